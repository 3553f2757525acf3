"""Wrong versions of the link matrix: what a learner's ``dh_transform(theta, d, a, alpha)`` computes
when one thing is wrong; angles are radians.
"""

import numpy as np

from ....transform import rot_x, rot_z, trans_x, trans_z
from ...mistakes.entries import MONOMIALS
from ...mistakes.themes.links import mistyped
from ..search.steps import run_link, slips
from .versions import Versions

__all__ = ["standard", "two_rows", "typical_entries", "WRONG_LINKS"]


def standard(theta, d, a, alpha):
    """The right one: Rz(theta) Tz(d) Tx(a) Rx(alpha)."""
    return rot_z(theta) @ trans_z(d) @ trans_x(a) @ rot_x(alpha)


def _typed(entry, sign, parts):
    return mistyped(entry, next(m for m in MONOMIALS if m.sign == sign and m.parts == parts))


def typical_entries():
    """A few slips of one entry each: a sign lost or too many, cos for sin, 0 for d."""
    return [
        _typed((0, 1), 1, (2, 1, 0)),
        _typed((0, 2), -1, (2, 2, 0)),
        _typed((1, 2), 1, (1, 2, 0)),
        _typed((2, 1), -1, (0, 2, 0)),
        _typed((1, 3), 1, (1, 0, 1)),
        _typed((2, 3), 0, (0, 0, 0)),
    ]


def two_rows():
    """theta, d, a, alpha of two rows at once, between them of both signs and in every quadrant."""
    return tuple(
        np.array([[0.31672, -2.31672], [0.12345, -0.23456], [-0.34567, 0.43219], [2.0456, -0.5123]])
    )


def _made():
    for slip in slips("arguments") + slips("link") + slips("result") + typical_entries():
        yield slip.mistake, slip.place, lambda *row, slip=slip: run_link((slip,), *row)


WRONG_LINKS = Versions(_made, two_rows)
