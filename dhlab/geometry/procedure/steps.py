"""What :func:`dhlab.assign_frames` did, in sentences that a learner can follow with
a drawing of the arm.
"""

import numpy as np
from numpy.typing import NDArray

from ...printing import number
from ..freechoices import turn_of
from .normals import Placement

__all__ = ["describe"]


def describe(
    found: Placement,
    convention: str,
    sign: NDArray[np.float64],
    base: NDArray[np.float64],
    tool: NDArray[np.float64],
) -> list[str]:
    """One sentence per axis and per row, from frame 0 to the tool.

    Parameters
    ----------
    found : Placement
    convention : "standard" or "craig"
    sign : array (n,)
    base, tool : arrays (4, 4)

    Returns
    -------
    list of str

    Examples
    --------
    >>> from dhlab.geometry.procedure.frames import assign_frames
    >>> print(*assign_frames([([0, 0, 0.1], [0, 0, 2])], end=np.eye(4)).steps, sep="\\n")
    z0 is the axis of joint 1; it runs through the base's origin, which is o0, and x0 is taken along
    the base's x: frame 0 is the base frame.
    z1 lies on z0: x1 and o1 are free; taken as the tool's, so a1 = 0 and alpha1 = 0°.
    Row 1: theta1 = 0° (x0 to x1 about z0), d1 = 0 m (o0 to x1 along z0), a1 = 0 m (z0 to z1 along
    x1), alpha1 = 0° (z0 to z1 about x1).
    Frame 1 is the tool's frame, so arm.tool is the identity.
    """
    words = _Words(found, convention)
    n = len(sign)
    sentences = [words.start(base), *words.axis(1, sign)]
    for k in range(1, n + 1):
        sentences += [*words.axis(k + 1, sign), words.normal(k), words.row(k)]
    return [*sentences, words.end(n, tool)]


class _Words:
    """The names of things in one convention: z_{k-1} (standard) or z_k (Craig) is axis k; x_k is
    normal k in both.
    """

    def __init__(self, found, convention):
        self.found, self.standard = found, convention == "standard"

    def z(self, k):
        if k == len(self.found.axes) and not self.standard:
            return "the tool's z"
        return f"z{k - 1 if self.standard else k}"

    def start(self, base):
        along = _axis_name(self.found.normals[0].x)
        lead = (
            "z0 is the axis of joint 1"
            if self.standard
            else "z0 is taken on z1, the axis of joint 1, so a0 = 0 and alpha0 = 0°"
        )
        if np.array_equal(base, np.eye(4)):
            return (
                f"{lead}; it runs through the base's origin, which is o0, and x0 is taken along the"
                " base's x: frame 0 is the base frame."
            )
        return (
            f"{lead}; o0 is its point {_point(base[:3, 3])}, x0 is taken along {along}; arm.base"
            " holds this frame."
        )

    def axis(self, k, sign):
        """What is to be said of axis k before it is used."""
        axis = self.found.axes[k - 1]
        if k <= len(sign) and sign[k - 1] < 0:
            yield (
                f"{self.z(k)} is put against the direction of joint {k}, so the joint counts the"
                " other way: its sign is -1."
            )
        if axis.letter == "P":
            yield (
                f"Joint {k} slides: only the direction of {self.z(k)} counts; its line is taken"
                f" through {_point(axis.p)}, and d{k} is the variable."
            )

    def normal(self, k):
        case, N = self.found.cases[k], self.found.normals[k]
        text = {"skew": self._skew, "meet": self._meet}.get(
            case, self._parallel if N.a else self._same_line
        )(k, N, case)
        if k in self.found.snapped and k == len(self.found.normals) - 1:
            text = (
                text[:-1]
                + f" (the tool's z is off by {np.rad2deg(self.found.snapped[k][0]):.2g}°, which"
                " arm.tool holds)."
            )
        return text[0].upper() + text[1:] if text.startswith("the ") else text

    def _skew(self, k, N, case):
        sense = (
            f"from {self.z(k)} to {self.z(k + 1)}"
            if N.a > 0
            else f"from {self.z(k + 1)} to {self.z(k)}"
        )
        return (
            f"{self.z(k)} and {self.z(k + 1)} are skew: x{k} lies on their common normal, {sense},"
            f" so a{k} = {number(N.a)} m; alpha{k} = {_deg(N.alpha)}."
        )

    def _meet(self, k, N, case):
        first, second = (self.z(k), self.z(k + 1)) if N.alpha > 0 else (self.z(k + 1), self.z(k))
        return (
            f"{self.z(k)} and {self.z(k + 1)} meet: o{k} is the meeting point, so a{k} = 0, and"
            f" x{k} is taken along {first} × {second}, so alpha{k} = {_deg(N.alpha)}."
        )

    def _parallel(self, k, N, case):
        mark = (
            f"{self.z(k + 1)} ∥ {self.z(k)}"
            if case == "parallel"
            else f"{self.z(k + 1)} ∥ -{self.z(k)} (opposite senses, alpha{k} = 180°)"
        )
        sense = (
            f"from {self.z(k)} to {self.z(k + 1)}"
            if N.a > 0
            else f"from {self.z(k + 1)} to {self.z(k)}"
        )
        return (
            f"{mark}: the common normal is free; taken {self._where(k)}; x{k} points {sense}, a{k}"
            f" = {number(N.a)} m."
        )

    def _same_line(self, k, N, case):
        lies = (
            f"{self.z(k + 1)} lies on"
            f" {self.z(k)}{'' if case == 'same line' else ', the other way'}: "
        )
        if k == len(self.found.normals) - 1:
            free = f"o{k}" if self.standard else "the common normal"
            return (
                f"{lies}x{k} and {free} are free; taken as the tool's, so a{k} = 0 and alpha{k} ="
                f" {_deg(N.alpha)}."
            )
        theta = self.found.row(k)[0]
        along = (
            f"along x{k - 1}, so theta{k} = 0"
            if theta == 0
            else f"along {_axis_name(N.x)}, so theta{k} = {_deg(theta)}"
        )
        return (
            f"{lies}x{k} and the place of the normal are free; x{k} is taken {along}, the normal"
            f" {self._where(k)}; a{k} = 0, alpha{k} = {_deg(N.alpha)}."
        )

    def _where(self, k):
        d = self.found.row(k)[1]
        if k == len(self.found.normals) - 1:
            return f"through the tool's origin, so d{k} = {number(d)} m"
        through = f"o{k - 1}" if self.standard else f"the foot of x{k - 1}"
        return (
            f"through {through}, so d{k} = 0"
            if d == 0
            else f"{number(d)} m from {through} along {self.z(k)}, so d{k} = {number(d)} m"
        )

    def row(self, k):
        theta, d, a, alpha = self.found.row(k)
        z, w, x = self.z(k), self.z(k + 1), f"x{k}"
        start = f"{'o' if self.standard else 'x'}{k - 1}"
        first = (
            f"theta{k} = {_deg(theta)} (x{k - 1} to {x} about {z}), d{k} = {number(d)} m ({start}"
            f" to {x} along {z})"
        )
        if self.standard:
            return (
                f"Row {k}: {first}, a{k} = {number(a)} m ({z} to {w} along {x}), alpha{k} ="
                f" {_deg(alpha)} ({z} to {w} about {x})."
            )
        before = self.found.row(k - 1) if k > 1 else np.zeros(4)
        y = self.z(k - 1) if k > 1 else "z0"
        length, angle = f"a{k - 1} = {number(before[2])} m", f"alpha{k - 1} = {_deg(before[3])}"
        return (
            f"Row {k}: {length} ({y} to {z} along x{k - 1}), {angle} ({y} to {z} about x{k - 1}),"
            f" {first}."
        )

    def end(self, n, tool):
        if np.array_equal(tool, np.eye(4)):
            return f"Frame {n} is the tool's frame, so arm.tool is the identity."
        if np.abs(tool - np.eye(4)).max() < 1e-9:
            return (
                f"Frame {n} is the tool's frame up to rounding in the end pose ({turn_of(tool):.1g}"
                " rad), which arm.tool holds."
            )
        run = (
            f"z{n} runs along the tool's z; "
            if self.standard and n not in self.found.snapped and tool[2, 2] > 0
            else ""
        )
        return (
            f"{run}arm.tool holds the way that is left from frame {n} to the end: shift"
            f" {_point(tool[:3, 3])}, and turn {_turn(tool)}."
        )


def _deg(angle):
    return f"{number(np.rad2deg(angle), 4)}°"


def _point(p):
    return f"({', '.join(number(v) for v in p)})"


def _turn(T):
    return _deg(turn_of(T))


def _axis_name(x):
    for i, name in enumerate("xyz"):
        if abs(abs(x[i]) - 1) < 1e-9:
            return f"the base's {'-' if x[i] < 0 else ''}{name}"
    return f"{_point(x)} of the base"
