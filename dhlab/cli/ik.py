"""The verb ``dhlab ik``: inverse kinematics."""

import json
import re
import sys
from typing import Annotated

import numpy as np
import typer

from ..transform import from_xyz_rpy
from ..units import ANGLE, LENGTH
from .common import ArmName, Json, arm_of, units_of

__all__ = ["ik"]


def ik(
    arm: ArmName,
    pose: Annotated[
        str,
        typer.Option(
            "--pose",
            metavar="x,y,z,roll,pitch,yaw",
            help="Where the end shall be, tool included; angles about fixed x, y, z.",
        ),
    ] = "",
    units: Annotated[
        str, typer.Option(help="Of every number given, such as mm,deg or m,rad.")
    ] = "",
    limits: Annotated[
        bool, typer.Option("--limits", help="Only what keeps the arm's stated limits.")
    ] = False,
    near: Annotated[
        str, typer.Option(help="Where the arm stands, one value per joint; nearest to it first.")
    ] = "",
    redundancy: Annotated[
        str,
        typer.Option(
            metavar="JOINT=VALUE",
            help="For more than six joints: which one is held and where, such as 3=20.",
        ),
    ] = "",
    prepare: Annotated[
        bool,
        typer.Option(
            "--prepare",
            help="First derive what a general six-axis arm needs: minutes, once, kept on disk.",
        ),
    ] = False,
    as_json: Json = False,
) -> None:
    """Inverse kinematics: every configuration that brings the end to a pose, or why there is none;
    exit status 1 when there is none.
    """
    model = arm_of(arm)
    if prepare:
        _prepare(model)
        if not pose:
            return
    scales = _scales(pose, units)
    answer = model.solve(
        _target(pose, *scales),
        limits=limits,
        near=_near(near, model, *scales) if near.strip() else None,
        redundancy=_redundancy(redundancy, model, *scales) if redundancy.strip() else None,
    )
    if as_json:
        about = {"arm": model.name, "units": {"length": "m", "angle": "rad"}}
        print(json.dumps(about | answer.to_dict(), ensure_ascii=False))
    else:
        print(answer)
    if not answer:
        raise typer.Exit(1)


def _prepare(model):
    from ..inverse import prepare
    from ..inverse.candidates import needs_preparation

    if needs_preparation(model):
        print(
            f"Preparing {model.name}: this takes minutes, once; it is kept in your cache folder.",
            file=sys.stderr,
            flush=True,
        )
    if not prepare(model):
        print(
            "Note: there is nothing to prepare; without the extra [ik], and for other arms than"
            " those of six turning joints, solutions are searched.",
            file=sys.stderr,
        )


def _scales(pose, units):
    if not pose.strip():
        raise ValueError(
            "ik: expected --pose x,y,z,roll,pitch,yaw, found none; as in --pose 400,100,300,180,0,0"
            " --units mm,deg"
        )
    if not units.strip():
        raise ValueError(
            "ik: expected the units of --pose, found none; add --units mm,deg or --units m,rad"
        )
    length, angle = units_of(units, "ik")
    return LENGTH[length], ANGLE[angle]


def _numbers(text, count, what):
    cells = [cell for cell in re.split(r"[,\s]+", text.strip()) if cell]
    try:
        values = np.array([float(cell) for cell in cells])
    except ValueError:
        values = np.array([np.nan])
    if len(values) != count or not np.isfinite(values).all():
        raise ValueError(
            f"ik: {what}: expected {count} numbers separated by commas, found {text!r}; write 0.5,"
            " not 1/2 or 0,5"
        )
    return values


def _target(pose, length, angle):
    values = _numbers(pose, 6, "--pose")
    return from_xyz_rpy(values[:3] * length, values[3:] * angle)


def _near(near, model, length, angle):
    values = _numbers(near, len(model), "--near")
    return values * np.where(model.table.prismatic, length, angle)


def _redundancy(text, model, length, angle):
    found = re.fullmatch(r"\s*(\d+)\s*=\s*([-+.\deE]+)\s*", text)
    given = found.groups() if found else ("", "")
    try:
        joint, value = int(given[0]), float(given[1])
    except ValueError:
        raise ValueError(
            f"ik: --redundancy: expected a joint and its value, such as 3=20, found {text!r}"
        ) from None
    slides = 1 <= joint <= len(model) and model.table.prismatic[joint - 1]
    return {joint: value * (length if slides else angle)}
