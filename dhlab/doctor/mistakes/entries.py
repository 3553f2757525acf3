"""The entries of the closed form of the standard link matrix, and what people type in their place:
monomials in cos, sin, a and d.
"""

from dataclasses import dataclass
from functools import cache
from itertools import product

import numpy as np

__all__ = ["Monomial", "MONOMIALS", "RIGHT_ENTRIES", "slips_of_the_pen", "typed", "wrong_entries"]

FACTORS = (("", "cos θ", "sin θ"), ("", "cos α", "sin α"), ("", "a", "d"))


@dataclass(frozen=True)
class Monomial:
    """sign · (1, cos θ or sin θ) · (1, cos α or sin α) · (1, a or d); ``parts`` holds a choice 0,
    1, 2 for each.
    """

    sign: int
    parts: tuple = (0, 0, 0)

    def __call__(self, theta, d, a, alpha):
        values = (
            (1.0, np.cos(theta), np.sin(theta)),
            (1.0, np.cos(alpha), np.sin(alpha)),
            (1.0, a, d),
        )
        one = np.ones(np.shape(theta))
        return (
            self.sign
            * one
            * values[0][self.parts[0]]
            * values[1][self.parts[1]]
            * values[2][self.parts[2]]
        )

    @property
    def names(self):
        """The factors that are there."""
        return {FACTORS[k][choice] for k, choice in enumerate(self.parts) if choice}


MONOMIALS = (
    Monomial(0),
    *(Monomial(sign, parts) for sign in (1, -1) for parts in product(range(3), repeat=3)),
)
RIGHT_ENTRIES = {  # Siciliano et al., Robotics, eq. 2.52
    (0, 0): Monomial(1, (1, 0, 0)),
    (0, 1): Monomial(-1, (2, 1, 0)),
    (0, 2): Monomial(1, (2, 2, 0)),
    (0, 3): Monomial(1, (1, 0, 1)),
    (1, 0): Monomial(1, (2, 0, 0)),
    (1, 1): Monomial(1, (1, 1, 0)),
    (1, 2): Monomial(-1, (1, 2, 0)),
    (1, 3): Monomial(1, (2, 0, 1)),
    (2, 0): Monomial(0),
    (2, 1): Monomial(1, (0, 2, 0)),
    (2, 2): Monomial(1, (0, 1, 0)),
    (2, 3): Monomial(1, (0, 0, 2)),
}


def typed(entry, found):
    """In words, what is wrong with an entry (row, column) in which the Monomial ``found`` stands;
    "" when it is right.

    Examples
    --------
    >>> typed((0, 1), Monomial(1, (2, 1, 0)))
    'row 1, column 2: its sign is turned'
    >>> typed((1, 3), Monomial(1, (1, 0, 1)))
    'row 2, column 4: cos θ stands where another factor belongs'
    """
    right = RIGHT_ENTRIES[entry]
    if found == right:
        return ""
    return f"row {entry[0] + 1}, column {entry[1] + 1}: {_difference(right, found)}"


def _difference(right, found):
    if found.sign == 0:
        return "0 stands there"
    if right.sign == 0:
        return "something stands where 0 belongs"
    missing, extra = right.names - found.names, found.names - right.names
    sign = " and its sign is turned" if found.sign != right.sign else ""
    if not missing and not extra:
        return "its sign is turned"
    if not extra:
        return f"a factor is missing{sign}"
    words = " and ".join(sorted(extra))
    return (
        f"{words} stands where another factor belongs{sign}"
        if missing
        else f"the factor {words} is too many{sign}"
    )


def wrong_entries():
    """Every wrong Monomial of each entry, as ((row, column), Monomial)."""
    return [
        (entry, monomial)
        for entry, right in RIGHT_ENTRIES.items()
        for monomial in MONOMIALS
        if monomial != right
    ]


@cache
def slips_of_the_pen():
    """The likeliest wrong Monomials of each entry: its sign, a factor lost, cos for sin, a for d;
    as ((row, column), Monomial).
    """
    found = []
    for entry, right in RIGHT_ENTRIES.items():
        for other in MONOMIALS:
            changed = sum(p != r for p, r in zip(other.parts, right.parts))
            if other != right and (
                (changed <= 1 and other.sign == right.sign) or changed == 0 or other.sign == 0
            ):
                found.append((entry, other))
    return tuple(found)
