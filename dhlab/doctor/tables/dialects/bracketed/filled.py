"""Tables that are filled bit by bit: a row to each call, name, index or line, a number to each
place, or all numbers one behind the other.
"""

import re
from collections import Counter

from ...language.brackets import cells_in

__all__ = ["TABLE", "filled"]

TABLE = re.compile(r"^(?!.*(?:limit|range|home|pose)).*(?:dh|denavit|table|param|links?(?:_|$))")
ONE_CELL = re.compile(
    r"\b([A-Za-z_]\w*)\s*[\[(]\s*(\d+)\s*(?:,|\]\s*\[)\s*(\d)\s*[\])]\s*=\s*([^=;\n][^;\n]*)"
)


def filled(found, source):
    """The rows, as (where, cells), of each way in which the text may fill a table.

    Parameters
    ----------
    found : list of Group
        The groups of the text.
    source : Source
    """
    yield _one_a_call(found)
    yield _siblings(found, source)
    yield _one_a_name(found)
    yield _one_an_index(found, source)
    yield _by_fours(found, source)
    yield _cell_by_cell(source.code)
    yield from _streams(source.code)
    yield from _listed(source.code)


def _cells(group):
    """What stands in a group: its items, or the cells of its only one at spaces."""
    texts = [item.text for item in group.items]
    return texts if len(texts) > 1 else [cell for text in texts for cell in cells_in(text)]


def _one_a_call(found):
    """The rows that calls of one function take: ``setFixedTransform(j1, [0 …], 'dh')``."""
    rows: dict = {}
    torn = set()
    for group in found:
        cells = _cells(group)
        made = group.outer is not None and group.outer.name and group.mark != "("
        if made and len(cells) == 4 and not _is_property(group):
            rows.setdefault(group.outer.name, []).append((f"line {group.line}", cells))
        elif made and len(cells) in (3, 5) and sum(map(str.isdigit, cells)) > 1:
            torn.add(group.outer.name)  # a number is missing there, or one too many
    whole = [one for name, one in rows.items() if name not in torn]
    most = max(whole, key=len, default=[])
    return most if len(most) > 1 else []


def _is_property(group):
    """Whether a word in quotation marks says what the numbers are: ``'Position', [9, 9, 9, 3]``."""
    before = group.outer.text.partition(group.text)[0].rstrip()
    return bool(re.search(r"(['\"])\w+\1\s*,$", before))


def _siblings(found, source):
    """Brackets of one kind, one behind the other, nothing around them: ``(1, 0, 90), (2, …)``."""
    whole, torn = [], []
    for group in found:
        cells = [item.text for item in group.items]
        bare = group.outer is None and not group.name and not group.target
        if not bare or [re.sub(r"\.0*$", "", cell) for cell in cells] == ["0", "0", "0", "1"]:
            continue  # the origin, as a point of four numbers
        read = len(cells) in (4, 5, 6) and all(source.value(cell) is not None for cell in cells)
        (whole if read else torn).append((group.line, cells))
    widths = Counter(len(cells) for _, cells in whole).most_common(1)
    if not widths or widths[0][1] < 2:
        return []
    best = [(f"line {line}", cells) for line, cells in whole if len(cells) == widths[0][0]]
    torn += [(line, cells) for line, cells in whole if len(cells) != widths[0][0]]
    first, last = (int(where.split()[1]) for where, _ in (best[0], best[-1]))
    torn = [(line, cells) for line, cells in torn if first < line < last]
    if any(re.search(r"\b(?:sin|cos)", cell) for _, cells in torn for cell in cells):
        return []  # the lines of a link matrix
    for line, cells in torn:
        if sum(source.value(cell) is not None for cell in cells) > 1:
            raise ValueError(
                f"recognise_table: line {line}: expected {len(best[0][1])} numbers, as in the other"
                f" rows, found {', '.join(cells)[:60]!r}; what is each? Write the numbers"
            )
    return best


def _one_a_name(found):
    """The rows in arrays that are numbered: ``float link1[] = {0, L1, 0, 90};``."""
    rows = {}
    for group in found:
        name = re.fullmatch(r"(?:dh_?)?(link|joint|row|dh|param|l|j)_?(\d+)", group.target.lower())
        cells = _cells(group)
        if name and group.mark != "(" and len(cells) == 4:
            rows.setdefault(name[1], {})[int(name[2])] = (f"line {group.line}", cells)
    whole = [one for one in rows.values() if sorted(one) == list(range(min(one), max(one) + 1))]
    numbered = max(whole, key=len, default={})
    return [numbered[k] for k in sorted(numbered)] if len(numbered) > 1 else []


def _one_an_index(found, source):
    """The rows that are put into a table one by one: ``DH(1,:) = [0, 0.3, 0, 90]``."""
    rows: dict = {}
    for group in found:
        cells = _cells(group)
        alone = TABLE.search(group.target.lower()) and group.mark != "(" and group.outer is None
        if alone and 4 <= len(cells) <= 6 and re.search(r"\d", group.text):
            rows.setdefault((group.target, len(cells)), []).append((f"line {group.line}", cells))
    (name, _), most = max(rows.items(), key=lambda one: len(one[1]), default=(("", 0), []))
    if len(most) < 2:
        return []
    _require_all(name, most, source)
    return most


def _require_all(name, rows, source):
    """No row may be left out, nor a cell that cannot be read."""
    put = re.findall(rf"\b{re.escape(name)}\s*[\[(]\s*(\d+)[^=\n]*=(?!=)", source.code)
    indices = sorted({int(index) for index in put})
    if indices and indices != list(range(indices[0], indices[-1] + 1)):
        raise ValueError(
            f"recognise_table: {name}: expected rows {indices[0]} to {indices[-1]}, found"
            f" {', '.join(map(str, indices))}; paste the missing ones"
        )
    for where, cells in rows:
        bad = next((cell for cell in cells if source.value(cell) is None), None)
        if bad is not None:
            raise ValueError(
                f"recognise_table: {where}: expected a number or a joint variable, found"
                f" {bad[:40]!r}; write it as one of these"
            )


def _by_fours(found, source):
    """Rows of four in one flat list, where the text says in which order they stand."""
    for group in found:
        cells = [item.text for item in group.items]
        outer = group.outer.target if group.outer is not None else ""
        many = (
            TABLE.search((group.target or outer).lower())
            and len(cells) >= 8
            and len(cells) % 4 == 0
            and group.mark != "("
        )
        if many and not any(item.groups for item in group.items) and source.order:
            return [(f"line {group.line}", cells[k : k + 4]) for k in range(0, len(cells), 4)]
    return []


def _cell_by_cell(code):
    """A table of which every number is put in by its two indices: ``dh[1][3] = 90``."""
    cells: dict = {}
    for name, i, j, text in ONE_CELL.findall(code):
        cells.setdefault(name, {})[int(i), int(j)] = text.strip()
    for held in cells.values():
        rows, columns = (sorted({at[k] for at in held}) for k in (0, 1))
        if len(rows) > 1 and len(columns) in (4, 5) and len(held) == len(rows) * len(columns):
            return [(f"row {i}", [held[i, j] for j in columns]) for i in rows]
    return []


def _streams(code):
    """Eigen's ``DH << 0, 0.1, …;``, by lines, or by fours where it stands in one."""
    for match in re.finditer(r"<<\s*([^;<]{8,2000});", code):
        lines = [
            cells_in(line.strip().rstrip(",")) for line in match[1].split("\n") if line.strip()
        ]
        if len(lines) == 1 and len(lines[0]) >= 8 and len(lines[0]) % 4 == 0:
            lines = [lines[0][k : k + 4] for k in range(0, len(lines[0]), 4)]
        if len(lines) > 1 and len({len(line) for line in lines}) == 1:
            first = code.count("\n", 0, match.start()) + 1
            yield [(f"line {first + k}", line) for k, line in enumerate(lines)]


def _listed(code):
    """Rows one below the other, as YAML has them: ``- [0, 0.4, 0, 90]``."""
    rows: list = []
    for number, line in enumerate([*code.split("\n"), ""], 1):
        found = re.fullmatch(r"\s*-\s*\[([^\[\]]*)\]\s*,?\s*", line)
        cells = cells_in(found[1]) if found else []
        if cells and (not rows or len(cells) == len(rows[0][1])):
            rows.append((f"line {number}", cells))
            continue
        if len(rows) > 1 and 4 <= len(rows[0][1]) <= 8:
            yield rows
        rows = [(f"line {number}", cells)] if cells else []
