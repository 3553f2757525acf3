"""The verb ``dhlab fk``: forward kinematics."""

import json
import re
from typing import Annotated

import numpy as np
import typer

from ..printing import matrix_text, number
from ..transform import to_xyz_rpy
from .common import ArmName, Json, arm_of

__all__ = ["fk"]


def fk(
    arm: ArmName,
    q: Annotated[
        str, typer.Option("--q", help="Joint values, separated by commas; all 0 when left out.")
    ] = "",
    deg: Annotated[
        bool,
        typer.Option(
            "--deg",
            help=(
                "The values of revolute joints are degrees, not radians (prismatic ones are"
                " metres)."
            ),
        ),
    ] = False,
    frames: Annotated[
        bool, typer.Option("--frames", help="Print every frame of the chain as well.")
    ] = False,
    as_json: Json = False,
) -> None:
    """Forward kinematics: where the end is, tool included."""
    model = arm_of(arm)
    values = _joint_values(q, model, deg)
    pose = model.forward(values)
    if as_json:
        answer = {
            "arm": model.name,
            "units": {"length": "m", "angle": "rad"},
            "q": values.tolist(),
            "pose": pose.tolist(),
            "within_limits": model.within_limits(values).tolist(),
        }
        print(
            json.dumps(
                answer | ({"frames": model.frames(values).tolist()} if frames else {}),
                ensure_ascii=False,
            )
        )
        return
    print(_pose_text(f"{model.name}: end pose", pose))
    for i, frame in enumerate(model.frames(values) if frames else []):
        print(_pose_text(f"frame {i}", frame))
    outside = [str(i) for i, inside in enumerate(model.within_limits(values), 1) if not inside]
    if outside:
        print(
            f"Note: outside the stated limits: joint {', '.join(outside)}. The pose is right for"
            " these values all the same."
        )


def _joint_values(text, model, deg):
    cells = (
        [cell for cell in re.split(r"[,\s]+", text.strip()) if cell]
        if text.strip()
        else ["0"] * len(model)
    )
    try:
        values = np.array([float(cell) for cell in cells])
    except ValueError:
        raise ValueError(
            f"--q: expected {len(model)} numbers separated by commas, found {text!r}; write 0.5,"
            " not 1/2 or 0,5"
        ) from None
    if len(values) != len(model):
        raise ValueError(
            f"--q: expected {len(model)} numbers, one per joint of {model.name}, found"
            f" {len(values)}; write them as --q 0,0.1,…"
        )
    return np.where(model.table.prismatic | (not deg), values, np.deg2rad(values))


def _pose_text(title, pose):
    xyz, rpy = to_xyz_rpy(pose)
    return "\n".join(
        [
            title,
            f"  position (m)              {'  '.join(number(v) for v in xyz)}",
            (
                f"  roll, pitch, yaw (deg)    {'  '.join(number(v, 4) for v in np.rad2deg(rpy))}  "
                " (about fixed x, y, z)"
            ),
            *("  " + line for line in matrix_text(pose).splitlines()),
        ]
    )
