"""What a column of a pasted table can be: angles or lengths, degrees or radians, metres or
millimetres.
"""

from itertools import permutations

import numpy as np

__all__ = ["orders", "angle_units", "length_units", "misplaced", "snapped"]

# who writes his columns so, the most common first
DIALECTS = {
    ("theta", "d", "a", "alpha"): "as here and in the Robotics Toolbox",
    ("a", "alpha", "d", "theta"): "as in MATLAB and Spong's book",
    ("alpha", "a", "theta", "d"): "as in some lecture notes",
    ("alpha", "a", "d", "theta"): "as in Craig's book",
    ("theta", "a", "d", "alpha"): "as Universal Robots prints it",
    ("a", "d", "alpha", "theta"): "as Franka prints it",
    ("d", "theta", "a", "alpha"): "as in many papers",
    ("a", "alpha", "theta", "d"): "",
    ("theta", "alpha", "a", "d"): "",
    ("alpha", "theta", "a", "d"): "",
    ("theta", "alpha", "d", "a"): "",
}
ROLES = ("theta", "d", "a", "alpha")
LONGEST_ARM = 3.0  # metres; a length beyond it is taken for millimetres or asked about
STEP = 15  # degrees; angles in tables are multiples of it


def orders(table, given):
    """(roles of the columns, why) that fit, the likeliest first."""
    if given is not None:
        return [(tuple(given.split()), "as you say")]
    if table.roles is not None:
        missing = [role for role in ROLES if role not in table.roles]
        if missing:
            raise ValueError(
                f"recognise_table: the header has no column {' and '.join(missing)}; expected"
                " theta, d, a and alpha"
            )
        return [(table.roles, "as the header says")]
    columns = list(zip(*table.rows))
    strict = [_kind(column) for column in columns]
    lenient = [
        "any" if kind == "length" and _might_be_degrees(column) else kind
        for kind, column in zip(strict, columns)
    ]
    for kinds in (strict, lenient):
        for known in (DIALECTS, permutations(ROLES)):
            fitting = [roles for roles in known if _fits(roles, columns, kinds)]
            if fitting:
                return [(roles, DIALECTS.get(roles) or "an unusual order") for roles in fitting]
    return []


def _might_be_degrees(column):
    """Large numbers that are no multiples of 15: millimetres most often, but an odd zero offset may
    look so.
    """
    values = [abs(cell.value) for cell in column if cell.value]
    return not any(cell.unit in ("mm", "cm", "m") for cell in column) and 10 < max(values) <= 360


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
        kind = _kind(column) if values and role in ROLES else "any"
        if (role in ("d", "a") and kind == "angle") or (
            role in ("theta", "alpha") and kind == "length" and max(values) < 1
        ):
            found.append(role)
    return found


def _fits(roles, columns, kinds):
    moving = sum(any(not cell.is_constant for cell in column) for column in columns)
    for role, column, kind in zip(roles, columns, kinds):
        variables = {cell.variable for cell in column} - {""}
        if kind not in ("any", "angle" if role in ("theta", "alpha") else "length"):
            return False
        if (
            ("theta" in variables and role != "theta")
            or ("d" in variables and role != "d")
            or (variables and role not in ("theta", "d"))
        ):
            return False
        if "q" in variables and moving == 1 and role != "theta":
            return False  # an arm of sliding joints only is not what "q" in one column means
    return True


def _kind(column):
    """ "angle", "length" or "any", by units, by multiples of 15° and by size."""
    if any(cell.unit in ("deg", "rad") or cell.variable == "theta" for cell in column):
        return "angle"
    if any(cell.unit in ("mm", "cm", "m") or cell.variable == "d" for cell in column):
        return "length"
    values = np.array([cell.value for cell in column if cell.value])
    if not len(values):
        return "any"
    right_angles = (
        np.abs(values / 90 - np.round(values / 90)).max() < 1e-9 and np.abs(values).max() <= 360
    )
    quarters = np.abs(values - np.round(values / (np.pi / 2)) * np.pi / 2).max() < 2e-3
    if quarters:
        return "angle"
    if right_angles:
        return "any" if np.abs(values).max() >= LONGEST_ARM else "length"
    fine = (
        np.abs(values - np.round(values / STEP) * STEP).max() < 1e-9 and np.abs(values).max() <= 360
    )
    turns = np.abs(values - np.round(values / (np.pi / 12)) * np.pi / 12).max() < 2e-3
    mixed = all(
        min(abs(v - round(v / 90) * 90), abs(v - round(v / (np.pi / 2)) * np.pi / 2)) < 2e-3
        for v in values
    )
    return "any" if fine or turns else "angle" if mixed else "length"


def angle_units(table, columns, given):
    """The units that the angles can have: "deg", "rad", or "mixed" when one column holds both."""
    said = {table.units.get(role) for role in ("theta", "alpha")} & {"deg", "rad"}
    if given or said:
        return [given or said.pop()]
    cells = [
        cell
        for role in ("theta", "alpha", "offset")
        for cell in columns.get(role, ())
        if cell.value
    ]
    if not cells or all(cell.unit == "deg" for cell in cells):
        return ["deg"]
    bare = [cell for cell in cells if cell.unit not in ("deg", "rad")]
    beyond = [cell for cell in bare if abs(cell.value) > 2 * np.pi]
    small = [
        cell
        for cell in cells
        if (cell not in beyond and cell.unit != "deg" and snapped(cell.value)[1])
        or cell.unit == "rad"
    ]
    if beyond and small:
        return ["mixed"]
    if beyond:
        return ["deg"]
    if small or not bare:
        return ["rad"]
    return ["rad", "deg"]


def length_units(table, columns, given):
    """The units that the lengths can have, "m" or "mm"; both when the size does not tell."""
    said = {table.units.get(role) for role in ("d", "a")} & {"m", "mm"}
    if given or said:
        return [given or said.pop()]
    sizes = [
        abs(cell.value)
        for role in ("d", "a")
        for cell in columns[role]
        if cell.value and cell.unit not in ("mm", "cm", "m")
    ]
    if not sizes or max(sizes) <= LONGEST_ARM:
        return ["m"]
    return ["mm"] if max(sizes) > 10 else ["m", "mm"]


def snapped(value):
    """(value, "") or the multiple of π/2 that a rounded number means, with a sentence.

    Examples
    --------
    >>> snapped(1.5708)[1], snapped(0.3)
    ('1.5708 is read as π/2', (0.3, ''))
    """
    turns = round(value / (np.pi / 2))
    if not turns or abs(turns) > 4 or abs(value - turns * np.pi / 2) > 2e-3 * abs(turns):
        return value, ""
    exact = turns * np.pi / 2
    name = {1: "π/2", 2: "π", 3: "3π/2", 4: "2π"}[abs(turns)]
    return exact, f"{value:.6g} is read as {'-' if turns < 0 else ''}{name}"
