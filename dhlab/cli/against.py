"""What ``dhlab doctor`` does beside a table and poses: a sheet of joint axes, and an arm against
another arm, where nothing was measured.
"""

import json
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np

from ..formats import plainyaml
from ..formats.axisfile import AxisSheet, holds_axes, sheet_from_item
from ..formats.descriptions import ENDINGS
from ..formats.files import read_text
from ..formats.posefile import LARGEST
from ..robots import known_as
from .common import arm_of

__all__ = ["is_arm", "sheet_in", "against_arm", "axes_of"]

YAML = (".yaml", ".yml")
ROUNDED = (2e-5, 2e-5)  # m, rad: what angles printed as 1.5708 make of an arm of some metres
POSES = 12


def is_arm(text: str) -> bool:
    """Whether what stands in the place of the poses is an arm: a name, a table, a URDF."""
    ending = Path(text).suffix.lower()
    if ending in (*YAML, *ENDINGS):
        return True
    if ending == ".csv":
        if not Path(text).is_file():
            return False
        return read_text(text, "a poses file", LARGEST).lstrip().startswith("# convention")
    return bool(known_as(text.partition(".")[0]))


def sheet_in(text: str) -> AxisSheet | None:
    """The axis sheet in a file; None where it holds something else."""
    if Path(text).suffix.lower() not in YAML or not Path(text).is_file():
        return None
    item = plainyaml.read(text)
    return sheet_from_item(item) if holds_axes(item) else None


def against_arm(
    name: str, other: str, free_base: bool, free_tool: bool, budget: float, as_json: bool
) -> None:
    """What is wrong with a table when another arm is right; printed, with the two side by side."""
    from ..doctor import diagnose
    from ..geometry.comparing.compare import compare

    model, right = arm_of(name), arm_of(other)
    found = compare(right, model)
    if found.kind == "joints":
        raise ValueError(
            f"doctor: expected two arms with the same joints, found {model.name}:"
            f" {model.table.joints} and {right.name}: {right.table.joints}; compare arms joint by"
            " joint, such as from-urdf --end"
        )
    low, high = np.where(model.table.prismatic, 0.0, -2.0), np.where(model.table.prismatic, 0.3, 2)
    q = np.random.default_rng(0).uniform(low, high, (POSES, len(model)))
    answer = diagnose(
        model,
        q,
        right.forward(q),
        noise=ROUNDED,
        base="free" if free_base else "fixed",
        tool="free" if free_tool else "fixed",
        budget=budget,
    )
    words = answer.headline.replace("these measurements", "the measurements")
    answer = replace(
        answer, headline=words.replace("the measurements", f"the poses of {right.name or other}")
    )
    if as_json:
        both = {"diagnosis": answer.to_dict(), "comparison": found.to_dict()}
        print(json.dumps(both, ensure_ascii=False))
        return
    print(answer)
    if not found:
        print(f"\nSide by side, a the arm that was taken for right:\n{found}")


def axes_of(
    sheet: AxisSheet,
    poses: str,
    units: tuple[str, str],
    noise: tuple[float, ...] | None,
    repair: str,
    budget: float,
    as_json: bool,
) -> None:
    """What is wrong with a sheet of axes, printed; and the repaired sheet, where asked for."""
    from ..doctor import diagnose_axes
    from ..formats.posefile import read_poses

    letters = "".join(letter for *_, letter in sheet.axes)
    q, measured = read_poses(poses, len(letters), *units, joints=letters)
    answer = diagnose_axes(
        sheet.axes, sheet.end, q, measured, noise=noise, name=sheet.name, budget=budget
    )
    print(json.dumps(answer.to_dict(), ensure_ascii=False) if as_json else answer)
    if not repair:
        return
    if answer.sheet is None:
        print(
            f"Note: {repair} was not written: the verdict is {answer.verdict!r}.", file=sys.stderr
        )
        return
    answer.sheet.save(repair)
    print(f"Note: the repaired sheet is in {repair}.", file=sys.stderr)
