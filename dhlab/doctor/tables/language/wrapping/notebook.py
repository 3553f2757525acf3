"""A notebook pasted as the file that it is: JSON, of which the cells' own lines are the text."""

import json
import re

__all__ = ["without_notebook"]

STRING = r'"(?:[^"\\]|\\.)*"'
CELL = re.compile(rf'"source"\s*:\s*(?:(\[)((?:\s|,|{STRING})*)(\]?)([^\n]*)|({STRING}))')


def without_notebook(text):
    """What stands in the cells of a notebook, in their order; another text as it is.

    Examples
    --------
    >>> print(without_notebook('''{"cells": [{"cell_type": "code", "outputs": [],
    ...   "source": ["a1 = 0.3\\\\n", "d1 = 0.1"]}]}'''))
    a1 = 0.3
    d1 = 0.1
    """
    if '"cell_type"' not in text:
        return text
    cells = []
    for opened, listed, closed, rest, alone in CELL.findall(text):
        said = "".join(map(_read, re.findall(STRING, listed if opened else alone)))
        if opened and not closed:  # the text was cut off within a line of the cell
            said += _read(f'{rest.rstrip(chr(92))}"')
        cells.append(said)
    return "\n\n".join(cells) if cells else text


def _read(string):
    try:
        return str(json.loads(string, strict=False))
    except ValueError:
        return string.strip('"')
