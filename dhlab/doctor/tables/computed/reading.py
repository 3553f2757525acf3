"""The readings of a program's own chain: all is computed but the unit of its lengths."""

import re
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from ....arm import Arm
from ....geometry.equivalence import equivalent
from ....table import DHTable
from ..cells import Cell
from ..completing.words import with_words
from ..evidence.source import source_of
from ..language.values import TO_METRES
from ..language.wrapping.notebook import without_notebook
from ..meaning.scales import UNIT_WORDS, in_metres, length_units
from ..pasted import Pasted
from ..readings import BOOKS, QUESTIONS, Reading, arm_of_rows
from .chains import chain_of

__all__ = ["Computed", "computed", "differs_in_theta", "moves_alike"]

ROLES = ("theta", "d", "a", "alpha")
LONGEST, MOST_LINES = 12_000, 400
IS_POSE = re.compile(r"_?(?:q|joint|angle|config|pose|servo|motor)", re.IGNORECASE)
QUARTER = np.pi / 2
# sets numbers of a robot that is made already, which is kept as it was; the words tell of these
CHANGED_LATER = re.compile(r"\.(?:offset|links\b[^=\n]*)\s*=[^=]")
WORDS = "as the program computes it"


@dataclass(frozen=True)
class Computed:
    """What a program computes: a Reading for each unit that its lengths can have, what is worth a
    second look, the ends that are not in the rows, and whether the program holds the joints' values
    itself, in one pose; ``of_function`` whether it does not call its link function, so that nothing
    is known of which rows have a joint; ``rows`` how many it has, with those without a joint.
    """

    readings: tuple
    notes: tuple = ()
    ends: tuple = ()
    posed: bool = False
    of_function: bool = False
    rows: int = 0


def computed(text, length=None):
    """The Computed chain of a program; None where it computes no whole chain of links.

    Parameters
    ----------
    text : str
    length : str, optional
        The unit of its lengths, where somebody says it.
    """
    text = without_notebook(text)
    if len(text) > LONGEST or text.count("\n") > MOST_LINES:
        return None
    found = _chain(text)
    if found is None:
        return None
    links, posed = found
    if links.of_toolbox and CHANGED_LATER.search(text):
        return None
    if any(_may_be_zeros(name, values) for name, values in posed):
        return None
    ends = ("base", "tool") if links.of_toolbox else links.ends
    found = _readings(links, text, length)
    notes, n = _notes(links, posed), len(links.rows)
    return Computed(found, notes, ends, bool(posed), links.of_function, n)


@lru_cache(64)
def _chain(text):
    """(Links, posed as pairs) of a program; None without them."""
    found = chain_of(text)
    if found is None:
        return None
    links, posed = found
    return links, tuple((name, tuple(np.ravel(value).tolist())) for name, value in posed.items())


def _may_be_zeros(name, values):
    """Whether numbers that are held for angles may be zeros that belong to the joints: quarter
    turns, under a name that both have.
    """
    turned = [value for value in values if value]
    quarters = [abs(v / QUARTER - round(v / QUARTER)) < 1e-3 or not v % 90 for v in turned]
    return not IS_POSE.match(name) and any(quarters)


def _readings(links, text, length):
    table = _as_pasted(links, text)
    columns = {role: [row[k] for row in table.rows] for k, role in enumerate(ROLES)}
    return tuple(
        _reading(links, columns, unit, why) for unit, why in length_units(table, columns, length)
    )


def _as_pasted(links, text):
    """The rows as a table, with what the words of the text say of its lengths."""
    rows = tuple(
        tuple(
            Cell(value, unit="" if role in ("d", "a") else "rad") for role, value in zip(ROLES, row)
        )
        for row in links.rows
    )
    table = Pasted(rows, ROLES, WORDS, form="a program")
    try:
        said = with_words(table, source_of(text))
    except ValueError:
        return table
    return replace(table, length=said.length, scaled=said.scaled, multiple=said.multiple)


def _reading(links, columns, unit, why):
    rows = np.array(links.rows, dtype=float)
    rows[:, 1] = [in_metres(cell, unit) for cell in columns["d"]]
    rows[:, 2] = [in_metres(cell, unit) for cell in columns["a"]]
    still = tuple(i for i, letter in enumerate(links.letters) if not letter)
    said = UNIT_WORDS[unit] + (f" {why}" if why.startswith("by") else f", {why}" if why else "")
    made = "function, called for each row" if links.of_function else "links"
    words = [f"the product of the program's {made}", BOOKS[links.convention], said]
    slides = [f"the joint of row {i + 1} slides" for i, c in enumerate(links.letters) if c == "P"]
    fixed = [f"rows without a joint: {', '.join(str(i + 1) for i in still)}"] if still else []
    choices = (ROLES, links.convention, "rad", unit, (), "", "", "computed")
    return Reading(
        arm_of_rows(links.convention, rows, list(links.letters), list(links.signs)),
        "; ".join([*words, *slides, *fixed]),
        choices=tuple(zip(QUESTIONS, choices)),
    )


def _notes(links, posed):
    said = [
        f"the program multiplies a constant matrix {where}, which is not in the rows"
        for end, where in (("base", "before its links"), ("tool", "behind its links"))
        if end in links.ends
    ]
    if posed:
        said.append(f"the numbers of {posed[0][0]} are taken for where the joints stand")
    return tuple(said)


def moves_alike(reading, other, free=()):
    """Whether two readings are one arm, whatever the unit of their lengths; ``free`` are the ends,
    "base" and "tool", in which they may differ.
    """
    one, two = reading.arm, other.arm
    if len(one) != len(two) or one.table.joints != two.table.joints:
        return False
    units = [TO_METRES[dict(each.choices).get("length") or "m"] for each in (reading, other)]
    ratio = units[0] / units[1]
    ends = dict.fromkeys(free, "free")
    return any(equivalent(one, _scaled(two, scale), **ends) for scale in sorted({ratio, 1.0}))


def differs_in_theta(reading, other):
    """Whether two readings have the same rows but for theta and the signs of the joints."""
    one, two = reading.arm.table, other.arm.table
    units = [TO_METRES[dict(each.choices).get("length") or "m"] for each in (reading, other)]
    if one.convention != two.convention or one.joints != two.joints:
        return False
    scale = (units[0] / units[1]) ** np.array([1.0, 1.0, 0.0])
    return bool(np.allclose(one.rows[:, 1:], two.rows[:, 1:] * scale, rtol=1e-9, atol=1e-9))


def _scaled(arm, ratio):
    """An arm with all lengths so many times as long."""
    rows = arm.table.rows * (1.0, ratio, ratio, 1.0)
    base, tool = arm.base.copy(), arm.tool.copy()
    base[:3, 3] *= ratio
    tool[:3, 3] *= ratio
    table = DHTable(arm.table.convention, *rows.T, arm.table.joints)
    return Arm(table, base=base, tool=tool, sign=arm.sign)
