"""The search over single mistakes of a sheet, and the fit of all its axes at once."""

from dataclasses import dataclass

import numpy as np

from ..arms.search.measured import limit
from .chain import Around, Chain, about
from .changes import Change, changes_of_axis, changes_of_end
from .fitting import least

__all__ = ["Explanation", "explanations", "misfit", "everything"]

TWOFOLD = 12.0  # χ²
NEARLY_TURNED = 2.9  # rad
SHOWS = 5.0  # σ; what moves by less in a fit of everything is not told
FITTED_FROM = 3  # starts from which a fit is begun, the most promising of them


@dataclass(frozen=True)
class Explanation:
    """A change with its numbers: the changed chain, its misfit, and the covariance (k, k) of the
    free numbers.
    """

    change: Change
    chain: Chain
    chi2: float
    x: np.ndarray
    covariance: np.ndarray

    def explains(self, data):
        """Whether no more is left than the noise makes."""
        return self.chi2 <= limit(data.count - self.change.free)

    def score(self, data):
        """Smaller is better: the misfit, and what the free numbers and the choice cost (Schwarz,
        Annals of Statistics 6, 1978).
        """
        cost = self.change.free * np.log(data.count) + 2 * np.log(self.change.guesses)
        # a place and a direction together are two mistakes, and so are a direction and a sense
        return self.chi2 + cost + (TWOFOLD if self.change.kind == "line" or self._turned() else 0)

    def _turned(self):
        """Whether a direction was fitted that is nearly the opposite of the one written."""
        if self.change.kind != "direction" or not self.change.free:
            return False
        return float(np.linalg.norm(self.x)) > NEARLY_TURNED


def misfit(chain, data):
    """χ² of a chain."""
    return float((data.residual(chain.forward(data.q)) ** 2).sum())


def explanations(chain, data, clock):
    """Every single mistake, fitted; the best first. Where a change without a free number explains
    the data, those with more than one are not asked for; nor any when the clock's time is over.
    """
    around = Around.of(chain, data.q)
    changes = [c for i in range(len(chain.letters)) for c in changes_of_axis(chain, i)]
    changes += changes_of_end(chain)
    none = clock.within([c for c in changes if not c.free], "one axis at a time", least=2)
    found = [_fitted(chain, c, data, around, clock) for c in none]
    enough = any(e.explains(data) for e in found)
    asked = [c for c in changes if c.free == 1 or (c.free and not enough)]
    asked = clock.within(asked, "one axis at a time")
    found += [_fitted(chain, c, data, around, clock) for c in asked]
    return sorted(found, key=lambda e: e.score(data))


def _fitted(chain, change, data, around, clock):
    def residual(x):
        return data.residual(
            _poses(change.apply(chain, np.asarray(x)), change, data, around)
        ).ravel()

    if not change.free:
        chi2 = float((residual(()) ** 2).sum())
        return Explanation(change, change.apply(chain, ()), chi2, np.zeros(0), np.zeros((0, 0)))
    starts = sorted(change.starts, key=lambda x: (residual(x) ** 2).sum())[:FITTED_FROM]
    best = min((least(residual, x, clock, 40) for x in starts), key=lambda fit: fit.chi2)
    chain = change.apply(chain, best.x)
    return Explanation(change, chain, best.chi2, best.x, best.covariance)


def _poses(changed, change, data, around):
    """The end poses of a chain that differs from the sheet's in one joint, or in the end."""
    i = change.joint
    if i is None:
        return around.before[-1] @ changed.end
    q = data.q[:, i] + changed.zero[i]
    return (
        around.before[i]
        @ about(changed.p[i], changed.z[i], changed.letters[i], q)
        @ (around.behind[i])
    )


def everything(starts, data, clock):
    """The chain with every axis and the end fitted, from the first of ``starts`` that leads to what
    noise alone would leave, else from the best: the chain, its χ², how many numbers were fitted,
    and which joints (0-based) moved by more than the noise.
    """
    best = None
    for start in starts:
        if best is not None and clock.over:
            clock.cut_short.append("all axes together")
            break
        found = _all_fitted(start, data, clock)
        if best is None or found[1] < best[1]:
            best = found
        if best[1] <= limit(data.count - best[2]):
            break
    return best


def _all_fitted(start, data, clock):
    n = len(start.letters)
    lines = [c for i in range(n) for c in [_line(start, i)] if c is not None]
    end = [c for c in changes_of_end(start) if c.free == 6]
    parts = lines + end
    cuts = np.cumsum([change.free for change in parts])[:-1]

    def chain_of(x):
        chain = start
        for change, part in zip(parts, np.split(x, cuts)):
            chain = change.apply(chain, part)
        return chain

    fit = least(
        lambda x: data.residual(chain_of(x).forward(data.q)),
        np.zeros(sum(change.free for change in parts)),
        clock,
        30,
    )
    moved, first = set(), 0
    for change, part in zip(parts, np.split(fit.x, cuts)):
        block = slice(first, first + change.free)
        first += change.free
        if part @ np.linalg.pinv(fit.covariance[block, block]) @ part > SHOWS**2:
            moved.add(change.joint)
    return chain_of(fit.x), fit.chi2, len(fit.x), moved


def _line(chain, i):
    """The change that moves all of an axis: four numbers, two of a sliding one."""
    wanted = "line" if chain.letters[i] == "R" else "direction"
    return next(c for c in changes_of_axis(chain, i) if c.kind == wanted and c.free)
