"""Claims of every exercise: units, shapes, and where an answer is wrong."""

from itertools import product

import numpy as np

FACTORS = {
    "radians": 57.29577951308232,
    "degrees": 0.017453292519943295,
    "degrees, converted to degrees once more": 0.017453292519943295,
    "radians, taken times π/180 and not 180/π": 57.29577951308232**2,
    "radians, converted to radians once more": 57.29577951308232,
    "millimetres": 0.001,
    "centimetres": 0.01,
    "metres, divided by 1000": 1000.0,
    "millimetres per second": 0.001,
    "degrees per second": 0.017453292519943295,
}


def right_of(given):
    """The right value, as the exercise has it; its own tests hold it against other programs."""
    exercise, variant = given["exercise"], given["variant"]
    return np.asarray(exercise.answer(**exercise.given(variant)), dtype=float)


def near(a, b, by=6e-3):
    """Whether two arrays agree within what the eye takes for equal."""
    a, b = np.asarray(a, dtype=float), np.asarray(b, dtype=float)
    return a.shape == b.shape and bool((np.abs(a - b) <= by * (1 + np.abs(b))).all())


def off_by(answer, given):
    """The mask of the entries that are wrong; whole turns do not count where they are angles."""
    exercise, right = given["exercise"], right_of(given)
    difference = np.asarray(answer, dtype=float) - right
    if difference.ndim == 1:
        for k in exercise.turns:
            difference[k] = (difference[k] + 180) % 360 - 180
    return np.abs(difference) > exercise.tolerance * (1 + np.abs(right))


def in_units(answer, given, found):
    """The named numbers are right in the other unit, and wrong as they stand; all others are
    right.
    """
    exercise, right = given["exercise"], right_of(given)
    named = {}
    for what, unit in (("what", "unit"), ("more", "more_unit")):
        for name in (found.get(what) or "").replace(" and ", ", ").split(", "):
            named[name] = FACTORS.get(found.get(unit))
    scaled = np.array(answer, dtype=float)
    if exercise.units == "pose":
        scaled[:3, 3] *= named["the last column"]
    elif "the numbers" in named:
        scaled *= named["the numbers"]
    else:
        for k, name in enumerate(exercise.entries):
            scaled[k] *= named.get(name) or 1
    if exercise.turns:
        scaled = right + np.where(
            np.isin(np.arange(4)[: len(right)], exercise.turns),
            (scaled - right + 180) % 360 - 180,
            scaled - right,
        )
    allowed = 6e-3 * np.abs(right) + 2 * exercise.tolerance
    return (np.abs(scaled - right) <= allowed).all() and off_by(answer, given).any()


def other_readings(array, given):
    """A vector or a pose with some numbers taken for others of their unit."""
    exercise = given["exercise"]
    if exercise.units == "pose" or not isinstance(exercise.units, tuple):
        for factor in FACTORS.values():
            fixed = array * factor
            if exercise.units == "pose":
                fixed = array.copy()
                fixed[:3, 3] *= factor
            yield fixed
        return
    for mask in product((1, 0), repeat=array.size):
        for one, other in product(FACTORS.values(), repeat=2):
            yield np.where(
                mask, array * [one if "m" in unit else other for unit in exercise.units], array
            )


def these_entries(answer, given, found):
    """Exactly the entries that are named are wrong."""
    exercise, off = given["exercise"], off_by(answer, given)
    names = exercise.entries or [f"number {k + 1}" for k in range(off.size)]
    return [name for name, bad in zip(names, off.ravel()) if bad] == found["names"].split(", ")


def so_many(answer, given, found):
    """As many entries are wrong as is said, and the first of them is the one named."""
    off = off_by(answer, given)
    i, j = np.argwhere(off)[0] + 1
    told = tuple(int(found[name]) for name in ("count", "of", "row", "column"))
    return told == (off.sum(), off.size, i, j)


def other_shape(answer, given, found):
    """The answer has another shape than the right one, or holds no finite numbers."""
    try:
        array = np.asarray(answer, dtype=float)
    except (TypeError, ValueError):
        return True
    return array.shape != right_of(given).shape or not np.isfinite(array).all()


def cut_off(answer, given, found):
    return (np.asarray(answer) == np.trunc(right_of(given))).all()


def fewer_decimals(answer, given, found):
    """Each entry that is wrong is the right one printed with fewer decimals."""
    off = off_by(answer, given)
    pairs = list(zip(np.asarray(answer, dtype=float)[off], right_of(given)[off]))
    return bool(pairs) and all(
        any(abs(float(f"{right:.{k}f}") - told) < 1e-9 for k in range(6)) for told, right in pairs
    )


def one_negative(answer, given, found):
    right = right_of(given)
    right[given["exercise"].entries.index(found["name"])] *= -1
    return near(answer, right)


def in_places(answer, given, found):
    names, right = given["exercise"].entries, right_of(given)
    i, k = names.index(found["one"]), names.index(found["other"])
    right[[i, k]] = right[[k, i]]
    return near(answer, right)


def arrow_turned(answer, given, found):
    turned = np.array(answer, dtype=float)
    turned[:, "xyz".index(found["name"])] *= -1
    return near(turned, right_of(given))


def _block_back(T):
    T = T.copy()
    T[:3, :3] = T[:3, :3].T
    return T


UNDONE = {  # a second slip, and what takes it back
    "the whole 4×4 is transposed": np.transpose,
    "the rotation block is transposed": _block_back,
    "the pose is inverted": np.linalg.inv,
}
ONE = r"in other units: (?P<what>[^;]+?) in (?P<unit>[^;]+); [a-z ]+ (?:are )?asked"
BOTH = (
    r"in other units: (?P<what>[θα, and]+) in (?P<unit>[^;]+?), (?P<more>[da, n]+) in"
    r" (?P<more_unit>[^;]+); degrees and metres are asked"
)
GENERAL = [
    (BOTH, in_units),
    (r"in other units: (?P<what>.+?) in (?P<unit>[^;]+); .+ are asked", in_units),
    (
        r"these are not the numbers @ (?P<count>\d+) of (?P<of>\d+) entries, the first in row"
        r" (?P<row>\d+), column (?P<column>\d+)",
        so_many,
    ),
    (r"these are not the numbers @ (?P<names>.+)", these_entries),
    (r"these are the right numbers with their decimals cut off", cut_off),
    (r"these are the right numbers, rounded too early", fewer_decimals),
    (r"expected .+, found .+", other_shape),
    (r"every number has the other sign", lambda a, g, f: near(np.negative(a), right_of(g))),
    (r"(?P<name>[^;:]+) has the other sign", one_negative),
    (r"(?P<one>[^;:]+) and (?P<other>[^;:]+) have changed places", in_places),
    (
        r"the origin stands in the last row, not the last column",
        lambda a, g, f: (
            near(np.asarray(a)[:3, :3], right_of(g)[:3, :3])
            and near(np.asarray(a)[3], [*right_of(g)[:3, 3], 1])
            and near(np.asarray(a)[:3, 3], [0, 0, 0])
        ),
    ),
    (r"the (?P<name>[xyz]) arrow points the other way", arrow_turned),
    *(
        (said, lambda a, g, f, undone=undone: near(undone(np.asarray(a, dtype=float)), right_of(g)))
        for said, undone in UNDONE.items()
    ),
    (r"every number is 0 @ (?P<count>\d+) of .+", lambda a, g, f: not np.any(a)),
    (
        r"every number is 0 @ (?P<names>.+)",
        lambda a, g, f: not np.any(a) and these_entries(a, g, f),
    ),
]
