"""Lesson 01, frames: reading, building and composing poses; base, flange and tool."""

import numpy as np

from ...transform import from_xyz_rpy, inverse, rot_x, rot_y, rot_z, trans
from ..kinds import Choice, Function, Option, Order, Prediction, Value

__all__ = ["EXERCISES"]


def _general_pose(rng, reach=0.5):
    """A pose without zeros and without right angles."""
    return from_xyz_rpy(rng.uniform(0.1, reach, 3) * rng.choice([-1, 1], 3), rng.uniform(0.3, 1.2, 3) * rng.choice([-1, 1], 3)).round(3)


def _draw_pose(rng):
    return {"T_01": from_xyz_rpy(rng.integers(1, 6, 3) / 10, np.deg2rad(rng.choice([20, 30, 40, 50, 60], 3))).round(3)}


def _misread_axis(T_01):
    yield "rotation-transposed", "this is the first row", T_01[0, :3]
    yield "rotation-block-misread", "this is the plate's y arrow", T_01[:3, 1]
    yield "rotation-block-misread", "this is the plate's z arrow", T_01[:3, 2]
    yield "rotation-block-misread", "this is the plate's origin", T_01[:3, 3]
    yield "rotation-transposed", "this is the second row", T_01[1, :3]
    yield "rotation-transposed", "this is the third row", T_01[2, :3]


def _draw_corner(rng):
    x, y, z = rng.integers(1, 9, 3) / 10
    return {"x": float(x), "y": float(y), "z": float(z)}


def _plate(x, y, z):
    """The plate of 01.2: its x arrow along y0, its z arrow up."""
    T = np.eye(4)
    T[:3, :3] = [[0, -1, 0], [1, 0, 0], [0, 0, 1]]
    T[:3, 3] = x, y, z
    return T


def _wrong_plates(x, y, z):
    T = _plate(x, y, z)
    yield "rotation-transposed", "", trans([x, y, z]) @ rot_z(-np.pi / 2)
    yield "matrix-transposed", "", T.T
    yield "pose-inverted", "", inverse(T)
    yield "mirror", "the y arrow", trans([x, y, z]) @ np.array([[0, 1, 0, 0], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
    yield "rotation-block-misread", "the plate is not turned: its x arrow still points along x0", trans([x, y, z])
    yield "length-unit", "", trans([1000 * x, 1000 * y, 1000 * z]) @ rot_z(np.pi / 2)
    yield "last-row-missing", "", np.vstack([T[:3], np.zeros(4)])
    yield "product-reversed", "the shift was made in the turned axes", rot_z(np.pi / 2) @ trans([x, y, z])
    yield "degrees-in-sin-cos", "", trans([x, y, z]) @ rot_z(90)
    yield "rotation-block-misread", "turned about x", trans([x, y, z]) @ rot_x(np.pi / 2)
    yield "rotation-block-misread", "turned about y", trans([x, y, z]) @ rot_y(np.pi / 2)


def _draw_chain(rng):
    return {"T_01": (trans([0.1, 0.2, 0.3]) @ rot_z(np.pi / 2)).round(6) + 0.0, "p_12": [float(v) for v in rng.integers(1, 6, 3) / 10]}


def _point_in_base(T_01, p_12):
    return T_01[:3, :3] @ p_12 + T_01[:3, 3]


def _wrong_points(T_01, p_12):
    R, p = T_01[:3, :3], T_01[:3, 3]
    yield "translations-not-rotated", "", p + p_12
    yield "rotation-transposed", "", R.T @ p_12 + p
    yield "product-stops-early", "the shift of {1} is missing", R @ p_12
    yield "product-starts-late", "the turn and the shift of {1} are missing", np.asarray(p_12)
    yield "pose-inverted", "", R.T @ (np.asarray(p_12) - p)
    yield "product-reversed", "", R @ (np.asarray(p_12) + p)
    yield "product-stops-early", "this is the origin of {1}", p


def _draw_tool(rng):
    return {"T_0F": _general_pose(rng, 0.7), "T_FT": (trans([0.0, round(float(rng.uniform(0.03, 0.06)), 3), round(float(rng.uniform(0.12, 0.2)), 3)])
                                                      @ rot_x(np.pi / 6)).round(4)}


def _wrong_tips(T_0F, T_FT):
    yield "wrong-frame-compared", "this is the flange, not the tool", T_0F[:3, 3]
    yield "translations-not-rotated", "", T_0F[:3, 3] + T_FT[:3, 3]
    yield "product-reversed", "", (T_FT @ T_0F)[:3, 3]
    yield "pose-inverted", "the tool's pose was inverted", (T_0F @ inverse(T_FT))[:3, 3]
    yield "pose-inverted", "the flange's pose was inverted", (inverse(T_0F) @ T_FT)[:3, 3]
    yield "pose-inverted", "", inverse(T_0F @ T_FT)[:3, 3]
    yield "wrong-frame-compared", "this is the tool in the flange, not in the base", T_FT[:3, 3]
    yield "rotation-transposed", "", T_0F[:3, :3].T @ T_FT[:3, 3] + T_0F[:3, 3]
    yield "length-unit", "", 1000 * (T_0F @ T_FT)[:3, 3]
    yield "rotation-block-misread", "this is the tool's z arrow", (T_0F @ T_FT)[:3, 2]


def _explain_chain(letters):
    if letters == ["d", "c", "b", "a"]:
        return "product-reversed", ""
    if set(letters) & {"e", "f"}:
        return "pose-inverted", "read the subscripts of what you used"
    return "product-reversed", "neighbouring subscripts must meet: …i, i…"


EXERCISES = [
    Prediction(id="01.P1", title="A plate turned about its x arrow", options={
        "a": "its z arrow points along y0", "b": "its z arrow points against y0", "c": "its z arrow still points up"},
        correct="b", outcome="a turn by +90° about x carries y to z and z to -y: the z arrow points against y0."),
    Value(id="01.1", title="Read an arrow", draw=_draw_pose, answer=lambda T_01: T_01[:3, 0], mistakes=_misread_axis,
          entries=("x0 coordinate", "y0 coordinate", "z0 coordinate"), tolerance=2e-3, praise="The first column is the plate's x arrow, written in the base.",
          hints=("A pose T_01 has four columns: three arrows and an origin. Which comes first?",
                 "Take the first three numbers of one column, from top to bottom.")),
    Value(id="01.2", title="Build a pose", points=2, draw=_draw_corner, answer=_plate, mistakes=_wrong_plates, tolerance=1e-6,
          praise="Three arrows as columns, the origin beside them, 0 0 0 1 below.",
          hints=("Write the arrows one by one as columns. You know x and z; the right hand gives y = z × x.",
                 "x points along y0, so the first column is 0 1 0. Stand in the base and ask where y must point for a right hand.")),
    Prediction(id="01.P2", title="Two poses in the other order", options={
        "a": "the plate ends at the same place, turned the same way", "b": "turned the same way, at another place", "c": "another place and turned another way"},
        correct="b", outcome="both turns are about z, so the directions agree; the shifts were made along different arrows, so the places differ. "
                             "With turns about different axes the directions differ as well."),
    Value(id="01.3", title="A point of the second plate, in the base", draw=_draw_chain, answer=_point_in_base, mistakes=_wrong_points,
          entries=("x0", "y0", "z0"), praise="Turn first, then shift.",
          hints=("The shift p_12 is written in plate 1's arrows. Where do these point in the base?",
                 "Turn p_12 with the rotation block first; what must be added to it then?")),
    Function(id="01.4", title="Compose two poses", points=2, draw=lambda rng: (_general_pose(rng), _general_pose(rng)), answer=lambda A, B: A @ B,
             names=("T_ab", "T_bc"), family="compose", praise="One product turns, shifts and keeps the last row, all at once.",
             hints=("Inner subscripts meet: T_ab and T_bc share b, and b disappears.",
                    "numpy's matrix product is @; the pose that is nearer to the base stands on the left.")),
    Order(id="01.5", title="From base to tool", length=4, items={"a": "T_01", "b": "T_12", "c": "T_2F", "d": "T_FT", "e": "T_TF", "f": "T_10"},
          accepts=lambda letters: letters == ["a", "b", "c", "d"], explain=_explain_chain, praise="Each inner pair meets: 0·1, 1·2, 2·F, F·T.",
          hints=("The product must begin with 0 and end with T.", "Neighbours must meet: after T_01 comes a pose that begins with 1.")),
    Choice(id="01.6", title="Why the camera never fits", correct="c", hints=(
        "Which two frames are both called “the end of the arm”?", "One side of the calibration was told where the flange is. What was the other side looking at?"),
        options={
            "a": Option("the camera was not level", "A tilted camera is no trouble: its tilt is one of the numbers that calibration finds.", "wrong-frame-compared"),
            "b": Option("the rotation matrices were transposed", "Then every pose is wrong, at the first look. Here each of the two sides was right in itself.",
                        "rotation-transposed"),
            "c": Option("the arm reported the flange, the pattern was measured at the tool tip",
                        "The tool's length turns with the wrist, so no constant camera pose can make up for it."),
            "d": Option("the poses were multiplied in the wrong order", "That would show at once with a single pose; here each pose taken alone was right.", "product-reversed"),
        }),
    Value(id="01.7", title="The tip of a gripper on an arm you have not seen", points=2, draw=_draw_tool, answer=lambda T_0F, T_FT: (T_0F @ T_FT)[:3, 3],
          mistakes=_wrong_tips, entries=("x0", "y0", "z0"), praise="Base to flange, flange to tool: the chain is the same on every arm.",
          hints=("Write the chain with its subscripts first: 0 to F, F to T.", "The tip is the origin of frame T: which column of T_0T is that?")),
]
