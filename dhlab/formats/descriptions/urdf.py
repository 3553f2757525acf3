"""URDF in and out: the chain between two links as an ``Arm`` with the same pose for every q, and an
``Arm`` as a URDF that simulators load.
"""

from __future__ import annotations

import re
import warnings
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any
from xml.etree import ElementTree

import numpy as np

from ...arm import Arm
from ...transform import to_xyz_rpy
from ..files import write_text

if TYPE_CHECKING:
    from ...geometry.procedure.frames import PlacedArm

__all__ = ["read_description", "read_urdf", "to_urdf"]

FREE = 1e6  # m or rad; URDF wants limits on every sliding joint, and no arm goes further than this
DUST = 1e-16  # what a cosine of 90° leaves in a length
MASS, INERTIA = "0.001", "1e-06"  # simulators refuse or replace links without mass


def read_urdf(
    path: str | Path,
    base: str | None = None,
    tip: str | None = None,
    *,
    convention: str = "standard",
    parallel: float | None = None,
    arguments: Mapping[str, object] | None = None,
    packages: Mapping[str, str | Path] | None = None,
    unround: bool = False,
) -> PlacedArm:
    """The chain between two links of a URDF file, as an arm.

    Fixed joints are folded into their neighbours. The joint variables are the revolute, continuous
    and prismatic joints between base and tip, in this order, counted as the URDF counts them.

    Parameters
    ----------
    path : str or path
        A ``.urdf`` file, or a xacro file, which the package xacro expands (extra ``[urdf]``). That
        evaluates the file's expressions: read files that you trust.
    base : str, optional
        The link whose frame poses are given in; the root when left out.
    tip : str, optional
        The link whose frame is the end point. Left out: the end of the longest chain of arm joints;
        a gripper's fingers are no arm joints. Where that was a choice, a warning says so.
    convention : "standard" or "craig"
    unround : bool
        Take an angle that the file has rounded, such as 1.5708 or 3.14, for the multiple of 90° or
        15° that it stands for. The arm is then the one that was meant, and no longer that of the
        file to the last digit.

    Returns
    -------
    Arm
        ``arm.forward(q)`` is the pose of the tip in the base for every q (but see ``parallel``).
        ``name`` is the robot's, ``limits`` are the file's (None where a joint is continuous, states
        none, or has lower above upper), ``source`` names file, links and joints, ``steps`` says how
        frames were assigned.

    Raises
    ------
    ValueError
        Not a URDF file, xacro that cannot be expanded, mimic joints, floating or planar joints,
        loops, two chains that are equally long, a tip that is not below the base: one sentence
        each.

    Warns
    -----
    NearlyParallelWarning
        Axes that the file's rounded angles (1.5708, 3.141592653) keep from being parallel, and what
        was done about it.
    UserWarning
        Which chain was taken, where there were several.

    Examples
    --------
    >>> import pathlib, tempfile, dhlab as dh
    >>> path = pathlib.Path(tempfile.mkdtemp(), "arm.urdf")
    >>> _ = to_urdf(dh.load("ur5e"), path)
    >>> read_urdf(path).forward([0] * 6)[:3, 3].round(4)
    array([-0.8172, -0.2329,  0.0628])
    """
    from .placed import placed_arm
    from .urdftree import read_chain

    joints, name, base, tip, chosen = read_chain(
        path, base, tip, arguments, packages, unround=unround
    )
    axes, limits, end = [], [], np.eye(4)
    for joint in joints:
        end = end @ joint.origin
        if joint.kind != "fixed":
            slides = joint.kind == "prismatic"
            axes.append((end[:3, 3], end[:3, :3] @ joint.axis, "P" if slides else "R"))
            limits.append(_limits(joint.limits))
    if not axes:
        raise ValueError(
            f"{path}: expected a joint that moves between {base} and {tip}, found fixed joints"
            " only; name another base or tip"
        )
    moving = ", ".join(joint.name for joint in joints if joint.kind != "fixed")
    if chosen:
        warnings.warn(f"{path}: {chosen}", stacklevel=2)
    return placed_arm(
        path,
        axes,
        end,
        parallel,
        convention=convention,
        limits=limits if any(limits) else None,
        name=name,
        source=f"{Path(path).name}, from {base} to {tip}; joints: {moving}",
    )


def read_description(path: str | Path, *given: Any, **more: Any) -> PlacedArm:
    """A robot description of either kind: URDF (and xacro), or MJCF where the outermost element
    says so; what is given goes to :func:`read_urdf` or :func:`dhlab.read_mjcf`.
    """
    from .mjcf import read_mjcf
    from .urdfxml import parsed

    if Path(path).suffix.lower() == ".xml" and parsed(path, "a robot").tag == "mujoco":
        return read_mjcf(path, *given, **more)
    return read_urdf(path, *given, **more)


def _limits(stated):
    """(low, high), or None where the joint is free; URDF takes a missing end for 0."""
    if stated is None:
        return None
    low, high = stated[0] or 0.0, stated[1] or 0.0
    return None if low > high or (low <= -FREE and high >= FREE) else (low, high)


def to_urdf(arm: Arm, path: str | Path | None = None, *, overwrite: bool = False) -> str:
    r"""A URDF of an arm, with links and joints and next to no mass, for simulators and visualisers.

    Parameters
    ----------
    arm : Arm
    path : str or path, optional
        Where to write it; nothing is written when left out.
    overwrite : bool
        Replace an existing file; it is kept, with an error, otherwise.

    Returns
    -------
    str
        The text. Links ``link_0`` (the frame that ``forward`` uses) to ``link_n`` and ``tool``,
        joints ``joint_1`` to ``joint_n``; a joint without limits is continuous, or slides a million
        metres. The joint variables are those of ``arm``. The links' frames lie on the joint axes,
        as URDF wants it: ``link_i`` is DH frame i - 1 turned by joint i (standard) or DH frame i
        (Craig).

    Raises
    ------
    ValueError
        No arm, or a file that exists or cannot be written.

    Examples
    --------
    >>> import dhlab as dh
    >>> print(*to_urdf(dh.load("article-6r")).splitlines()[:3], sep="\n")
    <?xml version="1.0"?>
    <robot name="The article's 6R arm, as its table has it">
      <link name="link_0">
    """
    if not isinstance(arm, Arm):
        raise ValueError(
            f"to_urdf: expected an Arm, found {type(arm).__name__}; make one with dhlab.Arm(table)"
            " or dhlab.load"
        )
    if arm.coupling is not None:
        raise ValueError(
            "to_urdf: expected an arm whose joints move one by one, found coupled joints, which"
            " URDF cannot express (its mimic follows one joint, and has no variable of its own);"
            " write the arm without its coupling and move it by arm.joint_values(q)"
        )
    robot = ElementTree.Element(
        "robot", name=" ".join(re.sub(r"[^\w\s!-~]", " ", arm.name).split()) or "arm"
    )
    n = len(arm)
    for name in [*(f"link_{i}" for i in range(n + 1)), "tool"]:
        _add_link(robot, name)
    *origins, tool = _origins(arm)
    for i, origin in enumerate(origins, 1):
        _add_joint(robot, arm, i, origin)
    joint = ElementTree.SubElement(robot, "joint", name="tool_joint", type="fixed")
    _add_ends(joint, f"link_{n}", "tool", tool)
    ElementTree.indent(robot)
    text = '<?xml version="1.0"?>\n' + ElementTree.tostring(robot, encoding="unicode") + "\n"
    if path is not None:
        write_text(path, text, overwrite=overwrite)
    return text


def _origins(arm):
    """The n + 1 constant poses between the joints' own motions: Rz(θ) and Tz(d) commute, so A_i(q)
    is a motion about or along z times A_i(0).
    """
    A = list(arm.links(np.zeros(len(arm))))
    if arm.table.convention == "standard":  # the motion stands before A_i(0)
        return [arm.base, *A[:-1], A[-1] @ arm.tool]
    return [arm.base @ A[0], *A[1:], arm.tool]


def _add_link(robot, name):
    inertial = ElementTree.SubElement(ElementTree.SubElement(robot, "link", name=name), "inertial")
    ElementTree.SubElement(inertial, "mass", value=MASS)
    ElementTree.SubElement(
        inertial, "inertia", ixx=INERTIA, ixy="0", ixz="0", iyy=INERTIA, iyz="0", izz=INERTIA
    )


def _add_joint(robot, arm, i, origin):
    limits = arm.limits[i - 1] if arm.limits else None
    slides = arm.table.joints[i - 1] == "P"
    kind = "prismatic" if slides else "revolute" if limits else "continuous"
    joint = ElementTree.SubElement(robot, "joint", name=f"joint_{i}", type=kind)
    _add_ends(joint, f"link_{i - 1}", f"link_{i}", origin)
    ElementTree.SubElement(joint, "axis", xyz=f"0 0 {int(arm.sign[i - 1])}")
    if kind != "continuous":
        low, high = limits or (-FREE, FREE)
        ElementTree.SubElement(
            joint, "limit", lower=repr(low), upper=repr(high), effort="1000", velocity="10"
        )


def _add_ends(joint, parent, child, origin):
    xyz, rpy = to_xyz_rpy(origin)
    ElementTree.SubElement(joint, "parent", link=parent)
    ElementTree.SubElement(joint, "child", link=child)
    ElementTree.SubElement(joint, "origin", xyz=_written(xyz), rpy=_written(rpy))


def _written(values):
    return " ".join("0" if abs(value) < DUST else repr(float(value)) for value in values)
