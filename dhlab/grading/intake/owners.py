"""Whose numbers a notebook has, and whose work it may be: what the key and the roster tell of what
was handed in, before any of it is run.
"""

import difflib
from collections.abc import Mapping, Sequence

from ..handing_out.variants import variant
from ..shown import some
from .roster import Student
from .submissions import Submission, voters

__all__ = ["look_whose"]

NEAR = 0.6  # how like a name of the roster a stranger's must be to be proposed
# where no roster knows anybody: when this share has numbers that are nobody's, the key is wrong
NEARLY_ALL = 0.9


def look_whose(
    found: Mapping[str, Submission],
    roster: Sequence[Student],
    key: bytes | None,
    numbers: dict[str, int],
) -> list[str]:
    """Note at each submission whose numbers its notebooks have, when these are not the student's
    own. The notes are for the teacher: they move nobody's file to anybody.

    Parameters
    ----------
    found : dict of str to Submission
        ``notes`` is added to, and ``numbers_of`` set.
    roster : sequence of Student
    key : bytes or None
    numbers : dict of str to int
        Each student's variant; a stranger gets that of the student of the roster whose numbers the
        stranger's notebooks have.

    Returns
    -------
    list of str
        Sentences for the teacher.

    Raises
    ------
    ValueError
        Most students of the roster have numbers that this key gives to nobody; where none of the
        roster handed in, nearly all have.
    """
    names = {student.student: student.name for student in roster}
    owner = {variant(key, student): student for student in names or numbers} if key else {}
    # by student the numbers in each notebook of the course
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
        given = {number for _, numbers_in in drawn[student] for number in numbers_in}
        others = {owner[number] for number in given if number in owner} - {student}
        mine.numbers_of = min(others) if len(others) == 1 else None
        if mine.on_roster:
            mine.notes += _own_notes(drawn[student], numbers[student], owner, names)
        else:
            mine.notes.append(_stranger(student, mine, others, names))
            notes.append(f"{student}: {mine.notes[-1]}")
            if mine.numbers_of in numbers:
                numbers[student] = numbers[mine.numbers_of]
    common = sum(not any(own) for own in ours)
    if key and 2 * common > len(ours):
        notes.append(
            f"{common} students' notebooks have the numbers that are the same for all: were the"
            " lessons handed out without a key? Then leave out --key"
        )
    return notes


def _check_key(drawn, owner, key, on_roster):
    """Sentences for the teacher where more than half have numbers that are nobody's; ValueError
    where these are students of the roster, or nearly all: then the key is the wrong one. ``drawn``
    has an entry for each student, so that many copies of one notebook count once.
    """
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


def _own_notes(drawn, number, owner, names):
    """What the teacher should know of the numbers in the notebooks of a student, whose own number
    is given; ``owner`` names the student of each number, and is empty without a key.
    """
    for name, given in drawn:
        for other in sorted({owner[one] for one in given if one in owner and one != number}):
            yield f"{name}: has the numbers of {_called(other, names)}: look whose work it is"
        if given and not given & owner.keys():
            yield (
                f"{name}: has numbers that this key gives to nobody; it is marked with this"
                " student's own"
                if owner
                else f"{name}: has numbers of somebody's own; without a key it is marked with those"
                " that are the same for all"
            )
        if owner and not given:
            yield (
                f"{name}: has the numbers that are the same for all: was it the lesson of the"
                " course, not the one handed out? What is right by the letters of one of the two"
                " alone is to be marked"
            )


def _stranger(student, mine, others, names):
    """What is known of a submission that matches nobody of the roster; ``others`` are the students
    of the roster whose numbers it has.
    """
    if mine.names and not others:
        return (
            "not on the roster, and held apart with its files in the names of"
            f" {some(_called(other, names) for other in mine.names)}: what stands in one person's"
            " folder or zip is that person's; if it holds the work of several, move that out of it"
            " and grade again"
        )
    if others:
        told = " and ".join(_called(other, names) for other in sorted(others))
        proposal = f"these are the numbers of {told}"
    else:
        near = " or ".join(_called(other, names) for other in _near(student, names))
        proposal = f"perhaps {near}" if near else "nobody on it has a name like this"
    return (
        f"not on the roster; {proposal}: give the file its owner's id as its name and grade again"
    )


def _near(called, names):
    """The students, at most three, whose id or name is most like what somebody is called."""
    known = {
        text.casefold(): student
        for student, name in names.items()
        for text in (student, name, *name.split())
        if text
    }
    words = [called.casefold(), *called.casefold().split()]
    near = dict.fromkeys(
        known[match] for word in words for match in difflib.get_close_matches(word, known, 3, NEAR)
    )
    return list(near)[:3]


def _called(student, names):
    return f"{student} ({names[student]})" if names.get(student) else student
