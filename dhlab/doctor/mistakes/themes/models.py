"""The whole arm: the table is that of another model."""

from functools import cache

import numpy as np

from ....robots import robots
from ....robots.index import summary
from ....robots.likeness import like
from ..changes import ArmChange
from ..registry import mistake
from ..remade import with_rows

__all__ = ["models", "which_model"]

SAME = 1e-6  # m, rad
ID = "another-model"


@mistake(ID)
def another_model():
    """The table of another arm of the same maker, where the right one is in the library too: one of
    its models for another, which takes itself back.
    """

    def make(arm):
        # which arm this is the index tells, without a file read for each
        names = {found.name.partition(".")[0] for found in like(arm.table)}
        makers = {summary(name)["maker"] for name in names}
        known = list(models(arm, frozenset(makers)))
        if any(_alike(arm, model) for _, model in known):
            yield from ((None, "", model) for _, model in known if not _alike(arm, model))

    yield ArmChange(make, only="arm", twice=True)


def models(arm, makers=None):
    """(name, the arm with the rows and senses of that model) for every model of the library with
    the same kinds of joints, or of these makers alone.
    """
    for name, (rows, parts) in _known(arm.table.joints).items():
        if makers is None or summary(name)["maker"] in makers:
            yield name, with_rows(arm, rows, **parts)


def which_model(mistake, wrong, right):
    """(headline, note) that name the model that fits and the one whose table it was, where this
    mistake was made; else None.

    Examples
    --------
    >>> from dhlab.robots import load
    >>> which_model(ID, load("ur10_cb"), load("ur10e"))[0]
    'This arm is the Universal Robots UR10e; the table is that of another model.'
    """
    fitting = like(right.table)[:1] if mistake == ID else []
    if not fitting:
        return None
    told = _called(fitting[0])
    mine = like(wrong.table)[:1]
    whose = f" The numbers of your table are those of the {_called(mine[0])}." if mine else ""
    return (
        f"This arm is the {fitting[0].title}; the table is that of another model.",
        f"The measurements fit the {told}.{whose}",
    )


def _called(model):
    return f"{model.title} ({model.name.partition('.')[0]} in the library)"


def _alike(a, b):
    return a.table.convention == b.table.convention and np.allclose(
        a.table.rows, b.table.rows, rtol=0, atol=SAME
    )


@cache
def _known(joints):
    """The rows, and the other parts, of the best table of every model with these joints: as the
    index has them, without a file read for each.
    """
    best = {name: next(iter(summary(name)["tables"].values())) for name in robots()}
    return {
        name: (np.array(said["rows"]), _parts(said))
        for name, said in best.items()
        if said["joints"] == joints
    }


def _parts(said):
    coupling = said["coupling"]
    return {
        "convention": said["convention"],
        "sign": np.array(said["sign"]),
        "coupling": None if coupling is None else np.array(coupling),
    }
