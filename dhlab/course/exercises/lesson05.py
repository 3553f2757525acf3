"""Lesson 05, the link matrix: four moves, their order, the closed form."""

from dataclasses import dataclass
from itertools import product

import numpy as np

from ...doctor.programs.cases import SPECIAL, general_row
from ...doctor.programs.slipsearch import wrong_entries
from ...doctor.programs.wrong.links import WRONG_LINKS, standard
from ...transform import rot_x
from ..kinds import Choice, Function, Option, Order, Prediction, Said, Value

__all__ = ["EXERCISES"]

RIGHT_ORDERS = (
    ["a", "b", "c", "d"],
    ["b", "a", "c", "d"],
    ["a", "b", "d", "c"],
    ["b", "a", "d", "c"],
    ["a", "c", "b", "d"],
)


def _draw_angle(rng):
    return (float(rng.uniform(0.2, 3.0) * rng.choice([-1, 1])),)


def _from_a_blog(theta, d, a, alpha):
    """The broken program of 05.7: one sign of the z arrow."""
    T = standard(theta, d, a, alpha)
    T[1, 2] *= -1
    return T


def _draw_column(rng):
    return {
        "theta": float(rng.choice([20, 30, 40, 50, 60])),
        "d": float(rng.integers(1, 6) / 10),
        "a": float(rng.integers(1, 6) / 10),
        "alpha": float(rng.choice([25, 35, 45, 55, 65])),
    }


def _row_in_radians(theta, d, a, alpha):
    return standard(np.deg2rad(theta), d, a, np.deg2rad(alpha))


def _wrong_origins(theta, d, a, alpha):
    T = _row_in_radians(theta, d, a, alpha)
    t, al = np.deg2rad(theta), np.deg2rad(alpha)
    yield "shift-not-turned-by-theta", "", [a, 0, d]
    yield "rotation-block-misread", "this is the x arrow, without its length", T[:3, 0]
    yield "rotation-block-misread", "this is the z arrow", T[:3, 2]
    yield "degrees-in-sin-cos", "", [a * np.cos(theta), a * np.sin(theta), d]
    yield (
        "a-d-exchanged",
        Said(
            "a and d have changed places",
            next="a is walked along the new x arrow, d along the old z.",
        ),
        [d * np.cos(t), d * np.sin(t), a],
    )
    yield (
        "sin-cos-exchanged",
        Said(
            "sine and cosine of θ have changed places",
            next="Set θ = 0: the origin must lie along x.",
        ),
        [a * np.sin(t), a * np.cos(t), d],
    )
    yield (
        "theta-alpha-exchanged",
        Said(
            "α stands where θ belongs", next="Which of the two turns comes before the step along x?"
        ),
        [a * np.cos(al), a * np.sin(al), d],
    )
    yield (
        "standard-rows-in-craig-matrix",
        Said(
            "the x moves come before the z moves",
            next="Turn and lift along z first, then step along the turned x arrow.",
        ),
        [a, -d * np.sin(al), d * np.cos(al)],
    )
    yield (
        "pose-inverted",
        Said(
            "this is the old origin, seen from the new frame",
            next="Asked is the new origin, seen from the old frame.",
        ),
        np.linalg.inv(T)[:3, 3],
    )
    yield (
        "pi-rounded",
        Said(
            "rounded too early", next="Give four digits or more, or let numpy compute the numbers."
        ),
        np.round(T[:3, 3], 2),
    )


def _draw_slide(rng):
    return {"q3": float(rng.choice([0.4, 0.5, 0.6, 0.7, 0.8]))}


def _slide(q3):
    """The sliding row of 05.9: theta = -90°, d = q3, a = 0.05, alpha = 90°."""
    return standard(-np.pi / 2, q3, 0.05, np.pi / 2)


def _wrong_slides(q3):
    half = np.pi / 2
    row = (-half, q3, 0.05, half)
    yield (
        "offset-missing",
        Said("θ is −90° here, not 0", next="θ is a constant of this row: −90° at every q3."),
        standard(0, q3, 0.05, half),
    )
    yield (
        "offset-sign",
        Said("θ is −90° here, not +90°", next="Compare the sign with the row in the text."),
        standard(half, q3, 0.05, half),
    )
    yield (
        "alpha-sign",
        Said("α is +90° here, not −90°", next="Compare the sign with the row in the text."),
        standard(-half, q3, 0.05, -half),
    )
    yield (
        "theta-alpha-exchanged",
        Said(
            "θ and α have changed places, or both their signs",
            next="θ = −90° comes first, α = 90° last.",
        ),
        standard(half, q3, 0.05, -half),
    )
    yield (
        "joint-values-unused",
        Said("q3 is left out", next="Put q3 in place of d; θ stays −90°."),
        standard(-half, 0, 0.05, half),
    )
    for theta in (-half + q3, q3):
        yield "prismatic-variable-in-theta", "", standard(theta, 0, 0.05, half)
    for theta, alpha in product((half, 1.57, 1.571, 1.5708), repeat=2):
        if (theta, alpha) != (half, half):
            yield (
                "pi-rounded",
                Said(
                    "rounded on the way", next="Write np.pi / 2, or let np.deg2rad make it of 90."
                ),
                standard(-theta, q3, 0.05, alpha),
            )
    for mistake, place, version in WRONG_LINKS:
        yield mistake, place, version(*row)


def _explain_order(letters):
    if set(letters[:2]) == {"c", "d"}:
        return "standard-rows-in-craig-matrix", Said(
            "the x moves come before the z moves",
            next="Which pair did the picture's link make first?",
        )
    if letters.index("c") < letters.index("a"):
        return "shift-not-turned-by-theta", Said(
            "Tx(a) stands before Rz(θ)",
            next="Set θ = 90°: the origin must move to y.",
            why="A step along x that is made first does not swing with θ.",
        )
    if letters.index("d") < letters.index("b"):
        return "alpha-before-d", Said(
            "Rx(α) stands before Tz(d)",
            next="Set α = 90°: d must still go along the old z.",
            why="After Rx(α) the z axis is a new one.",
        )
    return "order-taken-for-free", Said(
        "Rx(α) stands before Rz(θ)",
        next="Set α = 90°: θ must still turn about the old z.",
        why="After Rx(α) the z axis is a new one.",
    )


@dataclass(frozen=True, kw_only=True)
class _ClosedForm(Function):
    """A link matrix typed entry by entry: what is wrong is said of its entries and columns."""

    def refine(self, mistake, answers, cases):
        if mistake not in ("matrix-entry-mistyped", "not-rigid"):
            return None
        answers = np.array(answers, dtype=float)
        said = (
            _wrong_columns(answers[:, :3, :3])
            if mistake == "not-rigid"
            else _wrong_entries(wrong_entries(answers, cases))
        )
        return said and (mistake, said)


NEXT = {
    2: "Turn y by θ, then tip it towards z by α.",
    3: "Take z = x × y: z is at right angles to both.",
}  # by column


def _wrong_entries(slips):
    """Which entries, the typed ones of a closed form; None when they are not known one by one."""
    if not slips:
        return None
    columns = {int(slip.place.split("column ")[1][0]) for slip in slips}
    given = any("row 3" in slip.place for slip in slips) or columns & {1, 4}
    column = min(columns)
    turned = (
        len(slips) == 2
        and len(columns) == 1
        and not given
        and all("its sign is turned" in slip.place for slip in slips)
    )
    headline = (
        f"column {column} points the wrong way"
        if turned
        else "one entry is wrong"
        if len(slips) == 1
        else f"{len(slips)} entries are wrong"
    )
    return Said(
        headline,
        next="Compare with the entries that the text gives." if given else NEXT[column],
        place="; ".join(slip.place for slip in slips),
    )


def _wrong_columns(R):
    """The first column, or pair of columns, that no frame's arrows can be."""
    for k in range(3):
        if np.abs(np.linalg.norm(R[:, :, k], axis=1) - 1).max() > 1e-6:
            return Said(
                f"column {k + 1} does not have length 1",
                next=NEXT.get(k + 1, "Compare with the entries that the text gives."),
                why="An arrow that is turned keeps its length.",
            )
        for j in range(k):
            if np.abs((R[:, :, j] * R[:, :, k]).sum(axis=1)).max() > 1e-6:
                return Said(
                    f"columns {j + 1} and {k + 1} are not at right angles",
                    next=NEXT[k + 1],
                    why="The arrows of a frame stand at right angles, whatever the angles are.",
                )
    return None


TURNED_BACK = Said(
    "α turns the other way", next="Set θ = 0, α = 90°: column 2 must be z, (0, 0, 1)."
)
X_FIRST = Said(
    "the x moves come before the z moves",
    next="Make both z moves first: each next move joins on the right.",
    place="Rx and Tx stand before Rz and Tz",
)
LEFT_HANDED = Said(
    "one arrow points the wrong way",
    next="Turn y by θ, then tip it by α; take z = x × y.",
    why="x, y and z must form a right hand.",
)
SIN_COS = Said(
    "a sine or a cosine is not where it belongs",
    next="Set this angle to 90°: its turn must be a quarter turn.",
)
OF_THE_MATRIX = {
    "alpha-sign": TURNED_BACK,
    "standard-rows-in-craig-matrix": X_FIRST,
    "mirror": LEFT_HANDED,
    "sin-cos-exchanged": SIN_COS,
}

EXERCISES = [
    Prediction(
        id="05.P1",
        title="Turn, then step; step, then turn",
        options={
            "a": "both end at the same place",
            "b": "the first ends at (0, 0.4), the second at (0.4, 0)",
            "c": "the first ends at (0.4, 0), the second at (0, 0.4)",
        },
        correct="b",
        outcome=(
            "turning first turns the x arrow too, so the step goes along y0. Stepping first goes"
            " along x0, and the turn comes too late to matter."
        ),
    ),
    Function(
        id="05.1",
        title="A turn about x",
        draw=_draw_angle,
        special=((0.0,), (np.pi / 2,), (-np.pi / 2,), (np.pi,)),
        answer=rot_x,
        names=("alpha",),
        family="rot_x",
        praise="x stays; y goes towards z.",
        words={
            "rotation-transposed": Said(
                "the turn goes the other way",
                next="Take the second column at α = 90°: y must go to z, (0, 0, 1).",
            ),
            "mirror": Said(
                "y and z do not turn together",
                next=(
                    "Tip y a little towards z: which way does z go, and which sine carries the"
                    " minus?"
                ),
                why="The two must stay at right angles, and z = x × y.",
            ),
            "matrix-entry-mistyped": Said(
                "not every entry is right", next="Put α = 90° in: y must go to z, and z to −y."
            ),
        },
        hints=(
            "Compare with rot_z: the axis that stays has a 1 on the diagonal. Which one stays now?",
            "The second column says where y goes: cos α along y, sin α along z.",
        ),
    ),
    Choice(
        id="05.2",
        title="Which moves may change places",
        correct="b",
        hints=(
            "Try each pair with your hand: does the first move change the direction of the second?",
            "A turn about an axis leaves that axis where it is.",
        ),
        options={
            "a": Option(
                "none: every change of order is a mistake",
                "Too strict: a turn about z leaves the z axis where it is, so a shift along z does"
                " not notice.",
                "every-order-taken-for-wrong",
            ),
            "b": Option(
                "Rz with Tz, Tx with Rx, and Tz with Tx",
                "Turn and shift about one axis commute, and so do two shifts: five of the 24 orders"
                " are right.",
            ),
            "c": Option(
                "all turns with all shifts",
                "A turn about z does change where a shift along x goes.",
                "order-taken-for-free",
            ),
            "d": Option(
                "Rz with Rx, since both are turns",
                "Turns about different axes do not commute: try a book on the table.",
                "order-taken-for-free",
            ),
        },
    ),
    Order(
        id="05.3",
        title="The four moves in order",
        items={"a": "Rz(θ)", "b": "Tz(d)", "c": "Tx(a)", "d": "Rx(α)"},
        accepts=lambda letters: letters in RIGHT_ORDERS,
        explain=_explain_order,
        praise=(
            "Five of the 24 orders give this matrix, and yours is one. If it is a, b, c, d, find"
            " another."
        ),
        hints=(
            "Two of the moves belong to z, two to x. Which pair does a standard row make first?",
            "Tx(a) must come after Rz(θ), and Rx(α) after both z moves.",
        ),
    ),
    Function(
        id="05.4",
        title="dh_transform from four moves",
        points=2,
        draw=general_row,
        special=SPECIAL["dh_transform"],
        answer=standard,
        names=("theta", "d", "a", "alpha"),
        family="dh_transform",
        praise="Four moves, multiplied from left to right.",
        words=OF_THE_MATRIX,
        hints=(
            "Write the four matrices first, in the order about z, along z, along x, about x.",
            (
                "Each new move is made in the current frame, so it goes to the right of those"
                " already made."
            ),
        ),
    ),
    Prediction(
        id="05.P2",
        title="A test that says yes too often",
        options={
            "a": "1 of the 24 orders passes",
            "b": "5 of the 24 orders pass",
            "c": "all 24 orders pass",
        },
        correct="c",
        outcome=(
            "with θ = d = α = 0 three of the moves do nothing, and one move alone has no order. All"
            " 24 pass."
        ),
    ),
    Value(
        id="05.5",
        title="Where the new origin is",
        draw=_draw_column,
        answer=lambda **row: _row_in_radians(**row)[:3, 3],
        mistakes=_wrong_origins,
        entries=("x", "y", "z"),
        praise="The link swings with θ; d lifts it; α has no say in the position.",
        hints=(
            (
                "The last column of the link matrix is where the origin goes: which of the four"
                " numbers enter it?"
            ),
            "a is walked along the new x arrow, which θ has turned: (a cos θ, a sin θ, d).",
        ),
    ),
    _ClosedForm(
        id="05.6",
        title="dh_transform in closed form",
        points=2,
        draw=general_row,
        special=SPECIAL["dh_transform"],
        answer=standard,
        names=("theta", "d", "a", "alpha"),
        family="dh_transform",
        praise="The same matrix, in closed form.",
        words=OF_THE_MATRIX,
        hints=(
            (
                "First column: the x arrow after the turn by θ. Last column: a times that arrow,"
                " and d."
            ),
            (
                "The second column is the turned y arrow (-sin θ, cos θ, 0), tilted towards z by α;"
                " the third is what is then left for z."
            ),
        ),
    ),
    _ClosedForm(
        id="05.7",
        title="The smallest fix",
        draw=general_row,
        special=SPECIAL["dh_transform"],
        answer=standard,
        names=("theta", "d", "a", "alpha"),
        family="dh_transform",
        handed_out=_from_a_blog,
        praise="One sign. It hides whenever α is 0, and also at θ = ±90°.",
        words=OF_THE_MATRIX,
        hints=(
            "Compare the third column with that of your dh_closed.",
            (
                "The third column must be at right angles to the first: multiply them entry by"
                " entry and add."
            ),
        ),
    ),
    Choice(
        id="05.8",
        title="What a good test needs",
        correct="d",
        hints=(
            "Which numbers make sin or cos vanish?",
            "A sign can only show where what it multiplies is not 0.",
        ),
        options={
            "a": Option(
                "θ = 0, d = 0, a = 1, α = 0, and look for a shift of 1 along x",
                "All 24 orders of the moves pass this one.",
                "only-zero-pose-checked",
            ),
            "b": Option(
                "all angles 90°, since the matrix is then clean",
                "Clean, because the cosines vanish, and what they multiply is never tested.",
                "only-zero-pose-checked",
            ),
            "c": Option(
                "compare the positions only, that is what counts",
                "α never enters the position of its own link: half of the matrix would go"
                " untested.",
                "only-zero-pose-checked",
            ),
            "d": Option(
                "values without zeros and right angles, position and rotation both",
                "Then every entry, and every sign, has to be right.",
            ),
        },
    ),
    Value(
        id="05.9",
        title="A sliding joint, on an arm you have not seen",
        points=2,
        draw=_draw_slide,
        answer=_slide,
        mistakes=_wrong_slides,
        tolerance=1e-6,
        praise="For a sliding joint d moves and θ stays: the matrix is the same.",
        hints=(
            "Which of the four numbers does a sliding joint change?",
            "Call your dh_transform with theta = -90° in radians and d = q3.",
        ),
    ),
]
