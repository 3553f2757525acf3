"""From a picture of motion: one joint moved at a time, the circles it drew against those of the
table, and which row they accuse.
"""

from dataclasses import dataclass

import numpy as np

from ...arm import Arm
from ...geometry.conversion import require_uncoupled
from ...measure import fit_circles
from ...measure.circlewords import NO_PROOF, SMALLEST
from ...printing import number
from ...table import DHTable
from ..diagnosis import AGREES, CALIBRATED, EXPLAINED, UNEXPLAINED, Diagnosis
from .faults import ALPHA, THETA
from .fitting import Measured, fit, limit, misfit, with_parts, with_rows
from .naming import name_change

__all__ = ["diagnose_motion"]

EXACT = 1e-6  # m; less scatter is rounding
SURE = 5.0  # standard deviations: thirty numbers are compared
TINY = {
    "axis": np.deg2rad(0.5),
    "shift": 5e-3,
    "height": 5e-3,
    "radius": 5e-3,
    "phase": np.deg2rad(0.5),
}  # a calibration moves a circle so far


@dataclass(frozen=True)
class Sweep:
    """What one joint's circle (or line) says: whether its axis is where the table has it, whether
    the rest agrees, the words for it.
    """

    joint: int
    axis_right: bool | None  # None: nothing to be seen
    rest_right: bool | None
    tiny: bool
    words: str


def diagnose_motion(arm, q, points, *, noise=None):
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
    >>> answer = diagnose_motion(dh.Arm(dh.DHTable.standard(rows, angle="rad")), q, right.forward(q))
    >>> answer.findings[0].place, answer.findings[0].detail
    ('row 2, a', 'is 450 mm, should be 400 mm')
    """
    arm = Arm(arm) if isinstance(arm, DHTable) else arm
    if not isinstance(arm, Arm):
        raise ValueError(
            f"diagnose_motion: expected an Arm or a DHTable, found {type(arm).__name__}"
        )
    require_uncoupled(arm, "diagnose_motion")
    report = fit_circles(q, points, arm, noise=noise)
    q, points = np.asarray(q, dtype=float), np.asarray(points, dtype=float)
    data = Measured(
        q, points[:, :3, 3] if points.ndim == 3 else points, None, (noise or _scatter(report), 1.0)
    )
    sweeps = [
        _line(arm, data, c) if arm.table.joints[c.joint - 1] == "P" else _sweep(c)
        for c in report.circles
    ]
    return _decide(arm, data, sweeps, _notes(arm, sweeps, report))


def _scatter(report):
    """The standard deviation of a coordinate, from the distances off all circles."""
    circles = [c for c in report.circles if not c.fault]
    freedom = sum(2 * c.points - 6 for c in circles)
    total = sum(c.points * c.off_circle**2 for c in circles)
    return max(float(np.sqrt(total / freedom)) if freedom else EXACT, EXACT)


def _sweep(circle):
    if circle.fault:
        return Sweep(circle.joint, None, None, True, circle.words)
    wrong = {
        name
        for name, (value, sigma) in circle.differs.items()
        if abs(value) > max(SURE * sigma, 10 * SMALLEST[name])
    }
    tiny = all(abs(value) < TINY[name] for name, (value, _) in circle.differs.items())
    words = (
        circle.words
        if wrong
        else (
            f"Joint {circle.joint}: its circle agrees with the model's as far as the measurements"
            " can tell."
        )
    )
    return Sweep(
        circle.joint, not wrong & {"axis", "shift"}, not wrong - {"axis", "shift"}, tiny, words
    )


def _line(arm, data, circle):
    """A sliding joint: the direction in which its points go, against the table's."""
    rows = _own_rows(data.q, circle)
    q, p = data.q[rows, circle.joint - 1], data.p[rows]
    q = q - q.mean()
    v = q @ (p - p.mean(0)) / (q @ q)
    model = arm.jacobian(data.q[rows[0]])[:3, circle.joint - 1]
    angle = float(np.arctan2(np.linalg.norm(np.cross(model, v)), model @ v))
    sigma = data.noise[0] / np.sqrt(q @ q)
    right = angle < max(SURE * sigma, 1e-6)
    long = abs(np.linalg.norm(v) - 1) < max(SURE * sigma, 1e-6)
    said = (
        "agrees with the model in direction"
        if right
        else f"the line runs {number(np.rad2deg(angle), 3)}° off the model's"
    )
    said += (
        ""
        if angle < np.pi / 2
        else ", so it slides the other way, or an axis before it is turned round"
    )
    said += (
        " and in length"
        if long and right
        else (
            ""
            if long
            else (
                f"; a metre of the joint moves the point {number(np.linalg.norm(v), 4)} m, so look"
                " at its unit"
            )
        )
    )
    return Sweep(
        circle.joint,
        right,
        long,
        angle < TINY["axis"] and long,
        f"Joint {circle.joint}: it slides, so its points lie on a line: {said}.",
    )


def _own_rows(q, circle):
    """The rows in which the joint of this sweep moved and no other."""
    for first in range(len(q) - circle.points + 1):
        rows = np.arange(first, first + circle.points)
        moved = np.ptp(q[rows], axis=0) > 1e-3
        if moved[circle.joint - 1] and moved.sum() == 1:
            return rows


def _notes(arm, sweeps, report):
    """What each joint says, and what none can."""
    yield from (sweep.words for sweep in sweeps)
    missing = [str(i) for i in range(1, len(arm) + 1) if i not in {s.joint for s in sweeps}]
    if missing:
        yield (
            f"Not moved alone: joint {', '.join(missing)}; a mistake there cannot be told from one"
            " in its neighbours."
        )
    if report.left_out:
        yield (
            f"{report.left_out} measurement{'s belong' if report.left_out > 1 else ' belongs'} to"
            " no sweep of a single joint."
        )
    yield NO_PROOF


def _decide(arm, data, sweeps, notes):
    notes, known = tuple(notes), {"before": _size(arm, data), "compared": (arm, data.q, data.p)}
    if misfit(arm, data).chi2 <= limit(data.count):
        return Diagnosis(AGREES, "Every circle is where the table has it.", notes=notes, **known)
    if data.noise[0] > 2 * EXACT and all(s.tiny for s in sweeps):
        return Diagnosis(
            CALIBRATED,
            "The circles are a little off those of the table, as on every real arm; no mistake"
            " shows.",
            notes=notes,
            **known,
        )
    first, last, why = _accused(arm, sweeps)
    repairs = _explaining(arm, data, first, last, ends=True) or _explaining(
        arm, data, 1, len(arm), ends=False
    )
    if not repairs:
        return Diagnosis(
            UNEXPLAINED,
            "The circles are not those of the table, and no single change explains them.",
            notes=(why, *notes),
            **known,
        )
    findings = [
        name_change(arm, repaired, data, entries, ends) for repaired, entries, ends in repairs
    ]
    where = [f.place or f.detail for f in findings]
    alike = tuple(dict.fromkeys(place for place in where[1:] if place != where[0]))[:5]
    same = (
        (f"A change of {'; or of '.join(alike)} would do the same on these sweeps.",)
        if alike
        else ()
    )
    return Diagnosis(
        EXPLAINED,
        f"One mistake explains the circles: {where[0]}.",
        (findings[0],),
        after=_size(repairs[0][0], data),
        notes=(why, *same, *notes),
        **known,
    )


def _accused(arm, sweeps):
    """First and last row (1-based, standard) in which the mistake lies, and why, in words."""
    seen = {s.joint: s.axis_right for s in sweeps if s.axis_right is not None}
    wrong = min((joint for joint, right in seen.items() if not right), default=None)
    good = max((joint for joint in seen if wrong is None or joint < wrong), default=0)
    first, last = max(good, 1), len(arm) if wrong is None else max(wrong - 1, 1)
    rows = _rows_between(arm, first, last)
    if not seen:
        return 1, len(arm), "No joint drew a circle that can be compared, so no row is accused."
    if wrong is None:
        return (
            first,
            last,
            (
                f"Every axis seen is right, up to joint {good}'s: the mistake is in {rows} or in"
                " the tool."
            ),
        )
    axes = (
        f"The axis of joint {good} is right, that of joint {wrong} is not"
        if good
        else f"The axis of joint {wrong} is the first one seen, and it is not right"
    )
    return (
        first,
        last,
        (
            f"{axes}: the mistake is in {rows if good else rows + ' or in the base'}, or joint"
            f" {wrong} counts the other way."
        ),
    )


def _rows_between(arm, first, last):
    if arm.table.convention == "craig":
        behind = min(last + 1, len(arm))
        return (
            f"theta or d of row {first}{f' to {last}' if last > first else ''} or a or alpha of row"
            f" {min(first + 1, behind)}{f' to {behind}' if last > first else ''}"
        )
    return f"row {first}" if first == last else f"rows {first} to {last}"


def _explaining(arm, data, first, last, ends):
    """(repaired arm, entries, ends) for every change in the accused rows that leaves no more misfit
    than the noise; the smallest misfit first.
    """
    found = []
    for i in range(first - 1, min(last + 1, len(arm))):
        sense = np.where(np.arange(len(arm)) == i, -1, 1)
        found.append((misfit(with_parts(arm, sign=arm.sign * sense), data), (), ()))
    for entry in _entries(arm, first - 1, last - 1):
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
        yield from ((i, column) for column in (THETA, 1))
        if i + shift < len(arm):
            yield from ((i + shift, column) for column in (2, ALPHA))
    if first == 0 and shift:
        yield from ((0, column) for column in (2, ALPHA))


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
