"""What :func:`dhlab.assign_frames` is given, checked: the joint axes, and the
choices that the geometry leaves open.
"""

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from .normals import Axis, Choices

__all__ = ["axes_from", "choices_from", "signs_from"]


PLACES = ("auto", "previous", "next", "given")


AXIS_FORM = '(point, direction) or (point, direction, "R" or "P")'


def axes_from(axes: Iterable[Sequence[Any]], where: str = "assign_frames") -> list[Axis]:
    """The joint axes, directions at length 1; or a sentence that names the joint."""
    if isinstance(axes, (str, bytes, dict)) or not np.iterable(axes):
        raise ValueError(
            f"{where}: expected a list of joint axes, {AXIS_FORM} each, found"
            f" {type(axes).__name__}; give one entry per joint"
        )
    lines = [_axis(entry, f"{where}: joint {k}") for k, entry in enumerate(axes, 1)]
    if not lines:
        raise ValueError(
            f"{where}: expected at least one joint axis, found an empty list; give"
            f" {AXIS_FORM} per joint"
        )
    return lines


def _axis(entry, where):
    entry = list(entry) if np.iterable(entry) and not isinstance(entry, (str, bytes, dict)) else []
    if len(entry) not in (2, 3):
        raise ValueError(
            f"{where}: expected {AXIS_FORM}, found {len(entry)} entries; put point and direction in"
            " brackets of their own"
        )
    letter = entry[2] if len(entry) == 3 else "R"
    if not isinstance(letter, str) or letter not in ("R", "P"):
        raise ValueError(
            f'{where}: expected "R" (revolute) or "P" (prismatic), found {letter!r}; leave it out'
            " for a revolute joint"
        )
    return Axis(
        _vector(entry[0], f"{where}: point"), _direction(entry[1], f"{where}: direction"), letter
    )


def _vector(given, where):
    try:
        v = np.array(given)
    except ValueError:  # ragged
        v = np.array(None)
    if v.shape != (3,) or v.dtype.kind not in "iuf" or not np.isfinite(v).all():
        raise ValueError(
            f"{where}: expected three finite numbers (x, y, z) in the base frame, found {given!r};"
            " check where they were measured"
        )
    return v.astype(float)


def _direction(given, where):
    v = _vector(given, where)
    largest = np.abs(v).max()
    if largest == 0:
        raise ValueError(
            f"{where}: expected a vector with a length, found 0 0 0; give the direction of positive"
            " motion, such as [0, 0, 1]"
        )
    v = v / largest  # so that very short and very long vectors keep their digits
    return v / np.linalg.norm(v)


def _entries(given, what, low, high):
    """The (number, value) pairs of a keyword that takes a dict."""
    given = {} if given is None else given
    if not isinstance(given, dict):
        raise ValueError(
            f"assign_frames: {what}: expected a dict from number to value, found"
            f" {type(given).__name__}; write it as {{2: value}}"
        )
    for i in given:
        if isinstance(i, bool) or not isinstance(i, (int, np.integer)) or not low <= i <= high:
            raise ValueError(
                f"assign_frames: {what}: expected numbers from {low} to {high}, found {i!r}; "
                f"{'joints count from 1' if low else 'frames count from 0'}"
            )
    return given


def signs_from(given: Mapping[int, int] | None, what: str, low: int, high: int) -> dict[int, int]:
    """The entries of ``x_signs`` or ``z_signs``, numbered from ``low`` to ``high``."""
    entries = _entries(given, what, low, high)
    for i, s in entries.items():
        if not np.isscalar(s) or s not in (1, -1):
            raise ValueError(
                f"assign_frames: {what}: expected 1 or -1 for {i}, found {s!r}; -1 turns the axis"
                " round"
            )
    return entries


def _lengths(given, n):
    return {
        i: _number(h, f"slides: frame {i}: expected a length in m")
        for i, h in _entries(given, "slides", 0, n).items()
    }


def _directions(given, n):
    return {
        i: _direction(v, f"assign_frames: x_along: frame {i}")
        for i, v in _entries(given, "x_along", 0, n).items()
    }


def _angle(given):
    if given is None:
        return None
    angle = _number(given, "parallel: expected an angle in rad")
    if not 0 <= angle < np.pi / 4:
        raise ValueError(
            f"assign_frames: parallel: expected an angle from 0 to π/4 rad, found {given!r}; give"
            " radians, such as 1e-6"
        )
    return angle


def _number(given, where):
    array = np.asarray(given)
    if array.shape != () or array.dtype.kind not in "iuf" or not np.isfinite(array):
        raise ValueError(f"assign_frames: {where}, found {given!r}; give one finite number")
    return float(array)


def _place(given):
    if given not in PLACES:
        raise ValueError(
            'assign_frames: prismatic: expected "auto", "previous", "next" or "given", found'
            f" {given!r}; it says where sliding axes go"
        )
    return given


def choices_from(
    n: int,
    x_signs: Mapping[int, int] | None,
    slides: Mapping[int, float] | None,
    x_along: Mapping[int, ArrayLike] | None,
    prismatic: str,
    parallel: float | None,
    convention: str,
) -> Choices:
    """The keywords of ``assign_frames`` for an arm of n joints, each checked."""
    return Choices(
        signs_from(x_signs, "x_signs", 0, n),
        _lengths(slides, n),
        _directions(x_along, n),
        _place(prismatic),
        _angle(parallel),
        convention == "standard",
    )
