"""``Comparison``: two arms side by side, for a terminal, a notebook and a program."""

from __future__ import annotations

from dataclasses import dataclass
from html import escape
from typing import Any

import numpy as np

from ...printing import grid_html, grid_text, number
from ..differences import Equivalence

__all__ = ["Comparison", "JointCompared", "EndCompared"]

SAME_ANGLE = 1e-7  # rad; both are far below what any maker prints
SAME_LENGTH = 1e-8  # m
HEADINGS = ("joint", "counts", "zero", "d (mm)", "a (mm)", "alpha (deg)")


@dataclass(frozen=True)
class JointCompared:
    """One joint of two arms, and the link behind it.

    Attributes
    ----------
    joint : int
        From 1.
    kind : "R" or "P"
    sense : int
        -1 where arm b counts the other way than arm a.
    zero : float
        Where arm b is at 0, in arm a's joint value: ``q_a = sense · q_b + zero`` (rad; m of a
        sliding joint).
    d, a, alpha : (float, float) or None
        In arm a and in arm b, m and rad, both with arm a's choice of x and z; ``a`` and ``alpha``
        of the last joint are 0, since its link is the tool. Of a sliding joint ``d`` is None.
    theta : (float, float) or None
        Of a sliding joint, rad; None of others.
    beta : (float, float) or None
        Where the axis and the next are nearly parallel in one of the arms: the turn about y, and d
        is 0 (Hayati's parameters); None elsewhere.
    """

    joint: int
    kind: str
    sense: int
    zero: float
    d: tuple[float, float] | None
    a: tuple[float, float]
    alpha: tuple[float, float]
    theta: tuple[float, float] | None = None
    beta: tuple[float, float] | None = None

    def lengths(self) -> dict[str, float]:
        """By how much b's numbers differ from a's, of those that differ: m and rad, by name; zero
        and sense left out.

        Examples
        --------
        >>> JointCompared(2, "R", 1, 0.0, (0.0, 0.0), (0.4, 0.41), (0.0, 0.0)).lengths()
        {'a': 0.01}
        """
        found = {}
        for name in ("d", "a", "alpha", "theta", "beta"):
            pair = getattr(self, name)
            if pair is None:
                continue
            gap = pair[1] - pair[0]
            if name not in ("d", "a"):
                gap = float((gap + np.pi) % (2 * np.pi) - np.pi)
            if abs(gap) > (SAME_LENGTH if name in ("d", "a") else SAME_ANGLE):
                found[name] = round(gap, 15)
        return found

    @property
    def counts_alike(self) -> bool:
        """Whether sense and zero are the same in both."""
        return self.sense > 0 and not self.moved

    @property
    def moved(self) -> str:
        """By how much the zero is another, in words such as "+2°"; empty where it is the same."""
        if abs(self.zero) <= (SAME_LENGTH if self.kind == "P" else SAME_ANGLE):
            return ""
        return (
            f"{self.zero * 1e3:+.6g} mm" if self.kind == "P" else f"{np.rad2deg(self.zero):+.6g}°"
        )


@dataclass(frozen=True)
class EndCompared:
    """How far the base (or the tool) of arm b lies from that of arm a: ``shift`` (m), ``turn``
    (rad). A shift along the first axis and a turn about it stand with joint 1, as d and zero, since
    nothing tells them apart; likewise of the tool and the last joint."""

    shift: float
    turn: float

    @property
    def same(self) -> bool:
        """Whether there is nothing between them."""
        return self.shift <= SAME_LENGTH and self.turn <= SAME_ANGLE

    def __str__(self) -> str:
        if self.same:
            return "same"
        return f"{_mm(self.shift)} mm away, turned by {_deg(self.turn)}°"


@dataclass(frozen=True)
class Comparison:
    """The answer of :func:`dhlab.compare`: true where the motion is the same, a table when printed.

    Attributes
    ----------
    kind : str
        "same": the same pose for every q. "ends": with another base or tool they are one arm.
        "zeros": the same lengths and angles, but joints count from another zero or the other way.
        "lengths": other lengths or angles. "joints": another number or other types of joints.
    message : str
        The same in a sentence or two.
    names : (str, str)
    joints : tuple of JointCompared
        Empty where ``kind`` is "joints".
    base, tool : EndCompared or None
    apart : (float, float) or None
        How far the ends are apart at most, over random configurations: m and rad.
    apart_matched : (float, float) or None
        The same with b's zeros and senses, base and tool taken for a's: what the lengths and
        angles make.
    equivalence : Equivalence
        What :func:`dhlab.equivalent` says.

    Examples
    --------
    >>> import dhlab as dh
    >>> found = dh.compare(dh.load("piper"), dh.load("piper.sdk_old"))
    >>> found.kind, [joint.joint for joint in found.joints if not joint.counts_alike]
    ('zeros', [2, 3])
    """

    kind: str
    message: str
    names: tuple[str, str]
    joints: tuple[JointCompared, ...]
    base: EndCompared | None
    tool: EndCompared | None
    apart: tuple[float, float] | None
    apart_matched: tuple[float, float] | None
    equivalence: Equivalence

    def __bool__(self) -> bool:
        return self.kind == "same"

    def to_dict(self) -> dict[str, Any]:
        """Plain values for a program, in m and rad.

        Examples
        --------
        >>> import dhlab as dh
        >>> dh.compare(dh.load("ur5e"), dh.load("ur5e")).to_dict()["same"]
        True
        """
        return {
            "same": bool(self),
            "kind": self.kind,
            "message": self.message,
            "names": list(self.names),
            "units": {"length": "m", "angle": "rad"},
            "joints": [vars(joint) | {"differs": joint.lengths()} for joint in self.joints],
            "base": None if self.base is None else vars(self.base),
            "tool": None if self.tool is None else vars(self.tool),
            "apart": self.apart,
            "apart_matched": self.apart_matched,
        }

    def __str__(self) -> str:
        lines = [self.message]
        if self.joints:
            lines += ["", f"a: {self.names[0]}", f"b: {self.names[1]}"]
            lines.append("(told in one choice of frames; a table's own may turn x or z round)")
            lines += [grid_text(HEADINGS, self._rows()), *self._ends()]
        return "\n".join(lines)

    def _repr_html_(self) -> str:
        text = f"<p>{escape(self.message)}</p>"
        if not self.joints:
            return text
        caption = f"a: {self.names[0]}; b: {self.names[1]}"
        return (
            text
            + grid_html(map(escape, HEADINGS), self._rows(), caption)
            + "".join(f"<p>{escape(line)}</p>" for line in self._ends())
        )

    def _rows(self) -> list[list[str]]:
        return [_row(joint) for joint in self.joints]

    def _ends(self) -> list[str]:
        assert self.base is not None and self.tool is not None
        lines = [f"base: {self.base}", f"tool: {self.tool}"]
        if self.apart is not None and not self:
            lines.append(f"ends: up to {_both(self.apart)} apart for the same q")
            if self.apart_matched is not None and self.apart_matched != self.apart:
                lines.append(
                    f"      up to {_both(self.apart_matched)} with signs, zeros, base and tool"
                    f" taken alike (d1 and d{len(self.joints)} belong to these)"
                )
        if any(joint.beta for joint in self.joints):
            lines.append(
                "Nearly parallel axes are told as Hayati does: no d, and beta turns about y."
            )
        return lines


def _row(joint):
    slides = joint.kind == "P"
    first = f"slides; theta {_pair(joint.theta, _deg)}°" if slides else _pair(joint.d, _mm)
    alpha = _pair(joint.alpha, _deg)
    if joint.beta:
        alpha += f", beta {_pair(joint.beta, _deg)}"
    counts = "same" if joint.sense > 0 else "other way"
    return [str(joint.joint), counts, joint.moved or "same", first, _pair(joint.a, _mm), alpha]


def _pair(pair, written):
    """Both numbers, or the one where they are the same as written."""
    in_a, in_b = map(written, pair)
    return in_a if in_a == in_b else f"{in_a} → {in_b}"


def _mm(metres):
    return number(metres * 1e3, 4)


def _deg(angle):
    return number(np.rad2deg(angle), 4)


def _both(pair):
    return f"{_mm(pair[0])} mm and {_deg(pair[1])}°"
