"""The kind of exercise in which frames are placed on bare joint axes: each step is judged by
:mod:`dhlab.placing`, and any valid choice passes.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from ....arm import Arm
from ....geometry.equivalence import equivalent
from ....placing.board import Placement
from ...verdict import NOT_ATTEMPTED, RIGHT, Verdict
from .. import Exercise, Said, untouched
from ..exercise import listed
from ..kept import kept, kept_apart
from ..reading import as_numbers
from ..wrong.drawn import drawn_frames
from .framed import far_away, first_wrong, in_another_order, in_other_units, rows_of

__all__ = ["Frames", "MISTAKES", "WORDS"]

MISTAKES = {  # the catalogue's id for every rule of dhlab.placing that a choice can break
    "z-on-wrong-joint": "frame-at-other-end",
    "z-across-axis": "z-across-joint-axis",
    "z-not-along-axis": "z-across-joint-axis",
    "z-beside-axis": "z-across-joint-axis",
    "origin-off-z": "origin-off-common-normal",
    "origin-on-other-axis": "origin-off-common-normal",
    "origin-not-at-foot": "origin-off-common-normal",
    "origin-not-at-meeting": "origin-off-common-normal",
    "not-one-row": "four-numbers-for-any-pose",
    "x-along-z": "x-off-common-normal",
    "x-not-across-z": "x-off-common-normal",
    "x-not-across-other": "x-not-across-z",
    "x-in-plane": "x-off-common-normal",
    "x-misses-other-axis": "x-off-common-normal",
}
BESIDE = (
    "A housing may sit anywhere along its axis; the four numbers know only the line.",
    "Put the origin on z_i itself, then ask how z_i lies to the z before.",
)
THERE = (
    "A row ends where x_i arrives on z_i, and that is where its frame stands.",
    "Follow the row: along the z before it, then along x_i. On which line does it arrive?",
)
LEANING = (
    (
        "A row turns about the z before it, and then about x_i: only an x_i at right angles to both"
        " z axes fits."
    ),
    "Form the scalar product of x_i with each of the two z axes: both must be 0.",
)
# (why, next) of a rule, where the catalogue's words of its mistake were written for tables and
# programs, or for skew axes only
WORDS = {
    "z-on-wrong-joint": (
        (
            "The first turn of a row is about the z before it: z0 belongs to joint 1, z1 to joint"
            " 2, always one less."
        ),
        "Count the joints from the base.",
    ),
    "origin-off-z": BESIDE,
    "origin-on-other-axis": THERE,
    "origin-not-at-foot": (
        "Between skew axes only one line is at right angles to both and meets both.",
        "Draw the shortest line between the two axes: where does it arrive?",
    ),
    "origin-not-at-meeting": (
        "Where the two axes meet there is no way to walk: a is 0.",
        "Find the point that lies on both axes.",
    ),
    "not-one-row": (
        "A row walks along the z before it by d, then along x_i by a. It reaches no point beside.",
        (
            "Which way does x_i point, at right angles to both z axes? Start on the z before, and"
            " go along x_i only."
        ),
    ),
    "x-not-across-z": LEANING,
    "x-not-across-other": LEANING,
    "x-along-z": LEANING,
    "x-in-plane": (
        "Of axes that meet, only the normal of their plane is at right angles to both.",
        "Form the cross product of the two z axes.",
    ),
    "x-misses-other-axis": (
        "A row walks along x_i from one axis to the other.",
        "Are both origins right? Then point from the one axis straight across to the other.",
    ),
}
# of a frame that has no z before it
WORDS_OF_FIRST = {
    "origin-off-z": (BESIDE[0], "Put the origin on z_i itself; any point of it will do."),
    "x-along-z": (
        "The three arrows of a frame stand at right angles to each other.",
        "Any x_i at right angles to z_i will do: their scalar product must be 0.",
    ),
}
WORDS_OF_FIRST["x-not-across-z"] = WORDS_OF_FIRST["x-along-z"]
SLIDES = (
    "z lies along the direction of the slide, either way: a row's d is counted along z.",
    "Move the joint alone. Along which direction do all its points go?",
)
KINDS = {"z": "a z arrow", "o": "an origin", "x": "an x arrow"}  # told before the frame is
BY_HAND = 1e-3  # m; of arrows, of their length: nearer, a step is the same


@dataclass(frozen=True, kw_only=True)
class Frames(Exercise):
    """Frames to be placed: a list with one ``[z, origin, x]`` per frame, 0 … n, in the base frame.

    ``draw(rng)`` gives the task's ``axes`` and ``end`` as :func:`dhlab.assign_frames` takes them;
    for a "smallest fix" also ``frames``, the broken ones that are handed out, which are no attempt
    as long as they are unchanged; only the step that breaks a rule may then be another one. What is
    still ``...`` is left out, and what is there is judged. ``published(**given)`` is an Arm whose
    table is known by a name, ``known_as``: it is named of frames whose table it is, and others are
    compared with it; ``warning(task)`` is said of right frames that will not do later on.
    """

    greek: ClassVar[bool] = True
    draw: Callable
    published: Callable[..., Arm] | None = None
    known_as: str = "ours"
    warning: Callable[[Placement], str] = lambda task: ""

    @kept_apart
    def given(self, variant: int) -> Mapping[str, Any]:
        return self.draw(self.rng(variant))

    @kept
    def _bare(self, variant):
        """The task's axes with no frame placed on them: for copies, which ``cleared`` makes."""
        given = self.given(variant)
        return Placement(given["axes"], given["end"])

    def judge(self, answer: Any, variant: int = 0) -> Verdict:
        answer, given = listed(answer), self.given(variant)
        handed_out = "frames" in given and _same(answer, given["frames"])
        return super().judge(None if handed_out else answer, variant)

    def gaps(self, answer: Any) -> list[str]:
        return []  # what is there is judged

    def compare(self, answer: Any, variant: int) -> Verdict:
        given = self.given(variant)
        rows = rows_of(answer, len(given["axes"]) + 1)
        if isinstance(rows, str):
            return self.wrong(
                headline=rows,
                next=(
                    "Write a list with one row [z, origin, x] per frame; each of the three has an"
                    " x, a y and a z."
                ),
            )
        task = self._bare(variant).cleared()
        wrong = first_wrong(task, rows)
        if wrong is not None:
            unit = in_other_units(task, rows, wrong.step)
            if unit:
                return self.told("length-unit", unit)
            order = in_another_order(task, rows)
            if order:
                return self.told(None, order)
            return self.slowly(self._refused(task, wrong, _was_allowed(task, given, rows)))
        far = far_away(task)
        if far:
            return self.told("length-unit", far)
        if not task.finished:
            right = ", ".join(
                f"{letter}{i}"
                for i in range(len(rows))
                for letter, placed in (("z", task.z), ("o", task.o), ("x", task.x))
                if i in placed
            )
            return self.say(
                NOT_ATTEMPTED, place=f"right so far: {right}", next=f"Place {task.missing[0]}."
            )
        return self._mended(task, given, rows) if "frames" in given else self._finished(task, given)

    def _finished(self, task, given):
        """The Verdict on right frames: whose table theirs is, or how it is another one."""
        known = self.published and self.published(**given)
        choices = [c.message for c in equivalent(known or task.model, task.arm).differences]
        if choices:
            told = "; ".join(choices)
            says = f" The table of your frames is another right one than {self.known_as}: {told}."
        else:
            says = f" The table of your frames is {self.known_as}." if known else ""
        return self.say(RIGHT, self.praise + says + self.warning(task))

    def _mended(self, task, given, rows):
        """The Verdict on somebody's frames that keep every rule now: the step that broke one may be
        changed, and no other.
        """
        needless = _needless(task, given, rows)
        if not needless:
            return self.say(RIGHT, self.praise)
        choice = "a choice" if len(needless) == 1 else "choices"
        return self.slowly(
            self.wrong(
                headline="every rule is kept now, but more was changed than had to be",
                place=f"{', '.join(needless)}: allowed as handed out, {choice} and no broken rule",
                next="Put back what was allowed, and leave changed what broke a rule.",
            )
        )

    def drawn(self, answer: Any, variant: int = 0) -> Any:
        given = self.given(variant)
        rows = rows_of(answer, len(given["axes"]) + 1)
        if isinstance(rows, str):
            return None
        task = self._bare(variant).cleared()
        wrong = first_wrong(task, rows)
        if wrong is None:
            return None
        return drawn_frames(task, wrong, rows[int(wrong.step[1:])]["zox".index(wrong.step[0])])

    def _refused(self, task, judgement, allowed):
        step, rule = judgement.step, judgement.rule
        mistake = MISTAKES.get(rule)
        if mistake is None:
            return self.wrong(
                headline=f"{step} is not right. {judgement.message}{allowed}",
                place=step,
                next="Three numbers in brackets, or X, Y, Z or -X, -Y, -Z.",
            )
        i = int(step[1:])
        joint = task.joint(i) if mistake == "z-across-joint-axis" else None
        if joint and task.axes[joint - 1].letter == "P":
            message, (why, next_step) = (
                f"Joint {joint} slides, and this is not its direction.",
                SLIDES,
            )
        else:
            message = judgement.message
            why, next_step = (i == 0 and WORDS_OF_FIRST.get(rule)) or WORDS.get(rule, ("", ""))
        if rule == "x-misses-other-axis":
            message += "".join(f" z{k} runs through your o{k}." for k in _placed_lines(task, i))
        what = KINDS[step[0]] if self.sparing else step
        headline = f"{what} is not right. {message}{allowed}"
        if not why:
            return self.wrong(mistake, headline=headline, place=step)
        why, next_step = (text.replace("_i", str(i)) for text in (why, next_step))
        return self.wrong(mistake, place=Said(headline, next=next_step, why=why, place=step))


def _placed_lines(task, i):
    """Of z_{i-1} and z_i those that an origin was free to choose: a slide's, and the last."""
    joints = ((k, task.joint(k)) for k in (i - 1, i))
    return [k for k, joint in joints if joint is None or task.axes[joint - 1].letter == "P"]


def _same(answer, frames):
    try:
        return np.allclose(
            np.array([[list(part) for part in row] for row in answer], dtype=float), frames
        )
    except (TypeError, ValueError):
        return False


def _was_allowed(task, given, rows):
    """Which of the steps that a learner changed were right as they were handed out, as a sentence;
    "" when none was.
    """
    needless = _needless(task, given, rows) if "frames" in given else []
    were = "was" if len(needless) == 1 else "were"
    return f" {' and '.join(needless)} {were} allowed as handed out." if needless else ""


def _needless(task, given, rows):
    """The steps that were changed and broke no rule as they were handed out."""
    broken = first_wrong(task.cleared(), given["frames"])
    changed = [
        f"{letter}{i}"
        for i, (row, frame) in enumerate(zip(rows, given["frames"]))
        for letter, part, before in zip("zox", row, frame)
        if not untouched(part) and not _same_step(letter, part, before)
    ]
    return [step for step in changed if broken is None or step != broken.step]


def _same_step(letter, part, before):
    """Whether a step is as it was, within the inexactness of a hand; an arrow may be of another
    length.
    """
    part, before = as_numbers(part), as_numbers(before)
    if part.shape != before.shape:
        return False
    length = 1 if letter == "o" else np.linalg.norm(part) or 1
    return bool(np.linalg.norm(part / length - before) <= BY_HAND)
