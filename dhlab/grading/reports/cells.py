"""The cells of a notebook that a student handed in, read without trusting that it has the right
form.
"""

import re
from collections.abc import Iterator
from typing import Any

__all__ = ["cells", "code_and_check"]

CHECK = re.compile(r"""^[ \t]*check\(\s*["']([0-9A-Za-z.]+)["']""", re.MULTILINE)


def cells(notebook: Any) -> Iterator[dict[str, Any]]:
    """The cells of a notebook as it stands in the file."""
    found = notebook.get("cells") if isinstance(notebook, dict) else None
    return (cell for cell in (found if isinstance(found, list) else ()) if isinstance(cell, dict))


def _whole_letters(text):
    """A text that a file can hold: without halves of letters, which JSON may have."""
    return text.encode("utf-8", "replace").decode("utf-8")


def code_and_check(cell: dict[str, Any]) -> tuple[str, str | None] | None:
    """The code of a code cell up to its check, and the exercise that is checked there, if one is;
    None of any other cell.

    Examples
    --------
    >>> code_and_check({"cell_type": "code", "source": ["x = 1\\n", "check('05.1', x)"]})
    ('x = 1\\n', '05.1')
    """
    if cell.get("cell_type") != "code":
        return None
    source = cell.get("source", "")
    if isinstance(source, list):
        source = "".join(part for part in source if isinstance(part, str))
    source = _whole_letters(source) if isinstance(source, str) else ""
    checked = CHECK.search(source)
    return (source[: checked.start()], checked[1]) if checked else (source, None)
