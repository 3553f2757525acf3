"""Flat arrays of numbers in a text, by the names that they are assigned to."""

import re

from ..language.brackets import cells_in, groups

__all__ = ["arrays_in"]

STREAM = re.compile(r"\b(\w+)\s*<<\s*([^;<\"']+);")  # Eigen's d << 0.1, 0, 0.3;
AFTER = re.compile(r"[\s)]*?\)?[ \t]*([*/][ \t]*[\w./* \t()]+?)[ \t]*(?=[,;\n]|$)")
BEFORE = re.compile(r"=\s*([\w./*()]+?)\s*\*\s*(?:[\w.]+\()?$")

HELD = ("value", "values", "val")  # "alpha": {"value": [0, 1.57], "unit": "rad"}


def arrays_in(source, twice=None, unread=None):
    """{name: list of Values} of every flat array whose items are expressions; ``twice`` gets the
    names that are given again with other numbers, ``unread`` those with a cell that is no number.
    """
    code = re.sub(
        r"([\w'\"]+)\s*:\s*((?:\n\s*-\s*[^\n:\[]+)+)",
        lambda m: m[1] + ": [" + ", ".join(re.findall(r"-\s+([^\n]+)", m[2])) + "]\n",
        source.code,
    )
    code = STREAM.sub(r"\1 = [\2];", code)
    found = {}
    for group in groups(code):
        name = _assigned_to(group)
        turned = group.outer is not None and _last(group.outer) in ("radians", "deg2rad")
        cells = _upright(group) if name else None
        values = [source.value(cell) for cell in cells or ()]
        if unread is not None and None in values and _last(group) != "zeros":
            unread[name] = cells[values.index(None)]
            if group.mark == "{" and re.match(r"\s*['\"]?\w+['\"]?\s*:", unread[name]):
                del unread[name]  # under an index each: no list of zeros
        if group.mark == "(" and group.name and any(v is None or v.letters for v in values):
            continue  # a call of numbers makes a list, one of letters is a function
        if len(values) >= (3 if group.mark == "(" else 2) and None not in values:
            factor = "pi/180" if turned else _factor(code, group, source)
            if factor:
                values = [
                    source.value(f"({cell})*({factor})") if not value.unit else value
                    for cell, value in zip(cells, values)
                ]
            if None in values:  # too long with its factor
                continue
            given = [(value, cell) for value, cell in zip(values, cells)]
            if found.setdefault(name, given) != given and twice is not None:
                twice.add(name)
    return found


def _last(group):
    return re.split(r"\.|::", group.name)[-1].lower()


def _assigned_to(group):
    """The name of an array: what it is assigned to, itself or in calls that make it, such as
    ``np.deg2rad(np.array([…]))``; a call must be alone in what is around it.
    """
    while group is not None and not group.target:
        if group.outer is None or group.outer.mark != "(" or len(group.outer.items) > 2:
            return ""
        group = group.outer
    if group is not None and group.outer is not None and group.target.lower() in HELD:
        return group.outer.target
    return group.target if group is not None else ""


def _upright(group):
    """The cells of a flat array, or of a column ``[[0], [0.3]]``; None of other matrices."""
    column = [item.groups[0].items for item in group.items if _is_row(item, group.mark)]
    if len(column) > 1 and all(len(items) == 1 for items in column):
        return [items[0].text for items in column] if len(column) == len(group.items) else None
    inner = re.compile(rf"(?<![\w\])]){re.escape(group.mark)}")  # no index, as in q[1]
    for item in group.items:
        sums = group.mark == "(" and all(len(part.items) == 1 for part in item.groups)
        if item.groups and not sums and inner.search(item.text):
            return None
    return [cell for item in group.items for cell in cells_in(item.text)]


def _is_row(item, mark):
    return bool(item.groups) and item.groups[0].text == item.text and item.text[0] == mark


def _factor(code, group, source):
    """What all numbers of an array are multiplied by, behind it or before; "" when nothing is."""
    before, _, after = code.partition(group.text)
    found = AFTER.match(after[:60])
    said = f"1{found[1]}" if found else ""
    if not said and (found := BEFORE.search(before[-60:])):
        said = found[1]
    value = source.value(said) if said else None
    return said if value is not None and not value.letters else ""
