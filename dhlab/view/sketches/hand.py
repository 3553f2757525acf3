"""The right hand: which way z points, and which way an angle counts."""

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.spatial.transform import Rotation

from ... import transform
from ..drawing.camera import orbit
from ..drawing.page import View, compose
from ..drawing.scene import Face, Label, Scene, Stroke
from ..drawing.style import AXES, INK, SIZES
from ..picture import Picture

__all__ = ["right_hand"]

SKIN, SLEEVE, LINE = "#f1e4d3", "#c9d3dc", "#6b5a48"
GRIP = 0.25  # m, from the middle of the fist to the middle of a finger
THICK = 21.5  # page points, of a finger
FINGERS = (0.33, 0.11, -0.11, -0.31)  # heights of the four above the middle of the fist, m
TIPS = (150, 165, 162, 145)  # degrees round the thumb's line, where each finger ends
FIST = np.array([0.0, 0.0, 1.15])  # middle of the fist above the origin of its frame
TALL = 2.35  # m, of the thumb's arrow; the other two are shorter
ACROSS = 1.25
CAMERA = orbit(20, 48)
ASIDE, LEAN = 2.75, np.deg2rad(38)  # the second hand: how far to the right, how far it leans

THUMB = [[-0.5, -0.2, 0.2], [-0.36, -0.1, 0.5], [-0.22, 0.0, 0.74], [-0.19, 0.02, 0.98]]

ALT = (
    "Two right hands. On the left a hand closes around the z axis of a frame: its thumb points"
    " along z, its fingers go round from x to y. On the right the same hand holds another axis:"
    " thumb along the axis, and the fingers go the way in which a positive angle turns."
)


def right_hand() -> Picture:
    """A hand around z, and the same hand around any axis."""
    scene = Scene()
    _add_frame(scene)
    _add_hand(scene, transform.trans(FIST))
    leaning = np.eye(4)
    leaning[:3, :3] = Rotation.from_rotvec(-LEAN * CAMERA.toward).as_matrix()
    _add_any_axis(scene, transform.trans(ASIDE * CAMERA.right + FIST) @ leaning)
    figure = compose(
        [View(scene, CAMERA, frame=(16.0, 30.0, 16.0, 14.0))],
        "The right hand: which way z points, which way angles count",
    )
    rows = [["z", "x", "y"], ["x", "y", "z"], ["y", "z", "x"]]
    picture = Picture(
        figure,
        ALT,
        ("thumb along", "fingers go from", "to"),
        rows,
        "What the right hand says",
        scene.named(),
    )
    picture.summary = "The rule as a table"
    return picture


def _add_frame(scene):
    for style, direction, length in zip(AXES, np.eye(3), (ACROSS, ACROSS, TALL)):
        scene.add(
            Stroke(
                np.array([np.zeros(3), length * direction]),
                style.color,
                style.width + 0.8,
                style.dash,
                "body",
                head=13.0,
                casing=1.0,
                gid=f"{style.letter}-axis:hand",
            ),
            Label(length * direction, style.letter, direction, style.color, 15.0, math=True),
        )
    _add_turn(scene, np.eye(4), 0.95, (4, 86), AXES[2].color, "from x to y")


def _add_any_axis(scene, T):
    low, high = (T[:3, 3] + h * T[:3, 2] for h in (-1.5, 1.35))
    scene.add(
        Stroke(np.array([low, high]), INK, 2.2, "-", "body", head=13.0, casing=1.0, gid="any-axis"),
        Label(high, "any axis", T[:3, 2], INK, SIZES["value"]),
    )
    _add_hand(scene, T)
    _add_turn(scene, T @ transform.trans_z(-1.05), 0.42, (-60, 150), INK, "positive angles")


def _add_turn(scene, T, radius, between, color, text):
    """A bent arrow about z of T, counter-clockwise as seen against z."""
    arc = _arc(T, radius, np.linspace(between[0], between[1], 40))
    scene.add(
        Stroke(arc, color, 1.8, "-", "mark", head=10.0, casing=0.8, gid=f"turn:{text}"),
        Label(arc[len(arc) // 2], text, -T[:3, 2], color, SIZES["name"]),
    )


def _add_hand(scene, T):
    """A closed right hand around z of T: forearm from behind, palm, four fingers, thumb up."""
    palm = [[x, -0.25, z] for x in (-0.5, 0.02) for z in (-0.28, 0.34)]
    arm = [[x, -0.27, z] for x in (-0.95, -0.55) for z in (-0.13, 0.13)]
    cuff = [[x, -0.27, z] for x in (-1.35, -0.95) for z in (-0.19, 0.19)]
    for gid, middles, round_, fill in (
        ("sleeve", cuff, 0.17, SLEEVE),
        ("forearm", arm, 0.14, SKIN),
        ("palm", palm, 0.13, SKIN),
    ):
        solid = _moved(T, _balls(middles, round_))
        scene.add(Face(solid, fill, LINE, outline=True, gid=gid, layer="shadow"))
    for height, tip in zip(FINGERS, TIPS):
        bent = _arc(T @ transform.trans_z(height), GRIP, np.linspace(-95, tip, 40))
        _add_limb(scene, bent, THICK, "aid", "finger")
    _add_limb(scene, _moved(T, _smooth(THUMB)), THICK, "aid", "thumb")


def _balls(middles, radius):
    """Points (k, 3) on balls, whose hull is a solid with round edges."""
    turns, heights = np.meshgrid(np.linspace(0, 2 * np.pi, 24), np.linspace(-1, 1, 13))
    flat = np.sqrt(1 - heights**2)
    ball = np.stack([flat * np.cos(turns), flat * np.sin(turns), heights], axis=-1).reshape(-1, 3)
    return (np.array(middles)[:, None] + radius * ball).reshape(-1, 3)


def _smooth(points):
    """A curve (k, 3) through points that have no corner left."""
    stops = np.linspace(0, 1, len(points))
    return CubicSpline(stops, points)(np.linspace(0, 1, 30))


def _add_limb(scene, path, width, layer, gid):
    """A finger: a wide line with round ends, on a slightly wider one that is its edge."""
    scene.add(
        Stroke(path, LINE, width + 1.6, layer=layer),
        Stroke(path, SKIN, width, layer=layer, gid=gid),
    )


def _arc(T, radius, degrees):
    turns = np.deg2rad(degrees)
    return _moved(T, radius * np.column_stack([np.cos(turns), np.sin(turns), 0 * turns]))


def _moved(T, points):
    return np.asarray(points) @ T[:3, :3].T + T[:3, 3]
