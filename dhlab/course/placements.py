"""The kind of exercise in which frames are placed on bare joint axes: each step is judged by :mod:`dhlab.placing`, and any valid choice passes."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ..equivalence import equivalent
from ..placing import Placement
from .kinds import Exercise, untouched
from .verdict import NOT_ATTEMPTED, RIGHT

__all__ = ["Frames", "MISTAKES"]

MISTAKES = {  # the catalogue's id for every rule of dhlab.placingrules that a choice can break
    "z-on-wrong-joint": "frame-at-other-end", "z-across-axis": "z-across-joint-axis", "z-not-along-axis": "z-across-joint-axis",
    "z-beside-axis": "z-across-joint-axis", "origin-off-z": "origin-off-common-normal", "origin-on-other-axis": "origin-off-common-normal",
    "origin-not-at-foot": "origin-off-common-normal", "origin-not-at-meeting": "origin-off-common-normal", "not-one-row": "four-numbers-for-any-pose",
    "x-along-z": "x-off-common-normal", "x-not-across-z": "x-off-common-normal", "x-not-across-other": "x-not-across-z",
    "x-in-plane": "x-off-common-normal", "x-misses-other-axis": "x-off-common-normal"}
TOLD = 3  # free choices that are named when somebody's right frames differ from ours


@dataclass(frozen=True, kw_only=True)
class Frames(Exercise):
    """Frames to be placed: a list with one ``[z, origin, x]`` per frame, 0 … n, in the base frame.

    ``draw(rng)`` gives the task's ``axes`` and ``end`` as :func:`dhlab.assign_frames` takes them; for a "smallest fix" also ``frames``, the
    broken ones that are handed out, which are no attempt as long as they are unchanged. What is still ``...`` is left out, and what is there is judged.
    """

    draw: Callable

    def given(self, variant):
        return self.draw(self.rng(variant))

    def judge(self, answer, variant=0):
        given = self.given(variant)
        handed_out = "frames" in given and _same(answer, given["frames"])
        return super().judge(None if handed_out else answer, variant)

    def compare(self, answer, variant):
        given = self.given(variant)
        rows = _rows(answer, len(given["axes"]) + 1)
        if isinstance(rows, str):
            return self.wrong(headline=rows, next="Write a list with one row [z, origin, x] per frame; each of the three has an x, a y and a z.")
        task = Placement(given["axes"], given["end"])
        wrong = _first_wrong(task, rows)
        if wrong is not None:
            return self._refused(wrong)
        if not task.finished:
            right = ", ".join(f"{letter}{i}" for i in range(len(rows)) for letter, placed in (("z", task.z), ("o", task.o), ("x", task.x)) if i in placed)
            return self.say(NOT_ATTEMPTED, place=f"right so far: {right}", next=f"Place {task.missing[0]}.")
        return self.say(RIGHT, f"{self.praise}{_other_choices(task)}")

    def _refused(self, judgement):
        mistake = MISTAKES.get(judgement.rule)
        return self.wrong(mistake, headline=f"{judgement.step} is not right. {judgement.message}", place=judgement.step,
                          next="" if mistake else "Three numbers in brackets, or X, Y, Z or -X, -Y, -Z.")


def _same(answer, frames):
    try:
        return np.allclose(np.array([[list(part) for part in row] for row in answer], dtype=float), frames)
    except (TypeError, ValueError):
        return False


def _rows(answer, count):
    """The answer as ``count`` rows of three, or a sentence."""
    try:
        rows = [list(row) for row in answer]
    except TypeError:
        return f"expected {count} rows [z, origin, x], one per frame, found {type(answer).__name__}"
    if len(rows) != count:
        return f"expected {count} rows [z, origin, x], frames 0 to {count - 1}, found {len(rows)}"
    short = next((i for i, row in enumerate(rows) if len(row) != 3), None)
    return rows if short is None else f"expected z, origin and x for frame {short}, found {len(rows[short])} entries"


def _first_wrong(task, rows):
    """Make every step that is there, all z first; the Judgement on the first wrong one, or None. What waits for a missing step waits."""
    steps = [(task.set_z, i, row[0]) for i, row in enumerate(rows)]
    steps += [step for i, row in enumerate(rows) for step in ((task.set_origin, i, row[1]), (task.set_x, i, row[2]))]
    for place, i, value in steps:
        judgement = None if untouched(value) else place(i, value)
        if judgement is not None and not judgement and judgement.rule != "order":
            return judgement
    return None


def _other_choices(task):
    """Which free choices were taken in another way than assign_frames takes them."""
    found = [choice.message for choice in equivalent(task.model, task.arm).differences]
    if not found:
        return ""
    more = f" and {len(found) - TOLD} more" if len(found) > TOLD else ""
    return f" Your table is another right one than ours: {'; '.join(found[:TOLD])}{more}."
