"""The verdict at a known level of noise: whether the table agrees, which mistakes explain what was
measured, whether the arm is only a little off its table.
"""

import numpy as np

from ..diagnosis import AGREES, CALIBRATED, EXPLAINED, UNEXPLAINED, Diagnosis
from .differences import difference_text
from .given import EXACT
from .ranking import named, ranked, rivals_of, telling_pose, with_equivalents
from .search.fitting import misfit
from .search.measured import limit, rotation_vectors
from .search.pairs import pairs
from .search.singles import calibrated, singles

__all__ = ["decide", "explained"]

SMALL = (0.012, 0.02)  # a misfit that a calibration might make (m, rad, root mean square)
# how far a calibration moves a number, standard deviation (m, rad): the arms of dh_facts are 1 to
# 5 mm off at the end
CALIBRATION = (1e-3, 2e-3)
DOUBT = 10  # a mistake must explain noisy data this much better than a calibration does (χ²)


def decide(arm, data, notes, two=True):
    """The verdict at a known level of noise; ``two`` asks for pairs of mistakes as well."""
    now = misfit(arm, data)
    before = _size(arm, data, now)
    if now.explains(data):
        words = "The table agrees with the measurements."
        return Diagnosis(AGREES, words, before=before, notes=notes + _weak(data))
    small = _is_small(now, data)
    nearly = _explaining(singles(arm, data), data)
    whole = _calibration(arm, data) if small else None
    ones = [e for e in nearly if not small or _is_no_calibration(e, whole, data)]
    if ones:
        return explained(arm, data, now, ones, notes)
    if whole:
        return _calibrated(arm, data, whole, before, notes + _nearest_number(arm, nearly, data))
    exact = data.noise[0] <= 2 * EXACT[0]
    twos = (
        [e for e in pairs(arm, data) if e.fit.explains(data)]
        if two and (exact or not small)
        else []
    )
    if twos:
        return explained(arm, data, now, twos, notes)
    words = "No one or two mistakes explain these measurements."
    return Diagnosis(UNEXPLAINED, words, before=before, notes=notes)


def _explaining(explanations, data):
    """Those that fit; measurements are blamed only where no change of the arm fits."""
    fitting = [e for e in explanations if e.fit.explains(data)]
    of_arm = [e for e in fitting if e.data_fault is None]
    return of_arm or fitting


def _is_no_calibration(explanation, whole, data):
    """Whether an explanation of a small misfit is clearly better than a calibration."""
    if len(explanation.entries) > 1:
        return False
    exact = data.noise[0] <= EXACT[0]
    return exact or whole is None or explanation.fit.chi2 + DOUBT < whole.chi2


def _calibrated(arm, data, whole, before, notes):
    return Diagnosis(
        CALIBRATED,
        "The table is right; this arm is a little off it, as every real arm is.",
        before=before,
        after=_size(whole.arm, data, whole),
        notes=notes,
        fitted=whole.arm,
    )


def _nearest_number(arm, explanations, data):
    numbers = [e for e in explanations if len(e.entries) == 1 and e.data_fault is None]
    if not numbers:
        return ()
    nearest = difference_text(arm, ranked(arm, numbers, data)[0].fit.arm)
    return (f"If it is one number, this is the nearest: {nearest}.",)


def _is_small(now, data):
    r = data.residual(now.arm.forward(data.q))
    position = data.noise[0] * np.sqrt((r[:, :3] ** 2).sum(1).mean())
    turn = data.noise[1] * np.sqrt((r[:, 3:] ** 2).sum(1).mean()) if data.R is not None else 0
    return position < SMALL[0] and turn < SMALL[1]


def _calibration(arm, data):
    """The fit of all numbers, held near where they stand, when it explains the data; its χ² counts
    how far they had to go.
    """
    whole = calibrated(arm, data, CALIBRATION)
    left = float((data.residual(whole.arm.forward(data.q)) ** 2).sum())
    return whole if left <= limit(data.count) and whole.chi2 < 3 * limit(data.count) else None


def explained(arm, data, now, explanations, notes):
    """The Diagnosis from everything that fits: the simplest first, snapped to round numbers, named;
    the others noted.
    """
    explanations = ranked(arm, explanations, data)
    best = explanations[0]
    findings = named(best, data)
    if len(findings) == 1 and best.data_fault is None:
        findings[0], same = with_equivalents(findings[0], best, explanations[1:], data)
        notes += same
    others = rivals_of(best, explanations[1:], data)
    words = "One mistake explains" if len(findings) == 1 else "Two mistakes together explain"
    pose = None
    if others:
        pose = telling_pose(best.fit.arm, [e.fit.arm for e in others], data)
        notes += (
            "Another explanation fits these poses as well: "
            + "; ".join(named(e, data)[0].message.split(". ")[0] for e in others[:3])
            + ".",
        )
    return Diagnosis(
        EXPLAINED,
        f"{words} the measurements.",
        tuple(findings),
        _size(arm, data, now),
        _size(best.fit.arm, best.changed or data, best.fit),
        notes + _weak(data),
        pose,
    )


def _size(arm, data, found):
    """Largest residual in mm and degrees."""
    T = found.arm.forward(data.q)
    millimetres = 1e3 * np.linalg.norm(T[:, :3, 3] - data.p, axis=1).max()
    if data.R is None:
        return float(millimetres), float("nan")
    turn = np.linalg.norm(rotation_vectors(np.swapaxes(T[:, :3, :3], -1, -2) @ data.R), axis=1)
    return float(millimetres), float(np.rad2deg(turn.max()))


def _weak(data):
    """What these poses could not have shown."""
    needed, what = (3, "pose") if data.R is not None else (6, "position")
    if len(data.q) < needed:
        proves = "s prove" if len(data.q) > 1 else " proves"
        return (
            f"{len(data.q)} {what}{proves} little: {needed - len(data.q)} more, general ones,"
            " without zeros and right angles.",
        )
    steps = data.q / (np.pi / 2)
    if (np.abs(steps - np.round(steps)) < 1e-3).all():
        return (
            "All poses are at multiples of 90°, where many mistakes do not show: add three"
            " general ones.",
        )
    return ()
