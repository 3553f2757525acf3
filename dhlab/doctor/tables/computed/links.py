"""Links from matrices: what a row holds, and which joint's value moves it, from several samples."""

from dataclasses import dataclass

import numpy as np

from ....kinematics import link_matrices
from .held.values import LOST

__all__ = ["Links", "links_of"]

EXACT = 1e-9
SAME = 1e-8
TURNS = np.pi / 12
SCALES = 1.0, np.pi / 180  # of a joint's value in radians, in degrees
BOOKS = "standard", "craig"


@dataclass(frozen=True)
class Links:
    """The rows (theta, d, a, alpha) of a chain, as the program has them; ``letters`` "R", "P" and
    "" of a row without a joint, ``signs``, ``names`` of the joints' values, and the ``ends``,
    "base" and "tool", that the product has and the rows have not; ``of_toolbox`` whether they are
    links of a toolbox, whose robot may have such ends, too, ``of_function`` whether the program has
    a function for them and does not call it.
    """

    convention: str
    rows: tuple
    letters: tuple
    signs: tuple
    names: tuple
    ends: tuple = ()
    of_toolbox: bool = False
    of_function: bool = False

    @property
    def joints(self):
        """How many joints it has."""
        return sum(bool(letter) for letter in self.letters)


def links_of(samples, drawn, makers=None):
    """The Links of a chain in one convention; None where it is no chain of such links.

    Parameters
    ----------
    samples : list of tuple of array (4, 4)
        The factors of the product in each run.
    drawn : list of dict of str to float
        The numbers that stood for what is not known.
    makers : list, optional
        What made each factor: a constant one at an end that something else has made is no row.

    Examples
    --------
    >>> def turn(q):
    ...     return link_matrices("standard", q - 0.5, 0.1, 0.3, 0.2)
    >>> drawn = [{"q1": 0.2, "q2": 0.4}, {"q1": 0.3, "q2": 0.9}, {"q1": 0.5, "q2": 0.7}]
    >>> found = links_of([(turn(one["q1"]), turn(one["q2"])) for one in drawn], drawn)
    >>> found.convention, found.letters, found.rows[0]
    ('standard', ('R', 'R'), (-0.5, 0.1, 0.3, 0.2))
    """
    if len({len(one) for one in samples}) > 1 or not samples[0]:
        return None
    stacks = [np.array(parts) for parts in zip(*samples)]
    moving = [np.ptp(stack, axis=0).max() > EXACT for stack in stacks]
    if sum(moving) < 1 or not all(np.isfinite(stack).all() for stack in stacks):
        return None
    found = [one for book in BOOKS if (one := _in_convention(book, stacks, moving, drawn, makers))]
    return min(found, key=lambda one: len(one.rows), default=None)


def _in_convention(convention, stacks, moving, drawn, makers):
    stacks, ends = _without_ends(convention, stacks, moving, makers)
    groups = _merged(convention, stacks)
    if groups is None:
        return None
    rows, letters, signs, names = [], [], [], []
    for numbers in groups:
        row = _row(numbers, drawn)
        if row is None:
            return None
        for column, value in zip((rows, letters, signs, names), row):
            column.append(value)
    used = [name for name in names if name]
    if len(set(used)) < len(used):
        return None
    return Links(convention, tuple(rows), tuple(letters), tuple(signs), tuple(used), ends)


def _without_ends(convention, stacks, moving, makers):
    """(The matrices without constant ones at the ends that are no rows, which ends these are)."""
    first, last = moving.index(True), len(moving) - moving[::-1].index(True)
    rows = [_numbers(convention, one) is not None for one in stacks]
    if makers and not _elementary([_numbers(convention, one) for one in stacks]):
        near = [makers[first]] * first + [None] * (last - first)
        near += [makers[last - 1]] * (len(stacks) - last)
        rows = [row and (first <= k < last or makers[k] == near[k]) for k, row in enumerate(rows)]
    ends = ()
    if not all(rows[last:]):
        stacks, ends = stacks[:last], ("tool",)
    if not all(rows[:first]):
        stacks, ends = stacks[first:], ("base", *ends)
    return stacks, ends


def _numbers(convention, stack):
    """theta, d, a, alpha of matrices (k, 4, 4) as (k, 4); None where they are no links."""
    T = stack
    still = T[:, 2, 0] if convention == "standard" else T[:, 0, 2]
    if np.abs(still).max() > SAME:
        return None
    if convention == "standard":
        theta, alpha = np.arctan2(T[:, 1, 0], T[:, 0, 0]), np.arctan2(T[:, 2, 1], T[:, 2, 2])
        a = T[:, 0, 3] * np.cos(theta) + T[:, 1, 3] * np.sin(theta)
        d = T[:, 2, 3]
    else:
        theta, alpha = np.arctan2(-T[:, 0, 1], T[:, 0, 0]), np.arctan2(-T[:, 1, 2], T[:, 2, 2])
        a, d = T[:, 0, 3], -T[:, 1, 3] * np.sin(alpha) + T[:, 2, 3] * np.cos(alpha)
    numbers = np.column_stack([theta, d, a, alpha])
    again = np.array([link_matrices(convention, *row) for row in numbers])
    size = max(1.0, np.abs(T).max())
    return numbers if np.abs(again - T).max() < SAME * size else None


def _merged(convention, stacks):
    """The numbers of each link, elementary moves put together where the program multiplies links
    out of them; None where a matrix is no link.
    """
    alone = [_numbers(convention, stack) for stack in stacks]
    if not any(one is None for one in alone) and not _elementary(alone):
        return alone
    groups: list = []
    product = None
    for stack in stacks:
        joined = None if product is None else product @ stack
        numbers = None if joined is None else _numbers(convention, joined)
        if numbers is not None and np.sum(np.ptp(numbers[:, :2], axis=0) > EXACT) < 2:
            own = [np.ptp(_each(one), axis=0).max() > EXACT for one in (product, stack)]
            if not all(own):
                product, groups[-1] = joined, numbers
                continue
        numbers = _numbers(convention, stack)
        if numbers is None:
            return None
        product = stack
        groups.append(numbers)
    return groups


def _each(stack):
    return stack.reshape(len(stack), -1)


def _elementary(alone):
    """Whether most matrices have one number alone."""
    if any(one is None for one in alone):
        return False
    few = sum(np.count_nonzero(np.abs(one).max(axis=0) > EXACT) <= 1 for one in alone)
    moving = sum(np.ptp(one, axis=0).max() > EXACT for one in alone)
    return few > len(alone) / 2 and len(alone) >= 2 * moving


def _row(numbers, drawn):
    """(numbers, letter, sign, name) of one link; None where no single joint's value moves it."""
    spread = np.ptp(_unwrapped(numbers), axis=0) > EXACT
    if spread[2:].any() or spread.sum() > 1:
        return None
    theta, d, a, alpha = numbers[0]
    fixed = (_angle(theta), _length(d), _length(a), _angle(alpha))
    if not spread.any():
        return fixed, "", 1, ""
    slides = bool(spread[1])
    values = numbers[:, 1 if slides else 0]
    for name in drawn[0]:
        if name.startswith(LOST) or not all(name in one for one in drawn):
            continue
        q = np.array([one[name] for one in drawn])
        for scale in (1.0, 1e-3, 1e-2, 1e3, 1e2) if slides else SCALES:
            for sign in (1, -1):
                left = values - sign * scale * q
                if _constant(left, slides):
                    zero = _length(left[0]) if slides else _angle(_wrapped(left[0]))
                    row = (fixed[0], zero, *fixed[2:]) if slides else (zero, *fixed[1:])
                    return row, "P" if slides else "R", sign, name
    return None


def _unwrapped(numbers):
    """Angles near the first sample's: one that crosses π has not changed by a turn."""
    near = numbers.copy()
    for k in (0, 3):
        near[:, k] = numbers[0, k] + _wrapped(numbers[:, k] - numbers[0, k])
    return near


def _wrapped(angle):
    return (angle + np.pi) % (2 * np.pi) - np.pi


def _constant(left, slides):
    gaps = left - left[0]
    size = max(1.0, np.abs(left).max()) if slides else 1.0
    return np.abs(gaps if slides else _wrapped(gaps)).max() < EXACT * size


def _angle(value):
    """An angle without the last digits that the matrix has cost, from -π to π, π taken for -π."""
    exact = round(value / TURNS) * TURNS
    value = exact if abs(value - exact) < EXACT else float(f"{value:.12g}")
    return float(np.pi if abs(value + np.pi) < EXACT else value) + 0.0


def _length(value):
    """A length without the last digits that the matrix has cost."""
    return 0.0 if abs(value) < 1e-12 else float(f"{value:.12g}") + 0.0
