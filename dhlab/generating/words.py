"""What the generated file says at its head, and names and texts that cannot break out of a comment
or an identifier, whatever an arm is called.
"""

from __future__ import annotations

import re
import textwrap
import unicodedata

import numpy as np

from ..arm import Arm
from ..printing import grid_text
from ..units import written, written_rows
from .formulas import Formulas

__all__ = ["header", "identifier", "plain"]

WIDTH = 92
NAME = 24  # characters; C99 lets a linker compare the first 31 only, "_jacobian" included
MATRICES = {
    "standard": "standard DH, A_i = Rz(theta_i) Tz(d_i) Tx(a_i) Rx(alpha_i)",
    "craig": (
        "Craig (modified) DH, A_i = Rx(alpha_i-1) Tx(a_i-1) Rz(theta_i) Tz(d_i); row i holds"
        " a_i-1 and alpha_i-1"
    ),
}
JOINTS = (
    "Joint variables: theta_i = sign_i q_i + theta of row i; of a prismatic joint d_i = sign_i q_i"
    " + d of row i. q_1 is q[0]."
)


def plain(text: str) -> str:
    """A text on one line, of characters that are printed, without what ends or opens a comment.

    Examples
    --------
    >>> plain("arm */ int x;\\n #define")
    'arm * / int x; #define'
    """
    printed = "".join(letter if letter.isprintable() else " " for letter in text)
    for mark in ("*/", "/*", "??"):  # the last begins a trigraph in C
        while mark in printed:
            printed = printed.replace(mark, f"{mark[0]} {mark[1]}")
    return " ".join(printed.split())


def identifier(name: str) -> str:
    """A name that C and Python take, from whatever an arm is called.

    Examples
    --------
    >>> identifier("KUKA KR 6 R700"), identifier("7-axis"), identifier("机械臂")
    ('kuka_kr_6_r700', 'arm_7_axis', 'arm')
    """
    letters = (
        unicodedata.normalize("NFKD", name.replace("'", ""))
        .encode("ascii", "ignore")
        .decode()
        .lower()
    )
    words = re.sub(r"[^a-z0-9]+", "_", letters).strip("_")
    if not words[:1].isalpha():
        words = f"arm_{words}"
    return words[:NAME].strip("_")


def header(arm: Arm, formulas: dict[str, Formulas], notes: list[str], check: str) -> list[str]:
    """The lines of the comment at the head.

    Parameters
    ----------
    arm : Arm
    formulas : dict
        The name of each function and its Formulas.
    notes : list of str
        What else is to be said of base and tool.
    check : str
        How the file is tested, as a command.
    """
    paragraphs = [  # Python looks for a declared encoding in two lines: no text of the arm's there
        "Forward kinematics and Jacobian of one arm.",
        "Written by dhlab.generate: change the table and write it again, rather than this file.",
        f"Arm: {plain(arm.name) or 'without a name'}",
        f"Source of its table: {plain(arm.source) or 'not stated'}",
        f"Convention: {MATRICES[arm.table.convention]}.",
        "Units: q in rad, of a prismatic joint in m; lengths in m. (The table below: degrees.)",
        JOINTS,
    ]
    lines = [line for text in paragraphs for line in _wrapped(text)]
    lines += [
        "",
        *_table(arm).splitlines(),
        "",
        *_coupling(arm),
        *_frames(arm),
        *notes,
        *_results(arm),
    ]
    for name, formula in formulas.items():
        counts = ", ".join(f"{number} {kind}" for kind, number in formula.count.items())
        lines.append(f"Cost of {name}: {counts}")
    return [*lines, f"Check: {check}"]


def _wrapped(text):
    return textwrap.wrap(text, WIDTH, subsequent_indent="    ")


def _table(arm):
    """Every number as it is read back."""
    a, alpha = ("a", "alpha") if arm.table.convention == "standard" else ("a_i-1", "alpha_i-1")
    headings = ["i", "joint", "sign", "theta (deg)", "d (m)", f"{a} (m)", f"{alpha} (deg)"]
    limits = arm.limits or [None] * len(arm)
    rows = [
        [
            str(i),
            "prismatic" if arm.table.joints[i - 1] == "P" else "revolute",
            f"{int(arm.sign[i - 1]):+d}",
            *numbers,
            _limit(limits[i - 1], arm.table.joints[i - 1]),
        ]
        for i, numbers in enumerate(written_rows(arm.table, "deg", "m"), 1)
    ]
    return grid_text([*headings, "limits of q"], rows)


def _limit(pair, letter):
    if pair is None:
        return "none"
    unit = "m" if letter == "P" else "deg"
    return f"{written(pair[0], unit)} to {written(pair[1], unit)} {unit}"


def _coupling(arm):
    """What each joint makes of q, where it is not its own number alone."""
    if arm.coupling is not None:
        yield "coupling (joint variables = coupling (sign q) + theta or d of the row):"
        yield from ("    " + "  ".join(map(repr, row)) for row in arm.coupling.tolist())


def _frames(arm):
    """Base and tool, where there is something to say."""
    for name, of in (("base", "frame 0 in the world"), ("tool", "the end point in the last frame")):
        pose = getattr(arm, name)
        if not np.array_equal(pose, np.eye(4)):
            yield f"{name} ({of}):"
            yield from ("    " + "  ".join(map(repr, row)) for row in (pose[:3] + 0.0).tolist())


def _results(arm):
    yield from _wrapped("T: pose of the end point in the world, tool included, 4 x 4, row by row.")
    yield from _wrapped(
        f"J: geometric Jacobian there, in the world's axes, 6 x {len(arm)}, row by row: v in m/s,"
        " then omega in rad/s, per unit of q a second."
    )
