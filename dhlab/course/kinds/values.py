"""``Value``: a number or an array to be worked out."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import partial
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from ..verdict import Verdict
from .exercise import Exercise, Said, no_draw
from .kept import kept, kept_apart
from .partial import PART_IS_RIGHT, filled_up
from .reading import Unreadable, plain, split_at_commas
from .wrong.drawn import drawn_pose, drawn_row
from .wrong.twofold import FRAMES, SIGNS, TWO, by_entries, of_any_pose, of_any_vector, under_another
from .wrong.units import FACTORS, LOOSELY, Group, in_other_units, of_places

__all__ = ["LAST_ROW", "Value"]

ROW = ("deg", "m", "m", "deg")  # theta, d, a, alpha of one link
CUT_OFF = Said(
    "these are the right numbers with their decimals cut off",
    next="An array of whole numbers cuts off what is written into it: say dtype=float.",
)
ROUNDED = Said(
    "these are the right numbers, rounded too early",
    next="Give more digits, or let numpy compute the numbers.",
)
PLAIN = "Give plain numbers, all of them, no text."
DECIMAL_POINT = "Write a decimal point, and no quotation marks: 0.5."
SPLIT = "Is there a decimal comma? Python reads 0,5 as two numbers; write 0.5."
NOTHING = Said(
    "every number is 0", next="Was each number written in its place before this was handed in?"
)
LAST_ROW = Said(  # of a place that is read off a pose
    "every number is 0, as in the last row of a pose",
    next="Where in a 4×4 does the place stand: in its last row, or in its last column?",
)
MOST_DEGREES = 1e6  # off by more, an angle has no digits left in which turns could be told apart
HARDLY = 0.1  # of the largest number: further off, a rounded answer is hardly the right one


@dataclass(frozen=True, kw_only=True)
class Value(Exercise):
    """A number or an array to be given.

    ``draw(rng)`` gives the task's numbers by name; ``answer(**given)`` the right value;
    ``mistakes(**given)`` yields (mistake, what is said, wrong value); ``misshapen(answer,
    **given)`` gives (mistake, what is said) for wrong answers that it knows whatever their shape,
    else None; ``entries`` names the entries of a vector, for the place; ``turns`` are the positions
    of the entries that are angles in degrees: these are compared modulo 360, with the right value
    and with the wrong ones. ``units`` is the unit of all numbers, or of each entry of a vector
    ("deg", "rad", "m", "m/s", "rad/s", "" for none), or "pose" for a 4×4 in metres: other units are
    tried before anything else is said.
    """

    greek: ClassVar[bool] = True
    answer: Callable
    draw: Callable = no_draw
    mistakes: Callable = lambda **given: ()
    misshapen: Callable = lambda answer, **given: None
    entries: tuple = ()
    turns: tuple = ()
    units: str | tuple = ""
    tolerance: float = 1e-3

    @kept_apart
    def given(self, variant: int) -> Mapping[str, Any]:
        return self.draw(self.rng(variant))

    @kept
    def expected(self, variant: int) -> NDArray[np.float64]:
        """The right numbers."""
        return np.asarray(self.answer(**self.given(variant)), dtype=float)

    def compare(self, answer: Any, variant: int) -> Verdict:
        given, expected = self.given(variant), self.expected(variant)
        known = self.misshapen(answer, **given)
        if known:
            return self.told(*known)
        try:
            array = plain(answer)
        except Unreadable as found:
            return self.wrong(
                headline=f"expected {_amount(expected)}, found {found}",
                next=DECIMAL_POINT if "commas" in str(found) else PLAIN,
            )
        if array.size == expected.size == 1:
            array = array.reshape(expected.shape)  # one number in a list is that number
        if expected.ndim == 1 and max(array.shape, default=0) == array.size:
            array = array.ravel()  # a column n×1, or a row 1×n, is a vector
        if array.shape != expected.shape:
            said = f"expected {_amount(expected)}, found {_amount(array)}"
            if split_at_commas(array, expected.size):
                return self.wrong(headline=said, next=SPLIT)
            return self.wrong(headline=said)
        if not np.isfinite(array).all():
            return self.wrong(headline="expected finite numbers, found NaN or infinity")
        return self._compared(array, expected, given, answer)

    def so_far(self, answer: Any, variant: int) -> str:
        expected = self.expected(variant)
        filled = filled_up(answer, expected)
        fits = filled is not None and self.is_right(filled, expected, self.given(variant))
        return PART_IS_RIGHT if fits else ""

    def is_right(self, array: NDArray, expected: NDArray, given: Mapping[str, Any]) -> bool:
        """Whether an array of the right shape is the answer."""
        return not self.differs(array, expected).any()

    def _compared(self, array, expected, given, answer):
        """The Verdict on finite numbers of the right shape."""
        if self.is_right(array, expected, given):
            return self.right()
        off = self.differs(array, expected)
        unit = in_other_units(
            array,
            self._groups(expected),
            lambda numbers: not self.differs(numbers, expected, LOOSELY).any(),
        )
        if unit:
            return self.told(*unit)
        known = [*self.mistakes(**given), *self._of_any(expected)]
        for mistake, said, value in known:
            if self._is(array, value):
                return self.told(mistake, said)
        if not array.any():
            return self.told(None, replace(NOTHING, place=self._place(off)))
        whole = isinstance(answer, np.ndarray) and array.dtype.kind == "i"
        if whole and np.array_equal(array, np.trunc(expected)):
            return self.told("integer-arrays", CUT_OFF)
        unlike = [of for of in self._of_one_unit(expected) if off[of].any()]
        if all(_rounded(array[of], expected[of]) for of in unlike):
            return self.told("pi-rounded", ROUNDED)
        return self._twofold(array, expected, known) or self.wrong(
            headline="these are not the numbers", place=self._place(off)
        )

    def _is(self, array, value):
        """Whether an array is a value."""
        return (
            np.shape(value) == array.shape
            and not self.differs(array, np.asarray(value, dtype=float)).any()
        )

    def _of_any(self, expected):
        """The slips that any numbers of a unit may have."""
        if self.units == "pose":
            return of_any_pose(expected)
        named = self.entries and self.units and expected.ndim == 1
        return of_any_vector(expected, self.entries) if named else ()

    def _twofold(self, array, expected, known):
        """The Verdict on two slips at once; None where no two explain the numbers."""
        found = None
        if self.units == "pose":
            found = next(under_another(array, known, self._is, FRAMES), None)
        elif expected.ndim == 1:
            found = by_entries(array, expected, known, self.differs)
            unsigned = [one for one in known if not str(one[0]).endswith("-sign")]
            found = found or next(under_another(array, unsigned, self._is, SIGNS), None)
        found = found or self._in_units_of(array, expected, known)
        if found is None:
            return None
        first, second = (self.told(*slip[:2]) for slip in found)
        after = next((v.next for v in (first, second) if not v.next.startswith("hint(")), "")
        return self.told(
            first.mistake or second.mistake,
            Said(TWO.format(first.headline, second.headline), next=after),
        )

    def _in_units_of(self, array, expected, known):
        """A known slip that explains the numbers in other units, and that slip of units; None."""
        groups = self._groups(expected)
        for one in known if groups else ():
            value = np.asarray(one[2], dtype=float)
            if np.shape(value) != array.shape:
                continue
            fits = [~self.differs(array * factor, value) for factor in FACTORS]
            if np.any(fits, axis=0).all():
                unit = in_other_units(array, groups, partial(self._is, value=value))
                if unit:
                    return one, unit
        return None

    def drawn(self, answer: Any, variant: int = 0) -> Any:
        expected = self.expected(variant)
        try:
            array = plain(answer)
        except Unreadable:
            return None
        if array.shape != expected.shape or not np.isfinite(array).all():
            return None
        if self.units == ROW:
            return drawn_row(array, expected)
        return drawn_pose(array, self.differs(array, expected)) if self.units == "pose" else None

    def _groups(self, expected):
        """The numbers by their units."""
        if self.units == "pose":
            return [Group("the last column", "m", np.pad(np.ones((3, 1)), ((0, 1), (3, 0))) > 0)]
        if isinstance(self.units, tuple):
            return of_places(self.units, self.entries)
        every = np.ones(expected.shape, dtype=bool)
        return [Group("the numbers", self.units, every)] if self.units else []

    def _of_one_unit(self, expected):
        """Masks of the numbers that are of one unit, and are rounded together."""
        every = np.ones(expected.shape, dtype=bool)
        if not isinstance(self.units, tuple):
            return [every]
        return [np.array([u == unit for u in self.units]) for unit in dict.fromkeys(self.units)]

    def differs(self, array: NDArray, value: NDArray, tolerance: float = 0) -> NDArray[np.bool_]:
        """Which entries of an array differ from those of a value, or of a stack of values; whole
        turns apart where they are angles. ``tolerance``, a part of the value, where it is to be
        larger than usual.
        """
        difference = np.asarray(array - value)
        size = np.abs(value)
        if self.turns:
            angles = np.isin(np.arange(array.size), self.turns).reshape(array.shape)
            angles = angles & (np.abs(difference) < MOST_DEGREES)
            difference = np.where(angles, difference - 360 * np.round(difference / 360), difference)
            size = np.abs(np.where(angles, value - 360 * np.round(value / 360), value))
        allowed = np.maximum(tolerance * size, self.tolerance * (1 + size))
        return ~(np.abs(difference) <= allowed)

    def _place(self, off):
        if off.ndim == 2:
            i, j = np.argwhere(off)[0] + 1
            return f"{off.sum()} of {off.size} entries, the first in row {i}, column {j}"
        names = self.entries or [f"number {k + 1}" for k in range(off.size)]
        return ", ".join(name for name, bad in zip(names, np.ravel(off)) if bad) if off.ndim else ""


def _rounded(array, expected):
    """Whether these are the expected numbers with fewer decimals, and still near them."""
    far = np.abs(array - expected).max(initial=0) > HARDLY * np.abs(expected).max(initial=0)
    return not far and any(
        np.allclose(array, np.round(expected, k), rtol=0, atol=1e-9) for k in range(6)
    )


def _amount(array):
    return "one number" if array.ndim == 0 else f"{'×'.join(map(str, array.shape))} numbers"
