"""Wrong versions of forward kinematics: what a learner's ``forward_kinematics(rows, q)`` computes
when one thing is wrong.

``rows`` is (n, 4): theta offset, d, a, alpha in radians and metres; ``q`` is (n,). Each entry of
:data:`WRONG_PRODUCTS` is ``(mistake, place, function of rows, q)``.
"""

import numpy as np

from ..search.steps import run_chain, slips
from .links import standard, typical_entries
from .versions import Versions

__all__ = ["SAMPLE", "product", "WRONG_PRODUCTS"]

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


STEPS = ("reading", "arguments", "product", "result", "each link", "link")


def _made():
    for slip in [*(slip for step in STEPS for slip in slips(step)), *typical_entries()]:
        yield slip.mistake, slip.place, lambda rows, q, slip=slip: run_chain((slip,), rows, q)


WRONG_PRODUCTS = Versions(_made, lambda: SAMPLE)
