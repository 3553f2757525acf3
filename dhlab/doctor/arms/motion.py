"""From a picture of motion: one joint moved at a time, the circles it drew against those of the
table, and which row they accuse.
"""

import numpy as np

from ...arm import Arm
from ...geometry.conversion import require_uncoupled
from ...measure import fit_circles
from ...table import DHTable
from ..budget import NAMES, SECONDS, budget_of
from ..diagnosis import AGREES, CALIBRATED, EXPLAINED, UNEXPLAINED, Diagnosis
from ..mistakes.remade import ALPHA, THETA, A, D, with_parts, with_rows
from .given import one_in
from .search.fitting import fit, misfit
from .search.measured import Measured, limit
from .sweeps import EXACT, accused, notes, scatter, sweep
from .words.naming import name_change

__all__ = ["diagnose_motion"]


def diagnose_motion(arm, q, points, *, noise=None, budget=SECONDS):
    """What is wrong with an arm's table, from sweeps in which one joint moved at a time.

    Parameters
    ----------
    arm : Arm or DHTable
        The candidate.
    q : array (m, n)
        Joint values of every measurement, in order: a sweep of one joint (at least four
        measurements) after the other.
    points : array (m, 3), or poses (m, 4, 4) of which the positions are taken
        The measured tool point, metres, in the base frame.
    noise : float, optional
        Standard deviation of a coordinate, m; estimated from the scatter about the circles when
        left out.
    budget : float
        Seconds of processor time; when they are over, the best answer so far is given. Of more than
        500 points a joint as many are used, evenly from all.

    Returns
    -------
    Diagnosis
        The headline says which rows are accused; the notes say of every joint what its circle
        shows.

    Raises
    ------
    ValueError
        Shapes that do not fit, or no sweep of a single joint.

    Notes
    -----
    A mistake before joint i moves the axis of joint i; one in row i or behind it changes the circle
    about it (height, radius, phase); an offset of the joint itself the phase alone. So the mistake
    lies between the last joint whose axis is right and the first whose axis is wrong. There every
    number and every joint's sense is tried; what leaves no more than the noise is named.

    Examples
    --------
    >>> import dhlab as dh
    >>> right = dh.load("article-6r")
    >>> rows = right.table.rows
    >>> rows[1, 2] = 0.45
    >>> q = np.tile([0.3, 0.4, -0.7, 0.5, 0.9, 0.2], (54, 1))
    >>> for i in range(6):
    ...     q[9 * i:9 * i + 9, i] = np.linspace(-1, 1, 9)
    >>> wrong = dh.Arm(dh.DHTable.standard(rows, angle="rad"))
    >>> answer = diagnose_motion(wrong, q, right.forward(q))
    >>> answer.findings[0].place, answer.findings[0].detail
    ('row 2, a', 'is 450 mm, should be 400 mm')
    """
    arm = Arm(arm) if isinstance(arm, DHTable) else arm
    if not isinstance(arm, Arm):
        raise ValueError(
            f"diagnose_motion: expected an Arm or a DHTable, found {type(arm).__name__}"
        )
    require_uncoupled(arm, "diagnose_motion")
    clock = budget_of(budget, "diagnose_motion")
    q, points = np.asarray(q, dtype=float), np.asarray(points, dtype=float)
    step = one_in(len(points) // len(arm)) if points.ndim > 1 and len(q) == len(points) else 1
    few = (f"Of {len(q)} points one in {step} was used.",) if step > 1 else ()
    q, points = q[::step], points[::step]
    report = fit_circles(q, points, arm, noise=noise)
    p = points[:, :3, 3] if points.ndim == 3 else points
    data = Measured(q, p, None, (noise or scatter(report), 1.0))
    sweeps = [sweep(arm, data, circle) for circle in report.circles]
    try:
        return _decide(arm, data, sweeps, (*few, *notes(arm, sweeps, report)), clock)
    finally:
        clock.close()


def _decide(arm, data, sweeps, notes, clock):
    known = {"before": _size(arm, data), "compared": (arm, data.q, data.p)}
    if misfit(arm, data).chi2 <= limit(data.count):
        return Diagnosis(AGREES, "Every circle is where the table has it.", notes=notes, **known)
    if data.noise[0] > 2 * EXACT and all(s.tiny for s in sweeps):
        headline = (
            "The circles are a little off those of the table, as on every real arm; no mistake"
            " shows."
        )
        return Diagnosis(CALIBRATED, headline, notes=notes, **known)
    first, last, why = accused(arm, sweeps)
    repairs = _explaining(arm, data, first, last, True, clock)
    repairs = repairs or _explaining(arm, data, 1, len(arm), False, clock)
    if not repairs:
        headline = "The circles are not those of the table, and no single change explains them."
        return Diagnosis(UNEXPLAINED, headline, notes=(*clock.notes, why, *notes), **known)
    part = clock.part("names of what fits", NAMES)
    findings = [
        name_change(arm, right, data, part, entries, ends) for right, entries, ends in repairs
    ]
    where = [f.place or f.detail for f in findings]
    return Diagnosis(
        EXPLAINED,
        f"One mistake explains the circles: {where[0]}.",
        (findings[0],),
        after=_size(repairs[0][0], data),
        notes=(*clock.notes, why, *_the_same(where), *notes),
        **known,
    )


def _the_same(where):
    """What else would do the same as the first."""
    alike = list(dict.fromkeys(place for place in where[1:] if place != where[0]))[:5]
    if alike:
        yield f"A change of {'; or of '.join(alike)} would do the same on these sweeps."


def _explaining(arm, data, first, last, ends, clock):
    """(repaired arm, entries, ends) for every change in the accused rows that leaves no more misfit
    than the noise; the smallest misfit first.
    """
    found = []
    for i in range(first - 1, min(last + 1, len(arm))):
        sense = np.where(np.arange(len(arm)) == i, -1, 1)
        found.append((misfit(with_parts(arm, sign=arm.sign * sense), data), (), ()))
    for entry in clock.within(_entries(arm, first - 1, last - 1), "one number at a time"):
        fits = [fit(start, data, (entry,), steps=20) for start in _starts(arm, entry)]
        found.append((min(fits, key=lambda f: f.chi2), (entry,), ()))
    if ends and first == 1:
        found.append((fit(arm, data, (), base=True, steps=40), (), ("base",)))
    if ends and last == len(arm):
        found.append((fit(arm, data, (), tool=True, steps=40), (), ("tool",)))
    good = [case for case in found if case[0].chi2 <= limit(data.count - case[0].fitted)]
    good.sort(key=lambda case: case[0].chi2 + 1 * len(case[1]) + 10 * len(case[2]))
    return [(_rounded(f, entries, data), entries, end) for f, entries, end in good]


def _entries(arm, first, last):
    """The (row, column) from 0 that stand between the axes of joints first and last + 1."""
    shift = arm.table.convention == "craig"
    for i in range(first, last + 1):
        yield from ((i, column) for column in (THETA, D))
        if i + shift < len(arm):
            yield from ((i + shift, column) for column in (A, ALPHA))
    if first == 0 and shift:
        yield from ((0, column) for column in (A, ALPHA))


def _starts(arm, entry):
    """The arm, and for an angle the arm with that angle all round: a fit only sees the nearest
    valley.
    """
    yield arm
    for turn in np.arange(1, 6) * np.pi / 3 if entry[1] in (THETA, ALPHA) else ():
        rows = arm.table.rows
        rows[entry] += turn
        yield with_rows(arm, rows)


def _rounded(found, entries, data):
    """The fitted number made as round as fits about as well: a right angle, whole degrees or
    millimetres, tenths, …
    """
    if not entries:
        return found.arm
    (entry,) = entries
    value, is_angle = found.arm.table.rows[entry], entry[1] in (THETA, ALPHA)
    value = (value + np.pi) % (2 * np.pi) - np.pi if is_angle else value
    for step in np.deg2rad([90, 1, 0.1, 0.01]) if is_angle else (1e-3, 1e-4, 1e-5):
        rows = found.arm.table.rows
        rows[entry] = step * np.round(value / step)
        trial = with_rows(found.arm, rows)
        if misfit(trial, data).chi2 <= min(limit(data.count), found.chi2 + 4):
            return trial
    return found.arm


def _size(arm, data):
    """Largest distance in mm; no angle is measured."""
    return float(1e3 * np.linalg.norm(arm.forward(data.q)[:, :3, 3] - data.p, axis=1).max()), float(
        "nan"
    )
