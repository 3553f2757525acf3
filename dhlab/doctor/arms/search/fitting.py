"""How far a model is from the measured poses, in units of their noise, and small fits of its
numbers to them.
"""

from dataclasses import dataclass

import numpy as np

from ....arm import Arm
from ....rotations import from_rotation_vectors, rotation_vectors
from ...mistakes.remade import A, D, with_rows
from ...mistakes.together import ends_of
from .ends import place_ends, rigid
from .measured import limit

__all__ = [
    "DAMPING",
    "MOST_DAMPING",
    "Fit",
    "damped",
    "derivatives",
    "done",
    "fit",
    "hopeless",
    "jacobian",
    "misfit",
    "misfits",
    "within",
]

NEXT, LAST = [1, 2, 0], [2, 0, 1]  # the other two of three numbers
DAMPING, MOST_DAMPING = 1e-9, 1e4  # of a Gauss-Newton step: the first, and where a fit gives up
FLAT = 4  # poses; so few leave a base and a tool that are both free long valleys to walk along


@dataclass(frozen=True)
class Fit:
    """A model fitted to measurements: the Arm, its χ², how many numbers were fitted, their values'
    standard deviations, and, where they are known already, the squares that are left.
    """

    arm: Arm
    chi2: float
    fitted: int = 0
    sigma: np.ndarray = None
    left: tuple = None

    def explains(self, data):
        """Whether the misfit is no larger than the noise makes it."""
        return self.chi2 <= limit(data.count - self.fitted)


def hopeless(data):
    """A χ² that neither another base or tool nor slow steps of a fit will bring down to the noise;
    exact data may begin far off.
    """
    return 100 * limit(data.count) + 1e6


def misfit(arm, data):
    """The Fit of an arm as it is; base and tool put in place where they are free.

    One end is placed in closed form: to the end where only positions were measured, otherwise near
    enough to see that a fit is hopeless.
    """
    placed = place_ends(arm, data)
    r = data.residual(placed.forward(data.q))
    chi2 = float((r**2).sum())
    ends = data.base_free + data.tool_free
    if ends == 0 or (ends == 1 and (data.R is None or chi2 > hopeless(data))):
        fitted = ends * (3 if data.R is None and data.tool_free else 6)
        return Fit(placed, chi2, fitted, left=data.left_by(r))
    flat = ends == 2 and len(data.q) <= FLAT
    return fit(placed, data, (), steps=100 if flat else 15)


def misfits(arms, data):
    """The Fit of each of several arms as it is, like :func:`misfit`: one by one, as they are asked
    for, where an end is free.
    """
    if data.base_free or data.tool_free:
        return (misfit(arm, data) for arm in arms)
    left = data.squares(ends_of(arms, data.q))
    chi2 = left[0] / data.noise[0] ** 2
    chi2 = chi2 if data.R is None else chi2 + left[1] / data.noise[1] ** 2
    return (Fit(*each, left=both) for *each, both in zip(arms, chi2.tolist(), zip(*left)))


def within(arm, data, chi2):
    """Whether the misfit of an arm is no larger than ``chi2``: as :func:`misfit` says, and where
    both ends are free first from the turns between two poses, which no end changes.
    """
    if data.base_free and data.tool_free and data.R is not None:
        most = np.sqrt(2 * chi2) * data.noise[1]  # what two residuals together may turn at most
        if np.abs(_turned(arm.forward(data.q)[..., :3, :3]) - _turned(data.R)).max() > most:
            return False
    return misfit(arm, data).chi2 <= chi2


def _turned(R):
    """The angles (m,) between the first rotation and each."""
    return np.linalg.norm(rotation_vectors(np.swapaxes(R[:1], -1, -2) @ R), axis=-1)


def fit(arm, data, free, *, base=None, tool=None, steps=15, prior=None):
    """Fit some of an arm's numbers by damped Gauss-Newton steps.

    Parameters
    ----------
    arm : Arm
        Where the fit starts; angles should be within some 60° of the answer.
    data : Measured
    free : sequence of (row, column)
        0-based row, column 0 to 3 for theta, d, a, alpha.
    base, tool : bool, optional
        Fit the base (tool) pose as well; as the data say when left out.
    prior : (float, float), optional
        Hold lengths (m) and angles (rad) to where they start, with this standard deviation; the
        cost is in the χ².

    Returns
    -------
    Fit
    """
    base, tool = data.base_free if base is None else base, data.tool_free if tool is None else tool
    free = list(free)
    size = len(free) + 6 * base + 6 * tool
    F, r = _looked_at(arm, data)
    best = (r**2).sum()
    if size == 0:
        return Fit(arm, float(best))
    J, held = _derivatives(arm, F, data, free, base, tool), _Held(arm, free, prior)
    damping, far = DAMPING, hopeless(data)
    for _ in range(steps):
        trial = _moved(arm, held.step(arm, J, r, damping), free, base, tool)
        F, left = _looked_at(trial, data)
        chi2 = (left**2).sum() + held.cost(trial)
        better = chi2 < best
        damping, was = damped(damping, better), best
        if better:
            arm, best, r = trial, chi2, left
            J = _derivatives(arm, F, data, free, base, tool)
        if done(was, chi2, far) if better else damping > MOST_DAMPING:
            break
    sigma = np.sqrt(np.clip(np.diag(np.linalg.pinv(J.T @ J, rcond=1e-10, hermitian=True)), 0, None))
    rank = np.linalg.matrix_rank(J, tol=1e-6 * np.abs(J).max(initial=1e-300))
    return Fit(arm, float(best), rank, sigma, data.left_by(r))


def damped(damping, better):
    """The damping after a step that made the misfit smaller, or did not."""
    return np.where(better, damping / 10, np.maximum(damping * 30, 1e-5))


def done(was, chi2, far):
    """Whether a step that made χ² smaller gained so little that the next is not worth its time;
    sooner where χ² is beyond ``far``.
    """
    return was - chi2 < np.where(chi2 > far, 1e-2, 1e-7) * (1 + chi2)


class _Held:
    """Numbers held to where they start by springs; without a prior the springs have no force."""

    def __init__(self, arm, free, prior):
        self.free, self.start = free, np.array([arm.table.rows[entry] for entry in free])
        self.stiff = np.zeros(len(free))
        if prior:
            self.stiff[:] = [1 / prior[0 if column in (D, A) else 1] for _, column in free]

    def _pulled(self, arm):
        return np.array([arm.table.rows[entry] for entry in self.free]) - self.start

    def cost(self, arm):
        """What the springs add to χ²."""
        return ((self.stiff * self._pulled(arm)) ** 2).sum()

    def step(self, arm, J, r, damping):
        """The damped Gauss-Newton step from an arm."""
        H, g, n = J.T @ J, J.T @ r, len(self.free)
        H[range(n), range(n)] += self.stiff**2
        g[:n] += self.stiff**2 * self._pulled(arm)
        return np.linalg.lstsq(H + damping * np.diag(np.diag(H) + 1e-12), -g, rcond=1e-13)[0]


def jacobian(arm, data, free, base, tool):
    """Residuals' derivatives by each of the free numbers, and the residuals."""
    F, r = _looked_at(arm, data)
    return _derivatives(arm, F, data, free, base, tool), r


def _looked_at(arm, data):
    """The frames of an arm where it was measured, and its residuals in one row."""
    F = arm.frames(data.q)
    return F, data.residual(F[:, -1] @ arm.tool).reshape(-1)


def _derivatives(arm, F, data, free, base, tool):
    """The residuals' derivatives: each number of a row turns or shifts what is behind it, like a
    joint of its own.
    """
    end = F[:, -1] @ arm.tool
    axes, origins, turns = [], [], []
    standard = arm.table.convention == "standard"
    for i, column in free:
        of_z = column < 2
        frame = F[
            :, i if of_z == standard else i + 1
        ]  # standard: z of frame i-1, x of frame i; Craig: the other way round
        axes.append(frame[:, :3, 2 if of_z else 0])
        origins.append(frame[:, :3, 3])
        turns.append(column in (0, 3))
    for frame, wanted in ((np.broadcast_to(np.eye(4), end.shape), base), (end, tool)):
        for k in range(6 * wanted):
            axes.append(frame[:, :3, k % 3])
            origins.append(frame[:, :3, 3])
            turns.append(k < 3)
    axes, origins, turns = np.stack(axes, 1), np.stack(origins, 1), np.array(turns)[:, None]
    v = derivatives(axes, origins, turns, end, data)
    return np.swapaxes(v, 1, 2).reshape(-1, v.shape[1])


def derivatives(axes, origins, turns, end, data):
    """How the residuals of poses ``end`` (..., m, 4, 4) change when what is behind some axes (...,
    m, s, 3) is turned about them, or shifted along them where not ``turns``; (..., m, s, 3 or 6).
    """
    v = np.where(turns, _cross(axes, end[..., None, :3, 3] - origins), axes) / data.noise[0]
    if data.R is None:
        return v
    omega = np.where(turns, -axes @ end[..., :3, :3], 0.0) / data.noise[1]
    return np.concatenate([v, omega], axis=-1)


def _cross(a, b):
    """The products of many vectors; ``np.cross`` takes longer to ask than to multiply."""
    return a[..., NEXT] * b[..., LAST] - a[..., LAST] * b[..., NEXT]


def _moved(arm, step, free, base, tool):
    rows = arm.table.rows
    for (i, column), value in zip(free, step):
        rows[i, column] += value
    parts, rest = {}, step[len(free) :]
    if base:
        parts["base"] = rigid(_pose(rest[:6]) @ arm.base)
        rest = rest[6:]
    if tool:
        parts["tool"] = rigid(arm.tool @ _pose(rest))
    return with_rows(arm, rows, **parts)


def _pose(twist):
    T = np.eye(4)
    T[:3, :3] = from_rotation_vectors(twist[:3])
    T[:3, 3] = twist[3:]
    return T
