"""The Jacobians of lesson 08: what their wrong answers are told beyond what the doctor knows of
them.
"""

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ...doctor.programs.wrong.jacobians import geometric_jacobian
from ...robots import load
from ..kinds import Function, Said
from ..verdict import Verdict

__all__ = ["Jacobian"]

NEAR = 1e-9
IN_T_END = "The end of each call is in T_end: its fourth column."
POSE_AND_THREE = re.compile(r"shapes \((4,4\) \(3,|3,\) \(4,4)\)")  # T_end - p, or p - T_end


@dataclass(frozen=True, kw_only=True)
class Jacobian(Function):
    """A function of frames, end and kinds of joints that gives a Jacobian; what is wrong is told by
    the joints whose columns are, and by v and ω.
    """

    def compare(self, answer: object, variant: int) -> Verdict:
        verdict = super().compare(answer, variant)
        if not POSE_AND_THREE.search(verdict.headline):
            return verdict
        return replace(
            verdict,
            next="A whole pose, 4×4, and three numbers do not go together: which three numbers of"
            " the pose are its place?",
        )

    def refine(
        self, mistake: str | None, answers: Sequence[NDArray], cases: Sequence[tuple]
    ) -> tuple[str | None, str | Said] | None:
        """Where every lever runs, where that is not from the joint's axis to the end."""
        if mistake not in (None, "lever-arm-wrong"):
            return None
        for runs, sign in (("last frame to the end", 1), ("end to the last frame", -1)):
            if all(_along_the_tool(sign, J, *case) for J, case in zip(answers, cases)):
                return "lever-arm-wrong", Said(
                    "the lever does not begin on the joint's axis",
                    place=f"it runs from the {runs}, for every joint",
                    next="Which point of the joint's own axis is at hand in the loop?",
                )
        for place, end in _other_ends(len(cases[0][0])):
            if all(_ends_at(end, J, *case) for J, case in zip(answers, cases)):
                said = "the lever does not run to the end"
                return "lever-arm-wrong", Said(said, place=place, next=IN_T_END)
        return None

    def parts(
        self, answers: Sequence[NDArray], expected: Sequence[NDArray], cases: Sequence[tuple]
    ) -> str:
        off = np.abs(np.array(answers) - np.array(expected)) > NEAR
        v, omega = off[:, :3].any(), off[:, 3:].any()
        halves = "v and ω are" if v and omega else "v is" if v else "ω is"
        return f"{halves} wrong in {_columns(off.any(axis=1), cases)}"


def _ends_at(end, J, frames, T_end, sliding):
    """Whether a Jacobian is right but for its levers, which run to another point."""
    T = np.eye(4)
    T[:3, 3] = end(frames, T_end)
    return np.allclose(J, geometric_jacobian(frames, T, sliding), rtol=0, atol=NEAR)


def _along_the_tool(sign, J, frames, T_end, sliding):
    """Whether a Jacobian is right but for its levers, which are all the step that the tool adds."""
    lever, z = sign * (T_end[:3, 3] - frames[-1, :3, 3]), frames[:-1, :3, 2]
    v = np.where(sliding, z.T, np.cross(z, lever).T)
    return np.allclose(J, np.vstack([v, np.where(sliding, 0, z.T)]), rtol=0, atol=NEAR)


def _other_ends(many):
    """(what is said of it, the point) of what is likely to be taken for the end."""
    bent = load("article-6r").forward(np.deg2rad([0, 40, -60, 50, 40, 0]))[:3, 3]
    yield (
        "p is not among the arguments: it is the end at bent, from the cell above",
        lambda frames, T_end: bent,
    )
    yield (
        "p is 0, as if a row of the pose were taken: [3, :3] holds three zeros",
        lambda frames, T_end: np.zeros(3),
    )
    for k in range(many - 1):
        yield (
            f"p is the origin of frames[{k}], which is frames[{k - many}]",
            lambda frames, T_end, k=k: frames[k, :3, 3],
        )
    for k, name in enumerate("xyz"):
        yield (
            f"p is T_end[:3, {k}]: its {name} arrow, and no point",
            lambda frames, T_end, k=k: T_end[:3, k],
        )


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
