"""Mode "place": what is offered at each step, what is said of a choice, and the worked placement
that a page without a kernel plays.

Every choice is judged by :class:`dhlab.placing.Placement`; here is only what to show.
"""

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...arm import Arm
from ...placing.board import Placement
from ...placing.words import Judgement
from .content import arm_data

__all__ = ["Placing", "axes_of"]

# of what is drawn: free of rounding's last digits, so that stored pages are the same everywhere
DIGITS = 9


def axes_of(
    arm: Arm,
) -> tuple[list[tuple[NDArray[np.float64], NDArray[np.float64], str]], NDArray[np.float64]]:
    """The bare axes of an arm at its zero pose, as ``assign_frames`` takes them, and its end pose
    there.
    """
    chain = arm.frames(np.zeros(len(arm)))
    on = chain[:-1] if arm.table.convention == "standard" else chain[1:]
    axes = [
        (frame[:3, 3], sign * frame[:3, 2], letter)
        for frame, sign, letter in zip(on, arm.sign, arm.table.joints)
    ]
    return axes, chain[-1] @ arm.tool


class Placing:
    """A placement in the view: ``placement`` is what is placed so far, ``turn`` how often something
    was asked.
    """

    def __init__(self, axes: Iterable[Sequence[Any]], end: ArrayLike, convention: str) -> None:
        self.given, self.turn = (axes, end, convention), 0
        self.shown: dict[int, NDArray[np.float64]] | None = None  # frames that came placed
        self.start_over()

    @classmethod
    def of(cls, board: Placement) -> "Placing":
        """A board in the view, with what is placed on it."""
        axes = [(axis.p, axis.z, axis.letter) for axis in board.axes[: len(board)]]
        placing = cls(axes, board.end, board.convention)
        kept = {"z": board.z, "o": board.o, "x": board.x}
        for step in placing.placement.missing:
            letter, i = step[0], int(step[1:])
            if i in kept[letter]:
                placing.make(step, kept[letter][i], board.o.get(i) if letter == "z" else None)
        placing.shown = board.frames if board.finished else None
        return placing

    def start_over(self, keep: Iterable[tuple[str, ArrayLike, ArrayLike | None]] = ()) -> None:
        """Put all frames away, but for the steps to keep."""
        self.turn += 1
        self.placement = Placement(*self.given)
        self.made: list[tuple[str, ArrayLike, ArrayLike | None]] = []
        for step in keep:
            self.make(*step)

    def back(self) -> None:
        """Take back the last right step."""
        self.start_over(self.made[:-1])

    def make(self, step: str, value: ArrayLike, point: ArrayLike | None = None) -> Judgement:
        """Make a step such as "z1"; returns the Judgement."""
        self.turn += 1
        letter, i = step[:1], step[1:]
        if letter not in ("z", "o", "x") or not i.isdigit():
            raise ValueError(
                f'explorer.place: expected a step such as "z1", "o1" or "x1", found {step!r}'
            )
        judgement = self._setter(letter)(int(i), value, *([point] if letter == "z" else []))
        if judgement:
            self.made.append((step, value, point))
        return judgement

    def _setter(self, letter):
        return {
            "z": self.placement.set_z,
            "o": self.placement.set_origin,
            "x": self.placement.set_x,
        }[letter]

    def data(self) -> dict[str, Any]:
        """What does not change: axes, base, end, and a worked placement."""
        placement = self.placement
        axes = [
            {"p": _plain(axis.p), "z": _plain(axis.z), "letter": axis.letter}
            for axis in placement.axes
        ]
        return {
            "axes": axes,
            "end": _plain(placement.end.ravel()),
            "reach": round(float(placement.reach), DIGITS),
            "convention": placement.convention,
            **self._worked(),
        }

    def _worked(self):
        """The frames that came placed, or those that ``assign_frames`` finds, made step by step."""
        worked, steps = Placement(*self.given), []
        frames = self.shown or self.placement.model.frames(np.zeros(len(self.placement)))
        while not worked.finished:
            step = worked.missing[0]
            letter, i = step[0], int(step[1:])
            x, _, z, o = frames[i][:3].T
            if letter == "z":
                made = worked.set_z(i, z, o)
            else:
                made = worked.set_origin(i, o) if letter == "o" else worked.set_x(i, x)
            if not made:
                break
            steps.append(
                {
                    "step": step,
                    "message": made.message,
                    "value": _plain({"z": worked.z, "o": worked.o, "x": worked.x}[letter][i]),
                }
            )
        return {
            "worked": steps,
            "finished": arm_data(worked.arm if worked.finished else self.placement.model),
            "steps": (0, len(steps)),
        }

    def answer(self, judgement: Judgement | None = None) -> dict[str, Any]:
        """What the view shows after a step: what is placed, what is said, what comes next and what
        is offered for it.
        """
        placement = self.placement
        said = (
            None
            if judgement is None
            else {
                "step": judgement.step,
                "right": bool(judgement),
                "rule": judgement.rule,
                "message": judgement.message,
            }
        )
        kept = {"z": placement.z, "o": placement.o, "x": placement.x}
        placed = [
            {"step": f"{letter}{i}", "value": _plain(value)}
            for letter, by_frame in kept.items()
            for i, value in by_frame.items()
        ]
        following = None if placement.finished else placement.missing[0]
        return {
            "turn": self.turn,
            "said": said,
            "placed": placed,
            "next": following,
            "left": len(placement.missing),
            "offers": self._offers(following) if following else [],
            "arm": arm_data(placement.arm) if placement.finished else None,
        }

    def _offers(self, step):
        """Right and wrong choices for a step, in one order whatever is right: {words, value, point
        or None}.
        """
        letter, i = step[0], int(step[1:])
        return list({"z": self._lines, "o": self._points, "x": self._directions}[letter](i))

    def _lines(self, i):
        """Every joint's axis, both ways, and the end's z."""
        for k, axis in enumerate(self.placement.axes, 1):
            name = "the end's z" if axis.letter == "tool" else f"axis of joint {k}"
            for sense, word in ((1, "forward"), (-1, "backward")):
                yield {
                    "words": f"{name}, {word}",
                    "value": _plain(sense * axis.z),
                    "point": _plain(axis.p),
                }

    def _points(self, i):
        """The feet of the common normal, points of the axes, base and end, and the same dropped
        onto this z.
        """
        placement, found = self.placement, self.placement.choices(i)
        places = [] if found.feet is None else list(found.feet)
        places += [
            np.zeros(3),
            placement.end[:3, 3],
            *(axis.p for axis in placement.axes[: len(placement)] if axis.letter == "R"),
        ]
        if found.line is None:
            return _different(np.array([*places, *placement.o.values()]), placement.reach)
        p, z = found.line
        near = [p + z * ((point - p) @ z) for point in places]
        return _different(np.array([*near, *places[:4]]), placement.reach)

    def _directions(self, i):
        """Both ways along the common normal, both z axes and the base's axes."""
        placement, found = self.placement, self.placement.choices(i)
        lines = [
            placement.z[i],
            *np.eye(3),
            *(_sides(placement.z[i]) if found.x is None else [found.x]),
        ]
        lines += [] if found.other is None else [found.other[1]]
        return _different(np.array([sense * line for line in lines for sense in (1, -1)]), 1.0)


def _different(values, size):
    """Each point or direction (k, 3) once, sorted by its coordinates, so that the order says
    nothing about what is right.
    """
    kept: list[NDArray[np.float64]] = []
    for value in values[np.lexsort(np.round(values, 6).T)]:
        if all(np.linalg.norm(value - other) > 1e-4 * size for other in kept):
            kept.append(value)
    return [{"words": "", "value": _plain(value), "point": None} for value in kept]


def _sides(z):
    """Two directions at right angles to z and to each other."""
    side = np.cross(z, np.eye(3)[np.argmin(np.abs(z))])
    side = side / np.linalg.norm(side)
    return side, np.cross(z, side)


def _plain(values):
    return (np.round(np.asarray(values, dtype=float), DIGITS) + 0.0).tolist()
