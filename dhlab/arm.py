"""``Arm``: a DH table with what the table alone does not say: base, tool, joint signs, coupled
joints, limits, a name and a source.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import kinematics
from .checks import checked_coupling, checked_limits, checked_ranges, checked_signs
from .fast.inputs import as_numbers, require_finite
from .fast.paths import Kinematics
from .fast.plain import Plain
from .table import DHTable
from .transform import require_pose

if TYPE_CHECKING:
    from .inverse.solutions import Solutions

__all__ = ["Arm"]


@dataclass(frozen=True, eq=False, repr=False)
class Arm:
    """A serial arm: ``base · A_1 … A_n · tool`` with joint variable ``theta_i`` (or ``d_i``) ``=
    sign_i · q_i + offset_i``; where joints are coupled, ``coupling @ (sign · q) + offset``.

    Parameters
    ----------
    table : DHTable
    base, tool : (4, 4), optional
        The table's frame 0 in the world, and the end point in frame n; the identity when left out.
    limits : sequence of n entries, optional
        ``(low, high)`` in radians or metres, or None, per joint. Stated, never enforced by
        :meth:`forward`.
    sign : sequence of n numbers +1 or -1, optional
        How each joint counts; +1 when left out.
    name, source : str, optional
        What the arm is called and where its numbers come from.
    coupling : (n, n), optional
        What the controller counts is not always a joint's angle: where motor 2 carries the linkage
        of joint 3 along (Fanuc, parallelogram arms), or two motors drive a wrist together, row i
        says what joint i makes of each number of q. In radians and metres; each joint its own when
        left out. ``limits`` stay limits of q.

    Raises
    ------
    ValueError
        One sentence: which part, what was expected, what was found.

    Examples
    --------
    >>> table = DHTable.standard([[0, 0.1, 0, 90], [0, 0, 0.4, 0]], angle="deg")
    >>> arm = Arm(table, name="two links")
    >>> arm.forward([0, 0])[:3, 3]
    array([0.4, 0. , 0.1])
    >>> parallelogram = Arm(table, coupling=[[1, 0], [-1, 1]])  # link 2 keeps its direction
    >>> parallelogram.forward([0.5, 0])[:3, 3].round(3) + 0
    array([ 0.308,  0.168, -0.092])
    """

    table: DHTable
    base: NDArray[np.float64] = None  # type: ignore[assignment]  # the identity
    tool: NDArray[np.float64] = None  # type: ignore[assignment]  # the identity
    limits: Sequence[tuple[float, float] | None] | None = None
    sign: NDArray[np.float64] = None  # type: ignore[assignment]  # all +1
    name: str = ""
    source: str = ""
    coupling: NDArray[np.float64] | None = None

    if TYPE_CHECKING:  # what may be given; the fields above are what it becomes

        def __init__(
            self,
            table: DHTable,
            base: ArrayLike | None = None,
            tool: ArrayLike | None = None,
            limits: Sequence[tuple[float, float] | None] | None = None,
            sign: ArrayLike | None = None,
            name: str | None = "",
            source: str | None = "",
            coupling: ArrayLike | None = None,
        ) -> None: ...

    def __post_init__(self) -> None:
        if not isinstance(self.table, DHTable):
            raise ValueError(
                f"Arm: expected a DHTable first, found {type(self.table).__name__}; make one with"
                " DHTable.standard or DHTable.craig"
            )
        n = len(self.table)
        for name in ("base", "tool"):
            given = getattr(self, name)
            pose = np.eye(4) if given is None else require_pose(given, f"Arm: {name}")
            pose.flags.writeable = False
            object.__setattr__(self, name, pose)
        object.__setattr__(self, "sign", checked_signs(self.sign, n))
        object.__setattr__(self, "coupling", checked_coupling(self.coupling, n))
        object.__setattr__(self, "limits", checked_limits(self.limits, n))
        for name in ("name", "source"):
            given = getattr(self, name)
            if given is not None and not isinstance(given, str):
                raise ValueError(f"Arm: {name}: expected text, found {type(given).__name__}")
            object.__setattr__(self, name, given or "")

    @classmethod
    def load(cls, path: str | Path) -> Arm:
        """The arm in a ``.yaml`` or ``.csv`` table file; ``dhlab.load`` takes names of the library
        too.
        """
        from .formats.tablefile import read_arm

        return read_arm(path)

    def save(
        self,
        path: str | Path,
        *,
        angle: str | None = None,
        length: str = "m",
        overwrite: bool = False,
    ) -> None:
        """Write the arm as ``.yaml`` (all of it) or ``.csv`` (table and signs; refused when there
        is more to say).

        Parameters as :meth:`DHTable.save`.
        """
        from .formats.tablefile import write

        write(path, self, angle=angle, length=length, overwrite=overwrite)

    def __len__(self) -> int:
        """The number of joints."""
        return len(self.table)

    def forward(self, q: ArrayLike, out: NDArray[Any] | None = None) -> NDArray[np.float64]:
        """End pose, tool included.

        Parameters
        ----------
        q : array (..., n)
            Radians (revolute) or metres (prismatic).
        out : array (..., 4, 4), optional
            Where to write the result, float64 or float32; a new array when left out.

        Returns
        -------
        array (..., 4, 4)
            Of single precision when q is (computed in double, rounded once), of double otherwise.

        Examples
        --------
        >>> import dhlab as dh
        >>> dh.load("article-6r").forward([0] * 6)[:3, 3].round(6)
        array([ 0.75, -0.2 ,  0.1 ])
        """
        return self._kinematics.forward(q, out)

    def frames(self, q: ArrayLike, out: NDArray[Any] | None = None) -> NDArray[np.float64]:
        """Every frame of the chain; ``frames[0]`` is the base, ``frames[i] = base · A_1 … A_i``;
        the tool is not included.

        Parameters
        ----------
        q : array (..., n)
            Radians or metres.
        out : array (..., n + 1, 4, 4), optional
            Where to write the result, float64 or float32; a new array when left out.

        Returns
        -------
        array (..., n + 1, 4, 4)

        Examples
        --------
        >>> import dhlab as dh
        >>> dh.load("article-6r").frames([0] * 6).shape
        (7, 4, 4)
        """
        return self._kinematics.frames(q, out)

    def links(self, q: ArrayLike) -> NDArray[np.float64]:
        """Every link matrix ``A_i`` at ``q`` (..., n); returns (..., n, 4, 4).

        Examples
        --------
        >>> import dhlab as dh
        >>> dh.load("article-6r").links([0] * 6)[1, 0, 3]
        np.float64(0.4)
        """
        return self._kinematics.plain.links(self._checked(q))

    def jacobian(self, q: ArrayLike, out: NDArray[Any] | None = None) -> NDArray[np.float64]:
        """Geometric Jacobian at the end point (tool included), in the frame :meth:`forward` uses.

        Parameters
        ----------
        q : array (..., n)
            Radians or metres.
        out : array (..., 6, n), optional
            Where to write the result, float64 or float32; a new array when left out.

        Returns
        -------
        array (..., 6, n)
            Rows v then ω, per unit of each number of q.

        Examples
        --------
        >>> import dhlab as dh
        >>> int(np.linalg.matrix_rank(dh.load("article-6r").jacobian([0] * 6)))
        4
        """
        return self._kinematics.jacobian(q, out)

    @cached_property
    def _kinematics(self):
        """What the fast paths keep of this arm; nothing of an arm ever changes."""
        plain = Plain(self.table, self.base, self.tool, self.sign, self.coupling)
        return Kinematics(plain, self.name)

    def solve(
        self,
        T: ArrayLike,
        *,
        limits: bool = False,
        near: ArrayLike | None = None,
        redundancy: Any = None,
        tolerance: float = 1e-9,
        method: str | None = None,
    ) -> Solutions | Any:
        """The configurations that bring the end to a pose: the way back from :meth:`forward`.

        Parameters
        ----------
        T : array (4, 4) or (m, 4, 4)
            A pose of the end, tool included, in the frame that :meth:`forward` uses; or many. Its
            rotation is made exact first.
        limits : bool
            Only what keeps the arm's stated limits.
        near : array (n,), optional
            Where the arm stands: the solution nearest to it comes first.
        redundancy : number, sequence or dict, optional
            For more than six joints, where one is held (radians): a value or several, or ``{joint
            from 1: value or values}``. Left out, seven joints hold the usual one where it stands in
            ``near``, in the middle of its range, or at the first value from there that serves.
        tolerance : float
            Metres and radians by which the end may miss; each solution says how much it does.
        method : "closed form" or "search", optional
            Left out: in closed form where there is one (with the extra ``[ik]``), else by search.

        Returns
        -------
        dhlab.inverse.Solutions
            A sequence of q (n,), true when there is one; without one, its ``reason`` and
            ``nearest`` say why and what comes nearest. A list of them for many poses.

        Examples
        --------
        >>> import dhlab as dh
        >>> arm = dh.load("ur5e")
        >>> if answer := arm.solve(arm.forward([0.1, -1, 1, 0.4, 0.5, 0.6])):
        ...     print(len(answer), answer[0].round(6))
        8 [ 0.1 -1.   1.   0.4  0.5  0.6]
        """
        from .inverse import solve

        return solve(
            self,
            T,
            limits=limits,
            near=near,
            redundancy=redundancy,
            tolerance=tolerance,
            method=method,
        )

    def to(self, convention: str) -> Arm:
        """The same arm with its table in another convention, ``"standard"`` or ``"craig"``; base
        and tool take up the difference.

        Examples
        --------
        >>> import dhlab as dh
        >>> dh.load("panda").to("standard").table.convention
        'standard'
        """
        from .geometry.conversion import to_convention

        return to_convention(self, convention)

    def flip_x(self, i: int) -> Arm:
        """The same arm with x_i turned round (frame i, 0 to n): theta_i and theta_{i+1} by 180°,
        a_i and alpha_i change sign.

        Examples
        --------
        >>> import dhlab as dh
        >>> dh.load("ur5e").flip_x(2).table.a
        array([ 0.    ,  0.425 , -0.3922,  0.    ,  0.    ,  0.    ])
        """
        from .geometry.freedoms import flip_x

        return flip_x(self, i)

    def flip_z(self, i: int) -> Arm:
        """The same arm with z_i turned round (frame i, 0 to n): the joint on z_i counts the other
        way.

        Examples
        --------
        >>> import dhlab as dh
        >>> dh.load("ur5e").flip_z(2).sign
        array([ 1.,  1., -1.,  1.,  1.,  1.])
        """
        from .geometry.freedoms import flip_z

        return flip_z(self, i)

    def slide(self, i: int, h: float) -> Arm:
        """The same arm with o_i moved by ``h`` metres along z_i, where the axes on both sides are
        parallel (a ValueError elsewhere).

        Examples
        --------
        >>> import dhlab as dh
        >>> dh.load("ur5e").slide(3, 0.1333).table.d
        array([0.1625, 0.    , 0.1333, 0.    , 0.0997, 0.0996])
        """
        from .geometry.freedoms import slide

        return slide(self, i, h)

    def joint_values(self, q: ArrayLike) -> NDArray[np.float64]:
        """What ``q`` (..., n) makes of the joints, before the offsets of the table: sign · q, and
        ``coupling @ (sign · q)`` where the joints are coupled; (..., n).

        Examples
        --------
        >>> import dhlab as dh
        >>> dh.load("ur5e").flip_z(2).joint_values([0, 0, 0.5, 0, 0, 0])
        array([ 0. ,  0. , -0.5,  0. ,  0. ,  0. ])
        """
        return self._kinematics.plain.joint_values(self._checked(q))

    def workspace(self, n: int = 100_000, seed: int = 0) -> NDArray[np.float64]:
        """Where the end can be: its positions at joint values drawn at random, each evenly from its
        limits; ``view.workspace`` draws them.

        Parameters
        ----------
        n : int
            How many.
        seed : int
            The same seed draws the same joint values.

        Returns
        -------
        array (n, 3)
            Metres, in the frame that :meth:`forward` uses. A turning joint without limits is drawn
            from a whole turn, -180° to 180°.

        Raises
        ------
        ValueError
            A number that is none, or a sliding joint without limits.

        Examples
        --------
        >>> import dhlab as dh
        >>> points = dh.load("ur5e").workspace(20_000)
        >>> points.shape, float(np.linalg.norm(points - [0, 0, 0.1625], axis=1).max().round(2))
        ((20000, 3), 0.97)
        """
        low, high = checked_ranges(self.limits, self.table.joints, n, "workspace")
        q = np.random.default_rng(seed).uniform(low, high, (n, len(self)))
        return self.forward(q)[:, :3, 3].copy()

    def manipulability(self, q: ArrayLike) -> NDArray[np.float64]:
        """How far the end is from a singular pose, where it is 0: the square root of det(J Jᵀ).

        Parameters
        ----------
        q : array (..., n)
            Radians or metres.

        Returns
        -------
        array (...)
            See :func:`dhlab.kinematics.manipulability`. It mixes metres and radians, so compare it
            within one arm only.

        Examples
        --------
        >>> import dhlab as dh
        >>> arm = dh.load("ur5e")
        >>> float(arm.manipulability([0, -1.5, 1.5, 0, 1.5, 0]).round(4))
        0.07
        >>> bool(arm.manipulability([0, -1.5, 0, 0, 1.5, 0]) < 1e-12)  # the elbow is stretched
        True
        """
        return kinematics.manipulability(self.jacobian(q))

    def within_limits(self, q: ArrayLike) -> NDArray[np.bool_]:
        """Which joints are inside their stated limits: booleans of the shape of ``q``; a joint
        without limits always is.

        Examples
        --------
        >>> import dhlab as dh
        >>> dh.load("panda").within_limits([0] * 7).tolist()
        [True, True, True, False, True, True, True]
        """
        q = self._checked(q)
        bounds = [
            (-np.inf, np.inf) if pair is None else pair
            for pair in self.limits or [None] * len(self)
        ]
        low, high = np.array(bounds).T
        return (low <= q) & (q <= high)

    def _checked(self, q: ArrayLike) -> NDArray[np.float64]:
        """``q`` as floats (..., n), or a sentence."""
        array = as_numbers(q, len(self), self.name)
        require_finite(array)
        return array.astype(float)

    def __eq__(self, other: object) -> bool:
        """The same numbers and signs; whether two arms move alike is answered by
        ``dhlab.equivalent``.
        """
        if not isinstance(other, Arm):
            return NotImplemented
        arrays = (
            (getattr(self, k), getattr(other, k)) for k in ("base", "tool", "sign", "coupling")
        )
        return (
            self.table == other.table
            and self.limits == other.limits
            and all(x is y or np.array_equal(x, y) for x, y in arrays)
        )

    def __hash__(self) -> int:
        return hash((self.table, self.base.tobytes(), self.tool.tobytes()))

    def __reduce__(self) -> tuple[type, tuple[object, ...]]:
        return Arm, (
            self.table,
            self.base,
            self.tool,
            self.limits,
            self.sign,
            self.name,
            self.source,
            self.coupling,
        )

    def __repr__(self) -> str:
        return f"<Arm {self.name or 'without a name'}: {len(self)} joints, {self.table.convention}>"

    def __str__(self) -> str:
        from .printing import arm_text

        return arm_text(self)

    def _repr_html_(self) -> str:
        from .printing import arm_html

        return arm_html(self)

    def _repr_mimebundle_(self, include: Any = None, exclude: Any = None) -> Any:
        from .view.explorer import arm_bundle

        return arm_bundle(self)
