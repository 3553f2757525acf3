"""From measured poses: whether a sheet of joint axes is right, and which axis is not."""

from dataclasses import replace

import numpy as np

from ...geometry.procedure.inputs import axes_from
from ...transform import require_pose
from ..arms.given import measured, one_in, thinned
from ..arms.search.measured import limit
from ..budget import SECONDS, budget_of
from ..diagnosis import AGREES
from .chain import Chain
from .pairs import pairs
from .search import everything, explanations, misfit
from .verdicts import RIVAL, SPARE, agreed, all_fitted, arm_of, explained, two_explained

__all__ = ["diagnose_axes"]

LARGEST_NOISE = (0.01, 0.05)  # m, rad; beyond this nothing is explained any more
COARSE = (2e-3, 4e-3)  # m, rad; supposed where the noise cannot be estimated
DOUBT = 18.0  # χ²; so much must one mistake explain of what the noise alone might still make


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
    arm = arm_of(sheet, name)
    clock = budget_of(budget, "diagnose_axes")
    data, few = thinned(measured(arm, q, poses, noise, "fixed", "fixed"))
    try:
        answer = (_without_level if noise is None else _decided)(sheet, data, few, name, clock)
    finally:
        clock.close()
    if answer.verdict != AGREES:
        answer = replace(answer, notes=clock.notes + answer.notes)
    given = np.asarray(poses, dtype=float)
    return replace(answer, compared=(arm, data.q, given[:: one_in(len(given))]))


def _decided(sheet, data, notes, name, clock):
    """The verdict at a known level of noise."""
    now = misfit(sheet, data)
    found = explanations(sheet, data, clock)
    if now <= limit(data.count) and now - found[0].score(data) < DOUBT:
        return agreed(sheet, data, notes)
    fitting = [e for e in found if e.explains(data)]
    if fitting:
        return explained(sheet, data, fitting, notes, name)
    two = pairs(sheet, data, found, clock)
    if two and not _as_good(two, data):
        return two_explained(sheet, data, two[0], notes, name)
    return all_fitted(sheet, data, found, notes, name, clock)


def _as_good(two, data):
    """Whether other axes explain the data as well as the best two do."""
    return len(two) > 1 and two[1].score(data) - two[0].score(data) < RIVAL


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
        return agreed(sheet, exact, said)
    fitting = [e for e in explanations(sheet, exact, clock) if e.explains(exact)]
    return explained(sheet, exact, fitting, said, name) if fitting else None


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
