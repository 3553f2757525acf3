"""Numbers with their names beside them, a row in a line or in a block: ``d=0.1, a=0, alpha=90``,
YAML, what simulators print.
"""

import re

from ..cells import cell_of, kind_of_letter
from ..evidence.several import in_parts
from ..language.brackets import groups, keyword
from ..language.roles import kind_said, role_of
from ..pasted import Row, from_rows

__all__ = ["in_groups", "read"]

PAIR = re.compile(
    r"(?<![\w.\])])['\"]?([A-Za-z_][A-Za-z_]*?)_?(\d*)['\"]?\s*(?:=|:(?!:))\s*"
    r"([^=:,;\n{}|\[\]]+?)(?:\s*\[(\w+)\])?(?=\s*(?:[,;\n{}|]|$|\s[A-Za-z_]+_?\d*\s*[=:]|\s['\"]))"
)
LOOSE = re.compile(
    r"((?:-(?=\w)|(?<=[,=(:;])\s*-\s*)?\b(?:theta|th|q)_?\d+\b\s*\*?(?:\s*[-+]\s*[\w./*]+°?)?)"
)
WORDED = re.compile(  # theta 0 d 0.42; link length 0.06, link twist -90
    r"([A-Za-z][A-Za-z_ -]{0,30}?)\s*(?:\bis|\bof|=|:)?\s+"
    r"(-?\d[\d.]*\s*(?:deg|°|mm|cm|m|rad)?(?![\w*/])"
    r"|-?\d*\s*\*?\s*pi(?:\s*/\s*\d)?(?!\w))"
)
NAMED = re.compile(  # gripper: of a block, - name: gripper
    r"\s*-?\s*['\"]?([\w .-]*[a-z][\w .-]*?)['\"]?\s*:\s*(?:\{.*)?$"
    r"|\s*-?\s*['\"]?(?:name|joint|link|label|id|frame)['\"]?\s*:\s*"
    r"['\"]?([\w .-]+?)['\"]?\s*,?\s*$",
    re.IGNORECASE,
)
BLOCK = re.compile(r"\s*-|\s*[\w .-]+:\s*$|\s*['\"]?\w+['\"]?\s*:\s*\{")
OF_ANGLE = re.compile(
    r"\b(?:cos|sin)[dfl]?\s*\(\s*[A-Za-z_]", re.IGNORECASE
)  # cos_alpha = cos(alpha)
NAMES = ("theta", "d", "a", "alpha", "r", "offset")
STILL = re.compile(r"(.*\S)\s*\((?:fixed|no joint)\)", re.IGNORECASE)  # -pi/2 (fixed)
REVERSED = re.compile(  # reverse_rotation_direction: true
    r"(?:is_?)?(?:flip(?:ped)?|revers(?:e|ed)|invert(?:ed)?)"
    r"(?:_?(?:rotation|joint|axis|motor|direction|sense))*",
    re.IGNORECASE,
)
TYPES = "number", "float", "double", "real"  # type Link = { a: number }
UNITS = re.compile(
    r"m|mm|cm|in|met(?:er|re)s?|milli-?met(?:er|re)s?|inch(?:es)?|deg(?:rees?)?|°|rad(?:ians?)?"
)
COUNT = re.compile(r"_?\d+$")
LABELS = ("name", "joint", "link", "label", "id", "frame")


def read(source, nominal=None):
    """The Pasted table of named numbers; None when no two rows have them."""
    rows, row, block, name = [], {}, -1, ""
    lines = [(line, _pairs(_said(line), source)) for line in source.code.split("\n")]
    listed = [len(pairs) for line, pairs in lines if pairs and re.match(r"\s*-\s", line)]
    one_a_line = listed and len(listed) == sum(bool(pairs) for _, pairs in lines)
    for number, (line, pairs) in enumerate(lines):
        if (row and BLOCK.match(line) and not (one_a_line and pairs)) or (
            set(row) & set(pairs) - {"index"}
        ):
            rows, row = [*rows, row] if row else rows, {}
        name = (found[1] or found[2]).strip() if (found := NAMED.match(line)) else name
        if pairs:
            row = {"label": name, **row, **pairs}
            block = number
        if row and not pairs and not line.strip() and number > block + 1:
            rows, row = [*rows, row], {}
    rows = [one for one in [*rows, row] if len({"d", "a", "alpha", "r", "theta"} & set(one)) >= 2]
    if len(rows) < 2:
        return None
    kinds = [one.pop("type", "") for one in rows]
    moving = ("d" in one and one["d"].letters for one in rows)  # theta: 0 (fixed) of a slider
    kinds = ["" if kind == "fixed" and slides else kind for kind, slides in zip(kinds, moving)]
    labels = [one.pop("label") for one in rows]
    indices = [one.pop("index", "") for one in rows]
    if len(set(indices)) < len(indices) and any(indices):
        return None
    if all(indices) and any(len({match[2] for match in _roles(line)}) > 1 for line, _ in lines):
        return None  # d1 beside a0
    if all(indices) and "d" not in rows[0] and "alpha" not in rows[-1]:
        return None  # the lines are no rows: alpha0, a0 belong to d1 on the next
    if all("r" in one and "a" not in one for one in rows):
        rows = [
            {("a" if role == "r" else role): cell for role, cell in one.items()} for one in rows
        ]
    held = set.union(*map(set, rows))
    if "alpha" not in held or not held & {"a", "d"}:
        return None
    if _is_statement(rows, lines[block + 1 :]):
        rows = rows[:-1]
    _require_whole(rows)
    return from_rows(
        [Row(one, kind, label) for one, kind, label in zip(rows, kinds, labels)],
        why="as the names beside them say",
    )


def _require_whole(rows):
    """The last row has the names that every other one has: the text was not cut off in it."""
    left = [
        role for role in NAMES if role not in rows[-1] and all(role in one for one in rows[:-1])
    ]
    if left and len(rows) > 2:
        raise ValueError(
            f"recognise_table: expected {' and '.join(left)} in the last row as in the others,"
            " found a shorter one; was the text cut off there? Give all its numbers"
        )


def _is_statement(rows, behind):
    """Whether the last of the rows is what a program does with them, as in ``theta = q + row.zero;
    alpha = radians(row.alpha)``: fewer names than in each row before, a letter that is no joint's,
    and more of the program behind it.
    """
    held = set.intersection(*(set(one) & set(NAMES) for one in rows[:-1]))
    letters = [name for role in NAMES if role in rows[-1] for name, _ in rows[-1][role].letters]
    own = any(kind_of_letter(name) == "?" for name in letters)
    more = any(re.search(r"\w", line) for line, _ in behind)
    return len(rows) > 2 and bool(held - set(rows[-1])) and own and more


def _said(line):
    """A line in which words and numbers stand side by side, with ``=`` between them."""
    if "|" in line or len(WORDED.findall(line)) < 3 or re.search(r"[=({\[]", line):
        return line
    if len(_roles(line)) > 2:
        return line
    named = []
    for words, number in WORDED.findall(line):
        parts = words.split()
        tried = (" ".join(parts[-k:]) for k in (3, 2, 1) if k <= len(parts))
        role = next((role for one in tried if (role := role_of(one)[0]) in NAMES), None)
        named.append((role, number))
    roles = [role for role, _ in named if role]
    whole = len(set(roles)) == len(roles) >= 3 and "alpha" in roles
    return ", ".join(f"{role} = {number}" for role, number in named if role) if whole else line


def _roles(line):
    """The named numbers of a line whose names are parameters'."""
    found = [match for match in PAIR.finditer(line) if role_of(match[1])[0] in NAMES]
    return found if len({role_of(match[1])[0] for match in found}) > 1 else []


def _pairs(line, source):
    """The Cells of a line by role; a joint variable that stands alone is theta."""
    found: dict = {}
    rest = line
    if len({match[2] for match in PAIR.finditer(line)} - {""}) > 1:
        return found  # one name for each number
    for match in PAIR.finditer(line):
        role = None if OF_ANGLE.search(match[3]) else role_of(match[1])[0]
        if kind := kind_said(match[1], match[3]):
            found["type"] = kind
            continue
        said = match[3] if match[3].count(")") == match[3].count("(") else match[3].rstrip(") ")
        if role == "theta" and (still := STILL.fullmatch(said)):
            said = still[1]
            found["type"] = "fixed"
        value = source.value(said + (f" {match[4]}" if match[4] else ""))
        if value is None:  # without what follows it: a unit, or a remark in brackets
            value = source.value(re.sub(r"\s*\([^()]*[a-z]{3}[^()]*\)\s*$", "", match[3]))
        if said.strip().lower() in TYPES or UNITS.fullmatch(said.strip(" '\"")):
            value = None
        if role in NAMES and value is not None and role not in found:
            found[role] = cell_of(value, match[3].strip())
            found["index"] = match[2]
            rest = rest.replace(match[0], " ", 1)
    if len(set(found) & set(NAMES)) >= 2 and "theta" not in found:
        alone = LOOSE.search(rest)
        value = source.value(alone[1]) if alone else None
        if value is not None:
            found["theta"] = cell_of(value, alone[1].strip())
    return found


def in_groups(source):
    """The Pasted table of dictionaries and structures, one a row; None without two of them."""
    rows, arms, unknown = [], {}, []
    found = groups(source.code)
    said = dict(source.comments)
    for group in found:
        if _tells_units(group):
            continue
        own_class = group.mark == "(" and group.name.lower() != "dict"
        if _is_made_room_for(group, source):
            continue
        named = NAMED.match(source.lines[group.line - 1])
        row = {"label": ((named and named[1]) or said.get(group.line, "")).strip()}
        for pair in _items(group):
            role = _role(pair[0], group) if pair else None
            value = (
                source.value(pair[1])
                if role in NAMES and pair[1].strip().lower() not in TYPES
                else None
            )
            if value is not None:
                row[role] = cell_of(value, pair[1])
            elif pair and (kind := kind_said("type" if role == "type" else pair[0], pair[1])):
                row["type"] = kind
            elif pair and REVERSED.fullmatch(pair[0]):
                row["sign"] = -1 if pair[1].strip("'\"").lower() in ("true", "1", "-1") else 1
            elif pair and pair[0].lower() in LABELS:
                row["label"] = pair[1].strip("'\"")
        wanted = 3 if own_class else 2  # somebody's own class, with all parameters by name
        if len({"theta", "d", "a", "alpha", "r"} & set(row)) >= wanted:
            _require_read(group, row)
            rows.append(row)
            unknown.append(_unknown(group, source))
            arms.setdefault(_list_of(group), []).append(row)
    if len(rows) < 2 or (set.intersection(*unknown) and not any("alpha" in row for row in rows)):
        return None  # the twists may have a name that says nothing: {ap: b1, a: a1, d: d2}
    parts = {name: one for name, one in arms.items() if len(one) > 1}
    rows = in_parts(parts, lambda row: sorted(_values(row)), "rows") or rows
    if all("r" in row and "a" not in row for row in rows):
        rows = [
            {("a" if role == "r" else role): cell for role, cell in row.items()} for row in rows
        ]
    kinds = [row.pop("type", "") for row in rows]
    labels = [row.pop("label") for row in rows]
    signs = [row.pop("sign", 1) for row in rows]
    return from_rows(
        [Row(*one) for one in zip(rows, kinds, labels, signs)], why="as their names say"
    )


def _role(name, group):
    """The parameter that a name means; d_2 is d where all names of the row have one number."""
    numbers = {found[0] for one in filter(None, _items(group)) if (found := COUNT.search(one[0]))}
    return role_of(name)[0] or (role_of(COUNT.sub("", name))[0] if len(numbers) == 1 else None)


def _tells_units(group):
    """Whether a group says units, {"length": "m", "angle": "deg"}, and no numbers."""
    said = [pair[1].strip("'\" ").lower() for pair in filter(None, _items(group))]
    return len(said) > 1 and all(UNITS.fullmatch(text) for text in said)


def _unknown(group, source):
    """The names in a row that mean nothing and hold a number."""
    pairs = filter(None, _items(group))
    return {
        name for name, text in pairs if role_of(name)[0] is None and source.value(text) is not None
    }


def _list_of(group):
    """Name and line of the list in which a row stands; it may have a name of its own in it."""
    outer = group.outer
    if outer is not None and len(outer.items) == 1 and outer.outer is not None:
        outer = outer.outer
    return f"{outer.target} of line {outer.line}".strip() if outer else ""


def _values(row):
    return ((role, cell.value) for role, cell in row.items() if role in NAMES)


def _require_read(group, row):
    """A number that is named and cannot be read must not be taken for 0."""
    for name, text in filter(None, _items(group)):
        role = _role(name, group)
        if role in ("d", "a", "alpha", "r") and role not in row and re.search(r"[(\d]", text):
            raise ValueError(
                f"recognise_table: line {group.line}: {name}: expected a number, found"
                f" {text[:40]!r}; write the number, or what its letters are"
            )


def _items(group):
    """(name, text) or None of each item; MATLAB's ``struct('d', 0.1, 'a', 0)`` by twos."""
    texts = [item.text for item in group.items]
    if group.name.lower() == "struct":
        return [(name.strip("'\""), text) for name, text in zip(texts[::2], texts[1::2])]
    return [keyword(text) for text in texts]


def _is_made_room_for(group, source):
    """Whether ``Link = struct(…)`` only makes room for ``Link(1) = struct(…)`` below it."""
    if group.name.lower() != "struct" or not group.target:
        return False
    indexed = rf"^\s*{re.escape(group.target)}\s*\(\d+\)\s*=\s*struct"
    line = source.code.split("\n")[group.line - 1]
    return not re.match(indexed, line) and bool(re.search(indexed, source.code, re.MULTILINE))
