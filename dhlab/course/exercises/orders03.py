"""What lesson 03 says of orders of moves, of classified tables and of Craig's matrix."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import permutations

import numpy as np
from numpy.typing import NDArray

from ...doctor.mistakes.registry import value_mistake
from ...doctor.programs.wrong.craig import craig, in_order
from ...doctor.programs.wrong.links import standard
from ...table import COLUMNS
from ..kinds import Function, Known, Said

__all__ = [
    "ARGUMENTS",
    "CRAIGS_WORDS",
    "CRAIG_ORDERS",
    "CraigsMatrix",
    "PUBLISHED",
    "REASONS",
    "SIDES",
    "explain_order",
    "explain_published",
    "explain_reasons",
    "explain_sides",
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


# 03.P1 asks what moves when one joint turns, so 03.1 does not say it
WHICH_END = (
    "Link i runs from the axis of joint i to that of joint i+1, the last one to where no joint is."
    " Which end has plate i?"
)


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


def _numbered(what, numbers):
    """Things by their numbers, as "statement 2" or "statements 1, 3"."""
    return f"{what}{'s' if len(numbers) > 1 else ''} {', '.join(map(str, numbers))}"


def explain_sides(given: list[str]) -> Known | None:
    wrong = _wrong_numbers(given, SIDES)
    if len(wrong) == 6:
        return "frame-at-other-end", Said(
            "all six: the two conventions have changed places", next=WHICH_END
        )
    named = _numbered("statement", wrong)
    if set(wrong) <= {3, 6}:
        return "frame-at-other-end", Said(
            f"look again at {named}: what lies between plate {{i-1}} and plate {{i}}",
            next=(
                "From plate to plate: do you meet the joint first, or the link? And which link is"
                " it, that before the joint or that behind it?"
            ),
        )
    return "frame-at-other-end", Said(f"look again at {named}", next=WHICH_END)


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

ARGUMENTS = Said(
    "the arguments are used in each other's places",
    next="Give one argument at a time, the other three 0: which move does it make?",
)

CRAIGS_ALPHA = Said(
    "alpha turns the wrong way",
    why="In Craig's matrix it is α_{i-1}: measured about x_{i-1}, from z_{i-1} to z_i.",
    next="Set theta, d and a to 0: is what is left rot_x(alpha)?",
)


CRAIGS_THETA = Said(
    "theta turns the wrong way",
    why="θ_i is measured about z_i, from x_{i-1} to x_i.",
    next="Set d, a and alpha to 0: is what is left rot_z(theta)?",
)
BOTH_TURNS = Said(
    "theta and alpha turn the wrong way",
    next="Give one angle at a time, all else 0: is what is left rot_z(theta), or rot_x(alpha)?",
)
INVERTED = Said(
    "this is the inverse of the right matrix",
    next="Where is the new frame, seen from the old one? That is asked, and not the reverse.",
)

CRAIGS_WORDS = {
    "craig-rows-in-standard-matrix": STANDARD_ORDER,
    "order-taken-for-free": OTHER_ORDER,
    "matrix-entry-mistyped": ENTRIES,
    "columns-misread": ARGUMENTS,
    "alpha-sign": CRAIGS_ALPHA,
    ("row-vector-convention", "the turn about z"): CRAIGS_THETA,
    ("row-vector-convention", ""): BOTH_TURNS,
    "pose-inverted": INVERTED,
}  # 03.3


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
    found_in = {
        where: [k for k in wrong if ZEROS[k - 1] == where] for where in ("row 1", "the last row")
    }
    said = [
        f"the zeros of {_numbered('table', found)} stand in {where}"
        for where, found in found_in.items()
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
    wrong = _numbered("pair", _wrong_numbers(given, REASONS))
    return "tables-differ-otherwise", Said(
        f"look again at {wrong}",
        next=(
            "Read the sentence of dh.equivalent once more: the same arm, only the end, a fraction"
            " of a millimetre, a zero moved, or counted the other way?"
        ),
    )


@dataclass(frozen=True, kw_only=True)
class CraigsMatrix(Function):
    """The function of 03.3; says which of the four moves is missing where one is."""

    def refine(
        self, mistake: str | None, answers: Sequence[NDArray], cases: Sequence[tuple]
    ) -> Known | None:
        values = "theta-unused", *map(value_mistake, COLUMNS)
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
