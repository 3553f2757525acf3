"""The whole arm: the table is that of another model."""

from functools import cache

import numpy as np

from ...robots import load, robots
from .changes import ArmChange
from .registry import mistake
from .remade import with_rows

__all__ = ["models"]

SAME = 1e-6  # m, rad


@mistake("another-model")
def another_model():
    """The table of another arm of the library, where the right one is in it too; told only where no
    other mistake explains the measurements, so it needs no way back.
    """

    def make(arm):
        known = [model for _, model in models(arm)]
        if any(_alike(arm, model) for model in known):
            yield from ((None, "", model) for model in known if not _alike(arm, model))

    yield ArmChange(make, only="arm")


def models(arm):
    """(name, the arm with the rows and senses of that model) for every model of the library with
    the same kinds of joints.
    """
    for name, model in _of_joints(arm.table.joints):
        rows, convention = model.table.rows, model.table.convention
        yield name, with_rows(arm, rows, convention=convention, sign=model.sign)


def _alike(a, b):
    return a.table.convention == b.table.convention and np.allclose(
        a.table.rows, b.table.rows, rtol=0, atol=SAME
    )


@cache
def _of_joints(joints):
    arms = [(name, load(name)) for name in robots()]
    return tuple((name, arm) for name, arm in arms if arm.table.joints == joints)
