"""Why no predicate decides a sentence, and what the predicates of several lessons share."""

from itertools import permutations, product

import numpy as np

from .facts import how

DO = "it says what to do"
NAMES = "it says what something is called or what the task gives: so it is by definition"
STORY = "it says what happened, or cheers"


def near(*arrays, by=1e-6):
    """Whether arrays are of one shape and the same."""
    first = np.asarray(arrays[0], dtype=float)
    return all(first.shape == np.shape(a) and np.allclose(first, a, atol=by) for a in arrays[1:])


def always(*facts):
    """Facts that hang on no task."""
    return lambda g: all(fact() for fact in facts)


def accepted(exercise):
    """Every right order of an exercise, as ids."""
    given = product if exercise.repeats else permutations
    sized = {"repeat": exercise.size} if exercise.repeats else {"r": exercise.size}
    return [ids for ids in given(exercise.items, **sized) if exercise.accepts(list(ids))]


def accepts(*ids):
    """This order is right."""
    return lambda g: g["exercise"].accepts(list(ids))


def in_order(*pairs):
    """In every right order the first of each pair stands before the second."""
    return lambda g: all(
        ids.index(one) < ids.index(other) for ids in accepted(g["exercise"]) for one, other in pairs
    )


def lie(*cases):
    """The axes of a task lie so, each to the one before it, from some axis on."""
    return lambda g: tuple(how(*g["axes"][k : k + 2]) for k in range(len(g["axes"]) - 1)) == cases


def on(axis, point):
    """Whether a point is on an axis."""
    p, u = (np.array(x, dtype=float) for x in axis[:2])
    return np.allclose(np.cross(u, np.asarray(point) - p), 0, atol=1e-9)


def is_pose(T, by=2e-3):
    """Three arrows at right angles as columns, a right hand, 0 0 0 1 below."""
    R = np.asarray(T)[:3, :3]
    return near(R.T @ R, np.eye(3), by=by) and np.linalg.det(R) > 0 and near(T[3], [0, 0, 0, 1])
