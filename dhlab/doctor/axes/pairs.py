"""Two mistakes in a sheet of axes: to each of the best single ones the best second, and both fitted
together.
"""

from dataclasses import dataclass, replace

import numpy as np

from ..arms.search.measured import limit
from .chain import Chain
from .fitting import least
from .search import Explanation, explanations

__all__ = ["Pair", "pairs"]

FIRSTS = 8  # single changes, of different axes or kinds, that a second is looked for
SECONDS = 3
SPARE = 6  # measured numbers that must be left over


@dataclass(frozen=True)
class Pair:
    """Two changes with their numbers, fitted together; ``parts`` are both as Explanations of the
    same chain.
    """

    parts: tuple[Explanation, Explanation]

    @property
    def chain(self) -> Chain:
        """The chain with both taken back."""
        return self.parts[0].chain

    @property
    def free(self) -> int:
        """How many numbers were fitted."""
        return sum(part.change.free for part in self.parts)

    def explains(self, data) -> bool:
        """Whether no more is left than the noise makes."""
        left = data.count - self.free
        return left >= SPARE and self.parts[0].chi2 <= limit(left)

    def score(self, data) -> float:
        """As of an Explanation; the misfit, which both hold, counts once."""
        return sum(part.score(data) for part in self.parts) - self.parts[0].chi2

    @property
    def places(self) -> frozenset:
        """Which axes, and what of them."""
        return frozenset((part.change.joint, part.change.kind) for part in self.parts)


def pairs(sheet, data, singles, clock):
    """The pairs that explain the data, the best first, one for each two places."""
    found = {}
    for first in clock.within(_unlike(singles, FIRSTS), "two axes at once"):
        if clock.over:
            break
        more = [
            second
            for second in explanations(first.chain, data, clock)
            if second.change.joint != first.change.joint
        ]
        for second in clock.within(_unlike(more, SECONDS), "two axes at once"):
            pair = _together(sheet, first, second, data, clock)
            key = frozenset(part.change.joint for part in pair.parts)
            if pair.explains(data) and (
                key not in found or pair.score(data) < found[key].score(data)
            ):
                found[key] = pair
    return sorted(found.values(), key=lambda pair: pair.score(data))


def _unlike(singles, most):
    """The explanations that leave least, one for each axis and kind."""
    kept = {}
    for e in sorted(singles, key=lambda e: e.chi2):
        kept.setdefault((e.change.joint, e.change.kind), e)
    return list(kept.values())[:most]


def _together(sheet, first, second, data, clock):
    """The two, all their numbers fitted at once."""
    n = len(first.x)

    def chain_of(x):
        return second.change.apply(first.change.apply(sheet, x[:n]), x[n:])

    x = np.concatenate([first.x, second.x])
    if len(x):
        fit = least(lambda x: data.residual(chain_of(x).forward(data.q)), x, clock, 25)
        x, covariance = fit.x, fit.covariance
    else:
        covariance = np.zeros((0, 0))
    chain = chain_of(x)
    chi2 = float((data.residual(chain.forward(data.q)) ** 2).sum())
    both = [
        replace(e, chain=chain, chi2=chi2, x=x[part], covariance=covariance[part, part])
        for e, part in ((first, slice(0, n)), (second, slice(n, None)))
    ]
    return Pair((both[0], both[1]))
