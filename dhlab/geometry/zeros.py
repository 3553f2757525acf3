"""When two arms differ only in where their joints' zeros are, and which way they count: the usual
gap between two publishers.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..arm import Arm
from ..printing import number
from ..table import DHTable
from ..transform import inverse, trans
from .canonical import JointAxes, align, gaps, joint_axes, moved
from .lines import across, angle_about, common_normal

__all__ = ["Rezeroed", "rezero", "with_zeros"]

SAME_ANGLE = 1e-7  # rad
SAME_LENGTH = 1e-7  # × the size of the arm
SHOWN = 1e-8  # rad or m; a smaller offset is none


@dataclass(frozen=True)
class Rezeroed:
    """``b(q) = base · a(sign · q + offset) · tool``: ``sign`` and ``offset`` (n,), rad or m;
    ``base`` and ``tool`` "fixed" or "free"; ``letters`` are the joints' types."""

    sign: NDArray[np.float64]
    offset: NDArray[np.float64]
    base: str
    tool: str
    letters: str

    @property
    def says_something(self) -> bool:
        """Whether any zero or sign is another at all."""
        return bool((self.sign < 0).any() or (abs(self.offset) > SHOWN).any())

    def __str__(self) -> str:
        """What to change, as the end of a sentence."""
        parts = []
        turned = [str(k) for k, s in enumerate(self.sign, 1) if s < 0]
        if turned:
            parts.append(
                f"joint{'s' * (len(turned) > 1)} {', '.join(turned)} counted the other way"
            )
        offsets = zip(range(1, len(self.letters) + 1), self.offset, self.letters)
        shifts = [
            f"joint {k}'s zero moved by {_amount(x, letter)}"
            for k, x, letter in offsets
            if abs(x) > SHOWN
        ]
        free = " and ".join(name for name in ("base", "tool") if getattr(self, name) == "free")
        return ", ".join(parts + shifts) + (f", and {free} free," if free else "")


def _amount(x, letter):
    value, unit, gap = (np.rad2deg(x), "°", "") if letter == "R" else (x * 1000, "mm", " ")
    return f"{number(value, 4) if abs(value) > 0.01 else f'{value:.2g}'}{gap}{unit}"


def with_zeros(arm: Arm, sign: ArrayLike, offset: ArrayLike) -> Arm:
    """The arm that stands at ``sign · q + offset`` when ``arm`` itself stands at q.

    Examples
    --------
    >>> import dhlab as dh
    >>> arm = dh.load("ur5e")
    >>> moved_zero = with_zeros(arm, [1, 1, 1, 1, 1, -1], [0, 0.5, 0, 0, 0, 0])
    >>> bool(np.allclose(moved_zero.forward([0] * 5 + [0.3]), arm.forward([0, 0.5, 0, 0, 0, -0.3])))
    True
    """
    t, given = arm.table, arm.joint_values(offset)
    theta, d = t.theta + np.where(t.prismatic, 0, given), t.d + np.where(t.prismatic, given, 0)
    table = DHTable(t.convention, theta, d, t.a, t.alpha, t.joints)
    return Arm(
        table,
        base=arm.base,
        tool=arm.tool,
        sign=arm.sign * np.asarray(sign),
        name=arm.name,
        source=arm.source,
        coupling=arm.coupling,
    )


def rezero(a: Arm, b: Arm) -> Rezeroed | None:
    """Signs and zero offsets that make arm a move like arm b, if some do; the fewest changes, base
    and tool fixed when that is enough.

    Joint by joint: the next axis of b is turned about the present axis of a until it lies on a's
    next axis, in either sense. A search that finds nothing proves little where neighbouring axes
    coincide.

    Parameters
    ----------
    a, b : Arm
        With the same joint letters.

    Returns
    -------
    Rezeroed or None

    Examples
    --------
    >>> import dhlab as dh
    >>> print(rezero(dh.load("piper.sdk_old"), dh.load("piper.sdk_new")))
    joint 2's zero moved by 2°, joint 3's zero moved by -2°
    """
    if a.coupling is not None or b.coupling is not None:
        return None  # the search counts joint by joint
    A, B = joint_axes(a), joint_axes(b)
    for base in ("fixed", "free"):
        found = [
            _settled(A, B, signs, offsets, Z, base) for signs, offsets, Z in _search(A, B, base)
        ]
        if found:
            return min(
                found,
                key=lambda r: (
                    r.tool == "free",
                    (r.sign < 0).sum() + (abs(r.offset) > SHOWN).sum(),
                ),
            )
    return None


def _search(A, B, base):
    """Every (signs, offsets of joints 1 … n-1, Z) for which all axes of b, moved along, lie on
    those of a.
    """
    same = SAME_LENGTH * max(A.reach, 1e-3)
    states = list(_starts(A, B, base, same))
    for i in range(1, len(A.letters)):
        states = [
            (s + [sign], o + [offset], screw(A, i - 1, offset) @ Z)
            for s, o, Z in states
            for sign in (1.0, -1.0)
            for offset in _offset(A, moved(Z, B), i, sign, same)
        ]
    return states


def _starts(A, B, base, same):
    """First axis on first axis; with the base free, what lays the first two axes on each other goes
    into the base.
    """
    for sign in (1.0, -1.0):
        if base == "fixed":
            angle, distance = gaps(A, _counted(B, 0, sign))
            if angle[0] < SAME_ANGLE and distance[0] < same:
                yield [sign], [], np.eye(4)
        elif len(A.letters) > 1:
            for second in (1.0, -1.0):
                turned = _counted(_counted(B, 0, sign), 1, second)
                Z = align(A, turned, 2)
                angle, distance = gaps(A, moved(Z, turned))
                if (angle[:2] < SAME_ANGLE).all() and (distance[:2] < same).all():
                    yield [sign], [], Z


def _counted(axes, i, sign):
    z = axes.z.copy()
    z[i] *= sign
    return type(axes)(axes.p, z, axes.end, axes.letters, axes.reach, axes.largest)


def _offset(A, M, i, sign, same):
    """The offset of joint i-1 (0-based) that carries axis i of M onto axis i of A, as a list of
    none or one.
    """
    z, p = A.z[i - 1], A.p[i - 1]
    there, here = M.z[i] * sign, A.z[i]
    if abs(z @ there - z @ here) > SAME_ANGLE:
        return []
    slides, loose = A.letters[i - 1] == "P", A.letters[i] == "P"
    crossing = np.linalg.norm(np.cross(z, here)) > 1e-6
    x_there, x_here = (
        _across(p, z, M.p[i], there, crossing, loose),
        _across(p, z, A.p[i], here, crossing, loose),
    )
    if slides:
        return _slide_offset(z, here, there, A.p[i], M.p[i], crossing, loose, same)
    if np.linalg.norm(x_here) < same or np.linalg.norm(x_there) < same:
        offset = 0.0
    else:
        offset = float(
            angle_about(z, x_there / np.linalg.norm(x_there), x_here / np.linalg.norm(x_here))
        )
    return [offset] if _lands(A, M, i, sign, offset, same) else []


def _across(p, z, q, w, crossing, loose):
    """What the turn about (p, z) has to bring round: the direction across z, or the way across when
    the axes are parallel.
    """
    if crossing:
        return across(w, z)
    return np.zeros(3) if loose else across(q - p, z)


def _slide_offset(z, here, there, q_here, q_there, crossing, loose, same):
    if np.linalg.norm(here - there) > SAME_ANGLE:
        return []
    if loose or not crossing:
        return [0.0] if loose or np.linalg.norm(across(q_here - q_there, z)) < same else []
    return [float(common_normal(q_there, z, q_here, here).out)]


def _lands(A, M, i, sign, offset, same):
    angle, distance = gaps(A, _counted(moved(screw(A, i - 1, offset), M), i, sign))
    return angle[i] < 10 * SAME_ANGLE and distance[i] < 10 * same


def screw(A: JointAxes, i: int, q: float) -> NDArray[np.float64]:
    """The motion of joint i (0-based) of A by q, from the zero pose; (4, 4)."""
    if A.letters[i] == "P":
        return trans(A.z[i] * q)
    K = np.cross(np.eye(3), A.z[i])  # K v = z × v
    T = np.eye(4)
    T[:3, :3] = np.eye(3) + np.sin(q) * K + (1 - np.cos(q)) * K @ K
    T[:3, 3] = A.p[i] - T[:3, :3] @ A.p[i]
    return T


def _settled(A, B, signs, offsets, Z, base):
    """The last joint's offset from the end poses, if one brings them together; the tool is free
    otherwise. What turned b onto a turns a back.
    """
    end, target = Z @ B.end, A.end
    n = len(A.letters) - 1
    for q in _last_offsets(A, n, end, target):
        if np.abs(
            inverse(screw(A, n, q) @ end) @ target - np.eye(4)
        ).max() < 10 * SAME_LENGTH * max(A.reach, 1e-3):
            return Rezeroed(np.array(signs), -np.array([*offsets, q]), base, "fixed", A.letters)
    return Rezeroed(np.array(signs), -np.array([*offsets, 0.0]) + 0.0, base, "free", A.letters)


def _last_offsets(A, n, end, target):
    if A.letters[n] == "P":
        return [float((target[:3, 3] - end[:3, 3]) @ A.z[n])]
    side = end[:3, np.argmin(abs(end[:3, :3].T @ A.z[n]))]
    aim = target[:3, np.argmin(abs(end[:3, :3].T @ A.z[n]))]
    return [float(angle_about(A.z[n], across(side, A.z[n]), across(aim, A.z[n])))]
