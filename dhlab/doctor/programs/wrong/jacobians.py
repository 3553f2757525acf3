"""Wrong versions of the geometric Jacobian and of the pose error: what a learner's function
computes when one thing is wrong.

Each entry of the lists is ``(mistake, place, function)``. :data:`WRONG_JACOBIANS` holds functions
of ``frames`` (n + 1, 4, 4), ``T_end`` (4, 4) and ``sliding`` (n,); :data:`WRONG_ERRORS` functions
of ``T`` and ``T_goal`` (4, 4); metres and radians.
"""

import numpy as np
from scipy.spatial.transform import Rotation

from ..stages import truncated
from .links import distinct

__all__ = ["geometric_jacobian", "pose_error", "WRONG_JACOBIANS", "WRONG_ERRORS"]

DEG = 180 / np.pi


# ---- the Jacobian


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
        "tool-missing",
        "the last frame's origin was taken for the end",
        _with(levers=lambda frames, p: _levers(frames, frames[-1, :3, 3])),
    ),
    (
        "elementwise-product",
        "z * (p − o) where z × (p − o) belongs",
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
        "v and ω have changed places",
        _with(columns=_slid(lambda z, lever: 0 * z, lambda z: z)),
    ),
    (
        "prismatic-column-wrong",
        "ω should be 0: a slide turns nothing",
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
    ("joint-reversed", "every column", _after(lambda J, *rest: -J)),
    ("error-sign", "ω has the other sign", _after(lambda J, *rest: _halved(J, -1.0))),
    (
        "degrees-for-radians",
        "per degree where per radian was asked",
        _after(lambda J, *rest: J / DEG),
    ),
    ("degrees-for-radians", "ω in degrees", _after(lambda J, *rest: _halved(J, DEG))),
    (
        "joint-index-off-by-one",
        "the columns come in reverse order",
        _after(lambda J, *rest: J[:, ::-1]),
    ),
    ("integer-arrays", "", _after(lambda J, *rest: truncated(J))),
]


def _sample():
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


WRONG_JACOBIANS = distinct(_ALL, *_sample())


# ---- the pose error


def pose_error(T, T_goal):
    """The right one: p_goal − p, then the rotation vector of R_goal Rᵀ; both in the base's axes.

    Examples
    --------
    >>> from dhlab.transform import rot_z
    >>> pose_error(np.eye(4), rot_z(0.3)).round(6)
    array([0. , 0. , 0. , 0. , 0. , 0.3])
    """
    return _error(T, T_goal)


def _vector(R):
    return Rotation.from_matrix(R).as_rotvec()


def _error(
    T,
    T_goal,
    way=lambda R, R_goal, p, p_goal: p_goal - p,
    turn=lambda R, R_goal: _vector(R_goal @ R.T),
):
    R, R_goal = T[:3, :3], T_goal[:3, :3]
    return np.concatenate([way(R, R_goal, T[:3, 3], T_goal[:3, 3]), turn(R, R_goal)])


def _made(**parts):
    return lambda T, T_goal: _error(T, T_goal, **parts)


def _changed(change):
    return lambda T, T_goal: change(_error(T, T_goal))


def _skew(A):
    """The vector in the antisymmetric part of a 3×3 block."""
    return np.array([A[2, 1] - A[1, 2], A[0, 2] - A[2, 0], A[1, 0] - A[0, 1]]) / 2


def _quaternion(R):
    """Its vector part, with w positive."""
    x, y, z, w = Rotation.from_matrix(R).as_quat()
    return np.array([x, y, z]) * (1 if w >= 0 else -1)


def _angles(order):
    return lambda R, R_goal: (
        Rotation.from_matrix(R_goal).as_euler(order) - Rotation.from_matrix(R).as_euler(order)
    )


def _angles_of_the_turn(R, R_goal):
    return Rotation.from_matrix(R_goal @ R.T).as_euler("xyz")


def _backwards(way, turn):
    return lambda e: np.concatenate([way * e[:3], turn * e[3:]])


_TOOL_TURN = {"turn": lambda R, R_goal: _vector(R.T @ R_goal)}
_TOOL_WAY = {"way": lambda R, R_goal, p, p_goal: R.T @ (p_goal - p)}

WRONG_ERRORS = distinct(
    [
        ("error-sign", "all six: the way back from the goal", _changed(_backwards(-1, -1))),
        ("error-sign", "the position", _changed(_backwards(-1, 1))),
        ("error-sign", "the orientation", _changed(_backwards(1, -1))),
        ("orientation-error-frame", "the orientation is in the tool's axes", _made(**_TOOL_TURN)),
        (
            "orientation-error-frame",
            "the orientation is R_goalᵀ R, the way back in the goal's axes",
            _made(turn=lambda R, R_goal: _vector(R_goal.T @ R)),
        ),
        ("orientation-error-frame", "the position is in the tool's axes", _made(**_TOOL_WAY)),
        (
            "orientation-error-frame",
            "both are in the tool's axes",
            _made(**_TOOL_WAY, **_TOOL_TURN),
        ),
        (
            "orientation-error-frame",
            "the position is in the goal's axes",
            _made(way=lambda R, R_goal, p, p_goal: R_goal.T @ (p_goal - p)),
        ),
        (
            "pose-inverted",
            "a transpose is missing: R_goal R where R_goal Rᵀ belongs",
            _made(turn=lambda R, R_goal: _vector(R_goal @ R)),
        ),
        (
            "pose-inverted",
            "a transpose is missing: R R_goal",
            _made(turn=lambda R, R_goal: _vector(R @ R_goal)),
        ),
        ("rotation-difference", "", _made(turn=lambda R, R_goal: _skew(R_goal - R))),
        (
            "rotation-difference",
            "twice the antisymmetric part",
            _made(turn=lambda R, R_goal: 2 * _skew(R_goal - R)),
        ),
        (
            "rotation-difference",
            "the x arrows subtracted",
            _made(turn=lambda R, R_goal: (R_goal - R)[:, 0]),
        ),
        (
            "rotation-difference",
            "the z arrows subtracted",
            _made(turn=lambda R, R_goal: (R_goal - R)[:, 2]),
        ),
        (
            "rotation-difference",
            "the diagonals subtracted",
            _made(turn=lambda R, R_goal: np.diag(R_goal - R)),
        ),
        ("angles-subtracted", "roll, pitch, yaw", _made(turn=_angles("xyz"))),
        ("angles-subtracted", "yaw, pitch, roll", _made(turn=_angles("ZYX"))),
        (
            "angles-subtracted",
            "rotation vectors",
            _made(turn=lambda R, R_goal: _vector(R_goal) - _vector(R)),
        ),
        (
            "rotation-vector-misread",
            "roll, pitch, yaw of the turn, not its rotation vector",
            _made(turn=_angles_of_the_turn),
        ),
        (
            "rotation-vector-misread",
            "the sine of the angle, not the angle",
            _made(turn=lambda R, R_goal: _skew(R_goal @ R.T)),
        ),
        (
            "rotation-vector-misread",
            "twice the sine of the angle, not the angle",
            _made(turn=lambda R, R_goal: 2 * _skew(R_goal @ R.T)),
        ),
        (
            "rotation-vector-misread",
            "the vector part of the quaternion",
            _made(turn=lambda R, R_goal: _quaternion(R_goal @ R.T)),
        ),
        (
            "rotation-vector-misread",
            "the axis alone, without the angle",
            _made(
                turn=lambda R, R_goal: _vector(R_goal @ R.T) / np.linalg.norm(_vector(R_goal @ R.T))
            ),
        ),
        (
            "rotation-vector-misread",
            "only the z arrows are compared",
            _made(turn=lambda R, R_goal: np.cross(R[:, 2], R_goal[:, 2])),
        ),
        ("jacobian-rows-exchanged", "", _changed(lambda e: np.roll(e, 3))),
        ("angular-part-missing", "", _changed(_backwards(1, 0))),
        ("degrees-for-radians", "the orientation", _changed(_backwards(1, DEG))),
        ("length-unit", "the position is in mm", _changed(_backwards(1000, 1))),
        (
            "wrong-frame-compared",
            "this is the goal itself, not the way to it",
            _made(way=lambda R, R_goal, p, p_goal: p_goal, turn=lambda R, R_goal: _vector(R_goal)),
        ),
        ("integer-arrays", "", _changed(truncated)),
    ],
    *(
        np.block(
            [
                [Rotation.random(random_state=k).as_matrix(), np.full((3, 1), 0.3 * k)],
                [np.zeros((1, 3)), 1],
            ]
        )
        for k in (2, 3)
    ),
)
