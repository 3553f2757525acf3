"""Every solution of six turning joints in closed form, by the library ssik (extra ``[ik]``)."""

from dataclasses import dataclass
from functools import lru_cache
from importlib.util import find_spec
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..arm import Arm
from ..table import DHTable
from ..transform import inverse
from . import prepared
from .joints import wrapped

__all__ = ["ClosedForm", "closed_form", "installed"]

# ssik 8.2 takes some chains and then refuses them while solving ("spherical requires the
# intersecting-axis triple at joints (3, 4, 5); got (1, 2, 3)"): no solution from it, then
REFUSALS = (ValueError, ArithmeticError, LookupError, RuntimeError, TypeError)
NOTHING = 1e-12  # of a direction or of the arm's length: rounding, taken for 0
KNOWN = 1e-6  # rad: a solution that is known was met


def installed() -> bool:
    """Whether the library is there."""
    return find_spec("ssik") is not None


@dataclass(frozen=True)
class ClosedForm:
    """Six turning joints as ssik knows them.

    Parameters
    ----------
    free : array (6,)
        Which joints these are, counted from 0.
    held : tuple of (joint, value)
        The other joints and their joint variables.
    count : int
        The joints of the whole arm.
    zero : array (4, 4)
        The end pose in frame 0, without the tool, with the free joints at 0.
    turned : bool
        The chain was handed over from its end to its base, which has a simpler solution.
    solver : ssik.Manipulator
    """

    free: NDArray[np.int64]
    held: tuple[tuple[int, float], ...]
    count: int
    zero: NDArray[np.float64]
    turned: bool
    solver: Any  # its library is an extra

    @property
    def name(self) -> str:
        """What ssik calls the kind of solution."""
        return self.solver.solver_name.removeprefix("ikgeo.")

    @property
    def general(self) -> bool:
        """True when no two axes meet or run parallel in a way that helps: ssik then has to derive
        the equations of this arm first, which takes minutes.
        """
        return self.solver.dispatch_plan.needs_symbolic_precompute

    def solve(self, T_0n: NDArray[np.float64]) -> NDArray[np.float64]:
        """Joint variables (k, n) that bring frame n to the pose ``T_0n`` (4, 4) in frame 0, as ssik
        gives them: not verified yet.
        """
        target = inverse(T_0n) if self.turned else np.array(T_0n)
        target[:3, :3] = target[:3, :3] @ self.zero[:3, :3].T
        try:
            found = self.solver.solve(target, respect_limits=False)
        except REFUSALS:
            found = []
        angles = np.reshape([solution.q for solution in found], (-1, len(self.free)))
        v = np.zeros((len(angles), self.count))
        for joint, value in self.held:
            v[:, joint] = value
        v[:, self.free] = angles[:, ::-1] if self.turned else angles
        return v


@lru_cache(maxsize=512)
def closed_form(table: DHTable, held: tuple[tuple[int, float], ...] = ()) -> ClosedForm | None:
    """How ssik solves a table with ``held`` joints fixed, or None when six turning joints are not
    what is left, or ssik is not installed.

    Parameters
    ----------
    table : DHTable
        Of either convention; its offsets count, base and tool are left to who asks.
    held : tuple of (joint from 0, value of its joint variable)

    Returns
    -------
    ClosedForm or None
    """
    fixed = [joint for joint, _ in held]
    free = np.array([joint for joint in range(len(table)) if joint not in fixed], dtype=int)
    if len(free) != 6 or table.prismatic[free].any() or not installed():
        return None
    z, p, zero = _axes(table, free, dict(held))
    back = inverse(zero)
    z_back, p_back = -(z @ back[:3, :3].T)[::-1], (p @ back[:3, :3].T + back[:3, 3])[::-1]
    forms = [
        ClosedForm(free, held, len(table), zero, False, _manipulator(z, p, zero)),
        ClosedForm(free, held, len(table), back, True, _manipulator(z_back, p_back, back)),
    ]
    simple = [form for form in forms if not form.general and _works(form, table)]
    return simple[0] if simple else forms[0] if forms[0].general else None


def _works(form, table):
    """One pose whose solution is known is tried before the chain is trusted."""
    v = np.random.default_rng(1).uniform(-2, 2, form.count)
    for joint, value in form.held:
        v[joint] = value
    found = form.solve(Arm(table).forward(v))
    return bool(len(found)) and np.abs(wrapped(found - v)).max(axis=1).min() < KNOWN


def prepare_table(table):
    """Derive what a general arm needs, once, and keep it on disk; minutes, or nothing to do."""
    form = closed_form(table)
    if form is not None and form.general and not prepared.is_ready(table):
        with prepared.folder_of(table):
            form.solver.prepare()
        prepared.mark(table)


def _axes(table, free, held):
    """The free joints' axes in frame 0 (directions and points) and the end pose, with every free
    joint at 0.
    """
    at = np.array([held.get(joint, 0.0) for joint in range(len(table))])
    chain = Arm(table).frames(at)
    of_joint = chain[:-1] if table.convention == "standard" else chain[1:]
    return of_joint[free, :3, 2], of_joint[free, :3, 3], chain[-1]


def _manipulator(z, p, zero):
    """ssik's arm with these axes; its zero pose has the base's orientation, so that only the axes
    count.
    """
    import ssik

    steps = np.vstack([p[:1], np.diff(p, axis=0), zero[None, :3, 3] - p[-1:]])
    return ssik.Manipulator.from_axes(_cleared(z, 1.0), _cleared(steps, np.abs(steps).max()))


def _cleared(numbers, size):
    """Rounding errors set to 0: parallel axes shall be parallel."""
    return np.where(np.abs(numbers) < NOTHING * size, 0.0, numbers)
