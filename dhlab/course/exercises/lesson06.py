"""Lesson 06, forward kinematics of a six-axis arm: from the table to the pose, zero offsets,
reading the structure.
"""

import numpy as np

from ...arm import Arm
from ...doctor.programs.cases import SPECIAL, general_chain
from ...doctor.programs.wrong.products import product
from ...table import DHTable
from ..kinds import Choice, Function, Option, Order, Prediction, Table, Value
from .answers06 import (
    ARTICLE,
    IN_THE_LOOP,
    OF_LENGTHS,
    STRUCTURES,
    draw_unseen,
    explain_lengths,
    explain_structures,
    unseen_pose,
    wrong_unseen,
    wrong_zero_poses,
    zero_pose,
)
from .offsets06 import UPRIGHT, wrong_offsets

__all__ = ["EXERCISES"]

EXERCISES = [
    Order(
        id="06.1",
        title="Five lengths of the arm",
        question="What are d1, a2, a3, d4, d6 on the arm? Five letters, in this order.",
        length=5,
        items={
            "forearm": "the forearm",
            "shoulder-height": "the height of the shoulder above the base",
            "wrist-to-tool": "from the wrist's centre to the tool point",
            "upper-arm": "the upper arm",
            "sideways": "the step sideways, along the axis of joint 4",
        },
        accepts=lambda parts: parts == list(OF_LENGTHS.values()),
        explain=explain_lengths,
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
        title="The pose at q = 0",
        answer=zero_pose,
        mistakes=wrong_zero_poses,
        units="pose",
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
        question="q = 0 gave (0.75, −0.2, 0.1). Where does q1 = 90° put it?",
        options={
            "turned": "(0.2, 0.75, 0.1)",
            "mirrored": "(−0.2, 0.75, 0.1)",
            "stays": "it stays, only the directions change",
        },
        correct="turned",
        outcome=(
            "the whole arm turns about z0: (x, y) goes to (-y, x), so (0.75, -0.2) goes to (0.2,"
            " 0.75)."
        ),
    ),
    Prediction(
        id="06.P2",
        title="The other convention, from memory",
        question="What did that program say at q = 0?",
        options={
            "other-place": "another place altogether",
            "one-sign": "the same pose but for one sign",
            "same": "exactly the same pose",
        },
        correct="one-sign",
        outcome=(
            "the rotation is right and the position is (0.75, -0.2, -0.1): one sign gives it away,"
            " and only if somebody looks."
        ),
    ),
    Choice(
        id="06.5",
        title="The fourth joint",
        question="What does joint 4 do, by the table?",
        correct="third-pitch",
        hints=(
            "Look at α2 and α3 in the table: what do they say of the axes of joints 2, 3 and 4?",
            "α = 0 means that the next z axis is parallel to this one.",
        ),
        options={
            "wrist-roll": Option(
                "it rolls the wrist about the forearm, as the text says",
                "Then its axis would lie along the forearm. Here it is parallel to the elbow's"
                " axis.",
                "structure-from-prose",
            ),
            "tool-roll": Option(
                "it turns the tool about its own axis",
                "That is joint 6: the last axis, along the tool.",
                "structure-from-prose",
            ),
            "third-pitch": Option(
                "it is a third pitch, with its axis parallel to those of joints 2 and 3",
                "α2 = α3 = 0: the three axes are parallel at every q, as on a UR arm.",
            ),
            "cannot-tell": Option(
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
        answer=lambda: Arm(DHTable.standard(UPRIGHT, angle="deg")),
        mistakes=wrong_offsets,
        in_lesson=(np.array(ARTICLE, dtype=float),),
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
        title="A program that is right at zero",
        draw=general_chain,
        special=SPECIAL["forward_kinematics"],
        answer=product,
        names=("rows", "q"),
        family="forward_kinematics",
        handed_out=lambda rows, q: product(rows, np.roll(q, 1)),
        praise="One index. At q = 0 nobody would have noticed.",
        words=IN_THE_LOOP,
        sparing=True,
        hints=(
            "The program is right when all q are equal. What could be mixed up, then?",
            "Print i and the q it uses, for the first row.",
        ),
    ),
    Value(
        id="06.10",
        title="The pose of an IRB 120",
        points=3,
        draw=draw_unseen,
        answer=unseen_pose,
        mistakes=wrong_unseen,
        units="pose",
        tolerance=1e-4,
        praise="An ABB IRB 120, with two offsets in its table.",
        hints=(
            "Which columns of the rows are in degrees, and which unit has q?",
            "Both angle columns and q go through np.deg2rad; the offsets stay in the rows.",
        ),
    ),
    Choice(
        id="06.4",
        practice=True,
        title="What the quarter turn proves",
        question="At q1 = 90° the position did turn about z0. Which conclusion is justified?",
        correct="program",
        hints=(
            "Write T = Rz(θ1) · M, where M holds everything else. What does turning q1 do to M?",
            "Change a length in the table and run the test again: does it notice?",
        ),
        options={
            "table": Option(
                "the table is right: the arm turned about z0 as it must",
                "Change any number of the table and the test still passes.",
                "only-zero-pose-checked",
            ),
            "program": Option(
                "the program turns about z0; the table may still be wrong",
                "T = Rz(θ1) · M for every table: the test is of the program alone.",
            ),
            "nothing": Option(
                "nothing at all",
                "It would catch a reversed product or degrees in sin and cos: it is a test of the"
                " program.",
                "product-reversed",
            ),
            "limits": Option(
                "q1 stays inside its limits",
                "Forward kinematics knows no limits.",
                "limits-in-forward",
            ),
        },
    ),
    Choice(
        id="06.8",
        practice=True,
        title="Far outside the limits",
        question="What comes back?",
        correct="right-pose",
        hints=(
            "Does any matrix of the product know about end stops?",
            "Put q2 = 500° into your function.",
        ),
        options={
            "right-pose": Option(
                "a pose, the right one for these angles; whether the arm may go there is another"
                " question",
                "The product takes any angle.",
            ),
            "error": Option(
                "an error: the pose cannot be reached",
                "No matrix of the product knows about end stops.",
                "limits-in-forward",
            ),
            "wrong-pose": Option(
                "a pose, but a wrong one: so the table can be checked this way",
                "The pose is right for those angles. It says nothing about the table.",
                "limits-in-forward",
            ),
        },
    ),
    Order(
        id="06.9",
        practice=True,
        title="Structures of four arms",
        question=(
            "A letter for each arm: the article's arm, the UR5e, the AR4, the Piper. A letter may"
            " come twice."
        ),
        length=4,
        repeats=True,
        items={
            "parallel": "axes 2, 3, 4 are parallel",
            "one-point": "axes 4, 5, 6 meet in one point",
            "both": "axes 2, 3, 4 are parallel, and axes 4, 5, 6 meet in one point",
            "neither": "neither parallel nor in one point",
        },
        accepts=lambda structures: structures == list(STRUCTURES.values()),
        explain=explain_structures,
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
]
