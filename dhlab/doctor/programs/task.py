"""What a program is asked for: the calls, and what is right in each."""

from functools import cache

import numpy as np

from ...transform import inverse
from .cases import SPECIAL, general_chain, general_row
from .wrong.craig import craig, product_craig
from .wrong.links import standard
from .wrong.products import product

__all__ = ["KINDS", "RIGHT", "Task"]

KINDS = {"dh_transform": standard, "forward_kinematics": product}
RIGHT = {"standard": KINDS, "craig": {"dh_transform": craig, "forward_kinematics": product_craig}}
IN_CRAIG = {"dh_transform": "craig_transform", "forward_kinematics": "craig_kinematics"}
SEED = 4
CALLS = 16
# rows of the chains, so that no program can be right for one length alone
LINKS = (2, 3, 4, 5, 6, 3, 7, 4, 2, 5, 3, 6)
ROW = ("theta", "d", "a", "alpha")
# one number or two at a time, so that half a repair can be seen
SIMPLE = np.array(
    [
        [0.7, 0, 0, 0],
        [0, 0.3, 0, 0],
        [0, 0, 0.4, 0],
        [0, 0, 0, 0.6],
        [0.7, 0, 0.4, 0],
        [0.7, 0, 0, 0.6],
        [0, 0.3, 0, 0.6],
    ]
)


class Task:
    """A kind of program, perhaps for one arm only.

    Parameters
    ----------
    kind : "dh_transform" or "forward_kinematics"
    arm : Arm or None
        Then the calls are with the arm's rows, and its base and tool belong to the pose.
    names : sequence of str
        The arguments that the program takes: of a chain rows and q, q alone, or rows, q, base and
        tool.
    convention : "standard" or "craig"
        Whose link matrix is right.

    Raises
    ------
    ValueError
        A program takes other arguments, or the arm has sliding joints, joints that count
        backwards, or rows of the other convention.
    """

    def __init__(self, kind, arm=None, names=("rows", "q"), convention="standard"):
        self.kind, self.arm, self.lists, self.convention = kind, arm, False, convention
        self.started = 0.0  # s of the processor, when the program was first looked at
        self.names = ROW if kind == "dh_transform" else names
        if kind == "dh_transform":
            self.arm = None
        if self.arm is not None:
            _check(self.arm, convention)

    @property
    def is_chain(self):
        return self.kind == "forward_kinematics"

    @property
    def versions(self):
        """Which wrong versions explain it: a key of ``WRONG_VERSIONS``."""
        return IN_CRAIG[self.kind] if self.convention == "craig" else self.kind

    @property
    def calls(self):
        """The general calls and the special ones: (theta, d, a, alpha) or (rows, q)."""
        return _calls(self.kind) if self.arm is None else _calls_of(self.arm.table.rows)

    @property
    def simple(self):
        """Calls in which most numbers are 0."""
        if not self.is_chain:
            return [tuple(row) for row in SIMPLE]
        if self.arm is None:
            alone = [(row[None] * [0.5, 1, 1, 1], row[:1] * 0.5) for row in SIMPLE[3:]]
            return [*alone, (SIMPLE[4:6], np.zeros(2)), (SIMPLE[5:7], np.array([0.2, -0.4]))]
        n = len(self.arm)
        return [(self.arm.table.rows, q) for q in (np.zeros(n), *(0.7 * np.eye(n)[:5]))]

    def right(self, case):
        """The right answer to a call."""
        T = RIGHT[self.convention][self.kind](*case)
        return T if self.arm is None else self.arm.base @ T @ self.arm.tool

    def bare(self, T):
        """Answers (m, 4, 4) without the arm's base and tool."""
        return T if self.arm is None else inverse(self.arm.base) @ T @ inverse(self.arm.tool)

    def arguments(self, case):
        """What the program is called with."""
        if not self.is_chain:
            return case
        rows, q = (part.tolist() for part in case) if self.lists else case
        if len(self.names) == 4:
            return rows, q, self.arm.base, self.arm.tool
        return (rows, q)[-len(self.names) :]


def _check(arm, convention):
    table, plain = arm.table, arm.coupling is None and np.all(arm.sign == 1)
    if table.convention != convention or "P" in table.joints or not plain:
        raise ValueError(
            f"diagnose_function: expected an arm in the {convention} convention whose joints all"
            f" turn, one by one, and count forwards, found {table.convention}, {table.joints}; the"
            " program is given its rows and q, and nothing else. Name the convention that the"
            ' program is for, such as convention="craig" (--convention craig)'
        )


@cache
def _calls(kind):
    rng = np.random.default_rng(SEED)
    if kind == "dh_transform":
        return [general_row(rng) for _ in range(CALLS)], SPECIAL[kind]
    return [general_chain(rng, n) for n in LINKS], SPECIAL[kind]


def _calls_of(rows):
    rng, n = np.random.default_rng(SEED), len(rows)
    q = [np.zeros(n), *(np.pi / 2 * np.eye(n)), rng.uniform(-7, 7, n)]
    return [(rows, general_chain(rng, n)[1]) for _ in LINKS], [(rows, one) for one in q]
