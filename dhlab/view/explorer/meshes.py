"""The links' own shapes over the frames: STL files, and the URDF that says where they sit. They are
read when a view asks for them; a notebook keeps neither them nor their names.
"""

import re
import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...arm import Arm
from ...formats.descriptions.urdfjoint import read_joint
from ...formats.descriptions.urdfxml import parts, read_robot
from ...transform import from_xyz_rpy, inverse

__all__ = ["Part", "parts_of", "triangles"]

MILLIMETRES = 25  # times the arm's reach: what extends further is not in metres
NEAR, ALONG = 2e-3, 0.9999  # of the reach, and a cosine: one axis to the eye


@dataclass(frozen=True, eq=False)
class Part:
    """A file that moves with frame ``frame``, at ``pose`` (4, 4) in it; ``scale`` (3,) makes its
    numbers metres.
    """

    file: Path
    frame: int
    pose: NDArray[np.float64]
    scale: NDArray[np.float64]


def parts_of(arm: Arm, meshes: Any) -> list[Part]:
    """What is drawn with which frame of the arm.

    Parameters
    ----------
    arm : Arm
    meshes : path, sequence of paths or mapping
        A URDF, or a xacro file, with the STL files that it names, found beside it; a folder of STL
        files or a list of them, placed as they were assembled at q = 0, where the last number in a
        name says the link (0 is the base); or ``{i: file}``, each drawn in its own DH frame i.

    Raises
    ------
    ValueError
        No file there, no STL file, or a link that the arm does not have.
    """
    if isinstance(meshes, Mapping):
        return [_numbered(arm, Path(file), int(i), np.eye(4)) for i, file in meshes.items()]
    if not isinstance(meshes, (str, Path)):
        return _assembled(arm, [Path(file) for file in meshes])
    path = Path(meshes)
    if path.suffix.lower() in (".urdf", ".xacro", ".xml"):
        return _described(arm, path)
    if path.is_dir():
        return _assembled(arm, sorted(p for p in path.iterdir() if p.suffix.lower() == ".stl"))
    return _assembled(arm, [path])


def _assembled(arm: Arm, files: Sequence[Path]) -> list[Part]:
    if not files:
        raise ValueError("explore: meshes: expected STL files, found none; give a URDF or a list")
    zero = arm.frames(np.zeros(len(arm)))
    found = []
    for file in files:
        digits = re.findall(r"\d+", file.stem)
        i = int(digits[-1]) if digits else 0
        found.append(_numbered(arm, file, i, inverse(zero[min(i, len(arm))])))
    return found


def _numbered(arm, file, i, pose):
    if not 0 <= i <= len(arm):
        raise ValueError(
            f"explore: meshes: expected links from 0 to {len(arm)}, found {i} for {file.name}; say"
            " which is whose with {i: file}"
        )
    far = float(np.abs(triangles(file)).max())
    scale = 1e-3 if far > MILLIMETRES * _reach(arm) else 1.0
    return Part(file, i, pose, np.full(3, scale))


def _reach(arm):
    ends = [
        np.abs(arm.table.rows[:, 1:3]).sum(),
        *np.abs([arm.base[:3, 3], arm.tool[:3, 3]]).max(1),
    ]
    return max(0.1, float(np.sum(ends)))


def _described(arm: Arm, path: Path) -> list[Part]:
    """The visuals of a URDF, each with the joint above it."""
    robot = read_robot(path, looks=True)
    _, joints = parts(robot, path)
    children = {child for _, _, child, _ in joints}
    elements = {link.get("name", ""): link for link in robot.findall("link")}
    places = {name: (np.eye(4), 0) for name in elements if name not in children}
    axes: dict[int, tuple[Any, Any]] = {}
    waiting = list(places)
    while waiting:
        above = waiting.pop()
        T, count = places[above]
        for _, parent, child, element in joints:
            if parent != above:
                continue
            at, i = _moved(T, count, element, path, axes)
            places[child] = at, i
            waiting.append(child)
    _warn_of_other_axes(arm, path, axes)
    zero, found, missing = arm.frames(np.zeros(len(arm))), [], []
    for name, (T, count) in places.items():
        for visual in elements[name].findall("visual"):
            mesh = visual.find("geometry/mesh")
            if mesh is None:
                continue
            file = _found(path, mesh.get("filename", ""))
            frame = min(count, len(arm))
            if file is None:
                missing.append(mesh.get("filename", ""))
            else:
                pose = inverse(zero[frame]) @ T @ _origin(visual)
                found.append(Part(file, frame, pose, _numbers(mesh.get("scale"), 1.0)))
    if not found:
        raise ValueError(
            f"{path}: expected beside it the STL files that it names, found none of"
            f" {len(missing)}; give a list of the files"
        )
    if missing:
        warnings.warn(f"{path}: not found and not drawn: {', '.join(missing[:5])}", stacklevel=4)
    return found


def _moved(T, count, element, path, axes):
    """The place of a joint's child, and how many joints move it."""
    if element.get("type") in ("floating", "planar") or element.find("mimic") is not None:
        return T @ _origin(element), count
    joint = read_joint(element, path)
    at = T @ joint.origin
    if joint.kind == "fixed":
        return at, count
    axes.setdefault(count + 1, (at[:3, 3], at[:3, :3] @ joint.axis))
    return at, count + 1


def _warn_of_other_axes(arm, path, axes):
    zero, first = arm.frames(np.zeros(len(arm))), int(arm.table.convention == "craig")
    for i in range(1, len(arm) + 1):
        T, (point, along) = zero[i - 1 + first], axes.get(i, (np.zeros(3), np.zeros(3)))
        z, way = T[:3, 2], point - T[:3, 3]
        aside = arm.table.joints[i - 1] == "R" and np.linalg.norm(np.cross(z, way)) / _reach(arm)
        if abs(z @ along) < ALONG * np.linalg.norm(along) or not along.any() or aside > NEAR:
            warnings.warn(
                f"{path}: at q = 0 its joint {i} lies elsewhere than this table's, so the links may"
                " sit wrong",
                stacklevel=5,
            )
            return


def _numbers(text, otherwise):
    return np.array([float(x) for x in text.split()]) if text else np.full(3, otherwise)


def _origin(element):
    at = element.find("origin")
    if at is None:
        return np.eye(4)
    return from_xyz_rpy(_numbers(at.get("xyz"), 0.0), _numbers(at.get("rpy"), 0.0))


def _found(path, name):
    """The STL file that a URDF means; a mesh of another format is looked for as STL."""
    tail = Path(re.sub(r"^\w+://", "", name))
    inside = Path(*tail.parts[1:]) if tail.parts[1:] else tail
    for folder in path.resolve().parents:
        for way in (tail, inside):
            file = (folder / way).with_suffix(".stl")
            for one in (file, file.with_suffix(".STL")):
                if one.is_file():
                    return one
    wanted = tail.with_suffix(".stl").name.lower()
    return next((p for p in path.resolve().parent.rglob("*") if p.name.lower() == wanted), None)


def triangles(file: Path) -> NDArray[np.float32]:
    """The corners (k, 3, 3) in an STL file, binary or text, in the file's own unit."""
    try:
        data = Path(file).read_bytes()
    except OSError:
        raise ValueError(
            f"explore: meshes: expected an STL file, found none at {file}; look at its path"
        ) from None
    count = int.from_bytes(data[80:84], "little") if len(data) >= 84 else -1
    if len(data) == 84 + 50 * count:
        facets = np.frombuffer(data, FACET, offset=84)
        return np.array(facets["corners"])
    words = re.findall(rb"vertex\s+(\S+)\s+(\S+)\s+(\S+)", data)
    if not words or len(words) % 3:
        raise ValueError(
            f"explore: meshes: expected an STL file, found something else in {file}; save the link"
            " as STL"
        )
    return np.array(words, np.float32).reshape(-1, 3, 3)


FACET = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
