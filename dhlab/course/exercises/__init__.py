"""Every exercise of the course, a module per sitting; a module's ``EXERCISES`` lists its own in the
order of the notebook. Most lessons are one sitting; lesson 08 is two, ``08`` and ``08b``, and one
lesson for due dates and marks.
"""

from functools import cache
from importlib import import_module
from pkgutil import iter_modules

from ..kinds import Exercise

__all__ = ["exercises", "sittings"]


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
    found: dict[str, Exercise] = {}
    for sitting, asked in _modules():
        for exercise in asked:
            if exercise.id in found:
                raise ValueError(
                    f"lesson{sitting}: expected every exercise id once, found {exercise.id} twice"
                )
            found[exercise.id] = exercise
    return found


@cache
def sittings() -> dict[str, tuple[str, ...]]:
    """The ids of the exercises and predictions of each sitting, in the order of the notebook.

    Returns
    -------
    dict of str to tuple of str

    Examples
    --------
    >>> [sitting for sitting in sittings() if sitting.startswith("08")]
    ['08', '08b']
    """
    return {sitting: tuple(exercise.id for exercise in asked) for sitting, asked in _modules()}


def _modules():
    """(sitting, its exercises) of each module, in the order of the course."""
    for module in sorted(m.name for m in iter_modules(__path__) if m.name.startswith("lesson")):
        yield module.removeprefix("lesson"), import_module(f"{__name__}.{module}").EXERCISES
