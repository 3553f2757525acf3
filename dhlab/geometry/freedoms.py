"""What a DH table leaves free: every way to write the same arm in another table. Put G G⁻¹ between
two rows; each move is one G.

Frames are numbered 0 … n. Between two rows (frame i = 1 … n-1) rows i and i+1 change; at the ends
the base (i = 0) or the tool (i = n) takes the other half, so that the pose never changes. The
formulas follow from the link matrices alone; every one is verified against poses in
``tests/test_conversion.py``.
"""

import numpy as np

from ..arm import Arm
from ..table import DHTable
from ..transform import inverse, rot_x, rot_z, trans

__all__ = ["flip_x", "flip_z", "slide", "twist", "move_base", "move_tool", "shift_prismatic"]

# |sin alpha| (and |a| in m) below this leave the slide (and the twist) free: what it costs is below
# the rounding of a pose
FREE = 1e-12
HALF_X, HALF_Z = (
    np.diag([1.0, -1, -1, 1]),
    np.diag([-1.0, -1, 1, 1]),
)  # half turns without the rounding of sin(pi)


def flip_x(arm, i):
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
    edit = _Edit(arm, i, "flip_x")
    edit.theta[edit.rows] = [half_turn(edit.theta[k]) for k in edit.rows]
    edit.normal(-1.0, lambda alpha: -alpha)
    return edit.arm(HALF_Z)


def flip_z(arm, i):
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
    edit = _Edit(arm, i, "flip_z")
    k = i if edit.standard else i - 1  # the row whose joint turns about z_i
    edit.alpha[edit.rows] = [half_turn(edit.alpha[row]) for row in edit.rows]
    if 0 <= k < len(arm):
        edit.theta[k], edit.d[k], edit.sign[k] = -edit.theta[k], -edit.d[k], -edit.sign[k]
    return edit.arm(HALF_X)


def slide(arm, i, h):
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
    edit = _Edit(arm, i, "slide")
    c = edit.free_cosine(f"cannot move along z{i}", f"o{i}")
    edit.add(edit.d, h, c)
    return edit.arm(trans([0, 0, h]))


def twist(arm, i, phi):
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
    edit = _Edit(arm, i, "twist")
    c = edit.free_cosine(f"cannot turn about z{i}", f"x{i}", lengths_too=True)
    edit.add(edit.theta, phi, c)
    return edit.arm(rot_z(phi))


def move_base(arm, turn=0.0, shift=0.0):
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
    edit = _Edit(arm, 0, "move_base")
    if edit.standard:
        edit.theta[0], edit.d[0] = edit.theta[0] - turn, edit.d[0] - shift
        return edit.arm(trans([0, 0, shift]) @ rot_z(turn))
    edit.alpha[0], edit.a[0] = edit.alpha[0] - turn, edit.a[0] - shift
    return edit.arm(trans([shift, 0, 0]) @ rot_x(turn))


def move_tool(arm, turn=0.0, shift=0.0):
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
    edit = _Edit(arm, len(arm), "move_tool")
    if edit.standard:
        edit.alpha[-1], edit.a[-1] = edit.alpha[-1] + turn, edit.a[-1] + shift
        return edit.arm(trans([shift, 0, 0]) @ rot_x(turn))
    edit.theta[-1], edit.d[-1] = edit.theta[-1] + turn, edit.d[-1] + shift
    return edit.arm(trans([0, 0, shift]) @ rot_z(turn))


def shift_prismatic(arm, k, h):
    """Move the line of sliding joint k sideways by ``h``, in the one direction that leaves both
    neighbouring frames where they are.

    Only the direction of a sliding axis counts. The frame on it (k-1 standard, k Craig) moves by v;
    that v_y vanishes in both rows leaves one direction, of which ``h`` is the length. (A shift in
    any direction also moves the next frame: :func:`dhlab.geometry.frames.assign_frames` with
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
    edit = _Edit(arm, k - 1 if standard else k, "shift_prismatic")
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


def half_turn(angle):
    """``angle`` and 180° more or less, whichever is nearer to 0: two half turns give the number
    back.

    Examples
    --------
    >>> float(half_turn(0.0)) == np.pi, float(half_turn(np.pi))
    (True, 0.0)
    """
    return angle - np.pi if angle > 0 else angle + np.pi


class _Edit:
    """The columns of an arm opened for one move at frame i; :meth:`arm` closes it, giving G to the
    base or the tool at the ends.
    """

    def __init__(self, arm, i, verb):
        n = len(arm)
        if (
            isinstance(i, (bool, np.bool_))
            or not isinstance(i, (int, np.integer))
            or not 0 <= i <= n
        ):
            raise ValueError(
                f"{verb}: expected a frame from 0 to {n}, found {i!r}; frames 1 to {n - 1} stand"
                " between two rows"
            )
        self.of, self.i, self.verb = arm, int(i), verb
        self.standard = arm.table.convention == "standard"
        self.theta, self.d, self.a, self.alpha = (np.array(column) for column in arm.table.rows.T)
        self.sign = np.array(arm.sign)
        self.rows = [k for k in (i - 1, i) if 0 <= k < n]  # 0-based: row i, then row i + 1

    @property
    def normal_row(self):
        """The 0-based row of a_i and alpha_i, or None where the table has no such entry."""
        k = self.i - 1 if self.standard else self.i
        return k if 0 <= k < len(self.theta) else None

    def normal(self, times, turn):
        k = self.normal_row
        if k is not None:
            self.a[k], self.alpha[k] = times * self.a[k], turn(self.alpha[k])

    def free_cosine(self, cannot, fixed, lengths_too=False):
        """cos(alpha_i), which is ±1; a sentence when frame i has no such freedom."""
        k = self.normal_row
        if k is None:
            return 1.0
        if abs(np.sin(self.alpha[k])) > FREE:
            angle = np.rad2deg(self.alpha[k])
            raise ValueError(
                f"{self.verb}: frame {self.i} {cannot}, since alpha{self.i} = {angle:.6g}° is"
                f" neither 0° nor 180°: the axes there are not parallel, so {fixed} stays where"
                " it is"
            )
        if lengths_too and abs(self.a[k]) > FREE:
            raise ValueError(
                f"{self.verb}: frame {self.i} {cannot}, since a{self.i} = {self.a[k]:.6g} m is not"
                f" 0: the axes there do not coincide, so {fixed} stays as it is"
            )
        return np.sign(np.cos(self.alpha[k]))

    def add(self, column, amount, cosine):
        """``amount`` in frame i: into row i and out of row i + 1, one of them seen through
        alpha_i.
        """
        before, behind = (cosine, 1.0) if self.standard else (1.0, cosine)
        if self.i > 0:
            column[self.i - 1] += amount * before
        if self.i < len(column):
            column[self.i] -= amount * behind

    def arm(self, G):
        arm, t = self.of, self.of.table
        table = DHTable(t.convention, self.theta, self.d, self.a, self.alpha, t.joints)
        base = arm.base @ G if self.i == 0 else arm.base
        tool = inverse(G) @ arm.tool if self.i == len(arm) else arm.tool
        return Arm(
            table,
            base=base,
            tool=tool,
            limits=arm.limits,
            sign=self.sign,
            name=arm.name,
            source=arm.source,
        )
