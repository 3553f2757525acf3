"""Frames as a learner hands them in: read as rows of z, origin and x, put on a board step by step,
and the units of their origins.
"""

from collections.abc import Sequence
from itertools import permutations
from typing import Any

import numpy as np

from ....placing.board import Placement
from ....placing.words import Judgement
from ....printing import number
from ..exercise import Said, untouched
from ..reading import as_numbers, unusable

__all__ = ["far_away", "first_wrong", "in_another_order", "in_other_units", "rows_of"]

PARTS = "z", "origin", "x"
LENGTHS = {"millimetres": 1000, "centimetres": 100}
# one or two of x, y, z
COORDINATES = "x", "y", "z", "xy", "xz", "yz"
FAR = 30  # arm lengths, which no origin is away from the base


def rows_of(answer: Any, count: int) -> list[list[Any]] | str:
    """The answer as ``count`` rows of three, or a sentence."""
    asked = f"expected {count} rows [z, origin, x]"
    if not np.iterable(answer):
        return f"{asked}, one per frame, found {type(answer).__name__}"
    rows = [[...] * 3 if untouched(row) else row for row in answer]
    if as_numbers(answer).shape == (3, 3):
        return f"{asked}, one per frame, found a single one"
    if len(rows) != count:
        return f"{asked}, frames 0 to {count - 1}, found {len(rows)}"
    for i, row in enumerate(rows):
        if not np.iterable(row) or as_numbers(row).shape == (3,):
            return f"expected z, origin and x for frame {i}, three lists, found {row}"
        if len(list(row)) != 3:
            return f"expected z, origin and x for frame {i}, found {len(list(row))} entries"
    found = next(filter(None, (unusable(part) for row in rows for part in row)), "")
    return f"expected plain numbers, found {found}" if found else [list(row) for row in rows]


def first_wrong(task: Placement, rows: Sequence[Any]) -> Judgement | None:
    """Make every step that is there, all z first; the Judgement on the first wrong one, or None.
    What waits for a missing step waits.
    """
    lines = [(task.set_z, i, row[0]) for i, row in enumerate(rows)]
    return _first_wrong([*lines, *_after_lines(task, rows)])


def _after_lines(task, rows, first=0):
    """The steps that follow every z, from the frame ``first`` on."""
    for i, row in enumerate(rows):
        if i >= first:
            yield from ((task.set_origin, i, row[1]), (task.set_x, i, row[2]))


def _first_wrong(steps):
    for place, i, value in steps:
        judgement = None if untouched(value) else place(i, value)
        if judgement is not None and not judgement and judgement.rule != "order":
            return judgement
    return None


def in_other_units(task: Placement, rows: Sequence[Any], wrong: str) -> Said | None:
    """What is said of origins that are right in another unit than metres: of all that are there,
    of the ``wrong`` one, or of some of its coordinates; None. ``task`` has all that is right up to
    there.
    """
    if wrong[0] == "z":
        return None
    points = {i: as_numbers(row[1]) for i, row in enumerate(rows)}
    points = {i: point for i, point in points.items() if point.shape == (3,)}

    def fits(some, times):
        scaled = [list(row) for row in rows]
        for i in some:
            scaled[i][1] = points[i] * times
        first = min(*some, int(wrong[1:]))  # what comes before is as it was
        board = task.cleared(first)
        left = _first_wrong(_after_lines(board, scaled, first))
        return left is None or (len(some) == 1 and left.step != wrong)

    for name, some, places in _origins(points, wrong):
        if not any(np.any(points[i] * places) for i in some) or fits(some, 1 - places):
            continue  # what would be right with 0 as well does not tell its unit
        for unit, factor in LENGTHS.items():
            if fits(some, np.where(places, 1 / factor, 1)):
                return Said(
                    f"in other units: {name} in {unit}; metres are asked",
                    next=f"Divide by {factor}, once, whatever is in {unit}.",
                )
    return None


def _origins(points, wrong):
    """What may be in another unit: its name, which origins, and which of their coordinates."""
    yield "the origins", list(points), np.ones(3)
    i = int(wrong[1:])
    if i in points:
        yield f"o{i}", [i], np.ones(3)
        for names in COORDINATES:
            places = np.array([name in names for name in "xyz"], dtype=int)
            yield f"{' and '.join(names)} of o{i}", [i], places


def in_another_order(task: Placement, rows: Sequence[Any]) -> Said | None:
    """What is said of rows that would be right with their three entries in another order; None."""
    if any(untouched(part) for row in rows for part in row):
        return None
    for order in list(permutations(range(3)))[1:]:
        turned = [[row[k] for k in order] for row in rows]
        if first_wrong(task.cleared(), turned) is None:
            found = ", ".join(PARTS[order.index(k)] for k in range(3))
            return Said(
                f"the rows hold {found}; they are asked as z, origin, x",
                next="Write each frame's z first, its origin second, its x last.",
            )
    return None


def far_away(task: Placement) -> Said | None:
    """What is said of an origin that the rules allow, many times as far away as the arm is long."""
    for i, origin in task.o.items():
        away = np.linalg.norm(origin)
        if away > FAR * max(task.reach, float(np.linalg.norm(task.end[:3, 3]))):
            return Said(
                f"o{i} lies {number(away, 0)} m from the base",
                next="Metres are asked. Is a number of it in millimetres or centimetres?",
                place=f"o{i}",
            )
    return None
