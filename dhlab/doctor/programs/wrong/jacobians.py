"""Wrong versions of the geometric Jacobian: what a learner's function computes when one thing is
wrong.

Each entry of :data:`WRONG_JACOBIANS` is ``(mistake, place, function)``, a function of ``frames``
(n + 1, 4, 4), ``T_end`` (4, 4) and ``sliding`` (n,); metres and radians.
"""

import numpy as np

from .columns import (
    after,
    axes,
    columns,
    geometric_jacobian,
    halved,
    levers,
    next_axes,
    next_levers,
    slid,
    turned,
    with_other,
)
from .errors import pose_error
from .versions import Versions

__all__ = ["geometric_jacobian", "pose_error", "WRONG_JACOBIANS"]

DEG = 180 / np.pi

_ALL = [
    ("jacobian-axis-off-by-one", "axis and origin", with_other(next_axes, next_levers)),
    ("jacobian-axis-off-by-one", "the axis", with_other(axes=next_axes)),
    ("jacobian-axis-off-by-one", "the origin", with_other(levers=next_levers)),
    (
        "jacobian-axis-off-by-one",
        "the base's axis for every joint",
        with_other(axes=lambda frames: 0 * frames[:-1, :3, 2] + frames[0, :3, 2]),
    ),
    (
        "jacobian-axis-off-by-one",
        "axis and origin are those of the joint before, and joint 1 has the last frame's",
        with_other(
            lambda frames: np.roll(frames, 1, axis=0)[:-1, :3, 2],
            lambda frames, p: p - np.roll(frames, 1, axis=0)[:-1, :3, 3],
        ),
    ),
    ("cross-product-reversed", "", with_other(levers=lambda frames, p: -levers(frames, p))),
    (
        "lever-arm-wrong",
        "p of the end alone: o was not taken off, or z or a row in its place",
        with_other(levers=lambda frames, p: 0 * frames[:-1, :3, 3] + p),
    ),
    (
        "lever-arm-wrong",
        "o alone, the end does not enter",
        with_other(levers=lambda frames, p: frames[:-1, :3, 3]),
    ),
    (
        "lever-arm-wrong",
        "o × z: the velocity of a point at the base's origin",
        with_other(levers=lambda frames, p: -frames[:-1, :3, 3]),
    ),
    (
        "lever-arm-wrong",
        "to the next origin, not to the end",
        with_other(levers=lambda frames, p: frames[1:, :3, 3] - frames[:-1, :3, 3]),
    ),
    (
        "lever-arm-wrong",
        "from the base's origin for every joint",
        with_other(levers=lambda frames, p: 0 * frames[:-1, :3, 3] + p - frames[0, :3, 3]),
    ),
    (
        "lever-arm-wrong",
        "the sum p + o",
        with_other(levers=lambda frames, p: p + frames[:-1, :3, 3]),
    ),
    (
        "wrong-frame-compared",
        "T_end was multiplied onto the last frame; it is the end in the base already",
        lambda frames, T_end, sliding: geometric_jacobian(frames, frames[-1] @ T_end, sliding),
    ),
    (
        "tool-missing",
        "the last frame's origin was taken for the end",
        with_other(levers=lambda frames, p: levers(frames, frames[-1, :3, 3])),
    ),
    (
        "elementwise-product",
        "z * (p − o), entry by entry, where np.cross(z, p − o) belongs",
        lambda frames, T_end, sliding: np.vstack(
            [
                np.where(sliding, axes(frames).T, (axes(frames) * levers(frames, T_end[:3, 3])).T),
                np.where(sliding, 0.0, axes(frames).T),
            ]
        ),
    ),
    ("jacobian-rows-exchanged", "", after(lambda J, *rest: np.vstack([J[3:], J[:3]]))),
    (
        "jacobian-rows-exchanged",
        "in the turning columns",
        after(lambda J, frames, T_end, sliding: np.where(sliding, J, np.vstack([J[3:], J[:3]]))),
    ),
    (
        "prismatic-column-wrong",
        "sliding joints are treated as turning ones",
        with_other(columns=lambda z, lever, sliding: columns(z, lever, np.zeros_like(sliding))),
    ),
    (
        "prismatic-column-wrong",
        "turning joints are treated as sliding ones too",
        with_other(columns=lambda z, lever, sliding: columns(z, lever, np.ones_like(sliding))),
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
        with_other(columns=lambda z, lever, sliding: columns(z, lever, np.logical_not(sliding))),
    ),
    (
        "prismatic-column-wrong",
        "ω should be 0: a slide turns nothing",
        with_other(columns=slid(lambda z, lever: z, lambda z: z)),
    ),
    (
        "prismatic-column-wrong",
        "v should be z, not −z",
        with_other(columns=slid(lambda z, lever: -z, lambda z: 0 * z)),
    ),
    (
        "prismatic-column-wrong",
        "v should be the joint's own z: the z of the next frame stands there",
        lambda frames, T_end, sliding: np.where(
            sliding,
            np.vstack([next_axes(frames).T, 0 * next_axes(frames).T]),
            geometric_jacobian(frames, T_end, sliding),
        ),
    ),
    (
        "prismatic-column-wrong",
        "v should be z as the base sees it: (0, 0, 1) is z in its own frame",
        with_other(columns=slid(lambda z, lever: 0 * z + [0.0, 0.0, 1.0], lambda z: 0 * z)),
    ),
    (
        "prismatic-column-wrong",
        "v and ω have changed places",
        with_other(columns=slid(lambda z, lever: 0 * z, lambda z: z)),
    ),
    (
        "prismatic-column-wrong",
        "v should be z: a slide has no lever",
        with_other(columns=slid(np.cross, lambda z: 0 * z)),
    ),
    (
        "prismatic-column-wrong",
        "the column is empty",
        with_other(columns=slid(lambda z, lever: 0 * z, lambda z: 0 * z)),
    ),
    (
        "prismatic-column-wrong",
        "the lever stands where the direction z belongs",
        with_other(columns=slid(lambda z, lever: lever, lambda z: 0 * z)),
    ),
    (
        "jacobian-frame",
        "written in the tool's axes",
        after(lambda J, frames, T_end, sliding: turned(J, T_end[:3, :3])),
    ),
    (
        "jacobian-frame",
        "written in frame {0}, without the base",
        after(lambda J, frames, T_end, sliding: turned(J, frames[0, :3, :3])),
    ),
    (
        "jacobian-frame",
        "written in the last frame's axes",
        after(lambda J, frames, T_end, sliding: turned(J, frames[-1, :3, :3])),
    ),
    (
        "jacobian-frame",
        "the axis left in its own frame: always 0 0 1",
        with_other(axes=lambda frames: 0 * frames[:-1, :3, 2] + [0.0, 0.0, 1.0]),
    ),
    (
        "rotation-transposed",
        "a row was taken for the axis",
        with_other(axes=lambda frames: frames[:-1, 2, :3]),
    ),
    (
        "rotation-block-misread",
        "the x arrow was taken for the joint's axis",
        with_other(axes=lambda frames: frames[:-1, :3, 0]),
    ),
    (
        "rotation-block-misread",
        "the y arrow was taken for the joint's axis",
        with_other(axes=lambda frames: frames[:-1, :3, 1]),
    ),
    (
        "rotation-block-misread",
        "the origin was taken for the axis",
        with_other(axes=lambda frames: frames[:-1, :3, 3]),
    ),
    ("angular-part-missing", "", after(lambda J, *rest: halved(J, 0.0))),
    ("joint-reversed", "every number has the other sign", after(lambda J, *rest: -J)),
    ("error-sign", "ω has the other sign", after(lambda J, *rest: halved(J, -1.0))),
    (
        "degrees-for-radians",
        "per degree where per radian was asked",
        after(lambda J, *rest: J / DEG),
    ),
    ("degrees-for-radians", "ω in degrees", after(lambda J, *rest: halved(J, DEG))),
    ("degrees-for-radians", "all numbers in degrees", after(lambda J, *rest: J * DEG)),
    (
        "columns-misread",
        "reshape(6, n) does not turn a list of columns round: .T does",
        after(lambda J, *rest: J.T.reshape(J.shape)),
    ),
    (
        "joint-index-off-by-one",
        "the columns come in reverse order",
        after(lambda J, *rest: J[:, ::-1]),
    ),
    ("integer-arrays", "", after(lambda J, *rest: np.trunc(J))),
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
