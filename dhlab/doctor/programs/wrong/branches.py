"""Wrong versions of the analytic inverse kinematics of the course's 6R arm: what a learner's
``branches(T)`` computes when one thing is wrong.

The arm (``article-6r``): axes 2, 3, 4 parallel, axes 4, 5, 6 through one point, the wrist's centre.
Each entry of :data:`WRONG_BRANCHES` is ``(mistake, place, function of T)``; a function returns (8,
6) joint values in radians.
"""

import numpy as np

from ....transform import rot_x, rot_z, trans_x, trans_z
from .solvers import wrapped
from .versions import Versions

__all__ = [
    "WRONG_BRANCHES",
    "arm_angles",
    "branches",
    "branches_of_all",
    "in_order",
    "wrist_angles",
]

D1, A2, A3, D4, D6 = 0.1, 0.4, 0.35, 0.1, 0.1
DEG = 180 / np.pi


def in_order(Q):
    """Rows of joint values with whole turns taken off, in one order whatever order they came in."""
    Q = wrapped(Q)
    return Q[np.lexsort(np.round(Q, 6).T[::-1])]


def _centre(T):
    return T[:3, 3] - D6 * T[:3, 2]


def arm_angles(c, d1=D1, d4=D4, angle=np.arctan2):
    """The four triples (θ1, θ2, θ3), shape (4, 3), that bring the wrist's centre to c (3,); NaN
    where c is out of reach.
    """
    x, y, z = c
    triples = []
    for shoulder in (0, np.pi):  # facing c, or with its back to c
        theta_1 = angle(y, x) + (
            np.arcsin(d4 / np.hypot(x, y))
            if shoulder == 0
            else np.pi - np.arcsin(d4 / np.hypot(x, y))
        )
        out, up = np.cos(theta_1) * x + np.sin(theta_1) * y, z - d1
        bend = np.arccos((out**2 + up**2 - A2**2 - A3**2) / (2 * A2 * A3))
        for theta_3 in (bend, -bend):
            theta_2 = angle(up, out) - angle(A3 * np.sin(theta_3), A2 + A3 * np.cos(theta_3))
            triples.append((theta_1, theta_2, theta_3))
    return np.array(triples)


def wrist_angles(R_36):
    """The two triples (θ4, θ5, θ6), shape (2, 3), of R_36 = Rz(θ4) Ry(−θ5) Rz(θ6)."""
    theta_5 = np.arccos(R_36[2, 2])
    theta_4, theta_6 = np.arctan2(-R_36[1, 2], -R_36[0, 2]), np.arctan2(-R_36[2, 1], R_36[2, 0])
    return np.array([(theta_4, theta_5, theta_6), (theta_4 + np.pi, -theta_5, theta_6 + np.pi)])


def _R_03(theta_1, theta_2, theta_3):
    return (
        rot_z(theta_1) @ trans_z(D1) @ rot_x(np.pi / 2) @ rot_z(theta_2 + theta_3) @ trans_x(A2)
    )[..., :3, :3]


def _branches(
    T, centre=_centre, arm=arm_angles, wrist=wrist_angles, rest=lambda R_03, R: R_03.T @ R
):
    with np.errstate(all="ignore"):
        triples = arm(centre(T))
        found = [
            (*triple, *turn)
            for triple, R_03 in zip(triples, _R_03(*triples.T))
            for turn in wrist(rest(R_03, T[:3, :3]))
        ]
    return in_order(found)


def branches(T):
    """The right one: two shoulders, two elbows, two wrists, (8, 6).

    Examples
    --------
    >>> import dhlab as dh
    >>> arm = dh.load("article-6r")
    >>> T = arm.forward([0.3, 0.4, -0.7, 0.5, 0.9, 0.2])
    >>> bool(np.allclose(arm.forward(branches(T)), T))
    True
    """
    return _branches(T)


def branches_of_all(T):
    """The right ones of many poses (m, 4, 4) together: a list of m arrays (8, 6).

    Examples
    --------
    >>> import dhlab as dh
    >>> T = dh.load("article-6r").forward(np.full((2, 6), 0.5))
    >>> bool(np.allclose(branches_of_all(T)[1], branches(T[1])))
    True
    """
    Q = np.empty((len(T), 4, 2, 6))
    with np.errstate(all="ignore"):
        triples = arm_angles(_centre(np.moveaxis(T, 0, -1)))
        R_36 = np.swapaxes(_R_03(*np.moveaxis(triples, 1, 0)), -1, -2) @ T[:, :3, :3]
        turns = wrist_angles(np.moveaxis(R_36, (-2, -1), (0, 1)))
    Q[..., :3] = np.moveaxis(triples, -1, 0)[:, :, None]
    Q[..., 3:] = np.moveaxis(turns, (3, 2), (0, 1))
    return [in_order(rows) for rows in Q.reshape(-1, 8, 6)]


def _made(**parts):
    return lambda T: _branches(T, **parts)


def _second(change_4, sign_5, change_6):
    """The second wrist made from the first in another way."""

    def wrist(R_36):
        theta_4, theta_5, theta_6 = wrist_angles(R_36)[0]
        return np.array(
            [
                (theta_4, theta_5, theta_6),
                (theta_4 + change_4, sign_5 * theta_5, theta_6 + change_6),
            ]
        )

    return wrist


def _read(change):
    return lambda R_36: change(wrist_angles(R_36))


def _by_tangent(y, x):
    return np.arctan(y / x)


def _by_atan(R_36):
    theta_5 = np.arccos(R_36[2, 2])
    theta_4, theta_6 = np.arctan(R_36[1, 2] / R_36[0, 2]), np.arctan(-R_36[2, 1] / R_36[2, 0])
    return np.array([(theta_4, theta_5, theta_6), (theta_4 + np.pi, -theta_5, theta_6 + np.pi)])


def _doubled(keep):
    """Only some of the eight, each as often as it takes to fill the eight."""
    return lambda T: in_order(np.repeat(_unordered(T)[keep], 8 // len(keep), axis=0))


def _unordered(T):
    with np.errstate(all="ignore"):
        return np.array(
            [
                (*triple, *turn)
                for triple in arm_angles(_centre(T))
                for turn in wrist_angles(_R_03(*triple).T @ T[:3, :3])
            ]
        )


_ALL = [
    ("wrist-flip-incomplete", "θ5 turned round, θ4 and θ6 left", _made(wrist=_second(0, -1, 0))),
    ("wrist-flip-incomplete", "θ6 was not turned by 180°", _made(wrist=_second(np.pi, -1, 0))),
    ("wrist-flip-incomplete", "θ4 was not turned by 180°", _made(wrist=_second(0, -1, np.pi))),
    ("wrist-flip-incomplete", "θ5 kept its sign", _made(wrist=_second(np.pi, 1, np.pi))),
    (
        "joint-reversed",
        "θ5: the turn in the middle is Ry(−θ5)",
        _made(wrist=_read(lambda w: w * [1, -1, 1])),
    ),
    ("joint-reversed", "θ4 and θ6", _made(wrist=_read(lambda w: w * [-1, 1, -1]))),
    ("joint-reversed", "all three of the wrist", _made(wrist=_read(lambda w: -w))),
    (
        "joint-index-off-by-one",
        "θ4 and θ6 have changed places",
        _made(wrist=_read(lambda w: w[:, ::-1])),
    ),
    (
        "joint-index-off-by-one",
        "θ4 and θ6 have changed places, and θ5 has the other sign",
        _made(wrist=_read(lambda w: (w * [1, -1, 1])[:, ::-1])),
    ),
    ("branch-missing", "both wrists are the same", _doubled([0, 2, 4, 6])),
    ("branch-missing", "both elbows are the same", _doubled([0, 1, 4, 5])),
    ("branch-missing", "both shoulders are the same", _doubled([0, 1, 2, 3])),
    ("branch-missing", "all eight are the same", _doubled([0])),
    (
        "rotation-transposed",
        "R_03, where R_03ᵀ takes off the first three joints",
        _made(rest=lambda R_03, R: R_03 @ R),
    ),
    ("pose-inverted", "this is R_63, not R_36", _made(rest=lambda R_03, R: R.T @ R_03)),
    ("product-reversed", "R R_03ᵀ", _made(rest=lambda R_03, R: R @ R_03.T)),
    (
        "wrong-frame-compared",
        "the wrist's angles were read off R_06, with the first three joints still in it",
        _made(rest=lambda R_03, R: R),
    ),
    ("atan-for-atan2", "θ4 and θ6", _made(wrist=_by_atan)),
    ("atan-for-atan2", "θ1 and θ2", _made(arm=lambda c: arm_angles(c, angle=_by_tangent))),
    (
        "tool-missing",
        "the tool point was taken for the wrist's centre",
        _made(centre=lambda T: T[:3, 3]),
    ),
    (
        "length-sign",
        "d6: the wrist's centre lies behind the tool point",
        _made(centre=lambda T: T[:3, 3] + D6 * T[:3, 2]),
    ),
    ("length-sign", "d4", _made(arm=lambda c: arm_angles(c, d4=-D4))),
    (
        "rotation-block-misread",
        "d6 was taken off along the tool's x arrow",
        _made(centre=lambda T: T[:3, 3] - D6 * T[:3, 0]),
    ),
    (
        "translations-not-rotated",
        "d6 was taken off along z0, not along the tool's z",
        _made(centre=lambda T: T[:3, 3] - [0, 0, D6]),
    ),
    ("base-height-missing-or-twice", "d1", _made(arm=lambda c: arm_angles(c, d1=0.0))),
    ("degrees-for-radians", "the answer is in degrees", lambda T: in_order(DEG * _unordered(T))),
]


def _sample():
    """A pose in reach."""
    T = np.eye(4)
    T[:3, :3] = _R_03(0.3, 0.5, 0.9) @ _R_03(0.4, -0.8, 0.2)
    T[:3, 3] = 0.3, 0.25, 0.35
    return (T,)


WRONG_BRANCHES = Versions(lambda: _ALL, _sample)
