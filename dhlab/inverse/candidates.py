"""The solutions of one target with some joints held: found, verified, merged, kept to limits."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..arm import Arm
from ..transform import inverse
from .closedform import ClosedForm, closed_form
from .joints import counted, inside_by_turns, nearest_by_turns, variables
from .numeric.descent import Problem, approach
from .numeric.families import flat, same_family, settled, still_free
from .numeric.merging import merged
from .numeric.search import SHARP, arm_length, search
from .prepared import folder_of, is_ready
from .question import Question, free_joints
from .residuals import residuals

__all__ = ["Candidates", "by_closed_form", "by_search", "form_for", "needs_preparation"]

NOTHING = 1e-9  # rad, m
MEMBERS = 8  # of families that a search ran into: more are hardly of another one
SAMPLES = 8  # of the solutions of an arm with joints to spare, when none is held


@dataclass(frozen=True)
class Candidates:
    """What was found for one target.

    Parameters
    ----------
    q : array (k, n)
        Verified by the arm's own :meth:`Arm.forward`.
    outside : array (j, n)
        The same, but outside the limits, where these were to be kept.
    families : tuple of (k) tuples
        The joints of each that can move while the end stays.
    hold : dict
        Joints from 0 and the value of q they were held at.
    method : str
    complete : bool
    seen : array (n,) or None
        Where a search came nearest.
    """

    q: NDArray[np.float64]
    outside: NDArray[np.float64]
    families: tuple[tuple[int, ...], ...]
    hold: Mapping[int, float]
    method: str
    complete: bool
    seen: NDArray[np.float64] | None = None


def form_for(arm: Arm, hold: Mapping[int, float]) -> ClosedForm | None:
    """The closed form that is ready for use with these joints held, or None."""
    form = _any_form(arm, hold)
    ready = form is not None and (not form.general or (not hold and is_ready(arm.table)))
    return form if ready else None


def needs_preparation(arm: Arm) -> bool:
    """Whether a closed form could be had for this arm, were it derived first."""
    form = _any_form(arm, {})
    return form is not None and form.general and not is_ready(arm.table)


def _any_form(arm, hold):
    coupled = arm.coupling is not None
    if coupled and any((arm.coupling[joint] != np.eye(len(arm))[joint]).any() for joint in hold):
        return None  # what the controller holds is no joint's own angle
    at = np.zeros(len(arm))
    at[list(hold)] = list(hold.values())
    v = variables(arm, at)
    return closed_form(arm.table, tuple((joint, float(v[joint])) for joint in sorted(hold)))


def by_closed_form(question: Question, form: ClosedForm, hold: Mapping[int, float]) -> Candidates:
    """Every solution that ssik knows for one question."""
    arm = question.arm
    T_0n = inverse(arm.base) @ question.T @ inverse(arm.tool)
    if form.general:
        with folder_of(arm.table):
            v = form.solve(T_0n)
    else:
        v = form.solve(T_0n)
    return _sorted_out(question, counted(arm, v), hold, f"closed form, ssik {form.name}", True)


def by_search(questions: Sequence[Question], hold: Mapping[int, float]) -> list[Candidates]:
    """What a search finds for each question; these share everything but the target."""
    if not questions:
        return []
    first = questions[0]
    spare = free_joints(first.arm, hold).sum() > 6
    founds = search(
        first.arm,
        np.array([question.T for question in questions]),
        tolerance=first.tolerance,
        held=hold,
        near=first.near,
        within=first.limits and spare,
    )
    return [
        _sorted_out(question, found.q, hold, f"search from {found.starts} starts", False, found)
        for question, found in zip(questions, founds, strict=True)
    ]


def _sorted_out(question, q, hold, method, complete, found=None):
    """Verified, one of each, one of each family, in order, and kept to the limits."""
    arm, T, tolerance = question.arm, question.T, question.tolerance
    free = free_joints(arm, hold)
    q = _turned(question, _verified(question, q, free), hold)
    q, families = _families(question, q, free)
    q, members = merged(arm, q, T, tolerance)
    families = [families[same[0]] for same in members]
    q = _turned(question, q, hold)
    order = np.argsort(np.abs(q - question.reference).max(axis=1), kind="stable")
    if free.sum() > 6:
        order = order[:SAMPLES]
    kept = arm.within_limits(q).all(axis=1) | (not question.limits)
    # one member stands for its family: another one may keep the limits that this one breaks
    complete = complete and not any(families[k] for k in order if not kept[k])
    # one member stands for its family: another one may keep the limits that it breaks
    complete = complete and not any(families[k] for k in order if not kept[k])
    return Candidates(
        q[[k for k in order if kept[k]]],
        q[[k for k in order if not kept[k]]],
        tuple(families[k] for k in order if kept[k]),
        hold,
        method,
        complete,
        None if found is None else found.nearest,
    )


def _turned(question, q, hold):
    """Whole turns taken off or added: near the reference, and within the limits where that can be;
    what is held stays (of coupled joints, another one's turn may move it).
    """
    turned = nearest_by_turns(question.arm, q, question.reference)
    if question.arm.limits:
        turned = inside_by_turns(question.arm, turned)
    held = list(hold)
    moved = np.abs(turned[:, held] - q[:, held]).max(axis=1, initial=0.0) > NOTHING
    return np.where(moved[:, None], q, turned)


def _families(question, q, free):
    """Solutions (k, n) and the joints of each that can move while the end stays; those of a family
    moved to its member nearest to the reference, and each family once, as far as that can be told.
    """
    arm, T, tolerance = question.arm, question.T, question.tolerance
    bent = flat(arm, q, free) if free.sum() <= 6 else np.zeros(len(q), dtype=bool)
    away = np.abs(q - question.reference).max(axis=1, initial=0.0)
    members = np.flatnonzero(bent)[np.argsort(away[bent], kind="stable")][:MEMBERS]
    kept = list(q[~bent])
    families: list[tuple[int, ...]] = [()] * len(kept)
    for row in q[members]:
        moving = still_free(arm, row, T, tolerance, free)
        if moving:
            row = settled(arm, row, T, question.reference, tolerance, free)
        if not any(
            one == moving and same_family(arm, row, other, moving)
            for other, one in zip(kept, families, strict=True)
        ):
            kept.append(row)
            families.append(moving)
    return np.reshape(kept, (-1, len(arm))), families


def _verified(question, q, free):
    """Those of ``q`` (k, n) that reach the target; what is nearly there is walked the rest of the
    way first.
    """
    off = residuals(question.arm, q, question.T)
    rough = (off > SHARP * question.tolerance).any(axis=1)
    if rough.any():
        T = np.broadcast_to(question.T, (int(rough.sum()), 4, 4))
        problem = Problem(question.arm, T, arm_length(question.arm), free=free)
        q = q.copy()
        q[rough] = approach(problem, q[rough])
        off = residuals(question.arm, q, question.T)
    return q[(off <= question.tolerance).all(axis=1)]
