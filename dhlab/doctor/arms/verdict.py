"""The verdict: whether the table agrees, which mistakes explain what was measured, whether the arm
is only a little off its table, or whether these poses cannot tell.
"""

from dataclasses import replace

import numpy as np

from ...printing import number
from ...transform import trans
from ..budget import NAMES
from ..diagnosis import AGREES, CALIBRATED, EXPLAINED, UNEXPLAINED, Diagnosis
from ..mistakes.remade import with_parts
from ..mistakes.themes.models import which_model
from .judging.agreement import agreement, are_few, may_be_scatter
from .judging.calibration import calibration, changes_by_size, explains_better, is_small
from .judging.choosing import choose, least_needed
from .judging.undecided import may_be_noise, undecided
from .judging.weighing import as_it_is, largest, level_left
from .search.fitting import misfit
from .search.measured import limit
from .search.pairs import pairs
from .search.singles import singles
from .words.differences import difference_text
from .words.ranking import named, ranked, rivals_of, telling_pose, with_equivalents

__all__ = ["decide", "explained"]

DOUBT = 8.0  # nats by which mistakes must explain a small misfit better than a calibration does
RIVAL = 4.0  # nats dearer, and still as good where the poses are few
FOR_PAIRS = 0.35  # share of the time that the search for two mistakes may take
TOOLS = 0.2  # of the reach; so far off a tool point is sought as well
CHEAPEST_PAIR = 10.0  # nats; where two mistakes could not convince, they are not looked for
MANY_NUMBERS = 2  # that nobody would have guessed: too many for few poses to prove
CLEAR = 4.0  # nats by which a calibration must be better than the table as it is


def decide(arm, data, notes, budget):
    """The verdict, with the time that there is."""
    now = _as_it_stands(arm, data)
    seen = agreement(now, data)
    if seen.agrees:
        words = "The table agrees with the measurements."
        said = (*notes, *_scatter(seen, data), *_weak(data))
        return Diagnosis(AGREES, words, before=largest(now.arm, data), notes=said)
    if not seen.shown:
        return undecided(data, now, (), notes, budget)
    small = is_small(now, data)
    whole = calibration(arm, now, data) if small else None
    found = list(singles(arm, data, budget.part("one mistake")))
    choice = choose(found, data, now, budget)
    few = are_few(now, data)
    numbers = choice.best is not None and choice.best.explanation.odd >= MANY_NUMBERS
    if (not _settles(choice, whole) or (few and numbers)) and least_needed(
        now.arm, data
    ) > CHEAPEST_PAIR:
        found += pairs(arm, data, budget.part("two mistakes", FOR_PAIRS))
        choice = choose(found, data, now, budget)
    if _settles(choice, whole):
        return _told(arm, data, now, choice, notes, budget)
    if few and choice.best is not None:
        return undecided(data, now, choice.fitting, notes, budget)
    if whole and whole.cost + CLEAR < as_it_is(now.arm, data) and explains_better(whole, data):
        return _calibrated(arm, data, whole, now, choice, notes)
    if few or _may_be_scatter(now, data):
        return undecided(data, now, choice.fitting, notes, budget)
    words = "No one or two mistakes explain these measurements."
    return Diagnosis(UNEXPLAINED, words, before=largest(now.arm, data), notes=notes)


def _as_it_stands(arm, data):
    """The Fit of the table as it is. With both ends free and positions alone, the ends are sought
    from several tools: from the first alone they may stop where no pose fits.
    """
    now = misfit(arm, data)
    if data.R is not None or not (data.base_free and data.tool_free) or now.explains(data):
        return now
    far = TOOLS * data.reach * np.vstack([np.eye(3), -np.eye(3)])
    others = [misfit(with_parts(arm, tool=arm.tool @ trans(x)), data) for x in far]
    return min([now, *others], key=lambda one: one.chi2)


def _may_be_scatter(now, data):
    """Whether the table as it is leaves no more than noise now and then does: too much for a clean
    bill, too little to say that something is wrong.
    """
    if data.stated:
        return now.chi2 <= limit(data.count)
    return may_be_scatter(now, data, level_left(now.arm, data, now.fitted))


def _settles(choice, whole):
    """Whether the best explanation is good enough that nothing else need be tried."""
    return choice.best is not None and (whole is None or choice.best.cost + DOUBT < whole.cost)


def _told(arm, data, now, choice, notes, budget):
    """The best explanation, or the list of those that are as good where few poses cannot tell."""
    best = choice.best
    as_good = [w for w in choice.fitting if w.cost <= best.cost + RIVAL]
    at = data if data.stated else replace(data, noise=best.level)
    explanations = [w.explanation for w in as_good]
    few = are_few(now, data)
    if few and (explanations[0].odd >= MANY_NUMBERS or _may_be_right(now, best, data)):
        return undecided(data, now, choice.fitting, notes, budget)
    if few and rivals_of(explanations[0], explanations[1:], at):
        return undecided(data, now, choice.fitting, notes, budget)
    told = [w.explanation for w in choice.convincing]
    return explained(arm, at, now, told, (*notes, *_noise_left(best, data)), budget)


def _may_be_right(now, best, data):
    """Whether the table as it is may be right, and chance have made what few poses show: it leaves
    no more than measurements can, and its repair leaves more than their digits.
    """
    if data.stated:
        return now.chi2 <= limit(data.count - now.fitted)
    rough = any(s > 2 * least for s, least in zip(best.level, data.floor))
    return rough and may_be_noise(largest(now.arm, data), data)


def _noise_left(best, data):
    if data.stated:
        return
    if all(s <= 2 * least for s, least in zip(best.level, data.floor)):
        yield "The measurements are exact to their digits."
    else:
        yield f"What is left is noise of {_level_text(best.level, data)}."


def _scatter(seen, data):
    """How large the noise is that an agreement supposes, where nobody stated it."""
    if not data.stated and any(s > 2 * least for s, least in zip(seen.level, data.floor)):
        yield (
            f"What is left looks like scatter of {_level_text(seen.level, data)} in each direction;"
            " no number of the table would take much of it away."
        )


def _level_text(level, data):
    words = f"{number(1e3 * level[0], 3)} mm"
    return words if data.R is None else words + f" and {number(np.rad2deg(level[1]), 3)}°"


def _calibrated(arm, data, whole, now, choice, notes):
    before = largest(now.arm, data)
    words = (
        "No one or two mistakes: every number of this arm is a little off the table, together by"
        f" {number(before[0], 1)} mm at the worst pose."
    )
    nearest = [w.explanation for w in choice.fitting if len(w.explanation.entries) == 1][:1]
    said = tuple(
        f"If it is one number, this is the nearest: {difference_text(arm, e.fit.arm)}."
        for e in nearest
    )
    return Diagnosis(
        CALIBRATED,
        words,
        before=before,
        after=largest(whole.fit.arm, data),
        notes=(*notes, *changes_by_size(arm, whole, data), *said),
        fitted=whole.fit.arm,
    )


def explained(arm, data, now, explanations, notes, budget, measurements="the measurements"):
    """The Diagnosis from everything that fits: the simplest first, snapped to round numbers, named;
    the others noted. ``measurements`` says in words what is explained.
    """
    part = budget.part("names of what was found", NAMES)
    explanations = ranked(arm, explanations, data, part)
    best = explanations[0]
    findings = named(best, data, part)
    if len(findings) == 1 and best.data_fault is None:
        findings[0], same = with_equivalents(findings[0], best, explanations[1:], data, part)
        notes += same
    others = rivals_of(best, explanations[1:], data)
    headline, pose = f"{_words(len(findings))} {measurements}.", None
    model = which_model(findings[0].mistake, arm, best.fit.arm)
    if model is not None:
        headline, note = model
        notes += (note,)
    if others:
        pose = telling_pose([best.fit.arm, *(e.fit.arm for e in others)])
        notes += (
            "Another explanation fits these poses as well: "
            + "; ".join(named(e, data, part)[0].message.split(". ")[0] for e in others[:3])
            + ".",
        )
    return Diagnosis(
        EXPLAINED,
        headline,
        tuple(findings),
        largest(now.arm, data),
        largest(best.fit.arm, best.changed or data),
        notes + _weak(data),
        pose,
    )


def _words(count):
    if count == 1:
        return "One mistake explains"
    return f"{'Two' if count == 2 else count} mistakes together explain"


def _weak(data):
    """What these poses could not have shown."""
    needed, what = (3, "pose") if data.R is not None else (6, "position")
    if len(data.q) < needed:
        proves = "s prove" if len(data.q) > 1 else " proves"
        return (
            f"{len(data.q)} {what}{proves} little: {needed - len(data.q)} more, general ones,"
            " without zeros and right angles.",
        )
    steps = data.q / (np.pi / 2)
    if (np.abs(steps - np.round(steps)) < 1e-3).all():
        return (
            "All poses are at multiples of 90°, where many mistakes do not show: add three"
            " general ones.",
        )
    return ()
