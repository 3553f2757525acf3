"""What lesson 08 draws and says of joint speeds: the hand of a Stanford arm."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...doctor.programs.wrong.jacobians import geometric_jacobian
from ...robots import load
from ..kinds import Mistakes, Said, Value
from ..verdict import RIGHT, Verdict
from .answers08 import seen_at

__all__ = ["Speeds", "draw_hand_speed", "joint_speeds", "wrong_speeds"]

SOLVE = "Solve J · speeds = velocity: six equations, six unknowns."


def draw_hand_speed(rng: np.random.Generator) -> dict[str, Any]:
    q = [
        rng.choice(values)
        for values in (
            [-30, 20, 40],
            [50, 65, 80],
            [0.4, 0.5, 0.6],
            [-50, 25, 60],
            [-70, -45, 40, 60],
            [15, 70],
        )
    ]
    return {
        "q": [float(value) for value in q],
        "v": [float(value) for value in rng.choice([-0.3, -0.2, -0.1, 0.1, 0.2, 0.3], 3)],
        "omega": [float(value) for value in rng.choice([-0.8, -0.6, -0.4, 0.4, 0.6, 0.8], 3)],
    }


def joint_speeds(q: list[float], v: list[float], omega: list[float]) -> NDArray:
    return np.linalg.solve(geometric_jacobian(*seen_at("stanford", q)), [*v, *omega])


def wrong_speeds(q: list[float], v: list[float], omega: list[float]) -> Mistakes:
    frames, T_end, sliding = seen = seen_at("stanford", q)
    right, J, twist = joint_speeds(q, v, omega), geometric_jacobian(*seen), np.array([*v, *omega])
    yield (
        "jacobian-rows-exchanged",
        "v was put where ω belongs",
        np.linalg.solve(J, np.roll(twist, 3)),
    )
    yield (
        "jacobian-transpose-only",
        Said(
            "this is Jᵀ times the hand's velocity, and the transpose is not the inverse", next=SOLVE
        ),
        J.T @ twist,
    )
    yield (
        "jacobian-transpose-only",
        Said(
            "this is J times the hand's velocity",
            why="Joint speeds go into J; the hand's velocity comes out.",
            next=SOLVE,
        ),
        J @ twist,
    )
    yield (
        "error-sign",
        Said(
            "all six speeds have the other sign",
            next="Multiply J by your speeds: which way does the hand go then?",
        ),
        -right,
    )
    yield (
        "degrees-in-sin-cos",
        "q was left in degrees",
        np.linalg.solve(geometric_jacobian(*_at_radians(q)), twist),
    )
    yield (
        "angle-unit",
        Said("joint 3's value went through deg2rad too", why="It slides: its value is in metres."),
        np.linalg.solve(geometric_jacobian(*_at_radians(np.deg2rad(q))), twist),
    )
    yield (
        "degrees-for-radians",
        Said(
            "all six went through rad2deg: radians and metres per second are asked",
            next="Hand in what np.linalg.solve gives.",
        ),
        np.rad2deg(right),
    )
    for said, turned in (("deg2rad", np.deg2rad(omega)), ("rad2deg", np.rad2deg(omega))):
        yield (
            "angle-unit",
            Said(
                f"ω went through {said}: it is given in rad/s, and rad/s are asked",
                next="Take v and ω as they are given.",
            ),
            np.linalg.solve(J, [*v, *turned]),
        )
    yield (
        "wrong-frame-compared",
        Said(
            "these speeds fit the Jacobian of the article's arm",
            next="Which arm is in arm, and which in stanford?",
        ),
        _of_the_article(np.where(sliding, q, np.deg2rad(q)), twist),
    )
    for damping in (0.01, 0.05, 0.1, 0.5):
        yield (
            "damping-taken-for-free",
            Said(
                "this is a damped step: the hand lags behind what was asked",
                next=f"Here the arm is far from singular. {SOLVE}",
            ),
            _damped(J, twist, damping),
        )
    for wrong in (np.linalg.pinv(J[:3]) @ v, np.linalg.solve(J, [*v, 0, 0, 0])):
        yield (
            "angular-part-missing",
            Said("the hand goes at v, but does not turn with ω", next=SOLVE),
            wrong,
        )
    yield (
        "angular-part-missing",
        Said("the hand turns with ω, but does not go at v", next=SOLVE),
        np.linalg.solve(J, [0, 0, 0, *omega]),
    )
    yield (
        "prismatic-column-wrong",
        "the slide is treated as a turning joint",
        np.linalg.pinv(geometric_jacobian(frames, T_end, [False] * 6)) @ twist,
    )
    for other in (
        np.eye(4),
        *frames[1:-1],
        load("article-6r").forward(np.deg2rad([30, 60, -80, -30, 40, 0])),
    ):
        yield (
            "lever-arm-wrong",
            Said(
                "these speeds fit another end point",
                next="The hand is where stanford.forward puts it at your q.",
            ),
            np.linalg.solve(geometric_jacobian(frames, other, sliding), twist),
        )
    yield from _by_other_jacobians(frames, T_end, sliding, twist)


def _of_the_article(q, twist):
    """Speeds of the arm that has been in memory since the lesson's first cell."""
    return np.linalg.pinv(load("article-6r").jacobian(q)) @ twist


def _by_other_jacobians(frames, T_end, sliding, twist):
    """Speeds that fit a Jacobian with one slip in it."""
    J, p, R = geometric_jacobian(frames, T_end, sliding), T_end[:3, 3], T_end[:3, :3]
    moved = np.concatenate([frames[1:], T_end[None]])
    z = frames[:-1, :3, 2]
    to_base = np.where(sliding, z.T, np.cross(z, p).T)
    turns_too = J.copy()
    turns_too[3:, sliding] = z[sliding].T
    for mistake, said, wrong in (
        (
            "cross-product-reversed",
            "these speeds fit a Jacobian whose cross products are the wrong way round",
            np.vstack([np.where(sliding, J[:3], -J[:3]), J[3:]]),
        ),
        (
            "jacobian-axis-off-by-one",
            "these speeds fit a Jacobian that takes the axis of joint i from frame i",
            geometric_jacobian(moved, T_end, sliding),
        ),
        (
            "lever-arm-wrong",
            "these speeds fit a Jacobian whose levers all begin at the base's origin",
            np.vstack([to_base, J[3:]]),
        ),
        (
            "prismatic-column-wrong",
            "these speeds fit a Jacobian in which joint 3 slides and turns",
            turns_too,
        ),
        (
            "jacobian-frame",
            "these speeds fit a Jacobian that is written in the end's own axes",
            np.vstack([R.T @ J[:3], R.T @ J[3:]]),
        ),
    ):
        if np.linalg.cond(wrong) < 1e6:
            yield mistake, said, np.linalg.solve(wrong, twist)


def _damped(J, twist, damping):
    return J.T @ np.linalg.solve(J @ J.T + damping**2 * np.eye(6), twist)


@dataclass(frozen=True, kw_only=True)
class Speeds(Value):
    """Joint speeds of the Stanford arm; it knows a slide that was treated as a turning joint, too:
    then J has no inverse, and any huge numbers come out.
    """

    def compare(self, answer: object, variant: int) -> Verdict:
        verdict = super().compare(answer, variant)
        try:
            speeds = np.asarray(answer, dtype=float)
        except (TypeError, ValueError):
            return verdict
        if (
            verdict.status == RIGHT
            or verdict.mistake
            or speeds.shape != (6,)
            or not np.isfinite(speeds).all()
        ):
            return verdict
        frames, T_end, _ = seen_at("stanford", self.given(variant)["q"])
        lost = np.linalg.svd(geometric_jacobian(frames, T_end, [False] * 6))[2][-1]
        if np.linalg.norm(speeds) < 1e6 or abs(lost @ speeds) < 0.9999 * np.linalg.norm(speeds):
            return verdict
        return self.wrong(
            "prismatic-column-wrong",
            place=Said(
                "these speeds are beyond all measure: the slide is treated as a turning joint",
                next="Which entry of sliding is True here?",
                why=(
                    "Axes 3 and 4 lie on one line: if both turn, J has two equal columns and no"
                    " inverse."
                ),
            ),
        )


def _at_radians(q):
    arm = load("stanford")
    return arm.frames(q), arm.forward(q), arm.table.prismatic
