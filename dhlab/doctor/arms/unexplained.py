"""What can still be said of measurements that no mistake explains: one bad line, what is right all
the same, what would make the table agree.
"""

from dataclasses import replace

import numpy as np

from ...printing import number
from ...rotations import rotation_vectors
from ..budget import CHOICE
from ..mistakes.themes.models import models
from .search.fitting import misfit
from .search.measured import limit
from .search.singles import Explanation, singles

__all__ = ["all_but_one", "of_the_library", "right_part", "still_right"]

MOST_POSES = 40  # beyond these a line is looked for by eye
SUSPECTS = 3  # a search for each of them left out
FEWEST = {
    True: 6,
    False: 9,
}  # poses and positions that are needed before one of them may be doubted
TWO_TURNS = 4 * np.pi  # no table needs a larger angle
LOUDER = 6  # noise so many times as large as stated is worth a word


def all_but_one(arm, data, clock):
    """(index of the one measurement that does not belong, the rest, explanations of the rest); None
    unless there is exactly one such.

    The explanations are empty when the table agrees with the rest.
    """
    m = len(data.q)
    if not FEWEST[data.R is not None] <= m <= MOST_POSES:
        return None
    part = clock.part("all measurements but one")
    rests = [_without(data, k) for k in range(m)]
    agreeing = [k for k in part(range(m)) if misfit(arm, rests[k]).explains(rests[k])]
    if clock.over:
        return None
    if agreeing:
        return (agreeing[0], rests[agreeing[0]], []) if len(agreeing) == 1 else None
    found = []
    for k in _suspects(arm, data, part):
        ones = [
            e
            for e in singles(arm, rests[k], part)
            if e.data_fault is None and len(e.entries) <= 1 and e.fit.explains(rests[k])
        ]
        if ones:
            found.append((k, rests[k], ones))
    return found[0] if len(found) == 1 else None


def _suspects(arm, data, part):
    """The measurements that stand out most from the repairs that fit the others best: one bad
    measurement spoils every fit, but not for all alike.
    """
    sizes = [
        np.linalg.norm(data.residual(e.fit.arm.forward(data.q)), axis=1)
        for e in singles(arm, data, part)
        if e.data_fault is None and len(e.entries) <= 1
    ]
    return list(dict.fromkeys(int(np.argmax(size)) for size in sorted(sizes, key=np.median)[:20]))[
        :SUSPECTS
    ]


def _without(data, k):
    keep = np.arange(len(data.q)) != k
    return replace(data, q=data.q[keep], p=data.p[keep], R=None if data.R is None else data.R[keep])


def of_the_library(arm, data, clock):
    """(name, Explanation, whether the table is that of another model) where a model of the library
    fits as it stands; None where none does.
    """
    known = list(clock.within(models(arm), "the models of the library", CHOICE))
    fits = [(name, misfit(model, data)) for name, model in known]
    name, best = min(fits, key=lambda fit: fit[1].chi2, default=(None, None))
    if best is None or best.arm.table == arm.table or not best.explains(data):
        return None
    mistaken = any(np.allclose(model.table.rows, arm.table.rows, atol=1e-6) for _, model in known)
    return name, Explanation(best, (arm, best.arm)), mistaken


def still_right(arm, data):
    """Sentences on what is right although something is wrong, and on what would make the table
    agree.
    """
    now = misfit(arm, data)
    found = (*_of_ends_and_units(arm, data), *right_part(now, data))
    return found or _louder(now, data) or _pose_by_pose(now, data)


def _of_ends_and_units(arm, data):
    if not (data.base_free and data.tool_free):
        freed = replace(data, base_free=True, tool_free=True)
        if misfit(arm, freed).explains(freed):
            yield (
                "With another base and another tool than the table's the measurements agree: give"
                ' --free-base and --free-tool (base="free", tool="free") to have both found.'
            )
    if np.abs(arm.table.rows[:, [0, 3]]).max() > TWO_TURNS:
        yield (
            "An angle of the table is more than two full turns: is the file in degrees, base and"
            " tool too, where its units say rad?"
        )


def right_part(now, data):
    """Whether rotation, or position, is right at every pose."""
    if data.R is None:
        return
    T = now.arm.forward(data.q)
    turn = np.linalg.norm(rotation_vectors(np.swapaxes(T[:, :3, :3], -1, -2) @ data.R), axis=1)
    if (turn**2).sum() / data.noise[1] ** 2 < limit(3 * len(turn)):
        yield (
            "The rotation is right at every pose, so q, the angles of the table and the senses"
            " are: look at the lengths, their unit, and the position of base and tool."
        )
    elif (_apart(now, data) ** 2).sum() / data.noise[0] ** 2 < limit(3 * len(turn)):
        yield (
            "The position is right at every pose: look at the columns of the orientation, their"
            " order and their unit."
        )


def _apart(now, data):
    """How far the positions are off, m."""
    return np.linalg.norm(now.arm.forward(data.q)[:, :3, 3] - data.p, axis=1)


def _louder(now, data):
    """How much noise would explain it."""
    louder = np.sqrt(now.chi2 / limit(data.count))
    if louder >= LOUDER:
        return ()
    words = number(1e3 * louder * data.noise[0], 1) + " mm"
    if data.R is not None:
        words += f", {number(np.rad2deg(louder * data.noise[1]), 2)}°"
    return (
        f"With {louder:.1f} times the noise ({words}) the table would agree: was it measured"
        " that coarsely?",
    )


def _pose_by_pose(now, data):
    millimetres = 1e3 * _apart(now, data)[:MOST_POSES]
    apart = ", ".join(number(x, 0 if x > 100 else 1) for x in millimetres)
    return (
        f"Off by, pose by pose (mm): {apart}. Check that q and poses belong together, in order"
        " and in unit, and that every joint was really where it was read; rows copied from"
        " another program may have their columns in its order (dhlab.recognise_table reads"
        " those).",
    )
