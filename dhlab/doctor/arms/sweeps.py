"""Sweeps: what the circle (or line) of one moved joint says of its axis and of the rows behind."""

from dataclasses import dataclass

import numpy as np

from ...measure.circlewords import NO_PROOF, SMALLEST
from ...printing import number

__all__ = ["EXACT", "Sweep", "accused", "notes", "scatter", "sweep"]

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


def scatter(report):
    """The standard deviation of a coordinate, from the distances off all circles."""
    circles = [c for c in report.circles if not c.fault]
    freedom = sum(2 * c.points - 6 for c in circles)
    total = sum(c.points * c.off_circle**2 for c in circles)
    return max(float(np.sqrt(total / freedom)) if freedom else EXACT, EXACT)


def sweep(arm, data, circle):
    """The Sweep of one joint; ``circle`` as :func:`dhlab.fit_circles` found it."""
    return (_line if arm.table.joints[circle.joint - 1] == "P" else _circle)(arm, data, circle)


def _circle(arm, data, circle):
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
    said = _line_words(angle, np.linalg.norm(v), right, long)
    words = f"Joint {circle.joint}: it slides, so its points lie on a line: {said}."
    return Sweep(circle.joint, right, long, angle < TINY["axis"] and long, words)


def _line_words(angle, metres, right, long):
    """How the line stands to the model's: the angle between them, the metres that a metre of the
    joint moves the point.
    """
    said = f"the line runs {number(np.rad2deg(angle), 3)}° off the model's"
    if right:
        said = "agrees with the model in direction"
    if angle >= np.pi / 2:
        said += ", so it slides the other way, or an axis before it is turned round"
    if long and right:
        said += " and in length"
    if not long:
        said += f"; a metre of the joint moves the point {number(metres, 4)} m, so look at its unit"
    return said


def _own_rows(q, circle):
    """The rows in which the joint of this sweep moved and no other."""
    for first in range(len(q) - circle.points + 1):
        rows = np.arange(first, first + circle.points)
        moved = np.ptp(q[rows], axis=0) > 1e-3
        if moved[circle.joint - 1] and moved.sum() == 1:
            return rows


def notes(arm, sweeps, report):
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


def accused(arm, sweeps):
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
