"""Tables compared number by number: which entries differ from the right ones, and how. Rows are
(n, 4) in degrees and metres, a mask (n, 4) says which entries are meant.
"""

from collections.abc import Callable
from itertools import combinations, permutations

import numpy as np
from numpy.typing import NDArray

from ....printing import listed
from ..exercise import Said
from ..wrong.twofold import TWO
from ..wrong.units import LOOSELY, Group, in_other_units

__all__ = ["COLUMNS", "KINDS", "differing", "difference", "in_part", "places"]

COLUMNS = "θ", "d", "a", "α"
KINDS = "offset", "length", "length", "alpha"  # in the catalogue's ids
ANGLES = np.array([True, False, False, True])
ALIKE = np.array([1e-4, 1e-6, 1e-6, 1e-4])  # degrees, metres
EXCHANGED = {(0, 3): "theta-alpha-exchanged", (1, 2): "a-d-exchanged"}
IN_OTHER_UNITS = [  # mistake, columns, what they are in, what is asked, and the factor to it
    *(("angle-unit", c, "radians", "degrees", 180 / np.pi) for c in ([0], [3], [0, 3])),
    *(("length-unit", c, "millimetres", "metres", 1e-3) for c in ([1], [2], [1, 2])),
]
NEAR = 0.1  # of the largest number of the column: a rounded number is no further off


def differing(rows: NDArray, right: NDArray) -> NDArray[np.bool_]:
    """The mask of the entries that differ; whole turns do not count, and an entry that overflows
    differs from any other.
    """
    return ~(np.abs(_apart(rows, right)) <= ALIKE)


def _apart(rows, right):
    off = rows - right
    return np.where(ANGLES, (off + 180) % 360 - 180, off)


def places(mask: NDArray[np.bool_]) -> str:
    """The entries of a mask, in words.

    Examples
    --------
    >>> places(np.array([[0, 0, 0, 0], [0, 0, 1, 1], [0, 1, 0, 0]], dtype=bool))
    'row 2, a and α; row 3, d'
    """
    rows = [(i, [c for c, on in zip(COLUMNS, row) if on]) for i, row in enumerate(mask, 1)]
    return "; ".join(f"row {i}, {listed(names)}" for i, names in rows if names)


def in_part(
    rows: NDArray, right: NDArray, name: Callable[[int, int], str]
) -> tuple[str, Said] | None:
    """The slip of units that explains every entry that differs, with what is said of it; None.
    ``name(row, column)`` names an entry, both from 0.
    """
    off = differing(rows, right)

    def fits(numbers):
        return (np.abs(numbers - right) <= LOOSELY * np.abs(right))[off].all()

    groups = [
        Group(_named(off & of, right, name), unit, off & of)
        for of, unit in ((ANGLES, "deg"), (~ANGLES, "m"))
        if (off & of).any()
    ]
    return in_other_units(rows, groups, fits) if groups else None


def _named(mask, right, name):
    """A column by its letter where all of it is meant that is not 0, else entry by entry."""
    names = []
    for k in np.flatnonzero(mask.any(axis=0)):
        rows = np.flatnonzero(mask[:, k])
        whole = not right[~mask[:, k], k].any()
        names += [COLUMNS[k]] if whole else [name(i, k) for i in rows]
    return listed(names)


def difference(rows: NDArray, right: NDArray) -> tuple[str | None, Said]:
    """How rows differ from the right ones, as (mistake, what is said of it)."""
    off = differing(rows, right)
    return (
        _moved(rows, right, off)
        or _changed(rows, right, off)
        or _doubled(rows, right, off)
        or _others(off)
    )


def _moved(rows, right, off):
    """Two columns or rows in each other's places."""
    wrong = off.any(axis=1)
    found = [str(i + 1) for i in np.flatnonzero(wrong)]
    where = f"{'row' if len(found) == 1 else 'rows'} {listed(found)}"
    for i, k in combinations(range(4), 2):
        other = right.copy()
        other[np.ix_(wrong, [i, k])] = right[np.ix_(wrong, [k, i])]
        if not differing(rows, other).any():
            said = f"{COLUMNS[i]} and {COLUMNS[k]} have changed places"
            return EXCHANGED.get((i, k), "columns-misread"), Said(said, place=where)
    for columns in permutations(range(4)):
        if not differing(rows, right[:, columns]).any():
            return "columns-misread", Said("the columns stand in another order than θ, d, a, α")
    for i, k, order in _swaps(len(right)):
        if not differing(rows, right[order]).any():
            return None, Said(f"rows {i + 1} and {k + 1} have changed places")
    return None


def _swaps(n):
    """Each two of n places, and the order in which these have changed."""
    for i, k in combinations(range(n), 2):
        order = np.arange(n)
        order[[i, k]] = k, i
        yield i, k, order


def _exchanged(rows, off):
    other = rows.copy()
    other[off] = rows[off][::-1]
    return other


def _changed(rows, right, off):
    """Signs, two numbers in each other's places, zeros or digits; None of other values."""
    n, kind = int(off.sum()), _kind(off)
    if not differing(rows, np.where(off, -right, right)).any():
        mistake, said = _signs(right, off, kind)
    elif n == 2 and not differing(_exchanged(rows, off), right).any():
        mistake, said = None, "two numbers have changed places"
    elif not rows[off].any():
        mistake = "offset-missing" if kind == "offset" else kind and f"{kind}-value"
        said = f"{_are(n)} 0, and should not be"
    elif all(_is_rounded(rows[i, k], right, i, k) for i, k in np.argwhere(off)):
        mistake, said = "pi-rounded", f"{_are(n)} rounded"
    else:
        return None
    return mistake or None, Said(said, place=places(off))


def _others(off):
    """So many numbers of which nothing more is known."""
    n, kind = int(off.sum()), _kind(off)
    if 2 * n <= off.size:
        said, place = f"{_are(n)} not right", places(off)
    else:
        i, k = np.argwhere(off)[0]
        said = f"{n} of {off.size} numbers are not right"
        place = f"row {i + 1}, {COLUMNS[k]} is the first"
    return f"{kind}-value" if kind else None, Said(said, place=place)


def _doubled(rows, right, off):
    """Columns or rows in each other's places or columns in another unit, and, once that is put
    right, one number or two more; None. Of what differs the first explains the most.
    """
    for mistake, said, mended in _put_right(rows):
        left = differing(mended, right)
        if 0 < left.sum() <= min(2, off.sum() // 3):
            _, more = _changed(mended, right, left) or _others(left)
            return mistake, Said(
                TWO.format(said, more.headline), place=f"{more.place}, once that is put right"
            )
    return None


def _put_right(rows):
    """Rows with one slip taken back: (mistake, what it is, the rows)."""
    for i, k, order in _swaps(4):
        said = f"{COLUMNS[i]} and {COLUMNS[k]} have changed places"
        yield EXCHANGED.get((i, k), "columns-misread"), said, rows[:, order]
    for i, k, order in _swaps(len(rows)):
        yield None, f"rows {i + 1} and {k + 1} have changed places", rows[order]
    for mistake, columns, found, asked, factor in IN_OTHER_UNITS:
        names = listed([COLUMNS[k] for k in columns])
        scaled = rows * np.where(np.isin(np.arange(4), columns), factor, 1)
        yield mistake, f"in other units: {names} in {found}; {asked} are asked", scaled


def _kind(off):
    """The kind of the numbers of a mask, in the catalogue's ids; "" of several kinds."""
    kinds = {KINDS[k] for k in np.flatnonzero(off.any(axis=0))}
    return kinds.pop() if len(kinds) == 1 else ""


def _are(n):
    return "one number is" if n == 1 else f"{n} numbers are"


def _signs(right, off, kind):
    """What is said of numbers with the other sign, as (mistake, words)."""
    n, mistake = int(off.sum()), f"{kind}-sign" if kind else None
    if not (right[off] < 0).all():
        return mistake, ("one number has" if n == 1 else f"{n} numbers have") + " the other sign"
    every = np.array_equal(off[:, 1:3], right[:, 1:3] < 0) and off[:, 1:3].any()
    return (
        "lengths-made-positive" if every else mistake,
        "a minus sign is gone" if n == 1 else f"{n} minus signs are gone",
    )


def _is_rounded(x, right, i, k):
    """Whether a number is the right one with fewer decimals; an angle also in radians."""
    value = right[i, k]
    if abs(x - value) > NEAR * np.abs(right[:, k]).max():
        return False
    readings = [(x, value), (np.deg2rad(x), np.deg2rad(value))] if ANGLES[k] else [(x, value)]
    return any(abs(a - round(b, d)) < 1e-9 for a, b in readings for d in range(5))
