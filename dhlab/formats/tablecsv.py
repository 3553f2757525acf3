"""Table files in CSV: a line that names the convention, a header that names the units, a line per
joint.
"""

import csv
import io
from pathlib import Path
from typing import Any

import numpy as np

from .. import units
from ..arm import Arm
from ..table import COLUMNS, CONVENTIONS, JOINT_WORDS, DHTable, joint_letter
from .files import read_text
from .plainyaml import FLOAT, Item, number, placed

__all__ = ["read_csv", "csv_text"]

HEADER = "theta_deg,d_m,a_m,alpha_deg (or _rad, _mm) and optionally type,sign"


def read_csv(path: str | Path) -> Arm:
    """The ``Arm`` in a CSV table file."""
    lines = read_text(path, "a table file").splitlines()
    convention = _convention(lines[0] if lines else "", path)
    rows = [(i, row) for i, row in _rows(lines[1:], path) if any(cell.strip() for cell in row)]
    if len(rows) < 2:
        raise ValueError(
            f"{path}: expected a header and at least one row, found {len(rows)} of these lines; see"
            " the documentation's table files page"
        )
    scales, names = _header([cell.strip() for cell in rows[0][1]], path)
    columns: dict[str, list[Any]] = {name: [] for name in names}
    for k, (line, row) in enumerate(rows[1:], 1):
        where = f"{path}: line {line}: row {k}"
        if len(row) != len(names):
            raise ValueError(
                f"{where}: expected {len(names)} cells ({', '.join(names)}), found {len(row)}; use"
                " commas between cells and points in numbers"
            )
        for name, cell in zip(names, row):
            columns[name].append(
                joint_letter(cell.strip(), f"{where}, type")
                if name == "type"
                else number(Item(_cell(cell), where), name)
            )
    letters = "".join(columns.pop("type", ["R"] * (len(rows) - 1)))
    sign = columns.pop("sign", None)
    theta, d, a, alpha = (
        units.convert(np.array(columns[name], dtype=float), scales[name]) for name in COLUMNS
    )
    table = DHTable(convention, theta, d, a, alpha, letters)
    for (line, _), value in zip(rows[1:], sign or ()):
        if value not in (1, -1):
            raise ValueError(
                f"{path}: line {line}: column sign: expected 1 or -1, found {value:g}; write -1"
                " where the joint counts the other way"
            )
    return placed(path, lambda: Arm(table, sign=sign))


def _rows(lines, path):
    """The cells of every line, with its number."""
    for i, line in enumerate(lines, 2):
        try:
            yield i, next(csv.reader([line]), [])
        except csv.Error as error:
            raise ValueError(
                f"{path}: line {i}: expected cells with commas between them, found {error}; look at"
                " this line"
            ) from None


def _convention(line, path):
    line = line.strip().rstrip(",").strip()
    key, _, value = line.lstrip("#").partition(":")
    value = value.strip()
    if not line.startswith("#") or key.strip() != "convention" or value not in CONVENTIONS:
        hint = '; "modified" is called craig here' if value == "modified" else ""
        raise ValueError(
            f"{path}: line 1: expected '# convention: standard' or '# convention: craig', found"
            f" {line[:60]!r}{hint}"
        )
    return value


def _header(cells, path):
    scales, names = {}, []
    for cell in cells:
        name, _, unit = cell.rpartition("_")
        if cell in ("type", "sign"):
            name = cell
        elif name in ("theta", "alpha"):
            scales[name] = units.scale_of(unit, "angle", f"{path}: line 2: column {cell}")
        elif name in ("d", "a"):
            scales[name] = units.scale_of(unit, "length", f"{path}: line 2: column {cell}")
        else:
            unit = "m" if cell in ("d", "a") else "deg"
            todo = f"; name its unit, as in {cell}_{unit}" if cell in COLUMNS else ""
            raise ValueError(f"{path}: line 2: column {cell!r}: expected {HEADER}{todo}")
        if name in names:
            raise ValueError(f"{path}: line 2: expected every column once, found {name} twice")
        names.append(name)
    for name in COLUMNS:
        if name not in names:
            raise ValueError(f"{path}: line 2: no column {name}; expected {HEADER}")
    return scales, names


def _cell(cell):
    """What stands in a CSV cell: a number where it is one, the text itself otherwise."""
    cell = cell.strip()
    if FLOAT.match(cell) or cell.lstrip("+-").lower() in ("nan", "inf"):
        return float(cell)
    return cell or None


def csv_text(arm: Arm, angle: str, length: str) -> str:
    """The CSV text of an arm without base, tool or limits, in the units named."""
    plain = Arm(arm.table)
    held = (
        np.array_equal(arm.base, plain.base)
        and np.array_equal(arm.tool, plain.tool)
        and arm.limits is None
        and arm.coupling is None
    )
    if not held:
        raise ValueError(
            "save: expected an arm that CSV can hold, found a base, a tool, limits or coupled"
            " joints; save it as"
            " .yaml"
        )
    joints, signs = "P" in arm.table.joints, bool((arm.sign < 0).any())
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    out.write(f"# convention: {arm.table.convention}\n")
    writer.writerow(
        [f"theta_{angle}", f"d_{length}", f"a_{length}", f"alpha_{angle}"]
        + ["type"] * joints
        + ["sign"] * signs
    )
    words = {letter: word for word, letter in JOINT_WORDS.items()}
    for row, letter, sign in zip(
        units.written_rows(arm.table, angle, length), arm.table.joints, arm.sign
    ):
        writer.writerow(row + [words[letter]] * joints + [int(sign)] * signs)
    return out.getvalue()
