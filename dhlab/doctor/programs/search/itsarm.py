"""A program for one arm, with the table in it, taken for an arm: which arm's poses it answers with,
and in what that arm's table differs.
"""

from dataclasses import replace

import numpy as np
from scipy.spatial.transform import Rotation

from ....transform import inverse, pose_fault
from ...arms.given import measured
from ...arms.search.fitting import misfit
from ...arms.search.pairs import pairs
from ...arms.search.singles import singles
from ...arms.words.ranking import named, ranked
from ...budget import NAMES, Budget

__all__ = ["STEP", "as_its_arm", "is_a_chain"]

STEP = 0.7  # rad or m: of each joint alone, for its axis

SEARCH = 0.85  # of the time; the names of what is found take little
FEW = 6  # calls for the search; what is found must hold in all
NOISE = (1e-8, 1e-8)  # m and rad; the answers of a program are exact


def is_a_chain(zero, alone, q, answers):
    """Whether answers are those of joints one behind the other, each turning about an axis of its
    own or sliding along it: then they are the product of the joints' motions from the zero pose.

    Parameters
    ----------
    zero : array (4, 4)
        The answer at q = 0.
    alone : array (n, 4, 4)
        With each joint alone at ``STEP``.
    q : array (m, n)
    answers : array (m, 4, 4)
    """
    if pose_fault(np.array([zero, *alone, *answers])) is not None:
        return False
    moves = np.array(alone) @ inverse(np.array(zero))
    turns = Rotation.from_matrix(moves[:, :3, :3]).as_rotvec()
    for values, right in zip(q, answers):
        T = np.eye(4)
        for move, turn, value in zip(moves, turns, values):
            T = T @ _part(move, turn, value / STEP)
        if not np.allclose(T @ zero, right, rtol=1e-6, atol=1e-6):
            return False
    return True


def _part(move, turn, share):
    """A motion, or a multiple of it: the turn about its axis, the slide along it."""
    R = Rotation.from_rotvec(share * turn).as_matrix()
    angle, T = np.linalg.norm(turn), np.eye(4)
    T[:3, :3] = R
    if angle < 1e-9:
        T[:3, 3] = share * move[:3, 3]
        return T
    along = turn / angle
    slide = along * (along @ move[:3, 3])
    aside = move[:3, 3] - slide
    point = (aside + np.cross(along, aside) / np.tan(angle / 2)) / 2
    T[:3, 3] = point - R @ point + share * slide
    return T


def as_its_arm(answers, arm, q, seconds, mistakes=1):
    """The Findings that explain the answers as those of another arm; none where they are no arm's
    with one mistake or two.

    The arm that the program has is sought as if its answers had been measured; on the way back from
    it to the right one each step is what is wrong with the program.

    Parameters
    ----------
    answers : array (m, 4, 4)
    arm : Arm
        The right one.
    q : array (m, n)
    seconds : float
        Of the processor.
    mistakes : 1 or 2
        How many it takes.

    Returns
    -------
    tuple of Finding

    Examples
    --------
    >>> import dhlab as dh
    >>> right = dh.load("article-6r")
    >>> rows = right.table.rows
    >>> rows[2, [1, 2]] = rows[2, [2, 1]]
    >>> wrong = dh.Arm(dh.DHTable.standard(rows, angle="rad"))
    >>> q = np.random.default_rng(1).uniform(-2, 2, (12, 6))
    >>> [(f.mistake, f.joint) for f in as_its_arm(wrong.forward(q), right, q, 1.0)]
    [('a-d-exchanged', 3)]
    """
    if pose_fault(answers) is not None:
        return ()
    data = measured(arm, q[:FEW], answers[:FEW], NOISE, "fixed", "fixed")
    whole = measured(arm, q, answers, NOISE, "fixed", "fixed")
    search = singles if mistakes == 1 else pairs
    clock = Budget(seconds)
    found = search(arm, data, clock.part("its arm", SEARCH))
    fitting = [explanation for explanation in found if _fits(explanation, data, whole)]
    if not fitting:
        return ()
    part = clock.part("its name", NAMES)
    best = min(ranked(arm, fitting, data, part), key=lambda e: _moves_an_end(e, arm))
    return tuple(_on_the_way_back(best, data, arm, part))


def _moves_an_end(explanation, arm):
    """Whether base or tool differ: what a number of the table or a joint's sense does as well is
    likelier there.
    """
    its = explanation.chain[-1]
    return not (np.allclose(its.base, arm.base) and np.allclose(its.tool, arm.tool))


def _fits(explanation, data, whole):
    """Whether it is an arm's, and that arm answers so in every call; many offsets at once explain
    too much.
    """
    if explanation.data_fault is not None or len(explanation.entries) > explanation.changes:
        return False
    return explanation.fit.explains(data) and misfit(explanation.fit.arm, whole).explains(whole)


def _on_the_way_back(explanation, data, arm, part):
    its = explanation.chain[-1]
    right = arm.forward(data.q)
    data = replace(data, p=right[:, :3, 3], R=right[:, :3, :3])
    back = replace(explanation, chain=explanation.chain[::-1], fit=misfit(arm, data))
    return named(back, data, part) if its is not arm else []
