"""What to choose for frame n: the tool's line, taken as one more axis."""

import numpy as np

from ...transform import trans
from ..drawing.bodies import add_joint
from ..drawing.camera import orbit
from ..drawing.page import View, compose
from ..drawing.scene import Dot, Label, Scene, Stroke
from ..drawing.style import AXES, INK, QUIET, SIZES
from ..picture import Picture

__all__ = ["last_axis"]

CAMERA = orbit(22, -60)
TURN = np.array([0, 1.0, 0])  # the last joint turns about this
ALONG = np.array([1.0, 0, 0])  # the tool points along this
NORMAL = np.array([0, 0, 1.0])  # at right angles to both
OUT, REACH = 0.2, 0.56  # m along the tool's line: how far it is drawn back, and on to the tool
APART = 0.38  # m between the two lines where they pass each other
X, Z, MOUNT = AXES[0].color, AXES[2].color, "#b35900"
DASH = (0, (9, 2, 2, 2))

ALT = (
    "Frame n, twice. On the left the axis of the last joint meets the tool's line: the origin of"
    " frame n is where they meet. On the right the tool's line passes the axis at a distance: the"
    " origin is the foot of the common normal on the tool's line, and x_n lies along that normal."
    " Both times z_n lies on the tool's line, and a dashed arrow, the tool's constant step, leads"
    " from the origin to the fingertips."
)
ROWS = (
    ("meets the axis of joint n", "where they meet", "at right angles to both", "0"),
    ("passes it", "foot of the common normal on it", "along the normal", "the distance"),
    ("is parallel to it", "anywhere on it", "straight across", "the distance"),
    ("is the same line", "anywhere on it: the tool's own origin", "any across it", "0"),
)


def last_axis() -> Picture:
    """The tool's line as the axis that follows the last joint's, in two cases."""
    scene = Scene()
    _add_case(scene, np.eye(4), 0.0, "they meet")
    _add_case(scene, trans(1.22 * CAMERA.right), APART, "they pass each other")
    figure = compose(
        [View(scene, CAMERA, frame=(30.0, 30.0, 34.0, 14.0))],
        "Frame n: take the tool's line for one more axis",
    )
    picture = Picture(
        figure,
        ALT,
        ("the tool's line", "origin of frame n", "x_n", "a_n"),
        ROWS,
        "Frame n on the tool's line",
        scene.named(),
    )
    picture.summary = "The cases as a table"
    return picture


def _add_case(scene, T, apart, name):
    """The last joint at the origin of T, the tool's line ``apart`` above it."""
    joint, origin = T[:3, 3], T[:3, 3] + apart * NORMAL
    tool = origin + REACH * ALONG
    _add_joint(scene, joint)
    _add_tool_line(scene, origin, tool)
    _add_gripper(scene, tool)
    if apart:
        _add_normal(scene, joint, origin)
    _add_arrow(scene, origin, NORMAL, 0.24, X, "x_n")
    _add_arrow(scene, origin, ALONG, 0.24, Z, "z_n")
    ways = np.array([origin, tool]) - 0.12 * NORMAL
    for end, way in zip((origin, tool), ways):
        scene.add(Stroke(np.array([end, way - 0.02 * NORMAL]), QUIET, 0.8, layer="aid"))
    scene.add(
        Stroke(ways, MOUNT, 1.9, (0, (4, 2)), "mark", head=10.0, casing=0.8, gid=f"tool:{name}"),
        Label(ways.mean(axis=0), "the tool", -NORMAL, MOUNT, SIZES["name"]),
        Dot(origin, 6.5, layer="mark", gid=f"o_n:{name}"),
        Label(origin, "o_n", -ALONG + NORMAL, INK, 14.0, math=True),
        Label(joint - 0.52 * NORMAL + 0.2 * ALONG, name, None, INK, SIZES["title"], fixed=0.0),
    )


def _add_joint(scene, at):
    ends = at + np.outer([-0.36, 0.42], TURN)
    scene.add(
        Stroke(ends, INK, 1.2, DASH, "shadow", head=9.0, gid="joint-axis"),
        Label(ends[1], "z_{n-1}", TURN, Z, 14.0, math=True),
        Label(ends[0], "joint n", -TURN, INK, SIZES["name"]),
    )
    add_joint(scene, "R", at, TURN, 0.055, 0.16, "joint")
    link = np.array([at, at - 0.1 * ALONG - 0.36 * NORMAL])
    scene.add(Stroke(link, "#c3c9cf", 9.0, layer="shadow", gid="link"))


def _add_tool_line(scene, origin, tool):
    ends = np.array([origin - OUT * ALONG, tool + 0.2 * ALONG])
    scene.add(
        Stroke(ends, INK, 1.0, DASH, "aid", gid="tool-line"),
        Label(ends[1], "the tool's line", -NORMAL, INK, SIZES["name"]),
    )


def _add_gripper(scene, tool):
    """Two fingers that close on the tool's origin, and the plate they sit on."""
    plate = tool - 0.17 * ALONG
    for side in (-1, 1):
        across = side * TURN
        finger = [plate, plate + 0.06 * across, plate + 0.05 * across + 0.07 * ALONG]
        path = np.array([*finger, tool + 0.025 * across])
        scene.add(Stroke(path, QUIET, 4.5, layer="body", casing=0.8, gid=f"finger:{side}"))
    add_joint(scene, "R", plate - 0.01 * ALONG, ALONG, 0.05, 0.03, "flange")
    scene.add(Dot(tool, 5.0, layer="mark"), Label(tool, "T", NORMAL, INK, 13.0))


def _add_normal(scene, joint, origin):
    ends = np.array([joint, origin])
    scene.add(
        Stroke(ends, X, 2.2, "-", "frame", casing=0.8, gid="a-length"),
        Label(ends.mean(axis=0), "a_n", -ALONG, X, 14.0, math=True),
        Dot(joint, 5.0, layer="mark"),
    )


def _add_arrow(scene, at, direction, length, color, name):
    tip = at + length * direction
    width = 2.9 if color == Z else 1.8
    scene.add(
        Stroke(np.array([at, tip]), color, width, "-", "frame", head=9.0, casing=0.6, gid=name),
        Label(tip, name, direction, color, 14.0, math=True),
    )
