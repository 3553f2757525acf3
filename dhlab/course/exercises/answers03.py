"""What lesson 03 draws, what is right, and what the wrong answers are told:
orders of moves, tables to classify and to convert, a table with no name.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations, permutations
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...arm import Arm
from ...doctor.mistakes.registry import value_mistake
from ...doctor.programs.wrong.craig import craig, in_order
from ...doctor.programs.wrong.links import standard
from ...robots import load
from ...table import COLUMNS, DHTable
from ..kinds import Function, Known, Mistakes, Said, numbers

__all__ = [
    "CRAIGS_ALPHA",
    "CRAIG_ORDERS",
    "ENTRIES",
    "OTHER_ORDER",
    "PUBLISHED",
    "REASONS",
    "SIDES",
    "SIGNS",
    "STANDARD_ORDER",
    "CraigsMatrix",
    "badly_repaired",
    "draw_broken",
    "draw_craig",
    "draw_standard",
    "draw_unseen",
    "explain_order",
    "explain_published",
    "explain_reasons",
    "explain_sides",
    "half_to_craig",
    "half_to_standard",
    "repaired",
    "to_craig",
    "to_standard",
    "unseen_point",
    "wrong_points",
]

MOVES = {"rz": "Rz", "tz": "Tz", "tx": "Tx", "rx": "Rx"}
SIDES = ["craig", "standard", "craig", "craig", "standard", "standard"]  # 03.1
PUBLISHED = ["craig", "standard", "standard", "craig", "standard", "craig"]  # 03.5
REASONS = ["convention", "hand", "digit", "zero-pose", "reversed-joint"]  # 03.6
ZEROS = [
    "row 1",
    "the last row",
    "the last row",
    "row 1",
    "the last row",
    "row 1",
]  # where each table of 03.5 has a = 0 and α = 0
UNSEEN = ("piper", "irb120")


def _orders_of(matrix):
    row = 0.3, 0.2, 0.4, 0.5
    return [
        list(order)
        for order in permutations(MOVES)
        if np.allclose(in_order([MOVES[move] for move in order], *row), matrix(*row))
    ]


CRAIG_ORDERS, STANDARD_ORDERS = _orders_of(craig), _orders_of(standard)


def _wrong_numbers(given, right):
    return [k for k, (one, wanted) in enumerate(zip(given, right), 1) if one != wanted]


def explain_sides(given: list[str]) -> Known | None:
    wrong = _wrong_numbers(given, SIDES)
    if len(wrong) == 6:
        return "frame-at-other-end", "all six: the two conventions have changed places"
    named = ", ".join(map(str, wrong))
    if set(wrong) <= {3, 6}:
        return "frame-at-other-end", Said(
            f"look again at statement {named}: what lies between plate {{i-1}} and plate {{i}}",
            next=(
                "From plate to plate: do you meet the joint first, or the link? And which link is"
                " it, that before the joint or that behind it?"
            ),
        )
    return "frame-at-other-end", Said(
        f"look again at statement {named}",
        next="Which convention's plate i swings when joint i turns, and which one's stays?",
    )


STANDARD_ORDER = Said(
    "this is the standard matrix: the joint turns first, then comes the link",
    next="Craig walks the link before joint i first. Which of the moves belong to a link?",
)
OTHER_ORDER = Said(
    "this is neither Craig's matrix nor the standard one",
    why="A turn changes the direction of every later shift across its axis, so the order counts.",
    next="One move after the other: first the link before the joint, then the joint.",
)


ENTRIES = Said(
    "not every entry is right",
    next=(
        "Call it with one argument at a time, the other three 0: does each of the four make its own"
        " move, and the right way?"
    ),
)
CRAIGS_ALPHA = Said(
    "alpha turns the wrong way",
    why="In Craig's matrix it is α_{i-1}: measured about x_{i-1}, from z_{i-1} to z_i.",
    next="Set theta, d and a to 0: is what is left rot_x(alpha)?",
)
COPIED = (
    "A conversion changes no number, only its row. Compare signs and digits with the given table."
)
SIGNS = {
    "alpha-sign": Said("an α has the other sign", next=COPIED),
    "length-sign": Said("a length has the other sign", next=COPIED),
    "offset-sign": Said("a θ has the other sign", next=COPIED),
    "lengths-made-positive": Said("the lengths have lost their signs", next=COPIED),
}


def explain_order(order: list[str]) -> Known | None:
    if order in STANDARD_ORDERS:
        return "craig-rows-in-standard-matrix", STANDARD_ORDER
    return "order-taken-for-free", OTHER_ORDER


def explain_published(given: list[str]) -> Known | None:
    wrong = _wrong_numbers(given, PUBLISHED)
    if len(wrong) == 6:
        return "convention-guessed", Said(
            "all six: the two have changed places",
            next="Before joint 1 there is no link. Whose row 1 holds that missing link's pair?",
        )
    tables = {
        where: [str(k) for k in wrong if ZEROS[k - 1] == where]
        for where in ("row 1", "the last row")
    }
    said = [
        f"the zeros of table {', '.join(found)} stand in {where}"
        for where, found in tables.items()
        if found
    ]
    return "convention-guessed", Said(
        " and ".join(said),
        next=(
            "Row i holds the link before joint i, or the link behind it: which of the two is"
            " missing in that row?"
        ),
    )


def explain_reasons(given: list[str]) -> Known | None:
    wrong = ", ".join(map(str, _wrong_numbers(given, REASONS)))
    return "tables-differ-otherwise", Said(
        f"look again at pair {wrong}",
        next=(
            "Read the sentence of dh.equivalent once more: the same arm, only the end, a fraction"
            " of a millimetre, a zero moved, or counted the other way?"
        ),
    )


def _draw_rows(rng, n):
    """n rows as somebody would publish them, degrees and metres; every a and alpha differs from its
    neighbours'.
    """
    d, a = (
        rng.permutation(np.arange(10, 45, 5))[:n] / 100,
        rng.permutation(np.arange(12, 47, 5))[:n] / 100,
    )
    alpha = rng.permutation([90.0, -90.0, 60.0, -60.0, 30.0])[:n]
    theta = rng.permutation([0.0, 90.0, -90.0, 180.0, 0.0])[:n]
    return np.column_stack([theta, d, a * rng.choice([-1, 1], n), alpha])


def draw_standard(rng: np.random.Generator) -> dict[str, Any]:
    return {"rows": _draw_rows(rng, 3).tolist()}


def to_craig(rows: list[list[float]]) -> Arm:
    return Arm(DHTable.standard(rows, angle="deg")).to("craig")


def half_to_craig(rows: list[list[float]]) -> Mistakes:
    """What half a conversion looks like, twice: with a row 1 that is right, as 03.7 hands it out,
    and with a row 1 of its own.
    """
    given, right = np.array(rows), np.array(numbers(to_craig(rows).table))
    up, rolled = (
        _shifted(given, -1),
        np.column_stack([given[:, :2], np.roll(given[:, 2:], 1, axis=0)]),
    )
    whole, joints = (
        np.vstack([np.zeros(4), given[:-1]]),
        np.column_stack([np.roll(given[:, :2], 1, axis=0), given[:, 2:]]),
    )
    for everywhere, below, wrong in (
        (
            "the rows are those of the standard table",
            "row 1 is right, and the others are those of the standard table",
            given,
        ),
        (
            "α moved, a did not",
            "α moved; from row 2 on a did not",
            np.column_stack([given[:, :3], right[:, 3]]),
        ),
        (
            "a moved, α did not",
            "a moved; from row 2 on α did not",
            np.column_stack([right[:, :3], given[:, 3]]),
        ),
        (
            "θ and d moved as well; they stay in their rows",
            "from row 2 on θ and d moved as well; they stay in their rows",
            whole,
        ),
        (
            "the pairs moved up; from standard to Craig they move down",
            "from row 2 on the pairs moved up; from standard to Craig they move down",
            up,
        ),
        ("the last pair came back in row 1; it belongs into the tool", "", rolled),
        ("θ and d moved, a and α did not", "from row 2 on θ and d moved, a and α did not", joints),
    ):
        yield "conversion-incomplete", _half(everywhere), wrong
        if not np.allclose(wrong[1:], right[1:]):
            yield "conversion-incomplete", _half(below), np.vstack([right[:1], wrong[1:]])
    round_up = np.column_stack([given[:, :2], np.roll(given[:, 2:], -1, axis=0)])
    yield (
        "conversion-incomplete",
        _half("from row 2 on the pairs moved up; from standard to Craig they move down"),
        np.vstack([right[:1], round_up[1:]]),
    )
    for k in range(1, len(given)):
        forgotten = right.copy()
        forgotten[k] = given[k]
        yield (
            "conversion-incomplete",
            _half(f"row {k + 1} is still that of the standard table"),
            forgotten,
        )


def _half(headline):
    """What is said of a conversion of which a part was forgotten or went another way."""
    return Said(
        headline,
        why="θ and d belong to the joint and stay; a and α belong to a link and move together.",
        next="Pick one link and find its a and its α in both tables.",
    )


def _shifted(rows, step):
    """a and alpha moved by one row, down (1) or up (-1), zeros in the row that is left empty."""
    moved = np.roll(rows[:, 2:], step, axis=0)
    moved[0 if step > 0 else -1] = 0
    return np.column_stack([rows[:, :2], moved])


def draw_craig(rng: np.random.Generator) -> dict[str, Any]:
    rows = _draw_rows(rng, 4)
    rows[0, 2:] = 0
    return {"rows": rows.tolist()}


def to_standard(rows: list[list[float]]) -> Arm:
    return Arm(DHTable.craig(rows, angle="deg")).to("standard")


def half_to_standard(rows: list[list[float]]) -> Mistakes:
    given, right = np.array(rows), np.array(numbers(to_standard(rows).table))
    yield "conversion-incomplete", _half("the rows are those of Craig's table"), given
    yield (
        "conversion-incomplete",
        _half("α moved, a did not"),
        np.column_stack([given[:, :3], right[:, 3]]),
    )
    yield (
        "conversion-incomplete",
        _half("a moved, α did not"),
        np.column_stack([right[:, :3], given[:, 3]]),
    )
    yield (
        "conversion-incomplete",
        _half("the pairs moved down; from Craig to standard they move up"),
        _shifted(given, 1),
    )
    yield (
        "conversion-incomplete",
        _half("θ and d moved as well; they stay in their rows"),
        np.vstack([given[1:], np.zeros(4)]),
    )
    yield (
        "conversion-incomplete",
        _half("the last row keeps a pair; nothing comes after it"),
        np.vstack([right[:-1], given[-1]]),
    )


def draw_broken(rng: np.random.Generator) -> dict[str, Any]:
    """A standard table and its conversion in which a stayed where it was."""
    rows = _draw_rows(rng, 4)
    rows[-1, 2:] = 0
    converted = np.array(numbers(to_craig(rows).table))
    return {
        "standard": rows.tolist(),
        "converted": np.column_stack([converted[:, :2], rows[:, 2], converted[:, 3]]).tolist(),
    }


def repaired(standard: list[list[float]], converted: list[list[float]]) -> Arm:
    return to_craig(standard)


def badly_repaired(standard: list[list[float]], converted: list[list[float]]) -> Mistakes:
    rows, right = np.array(converted), np.array(numbers(to_craig(standard).table))
    for k in range(1, len(rows)):
        for mended in combinations(range(len(rows)), k):
            partly = rows.copy()
            partly[list(mended), 2] = right[list(mended), 2]
            yield (
                "conversion-incomplete",
                Said(
                    "some of column a is right by now, and not all of it",
                    place=f"right so far: a of row {', '.join(str(i + 1) for i in mended)}",
                    next=(
                        "Where does the a of each link stand in the first table, and where must it"
                        " stand in Craig's?"
                    ),
                ),
                partly,
            )
    yield from half_to_craig(standard)
    yield (
        "conversion-incomplete",
        _half("both columns moved, α for the second time"),
        _shifted(np.array(converted), 1),
    )


def draw_unseen(rng: np.random.Generator) -> dict[str, Any]:
    """A table that no habit gives away: its owner counts in a bracket below joint 1 (Craig) or a
    hand (standard), so both ends hold numbers.
    """
    table = load(str(rng.choice(UNSEEN))).to(str(rng.choice(["standard", "craig"]))).table
    rows = np.array(numbers(table))
    rows[0 if table.convention == "craig" else -1, 2:] = (
        rng.choice([0.05, 0.08, 0.1]),
        rng.choice([-90.0, 90.0]),
    )
    arm = _read_as(table.convention, rows)
    q_check, q = rng.integers(15, 75, (2, len(arm))) * rng.choice([-1, 1], (2, len(arm)))
    return {
        "rows": rows.tolist(),
        "q_check": q_check.tolist(),
        "p_check": arm.forward(np.deg2rad(q_check))[:3, 3].round(3).tolist(),
        "q": q.tolist(),
    }


def _read_as(convention, rows, angle="deg"):
    return Arm(getattr(DHTable, convention)(rows, angle=angle))


def _convention_of(rows, q_check, p_check):
    return min(
        ("standard", "craig"),
        key=lambda name: np.linalg.norm(
            _read_as(name, rows).forward(np.deg2rad(q_check))[:3, 3] - p_check
        ),
    )


def unseen_point(
    rows: list[list[float]], q_check: list[float], p_check: list[float], q: list[float]
) -> NDArray:
    return _read_as(_convention_of(rows, q_check, p_check), rows).forward(np.deg2rad(q))[:3, 3]


def wrong_points(
    rows: list[list[float]], q_check: list[float], p_check: list[float], q: list[float]
) -> Mistakes:
    right = _convention_of(rows, q_check, p_check)
    arm, angles = _read_as(right, rows), np.deg2rad(q)
    mistake, other = (
        ("craig-rows-in-standard-matrix", "standard")
        if right == "craig"
        else ("standard-rows-in-craig-matrix", "craig")
    )
    T = arm.forward(angles)
    yield (
        mistake,
        "this is the rows' other reading, which the check pose does not fit",
        _read_as(other, rows).forward(angles)[:3, 3],
    )
    yield "joint-values-unused", "this is the point at q = 0", arm.forward(0 * angles)[:3, 3]
    yield "degrees-in-sin-cos", "q went in in degrees", arm.forward(np.array(q, dtype=float))[:3, 3]
    yield (
        "degrees-in-sin-cos",
        "the rows were read as radians",
        _read_as(right, rows, "rad").forward(angles)[:3, 3],
    )
    yield (
        "offset-missing",
        "the rows' θ were left out",
        _read_as(right, np.array(rows) * [0, 1, 1, 1]).forward(angles)[:3, 3],
    )
    yield (
        "offset-subtracted",
        "this is the point at −q: all joints turned the other way",
        arm.forward(-angles)[:3, 3],
    )
    yield (
        "conversion-incomplete",
        "the rows were converted and then read in the convention they came from",
        _read_as(right, numbers(arm.to(other).table)).forward(angles)[:3, 3],
    )
    yield (
        "conversion-incomplete",
        "the rows were converted, and base or tool forgotten",
        _read_as(other, numbers(arm.to(other).table)).forward(angles)[:3, 3],
    )
    yield "rotation-block-misread", "this is the end's z arrow", T[:3, 2]
    yield "rotation-block-misread", "this is the last row of the rotation", T[2, :3]
    yield "pose-inverted", "this is the base's origin, seen from the end", -T[:3, :3].T @ T[:3, 3]


@dataclass(frozen=True, kw_only=True)
class CraigsMatrix(Function):
    """The function of 03.3; says which of the four moves is missing where one is."""

    def refine(
        self, mistake: str | None, answers: Sequence[NDArray], cases: Sequence[tuple]
    ) -> Known | None:
        values = "joint-values-unused", *map(value_mistake, COLUMNS)
        if mistake not in (None, "matrix-entry-mistyped", *values):
            return None
        for k, (name, move) in enumerate(zip(self.names, ("Rz(θ)", "Tz(d)", "Tx(a)", "Rx(α)"))):
            without = [
                craig(*(0 if i == k else value for i, value in enumerate(case))) for case in cases
            ]
            if np.allclose(answers, without, rtol=0, atol=1e-9):
                return mistake if mistake in values else None, Said(
                    f"{name} has no effect", next=f"Is {move} missing in the product?"
                )
        return None
