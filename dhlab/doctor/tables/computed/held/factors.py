"""Which matrices a product was multiplied from, in their order."""

from dataclasses import dataclass, field

import numpy as np

from .budget import Unsupported
from .values import Unknown, plain

__all__ = ["Factors", "Multiplied", "is_known_pose", "is_pose"]

MOST_FACTORS = 200
MOST_KEPT = 2_000


class Multiplied(np.ndarray):
    """A matrix for which ``*`` is the product: numpy's matrix, SymPy's Matrix."""


def is_pose(value):
    """Whether a value has four rows of four numbers."""
    if isinstance(value, np.ndarray):
        return value.shape == (4, 4)
    return (
        isinstance(value, list | tuple)
        and len(value) == 4
        and all(isinstance(row, list | tuple | np.ndarray) and len(row) == 4 for row in value)
    )


def is_known_pose(value):
    """Whether a value is known to have four rows of four numbers."""
    return not isinstance(value, Unknown) and is_pose(value)


@dataclass
class Factors:
    """What every 4×4 matrix of a run was multiplied from, by its content; ``products`` are all
    sequences that were multiplied, ``broken`` those with a factor that is not known, and
    ``makers`` the expression that made each matrix.
    """

    known: dict = field(default_factory=dict)
    products: list = field(default_factory=list)
    broken: list = field(default_factory=list)
    makers: dict = field(default_factory=dict)

    def of(self, value):
        """The factors of a matrix: itself, where it is no product; none of the unit matrix.

        Examples
        --------
        >>> factors, A = Factors(), np.diag([1.0, 1, 2, 1])
        >>> _ = factors.product(A, A)
        >>> len(factors.of(A @ A)), len(factors.of(np.eye(4)))
        (2, 0)
        """
        matrix = np.asarray(plain(value)) + 0.0
        if np.array_equal(matrix, np.eye(4)):
            return ()
        return self.known.get(matrix.tobytes(), (matrix,))

    def made(self, value, node):
        """Note which expression made a matrix."""
        if not isinstance(value, Unknown) and is_pose(value):
            try:
                key = (np.asarray(plain(value)) + 0.0).tobytes()
            except Unsupported:
                return
            self.makers.setdefault(key, id(node))

    def product(self, one, other):
        """The product of two matrices, of which the factors are kept."""
        a, b = np.asarray(plain(one)), np.asarray(plain(other))
        result = a @ b
        self.keep(result, (*self.of(a), *self.of(b)))
        return result

    def keep(self, result, factors):
        """Keep what a matrix was multiplied from."""
        if len(factors) > MOST_FACTORS or len(self.known) > MOST_KEPT:
            raise Unsupported("too many factors")
        key = (np.asarray(result) + 0.0).tobytes()
        if len(factors) > 1:
            self.known.setdefault(key, factors)
            self.products.append(factors)

    def seen_as_product(self, result, one, other):
        """Whether a matrix is the product of two others, however made; its factors are kept."""
        a, b, c = (np.asarray(plain(value), dtype=float) for value in (one, other, result))
        if not np.allclose(a @ b, c, rtol=0, atol=1e-12):
            return False
        if (c + 0.0).tobytes() not in self.known:
            self.keep(c, (*self.of(a), *self.of(b)))
        return True

    def spoil(self, *values):
        """Note that matrices were multiplied with something unknown."""
        for value in values:
            if not isinstance(value, Unknown) and is_pose(value):
                self.broken.append(self.of(value))
