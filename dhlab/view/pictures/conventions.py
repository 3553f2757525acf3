"""One arm twice, in the same configuration: with its standard frames and with Craig's, and where
the two part.
"""

import numpy as np
from numpy.typing import ArrayLike

from ...arm import Arm
from ...printing import listed, number
from ...transform import trans
from .. import words
from ..drawing.bodies import add_arm, add_tool, dh_path
from ..drawing.camera import orbit
from ..drawing.floor import add_shadow, floor_height
from ..drawing.page import View, compose
from ..drawing.scene import Dot, Label, Scene, Stroke
from ..drawing.style import INK, QUIET, SIZES
from ..drawing.triads import NEAR, add_triads
from ..given import given_arm_at, spread
from ..picture import Picture

__all__ = ["conventions"]

HEADINGS = (
    "frame",
    "standard: x, y, z (m)",
    "its z axis",
    "is the axis of",
    "Craig: x, y, z (m)",
    "its z axis",
    "is the axis of",
)
NAMES = {"standard": "standard", "craig": "Craig"}
PARTED = np.deg2rad(0.01)  # axes nearer than this are one direction to every eye


def conventions(arm: Arm, q: ArrayLike | None = None) -> Picture:
    """The same arm side by side in both conventions: standard frames on the left, Craig's on the
    right.

    Parameters
    ----------
    arm : Arm
        In either convention; the other one comes from :meth:`dhlab.Arm.to`.
    q : array (n,), optional
        Radians, metres for a prismatic joint; all 0 when left out.

    Returns
    -------
    Picture
        On the right a dotted arrow leads from each frame's origin to where the standard one of the
        same number is.

    Raises
    ------
    ValueError
        No arm, or a ``q`` that does not fit it.

    Examples
    --------
    >>> import dhlab as dh
    >>> from dhlab import view
    >>> table = dh.DHTable.standard([[0, 0.1, 0, 90], [0, 0, 0.4, 0]], angle="deg")
    >>> arm = dh.Arm(table, name="two links")
    >>> print(view.conventions(arm).table)
    The frames of both conventions, in the world frame
     frame  standard: x, y, z (m)  its z axis  is the axis of  Craig: x, y, z (m)  its z axis  is the axis of
     {0}    0, 0, 0                (0, 0, 1)   joint 1         0, 0, 0             (0, 0, 1)   no joint
     {1}    0, 0, 0.1              (0, -1, 0)  joint 2         0, 0, 0.1           (0, 0, 1)   joint 1
     {2}    0.4, 0, 0.1            (0, -1, 0)  no joint        0, 0, 0.1           (0, -1, 0)  joint 2
    """  # noqa: E501  (a printed table)
    q, _ = given_arm_at(arm, q)
    arms = {name: arm.to(name) for name in NAMES}
    chains = {name: one.frames(q) for name, one in arms.items()}
    scene, camera = Scene(), orbit()
    drawn = np.vstack([_path(arms[name], chain) for name, chain in chains.items()])
    size = spread(drawn) or 0.1
    aside = trans((np.ptp(camera.flat(drawn)[:, 0]) + 0.55 * size) * camera.right)
    for name, shift in (("standard", np.eye(4)), ("craig", aside)):
        _add_copy(scene, arms[name], shift @ chains[name], size, NAMES[name])
    _add_ways(scene, aside @ chains["craig"], aside @ chains["standard"])
    values = words.configuration(arm.table.joints, q).replace("-", "−")
    figure = compose(
        [View(scene, camera, frame=(38.0, 26.0, 38.0, 20.0))],
        f"{arm.name or 'Arm'} in both conventions\nq = ({values})",
    )
    picture = Picture(
        figure,
        _alt(arm, q, **chains),
        HEADINGS,
        _rows(**chains),
        "The frames of both conventions, in the world frame",
        scene.named(),
    )
    picture.summary = "The frames of both as a table"
    return picture


def _path(arm, chain):
    """The links from corner to corner, and on to the tool."""
    return np.vstack([dh_path(arm.table.convention, chain), (chain[-1] @ arm.tool)[:3, 3]])


def _add_copy(scene, arm, chain, size, name):
    path = _path(arm, chain)
    add_arm(scene, arm, chain, size)
    if np.linalg.norm(path[-1] - path[-2]) > NEAR:
        add_tool(scene, path[-2], path[-1])
    subscripts = [str(i) for i in range(len(chain))]
    drawn = len(scene.items)
    add_triads(scene, chain, subscripts, 0.14 * size)
    for item in scene.items[drawn:]:  # both copies have a frame {1}
        item.gid = item.gid and f"{name} {item.gid}"
    low = floor_height(path)
    add_shadow(scene, path, low)
    foot = np.array([*path[0, :2], low])
    scene.add(
        Dot(foot, 3.0, QUIET, "shadow"),
        Label(
            foot, name, np.array([0, 0, -1.0]), INK, SIZES["title"], fixed=22.0, gid="convention"
        ),
    )


def _add_ways(scene, craig, standard):
    """From each of Craig's origins to the standard one of the same number."""
    for i, ends in enumerate(zip(craig[:, :3, 3], standard[:, :3, 3])):
        if np.linalg.norm(ends[1] - ends[0]) > NEAR:
            scene.add(
                Stroke(np.array(ends), INK, 1.4, (0, (1, 1.6)), "mark", head=7.0, gid=f"way:{i}"),
                Dot(ends[1], 4.0, "white", "mark"),
            )


def _rows(standard, craig):
    n = len(standard) - 1
    joint = ["no joint", *(f"joint {i}" for i in range(1, n + 1)), "no joint"]

    def cells(pose, k):
        return [
            ", ".join(number(v, 4) for v in pose[:3, 3]),
            "(" + ", ".join(number(v, 3) for v in pose[:3, 2]) + ")",
            joint[k],
        ]

    return [[f"{{{i}}}", *cells(standard[i], i + 1), *cells(craig[i], i)] for i in range(n + 1)]


def _alt(arm, q, standard, craig):
    parts = [_parting(i, a, b) for i, (a, b) in enumerate(zip(standard, craig))]
    parted = [part for part in parts if part]
    same = [f"{{{i}}}" for i, part in enumerate(parts) if not part]
    agree = f" The same in both: {listed(same)}." if same else ""
    differ = (
        f" Seen from the standard frame of the same number, Craig's {listed(parted)}."
        if parted
        else ""
    )
    return (
        f"{words.who(arm)}, drawn twice at q = {words.configuration(arm.table.joints, q)}: with its"
        " standard frames on the left, with Craig's on the right. The links are the"
        f" same.{agree}{differ}"
    )


def _parting(i, standard, craig):
    """How Craig's frame i differs from the standard one, or ""."""
    away = np.linalg.norm(craig[:3, 3] - standard[:3, 3])
    turn = np.arccos(np.clip(craig[:3, 2] @ standard[:3, 2], -1, 1))
    found = [
        text
        for text, seen in (
            (f"{number(away, 4)} m away", away > NEAR),
            (f"turned by {number(np.rad2deg(turn), 1)}°", turn > PARTED),
        )
        if seen
    ]
    return f"{{{i}}} is {' and '.join(found)}" if found else ""
