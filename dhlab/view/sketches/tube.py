"""The upper arm of an xArm6 from the side: a bent tube between two parallel axes."""

import numpy as np

from ...printing import number
from ..drawing.camera import PLANES
from ..drawing.page import View, compose
from ..drawing.scene import Dot, Face, Label, Scene, Stroke
from ..drawing.style import AXES, INK, JOINT_CAP, QUIET, SIZES
from ..picture import Picture

__all__ = ["bent_tube"]

UP, FORWARD = 0.2845, 0.0535  # m
AXIS_2, BEND, AXIS_3 = np.zeros(3), np.array([0, UP, 0]), np.array([FORWARD, UP, 0])
X, Y, Z = np.eye(3)
RING = 0.024  # m, radius of a housing seen along its axis

ALT = (
    "The upper arm of an xArm6 from the side, both axes towards you. A tube leaves axis 2, goes"
    " 284.5 mm straight up, along y0, bends at a right angle and goes 53.5 mm forward, along x0, to"
    " axis 3."
)
ROWS = (("axis 2", "0", "0"), ("the bend", "0", "284.5"), ("axis 3", "53.5", "284.5"))


def bent_tube() -> Picture:
    """The tube with its two measures, seen along the axes."""
    scene = Scene()
    tube = np.array([AXIS_2, BEND, AXIS_3])
    scene.add(
        Stroke(tube, QUIET, 27.0, layer="shadow"),
        Stroke(tube, "#d7dce1", 25.2, layer="shadow", gid="tube"),
    )
    for at, name, toward in ((AXIS_2, "axis 2", -Y), (AXIS_3, "axis 3", X)):
        _add_housing(scene, at, name, toward)
    _add_frame(scene)
    _add_measure(scene, AXIS_2, BEND, -0.062 * X)
    _add_measure(scene, BEND, AXIS_3, 0.05 * Y)
    figure = compose(
        [View(scene, PLANES["x-y"], frame=(64.0, 34.0, 64.0, 18.0))],
        "From axis 2 to axis 3, seen along both",
    )
    picture = Picture(
        figure, ALT, ("point", "x0 (mm)", "y0 (mm)"), ROWS, "The tube, from axis 2", scene.named()
    )
    picture.summary = "The measures as a table"
    return picture


def _add_housing(scene, at, name, toward):
    turns = np.linspace(0, 2 * np.pi, 60)[:, None]
    ring = at + RING * (np.cos(turns) * X + np.sin(turns) * Y)
    scene.add(
        Face(ring, JOINT_CAP, INK, layer="body", gid=f"housing:{name}"),
        Dot(at, 5.0, layer="mark", gid=name),
        Label(at + RING * toward, name, toward, INK, SIZES["value"]),
    )


def _add_frame(scene):
    for style, direction, name in ((AXES[0], X, "x_0"), (AXES[1], Y, "y_0")):
        ends = np.array([AXIS_2, 0.085 * direction])
        scene.add(
            Stroke(ends, style.color, 2.0, style.dash, "frame", head=9.0, casing=0.8, gid=name),
            Label(ends[1], name, X, style.color, 14.0, math=True),
        )
    circle = np.linspace(0, 2 * np.pi, 40)[:, None]
    scene.add(
        Stroke(0.009 * (np.cos(circle) * X + np.sin(circle) * Y), AXES[2].color, 1.6, layer="mark"),
        Label(0.8 * RING * (-X - Y), "z0 towards you", -X, AXES[2].color, fixed=3.0),
    )


def _add_measure(scene, start, end, aside):
    """A length beside the tube, in millimetres, as on a drawing."""
    for point in (start, end):
        scene.add(Stroke(np.array([point, point + 1.15 * aside]), QUIET, 0.8, layer="aid"))
    line = np.array([start, end]) + aside
    text = f"{number(1e3 * np.linalg.norm(end - start), 1)} mm"
    scene.add(
        Stroke(line, INK, 1.3, "-", "mark", head=8.0, gid=f"measure:{text}"),
        Stroke(line[::-1], INK, 1.3, "-", "mark", head=8.0),
        Label(line.mean(axis=0), text, aside, INK, SIZES["value"]),
    )
