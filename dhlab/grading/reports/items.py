"""How hard an exercise was, and whether it tells those who know from those who do not: classical
item analysis.
"""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..results.marks import GRADED, NOT_HANDED_IN, RIGHT, TIMED_OUT, TO_MARK, WRONG, Graded

__all__ = ["Item", "items"]

NOT_COUNTED = (NOT_HANDED_IN, TO_MARK)

ENOUGH = 10  # students; with fewer, a correlation is noise
ENOUGH_WRONG = 3  # who did not get it right; with fewer, one student makes the figure
EASY, HARD, FLAT = 0.95, 0.15, 0.1


@dataclass(frozen=True)
class Item:
    """One exercise, over all who handed in its lesson.

    Parameters
    ----------
    exercise : str
    statuses, mistakes : Counter
        How many marks have each status, and how many wrong ones each mistake (None: not named).
    difficulty : float
        The mean share of the points, 1 when everybody has all of them.
    discrimination : float or None
        The correlation with the points of all the other exercises; None with fewer than ten
        students, or when one of the two does not vary.
    """

    exercise: str
    statuses: Counter
    mistakes: Counter
    difficulty: float
    discrimination: float | None

    @property
    def warning(self) -> str:
        """A sentence on a question that may be a bad one; empty when it seems sound."""
        if self.discrimination is None:
            return ""
        if self.difficulty > EASY:
            return (
                "Nearly everybody is right: fine as practice, but it tells nothing of who"
                " understands."
            )
        if self.suspect and self.discrimination < 0:
            return (
                "Those who do well elsewhere do worse here: is the question misleading, or its"
                " answer wrong?"
            )
        if self.difficulty < HARD:
            return "Nearly nobody is right: was it taught, and does the text say what is asked?"
        return (
            "It hardly tells those who know from those who do not: read its text again."
            if self.suspect
            else ""
        )

    @property
    def suspect(self) -> bool:
        """Whether the question itself, not the class, may be at fault."""
        wrong = self.statuses.total() - self.statuses[RIGHT]
        return (
            self.discrimination is not None
            and self.discrimination < FLAT
            and self.difficulty <= EASY
            and wrong >= ENOUGH_WRONG
        )


def items(results: Sequence[Graded]) -> list[Item]:
    """The items of a class, in the order of the exercises.

    Students whose work could not be looked at are left out, and so is who did not hand in the
    exercise's lesson.

    Parameters
    ----------
    results : sequence of Graded

    Returns
    -------
    list of Item

    Examples
    --------
    >>> from dhlab.grading.results.marks import Graded, Mark
    >>> right, wrong = Mark("05.1", "right", 1, 1), Mark("05.1", "wrong", 0, 1)
    >>> ada, bo = Graded("ada", "", "graded", (right,)), Graded("bo", "", "graded", (wrong,))
    >>> [item] = items([ada, bo])
    >>> item.difficulty, item.discrimination is None
    (0.5, True)
    """
    looked_at = [graded for graded in results if graded.status in (GRADED, TIMED_OUT)]
    order = dict.fromkeys(
        mark.exercise
        for graded in looked_at
        for mark in graded.marks
        if mark.status not in NOT_COUNTED
    )
    return [
        _item(exercise, looked_at)
        for exercise in sorted(order, key=lambda exercise: exercise.partition(".")[0])
    ]


def _item(exercise, looked_at):
    pairs = [
        (mark, graded)
        for graded in looked_at
        for mark in graded.marks
        if mark.exercise == exercise and mark.status not in NOT_COUNTED
    ]
    marks = [mark for mark, _ in pairs]
    shares = np.array(
        [mark.points / mark.of if mark.of else mark.status == RIGHT for mark in marks], dtype=float
    )
    rest = np.array([_share_of_others(mark, graded) for mark, graded in pairs], dtype=float)
    return Item(
        exercise,
        Counter(mark.status for mark in marks),
        Counter(mark.mistake for mark in marks if mark.status == WRONG),
        float(shares.mean()),
        _correlation(shares, rest),
    )


def _share_of_others(mark, graded):
    """The share of the points of all other exercises that were handed in."""
    of = sum(other.of for other in graded.marks if other.status not in NOT_COUNTED) - mark.of
    return (graded.points - mark.points) / of if of else 0.0


def _correlation(shares, rest):
    if len(shares) < ENOUGH or np.ptp(shares) == 0 or np.ptp(rest) == 0:
        return None
    return float(np.corrcoef(shares, rest)[0, 1])
