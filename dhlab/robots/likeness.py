"""Which arm of the library is this table? Up to what a table leaves free, zeros, signs, base, tool
and flange.
"""

from dataclasses import dataclass
from functools import cache

import numpy as np

from ..arm import Arm
from ..geometry.conversion import as_arm
from ..geometry.equivalence import equivalent
from ..geometry.shapes import SameShape, same_shape
from ..geometry.zeros import Rezeroed, rezero
from ..printing import number
from ..table import DHTable
from .entries import entry
from .index import summary, unsigned

__all__ = ["Likeness", "like", "likeness", "words_of"]

EXACT = 1e-6  # m and rad
ROUNDED = 5e-4, np.deg2rad(0.1)  # m, rad: what publishers round away; families differ by more
MILLIMETRES = 20.0  # m; a larger number in a table is no length of an arm


@dataclass(frozen=True)
class Likeness:
    """An arm of the library that a table is: ``name`` for :func:`dhlab.load`, ``length`` (m) and
    ``angle`` (rad) by which the numbers differ at most, ``words`` what else does.

    Examples
    --------
    >>> import dhlab as dh
    >>> print(dh.like(dh.load("ur10_cb.arte").table)[0])
    ur10_cb (Universal Robots UR10 (CB series)): as its table "arte"
    """

    name: str
    title: str
    length: float
    angle: float
    words: str

    def __str__(self) -> str:
        """One line."""
        key, _, table = self.name.partition(".")
        return f'{key} ({self.title}): as its table "{table}"{self.words}'


def like(table: Arm | DHTable) -> list[Likeness]:
    """Which arm of the library this is, up to what a table leaves free, zeros, signs, base and
    tool.

    Parameters
    ----------
    table : Arm or DHTable
        In any convention. Numbers beyond 20 m are taken for millimetres.

    Returns
    -------
    list of Likeness
        The nearest first, one for each arm; empty when there is none. Where one agrees within 1e-6
        m and rad, only those; else within what publishers round away, 0.5 mm and 0.1°.

    Raises
    ------
    ValueError
        Something else than an Arm or a DHTable.

    Notes
    -----
    Compared are the shapes (:mod:`dhlab.geometry.shapes`); of arms with sliding joints, all of the
    table by :func:`dhlab.geometry.zeros.rezero`. What couples joints is not compared.

    Examples
    --------
    >>> import dhlab as dh
    >>> for found in dh.like(dh.load("ur5e").flip_x(2).to("craig").table):
    ...     print(found)
    ur5e (Universal Robots UR5e): as its table "maker"
    >>> dh.like(dh.DHTable.standard([[0, 0.1, 0.2, 90], [0, 0, 0.3, 0]], angle="deg"))
    []
    """
    arm = _in_metres(as_arm(table, "like"))
    found = [near for key, names in _can_be(arm).items() if (near := _nearest(key, names, arm))]
    found.sort(key=lambda near: (round(near.length, 7), len(near.words)))
    exact = [near for near in found if max(near.length, near.angle) < EXACT]
    return exact or found


def _in_metres(arm):
    t = arm.table
    if max(abs(t.a).max(), abs(t.d).max()) <= MILLIMETRES:
        return arm
    table = DHTable(t.convention, t.theta, t.d / 1000, t.a / 1000, t.alpha, t.joints)
    return Arm(table, sign=arm.sign)


def _can_be(arm):
    """The names of the tables that the arm can be at all, by the arm's key: their shapes are near
    its own; a sliding joint leaves it open.
    """
    from . import robots

    known, shapes = _stored(arm.table.joints, tuple(robots()))
    if shapes is not None:
        near = np.abs(shapes - unsigned(arm)).max(axis=1) < 2 * max(ROUNDED)
        known = [known[k] for k in np.flatnonzero(near)]
    names: dict[str, list[str]] = {}
    for key, name in known:
        names.setdefault(key, []).append(name)
    return names


@cache
def _stored(joints, keys):
    """(key, name) of every table of these arms of the library that has these joints, and their
    shapes (k, 3n - 2), None where one slides.
    """
    found = [
        (key, name, said["shape"])
        for key in keys
        for name, said in summary(key)["tables"].items()
        if said["joints"] == joints
    ]
    known = [(key, name) for key, name, _ in found]
    return known, None if "P" in joints or not found else np.array([each[2] for each in found])


def _nearest(key, names, arm):
    """The table of one entry, of those named, that is nearest to the arm, or None."""
    near, title = [], summary(key)["name"]
    for name in names:
        model = entry(key).tables[name]
        same = likeness(model, arm, *ROUNDED)
        if same:
            words = words_of(same, model, arm)
            near.append(Likeness(f"{key}.{name}", title, same.length, same.angle, words))
    return min(near, key=lambda one: (round(one.length, 7), len(one.words)), default=None)


def likeness(a: Arm, b: Arm, length: float, angle: float) -> SameShape | None:
    """How b lies on a; for sliding joints within rounding only.

    Examples
    --------
    >>> import dhlab as dh
    >>> likeness(dh.load("ur5e"), dh.load("ur5e").flip_z(2), 1e-6, 1e-6).length
    0.0
    """
    if a.table.joints != b.table.joints:
        return None
    if "P" not in a.table.joints:
        return same_shape(a, b, length=length, angle=angle)
    zeros = rezero(_uncoupled(a), _uncoupled(b))
    return SameShape(0.0, 0.0, zeros) if zeros else None


def _uncoupled(arm):
    return Arm(arm.table, base=arm.base, tool=arm.tool, sign=arm.sign)


def words_of(same: SameShape, a: Arm, b: Arm) -> str:
    """What separates b from a, to stand behind "the same arm"; empty when nothing does.

    Examples
    --------
    >>> import dhlab as dh
    >>> old, new = dh.load("piper.sdk_old"), dh.load("piper.sdk_new")
    >>> words_of(likeness(old, new, 1e-6, 1e-6), old, new)
    ", base and tool aside; joint 2's zero moved by 2°, joint 3's zero moved by -2°"
    """
    parts = []
    if same.zeros.says_something:
        z = same.zeros
        bare = Rezeroed(z.sign, z.offset, "fixed", "fixed", z.letters)
        parts.append(str(bare))
    if same.length >= EXACT:
        parts.append(f"lengths up to {number(same.length * 1000, 3)} mm apart")
    if same.angle >= EXACT:
        parts.append(f"angles up to {number(np.rad2deg(same.angle), 3)}° apart")
    if not parts and equivalent(a, b):
        return ""
    return ", base and tool aside" + "".join(f"; {part}" for part in parts)
