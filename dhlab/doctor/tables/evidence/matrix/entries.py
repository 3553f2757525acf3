"""The entries of everything in a program that may be a 4×4 matrix, however it is written: as a
list, entry by entry, row by row, column by column, drawn.
"""

import re
from itertools import islice

from ...language.brackets import Group, cells_in, groups

__all__ = ["in_rows", "matrices"]

ENTRY = re.compile(
    r"\b([A-Za-z_]\w*)\s*[\[(]\s*(?:[a-z:]\w*\s*,\s*)?(\d)\s*(?:,|\]\s*\[)\s*(\d)\s*[\])]\s*=\s*([^=;\n][^;\n]*)"
)
IN_LINE = re.compile(r"\b([A-Za-z_]\w*)\s*\[\s*(\d{1,2})\s*\]\s*=(?!=)\s*([^=;\n]+)")
NAMED = re.compile(  # m.m01 = …, M12 = …, t23 = …
    r"\b((?:\w+\.)?[mnetr])_?([0-4])([0-4])\s*[=:](?![=:])\s*([^=;,}\n][^;,}\n]*)", re.IGNORECASE
)
# m.SetRow(0, …), T.col(3) << …, T(1,:) = […], m[0] = …
LINE = re.compile(
    r"\b(\w+)\s*(?:(?:\.|->)\s*(?:set_?)?(?:row|col(?:umn)?)s?\s*\(\s*(\d)\s*(?:,|\)\s*(?:<<|=))"
    r"|[\[(]\s*(?:(\d)\s*(?:,\s*:\s*)?|:\s*,\s*(\d)\s*)[\])]\s*=(?!=))\s*",
    re.IGNORECASE,
)
MOST_LINES = 64  # that are looked at
FILLED = re.compile(r"<<([^;]{40,1500});")


def matrices(code):
    """The entries, 12 or 16, of everything that may be a matrix."""
    closing = _closing(code)
    sizes = (8, 12, 16) if closing else (12, 16)  # two rows of a text that was cut off tell it
    for group in groups(code + closing):
        if 60 < len(group.text) < 1800:
            flat = len(group.items) in (12, 16)
            cells = [item.text for item in group.items] if flat else in_rows(group)
            if len(cells) in sizes:
                yield cells
    for block in FILLED.findall(code):
        cells = [cell.strip() for cell in cells_in(block.replace("\n", " "))]
        if len(cells) in (12, 16):
            yield cells
    yield from _by_lines(code)
    yield from _one_by_one(code)
    yield from _drawn(code)
    yield from _by_entries(ENTRY, code)
    yield from _by_entries(NAMED, code)


def _by_lines(code):
    """The entries of a matrix that gets four numbers at a time, and what they are if these are its
    columns: ``m.SetRow(0, new Vector4(c, -s, 0, a))``.
    """
    held: dict = {}
    for match in islice(LINE.finditer(code), MOST_LINES):
        cells = _four(code[match.end() : match.end() + 600])
        at = next(one for one in match.groups()[1:] if one)
        if cells:
            held.setdefault(match[1], {}).setdefault(int(at), cells)
    for lines in held.values():
        found = [lines[k] for k in sorted(lines)]
        if max(lines) - min(lines) < 4 and len(found) in (3, 4):
            yield [cell for line in found for cell in line]
            found += [["0", "0", "0", "1"]] * (4 - len(found))
            yield [line[k] for k in range(4) for line in found]


def _four(text):
    """The four cells that a text begins with, in brackets or bare; None where it has others."""
    for group in (one for one in groups(text) if one.line == 1):
        if len(cells := cells_in(group.text[1:-1].replace("\n", " "))) == 4:
            return cells
    bare = re.split(r"[;\n]", text)[0]
    cells = cells_in(bare[:-1] if bare.count(")") > bare.count("(") else bare)
    return cells if len(cells) == 4 else None


def _by_entries(pattern, code):
    """The entries of each matrix that is written entry by entry."""
    held: dict = {}
    for name, i, j, text in pattern.findall(code):
        held.setdefault(name, {}).setdefault((int(i), int(j)), text.strip())
    for entries in held.values():
        first = min(min(at) for at in entries)
        if len(entries) >= 8 and max(max(at) for at in entries) - first <= 3:
            yield [
                entries.get((i + first, j + first), "1" if i == j else "0")
                for i in range(4)
                for j in range(4)
            ]


def _drawn(code):
    """The entries of a matrix that is drawn over three or four lines, each with four of them."""
    rows: list = []
    for line in [*code.split("\n"), ""]:
        line = re.sub(r"^[^=\[|]*=\s*(?=[\[|(]|$)", "", line).strip(" \t[]|;,.⎡⎢⎣⎤⎥⎦")
        cells = [cell for cell in re.split(r"\s{2,}|\s*[|&]\s*|\s*,\s+", line) if cell]
        if len(cells) == 4:
            rows.append(cells)
            continue
        if len(rows) in (3, 4):
            yield [cell for row in rows for cell in row]
        rows = []


def _one_by_one(code):
    """The entries, 16 under one name, that are written one behind the other: ``m[7] = d``."""
    held: dict = {}
    for name, index, text in IN_LINE.findall(code):
        held.setdefault(name, {})[int(index)] = text.strip()
    for entries in held.values():
        if set(range(12)) <= set(entries) <= set(range(16)):
            last = ["0", "0", "0", "1"]
            whole = [entries.get(k, last[k - 12] if k > 11 else "") for k in range(16)]
            yield whole
            yield [whole[4 * (k % 4) + k // 4] for k in range(16)]


def _closing(code):
    """The brackets that are still open where a text was cut off."""
    left: list = []
    for mark in re.findall(r"[\[({\])}]", code):
        if mark in "[({":
            left.append({"[": "]", "(": ")", "{": "}"}[mark])
        elif left and left[-1] == mark:
            left.pop()
    return "".join(reversed(left[-6:]))


def in_rows(group: Group):
    """The entries of a matrix in a group, row by row."""
    return [cell for row in _rows(group) for cell in row]


def _rows(group: Group):
    """The rows in a group: lists in it, bare or in a call of their own, or MATLAB's."""
    for item in group.items:
        inner = item.groups[0] if len(item.groups) == 1 else None
        if inner is not None and item.text == inner.text:
            yield [part.text for part in inner.items]
        elif inner is not None and inner.items and inner.items[0].text[:1] == "[":
            yield (
                [part.text for part in inner.items[0].groups[0].items]
                if inner.items[0].groups
                else []
            )
        else:
            yield cells_in(item.text)
