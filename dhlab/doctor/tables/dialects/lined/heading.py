"""Which line is the heading of a table, or the units below it, and what its cells name."""

import re

import numpy as np

from ...cells import cell_or_none, plain
from ...language.roles import ROLES, role_of, unit_in
from ...language.words import NO_UNIT
from ...meaning.columns import LENGTHS

__all__ = ["header", "units_of"]

OF_ANGLES = re.compile(r"(?:cos|sin)[ _({]*(?:theta|alpha|θ|α)", re.IGNORECASE)
BY_N = re.compile(r"(theta|alpha|[adr])_?\{?n\}?")


def header(cells):
    """(roles, units, convention, whether d and not theta has the index i-1) of a heading; None of
    another line.
    """
    if any(isinstance(cell, (int, float, np.number)) for cell in cells):
        return None
    if 2 * sum(bool(OF_ANGLES.search(str(cell))) for cell in cells) > len(cells):
        return None  # a row of a link matrix
    if sum(bool(BY_N.fullmatch(str(cell).strip())) for cell in cells) > 2:  # theta_n, d_n, a_n
        cells = [BY_N.sub(r"\1_i", str(cell).strip()) for cell in cells]
    found = [(*role_of(cell), unit_in(plain(str(cell)))) for cell in cells]
    roles = tuple(role for role, _, _ in found)
    if "d" not in roles:  # an offset in millimetres is the length along z
        roles = tuple(
            "d" if role == "offset" and unit in LENGTHS else role
            for role, (_, _, unit) in zip(roles, found)
        )
    if len({"theta", "d", "a", "alpha", "r", "offset"} & set(roles)) < 3:
        return None
    if sum((one := cell_or_none(str(cell))) is not None and one.is_constant for cell in cells) > 1:
        return None
    before = {role for role, was, _ in found if was}
    if {"r", "theta"} <= set(roles) and "a" not in roles and "d" in before and "r" not in before:
        roles, before = tuple("a" if role == "d" else role for role in roles), {"a"}  # Khalil's
        roles = tuple("d" if role == "r" else role for role in roles)
    behind = "d" in before and "theta" not in before and {"theta", "d"} <= set(roles)
    previous = bool(before & {"a", "alpha", "r"}) and not {"d", "theta"} <= before
    if {"a", "d", "r"} <= set(roles):  # Khalil and Kleinfinger; their a(j) is the link before
        renamed = {"a": None, "d": "a", "r": "d"}
        roles, previous = tuple(renamed.get(role, role) for role in roles), True
    found = [(role, was, unit) for role, (_, was, unit) in zip(roles, found)]
    same = [re.search(r"[a-z_\s(\[{][ij][)\]}]*\s*$", _bare(cell)) for cell in cells]
    indexed = all(mark for mark, role in zip(same, roles) if role in (*ROLES, "r"))
    apart = {role for role, mark in zip(roles, same) if mark} | (before & {"a", "alpha"})
    if len(before & {"a", "alpha"}) == 1 and {"a", "alpha"} <= apart:
        previous = False  # a(i) beside alpha(i-1)
    return (
        roles,
        {role: unit for role, _, unit in reversed(found) if unit and role},  # the first counts
        "craig" if previous else "i" if indexed and not previous else None,
        behind,
    )


def units_of(cells):
    """The units, "" where a cell has none, when a line holds units and nothing else, as a
    spreadsheet has it below its heading; None of other lines.

    Examples
    --------
    >>> units_of(["", "[deg]", "mm", "(mm)", "°", "-"])
    ['', 'deg', 'mm', 'mm', 'deg', '']
    """
    words = [plain(str(cell)).strip("[]()/ ") for cell in cells]
    found = ["" if word in NO_UNIT else unit_in(f"x [{word}]") for word in words]
    said = sum(map(bool, found))
    if said < 2 or any(word not in NO_UNIT and not unit for word, unit in zip(words, found)):
        return None
    return found


def _bare(cell):
    text = re.sub(r"(?<=\S)\s+\((?:joint )?var(?:iable)?s?\)\s*$", "", plain(str(cell)))
    return re.sub(r"[\[(]\s*(deg|rad|mm|cm|m|°|in)\w*\s*[\])]", "", text).strip("$* ")
