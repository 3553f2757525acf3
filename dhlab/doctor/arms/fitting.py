"""Measured poses, how far a model is from them in units of their noise, and small fits of a model's
numbers to them.
"""

from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation
from scipy.special import chdtri

from ...arm import Arm
from ...table import DHTable
from ...transform import inverse

__all__ = [
    "Measured",
    "Fit",
    "misfit",
    "fit",
    "with_rows",
    "with_parts",
    "place_ends",
    "carried",
    "limit",
    "rotation_vectors",
]

FALSE_ALARM = 1e-7  # how often right data may look wrong


@dataclass(frozen=True)
class Measured:
    """What was measured: ``q`` (m, n), positions ``p`` (m, 3) in m, rotations ``R`` (m, 3, 3) or
    None, the noise per axis (m, rad), what is free.
    """

    q: np.ndarray
    p: np.ndarray
    R: np.ndarray | None
    noise: tuple
    base_free: bool = False
    tool_free: bool = False

    @property
    def count(self):
        """How many numbers were measured."""
        return self.p.size * (1 if self.R is None else 2)

    def residual(self, T):
        """(m, 3 or 6): predicted minus measured, in units of the noise."""
        position = (T[..., :3, 3] - self.p) / self.noise[0]
        if self.R is None:
            return position
        turn = rotation_vectors(np.swapaxes(T[..., :3, :3], -1, -2) @ self.R) / self.noise[1]
        return np.concatenate([position, turn], axis=-1)


@dataclass(frozen=True)
class Fit:
    """A model fitted to measurements: the Arm, its χ², how many numbers were fitted, their values'
    standard deviations.
    """

    arm: Arm
    chi2: float
    fitted: int = 0
    sigma: np.ndarray = None

    def explains(self, data):
        """Whether the misfit is no larger than the noise makes it."""
        return self.chi2 <= limit(data.count - self.fitted)


def limit(freedom):
    """The χ² that noise alone passes once in ten million draws."""
    return chdtri(max(freedom, 1), FALSE_ALARM)


def _hopeless(data):
    """A χ² that neither another base or tool nor slow steps of a fit will bring down to the noise;
    exact data may begin far off.
    """
    return 100 * limit(data.count) + 1e6


def rotation_vectors(R):
    """Rotation vectors (..., 3) of rotation matrices (..., 3, 3)."""
    return Rotation.from_matrix(R.reshape(-1, 3, 3)).as_rotvec().reshape(R.shape[:-1])


def with_rows(arm, rows, **parts):
    """The arm with other rows (theta, d, a, alpha in rad and m) and perhaps other parts.

    The search makes tens of thousands of arms from checked ones, so the checks of ``DHTable`` and
    ``Arm`` are not made again.
    """
    table, changed = object.__new__(DHTable), object.__new__(Arm)
    columns = dict(zip(("theta", "d", "a", "alpha"), np.array(rows, dtype=float).T + 0.0))
    table.__dict__.update(
        columns,
        convention=parts.pop("convention", arm.table.convention),
        joints=parts.pop("joints", arm.table.joints),
    )
    changed.__dict__.update(arm.__dict__, table=table, **parts)
    changed.__dict__.pop("_kinematics", None)  # worked out from the parts that were
    return changed


def with_parts(arm, **parts):
    """The arm with another base, tool or sign; unchecked, like :func:`with_rows`."""
    changed = object.__new__(Arm)
    changed.__dict__.update(arm.__dict__, **parts)
    changed.__dict__.pop("_kinematics", None)
    return changed


def misfit(arm, data):
    """The Fit of an arm as it is; base and tool put in place where they are free.

    One end is placed in closed form: to the end where only positions were measured, otherwise near
    enough to see that a fit is hopeless.
    """
    placed = place_ends(arm, data)
    chi2 = float((data.residual(placed.forward(data.q)) ** 2).sum())
    ends = data.base_free + data.tool_free
    if ends == 0 or ends == 1 and (data.R is None or chi2 > _hopeless(data)):
        return Fit(placed, chi2, ends * (3 if data.R is None and data.tool_free else 6))
    return fit(placed, data, ())


def place_ends(arm, data):
    """The arm with the free base and tool that bring it near the measured poses."""
    if not (data.base_free or data.tool_free):
        return arm
    T = arm.forward(data.q)
    if data.R is None:
        return _placed_by_positions(arm, T, data)
    U = np.tile(np.eye(4), (len(T), 1, 1))
    U[:, :3, :3], U[:, :3, 3] = data.R, data.p
    B, E = np.eye(4), np.eye(4)
    if data.base_free and data.tool_free:
        B[:3, :3] = _aligned(T, U)
    for _ in range(10 if data.base_free and data.tool_free else 1):
        if data.tool_free:
            E = _mean(inverse(B @ T) @ U)
        if data.base_free:
            B = _mean(U @ inverse(T @ E))
    return with_parts(arm, base=_rigid(B @ arm.base), tool=_rigid(arm.tool @ E))


def _placed_by_positions(arm, T, data):
    """The same from positions alone: a tool point is the mean of where the measured ones are in the
    last frame, a base is carried there.
    """
    B, E = np.eye(4), np.eye(4)
    for _ in range(10 if data.base_free and data.tool_free else 1):
        if data.tool_free:
            E[:3, 3] = (
                (inverse(B @ T)[:, :3, :3] @ (data.p - (B @ T)[:, :3, 3])[..., None])[..., 0]
            ).mean(0)
        if data.base_free:
            B = _kabsch((T @ E)[:, :3, 3], data.p)
    return with_parts(arm, base=_rigid(B @ arm.base), tool=arm.tool @ E)


def _kabsch(points, targets):
    """The pose that carries points to targets best (Kabsch 1976)."""
    a, b = points - points.mean(0), targets - targets.mean(0)
    U, _, Vt = np.linalg.svd(b.T @ a)
    T = np.eye(4)
    T[:3, :3] = U @ np.diag([1, 1, np.linalg.det(U @ Vt)]) @ Vt
    T[:3, 3] = targets.mean(0) - T[:3, :3] @ points.mean(0)
    return T


def carried(points, targets):
    """The squares left when each set of points (k, m, 3) is carried to the targets (m, 3) as well
    as a pose can (Kabsch 1976).
    """
    a, b = points - points.mean(1, keepdims=True), targets - targets.mean(0)
    U, s, Vt = np.linalg.svd(b.T @ a)
    s[:, 2] *= np.sign(np.linalg.det(U) * np.linalg.det(Vt))
    return (a**2).sum((1, 2)) + (b**2).sum() - 2 * s.sum(1)


def _aligned(T, U):
    """The base rotation from relative motions: conjugate rotations have rotation vectors turned by
    it.
    """
    a = rotation_vectors(T[1:, :3, :3] @ T[0, :3, :3].T)
    b = rotation_vectors(U[1:, :3, :3] @ U[0, :3, :3].T)
    return _kabsch(np.vstack([a, -a]), np.vstack([b, -b]))[:3, :3]


def _mean(poses):
    """The mean pose: the rotation nearest to the sum of the rotations."""
    T = np.eye(4)
    T[:3, :3] = poses[:, :3, :3].mean(0)
    T[:3, 3] = poses[:, :3, 3].mean(0)
    return _rigid(T)


def _rigid(T):
    U, _, Vt = np.linalg.svd(T[:3, :3])
    R = U @ np.diag([1, 1, np.linalg.det(U @ Vt)]) @ Vt
    T = T.copy()
    T[:3, :3] = R
    return T


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
    best = (data.residual(arm.forward(data.q)) ** 2).sum()
    if size == 0:
        return Fit(arm, float(best))
    start = np.array([arm.table.rows[entry] for entry in free])
    stiff = np.zeros(size)
    if prior:
        stiff[: len(free)] = [1 / prior[0 if column in (1, 2) else 1] for _, column in free]
    damping, far = 1e-9, _hopeless(data)
    for _ in range(steps):
        J, r = _jacobian(arm, data, free, base, tool)
        pull = np.zeros(size)
        pull[: len(free)] = [arm.table.rows[entry] for entry in free] - start
        H, g = J.T @ J + np.diag(stiff**2), J.T @ r + stiff**2 * pull
        step = np.linalg.lstsq(H + damping * np.diag(np.diag(H) + 1e-12), -g, rcond=1e-13)[0]
        trial = _moved(arm, step, free, base, tool)
        moved = np.array([trial.table.rows[entry] for entry in free]) - start
        chi2 = (data.residual(trial.forward(data.q)) ** 2).sum() + (
            (stiff[: len(free)] * moved) ** 2
        ).sum()
        if chi2 < best:
            done = best - chi2 < (1e-2 if chi2 > far else 1e-7) * (1 + chi2)
            arm, best, damping = trial, chi2, damping / 10
            if done:
                break
        else:
            damping = max(damping * 30, 1e-5)
            if damping > 1e4:
                break
    J, _ = _jacobian(arm, data, free, base, tool)
    sigma = np.sqrt(np.clip(np.diag(np.linalg.pinv(J.T @ J, rcond=1e-10, hermitian=True)), 0, None))
    return Fit(
        arm, float(best), np.linalg.matrix_rank(J, tol=1e-6 * np.abs(J).max(initial=1e-300)), sigma
    )


def _jacobian(arm, data, free, base, tool):
    """Residuals' derivatives: each number of a row turns or shifts what is behind it, like a joint
    of its own.
    """
    F = arm.frames(data.q)
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
    v = np.where(turns, np.cross(axes, end[:, None, :3, 3] - origins), axes) / data.noise[0]
    r = data.residual(end)
    if data.R is not None:
        omega = np.where(turns, -axes @ end[:, :3, :3], 0.0) / data.noise[1]
        v = np.concatenate([v, omega], axis=-1)
    return np.swapaxes(v, 1, 2).reshape(-1, v.shape[1]), r.reshape(-1)


def _moved(arm, step, free, base, tool):
    rows = arm.table.rows
    for (i, column), value in zip(free, step):
        rows[i, column] += value
    parts, rest = {}, step[len(free) :]
    if base:
        parts["base"] = _rigid(_pose(rest[:6]) @ arm.base)
        rest = rest[6:]
    if tool:
        parts["tool"] = _rigid(arm.tool @ _pose(rest))
    return with_rows(arm, rows, **parts)


def _pose(twist):
    T = np.eye(4)
    T[:3, :3] = Rotation.from_rotvec(twist[:3]).as_matrix()
    T[:3, 3] = twist[3:]
    return T
