"""How much of what is endless, or the same for every arm, a run looks at: a few under
``make test``, and all that a test names under ``make thorough`` and ``make fuzz``.
"""

import os

__all__ = ["few", "shared_out", "variants"]

ALL = any(map(os.environ.get, ("DHLAB_THOROUGH", "DHLAB_SEED")))


def few(items, most):
    """At most ``most`` of the items, spread evenly over them; all in a thorough run."""
    items = list(items)
    if ALL or len(items) <= most:
        return items
    return [items[k * len(items) // most] for k in range(most)]


def shared_out(items, k, among):
    """The share of the items that falls to the ``k``-th of several arms, where every so many arms
    see all of them; all in a thorough run.
    """
    items = list(items)
    return items if ALL else items[k % among :: among]


def variants(most):
    """The numbers of the variants of an exercise that are drawn."""
    return range(most if ALL else min(most, 2))
