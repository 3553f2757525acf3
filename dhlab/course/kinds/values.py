"""``Value``: a number or an array to be worked out."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..verdict import Verdict
from .exercise import Exercise, no_draw

__all__ = ["Value", "as_numbers", "is_array_of"]


@dataclass(frozen=True, kw_only=True)
class Value(Exercise):
    """A number or an array to be given.

    ``draw(rng)`` gives the task's numbers by name; ``answer(**given)`` the right value;
    ``mistakes(**given)`` yields (mistake, place, wrong value); ``misshapen(answer, **given)`` gives
    (mistake, place) for wrong answers that it knows whatever their shape, else None; ``entries``
    names the entries of a vector, for the place; ``turns`` are the positions of the entries that
    are angles in degrees: these are compared modulo 360, with the right value and with the wrong
    ones.
    """

    answer: Callable
    draw: Callable = no_draw
    mistakes: Callable = lambda **given: ()
    misshapen: Callable = lambda answer, **given: None
    entries: tuple = ()
    turns: tuple = ()
    tolerance: float = 1e-3

    def given(self, variant: int) -> Mapping[str, Any]:
        return self.draw(self.rng(variant))

    def compare(self, answer: Any, variant: int) -> Verdict:
        given = self.given(variant)
        known = self.misshapen(answer, **given)
        if known:
            return self.wrong(known[0], place=known[1])
        expected = np.asarray(self.answer(**given), dtype=float)
        try:
            array = _plain(answer)
        except (TypeError, ValueError):
            return self.wrong(
                headline=f"expected {_amount(expected)}, found {type(answer).__name__}",
                next="Give plain numbers, all of them, no text.",
            )
        if array.shape != expected.shape:
            return self.wrong(headline=f"expected {_amount(expected)}, found {_amount(array)}")
        if not np.isfinite(array).all():
            return self.wrong(headline="expected finite numbers, found NaN or infinity")
        return self._compared(array, expected, given)

    def _compared(self, array, expected, given):
        """The Verdict on finite numbers of the right shape."""
        off = self.differs(array, expected)
        if not off.any():
            return self.right()
        for mistake, place, value in self.mistakes(**given):
            if (
                np.shape(value) == array.shape
                and not self.differs(array, np.asarray(value, dtype=float)).any()
            ):
                return self.wrong(mistake, place=place)
        if np.array_equal(array, np.trunc(expected)) and array.dtype.kind == "i":
            return self.wrong("integer-arrays")
        return self.wrong(headline="these are not the numbers", place=self._place(off))

    def differs(self, array: NDArray, value: NDArray) -> NDArray[np.bool_]:
        """Which entries of an array differ from those of a value, or of a stack of values; whole
        turns apart where they are angles.
        """
        difference = np.asarray(array - value)
        angles = np.isin(np.arange(array.size), self.turns).reshape(array.shape)
        difference = np.where(angles, difference - 360 * np.round(difference / 360), difference)
        return ~(np.abs(difference) <= self.tolerance * (1 + np.abs(value)))

    def _place(self, off):
        if off.ndim == 2:
            i, j = np.argwhere(off)[0] + 1
            return f"{off.sum()} of {off.size} entries, the first in row {i}, column {j}"
        names = self.entries or [f"number {k + 1}" for k in range(off.size)]
        return ", ".join(name for name, bad in zip(names, np.ravel(off)) if bad) if off.ndim else ""


def _plain(answer):
    """The answer as an array of numbers; TypeError or ValueError where it holds anything else."""
    array = np.asarray(answer)
    if array.dtype.kind in "iuf":
        return array
    return array.astype(float, casting="unsafe" if array.dtype.kind == "O" else "safe")


def _amount(array):
    return "one number" if array.ndim == 0 else f"{'×'.join(map(str, array.shape))} numbers"


def as_numbers(answer: Any) -> NDArray[np.float64]:
    """The answer as an array of decimals, whatever its shape; of no numbers, an empty one.

    Examples
    --------
    >>> as_numbers([1, 2]), as_numbers("two")
    (array([1., 2.]), array([], dtype=float64))
    """
    try:
        return np.asarray(answer, dtype=float)
    except (TypeError, ValueError):
        return np.empty(0)


def is_array_of(answer: NDArray[np.float64], value: ArrayLike) -> bool:
    """Whether an array, already of decimals, has the shape and the numbers of a value."""
    return answer.shape == np.shape(value) and np.allclose(answer, value, rtol=1e-3, atol=1e-3)
