"""A pasted table taken apart: lines, separators, header, row labels, cells; what it means is
decided in :mod:`dhlab.doctor.tables.dialects`.
"""

import re

import numpy as np

from .cells import plain
from .grid import from_grid, from_keys

__all__ = ["take_apart"]

MOST_LINES, MOST_CHARACTERS = 60, 10_000
RULE = re.compile(r"[-|:+=\s().;]*")  # a line that only separates
KEYED = re.compile(r"\b(theta|d|a|alpha|offset)(?:\s*=|['\"]\s*,)\s*([^,;)\]]+)")
LINK_CLASS = re.compile(
    r"\b(revolute|prismatic)(mdh|dh)?\b|\bdh(?:robot)?link\b|\blink\b", re.IGNORECASE
)
WORDS_FOR = {
    "craig": ("modified", "craig", "mdh", "proximal", "khalil"),
    "standard": ("standard", "classic", "distal", "paul"),
}


def take_apart(given):
    """The Pasted table in a text, or in rows of numbers and texts.

    Raises
    ------
    ValueError
        One sentence with the line: expected, found, what to do.
    """
    if isinstance(given, str):
        return _from_text(given)
    if isinstance(given, (bytes, dict)) or not np.iterable(given):
        raise ValueError(
            "recognise_table: expected a text or rows of four numbers, found"
            f" {type(given).__name__}; paste the table as text"
        )
    rows = [
        list(row) if np.iterable(row) and not isinstance(row, (str, bytes, dict)) else [row]
        for row in given
    ]
    return from_grid([(f"row {i}", row) for i, row in enumerate(rows, 1)], None)


def _from_text(text):
    if len(text) > MOST_CHARACTERS:
        raise ValueError(
            f"recognise_table: expected one table, found a text of {len(text)} characters; paste"
            " the rows only"
        )
    said = _convention(text)
    text = re.sub(
        "[│┃]", "|", re.sub("[┌┐└┘├┤┬┴┼─━┏┓┗┛┣┫┳┻╋═]+", "", text)
    )  # the frames that toolboxes print
    lines = [(f"line {k}", line) for k, line in enumerate(_lines(text), 1) if line.strip()]
    if len(lines) > MOST_LINES:
        raise ValueError(
            f"recognise_table: expected at most {MOST_LINES} lines, found {len(lines)}; paste the"
            " rows only"
        )
    keyed = [(where, dict(KEYED.findall(plain(line))), line) for where, line in lines]
    links = [
        (where, found, line)
        for where, found, line in keyed
        if len(found) >= 2 or (found and LINK_CLASS.search(line))
    ]
    if len(links) >= max(1, len(lines) // 2):
        return from_keys(links, said)
    lines = [
        (where, re.sub(r"^[\w\s().]*=\s*\[|^[\w\s().]*=\s*\w*\(\s*\[|[\[\]]", " ", line))
        for where, line in lines
    ]
    lines = [(where, line.strip().rstrip(";,").strip()) for where, line in lines]
    lines = [(where, line) for where, line in lines if not RULE.fullmatch(line)]
    split = _splitter([line for _, line in lines])
    return from_grid([(where, split(line)) for where, line in lines], said)


def _lines(text):
    """The lines; a matrix on one line is broken where its rows end."""
    lines = text.splitlines()
    if len([line for line in lines if line.strip()]) == 1:
        return re.split(r";|\]\s*,?\s*\[|\\\\", text)
    return [
        re.sub(r"\\\\\s*(\\hline)?\s*$", "", line).replace("\\hline", "").replace("&", "|")
        for line in lines
    ]


def _convention(text):
    words = set(re.findall(r"[a-z]+", plain(text)))
    said = [name for name, marks in WORDS_FOR.items() if words & set(marks)]
    return said[0] if len(said) == 1 else None


def _splitter(lines):
    """How the cells of these lines are separated; a comma is a decimal one where something else
    separates.
    """
    for mark in ("|", "\t", ";"):
        if sum(mark in line for line in lines) > len(lines) / 2:
            return lambda line, mark=mark: [
                _decimal(cell) for cell in _trimmed(line.split(mark), mark)
            ]
    if sum(line.count(",") >= 3 for line in lines) > len(lines) / 2:
        return lambda line: [cell.strip() for cell in re.sub(r"^\s*[%#]\s*", "", line).split(",")]
    return lambda line: [_decimal(cell) for cell in _joined(re.sub(r"^\s*(%|#|//)\s*", "", line))]


def _trimmed(cells, mark):
    cells = [re.sub(r"^\s*[%#]\s*", "", cell).strip() for cell in cells]
    if mark == "|":
        cells = cells[1:] if cells and not cells[0] else cells
        cells = cells[:-1] if cells and not cells[-1] else cells
    return [
        re.sub(r"^\*\*(.*)\*\*$|^`(.*)`$", lambda m: m.group(1) or m.group(2), cell)
        for cell in cells
    ]


def _decimal(cell):
    return re.sub(r"^([-−+]?\d*),(\d+)$", r"\1.\2", cell.strip())


def _joined(line):
    """Cells separated by spaces; "q2 - 90", "pi / 2", "90 deg" and "i - 1" are one cell each."""
    line = re.sub(r"(?<=[\w)])\s*([*/])\s*(?=[\w(])", r"\1", plain(line))
    line = re.sub(r"((?:theta|th|q)_?\d*\*?)\s*([-+])\s+(?=[\dp.])", r"\1\2", line)
    line = re.sub(r"(?<=[\d.])\s+(deg|degrees|°|mm|cm|rad)\b", r"\1", line)
    line = re.sub(
        r"\s+(?=[\[(]\s*(deg|rad|mm|cm|m|°))|(?<=i)\s*-\s*(?=1)",
        lambda m: "-" if "-" in m.group() else "",
        line,
    )
    return line.split()
