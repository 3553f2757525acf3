"""What a program answers with two changes, foretold from what it answers with each of them; so that
of all pairs only those need be tried that are foretold to be right.
"""

import numpy as np

__all__ = ["foretold_pairs"]

CLOSE = 1e-11  # of squares, to what is compared
OF_A_POSE = (
    np.s_[..., :3, :3],
    np.s_[..., :3, 3],
    np.s_[..., 3, :],
)  # each may follow a law of its own
WHOLE = (np.s_[...],)  # of anything else


def foretold_pairs(before, answers, right):
    """The pairs of changes that are foretold to make the answers right.

    Two changes of factors of a product of poses, L A M B R, give P_1 T⁻¹ P_2 with the answers P_1
    and P_2 to each and T to none, where T may have no inverse if P_1 or P_2 has one; two of terms
    of a sum P_1 + P_2 - T; two of factors of a number P_1 P_2 / T. What is no pose (a Jacobian, a
    vector) is no product of factors with inverses, and is compared as a whole.

    Parameters
    ----------
    before : array (m, ...)
        The answers to m calls as the program stands: poses (m, 4, 4), or what else it gives.
    answers : array (N, m, ...)
        With each of N changes.
    right : array (m, ...)

    Returns
    -------
    array (k, 2) of int
        i < j, sorted.

    Examples
    --------
    >>> from dhlab.transform import rot_z, trans_x
    >>> A, B, C, D = rot_z(0.3), trans_x(0.4), rot_z(-0.3), trans_x(0.5)
    >>> answers = np.array([[C @ B], [B @ A], [A @ D]])
    >>> foretold_pairs((A @ B)[None], answers, (C @ D)[None])
    array([[0, 2]])
    """
    N, are_poses = len(answers), right.shape[1:] == (4, 4)
    fits = np.ones((N, N), dtype=bool)
    needed = list(_needed(before, answers, right, are_poses))
    for block in OF_A_POSE if are_poses else WHOLE:
        there = answers[block].reshape(N, -1)
        close = np.zeros((N, N), dtype=bool)
        for wanted in needed:
            close |= _close(wanted[block].reshape(N, -1), there)
        fits &= close | close.T
    return np.argwhere(np.triu(fits, 1))


def _needed(before, answers, right, are_poses):
    """By each law, what the other change must give for both to be right, as the answers are."""
    yield right + before - answers
    with np.errstate(all="ignore"):
        touched = ~np.isclose(answers, before, rtol=1e-9, atol=1e-12)
        scaled = right * before / answers
        usable = touched & (np.abs(answers) > 1e-9) & (np.abs(before) > 1e-9)
        yield np.where(usable, scaled, right + before - answers)
    if not are_poses:
        return
    sound = np.abs(np.linalg.det(answers)).min(axis=1) > 1e-9
    inverses = np.linalg.inv(np.where(sound[:, None, None, None], answers, np.eye(4)))
    for product in (before @ inverses @ right, right @ inverses @ before):
        yield np.where(sound[:, None, None, None], product, np.inf)


def _close(a, b):
    """Whether rows of a are rows of b, (N, N)."""
    sizes = (a * a).sum(axis=1)
    with np.errstate(all="ignore"):
        apart = sizes[:, None] + (b * b).sum(axis=1) - 2 * a @ b.T
        return apart <= CLOSE * (1 + sizes[:, None])
