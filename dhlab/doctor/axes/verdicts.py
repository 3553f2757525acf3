"""What is said of a sheet of joint axes: the diagnosis, and the words of each verdict."""

import warnings
from dataclasses import dataclass, field

import numpy as np

from ...formats.axisfile import AxisSheet
from ...geometry.procedure.frames import assign_frames
from ...rotations import rotation_vectors
from ..arms.given import distinct
from ..arms.search.measured import limit
from ..arms.words.ranking import differs, telling_pose
from ..diagnosis import AGREES, CALIBRATED, EXPLAINED, UNDECIDED, UNEXPLAINED, Diagnosis
from .search import everything
from .words import axis_differences, finding_of

__all__ = ["AxisDiagnosis", "agreed", "all_fitted", "arm_of", "explained", "two_explained"]

RIVAL = 9.0  # what is no worse than the best by more than this is told beside it
SPARE = 8  # so many numbers more than are fitted tell the noise
SMALL = (0.012, 0.02)  # m, rad; axes that are off by less, each, were measured, not mistaken
FEWEST = 3  # configurations; from fewer no mistake is claimed
MOST = 5  # explanations that are listed
TOLD = 4  # axes of which a note says how far they are off


@dataclass(frozen=True, repr=False)
class AxisDiagnosis(Diagnosis):
    """The answer of :func:`dhlab.diagnose_axes`: a :class:`Diagnosis` whose findings name an axis;
    ``finding.parameter`` is "point", "direction", "sense", "q" (the zero pose) or "end".

    Parameters
    ----------
    sheet : AxisSheet or None
        The axes as repaired, where something was found.

    Examples
    --------
    >>> import dhlab as dh
    >>> axes, end = [([0, 0, 0], [0, 0, 1])], dh.transform.trans([0.4, 0, 0])
    >>> right = dh.assign_frames(axes, end=end)
    >>> q = [[0.5], [1.0], [-1.2]]
    >>> moved = [([0.01, 0, 0], [0, 0, 1])]
    >>> answer = dh.diagnose_axes(moved, end, q, right.forward(q))
    >>> answer.sheet.axes[0][0].round(6) + 0
    array([0., 0., 0.])
    """

    sheet: AxisSheet | None = field(default=None, repr=False, compare=False)


def agreed(sheet, data, notes):
    """Nothing is wrong."""
    words = "The axes agree with the measurements."
    return AxisDiagnosis(AGREES, words, before=_size(sheet, data), notes=notes + _weak(data))


def explained(sheet, data, fitting, notes, name):
    """One mistake explains all; or others do as well, and it is undecided."""
    best, best_score = fitting[0], fitting[0].score(data)
    close = [e for e in fitting[1:] if e.score(data) - best_score < RIVAL]
    others = {(e.change.joint, e.change.kind): e for e in reversed(close)}
    others.pop((best.change.joint, best.change.kind), None)
    repaired = arm_of(best.chain, name)
    arms = {key: arm_of(e.chain, name) for key, e in others.items()}
    unlike = [key for key in arms if differs(repaired, arms[key], data)]
    told = {key: finding_of(e, sheet, arms[key]) for key, e in others.items()}
    if unlike or distinct(data.q) < FEWEST:
        fits = (finding_of(best, sheet, repaired), *(told[key] for key in unlike))
        return _undecided(sheet, data, fits, [repaired, *(arms[key] for key in unlike)], notes)
    if told:
        same = "; ".join(f"{finding.place} {finding.detail}" for finding in told.values())
        notes = (*notes, f"The same motion as: {same}.")
    return AxisDiagnosis(
        EXPLAINED,
        "One mistake in the axes explains the measurements.",
        (finding_of(best, sheet, repaired),),
        _size(sheet, data),
        _size(best.chain, data),
        notes + _weak(data),
        fitted=repaired,
        sheet=_sheet(best.chain, name),
    )


def two_explained(sheet, data, pair, notes, name):
    """Two mistakes together explain all."""
    repaired = arm_of(pair.chain, name)
    findings = sorted(
        (finding_of(part, sheet, repaired) for part in pair.parts),
        key=lambda finding: finding.joint or len(sheet.letters) + 1,
    )
    places = " and ".join(finding.place for finding in findings)
    return AxisDiagnosis(
        EXPLAINED,
        f"Two mistakes in the axes together explain the measurements: {places}.",
        tuple(findings),
        _size(sheet, data),
        _size(pair.chain, data),
        notes + _weak(data),
        fitted=repaired,
        sheet=_sheet(pair.chain, name),
    )


def _undecided(sheet, data, fits, arms, notes):
    """Too few measurements: what fits, and the pose that decides."""
    count = distinct(data.q)
    return AxisDiagnosis(
        UNDECIDED,
        f"{count} measurement{'s' * (count > 1)} cannot tell which axis is wrong: each of these"
        " fits.",
        before=_size(sheet, data),
        notes=(*notes, "Measure more general poses, the one below first."),
        next_pose=telling_pose(arms) if len(arms) > 1 else None,
        fits=fits[:MOST],
    )


def all_fitted(sheet, data, found, notes, name, clock):
    """No single mistake: what all axes look like when all are fitted, where that explains."""
    chain, chi2, free, moved = everything([*(e.chain for e in found[:2]), sheet], data, clock)
    if data.count - free < SPARE or chi2 > limit(data.count - free):
        needed = -(-(free + SPARE) * len(data.q) // data.count)
        few = f"{needed} general poses would tell every axis."
        return AxisDiagnosis(
            UNEXPLAINED,
            "No one mistake in the axes explains these measurements.",
            before=_size(sheet, data),
            notes=(*notes, few) if needed > len(data.q) else notes,
        )
    small = _all_small(sheet, chain)
    said = axis_differences(sheet, chain, moved | {found[0].change.joint, found[1].change.joint})
    more = f", and {len(said) - TOLD} more by less" if len(said) > TOLD else ""
    return AxisDiagnosis(
        CALIBRATED if small else UNEXPLAINED,
        (
            "Every axis is about where it was written; together they are a little off."
            if small
            else "More than one axis is not as written; all of them fitted explain this."
        ),
        before=_size(sheet, data),
        after=_size(chain, data),
        notes=(*notes, f"As fitted, {'; '.join(said[:TOLD])}{more}."),
        fitted=arm_of(chain, name),
        sheet=_sheet(chain, name),
    )


def _all_small(sheet, chain):
    near = np.linalg.norm(np.cross(chain.p - sheet.p, sheet.z), axis=1).max() < SMALL[0]
    angles = np.linalg.norm(np.cross(chain.z, sheet.z), axis=1)
    return bool(near and angles.max() < SMALL[1] and ((chain.z * sheet.z).sum(axis=1) > 0).all())


def arm_of(chain, name):
    """The arm that a chain of axes is."""
    with warnings.catch_warnings():  # axes that are nearly parallel make a table of large numbers
        warnings.simplefilter("ignore")
        return assign_frames(chain.axes(), end=chain.end_at_zero(), name=name)


def _sheet(chain, name):
    return AxisSheet(tuple(chain.axes()), chain.end_at_zero(), name=name)


def _weak(data):
    """What so few measurements could not have shown."""
    needed = 3 if data.R is not None else 6
    if len(data.q) >= needed:
        return ()
    return (f"{len(data.q)} measurements prove little: {needed - len(data.q)} more, general ones.",)


def _size(chain, data):
    """Largest residual in mm and degrees."""
    T = chain.forward(data.q)
    millimetres = 1e3 * np.linalg.norm(T[:, :3, 3] - data.p, axis=1).max()
    if data.R is None:
        return float(millimetres), float("nan")
    turn = np.linalg.norm(rotation_vectors(np.swapaxes(T[:, :3, :3], -1, -2) @ data.R), axis=1)
    return float(millimetres), float(np.rad2deg(turn.max()))
