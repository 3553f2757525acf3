"""Wrong versions of Craig's link matrix: what a learner's function of theta, d, a, alpha computes
when one thing is wrong.
"""

from ....transform import rot_x, rot_z, trans_x, trans_z
from ...mistakes.links import MOVES, in_order
from ..steps import slips
from .links import two_rows
from .versions import Versions

__all__ = ["craig", "in_order", "MOVES", "WRONG_CRAIG"]


def craig(theta, d, a, alpha):
    """The right one: Rx(alpha) Tx(a) Rz(theta) Tz(d). Craig, Introduction to Robotics, eq. 3.6.

    Examples
    --------
    >>> craig(0.0, 0.1, 0.4, 0.0)[:3, 3]
    array([0.4, 0. , 0.1])
    """
    return rot_x(alpha) @ trans_x(a) @ rot_z(theta) @ trans_z(d)


def _made():
    for slip in slips("craig link"):
        yield slip.mistake, slip.place, slip.change
    for slip in slips("arguments"):
        yield slip.mistake, slip.place, lambda *row, slip=slip: craig(*slip.change(*row))
    for slip in slips("result"):
        yield slip.mistake, slip.place, lambda *row, slip=slip: slip.change(craig(*row))


WRONG_CRAIG = Versions(_made, two_rows, craig)
