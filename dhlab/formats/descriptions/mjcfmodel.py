"""What a MuJoCo model says of bodies and joints: its elements read, with the settings and defaults
that give its numbers their meaning (MuJoCo documentation, "XML reference").
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from xml.etree.ElementTree import Element

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from ..plainyaml import FLOAT, placed
from .urdfxml import parsed

__all__ = ["Frame", "Joint", "Model"]

MOST_INCLUDES = 50


@dataclass
class Frame:
    """A body or a site: its pose in the body before, and the joints that move it."""

    name: str
    parent: Frame | None
    pose: NDArray[np.float64]
    joints: list[Joint] = field(default_factory=list)
    site: bool = False

    def chain(self) -> list[Frame]:
        """From the world to this one."""
        return [*(self.parent.chain() if self.parent else []), self]


@dataclass
class Joint:
    """A joint in its body: where, which way, from where to where, and which value it has at the
    model's initial pose."""

    name: str
    kind: str
    pos: NDArray[np.float64]
    axis: NDArray[np.float64]
    limits: tuple[float, float] | None
    ref: float


class Model:
    """The bodies of a model, with the settings that say what its numbers mean."""

    def __init__(self, root: Element, path: str | Path) -> None:
        self.root, self.path = root, path
        self.world = Frame("world", None, np.eye(4))
        self.frames: list[Frame] = []
        self.defaults: dict[str, dict[str, dict[str, str]]] = {}

    def read(self) -> None:
        """All bodies, those of included files in their places."""
        _include(self.root, Path(self.path), [MOST_INCLUDES])
        settings: dict[str, str] = {}
        for compiler in self.root.findall("compiler"):
            settings |= compiler.attrib
        self.scale = 1.0 if settings.get("angle", "degree") == "radian" else np.pi / 180
        self.sequence = settings.get("eulerseq", "xyz")
        self.limited = settings.get("autolimits", "true") == "true"
        if settings.get("coordinate", "local") != "local":
            raise ValueError(
                f"{self.path}: expected local coordinates, found global ones, which MuJoCo no"
                " longer reads; save the model with a newer MuJoCo"
            )
        for default in self.root.findall("default"):
            self._read_default(default, {}, default.get("class", "main"))
        for body in self.root.findall("worldbody"):
            self._read_inside(body, self.world, "main")

    def _read_default(self, element, inherited, name):
        own = {tag: dict(values) for tag, values in inherited.items()}
        for child in element:
            if child.tag != "default":
                own[child.tag] = own.get(child.tag, {}) | child.attrib
        self.defaults[name] = own
        for child in element.findall("default"):
            self._read_default(child, own, child.get("class", name))

    def _read_inside(self, element, frame, childclass):
        for child in element:
            if child.tag == "body":
                self._read_body(child, frame, childclass)
            elif child.tag == "site":
                given = self._with_defaults(child, childclass)
                name = given.get("name", "")
                self.frames.append(Frame(name, frame, self._pose(given, name), site=True))
            elif child.tag == "frame":
                raise ValueError(
                    f"{self.path}: expected bodies, joints and sites, found a <frame>; save the"
                    " model with MuJoCo, which writes it out"
                )

    def _read_body(self, element, parent, childclass):
        name = element.get("name", "") or f"body {len(self.frames) + 1}"
        frame = Frame(name, parent, self._pose(element.attrib, f"body {name}"))
        self.frames.append(frame)
        childclass = element.get("childclass", childclass)
        for child in element:
            if child.tag == "freejoint":
                frame.joints.append(Joint("", "free", np.zeros(3), np.zeros(3), None, 0.0))
            elif child.tag == "joint":
                frame.joints.append(self._joint(child, childclass, name))
        self._read_inside(element, frame, childclass)

    def _with_defaults(self, element, childclass):
        of_class = self.defaults.get(element.get("class", childclass), {})
        return of_class.get(element.tag, {}) | element.attrib

    def _joint(self, element, childclass, body):
        given = self._with_defaults(element, childclass)
        name = given.get("name", "") or f"of body {body}"
        where = f"joint {name}"
        kind = given.get("type", "hinge")
        scale = self.scale if kind == "hinge" else 1.0
        stated = self._numbers(given, "range", 2, where)
        limited = given.get("limited", "auto")
        holds = limited == "true" or (limited == "auto" and self.limited)
        limits = (
            (float(stated[0] * scale), float(stated[1] * scale))
            if stated is not None and holds and stated[0] < stated[1]
            else None
        )
        return Joint(
            name,
            kind,
            self._numbers(given, "pos", 3, where, (0, 0, 0)),
            self._numbers(given, "axis", 3, where, (0, 0, 1)),
            limits,
            float(self._numbers(given, "ref", 1, where, (0,))[0] * scale),
        )

    def _pose(self, given, where):
        T = np.eye(4)
        T[:3, 3] = self._numbers(given, "pos", 3, where, (0, 0, 0))
        T[:3, :3] = self._rotation(given, where)
        return T

    def _rotation(self, given, where):
        if (v := self._numbers(given, "quat", 4, where)) is not None and v.any():
            return Rotation.from_quat(v[[1, 2, 3, 0]]).as_matrix()
        if (v := self._numbers(given, "axisangle", 4, where)) is not None and v[:3].any():
            turn = v[:3] / np.linalg.norm(v[:3]) * v[3] * self.scale
            return Rotation.from_rotvec(turn).as_matrix()
        if (v := self._numbers(given, "euler", 3, where)) is not None:
            # lower case turns about the moving axes, upper case about fixed ones
            R = np.eye(3)
            for letter, angle in zip(self.sequence, v * self.scale):
                step = Rotation.from_euler(letter.lower(), angle).as_matrix()
                R = R @ step if letter.islower() else step @ R
            return R
        if (v := self._numbers(given, "xyaxes", 6, where)) is not None:
            x = v[:3] / np.linalg.norm(v[:3])
            y = v[3:] - x * (x @ v[3:])
            y /= np.linalg.norm(y)
            return np.column_stack([x, y, np.cross(x, y)])
        if (v := self._numbers(given, "zaxis", 3, where)) is not None:
            return Rotation.align_vectors([v / np.linalg.norm(v)], [[0, 0, 1]])[0].as_matrix()
        return np.eye(3)

    def _numbers(self, given, key, n, where, default=None):
        words = given.get(key, "").split()
        if not words:
            return None if default is None else np.array(default, float)
        if len(words) != n or not all(FLOAT.match(w) and np.isfinite(float(w)) for w in words):
            raise ValueError(
                f"{self.path}: {where}: {key}: expected {n} finite number{'s' * (n > 1)}, found"
                f" {' '.join(words)[:60]!r}; write numbers with spaces between them"
            )
        return np.array([float(w) for w in words])


def _include(element, path, left):
    """Each <include> replaced by what stands in that file."""
    for parent in list(element.iter()):
        for k, child in reversed(list(enumerate(parent))):
            if child.tag != "include":
                continue
            left[0] -= 1
            if left[0] < 0:
                raise ValueError(f"{path}: expected at most {MOST_INCLUDES} includes, found more")
            other = path.parent / child.get("file", "")
            inside = placed(f"{path}: include", partial(parsed, other, "an MJCF file"))
            _include(inside, other, left)
            parent.remove(child)
            for part in reversed(list(inside)):
                parent.insert(k, part)
