"""Many wrong programs at once: what each step gives on the first call, and which of them give the
right answers to all others.
"""

from functools import cached_property

import numpy as np

from .steps import run_chain, run_link, slips

__all__ = ["Trial", "columns", "read"]


class Trial:
    """The answers, and the arguments of the links of many wrong programs at the first case.

    ``early`` are the tuples of slips that come before the link matrix, none and each one; ``table``
    (..., n, 4) the arguments that each of them leads to.
    """

    def __init__(self, answers, cases, kind, tolerance):
        self.answers, self.cases, self.tolerance = answers, cases, tolerance
        self.kind, self.is_chain = kind, kind == "forward_kinematics"
        if self.is_chain:
            rows, q = (np.asarray(part, dtype=float) for part in cases[0])
        else:  # one link is a chain of one row
            rows, q = np.array([cases[0]], dtype=float), np.zeros(1)
        self.rows, self.q = rows, q
        self.reading, self.product, self.each = (
            slips(step) if self.is_chain else [] for step in ("reading", "product", "each link")
        )
        self.early = [(), *((slip,) for slip in self.reading + slips("arguments"))]

    @cached_property
    def table(self):
        return np.stack([read(made, self.rows, self.q) for made in self.early])

    def fitting(self, blocks):
        """The slips, tuples, of every candidate that fits all cases; blocks are (slips of candidate
        k, poses of all candidates).
        """
        for name, poses in blocks:
            for k in np.flatnonzero(self._close(poses, self.answers[0]).all(axis=(-1, -2))):
                made = name(k)
                if all(
                    self._close(self._run(made, case), answer).all()
                    for case, answer in zip(self.cases[1:], self.answers[1:])
                ):
                    yield made

    def _run(self, made, case):
        return run_chain(made, *case) if self.is_chain else run_link(made, *case)

    def _close(self, poses, answer):
        return np.abs(poses - answer) <= self.tolerance * (1 + np.abs(answer))


def read(made, rows, q):
    """The four arguments of every link, (..., n, 4), after slips of reading and of arguments."""
    for slip in made:
        if slip.step == "reading":
            rows, q = slip.change(rows, q)
    row = (rows[..., 0] + q, rows[..., 1], rows[..., 2], rows[..., 3])
    for slip in made:
        if slip.step == "arguments":
            row = slip.change(*row)
    return np.stack(row, axis=-1)


def columns(table):
    """theta, d, a, alpha, arrays (...), of a table (..., 4)."""
    return tuple(np.moveaxis(table, -1, 0))
