"""The bench log of lesson 09: an encoder that counts the other way, homed at a mechanical stop, and
points measured with a tape.
"""

from dataclasses import replace
from typing import Any

import numpy as np

from ...robots import load
from ..kinds import Mistakes, Said

__all__ = ["COUNTS", "draw_bench", "misread_bench", "reading"]

COUNTS = 4096  # of the encoder, for a whole turn of the joint
TAPE = 4e-3  # m; three of it are the most that a careful hand is off
POSES = 6
AGAIN = "Put the reading at the stop into it: does it give the angle of the stop?"


def draw_bench(rng: np.random.Generator) -> dict[str, Any]:
    """Joint values in radians, but for joint 2, whose encoder was read; the tool's points in m."""
    arm = load("wx200")
    stop, at_stop = -int(rng.integers(109, 113)), int(rng.integers(2900, 3900))
    q = np.deg2rad(rng.integers(15, 60, (POSES, 5)) * rng.choice([-1, 1], (POSES, 5)))
    counts = np.round(at_stop - (np.rad2deg(q[:, 1]) - stop) * COUNTS / 360)
    off = np.clip(rng.normal(0, TAPE, (POSES, 3)), -3 * TAPE, 3 * TAPE)
    return {
        "stop": stop,
        "at_stop": at_stop,
        "counts": counts.astype(int),
        "q": np.column_stack([q[:, :1], np.full(POSES, np.nan), q[:, 2:]]),
        "points": np.round(arm.forward(q)[:, :3, 3] + off, 3),
    }


def reading(stop: int, at_stop: int, **log: Any) -> list[float]:
    """[sign, offset in degrees]: q2 = sign · counts · 360° / 4096 + offset."""
    return [-1.0, stop + at_stop * 360 / COUNTS]


def misread_bench(stop: int, at_stop: int, **log: Any) -> Mistakes:
    """What one slip makes of the two numbers."""
    turn = at_stop * 360 / COUNTS
    yield (
        "joint-reversed",
        Said(
            "right at the stop, and from there the wrong way",
            next="The log says that the encoder counts down where q2 grows.",
        ),
        [1, stop - turn],
    )
    yield (
        "joint-reversed",
        Said("the offset is right; the sign is not", next=AGAIN),
        [1, stop + turn],
    )
    for turns in (1, -1):
        yield (
            "offset-value",
            Said(
                f"at the stop these two give {stop + 360 * turns}°, a whole turn from where the"
                " joint is",
                next="A joint with a stop does not turn round: its angle there is the log's"
                " number, and no other.",
            ),
            [-1, stop + turn + 360 * turns],
        )
    for sign, of_sign in ((-1, "the sign is right; in"), (1, "the sign is not right; and in")):
        for mistake, said, offset in _wrong_offsets(stop, at_stop, turn):
            if (sign, offset) != (1, stop - turn):
                yield mistake, replace(said, headline=f"{of_sign} {said.headline}"), [sign, offset]


def _wrong_offsets(stop, at_stop, turn):
    """What one slip makes of the offset, told after "in"."""
    other = "the offset the {} has the other sign"
    left_out = "the offset the {} is left out"
    for mistake, headline, offset in (
        ("offset-sign", other.format("stop's angle"), turn - stop),
        ("offset-sign", other.format("reading"), stop - turn),
        ("offset-sign", "the offset both parts have the other sign", -stop - turn),
        ("offset-missing", left_out.format("stop's angle"), turn),
        ("offset-missing", left_out.format("reading at the stop"), stop),
        (
            "offset-sign",
            "the offset the reading is left out, and the stop's angle has the other sign",
            -stop,
        ),
    ):
        yield mistake, Said(headline, next=AGAIN), offset
    yield (
        "angle-unit",
        Said(
            "the offset the reading is still in counts", next=f"{COUNTS} counts are a whole turn."
        ),
        stop + at_stop,
    )
