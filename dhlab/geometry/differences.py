"""Where two arms truly differ, and by how much: the first joint whose axis stands otherwise, in
words.
"""

from dataclasses import dataclass
from html import escape

import numpy as np
from numpy.typing import NDArray

from ..arm import Arm
from ..printing import number
from ..transform import inverse
from .canonical import ROUNDING, JointAxes, align, counting, gaps, moved
from .freechoices import FreeChoice, turn_of
from .zeros import Rezeroed

__all__ = ["Equivalence", "tolerances", "unlike_joints", "first_difference", "end_difference"]


# rad; half way, in powers of ten, between the rounding of a long walk of rewritings (1e-14) and the
# smallest true change (1e-6), of which an axis may show a small part only
ANGLE = 1e-10
COUNTING = 1e-9  # of a coupling
LENGTH = 1e-10  # × how far the axes pass from the end; likewise


@dataclass(frozen=True)
class Equivalence:
    """The answer of :func:`dhlab.equivalent`: true or false in an ``if``, a sentence when printed.

    ``differences`` are the free choices (:class:`dhlab.geometry.freechoices.FreeChoice`) that
    separate two equivalent tables. Otherwise ``joint`` is the first joint (1-based) whose axis
    truly differs, None when only the end or the number of joints does; ``angle`` (rad) and
    ``distance`` (m) say by how much; ``reason`` is "count", "type", "coupling", "sense", "axis" or
    "end". ``zeros`` says which joint zeros and counting directions would make table a the arm of
    table b, where that is all that separates them (:class:`dhlab.geometry.zeros.Rezeroed`).
    """

    equal: bool
    message: str
    differences: tuple[FreeChoice, ...] = ()
    joint: int | None = None
    angle: float = 0.0
    distance: float = 0.0
    reason: str = ""
    zeros: Rezeroed | None = None

    def __bool__(self) -> bool:
        return self.equal

    def __str__(self) -> str:
        return self.message

    def _repr_html_(self) -> str:
        if not self.equal:
            return f"<p><strong>Not the same arm.</strong> {escape(self.message)}</p>"
        if not self.differences:
            return f"<p>{escape(self.message)}</p>"
        items = "".join(f"<li>{escape(choice.message)}</li>" for choice in self.differences)
        return f"<p><strong>The same arm.</strong> Table b is table a with:</p><ul>{items}</ul>"


def unlike_joints(a: Arm, b: Arm) -> Equivalence | None:
    """The difference in the number or the types of the joints; None when there is none."""
    if len(a) != len(b):
        return Equivalence(
            False, f"Table a has {_joints(len(a))}, table b {_joints(len(b))}.", reason="count"
        )
    for k, (one, other) in enumerate(zip(a.table.joints, b.table.joints), 1):
        if one != other:
            verb = {"R": "turns", "P": "slides"}
            return Equivalence(
                False,
                f"Joint {k} {verb[one]} in table a and {verb[other]} in table b.",
                joint=k,
                reason="type",
            )
    return _unlike_counting(a, b)


def _unlike_counting(a, b):
    """Arms whose joints are coupled otherwise move otherwise."""
    if a.coupling is None and b.coupling is None:
        return None
    gap = np.abs(counting(a)[1] - counting(b)[1]).max(axis=1)
    if (gap <= COUNTING).all():
        return None
    k = int(np.argmax(gap > COUNTING)) + 1
    return Equivalence(
        False, f"Joint {k} is coupled otherwise to what is counted.", joint=k, reason="coupling"
    )


def _joints(n):
    return "1 joint" if n == 1 else f"{n} joints"


def tolerances(A: JointAxes, B: JointAxes) -> tuple[float, float]:
    """Up to which angle (rad) and distance (m) the axes of two arms are the same."""
    return ANGLE, LENGTH * max(A.reach, B.reach) + ROUNDING * max(A.largest, B.largest)


def first_difference(
    A: JointAxes, B: JointAxes, X: NDArray[np.float64], base: str, tool: str
) -> Equivalence | None:
    """None, or an Equivalence that names the first joint, from the base (from the tool when only
    that is fixed), whose axes differ.
    """
    on_a = moved(X, B)
    angles, distances = gaps(A, on_a)
    angle_tol, length_tol = tolerances(A, B)
    wrong = np.flatnonzero((angles > angle_tol) | (distances > length_tol))
    if not len(wrong):
        return end_difference(A, on_a, angle_tol, length_tol) if base == tool == "fixed" else None
    if base == tool == "free":
        return _relative_difference(A, B, angle_tol, length_tol)
    k = wrong[-1 if base == "free" else 0]
    return _axis_difference(
        k + 1, angles[k], distances[k], angle_tol, length_tol, _where(k + 1, len(angles), base)
    )


def _where(k, n, base):
    """The entries that can make axis k differ when those before it agree (behind it, counted from
    the tool).
    """
    if base == "free":
        return f"Counted from the tool, look at theta{k}, d{k}, a{k}, alpha{k}" + (
            " and the tool." if k == n else "."
        )
    return (
        f"Look at theta{k - 1}, d{k - 1}, a{k - 1}, alpha{k - 1}." if k > 1 else "Look at the base."
    )


def _axis_difference(k, angle, distance, angle_tol, length_tol, where):
    if angle > np.pi - angle_tol and distance <= length_tol:
        return Equivalence(
            False,
            f"Joint {k} counts the other way: its axis is the same line, its positive direction"
            " reversed.",
            joint=k,
            angle=float(angle),
            reason="sense",
        )
    turned, away = angle > angle_tol, distance > length_tol
    what = (
        f"Joint {k}'s axis is turned by {_degrees(angle)}"
        if turned
        else f"The axis of joint {k} is {_mm(distance)} away"
    )
    also = f" and passes {_mm(distance)} away" if turned and away else ""
    return Equivalence(
        False,
        f"{what}{also}. {where}",
        joint=int(k),
        angle=float(angle),
        distance=float(distance),
        reason="axis",
    )


def end_difference(
    A: JointAxes, B: JointAxes, angle_tol: float, length_tol: float
) -> Equivalence | None:
    """None, or an Equivalence that says how the ends differ where all the axes agree."""
    D = inverse(A.end) @ B.end
    shift, angle = np.linalg.norm(D[:3, 3]), turn_of(D)
    if shift <= length_tol and angle <= angle_tol:
        return None
    parts = [_shift_words(D[:3, 3], length_tol)] if shift > length_tol else []
    parts += [f"turned by {_degrees(angle)}"] if angle > angle_tol else []
    n = len(A.letters)
    text = (
        f"All joint axes agree; only the end differs: {' and '.join(parts)}. Look at theta{n},"
        f" d{n}, a{n}, alpha{n} and the tool."
    )
    return Equivalence(False, text, angle=float(angle), distance=float(shift), reason="end")


def _shift_words(v, same):
    for i, name in enumerate("xyz"):
        if abs(v[i]) > same and np.linalg.norm(np.delete(v, i)) <= max(same, 1e-6 * abs(v[i])):
            return f"{_mm(abs(v[i]))} along {'-' if v[i] < 0 else ''}{name} of the end"
    return (
        f"{_mm(np.linalg.norm(v))} along ({', '.join(number(x) for x in v / np.linalg.norm(v))}) of"
        " the end"
    )


def _relative_difference(A, B, angle_tol, length_tol):
    """With base and tool free: the first joint whose axis stands otherwise to those before it."""
    k = next(k for k in range(2, len(A.letters) + 1) if not _alike(A, B, k, angle_tol, length_tol))
    for measure, tolerance, words, what in (
        (_between, angle_tol, _degrees, "makes {} with"),
        (_apart, length_tol, _mm, "passes {} from"),
    ):
        in_a, in_b = measure(A, k), measure(B, k)
        if abs(in_a - in_b) > tolerance:
            off = float(abs(in_a - in_b))
            angle, distance = (off, 0.0) if measure is _between else (0.0, off)
            text = (
                f"Joint {k}'s axis {what.format(words(in_b))} the axis of joint {k - 1} in table b,"
                f" {words(in_a)} in table a ({words(off)} apart)."
            )
            return Equivalence(False, text, joint=k, angle=angle, distance=distance, reason="axis")
    angles, distances = gaps(A, moved(align(A, B, k - 1), B))
    angle, distance = float(angles[k - 1]), float(distances[k - 1])
    parts = [f"turned by {_degrees(angle)}"] if angle > angle_tol else []
    parts += [_mm(distance) + " away"] if distance > length_tol else []
    text = (
        f"Joint {k}'s axis stands otherwise to those of joints 1 to {k - 1}:"
        f" {' and '.join(parts) or 'mirrored'}."
    )
    return Equivalence(False, text, joint=k, angle=angle, distance=distance, reason="axis")


def _alike(A, B, k, angle_tol, length_tol):
    """Whether the first k axes of both are one figure."""
    angles, distances = gaps(A, moved(align(A, B, k), B))
    return not ((angles[:k] > angle_tol).any() or (distances[:k] > length_tol).any())


def _between(axes, k):
    z, w = axes.z[k - 2], axes.z[k - 1]
    return np.arctan2(np.linalg.norm(np.cross(z, w)), z @ w)


def _apart(axes, k):
    """The distance between the axes of joints k-1 and k; 0 when one of them slides, since its place
    is free.
    """
    if "P" in axes.letters[k - 2 : k]:
        return 0.0
    r, c = axes.p[k - 1] - axes.p[k - 2], np.cross(axes.z[k - 2], axes.z[k - 1])
    s = np.linalg.norm(c)
    return abs(r @ c) / s if s > ANGLE else np.linalg.norm(r - axes.z[k - 2] * (r @ axes.z[k - 2]))


def _mm(metres):
    return f"{_figures(metres * 1000)} mm"


def _degrees(angle):
    return f"{_figures(np.rad2deg(angle))}°"


def _figures(value):
    """Plain decimals for what a ruler shows, an exponent for less."""
    return f"{value:.2g}" if abs(value) < 1e-3 else number(value, 3)
