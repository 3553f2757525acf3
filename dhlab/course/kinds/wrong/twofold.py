"""Slips that any numbers may have, a sign or a place, and two slips at once: tried when an
exercise's own wrong answers explain nothing.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import combinations
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from ....transform import inverse
from ..exercise import Mistakes, Said

__all__ = ["FRAMES", "SIGNS", "TWO", "by_entries", "of_any_pose", "of_any_vector", "under_another"]

TWO = "two slips: {}; and {}"
# what may be done to a finished pose or vector, and undone by doing it again: what is said, then
# (mistake, change)
Changes: TypeAlias = Mapping[str, tuple[str | None, Callable[[NDArray], NDArray]]]
SIGNS: Changes = {"every number has the other sign": (None, np.negative)}
FRAMES: Changes = {
    "the whole 4×4 is transposed": ("matrix-transposed", np.transpose),
    "the rotation block is transposed": (
        "rotation-transposed",
        lambda T: np.block([[T[:3, :3].T, T[:3, 3:]], [T[3:]]]),
    ),
    "the pose is inverted": ("pose-inverted", inverse),
}


def of_any_vector(right: NDArray, names: Sequence[str]) -> Mistakes:
    """One number with the other sign, all of them, or two in each other's places."""
    for k, name in enumerate(names):
        signs = np.where(np.arange(len(names)) == k, -1, 1)
        yield None, Said(f"{name} has the other sign"), right * signs
    yield None, Said("every number has the other sign"), -right
    for i, k in combinations(range(len(names)), 2):
        swapped = right.copy()
        swapped[[i, k]] = right[[k, i]]
        yield None, Said(f"{names[i]} and {names[k]} have changed places"), swapped


def of_any_pose(right: NDArray) -> Mistakes:
    """The whole pose transposed or inverted, its block transposed, an arrow turned round."""
    for said, (mistake, change) in FRAMES.items():
        yield mistake, Said(said), change(right)
    in_the_row = np.eye(4)
    in_the_row[:3, :3], in_the_row[3, :3] = right[:3, :3], right[:3, 3]
    yield (
        "matrix-transposed",
        Said("the origin stands in the last row, not the last column"),
        (in_the_row),
    )
    for k, name in enumerate("xyz"):
        turned = right * np.where(np.arange(4) == k, -1, 1)
        yield None, Said(f"the {name} arrow points the other way"), turned


def by_entries(
    array: NDArray, right: NDArray, known: Sequence[tuple], differs: Callable[..., NDArray]
) -> tuple | None:
    """Two known slips, each in numbers of its own, that together make a vector; None."""
    wrong = differs(array, right)
    parts = []
    for one in known:
        if np.shape(one[2]) != array.shape:
            continue
        value = np.asarray(one[2], dtype=float)
        touched = differs(value, right)
        # within what is wrong, and as it is there
        if (
            touched.any()
            and not (touched & ~wrong).any()
            and not differs(array, value)[touched].any()
        ):
            parts.append((one, touched))
    for (one, here), (other, there) in combinations(parts, 2):
        if not (here & there).any() and (here | there)[wrong].all():
            return one, other
    return None


def under_another(
    array: NDArray,
    known: Sequence[tuple],
    same: Callable[[NDArray, NDArray], bool],
    changes: Changes,
) -> Iterator[tuple]:
    """The known slips on top of which one of the changes was made: (known slip, change)."""
    for said, (mistake, change) in changes.items():
        undone = change(array)
        if not np.allclose(change(undone), array):  # no pose: part of it was not looked at
            continue
        for one in known:
            if one[0] != mistake and same(undone, one[2]):
                yield one, (mistake, Said(said))
