"""Joint axes in space → frames → an ``Arm``, with every step in words: the Denavit-Hartenberg
procedure itself.
"""

import warnings as _warnings
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ...arm import Arm
from ...printing import number
from ...table import CONVENTIONS, DHTable
from ...transform import inverse, require_pose
from .inputs import axes_from, choices_from, signs_from
from .normals import NEARLY, place
from .steps import describe

__all__ = ["assign_frames", "PlacedArm", "NearlyParallelWarning"]

# × the size of the arm; a d beyond it is a run-away common normal, no length of the arm
RUNAWAY = 10.0


class NearlyParallelWarning(UserWarning):
    """Two axes are so nearly parallel that their common normal is far outside the arm, or that they
    had to be taken as parallel.

    Examples
    --------
    >>> import warnings, dhlab as dh
    >>> axes = [([0, 0, 0], [0, 0, 1]), ([0.4, 0, 0], [1e-5, 0, 1])]
    >>> with warnings.catch_warnings(record=True) as said:
    ...     arm = dh.assign_frames(axes, end=dh.transform.trans([0.7, 0, 0]))
    >>> said[0].category.__name__
    'NearlyParallelWarning'
    """


@dataclass(frozen=True, eq=False, repr=False)
class PlacedArm(Arm):
    """An Arm from :func:`assign_frames`; all an Arm has, and ``steps`` (what was done, in words)
    and ``warnings``, tuples of sentences.
    """

    steps: tuple[str, ...] = ()
    warnings: tuple[str, ...] = ()

    def __reduce__(self) -> tuple[type, tuple[object, ...]]:
        made, parts = super().__reduce__()
        return made, (*parts, self.steps, self.warnings)


def assign_frames(
    axes: Iterable[Sequence[Any]],
    *,
    end: ArrayLike,
    convention: str = "standard",
    x_signs: Mapping[int, int] | None = None,
    z_signs: Mapping[int, int] | None = None,
    slides: Mapping[int, float] | None = None,
    x_along: Mapping[int, ArrayLike] | None = None,
    prismatic: str = "auto",
    parallel: float | None = None,
    limits: Sequence[tuple[float, float] | None] | None = None,
    name: str = "",
    source: str = "",
) -> PlacedArm:
    """Frames and DH table of an arm whose joint axes are known, in the base frame, at the zero
    pose.

    Frame 0 lies on axis 1: o_0 is the point of it nearest to the base's origin, x_0 along the
    base's x; ``base`` holds this pose, since no row can. The last normal goes to the tool's z axis,
    so that z_n (standard) runs along the tool; ``tool`` holds what is left: a turn and a shift
    along z_n (standard), or the whole way from the last joint's frame (Craig). The base's axes and
    the tool are never approximated.

    Parameters
    ----------
    axes : list
        Per joint (point, direction) or (point, direction, "R" | "P"): metres, any length of
        direction; positive motion turns counter-clockwise about the direction, or slides along it.
        Of a "P" only the direction counts (see ``prismatic``).
    end : array (4, 4)
        The end pose at q = 0.
    convention : "standard" or "craig"
    x_signs : dict, optional
        ``{i: -1}`` turns x_i round, i = 0 … n.
    z_signs : dict, optional
        ``{k: -1}`` puts z against the direction of joint k = 1 … n, which then has ``sign`` -1.
    slides : dict, optional
        ``{i: h}`` moves o_i by h metres along z_i from where the rule puts it, where the rule is
        free: i = 0, and normals of parallel axes.
    x_along : dict, optional
        ``{i: direction}`` in the base frame, where x_i is free: i = 0, and axes on one line.
    prismatic : "auto", "previous", "next" or "given"
        Where the line of a sliding joint goes: through the previous origin, through the next axis'
        origin, or through the given point; auto: onto the next axis when that turns and is parallel
        to it, else through the previous origin.
    parallel : float, optional
        Radians: axes closer to parallel than this are taken as parallel, at the cost of this angle
        times the size of the arm. Left out: 1e-12, and more only where the exact table would lose
        more to rounding.
    limits, name, source
        As in ``Arm``.

    Returns
    -------
    PlacedArm
        ``forward(0)`` is ``end``, and the joints move about the given axes; ``steps`` says how.

    Raises
    ------
    ValueError
        One sentence: what was expected, found, and what to do.

    Warns
    -----
    NearlyParallelWarning
        The exact table has lengths far beyond the arm; the sentence names them and the remedy.

    Notes
    -----
    Siciliano et al., Robotics, section 2.8.2; Craig, Introduction to Robotics, section 3.4.

    Examples
    --------
    >>> import dhlab as dh
    >>> from dhlab.transform import trans
    >>> axes = [([0, 0, 0], [0, 0, 1]), ([0.4, 0, 0.1], [0, 0, 1])]
    >>> arm = assign_frames(axes, end=trans([0.7, 0, 0.1]))
    >>> print(arm)
    standard DH, 2 joints (lengths in m, angles in deg)
     i  theta  d    a    alpha
     1  q1     0    0.4  0
     2  q2     0.1  0.3  0
    >>> print(arm.steps[1])
    z1 ∥ z0: the common normal is free; taken through o0, so d1 = 0; x1 points from z0 to z1, a1 =
    0.4 m.
    """
    if convention not in CONVENTIONS:
        raise ValueError(
            f'assign_frames: expected the convention "standard" or "craig", found {convention!r};'
            ' "modified" is "craig" here'
        )
    end = require_pose(end, "assign_frames: end")
    lines = axes_from(axes)
    n, sign = len(lines), np.ones(len(lines))
    for k, s in signs_from(z_signs, "z_signs", 1, n).items():
        lines[k - 1].z, sign[k - 1] = s * lines[k - 1].z, s
    choices = choices_from(n, x_signs, slides, x_along, prismatic, parallel, convention)
    found = place(lines, end, choices)
    _refuse_unused(choices, found.cases)
    table = _table(found, convention, [axis.letter for axis in lines])
    bare = Arm(table, base=found.frame_0(), sign=sign)
    said = _warned(found, table, parallel)
    for sentence in said:
        _warnings.warn(sentence, NearlyParallelWarning, stacklevel=2)
    tool = _near_identity(inverse(bare.frames(np.zeros(n))[-1]) @ end, found.reach)
    steps = (*describe(found, convention, sign, bare.base, tool), *said)
    return PlacedArm(
        table,
        base=bare.base,
        tool=tool,
        limits=limits,
        sign=sign,
        name=name,
        source=source,
        steps=steps,
        warnings=said,
    )


def _table(found, convention, letters):
    theta, d, a, alpha = found.rows().T
    if convention == "craig":
        a, alpha = np.r_[0.0, a[:-1]], np.r_[0.0, alpha[:-1]]
    return DHTable(convention, theta, d, a, alpha, "".join(letters))


def _near_identity(tool, reach):
    return np.eye(4) if np.abs(tool - np.eye(4)).max() < 1e-14 * max(1.0, reach) else tool


def _warned(found, table, asked):
    """A sentence for each pair of axes that is nearly, but not exactly, parallel, when that has a
    price.
    """
    sentences = []
    for k in range(1, len(table)):
        first = k - 1 if table.convention == "standard" else k
        z, w = f"z{first}", f"z{first + 1}"
        if k in found.snapped and asked is None:
            angle, far = found.snapped[k]
            sentences.append(
                f"{w} is {angle:.2g} rad from parallel to {z} and was taken as parallel, which"
                f" moves the end by up to {2 * angle * found.reach:.2g} m; the exact table has"
                f" lengths of {far:.2g} m and loses more to rounding."
            )
        elif k not in found.snapped and found.cases[k] in ("skew", "meet"):
            large = [
                f"d{i} = {number(table.d[i - 1], 2)} m"
                for i in (k, k + 1)
                if abs(table.d[i - 1]) > RUNAWAY * found.reach
            ]
            angle = abs(np.sin(found.normals[k].alpha))
            if large and angle < NEARLY:
                sentences.append(
                    f"{w} is only {number(np.rad2deg(angle), 4)}° from parallel to {z}, so their"
                    f" common normal is far outside the arm: {', '.join(large)}. The table is"
                    f" right, but rounds to about {max(abs(table.d)) * 1e-15:.0e} m;"
                    f" parallel={_just_above(angle)} takes them as parallel and moves the end by up"
                    f" to {number(2 * angle * found.reach * 1000, 1)} mm."
                )
    return tuple(sentences)


def _just_above(angle):
    """The next larger number of one digit."""
    step = 10.0 ** np.floor(np.log10(angle))
    return f"{np.ceil(angle / step) * step:.1g}"


def _refuse_unused(choices, cases):
    """A choice where the geometry leaves none is a misunderstanding; say so."""
    for i in choices.slides:
        if cases[i] in ("skew", "meet"):
            raise ValueError(
                f"assign_frames: slides: frame {i} cannot slide: the axes on both sides are not"
                f" parallel, so the common normal gives o{i}; leave it out"
            )
    for i in choices.x_along:
        if i and not cases[i].startswith("same line"):
            raise ValueError(
                f"assign_frames: x_along: x{i} is not free: it lies along the common normal of two"
                " axes; only its sense is, see x_signs"
            )
