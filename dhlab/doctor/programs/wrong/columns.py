"""What a geometric Jacobian is made of, and how a version of it is made with another part."""

from functools import partial

import numpy as np

__all__ = [
    "after",
    "axes",
    "columns",
    "geometric_jacobian",
    "halved",
    "levers",
    "next_axes",
    "next_levers",
    "slid",
    "turned",
    "with_other",
]


NEXT, LAST = [1, 2, 0], [2, 0, 1]


def levers(frames, p_end):
    """From each joint's axis to the end, (n, 3)."""
    return p_end - frames[:-1, :3, 3]


def axes(frames):
    """The axis of each joint, (n, 3): joint i turns about z of frame i - 1."""
    return frames[:-1, :3, 2]


def columns(z, lever, sliding, v=lambda z, lever: z, omega=lambda z: 0 * z):
    """(6, n) from axes and levers (n, 3): a turning joint gives z × lever and z, a sliding one z
    and 0, or what ``v`` and ``omega`` make of them.
    """
    slides = np.asarray(sliding, dtype=bool)[:, None]
    return np.hstack(
        [np.where(slides, v(z, lever), _crossed(z, lever)), np.where(slides, omega(z), z)]
    ).T


def _crossed(a, b):
    """a × b, both (n, 3), as ``np.cross`` multiplies, which takes longer to look at their shapes: a
    solver takes some hundred steps a task, and there are a hundred wrong ones.
    """
    return a[:, NEXT] * b[:, LAST] - a[:, LAST] * b[:, NEXT]


def geometric_jacobian(frames, T_end, sliding):
    """The right one: rows v then ω of the end, in the frame in which the frames are given
    (Siciliano et al., Robotics, eq. 3.30).

    Examples
    --------
    >>> import dhlab as dh
    >>> arm, q = dh.load("stanford"), [0.3, -0.4, 0.5, 0.6, -0.7, 0.8]
    >>> J = geometric_jacobian(arm.frames(q), arm.forward(q), arm.table.prismatic)
    >>> bool(np.allclose(J, arm.jacobian(q)))
    True
    """
    return columns(axes(frames), levers(frames, T_end[:3, 3]), sliding)


def with_other(axes=axes, levers=levers, columns=columns):
    """A version with another axis (of the frames), lever (of the frames and the end point) or
    column.
    """
    return lambda frames, T_end, sliding: columns(
        axes(frames), levers(frames, T_end[:3, 3]), sliding
    )


def after(change):
    """A version whose finished Jacobian is changed: ``change(J, frames, T_end, sliding)``."""
    return lambda frames, T_end, sliding: change(
        geometric_jacobian(frames, T_end, sliding), frames, T_end, np.asarray(sliding, dtype=bool)
    )


def turned(J, R):
    """Both halves of every column written in the axes of R."""
    return np.vstack([R.T @ J[:3], R.T @ J[3:]])


def slid(v, omega):
    """The columns of the sliding joints with v and ω made by functions of the axes and the
    levers.
    """
    return partial(columns, v=v, omega=omega)


def halved(J, factor):
    J = J.copy()
    J[3:] *= factor
    return J


def next_axes(frames):
    return frames[1:, :3, 2]


def next_levers(frames, p_end):
    return p_end - frames[1:, :3, 3]
