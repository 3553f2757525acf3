"""In which units the numbers of a pasted table can be: what the headings say, else the words around
it, else their size; every unit that fits where these do not settle it.
"""

import re

import numpy as np

from ....units import convert
from ..language.expressions import key
from ..language.values import TO_METRES
from .columns import LENGTHS, snapped

__all__ = [
    "UNIT_WORDS", "angle_units", "in_metres", "in_radians", "length_units",
    "measured_in",
    "multiples_said", "reached", "takes_thousandths",
    "the_measure",
    "units_by_size",
]  # fmt: skip

UNIT_WORDS = {
    "deg": "degrees",
    "rad": "radians",
    "mixed": "radians, with numbers beyond 2π as degrees",
    "m": "metres",
    "mm": "millimetres",
    "cm": "centimetres",
    "in": "inches",
}
SCALED = re.compile(r"mm_?(?:2|to)_?m|[*/]\s*(?:1000(?:\.0*)?|1e-?0?3|0?\.001|10\^-3)(?![\d.])")
# lengths that a comment calls multiples: documentation x 10, scaled by 10, 10 times the manual's
MULTIPLE = re.compile(
    r"(?<![\d\s])\s*(?:\bx|×|\*)\s*10+(?:\.0*)?(?![\w.])"
    r"|\b(?:scaled|multiplied|enlarged|shrunk)\s+(?:up\s+|down\s+)?(?:by|with)\s+"
    r"(?:an?\s+)?(?:factor\s+(?:of\s+)?)?\d|\b10+(?:x|\s*times)\s+(?:the|as|larger|bigger|smaller)",
    re.IGNORECASE,
)
MEASURE = re.compile(r"(?<![\w.,])(\d+(?:[.,]\d+)?)\s?(mm|cm|m)\b(?!/)")
OPEN = "m", "cm", "mm"  # what multiples may be in, as far as anybody can tell
# an arm that somebody gives in this unit: how far, in metres, all its links reach in a row
REACHES = {"m": (0.0, 6.0), "cm": (0.05, 2.0), "mm": (0.05, np.inf), "in": (0.05, 1.5)}
LONGEST = {"cm": 70.0, "in": 70.0}  # a link, in its unit
SHORT_LINK = 0.5  # a number as small as this is in metres, where metres make an arm at all
TINY = 0.003  # metres, all links in a row: nobody has such an arm
FARTHEST = 8.0  # metres, of an arm whose text measures something else in the same unit
TOY = 3.0  # the longest number: up to it, "mm" in the text is doubtful
DOUBTFUL = 0.015, 25.0  # an arm that reaches less or more, in metres, is in another unit than said


def angle_units(table, columns, given):
    """The (unit, why) that the angles can have; "mixed" when one column holds both."""
    if given:
        return [(given, "as you say")]
    cells = [
        cell
        for role in ("theta", "alpha", "offset")
        for cell in columns.get(role, ())
        if cell.value
    ]
    heads = {table.units.get(role) for role in ("theta", "alpha", "offset")} & {"deg", "rad"}
    bare = [cell for cell in cells if cell.unit not in ("deg", "rad")]
    if len(heads) == 1:
        return _checked_angle(heads.pop(), bare, "as the heading says")
    if not bare:
        marked = {cell.unit for cell in cells} or {"rad"}
        return [("deg" if marked == {"deg"} else "rad", "as the cells say")]
    beyond = [cell for cell in bare if abs(cell.value) > 2 * np.pi + 0.01]
    near = [cell for cell in bare if cell not in beyond and snapped(cell.value)[1]]
    small = [*near, *(cell for cell in cells if cell.unit == "rad")]
    if table.angle:
        return _checked_angle(table.angle, bare, "as the text says")
    if beyond and small:
        return [("mixed", "by size")]
    if beyond:
        return [("deg", "by size")]
    if small:
        return [("rad", "by size")]
    return [("rad", "by size"), ("deg", "by size")]


def _checked_angle(unit, cells, why):
    """The unit that is said; the other beside it where the numbers contradict it."""
    values = np.array([abs(cell.value) for cell in cells])
    if not len(values):
        return [(unit, why)]
    right = np.abs(values / 90 - np.round(values / 90)).max() < 1e-9
    if unit == "rad" and right and values.max() > 4 * np.pi:
        return [("deg", f"though the text says {UNIT_WORDS[unit]}"), (unit, why)]
    if unit == "rad" and any(
        value > 2 * np.pi + 0.01 and not snapped(value)[1] for value in values
    ):
        return [("deg", f"though the text says {UNIT_WORDS[unit]}"), (unit, why)]
    if unit == "deg" and all(snapped(value)[1] for value in values):
        return [("rad", f"though the text says {UNIT_WORDS[unit]}"), (unit, why)]
    if unit == "deg" and any(snapped(value)[1] and value % 1 for value in values):  # 1.5708
        return [("mixed", f"though the text says {UNIT_WORDS[unit]}"), (unit, why)]
    return [(unit, why)]


def length_units(table, columns, given):
    """The (unit, why) that the lengths can have; several where size does not tell."""
    if given:
        return [(given, "as you say")]
    cells = [cell for role in ("d", "a") for cell in columns[role]]
    sizes = [abs(cell.value) for cell in cells if cell.value and cell.unit not in LENGTHS]
    if not sizes:
        marked = {cell.unit for cell in cells if cell.unit in LENGTHS}
        return [(marked.pop() if len(marked) == 1 else "m", "as the cells say")]
    longest = max(sizes)
    heads = {table.units.get(role) for role in ("d", "a")} & set(LENGTHS)
    headed = len(heads) == 1
    said = heads.pop() if headed else table.length
    if said:
        why = (
            "as the heading says"
            if not table.length or said != table.length
            else "as the text says"
        )
        scaled = any(SCALED.search(cell.text) for cell in cells)
        if said == "mm" and longest < TOY and (scaled or table.scaled):
            return [("m", f"by the factor in the {'cells' if scaled else 'program'}")]
        if said == "m" and table.scaled and "mm" in _better(said, sizes):
            return [("mm", "by the factor in the program")]
        doubt = f"though the text says {UNIT_WORDS[said]}"
        better = [(unit, doubt) for unit in _better(said, sizes)]
        tiny = not headed and sum(sizes) * TO_METRES[said] < TINY  # said of something else
        return better if better and tiny else [*better, (said, why)]
    if table.multiple:
        return [(unit, reached(sizes, unit)) for unit in OPEN]
    found = units_by_size(sizes)
    if len(found) > 1 and "mm" in found and table.scaled and longest >= TOY:
        return [("mm", "by the factor in the program")]
    if len(found) > 1 and table.measured in found:
        reach = sum(sizes) * TO_METRES[table.measured]
        if REACHES["cm"][0] < reach <= FARTHEST:
            return [(table.measured, "as the text measures")]
    return [(unit, reached(sizes, unit)) for unit in found]


def measured_in(text, rows, roles):
    """The unit that the text gives beside all lengths of the rows, ``L1 = 10 cm`` above a table
    with 10; "" where it does not.

    Examples
    --------
    >>> from ..cells import read_cell
    >>> rows = [[read_cell(one) for one in row] for row in (("10", "0"), ("0", "12"))]
    >>> measured_in("L1 = 10 cm, L2 = 12 cm", rows, ("d", "a"))
    'cm'
    """
    kept = [k for k, role in enumerate(roles or ()) if role in ("d", "a", "r")]
    lengths = {abs(row[k].value) for row in rows for k in kept if row[k].value}
    units = {
        unit: {
            float(number.replace(",", ".")) for number, one in MEASURE.findall(text) if one == unit
        }
        for unit in ("mm", "cm", "m")
    }
    fits = [unit for unit, numbers in units.items() if len(lengths) > 1 and lengths <= numbers]
    return fits[0] if len(fits) == 1 else ""


def the_measure(text):
    """The one unit in which a text measures lengths, "" where it does in several or in none.

    Examples
    --------
    >>> the_measure("a camera 0.5 m above"), the_measure("1 m or 5 cm")
    ('m', '')
    """
    units = {unit for _, unit in MEASURE.findall(text)}
    return units.pop() if len(units) == 1 else ""


def takes_thousandths(code):
    """Whether a program divides by 1000, or multiplies by what does.

    Examples
    --------
    >>> takes_thousandths("T[0, 3] = a / 1000"), takes_thousandths("t = 1000")
    (True, False)
    """
    return bool(SCALED.search(code))


def multiples_said(source, rows):
    """The comment that calls lengths of the rows multiples of others, "" without one: it stands
    behind a name that the rows use, or speaks of lengths.

    Examples
    --------
    >>> from ..evidence.source import source_of
    >>> multiples_said(source_of("0.2, 4, 0, 0  # lengths scaled by 10"), ())
    'lengths scaled by 10'
    """
    used = {key(w) for row in rows for c in row for w in re.findall(r"[A-Za-z_][\w.]*", c.text)}
    for number, comment in source.comments:
        line = source.lines[number - 1] if number <= len(source.lines) else ""
        named = re.match(r"\s*([A-Za-z_][\w.]*)\s*=", line)
        about = (named and key(named[1]) in used) or re.search(r"(?i)length|dimension", comment)
        if about and MULTIPLE.search(comment):
            return comment
    return ""


def _better(said, sizes):
    """The units in which lengths make an arm, where they make none in the one that is said."""
    reach = sum(sizes) * TO_METRES[said]
    if reach > DOUBTFUL[1] and np.median(sizes) > 1:  # near-parallel axes have huge d among others
        return [unit for unit in ("mm", "cm") if _makes_an_arm(unit, sizes)][:1]
    if said == "mm" and max(sizes) < TOY:
        return ["m"]
    if reach < DOUBTFUL[0]:
        return [unit for unit in ("m", "cm") if _makes_an_arm(unit, sizes)][:1]
    return []


def _makes_an_arm(unit, sizes):
    least, most = REACHES[unit]
    return least <= sum(sizes) * TO_METRES[unit] <= most


def units_by_size(sizes):
    """The units in which lengths without one make an arm, the likeliest first.

    Parameters
    ----------
    sizes : sequence of float
        The lengths that are not 0, without their signs.

    Examples
    --------
    >>> units_by_size([0.333, 0.316, 0.384]), units_by_size([290, 270, 70, 302])
    (['m'], ['mm'])
    >>> units_by_size([4, 5, 13]), units_by_size([2, 1])
    (['cm', 'in', 'm'], ['m', 'in'])
    """
    reach, longest = sum(sizes), max(sizes, default=0.0)
    fits = [
        unit
        for unit, (least, most) in REACHES.items()
        if least <= reach * TO_METRES[unit] <= most and longest <= LONGEST.get(unit, np.inf)
    ]
    if not sizes or ("m" in fits and min(sizes) <= SHORT_LINK):
        return ["m"]
    if longest > LONGEST["cm"] and np.median(sizes) < 1:
        return ["m", "mm"]
    alone = (
        fits if fits == ["mm"] else [*fits, "m"]
    )  # numbers of a textbook are lengths as they stand
    return list(dict.fromkeys(alone))


def reached(sizes, unit):
    """Why a unit is taken, in words: how far the arm reaches in it."""
    if not sizes:
        return "by size"
    return f"by size: all links in a row reach {sum(sizes) * TO_METRES[unit]:.3g} m"


def in_metres(cell, unit):
    """The number of a length in metres."""
    return convert(cell.value, TO_METRES[cell.unit if cell.unit in LENGTHS else unit])


def in_radians(cell, unit):
    """The number of an angle in radians."""
    degrees = cell.unit == "deg" or (
        cell.unit != "rad"
        and (unit == "deg" or (unit == "mixed" and abs(cell.value) > 2 * np.pi + 0.01))
    )
    return float(np.deg2rad(cell.value)) if degrees else cell.value
