"""Poses files: measured or computed end points and poses of an arm in CSV, one line per
configuration, read strictly.
"""

import csv
import io
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from .. import units
from ..checks import checked_joints
from ..rotations import from_rotation_vectors, skew
from ..transform import from_xyz_rpy
from .files import read_text
from .plainyaml import FLOAT

__all__ = ["read_poses", "LARGEST", "ORIENTATIONS"]

ORIENTATIONS = {
    "a quaternion": ("qw", "qx", "qy", "qz"),
    "fixed-axis angles": ("roll", "pitch", "yaw"),
    "a rotation vector": ("rx", "ry", "rz"),
}
POSITION = ("x", "y", "z")
LARGEST = 200_000_000  # bytes: a controller's log holds more than a hundred thousand poses
UNIT_TOLERANCE = 1e-3  # a quaternion printed with four digits passes


def read_poses(
    path: str | Path, n: int, length: str = "m", angle: str = "rad", *, joints: str | None = None
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Configurations and the poses (or positions) that belong to them, from a CSV file.

    Parameters
    ----------
    path : str or path
        CSV with a header ``q1,…,qn,x,y,z`` and optionally ``qw,qx,qy,qz`` (a unit quaternion), or
        ``roll,pitch,yaw`` (about fixed x, y, z, in this order, as URDF has it), or ``rx,ry,rz``
        (the rotation vector, as UR controllers print it). Columns in any order; empty lines and
        lines that start with ``#`` are passed over.
    n : int
        The number of joints.
    length : "m" or "mm"
        The unit of x, y, z and of prismatic joints.
    angle : "rad" or "deg"
        The unit of revolute joints, of roll, pitch, yaw and of the rotation vector.
    joints : str, optional
        ``"R"`` or ``"P"`` per joint, such as ``arm.table.joints``; all revolute when left out.

    Returns
    -------
    q : array (m, n)
        Radians, metres for a prismatic joint.
    poses : array (m, 4, 4), or positions (m, 3) when the file has no orientation
        Metres.

    Raises
    ------
    ValueError
        One sentence that names file, line and column.

    Examples
    --------
    >>> import pathlib, tempfile
    >>> path = pathlib.Path(tempfile.mkdtemp(), "points.csv")
    >>> _ = path.write_text("q1, q2, x, y, z\\n0, 90, 400, 0, 100\\n")
    >>> q, points = read_poses(path, 2, length="mm", angle="deg")
    >>> q.round(6), points
    (array([[0.      , 1.570796]]), array([[0.4, 0. , 0.1]]))
    """
    to_m = units.scale_of(length, "length", "read_poses")
    to_rad = units.scale_of(angle, "angle", "read_poses")
    slides = _slides(joints, n)
    (line, names), *rows = _lines(path)
    orientation = _orientation(names, n, f"{path}: line {line}")
    if not rows:
        raise ValueError(
            f"{path}: expected a line of numbers for each pose, found the header alone; was the"
            " file cut off?"
        )
    table = np.array([_numbers(cells, names, f"{path}: line {line}") for line, cells in rows])
    columns = {name: table[:, k] for k, name in enumerate(names)}
    q = np.column_stack(
        [units.convert(columns[f"q{i + 1}"], to_m if slides[i] else to_rad) for i in range(n)]
    )
    xyz = units.convert(np.column_stack([columns[name] for name in POSITION]), to_m)
    if orientation is None:
        return q, xyz
    poses = from_xyz_rpy(xyz, np.zeros_like(xyz))
    poses[:, :3, :3] = _rotations(
        orientation, np.column_stack([columns[name] for name in orientation]), to_rad, path, rows
    )
    return q, poses


def _slides(joints, n):
    if isinstance(n, bool) or not isinstance(n, (int, np.integer)) or n < 1:
        raise ValueError(
            f"read_poses: n: expected the number of joints, a whole number from 1, found {n!r};"
            " give len(arm)"
        )
    return [letter == "P" for letter in checked_joints(joints, int(n), "read_poses: joints")]


def _lines(path):
    """``(line number, cells)`` of the header and of every line with numbers."""
    kept = []
    for i, line in enumerate(
        io.StringIO(read_text(path, "a poses file", LARGEST), newline=None), 1
    ):
        if not line.strip(" \t\r\n,") or line.lstrip().startswith("#"):
            continue
        try:
            (cells,) = csv.reader([line.rstrip("\n")], skipinitialspace=True, strict=True)
        except (csv.Error, ValueError):
            raise ValueError(
                f"{path}: line {i}: expected cells with commas between them, found"
                f" {line.strip()[:60]!r}; take quotes and other signs out"
            ) from None
        kept.append((i, [cell.strip() for cell in cells]))
    if not kept:
        raise ValueError(
            f"{path}: expected a header q1,…,qn,x,y,z and a line per pose, found an empty file; was"
            " it saved?"
        )
    first, header = kept[0]
    wrong = "semicolons" if ";" in "".join(header) else "tabs" if "\t" in "".join(header) else None
    if wrong:
        raise ValueError(
            f"{path}: line {first}: expected commas between the columns, found {wrong}; "
            "save it with commas between cells and points in numbers"
        )
    return [(first, [name.lower() for name in header]), *kept[1:]]


def _orientation(names, n, where):
    """The names of the orientation's columns, or None; the header is right when this returns."""
    joints = [f"q{i}" for i in range(1, n + 1)]
    known = {*joints, *POSITION}.union(*ORIENTATIONS.values())
    if all(FLOAT.match(name) for name in names):
        raise ValueError(
            f"{where}: expected a header such as q1,…,q{n},x,y,z, found numbers; write the columns'"
            " names above them"
        )
    for name in names:
        if name not in known:
            raise ValueError(
                f"{where}: column {name[:40]!r}: expected q1 to q{n}, x, y, z and an orientation"
                f" ({_choices()}); {_todo(name)}"
            )
        if names.count(name) > 1:
            raise ValueError(
                f"{where}: expected every column once, found {name} twice; take one out"
            )
    found = {
        kind: [name for name in columns if name in names] for kind, columns in ORIENTATIONS.items()
    }
    found = {kind: some for kind, some in found.items() if some}
    if len(found) > 1:
        raise ValueError(
            f"{where}: expected one orientation, found columns of {' and of '.join(found)}; keep"
            " one of them"
        )
    orientation = ORIENTATIONS[next(iter(found))] if found else ()
    missing = [name for name in (*joints, *POSITION, *orientation) if name not in names]
    if missing:
        expected = ", ".join([f"q1 to q{n}", *POSITION, *orientation])
        raise ValueError(f"{where}: no column {', '.join(missing)}; expected {expected}")
    return orientation or None


def _choices():
    return " or ".join(",".join(columns) for columns in ORIENTATIONS.values())


def _todo(name):
    if name[:1] == "q" and name[1:].isdigit():
        return "look at the number of joints given"
    if name.rpartition("_")[0]:
        return "units are given as length= and angle=, not in the names"
    return "rename it or take it out"


def _numbers(cells, names, where):
    while len(cells) > len(names) and not cells[-1]:
        cells = cells[:-1]
    if len(cells) != len(names):
        comma = (
            "is that a decimal comma? Write 0.425, not 0,425"
            if len(cells) > len(names)
            else "fill in what is missing"
        )
        raise ValueError(
            f"{where}: expected {len(names)} cells ({', '.join(names)}), found {len(cells)};"
            f" {comma}"
        )
    return [_number(cell, f"{where}: column {name}") for cell, name in zip(cells, names)]


def _number(cell, where):
    if FLOAT.match(cell) and np.isfinite(float(cell)):
        return float(cell)
    if not cell:
        raise ValueError(
            f"{where}: expected a number, found an empty cell; fill it in or take the line out"
        )
    if cell.lower().lstrip("+-") in ("nan", "inf", "infinity") or FLOAT.match(cell):
        raise ValueError(
            f"{where}: expected a finite number, found {cell}; take the line out if nothing was"
            " measured"
        )
    todo = (
        "write 0.425, not 0,425"
        if "," in cell
        else "write it with digits and a decimal point, without units"
    )
    raise ValueError(f"{where}: expected a number, found {cell[:40]!r}; {todo}")


def _rotations(orientation, values, to_rad, path, rows):
    """(m, 3, 3) rotation matrices of the orientation's columns."""
    if orientation == ORIENTATIONS["fixed-axis angles"]:
        angles = units.convert(values, to_rad)
        return from_xyz_rpy(np.zeros_like(angles), angles)[:, :3, :3]
    if orientation == ORIENTATIONS["a rotation vector"]:
        return from_rotation_vectors(units.convert(values, to_rad))
    norms = np.linalg.norm(values, axis=1)
    bad = np.flatnonzero(np.abs(norms - 1) > UNIT_TOLERANCE)
    if len(bad):
        raise ValueError(
            f"{path}: line {rows[bad[0]][0]}: columns qw, qx, qy, qz: expected a unit quaternion,"
            f" found one of length {norms[bad[0]]:.4g}; are the columns in the order the header"
            " says?"
        )
    return _of_quaternions(values / norms[:, None])


def _of_quaternions(values):
    """(m, 3, 3) from unit quaternions, w first: v'= v + 2 w (u × v) + 2 u × (u × v)."""
    w, K = values[:, :1, None], skew(values[:, 1:])
    return np.eye(3) + 2 * w * K + 2 * K @ K
