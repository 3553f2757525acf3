"""The explorer as ``text/html``: its data, and what is seen where no program runs, a still picture
or a table.
"""

import json
from typing import Any

__all__ = ["wrapped"]


def wrapped(fallback: str, data: dict[str, Any], state: dict[str, Any]) -> str:
    """The element that the module ``explorer.js`` makes alive on a page; no id in it, so that the
    same explorer is the same text.
    """
    numbers = json.dumps(
        {**data, "state": state}, ensure_ascii=False, separators=(",", ":")
    ).replace("</", "<\\/")
    return (
        f'<div class="dhlab-explorer">{fallback}<script'
        f' type="application/json">{numbers}</script></div>'
    )
