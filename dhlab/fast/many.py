"""Many poses at once in plain numpy.

What makes it fast, beside the walk itself (``walk.py``):

* *Numbers of one kind lie together.* The poses are held as rows: all x components, then all y
  components and so on, so that every numpy call runs over thousands of numbers. Only the result is
  transposed into (..., 4, 4), in one copy (``_write``).
* *A chunk stays in the cache.* All that is done to some thousand poses is done before the next
  ones are touched, so that numpy's intermediate arrays never travel to memory (``_chunks``).
* *Cosine and sine come from one tangent.* With t = tan(angle / 2) and r = 2 / (1 + t²) they are
  r - 1 and t·r. numpy's tan (as of 2.4) is vectorised for doubles on processors with AVX-512, its
  sin and cos are not; elsewhere one tangent still costs less than both (``phases``).
* *x and y are one complex row.* With w = x + i·y, turning a frame about z is w·exp(-i·angle): the
  same arithmetic in one call of numpy and one intermediate array instead of six (``Frames.turn``).
  In memory x and y of a pose then stand side by side, and a step that needs one of them alone takes
  every second number.
* *At a right angle y and z change places*: alpha = ±90° takes two products by ±1, not four and two
  sums (``Frames.tilt``).
* *What is 0 is skipped*: zero d and a, an alpha of 0, the zeros of the tool.
* *The last row is never computed.* It is 0 0 0 1 and stands ready (``_poses``).

Where rows are stored for the result, 0.0 is added instead of copying them: that costs the same, and
-0.0, which prints badly, becomes 0.0. (Only the Jacobian is gone over once more for it.)

A function answers True, as the compiled ones do, which tell by False that a number of q is not
finite; here ``require_finite`` says so at once. Chunks that were done before are written then.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from .chain import Chain, Step
from .inputs import require_finite
from .walk import along_the_joints, frame_by_frame, to_the_end

__all__ = ["forward", "frames", "jacobian", "phases"]

# bytes of a chunk: more than most L2 caches hold, since in smaller chunks numpy's calls cost more
# than what comes from the next cache (measured)
CACHE = 1 << 22
LINE = 8  # doubles in a line of the cache


def forward(chain: Chain, q: NDArray, out: NDArray) -> bool:
    """End poses of ``q`` (m, n) into ``out`` (m, 4, 4)."""
    block = _poses(chain, q, 1)[0]
    for part, joined, result, rows in _chunks(chain, q, out, block):
        frame = to_the_end(chain, Frames(chain, part, joined), joined)
        frame.behind(chain.end, rows)
        _write(rows, result)
    return True


def frames(chain: Chain, q: NDArray, out: NDArray) -> bool:
    """Every frame of ``q`` (m, n) into ``out`` (m, n + 1, 4, 4)."""
    block = _poses(chain, q, len(chain) + 1)
    for part, _, result, rows in _chunks(chain, q, out, block):
        frame = Frames(chain, part, joined=False)
        for i in frame_by_frame(chain, frame):
            frame.hold(rows[i])
        _write(rows, result)
    return True


def jacobian(chain: Chain, q: NDArray, out: NDArray) -> bool:
    """Jacobians of ``q`` (m, n) into ``out`` (m, 6, n): column i is z × (end - p) over z, or z over
    0 where the joint slides.
    """
    block = _columns(chain, q)
    for part, joined, result, rows in _chunks(chain, q, out, block):
        v, z, p = rows
        frame = Frames(chain, part, joined)
        for i in along_the_joints(chain, frame, joined):
            np.add(frame.z, 0.0, out=z[:, i])
            p[:, i] = frame.p
        np.subtract(frame.point(chain.end[:3, 3])[:, None], p, out=p)
        for k in range(3):
            i, j = (k + 1) % 3, (k + 2) % 3
            np.subtract(z[i] * p[j], z[j] * p[i], out=v[k])
        v += 0.0
        for i, slides in enumerate(chain.slides):
            if slides:
                v[:, i], z[:, i] = z[:, i], 0.0
        columns = _chain_rule(chain, rows[:2])
        _write(columns.reshape(6, *columns.shape[2:]), result)
    return True


class Frames:
    """A frame per pose: ``w`` = x + i·y, ``z`` and ``p``, each three rows of one number per pose
    (of one number for all, as long as they are the same). The moves are those of ``walk.py``.
    """

    def __init__(self, chain: Chain, q: NDArray, joined: bool) -> None:
        x, y, self.z, self._p = chain.base[:3].T[..., None]
        self.w = x + 1j * y
        self.lengths, half = _variables(chain, q)
        for i in range(1, len(chain)):
            if joined and chain.steps[i].parallel:
                half[i] += half[i - 1]  # the angle of the run so far
        self.phases = phases(half)
        self.chain, self.turns, self.laid = chain, False, None

    @property
    def p(self) -> NDArray:
        """The origin. What was laid out in the plane is added first: x·cos + y·sin is the real part
        of w·exp(-i·angle).
        """
        if self.laid is not None:
            self._p = self._p + (self.w * self.laid).real
            self.laid = None
        return self._p

    def add_joint(self, i: int) -> None:
        self.i, d = i, self.lengths[i]
        self.turns = self.turns or not self.chain.slides[i] or self.chain.theta[i] != 0
        if np.ndim(d) or d:
            self._p = self._p + self.z * d

    def lay(self, a: float) -> None:
        if a:
            step = self.phases[self.i] * a
            self.laid = step if self.laid is None else self.laid + step

    def turn(self, a: float) -> None:
        if self.laid is not None and a:
            self.lay(a)
            a = 0.0
        p = self.p
        if self.turns:
            self.w = self.w * self.phases[self.i]
        self.turns, self._p = False, p
        self.go(a)

    def go(self, a: float) -> None:
        if a:
            self._p = self._p + self.w.real * a

    def tilt(self, step: Step) -> None:
        y, z = self.w.imag, self.z  # y is a view: the new z is worked out before y is written
        if step.parallel:
            return
        if step.c == 0.0:
            self.z = y * -step.s
            self.w.imag = z * step.s
        else:
            self.z = z * step.c - y * step.s
            self.w.imag = y * step.c + z * step.s

    def point(self, xyz: Any) -> NDArray:
        """A point of the frame."""
        return _sum(zip((1.0, *xyz), (self.p, self.w.real, self.w.imag, self.z)))

    def hold(self, rows: NDArray) -> None:
        """This frame into ``rows`` (4, 4, m)."""
        for k, column in enumerate((self.w.real, self.w.imag, self.z, self.p)):
            np.add(column, 0.0, out=rows[:3, k])

    def behind(self, pose: NDArray, rows: NDArray) -> None:
        """This frame moved by a constant pose into ``rows`` (4, 4, m)."""
        axes, columns = (self.w.real, self.w.imag, self.z), pose[:3].T.tolist()
        for k in range(3):
            np.add(_sum(zip(columns[k], axes)), 0.0, out=rows[:3, k])
        np.add(self.point(columns[3]), 0.0, out=rows[:3, 3])


def _sum(terms):
    """Σ k·rows over (k, rows), without the terms that are 0 and the products by 1."""
    total = None
    for k, rows in terms:
        if k:
            term = rows if k == 1.0 else rows * k
            total = term if total is None else total + term
    return 0.0 if total is None else total


def _variables(chain, q):
    """Per joint its d (a row where it slides), and a row of half its angle each, negated, since the
    phase of a turn is exp(-i·angle).
    """
    rates, offsets = chain.minus_half_angles
    rows = rates @ q.T if chain.coupled else q.T * rates
    if offsets is not None:
        rows += offsets
    lengths = list(chain.d)
    for i, slides in enumerate(chain.slides):
        if slides:
            lengths[i] = rows[i].copy()
            rows[i] = -0.5 * chain.theta[i]
    return lengths, rows


def phases(half: NDArray) -> NDArray[np.complex128]:
    """exp(2i·half) of an array of half angles.

    Near 180° t is huge, r nearly 0, and t·r = 2 / t as exact as anywhere.
    """
    t = np.tan(half)
    r = t * t
    r += 1.0
    np.divide(2.0, r, out=r)
    e = np.empty(half.shape, complex)
    np.subtract(r, 1.0, out=e.real)
    np.multiply(t, r, out=e.imag)
    return e


def _chunks(chain, q, out, block):
    """Parts of ``q``, whether their angles may be added up, the parts of ``out``, and as much of
    ``block`` (..., m) as they need.
    """
    size = block.shape[-1]
    for start in range(0, len(q), size):
        part = q[start : start + size]
        largest = max(float(part.max()), -float(part.min()))  # NaN where a number of q is
        if not largest < np.inf:
            require_finite(part)
        yield (
            part,
            bool(largest <= chain.largest_q),
            out[start : start + size],
            block[..., : len(part)],
        )


def _size(chain, q, doubles):
    """How many poses a chunk has: a pose needs ``doubles`` for its result, about five a joint for
    angles, phases and d, and some 30 for the frame and numpy's intermediate arrays. ``LINE`` poses
    are added so that rows do not lie at distances of a power of two, where they would compete for
    the same places of the cache.
    """
    size = CACHE // (8 * (5 * len(chain) + 30 + doubles))
    return min(len(q), max(size // 64, 1) * 64 + LINE)


def _poses(chain, q, k):
    """Rows (k, 4, 4, m) for k poses each, the last row of which is written here once for all."""
    block = np.zeros((k, 4, 4, _size(chain, q, 16 * k)))
    block[:, 3, 3] = 1.0
    return block


def _columns(chain, q):
    """Rows (3, 3, n, m) for v, z and p of every joint; numpy's intermediate arrays for z × lever
    take as much again.
    """
    return np.empty((3, 3, len(chain), _size(chain, q, 18 * len(chain))))


def _chain_rule(chain, J):
    """From per joint variable to per number of q: columns (2, 3, n, m) by the rates, or by the
    matrix of the coupling.
    """
    if chain.coupled:
        return chain.rates.T @ J
    if (chain.rates != 1).any():
        J *= chain.rates[:, None]
        J += 0.0
    return J


def _write(rows, result):
    """Rows (..., m) transposed into poses (m, ...)."""
    result.transpose(*range(1, result.ndim), 0)[...] = rows
