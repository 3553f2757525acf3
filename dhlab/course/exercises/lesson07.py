"""Lesson 07, troubleshooting: from a symptom to its cause, by hand and with the doctor; three ways
to check a table; zero offsets.
"""

import numpy as np
from scipy.spatial.transform import Rotation

from ...arm import Arm
from ...doctor.programs.cases import SPECIAL, general_chain
from ...doctor.programs.wrong.links import standard
from ...doctor.programs.wrong.products import product
from ...robots import load
from ...table import DHTable
from ..kinds import Choice, Function, Option, Order, Prediction, Said, Value
from ..kinds.repaired import Impostor, Repair
from .lesson06 import ARTICLE

__all__ = ["EXERCISES"]

COARSE, FINE, TURN = (
    5e-4,
    3e-4,
    2e-3,
)  # noise: half a millimetre, a third of one, a tenth of a degree
PUMA = [
    [0, 0.67183, 0, 90],
    [0, 0, 0.4318, 0],
    [0, 0.15005, 0.0203, -90],
    [0, 0.4318, 0, 90],
    [0, 0, 0, -90],
    [0, 0, 0, 0],
]
CAUSES = {
    "a": ("the base's height is missing", "base-height-missing-or-twice"),
    "b": ("degrees passed to sin and cos", "degrees-in-sin-cos"),
    "c": ("the tool is left out", "tool-missing"),
    "d": ("a joint limit is exceeded", "limits-in-forward"),
    "e": ("one length (a) has the wrong value", "length-value"),
    "f": ("a zero offset is left out", "offset-missing"),
    "g": ("a joint counts the other way", "joint-reversed"),
}
OF_SYMPTOMS = ["b", "e", "g", "a", "c", "f"]
TRACES = {
    "a": "seen from the base, every pose would be shifted by one and the same vector",
    "b": "a small turn of a joint would become a leap, since 1 would be taken for 57°",
    "c": "seen from the last frame, every pose would be shifted by one and the same vector",
    "d": "no trace at all; forward kinematics has a pose for any q",
    "e": (
        "the rotation would be right, and the residual would lie along one arrow of the arm at"
        " every pose"
    ),
    "f": "every pose would be right once a joint is turned by a constant",
    "g": "at q = 0 all is well, and one joint turns the wrong way from there",
}


def _article():
    return Arm(DHTable.standard(ARTICLE, angle="deg"))


def _general(rng, m, arm):
    """Configurations (m, n) in whole degrees, none near 0 or 90°, the arm above the floor; as
    radians.
    """
    q = np.deg2rad(
        rng.integers(15, 76, (60 * m, len(arm))) * rng.choice([-1, 1], (60 * m, len(arm)))
    )
    return q[(arm.frames(q)[:, 1:, 2, 3] > 0.05).all(axis=1)][:m]


def _points(rng, arm, q, noise):
    return arm.forward(q)[:, :3, 3] + rng.normal(0, noise, (len(q), 3))


def _poses(rng, arm, q, noise, turn):
    T = arm.forward(q)
    T[:, :3, 3] += rng.normal(0, noise, (len(q), 3))
    T[:, :3, :3] = T[:, :3, :3] @ Rotation.from_rotvec(rng.normal(0, turn, (len(q), 3))).as_matrix()
    return T


def _explain_match(letters):
    """The first wrong cause, and what it would have looked like."""
    k, letter = next(
        (k, letter)
        for k, (letter, right) in enumerate(zip(letters, OF_SYMPTOMS))
        if letter != right
    )
    cause, mistake = CAUSES[letter]
    return mistake, Said(
        f"symptom {k + 1} is not {letter}",
        why=f"“{cause}” would look like this: {TRACES[letter]}. Does symptom {k + 1} say that?",
    )


def _two_sources(rows, q):
    """The broken program of 07.2: alpha is converted a second time."""
    return product(
        rows, q, link=lambda theta, d, a, alpha: standard(theta, d, a, np.deg2rad(alpha))
    )


def _draw_length(rng):
    rows = np.array(ARTICLE, dtype=float)
    i, k = [(0, 1), (2, 2), (5, 1)][rng.integers(3)]
    rows[i, k] = round(rows[i, k] + rng.choice([-1, 1]) * rng.integers(3, 7) / 100, 2)
    q = _general(rng, 8, _article())
    return {"rows": rows, "q": q, "points": _points(rng, _article(), q, FINE)}


def _story(rng):
    """The arm that missed the cup; the same for every learner."""
    rng, real = np.random.default_rng(3), _article()
    rows = np.array(ARTICLE, dtype=float)
    rows[3, 3] = -90
    log = _general(rng, 8, real)
    sweeps = np.tile(np.deg2rad([30, 60, -80, -30, 40, 20]), (6 * 13, 1))
    for i in range(6):
        sweeps[13 * i : 13 * (i + 1), i] = np.deg2rad(np.linspace(-60, 60, 13))
    return {
        "rows": rows,
        "q": log,
        "poses": _poses(rng, real, log, COARSE, TURN),
        "sweeps": sweeps,
        "points": _points(rng, real, sweeps, COARSE),
    }


def _draw_offsets(rng):
    """Offsets of joints 2 and 3, half degrees; the caller sees only what was measured."""
    offsets = np.zeros(6)
    offsets[1:3] = np.deg2rad(
        rng.permutation([2.5, 3.0, 3.5, 4.5, 5.0, 5.5, 6.0])[:2] * rng.choice([-1, 1], 2)
    )
    q = _general(rng, 20, _article())
    return {"q": q, "points": _points(rng, _article(), q + offsets, COARSE)}


def _offsets_of(q, points):
    """Offsets of joints 2 and 3 in degrees: the half degrees that fit best, all others being 0."""
    from ...measure import calibrate_offsets

    return (
        np.round(
            2 * np.rad2deg(calibrate_offsets(_article(), q, points, noise=COARSE).offsets[1:3])
        )
        / 2
    )


def _wrong_offsets(q, points):
    from ...measure import calibrate_offsets

    right, measured = (
        _offsets_of(q, points),
        np.rad2deg(calibrate_offsets(_article(), q, points, base="fixed").offsets),
    )
    yield "offset-sign", "model minus measurement, where measurement minus model was asked", -right
    yield "offset-on-wrong-joint", "joints 2 and 3 have changed places", right[::-1]
    yield (
        "offset-missing",
        Said(
            "neither offset is 0",
            next="Look into found.offsets: one number per joint, joint 1 first.",
        ),
        np.zeros(2),
    )
    yield "offset-counted-twice", "", 2 * right
    yield (
        "converted-to-radians-twice",
        Said(
            "these are radians; degrees were asked", next="np.rad2deg turns the one into the other."
        ),
        np.deg2rad(right),
    )
    yield "offset-missing", Said("joint 3 has an offset too"), [right[0], 0]
    yield "offset-missing", Said("joint 2 has an offset too"), [0, right[1]]
    for names, found in (
        ("1 and 2", measured[:2]),
        ("1 and 2", [0, right[0]]),
        ("3 and 4", measured[2:4]),
        ("3 and 4", [right[1], 0]),
    ):
        yield (
            "joint-index-off-by-one",
            Said(
                f"these are joints {names}: offsets[0] belongs to joint 1",
                next="Count from 0: at which places do joints 2 and 3 stand?",
            ),
            found,
        )
    yield "offset-sign", "joint 2", right * [-1, 1]
    yield "offset-sign", "joint 3", right * [1, -1]


def _draw_pasted(rng):
    """A Puma 560 as pasted from a paper, with one entry wrong, and ten measured poses."""
    rows = np.array(PUMA, dtype=float)
    i, k = [(0, 3), (2, 3), (3, 3), (4, 3), (2, 2), (2, 1)][rng.integers(6)]
    rows[i, k] *= -1
    lines = [
        f"{n:>3}   q{n}   {1000 * d:8.2f}   {1000 * a:7.2f}   {alpha:5.0f}"
        for n, (_, d, a, alpha) in enumerate(rows, 1)
    ]
    text = "\n".join(["  i   theta   d (mm)    a (mm)   alpha (deg)", *lines])
    real = load("puma560")
    q = _general(rng, 10, real)
    return {"table": text, "rows": rows, "q": q, "poses": _poses(rng, real, q, FINE, TURN)}


EXERCISES = [
    Order(
        id="07.1",
        title="From a symptom to its cause",
        points=2,
        length=6,
        repeats=True,
        items={letter: text for letter, (text, _) in CAUSES.items()},
        accepts=lambda letters: letters == OF_SYMPTOMS,
        explain=_explain_match,
        praise="Each cause leaves its own trace; one of the seven leaves none.",
        hints=(
            (
                "Ask of every symptom: is the rotation touched? Does the error stay the same, and"
                " seen from where?"
            ),
            (
                "What is fixed to the floor shifts every pose alike; what is fixed to the hand"
                " shifts it alike seen from the hand. One of the causes leaves no trace at all."
            ),
        ),
    ),
    Function(
        id="07.2",
        title="The smallest fix: a program from two sources",
        points=2,
        draw=general_chain,
        special=SPECIAL["forward_kinematics"],
        answer=product,
        names=("rows", "q"),
        family="forward_kinematics",
        handed_out=_two_sources,
        praise="One conversion too many. On a flat arm, where every α is 0, nobody could notice.",
        hints=(
            (
                "A flat arm has α = 0 in every row. Which line does something that makes no"
                " difference then?"
            ),
            "Which unit does α come in, and which unit does dh_transform want?",
        ),
    ),
    Prediction(
        id="07.P1",
        title="A length that is 5 cm too long",
        options={
            "a": "the same vector at every pose",
            "b": "5 cm long at every pose, in another direction each time",
            "c": "the further the arm reaches, the larger the error",
        },
        correct="b",
        outcome=(
            "every link behind is carried along by 5 cm, in the direction of x2: the length of the"
            " error is the error of the length, and its direction turns with the link."
        ),
    ),
    Repair(
        id="07.3",
        title="Which length, and by how much",
        points=3,
        answer=_article(),
        draw=_draw_length,
        praise="One arrow accused itself: the residual lay along it at every pose.",
        hints=(
            (
                "d_i acts along z_{i-1}, which is frames[:, i - 1, :3, 2]; a_i acts along x_i,"
                " which is frames[:, i, :3, 0]."
            ),
            (
                "Multiply the residuals with an arrow and add over the three coordinates. The"
                " guilty arrow gives one and the same number at every pose, and what it gives is"
                " missing in the table."
            ),
        ),
    ),
    Impostor(
        id="07.4",
        title="A wrong table that passes q = 0",
        points=2,
        answer=_article(),
        praise="A perfect impostor.",
        hints=(
            (
                "At q = 0 upper arm and forearm lie on one line. Which wrong lengths would still"
                " add up?"
            ),
            "A stretched arm shows some lengths only as a sum. Share that sum out in another way.",
        ),
    ),
    Prediction(
        id="07.P2",
        title="Three tables, one joint moved",
        options={
            "a": "the table with the reversed axis",
            "b": "the table of random numbers",
            "c": "both of these",
            "d": "none: all three draw an arc",
        },
        correct="d",
        outcome=(
            "all three draw exact circles. What stands before the joint and what stands behind it"
            " are constant while only this joint turns, whatever the table says."
        ),
    ),
    Choice(
        id="07.5",
        title="What the arc proves",
        correct="c",
        hints=(
            (
                "Write T(q5) = L · Rz(θ5) · M. What do wrong numbers in L and M do to the kind of"
                " path?"
            ),
            "What would have to happen on the real arm for the points to leave the circle?",
        ),
        options={
            "a": Option(
                "the table is right",
                "A table of random numbers passed as well: T = L · Rz(θ5) · M draws a circle for"
                " any L and M.",
                "arc-taken-for-proof",
            ),
            "b": Option(
                "a and α of row 5 are right",
                "Change them to anything: L · Rz(θ5) · M still draws a circle.",
                "arc-taken-for-proof",
            ),
            "c": Option(
                "only joint 5 moved, without play; of the table, nothing",
                "T = L · Rz(θ5) · M with L and M at rest: it is a test of the measurement.",
            ),
            "d": Option(
                "nothing at all",
                "It does prove something about the arm: a coupled joint or play would have left the"
                " circle.",
                "joints-coupled",
            ),
        },
    ),
    Repair(
        id="07.6",
        title="The cup",
        points=3,
        answer=_article(),
        draw=_story,
        praise="That was it: z4, drawn with its arrow on the wrong side. Two days.",
        hints=(
            (
                "Which is the last joint whose axis is where the table has it, in place and in"
                " direction? Which is the first whose axis is not?"
            ),
            (
                "The row between the two axes is to blame, and of its four numbers the one that"
                " says how the next z axis is tilted."
            ),
        ),
    ),
    Value(
        id="07.7",
        title="Zero offsets of shoulder and elbow",
        points=2,
        draw=_draw_offsets,
        answer=_offsets_of,
        mistakes=_wrong_offsets,
        turns=(0, 1),
        tolerance=0.04,
        entries=("joint 2", "joint 3"),
        praise="Added to θ, these two bring the model from centimetres down to the noise.",
        hints=(
            "calibrate_offsets returns a Calibration; what is in its offsets?",
            "The offsets are in radians, one per joint; joints 2 and 3 stand at places 1 and 2.",
        ),
    ),
    Repair(
        id="07.8",
        title="A table from a paper, for an arm you have not seen",
        points=3,
        answer=Arm(DHTable.standard(PUMA, angle="deg")),
        draw=_draw_pasted,
        praise="A Puma 560, repaired from ten measured poses.",
        hints=(
            "Is the rotation right at every pose? That decides between the angles and the lengths.",
            (
                "Hand the likelier reading's arm to dh.diagnose, with q and the measured poses;"
                " then change the one entry it names."
            ),
        ),
    ),
]
