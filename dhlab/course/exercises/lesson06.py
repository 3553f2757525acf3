"""Lesson 06, forward kinematics of a six-axis arm: from the table to the pose, zero offsets,
reading the structure.
"""

import numpy as np

from ...arm import Arm
from ...doctor.programs.cases import SPECIAL, general_chain
from ...doctor.programs.wrong.products import WRONG_PRODUCTS, product
from ...robots import load
from ...table import DHTable
from ..kinds import Choice, Function, Option, Order, Prediction, Said, Table, Value

__all__ = ["EXERCISES"]

ARTICLE = [
    [0, 0.1, 0, 90],
    [0, 0, 0.4, 0],
    [0, 0, 0.35, 0],
    [0, 0.1, 0, 90],
    [0, 0, 0, -90],
    [0, 0.1, 0, 0],
]
UPRIGHT = [
    [0, 0.1, 0, 90],
    [90, 0, 0.4, 0],
    [-90, 0, 0.35, 0],
    [0, 0.1, 0, 90],
    [0, 0, 0, -90],
    [0, 0.1, 0, 0],
]


def _article_rows():
    return DHTable.standard(ARTICLE, angle="deg").rows


def _wrong_poses(rows, q):
    """What the wrong programs give for these rows and this q."""
    for mistake, place, version in WRONG_PRODUCTS:
        yield mistake, place, version(rows, q)


def _zero_pose():
    return product(_article_rows(), np.zeros(6))


def _wrong_zero_poses():
    yield from _wrong_poses(_article_rows(), np.zeros(6))
    in_degrees = _article_rows()
    in_degrees[:, 3] = np.rad2deg(in_degrees[:, 3])
    yield "alpha-in-degrees", "", product(in_degrees, np.zeros(6))


def _draw_unseen(rng):
    return {"q": (rng.integers(15, 60, 6) * rng.choice([-1, 1], 6)).astype(float)}


def _unseen_pose(q):
    return load("irb120").forward(np.deg2rad(q))


def _wrong_unseen(q):
    rows = load("irb120").table.rows
    twice = rows * [np.pi / 180, 1, 1, np.pi / 180]
    yield (
        "converted-to-radians-twice",
        Said(
            "the rows were converted twice",
            next="Run the cell that makes irb120 once more, then convert once.",
        ),
        product(twice, np.deg2rad(q)),
    )
    yield from _wrong_poses(rows, np.deg2rad(q))
    in_degrees = rows * [180 / np.pi, 1, 1, 180 / np.pi]
    yield "degrees-in-sin-cos", "the rows were left in degrees", product(in_degrees, np.deg2rad(q))
    yield "degrees-in-sin-cos", "rows and q were left in degrees", product(in_degrees, q)


ON_THE_ARM = {
    "d1": "d1 runs along the first joint's axis: follow z0 in the picture.",
    "a2": "a2 runs across, from axis 2 to axis 3: what lies between them?",
    "a3": "a3 runs across, from axis 3 to axis 4: what lies between them?",
    "d4": "d runs along a joint's axis: follow z3, then z5, in the picture.",
}  # d6 is never the only wrong one


def _explain_labels(letters):
    right = ["b", "d", "a", "e", "c"]
    wrong = [
        name
        for name, letter, wanted in zip(("d1", "a2", "a3", "d4", "d6"), letters, right)
        if letter != wanted
    ]
    mistake = "a-d-exchanged" if letters[0] == "d" or letters[1] == "b" else "length-value"
    headline = (
        f"{' and '.join(wrong)} are exchanged"
        if len(wrong) == 2
        else f"{', '.join(wrong)} are not in their places"
    )
    return mistake, Said(headline, next=ON_THE_ARM[wrong[0]])


SAYS = {
    "a": (True, False),
    "b": (False, True),
    "c": (True, True),
    "d": (False, False),
}  # axes 2, 3, 4 parallel; axes 4, 5, 6 in one point


def _explain_structures(letters):
    arms = ("the article's arm", "the UR5e", "the AR4", "the Piper")
    wrong = [
        (arm, letter, wanted)
        for arm, letter, wanted in zip(arms, letters, "cabb")
        if letter != wanted
    ]
    arm, letter, wanted = wrong[0]
    look = (
        "α2 and α3: are both 0"
        if SAYS[letter][0] != SAYS[wanted][0]
        else "a4, a5 and d5: are all three 0"
    )
    headline = "look again at " + " and ".join(
        filter(None, (", ".join(name for name, _, _ in wrong[:-1]), wrong[-1][0]))
    )
    return ("structure-from-prose" if arm in arms[:2] else "standard-rows-in-craig-matrix"), Said(
        headline, next=f"{arm[0].upper()}{arm[1:]}: look at {look}?"
    )


def _upright(offset_2, offset_3):
    rows = [list(row) for row in UPRIGHT]
    rows[1][0], rows[2][0] = offset_2, offset_3
    return Arm(DHTable.standard(rows, angle="deg"))


STANDS = {
    0: "is level, pointing forward",
    90: "points straight up",
    180: "is level, pointing backward",
    270: "points straight down",
}  # by its angle to the floor


def _wrong_offsets():
    """The offsets of 06.6 in radians, and in other quarter turns: what the arm then looks like
    where the encoders read 0.
    """
    radians = Said(
        "the offsets look like radians", next="This table is in degrees: 90, not 1.5708."
    )
    for quarter in (np.pi / 2, 1.57, 1.571, 1.5708):
        for signs in ((1, -1), (1, 0), (0, -1), (1, 1), (-1, 1), (-1, -1), (-1, 0), (0, 1)):
            yield "angle-unit", radians, _upright(signs[0] * quarter, signs[1] * quarter)
    for offset_2 in STANDS:
        for offset_3 in STANDS:
            if (offset_2, offset_3) != (90, 270):
                yield (
                    _offset_mistake(offset_2, offset_3),
                    _seen(offset_2, offset_3),
                    _upright(offset_2, offset_3),
                )


def _offset_mistake(offset_2, offset_3):
    if offset_2 == 0 and offset_3 in (0, 270) or (offset_2, offset_3) == (90, 0):
        return "offset-missing"
    if (offset_2, offset_3) in ((90, 90), (270, 270), (270, 90)):
        return "offset-sign"
    return (
        "offset-counted-twice"
        if (offset_2, offset_3) in ((90, 180), (180, 270))
        else "offset-value"
    )


def _seen(offset_2, offset_3):
    if offset_2 != 90:
        return Said(
            f"where the encoders read 0, your upper arm {STANDS[offset_2]}",
            next="It must point straight up there; positive q2 lifts it from the level.",
        )
    return Said(
        "the upper arm is right; where the encoders read 0, your forearm"
        f" {STANDS[(offset_2 + offset_3) % 360]}",
        next=(
            "θ3 is measured from the upper arm, not from the floor. With the arm up, which θ3 makes"
            " the forearm level?"
        ),
    )


IN_THE_LOOP = {  # two slips of Python, by the place that the doctor names
    ("product-starts-late", "only the last row is used"): Said(
        "only the last row's matrix comes out",
        next="Each turn of the loop throws the product away: write T = T @ A.",
    ),
    ("product-stops-early", "only the first row is used"): Said(
        "only the first row's matrix comes out",
        next="Is the return inside the loop? It belongs behind it.",
    ),
}

EXERCISES = [
    Order(
        id="06.1",
        title="What each length is on the arm",
        length=5,
        items={
            "a": "the forearm",
            "b": "the height of the shoulder above the base",
            "c": "from the wrist's centre to the tool point",
            "d": "the upper arm",
            "e": "the step sideways, along the wrist's first axis",
        },
        accepts=lambda letters: letters == ["b", "d", "a", "e", "c"],
        explain=_explain_labels,
        praise="d runs along a joint axis, a across from one axis to the next.",
        hints=(
            "d is measured along z, a along x. Which of the five parts lie along a joint's axis?",
            "Walk along the chain from the base: up, out, out, sideways, out to the tool.",
        ),
    ),
    Function(
        id="06.2",
        title="Forward kinematics",
        points=3,
        draw=general_chain,
        special=SPECIAL["forward_kinematics"],
        answer=product,
        names=("rows", "q"),
        family="forward_kinematics",
        praise="One loop, one product, any number of joints.",
        words=IN_THE_LOOP,
        hints=(
            "Start from np.eye(4) and walk over rows and q together.",
            (
                "A row's θ is its offset plus its q. Each new link is seen from the last frame, so"
                " its matrix joins on the right."
            ),
        ),
    ),
    Value(
        id="06.3",
        title="The zero pose",
        answer=_zero_pose,
        mistakes=_wrong_zero_poses,
        tolerance=1e-6,
        praise=(
            "Position (0.75, -0.2, 0.1), as the article has it; the tool's z arrow points along"
            " -y0."
        ),
        hints=(
            "Which two things does your forward_kinematics want?",
            "`rows` is converted already; q is six zeros.",
        ),
    ),
    Prediction(
        id="06.P1",
        title="A quarter turn of the base",
        options={
            "a": "(0.2, 0.75, 0.1)",
            "b": "(-0.2, 0.75, 0.1)",
            "c": "(0.75, -0.2, 0.1): only the directions change",
        },
        correct="a",
        outcome=(
            "the whole arm turns about z0: (x, y) goes to (-y, x), so (0.75, -0.2) goes to (0.2,"
            " 0.75)."
        ),
    ),
    Choice(
        id="06.4",
        title="What the quarter turn proves",
        correct="b",
        hints=(
            "Write T = Rz(θ1) · M, where M holds everything else. What does turning q1 do to M?",
            "Change a length in the table and run the test again: does it notice?",
        ),
        options={
            "a": Option(
                "the table is right: the arm turned about z0 as it must",
                "Change any number of the table and the test still passes.",
                "only-zero-pose-checked",
            ),
            "b": Option(
                "the program turns about z0; the table may still be wrong",
                "T = Rz(θ1) · M for every table: the test is of the program alone.",
            ),
            "c": Option(
                "nothing at all",
                "It would catch a reversed product or degrees in sin and cos: it is a test of the"
                " program.",
                "product-reversed",
            ),
            "d": Option(
                "q1 stays inside its limits",
                "Forward kinematics knows no limits.",
                "limits-in-forward",
            ),
        },
    ),
    Prediction(
        id="06.P2",
        title="The same rows in Craig's matrix, at q = 0",
        options={
            "a": "another place altogether",
            "b": "the same pose but for one sign",
            "c": "exactly the same pose",
        },
        correct="b",
        outcome=(
            "the rotation is right and the position is (0.75, -0.2, -0.1): one sign gives it away,"
            " and only if somebody looks."
        ),
    ),
    Choice(
        id="06.5",
        title="What joint 4 does",
        correct="c",
        hints=(
            "Look at α2 and α3 in the table: what do they say of the axes of joints 2, 3 and 4?",
            "α = 0 means that the next z axis is parallel to this one.",
        ),
        options={
            "a": Option(
                "it rolls the wrist about the forearm, as the text says",
                "Then its axis would lie along the forearm. Here it is parallel to the elbow's"
                " axis.",
                "structure-from-prose",
            ),
            "b": Option(
                "it turns the tool about its own axis",
                "That is joint 6: the last axis, along the tool.",
                "structure-from-prose",
            ),
            "c": Option(
                "it is a third pitch, with its axis parallel to those of joints 2 and 3",
                "α2 = α3 = 0: the three axes are parallel at every q, as on a UR arm.",
            ),
            "d": Option(
                "a table cannot tell",
                "It does: α is the angle between neighbouring axes, at every q.",
                "only-zero-pose-checked",
            ),
        },
    ),
    Table(
        id="06.6",
        title="An encoder that reads 0 elsewhere",
        points=2,
        answer=Arm(DHTable.standard(UPRIGHT, angle="deg")),
        mistakes=_wrong_offsets,
        praise="Offsets go into the θ column, and every right table passes, this one or another.",
        hints=(
            "Where does θ2 stand when the upper arm points straight up?",
            (
                "Turn your article arm to the encoder's zero: which q2 and q3 lift the upper arm"
                " and keep the forearm level? Those are the offsets."
            ),
        ),
    ),
    Function(
        id="06.7",
        title="The smallest fix: right at zero only",
        draw=general_chain,
        special=SPECIAL["forward_kinematics"],
        answer=product,
        names=("rows", "q"),
        family="forward_kinematics",
        handed_out=lambda rows, q: product(rows, np.roll(q, 1)),
        praise="One index. At q = 0 nobody would have noticed.",
        words=IN_THE_LOOP,
        hints=(
            "The program is right when all q are equal. What could be mixed up, then?",
            "Print i and the q it uses, for the first row.",
        ),
    ),
    Choice(
        id="06.8",
        title="Far outside the limits",
        correct="a",
        hints=(
            "Does any matrix of the product know about end stops?",
            "Put q2 = 500° into your function.",
        ),
        options={
            "a": Option(
                "a pose, the right one for these angles; whether the arm may go there is another"
                " question",
                "The product takes any angle.",
            ),
            "b": Option(
                "an error: the pose cannot be reached",
                "No matrix of the product knows about end stops.",
                "limits-in-forward",
            ),
            "c": Option(
                "a pose, but a wrong one: so the table can be checked this way",
                "The pose is right for those angles. It says nothing about the table.",
                "limits-in-forward",
            ),
        },
    ),
    Order(
        id="06.9",
        title="Structures of four arms",
        length=4,
        repeats=True,
        items={
            "a": "axes 2, 3, 4 are parallel",
            "b": "axes 4, 5, 6 meet in one point",
            "c": "both of these",
            "d": "neither of these",
        },
        accepts=lambda letters: letters == ["c", "a", "b", "b"],
        explain=_explain_structures,
        praise=(
            "Parallel axes come from α, meeting ones from lengths that are 0. The UR5e has a length"
            " where the others have none."
        ),
        hints=(
            "Two rows decide the first question: α2 and α3. Are both 0?",
            (
                "For the second look at a4, a5 and d5 of the standard rows. On which arm is one of"
                " them not 0?"
            ),
        ),
    ),
    Value(
        id="06.10",
        title="An arm you have not seen",
        points=3,
        draw=_draw_unseen,
        answer=_unseen_pose,
        mistakes=_wrong_unseen,
        tolerance=1e-6,
        praise="An ABB IRB 120, with two offsets in its table.",
        hints=(
            "Which columns of the rows are in degrees, and which unit has q?",
            "Both angle columns and q go through np.deg2rad; the offsets stay in the rows.",
        ),
    ),
]
