"""Too few poses to tell: the list of what fits, and the pose that would decide."""

from dataclasses import replace

import numpy as np

from ....printing import number
from ...budget import CHOICE, NAMES
from ...catalogue import catalogue
from ...diagnosis import UNDECIDED, Diagnosis
from ..given import distinct
from ..words.ranking import differs, named, telling_pose
from .agreement import FEW, are_few, possible, too_free
from .weighing import as_it_is, largest

__all__ = ["may_be_noise", "undecided"]

MOST = 5  # candidates that are listed


def undecided(data, now, fitting, notes, budget):
    """The Diagnosis that names no mistake: what fits (Weighed, the cheapest first), and what to
    measure next.
    """
    before, kinds, few = largest(now.arm, data), distinct(data.q), are_few(now, data)
    better = [w for w in fitting if w.cost < as_it_is(now.arm, data)]
    candidates = _unlike(better, data)
    words = "names of what fits"
    part = budget.part(words, NAMES)
    fits = tuple(_as_one(w, data, part) for w in budget.within(candidates, words, CHOICE))
    said = (*notes, *_as_it_stands(before, data), *_needed(kinds, data))
    pose = telling_pose([now.arm, *(w.explanation.fit.arm for w in candidates)])
    return Diagnosis(
        UNDECIDED,
        _headline(kinds, len(fits), may_be_noise(before, data), data, few, too_free(now, data)),
        before=before,
        notes=said,
        next_pose=pose,
        fits=fits,
    )


def _headline(kinds, fits, may_be_right, data, few, free):
    what = ("pose" if data.R is not None else "position") + ("s" if kinds > 1 else "")
    if data.base_free or data.tool_free:
        what += " with a free " + " and ".join(
            end for end in ("base", "tool") if getattr(data, f"{end}_free")
        )
    if not few and not free:
        return "A little more misfit than the noise makes, and nothing that is sure to be wrong."
    if fits:
        return f"{kinds} {what} cannot tell: each of these fits."
    if may_be_right:
        return f"{kinds} {what} cannot tell what is wrong, or whether anything is."
    return f"Something is wrong; {kinds} {what} cannot tell what."


def _unlike(fitting, data):
    """Candidates whose arms move otherwise, the cheapest first."""
    chosen = []
    for w in fitting:
        at = replace(data, noise=w.level)
        arms = [other.explanation.fit.arm for other in chosen]
        if len(chosen) < MOST and all(differs(w.explanation.fit.arm, a, at) for a in arms):
            chosen.append(w)
    return chosen


def _as_one(w, data, part):
    """The Finding of a candidate; two mistakes are put into one line."""
    first, *more = named(w.explanation, replace(data, noise=w.level), part)
    if not more:
        return first
    others = ", and ".join(map(_titled, more))
    return replace(first, detail=f"{first.detail or first.place}, and {others}")


def _titled(finding):
    where = "; ".join(word for word in (finding.place, finding.detail) if word)
    return f"{catalogue()[finding.mistake].title} ({where})"


def _as_it_stands(apart, data):
    """Whether the table itself would do."""
    if data.stated:
        yield f"The table as it is leaves {_size_text(apart)}, more than the stated noise makes."
    elif may_be_noise(apart, data):
        yield (
            f"The table as it is leaves {_size_text(apart)}: if it was measured that coarsely,"
            " nothing need be wrong. Say how exact it is (noise=, --noise)."
        )


def may_be_noise(apart, data):
    """Whether the measurements may have been so coarse."""
    most = possible(data)
    small = np.isnan(apart[1]) or apart[1] < np.rad2deg(4 * most[1])
    return bool(apart[0] < 4e3 * most[0] and small)


def _size_text(apart):
    words = f"up to {number(apart[0], 2)} mm"
    return words if np.isnan(apart[1]) else words + f" and {number(apart[1], 2)}°"


def _needed(kinds, data):
    if kinds < FEW:
        yield (
            f"Measure {FEW + 1 - kinds} more, general ones, without zeros and right angles, the one"
            " below first."
        )
    else:
        yield "Measure some more, the one below first."
