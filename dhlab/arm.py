"""``Arm``: a DH table with what the table alone does not say: base, tool, joint signs, coupled
joints, limits, a name and a source; and what it can be asked beyond the product of its links, with
the doors to the rooms that answer.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import kinematics
from .checks import checked_ranges
from .serialchain import SerialChain

if TYPE_CHECKING:
    from .inverse.solutions import Solutions

__all__ = ["Arm"]


@dataclass(frozen=True, init=False, eq=False, repr=False)
class Arm(SerialChain):
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
    >>> from dhlab import Arm, DHTable
    >>> table = DHTable.standard([[0, 0.1, 0, 90], [0, 0, 0.4, 0]], angle="deg")
    >>> arm = Arm(table, name="two links")
    >>> arm.forward([0, 0])[:3, 3]
    array([0.4, 0. , 0.1])
    >>> parallelogram = Arm(table, coupling=[[1, 0], [-1, 1]])  # link 2 keeps its direction
    >>> parallelogram.forward([0.5, 0])[:3, 3].round(3) + 0
    array([ 0.308,  0.168, -0.092])
    """

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

    def _repr_mimebundle_(self, include: Any = None, exclude: Any = None) -> Any:
        from .view.explorer import arm_bundle

        return arm_bundle(self)
