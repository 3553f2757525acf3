"""The verb ``dhlab doctor``: what is wrong with a table, from measured poses, with a tape measure,
or one joint at a time.
"""

import json
import sys
from pathlib import Path
from typing import Annotated

import typer

from .against import against_arm, axes_of, is_arm, sheet_in
from .common import arm_of, units_of
from .doctor_program import diagnose_program
from .measured import noise_of, units_of_poses

__all__ = ["doctor"]


def doctor(
    arm: Annotated[
        str,
        typer.Argument(
            metavar="ARM",
            help=(
                "The table that is doubted: a name of the library, a .yaml or .csv table file, a"
                " URDF, or an axis sheet. Or a program.py with dh_transform or"
                " forward_kinematics."
            ),
        ),
    ],
    poses: Annotated[
        str,
        typer.Argument(
            metavar="POSES.csv",
            help=(
                "What was measured: columns q1,…,qn,x,y,z and, where known, an orientation. Or an"
                " arm that is right, such as a URDF: then nothing is measured. After a program.py:"
                " the one arm that it is written for, if it is."
            ),
        ),
    ] = "",
    units: Annotated[
        str,
        typer.Option(
            help=(
                "Of the poses file, such as mm,deg or m,rad; left out where a line of the file says"
                " so: # units: mm,deg."
            )
        ),
    ] = "",
    free_base: Annotated[
        bool,
        typer.Option(
            "--free-base", help="Measured in another base frame, which is to be found as well."
        ),
    ] = False,
    free_tool: Annotated[
        bool,
        typer.Option(
            "--free-tool", help="Measured at another tool frame, which is to be found as well."
        ),
    ] = False,
    noise: Annotated[
        str,
        typer.Option(
            help=(
                "Of the measurements, such as 1mm,0.2deg (1mm for positions alone); estimated when"
                " left out."
            )
        ),
    ] = "",
    repair: Annotated[
        str,
        typer.Option(
            "--repair",
            metavar="FILE.yaml",
            help="Write the repaired arm; an existing file is kept.",
        ),
    ] = "",
    budget: Annotated[
        float,
        typer.Option(
            metavar="SECONDS",
            help="Processor time for the search; the best answer so far is given when it is over.",
        ),
    ] = 10.0,
    motion: Annotated[
        bool, typer.Option("--motion", help="The file holds sweeps: one joint moved at a time.")
    ] = False,
    protocol: Annotated[
        bool,
        typer.Option(
            "--protocol", help="Say which poses to drive to and what to measure; needs no file."
        ),
    ] = False,
    sheet: Annotated[
        str,
        typer.Option(
            "--sheet",
            metavar="FILE.csv",
            help="With --protocol: write the sheet to fill in; an existing file is kept.",
        ),
    ] = "",
    convention: Annotated[
        str, typer.Option(help="Of a program.py: standard or craig, whose link matrix it computes.")
    ] = "",
    as_json: Annotated[
        bool, typer.Option("--json", help="Print JSON for a program to read.")
    ] = False,
) -> None:
    """What is wrong with an arm's table, from measured poses, or with a program; or, with
    --protocol, what to measure.
    """
    if arm.endswith(".py"):
        diagnose_program(arm, poses, convention, as_json)
        return
    if convention:
        raise ValueError(
            f"doctor: expected --convention with a program.py only, found it with {arm}; a table"
            " says its own, leave it out"
        )
    _check(poses, protocol, sheet, repair, motion, free_base or free_tool)
    level = noise_of(noise)
    if units:
        units_of(units, "doctor")
    if poses and not motion and is_arm(poses):
        if noise or units or repair:
            raise ValueError(
                f"doctor: expected no --noise, --units or --repair with {poses}, found one of"
                " them; it is an arm, whose poses are computed: leave them out"
            )
        against_arm(arm, poses, free_base, free_tool, budget, as_json)
        return
    axes = None if protocol or motion else sheet_in(arm)
    if axes is not None:
        if free_base or free_tool:
            raise ValueError(
                f"doctor: expected poses in the base frame and at the end of {arm}, an axis sheet,"
                " found --free-base or --free-tool; leave them out, the end pose is looked at too"
            )
        axes_of(axes, poses, units_of_poses(units, poses), level, repair, budget, as_json)
        return
    model = arm_of(arm)
    lengths, angles = (None, None) if protocol else units_of_poses(units, poses)
    if protocol:
        _give_protocol(model, sheet, as_json)
        return
    answer = (
        _motion(model, poses, lengths, angles, level, budget)
        if motion
        else _poses(model, poses, lengths, angles, level, free_base, free_tool, budget)
    )
    print(json.dumps(answer.to_dict(), ensure_ascii=False) if as_json else answer)
    if repair:
        _write_repair(answer, model, repair)


def _check(poses, protocol, sheet, repair, motion, free):
    """Options that do not go together, before anything is computed."""
    if protocol and (poses or motion or repair):
        raise ValueError(
            "doctor: --protocol says what to measure and reads nothing; leave POSES.csv, --motion"
            " and --repair out, or leave --protocol out"
        )
    if not protocol and not poses:
        raise ValueError(
            "doctor: expected POSES.csv, a file of measured poses, after ARM, found none; with"
            " --protocol the doctor says what to measure"
        )
    if sheet and not protocol:
        raise ValueError("doctor: --sheet goes with --protocol; add it, or leave --sheet out")
    if motion and (repair or free):
        raise ValueError(
            "doctor: --motion compares circle by circle and repairs nothing; leave --repair,"
            " --free-base and --free-tool out"
        )
    if repair and Path(repair).suffix.lower() not in (".yaml", ".yml"):
        raise ValueError(f"doctor: --repair: expected a name that ends in .yaml, found {repair!r}")
    for name, file in (("--repair", repair), ("--sheet", sheet)):
        if file and Path(file).exists():
            raise ValueError(
                f"doctor: {name}: {file}: expected a new file, found one that exists; choose"
                " another name"
            )


def _poses(model, path, lengths, angles, noise, free_base, free_tool, budget):
    from ..doctor import diagnose
    from ..formats.posefile import read_poses

    q, measured = read_poses(path, len(model), lengths, angles, joints=model.table.joints)
    return diagnose(
        model,
        q,
        measured,
        noise=noise,
        base="free" if free_base else "fixed",
        tool="free" if free_tool else "fixed",
        budget=budget,
    )


def _motion(model, path, lengths, angles, noise, budget):
    from ..doctor.arms.motion import diagnose_motion
    from ..formats.posefile import read_poses

    q, measured = read_poses(path, len(model), lengths, angles, joints=model.table.joints)
    return diagnose_motion(model, q, measured, noise=noise and noise[0], budget=budget)


def _give_protocol(model, sheet, as_json):
    from ..doctor.arms.protocol import protocol
    from ..formats import files

    plan = protocol(model)
    if sheet:
        files.write_text(sheet, plan.to_csv())
    print(json.dumps(plan.to_dict(), ensure_ascii=False) if as_json else plan)


def _write_repair(answer, model, path):
    """The repaired arm into a new file; where there is none, a note in its place."""
    repaired = answer.findings[0].repair if answer.findings else answer.fitted
    if repaired is None or repaired == model:
        why = (
            "the mistake is in the measurements, not in the table"
            if answer.findings
            else f"the verdict is {answer.verdict!r}"
        )
        print(f"Note: {path} was not written: {why}.", file=sys.stderr)
        return
    repaired.save(path)
    print(f"Note: the repaired arm is in {path}.", file=sys.stderr)
