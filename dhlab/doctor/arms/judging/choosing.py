"""Which explanations are good enough to be told: settled at the noise that they leave, made round,
weighed against the table as it is, against explaining nothing, and against each other.
"""

from dataclasses import dataclass, replace

import numpy as np

from ...budget import CHOICE
from ..search.fitting import fit, misfit
from ..search.measured import limit
from ..words.ranking import snapped, taken_over
from .agreement import may_be_scatter, possible
from .weighing import as_it_is, as_measured, weigh

__all__ = ["Choice", "choose", "least_needed"]

OVER_TABLE = 5.0  # nats by which an explanation must be better than the table as it is
OVER_NOTHING = 10.0  # nats by which it must be better than the bare numbers
LOOKED_AT = 24  # so many of the cheapest are settled
AS_GOOD = 12.0  # nats dearer than the best, and still told as fitting


@dataclass(frozen=True)
class Choice:
    """The explanations that fit, the cheapest first, and of these the ones that also convince: that
    the data could not as well be explained by chance.
    """

    fitting: tuple
    convincing: tuple

    @property
    def best(self):
        """The cheapest that convinces, None where none does."""
        return self.convincing[0] if self.convincing else None


def choose(explanations, data, now, budget):
    """The :class:`Choice` from many explanations, fitting or not."""
    rough = sorted((weigh(e, data) for e in explanations), key=_order)
    near = [w for w in rough[:LOOKED_AT] if _may_fit(w, data)]
    part = budget.part("a closer look at what may fit", CHOICE)
    settled = [_settled(w, data) for w in part(near)]
    fitting = sorted((w for w in settled if _fits(w, data)), key=_order)
    of_the_arm = [w.cost for w in fitting if w.explanation.data_fault is None]
    most = (
        min(of_the_arm, default=np.inf) - AS_GOOD
    )  # measurements are blamed where that is far cheaper
    fitting = [w for w in fitting if w.explanation.data_fault is None or w.cost < most]
    needed = least_needed(now.arm, data)
    convincing = [w for w in fitting if w.cost <= needed and _leaves_enough(w, data)]
    if convincing:
        convincing = [w for w in convincing if w.cost <= convincing[0].cost + AS_GOOD]
    return Choice(tuple(fitting), tuple(convincing))


def _leaves_enough(w, data):
    """Whether a base or a tool that was fitted leaves as many measured numbers as it takes: three
    points are carried to three others by many a wrong one.
    """
    return not w.explanation.ends or data.count >= 2 * w.explanation.fit.fitted


def _order(w):
    """By cost; of equally dear ones, which make the same arm, what the search found first."""
    return round(w.cost, 2)


def least_needed(placed, data):
    """What an explanation may cost at most to convince, nats; ``placed`` is the table as it is."""
    return min(as_it_is(placed, data) - OVER_TABLE, as_measured(data) - OVER_NOTHING)


def _may_fit(w, data):
    """Whether a settled fit can come within the noise, from what the rough one leaves."""
    most = possible(_mended(w, data))
    return data.stated or all(s < 10 * m for s, m in zip(w.level, most) if s > 0)


def _mended(w, data):
    """The measurements as an explanation takes them."""
    return data if w.explanation.changed is None else w.explanation.changed


def _settled(w, data):
    """The same explanation, fitted once more where its noise was not known before, and made round;
    weighed again.
    """
    e, mended = w.explanation, _mended(w, data)
    if not data.stated:
        e = _refitted(e, replace(mended, noise=w.level))
        mended = replace(mended, noise=weigh(e, data).level)
    e = snapped(e, mended)
    return weigh(e, data)


def _refitted(e, data):
    base, tool = data.base_free or "base" in e.ends, data.tool_free or "tool" in e.ends
    if e.entries or e.ends:
        found = fit(e.fit.arm, data, e.entries, base=base, tool=tool, steps=6)
    else:
        found = misfit(e.fit.arm, data)
    chain = e.chain if e.data_fault is not None else taken_over(e, found.arm)
    return replace(e, fit=found, chain=chain)


def _fits(w, data):
    """Whether what is left is no more than noise, and anything is left at all."""
    e, mended = w.explanation, _mended(w, data)
    left = data.count - e.fit.fitted
    if left <= 0:
        return False
    if data.stated:
        return e.fit.chi2 <= limit(left)
    return may_be_scatter(e.fit, mended, w.level)
