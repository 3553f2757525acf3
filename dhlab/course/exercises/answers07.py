"""What lesson 07 draws, what is right, and what the wrong answers are told:
symptoms, broken tables, measured poses.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...arm import Arm
from ...doctor.programs.wrong.links import standard
from ...doctor.programs.wrong.products import product
from ...robots import load
from ...rotations import from_rotation_vectors
from ...table import DHTable
from ...transform import trans_x, trans_z
from ..kinds import Known, Mistakes, Said
from .answers06 import ARTICLE

__all__ = [
    "CAUSES",
    "CRANE",
    "OF_SYMPTOMS",
    "PUMA",
    "article",
    "draw_length",
    "draw_offsets",
    "draw_pasted",
    "explain_match",
    "fitted_offsets",
    "mended_length",
    "offsets_of",
    "story",
    "turned_by_theta",
    "two_sources",
    "wrong_offsets",
]

# noise, m and rad: of a tape, of a camera, of good optics, of an orientation
TAPE, COARSE, FINE, TURN = 4e-3, 5e-4, 3e-4, 2e-3
LENGTHS = (0, 1), (2, 2), (5, 1)  # row and column, from 0, of d1, a3 and d6
GAUSS_NEWTON = 5  # steps; the last changes nothing beyond 1e-9 rad
PUMA: list[list[float]] = [
    [0, 0.67183, 0, 90],
    [0, 0, 0.4318, 0],
    [0, 0.15005, 0.0203, -90],
    [0, 0.4318, 0, 90],
    [0, 0, 0, -90],
    [0, 0, 0, 0],
]
CRANE: list[list[float]] = [  # of 07.4: of another arm than 07.6, whose right table it would show
    [0, 0.3, 0, 90],
    [0, 0, 0.5, 0],
    [0, 0.1, 0.4, 0],
]
CAUSES = {
    "base-height": ("the base's height is missing", "base-height-missing-or-twice"),
    "degrees": ("degrees passed to sin and cos", "degrees-in-sin-cos"),
    "tool": ("the tool is left out", "tool-missing"),
    "limit": ("a joint limit is exceeded", "limits-in-forward"),
    "length": ("one length (a) has the wrong value", "length-value"),
    "reversed-joint": ("a joint counts the other way", "joint-reversed"),
}
OF_SYMPTOMS = ["degrees", "length", "reversed-joint", "base-height", "tool"]
TRACES = {
    "base-height": "seen from the base, every pose would be shifted by one and the same vector",
    "degrees": "a small turn of a joint would become a leap, since 1 would be taken for 57°",
    "tool": "seen from the last frame, every pose would be shifted by one and the same vector",
    "limit": "no trace at all; forward kinematics has a pose for any q",
    "length": (
        "the rotation would be right, and the residual would lie along one arrow of the arm at"
        " every pose"
    ),
    "reversed-joint": "at q = 0 all is well, and one joint turns the wrong way from there",
}


def article() -> Arm:
    return Arm(DHTable.standard(ARTICLE, angle="deg"))


def _general(rng, m, arm):
    """Configurations (m, n) in whole degrees, none near 0 or 90°, the arm above the floor; as
    radians.
    """
    q = np.deg2rad(
        rng.integers(15, 76, (60 * m, len(arm))) * rng.choice([-1, 1], (60 * m, len(arm)))
    )
    return q[(arm.frames(q)[:, 1:, 2, 3] > 0.05).all(axis=1)][:m]


def _points(rng, arm, q, noise):
    return arm.forward(q)[:, :3, 3] + rng.normal(0, noise, (len(q), 3))


def _poses(rng, arm, q, noise, turn):
    T = arm.forward(q)
    T[:, :3, 3] += rng.normal(0, noise, (len(q), 3))
    T[:, :3, :3] = T[:, :3, :3] @ from_rotation_vectors(rng.normal(0, turn, (len(q), 3)))
    return T


def _one_by_one(rest):
    """Configurations (78, 6) in which one joint after the other moves; ``rest`` in degrees."""
    sweeps = np.tile(np.deg2rad(rest), (6 * 13, 1))
    for i in range(6):
        sweeps[13 * i : 13 * (i + 1), i] = np.deg2rad(np.linspace(-60, 60, 13))
    return sweeps


def explain_match(causes: list[str]) -> Known | None:
    """The first wrong cause, and what it would have looked like."""
    k, given = next(
        (k, given) for k, (given, right) in enumerate(zip(causes, OF_SYMPTOMS), 1) if given != right
    )
    cause, mistake = CAUSES[given]
    return mistake, Said(
        f"symptom {k} has another cause",
        why=f"“{cause}” would look like this: {TRACES[given]}. Does symptom {k} say that?",
    )


def two_sources(rows: NDArray, q: NDArray) -> NDArray:
    """The broken program of 07.2: alpha is converted a second time."""
    return product(
        rows, q, link=lambda theta, d, a, alpha: standard(theta, d, a, np.deg2rad(alpha))
    )


def draw_length(rng: np.random.Generator) -> dict[str, Any]:
    """An arm of the article's build with lengths of its own, whole centimetres, one of them
    written down wrong; its points as a tape gives them.
    """
    place = LENGTHS[rng.integers(3)]
    wrong_by = rng.choice([-1, 1]) * rng.integers(3, 7) / 100
    rows = np.array(ARTICLE, dtype=float)
    rows[[0, 1, 2, 3, 5], [1, 2, 2, 1, 1]] += rng.integers(-2, 3, 5) / 100
    right = Arm(DHTable.standard(rows.round(2), angle="deg"))
    rows[place] += wrong_by
    rows = rows.round(2)
    while True:
        q = _general(rng, 12, right)
        points = _points(rng, right, q, TAPE)
        # one tape in thousands hides which length it is
        if np.allclose(mended_length(rows, q, points).table.rows, right.table.rows):
            return {"rows": rows, "q": q, "points": points}


def mended_length(rows: NDArray, q: NDArray, points: NDArray) -> Arm:
    """The arm with the one wrong length put right: of the three under suspicion the one along whose
    arrow the points lie off by the same at every pose.
    """
    arm = Arm(DHTable.standard(rows, angle="deg"))
    frames, off = arm.frames(q), points - arm.forward(q)[:, :3, 3]
    arrows = [frames[:, i, :3, 2] if k == 1 else frames[:, i + 1, :3, 0] for i, k in LENGTHS]
    along = [(off * arrow).sum(axis=1) for arrow in arrows]
    guilty = int(np.argmin(np.std(along, axis=1)))
    mended = np.array(rows, dtype=float)
    mended[LENGTHS[guilty]] += along[guilty].mean()
    return Arm(DHTable.standard(mended.round(2), angle="deg"))


def story(rng: np.random.Generator) -> dict[str, Any]:
    """The arm that missed the cup; the same for every learner."""
    rng, real = np.random.default_rng(3), article()
    rows = np.array(ARTICLE, dtype=float)
    rows[3, 3] = -90
    log = _general(rng, 8, real)
    sweeps = _one_by_one([30, 60, -80, -30, 40, 20])
    return {
        "rows": rows,
        "q": log,
        "poses": _poses(rng, real, log, COARSE, TURN),
        "sweeps": sweeps,
        "points": _points(rng, real, sweeps, COARSE),
    }


def turned_by_theta(rows: NDArray, **log: Any) -> Mistakes:
    """θ4 in place of α4: it brings axis 5 to its place, too."""
    turned = rows.copy()
    turned[3, 0] = 180
    yield (
        "offset-value",
        Said(
            "θ4 brings the axis of joint 5 to its place, too, but turns the arc of joint 4 by 180°",
            why="About that joint's axis, the arc was right as it was handed out.",
            next="Put θ4 back. Which other number of row 4 tilts the axis of joint 5?",
        ),
        turned,
    )


def draw_offsets(rng: np.random.Generator) -> dict[str, Any]:
    """Offsets of joints 2 and 3, half degrees; the caller sees only what was measured."""
    offsets = np.zeros(6)
    offsets[1:3] = np.deg2rad(
        rng.permutation([2.5, 3.0, 3.5, 4.5, 5.0, 5.5, 6.0])[:2] * rng.choice([-1, 1], 2)
    )
    q = _general(rng, 20, article())
    return {"q": q, "points": _points(rng, article(), q + offsets, COARSE)}


def fitted_offsets(q: NDArray, points: NDArray) -> NDArray:
    """The offsets of all joints that fit best, in degrees, as ``calibrate_offsets`` finds them: by
    Gauss-Newton steps from 0, which are enough here and need no scipy.
    """
    arm = article()
    offsets = np.zeros(len(arm))
    for _ in range(GAUSS_NEWTON):
        off = points - arm.forward(q + offsets)[:, :3, 3]
        J = arm.jacobian(q + offsets)[:, :3]
        offsets += np.linalg.lstsq(J.reshape(-1, len(arm)), off.ravel())[0]
    return np.rad2deg(offsets)


def offsets_of(q: NDArray, points: NDArray) -> NDArray:
    """Offsets of joints 2 and 3 in degrees: the half degrees that fit best, all others being 0."""
    return np.round(2 * fitted_offsets(q, points)[1:3]) / 2


def wrong_offsets(q: NDArray, points: NDArray) -> Mistakes:
    right, measured = offsets_of(q, points), fitted_offsets(q, points)
    yield "offset-sign", "both offsets have the other sign", -right
    yield "offset-on-wrong-joint", "the offsets of joints 2 and 3 have changed places", right[::-1]
    yield (
        "offset-missing",
        Said(
            "neither offset is 0",
            next="Look into found.offsets: one number per joint, joint 1 first.",
        ),
        np.zeros(2),
    )
    yield "offset-counted-twice", "both offsets are twice as large as they should be", 2 * right
    yield "offset-missing", Said("joint 3 has an offset too"), [right[0], 0]
    yield "offset-missing", Said("joint 2 has an offset too"), [0, right[1]]
    for names, found in (
        ("1 and 2", measured[:2]),
        ("1 and 2", [0, right[0]]),
        ("3 and 4", measured[2:4]),
        ("3 and 4", [right[1], 0]),
    ):
        yield (
            "joint-index-off-by-one",
            Said(
                f"these are joints {names}: offsets[0] belongs to joint 1",
                next="Count from 0: at which places do joints 2 and 3 stand?",
            ),
            found,
        )
    yield "offset-sign", "the offset of joint 2 has the other sign", right * [-1, 1]
    yield "offset-sign", "the offset of joint 3 has the other sign", right * [1, -1]


def draw_pasted(rng: np.random.Generator) -> dict[str, Any]:
    """A Puma 560 as pasted from a paper, one entry with the wrong sign; ten poses that were
    measured, and the tip of a pen while one joint after the other moved.
    """
    rows = np.array(PUMA, dtype=float)
    i, k = [(0, 3), (2, 3), (3, 3), (4, 3), (2, 2), (2, 1)][rng.integers(6)]
    rows[i, k] *= -1
    lines = [
        f"{n:>3}   q{n}   {1000 * d:8.2f}   {1000 * a:7.2f}   {alpha:5.0f}"
        for n, (_, d, a, alpha) in enumerate(rows, 1)
    ]
    text = "\n".join(["  i   theta   d (mm)    a (mm)   alpha (deg)", *lines])
    real, pen = load("puma560"), trans_x(0.1) @ trans_z(0.15)
    q, sweeps = _general(rng, 10, real), _one_by_one([20, -40, 60, 40, 50, 30])
    return {
        "table": text,
        "rows": rows,
        "q": q,
        "poses": _poses(rng, real, q, FINE, TURN),
        "pen": pen,
        "sweeps": sweeps,
        "points": _points(rng, Arm(real.table, tool=pen), sweeps, COARSE),
    }
