"""When two DH tables are one arm, decided on a canonical form; in words what separates them, or the
first joint where they truly differ.
"""

from dataclasses import replace

import numpy as np

from ..arm import Arm
from ..table import DHTable
from ..transform import inverse
from .canonical import ROUNDING, align, gaps, joint_axes, moved
from .conversion import as_arm, to_convention
from .differences import Equivalence, end_difference, first_difference, tolerances, unlike_joints
from .freechoices import SAME_LENGTH, FreeChoice, end_choice, free_choices, in_words
from .zeros import rezero, with_zeros

__all__ = ["equivalent", "Equivalence"]

NAMES = {"standard": "the standard convention", "craig": "Craig's convention"}


def equivalent(
    a: Arm | DHTable, b: Arm | DHTable, *, base: str = "fixed", tool: str = "fixed"
) -> Equivalence:
    """Whether two tables describe one arm: the same pose for every q.

    Decided, not sampled: the joint axes at q = 0 and the end pose there determine the motion and
    are determined by it (:mod:`dhlab.geometry.canonical`); they are compared within 1e-10 rad and
    1e-10 of the arm's size.

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
    The same arm: table b is table a with 0.1 m slid along the parallel axes 2-3 from row 3 to row
    2.
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
    result = unlike_joints(a, b)
    if result is not None:
        return result
    A, B = joint_axes(a), joint_axes(b)
    X = _common_base(A, B, base, tool)
    result = first_difference(A, B, X, base, tool)
    if result is None:
        return _same(a, b, A, B, X, base, tool)
    return _with_remedy(result, a, b, A, B, base, tool)


def _common_base(A, B, base, tool):
    """What lays b on a before axes are compared: nothing, the end poses, or the axes themselves."""
    if base == "fixed":
        return np.eye(4)
    return A.end @ inverse(B.end) if tool == "fixed" else align(A, B)


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
                f"{NAMES[b.table.convention]} in place of {NAMES[a.table.convention]} (a and alpha"
                " in other rows)",
            ),
        )
    )
    length = SAME_LENGTH * max(A.reach, B.reach) + ROUNDING * max(A.largest, B.largest)
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
    angle_tol, length_tol = tolerances(A, B)
    angles, distances = gaps(A, on_a)
    if (angles > angle_tol).any() or (distances > length_tol).any():
        return False
    return not (base == tool == "fixed") or end_difference(A, on_a, angle_tol, length_tol) is None
