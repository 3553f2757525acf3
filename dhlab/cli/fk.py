"""The verb ``dhlab fk``: forward kinematics."""

import json
import re
from dataclasses import replace
from typing import Annotated

import numpy as np
import typer

from ..printing import matrix_text, number
from ..transform import from_xyz_rpy, to_xyz_rpy
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
    tool: Annotated[
        str,
        typer.Option(
            "--tool",
            metavar="x,y,z[,roll,pitch,yaw]",
            help="A tool on the arm's own end; m and, angles about fixed x, y, z, deg with --deg.",
        ),
    ] = "",
    frames: Annotated[
        bool, typer.Option("--frames", help="Print every frame of the chain as well.")
    ] = False,
    as_json: Json = False,
) -> None:
    """Forward kinematics: where the end is, tool included."""
    model = arm_of(arm)
    values = _joint_values(q, model, deg)
    if tool:
        model = replace(model, tool=model.tool @ _tool(tool, deg))
    pose = model.forward(values)
    if as_json:
        answer = {
            "arm": model.name,
            "units": {"length": "m", "angle": "rad"},
            "q": values.tolist(),
            "pose": pose.tolist(),
            **_orientations(pose),
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


def _tool(text, deg):
    """The pose (4, 4) of a tool in the frame of the arm's end."""
    cells = [cell for cell in re.split(r"[,\s]+", text.strip()) if cell]
    try:
        values = np.array([float(cell) for cell in cells])
    except ValueError:
        values = np.array([])
    if len(values) not in (3, 6) or not np.isfinite(values).all():
        raise ValueError(
            "fk: --tool: expected x,y,z in metres and perhaps roll,pitch,yaw, found"
            f" {text[:60]!r}; write 0,0,0.1 for a tool 100 mm long"
        )
    rpy = values[3:] if len(values) == 6 else np.zeros(3)
    return from_xyz_rpy(values[:3], np.deg2rad(rpy) if deg else rpy)


def _orientations(pose):
    """The same rotation as others write it: radians; each by its name."""
    from scipy.spatial.transform import Rotation  # large: only where it is asked for

    turn = Rotation.from_matrix(pose[:3, :3])
    x, y, z, w = turn.as_quat(canonical=True)
    _, (roll, pitch, yaw) = to_xyz_rpy(pose)
    return {
        "roll_pitch_yaw": [float(v) for v in (roll, pitch, yaw)],
        "rotation_vector": turn.as_rotvec().tolist(),
        "quaternion_wxyz": [float(v) for v in (w, x, y, z)],
        "quaternion_xyzw": [float(v) for v in (x, y, z, w)],
        "kuka_abc": [float(v) for v in (yaw, pitch, roll)],
    }


def _other_three(rpy):
    """The other roll, pitch, yaw of a rotation, which some programs print: half a turn more of
    roll and yaw, the pitch taken from half a turn.
    """
    roll, pitch, yaw = rpy
    return np.array([_half_turn(roll), np.copysign(np.pi, pitch) - pitch, _half_turn(yaw)])


def _half_turn(angle):
    return angle - np.copysign(np.pi, angle)


def _pose_text(title, pose):
    xyz, rpy = to_xyz_rpy(pose)
    given = _orientations(pose)

    def degrees(values):
        return "  ".join(number(v, 4) for v in np.rad2deg(values))

    def plain(values):
        return "  ".join(number(v) for v in values)

    return "\n".join(
        [
            title,
            f"  position (m)              {plain(xyz)}",
            f"  roll, pitch, yaw (deg)    {degrees(rpy)}   (about fixed x, y, z)",
            f"  or, the same rotation     {degrees(_other_three(rpy))}",
            f"  KUKA A, B, C (deg)        {degrees(given['kuka_abc'])}   (about moving z, y, x)",
            f"  rotation vector (rad)     {plain(given['rotation_vector'])}   (as UR prints it)",
            f"  quaternion w, x, y, z     {plain(given['quaternion_wxyz'])}",
            f"  quaternion x, y, z, w     {plain(given['quaternion_xyzw'])}   (as ROS has it)",
            *("  " + line for line in matrix_text(pose).splitlines()),
        ]
    )
