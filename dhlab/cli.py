"""The command line: one verb each. Errors are one plain sentence on standard error, exit status 2."""

import json
import os
import re
import sys
from pathlib import Path
from typing import Annotated

import numpy as np
import typer

from . import __version__
from .cli_doctor import doctor
from .cli_grade import grade
from .cli_grading import export, release
from .printing import grid_text, matrix_text, number
from .robots import entry, load, robots
from .transform import to_xyz_rpy

__all__ = ["app", "main"]

app = typer.Typer(help="Learn, teach and debug Denavit-Hartenberg kinematics.", add_completion=False, rich_markup_mode=None, pretty_exceptions_enable=False)
Json = Annotated[bool, typer.Option("--json", help="Print JSON for a program to read.")]


@app.callback(invoke_without_command=True)
def _top(context: typer.Context, version: Annotated[bool, typer.Option("--version", help="Print the version.")] = False):
    if context.invoked_subcommand is None:
        print(__version__ if version else context.get_help())


@app.command()
def lab(folder: Annotated[Path, typer.Argument(help="Your own folder for the course; made when it is not there.")] = Path("my-course"),
        port: Annotated[int, typer.Option(help="The port JupyterLab listens on; a free one when left out.")] = 0,
        browser: Annotated[bool, typer.Option(help="Open a browser window.")] = True):
    """Open the course in JupyterLab, on your own copy of the lessons."""
    from .course.workspace import open_lab
    raise typer.Exit(open_lab(folder, port=port or None, browser=browser))


@app.command(name="robots")
def list_robots(name: Annotated[str, typer.Argument(help="One arm, such as ur5e or piper.sdk_old; all when left out.")] = "", as_json: Json = False):
    """The arms of the library, or the table, source and limits of one."""
    if name:
        arm = load(name)
        print(json.dumps(_described(arm), ensure_ascii=False) if as_json else arm)
        return
    entries = [entry(key) for key in robots()]
    if as_json:
        print(json.dumps([{"name": e.key, "title": e.name, "tables": list(e.tables), "topology": e.topology, "ambiguity": e.ambiguity} for e in entries], ensure_ascii=False))
        return
    rows = [[e.key, len(best := next(iter(e.tables.values()))), best.table.convention, ", ".join(e.tables), e.name] for e in entries]
    print(grid_text(["name", "joints", "convention", "tables, the best first", ""], rows))


def _described(arm):
    table = arm.table
    return {"name": arm.name, "convention": table.convention, "joints": table.joints, "units": {"length": "m", "angle": "rad"},
            "rows": table.rows.tolist(), "sign": arm.sign.tolist(), "base": arm.base.tolist(), "tool": arm.tool.tolist(),
            "limits": arm.limits, "source": arm.source}


@app.command()
def fk(arm: Annotated[str, typer.Argument(metavar="ARM", help="A name of the library, or a .yaml or .csv table file.")],
       q: Annotated[str, typer.Option("--q", help="Joint values, separated by commas; all 0 when left out.")] = "",
       deg: Annotated[bool, typer.Option("--deg", help="The values of revolute joints are degrees, not radians (prismatic ones are metres).")] = False,
       frames: Annotated[bool, typer.Option("--frames", help="Print every frame of the chain as well.")] = False, as_json: Json = False):
    """Forward kinematics: where the end is, tool included."""
    model = load(arm)
    values = _joint_values(q, model, deg)
    pose = model.forward(values)
    if as_json:
        answer = {"arm": model.name, "units": {"length": "m", "angle": "rad"}, "q": values.tolist(), "pose": pose.tolist(),
                  "within_limits": model.within_limits(values).tolist()}
        print(json.dumps(answer | ({"frames": model.frames(values).tolist()} if frames else {}), ensure_ascii=False))
        return
    print(_pose_text(f"{model.name}: end pose", pose))
    for i, frame in enumerate(model.frames(values) if frames else []):
        print(_pose_text(f"frame {i}", frame))
    outside = [str(i) for i, inside in enumerate(model.within_limits(values), 1) if not inside]
    if outside:
        print(f"Note: outside the stated limits: joint {', '.join(outside)}. The pose is right for these values all the same.")


app.command()(doctor)
app.command()(grade)
app.command()(release)
app.add_typer(export, name="export")


@app.command()
def convert(arm: Annotated[str, typer.Argument(metavar="ARM", help="A name of the library, or a .yaml or .csv table file.")],
            to: Annotated[str, typer.Option("--to", help="standard or craig.")],
            out: Annotated[str, typer.Option("--out", help="Write a .yaml file; an existing one is kept.")] = "", as_json: Json = False):
    """The same arm in the other convention: the same pose for every q, exactly."""
    _give(load(arm).to(to), out, as_json)


@app.command(name="from-urdf")
def from_urdf(file: Annotated[Path, typer.Argument(metavar="FILE", help="A URDF file (expand xacro first).")],
              base: Annotated[str, typer.Option(help="The link the chain begins with; the root when left out.")] = "",
              tip: Annotated[str, typer.Option(help="The link it ends with; the only leaf when left out.")] = "",
              to: Annotated[str, typer.Option("--to", help="standard or craig.")] = "standard",
              out: Annotated[str, typer.Option("--out", help="Write a .yaml file; an existing one is kept.")] = "", as_json: Json = False):
    """The DH table of a URDF chain: the same pose for every q."""
    import warnings

    from .urdf import read_urdf
    with warnings.catch_warnings(record=True) as noted:
        warnings.simplefilter("always")
        model = read_urdf(file, base or None, tip or None, convention=to)
    _give(model, out, as_json)
    for warning in noted:
        print(f"Note: {warning.message}", file=sys.stderr)


def _give(model, out, as_json):
    """Print an arm, and write it where asked."""
    if out:
        model.save(out)
    print(json.dumps(_described(model), ensure_ascii=False) if as_json else model)


def _joint_values(text, model, deg):
    cells = [cell for cell in re.split(r"[,\s]+", text.strip()) if cell] if text.strip() else ["0"] * len(model)
    try:
        values = np.array([float(cell) for cell in cells])
    except ValueError:
        raise ValueError(f"--q: expected {len(model)} numbers separated by commas, found {text!r}; write 0.5, not 1/2 or 0,5") from None
    if len(values) != len(model):
        raise ValueError(f"--q: expected {len(model)} numbers, one per joint of {model.name}, found {len(values)}; write them as --q 0,0.1,…")
    return np.where(model.table.prismatic | (not deg), values, np.deg2rad(values))


def _pose_text(title, pose):
    xyz, rpy = to_xyz_rpy(pose)
    return "\n".join([title, f"  position (m)              {'  '.join(number(v) for v in xyz)}",
                      f"  roll, pitch, yaw (deg)    {'  '.join(number(v, 4) for v in np.rad2deg(rpy))}   (about fixed x, y, z)",
                      *("  " + line for line in matrix_text(pose).splitlines())])


def main():
    """The entry point of the ``dhlab`` command."""
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="replace")  # a terminal without θ still gets an answer
    try:
        sys.exit(app(standalone_mode=False))
    except (KeyboardInterrupt, typer.Abort):
        sys.exit(130)
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        sys.exit(1)
    except Exception as error:
        usage = getattr(error, "format_message", None)  # a usage error; Typer's class for it has moved between versions
        if not usage and not isinstance(error, ValueError):
            raise
        sentence = f"{usage()} See dhlab --help for what there is." if usage else str(error)
        print(f"dhlab: {' '.join(sentence.split())}", file=sys.stderr)
        sys.exit(2)
