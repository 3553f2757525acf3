"""Wrong versions of forward kinematics: what a learner's ``forward_kinematics(rows, q)`` computes
when one thing is wrong.

``rows`` is (n, 4): theta offset, d, a, alpha in radians and metres; ``q`` is (n,). Each entry of
:data:`WRONG_PRODUCTS` is ``(mistake, place, function of rows, q)``.
"""

import numpy as np

from ..stages import ARGUMENTS, EACH_LINK, LINK, PRODUCT, READING, RESULT, run_chain
from .links import TYPICAL_ENTRIES, distinct, standard

__all__ = ["product", "WRONG_PRODUCTS"]

SAMPLE = (
    np.array(
        [
            [0.4, -0.2, 0.5, 0.9],
            [-0.7, 0.3, -0.4, 1.1],
            [0.5, 0.25, 0.35, -0.8],
            [1.2, 0.1, 0.6, 0.3],
        ]
    ),
    np.array([0.9, -0.6, 0.3, 1.3]),
)


def product(rows, q, link=standard):
    """A_1 … A_n with theta = offset + q."""
    T = np.eye(4)
    for (offset, d, a, alpha), q_i in zip(rows, q):
        T = T @ link(offset + q_i, d, a, alpha)
    return T


def _with(slip):
    return lambda rows, q: run_chain((slip,), rows, q)


SLIPS = READING + ARGUMENTS + PRODUCT + RESULT + EACH_LINK + LINK + TYPICAL_ENTRIES
WRONG_PRODUCTS = distinct([(slip.mistake, slip.place, _with(slip)) for slip in SLIPS], *SAMPLE)
