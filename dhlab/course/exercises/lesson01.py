"""Lesson 01, frames: reading, building and composing poses; base, flange and tool."""

import numpy as np

from ...transform import from_xyz_rpy, inverse, rot_x, rot_y, rot_z, trans
from ..kinds import Choice, Function, Option, Order, Prediction, Said, Value
from .shaped_value import ShapedValue, as_numbers, is_array_of

__all__ = ["EXERCISES"]


def _general_pose(rng, reach=0.5):
    """A pose without zeros and without right angles."""
    return from_xyz_rpy(
        rng.uniform(0.1, reach, 3) * rng.choice([-1, 1], 3),
        rng.uniform(0.3, 1.2, 3) * rng.choice([-1, 1], 3),
    ).round(3)


def _draw_pose(rng):
    return {
        "T_01": (
            from_xyz_rpy(
                rng.integers(1, 6, 3) / 10, np.deg2rad(rng.choice([20, 30, 40, 50, 60], 3))
            ).round(3)
        )
    }


def _a_row(which):
    return Said(
        f"this is the {which} row; the plate's arrows are columns",
        why="The rows say where the base's arrows are, seen from the plate.",
        next="Which column is the x arrow? Take it from top to bottom.",
    )


def _misread_axis(T_01):
    yield "rotation-transposed", _a_row("first"), T_01[0, :3]
    yield "rotation-block-misread", "this is the plate's y arrow", T_01[:3, 1]
    yield "rotation-block-misread", "this is the plate's z arrow", T_01[:3, 2]
    yield "rotation-block-misread", "this is the plate's origin", T_01[:3, 3]
    yield "rotation-transposed", _a_row("second"), T_01[1, :3]
    yield "rotation-transposed", _a_row("third"), T_01[2, :3]


STANDING = Said(
    "the right numbers, but one below the other",
    next=(
        "Three numbers in a row are asked: end the line with .ravel(), or take the column as [:3,"
        " k] with a plain number k."
    ),
)


def _misshapen_axis(answer, T_01):
    array = as_numbers(answer)
    if is_array_of(array.ravel(), T_01[:, 0]):
        return None, Said(
            "the last 0 is not part of the arrow",
            next="An arrow is three numbers: [:3] takes the first three.",
        )
    if is_array_of(array.ravel(), T_01[0]):
        return "rotation-transposed", _a_row("first")
    if array.ndim == 2 and is_array_of(array.ravel(), T_01[:3, 0]):
        return None, STANDING
    return None


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
    yield (
        "pose-inverted",
        Said(
            "this is the inverse: where the base is, seen from the camera plate",
            next="Every arrow, and the origin, is written in the base.",
        ),
        inverse(T),
    )
    yield (
        "mirror",
        "the y arrow",
        trans([x, y, z]) @ np.array([[0, 1, 0, 0], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]),
    )
    yield (
        "rotation-block-misread",
        Said(
            "the plate is not turned: its x arrow still points along x0",
            next="The first column is the x arrow, in the base: along y0.",
        ),
        trans([x, y, z]),
    )
    yield "length-unit", "", trans([1000 * x, 1000 * y, 1000 * z]) @ rot_z(np.pi / 2)
    yield "last-row-missing", "", np.vstack([T[:3], np.zeros(4)])
    yield (
        "product-reversed",
        Said(
            "the shift was made along the turned arrows",
            why="(x, y, z) is written in the base.",
            next=(
                "The fourth column is x, y, z as they are; of a product, the shift stands on the"
                " left."
            ),
        ),
        rot_z(np.pi / 2) @ trans([x, y, z]),
    )
    yield (
        "degrees-in-sin-cos",
        Said(
            "90 was taken for radians",
            why="numpy and from_xyz_rpy take angles in radians.",
            next="np.deg2rad(90), or np.pi / 2.",
        ),
        trans([x, y, z]) @ rot_z(90),
    )
    yield (
        "rotation-block-misread",
        Said(
            "turned about x: the z arrow no longer points up",
            next="Which arrow stays where it was?",
        ),
        trans([x, y, z]) @ rot_x(np.pi / 2),
    )
    yield (
        "rotation-block-misread",
        Said(
            "turned about y: the z arrow no longer points up",
            next="Which arrow stays where it was?",
        ),
        trans([x, y, z]) @ rot_y(np.pi / 2),
    )


def _draw_chain(rng):
    return {
        "T_01": (trans([0.1, 0.2, 0.3]) @ rot_z(np.pi / 2)).round(6) + 0.0,
        "p_12": [float(v) for v in rng.integers(1, 6, 3) / 10],
    }


def _point_in_base(T_01, p_12):
    return T_01[:3, :3] @ p_12 + T_01[:3, 3]


TURN = "p_0 = R_01 p_1 + p_01: turn, then shift."


def _wrong_points(T_01, p_12):
    R, p = T_01[:3, :3], T_01[:3, 3]
    yield (
        "translations-not-rotated",
        Said(
            "the two shifts were added, and p_12 was not turned",
            why="p_12 is written in plate 1's arrows.",
            next=TURN,
        ),
        p + p_12,
    )
    yield (
        "rotation-transposed",
        Said(
            "p_12 was turned the wrong way: the columns of R were used where its rows belong",
            next="R stands on the left of @, and not transposed.",
        ),
        R.T @ p_12 + p,
    )
    yield "product-stops-early", Said("the shift of plate 1 is missing", next=TURN), R @ p_12
    yield (
        "product-starts-late",
        Said("this is p_12 itself, still written in plate 1", next=TURN),
        np.asarray(p_12),
    )
    yield (
        "pose-inverted",
        Said("this goes the other way: from the base into plate 1", next=TURN),
        R.T @ (np.asarray(p_12) - p),
    )
    yield (
        "product-reversed",
        Said(
            "you shifted first and then turned",
            why="p_01 is written in the base's arrows already, and needs no turn.",
            next=TURN,
        ),
        R @ (np.asarray(p_12) + p),
    )
    yield (
        "product-stops-early",
        Said("this is the origin of plate 1; p_12 was not used", next=TURN),
        p,
    )


def _misshapen_point(answer, T_01, p_12):
    array = as_numbers(answer)
    if is_array_of(array.ravel(), [*_point_in_base(T_01, p_12), 1]):
        return None, Said(
            "the place is right, but the 1 at the end is not part of it",
            next="Three numbers are asked: [:3] takes the first three.",
        )
    if is_array_of(array.ravel(), [*(T_01[:3, :3] @ p_12), 0]):
        return "product-stops-early", Said(
            "the shift of plate 1 is missing",
            why="With a 0 in fourth place T_01 only turns.",
            next="Append a 1 to a point, and take three numbers of the result.",
        )
    if array.ndim == 2 and is_array_of(array.ravel(), _point_in_base(T_01, p_12)):
        return None, STANDING
    if is_array_of(array, T_01[:3, :3] * p_12 + T_01[:3, 3]):
        return "elementwise-product", Said(
            "multiplied entry by entry, with * in place of @",
            next="@ takes each row of R against the whole of p_12, and adds up.",
        )
    return None


def _draw_tool(rng):
    return {
        "T_0F": _general_pose(rng, 0.7),
        "T_FT": (
            (
                trans(
                    [
                        0.0,
                        round(float(rng.uniform(0.03, 0.06)), 3),
                        round(float(rng.uniform(0.12, 0.2)), 3),
                    ]
                )
                @ rot_x(np.pi / 6)
            ).round(4)
        ),
    }


CHAIN = "Write the chain with its subscripts: 0 to F, F to T."


def _wrong_tips(T_0F, T_FT):
    R, p, t = T_0F[:3, :3], T_0F[:3, 3], T_FT[:3, 3]
    yield (
        "wrong-frame-compared",
        Said(
            "this is the flange's origin, not the tip",
            next="The tip is a step further: which pose leads from F to T?",
        ),
        p,
    )
    yield (
        "translations-not-rotated",
        Said(
            "the two shifts were added, and the tool's was not turned",
            why="The tool's shift is written in the flange's arrows.",
            next=CHAIN,
        ),
        p + t,
    )
    yield (
        "product-reversed",
        Said(
            "the two poses are multiplied in the reverse order",
            next="The inner subscripts must meet. " + CHAIN,
        ),
        (T_FT @ T_0F)[:3, 3],
    )
    yield (
        "pose-inverted",
        Said("the tool's pose was inverted", next="T_FT is T written in F, as it is needed."),
        (T_0F @ inverse(T_FT))[:3, 3],
    )
    yield (
        "pose-inverted",
        Said("the flange's pose was inverted", next="T_0F is F written in 0, as it is needed."),
        (inverse(T_0F) @ T_FT)[:3, 3],
    )
    yield (
        "pose-inverted",
        Said(
            "this is the base's origin, seen from the tool",
            next="T in 0 is asked, not 0 in T. No inverse is needed.",
        ),
        inverse(T_0F @ T_FT)[:3, 3],
    )
    yield (
        "wrong-frame-compared",
        Said("this is the tip in the flange's arrows, not in the base's", next=CHAIN),
        t,
    )
    yield (
        "product-stops-early",
        Said(
            "the way from the base to the flange is missing",
            next="The tool's shift is turned rightly. What must be added to it?",
        ),
        R @ t,
    )
    yield (
        "product-reversed",
        Said(
            "you shifted first and then turned",
            why="The flange's place is written in the base already, and needs no turn.",
            next="Turn the tool's shift, then add.",
        ),
        R @ (p + t),
    )
    yield (
        "rotation-transposed",
        Said(
            "the tool's shift was turned the wrong way: the columns of R were used where its rows"
            " belong",
            next="R stands on the left of @, and not transposed.",
        ),
        R.T @ t + p,
    )
    yield (
        "length-unit",
        Said(
            "these are millimetres, and metres are asked",
            next="T_0F and T_FT are in metres already.",
        ),
        1000 * (T_0F @ T_FT)[:3, 3],
    )
    yield "rotation-block-misread", "this is the tool's z arrow", (T_0F @ T_FT)[:3, 2]


def _misshapen_tip(answer, T_0F, T_FT):
    array, right = as_numbers(answer), T_0F @ T_FT
    if is_array_of(array.ravel(), right[:, 3]):
        return None, Said(
            "the place is right, but the 1 at the end is not part of it",
            next="Three numbers are asked: [:3] takes the first three.",
        )
    if is_array_of(array, right):
        return None, Said(
            "this is the tool's whole pose, and its origin is asked",
            next="Which column of T_0T is the origin?",
        )
    if array.ndim == 2 and is_array_of(array.ravel(), right[:3, 3]):
        return None, STANDING
    return None


MEET = "The inner subscripts must meet: a·b, b·c."
COMPOSED = {
    "product-reversed": Said(
        "the two poses are multiplied in the reverse order",
        why="The right-hand pose is written in the frame that the left-hand one leads to.",
        next=MEET,
    ),
    "translations-not-rotated": Said(
        "the shifts were added up, and the second was not turned",
        why="The second shift is written in frame b's arrows.",
        next="One matrix product of the whole 4×4 matrices turns and shifts.",
    ),
    "pose-inverted": Said(
        "a pose was inverted, and none needs to be",
        next="Say them aloud: b written in a, c written in b. Asked is c written in a.",
    ),
    "matrix-transposed": Said(
        "a whole 4×4 was transposed",
        why="A pose has its origin in the last column and 0 0 0 1 below.",
        next="Multiply the two as they are.",
    ),
    "product-stops-early": Said("this is T_ab alone, T_bc was not used", next=MEET),
    "product-starts-late": Said("this is T_bc alone, T_ab was not used", next=MEET),
}
LINKS = {"a": "T_01", "b": "T_12", "c": "T_2F", "d": "T_FT", "e": "T_TF", "f": "T_10"}


def _explain_chain(letters):
    if letters == ["d", "c", "b", "a"]:
        return "product-reversed", Said(
            "the four are right, in the reverse order",
            next="The pose nearest to the base stands on the left.",
        )
    poses = [LINKS[letter] for letter in letters]
    apart = next(
        (
            f"{one}, then {two}: {one[3]} does not meet {two[2]}"
            for one, two in zip(poses, poses[1:])
            if one[3] != two[2]
        ),
        "",
    )
    ends = f"the product begins with {poses[0][2]} and ends with {poses[-1][3]}"
    turned = [pose for pose in poses if pose in ("T_TF", "T_10")]
    if turned:
        return "pose-inverted", Said(
            f"{' and '.join(turned)}: an inverse, which is not needed",
            place=apart or ends,
            next="After T_01 comes a pose that begins with 1, and so on to T.",
        )
    return "product-reversed", Said(
        "two neighbours do not meet",
        place=apart,
        next="Begin with 0. After T_01 comes a pose that begins with 1.",
    )


EXERCISES = [
    Prediction(
        id="01.P1",
        title="A plate turned about its x arrow",
        options={
            "a": "its z arrow points along y0",
            "b": "its z arrow points against y0",
            "c": "its z arrow still points up",
        },
        correct="b",
        outcome="a turn by +90° about x carries y to z and z to -y: the z arrow points against y0.",
    ),
    ShapedValue(
        id="01.1",
        title="Read an arrow",
        draw=_draw_pose,
        answer=lambda T_01: T_01[:3, 0],
        mistakes=_misread_axis,
        misshapen=_misshapen_axis,
        entries=("x0 coordinate", "y0 coordinate", "z0 coordinate"),
        tolerance=2e-3,
        praise="The first column is the plate's x arrow, written in the base.",
        hints=(
            "A pose T_01 has four columns: three arrows and an origin. Which comes first?",
            "Take the first three numbers of one column, from top to bottom.",
        ),
    ),
    Value(
        id="01.2",
        title="Build a pose",
        points=2,
        draw=_draw_corner,
        answer=_plate,
        mistakes=_wrong_plates,
        tolerance=1e-6,
        praise="Three arrows as columns, the origin beside them, 0 0 0 1 below.",
        hints=(
            (
                "Write the arrows one by one as columns. You know x and z; the right hand gives y ="
                " z × x."
            ),
            (
                "x points along y0, so the first column is 0 1 0. Stand in the base and ask where y"
                " must point for a right hand."
            ),
        ),
    ),
    Prediction(
        id="01.P2",
        title="Two poses in the other order",
        options={
            "a": "the plate ends at the same place, turned the same way",
            "b": "turned the same way, at another place",
            "c": "another place and turned another way",
        },
        correct="b",
        outcome=(
            "both turns are about z, so the directions agree; the shifts were made along different"
            " arrows, so the places differ. With turns about different axes the directions differ"
            " as well."
        ),
    ),
    ShapedValue(
        id="01.3",
        title="A point of the second plate, in the base",
        draw=_draw_chain,
        answer=_point_in_base,
        mistakes=_wrong_points,
        misshapen=_misshapen_point,
        entries=("x0", "y0", "z0"),
        praise="Turn first, then shift.",
        hints=(
            "The shift p_12 is written in plate 1's arrows. Where do these point in the base?",
            "Turn p_12 with the rotation block first; what must be added to it then?",
        ),
    ),
    Function(
        id="01.4",
        title="Compose two poses",
        points=2,
        draw=lambda rng: (_general_pose(rng), _general_pose(rng)),
        answer=lambda A, B: A @ B,
        names=("T_ab", "T_bc"),
        family="compose",
        words=COMPOSED,
        praise="One product turns, shifts and keeps the last row, all at once.",
        hints=(
            "Inner subscripts meet: T_ab and T_bc share b, and b disappears.",
            "numpy's matrix product is @; the pose that is nearer to the base stands on the left.",
        ),
    ),
    Order(
        id="01.5",
        title="From base to tool",
        length=4,
        items=LINKS,
        accepts=lambda letters: letters == ["a", "b", "c", "d"],
        explain=_explain_chain,
        praise="Each inner pair meets: 0·1, 1·2, 2·F, F·T.",
        hints=(
            "The product must begin with 0 and end with T.",
            "Neighbours must meet: after T_01 comes a pose that begins with 1.",
        ),
    ),
    Choice(
        id="01.6",
        title="Why the camera never fits",
        correct="c",
        hints=(
            "Which two frames are both called “the end of the arm”?",
            (
                "One side of the calibration was told where the flange is. What was the other side"
                " looking at?"
            ),
        ),
        options={
            "a": Option(
                "the camera was not level",
                "A tilted camera is no trouble: its tilt is one of the numbers that calibration"
                " finds.",
                "wrong-frame-compared",
            ),
            "b": Option(
                "the rotation matrices were transposed",
                "Then every pose is wrong, at the first look. Here each of the two sides was right"
                " in itself.",
                "rotation-transposed",
            ),
            "c": Option(
                "the arm reported the flange, the pattern was measured at the tool tip",
                "The tool's length turns with the wrist, so no constant camera pose can make up"
                " for it.",
            ),
            "d": Option(
                "the poses were multiplied in the wrong order",
                "That would show at once with a single pose; here each pose taken alone was right.",
                "product-reversed",
            ),
        },
    ),
    ShapedValue(
        id="01.7",
        title="The tip of a gripper on an arm you have not seen",
        points=2,
        draw=_draw_tool,
        answer=lambda T_0F, T_FT: (T_0F @ T_FT)[:3, 3],
        mistakes=_wrong_tips,
        misshapen=_misshapen_tip,
        entries=("x0", "y0", "z0"),
        praise="Base to flange, flange to tool: the chain is the same on every arm.",
        hints=(
            "Write the chain with its subscripts first: 0 to F, F to T.",
            "The tip is the origin of frame T: which column of T_0T is that?",
        ),
    ),
]
