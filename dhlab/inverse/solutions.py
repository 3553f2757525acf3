"""``Solutions``: the configurations that reach a pose, each with its residual; and why there are
none.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from html import escape
from textwrap import fill
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..arm import Arm
from ..printing import grid_html, grid_text, number
from .question import Question

__all__ = ["Nearest", "Reason", "Solutions"]

WIDTH = 100  # characters of a line, in a terminal


@dataclass(frozen=True)
class Nearest:
    """The pose nearest to the target that the search could reach.

    Parameters
    ----------
    q : array (n,)
    pose : array (4, 4)
    metres, radians : float
        What is missing there; a radian was counted as much as ``length`` metres.
    length : float

    Examples
    --------
    >>> import dhlab as dh
    >>> arm = dh.load("ur5e")
    >>> near = arm.solve(dh.transform.trans([2, 0, 0.3])).nearest
    >>> round(near.metres, 2)
    1.06
    """

    q: NDArray[np.float64]
    pose: NDArray[np.float64]
    metres: float
    radians: float
    length: float

    def to_dict(self) -> dict[str, Any]:
        """Plain values for a program."""
        return {
            "q": self.q.tolist(),
            "pose": self.pose.tolist(),
            "metres": self.metres,
            "radians": self.radians,
        }


@dataclass(frozen=True)
class Reason:
    """Why a pose has no solution.

    Parameters
    ----------
    kind : "reach", "orientation", "limits", "redundancy" or "search"
        The position cannot be reached in any orientation; it can, but not in this one; only outside
        the limits; only with another value of the joint that was held; or the search found none and
        cannot say why.
    sentence : str
    metres, radians : float
        By how much: the distance to the nearest position ("reach"), the angle to the nearest
        orientation at that position ("orientation"), the least that a limit is broken ("limits").
    short : float
        Metres by which the wrist centre lacks reach in this orientation, exactly; 0 where the arm's
        geometry does not give it.
    certain : bool
        True where the arm's geometry proves it; else a search from many starts says so, and its
        numbers are the least that it found.

    Examples
    --------
    >>> import dhlab as dh
    >>> dh.load("ur5e").solve(dh.transform.trans([2, 0, 0.3])).reason.kind
    'reach'
    """

    kind: str
    sentence: str
    metres: float = 0.0
    radians: float = 0.0
    short: float = 0.0
    certain: bool = False

    def to_dict(self) -> dict[str, Any]:
        """Plain values for a program."""
        return dict(vars(self))


@dataclass(frozen=True, eq=False, repr=False)
class Solutions(Sequence[NDArray[np.float64]]):
    """The solutions for one pose: a sequence of ``q``, true when there is one.

    Parameters
    ----------
    question : Question
        The arm, the target and the conditions.
    q : array (k, n)
        Radians, metres for a prismatic joint; nearest to ``near`` first, or to zero.
    residuals : array (k, 2)
        Metres and radians by which :meth:`Arm.forward` misses the target at each; never above the
        tolerance.
    method : str
        How they were found.
    complete : bool
        True when these are all there are (at the redundancy that was held), as far as the closed
        form knows; False after a search, which may have missed some.
    families : tuple of (k) tuples
        For each solution the joints, from 1, that can move while the end stays; empty where it
        stands alone.
    held : tuple of {joint from 1: value}
        The redundancy these solutions belong to.
    outside : array (j, n)
        Solutions that were left out because they break the limits.
    notes : tuple of str
    explain : callable
        Gives the reason and the nearest pose; called when they are first asked for.

    Examples
    --------
    >>> import dhlab as dh
    >>> arm = dh.load("puma560")
    >>> answer = arm.solve(arm.forward([0.1, 0.5, -0.2, 0.3, 0.4, 0.5]))
    >>> len(answer), answer[0].round(6), bool(answer.residuals.max() < 1e-9)
    (8, array([ 0.1,  0.5, -0.2,  0.3,  0.4,  0.5]), True)
    """

    question: Question
    q: NDArray[np.float64]
    residuals: NDArray[np.float64]
    method: str
    complete: bool
    families: tuple[tuple[int, ...], ...] = ()
    held: tuple[Mapping[int, float], ...] = ()
    outside: NDArray[np.float64] | None = None
    notes: tuple[str, ...] = ()
    explain: Callable[[], tuple[Reason, Nearest]] | None = None

    def __len__(self) -> int:
        return len(self.q)

    def __getitem__(self, i: Any) -> Any:
        return self.q[i]

    def __array__(self, dtype: Any = None, copy: Any = None) -> NDArray[np.float64]:
        return np.array(self.q, dtype=dtype)

    @property
    def arm(self) -> Arm:
        """The arm that was asked about."""
        return self.question.arm

    @property
    def T(self) -> NDArray[np.float64]:
        """The target (4, 4)."""
        return self.question.T

    @property
    def within_limits(self) -> NDArray[np.bool_]:
        """Which solutions keep the arm's stated limits: booleans (k,)."""
        return np.all(self.arm.within_limits(self.q), axis=1)

    @cached_property
    def _explained(self):
        return (None, None) if len(self) or self.explain is None else self.explain()

    @property
    def reason(self) -> Reason | None:
        """Why there is none, a :class:`Reason`, worked out when first asked for; None when there is
        one.
        """
        return self._explained[0]

    @property
    def nearest(self) -> Nearest | None:
        """The :class:`Nearest` pose that can be reached; None when the target itself can."""
        return self._explained[1]

    def to_dict(self) -> dict[str, Any]:
        """Plain values for a program; lengths in metres, angles in radians."""
        return {
            "solved": bool(self),
            "q": self.q.tolist(),
            "residuals": self.residuals.tolist(),
            "within_limits": self.within_limits.tolist(),
            "families": [list(joints) for joints in self.families],
            "held": [{str(joint): value for joint, value in hold.items()} for hold in self.held],
            "method": self.method,
            "complete": self.complete,
            "reason": self.reason and self.reason.to_dict(),
            "nearest": self.nearest and self.nearest.to_dict(),
            "notes": list(self.notes),
        }

    def _headline(self):
        name = self.arm.name or "the arm"
        if not len(self):
            why = self.reason.sentence if self.reason else ""
            return f"{name}: no solution. {why}"
        metres, radians = self.residuals.max(axis=0)
        count = "1 solution" if len(self) == 1 else f"{len(self)} solutions"
        return (
            f"{name}: {count} ({self.method}); the end misses the target by at most"
            f" {metres:.1g} m and {radians:.1g} rad"
        )

    def _grid(self):
        units = ["m" if slides else "deg" for slides in self.arm.table.prismatic]
        headings = [f"q{i} ({unit})" for i, unit in enumerate(units, 1)]
        rows = [[number(v, 4) for v in self._written(q)] for q in self.q]
        if self.arm.limits:
            headings.append("limits")
            rows = [
                [*row, "kept" if kept else "broken"]
                for row, kept in zip(rows, self.within_limits, strict=True)
            ]
        return ["", *headings], [[str(k), *row] for k, row in enumerate(rows, 1)]

    def _written(self, q):
        return np.where(self.arm.table.prismatic, q, np.rad2deg(q))

    def _remarks(self):
        if self.nearest is not None:
            yield self._nearest_words(self.nearest)
        for k, joints in enumerate(self.families, 1):
            if joints:
                names = ", ".join(str(joint) for joint in joints)
                yield (
                    f"Solution {k} is one of a family: joints {names} can move together and the end"
                    " stays."
                )
        yield from self.notes

    def _nearest_words(self, nearest):
        at = (
            f"at q = {', '.join(number(v, 4) for v in self._written(nearest.q))} (degrees, metres"
            " for a prismatic joint)."
        )
        if max(nearest.metres, nearest.radians) <= self.question.tolerance:
            return f"It is met {at}"
        return (
            f"The nearest pose that it can reach is {number(1000 * nearest.metres, 3)} mm and"
            f" {number(np.rad2deg(nearest.radians), 3)}° away, {at}"
        )

    def __repr__(self) -> str:
        lines = [fill(self._headline(), WIDTH)]
        if len(self):
            lines.append(grid_text(*self._grid()))
        return "\n".join(lines + [fill(remark, WIDTH) for remark in self._remarks()])

    def _repr_html_(self) -> str:
        remarks = "".join(f"<p>{escape(remark)}</p>" for remark in self._remarks())
        if not len(self):
            return f"<p>{escape(self._headline())}</p>{remarks}"
        headings, rows = self._grid()
        return grid_html(headings, rows, self._headline()) + remarks
