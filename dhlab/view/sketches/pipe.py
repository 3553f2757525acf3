"""A link as what it is made of, a bent pipe, and as what a table says of it: two axes."""

import numpy as np
from scipy.interpolate import CubicSpline

from ...transform import rot_x, trans
from ..drawing.bodies import add_joint
from ..drawing.camera import orbit
from ..drawing.page import View, compose
from ..drawing.scene import Dot, Face, Label, Scene, Stroke
from ..drawing.style import AXES, INK, QUIET, SIZES
from ..picture import Picture

__all__ = ["bent_pipe"]

D, A, ALPHA = 0.42, 0.5, np.deg2rad(55)
OLD, NEW = np.eye(4), trans([A, 0, D]) @ rot_x(ALPHA)
HOLES = (
    -0.16,
    -0.3,
)  # m along the two axes, from o_{i-1} and from o_i, where the pipe has its ends
SAG = 0.16  # m, how far the pipe hangs out of the way
CAMERA = orbit(20, -62)
X, Z = AXES[0].color, AXES[2].color

ALT = (
    "A bent pipe between two joint axes. The pipe runs from a housing low on the old axis to one on"
    " the new axis, in a wide bow. Nothing in the table follows the pipe: d goes up the old axis, a"
    " goes straight across on the common normal, which meets both axes at right angles and touches"
    " the pipe nowhere, and alpha is the angle by which the new axis is tipped about that line."
)
ROWS = (
    ("d", "the old z axis", "from old x up to the common normal"),
    ("a", "the common normal, x", "from the old axis to the new one"),
    ("alpha", "the common normal, x", "from the direction of old z to new z"),
)


def bent_pipe() -> Picture:
    """A pipe between two axes, beside d, a and alpha."""
    scene = Scene()
    foot = np.array([0, 0, D])
    holes = [HOLES[0] * OLD[:3, 2], NEW[:3, 3] + HOLES[1] * NEW[:3, 2]]
    _add_pipe(scene, holes)
    for k, (pose, low, high) in enumerate(((OLD, -0.31, 0.78), (NEW, -0.5, 0.4))):
        _add_axis(scene, pose, low, high, ("z_{i-1}", "z_i")[k])
        add_joint(scene, "R", holes[k], pose[:3, 2], 0.05, 0.13, f"joint:{k}")
    _add_normal(scene, foot)
    _add_d(scene, foot)
    _add_alpha(scene)
    figure = compose(
        [View(scene, CAMERA, frame=(40.0, 16.0, 40.0, 16.0))],
        "The metal goes its own way; the table measures the axes",
    )
    picture = Picture(
        figure,
        ALT,
        ("number", "measured on", "from where to where"),
        ROWS,
        "What the numbers of a link are measured on (theta is 0 here)",
        scene.named(),
    )
    picture.summary = "The numbers in words"
    return picture


def _add_pipe(scene, holes):
    """A tube through the two holes, round ends, drawn in pieces that know what is before them."""
    middle = np.mean(holes, axis=0)
    way = [
        holes[0],
        holes[0] + [0.17, -0.06, -0.02],
        middle + [0.1, -SAG, -0.17],
        holes[1] + [0.03, -0.04, -0.13],
        holes[1],
    ]
    path = CubicSpline(np.linspace(0, 1, len(way)), way)(np.linspace(0, 1, 60))
    scene.add(
        Stroke(path, QUIET, 21.0, layer="shadow"),
        Stroke(path, "#d7dce1", 19.2, layer="shadow", gid="pipe"),
        Stroke(path + 0.012 * CAMERA.up, "#eef1f3", 6.0, layer="shadow"),
    )


def _add_axis(scene, pose, low, high, name):
    z = pose[:3, 2]
    ends = pose[:3, 3] + np.outer([low, high], z)
    scene.add(
        Stroke(ends, INK, 1.0, (0, (9, 2, 2, 2)), "shadow", gid=f"line:{name}"),
        Stroke(
            np.array([ends[1] - 0.2 * z, ends[1]]),
            Z,
            2.9,
            "-",
            "frame",
            head=11.0,
            casing=0.6,
            gid=f"axis:{name}",
        ),
        Label(ends[1], name, z, Z, 14.0, math=True),
    )


def _add_normal(scene, foot):
    """The line across, with a right angle where it meets each axis, and x_i beyond it."""
    end = NEW[:3, 3]
    scene.add(
        Stroke(np.array([foot, end]), X, 2.4, "-", "mark", head=11.0, casing=1.0, gid="a-length"),
        Label((foot + end) / 2, "a_i", np.array([0, 0, 1.0]), X, 15.0, math=True),
        Label((foot + end) / 2, "common normal", np.array([0, 0, -1.0]), QUIET, SIZES["name"]),
        Dot(foot, 6.0, layer="mark"),
        Dot(end, 6.0, layer="mark", gid="o_i"),
        Stroke(np.array([end, end + [0.2, 0, 0]]), X, 1.6, "-", "frame", head=8.0, gid="x_i"),
        Label(end + [0.2, 0, 0], "x_i", np.array([1.0, 0, 0]), X, 14.0, math=True),
    )
    for at, along, z in ((foot, 1.0, OLD[:3, 2]), (end, -1.0, NEW[:3, 2])):
        x = np.array([along, 0, 0])
        square = at + 0.045 * np.array([x, x - z, -z])
        scene.add(Stroke(square, INK, 1.0, "-", "mark", gid="right-angle"))


def _add_d(scene, foot):
    """From the old x up to the foot of the normal, on the free side of the axis."""
    side = -0.13 * CAMERA.right
    for end in (np.zeros(3), foot):
        scene.add(Stroke(np.array([end, end + 1.15 * side]), QUIET, 0.8, layer="aid"))
    line = np.array([side, foot + side])
    scene.add(
        Stroke(line, Z, 2.0, "-", "mark", head=10.0, casing=0.6, gid="d-length"),
        Label(line.mean(axis=0), "d_i", side, Z, 15.0, math=True),
        Dot(np.zeros(3), 6.0, layer="mark"),
        Stroke(np.array([np.zeros(3), [0.2, 0, 0]]), X, 1.6, "-", "mark", head=8.0, gid="old-x"),
        Label(np.array([0.2, 0, 0]), "x_{i-1}", np.array([1.0, 0, 0]), X, 14.0, math=True),
    )


def _add_alpha(scene):
    """The old direction once more at the new axis, and the turn from it to the new one."""
    o, angles = NEW[:3, 3], np.linspace(0, ALPHA, 30)[:, None]
    arc = o + 0.24 * (np.cos(angles) * OLD[:3, 2] - np.sin(angles) * OLD[:3, 1])
    up = np.array([o, o + 0.34 * OLD[:3, 2]])
    scene.add(
        Stroke(up, QUIET, 1.1, (0, (3, 2)), "aid", gid="old-direction"),
        Face(np.vstack([o, arc]), X, layer="shadow", alpha=0.13),
        Stroke(arc, X, 1.8, "-", "mark", head=9.0, casing=0.6, gid="alpha-arc"),
        Label(arc[15], r"\alpha_i", arc[15] - o, X, 15.0, math=True),
    )
