"""Several people of one name, told apart by the numbers that platforms give to people."""

from collections.abc import Iterable
from statistics import median_low

from .layouts import Owner

__all__ = ["namesakes_of"]


def namesakes_of(owners: Iterable[Owner]) -> set[Owner]:
    """The owners of a name that several people have: a platform has written it at one place with
    more numbers than a person has there. A number beside several names is an assignment's.

    Examples
    --------
    >>> one, two = Owner("ada", True, "Ada", "7"), Owner("ada", True, "Ada", "8")
    >>> len(namesakes_of([one, two])), len(namesakes_of([one, two, Owner("bo", True, "Bo", "8")]))
    (2, 0)
    """
    owners = list(owners)
    sure = {owner.student for owner in owners if owner.number and owner.sure}
    people: dict[tuple[tuple[str, ...], str], set[str]] = {}  # by place and number
    for owner in owners:
        people.setdefault((owner.place, owner.number), set()).add(owner.student)
    numbers: dict[tuple[str, ...], dict[str, set[str]]] = {}  # by place and student
    for owner in owners:
        own = owner.number and len(people[owner.place, owner.number]) == 1
        if own and (owner.sure or owner.student not in sure):
            here = numbers.setdefault(owner.place, {})
            here.setdefault(owner.student, set()).add(owner.number)
    several = {
        student
        for here in numbers.values()
        for student, found in here.items()
        if len(found) > _numbers_of_one(here)
    }
    return {owner for owner in owners if owner.number and owner.student in several}


def _numbers_of_one(here):
    """How many numbers a person has at a place: one, or as many as most have there, which are those
    of several assignments.
    """
    counts = list(map(len, here.values()))
    return median_low(counts) if len(counts) > 2 else 1
