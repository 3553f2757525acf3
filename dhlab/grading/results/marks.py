"""``Mark`` and ``Graded``: what the grader says of one exercise, and of one student's submission;
as dataclasses and as JSON.
"""

from collections.abc import Mapping
from dataclasses import asdict, dataclass, fields
from typing import Any, Self

__all__ = [
    "Mark",
    "Graded",
    "RIGHT",
    "WRONG",
    "NOT_ATTEMPTED",
    "ERROR",
    "TIMED_OUT",
    "NOT_ALLOWED",
    "NOT_HANDED_IN",
    "TO_MARK",
    "MARKED",
    "GRADED",
    "UNREADABLE",
    "MISSING",
    "HELD",
]

RIGHT, WRONG, NOT_ATTEMPTED, ERROR, TIMED_OUT, NOT_ALLOWED = (
    "right",
    "wrong",
    "not attempted",
    "error",
    "timed out",
    "not allowed",
)
NOT_HANDED_IN = "not handed in"
TO_MARK, MARKED = "to be marked", "marked"  # by the teacher, of what no program can judge
GRADED, UNREADABLE, MISSING, HELD = "graded", "unreadable", "missing", "on hold"
OF_MARK = (
    RIGHT,
    WRONG,
    NOT_ATTEMPTED,
    ERROR,
    TIMED_OUT,
    NOT_ALLOWED,
    NOT_HANDED_IN,
    TO_MARK,
    MARKED,
)
OF_STUDENT = (GRADED, NOT_ATTEMPTED, UNREADABLE, TIMED_OUT, MISSING, HELD)


@dataclass(frozen=True)
class Mark:
    """What is said of one exercise of one submission.

    Parameters
    ----------
    exercise : str
        Its id, such as "05.2".
    status : str
        "right", "wrong", "not attempted", "error", "timed out", "not allowed" (it calls what it was
        to write), "not handed in" (no file of its lesson); of an explanation "to be marked"
        and, by the teacher, "marked".
    points, of : float
        Earned, and possible.
    mistake : str or None
        The id in the catalogue, when the mistake was recognised.
    headline, place, why, next : str
        The words of the course; the student may read them.
    note : str
        What only the teacher needs: a limit that was reached, an error that was met.
    file, handed_in : str
        The file the answer came from; when that was handed in, in the course's time zone, and how
        that is known.
    late_days, penalty : float
        Days after the due date, and the share of the points, 0 to 1, that is taken off for them.
    chosen : tuple of str
        Of an answer in letters: the ids of the options chosen, or "?".
    comment : str
        The teacher's own words, from decisions.yaml.
    answer : str
        Of an explanation: a short name of what was written, another one when that changes.

    Examples
    --------
    >>> mark = Mark("05.1", "right", 1, 1)
    >>> Mark.from_dict(mark.to_dict()) == mark
    True
    """

    exercise: str
    status: str
    points: float
    of: float
    mistake: str | None = None
    headline: str = ""
    place: str = ""
    why: str = ""
    next: str = ""
    note: str = ""
    file: str = ""
    handed_in: str = ""
    late_days: float = 0.0
    penalty: float = 0.0
    chosen: tuple[str, ...] = ()
    comment: str = ""
    answer: str = ""

    @property
    def lesson(self) -> str:
        """The lesson of the exercise."""
        return self.exercise.partition(".")[0]

    def __post_init__(self) -> None:
        if self.status not in OF_MARK:
            raise ValueError(
                f"Mark: expected a status of {', '.join(OF_MARK)}, found {self.status!r}; use one"
                " of these words"
            )

    def to_dict(self) -> dict[str, Any]:
        """A dict of text and numbers."""
        return asdict(self)

    @classmethod
    def from_dict(cls, given: Mapping[str, Any]) -> Self:
        """The Mark of such a dict."""
        known = _known(cls, given)
        return cls(**known | {"chosen": tuple(known.get("chosen", ()))})


@dataclass(frozen=True)
class Graded:
    """What is said of one student's submission.

    Parameters
    ----------
    student : str
        The id of the roster, or the one read off the file's name.
    file : str
        Where the submission was found, in words relative to the folder that was graded; empty when
        there is none.
    status : str
        "graded", "not attempted", "unreadable", "timed out", "missing" or, by the teacher, "on
        hold".
    marks : tuple of Mark
        One for every exercise asked for, also where the status is not "graded".
    variant : int
        Whose numbers the answers were compared with.
    late_days, penalty : float
        The most days that one of its exercises is late, and the share of all points, 0 to 1, that
        is taken off.
    cage : str
        The level the submission ran at.
    seconds : float
        How long it took; with ``number`` the only field in which two runs of the grader differ.
    notes : tuple of str
        Sentences for the teacher.
    guess_of : str or None
        Another student for whose variant the wrong answers are right, where chance does not explain
        it.
    numbers_of : str or None
        Another student whose numbers the notebook itself draws.
    fingerprint : str
        Of what was handed in and how it was to be graded: a later run grades again when it has
        changed.
    number : str
        What the inputs of graded calls were drawn from, with the teacher's key: drawn when the
        student is first graded, and kept, so that unchanged work gets the same marks again.
    bonus, comment : float, str
        The teacher's, from decisions.yaml.

    Examples
    --------
    >>> marks = Mark("05.1", "right", 2, 2), Mark("05.2", "wrong", 0, 2)
    >>> graded = Graded("ada", "ada.ipynb", "graded", marks, penalty=0.25)
    >>> graded.points, graded.of, graded.total
    (2, 4, 1.5)
    >>> Graded.from_dict(graded.to_dict()) == graded
    True
    """

    student: str
    file: str
    status: str
    marks: tuple[Mark, ...]
    variant: int = 0
    late_days: float = 0.0
    penalty: float = 0.0
    cage: str = ""
    seconds: float = 0.0
    notes: tuple[str, ...] = ()
    guess_of: str | None = None
    numbers_of: str | None = None
    fingerprint: str = ""
    number: str = ""
    bonus: float = 0.0
    comment: str = ""

    def __post_init__(self) -> None:
        if self.status not in OF_STUDENT:
            raise ValueError(
                f"Graded: expected a status of {', '.join(OF_STUDENT)}, found {self.status!r}; use"
                " one of these words"
            )

    @property
    def points(self) -> float:
        """The sum earned, before a late penalty."""
        return sum(mark.points for mark in self.marks)

    @property
    def of(self) -> float:
        """The sum possible; what is still to be marked is not counted yet."""
        return sum(mark.of for mark in self.marks if mark.status != TO_MARK)

    @property
    def total(self) -> float:
        """The points after the late penalty, with the bonus, to two decimals."""
        return round(self.points * (1 - self.penalty) + self.bonus, 2)

    def to_dict(self) -> dict[str, Any]:
        """A dict of text, numbers and lists, with ``points``, ``of`` and ``total`` for whoever
        reads the file.
        """
        return asdict(self) | {
            "marks": [mark.to_dict() for mark in self.marks],
            "notes": list(self.notes),
            "points": self.points,
            "of": self.of,
            "total": self.total,
        }

    @classmethod
    def from_dict(cls, given: Mapping[str, Any]) -> Self:
        """The Graded of such a dict."""
        known = _known(cls, given)
        return cls(
            **known
            | {
                "marks": tuple(map(Mark.from_dict, known["marks"])),
                "notes": tuple(known.get("notes", ())),
            }
        )


def _known(cls, given):
    return {field.name: given[field.name] for field in fields(cls) if field.name in given}
