"""What the interpreter of strangers' programs may use, and how it says that it stops."""

from contextlib import contextmanager
from dataclasses import dataclass

import numpy as np

__all__ = ["FAILURES", "Budget", "Raised", "Stopped", "Unsupported"]

MOST_STEPS = 80_000  # nodes of the program, in all its runs
DEEPEST = 90  # expressions and calls within each other
MOST_ITEMS = 4_096  # of a list, an array, a text
LARGEST = 1e15  # a number


class Unsupported(Exception):
    """A statement that is not understood: what it would have changed is not known."""


class Raised(Exception):
    """The program raises an error of its own."""


class Stopped(Exception):
    """The budget is used up."""


FAILURES = (
    Unsupported, TypeError, ValueError, LookupError, AttributeError, ArithmeticError, NameError,
    RecursionError, MemoryError,
)  # fmt: skip


@dataclass
class Budget:
    """Steps that are left, and the depth that is reached.

    Examples
    --------
    >>> budget = Budget(steps=9)
    >>> budget.step(2)
    >>> budget.steps
    7
    """

    steps: int = MOST_STEPS
    depth: int = 0
    least: int = 0

    def step(self, n=1):
        """Count steps."""
        self.steps -= n
        if self.steps < self.least:
            raise Stopped

    @contextmanager
    def at_most(self, n):
        """A part of the program, of which more steps than these are a failure of this part."""
        before, depth = self.least, self.depth
        self.least = max(before, self.steps - n)
        try:
            yield
        except Stopped:
            self.depth = depth
            if self.steps < before:
                raise
            raise Unsupported("too long") from None
        finally:
            self.least = before

    def __enter__(self):
        self.depth += 1
        if self.depth > DEEPEST:
            self.depth -= 1
            raise Unsupported("too deep")

    def __exit__(self, *_):
        self.depth -= 1

    def checked(self, value):
        """A value that is small enough to go on with."""
        if isinstance(value, bool | np.bool_) or value is None:
            return value
        if isinstance(value, int | float | np.number):
            if not abs(value) <= LARGEST:
                raise Unsupported("a number that is too large, or none")
            return value
        if isinstance(value, np.ndarray):
            if value.size > MOST_ITEMS or value.dtype.kind not in "fib":
                raise Unsupported("an array of another kind")
            self.step(value.size // 16)
        elif isinstance(value, str | list | tuple | dict):
            if len(value) > MOST_ITEMS:
                raise Unsupported("too many items")
            self.step(len(value) // 16)
        return value
