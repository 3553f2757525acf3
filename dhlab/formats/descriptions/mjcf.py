"""MuJoCo's MJCF in: the chain of bodies from the world to one of them, as an ``Arm``; the part of
the format that says where bodies and joints are (MuJoCo documentation, "XML reference": compiler,
default, body, joint, site).
"""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from scipy.spatial.transform import Rotation

from .mjcfmodel import Model
from .placed import placed_arm
from .urdfends import GRIPS, TURNS
from .urdfwords import listed
from .urdfxml import parsed

if TYPE_CHECKING:
    from ...geometry.procedure.frames import PlacedArm

__all__ = ["read_mjcf"]

AXES = {"hinge": "R", "slide": "P"}


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
    model = Model(root, path)
    model.read()
    start = _frame_of(model, base, "base") if base else model.world
    end, said = (_frame_of(model, tip, "tip"), "") if tip else _longest(model, start)
    arm = _arm(model, start, end, base or "the world", convention, parallel)
    if said:
        warnings.warn(f"{path}: {said}", stacklevel=2)
    return arm


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
