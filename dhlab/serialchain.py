"""``SerialChain``: what an arm is made of, checked, and what follows from that alone: its poses,
frames and Jacobian. ``Arm`` is a chain that can be asked for more.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .checks import checked_coupling, checked_limits, checked_signs
from .fast.inputs import as_numbers, require_finite
from .fast.paths import Kinematics
from .fast.plain import Plain
from .table import DHTable
from .transform import require_pose

__all__ = ["SerialChain"]


@dataclass(frozen=True, eq=False, repr=False)
class SerialChain:
    """The parts of an :class:`dhlab.Arm`, which says what each is, and the product of its links."""

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

    @cached_property
    def _kinematics(self):
        """What the fast paths keep of this arm; nothing of an arm ever changes."""
        plain = Plain(self.table, self.base, self.tool, self.sign, self.coupling)
        return Kinematics(plain, self.name)

    def _checked(self, q: ArrayLike) -> NDArray[np.float64]:
        """``q`` as floats (..., n), or a sentence."""
        array = as_numbers(q, len(self), self.name)
        require_finite(array)
        return array.astype(float)

    def __eq__(self, other: object) -> bool:
        """The same numbers and signs; whether two arms move alike is answered by
        ``dhlab.equivalent``.
        """
        if not isinstance(other, SerialChain):
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
        return type(self), (
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
