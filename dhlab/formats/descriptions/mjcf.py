"""MuJoCo's MJCF in: the chain of bodies from the world to one of them, as an ``Arm``; the part of
the format that says where bodies and joints are (MuJoCo documentation, "XML reference": compiler,
default, body, joint, site).
"""

from __future__ import annotations

import warnings
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING
from xml.etree.ElementTree import Element

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from ..plainyaml import FLOAT, placed
from .placed import placed_arm
from .urdfends import GRIPS, TURNS
from .urdfwords import listed
from .urdfxml import parsed

if TYPE_CHECKING:
    from ...geometry.procedure.frames import PlacedArm

__all__ = ["read_mjcf"]

AXES = {"hinge": "R", "slide": "P"}
MOST_INCLUDES = 50


def read_mjcf(
    path: str | Path,
    base: str | None = None,
    tip: str | None = None,
    *,
    convention: str = "standard",
    parallel: float | None = None,
) -> PlacedArm:
    """The chain of joints in a MuJoCo model, as an arm.

    Parameters
    ----------
    path : str or path
        An MJCF file; files it includes are read from beside it.
    base : str, optional
        The body (or site) whose frame poses are given in; the world when left out.
    tip : str, optional
        The body or site whose frame is the end. Left out: the last body of the longest chain of
        joints; a gripper's are left out, and a warning says so.
    convention : "standard" or "craig"
    parallel : float, optional
        As :func:`dhlab.read_urdf` takes it.

    Returns
    -------
    Arm
        ``forward(q)`` is the pose of the tip in the base for the joints' positions q as MuJoCo has
        them, hinges in radians, slides in metres.

    Raises
    ------
    ValueError
        No MJCF file, ball joints or a free joint on the chain, names that are not in it: one
        sentence each.

    Examples
    --------
    >>> import pathlib, tempfile
    >>> path = pathlib.Path(tempfile.mkdtemp(), "arm.xml")
    >>> _ = path.write_text('''
    ... <mujoco model="two links"><worldbody>
    ...   <body name="a" pos="0 0 0.1"><joint axis="0 0 1"/>
    ...     <body name="b" pos="0.4 0 0">
    ...       <joint axis="0 1 0"/><site name="end" pos="0.3 0 0"/>
    ...   </body></body>
    ... </worldbody></mujoco>''')
    >>> read_mjcf(path, tip="end").forward([0, 0])[:3, 3]
    array([0.7, 0. , 0.1])
    """
    root = parsed(path, "an MJCF file")
    if root.tag != "mujoco":
        raise ValueError(
            f"{path}: expected an MJCF file, whose outermost element is <mujoco>, found"
            f" <{root.tag[:40]}>; a <robot> is a URDF"
        )
    model = _Model(root, path)
    _include(root, Path(path), [MOST_INCLUDES])
    model.read()
    start = _frame_of(model, base, "base") if base else model.world
    end, said = (_frame_of(model, tip, "tip"), "") if tip else _longest(model, start)
    arm = _arm(model, start, end, base or "the world", convention, parallel)
    if said:
        warnings.warn(f"{path}: {said}", stacklevel=2)
    return arm


@dataclass
class _Frame:
    """A body or a site: its pose in the body before, and the joints that move it."""

    name: str
    parent: _Frame | None
    pose: NDArray[np.float64]
    joints: list[_Joint] = field(default_factory=list)
    site: bool = False

    def chain(self) -> list[_Frame]:
        """From the world to this one."""
        return [*(self.parent.chain() if self.parent else []), self]


@dataclass
class _Joint:
    """A joint in its body: where, which way, from where to where, and which value it has at the
    model's initial pose."""

    name: str
    kind: str
    pos: NDArray[np.float64]
    axis: NDArray[np.float64]
    limits: tuple[float, float] | None
    ref: float


class _Model:
    """The bodies of a model, with the settings that say what its numbers mean."""

    def __init__(self, root: Element, path: str | Path) -> None:
        self.root, self.path = root, path
        self.world = _Frame("world", None, np.eye(4))
        self.frames: list[_Frame] = []
        self.defaults: dict[str, dict[str, dict[str, str]]] = {}

    def read(self) -> None:
        """All bodies, once what they include is in place."""
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
                self.frames.append(_Frame(name, frame, self._pose(given, name), site=True))
            elif child.tag == "frame":
                raise ValueError(
                    f"{self.path}: expected bodies, joints and sites, found a <frame>; save the"
                    " model with MuJoCo, which writes it out"
                )

    def _read_body(self, element, parent, childclass):
        name = element.get("name", "") or f"body {len(self.frames) + 1}"
        frame = _Frame(name, parent, self._pose(element.attrib, f"body {name}"))
        self.frames.append(frame)
        childclass = element.get("childclass", childclass)
        for child in element:
            if child.tag == "freejoint":
                frame.joints.append(_Joint("", "free", np.zeros(3), np.zeros(3), None, 0.0))
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
        return _Joint(
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


def _frame_of(model, name, what):
    found = [frame for frame in model.frames if frame.name == name]
    if not found:
        names = [frame.name for frame in model.frames if frame.name]
        raise ValueError(
            f"{model.path}: {what}: expected a body or a site of the file, found {name!r}; it has"
            f" {listed(names)}"
        )
    return found[0]


def _longest(model, start):
    """The body at the end of the longest chain of joints, and what to say of it."""
    bodies = [frame for frame in model.frames if not frame.site and start in frame.chain()]
    if not bodies:
        raise ValueError(f"{model.path}: expected bodies below {start.name}, found none")
    behind = {}
    for body in bodies:
        joints = [joint for frame in body.chain() for joint in frame.joints]
        arm = [joint for joint in joints if not _grips(joint.name)]
        behind[id(body)] = len(arm) if len(arm) == len(joints) else -1
    most = max(behind.values())
    ends = [body for body in bodies if behind[id(body)] == most and body.joints]
    if len(ends) > 1:
        raise ValueError(
            f"{model.path}: expected one tip, found {len(ends)} chains of {most} joints; name the"
            f" last body or site as tip (--end): {listed([body.name for body in ends])}"
        )
    end = _flange(ends[0] if ends else bodies[-1], bodies)
    taken = {id(joint) for frame in end.chain() for joint in frame.joints}
    left = [j.name for body in bodies for j in body.joints if id(j) not in taken]
    if not left:
        return end, ""
    return end, (
        f"the arm was taken up to {end.name}, the longest chain of arm joints; left out:"
        f" {listed(left)}; name another end with --end (tip= in Python)."
    )


def _flange(end, bodies):
    """On to what stands still on the last moving body, as long as there is one such body."""
    while True:
        still = [body for body in bodies if body.parent is end and not body.joints]
        if len(still) != 1:
            return end
        end = still[0]


def _grips(name):
    return bool(GRIPS.search(name)) and not TURNS.search(name)


def _arm(model, start, end, base, convention, parallel):
    """The axes along the chain, in the base, at the joints' zero."""
    chain = end.chain()
    if start not in chain:
        raise ValueError(
            f"{model.path}: expected a tip below {start.name}, found {end.name}, which is not;"
            " name a base above it"
        )
    axes, limits, names = [], [], []
    T = np.eye(4)
    for frame in chain[chain.index(start) + 1 :]:
        T = T @ frame.pose
        for joint in frame.joints:
            if joint.kind not in AXES:
                raise ValueError(
                    f"{model.path}: joint {joint.name}: expected hinge or slide, found"
                    f" {joint.kind[:20]!r}, which no DH row can hold; name a base behind it"
                )
            if not joint.axis.any():
                raise ValueError(f"{model.path}: joint {joint.name}: axis: expected a direction")
            point = T[:3, :3] @ joint.pos + T[:3, 3]
            z = T[:3, :3] @ joint.axis / np.linalg.norm(joint.axis)
            axes.append((point, z, AXES[joint.kind]))
            limits.append(joint.limits)
            names.append(joint.name)
            # the model is drawn with the joint at ref; its zero is that much before
            T = _moved(point, z, AXES[joint.kind], -joint.ref) @ T
    if not axes:
        raise ValueError(
            f"{model.path}: expected a joint that moves between {base} and {end.name}, found none;"
            " name another base or tip"
        )
    return placed_arm(
        model.path,
        axes,
        T,
        parallel,
        convention=convention,
        limits=limits if any(limits) else None,
        name=model.root.get("model", ""),
        source=f"{Path(model.path).name}, from {base} to {end.name}; joints: {', '.join(names)}",
    )


def _moved(p, z, letter, q):
    T = np.eye(4)
    if letter == "P":
        T[:3, 3] = q * z
    else:
        T[:3, :3] = Rotation.from_rotvec(q * z).as_matrix()
        T[:3, 3] = p - T[:3, :3] @ p
    return T
