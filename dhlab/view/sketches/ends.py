"""Where the frames with names stand: base, flange, tool and camera; and the loop that a camera on
the hand closes.
"""

import numpy as np

from ...arm import Arm
from ...table import DHTable
from ...transform import rot_z, trans
from ..drawing.bodies import add_arm, add_joint, dh_path
from ..drawing.camera import orbit
from ..drawing.floor import add_shadow
from ..drawing.page import View, compose
from ..drawing.scene import Face, Label, Scene, Stroke
from ..drawing.style import INK, QUIET
from ..drawing.triads import add_triads
from ..picture import Picture

__all__ = ["ends", "hand_eye"]

# an arm of six axes that stands so that every frame is seen; what matters is its two ends
ARM = Arm(
    DHTable.standard(
        np.array(
            [
                [0, 0.3, 0, 90],
                [0, 0, 0.42, 0],
                [0, 0, 0, 90],
                [0, 0.36, 0, -90],
                [0, 0, 0, 90],
                [0, 0.11, 0, 0],
            ]
        ),
        angle="deg",
    )
)
Q = np.deg2rad([12, 78, 24, 0, -97, 180])
CAMERA = orbit(21, -66)
TRIAD = 0.15  # m
UNKNOWN = "#b35900"
GRIP = 0.17  # m, from the flange to the fingertips


def ends() -> Picture:
    """An arm with its base, flange and tool, and a camera on a stand."""
    chain = ARM.frames(Q)
    flange, tool = chain[-1], chain[-1] @ trans([0, 0, GRIP])
    stand = _looking([1.05, -0.02, 0.62], tool[:3, 3])
    scene = Scene()
    _add_arm(scene, chain)
    _add_gripper(scene, flange)
    _add_stand(scene, stand)
    _add_camera(scene, stand)
    poses = np.array([chain[0], flange, tool, stand])
    titles = ["base {0}", "flange {F}", "tool {T}", "camera {C}"]
    add_triads(scene, poses, ["0", "F", "T", "C"], TRIAD, titles=titles)
    _add_way(scene, chain[0], flange, "T_{0F}", INK, -0.03)
    _add_way(scene, flange, tool, "T_{FT}", INK, 0.6)
    _add_way(scene, chain[0], stand, "T_{0C}", UNKNOWN, -0.2, (0, (4, 2)))
    rows = [
        ["base {0}", "fixed to the table", "where everything is counted from"],
        ["flange {F}", "the plate on which the arm ends", "the controller"],
        ["tool {T}", "the fingertips", "whoever mounted the tool"],
        ["camera {C}", "on its stand", "nobody, until it is calibrated"],
    ]
    return _picture(
        scene,
        "Four frames with names",
        "An arm on a table, with four frames. The base frame {0} stands under the arm. The flange"
        " frame {F} sits on the plate in which the arm ends; the pose T_0F leads there. The tool"
        " frame {T} sits between the fingertips, a constant step T_FT further. The camera frame {C}"
        " is on a stand beside the arm; its pose T_0C, dashed, does not depend on the joints.",
        ("frame", "where", "who knows it"),
        rows,
    )


def hand_eye() -> Picture:
    """A camera on the hand that looks at a pattern: four poses in a ring."""
    chain = ARM.frames(Q)
    flange = chain[-1]
    eye = flange @ trans([-0.17, 0, 0.02])
    pattern = trans([0.58, -0.06, 0.0]) @ rot_z(np.deg2rad(8))
    scene = Scene()
    _add_arm(scene, chain)
    scene.add(
        Stroke(np.array([flange[:3, 3], eye[:3, 3]]), QUIET, 5.0, layer="shadow", gid="bracket")
    )
    _add_camera(scene, eye)
    _add_board(scene, pattern)
    poses = np.array([chain[0], flange, eye, pattern])
    titles = ["base {0}", "flange {F}", "camera {C}", "pattern {P}"]
    add_triads(scene, poses, ["0", "F", "C", "P"], TRIAD, titles=titles)
    _add_way(scene, chain[0], flange, "T_{0F}", INK, -0.12)
    _add_way(scene, flange, eye, "T_{FC}", UNKNOWN, 0.75, (0, (4, 2)))
    _add_way(scene, eye, pattern, "T_{CP}", INK, 0.14)
    _add_way(scene, chain[0], pattern, "T_{0P}", UNKNOWN, -0.16, (0, (4, 2)))
    rows = [
        ["T_0F", "the controller, from q", "with every pose of the arm"],
        ["T_FC", "nobody yet: hand-eye calibration finds it", "never: the camera is bolted on"],
        ["T_CP", "the camera, from its picture", "with every pose of the arm"],
        ["T_0P", "nobody yet: it comes out as well", "never: the pattern lies still"],
    ]
    return _picture(
        scene,
        "Two ways to the pattern, one place",
        "An arm with a camera bolted to its hand looks at a pattern on the table. Four poses make a"
        " ring: T_0F from the base to the flange, T_FC from the flange to the camera, T_CP from the"
        " camera to the pattern, and T_0P from the base straight to the pattern. The product of the"
        " first three is the fourth. T_FC and T_0P, dashed, are unknown and constant.",
        ("pose", "who knows it", "it changes"),
        rows,
    )


def _picture(scene, title, alt, headings, rows):
    figure = compose([View(scene, CAMERA, frame=(34.0, 22.0, 34.0, 14.0))], title)
    picture = Picture(figure, alt, headings, rows, title, scene.named())
    picture.summary = "The same as a table"
    return picture


def _add_arm(scene, chain):
    size = 0.95
    add_joint(scene, "R", np.array([0, 0, 0.02]), np.array([0, 0, 1.0]), 0.09, 0.04, "foot")
    add_arm(scene, ARM, chain, size)
    add_joint(scene, "R", chain[-1][:3, 3], chain[-1][:3, 2], 0.045, 0.018, "flange")
    add_shadow(scene, dh_path(ARM.table.convention, chain), 0.0, 9.0)


def _add_gripper(scene, flange):
    for side in (-1, 1):
        finger = [[0.012 * side, 0, 0.05], [0.05 * side, 0, 0.06], [0.05 * side, 0, 0.1]]
        path = _moved(flange, [*finger, [0.028 * side, 0, GRIP]])
        scene.add(Stroke(path, QUIET, 4.5, layer="body", casing=0.8, gid=f"finger:{side}"))
    scene.add(
        Stroke(_moved(flange, [[0, 0, 0], [0, 0, 0.06]]), QUIET, 9.0, layer="body", gid="palm")
    )


def _add_camera(scene, T):
    """A box whose lens looks along z; the frame sits in the middle of the lens."""
    box = [[x, y, z] for x in (-0.045, 0.045) for y in (-0.035, 0.035) for z in (-0.09, -0.02)]
    scene.add(Face(_moved(T, box), "#565f69", INK, outline=True, gid="camera", layer="body"))
    add_joint(scene, "R", T[:3, 3] - 0.008 * T[:3, 2], T[:3, 2], 0.026, 0.03, "lens")


def _looking(place, target):
    """The pose of a camera at a place: z toward the target, x level."""
    z = np.asarray(target) - place
    z /= np.linalg.norm(z)
    x = np.cross(z, [0, 0, 1.0])
    x /= np.linalg.norm(x)
    T = trans(place)
    T[:3, :3] = np.column_stack([x, np.cross(z, x), z])
    return T


def _add_stand(scene, T):
    foot = T[:3, 3] - 0.06 * T[:3, 2]
    ground = np.array([foot[0], foot[1], 0.0])
    scene.add(Stroke(np.array([ground, foot]), QUIET, 3.0, layer="shadow", gid="stand"))
    for turn in np.deg2rad([20, 140, 260]):
        leg = ground + 0.12 * np.array([np.cos(turn), np.sin(turn), 0])
        scene.add(Stroke(np.array([ground + [0, 0, 0.1], leg]), QUIET, 2.2, layer="shadow"))


def _add_board(scene, T):
    """A chequered board that lies on the table, its frame in one corner."""
    side, count = 0.055, 5
    whole = [[0, 0, 0], [side * count, 0, 0], [side * count, side * count, 0], [0, side * count, 0]]
    scene.add(Face(_moved(T, whole), "#ffffff", INK, layer="floor", gid="pattern"))
    for i in range(count):
        for j in range(count):
            if (i + j) % 2 == 0:
                square = side * (np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]) + [i, j, 0])
                scene.add(Face(_moved(T, square), INK, layer="shadow"))


def _add_way(scene, start, end, text, color, bow, dash="-"):
    """A bowed arrow from one frame's origin to another's, clear of both dots; ``bow`` is to the
    left of the way, as part of its length.
    """
    a, b = start[:3, 3], end[:3, 3]
    flat = np.array([(b - a) @ CAMERA.right, (b - a) @ CAMERA.up])
    aside = bow * (flat[0] * CAMERA.up - flat[1] * CAMERA.right)
    t = np.linspace(0.03, 0.97, 40)[:, None]
    path = (1 - t) ** 2 * a + 2 * t * (1 - t) * ((a + b) / 2 + 2 * aside) + t**2 * b
    scene.add(
        Stroke(path, color, 1.9, dash, "mark", head=10.0, casing=1.0, gid=f"way:{text}"),
        Label(path[20], text, aside, color, 14.0, math=True),
    )


def _moved(T, points):
    return np.asarray(points, dtype=float) @ T[:3, :3].T + T[:3, 3]
