"""The whole arm: the table is that of another model."""

from functools import cache

from ...robots import load, robots
from .changes import ArmChange
from .registry import mistake
from .remade import with_rows

__all__ = ["models"]


@mistake("another-model")
def another_model():
    """The table of another arm of the library with the same kinds of joints; told only where no
    other mistake explains the measurements, so it needs no way back.
    """

    def make(arm):
        yield from ((None, "", model) for _, model in models(arm))

    yield ArmChange(make, only="arm")


def models(arm):
    """(name, the arm with the rows and senses of that model) for every model of the library with
    the same kinds of joints.
    """
    for name, model in _alike(arm.table.joints):
        rows, convention = model.table.rows, model.table.convention
        yield name, with_rows(arm, rows, convention=convention, sign=model.sign)


@cache
def _alike(joints):
    arms = [(name, load(name)) for name in robots()]
    return tuple((name, arm) for name, arm in arms if arm.table.joints == joints)
