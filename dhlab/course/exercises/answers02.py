"""What lesson 02 draws, what is right, and what the wrong answers are told:
rows read off links, poses that no row makes, rows as somebody prints them.
"""

from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...arm import Arm
from ...table import DHTable
from ..kinds import Known, Mistakes, Said, as_numbers, is_array_of

__all__ = [
    "ENTRIES",
    "array_in_row",
    "draw_first",
    "draw_second",
    "draw_tube",
    "lengths",
    "link",
    "misread",
    "read_off",
    "tube",
    "wrong_tubes",
]

ENTRIES = ("θ", "d", "a", "α")

UP, FORWARD = 0.2845, 0.0535  # the xArm6's upper arm, metres; UFACTORY's kinematic parameters


def link(theta: float, d: float, a: float, alpha: float) -> NDArray:
    """The pose that one standard row makes; degrees and metres."""
    return Arm(DHTable.standard([[theta, d, a, alpha]], angle="deg")).forward([0.0])


def degrees(y: float, x: float) -> float:
    """The angle of the point (x, y), in degrees."""
    return float(np.rad2deg(np.arctan2(y, x)))


def read_off(T_01: NDArray) -> list[float]:
    """θ, d, a, α of a pose that one row makes; degrees and metres."""
    x, p = T_01[:3, 0], T_01[:3, 3]
    return [degrees(x[1], x[0]), p[2], x @ p, degrees(T_01[2, 1], T_01[2, 2])]


def lengths(rng: np.random.Generator) -> tuple[float, float]:
    """Two different lengths, metres."""
    d, a = rng.choice(np.arange(10, 46, 5), 2, replace=False) / 100
    return float(d), float(a)


def draw_first(rng: np.random.Generator) -> dict[str, Any]:
    """A link of which no sign and no quadrant can be guessed."""
    d, a = lengths(rng)
    theta, alpha = rng.choice([110, 125, 140, 155]), rng.choice([100, 115, 130, 145])
    return {"T_01": link(-float(theta), d, -a, -float(alpha))}


def draw_second(rng: np.random.Generator) -> dict[str, Any]:
    d, a = lengths(rng)
    return {
        "T_01": link(
            float(rng.choice([110, 125, 140, 155])), d, -a, -float(rng.choice([20, 35, 50, 65]))
        )
    }


FALSE_TURN = Said(
    "α has the wrong sign",
    why="α goes from z0 to z1, counted about x1 as the fingers of the right hand curl.",
    next="sin α has a sign too: in which entry of row 3 does it stand?",
)

HALF_A_TURN = Said(
    "θ is off by half a turn",
    next="np.arctan2(y, x) keeps the signs of both; a quotient y / x forgets them.",
)

X1 = "a and α are counted along and about x1 as it is given: which sign has x1 · p?"


def misread(T_01: NDArray) -> Mistakes:
    """What comes out when one of the four is taken otherwise."""
    theta, d, a, alpha = read_off(T_01)
    x, z, p = T_01[:3, 0], T_01[:3, 2], T_01[:3, 3]
    yield "a-d-exchanged", "", [theta, a, d, alpha]
    yield "theta-alpha-exchanged", "", [alpha, d, a, theta]
    yield (
        "length-along-the-part",
        "a: this is the distance of the two origins",
        [theta, d, np.linalg.norm(p), alpha],
    )
    yield (
        "measured-in-other-frame",
        "a: this is the step along x0, not along x1",
        [theta, d, p[0], alpha],
    )
    yield (
        "measured-in-other-frame",
        "α: this is the angle about x0, not about x1",
        [theta, d, a, degrees(-z[1], z[2])],
    )
    yield (
        "rotation-transposed",
        Said(
            "θ was read off the first row",
            next="x1 is the first column: its first two numbers, from top to bottom.",
        ),
        [degrees(T_01[0, 1], T_01[0, 0]), d, a, alpha],
    )
    yield (
        "atan-for-atan2",
        "θ: the two arguments of arctan2 have changed places",
        [degrees(x[0], x[1]), d, a, alpha],
    )
    yield (
        "atan-for-atan2",
        "α: the two arguments of arctan2 have changed places",
        [theta, d, a, degrees(T_01[2, 2], T_01[2, 1])],
    )
    if abs(theta) > 90:
        yield "atan-for-atan2", HALF_A_TURN, [theta - 180, d, a, alpha]
    if abs(alpha) > 90:
        yield (
            "atan-for-atan2",
            replace(HALF_A_TURN, headline="α is off by half a turn"),
            [theta, d, a, alpha - 180],
        )
        yield (
            "atan-for-atan2",
            Said(
                "α has the right sine and the wrong cosine",
                next="cos α has a sign too: in which entry of row 3 does it stand?",
            ),
            [theta, d, a, 180 - alpha],
        )
    else:
        yield "alpha-value", Said("α is off by half a turn"), [theta, d, a, alpha + 180]
    if theta < 0:
        yield (
            "offset-sign",
            Said("θ has the wrong sign", next="sin θ has a sign too: in which entry is it?"),
            [-theta, d, a, alpha],
        )
    arccos = " np.arccos forgets the sign." * (alpha < 0)
    yield ("alpha-sign", replace(FALSE_TURN, why=FALSE_TURN.why + arccos), [theta, d, a, -alpha])
    if a < 0:
        yield (
            "measured-in-other-frame",
            Said(
                "θ and a follow the way to the origin, not x1",
                next="θ goes from x0 to x1, wherever the origin is. What is x1 in T_01?",
            ),
            [theta - 180, d, -a, alpha],
        )
        yield (
            "lengths-made-positive",
            Said("a has lost its minus sign", next=X1),
            [theta, d, -a, alpha],
        )
        yield (
            "lengths-made-positive",
            "a is positive, as if x1 were turned round; but x1 is given",
            [theta - 180, d, -a, -alpha],
        )
        yield (
            "lengths-made-positive",
            Said("a and α have lost their minus signs", next=X1),
            [theta, d, -a, -alpha],
        )


def array_in_row(
    answer: object, T_01: NDArray | None = None, q2: float | None = None
) -> Known | None:
    """A row of which an entry is an array."""
    entries = (
        [as_numbers(entry) for entry in answer]
        if isinstance(answer, (list, tuple)) and len(answer) == len(ENTRIES)
        else []
    )
    arrays = [k for k, entry in enumerate(entries) if entry.ndim and entry.size]
    if not arrays or len(arrays) == len(ENTRIES):
        return None
    name, entry = ENTRIES[arrays[0]], entries[arrays[0]]
    if T_01 is not None and is_array_of(entry, T_01[:3, 0] * T_01[:3, 3]):
        return "elementwise-product", Said(
            f"{name} is an array of three numbers: * in place of @",
            next="@ multiplies entry by entry and adds up: that is one number.",
        )
    return None, Said(
        f"{name} is an array, where one number belongs",
        next="Print it: which @ or which index is missing?",
    )


def draw_tube(rng: np.random.Generator) -> dict[str, Any]:
    return {"q2": float(rng.integers(12, 60) * rng.choice([-1, 1]))}


def tube(q2: float) -> list[float]:
    return [q2 + degrees(UP, FORWARD), 0.0, float(np.hypot(UP, FORWARD)), 0.0]


SKETCH = (
    "Take the sketch at q2 = 0: at which angle to x0 does the straight line from axis 2 to axis"
    " 3 go?"
)


def wrong_tubes(q2: float) -> Mistakes:
    offset, a = degrees(UP, FORWARD), float(np.hypot(UP, FORWARD))
    yield (
        "length-along-the-part",
        "a: this is the way along the tube",
        [q2 + offset, 0, UP + FORWARD, 0],
    )
    yield "length-along-the-part", "a: this is one piece of the tube", [q2 + offset, 0, UP, 0]
    yield "length-along-the-part", "a: this is one piece of the tube", [q2 + offset, 0, FORWARD, 0]
    yield "length-along-the-part", "θ and a follow the first piece of the tube", [q2 + 90, 0, UP, 0]
    yield (
        "a-d-exchanged",
        "the step of 53.5 mm does not run along the joint's axis",
        [q2 + 90, FORWARD, UP, 0],
    )
    yield (
        "a-d-exchanged",
        "the piece of 284.5 mm does not run along the joint's axis",
        [q2, UP, FORWARD, 0],
    )
    for d, said in ((UP, "piece of 284.5 mm"), (FORWARD, "step of 53.5 mm")):
        for along in (UP + FORWARD - d, a):
            yield (
                "a-d-exchanged",
                f"the {said} does not run along the joint's axis",
                [q2 + offset, d, along, 0],
            )
    yield (
        "length-along-the-part",
        Said("θ follows the first piece of the tube, not the straight line", next=SKETCH),
        [q2 + 90, 0, a, 0],
    )
    yield "a-d-exchanged", "", [q2 + offset, a, 0, 0]
    yield (
        "measured-in-other-frame",
        Said("θ and a are told as if x1 pointed from axis 3 to axis 2", next=SKETCH),
        [q2 + offset + 180, 0, -a, 0],
    )
    yield (
        "offset-missing",
        Said("θ is q2 alone, but x1 leans by a constant angle, whatever q2 is", next=SKETCH),
        [q2, 0, a, 0],
    )
    yield (
        "joint-values-unused",
        Said(
            "θ is right at q2 = 0 only",
            next="q2 turns the whole tube: it is added to the angle at q2 = 0.",
        ),
        [offset, 0, a, 0],
    )
    yield (
        "offset-sign",
        Said(
            "the angle of x1 at q2 = 0 has the wrong sign in θ",
            next="Both are counted from x0 towards y0: is the tube above x0 or below it?",
        ),
        [q2 - offset, 0, a, 0],
    )
    yield (
        "offset-subtracted",
        Said(
            "q2 has the wrong sign in θ",
            next="Turn the tube by a small positive q2: does the angle from x0 grow?",
        ),
        [offset - q2, 0, a, 0],
    )
    yield (
        "atan-for-atan2",
        Said(
            "θ: the angle of x1 at q2 = 0 was taken from y0",
            next="θ is counted from x0. In np.arctan2(y, x) the part along y0 comes first.",
        ),
        [q2 + 90 - offset, 0, a, 0],
    )
    yield "angle-unit", "θ: radians were added to degrees", [q2 + np.deg2rad(offset), 0, a, 0]
    yield (
        "alpha-value",
        "α: the two axes are parallel and point the same way",
        [q2 + offset, 0, a, 180],
    )
    yield ("alpha-value", "α: the tube is bent, the two axes are not", [q2 + offset, 0, a, offset])
