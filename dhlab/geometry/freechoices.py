"""Which free choices separate two tables of one arm: frame by frame, what lies between them is a
move of :mod:`dhlab.geometry.freedoms`.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..arm import Arm
from ..printing import number
from ..transform import inverse
from .canonical import ROUNDING, largest_length
from .lines import across

__all__ = ["FreeChoice", "free_choices", "in_words", "end_choice", "turn_of", "far"]

SAME_ANGLE = 1e-7  # rad; a choice smaller than this is rounding
SAME_LENGTH = 1e-8  # × the size of the arm (m); likewise, beside the rounding of base and tool


@dataclass(frozen=True)
class FreeChoice:
    """One free choice: ``kind`` is "flip-x", "flip-z", "slide", "twist", "prismatic-shift", "base",
    "tool" or "convention".

    ``joint`` is the frame i of a flip, slide or twist, the joint of a prismatic shift, else None.
    ``amount`` is metres (slide, prismatic shift), radians (twist), the pair (m, rad) of how far a
    base or tool frame was moved, or None. Slides, twists and flips, made in this order with
    :mod:`dhlab.geometry.freedoms`, lead from the first table to the second.
    """

    kind: str
    joint: int | None
    amount: float | tuple[float, float] | None
    message: str


def free_choices(a: Arm, b: Arm, X: NDArray[np.float64]) -> tuple[FreeChoice, ...]:
    """The choices that lead from a's table to b's.

    Parameters
    ----------
    a, b : Arm
        Equivalent, and in the same convention.
    X : array (4, 4)
        What lays b's axes on a's: the identity when the base is fixed.

    Returns
    -------
    tuple of FreeChoice

    Examples
    --------
    >>> import dhlab as dh
    >>> arm = dh.load("ur5e")
    >>> [(c.kind, c.joint) for c in free_choices(arm, arm.slide(2, 0.1).flip_x(4), np.eye(4))]
    [('slide', 2), ('flip-x', 4)]
    """
    q = np.zeros(len(a))
    F_a, F_b = a.frames(q), X @ b.frames(q)
    same = SAME_LENGTH * np.abs(a.table.rows[:, 1:3]).max()
    same += ROUNDING * max(largest_length(a), largest_length(b))
    G = inverse(F_a) @ F_b
    found = list(_prismatic_shifts(a, F_a, F_b, same))
    for i in range(len(a) + 1):
        found += _at_frame(a, i, G[i], same)
    return tuple(found)


def _prismatic_shifts(a, F_a, F_b, same):
    first = 0 if a.table.convention == "standard" else 1
    for k in np.flatnonzero(a.table.prismatic):
        A, B = F_a[k + first], F_b[k + first]
        h = float(np.linalg.norm(across(B[:3, 3] - A[:3, 3], A[:3, 2])))
        if h > same:
            text = (
                f"the line of sliding joint {k + 1} moved by {number(h)} m (only its direction"
                " counts)"
            )
            yield FreeChoice("prismatic-shift", int(k) + 1, h, text)


def _at_frame(a, i, G, same):
    """The choices at frame i: G = Tz(h) Rz(phi), then half turns about z (flip x) and about x (flip
    z).
    """
    n, standard = len(a), a.table.convention == "standard"
    h, phi = G[2, 3], np.arctan2(G[1, 0], G[0, 0])
    flips = _flips(a, i, G[2, 2] < 0, abs(phi) > np.pi - SAME_ANGLE)
    if flips and flips[0].kind == "flip-x":
        phi = 0.0
    if i in (0, n):
        rest = G @ _undo(flips)
        # this frame's z lies on no joint, so a turned z alone is no flip
        loose = (i == n) == standard
        ends = _at_end(i, n, rest, same)
        return ends + flips if not (loose and ends) else _at_end(i, n, G, same)
    lone = abs(np.sin(_alpha(a, i))) < SAME_ANGLE
    found = []
    if abs(h) > same and lone:
        found.append(FreeChoice("slide", i, float(h), f"o{i} slid {number(h)} m along z{i}"))
    if abs(phi) > SAME_ANGLE and lone and abs(_a(a, i)) < same:
        found.append(
            FreeChoice(
                "twist",
                i,
                float(phi),
                f"x{i} turned by {number(np.rad2deg(phi), 4)}° about z{i} (theta{i}, theta{i + 1})",
            )
        )
    # what is not free by itself follows from the shift of a sliding joint next to it
    return found + flips


def _undo(flips):
    T = np.eye(4)
    for choice in reversed(flips):
        T = T @ np.diag([-1.0, -1, 1, 1] if choice.kind == "flip-x" else [1.0, -1, -1, 1])
    return T


def _flips(a, i, z_round, x_round):
    """The half turns at frame i, with the entries that they change; those that the table does not
    have go to base or tool.
    """
    n, standard = len(a), a.table.convention == "standard"
    taken = {0: ", the base taking the rest", n: ", the tool taking the rest"}.get(i, "")
    found = []
    if x_round:
        found.append(
            FreeChoice(
                "flip-x",
                i,
                None,
                f"x{i} flipped"
                f" ({_entries(a, ('theta', i), ('a', i), ('alpha', i), ('theta', i + 1))}{taken})",
            )
        )
    if z_round:
        k = i + 1 if standard else i
        counts = f", so that joint {k} counts the other way" if 1 <= k <= n else ""
        changed = _entries(a, ("alpha", k - 1), ("theta", k), ("d", k), ("alpha", k), ("sign", k))
        found.append(FreeChoice("flip-z", i, None, f"z{i} flipped{counts} ({changed}{taken})"))
    return found


def _entries(a, *wanted):
    """Those of the entries that the table has: rows run from 1 to n, a and alpha of a Craig table
    from 0 to n-1.
    """
    n, standard = len(a), a.table.convention == "standard"
    lengthwise = range(1, n + 1) if standard else range(n)
    return ", ".join(
        f"{name}{' ' * (name == 'sign')}{k}"
        for name, k in wanted
        if k in (lengthwise if name in ("a", "alpha") else range(1, n + 1))
    )


def _at_end(i, n, rest, same):
    """Frame 0 or n elsewhere, which base or tool take up."""
    shift, turn = float(np.linalg.norm(rest[:3, 3])), turn_of(rest)
    if shift <= same and turn <= SAME_ANGLE:
        return []
    kind, what = ("base", "frame 0 moved") if i == 0 else ("tool", f"frame {n} moved")
    return [
        FreeChoice(
            kind, None, (shift, turn), f"{what} by {far(shift, turn)}, which the {kind} takes up"
        )
    ]


def turn_of(T: NDArray[np.float64]) -> float:
    """The angle of the turn in T, exact for small ones."""
    R = T[:3, :3]
    s = np.linalg.norm([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]]) / 2
    return float(np.arctan2(s, (np.trace(R) - 1) / 2))


def far(shift: float, turn: float) -> str:
    """A shift (m) and a turn (rad) in words."""
    parts = [f"{number(shift)} m"] if number(shift) != "0" else []
    parts += [f"{number(np.rad2deg(turn), 4)}°"] if number(np.rad2deg(turn), 4) != "0" else []
    return " and ".join(parts) or "a trifle"


def end_choice(kind: str, T: NDArray[np.float64], same: float) -> list[FreeChoice]:
    """The "base" or "tool" choice when that freedom was granted and used: T is what lies between
    the two.
    """
    shift, turn = float(np.linalg.norm(T[:3, 3])), turn_of(T)
    if shift <= same and turn <= SAME_ANGLE:
        return []
    return [FreeChoice(kind, None, (shift, turn), f"another {kind}, {far(shift, turn)} away")]


def _alpha(a, i):
    return a.table.alpha[i - 1 if a.table.convention == "standard" else i]


def _a(a, i):
    return a.table.a[i - 1 if a.table.convention == "standard" else i]


def in_words(choices: Sequence[FreeChoice], a: Arm) -> str:
    """One phrase for all the choices; slides along one run of parallel axes are told together.

    Examples
    --------
    >>> import dhlab as dh
    >>> arm = dh.load("ur5e")
    >>> in_words(free_choices(arm, arm.slide(2, 0.1333).slide(3, 0.1333), np.eye(4)), arm)
    '0.1333 m slid along the parallel axes 2-3-4 from row 4 to row 2'
    """
    slides = {c.joint: c.amount for c in choices if c.kind == "slide"}
    phrases, told = [], set()
    for c in choices:
        if c.kind != "slide":
            phrases.append(c.message)
        elif c.joint not in told:
            run = _run(c.joint, slides)
            told.update(run)
            phrases.append(_slid(run, slides, a))
    return ", and ".join([", ".join(phrases[:-1]), phrases[-1]] if len(phrases) > 1 else phrases)


def _run(i, slides):
    run = [i]
    while run[-1] + 1 in slides:
        run.append(run[-1] + 1)
    return run


def _slid(run, slides, a):
    """What the slides of one run do to the column d: from one row to another, or frame by frame
    when more rows take part.
    """
    gain = dict.fromkeys(range(run[0], run[-1] + 2), 0.0)
    for i in run:
        c = np.sign(np.cos(_alpha(a, i)))
        before, behind = (c, 1.0) if a.table.convention == "standard" else (1.0, c)
        gain[i] += slides[i] * before
        gain[i + 1] -= slides[i] * behind
    changed = [row for row in gain if abs(gain[row]) > 1e-9]
    axes = "-".join(str(k) for k in range(run[0], run[-1] + 2))
    if len(changed) == 2 and abs(sum(gain.values())) < 1e-9:
        giver, taker = sorted(changed, key=lambda row: gain[row])
        return (
            f"{number(gain[taker])} m slid along the parallel axes {axes} from row {giver} to row"
            f" {taker}"
        )
    moves = ", ".join(f"o{i} by {number(slides[i])} m" for i in run)
    return f"origins slid along the parallel axes {axes} ({moves})"
