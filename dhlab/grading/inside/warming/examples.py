"""Parts of the library that read files and compile patterns when they are first used. The warm
parent uses each once, on a known arm, so that its copies find it done.
"""

from collections.abc import Callable
from types import ModuleType

__all__ = ["used_once"]

PUMA = "theta d a alpha\nq1 0.672 0 90\nq2 0 0.4318 0\nq3 0.15 0.0203 -90\nq4 0.4318 0 90\n"
WRONG = "q5 0 0 90\nq6 0 0 0\n"  # the last twist but one has lost its sign


def _diagnose(module):
    import numpy as np

    import dhlab

    right = dhlab.load("puma560")
    rows = right.table.rows
    rows[4, 3] *= -1
    q = np.random.default_rng(0).uniform(-2, 2, (8, len(right)))
    module.diagnose(dhlab.Arm(dhlab.DHTable.standard(rows, angle="rad")), q, right.forward(q))


def _recognise(module):
    module.recognise_table(PUMA + WRONG)


USED: dict[str, Callable[[ModuleType], None]] = {
    "dhlab.doctor.arms.poses": _diagnose,
    "dhlab.doctor.tables.recognise": _recognise,
}


def used_once(module: ModuleType) -> None:
    """Use a module of the library as a lesson does; nothing for those that keep nothing."""
    USED.get(module.__name__, lambda module: None)(module)
