"""From measured poses: whether an arm's table is right, what is wrong with it, and what it looks
like repaired.
"""

from dataclasses import replace

import numpy as np

from ...arm import Arm
from ...geometry.conversion import require_uncoupled
from ...printing import number
from ...table import DHTable
from ...transform import pose_fault, to_xyz_rpy
from ..diagnosis import AGREES, CALIBRATED, EXPLAINED, UNEXPLAINED, Diagnosis
from .armsearch import calibrated, singles
from .fitting import Measured, limit, misfit, rotation_vectors
from .leads import all_but_one, leads
from .naming import difference_text
from .pairsearch import pairs
from .ranking import named, ranked, rivals_of, telling_pose, with_twins

__all__ = ["diagnose"]

EXACT = (
    1e-6,
    1e-6,
)  # what counts as no noise at all (m, rad): a micrometre, and digits lost in printing
SPARE = 8  # so many numbers more than are fitted tell the noise
LARGEST_NOISE = (0.01, 0.05)  # beyond this nothing is explained any more
COARSEST = 0.2  # of the arm's reach, and radians: nobody measures worse
COARSE = (2e-3, 4e-3)  # supposed where the noise cannot be estimated: a ruler, a phone
FINE = 2e-3  # noise that all numbers together, fitted, do not leave by chance (m)
SMALL = (0.012, 0.02)  # a misfit that a calibration might make (m, rad, root mean square)
CALIBRATION = (
    1e-3,
    2e-3,
    # how far it moves a number, standard deviation (m, rad): the arms of dh_facts are 1 to 5 mm off at
    # the end
)
DOUBT = 10  # a mistake must explain noisy data this much better than a calibration does (χ²)


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
    data = _measured(arm, q, poses, noise, base, tool)
    answer = _decide(arm, data, ()) if noise is not None else _without_level(arm, data)
    if answer.verdict == UNEXPLAINED:
        answer = _led_on(arm, data if noise is not None else replace(data, noise=COARSE), answer)
    placed = misfit(arm, data).arm
    if answer.verdict == AGREES and (data.base_free or data.tool_free):
        answer = replace(answer, fitted=placed, notes=answer.notes + _found_ends(placed, data))
    return replace(answer, compared=(placed, data.q, np.asarray(poses, dtype=float)))


def _led_on(arm, data, answer):
    """An answer that explained nothing, looked at once more: without one measurement, or with what
    is right all the same.
    """
    found = all_but_one(arm, data)
    if found is None:
        return replace(answer, notes=answer.notes + leads(arm, data))
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
            _explained(arm, rest, misfit(arm, rest), ones, (said,)),
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
    answer = _decide(arm, data, ("The measurements are exact to a micrometre.",), two=False)
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
        answer = _decide(arm, replace(data, noise=level), (said, *few), two=two)
        if answer.verdict != UNEXPLAINED:
            break
    return answer


def _measured(arm, q, poses, noise, base, tool):
    if not isinstance(arm, Arm):
        raise ValueError(f"diagnose: expected an Arm or a DHTable, found {type(arm).__name__}")
    require_uncoupled(arm, "diagnose")
    for name, value in (("base", base), ("tool", tool)):
        if value not in ("fixed", "free"):
            raise ValueError(f'diagnose: {name}: expected "fixed" or "free", found {value!r}')
    q = np.atleast_2d(arm._checked(q))
    poses = np.asarray(poses)
    if q.ndim != 2 or len(q) == 0 or poses.shape not in ((len(q), 4, 4), (len(q), 3)):
        raise ValueError(
            f"diagnose: expected q (m, {len(arm)}) and as many poses (m, 4, 4) or positions (m, 3),"
            f" found {q.shape} and {poses.shape}"
        )
    if poses.dtype.kind not in "iuf" or not np.isfinite(poses).all():
        raise ValueError(
            "diagnose: poses: expected finite numbers, found something else; take the row out that"
            " could not be measured"
        )
    full = poses.ndim == 3
    if full and (fault := pose_fault(poses, 0.02)):
        raise ValueError(
            f"diagnose: poses: expected poses, but one is none: {fault}; give positions (m, 3) if"
            " the rotations are not known"
        )
    level = EXACT if noise is None else _noise(noise, arm, poses, full)
    R = _orthonormal(poses[:, :3, :3]) if full else None
    return Measured(
        q,
        poses[:, :3, 3] if full else poses.astype(float),
        R,
        level,
        base == "free",
        tool == "free",
    )


def _orthonormal(R):
    U, _, Vt = np.linalg.svd(R.astype(float))
    return U @ Vt


def _noise(noise, arm, poses, full):
    values = np.atleast_1d(np.asarray(noise, dtype=float))
    if values.shape not in ((1,), (2,)) or not (np.isfinite(values).all() and (values >= 0).all()):
        raise ValueError(f"diagnose: noise: expected (m, rad), two numbers from 0, found {noise!r}")
    if full and values.size == 1:
        raise ValueError(
            "diagnose: noise: expected two numbers, since the poses have rotations, found"
            f" {noise!r}; add the angle's, such as 1mm,0.2deg or (0.001, 0.0035)"
        )
    seen = np.ptp(poses[:, :3, 3] if full else poses, axis=0).max()
    reach = float(
        max(np.abs(arm.table.rows[:, 1:3]).sum() + np.linalg.norm(arm.tool[:3, 3]), seen, 0.1)
    )  # either may be in another unit
    if values[0] > COARSEST * reach or full and values[1] > COARSEST:
        raise ValueError(
            "diagnose: noise: expected metres and radians, much smaller than the arm"
            f" ({number(reach, 3)} m), found {noise!r}; 4 mm are 0.004"
        )
    return max(values[0], EXACT[0] / 10), max(values[-1], EXACT[1] / 10)


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


def _decide(arm, data, notes, two=True):
    """The verdict at a known level of noise; ``two`` asks for pairs of mistakes as well."""
    now = misfit(arm, data)
    if now.explains(data):
        return Diagnosis(
            AGREES,
            "The table agrees with the measurements.",
            before=_size(arm, data, now),
            notes=notes + _weak(data),
        )
    small = _is_small(now, data)
    ones = [e for e in singles(arm, data) if e.fit.explains(data)]
    ones = [e for e in ones if e.data_fault is None or not any(o.data_fault is None for o in ones)]
    whole = _calibration(arm, data) if small else None
    nearly = ones
    if small:
        ones = [
            e
            for e in ones
            if len(e.entries) <= 1
            and (data.noise[0] <= EXACT[0] or whole is None or e.fit.chi2 + DOUBT < whole.chi2)
        ]
    if ones:
        return _explained(arm, data, now, ones, notes)
    if whole:
        numbers = [e for e in nearly if len(e.entries) == 1 and e.data_fault is None]
        notes += (
            (
                (
                    "If it is one number, this is the nearest:"
                    f" {difference_text(arm, ranked(arm, numbers, data)[0].fit.arm)}."
                ),
            )
            if numbers
            else ()
        )
        return Diagnosis(
            CALIBRATED,
            "The table is right; this arm is a little off it, as every real arm is.",
            before=_size(arm, data, now),
            after=_size(whole.arm, data, whole),
            notes=notes,
            fitted=whole.arm,
        )
    twos = (
        []
        if not two or small and data.noise[0] > 2 * EXACT[0]
        else [e for e in pairs(arm, data) if e.fit.explains(data)]
    )
    if twos:
        return _explained(arm, data, now, twos, notes)
    return Diagnosis(
        UNEXPLAINED,
        "No one or two mistakes explain these measurements.",
        before=_size(arm, data, now),
        notes=notes,
    )


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


def _explained(arm, data, now, explanations, notes):
    """The Diagnosis from everything that fits: the simplest first, snapped to round numbers, named;
    the others noted.
    """
    explanations = ranked(arm, explanations, data)
    best = explanations[0]
    findings = named(best, data)
    if len(findings) == 1 and best.data_fault is None:
        findings[0], same = with_twins(findings[0], best, explanations[1:], data)
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
    needed = 3 if data.R is not None else 6
    if len(data.q) < needed:
        what = f"{'pose' if data.R is not None else 'position'}{'s prove' if len(data.q) > 1 else ' proves'}"
        return (
            (
                f"{len(data.q)} {what} little: {needed - len(data.q)} more, general ones, without"
                " zeros and right angles."
            ),
        )
    steps = data.q / (np.pi / 2)
    if (np.abs(steps - np.round(steps)) < 1e-3).all():
        return (
            (
                "All poses are at multiples of 90°, where many mistakes do not show: add three"
                " general ones."
            ),
        )
    return ()
