"""The Jacobians of lesson 08: what their wrong answers are told beyond what the doctor knows of
them.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..kinds import Function

__all__ = ["Jacobian"]

NEAR = 1e-9


@dataclass(frozen=True, kw_only=True)
class Jacobian(Function):
    """A function of frames, end and kinds of joints that gives a Jacobian; what is wrong is told by
    the joints whose columns are, and by v and ω.
    """

    def parts(
        self, answers: Sequence[NDArray], expected: Sequence[NDArray], cases: Sequence[tuple]
    ) -> str:
        off = np.abs(np.array(answers) - np.array(expected)) > NEAR
        v, omega = off[:, :3].any(), off[:, 3:].any()
        halves = "v and ω are" if v and omega else "v is" if v else "ω is"
        return f"{halves} wrong in {_columns(off.any(axis=1), cases)}"


def _columns(off, cases):
    """Which columns are wrong, of the mask (calls, n), in words that are true of every call."""
    slides = np.array([case[-1] for case in cases], dtype=bool)
    first = ", ".join(str(k + 1) for k in np.flatnonzero(off[0]))
    if off.all():
        return "every column"
    if (off == off[0]).all():
        return f"column {first}"
    for kind, of_kind in (("sliding", slides), ("turning", ~slides)):
        if (off == of_kind).all():
            return f"the columns of the {kind} joints, and in no others"
        if not off[~of_kind].any():
            return f"columns of {kind} joints only"
    return "other columns in every call"
