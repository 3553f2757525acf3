"""What a column of a pasted table can be: angles or lengths; and the order of the columns."""

from dataclasses import dataclass, replace
from itertools import permutations

import numpy as np

from ..cells import Cell
from ..language.roles import ROLES

__all__ = [
    "IMPLIED", "NAMED", "MOST_TURNS", "Order", "is_a_table", "kind_of_column", "orders",
    "misplaced", "snapped",
]  # fmt: skip

NAMED = ("as the header", "as their names", "as the names")  # why columns have their roles
IMPLIED = Cell(0.0, (("theta", 1.0),), text="theta")  # the variable of rows that do not show it

# who writes his columns so, the most common first
DIALECTS = {
    ("theta", "d", "a", "alpha"): "as here and in the Robotics Toolbox",
    ("a", "alpha", "d", "theta"): "as in MATLAB and Spong's book",
    ("alpha", "a", "theta", "d"): "as in pybotics and some lecture notes",
    ("alpha", "a", "d", "theta"): "as in Craig's book",
    ("theta", "a", "d", "alpha"): "as Universal Robots prints it",
    ("a", "d", "alpha", "theta"): "as Franka prints it",
    ("d", "theta", "a", "alpha"): "as in many papers",
    ("a", "alpha", "theta", "d"): "",
    ("theta", "alpha", "a", "d"): "",
    ("alpha", "theta", "a", "d"): "",
    ("theta", "alpha", "d", "a"): "",
    ("alpha", "d", "a", "theta"): "",
    ("d", "a", "alpha", "theta"): "",
}
LONGEST_ARM = 3.0  # metres
MOST_TURNS = 4.1 * np.pi  # radians; no table has a larger angle
STEP = 15  # degrees; angles in tables are multiples of it
LENGTHS = ("mm", "cm", "m", "in")
PLACE = {
    "theta": ("theta",),
    "q": ("theta", "d"),
    "d": ("d",),
    "a": ("a",),
    "alpha": ("alpha",),
    "length": ("d", "a"),
    "?": ("theta", "d", "a", "alpha"),
}


@dataclass(frozen=True)
class Order:
    """One order in which the columns may stand, why, and the convention where it says that too."""

    roles: tuple
    why: str
    convention: str | None = None
    because: str = ""


def orders(table, given):
    """The Orders that fit, the likeliest first."""
    if given is not None:
        return [Order(tuple(given.split()), "as you say")]
    if table.roles is not None:
        named = _named(table)
        return (_by_numbers(table, named[0]) if _is_contradicted(table, named) else None) or named
    columns = list(zip(*table.rows))
    usual = DIALECTS if any(cell != IMPLIED for cell in columns[-1]) else ()
    strict = [kind_of_column(column) for column in columns]
    lenient = [
        "any" if kind == "length" and _might_be_degrees(column) else kind
        for kind, column in zip(strict, columns)
    ]
    for kinds in (strict, lenient):
        for known in (usual, permutations(ROLES)):
            fitting = [roles for roles in known if _fits(roles, columns, kinds)]
            if fitting:
                return [
                    Order(roles, DIALECTS.get(roles) or "an unusual order") for roles in fitting
                ]
    return []


def _is_contradicted(table, named):
    """Whether a program or a comment calls a column of multiples of π a length."""
    written = table.why.startswith(NAMED)
    roles = named[0].roles
    if written or table.form or len(named) > 1 or set(roles) != set(ROLES):
        return False
    columns = {role: [row[k] for row in table.rows] for k, role in enumerate(roles)}
    return bool({"d", "a"} & set(misplaced(columns)))


def _by_numbers(table, named):
    """The Orders that the numbers allow, those first that are nearest to the one that is named."""
    said = f"by the numbers; {' '.join(named.roles)}, {named.why}, would make lengths of angles"
    found = orders(replace(table, roles=None), None)
    near = [sum(map(str.__eq__, order.roles, named.roles)) for order in found]
    ranked = sorted(zip(near, found), key=lambda one: -one[0])
    return [replace(order, why=said) for _, order in ranked]


def _named(table):
    """What the headings mean; r is the length or the offset, whichever has no column."""
    roles = table.roles
    if "theta" not in roles and "offset" in roles:
        roles = tuple("theta" if role == "offset" else role for role in roles)
    missing = [role for role in ROLES if role not in roles]
    if not missing:
        return [Order(roles, table.why)]
    offsets = [k for k, role in enumerate(roles) if role == "offset"] if missing == ["d"] else []
    along = [k for k in offsets if _are_lengths(table, k, strict=len(offsets) > 1)]
    if len(along) == 1:
        named = tuple("d" if k == along[0] else role for k, role in enumerate(roles))
        return [Order(named, f"{table.why}, the offset being that along z")]
    if "r" in roles and missing == ["d"]:
        return [Order(_swapped(roles, r="d"), f"{table.why}, r being the offset along z")]
    if "r" in roles and missing == ["a"]:
        return _offset_or_length(roles, table)
    raise ValueError(
        f"recognise_table: the header has no column {' and '.join(missing)}; expected theta, d, a"
        " and alpha"
    )


def _are_lengths(table, k, strict):
    """Whether a column of offsets holds lengths; not strict, whether it may."""
    kind = kind_of_column([row[k] for row in table.rows])
    unit = table.units.get("offset")
    return unit in LENGTHS or (unit is None and kind in ("length", "" if strict else "any"))


def _offset_or_length(roles, table):
    """Columns d and r: Khalil and Kleinfinger's, where d is the length and r the offset of a Craig
    row, or those of a row in which r is the length.
    """
    khalil = Order(
        _swapped(roles, d="a", r="d"),
        f"{table.why}, d being the length and r the offset as Khalil and Kleinfinger write",
        "craig",
        "Khalil and Kleinfinger's rows are Craig's",
    )
    other = Order(_swapped(roles, r="a"), f"{table.why}, r being the length")
    at = [role for role in roles if role in ("theta", "d", "r", "alpha")]
    if at == ["alpha", "d", "theta", "r"] and table.convention != "standard":
        return [khalil]
    if table.convention == "standard" or at.index("r") + 1 == at.index("alpha"):
        return [other]
    return [khalil, other] if table.convention == "craig" else [other, khalil]


def _swapped(roles, **names):
    return tuple(names.get(role, role) for role in roles)


def _might_be_degrees(column):
    """Large numbers that are no multiples of 15: millimetres most often, but an odd zero offset may
    look so.
    """
    values = [abs(cell.value) for cell in column if cell.value]
    return (
        bool(values)
        and not any(cell.unit in LENGTHS for cell in column)
        and 10 < max(values) <= 360
    )


def is_a_table(table):
    """Whether rows are an arm's beyond doubt: columns that are named, lengths and angles."""
    try:
        found = next(iter(orders(table, None)), None) if table.rows else None
    except ValueError:  # its heading lacks a column
        return False
    if found is None:
        return False
    if [cell.value for cell in table.rows[-1]] == [0, 0, 0, 1]:
        return False  # a pose
    columns = {role: [row[k] for row in table.rows] for k, role in enumerate(found.roles)}
    twists = [cell for cell in columns.get("alpha", ()) if cell.value]
    lengths = [c for role in ("d", "a") for c in columns.get(role, ()) if c.value or c.letters]
    turns = [cell.value for cell in twists if not (cell.value % 90 == 0 or snapped(cell.value)[1])]
    named = table.roles is not None and table.why.startswith(NAMED)
    if turns and not named:
        return False
    return bool(twists and lengths) and not misplaced({"alpha": columns["alpha"]})


def misplaced(columns):
    """The roles whose columns hold the other kind of number: multiples of π/2 as lengths, odd
    values below 1 as angles.

    Parameters
    ----------
    columns : dict of str to sequence of Cell
    """
    found = []
    for role, column in columns.items():
        values = [abs(cell.value) for cell in column if cell.value]
        kind = kind_of_column(column) if values and role in ROLES else "any"
        if (role in ("d", "a") and kind == "angle") or (
            role in ("theta", "alpha") and kind == "length" and max(values) < 1
        ):
            found.append(role)
    return found


def _fits(roles, columns, kinds):
    moving = sum(any(cell.variable in ("theta", "q", "?") for cell in column) for column in columns)
    for role, column, kind in zip(roles, columns, kinds):
        variables = {cell.variable for cell in column} - {""}
        if kind not in ("any", "angle" if role in ("theta", "alpha") else "length"):
            return False
        if any(role not in PLACE[variable] for variable in variables):
            return False
        if "q" in variables and moving == 1 and role != "theta":
            return False  # an arm of sliding joints only is not what "q" in one column means
    return True


def kind_of_column(column):
    """ "angle", "length" or "any", by units, by letters, by multiples of 15° and by size."""
    if any(cell.unit in ("deg", "rad") or cell.variable in ("theta", "alpha") for cell in column):
        return "angle"
    if any(cell.unit in LENGTHS or cell.variable in ("d", "a", "length") for cell in column):
        return "length"
    values = np.array([cell.value for cell in column if cell.value])
    if not len(values):
        return "any"
    right_angles = (
        np.abs(values / 90 - np.round(values / 90)).max() < 1e-9 and np.abs(values).max() <= 360
    )
    small = np.abs(values).max() < MOST_TURNS  # 710 is 452 quarter turns, to the fourth digit
    quarters = np.abs(values - np.round(values / (np.pi / 2)) * np.pi / 2).max() < 2e-3
    if small and quarters:
        return "angle"
    if right_angles:
        return "any" if np.abs(values).max() >= LONGEST_ARM else "length"
    fine = (
        np.abs(values - np.round(values / STEP) * STEP).max() < 1e-9 and np.abs(values).max() <= 360
    )
    turns = small and np.abs(values - np.round(values / (np.pi / 12)) * np.pi / 12).max() < 2e-3
    mixed = np.abs(values).max() <= 360 and all(
        abs(v - round(v / 90) * 90) < 2e-3
        or (abs(v) < MOST_TURNS and abs(v - round(v / (np.pi / 2)) * np.pi / 2) < 2e-3)
        for v in values
    )
    return "any" if fine or turns else "angle" if mixed else "length"


def snapped(value):
    """The multiple of π/2 that a rounded number is near to, and its name; (None, "") of another.

    Examples
    --------
    >>> snapped(1.5708)[1], snapped(0.3)
    ('π/2', (None, ''))
    """
    turns = round(value / (np.pi / 2))
    if not turns or abs(turns) > 4 or abs(value - turns * np.pi / 2) > 2e-3 * abs(turns):
        return None, ""
    name = {1: "π/2", 2: "π", 3: "3π/2", 4: "2π"}[abs(turns)]
    return turns * np.pi / 2, f"{'-' if turns < 0 else ''}{name}"
