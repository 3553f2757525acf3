"""Arms made of checked ones, without checking them again."""

import numpy as np

from ...arm import Arm
from ...table import COLUMNS, DHTable

__all__ = ["THETA", "D", "A", "ALPHA", "with_rows", "with_parts"]

THETA, D, A, ALPHA = range(4)  # the columns of a table's rows


def with_rows(arm, rows, **parts):
    """The arm with other rows (theta, d, a, alpha in rad and m) and perhaps other parts.

    The search makes tens of thousands of arms from checked ones, so the checks of ``DHTable`` and
    ``Arm`` are not made again.
    """
    table, changed = object.__new__(DHTable), object.__new__(Arm)
    numbers = np.array(rows, dtype=float) + 0.0
    table.__dict__.update(
        zip(COLUMNS, numbers.T),
        _rows=numbers,
        convention=parts.pop("convention", arm.table.convention),
        joints=parts.pop("joints", arm.table.joints),
    )
    changed.__dict__.update(arm.__dict__, table=table, **parts)
    changed.__dict__.pop("_kinematics", None)  # worked out from the parts that were
    return changed


def with_parts(arm, **parts):
    """The arm with another base, tool, sign or coupling; unchecked, like :func:`with_rows`."""
    changed = object.__new__(Arm)
    changed.__dict__.update(arm.__dict__, **parts)
    changed.__dict__.pop("_kinematics", None)
    return changed
