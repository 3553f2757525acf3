"""What is left of a number on its way: its digits, its quadrant, some other value."""

import numpy as np

from ..changes import ALL, PoseChange, RowChange, Slip, Symptom, of_numbers
from ..registry import mistake
from .numbers import ANGLES, DEG, LENGTHS, angles, in_programs
from .products import running

ROUNDED = 0.02  # a pose this near (m, and entries of R) to the right one was rounded on the way


# ---- digits


@mistake("pi-rounded")
def pi_rounded():
    for digits in (2, 3, 4):
        change = of_numbers(ANGLES, _to(digits))
        yield RowChange(change, rows=(ALL,), place="all angles", undo=_made_right)
    yield RowChange(of_numbers(("alpha",), _right_angle), "alpha", rows=(), within=np.deg2rad(0.7))
    for place, names in angles():
        yield in_programs(names, lambda x: _nearest(x, np.pi / 2), f"{place}, to multiples of 90°")
        yield in_programs(names, lambda x: _nearest(x, 1 / DEG), f"{place}, to whole degrees")
        for digits in (0, 1, 2, 3):
            yield in_programs(names, _to(digits), f"{place}, {_decimals(digits)}")
    for name in LENGTHS:
        for digits in (0, 1, 2, 3):
            yield in_programs((name,), _to(digits), f"{name}, {_decimals(digits)}")
    for digits in (1, 2, 3, 4, 5):
        yield PoseChange(_to(digits), _decimals(digits))
        yield Slip("product", f"the running product, {_decimals(digits)}", running(_to(digits)))
    yield Symptom(_a_little_turned, explains=True)


def _a_little_turned(answers, right):
    """A rounded angle turns the pose a little; a wrong length alone does not, nor a common factor,
    which turns nothing.
    """
    off = np.abs(answers - right)
    R, turned = right[:, :3, :3], off[:, :3, :3].max()
    factor = np.vdot(R, answers[:, :3, :3]) / np.vdot(R, R)
    scaled = np.abs(answers[:, :3, :3] - factor * R).max() < 0.1 * turned
    return "" if off.max() < ROUNDED and turned > 1e-7 and not scaled else None


def _decimals(digits):
    return f"{digits} decimal{'' if digits == 1 else 's'}"


def _to(digits):
    return lambda x: np.round(x, digits)


def _nearest(x, step):
    return np.round(x / step) * step


def _made_right(theta, d, a, alpha):
    """Angles that are nearly right ones made right."""

    def right(x):
        return np.where(np.abs(x - _nearest(x, np.pi / 2)) < 0.011, _nearest(x, np.pi / 2), x)

    return right(theta), d, a, right(alpha)


def _right_angle(x):
    """A right angle as it is, another angle as NaN: only right ones are known to have been
    rounded.
    """
    return np.where(np.abs(x - _nearest(x, np.pi / 2)) < 1e-6, x, np.nan)


# ---- quadrants


@mistake("atan-for-atan2")
def atan_for_atan2():
    for place, names in angles():
        yield in_programs(names, lambda x: np.arctan(np.tan(x)), place)


@mistake("sign-lost")
def sign_lost():
    for place, names in angles():
        yield in_programs(names, np.abs, f"the sine of {place}")
        yield in_programs(names, lambda x: np.arcsin(np.sin(x)), f"the cosine of {place}")


# ---- any other value


@mistake("length-value", value_of=LENGTHS)
def length_value():
    for name in LENGTHS:
        yield in_programs((name,), np.zeros_like, f"{name} has no effect")
        yield in_programs((name,), lambda x: 2 * x, f"twice {name}")
        yield in_programs((name,), lambda x: x / 2, f"half of {name}")


@mistake("alpha-value", value_of=("alpha",))
def alpha_value():
    yield from _turned_further("alpha")
    yield in_programs(("alpha",), np.zeros_like, "alpha has no effect")


@mistake("offset-value", value_of=("theta",))
def offset_value():
    yield from _turned_further("theta")


def _turned_further(name):
    for turn in (180, 90, -90):
        place = f"{name}: {turn}° too much"
        yield in_programs((name,), lambda x, turn=turn: x + turn / DEG, place)


# ---- whole numbers, after the values: short lengths cut to 0 have no effect either


@mistake("integer-arrays")
def integer_arrays():
    for place, names in angles():
        yield in_programs(names, np.trunc, place)
    for names in (LENGTHS, *((name,) for name in LENGTHS)):
        yield in_programs(names, np.trunc, " and ".join(names))
    whole = of_numbers((*LENGTHS, *ANGLES), np.trunc)
    yield RowChange(whole, rows=(), reading="the table")
    yield Slip("reading", "q", lambda rows, q: (rows, np.trunc(q)))
    yield Slip("reading", "the sums of offset and q", _whole_sums)
    yield PoseChange(np.trunc)
    yield Slip("product", "the running product", running(np.trunc))


def _whole_sums(rows, q):
    sums = np.trunc(rows[..., :1] + q[..., None])
    return np.concatenate([sums, rows[..., 1:]], axis=-1), 0 * q
