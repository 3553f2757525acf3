"""The cells of a notebook that a student handed in, read as the cage reads them: what is shown to
the teacher and compared with others is what was run.
"""

import re
from collections.abc import Iterator
from typing import Any

from ..inside.reading.notebook import cells_of, listed

__all__ = ["answered"]

# a check, with what may stand before it in its line
CHECK = re.compile(
    r"""(?:^[ \t]*(?:\w+[ \t]*=[ \t]*)?|\b)check\(\s*["']([0-9A-Za-z.]+)["']""", re.MULTILINE
)


def answered(notebook: Any) -> Iterator[tuple[dict[str, Any], str | None, str | None]]:
    """(the cell, its code up to the check, the exercise that is answered once it has run) of each
    cell; of one that is no code the second is None.

    Examples
    --------
    >>> cell = {"cell_type": "code", "source": ["x = 1\\n", "check('05.1', x)"]}
    >>> [found[1:] for found in answered({"cells": [cell]})]
    [('x = 1\\n', '05.1')]
    """
    try:
        found = cells_of(notebook, {}).code
        cells = listed(notebook)
    except (ValueError, AttributeError):
        return
    code, checks = iter(found), {key for one in found for key in one.checked}
    for cell in (one for one in cells if isinstance(one, dict)):
        if cell.get("cell_type") != "code":
            yield cell, None, None
            continue
        own = next(code)
        source = own.source.encode("utf-8", "replace").decode("utf-8")  # JSON has half letters
        checked = CHECK.search(source) if own.checked else None
        if checked:
            yield cell, source[: checked.start()], checked[1]
        else:
            yield cell, source, next((key for key in own.ids if key not in checks), None)
