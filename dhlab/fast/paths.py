"""``Kinematics``: forward, frames and Jacobian of one arm, each by the path that suits how much is
asked.

=====================  =========================================================================
one pose               the arm's straight-line program (``straight.py``); to write it takes as
                       long as a few poses in plain floats, so the first few are done in floats
                       (``one.py``), with the same bits
a few dozen            the plain product (``plain.py``): so few are no slower by it, and an arm
                       that is asked once, as in a search over tables, prepares nothing
more                   a chunk of some thousand at a time, in the cache (``many.py``)
any number, once       the same walk as machine code (``kernel_*.py``); ``compiled.py`` says when
numba is loaded        that is
=====================  =========================================================================

All compute in double precision. Where q or ``out`` is of single precision the result is rounded to
it when it is written; one pose that goes to ``out`` costs a copy.
"""

import time
from collections.abc import Callable
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import many, one
from .chain import Chain, chain_of
from .compiled import Compiled, Work
from .inputs import as_numbers, require_finite, require_finite_joints, result_for
from .plain import Plain
from .straight import straight

__all__ = ["Kinematics"]

FLOAT = np.dtype(float)
FIRST = 8  # single poses of an arm before its program is written
DOZENS = 40  # poses that the plain product does as fast as the others
QUESTIONS = ("forward", "frames", "jacobian")  # numbered as in kernel_parts.py


class Kinematics:
    """``forward``, ``frames`` and ``jacobian`` of an arm: functions of q (..., n) and, where the
    result is to be written to an array that is there, of out.

    ``name`` is the arm's, for the sentences about a wrong q.
    """

    forward: Callable[..., NDArray]
    frames: Callable[..., NDArray]
    jacobian: Callable[..., NDArray]

    def __init__(self, plain: Plain, name: str) -> None:
        self.plain, self.name, self.n = plain, name, len(plain.table)
        shapes = ((4, 4), (self.n + 1, 4, 4), (6, self.n))
        self.paths = [Path(self, *pair) for pair in zip(QUESTIONS, shapes)]
        for question, path in zip(QUESTIONS, self.paths):
            setattr(self, question, path.take)
        if Work.is_worth_it():
            self.compile()

    @cached_property
    def chain(self) -> Chain:
        """The constants of the fast paths, worked out when one of them is first taken."""
        return chain_of(self.plain)

    def compile(self) -> None:
        """From now on by the compiled kernels."""
        for kind, (question, path) in enumerate(zip(QUESTIONS, self.paths)):
            machine = Compiled(self.chain, kind, path.shape, path.take)
            path.one, path.rows = machine.floats, machine.rows
            path.compiled = True
            setattr(self, question, machine.take)


class Path:
    """One of the three questions: how floats, the plain product and rows answer it, and the shape
    of an answer.
    """

    def __init__(self, of: Kinematics, question: str, shape: tuple[int, ...]) -> None:
        self.of, self.shape, self.single = of, shape, (of.n,)
        self.floats, self.rows = getattr(one, question), getattr(many, question)
        self.plain = getattr(of.plain, question)
        # what answers a list of n finite floats: at first floats, then the arm's own program
        self.asked, self.one, self.compiled = 0, self._first_ones, False

    def take(self, q: Any, out: NDArray | None = None) -> NDArray:
        """The answer for ``q``."""
        good = type(q) is np.ndarray and q.shape == self.single and q.dtype is FLOAT
        if not good or out is not None:
            q = as_numbers(q, self.of.n, self.of.name)
            if q.ndim > 1 or out is not None or q.dtype == np.float32:
                return self._batch(q, result_for(q, self.shape, out))
        numbers = q.tolist()
        total = sum(numbers)
        if total - total:  # NaN, which counts as true, where a number is NaN or infinite
            require_finite(q)
        try:
            answer = self.one(numbers)
        except ValueError:  # the cosine of an infinite angle
            answer = None
        if answer is not None:
            return answer
        require_finite_joints(q, self.of.plain.coupling)
        return self.plain(np.array(numbers, dtype=float))

    def _batch(self, q, result):
        """Anything but one row of doubles, into ``result``."""
        require_finite_joints(q, self.of.plain.coupling)
        if q.size == self.of.n:
            result[...] = self.take(q.ravel().astype(float))
        elif q.size <= DOZENS * self.of.n and not self.compiled:
            require_finite(q)
            result[...] = self.plain(q.astype(float))
        else:
            rows = q.reshape(-1, self.of.n)
            flat = result.reshape(-1, *self.shape)  # a copy where the memory of out has gaps
            self._many(rows, flat)
            if not np.may_share_memory(flat, result):
                result[...] = flat.reshape(result.shape)
        return result

    def _many(self, rows, flat):
        """Rows (m, n) into (m, *shape), with the time that numpy took noted down."""
        if not self.compiled and Work.is_worth_it():
            self.of.compile()
        began = time.perf_counter()
        if not self.rows(self.of.chain, rows, flat):
            require_finite(rows)
        if not self.compiled:
            Work.seconds += time.perf_counter() - began

    def _first_ones(self, q):
        """The first poses of an arm; after ``FIRST`` its program is written and takes this one's
        place. None where ``one.Floats.added`` or the program gives up.
        """
        self.asked += 1
        if self.asked > FIRST:
            self.one = straight(self.floats, self.of.chain, self.shape)
            return self.one(q)
        try:
            return np.array(self.floats(self.of.chain, q)).reshape(self.shape) + 0.0
        except OverflowError:
            return None
