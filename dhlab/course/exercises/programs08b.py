"""The functions of lesson 08, second sitting: what their wrong answers are told beyond what the
doctor knows of them.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import product

import numpy as np
from numpy.typing import NDArray

from ...doctor.programs.wrong.branches import branches, branches_of_all, in_order
from ...doctor.programs.wrong.jacobians import geometric_jacobian, pose_error
from ...doctor.programs.wrong.solvers import chain, damped_step, wrapped
from ...kinematics import frames, link_matrices
from ...robots import load
from ...rotations import rotation_vectors
from ..kinds import Function, Known, Said
from ..verdict import Verdict

__all__ = ["MISREAD", "OTHER_STEPS", "Program", "branched_at_once", "solved_at_once"]

# of the calls: steps of the plain inverse leap near a singularity, and there rounding makes two
# right versions differ
MOST = 0.75
NEAR = 1e-5


@dataclass(frozen=True, kw_only=True)
class Program(Function):
    """A function whose answers are angles, with more wrong versions than the doctor's.

    ``more`` holds (mistake, Said, version), each compared with most of the answers; ``places``
    other words for a place; ``unknown`` is said of a version that nobody knows; ``at_once`` gives
    the right answers to all calls together, where that is quicker.
    """

    more: tuple = ()
    places: Mapping = field(default_factory=dict)
    unknown: Said
    at_once: Callable | None = None

    def right_answers(self, cases: Sequence[tuple]) -> list[NDArray]:
        return self.at_once(cases) if self.at_once else super().right_answers(cases)

    def compare(self, answer: object, variant: int) -> Verdict:
        verdict = super().compare(answer, variant)
        return replace(verdict, place=self.places.get(verdict.place, verdict.place))

    def refine(
        self, mistake: str | None, answers: Sequence[NDArray], cases: Sequence[tuple]
    ) -> Known | None:
        if mistake or all(np.array_equal(given, answers[0]) for given in answers):
            return None
        for known, said, version in self.more:
            if _mostly(version, cases, answers):
                return known, said
        off = sum(not _near(self.answer(*case), given) for case, given in zip(cases, answers))
        return (None, replace(self.unknown, place=f"{off} of {len(cases)} calls")) if off else None


def _mostly(version, cases, answers):
    """Whether a version gives most of the answers; it is not asked further than that is open."""
    others = 0
    for case, given in zip(cases, answers):
        others += not _near(version(*case), given)
        if (len(cases) - others) / len(cases) < MOST:
            return False
    return True


def _near(a, b):
    return np.shape(a) == np.shape(b) and np.abs(wrapped(a - b)).max() < NEAR


# ---- 08.6: other steps than those of damped least squares


def _stepping(step, onward=lambda q, dq: q + dq):
    """A solver by ``step(J, e, damping)``; ``onward(q, dq)`` is the next q."""

    def solve(rows, T_goal, q, damping, steps):
        for _ in range(steps):
            frames = chain(rows, q)
            J = geometric_jacobian(frames, frames[-1], np.zeros(len(q), dtype=bool))
            q = onward(q, step(J, pose_error(frames[-1], T_goal), damping))
        return wrapped(q)

    return solve


def _with_the_articles(jacobian_too, pose_too):
    """A solver that asks the article's arm, which is in memory, in place of rows."""

    def solve(rows, T_goal, q, damping, steps):
        arm = load("article-6r")
        for _ in range(steps):
            frames = chain(rows, q)
            J = geometric_jacobian(frames, frames[-1], np.zeros(len(q), dtype=bool))
            T = arm.forward(q) if pose_too else frames[-1]
            J = arm.jacobian(q) if jacobian_too else J
            q = q + damped_step(J, pose_error(T, T_goal), damping)
        return wrapped(q)

    return solve


def _left_in_memory():
    """The Jacobian of the cell in which the damping is changed."""
    return load("article-6r").jacobian(np.deg2rad([0, 40, -60, 50, 1, 0]))


def solved_at_once(tasks: Sequence[tuple]) -> list[NDArray]:
    """What the right solver gives for each task, all of them stepped together; who has made its
    steps waits.
    """
    rows, T_goal, q, damping, steps = (np.array(part) for part in zip(*tasks))
    theta, *rest = np.moveaxis(rows, -1, 0)
    for step in range(max(steps)):
        seen = frames(np.eye(4), link_matrices("standard", theta + q, *rest))
        z, T = seen[:, :-1, :3, 2], seen[:, -1]
        J_T = np.concatenate([np.cross(z, T[:, None, :3, 3] - seen[:, :-1, :3, 3]), z], axis=-1)
        turn = rotation_vectors(T_goal[:, :3, :3] @ np.swapaxes(T[:, :3, :3], -1, -2))
        e = np.concatenate([T_goal[:, :3, 3] - T[:, :3, 3], turn], axis=-1)
        A = np.swapaxes(J_T, -1, -2) @ J_T + damping[:, None, None] ** 2 * np.eye(6)
        dq = (J_T @ np.linalg.solve(A, e[..., None]))[..., 0]
        q = np.where(step < steps[:, None], q + dq, q)
    return list(wrapped(q))


def _typed_in(number):
    return _stepping(lambda J, e, damping: damped_step(J, e, number))


OTHER_STEPS = (
    (
        "damping-missing",
        Said(
            "the damping is missing: the steps are those of the plain inverse",
            why="Near a singularity the plain inverse asks for enormous joint steps.",
            next="Add damping**2 times the unit matrix to what you invert.",
        ),
        _stepping(lambda J, e, damping: np.linalg.solve(J, e)),
    ),
    (
        "damping-sides-mixed",
        Said(
            "Jᵀ is missing before the inverse",
            why="(J Jᵀ + λ² 1)⁻¹ e is no step of the joints yet: Jᵀ makes one of it.",
            next="dq is J.T @ what you have.",
        ),
        _stepping(lambda J, e, damping: np.linalg.solve(J @ J.T + damping**2 * np.eye(len(J)), e)),
    ),
    (
        "step-not-accumulated",
        Said("q = dq forgets the q before", why="Every step begins where the last one ended."),
        _stepping(damped_step, lambda q, dq: dq),
    ),
    (
        "jacobian-transpose-only",
        Said(
            "the inverse is missing: J Jᵀ + λ² 1 is multiplied, where its inverse belongs",
            place="the step dq",
            why="Where J is large a small step is enough; times J Jᵀ it becomes a large one.",
            next="np.linalg.solve(A, e) is the inverse of A, times e.",
        ),
        _stepping(lambda J, e, damping: J.T @ (J @ J.T + damping**2 * np.eye(len(J))) @ e),
    ),
    *(
        (
            "another-model",
            Said(
                f"{what} of the article's arm, and rows describes another",
                place=place,
                why="The name arm, from the first cell, is the article's arm, whatever rows are.",
                next="What do the helpers chain and jacobian take, and is it at hand in the loop?",
            ),
            _with_the_articles(*which),
        )
        for what, place, which in (
            ("the Jacobian is that", "the Jacobian", (True, False)),
            ("the pose is that", "the pose from which the error is taken", (False, True)),
            ("Jacobian and pose are those", "the Jacobian, and the pose", (True, True)),
        )
    ),
    (
        "jacobian-not-renewed",
        Said(
            "J is not made in the function: it is the one that the damping's cell left in memory",
            place="the Jacobian",
            next="Make J in every turn of the loop, of this turn's frames.",
        ),
        _stepping(lambda J, e, damping: damped_step(_left_in_memory(), e, damping)),
    ),
    *(
        (
            "damping-taken-for-free",
            Said(
                f"the damping is {number:g} in every call, whatever is handed in",
                next="Use the argument damping.",
            ),
            _typed_in(number),
        )
        for number in (0.01, 0.02, 0.03, 0.05, 0.1, 0.2, 0.5, 1.0)
    ),
)


def branched_at_once(tasks: Sequence[tuple]) -> list[NDArray]:
    """What the right ``branches`` gives for each pose, all of them solved together."""
    return branches_of_all(np.array([T for (T,) in tasks]))


# ---- 08.8: angles of the wrist read off with other signs; θ4 and θ6 enter both wrists alike

READINGS = (  # (mistake, what is said of the angle, what becomes of it), the right one first
    ("", "", lambda angle: angle),
    ("atan-for-atan2", "is off by 180°: both signs go into arctan2", lambda angle: angle + np.pi),
    (
        "joint-reversed",
        "runs the wrong way: look at the sign of the first argument of arctan2",
        lambda angle: -angle,
    ),
    (
        "atan-for-atan2",
        "runs the wrong way: look at the sign of the second argument of arctan2",
        lambda angle: np.pi - angle,
    ),
    (
        "atan-for-atan2",
        "is off: the arguments of arctan2 have changed places",
        lambda angle: np.pi / 2 - angle,
    ),
)


def _read(changes):
    """All branches with angles of the wrist changed where arctan2 reads them off; ``changes``:
    (place, function of the first wrist's angle).
    """

    def version(T):
        Q = branches(T)
        half_turn = np.where(np.sin(Q[:, 4]) > 0, 0, np.pi)
        for k, change in changes:
            Q[:, k] = change(Q[:, k] - half_turn) + half_turn
        return in_order(Q)

    return version


def _misread():
    for (mistake_4, words_4, change_4), (mistake_6, words_6, change_6) in list(
        product(READINGS, repeat=2)
    )[1:]:
        headline = "; ".join(
            f"{name} {words}" for name, words in (("θ4", words_4), ("θ6", words_6)) if words
        )
        yield (
            mistake_4 or mistake_6,
            Said(
                headline,
                next=(
                    "Compare with the last column and the last row: each entry has a sign of its"
                    " own."
                ),
            ),
            _read(((3, change_4), (5, change_6))),
        )


MISREAD = tuple(_misread())
