"""Several signs at once: of the alphas, and of all lengths, each pattern by one matrix product."""

import numpy as np

from ...mistakes.remade import ALPHA, A, D, with_rows
from .ends import carried
from .fitting import misfit

__all__ = ["entries_of", "length_columns", "signs_of_lengths", "signs_of_twists"]


def entries_of(arm, columns=range(4)):
    """(row, column) of every number of the table."""
    return [(i, column) for i in range(len(arm)) for column in columns]


def signs_of_twists(arm, data, part):
    """Arms with other signs of several alphas (their lengths' signs open), the two that fit best:
    by rotation, with a free base by position.
    """
    twisted = np.flatnonzero(np.abs(np.sin(arm.table.alpha)) > 1e-9)
    by_position = data.R is None or data.base_free
    if (
        data.tool_free
        or not 2 <= len(twisted) <= 7
        or (by_position and (arm.table.rows[:, 1:] < 0).any())
    ):  # lost signs leave no negative number
        return []
    trials = []
    for pattern in part(range(1, 2 ** len(twisted))):
        rows = arm.table.rows
        rows[twisted[[(pattern >> k) & 1 == 1 for k in range(len(twisted))]], ALPHA] *= -1
        trial = with_rows(arm, rows)
        trials.append(
            (
                (
                    min(_length_signs(trial, data)[2], default=np.inf)
                    if by_position
                    else _rotation_apart(trial, data)
                ),
                pattern,
                trial,
            )
        )
    return [trial for _, _, trial in sorted(trials, key=lambda item: item[:2])[:2]]


def _rotation_apart(arm, data):
    R = arm.frames(data.q[:3])[:, -1, :3, :3] @ arm.tool[:3, :3]
    return -np.einsum("kij,kij->", R, data.R[:3])


def signs_of_lengths(arm, data):
    """All lengths with other signs, the two patterns that fit best."""
    entries, patterns, misfits = _length_signs(arm, data)
    for k in np.argsort(misfits)[:2]:
        rows = arm.table.rows
        for e, sign in zip(entries, patterns[k]):
            rows[e] *= sign
        yield misfit(with_rows(arm, rows), data)


def _length_signs(arm, data):
    """The lengths, every pattern of their signs and its misfit: positions are linear in lengths, so
    every pattern is one matrix product.
    """
    entries = [
        e
        for e in entries_of(arm, (D, A))
        if arm.table.rows[e] and not (e[1] == D and arm.table.joints[e[0]] == "P")
    ]
    if data.tool_free or not 2 <= len(entries) <= 12:
        return [], [], []
    columns, off = length_columns(arm, data, entries)
    lengths = np.array([arm.table.rows[e] for e in entries])
    patterns = 1 - 2 * ((np.arange(2 ** len(entries))[:, None] >> np.arange(len(entries))) & 1)
    offs = off + (patterns - 1) * lengths @ columns.T
    targets = data.p / data.noise[0]
    return (
        entries,
        patterns,
        (
            carried(offs.reshape(len(offs), -1, 3) + targets, targets)
            if data.base_free
            else (offs**2).sum(1)
        ),
    )


def length_columns(arm, data, entries):
    """How the positions move with each length (3m, k) and how far they are off now (3m,), in units
    of the noise.
    """
    F = arm.frames(data.q)
    standard = arm.table.convention == "standard"
    axes = [F[:, i if (c == D) == standard else i + 1, :3, 2 if c == D else 0] for i, c in entries]
    off = ((F[:, -1] @ arm.tool)[:, :3, 3] - data.p) / data.noise[0]
    return np.stack([axis.reshape(-1) for axis in axes], axis=1) / data.noise[0], off.reshape(-1)
