"""Whether two arms move alike; and joint by joint, where they do not."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ...arm import Arm
from ...printing import number
from ...table import DHTable
from ...transform import inverse, trans_z
from ..canonical import JointAxes, joint_axes
from ..conversion import as_arm
from ..equivalence import equivalent
from ..freechoices import turn_of
from .comparison import SAME_ANGLE, Comparison, EndCompared, JointCompared
from .matching import matched, wrapped
from .walk import Link, Walk, cases_of

__all__ = ["compare"]

SAMPLES = 200  # random configurations
UNLIKE = ("count", "type")


def compare(a: Arm | DHTable, b: Arm | DHTable) -> Comparison:
    """Two arms side by side: the same motion or not, and joint by joint how each counts, where its
    zero is, and its lengths and angles; base and tool apart.

    Both are told in the same choice of frames, so that what merely is another right table for the
    same arm does not show. Where two axes are nearly parallel in one of the arms, both are told in
    Hayati's parameters there.

    Parameters
    ----------
    a, b : Arm or DHTable
        In any conventions. A table alone has no base, tool or reversed joints.

    Returns
    -------
    Comparison
        True where the motion is the same; a table when printed; ``kind``, ``joints``, ``base``,
        ``tool`` for a program.

    Raises
    ------
    ValueError
        Something else than an Arm or DHTable.

    Examples
    --------
    >>> import dhlab as dh
    >>> print(compare(dh.load("piper"), dh.load("piper.sdk_old")))  # doctest: +ELLIPSIS
    The same lengths and angles; what differs: joint 2's zero (by -2°), joint 3's zero (by +2°).
    <BLANKLINE>
    a: AgileX PiPER
    b: AgileX PiPER (sdk_old)
    (told in one choice of frames; a table's own may turn x or z round)
     joint  counts  zero  d (mm)  a (mm)   alpha (deg)
     1      same    same  123     0        ...
    """
    one, other = as_arm(a, "compare"), as_arm(b, "compare")
    verdict = equivalent(one, other)
    names = one.name or "table a", other.name or "table b"
    if verdict.reason in UNLIKE:
        return Comparison("joints", verdict.message, names, (), None, None, None, None, verdict)
    A, B = joint_axes(one), joint_axes(other)
    cases = cases_of(A, B)
    in_a, in_b, senses, way_a, way_b = matched(A, B, cases)
    joints = tuple(
        _joint(k, letter, *pair)
        for k, (letter, *pair) in enumerate(zip(A.letters, in_a, in_b, senses), 1)
    )
    ends = _Ends(A, B, way_a, way_b, senses)
    kind = _kind(verdict, one, other, joints)
    return Comparison(
        kind,
        _message(kind, verdict, joints, ends),
        names,
        joints,
        _gap(ends.base_a, ends.base_b),
        _gap(ends.tool_a, ends.tool_b),
        _apart(one, other),
        _apart_matched(one, other, joints, ends),
        verdict,
    )


class _Ends:
    """Base and tool of both: frame 0 in the base, the end in frame n, with x and z alike."""

    def __init__(
        self, A: JointAxes, B: JointAxes, way_a: Walk, way_b: Walk, senses: NDArray[np.float64]
    ) -> None:
        self.base_a, self.tool_a = _ends(A, way_a, np.ones(len(senses)))
        self.base_b, self.tool_b = _ends(B, way_b, senses)


def _ends(A, way, senses):
    first = _frame(way.into[0], way.x[0], A.z[0] * senses[0])
    last = _frame(way.out[-1], way.x[-1], A.z[-1] * senses[-1])
    return first, inverse(last) @ A.end


def _frame(o, x, z):
    T = np.eye(4)
    T[:3, :3] = np.column_stack([x, np.cross(z, x), z])
    T[:3, 3] = o
    return T


def _gap(in_a, in_b):
    D = inverse(in_a) @ in_b
    return EndCompared(float(np.linalg.norm(D[:3, 3])), turn_of(D))


def _joint(k: int, letter: str, in_a: Link, in_b: Link, sense: float) -> JointCompared:
    slides = letter == "P"
    zero = in_b.d - in_a.d if slides else wrapped(in_b.theta - in_a.theta)
    return JointCompared(
        k,
        letter,
        int(sense),
        float(zero),
        None if slides else (in_a.d, in_b.d),
        (in_a.a, in_b.a),
        _near_each_other(in_a.alpha, in_b.alpha),
        _near_each_other(in_a.theta, in_b.theta) if slides else None,
        (in_a.beta, in_b.beta) if max(abs(in_a.beta), abs(in_b.beta)) > SAME_ANGLE else None,
    )


def _near_each_other(in_a, in_b):
    """Two angles, the second within half a turn of the first."""
    return in_a, in_a + wrapped(in_b - in_a)


def _kind(verdict, a, b, joints):
    if verdict:
        return "same"
    if equivalent(a, b, base="free", tool="free"):
        return "ends"
    # what stands in d1 and in d of the last joint may as well stand in base and tool
    ends = {(1, "d"), (len(joints), "d")}
    found = {(joint.joint, name) for joint in joints for name in joint.lengths()}
    return "zeros" if found <= ends and verdict.reason != "coupling" else "lengths"


def _message(kind, verdict, joints, ends):
    if kind == "same":
        return verdict.message
    said = _counting(joints) + _lengths(joints)
    for name, gap in (
        ("the base", _gap(ends.base_a, ends.base_b)),
        ("the tool", _gap(ends.tool_a, ends.tool_b)),
    ):
        said += [f"{name} ({gap})"] if not gap.same else []
    if verdict.reason == "coupling":
        said.insert(0, "how the joints are coupled")
    begin = {
        "ends": "The same arm up to base and tool",
        "zeros": "The same lengths and angles",
        "lengths": "Not the same arm",
    }[kind]
    listed = ", ".join(said) or "less than a ten-thousandth of a millimetre and degree"
    return f"{begin}; what differs: {listed}."


def _counting(joints):
    said = [f"joint {joint.joint} counts the other way" for joint in joints if joint.sense < 0]
    said += [f"joint {joint.joint}'s zero (by {joint.moved})" for joint in joints if joint.moved]
    return said


def _lengths(joints):
    """Every length and angle that differs, by how much."""
    said = []
    for joint in joints:
        for name, gap in joint.lengths().items():
            amount = (
                f"{number(gap * 1e3, 4)} mm"
                if name in ("d", "a")
                else f"{number(np.rad2deg(gap), 4)}°"
            )
            said.append(f"{name}{joint.joint} by {amount}")
    return said


def _apart(a, b):
    q = _configurations(a)
    return _largest(a.forward(q), b.forward(q))


def _apart_matched(a, b, joints, ends):
    """With what counts otherwise, base and tool taken for a's."""
    if a.coupling is not None or b.coupling is not None:
        return None
    q = _configurations(a)
    senses, zeros = (np.array([getattr(j, what) for j in joints]) for what in ("sense", "zero"))
    # a shift along the first or last axis is base's or tool's as well as d's
    first, last = (_along(pair) for pair in (joints[0].d, joints[-1].d))
    last = last if len(joints) > 1 else np.eye(4)
    X = ends.base_a @ first @ inverse(ends.base_b)
    Y = inverse(ends.tool_b) @ last @ ends.tool_a
    return _largest(a.forward(q), X @ b.forward((q - zeros) * senses) @ Y)


def _along(d):
    return trans_z(d[0] - d[1]) if d else np.eye(4)


def _largest(T, U):
    D = inverse(T) @ U
    return (
        float(np.linalg.norm(D[:, :3, 3], axis=1).max()),
        float(max(turn_of(each) for each in D)),
    )


def _configurations(arm: Arm) -> NDArray[np.float64]:
    """Random joint values, within the limits where they are stated."""
    limits = arm.limits or [None] * len(arm)
    low, high = np.array(
        [
            pair or ((0.0, 0.5) if letter == "P" else (-np.pi, np.pi))
            for pair, letter in zip(limits, arm.table.joints)
        ]
    ).T
    return np.random.default_rng(0).uniform(low, high, (SAMPLES, len(arm)))
