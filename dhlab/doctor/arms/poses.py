"""From measured poses: whether an arm's table is right, what is wrong with it, and what it looks
like repaired.
"""

from dataclasses import replace

import numpy as np

from ...arm import Arm
from ...printing import number
from ...table import DHTable
from ...transform import to_xyz_rpy
from ..diagnosis import AGREES, EXPLAINED, UNEXPLAINED
from .given import EXACT, measured
from .ranking import ranked
from .search.fitting import misfit
from .search.singles import calibrated, singles
from .unexplained import all_but_one, still_right
from .verdict import decide, explained

__all__ = ["diagnose"]

SPARE = 8  # so many numbers more than are fitted tell the noise
LARGEST_NOISE = (0.01, 0.05)  # beyond this nothing is explained any more
COARSE = (2e-3, 4e-3)  # supposed where the noise cannot be estimated: a ruler, a phone
FINE = 2e-3  # noise that all numbers together, fitted, do not leave by chance (m)


def diagnose(arm, q, poses, *, noise=None, base="fixed", tool="fixed"):
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

    Returns
    -------
    Diagnosis
        ``verdict`` "agrees", "calibrated", "explained" or "unexplained"; ``findings`` together
        explain the data.

    Raises
    ------
    ValueError
        Wrong shapes, numbers that are not finite, matrices that are no poses; noise as large as the
        arm, or without an angle where there are rotations.

    Notes
    -----
    The rule: an explanation must leave no more misfit than the noise (χ² passed by noise alone but
    once in ten million draws). One mistake goes before two; among these, fewer numbers that nobody
    would have guessed, then the smaller misfit. A small misfit (rms below 12 mm and 1.1°) that
    small changes of all numbers (1 mm, 0.1°) explain about as well as one mistake does is called a
    calibration.

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
    data = measured(arm, q, poses, noise, base, tool)
    answer = decide(arm, data, ()) if noise is not None else _without_level(arm, data)
    if answer.verdict == UNEXPLAINED:
        answer = _looked_at_again(
            arm, data if noise is not None else replace(data, noise=COARSE), answer
        )
    placed = misfit(arm, data).arm
    if answer.verdict == AGREES and (data.base_free or data.tool_free):
        answer = replace(answer, fitted=placed, notes=answer.notes + _found_ends(placed, data))
    return replace(answer, compared=(placed, data.q, np.asarray(poses, dtype=float)))


def _looked_at_again(arm, data, answer):
    """An answer that explained nothing, looked at once more: without one measurement, or with what
    is right all the same.
    """
    found = all_but_one(arm, data)
    if found is None:
        return replace(answer, notes=answer.notes + still_right(arm, data))
    k, rest, ones = found
    best = ranked(arm, ones, rest)[0].fit.arm if ones else misfit(arm, rest).arm
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
        return replace(
            explained(arm, rest, misfit(arm, rest), ones, (said,)),
            headline=f"One mistake explains all measurements but number {k + 1}.",
        )
    return replace(
        answer,
        headline=f"The table agrees with every measurement but number {k + 1}.",
        notes=(said,),
    )


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


def _without_level(arm, data):
    """The verdict where the noise is not known: one mistake in exact data, one in data with little
    noise, then two, then more noise.
    """
    answer = decide(arm, data, ("The measurements are exact to a micrometre.",), two=False)
    if answer.verdict in (AGREES, EXPLAINED):
        return answer
    estimated, enough = _estimate(arm, data)
    needed = -(-(4 * len(arm) + SPARE) * len(data.q) // data.count)
    few = (
        ()
        if enough
        else (
            (
                f"With {len(data.q)} poses the noise cannot be told from a mistake; say what it is,"
                f" or measure {needed} general ones."
            ),
        )
    )
    small = (
        [(estimated, False)] if enough and EXACT[0] < estimated[0] < FINE else []
    )  # two mistakes in exact data would leave more
    rounds = [
        *small,
        (EXACT, True),
        (estimated if estimated[0] < LARGEST_NOISE[0] else COARSE, True),
    ]
    for level, two in rounds if answer.verdict == UNEXPLAINED else [(estimated, True)]:
        said = (
            f"The noise was estimated from the data: {level[0] * 1e3:.2g} mm"
            + ("" if data.R is None else f", {np.rad2deg(level[1]):.2g}°")
            + "."
        )
        answer = decide(arm, replace(data, noise=level), (said, *few), two=two)
        if answer.verdict != UNEXPLAINED:
            break
    return answer


def _estimate(arm, data):
    """The noise that is left when every number is fitted, begun at the most promising arms; and
    whether the data suffice for it.
    """
    loose = replace(data, noise=(1e-3, 2e-3))
    spare = data.count - 4 * len(arm)
    enough = spare >= SPARE
    if not enough:
        return COARSE, False
    starts = [arm] + [
        e.fit.arm
        for e in sorted(singles(arm, loose), key=lambda e: e.fit.chi2)[:3]
        if e.data_fault is None
    ]
    best = None
    for start in starts:
        r = loose.residual(calibrated(start, loose).arm.forward(data.q))
        share = np.sqrt(data.count / spare)
        position = loose.noise[0] * np.sqrt((r[:, :3] ** 2).mean()) * share
        turn = (
            loose.noise[1] * np.sqrt((r[:, 3:] ** 2).mean()) * share if data.R is not None else 0.0
        )
        if best is None or position < best[0]:
            best = position, turn
    return (
        float(np.clip(best[0], EXACT[0], LARGEST_NOISE[0])),
        float(np.clip(best[1], EXACT[1], LARGEST_NOISE[1])),
    ), True
