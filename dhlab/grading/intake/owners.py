"""Whose numbers does a notebook draw, and whose work may it be: what a key and a roster tell of
what was handed in, before any of it is run.
"""

import difflib
from collections.abc import Mapping, Sequence

from ..handing_out.variants import variant
from ..shown import some
from .roster import Student
from .submissions import Submission, voters

__all__ = ["look_whose"]

NEAR = 0.6  # how like a name of the roster a stranger's must be to be proposed
NEARLY_ALL = 0.9  # of people whom no roster knows, who have numbers that are nobody's


def look_whose(
    found: Mapping[str, Submission],
    roster: Sequence[Student],
    key: bytes | None,
    numbers: dict[str, int],
) -> list[str]:
    """Note at each submission whose numbers its notebooks draw, when these are not the student's
    own; nothing is given to anybody by that.

    Parameters
    ----------
    found : dict of str to Submission
        ``notes`` and ``numbers_of`` are added to; ``numbers`` gets a stranger's when they are
        somebody's of the roster.
    roster : sequence of Student
    key : bytes or None
    numbers : dict of str to int
        Each student's variant.

    Returns
    -------
    list of str
        Sentences for the teacher.

    Raises
    ------
    ValueError
        The numbers of most students are nobody's under this key; where no roster knows any of
        them, of nearly all.
    """
    names = {student.student: student.name for student in roster}
    owner = {variant(key, student): student for student in names or numbers} if key else {}
    drawn = {
        student: [
            (notebook.name, notebook.look.numbers)
            for notebook in mine.notebooks
            if notebook.look.lessons
        ]
        for student, mine in found.items()
    }
    ours = [[given for _, given in drawn[student]] for student in voters(found) if drawn[student]]
    on_it = bool(names) and any(mine.on_roster and mine.notebooks for mine in found.values())
    notes = _check_key(ours, owner, key, on_it)
    for student, mine in found.items():
        others = {
            owner[number] for _, given in drawn[student] for number in given if number in owner
        } - {student}
        mine.notes += (
            _own_notes(student, drawn[student], numbers[student], owner, names)
            if mine.on_roster
            else []
        )
        mine.numbers_of = min(others) if len(others) == 1 else None
        if not mine.on_roster:
            mine.notes.append(_stranger(student, mine, others, names))
            notes.append(f"{student}: {mine.notes[-1]}")
            numbers[student] = (
                numbers[mine.numbers_of] if mine.numbers_of in numbers else numbers[student]
            )
    common = sum(not any(own) for own in ours)
    if key and 2 * common > len(ours):
        notes.append(
            f"{common} students' notebooks have the numbers that are the same for all: were the"
            " lessons handed out without a key? Then leave out --key"
        )
    return notes


def _check_key(drawn, owner, key, on_roster):
    """A doubt where most have numbers that are nobody's; ValueError where those are the class."""
    # by student: one with many copies is still one
    foreign = sum(all(given and not given & owner.keys() for given in own) for own in drawn)
    if 2 * foreign <= len(drawn):
        return []
    what = "numbers of their own; give the key they were released with (--key)"
    if key:
        what = (
            "other numbers than this key gives to this roster; give the key and the roster they"
            " were released with (--key, --roster)"
        )
    told = f"{foreign} of {len(drawn)} students' notebooks have {what}"
    if on_roster or foreign >= NEARLY_ALL * len(drawn):
        raise ValueError(f"grade: {told}")
    return [told]


def _own_notes(student, drawn, number, owner, names):
    """What the teacher should know of the numbers in a student's notebooks."""
    for name, given in drawn:
        for other in sorted({owner[one] for one in given if one in owner and one != number}):
            yield f"{name}: has the numbers of {_called(other, names)}: look whose work it is"
        if given and not given & owner.keys():
            yield (
                f"{name}: has numbers that"
                f" {'this key gives to nobody' if owner else 'are not the same for all'}; marked"
                f" with {'the own ones' if owner else 'those of all'}"
            )
        if owner and not given:
            yield (
                f"{name}: has the numbers that are the same for all: was it the lesson of the"
                " course, not the one handed out? What is right by the letters of one of the two"
                " alone is to be marked"
            )


def _stranger(student, mine, others, names):
    """What is known of a submission that matches nobody of the roster."""
    if mine.names and not others:
        return (
            "not on the roster, and held apart with its files in the names of"
            f" {some(_called(other, names) for other in mine.names)}: what stands in one person's"
            " folder or zip is that person's; if it holds the work of several, move that out of it"
            " and grade again"
        )
    if others:
        proposal = (
            "these are the numbers of"
            f" {' and '.join(_called(other, names) for other in sorted(others))}"
        )
    else:
        called = {
            text.casefold(): one
            for one, name in names.items()
            for text in (one, name, *name.split())
            if text
        }
        words = [student.casefold(), *student.casefold().split()]
        near = dict.fromkeys(
            called[match]
            for word in words
            for match in difflib.get_close_matches(word, called, 3, NEAR)
        )
        proposal = (
            f"perhaps {' or '.join(_called(other, names) for other in list(near)[:3])}"
            if near
            else "nobody on it has a name like this"
        )
    return (
        f"not on the roster; {proposal}: give the file its owner's id as its name and grade again"
    )


def _called(student, names):
    return f"{student} ({names[student]})" if names.get(student) else student
