"""Numbers with their names beside them, a row in a line or in a block: ``d=0.1, a=0, alpha=90``,
YAML, what simulators print.
"""

import re

from ..cells import cell_of
from ..language.roles import role_of
from ..pasted import Row, from_rows

__all__ = ["read"]

PAIR = re.compile(
    r"(?<![\w.\])])['\"]?([A-Za-z_][A-Za-z_]*?)_?(\d*)['\"]?\s*(?:=|:(?!:))\s*"
    r"([^=:,;\n{}|\[\]]+?)(?:\s*\[(\w+)\])?(?=\s*(?:[,;\n{}|]|$|\s[A-Za-z_]+_?\d*\s*[=:]|\s['\"]))"
)
LOOSE = re.compile(r"(-?\s*\b(?:theta|th|q)_?\d+\b\s*\*?(?:\s*[-+]\s*[\w./*]+°?)?)")
BLOCK = re.compile(r"\s*-|\s*[\w .-]+:\s*$|\s*['\"]?\w+['\"]?\s*:\s*\{")
NAMES = ("theta", "d", "a", "alpha", "r", "offset")


def read(source, nominal=None):
    """The Pasted table of named numbers; None when no two rows have them."""
    rows, row, block = [], {}, -1
    lines = [(line, _pairs(line, source)) for line in source.code.split("\n")]
    listed = [len(pairs) for line, pairs in lines if pairs and re.match(r"\s*-\s", line)]
    one_a_line = listed and len(listed) == sum(bool(pairs) for _, pairs in lines)
    for number, (line, pairs) in enumerate(lines):
        if (row and BLOCK.match(line) and not (one_a_line and pairs)) or (
            set(row) & set(pairs) - {"index"}
        ):
            rows, row = [*rows, row] if row else rows, {}
        if pairs:
            row = {**row, **pairs}
            block = number
        if row and not pairs and not line.strip() and number > block + 1:
            rows, row = [*rows, row], {}
    rows = [one for one in [*rows, row] if len({"d", "a", "alpha", "r", "theta"} & set(one)) >= 2]
    if len(rows) < 2:
        return None
    kinds = [one.pop("type", "") for one in rows]
    indices = [one.pop("index", "") for one in rows]
    if len(set(indices)) < len(indices) and any(indices):
        return None
    if all("r" in one and "a" not in one for one in rows):
        rows = [
            {("a" if role == "r" else role): cell for role, cell in one.items()} for one in rows
        ]
    held = set.union(*map(set, rows))
    if "alpha" not in held or not held & {"a", "d"}:
        return None
    return from_rows(
        [Row(one, kind) for one, kind in zip(rows, kinds)], why="as the names beside them say"
    )


def _pairs(line, source):
    """The Cells of a line by role; a joint variable that stands alone is theta."""
    found: dict = {}
    rest = line
    if len({match[2] for match in PAIR.finditer(line)} - {""}) > 1:
        return found  # one name for each number
    for match in PAIR.finditer(line):
        role = role_of(match[1])[0]
        if match[1].lower() in ("type", "joint_type", "jointtype"):
            word = match[3].strip(" '\"").lower()
            found["type"] = {"r": "R", "p": "P", "f": "fixed"}.get(word[:1], "")
            continue
        value = source.value(match[3] + (f" {match[4]}" if match[4] else ""))
        if value is None:  # without what follows it: a unit, or a remark in brackets
            value = source.value(re.sub(r"\s*\([^()]*[a-z]{3}[^()]*\)\s*$", "", match[3]))
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
