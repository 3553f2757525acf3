"""Units, the commonest slip: an answer is read in other units before anything else is said of it.

Degrees and radians are mixed up, millimetres or centimetres stand where metres are asked, or a
conversion was made twice: in all numbers of a kind, in those of one column, or in a single one.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np
from numpy.typing import NDArray

from ....printing import listed
from ..exercise import Said

__all__ = ["FACTORS", "LOOSELY", "Group", "in_other_units", "of_places"]

LOOSELY = 5e-3  # of the value; of poses rad and m: 1.57 is a rounded 90°, and still in radians
DEGREES = 180 / np.pi
MOST_TURNS = 720  # degrees that an angle may come to
ASKED = {"deg": "degrees", "rad": "radians", "m": "metres", "m/s": "metres per second"}
ASKED |= {"rad/s": "radians per second"}
# by the unit that is asked: (what the answer is in, what it is multiplied by to be as asked)
SLIPS = {
    "deg": (
        ("radians", DEGREES),
        ("degrees, converted to degrees once more", 1 / DEGREES),
        ("radians, taken times π/180 and not 180/π", DEGREES**2),
    ),
    "rad": (("degrees", 1 / DEGREES), ("radians, converted to radians once more", DEGREES)),
    "m": (("millimetres", 1e-3), ("centimetres", 1e-2), ("metres, divided by 1000", 1e3)),
    "m/s": (("millimetres per second", 1e-3),),
    "rad/s": (("degrees per second", 1 / DEGREES),),
}
FACTORS = (1.0, *{factor for slips in SLIPS.values() for _, factor in slips})
NEXT = {  # by what an answer is in, or by the unit that is asked
    "deg": "np.rad2deg makes degrees of radians. Convert once, and all angles.",
    "rad": "np.deg2rad makes radians of degrees. Convert once, and all angles.",
    "rad/s": "np.deg2rad makes radians of degrees. Convert once, and all angles.",
    "m/s": "Divide millimetres by 1000, once, and all lengths.",
    "millimetres": "Divide millimetres by 1000, once, and all lengths.",
    "centimetres": "Divide centimetres by 100, once, and all lengths.",
    "metres, divided by 1000": "These lengths were divided by 1000 once too often.",
}


@dataclass(frozen=True)
class Group:
    """Numbers of an answer that are of one unit: what they are called, the unit that is asked
    (a key of ``ASKED``), and where they stand (a mask of the answer's shape).
    """

    name: str
    unit: str
    where: NDArray[np.bool_]

    @property
    def angle(self) -> bool:
        """Whether these are angles, not lengths."""
        return "m" not in self.unit


def of_places(units: Sequence[str], names: Sequence[str]) -> list[Group]:
    """A group for every entry of a vector that has a unit, by its name."""
    places = np.arange(len(units))
    return [Group(name, u, places == k) for k, (u, name) in enumerate(zip(units, names)) if u]


def in_other_units(
    answer: NDArray, groups: Sequence[Group], fits: Callable[[NDArray], bool]
) -> tuple[str, Said] | None:
    """The slip of units that explains an answer, with what is said of it; None when there is none.

    ``fits(numbers)`` says whether numbers are right, within :data:`LOOSELY`. The fewest groups that
    explain it are told.
    """
    for change in sorted(_changes(groups), key=len):
        if any(_unlikely(answer[group.where], group, factor) for group, _, factor in change):
            continue
        with np.errstate(over="ignore"):
            scaled = _scaled(answer, change)
        if not np.isfinite(scaled).all():  # a number that no unit makes larger
            continue
        if fits(scaled) and not any(fits(_without(scaled, group)) for group, *_ in change):
            return _said(change)
    return None


def _scaled(answer, change):
    """An answer with groups read in their other units."""
    numbers = np.array(answer, dtype=float)
    for group, _, factor in change:
        numbers[group.where] *= factor
    return numbers


def _without(numbers, group):
    """Numbers with 0 in a group's places: where that fits as well, they do not tell their unit."""
    return np.where(group.where, 0, numbers)


def _changes(groups: Sequence[Group]) -> Iterator[list[tuple[Group, str, float]]]:
    """Readings as lists of (group, what it is in, factor): all angles that are changed have one
    slip, and all lengths one.
    """
    angles = [g for g in groups if g.angle]
    lengths = [g for g in groups if not g.angle]
    for some_angles, some_lengths in product(_readings(angles), _readings(lengths)):
        if some_angles or some_lengths:
            yield [*some_angles, *some_lengths]


def _readings(groups):
    yield []
    for unit in dict.fromkeys(group.unit for group in groups):
        same = [group for group in groups if group.unit == unit]
        for slip in SLIPS[unit]:
            if len(same) > FEW:
                yield [(group, *slip) for group in same]
                continue
            for chosen in product((False, True), repeat=len(same)):
                if any(chosen):
                    yield [(group, *slip) for group, take in zip(same, chosen) if take]


FEW = 3  # groups of one unit, of which every subset is tried; of more, all together


def _unlikely(numbers, group, factor):
    """Whether a conversion would change nothing that can be seen, or make many turns of what are
    hardly radians.
    """
    largest = np.abs(numbers).max(initial=0)
    return largest <= 1e-9 or (group.unit == "deg" and factor > 1 and factor * largest > MOST_TURNS)


def _said(change):
    """What is said of a slip: one sentence for angles, one for lengths, one for both."""
    angles = [part for part in change if part[0].angle]
    lengths = [part for part in change if not part[0].angle]
    if angles and lengths:
        (a, in_angle, _), (b, in_length, _) = angles[0], lengths[0]
        return "length-unit", Said(
            f"in other units: {_names(angles)} in {in_angle}, {_names(lengths)} in {in_length};"
            f" {ASKED[a.unit]} and {ASKED[b.unit]} are asked",
            next=f"{_next(a, in_angle)} {_next(b, in_length)}",
        )
    group, found, _ = change[0]
    return "angle-unit" if angles else "length-unit", Said(
        f"in other units: {_names(change)} in {found}; {ASKED[group.unit]} are asked",
        next=_next(group, found),
    )


def _next(group, found):
    return NEXT.get(found) or NEXT[group.unit]


def _names(parts):
    return listed(group.name for group, *_ in parts)
