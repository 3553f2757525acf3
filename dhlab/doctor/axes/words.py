"""A found mistake of an axis sheet in words: which axis, how far and which way, how sure."""

import numpy as np
from scipy.spatial.transform import Rotation

from ...geometry.lines import across
from ...printing import number
from ..finding import find

__all__ = ["finding_of", "axis_differences"]

IDS = {
    "sense": "axis-sense",
    "direction": "axis-direction",
    "place": "axis-place",
    "line": "axis-place",
    "zero": "axis-zero",
    "end": "axis-end",
}
PARAMETERS = {"sense": "sense", "direction": "direction", "place": "point", "line": "point"}
PURE = 0.05  # of a shift: less than this beside one axis of the base is no part of the words
DUST = 5e-5  # m
TURNED = 2.9  # rad; a fitted direction as far round as this is the other sense


def finding_of(explanation, sheet, repair):
    """The Finding of an explanation; ``sheet`` is the chain as written."""
    change = explanation.change
    joint = None if change.joint is None else change.joint + 1
    return find(
        IDS[change.kind],
        place=f"axis {joint}" if joint else "the end",
        joint=joint,
        parameter=PARAMETERS.get(change.kind, "q" if change.kind == "zero" else "end"),
        detail=_detail(explanation, sheet),
        repair=repair,
    )


def _detail(explanation, sheet):
    change, new, i = explanation.change, explanation.chain, explanation.change.joint
    if change.kind == "sense":
        return f"its sense is turned: {_vector(new.z[i])}, not {_vector(sheet.z[i])}"
    if change.kind == "direction":
        return direction_words(sheet.z[i], new.z[i], _angle_error(explanation))
    if change.kind == "place":
        return place_words(
            sheet.p[i], new.p[i], sheet.z[i], _length_error(explanation), change.free == 1
        )
    if change.kind == "line":
        return (
            f"{place_words(sheet.p[i], new.p[i], sheet.z[i], _length_error(explanation))}, and it"
            f" {direction_words(sheet.z[i], new.z[i], '')}"
        )
    if change.kind == "zero":
        return _zero_words(sheet.letters[i], new.zero[i])
    return _end_words(sheet.end, new.end)


def direction_words(z, w, error):
    """How a direction differs from the one written."""
    angle = np.arctan2(np.linalg.norm(np.cross(z, w)), z @ w)
    return f"points {number(np.rad2deg(angle), 2)}{error}° off: {_vector(w)}, not {_vector(z)}"


def place_words(p, new, z, error, single=False):
    """How far an axis is from where it was written, and which way; a shift along the axis itself
    is none. ``single``: one coordinate of the point is named.
    """
    off = new - p if single else across(new - p, z)
    k = int(np.argmax(abs(off)))
    rest = np.linalg.norm(np.delete(off, k))
    size = number(1e3 * np.linalg.norm(off), 2)
    if rest > max(PURE * abs(off[k]), DUST):
        by = ", ".join(number(1e3 * x, 2) for x in off)
        return f"lies {size}{error} mm away, by ({by}) mm in x, y, z"
    sense = "-" if off[k] < 0 else ""
    where = f"lies {size}{error} mm away along {sense}{'xyz'[k]}"
    if not single:
        return where
    return (
        f"{where}: the point's {'xyz'[k]} is {number(1e3 * new[k], 2)} mm, not"
        f" {number(1e3 * p[k], 2)} mm"
    )


def _zero_words(letter, zero):
    amount = f"{number(1e3 * zero, 2)} mm" if letter == "P" else f"{number(np.rad2deg(zero), 2)}°"
    return f"the sheet shows the joint at {amount}, not at 0"


def _end_words(old, new):
    off = new[:3, 3] - old[:3, 3]
    turn = np.rad2deg(Rotation.from_matrix(old[:3, :3].T @ new[:3, :3]).as_rotvec())
    said = []
    if np.linalg.norm(off) > DUST:
        by = ", ".join(number(1e3 * x, 2) for x in off)
        said.append(f"lies {number(1e3 * np.linalg.norm(off), 2)} mm away, by ({by}) mm in x, y, z")
    if np.linalg.norm(turn) > 1e-3:
        by = ", ".join(number(x, 2) for x in turn)
        said.append(
            f"is turned by {number(np.linalg.norm(turn), 2)}°, by ({by})° about its own x, y, z"
        )
    return " and ".join(said)


def _vector(v):
    return f"({', '.join(number(x, 4) for x in v)})"


def _length_error(explanation):
    return _plus_minus(explanation.covariance[:2, :2], 1e3)


def _angle_error(explanation):
    return _plus_minus(explanation.covariance, 180 / np.pi)


def _plus_minus(covariance, scale):
    """Twice the standard deviation, where something was fitted and it shows."""
    error = 2 * scale * np.sqrt(np.linalg.eigvalsh(covariance)[-1]) if covariance.size else 0.0
    return f" ± {number(error, 2)}" if error >= 0.005 else ""


def axis_differences(sheet, fitted, joints):
    """A sentence for each of the joints (0-based) whose axis was fitted elsewhere, the largest
    difference first.
    """
    said = []
    for i, letter in enumerate(sheet.letters):
        if i not in joints:
            continue
        off = across(fitted.p[i] - sheet.p[i], sheet.z[i]) if letter == "R" else np.zeros(3)
        angle = np.arctan2(
            np.linalg.norm(np.cross(sheet.z[i], fitted.z[i])), sheet.z[i] @ fitted.z[i]
        )
        parts = []
        if np.linalg.norm(off) > DUST:
            parts.append(place_words(sheet.p[i], fitted.p[i], sheet.z[i], ""))
        if angle > TURNED:
            parts.append("has the other sense")
        elif angle > 1e-4:
            parts.append(f"points {number(np.rad2deg(angle), 2)}° off")
        if parts:
            said.append((np.linalg.norm(off) + 0.5 * angle, f"axis {i + 1} {' and '.join(parts)}"))
    return [words for _, words in sorted(said, key=lambda pair: -pair[0])]
