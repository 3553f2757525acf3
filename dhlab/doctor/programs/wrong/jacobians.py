"""Wrong versions of the geometric Jacobian: what a learner's function computes when one thing is
wrong.

Each entry of :data:`WRONG_JACOBIANS` is ``(mistake, place, function)``, a function of ``frames``
(n + 1, 4, 4), ``T_end`` (4, 4) and ``sliding`` (n,); metres and radians.
"""

import numpy as np

from .errors import pose_error
from .versions import Versions

__all__ = ["geometric_jacobian", "pose_error", "WRONG_JACOBIANS"]

DEG = 180 / np.pi


def _levers(frames, p_end):
    """From each joint's axis to the end, (n, 3)."""
    return p_end - frames[:-1, :3, 3]


def _axes(frames):
    """The axis of each joint, (n, 3): joint i turns about z of frame i - 1."""
    return frames[:-1, :3, 2]


def _columns(z, lever, sliding):
    """(6, n) from axes and levers (n, 3): a turning joint gives z × lever and z, a sliding one z
    and 0.
    """
    slides = np.asarray(sliding, dtype=bool)[:, None]
    return np.hstack([np.where(slides, z, np.cross(z, lever)), np.where(slides, 0.0, z)]).T


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
    return _columns(_axes(frames), _levers(frames, T_end[:3, 3]), sliding)


def _with(axes=_axes, levers=_levers, columns=_columns):
    """A version with another axis (of the frames), lever (of the frames and the end point) or
    column.
    """
    return lambda frames, T_end, sliding: columns(
        axes(frames), levers(frames, T_end[:3, 3]), sliding
    )


def _after(change):
    """A version whose finished Jacobian is changed: ``change(J, frames, T_end, sliding)``."""
    return lambda frames, T_end, sliding: change(
        geometric_jacobian(frames, T_end, sliding), frames, T_end, np.asarray(sliding, dtype=bool)
    )


def _turned(J, R):
    """Both halves of every column written in the axes of R."""
    return np.vstack([R.T @ J[:3], R.T @ J[3:]])


def _slid(v, omega):
    """The columns of the sliding joints with v and ω made by functions of the axes and the
    levers.
    """

    def columns(z, lever, sliding):
        slides = np.asarray(sliding, dtype=bool)[:, None]
        return np.hstack(
            [np.where(slides, v(z, lever), np.cross(z, lever)), np.where(slides, omega(z), z)]
        ).T

    return columns


def _halved(J, factor):
    J = J.copy()
    J[3:] *= factor
    return J


def _next_axes(frames):
    return frames[1:, :3, 2]


def _next_levers(frames, p_end):
    return p_end - frames[1:, :3, 3]


_ALL = [
    ("jacobian-axis-off-by-one", "axis and origin", _with(_next_axes, _next_levers)),
    ("jacobian-axis-off-by-one", "the axis", _with(axes=_next_axes)),
    ("jacobian-axis-off-by-one", "the origin", _with(levers=_next_levers)),
    (
        "jacobian-axis-off-by-one",
        "the base's axis for every joint",
        _with(axes=lambda frames: 0 * frames[:-1, :3, 2] + frames[0, :3, 2]),
    ),
    (
        "jacobian-axis-off-by-one",
        "axis and origin are those of the joint before, and joint 1 has the last frame's",
        _with(
            lambda frames: np.roll(frames, 1, axis=0)[:-1, :3, 2],
            lambda frames, p: p - np.roll(frames, 1, axis=0)[:-1, :3, 3],
        ),
    ),
    ("cross-product-reversed", "", _with(levers=lambda frames, p: -_levers(frames, p))),
    (
        "lever-arm-wrong",
        "p of the end alone, o was not taken off",
        _with(levers=lambda frames, p: 0 * frames[:-1, :3, 3] + p),
    ),
    (
        "lever-arm-wrong",
        "o alone, the end does not enter",
        _with(levers=lambda frames, p: frames[:-1, :3, 3]),
    ),
    (
        "lever-arm-wrong",
        "o × z: the velocity of a point at the base's origin",
        _with(levers=lambda frames, p: -frames[:-1, :3, 3]),
    ),
    (
        "lever-arm-wrong",
        "to the next origin, not to the end",
        _with(levers=lambda frames, p: frames[1:, :3, 3] - frames[:-1, :3, 3]),
    ),
    (
        "lever-arm-wrong",
        "from the base's origin for every joint",
        _with(levers=lambda frames, p: 0 * frames[:-1, :3, 3] + p - frames[0, :3, 3]),
    ),
    ("lever-arm-wrong", "the sum p + o", _with(levers=lambda frames, p: p + frames[:-1, :3, 3])),
    (
        "wrong-frame-compared",
        "T_end was multiplied onto the last frame; it is the end in the base already",
        lambda frames, T_end, sliding: geometric_jacobian(frames, frames[-1] @ T_end, sliding),
    ),
    (
        "tool-missing",
        "the last frame's origin was taken for the end",
        _with(levers=lambda frames, p: _levers(frames, frames[-1, :3, 3])),
    ),
    (
        "elementwise-product",
        "z * (p − o), entry by entry, where np.cross(z, p − o) belongs",
        lambda frames, T_end, sliding: np.vstack(
            [
                np.where(
                    sliding, _axes(frames).T, (_axes(frames) * _levers(frames, T_end[:3, 3])).T
                ),
                np.where(sliding, 0.0, _axes(frames).T),
            ]
        ),
    ),
    ("jacobian-rows-exchanged", "", _after(lambda J, *rest: np.vstack([J[3:], J[:3]]))),
    (
        "jacobian-rows-exchanged",
        "in the turning columns",
        _after(lambda J, frames, T_end, sliding: np.where(sliding, J, np.vstack([J[3:], J[:3]]))),
    ),
    (
        "prismatic-column-wrong",
        "sliding joints are treated as turning ones",
        _with(columns=lambda z, lever, sliding: _columns(z, lever, np.zeros_like(sliding))),
    ),
    (
        "prismatic-column-wrong",
        "turning joints are treated as sliding ones too",
        _with(columns=lambda z, lever, sliding: _columns(z, lever, np.ones_like(sliding))),
    ),
    (
        "joint-index-off-by-one",
        "sliding is asked of the joint before",
        lambda frames, T_end, sliding: geometric_jacobian(frames, T_end, np.roll(sliding, 1)),
    ),
    (
        "joint-index-off-by-one",
        "sliding is asked of the joint before, and joint 1 never slides",
        lambda frames, T_end, sliding: geometric_jacobian(
            frames, T_end, [False, *np.asarray(sliding, dtype=bool)[:-1]]
        ),
    ),
    (
        "prismatic-column-wrong",
        "turning and sliding have changed places",
        _with(columns=lambda z, lever, sliding: _columns(z, lever, np.logical_not(sliding))),
    ),
    (
        "prismatic-column-wrong",
        "ω should be 0: a slide turns nothing",
        _with(columns=_slid(lambda z, lever: z, lambda z: z)),
    ),
    (
        "prismatic-column-wrong",
        "v should be z, not −z",
        _with(columns=_slid(lambda z, lever: -z, lambda z: 0 * z)),
    ),
    (
        "prismatic-column-wrong",
        "v should be the joint's own z: the z of the next frame stands there",
        lambda frames, T_end, sliding: np.where(
            sliding,
            np.vstack([_next_axes(frames).T, 0 * _next_axes(frames).T]),
            geometric_jacobian(frames, T_end, sliding),
        ),
    ),
    (
        "prismatic-column-wrong",
        "v should be z as the base sees it: (0, 0, 1) is z in its own frame",
        _with(columns=_slid(lambda z, lever: 0 * z + [0.0, 0.0, 1.0], lambda z: 0 * z)),
    ),
    (
        "prismatic-column-wrong",
        "v and ω have changed places",
        _with(columns=_slid(lambda z, lever: 0 * z, lambda z: z)),
    ),
    (
        "prismatic-column-wrong",
        "v should be z: a slide has no lever",
        _with(columns=_slid(np.cross, lambda z: 0 * z)),
    ),
    (
        "prismatic-column-wrong",
        "the column is empty",
        _with(columns=_slid(lambda z, lever: 0 * z, lambda z: 0 * z)),
    ),
    (
        "prismatic-column-wrong",
        "the lever stands where the direction z belongs",
        _with(columns=_slid(lambda z, lever: lever, lambda z: 0 * z)),
    ),
    (
        "jacobian-frame",
        "written in the tool's axes",
        _after(lambda J, frames, T_end, sliding: _turned(J, T_end[:3, :3])),
    ),
    (
        "jacobian-frame",
        "written in frame {0}, without the base",
        _after(lambda J, frames, T_end, sliding: _turned(J, frames[0, :3, :3])),
    ),
    (
        "jacobian-frame",
        "written in the last frame's axes",
        _after(lambda J, frames, T_end, sliding: _turned(J, frames[-1, :3, :3])),
    ),
    (
        "jacobian-frame",
        "the axis left in its own frame: always 0 0 1",
        _with(axes=lambda frames: 0 * frames[:-1, :3, 2] + [0.0, 0.0, 1.0]),
    ),
    (
        "rotation-transposed",
        "a row was taken for the axis",
        _with(axes=lambda frames: frames[:-1, 2, :3]),
    ),
    (
        "rotation-block-misread",
        "the x arrow was taken for the joint's axis",
        _with(axes=lambda frames: frames[:-1, :3, 0]),
    ),
    (
        "rotation-block-misread",
        "the y arrow was taken for the joint's axis",
        _with(axes=lambda frames: frames[:-1, :3, 1]),
    ),
    (
        "rotation-block-misread",
        "the origin was taken for the axis",
        _with(axes=lambda frames: frames[:-1, :3, 3]),
    ),
    ("angular-part-missing", "", _after(lambda J, *rest: _halved(J, 0.0))),
    ("joint-reversed", "every number has the other sign", _after(lambda J, *rest: -J)),
    ("error-sign", "ω has the other sign", _after(lambda J, *rest: _halved(J, -1.0))),
    (
        "degrees-for-radians",
        "per degree where per radian was asked",
        _after(lambda J, *rest: J / DEG),
    ),
    ("degrees-for-radians", "ω in degrees", _after(lambda J, *rest: _halved(J, DEG))),
    ("degrees-for-radians", "all numbers in degrees", _after(lambda J, *rest: J * DEG)),
    (
        "columns-misread",
        "reshape(6, n) does not turn a list of columns round: .T does",
        _after(lambda J, *rest: J.T.reshape(J.shape)),
    ),
    (
        "joint-index-off-by-one",
        "the columns come in reverse order",
        _after(lambda J, *rest: J[:, ::-1]),
    ),
    ("integer-arrays", "", _after(lambda J, *rest: np.trunc(J))),
]


TOOL = "the last frame's origin was taken for the end"


def _made():
    """Each by itself, and then each on top of the last frame's origin taken for the end."""
    yield from _ALL
    for mistake, place, version in _ALL:
        if mistake == "tool-missing":
            continue
        yield (
            mistake,
            "; ".join(filter(None, (place, f"and {TOOL}"))),
            lambda frames, T_end, sliding, f=version: f(frames, _at_flange(frames, T_end), sliding),
        )


def _at_flange(frames, T_end):
    T = T_end.copy()
    T[:3, 3] = frames[-1, :3, 3]
    return T


def _sample():
    from scipy.spatial.transform import Rotation

    rng = np.random.default_rng(8)
    frames = np.tile(np.eye(4), (6, 1, 1))
    frames[:, :3, :3], frames[:, :3, 3] = (
        Rotation.random(6, random_state=8).as_matrix(),
        rng.uniform(0.2, 0.9, (6, 3)),
    )
    T_end = frames[-1].copy()
    T_end[:3, 3] += [0.1, 0.2, 0.3]
    T_end[:3, :3] = Rotation.random(random_state=9).as_matrix()
    return frames, T_end, np.array([False, False, True, False, True])


WRONG_JACOBIANS = Versions(_made, _sample)
