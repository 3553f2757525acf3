"""What a class chose where an exercise is answered in letters."""

from collections import Counter
from collections.abc import Sequence

from ...course.kinds import UNDECIDED, Choice, Exercise, Order
from ..results.marks import RIGHT, Mark

__all__ = ["chosen_answers"]

MOST = 5  # orders, the commonest; of a choice all options are shown


def chosen_answers(exercise: Exercise | None, marks: Sequence[Mark]) -> list[dict]:
    """How many chose what, by letters and texts as everybody has them without a variant.

    Parameters
    ----------
    exercise : Exercise or None
    marks : sequence of Mark
        Those of this exercise.

    Returns
    -------
    list of dict
        With ``letters``, ``text``, ``right`` and ``count``; empty for other kinds of exercises, and
        where nobody answered.

    Examples
    --------
    >>> from dhlab.course.exercises import exercises
    >>> mark = Mark("02.2", "right", 1, 1, chosen=("link-offset",))
    >>> [line for line in chosen_answers(exercises()["02.2"], [mark]) if line["count"]]
    [{'letters': 'd', 'text': 'the link offset d', 'right': True, 'count': 1}]
    """
    counts = Counter(mark.chosen for mark in marks if mark.chosen)
    if not counts or not isinstance(exercise, (Choice, Order)):
        return []
    right = {mark.chosen for mark in marks if mark.status == RIGHT}
    if isinstance(exercise, Choice):
        chosen: list[tuple[str, ...]] = [(key,) for key in (*exercise.options, UNDECIDED)]
        right.add((exercise.correct,))
    else:
        chosen = [ids for ids, _ in counts.most_common(MOST)]
    return [
        dict(
            zip(("letters", "text"), exercise.read_back(ids)), right=ids in right, count=counts[ids]
        )
        for ids in chosen
    ]
