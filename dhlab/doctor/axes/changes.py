"""The single mistakes that somebody makes who writes axes down: a sense, a direction, a point, the
zero pose, the end; as what they change, and with how many free numbers.
"""

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from ...geometry.lines import across, unit
from ...rotations import from_rotation_vectors, skew

__all__ = ["Change", "changes_of_axis", "changes_of_end"]

SAME = 1e-9
QUARTERS = (np.pi / 2, -np.pi / 2, np.pi)


@dataclass(frozen=True)
class Change:
    """One way in which a sheet may be wrong.

    Parameters
    ----------
    kind : "sense", "direction", "place", "line", "zero" or "end"
    joint : int or None
        0-based; None for the end.
    apply : callable
        From a Chain and the free numbers to the changed Chain.
    free : int
        How many numbers are fitted: m and rad.
    guesses : int
        Among how many such changes of this joint it was chosen; a change that needs no number must
        still pay for the choice.
    starts : tuple of tuples
        Where a fit begins.
    """

    kind: str
    joint: int | None
    apply: Callable
    free: int = 0
    guesses: int = 1
    starts: tuple = field(default=((),))


def changes_of_axis(chain, i):
    """Every single mistake of one joint."""
    z, letter = chain.z[i], chain.letters[i]
    yield Change("sense", i, lambda c, x: c.with_axis(i, z=-c.z[i]))
    directions = list(_other_directions(z))
    for w in directions:
        yield Change("direction", i, lambda c, x, w=w: c.with_axis(i, z=w), guesses=len(directions))
    tilts = (np.zeros(2), *(_tilt_to(z, w) for w in directions[:6]))
    yield Change(
        "direction",
        i,
        lambda c, x: c.with_axis(i, z=_tilted(c.z[i], x)),
        free=2,
        starts=tuple(map(tuple, tilts)),
    )
    for angle in QUARTERS if letter == "R" else ():
        yield Change(
            "zero", i, lambda c, x, angle=angle: c.with_axis(i, zero=angle), guesses=len(QUARTERS)
        )
    yield Change("zero", i, lambda c, x: c.with_axis(i, zero=x[0]), free=1, starts=((0.0,),))
    if letter == "R":
        yield from _places(chain, i)


def _places(chain, i):
    p, z = chain.p[i], chain.z[i]
    guesses = list(_other_points(p, z))
    for point in guesses:
        yield Change("place", i, lambda c, x, w=point: c.with_axis(i, p=w), guesses=len(guesses))
    for k in range(3):
        along = np.eye(3)[k]
        if np.linalg.norm(across(along, z)) > 0.1:
            yield Change(
                "place",
                i,
                lambda c, x, along=along: c.with_axis(i, p=c.p[i] + x[0] * along),
                free=1,
                guesses=3,
                starts=((0.0,),),
            )
    sideways = _sideways(z)
    yield Change(
        "place",
        i,
        lambda c, x: c.with_axis(i, p=c.p[i] + x @ sideways),
        free=2,
        starts=((0.0, 0.0),),
    )
    yield Change(
        "line",
        i,
        lambda c, x: c.with_axis(i, p=c.p[i] + x[:2] @ sideways, z=_tilted(c.z[i], x[2:])),
        free=4,
        starts=((0.0,) * 4,),
    )


def changes_of_end(chain):
    """Every single mistake of the end pose."""
    for k in range(3):
        along = np.eye(3)[k]
        yield Change("end", None, _shifted(lambda x, v=along: x[0] * v), 1, 3, ((0.0,),))
    yield Change("end", None, _shifted(lambda x: x), 3, 1, ((0.0,) * 3,))
    for k in range(3):
        for angle in QUARTERS:
            turn = tuple(angle * np.eye(3)[k])
            yield Change("end", None, lambda c, x, turn=turn: _turned(c, turn), 0, 9)
    yield Change("end", None, _turned, 3, 1, ((0.0,) * 3,))
    yield Change(
        "end",
        None,
        lambda c, x: _turned(_shifted(lambda y: y)(c, x[:3]), x[3:]),
        6,
        1,
        ((0.0,) * 6,),
    )


def _shifted(shift):
    def apply(chain, x):
        end = chain.end.copy()
        end[:3, 3] += shift(np.asarray(x))
        return type(chain)(chain.p, chain.z, chain.letters, end, chain.zero)

    return apply


def _moved(chain, x):
    return _turned(_shifted(lambda y: y)(chain, x[:3]), x[3:])


def _turned(chain, x):
    end = chain.end.copy()
    end[:3, :3] = end[:3, :3] @ from_rotation_vectors(x)
    return type(chain)(chain.p, chain.z, chain.letters, end, chain.zero)


def _other_directions(z):
    """Directions that somebody may have meant: along an axis of the base, a component with the
    other sign, two components exchanged; not the opposite sense, which has a name of its own.
    """
    wanted = [s * e for e in np.eye(3) for s in (1.0, -1.0)]
    for k in range(3):
        turned = z.copy()
        turned[k] *= -1
        wanted += [turned, -turned, _exchanged(z, k)]
    found = []
    for w in wanted:
        if all(np.abs(w - v).max() > SAME for v in (z, -z, *found)):
            found.append(w)
    return found


def _other_points(p, z):
    """Points that somebody may have meant: a coordinate with the other sign, left out, or exchanged
    with another; those off the axis.
    """
    wanted = []
    for k in range(3):
        for value in (-p[k], 0.0):
            w = p.copy()
            w[k] = value
            wanted.append(w)
        wanted.append(_exchanged(p, k))
    found = []
    for w in wanted:
        off = across(w - p, z)
        if np.linalg.norm(off) > 1e-6 and all(
            np.linalg.norm(across(w - v, z)) > 1e-6 for v in found
        ):
            found.append(w)
    return found


def _exchanged(v, k):
    """The two components other than k exchanged."""
    order = [0, 1, 2]
    i, j = [m for m in order if m != k]
    order[i], order[j] = j, i
    return v[order]


def _sideways(z):
    """Two unit vectors (2, 3) across z; along axes of the base where that is possible."""
    x = unit(across(np.eye(3)[np.argmin(abs(z))], z))
    return np.array([x, skew(z) @ x])


def _tilted(z, x):
    """z turned by the rotation vector x @ sideways."""
    return from_rotation_vectors(np.asarray(x) @ _sideways(z)) @ z


def _tilt_to(z, w):
    """The two numbers that turn z into w."""
    turn = np.cross(z, w)
    s = np.linalg.norm(turn)
    return _sideways(z) @ turn / s * np.arctan2(s, z @ w) if s > SAME else np.zeros(2)
