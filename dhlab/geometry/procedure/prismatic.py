"""The line of a sliding joint, of which only the direction counts."""

import numpy as np

from ...arm import Arm
from ...transform import trans
from ..edit import FREE, Edit

__all__ = ["shift_prismatic"]


def shift_prismatic(arm: Arm, k: int, h: float) -> Arm:
    """Move the line of sliding joint k sideways by ``h``, in the one direction that leaves both
    neighbouring frames where they are.

    Only the direction of a sliding axis counts. The frame on it (k-1 standard, k Craig) moves by v;
    that v_y vanishes in both rows leaves one direction, of which ``h`` is the length. (A shift in
    any direction also moves the next frame: :func:`dhlab.assign_frames` with
    another point does that.)

    Parameters
    ----------
    arm : Arm
    k : int
        A prismatic joint, 1 to n.
    h : float
        Metres.

    Returns
    -------
    Arm

    Raises
    ------
    ValueError
        Joint k does not slide.

    Examples
    --------
    >>> import dhlab as dh
    >>> moved = shift_prismatic(dh.load("stanford.rtb_std"), 3, 0.0203)
    >>> moved.table.d.round(4), moved.table.a.round(4)  # d2 was 0.154, a3 was 0.0203
    (array([0.412 , 0.1337, 0.    , 0.    , 0.    , 0.    ]), array([0., 0., 0., 0., 0., 0.]))
    """
    if not (
        isinstance(k, (int, np.integer)) and 1 <= k <= len(arm) and arm.table.joints[k - 1] == "P"
    ):
        raise ValueError(
            f"shift_prismatic: expected the number of a prismatic joint, found {k!r}; the joints of"
            f" this arm are {arm.table.joints}"
        )
    standard = arm.table.convention == "standard"
    edit = Edit(arm, k - 1 if standard else k, "shift_prismatic")
    return _shift_standard(edit, k - 1, h) if standard else _shift_craig(edit, k - 1, h)


def _shift_standard(edit, k, h):
    """Row k slides (0-based); v = (v_x, lam sin(alpha), lam cos(alpha)) in frame k, alpha of the
    row before.
    """
    alpha = edit.alpha[k - 1] if k else 0.0
    s, c, st, ct = np.sin(alpha), np.cos(alpha), np.sin(edit.theta[k]), np.cos(edit.theta[k])
    v_x, lam = h * _direction(s * ct, st) if k else h * np.array([ct, 0.0])
    v = np.array([v_x, lam * s, lam * c]) if k else np.array([v_x, h * st, 0.0])
    if k:
        edit.d[k - 1] += lam
        edit.a[k - 1] += v_x
    edit.d[k] -= v[2]
    edit.a[k] -= v[0] * ct + v[1] * st
    return edit.arm(trans(v))


def _shift_craig(edit, k, h):
    """Row k slides (0-based); v = (w_x cos(theta), -w_x sin(theta), v_z) in frame k+1, alpha of the
    row behind.
    """
    last = k == len(edit.theta) - 1
    alpha = 0.0 if last else edit.alpha[k + 1]
    s, c, st, ct = np.sin(alpha), np.cos(alpha), np.sin(edit.theta[k]), np.cos(edit.theta[k])
    w_x, v_z = np.array([h, 0.0]) if last else h * _direction(s, st * c)
    edit.a[k] += w_x
    edit.d[k] += v_z
    if not last:
        edit.a[k + 1] -= w_x * ct
        edit.d[k + 1] -= w_x * st * s + v_z * c
    return edit.arm(trans([w_x * ct, -w_x * st, v_z]))


def _direction(first, second):
    """The unit vector along (first, second), or along the first when both vanish and the direction
    is free.
    """
    length = np.hypot(first, second)
    return np.array([first, second]) / length if length > FREE else np.array([1.0, 0.0])
