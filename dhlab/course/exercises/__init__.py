"""Every exercise of the course, a module per lesson; a module's ``EXERCISES`` lists its own in the
order of the lesson.
"""

from functools import cache
from importlib import import_module
from pkgutil import iter_modules

from ..kinds import Exercise

__all__ = ["exercises"]


@cache
def exercises() -> dict[str, Exercise]:
    """All exercises and predictions by id, in the order of the course.

    Returns
    -------
    dict of str to Exercise

    Raises
    ------
    ValueError
        Two exercises share an id.

    Examples
    --------
    >>> exercises()["06.2"].title
    'Forward kinematics'
    """
    found = {}
    for module in sorted(m.name for m in iter_modules(__path__) if m.name.startswith("lesson")):
        for exercise in import_module(f"{__name__}.{module}").EXERCISES:
            if exercise.id in found:
                raise ValueError(
                    f"{module}: expected every exercise id once, found {exercise.id} twice"
                )
            found[exercise.id] = exercise
    return found
