"""Zero offsets of an arm's joints from measured poses, with the uncertainty of each and a word on
those the data cannot tell.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..arm import Arm
from ..geometry.conversion import require_uncoupled
from .calibrationwords import calibration_html, calibration_text
from .inputs import measured, noise_of
from .offsetmodel import OffsetModel
from .unknowns import Undetermined, null_space, pivots, undetermined_groups

__all__ = ["calibrate_offsets", "Calibration", "Residual"]

CHOICES = ("fixed", "free")
# χ² per degree of freedom; offsets that leave more than twice the noise do not explain the data
UNEXPLAINED = 4.0
STARTS = 16  # further starts when the first solution leaves too much
SPREAD = np.deg2rad(45)  # of the further starts
EXACT = 1e-12  # m and rad; the least scatter that is believed
# m and rad; without a stated noise, a residual beyond this is tried again from other starts
FAR_OFF = 2e-3


@dataclass(frozen=True)
class Residual:
    """What is left between model and measurement, rms and worst, in m and rad; None without
    rotations.
    """

    position: float
    worst_position: float
    rotation: float | None = None
    worst_rotation: float | None = None


@dataclass(frozen=True, eq=False, repr=False)
class Calibration:
    """What :func:`calibrate_offsets` found.

    ``arm``: the corrected Arm. ``offsets`` (n,): what was added to theta (rad) of a revolute joint,
    to d (m) of a prismatic one. ``sigma`` (n,): their standard deviations, infinite where the data
    cannot tell. ``undetermined``: groups of such joints, each with ``joints``, ``words``.
    ``before`` and ``after``: :class:`Residual`; before is with the best base and tool where these
    are free. ``base`` and ``tool`` (4, 4): the corrections found, ``base · old pose · tool``, the
    identity where fixed. ``noise``: (m, rad or None), given or estimated. ``explained``: whether
    offsets bring the model within the noise; None when the noise was not given.

    Examples
    --------
    >>> import dhlab as dh
    >>> arm, q = dh.load("article-6r"), np.random.default_rng(0).uniform(-2, 2, (30, 6))
    >>> found = dh.calibrate_offsets(arm, q, arm.forward(q + [0, 0.1, 0, 0, 0, 0]))
    >>> found.offsets.round(3) + 0.0, found.undetermined
    (array([0. , 0.1, 0. , 0. , 0. , 0. ]), ())
    """

    arm: Arm
    offsets: NDArray[np.float64]
    sigma: NDArray[np.float64]
    undetermined: tuple[Undetermined, ...]
    before: Residual
    after: Residual
    base: NDArray[np.float64]
    tool: NDArray[np.float64]
    noise: tuple[float, float | None]
    explained: bool | None
    poses: int

    def __repr__(self) -> str:
        return f"<Calibration of {len(self.offsets)} joints from {self.poses} poses>"

    def __str__(self) -> str:
        return calibration_text(self)

    def _repr_html_(self) -> str:
        return calibration_html(self)


def calibrate_offsets(
    arm: Arm,
    q: ArrayLike,
    poses: ArrayLike,
    *,
    noise: float | tuple[float, float] | None = None,
    base: str = "fixed",
    tool: str = "fixed",
) -> Calibration:
    """Joint zero offsets that bring a model as near as possible to measured poses, by least
    squares.

    Parameters
    ----------
    arm : Arm
        The model; its lengths and twists are taken as right.
    q : array (m, n)
        Joint values at the measurements, rad (m for a prismatic joint).
    poses : array (m, 4, 4), or positions (m, 3)
        What was measured there, metres.
    noise : float or (float, float), optional
        Standard deviations of a measured coordinate (m) and of a rotation about each axis (rad);
        estimated from what is left over when not given.
    base, tool : "fixed" or "free"
        Free: where the arm stands (or the tool sits) is found as well.

    Returns
    -------
    Calibration
        Printed: offsets with standard deviations, what cannot be told apart, residuals before and
        after.

    Raises
    ------
    ValueError
        Shapes that do not fit, an unknown word, or fewer measurements than unknowns when the noise
        is to be estimated.

    Notes
    -----
    Least squares over the offsets (and the free poses) with analytic Jacobians, from zero and, when
    that leaves too much, from further starts within 45°. Directions without effect on the data are
    found by singular values of the Jacobian: one offset of each is kept at 0. Standard deviations
    are of first order (Gauss-Newton). See Mooring, Roth, Driels, Fundamentals of Manipulator
    Calibration (1991).

    Examples
    --------
    >>> import dhlab as dh
    >>> arm, q = dh.load("article-6r"), np.random.default_rng(0).uniform(-2, 2, (30, 6))
    >>> wrong = np.array([0, 0.1, 0, 0, -0.2, 0])
    >>> result = calibrate_offsets(arm, q, arm.forward(q + wrong))
    >>> result.offsets.round(6) + 0.0
    array([ 0. ,  0.1,  0. ,  0. , -0.2,  0. ])
    """
    if not isinstance(arm, Arm):
        raise ValueError(
            f"calibrate_offsets: expected an Arm first, found {type(arm).__name__}; load one with"
            " dhlab.load"
        )
    require_uncoupled(arm, "calibrate_offsets")
    for name, word in (("base", base), ("tool", tool)):
        if word not in CHOICES:
            raise ValueError(
                f'calibrate_offsets: {name}: expected "fixed" or "free", found {word!r}'
            )
    q, poses = measured(q, poses, len(arm), "calibrate_offsets")
    given = noise_of(noise, "calibrate_offsets")
    if given and poses.ndim == 3 and given[1] is None:
        raise ValueError(
            "calibrate_offsets: noise: expected (m, rad) for full poses, found one number; give"
            " both standard deviations"
        )
    model = OffsetModel(arm, q, poses, base == "free", tool == "free")
    if given is None and model.numbers <= model.size:
        raise ValueError(
            f"calibrate_offsets: expected more measurements, found {model.numbers} measured numbers"
            f" for {model.size} unknowns and the noise; measure more poses, or give noise"
        )
    weights = given or (1.0, 1.0)
    x, keep = _solve(model, weights, _good_enough(model, given))
    for _ in range(0 if given else 2):  # weigh positions against rotations by what each leaves over
        weights = _scatter(model, x, keep)
        x, keep = _solve(model, weights, None, x)
    return _result(model, x, keep, weights, given)


def _good_enough(model, given):
    """A test of a solution: whether no better one need be looked for."""
    if given:
        return lambda x: (model.residual(x, given) ** 2).sum() < UNEXPLAINED * model.numbers
    return lambda x: (
        max(value or 0 for value in (_residual(model, x).position, _residual(model, x).rotation))
        < FAR_OFF
    )


def _solve(model, weights, good_enough, start=None):
    """The best solution, and which unknowns are kept free (the others are held, offsets at 0, since
    nothing in the data depends on them).
    """
    x = model.solve(model.start() if start is None else start, weights)
    if good_enough and not good_enough(x):
        x = _best_of_further_starts(model, weights, good_enough, x)
    keep = ~_without_effect(model, x, weights)
    if keep.all():
        return x, keep
    offsets = np.arange(model.size) < model.n
    return model.solve(np.where(keep | ~offsets, x, 0.0), weights, keep), keep


def _best_of_further_starts(model, weights, good_enough, best):
    rng = np.random.default_rng(0)  # the same answer every time
    for _ in range(STARTS):
        x = model.solve(
            model.start(rng.uniform(-1, 1, model.n) * SPREAD * np.where(model.slides, 0.1, 1.0)),
            weights,
        )
        if (model.residual(x, weights) ** 2).sum() < (model.residual(best, weights) ** 2).sum():
            best = x
        if good_enough(best):
            break
    return best


def _without_effect(model, x, weights):
    """One unknown for each direction without effect, an offset rather than a part of base or
    tool.
    """
    return pivots(null_space(model.jacobian(x, weights)), model.n)


def _scatter(model, x, keep):
    """Standard deviations (m, rad) estimated from what is left over, each kind with its share of
    the unknowns.
    """
    p, r = model.parts(x)
    share = max(1 - keep.sum() / model.numbers, 1e-3)
    rotation = None if r is None else max(np.sqrt((r**2).sum() / (3 * len(r) * share)), EXACT)
    return max(np.sqrt((p**2).sum() / (3 * len(p) * share)), EXACT), rotation


def _residual(model, x):
    p, r = model.parts(x)
    p = np.linalg.norm(p, axis=1)
    position, worst = float(np.sqrt((p**2).mean())), float(p.max())
    if r is None:
        return Residual(position, worst)
    angle = 2 * np.arcsin(np.clip(np.linalg.norm(r, axis=1) / 2, 0, 1))  # parts are chords
    return Residual(position, worst, float(np.sqrt((angle**2).mean())), float(angle.max()))


def _result(model, x, keep, weights, given):
    n = model.n
    # a search may end whole turns away
    x[:n] -= np.where(model.slides, 0.0, 2 * np.pi * np.round(x[:n] / (2 * np.pi)))
    J = model.jacobian(x, weights)
    freedom = model.numbers - keep.sum()
    chi2 = (model.residual(x, weights) ** 2).sum() / freedom if freedom else 0.0
    scale = 1.0 if given and chi2 < UNEXPLAINED else np.sqrt(chi2)
    sigma = np.full(model.size, np.inf)
    sigma[keep] = scale * np.sqrt(np.diag(np.linalg.pinv(J[:, keep].T @ J[:, keep])))
    groups = undetermined_groups(J, sigma, model)
    sigma = sigma[:n].copy()
    for group in groups:
        if not group.vague:
            sigma[[i - 1 for i in group.joints]] = np.inf
    nuisance = np.arange(model.size) >= n
    unmoved = model.solve(model.start(), weights, nuisance) if nuisance.any() else model.start()
    base, tool = model.base(x), model.tool(x)
    return Calibration(
        model.corrected(x),
        x[:n].copy(),
        sigma,
        groups,
        _residual(model, unmoved),
        _residual(model, x),
        base,
        tool,
        weights,
        bool(chi2 < UNEXPLAINED) if given else None,
        len(model.q),
    )
