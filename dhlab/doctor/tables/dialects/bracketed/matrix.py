"""The rows in one group of brackets, in any language; and tables that the text lays one below the
other.
"""

import re

from ...cells import cell_or_none
from ...evidence.orders import order_of_names
from ...language.brackets import cells_in
from ...language.roles import ROLES, role_of
from ..called.functions import own_calls, places_in
from ..lined.heading import header
from .filled import TABLE

__all__ = ["heading_in", "instances", "joined", "laid_down", "require_one", "rows_in", "target_of"]

WIDEST = 24  # columns, of which the text names the first four
COLUMNS = (*ROLES, "r", "offset", "sign")
STACKED = ("vstack", "concatenate", "vertcat", "append")
KEY = re.compile(r"\s*['\"]?([A-Za-z][\w .-]*)['\"]?\s*(?::(?!:)|=>)\s*")
NO_NUMBER = re.compile(r"(?:np\.|math\.|float\(['\"])?(?:inf|nan)(?:['\"]\))?", re.IGNORECASE)


def target_of(group):
    """What a group is assigned to, itself or in a call: ``dh = np.array([…])``."""
    outer = group.outer.target if group.outer is not None else ""
    return (group.target or outer).lower()


def rows_in(group):
    """[(where, cells)] of the rows in a group."""
    rows, items = [], [item for item in group.items if item.text not in ("None", "null", "nil")]
    if keyed := _under_keys(items) if TABLE.search(target_of(group)) else []:
        return keyed
    inner = [
        item.groups[-1]
        for item in items
        if item.groups
        and item.text.rstrip().endswith(item.groups[-1].text)
        and re.fullmatch(r"[\w.:]*\s*", item.text[: -len(item.groups[-1].text)] or "")
    ]
    alone = len(items) == 1 and len(items[0].groups) > 1
    if alone and not "".join(_between(items[0])).strip():
        inner = items = items[0].groups  # Lisp: no mark between the rows
    if len(inner) >= 1 and len(inner) == len(items):
        rows = [(f"line {part.line}", [item.text for item in part.items]) for part in inner]
        rows = [(where, cells_in(cells[0]) if len(cells) == 1 else cells) for where, cells in rows]
    elif all(part.mark == "(" for part in inner):
        line: list = []
        for item in group.items:
            line.append(item)
            if item.after != ",":
                rows.append(line)
                line = []
        rows = [
            (
                f"line {row[0].line}",
                cells_in(row[0].text) if len(row) == 1 else [item.text for item in row],
            )
            for row in [*rows, *([line] if line else [])]
        ]
    rows = [(where, [_variable(cell) for cell in cells]) for where, cells in _without_maker(rows)]
    if not rows or len({len(cells) for _, cells in rows}) > 1 or not 3 <= len(rows[0][1]) <= WIDEST:
        return []
    if len(rows) == 1 and (
        (group.outer is not None and group.outer.mark != "(" and len(group.outer.items) > 1)
        or group.mark == "("
        or (not inner and group.mark != "[")
        or len(rows[0][1]) > 5
    ):
        return []
    return rows


def _under_keys(items):
    """The rows of a dictionary, ``dh = {'s0': [0.3, 0, 0, 90], 's1': […]}``, each behind its name;
    none where the names are those of columns.
    """
    found = [(KEY.match(item.text), item.groups[-1] if item.groups else None) for item in items]
    whole = [
        (key, part) for (key, part), item in zip(found, items)
        if key and part and part.mark != "(" and item.text[key.end() :].strip() == part.text
    ]  # fmt: skip
    if (
        len(whole) < 2
        or len(whole) < len(items)
        or any(role_of(key[1])[0] in COLUMNS for key, _ in whole)
    ):
        return []
    rows = [
        (f"line {part.line}", [f"'{key[1]}'", *(cell.text for cell in part.items)])
        for key, part in whole
    ]
    return rows if {len(cells) for _, cells in rows} <= {5} else []


def _variable(cell):
    """``inf`` and ``nan`` stand where a joint's variable does."""
    return "q" if isinstance(cell, str) and NO_NUMBER.fullmatch(cell.strip()) else cell


def _between(item):
    """What of an item stands between its groups."""
    rest = item.text
    for part in item.groups:
        before, _, rest = rest.partition(part.text)
        yield before
    yield rest


def _without_maker(rows):
    """The rows without one name that stands before the numbers of each: ``Link 0 0.3 0 90``."""
    first = {cells[0] for _, cells in rows if cells}
    if len(rows) > 1 and len(first) == 1 and re.fullmatch(r"[A-Z]\w+", str(*first)):
        return [(where, cells[1:]) for where, cells in rows]
    return rows


def instances(matrices):
    """The matrices without one that is another with letters in the place of its numbers: the same
    table before and after its values are put in.
    """
    kept = list(matrices)
    for one in matrices:
        for other in matrices:
            if one in kept and other in kept and one is not other and _is_general(one[1], other[1]):
                kept.remove(one)
    return kept


def _is_general(rows, others):
    """Whether rows say what others do, with letters for some of their numbers."""
    if len(rows) < 2 or [len(cells) for _, cells in rows] != [len(cells) for _, cells in others]:
        return False
    pairs = [
        (cell_or_none(str(a)), cell_or_none(str(b)))
        for (_, one), (_, other) in zip(rows, others)
        for a, b in zip(one, other)
    ]
    if any(a is None or b is None for a, b in pairs):
        return False
    fixed = [(a, b) for a, b in pairs if a.is_constant or a.variable in ("theta", "q")]
    same = all(a.is_constant == b.is_constant and abs(a.value - b.value) < 1e-9 for a, b in fixed)
    return same and len(pairs) - len(fixed) > 0


def require_one(matrices):
    """Two tables by their names, dh_left and dh_right, are two arms: nobody can say which."""
    tables: dict = {}
    for group, rows in matrices:
        if len(rows) > 1 and re.search(r"dh|table|param", target_of(group)):
            tables.setdefault(
                str([cells for _, cells in rows]), (target_of(group), len(rows[0][1]))
            )
    widths = [width for _, width in tables.values()]
    if len(tables) > 1 and len(set(widths)) == 1:
        names = ", ".join(name for name, _ in tables.values())
        raise ValueError(
            f"recognise_table: expected one table, found two or more: {names[:60]}; paste one of"
            " them"
        )


def joined(matrices, found):
    """The matrices with the one that lays several of them one below the other in the place of its
    parts: ``DH = [arm; wrist]``, ``np.vstack((arm, wrist))``.
    """
    parts: dict = {}
    for group, rows in matrices:
        if target_of(group):
            parts.setdefault(target_of(group), (group, rows))
    for group in found:
        stacked = group.mark == "[" or re.split(r"\W", group.outer.name if group.outer else "")[-1]
        names = [item.text.strip().lower() for item in group.items]
        whole = stacked is True or stacked in STACKED
        if whole and len(names) > 1 and len(set(names)) == len(names) and set(names) <= set(parts):
            widths = {len(parts[name][1][0][1]) for name in names}
            apart = stacked is True and any(item.after == "," for item in group.items[:-1])
            if len(widths) == 1 and not apart:
                rows = [row for name in names for row in parts[name][1]]
                others = [one for one in matrices if target_of(one[0]) not in names]
                return [*others, (parts[names[0]][0], rows)]
    return matrices


def heading_in(found, width):
    """(where, names) of the columns, which a list of words in the text names; None without one."""
    for group in found:
        texts = [item.text.strip() for item in group.items]
        if len(texts) != width or any(text[:1] not in "'\"" for text in texts):
            continue
        names = [text.strip("'\"") for text in texts]
        if header(names):
            return f"line {group.line}", names
    return None


def laid_down(grid, name, source):
    """(roles, why) of the lines of a matrix that lies on its side, one parameter a line: by the
    comments behind its lines, or by the calls that take a column of it for each link; None of
    others.
    """
    if not 3 <= len(grid) <= 5:
        return None
    said = dict(source.comments)
    lines = [int(where.split()[1]) for where, _ in grid if "line" in where]
    beside = [role_of(_first_words(said.get(line, "")))[0] for line in lines]
    beside = ["theta" if role in ("label", "offset") else role for role in beside]
    if len(set(lines)) == len(grid) and set(beside) >= set(ROLES):
        return tuple(beside), "as the comments behind the lines say"
    taken = _by_calls(name, source)
    if taken and len(taken) == len(grid):
        return taken, "as the program takes them, a column for each link"
    return None


def _first_words(text):
    return "" if order_of_names(text) else " ".join(re.findall(r"[A-Za-z]\w*", text)[:2])


def _by_calls(name, source):
    """The roles of the lines of a named matrix of which the text's own function takes columns."""
    for call, roles in own_calls(source):
        at = places_in(call)
        taken = {re.match(r"\w+", one[0])[0].lower() for one in at}
        if taken == {name} and len({one[1] for one in at}) == len(at):
            return tuple(roles[k] for k in sorted(range(len(at)), key=lambda k: int(at[k][1])))
    return None
