"""What can still be said of measurements that no mistake explains: one bad line, what is right all
the same, what would make the table agree.
"""

from dataclasses import replace

import numpy as np

from ...printing import number
from .armsearch import singles
from .fitting import limit, misfit, rotation_vectors

__all__ = ["all_but_one", "leads"]

MOST_POSES = 40  # beyond these a line is looked for by eye
SUSPECTS = 3  # a search for each of them left out
FEWEST = {
    True: 6,
    False: 9,
}  # poses and positions that are needed before one of them may be doubted
TWO_TURNS = 4 * np.pi  # no table needs a larger angle
LOUDER = 6  # noise so many times as large as stated is worth a word


def all_but_one(arm, data):
    """(index of the one measurement that does not belong, the rest, explanations of the rest); None
    unless there is exactly one such.

    The explanations are empty when the table agrees with the rest.
    """
    m = len(data.q)
    if not FEWEST[data.R is not None] <= m <= MOST_POSES:
        return None
    rests = [_without(data, k) for k in range(m)]
    agreeing = [k for k, rest in enumerate(rests) if misfit(arm, rest).explains(rest)]
    if agreeing:
        return (agreeing[0], rests[agreeing[0]], []) if len(agreeing) == 1 else None
    found = []
    for k in _suspects(arm, data):
        ones = [
            e
            for e in singles(arm, rests[k])
            if e.data_fault is None and len(e.entries) <= 1 and e.fit.explains(rests[k])
        ]
        if ones:
            found.append((k, rests[k], ones))
    return found[0] if len(found) == 1 else None


def _suspects(arm, data):
    """The measurements that stand out most from the repairs that fit the others best: one bad
    measurement spoils every fit, but not for all alike.
    """
    sizes = [
        np.linalg.norm(data.residual(e.fit.arm.forward(data.q)), axis=1)
        for e in singles(arm, data)
        if e.data_fault is None and len(e.entries) <= 1
    ]
    return list(dict.fromkeys(int(np.argmax(size)) for size in sorted(sizes, key=np.median)[:20]))[
        :SUSPECTS
    ]


def _without(data, k):
    keep = np.arange(len(data.q)) != k
    return replace(data, q=data.q[keep], p=data.p[keep], R=None if data.R is None else data.R[keep])


def leads(arm, data):
    """Sentences on what is right although something is wrong, and on what would make the table
    agree.
    """
    now = misfit(arm, data)
    T = now.arm.forward(data.q)
    position = np.linalg.norm(T[:, :3, 3] - data.p, axis=1)
    found = []
    if not (data.base_free and data.tool_free):
        freed = replace(data, base_free=True, tool_free=True)
        if misfit(arm, freed).explains(freed):
            found.append(
                "With another base and another tool than the table's the measurements agree: give"
                ' --free-base and --free-tool (base="free", tool="free") to have both found.'
            )
    if np.abs(arm.table.rows[:, [0, 3]]).max() > TWO_TURNS:
        found.append(
            "An angle of the table is more than two full turns: is the file in degrees, base and"
            " tool too, where its units say rad?"
        )
    if data.R is not None:
        turn = np.linalg.norm(rotation_vectors(np.swapaxes(T[:, :3, :3], -1, -2) @ data.R), axis=1)
        if (turn**2).sum() / data.noise[1] ** 2 < limit(3 * len(turn)):
            found.append(
                "The rotation is right at every pose, so q, the angles of the table and the senses"
                " are: look at the lengths, their unit, and the position of base and tool."
            )
        elif (position**2).sum() / data.noise[0] ** 2 < limit(3 * len(position)):
            found.append(
                "The position is right at every pose: look at the columns of the orientation, their"
                " order and their unit."
            )
    louder = np.sqrt(now.chi2 / limit(data.count))
    if not found and louder < LOUDER:
        words = (
            number(1e3 * louder * data.noise[0], 1)
            + " mm"
            + ("" if data.R is None else f", {number(np.rad2deg(louder * data.noise[1]), 2)}°")
        )
        found.append(
            f"With {louder:.1f} times the noise ({words}) the table would agree: was it measured"
            " that coarsely?"
        )
    if not found:
        apart = ", ".join(number(1e3 * x, 0 if x > 0.1 else 1) for x in position[:MOST_POSES])
        found.append(
            f"Off by, pose by pose (mm): {apart}. Check that q and poses belong together, in order"
            " and in unit, and that every joint was really where it was read; rows copied from"
            " another program may have their columns in its order (dhlab.recognise_table reads"
            " those)."
        )
    return tuple(found)
