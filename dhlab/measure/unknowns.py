"""Unknowns that the data cannot tell: directions without effect, in words."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from .offsetmodel import OffsetModel

__all__ = ["Undetermined", "undetermined_groups", "null_space", "pivots"]

# singular value over the largest; derivatives are exact, so true ones lie far above
NO_EFFECT = 1e-9
PART = 0.02  # component of a unit vector from which an unknown takes part
VAGUE = {"R": np.deg2rad(5), "P": 0.02}  # rad, m; a worse standard deviation is said aloud


@dataclass(frozen=True)
class Undetermined:
    """Joints (1-based) whose offsets the data cannot tell, and why, in ``words``; ``vague``: it
    can, but only roughly.
    """

    joints: tuple[int, ...]
    words: str
    vague: bool = False


def null_space(J: NDArray[np.float64]) -> NDArray[np.float64]:
    """Orthonormal columns: the directions of the unknowns without effect on the data.

    Examples
    --------
    >>> null_space(np.array([[1.0, 1.0], [2.0, 2.0]])).round(3).shape
    (2, 1)
    """
    # as large as there are unknowns, however many rows J has
    _, s, V = np.linalg.svd(np.linalg.qr(J, mode="r"), full_matrices=True)
    s = np.r_[s, np.zeros(J.shape[1] - len(s))]
    return V[s <= NO_EFFECT * max(s[0], 1e-300)].T


def pivots(N: NDArray[np.float64], n: int) -> NDArray[np.bool_]:
    """Which unknowns to hold so that nothing is left free: one per direction, offsets (the first n)
    before others. Each time the unknown that takes the largest part, and what it settles is taken
    off the others: the pivots of a QR decomposition.
    """
    held = np.zeros(len(N), dtype=bool)
    parts = N * np.where(np.arange(len(N)) < n, 1.0, 1e-3)[:, None]
    for _ in range(N.shape[1]):
        k = np.argmax(np.linalg.norm(parts, axis=1))
        direction = parts[k] / np.linalg.norm(parts[k])
        parts = parts - np.outer(parts @ direction, direction)
        held[k] = True
    return held


def undetermined_groups(
    J: NDArray[np.float64], sigma: NDArray[np.float64], model: OffsetModel
) -> tuple[Undetermined, ...]:
    """Groups of joints that cannot be told apart (from each other, the base or the tool), and
    joints known only roughly.
    """
    N, n = null_space(J), model.n
    P = N @ N.T
    groups, seen = [], set()
    for i in range(n):
        if i not in seen and P[i, i] > PART**2:
            members = _connected(P, i)
            seen |= members
            joints = tuple(sorted(k + 1 for k in members if k < n))
            places = [
                name
                for name, (first, last) in {
                    "base": (n, n + model.n_base),
                    "tool": (n + model.n_base, model.size),
                }.items()
                if any(first <= k < last for k in members)
            ]
            groups.append(Undetermined(joints, _words(joints, places, model.R is None)))
    for i in range(n):
        limit = VAGUE["P" if model.slides[i] else "R"]
        if i not in seen and limit < sigma[i]:
            size = (
                f"{1000 * sigma[i]:.0f} mm"
                if model.slides[i]
                else f"{np.rad2deg(sigma[i]):.0f} deg"
            )
            words = (
                f"The offset of joint {i + 1} is known only to about {size} from these poses;"
                " measure more, or others."
            )
            groups.append(Undetermined((i + 1,), words, True))
    return tuple(groups)


def _connected(P, i):
    """The unknowns that directions without effect tie to unknown i."""
    members, fresh = set(), {i}
    while fresh:
        members |= fresh
        fresh = {int(k) for j in fresh for k in np.flatnonzero(abs(P[j]) > PART**2)} - members
    return members


def _words(joints, places, positions_only):
    by = "positions at these poses" if positions_only else "these poses"
    if len(joints) == 1 and not places:
        todo = "; measure rotations too, or a point off its axis" if positions_only else ""
        return f"The offset of joint {joints[0]} does not show in {by}; it was left as it is{todo}."
    names = (
        f"joint {joints[0]}"
        if len(joints) == 1
        else f"joints {', '.join(map(str, joints[:-1]))} and {joints[-1]}"
    )
    offsets = "offset" if len(joints) == 1 else "offsets"
    if places:
        where = " and ".join(
            {"base": "where the base stands", "tool": "how the tool sits"}[place]
            for place in places
        )
        each = "" if len(joints) == 1 else "each other or from "
        return (
            f"The {offsets} of {names} cannot be told apart from {each}{where} by {by}: a change of"
            " one hides in the other; one is kept at 0."
        )
    return (
        f"The {offsets} of {names} cannot be told apart by {by}: only their combination is known;"
        " one is kept at 0."
    )
