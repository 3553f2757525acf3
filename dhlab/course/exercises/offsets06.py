"""What 06.6 expects and says of wrong answers: an arm whose encoders read 0 elsewhere."""

import numpy as np

from ...arm import Arm
from ...table import DHTable
from ..kinds import Mistakes, Said

__all__ = ["UPRIGHT", "wrong_offsets"]

UPRIGHT: list[list[float]] = [
    [0, 0.1, 0, 90],
    [90, 0, 0.4, 0],
    [-90, 0, 0.35, 0],
    [0, 0.1, 0, 90],
    [0, 0, 0, -90],
    [0, 0.1, 0, 0],
]


def _upright(offset_2, offset_3):
    rows = [list(row) for row in UPRIGHT]
    rows[1][0], rows[2][0] = offset_2, offset_3
    return Arm(DHTable.standard(rows, angle="deg"))


STANDS = {
    0: "is level, pointing forward",
    90: "points straight up",
    180: "is level, pointing backward",
    270: "points straight down",
}  # by its angle to the floor


def wrong_offsets() -> Mistakes:
    """The offsets of 06.6 in radians, and in other quarter turns: what the arm then looks like
    where the encoders read 0.
    """
    radians = Said(
        "the offsets look like radians", next="This table is in degrees: 90, not 1.5708."
    )
    for quarter in (np.pi / 2, 1.57, 1.571, 1.5708):
        for signs in ((1, -1), (1, 0), (0, -1), (1, 1), (-1, 1), (-1, -1), (-1, 0), (0, 1)):
            yield "angle-unit", radians, _upright(signs[0] * quarter, signs[1] * quarter)
    for offset_2 in STANDS:
        for offset_3 in STANDS:
            if (offset_2, offset_3) != (90, 270):
                yield (
                    _offset_mistake(offset_2, offset_3),
                    _seen(offset_2, offset_3),
                    _upright(offset_2, offset_3),
                )


def _offset_mistake(offset_2, offset_3):
    if (offset_2 == 0 and offset_3 in (0, 270)) or (offset_2, offset_3) == (90, 0):
        return "offset-missing"
    if (offset_2, offset_3) in ((90, 90), (270, 270), (270, 90)):
        return "offset-sign"
    return (
        "offset-counted-twice"
        if (offset_2, offset_3) in ((90, 180), (180, 270))
        else "offset-value"
    )


def _seen(offset_2, offset_3):
    if offset_2 != 90:
        return Said(
            f"where the encoders read 0, your upper arm {STANDS[offset_2]}",
            next="It must point straight up there; positive q2 lifts it from the level.",
        )
    return Said(
        "the upper arm is right; where the encoders read 0, your forearm"
        f" {STANDS[(offset_2 + offset_3) % 360]}",
        next=(
            "θ3 is measured from the upper arm, not from the floor. With the arm up, which θ3 makes"
            " the forearm level?"
        ),
    )
