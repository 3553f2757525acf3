"""``solve``: every solution of a pose in closed form where there is one, by search elsewhere."""

from collections.abc import Mapping
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..arm import Arm
from .candidates import Candidates, by_closed_form, by_search, form_for, needs_preparation
from .closedform import installed, prepare_table
from .question import Question
from .reasons import explained
from .redundancy import given_holds, joint_to_hold, usual_holds
from .residuals import require_targets, residuals
from .solutions import Solutions

__all__ = ["prepare", "solve"]

METHODS = (None, "closed form", "search")
INSTALL = "pip install 'dhlab-kinematics[ik]'"
PREPARE = "dhlab.inverse.prepare(arm), or dhlab ik ARM --prepare"


def solve(
    arm: Arm,
    T: ArrayLike,
    *,
    limits: bool = False,
    near: ArrayLike | None = None,
    redundancy: Any = None,
    tolerance: float = 1e-9,
    method: str | None = None,
) -> Solutions | list[Solutions]:
    """The configurations that bring the end to a pose; the door is :meth:`Arm.solve`, which says
    what the arguments are.

    Examples
    --------
    >>> import dhlab as dh
    >>> arm = dh.load("ur5e")
    >>> q = [0.1, -1.2, 1.4, -0.8, 0.7, 0.2]
    >>> len(solve(arm, arm.forward(q)))
    8
    """
    targets, single = require_targets(T)
    asked = _question(arm, limits, near, redundancy, tolerance)
    if method not in METHODS:
        raise ValueError(
            f'solve: method: expected "closed form", "search" or None for what there is, found'
            f" {method!r}"
        )
    questions = [replace(asked, T=target) for target in targets]
    usual = asked.holds is None and len(arm) == 7 and not arm.table.prismatic.any()
    found = (_with_a_spare_joint if usual and questions else _plainly)(questions, method)
    answers = [_answer(*pair, method) for pair in zip(questions, found, strict=True)]
    return answers[0] if single else answers


def prepare(arm: Arm) -> bool:
    """Derive, once, what the closed form of a general six-axis arm needs: minutes of work, kept in
    the user's cache folder for this table. Nothing to do for other arms.

    Parameters
    ----------
    arm : Arm

    Returns
    -------
    bool
        Whether :meth:`Arm.solve` has a closed form for this arm now.

    Examples
    --------
    >>> import dhlab as dh
    >>> prepare(dh.load("stanford"))
    False
    """
    prepare_table(arm.table)
    return form_for(arm, {}) is not None


def _question(arm, limits, near, redundancy, tolerance):
    """What holds for every target, checked."""
    number = isinstance(tolerance, (int, float, np.number)) and not isinstance(tolerance, bool)
    if not (number and 0 < tolerance < 1):
        raise ValueError(
            "solve: tolerance: expected a number above 0 and below 1 (metres and radians), found"
            f" {tolerance!r}"
        )
    if near is not None:
        near = arm._checked(near)
        if near.ndim != 1:
            raise ValueError(
                f"solve: near: expected one configuration of {len(arm)} values, found shape"
                f" {near.shape}"
            )
    holds = None if redundancy is None else tuple(given_holds(arm, redundancy))
    anywhere = np.eye(4)  # each target takes its place
    return Question(arm, anywhere, bool(limits), near, holds, float(tolerance))


def _plainly(questions, method):
    """The solutions with every stated hold, or with none: a list of Candidates for each
    question.
    """
    stated = questions[0].holds if questions else None
    holds: tuple[Mapping[int, float], ...] = stated or ({},)
    by_hold = [_at(questions, hold, method) for hold in holds]
    return [list(row) for row in zip(*by_hold, strict=True)]


def _with_a_spare_joint(questions, method):
    """Seven turning joints and no stated redundancy: the first of the usual values that serves."""
    arm = questions[0].arm
    found: list[list[Candidates]] = [[] for _ in questions]
    for k, hold in enumerate(usual_holds(arm, questions[0].near)):
        form = method != "search" and form_for(arm, hold)
        if k and not form:
            continue  # one search with the joint held is enough, before it is let go
        left = [i for i, mine in enumerate(found) if not (mine and len(mine[-1].q))]
        here = _at([questions[i] for i in left], hold, "closed form" if form else method)
        for i, one in zip(left, here, strict=True):
            found[i].append(one)
    left = [i for i, mine in enumerate(found) if not len(mine[-1].q)]
    if method == "closed form":
        return found
    for i, freely in zip(left, by_search([questions[i] for i in left], {}), strict=True):
        found[i].append(_held_there(questions[i], freely, method))
    return found


def _held_there(question, freely, method):
    """What was found with no joint held, with the usual joint held where it was found."""
    if not len(freely.q):
        return freely
    joint = joint_to_hold(question.arm)
    there = _at([question], {joint: float(freely.q[0, joint])}, method)[0]
    return there if len(there.q) else replace(freely, q=freely.q[:1], families=freely.families[:1])


def _at(questions, hold, method):
    """Candidates for each question, with these joints held."""
    if not questions:
        return []
    arm = questions[0].arm
    form = None if method == "search" else form_for(arm, hold)
    if form is None:
        if method == "closed form":
            raise ValueError(_no_closed_form(arm, hold))
        return by_search(questions, hold)
    found = [by_closed_form(question, form, hold) for question in questions]
    if method != "closed form":  # none in closed form is no proof that there is none
        doubted = [i for i, one in enumerate(found) if not len(one.q) and not len(one.outside)]
        again = by_search([questions[i] for i in doubted], hold)
        for i, one in zip(doubted, again, strict=True):
            found[i] = one
    return found


def _no_closed_form(arm, hold):
    start = f"solve: {arm.name or 'the arm'} has no closed form here"
    if not installed():
        return f"{start}: ssik is not installed; {INSTALL}, or leave method out for a search"
    if not hold and needs_preparation(arm):
        return f"{start} yet: it takes minutes to derive, once; {PREPARE}, or leave method out"
    return f"{start}: ssik solves six turning joints; leave method out for a search"


def _answer(question, found, method):
    """What the user gets."""
    hits = [one for one in found if len(one.q)] or found[-1:]
    q = np.concatenate([one.q for one in hits])
    seen = [one.seen for one in found if one.seen is not None]
    outside = np.concatenate([one.outside for one in found])
    complete = all(one.complete for one in hits)
    return Solutions(
        question,
        q,
        residuals(question.arm, q, question.T),
        "; ".join(dict.fromkeys(one.method for one in hits)),
        complete,
        tuple(joints for one in hits for joints in one.families),
        tuple({joint + 1: value for joint, value in one.hold.items()} for one in hits if one.hold),
        outside,
        tuple(_notes(question, hits, method)),
        partial(explained, question, outside, seen[-1] if seen else None, complete),
    )


def _notes(question, hits, method):
    arm, hold = question.arm, hits[0].hold
    if len(arm) > 6 and question.holds is None and len(hits[0].q):
        at = " and ".join(f"joint {joint + 1} at {value:.4g}" for joint, value in hold.items())
        yield (
            f"{len(arm)} joints reach a pose in endlessly many ways; these are"
            + (f" those with {at} (rad)" if hold else " some of them")
            + "; redundancy={joint: value} asks for others."
        )
    if not hits[0].complete and len(hits[0].q):
        yield "A search found them; there may be more."
    if method is None and not hits[0].complete:
        if not installed() and len(arm) in (6, 7) and not arm.table.prismatic.any():
            yield f"In closed form, and faster: {INSTALL}."
        elif not hold and len(arm) == 6 and needs_preparation(arm):
            yield f"For a closed form this arm has to be prepared, minutes, once: {PREPARE}."
