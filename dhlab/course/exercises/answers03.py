"""What lesson 03 draws of tables to convert, what is right, and what wrong answers are told."""

from itertools import combinations
from typing import Any

import numpy as np

from ...arm import Arm
from ...table import DHTable
from ..kinds import Mistakes, Said, numbers

__all__ = [
    "COPIED",
    "badly_repaired",
    "draw_broken",
    "draw_craig",
    "draw_standard",
    "half_to_craig",
    "half_to_standard",
    "repaired",
    "to_craig",
    "to_standard",
]

COPIED = (
    "A conversion changes no number: θ and d keep their row, a and α change theirs. Compare signs"
    " and digits with the given table."
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
        ("the last pair came back in row 1; it belongs in the tool", "", rolled),
        ("θ and d moved, a and α did not", "from row 2 on θ and d moved, a and α did not", joints),
    ):
        yield "conversion-incomplete", _half(everywhere), wrong
        if not np.allclose(wrong[1:], right[1:]):
            yield "conversion-incomplete", _half(below), np.vstack([right[:1], wrong[1:]])
    yield (
        "conversion-incomplete",
        _half("the pairs moved down by two rows, and not by one"),
        _shifted(_shifted(given, 1), 1),
    )
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
    """What half a conversion looks like, twice: with a last row of its own, and with one that is
    right or left as it was.
    """
    given, right = np.array(rows), np.array(numbers(to_standard(rows).table))
    for headline, wrong in (
        ("the rows are those of Craig's table", given),
        ("α moved, a did not", np.column_stack([given[:, :3], right[:, 3]])),
        ("a moved, α did not", np.column_stack([right[:, :3], given[:, 3]])),
        ("the pairs moved down; from Craig to standard they move up", _shifted(given, 1)),
        ("the pairs moved up by two rows, and not by one", _shifted(_shifted(given, -1), -1)),
        ("θ and d moved as well; they stay in their rows", np.vstack([given[1:], np.zeros(4)])),
    ):
        yield "conversion-incomplete", _half(headline), wrong
        for last in (right[-1:], given[-1:]):
            if not np.allclose(wrong[:-1], right[:-1]):
                above = np.vstack([wrong[:-1], last])
                yield "conversion-incomplete", _half(f"above the last row: {headline}"), above
    rolled = np.column_stack([given[:, :2], np.roll(given[:, 2:], 1, axis=0)])
    yield (
        "conversion-incomplete",
        _half("the pairs moved down; from Craig to standard they move up"),
        rolled,
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
                    place=f"right so far, a of row {', '.join(str(i + 1) for i in mended)}",
                    next=(
                        "Where does the a of each link stand in the first table, and where must it"
                        " stand in Craig's?"
                    ),
                ),
                partly,
            )
    a = rows[:, 2]
    for up in (np.append(a[1:], 0), np.roll(a, -1)):
        yield (
            "conversion-incomplete",
            _half("a moved up; from standard to Craig it moves down"),
            np.column_stack([right[:, :2], up, right[:, 3]]),
        )
    yield from half_to_craig(standard)
    yield (
        "conversion-incomplete",
        _half("both columns moved, α for the second time"),
        _shifted(np.array(converted), 1),
    )
