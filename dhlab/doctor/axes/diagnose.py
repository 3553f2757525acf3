"""From measured poses: whether a sheet of joint axes is right, and which axis is not."""

import warnings
from dataclasses import dataclass, field, replace

import numpy as np

from ...formats.axisfile import AxisSheet
from ...geometry.procedure.frames import assign_frames
from ...geometry.procedure.inputs import axes_from
from ...transform import require_pose
from ..arms.given import distinct, measured, one_in, thinned
from ..arms.search.budget import SECONDS, budget_of
from ..arms.search.measured import limit, rotation_vectors
from ..arms.words.ranking import differs, telling_pose
from ..diagnosis import AGREES, CALIBRATED, EXPLAINED, UNDECIDED, UNEXPLAINED, Diagnosis
from .chain import Chain
from .pairs import pairs
from .search import everything, explanations, misfit
from .words import axis_differences, finding_of

__all__ = ["AxisDiagnosis", "diagnose_axes"]

SPARE = 8  # so many numbers more than are fitted tell the noise
LARGEST_NOISE = (0.01, 0.05)  # m, rad; beyond this nothing is explained any more
COARSE = (2e-3, 4e-3)  # m, rad; supposed where the noise cannot be estimated
RIVAL = 9.0  # what is no worse than the best by more than this is told beside it
SMALL = (0.012, 0.02)  # m, rad; axes that are off by less, each, were measured, not mistaken
DOUBT = 18.0  # χ²; so much must one mistake explain of what the noise alone might still make
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


def diagnose_axes(axes, end, q, poses, *, noise=None, name="", budget=SECONDS):
    """Which joint axis of a sheet is not where, or not as, it was written; from measured poses.

    Parameters
    ----------
    axes : list of (point, direction) or (point, direction, "R" or "P")
        As :func:`dhlab.assign_frames` takes them: in the base frame, at the zero pose, metres.
    end : array (4, 4)
        The end pose there.
    q : array (m, n)
        Joint values, radians (metres for sliding joints).
    poses : array (m, 4, 4) or (m, 3)
        What was measured there: poses, or positions only, in metres, in the base frame.
    noise : (float, float) or float, optional
        Standard deviation of one coordinate (m) and of one axis of rotation (rad), the first alone
        for positions; estimated when left out.
    name : str
        Of the arm.
    budget : float
        Seconds of processor time; when they are over, the best answer so far is given. Of more than
        500 poses as many are used, evenly from all.

    Returns
    -------
    AxisDiagnosis
        ``verdict`` "agrees", "explained", "calibrated", "undecided" or "unexplained"; the finding
        says which axis, and in ``detail`` how far and which way.

    Raises
    ------
    ValueError
        Axes, an end or poses that are none; wrong shapes; noise as large as the arm.

    Notes
    -----
    The pose is the product of exponentials of the written axes, T(q) = e^(S_1 q_1) … e^(S_n q_n) M.
    Every sense, direction, point and zero pose is changed alone, and the end, with the fewest free
    numbers first (Schwarz's criterion); what is left must be no more than the noise.

    Examples
    --------
    >>> import dhlab as dh
    >>> end = dh.transform.trans([0.7, 0, 0.1])
    >>> right = dh.assign_frames([([0, 0, 0], [0, 0, 1]), ([0.40, 0, 0], [0, 1, 0])], end=end)
    >>> q = np.random.default_rng(1).uniform(-2, 2, (6, 2))
    >>> written = [([0, 0, 0], [0, 0, 1]), ([0.41, 0, 0], [0, 1, 0])]
    >>> answer = diagnose_axes(written, end, q, right.forward(q))
    >>> answer.findings[0].joint, answer.findings[0].detail
    (2, "lies 10 mm away along -x: the point's x is 400 mm, not 410 mm")
    """
    lines = axes_from(axes, "diagnose_axes")
    sheet = Chain(
        np.array([line.p for line in lines]),
        np.array([line.z for line in lines]),
        "".join(line.letter for line in lines),
        require_pose(end, "diagnose_axes: end"),
        np.zeros(len(lines)),
    )
    arm = _arm(sheet, name)
    clock = budget_of(budget, "diagnose_axes")
    data, few = thinned(measured(arm, q, poses, noise, "fixed", "fixed"))
    try:
        answer = (_without_level if noise is None else _decided)(sheet, data, few, name, clock)
    finally:
        clock.close()
    if answer.verdict not in (AGREES, EXPLAINED):
        answer = replace(answer, notes=clock.notes + answer.notes)
    given = np.asarray(poses, dtype=float)
    return replace(answer, compared=(arm, data.q, given[:: one_in(len(given))]))


def _arm(chain, name):
    with warnings.catch_warnings():  # axes that are nearly parallel make a table of large numbers
        warnings.simplefilter("ignore")
        return assign_frames(chain.axes(), end=chain.end_at_zero(), name=name)


def _decided(sheet, data, notes, name, clock):
    """The verdict at a known level of noise."""
    before = _size(sheet, data)
    now = misfit(sheet, data)
    found = explanations(sheet, data, clock)
    if now <= limit(data.count) and now - found[0].score(data) < DOUBT:
        words = "The axes agree with the measurements."
        return AxisDiagnosis(AGREES, words, before=before, notes=notes + _weak(data))
    fitting = [e for e in found if e.explains(data)]
    if fitting:
        return _explained(sheet, data, fitting, before, notes, name)
    two = pairs(sheet, data, found, clock)
    if two and not _as_good(two, data):
        return _two_explained(sheet, data, two[0], before, notes, name)
    return _all_fitted(sheet, data, found, before, notes, name, clock)


def _as_good(two, data):
    """Whether other axes explain the data as well as the best two do."""
    return len(two) > 1 and two[1].score(data) - two[0].score(data) < RIVAL


def _two_explained(sheet, data, pair, before, notes, name):
    repaired = _arm(pair.chain, name)
    findings = sorted(
        (finding_of(part, sheet, repaired) for part in pair.parts),
        key=lambda finding: finding.joint or len(sheet.letters) + 1,
    )
    places = " and ".join(finding.place for finding in findings)
    return AxisDiagnosis(
        EXPLAINED,
        f"Two mistakes in the axes together explain the measurements: {places}.",
        tuple(findings),
        before,
        _size(pair.chain, data),
        notes + _weak(data),
        fitted=repaired,
        sheet=_sheet(pair.chain, name),
    )


def _explained(sheet, data, fitting, before, notes, name):
    best, best_score = fitting[0], fitting[0].score(data)
    close = [e for e in fitting[1:] if e.score(data) - best_score < RIVAL]
    others = {(e.change.joint, e.change.kind): e for e in reversed(close)}
    others.pop((best.change.joint, best.change.kind), None)
    repaired = _arm(best.chain, name)
    arms = {key: _arm(e.chain, name) for key, e in others.items()}
    unlike = [key for key in arms if differs(repaired, arms[key], data)]
    told = {key: finding_of(e, sheet, arms[key]) for key, e in others.items()}
    if unlike or distinct(data.q) < FEWEST:
        fits = (finding_of(best, sheet, repaired), *(told[key] for key in unlike))
        return _undecided(data, fits, [repaired, *(arms[key] for key in unlike)], before, notes)
    if told:
        same = "; ".join(f"{finding.place} {finding.detail}" for finding in told.values())
        notes = (*notes, f"The same motion as: {same}.")
    return AxisDiagnosis(
        EXPLAINED,
        "One mistake in the axes explains the measurements.",
        (finding_of(best, sheet, repaired),),
        before,
        _size(best.chain, data),
        notes + _weak(data),
        fitted=repaired,
        sheet=_sheet(best.chain, name),
    )


def _undecided(data, fits, arms, before, notes):
    """Too few measurements: what fits, and the pose that decides."""
    count = distinct(data.q)
    return AxisDiagnosis(
        UNDECIDED,
        f"{count} measurement{'s' * (count > 1)} cannot tell which axis is wrong: each of these"
        " fits.",
        before=before,
        notes=(*notes, "Measure more general poses, the one below first."),
        next_pose=telling_pose(arms) if len(arms) > 1 else None,
        fits=fits[:MOST],
    )


def _all_fitted(sheet, data, found, before, notes, name, clock):
    """No single mistake: what all axes look like when all are fitted, where that explains."""
    chain, chi2, free, moved = everything([*(e.chain for e in found[:2]), sheet], data, clock)
    if data.count - free < SPARE or chi2 > limit(data.count - free):
        needed = -(-(free + SPARE) * len(data.q) // data.count)
        few = f"{needed} general poses would tell every axis."
        return AxisDiagnosis(
            UNEXPLAINED,
            "No one mistake in the axes explains these measurements.",
            before=before,
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
        before=before,
        after=_size(chain, data),
        notes=(*notes, f"As fitted, {'; '.join(said[:TOLD])}{more}."),
        fitted=_arm(chain, name),
        sheet=_sheet(chain, name),
    )


def _all_small(sheet, chain):
    near = np.linalg.norm(np.cross(chain.p - sheet.p, sheet.z), axis=1).max() < SMALL[0]
    angles = np.linalg.norm(np.cross(chain.z, sheet.z), axis=1)
    return bool(near and angles.max() < SMALL[1] and ((chain.z * sheet.z).sum(axis=1) > 0).all())


def _sheet(chain, name):
    return AxisSheet(tuple(chain.axes()), chain.end_at_zero(), name=name)


def _without_level(sheet, data, notes, name, clock):
    """The verdict where the noise is not known: exact data first, then at the noise that is left
    when every axis is fitted.
    """
    answer = _decided_exactly(sheet, data, notes, name, clock)
    if answer is not None:
        return answer
    level, enough = _estimated(sheet, data, clock)
    said = (
        f"The noise was estimated from the data: {level[0] * 1e3:.2g} mm"
        + ("" if data.R is None else f", {np.rad2deg(level[1]):.2g}°")
        + ".",
    )
    if not enough:
        said = (
            f"With {len(data.q)} poses the noise cannot be told from a mistake; it was taken for"
            f" {level[0] * 1e3:.2g} mm. Say what it is, or measure more.",
        )
    return _decided(sheet, replace(data, noise=level), (*notes, *said), name, clock)


def _decided_exactly(sheet, data, notes, name, clock):
    exact = replace(data, noise=data.floor)
    said = (*notes, "The measurements are exact to their digits.")
    if misfit(sheet, exact) <= limit(data.count):
        return AxisDiagnosis(
            AGREES,
            "The axes agree with the measurements.",
            before=_size(sheet, data),
            notes=said + _weak(data),
        )
    fitting = [e for e in explanations(sheet, exact, clock) if e.explains(exact)]
    return _explained(sheet, exact, fitting, _size(sheet, exact), said, name) if fitting else None


def _estimated(sheet, data, clock):
    loose = replace(data, noise=COARSE)
    free = sum(4 if letter == "R" else 2 for letter in sheet.letters) + 6
    if data.count - free < SPARE:
        return COARSE, False
    found = explanations(sheet, loose, clock)
    chain = everything([*(e.chain for e in found[:2]), sheet], loose, clock)[0]
    r = loose.residual(chain.forward(data.q))
    share = np.sqrt(data.count / (data.count - free))
    position = COARSE[0] * np.sqrt((r[:, :3] ** 2).mean()) * share
    turn = (
        COARSE[1] * np.sqrt((r[:, 3:] ** 2).mean()) * share if data.R is not None else data.floor[1]
    )
    return (
        float(np.clip(position, data.floor[0], LARGEST_NOISE[0])),
        float(np.clip(turn, data.floor[1], LARGEST_NOISE[1])),
    ), True


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
