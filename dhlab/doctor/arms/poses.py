"""From measured poses: whether an arm's table is right, what is wrong with it, and what it looks
like repaired.
"""

from dataclasses import replace

import numpy as np

from ...arm import Arm
from ...printing import number
from ...robots.index import summary
from ...table import DHTable
from ...transform import to_xyz_rpy
from ..budget import CHOICE, SECONDS, budget_of
from ..diagnosis import AGREES, UNEXPLAINED
from .given import measured, oddities, one_in, thinned
from .rebuilding import rebuilt
from .search.fitting import misfit
from .unexplained import all_but_one, of_the_library, right_part, still_right
from .verdict import decide, explained
from .words.ranking import ranked

__all__ = ["diagnose"]


def diagnose(arm, q, poses, *, noise=None, base="fixed", tool="fixed", budget=SECONDS):
    """What is wrong with an arm's table, from measured poses.

    Parameters
    ----------
    arm : Arm or DHTable
        The candidate.
    q : array (m, n)
        Joint values, radians (metres for prismatic joints).
    poses : array (m, 4, 4) or (m, 3)
        What was measured there: poses, or positions only, in metres.
    noise : (float, float) or float, optional
        Standard deviation of one coordinate (m) and of one axis of rotation (rad), the first alone
        for positions; estimated when left out.
    base, tool : "fixed" or "free"
        Free: the measurements were taken in another base frame (to another tool frame), which is
        found as well.
    budget : float
        Seconds of processor time; when they are over, the best answer so far is given. Of more than
        500 poses as many are used, evenly from all.

    Returns
    -------
    Diagnosis
        ``verdict`` "agrees", "calibrated", "explained", "undecided" or "unexplained"; ``findings``
        together explain the data.

    Raises
    ------
    ValueError
        Wrong shapes, numbers that are not finite, matrices that are no poses; noise as large as the
        arm, or without an angle where there are rotations; a budget that is no time.

    Notes
    -----
    The rule: an explanation must leave no more misfit than the noise (χ² passed by noise alone but
    once in ten million draws), and it must be worth its price: a number that is fitted costs as
    much as a measured number tells, one that anybody would have guessed next to nothing. So six
    numbers fitted to six measured ones explain nothing. One mistake goes before two. A small misfit
    that small changes of all numbers explain about as well as one or two mistakes do is called a
    calibration. The noise is never taken for less than the digits of the measurements leave.

    Examples
    --------
    >>> import dhlab as dh
    >>> right = dh.load("article-6r")
    >>> rows = right.table.rows
    >>> rows[3, 3] *= -1
    >>> wrong = dh.Arm(dh.DHTable.standard(rows, angle="rad"))
    >>> q = np.random.default_rng(1).uniform(-2, 2, (6, 6))
    >>> answer = diagnose(wrong, q, right.forward(q))
    >>> answer.verdict, answer.findings[0].mistake, answer.findings[0].joint
    ('explained', 'alpha-sign', 4)
    """
    arm = Arm(arm) if isinstance(arm, DHTable) else arm
    clock = budget_of(budget, "diagnose")
    data, said = thinned(measured(arm, q, poses, noise, base, tool))
    try:
        answer = decide(arm, data, (*said, *oddities(arm, data)), clock)
        if answer.verdict == UNEXPLAINED:
            answer = _looked_at_again(arm, data, answer, clock)
    finally:
        clock.close()
    if answer.verdict != AGREES:
        answer = replace(answer, notes=clock.notes + answer.notes)
    placed, given = misfit(arm, data).arm, np.asarray(poses, dtype=float)
    if answer.verdict == AGREES and (data.base_free or data.tool_free):
        answer = replace(answer, fitted=placed, notes=answer.notes + _found_ends(placed, data))
    return replace(answer, compared=(placed, data.q, given[:: one_in(len(given))]))


def _looked_at_again(arm, data, answer, clock):
    """An answer that explained nothing, looked at once more: without one measurement, or with what
    is right all the same.
    """
    as_given, data = data, replace(data, stated=True)
    found = all_but_one(arm, data, clock)
    if found is None:
        return _of_many(arm, as_given, answer, clock)
    k, rest, ones = found
    part = clock.part("which of them is likeliest", CHOICE)
    best = ranked(arm, ones, rest, part)[0].fit.arm if ones else misfit(arm, rest).arm
    off = 1e3 * (best.forward(data.q[k])[:3, 3] - data.p[k])
    where = ", ".join(
        f"{number(-x, 1)} mm in {axis}"
        for x, axis in zip(off, "xyz")
        if abs(x) > 5e3 * data.noise[0]
    )
    said = (
        f"Measurement {k + 1} (the {_ordinal(k + 1)} line of numbers) does not belong to the"
        f" others: it is off by {where or 'its rotation'}. Read it again; it was left out here."
    )
    if ones:
        all_but = f"all measurements but number {k + 1}"
        return explained(arm, rest, misfit(arm, rest), ones, (said,), clock, all_but)
    return replace(
        answer,
        headline=f"The table agrees with every measurement but number {k + 1}.",
        notes=(said,),
    )


def _of_many(arm, data, answer, clock):
    """An answer that explained nothing, where many numbers are wrong: another model of the library,
    the arm rebuilt from the measurements, or what is right all the same.
    """
    at = replace(data, stated=True)
    model = of_the_library(arm, at, clock)
    said = answer.notes
    if model is not None:
        name, explanation, mistaken = model
        title = summary(name)["name"]
        said = (*said, f"The measurements fit the {title} as it stands ({name} of the library).")
        if mistaken:
            return explained(arm, at, misfit(arm, at), [explanation], said, clock)
    again = rebuilt(arm, data, clock)
    if again is None:
        return replace(answer, notes=said + still_right(arm, at))
    return replace(again, notes=said + tuple(right_part(misfit(arm, at), at)))


def _ordinal(k):
    return f"{k}{'th' if 10 < k % 100 < 14 else {1: 'st', 2: 'nd', 3: 'rd'}.get(k % 10, 'th')}"


def _found_ends(arm, data):
    """Where the free base and tool were found."""
    said = []
    for name in ("base", "tool"):
        if getattr(data, f"{name}_free"):
            xyz, rpy = to_xyz_rpy(getattr(arm, name))
            turn = (
                f", rpy ({', '.join(number(x, 2) for x in np.rad2deg(rpy))})°"
                if data.R is not None or name == "base"
                else ""
            )
            said.append(
                f"The {name} was found at xyz ({', '.join(number(x * 1e3, 1) for x in xyz)})"
                f" mm{turn}."
            )
    return tuple(said)
