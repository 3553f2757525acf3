"""Values whose wrong answers may have another shape than the right one."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ..kinds import Value

__all__ = ["ShapedValue", "as_numbers", "is_array_of"]


@dataclass(frozen=True, kw_only=True)
class ShapedValue(Value):
    """A :class:`Value` that also knows wrong answers of another shape: ``misshapen(answer,
    **given)`` gives (mistake, place) or None.
    """

    misshapen: Callable

    def compare(self, answer, variant):
        known = self.misshapen(answer, **self.given(variant))
        return self.wrong(known[0], place=known[1]) if known else super().compare(answer, variant)


def as_numbers(answer):
    """The answer as an array of decimals, whatever its shape; of no numbers, an empty one."""
    try:
        return np.asarray(answer, dtype=float)
    except (TypeError, ValueError):
        return np.empty(0)


def is_array_of(answer, value):
    """Whether an array, already of decimals, has the shape and the numbers of a value."""
    return answer.shape == np.shape(value) and np.allclose(answer, value, rtol=1e-3, atol=1e-3)
