"""``Kinematics``: forward, frames and Jacobian of one chain, each by the path that suits how much is
asked.

One pose of double precision runs through the arm's straight-line program (``straight.py``). To
write that program takes as long as a few poses in plain floats, so the first few of an arm are done
in floats (``one.py``), with the same bits. A batch goes to ``many.py``.
"""

import numpy as np

from . import many, one
from .inputs import as_numbers, require_finite, result_for
from .straight import straight

__all__ = ["Kinematics"]

FLOAT = np.dtype(float)
FIRST = 8  # single poses of an arm before its program is written
FEW = 4  # poses of a batch that are faster one by one


class Kinematics:
    """``forward``, ``frames`` and ``jacobian`` of a ``Chain``: functions of q (..., n) and, if the
    result is to be written somewhere, out.

    ``name`` is the arm's, for the sentences about a wrong q.
    """

    def __init__(self, chain, name):
        n = len(chain)
        self.forward = Path(chain, name, one.forward, many.forward, (4, 4)).take
        self.frames = Path(chain, name, one.frames, many.frames, (n + 1, 4, 4)).take
        self.jacobian = Path(chain, name, one.jacobian, many.jacobian, (6, n)).take


class Path:
    """One of the three questions: by floats, by numpy, and the shape of an answer."""

    def __init__(self, chain, name, by_floats, by_numpy, shape):
        self.chain, self.name, self.shape = chain, name, shape
        self.by_floats, self.by_numpy = by_floats, by_numpy
        self.single, self.asked, self.one = (len(chain),), 0, self._first_ones

    def take(self, q, out=None):
        """The answer for ``q``."""
        if type(q) is np.ndarray and q.shape == self.single and q.dtype is FLOAT and out is None:
            answer = self.one(q.tolist())
            if answer is not None:
                return answer
        q = as_numbers(q, len(self.chain), self.name)
        result = result_for(q, self.shape, out)
        rows = q.reshape(-1, len(self.chain))
        flat = result.reshape(-1, *self.shape)  # a copy where the memory of out has gaps
        self._fill(rows, flat)
        if not np.may_share_memory(flat, result):
            result[...] = flat.reshape(result.shape)
        return result

    def _fill(self, rows, flat):
        if len(rows) > FEW:
            self.by_numpy(self.chain, rows, flat)
            return
        require_finite(rows)
        for row, place in zip(rows.tolist(), flat):
            place[...] = self.one(row)

    def _first_ones(self, q):
        self.asked += 1
        if self.asked > FIRST:
            self.one = straight(self.by_floats, self.chain, self.shape)
            return self.one(q)
        total = sum(q)
        if total - total:  # NaN where one of them is NaN or infinite
            return None
        return np.array(self.by_floats(self.chain, q)).reshape(self.shape)
