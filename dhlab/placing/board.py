"""A learner places DH frames on bare joint axes, step by step, and every step is judged: any valid
choice passes, a wrong one is told its rule.
"""

from collections.abc import Iterable, Sequence
from copy import copy
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..geometry.procedure.frames import PlacedArm, assign_frames
from ..geometry.procedure.inputs import axes_from
from ..geometry.procedure.normals import Choices, place
from ..transform import require_pose
from .finished import placed_arm, pose
from .geometry import Geometry
from .neighbours import comes_first, on_next_line, open_for
from .rule_origin import judge_origin
from .rule_x import judge_x
from .rule_z import judge_z
from .words import Judgement

__all__ = ["Placement"]


class Placement:
    """Frames being placed on bare joint axes.

    Parameters
    ----------
    axes : list
        As :func:`dhlab.assign_frames` takes them: per joint (point, direction) or
        (point, direction, "R" | "P").
    end : array (4, 4)
        The end pose at q = 0.
    convention : "standard" or "craig"

    Attributes
    ----------
    z, o, x : dict
        What is placed so far, by frame: unit vectors (3,) and points (3,) in m, exact where the
        hand was a little off.
    points : dict
        By frame, the point (3,) that z was laid through, where its line is open; else None.
    model : PlacedArm
        What ``assign_frames`` makes of the same axes.

    Raises
    ------
    ValueError
        One sentence, as from ``assign_frames``.

    Notes
    -----
    A right step is kept; a wrong one changes nothing. A step made again puts away what no longer
    fits it. In a frame z comes first, then the origin, then x. A sliding joint has only a
    direction, so its z runs through the origin it is given (or through ``point``); so does the z
    that lies on no joint: z_n (standard) or z_0 (Craig).

    Examples
    --------
    >>> from dhlab.transform import trans
    >>> axes = [([0, 0, 0], [0, 0, 1]), ([0.4, 0, 0.1], [0, 0, 1])]
    >>> two = Placement(axes, end=trans([0.7, 0, 0.1]))
    >>> print(two.set_z(0, [1, 1, 0]))
    ✗ z0: This stands across the axis of joint 1. z lies on the line the joint turns about:
          move the joint alone and look for the line that stays in place.
    >>> for i, point in enumerate([[0, 0, 0], [0.4, 0, 0], [0.7, 0, 0.1]]):
    ...     right = two.set_z(i, [0, 0, 1]) and two.set_origin(i, point) and two.set_x(i, [1, 0, 0])
    >>> print(two.arm)
    standard DH, 2 joints (lengths in m, angles in deg)
     i  theta  d    a    alpha
     1  q1     0    0.4  0
     2  q2     0.1  0.3  0
    """

    def __init__(
        self, axes: Iterable[Sequence[Any]], end: ArrayLike, convention: str = "standard"
    ) -> None:
        self.model = assign_frames(axes, end=end, convention=convention)
        self.end, self.convention = require_pose(end, "Placement: end"), convention
        found = place(axes_from(axes), self.end, Choices(standard=self.standard))
        self.axes, self.reach = found.axes, found.reach or 1.0
        self._clear()

    def cleared(self, first: int | None = None) -> "Placement":
        """Another Placement on the same axes, with no frame placed yet; with ``first``, every z as
        it is here, and all of the frames before that one.
        """
        other = copy(self)
        other._clear()
        if first is not None:
            said = [step for step in self._said if step[0] == "z" or int(step[1:]) < first]
            other._said = {step: self._said[step] for step in said}
            other.z, other.points = self.z.copy(), self.points.copy()
            other.o = {i: o for i, o in self.o.items() if i < first}
            other.x = {i: x for i, x in self.x.items() if i < first}
        return other

    def _clear(self):
        self.z: dict[int, NDArray[np.float64]] = {}
        self.o: dict[int, NDArray[np.float64]] = {}
        self.x: dict[int, NDArray[np.float64]] = {}
        self.points: dict[int, NDArray[np.float64] | None] = {}
        self._said: dict[str, Judgement] = {}

    def __len__(self) -> int:
        """The number of joints; frames run from 0 to this."""
        return len(self.axes) - 1

    @property
    def standard(self) -> bool:
        """Whether z_i is the axis of joint i+1; else of joint i."""
        return self.convention == "standard"

    def joint(self, i: int) -> int | None:
        """The joint whose axis z_i is, or None: z_n (standard) and z_0 (Craig) lie on no joint."""
        k = self._frame(i) + self.standard
        return k if 1 <= k <= len(self) else None

    def choices(self, i: int) -> Geometry:
        """What the axes leave open for frame i now: the case, the lines, the common normal, and
        origin and x where there is only one.

        Returns
        -------
        Geometry
            See :class:`dhlab.placing.geometry.Geometry`.

        Raises
        ------
        ValueError
            There is no such frame, or another step comes first.

        Examples
        --------
        >>> frames = Placement([([0, 0, 0], [0, 0, 1]), ([0.4, 0, 0.1], [0, 1, 0])], end=np.eye(4))
        >>> found = frames.choices(1)
        >>> found.case, found.origin, abs(found.x)
        ('skew', array([0.4, 0. , 0.1]), array([1., 0., 0.]))
        """
        before = comes_first(self, self._frame(i))
        if before:
            raise ValueError(
                f"Placement.choices: frame {i}: what is open depends on {before}; place it first"
            )
        return open_for(self, i, self.o.get(i))

    def set_z(self, i: int, direction: ArrayLike, point: ArrayLike | None = None) -> Judgement:
        """Lay z_i along a direction.

        Parameters
        ----------
        i : int
            The frame, 0 to n.
        direction : array (3,)
            Of any length, in the base frame.
        point : array (3,), optional
            A point of the line, m: it tells parallel axes apart, and says where a z runs whose line
            is open.

        Returns
        -------
        Judgement
        """
        i = self._frame(i)
        judgement, exact = judge_z(i, self.axes, self.convention, self.reach, direction, point)
        if exact is not None:
            self.z[i], self.points[i] = exact
            self._keep(judgement, self._from(i))
        return judgement

    def set_origin(self, i: int, point: ArrayLike) -> Judgement:
        """Put o_i at a point (m, in the base frame).

        Returns
        -------
        Judgement
        """
        before = comes_first(self, self._frame(i), "o")
        if before:
            first = f"Place {before} first: which point is right depends on it."
            return Judgement(f"o{i}", False, "order", first)
        judgement, exact = judge_origin(open_for(self, i), point)
        if exact is not None:
            self.o[i] = on_next_line(self, i, exact)
            self._keep(judgement, self._from(i))
        return judgement

    def set_x(self, i: int, direction: ArrayLike) -> Judgement:
        """Point x_i along a direction of any length, in the base frame.

        Returns
        -------
        Judgement
        """
        before = comes_first(self, self._frame(i), "x")
        if before:
            return Judgement(f"x{i}", False, "order", f"Place {before} first: x{i} depends on it.")
        judgement, exact = judge_x(open_for(self, i, self.o[i]), self.z[i], direction, len(self))
        if exact is not None:
            self.x[i] = exact
            self._keep(judgement, [i])
        return judgement

    @property
    def missing(self) -> tuple[str, ...]:
        """The steps that are left, in an order in which they can be made: every z, then frame by
        frame the origin and x.
        """
        return tuple(step for step in self._every_step if step not in self._said)

    @property
    def finished(self) -> bool:
        """Whether every frame is placed."""
        return not self.missing

    @property
    def steps(self) -> tuple[str, ...]:
        """What is placed, a sentence each: every z, then frame by frame the origin and x."""
        said = self._said
        return tuple(f"{step}: {said[step].message}" for step in self._every_step if step in said)

    @property
    def placed(self) -> list[list[Any]]:
        """A row [z, origin, x] for each frame, as an exercise takes them: plain numbers, and
        ``...`` for what is not placed yet.
        """
        return [
            [[float(v) for v in part[i]] if i in part else ... for part in (self.z, self.o, self.x)]
            for i in range(len(self) + 1)
        ]

    @property
    def frames(self) -> dict[int, NDArray[np.float64]]:
        """The frames that are placed: {i: pose (4, 4)} in the base frame."""
        return {i: pose(self.x[i], self.z[i], self.o[i]) for i in sorted(self.x)}

    @property
    def arm(self) -> PlacedArm:
        """The finished frames as a PlacedArm: the table, the base and tool that take up what is
        free, the joints' signs, the steps.

        Raises
        ------
        ValueError
            A frame is not finished.
        """
        if not self.finished:
            raise ValueError(
                f"Placement.arm: expected every frame placed, found {len(self.missing)} steps left;"
                f" the next is {self.missing[0]}"
            )
        return placed_arm(self)

    def _from(self, i):
        """Frame i and those after it in that order: the line that a frame's x must meet is that of
        the frame before, so nothing else changes with frame i.
        """
        return range(i, len(self) + 1) if self.standard else range(i, -1, -1)

    @property
    def _every_step(self):
        frames = self._from(0 if self.standard else len(self))  # the line that x_i must meet first
        frame_by_frame = [f"{letter}{i}" for i in frames for letter in "ox"]
        return [f"z{i}" for i in range(len(self) + 1)] + frame_by_frame

    def _frame(self, i):
        if isinstance(i, bool) or not isinstance(i, (int, np.integer)) or not 0 <= i <= len(self):
            raise ValueError(
                f"Placement: expected a frame from 0 to {len(self)}, found {i!r}; frames count"
                " from 0"
            )
        return int(i)

    def _keep(self, judgement, frames):
        """Note a right step; make the steps of some frames exact again, or put away those that no
        longer fit.
        """
        self._said[judgement.step] = judgement
        for i in frames:
            self._again(i, "o", self.o)
            self._again(i, "x", self.x)

    def _again(self, i, letter, placed):
        if i not in placed:
            return
        exact = None
        if not comes_first(self, i, letter):
            if letter == "o":
                judgement, exact = judge_origin(open_for(self, i), placed[i])
            else:
                judgement, exact = judge_x(
                    open_for(self, i, self.o[i]), self.z[i], placed[i], len(self)
                )
        if exact is None:
            del placed[i], self._said[f"{letter}{i}"]
        else:
            placed[i], self._said[f"{letter}{i}"] = exact, judgement
