"""The paths that numba compiles, where the extra ``[fast]`` is installed.

To load numba takes half a second, to compile the kernels for the first time on a machine several;
they are kept on disk from then on. Who asks for one pose, or for a million, must not wait for that.
So numba is loaded by the first large batch that finds that large batches have kept numpy busy for
``PATIENCE``, twice what loading takes. From then on an arm uses it from its next large batch on (a
few dozen poses go through the plain product until then), and one that is made later from the start;
both for single poses too. ``DHLAB_NUMBA=1`` in the environment loads it
at once, ``DHLAB_NUMBA=0`` never. Results differ from those of the other paths by rounding alone.
"""

from __future__ import annotations

import os
import warnings
from collections.abc import Callable
from functools import cache
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from .chain import Chain

if TYPE_CHECKING:
    from concurrent.futures import ThreadPoolExecutor

__all__ = ["Compiled", "Work", "kernels", "packed"]

FLOAT = np.dtype(float)
PATIENCE = 1.0  # seconds of batches in numpy
PART = 8192  # poses that a thread takes at a time: some 0.4 ms of work


class Work:
    """How long batches have kept numpy busy in this process."""

    seconds = 0.0

    @classmethod
    def is_worth_it(cls) -> bool:
        """Whether numba is to be used now."""
        wanted = os.environ.get("DHLAB_NUMBA", "")
        return wanted != "0" and (cls.seconds > PATIENCE or wanted == "1") and bool(kernels())


@cache
def kernels() -> tuple[list[Callable], Callable] | None:
    """The compiled functions for one pose, one a question, and for many; None without numba, or
    with one that does not work here.
    """
    if find_spec("numba") is None:
        return None
    try:
        from .kernel_many import answer_many
        from .kernel_one import answers_one

        return answers_one(), answer_many
    except Exception as error:  # whatever keeps it from compiling: an old numpy, no place to write
        warnings.warn(f"dhlab: numba does not work here and is left out: {error}", stacklevel=2)
        return None


@cache
def threads() -> ThreadPoolExecutor:
    """As many threads as this process may use cores; the kernels run without Python's lock."""
    from concurrent.futures import ThreadPoolExecutor  # with what it logs: only where numba works

    return ThreadPoolExecutor(cores(), thread_name_prefix="dhlab")


if hasattr(os, "register_at_fork"):  # threads stay behind in the parent
    os.register_at_fork(after_in_child=threads.cache_clear)


def cores() -> int:
    """How many cores this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


class Compiled:
    """One question of one arm: ``take`` as ``paths.Path`` has it, ``rows`` as ``many.py``.

    A kernel sees for itself that an array holds numbers of 8 bytes, and that they are n and finite.
    It does not see how many dimensions there are, nor whether the 8 bytes are a double: who calls
    it must. Where it says False the result holds anything.
    """

    def __init__(self, chain: Chain, kind: int, shape: tuple[int, ...], fallback: Callable) -> None:
        self.numbers, self.shape = packed(chain, kind), shape
        found = kernels()
        assert found is not None
        ones, self.many = found
        self.one = ones[kind]
        self.take = self._taker(fallback)

    def _taker(self, fallback):
        """The answer for ``q``: a row of doubles goes straight to the kernel, everything else to
        ``fallback``. (A function within a function: Python finds its names faster than attributes,
        which here is a tenth of the time of a pose. An array that comes out of a pickle has a dtype
        of its own and goes the slower way.)
        """
        one, numbers, shape, empty, double = self.one, self.numbers, self.shape, np.empty, FLOAT
        array = np.ndarray  # and nothing derived, which may say anything of its dimensions

        def take(q: Any, out: NDArray | None = None) -> NDArray:
            if type(q) is array and q.ndim == 1 and q.dtype is double and out is None:
                answer = empty(shape)
                if one(q, numbers, answer):
                    return answer
            return fallback(q, out)

        return take

    def floats(self, q: list[float]) -> NDArray[np.float64] | None:
        """The answer for a list of n finite numbers; None where their coupling is not finite."""
        answer = np.empty(self.shape)
        return answer if self.one(np.array(q, dtype=float), self.numbers, answer) else None

    def rows(self, chain: Chain, q: NDArray, out: NDArray) -> bool:
        """The answers for ``q`` (m, n) into ``out``; False where not all of q, or of what its
        coupling makes of it, is finite, and then ``out`` holds anything.
        """
        starts = range(0, len(q), PART)
        parts = [(q[start : start + PART], out[start : start + PART]) for start in starts]
        if len(parts) == 1 or cores() == 1:
            return all(self._part(*part) for part in parts)
        good = list(threads().map(lambda part: self._part(*part), parts))
        return all(good)

    def _part(self, q, out):
        """A part of a batch. The kernels take and give contiguous doubles only, so that anything
        else is copied.
        """
        result = out if out.flags.c_contiguous and out.dtype == float else np.empty(out.shape)
        given = np.ascontiguousarray(q, float)
        good = self.many(given, self.numbers, result.reshape(len(q), -1))
        if result is not out:
            out[...] = result
        return good


def packed(chain: Chain, kind: int) -> NDArray[np.float64]:
    """A chain and the kind of question as one row of numbers, ordered as in ``kernel_parts.py``."""
    joints = zip((0.0, *chain.theta), (0.0, *chain.d), (False, *chain.slides))
    rows = [[*joint, step.a, step.c, step.s] for joint, step in zip(joints, chain.steps)]
    rates = chain.rates if chain.coupled else np.diag(chain.rates)
    return np.concatenate(
        [
            [chain.standard, chain.coupled, kind, chain.largest_q],
            chain.base[:3].T.ravel(),
            chain.end[:3].ravel(),
            np.ravel(rows),
            rates.ravel(),
        ]
    )
