"""Whether ``q`` and ``out`` are what they should be; where they are not, a ValueError says so."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

__all__ = ["as_numbers", "require_finite", "require_finite_joints", "result_for"]

UNIT = "radians, metres for a prismatic joint"


def as_numbers(q: Any, n: int, name: str) -> NDArray:
    """``q`` as an array (..., n) of real numbers; ``name`` is the arm's, for the sentence."""
    try:
        array = np.asarray(q)
    except ValueError:  # ragged
        array = np.array(None)
    if array.dtype.kind not in "iuf":
        raise ValueError(
            f"q: expected {n} numbers ({UNIT}), found {type(q).__name__} that does not hold plain"
            " numbers only"
        )
    if array.dtype.itemsize > 8:  # long doubles: everything here computes in doubles
        with np.errstate(over="ignore"):  # infinite then, which is said
            array = array.astype(float)
    if array.shape[-1:] != (n,):
        found = f"{array.shape[-1]} values" if array.ndim else "a single number"
        raise ValueError(
            f"q: expected {n} values, one per joint of {name or 'the arm'} ({UNIT}), found {found};"
            f" a batch has shape (..., {n})"
        )
    return array


def require_finite(q: NDArray) -> None:
    """Raise ValueError, with the joint, where ``q`` (..., n) is NaN or infinite."""
    if not np.isfinite(q).all():
        joint = np.argwhere(~np.isfinite(q))[0][-1] + 1
        raise ValueError(f"q: joint {joint} is NaN or infinite, expected a finite number ({UNIT})")


def require_finite_joints(q: NDArray, coupling: NDArray | None) -> None:
    """Raise ValueError where ``q`` (..., n) is finite and what a coupling makes of it is not."""
    if coupling is None:
        return
    largest = max(q.max(initial=0.0), -q.min(initial=0.0))
    if float(largest) * float(np.abs(coupling).sum()) < np.inf:
        return
    with np.errstate(all="ignore"):
        moved = q @ coupling.T
    if np.isfinite(q).all() and not np.isfinite(moved).all():
        raise ValueError(
            "q: expected numbers of which the coupling makes finite joint values, found larger"
            " ones; give smaller numbers"
        )


def result_for(q: NDArray, shape: tuple[int, ...], out: Any) -> NDArray:
    """An array (..., *shape) to write the results of ``q`` (..., n) to: ``out``, or a new one, of
    single precision when ``q`` is.
    """
    shape = q.shape[:-1] + shape
    if out is None:
        return np.empty(shape, np.float32 if q.dtype == np.float32 else float)
    if not isinstance(out, np.ndarray) or out.dtype not in (np.float64, np.float32):
        found = out.dtype if isinstance(out, np.ndarray) else type(out).__name__
        raise ValueError(
            f"out: expected an array of float64 or float32, found {found}; make one with"
            f" numpy.empty({shape})"
        )
    if out.shape != shape or not out.flags.writeable:
        found = out.shape if out.shape != shape else "one that is read-only"
        raise ValueError(
            f"out: expected a writeable array of shape {shape} for this q, found {found}; make one"
            f" with numpy.empty({shape})"
        )
    if np.shares_memory(q, out):
        raise ValueError("out: expected memory of its own, found some of q; give another array")
    return out
