"""Wrong versions of inverse kinematics by damped least squares: what a learner's solver computes
when one thing is wrong.

Each entry of :data:`WRONG_SOLVERS` is ``(mistake, place, function)``, a function of ``rows`` (n,
4), ``T_goal`` (4, 4), ``q`` (n,), ``damping`` and ``steps``; metres and radians, turning joints,
standard convention.
"""

import numpy as np

from ....kinematics import frames, link_matrices
from .errors import WRONG_ERRORS, pose_error
from .jacobians import WRONG_JACOBIANS, geometric_jacobian
from .products import product
from .versions import Versions

__all__ = ["chain", "damped_step", "inverse_kinematics", "wrapped", "WRONG_SOLVERS"]

DEG = 180 / np.pi


def chain(rows, q):
    """The frames {0} to {n} of a table, (n + 1, 4, 4)."""
    rows = np.asarray(rows, dtype=float)
    return frames(np.eye(4), link_matrices("standard", rows[:, 0] + q, *rows[:, 1:].T))


def wrapped(q):
    """Angles between −π and π: whole turns are left free."""
    return np.angle(np.exp(1j * np.asarray(q, dtype=float)))


def damped_step(J, e, damping):
    """Jᵀ (J Jᵀ + λ² 1)⁻¹ e, the Δq with the least |J Δq − e|² + λ² |Δq|² (Siciliano et al.,
    Robotics, section 3.5.2).
    """
    return J.T @ np.linalg.solve(J @ J.T + damping**2 * np.eye(len(J)), e)


def _looked(rows, q, jacobian, error, T_goal):
    """Jacobian and error at q."""
    seen = chain(rows, q)
    return jacobian(seen, seen[-1], np.zeros(len(q), dtype=bool)), error(seen[-1], T_goal)


def _solved(
    rows, T_goal, q, damping, steps, step=damped_step, jacobian=geometric_jacobian, error=pose_error
):
    q = np.asarray(q, dtype=float)
    for _ in range(steps):
        q = q + step(*_looked(rows, q, jacobian, error, T_goal), damping)
    return q


def inverse_kinematics(rows, T_goal, q, damping, steps):
    """The right one: ``steps`` times a damped step from where the last one ended; joint values
    (n,), whole turns taken off.

    Examples
    --------
    >>> rows = np.array([[0, 0.1, 0, 1.5], [0, 0, 0.4, 0], [0, 0.2, 0.3, 0.4]])
    >>> T_goal = product(rows, [0.3, 0.4, 0.5])
    >>> inverse_kinematics(rows, T_goal, np.array([0.1, 0.6, 0.7]), 0.01, 20).round(6)
    array([0.3, 0.4, 0.5])
    """
    return wrapped(_solved(rows, T_goal, q, damping, steps))


def _stepping(step):
    return lambda *task: wrapped(_solved(*task, step=step))


def _undamped(J, e, damping):
    return np.linalg.pinv(J) @ e


def _only_last(rows, T_goal, q, damping, steps):
    """Only the last step is added to the first q."""
    before = _solved(rows, T_goal, q, damping, steps - 1)
    return q + _solved(rows, T_goal, before, damping, 1) - before


def _frozen(jacobian_too, error_too):
    """Jacobian, or error, computed once before the loop."""

    def solve(rows, T_goal, q, damping, steps):
        J_0, e_0 = _looked(rows, q, geometric_jacobian, pose_error, T_goal)
        for _ in range(steps):
            J, e = _looked(rows, q, geometric_jacobian, pose_error, T_goal)
            q = q + damped_step(J_0 if jacobian_too else J, e_0 if error_too else e, damping)
        return wrapped(q)

    return solve


def _other_steps(change):
    return lambda rows, T_goal, q, damping, steps: wrapped(
        _solved(rows, T_goal, q, damping, change(steps))
    )


def _with_jacobian(version):
    return lambda *task: wrapped(_solved(*task, jacobian=version))


def _with_error(version):
    return lambda *task: wrapped(_solved(*task, error=version))


def _one(J):
    return np.eye(len(J))


_OWN = [
    (
        "error-sign",
        "the step is subtracted",
        _stepping(lambda J, e, damping: -damped_step(J, e, damping)),
    ),
    ("damping-missing", "", _stepping(_undamped)),
    ("damping-not-squared", "", _stepping(lambda J, e, damping: damped_step(J, e, damping**0.5))),
    (
        "damping-not-on-diagonal",
        "",
        _stepping(lambda J, e, damping: J.T @ np.linalg.solve(J @ J.T + damping**2, e)),
    ),
    (
        "damping-not-on-diagonal",
        "and not squared",
        _stepping(lambda J, e, damping: J.T @ np.linalg.solve(J @ J.T + damping, e)),
    ),
    (
        "damping-sides-mixed",
        "Jᵀ (Jᵀ J + λ² 1)⁻¹",
        _stepping(lambda J, e, damping: J.T @ np.linalg.solve(J.T @ J + damping**2 * _one(J), e)),
    ),
    (
        "damping-sides-mixed",
        "(J Jᵀ + λ² 1)⁻¹ Jᵀ",
        _stepping(lambda J, e, damping: np.linalg.solve(J @ J.T + damping**2 * _one(J), J.T @ e)),
    ),
    (
        "damping-sides-mixed",
        "J where Jᵀ belongs",
        _stepping(lambda J, e, damping: J @ np.linalg.solve(J @ J.T + damping**2 * _one(J), e)),
    ),
    (
        "damping-sides-mixed",
        "(J + λ² 1)⁻¹",
        _stepping(lambda J, e, damping: np.linalg.solve(J + damping**2 * _one(J), e)),
    ),
    ("jacobian-transpose-only", "", _stepping(lambda J, e, damping: J.T @ e)),
    (
        "jacobian-transpose-only",
        "divided by the damping",
        _stepping(lambda J, e, damping: J.T @ e / damping**2),
    ),
    (
        "jacobian-transpose-only",
        "times the damping",
        _stepping(lambda J, e, damping: damping * J.T @ e),
    ),
    (
        "step-not-accumulated",
        "only the last step is added to the first q",
        lambda *task: wrapped(_only_last(*task)),
    ),
    (
        "step-not-accumulated",
        "the last step is returned, not q",
        lambda *task: wrapped(_only_last(*task) - task[2]),
    ),
    (
        "step-not-accumulated",
        "the sum of the steps is returned, without the first q",
        lambda *task: wrapped(_solved(*task) - task[2]),
    ),
    ("loop-stops-early", "one step only", _other_steps(lambda steps: 1)),
    ("loop-stops-early", "one step too few", _other_steps(lambda steps: steps - 1)),
    ("loop-stops-early", "no step at all: q comes back", _other_steps(lambda steps: 0)),
    ("loop-stops-early", "one step too many", _other_steps(lambda steps: steps + 1)),
    ("jacobian-not-renewed", "the Jacobian is that of the first q", _frozen(True, False)),
    ("jacobian-not-renewed", "the error is that of the first q", _frozen(False, True)),
    ("jacobian-not-renewed", "Jacobian and error are those of the first q", _frozen(True, True)),
    (
        "degrees-for-radians",
        "the answer is in degrees",
        lambda *task: wrapped(DEG * _solved(*task)),
    ),
    (
        "degrees-for-radians",
        "each step is in degrees",
        _stepping(lambda J, e, damping: DEG * damped_step(J, e, damping)),
    ),
    ("pi-rounded", "the answer, 2 decimals", lambda *task: np.round(wrapped(_solved(*task)), 2)),
]


def _made():
    yield from _OWN
    for mistake, place, version in WRONG_JACOBIANS:
        yield (
            mistake,
            f"the Jacobian: {place}" if place else "the Jacobian",
            _with_jacobian(version),
        )
    for mistake, place, version in WRONG_ERRORS:
        yield (
            mistake,
            f"the pose error: {place}" if place else "the pose error",
            _with_error(version),
        )


def _sample():
    rng = np.random.default_rng(4)
    rows = rng.uniform(0.2, 0.5, (6, 4)) * [2, 1, 1, 2]
    q = rng.uniform(-1, 1, 6)
    return rows, product(rows, q + 0.2), q, 0.1, 3


# without those that are right for turning joints and no tool
WRONG_SOLVERS = Versions(_made, _sample, inverse_kinematics)
