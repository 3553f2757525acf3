"""When two DH tables are one arm, decided on a canonical form; in words what separates them, or the
first joint where they truly differ.
"""

from dataclasses import dataclass, replace
from html import escape

import numpy as np

from ..printing import number
from ..transform import inverse
from .canonical import align, gaps, joint_axes, moved
from .conversion import as_arm, to_convention
from .freechoices import FreeChoice, end_choice, free_choices, in_words, turn_of
from .zeros import Rezeroed, rezero, with_zeros

__all__ = ["equivalent", "Equivalence"]

# rad; a thousand times the rounding of a long walk of rewritings, a thousandth of the smallest true
# change
ANGLE = 1e-9
LENGTH = 1e-9  # × how far the axes pass from the end; likewise
ROUNDING = (
    64 * np.finfo(float).eps
)  # × the largest length in the table, for tables with run-away lengths (574 m in a 1 m arm)


@dataclass(frozen=True)
class Equivalence:
    """The answer of :func:`equivalent`: true or false in an ``if``, a sentence when printed.

    ``differences`` are the free choices (:class:`dhlab.geometry.freechoices.FreeChoice`) that
    separate two equivalent tables. Otherwise ``joint`` is the first joint (1-based) whose axis
    truly differs, None when only the end or the number of joints does; ``angle`` (rad) and
    ``distance`` (m) say by how much; ``reason`` is "count", "type", "sense", "axis" or "end".
    ``zeros`` says which joint zeros and counting directions would make table a the arm of table b,
    where that is all that separates them (:class:`dhlab.geometry.zeros.Rezeroed`).
    """

    equal: bool
    message: str
    differences: tuple = ()
    joint: int | None = None
    angle: float = 0.0
    distance: float = 0.0
    reason: str = ""
    zeros: Rezeroed | None = None

    def __bool__(self):
        return self.equal

    def __str__(self):
        return self.message

    def _repr_html_(self):
        items = "".join(f"<li>{escape(choice.message)}</li>" for choice in self.differences)
        verdict = "The same arm" if self.equal else "Not the same arm"
        return f"<p><strong>{verdict}.</strong> {escape(self.message)}</p>" + (
            f"<ul>{items}</ul>" if items else ""
        )


def equivalent(a, b, *, base="fixed", tool="fixed"):
    """Whether two tables describe one arm: the same pose for every q.

    Decided, not sampled: the joint axes at q = 0 and the end pose there determine the motion and
    are determined by it (:mod:`dhlab.geometry.canonical`); they are compared within 1e-9 rad and
    1e-9 of the arm's size.

    Parameters
    ----------
    a, b : Arm or DHTable
        In any conventions. A table alone has no base, tool or reversed joints.
    base, tool : "fixed" or "free"
        Free: equal up to a constant base (or tool) pose, for two publishers who put the frame
        elsewhere.

    Returns
    -------
    Equivalence
        True or false; printed, in words: the free choices that separate the tables, or the first
        joint where the arms differ.

    Raises
    ------
    ValueError
        Something else than an Arm or DHTable, or than "fixed" or "free".

    Examples
    --------
    >>> import dhlab as dh
    >>> arm = dh.load("ur5e")
    >>> print(equivalent(arm, arm.flip_x(2)))
    The same arm: table b is table a with x2 flipped (theta2, a2, alpha2, theta3).
    >>> print(equivalent(arm, arm.flip_x(2).slide(2, 0.1).flip_x(2)))
    The same arm: table b is table a with 0.1 m slid along the parallel axes 2-3 from row 3 to row 2.
    >>> result = equivalent(arm, dh.load("ur5_cb"))
    >>> bool(result), result.joint
    (False, 2)
    """
    for name, value in (("base", base), ("tool", tool)):
        if value not in ("fixed", "free"):
            raise ValueError(
                f'equivalent: {name}: expected "fixed" or "free", found {value!r}; free compares up'
                f" to a constant {name} pose"
            )
    a, b = as_arm(a, "equivalent"), as_arm(b, "equivalent")
    result = _unlike_joints(a, b)
    if result is not None:
        return result
    A, B = joint_axes(a), joint_axes(b)
    X = _common_base(A, B, base, tool)
    result = _first_difference(A, B, X, base, tool)
    if result is None:
        return _same(a, b, A, B, X, base, tool)
    return _with_remedy(result, a, b, A, B, base, tool)


def _unlike_joints(a, b):
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
    return None


def _joints(n):
    return "1 joint" if n == 1 else f"{n} joints"


def _common_base(A, B, base, tool):
    """What lays b on a before axes are compared: nothing, the end poses, or the axes themselves."""
    if base == "fixed":
        return np.eye(4)
    return A.end @ inverse(B.end) if tool == "fixed" else align(A, B)


def _tolerances(A, B):
    return ANGLE, LENGTH * max(A.reach, B.reach) + ROUNDING * max(A.largest, B.largest, 1e-3)


def _first_difference(A, B, X, base, tool):
    """None, or an Equivalence that names the first joint, from the base (from the tool when only
    that is fixed), whose axes differ.
    """
    on_a = moved(X, B)
    angles, distances = gaps(A, on_a)
    angle_tol, length_tol = _tolerances(A, B)
    wrong = np.flatnonzero((angles > angle_tol) | (distances > length_tol))
    if not len(wrong):
        return _end_difference(A, on_a, angle_tol, length_tol) if base == tool == "fixed" else None
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


def _end_difference(A, B, angle_tol, length_tol):
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
    """With base and tool free: the first joint whose axis stands otherwise to the axes before
    it.
    """
    k = next(k for k in range(2, len(A.letters) + 1) if not _alike(A, B, k, angle_tol, length_tol))
    for measure, tolerance, words, what in (
        (_between, angle_tol, _degrees, "makes {} with"),
        (_apart, length_tol, _mm, "passes {} from"),
    ):
        in_a, in_b = measure(A, k), measure(B, k)
        if abs(in_a - in_b) > tolerance:
            off = float(abs(in_a - in_b))
            text = (
                f"Joint {k}'s axis {what.format(words(in_b))} the axis of joint {k - 1} in table b,"
                f" {words(in_a)} in table a ({words(off)} apart)."
            )
            return Equivalence(
                False,
                text,
                joint=k,
                reason="axis",
                **{"angle" if measure is _between else "distance": off},
            )
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


def _same(a, b, A, B, X, base, tool):
    """The verdict for equivalent tables, with the free choices that separate them."""
    convention = (
        ()
        if a.table.convention == b.table.convention
        else (
            FreeChoice(
                "convention",
                None,
                None,
                f"the convention {b.table.convention} in place of {a.table.convention} (a and alpha"
                " one row on)",
            ),
        )
    )
    length = 10 * LENGTH * max(A.reach, B.reach, 1e-3)
    granted = end_choice("base", X, length) if base == "free" else []
    granted += end_choice("tool", inverse(A.end) @ X @ B.end, length) if tool == "free" else []
    choices = (*convention, *granted, *free_choices(a, to_convention(b, a.table.convention), X))
    if not choices:
        return Equivalence(True, "The same arm, in the same table.")
    return Equivalence(
        True, f"The same arm: table b is table a with {in_words(choices, a)}.", choices
    )


def _with_remedy(result, a, b, A, B, base, tool):
    """The verdict, and what would make the two agree, where that is known: base or tool free, other
    zeros, other signs.
    """
    for free in (("fixed", "free"), ("free", "fixed"), ("free", "free")):
        grants_more = all(
            new == "free" or old == "fixed" for new, old in zip(free, (base, tool))
        ) and free != (base, tool)
        if grants_more and _agree(A, B, *free):
            names = " and ".join(
                name for name, state in zip(("base", "tool"), free) if state == "free"
            )
            return replace(
                result, message=f"{result.message} With {names} free they are the same arm."
            )
    found = rezero(a, b)
    if (
        found
        and found.says_something
        and _agree(joint_axes(with_zeros(a, found.sign, found.offset)), B, found.base, found.tool)
    ):
        return replace(
            result,
            message=f"{result.message} With {found} table a becomes the arm of table b.",
            zeros=found,
        )
    return result


def _agree(A, B, base, tool):
    """The bare decision."""
    on_a = moved(_common_base(A, B, base, tool), B)
    angle_tol, length_tol = _tolerances(A, B)
    angles, distances = gaps(A, on_a)
    if (angles > angle_tol).any() or (distances > length_tol).any():
        return False
    return not (base == tool == "fixed") or _end_difference(A, on_a, angle_tol, length_tol) is None


def _mm(metres):
    return f"{_figures(metres * 1000)} mm"


def _degrees(angle):
    return f"{_figures(np.rad2deg(angle))}°"


def _figures(value):
    """Plain decimals for what a ruler shows, an exponent for less."""
    return f"{value:.2g}" if abs(value) < 1e-3 else number(value, 3)
