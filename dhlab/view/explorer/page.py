"""The explorer as ``text/html``: its data, and what is seen where no program runs, a still picture
or a table.
"""

import json

__all__ = ["arm_bundle", "wrapped"]


def wrapped(fallback, data, state):
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


def arm_bundle(arm):
    """How an arm shows itself: the explorer with the arm's table as what is seen without it; the
    table alone where no notebook asks.
    """
    from IPython import get_ipython

    from .explore import explore

    if getattr(get_ipython(), "kernel", None) is None:
        return {"text/html": arm._repr_html_(), "text/plain": repr(arm)}
    return explore(arm)._repr_mimebundle_(
        still={"text/html": arm._repr_html_(), "text/plain": repr(arm)}
    )
