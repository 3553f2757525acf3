"""Two arms in one picture, at the same joint values."""

import numpy as np
from numpy.typing import ArrayLike

from ...arm import Arm
from ...printing import number
from .. import words
from ..drawing.bodies import dh_path
from ..drawing.camera import PLANES, orbit, widest_plane
from ..drawing.floor import add_floor, add_wall, floor_height
from ..drawing.page import View, compose
from ..drawing.scene import Dot, Scene, Stroke
from ..drawing.style import AXES, INK
from ..given import require_arm
from ..picture import Picture

__all__ = ["two_arms"]

HEADINGS = ("frame", "a: x, y, z (m)", "b: x, y, z (m)", "apart (mm)")
# one is wide and pale below, the other narrow and dark above, so that both show where they agree
STROKES = (("#c9ced4", 7.0, "a"), (AXES[0].color, 2.0, "b"))


def two_arms(a: Arm, b: Arm, q: ArrayLike | None = None, *, title: str | None = None) -> Picture:
    """Two arms drawn over one another at the same joint values: a wide and grey, b narrow and red.

    Parameters
    ----------
    a, b : Arm
        With the same number of joints.
    q : array (n,), optional
        Radians, metres for a prismatic joint; all 0 when left out.
    title : str, optional

    Returns
    -------
    Picture
        The table holds the frames' places, and how far the two are apart.

    Raises
    ------
    ValueError
        No arm, another number of joints, or a ``q`` that does not fit.

    Examples
    --------
    >>> import dhlab as dh
    >>> from dhlab import view
    >>> print(view.two_arms(dh.load("ur5e"), dh.load("ur5_cb")).alt)
    Universal Robots UR5e in grey and Universal Robots UR5 (CB series) in red, both at q = 0°, 0°,
    0°, 0°, 0°, 0°. Their ends are 79.89 mm apart.
    """
    for arm in (a, b):
        require_arm(arm, "view.two_arms")
    if len(a) != len(b):
        raise ValueError(
            f"view.two_arms: expected two arms of as many joints, found {len(a)} and {len(b)}; draw"
            " each with view.arm"
        )
    values = np.zeros(len(a)) if q is None else a._checked(q)
    chains = [_chain(arm, values) for arm in (a, b)]
    paths = [dh_path(arm.table.convention, T[:-1]) for arm, T in zip((a, b), chains)]
    paths = [np.vstack([path, T[-1, :3, 3]]) for path, T in zip(paths, chains)]
    everything = np.vstack(paths)
    apart = float(1e3 * np.linalg.norm(chains[1][-1, :3, 3] - chains[0][-1, :3, 3]))
    views = [_view(paths), _side_view(paths, widest_plane(everything))]
    names = [arm.name or f"arm {letter}" for arm, letter in zip((a, b), "ab")]
    picture = Picture(
        compose(views, title or f"a: {names[0]} (grey)   b: {names[1]} (red)"),
        f"{names[0]} in grey and {names[1]} in red, both at q ="
        f" {words.configuration(a.table.joints, values)}. Their ends are {number(apart, 2)} mm"
        " apart.",
        HEADINGS,
        _rows(chains),
        "Both arms, frame by frame",
        views[0].scene.named(),
    )
    picture.summary = "The places as a table"
    return picture


def _chain(arm, q):
    frames = arm.frames(q)
    return np.concatenate([frames, [frames[-1] @ arm.tool]])


def _add(scene, paths):
    for path, (color, width, name) in zip(paths, STROKES):
        scene.add(
            Stroke(path, color, width, layer="mark" if name == "b" else "body", gid=f"arm:{name}"),
            Dot(path[0], width + 3, color, "body", gid=f"base:{name}"),
            Dot(path[-1], width + 2, INK if name == "b" else color, "body", gid=f"end:{name}"),
        )


def _view(paths):
    scene, camera = Scene(), orbit()
    _add(scene, paths)
    add_floor(scene, camera, floor_height(scene.points()))
    return View(scene, camera)


def _side_view(paths, plane):
    scene, camera = Scene(), PLANES[plane]
    _add(scene, paths)
    add_wall(scene, camera, plane)
    kind = "view from above" if plane == "x-y" else "side view"
    return View(scene, camera, f"{kind}, {plane.replace('-', '–')} plane", (40.0, 34.0, 24.0, 20.0))


def _rows(chains):
    def point(T):
        return ", ".join(number(x, 4) for x in T[:3, 3])

    names = [*(str(i) for i in range(len(chains[0]) - 1)), "tool"]
    return [
        [name, point(T), point(U), number(1e3 * np.linalg.norm(U[:3, 3] - T[:3, 3]), 2)]
        for name, T, U in zip(names, *chains)
    ]
