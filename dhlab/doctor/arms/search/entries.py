"""Fits of one number of the table each, all of them at once: a number changes one link, and what
stands before it and behind it is multiplied once.
"""

import numpy as np

from .... import kinematics
from ....fast.plain import Plain
from ...mistakes.remade import ALPHA, THETA, A, with_rows
from .fitting import DAMPING, MOST_DAMPING, Fit, damped, derivatives, done, hopeless

__all__ = ["fitted_one_by_one"]

AT_ONCE = 2000  # poses, of all the entries together, whose links take half a megabyte


def fitted_one_by_one(arm, data, begun, steps):
    """The :class:`Fit` of every entry by itself, as ``fit`` makes it where base and tool are fixed.

    Parameters
    ----------
    arm : Arm
    data : Measured
    begun : mapping of (row, column) to float
        How far from the arm's own number an entry's fit begins.
    steps : mapping of (row, column) to int
        How many steps it may take.

    Returns
    -------
    dict of (row, column) to Fit
    """
    entries, together = list(begun), max(1, AT_ONCE // len(data.q))
    found = {}
    for at in range(0, len(entries), together):
        some = entries[at : at + together]
        fits = _Links(arm, data, some).fits([begun[e] for e in some], [steps[e] for e in some])
        found.update(zip(some, fits))
    return found


class _Links:
    """For each of some entries the link (k, m, 4, 4) that it stands in, between what is before it
    and what is behind.
    """

    def __init__(self, arm, data, entries):
        self.arm, self.data, self.entries = arm, data, entries
        plain = Plain(arm.table, arm.base, arm.tool, arm.sign, arm.coupling)
        rows, self.columns = (np.array(part) for part in zip(*entries))
        before = plain.frames(data.q)
        links, behind = plain.links(data.q), [np.broadcast_to(arm.tool, before[:, 0].shape)]
        for i in reversed(range(1, len(arm))):
            behind.append(links[:, i] @ behind[-1])
        self.before = np.moveaxis(before[:, rows], 1, 0)
        self.behind = np.stack(behind[::-1])[rows]
        theta, d = (np.moveaxis(part[:, rows], 1, 0) for part in plain.variables(data.q))
        self.numbers = [theta, d, *(each[rows, None] for each in (arm.table.a, arm.table.alpha))]
        of_z = self.columns < A
        self.along, self.turns = np.where(of_z, 2, 0), np.isin(self.columns, (THETA, ALPHA))
        self.from_before = of_z == (arm.table.convention == "standard")

    def fits(self, begun, steps):
        """Damped Gauss-Newton steps of one number each."""
        moved, steps = np.array(begun, dtype=float), np.array(steps)
        J, r = self._looked(moved, np.arange(len(moved)))
        best, damping = (r**2).sum(1), np.full(len(moved), DAMPING)
        far, busy = hopeless(self.data), steps > 0
        while busy.any():
            k = np.flatnonzero(busy)
            H, g = (J[k] ** 2).sum(1), (J[k] * r[k]).sum(1)
            trial = moved[k] - g / (H + damping[k] * (H + 1e-12))
            J_trial, r_trial = self._looked(trial, k)
            chi2 = (r_trial**2).sum(1)
            better = chi2 < best[k]
            damping[k], steps[k] = damped(damping[k], better), steps[k] - 1
            ends = np.where(better, done(best[k], chi2, far), damping[k] > MOST_DAMPING)
            busy[k] = ~ends & (steps[k] > 0)
            b = k[better]
            moved[b], best[b] = trial[better], chi2[better]
            J[b], r[b] = J_trial[better], r_trial[better]
        return [self._fit(*each) for each in zip(self.entries, moved, best, J, r)]

    def _fit(self, entry, moved, chi2, J, r):
        rows, H = self.arm.table.rows, (J**2).sum()
        rows[entry] += moved
        sigma = np.array([1 / np.sqrt(H) if H > 0 else 0.0])
        left = self.data.left_by(r)
        return Fit(with_rows(self.arm, rows), float(chi2), int(H > 0), sigma, left)

    def _looked(self, moved, k):
        """Derivatives and residuals, (len(k), 3m or 6m), with some of the entries moved."""
        numbers = [each[k] for each in self.numbers]
        for column in range(4):
            numbers[column] = (
                numbers[column] + np.where(self.columns[k] == column, moved, 0)[:, None]
            )
        theta, d, a, alpha = np.broadcast_arrays(*numbers)
        link = kinematics.link_matrices(self.arm.table.convention, theta, d, a, alpha)
        after = self.before[k] @ link
        end = after @ self.behind[k]
        frame = np.where(self.from_before[k, None, None, None], self.before[k], after)
        axis = np.take_along_axis(frame, self.along[k, None, None, None], axis=3)[..., :3, 0]
        turns = self.turns[k, None, None, None]
        J = derivatives(axis[:, :, None], frame[..., None, :3, 3], turns, end, self.data)
        return J.reshape(len(k), -1), self.data.residual(end).reshape(len(k), -1)
