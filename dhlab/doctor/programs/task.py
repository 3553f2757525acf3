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
OF_ANOTHER = "arm_kinematics"
IN_CRAIG = {"dh_transform": "craig_transform", "forward_kinematics": "craig_kinematics"}
SEED = 4
CALLS = 16
SLIDE = 0.2  # m for a radian: how far sliding joints move
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
        The arguments that the program takes: of a chain rows and q, q alone or joint by joint (q1,
        q2, …), or rows, q, base and tool.
    convention : "standard" or "craig"
        Whose link matrix is right.

    Raises
    ------
    ValueError
        A program that is given the arm's rows: it has sliding joints, joints that count backwards,
        or rows of the other convention.
    """

    def __init__(self, kind, arm=None, names=("rows", "q"), convention="standard"):
        self.kind, self.arm, self.lists, self.convention = kind, arm, False, convention
        self.plain = True  # whether rows and q are all there is to the arm
        self.clock = None  # a Budget, from when the program is first looked at
        self.kept = 0.0  # s that are kept for the last thing that is tried
        self.names = ROW if kind == "dh_transform" else names
        if kind == "dh_transform":
            self.arm = None
        if self.arm is not None:
            self.plain = _is_plain(self.arm, convention)
            if not self.plain and "rows" in self.names:
                raise ValueError(_other_arm(self.arm, convention))

    @property
    def is_chain(self):
        return self.kind == "forward_kinematics"

    @property
    def versions(self):
        """Which wrong versions explain it: a key of ``WRONG_VERSIONS``, or of nothing there."""
        if not self.plain:
            return OF_ANOTHER
        return IN_CRAIG[self.kind] if self.convention == "craig" else self.kind

    @property
    def calls(self):
        """The general calls and the special ones: (theta, d, a, alpha) or (rows, q)."""
        return _calls(self.kind) if self.arm is None else _calls_of(self.arm.table)

    @property
    def simple(self):
        """Calls in which most numbers are 0."""
        if not self.is_chain:
            return [tuple(row) for row in SIMPLE]
        if self.arm is None:
            alone = [(row[None] * [0.5, 1, 1, 1], row[:1] * 0.5) for row in SIMPLE[3:]]
            return [*alone, (SIMPLE[4:6], np.zeros(2)), (SIMPLE[5:7], np.array([0.2, -0.4]))]
        n = len(self.arm)
        return [(self.arm.table.rows, q) for q in (np.zeros(n), *(0.7 * np.eye(n)))]

    def right(self, case):
        """The right answer to a call."""
        if self.arm is not None:
            return self.arm.forward(case[-1])
        return RIGHT[self.convention][self.kind](*case)

    def bare(self, T):
        """Answers (m, 4, 4) without the arm's base and tool."""
        return T if self.arm is None else inverse(self.arm.base) @ T @ inverse(self.arm.tool)

    def arguments(self, case):
        """What the program is called with."""
        if not self.is_chain:
            return case
        rows, q = (part.tolist() for part in case) if self.lists else case
        if "q1" in self.names:
            return tuple(q)
        if len(self.names) == 4:
            return rows, q, self.arm.base, self.arm.tool
        return (rows, q)[-len(self.names) :]


def _is_plain(arm, convention):
    """Whether rows of this convention and q, angles that count forwards, are all there is."""
    one_by_one = arm.coupling is None and np.all(arm.sign == 1)
    return arm.table.convention == convention and "P" not in arm.table.joints and one_by_one


def _other_arm(arm, convention):
    return (
        f"diagnose_function: expected an arm in the {convention} convention whose joints all turn,"
        f" one by one, and count forwards, found {arm.table.convention}, {arm.table.joints}; the"
        " program is given its rows and q, and nothing else. Name the convention that the program"
        ' is for, such as convention="craig" (--convention craig), or hand in a program that knows'
        " its rows and takes q alone"
    )


@cache
def _calls(kind):
    rng = np.random.default_rng(SEED)
    if kind == "dh_transform":
        return [general_row(rng) for _ in range(CALLS)], SPECIAL[kind]
    return [general_chain(rng, n) for n in LINKS], SPECIAL[kind]


def _calls_of(table):
    rng, n = np.random.default_rng(SEED), len(table)
    size = np.where([letter == "P" for letter in table.joints], SLIDE, 1)
    q = [np.zeros(n), *(np.pi / 2 * np.eye(n)), rng.uniform(-7, 7, n)]
    general = [(table.rows, size * general_chain(rng, n)[1]) for _ in LINKS]
    return general, [(table.rows, size * one) for one in q]
