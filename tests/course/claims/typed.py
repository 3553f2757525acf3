"""Claims about tables whose numbers are given: what is said is asked of what was typed."""

import re
from itertools import permutations

import numpy as np

COLUMN = {"θ": 0, "d": 1, "a": 2, "α": 3}
PLACES = r" @ (?P<places>row .+)"


def claims(right_of):
    """Of tables of which ``right_of(given)`` are the right rows, degrees and metres."""

    def typed(judge):
        """Exactly the named entries differ, so many as is said, and each pair is as is said."""

        def holds(answer, g, f):
            rows, right = np.array(answer, dtype=float), np.array(right_of(g), dtype=float)
            named = set(_entries(f["places"]))
            return (
                named == _off(rows, right)
                and len(named) == int(f.get("n") or 1)
                and all(judge(rows[e], right[e]) for e in named)
            )

        return holds

    def exchanged(answer, g, f):
        rows, right = np.array(answer, dtype=float), np.array(right_of(g), dtype=float)
        i, k = COLUMN[f["one"]], COLUMN[f["other"]]
        for row in map(int, re.findall(r"\d", f["rows"])):
            rows[row - 1, [i, k]] = rows[row - 1, [k, i]]
        return not _off(rows, right)

    def rows_exchanged(answer, g, f):
        rows, (i, k) = np.array(answer, dtype=float), (int(f["one"]) - 1, int(f["other"]) - 1)
        rows[[i, k]] = rows[[k, i]]
        return not _off(rows, np.array(right_of(g), dtype=float))

    def reordered(answer, g, f):
        rows, right = np.array(answer, dtype=float), np.array(right_of(g), dtype=float)
        orders = (right[:, order] for order in permutations(range(4)))
        return bool(_off(rows, right)) and any(not _off(rows, other) for other in orders)

    def two_exchanged(answer, g, f):
        rows, (one, other) = np.array(answer, dtype=float), _entries(f["places"])
        rows[one], rows[other] = rows[other], rows[one]
        return not _off(rows, np.array(right_of(g), dtype=float))

    def spoilt(answer, g, f):
        rows, right = np.array(answer, dtype=float), np.array(right_of(g), dtype=float)
        was_right = _off(rows, right) - _off(np.array(g["converted"], dtype=float), right)
        return was_right == set(_entries(f["places"]))

    def most(answer, g, f):
        rows, right = np.array(answer, dtype=float), np.array(right_of(g), dtype=float)
        off = sorted(_off(rows, right))
        return (len(off), rows.size, off[:1]) == (int(f["n"]), int(f["of"]), _entries(f["first"]))

    one_or_more = r"(?:one number (?:is|has)|(?P<n>\d+) numbers (?:are|have)) "
    return [
        (one_or_more + "the other sign" + PLACES, typed(lambda x, right: np.isclose(x, -right))),
        (
            r"(?:a minus sign is|(?P<n>\d+) minus signs are) gone" + PLACES,
            typed(lambda x, right: right < 0 and np.isclose(x, -right)),
        ),
        (one_or_more + "0, and should not be" + PLACES, typed(lambda x, right: x == 0 != right)),
        (one_or_more + "rounded" + PLACES, typed(_fewer_digits)),
        (one_or_more + "not right" + PLACES, typed(lambda x, right: x != right)),
        (
            r"(?P<one>[θda]) and (?P<other>[daα]) have changed places @ (?P<rows>rows? .+)",
            exchanged,
        ),
        (r"rows (?P<one>\d) and (?P<other>\d) have changed places", rows_exchanged),
        (r"(?P<n>\d+) of (?P<of>\d+) numbers are not right @ (?P<first>.+) is the first", most),
        (r"the columns stand in another order than θ, d, a, α", reordered),
        (r"two numbers have changed places" + PLACES, two_exchanged),
        (r"what was right as it was handed out is changed" + PLACES, spoilt),
    ]


def _entries(places):
    """The entries of "row 2, a and α; row 3, d", from 0."""
    return [
        (int(row) - 1, COLUMN[name])
        for row, names in re.findall(r"row (\d), ([^;]+)", places)
        for name in names.replace(" and ", ", ").split(", ")
    ]


def _off(rows, right):
    """The entries that differ, whole turns apart."""
    off = rows - right
    off[:, [0, 3]] = np.degrees(np.arcsin(np.sin(np.radians(off[:, [0, 3]] / 2)))) * 2
    return set(map(tuple, np.argwhere(np.abs(off) > 1e-4).tolist()))


def _fewer_digits(x, right):
    """Some rounding of the right number, in degrees, radians or metres."""
    return any(
        abs(scale * x - float(f"{scale * right:.{k}f}")) < 1e-9
        for scale in (1, np.pi / 180)
        for k in range(5)
    )
