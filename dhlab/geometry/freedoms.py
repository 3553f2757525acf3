"""What a DH table leaves free: every way to write the same arm in another table. Put G G⁻¹ between
two rows; each move is one G.

Frames are numbered 0 … n. Between two rows (frame i = 1 … n-1) rows i and i+1 change; at the ends
the base (i = 0) or the tool (i = n) takes the other half, so that the pose never changes. The
formulas follow from the link matrices alone; every one is verified against poses in
``tests/geometry/test_conversion.py``.
"""

import numpy as np

from ..arm import Arm
from ..transform import rot_x, rot_z, trans
from .edit import Edit, half_turn

__all__ = ["flip_x", "flip_z", "slide", "twist", "move_base", "move_tool"]

# half turns without the rounding of sin(pi)
HALF_X, HALF_Z = np.diag([1.0, -1, -1, 1]), np.diag([-1.0, -1, 1, 1])


def flip_x(arm: Arm, i: int) -> Arm:
    """Turn x_i round: a half turn of frame i about z_i.

    Parameters
    ----------
    arm : Arm
    i : int
        The frame, 0 to n.

    Returns
    -------
    Arm
        Standard: theta_i + 180°, -a_i, -alpha_i, theta_{i+1} - 180°. Craig: theta_i + 180°, -a_i,
        -alpha_i, theta_{i+1} - 180°, where a_i and alpha_i stand in row i+1.

    Raises
    ------
    ValueError
        There is no such frame.

    Examples
    --------
    >>> import dhlab as dh
    >>> print(flip_x(dh.load("article-6r"), 2).table)
    standard DH, 6 joints (lengths in m, angles in deg)
     i   theta     d    a     alpha
     1   q1        0.1  0     90
     2   q2 + 180  0    -0.4  0
     3   q3 + 180  0    0.35  0
     4   q4        0.1  0     90
     5   q5        0    0     -90
     6   q6        0.1  0     0
    """
    edit = Edit(arm, i, "flip_x")
    edit.theta[edit.rows] = [half_turn(edit.theta[k]) for k in edit.rows]
    edit.normal(-1.0, lambda alpha: -alpha)
    return edit.arm(HALF_Z)


def flip_z(arm: Arm, i: int) -> Arm:
    """Turn z_i round: a half turn of frame i about x_i. The joint on z_i then counts the other way,
    so its sign changes.

    Parameters
    ----------
    arm : Arm
    i : int
        The frame, 0 to n. z_i is the axis of joint i+1 (standard) or i (Craig).

    Returns
    -------
    Arm
        Standard: alpha_i + 180°; -theta_{i+1}, -d_{i+1}, the sign of joint i+1, alpha_{i+1} - 180°.
        Craig: alpha_{i-1} + 180°, -theta_i, -d_i and the sign of joint i; alpha_i - 180°.

    Raises
    ------
    ValueError
        There is no such frame.

    Examples
    --------
    >>> import dhlab as dh
    >>> flipped = flip_z(dh.load("article-6r"), 3)
    >>> flipped.sign
    array([ 1.,  1.,  1., -1.,  1.,  1.])
    >>> np.rad2deg(flipped.table.alpha), flipped.table.d
    (array([ 90.,   0., 180., -90., -90.,   0.]), array([ 0.1,  0. ,  0. , -0.1,  0. ,  0.1]))
    """
    edit = Edit(arm, i, "flip_z")
    k = i if edit.standard else i - 1  # the row whose joint turns about z_i
    edit.alpha[edit.rows] = [half_turn(edit.alpha[row]) for row in edit.rows]
    if 0 <= k < len(arm):
        edit.turn_joint(k)
    return edit.arm(HALF_X)


def slide(arm: Arm, i: int, h: float) -> Arm:
    """Move the origin o_i by ``h`` along z_i; possible where the axes on both sides are parallel,
    so that the common normal is free.

    Parameters
    ----------
    arm : Arm
    i : int
        The frame, 0 to n.
    h : float
        Metres.

    Returns
    -------
    Arm
        Standard: d_i + h cos(alpha_i), d_{i+1} - h. Craig: d_i + h, d_{i+1} - h cos(alpha_i).

    Raises
    ------
    ValueError
        The axes are not parallel, or there is no such frame.

    Examples
    --------
    >>> import dhlab as dh
    >>> slide(dh.load("ur5e"), 2, 0.1).table.d.round(4)
    array([ 0.1625,  0.1   , -0.1   ,  0.1333,  0.0997,  0.0996])
    >>> slide(dh.load("ur5e"), 1, 0.1)  # doctest: +ELLIPSIS
    Traceback (most recent call last):
    ...
    ValueError: slide: frame 1 cannot move along z1, since alpha1 = 90° is neither 0° nor 180°: ...
    """
    edit = Edit(arm, i, "slide")
    c = edit.free_cosine(f"cannot move along z{i}", f"o{i}")
    edit.add(edit.d, h, c)
    return edit.arm(trans([0, 0, h]))


def twist(arm: Arm, i: int, phi: float) -> Arm:
    """Turn x_i by ``phi`` about z_i; possible where the axes on both sides are one line.

    Parameters
    ----------
    arm : Arm
    i : int
        The frame, 0 to n.
    phi : float
        Radians.

    Returns
    -------
    Arm
        Standard: theta_i + phi cos(alpha_i), theta_{i+1} - phi. Craig: theta_i + phi, theta_{i+1} -
        phi cos(alpha_i).

    Raises
    ------
    ValueError
        The axes do not coincide, or there is no such frame.

    Examples
    --------
    >>> from dhlab import Arm, DHTable
    >>> arm = Arm(DHTable.standard([[0, 1, 0, 0], [0, 0, 1, 0]], angle="deg"))
    >>> np.rad2deg(twist(arm, 1, np.pi / 6).table.theta).round(6)
    array([ 30., -30.])
    """
    edit = Edit(arm, i, "twist")
    c = edit.free_cosine(f"cannot turn about z{i}", f"x{i}", lengths_too=True)
    edit.add(edit.theta, phi, c)
    return edit.arm(rot_z(phi))


def move_base(arm: Arm, turn: float = 0.0, shift: float = 0.0) -> Arm:
    """Put frame 0 elsewhere, as far as the convention allows; ``arm.base`` takes it up.

    Parameters
    ----------
    arm : Arm
    turn, shift : float
        Radians and metres: about and along z_0 (standard: theta_1 and d_1 change), about and along
        x_0 (Craig: alpha_0, a_0).

    Returns
    -------
    Arm

    Examples
    --------
    >>> import dhlab as dh
    >>> move_base(dh.load("article-6r"), shift=0.1).table.d[0]
    np.float64(0.0)
    """
    edit = Edit(arm, 0, "move_base")
    if edit.standard:
        edit.theta[0], edit.d[0] = edit.theta[0] - turn, edit.d[0] - shift
        return edit.arm(trans([0, 0, shift]) @ rot_z(turn))
    edit.alpha[0], edit.a[0] = edit.alpha[0] - turn, edit.a[0] - shift
    return edit.arm(trans([shift, 0, 0]) @ rot_x(turn))


def move_tool(arm: Arm, turn: float = 0.0, shift: float = 0.0) -> Arm:
    """Put frame n elsewhere, as far as the convention allows; ``arm.tool`` takes it up.

    Parameters
    ----------
    arm : Arm
    turn, shift : float
        Radians and metres: about and along x_n (standard: alpha_n, a_n), about and along z_n
        (Craig: theta_n and d_n).

    Returns
    -------
    Arm

    Examples
    --------
    >>> import dhlab as dh
    >>> move_tool(dh.load("article-6r"), shift=0.1).table.a[-1]
    np.float64(0.1)
    """
    edit = Edit(arm, len(arm), "move_tool")
    if edit.standard:
        edit.alpha[-1], edit.a[-1] = edit.alpha[-1] + turn, edit.a[-1] + shift
        return edit.arm(trans([shift, 0, 0]) @ rot_x(turn))
    edit.theta[-1], edit.d[-1] = edit.theta[-1] + turn, edit.d[-1] + shift
    return edit.arm(trans([0, 0, shift]) @ rot_z(turn))
