"""URDF's XML read safely, down to the names of its links and joints; numbers stay text here."""

import re
from collections.abc import Mapping
from pathlib import Path
from xml.etree import ElementTree
from xml.etree.ElementTree import Element
from xml.parsers import expat

from ..files import read_text
from .xacrofile import expanded

__all__ = ["EXPAND", "XACRO", "parsed", "parts", "read_parts", "read_robot"]

XACRO = re.compile(r"\$[({]")
OTHER_FORMATS = {
    "sdf": "an SDF file",
    "mujoco": "a MuJoCo file, which dhlab.read_mjcf reads",
    "COLLADA": "a COLLADA file",
    "html": "a web page",
}
EXPAND = "call the file .xacro, so that it is expanded"
LOOKS = {"visual", "collision", "inertial", "material", "gazebo", "transmission", "ros2_control"}
DEFINED = {"xacro:property", "xacro:arg", "xacro:macro"}  # of no effect where nothing uses them


def read_parts(
    path: str | Path,
    arguments: Mapping[str, object] | None = None,
    packages: Mapping[str, str | Path] | None = None,
) -> tuple[str, list[str], list[tuple[str, str, str, Element]]]:
    """The name of the robot, its links and its joints.

    Parameters
    ----------
    path : str or path
        A URDF, or a xacro file, which is expanded.
    arguments, packages
        Of a xacro file, as :func:`dhlab.formats.descriptions.xacrofile.expanded` takes them.

    Returns
    -------
    name : str
    links : list of str
    joints : list of (name, parent, child, element)

    Raises
    ------
    ValueError
        One sentence: what was expected, what was found, what to do.
    """
    robot = read_robot(path, arguments, packages)
    return robot.get("name", ""), *parts(robot, path)


def read_robot(
    path: str | Path,
    arguments: Mapping[str, object] | None = None,
    packages: Mapping[str, str | Path] | None = None,
    *,
    looks: bool = False,
) -> Element:
    """The element ``<robot>``, expanded where joints, or with ``looks`` also the shapes of links,
    are written with macros; as :func:`read_parts` otherwise.
    """
    robot = parsed(path, "a URDF file")
    if (arguments or packages) and not _wants_expanding(robot, set()):
        raise ValueError(
            f"{path}: expected a xacro file for the arguments and packages given, found a plain"
            " one; leave them out"
        )
    if arguments or _wants_expanding(robot, DEFINED if looks else DEFINED | LOOKS):
        robot = _parse(expanded(path, arguments, packages), path)
    _require_robot(robot, path)
    return robot


def parsed(path: str | Path, what: str) -> Element:
    """The outermost element of an XML file, read safely."""
    return _parse(read_text(path, what), path)


def _parse(text, path):
    """The root element. A document type is refused before it is read, so no entity can grow or
    fetch a file.
    """
    # without namespaces: some files use prefixes they never declare
    builder, parser = ElementTree.TreeBuilder(), expat.ParserCreate()
    parser.StartElementHandler, parser.EndElementHandler = builder.start, builder.end
    parser.StartDoctypeDeclHandler = lambda *_: _refuse_doctype(path)
    try:
        parser.Parse(text, True)
    except expat.ExpatError as error:
        raise ValueError(
            f"{path}: line {error.lineno}: expected XML, found {expat.ErrorString(error.code)}; "
            "open the file and look at this line"
        ) from None
    return builder.close()


def _wants_expanding(robot, without):
    """Whether macros are used: definitions that nothing asks for stand in many a plain file."""
    return robot.tag.startswith("xacro:") or any(
        element.tag.startswith("xacro:") or any(map(XACRO.search, element.attrib.values()))
        for element in _that_count(robot, without)
    )


def _that_count(robot, without):
    """The elements of a file, but for those of the tags ``without`` and what is in them."""
    waiting = [robot]
    while waiting:
        for child in waiting.pop():
            if child.tag not in without:
                yield child
                waiting.append(child)


def _require_robot(robot, path):
    if robot.tag != "robot":
        found = OTHER_FORMATS.get(robot.tag, f"the element <{robot.tag}>")
        raise ValueError(
            f"{path}: expected a URDF file, whose outermost element is <robot>, found {found};"
            " convert it or name another file"
        )


def _refuse_doctype(path):
    raise ValueError(
        f"{path}: expected plain URDF, found a document type (<!DOCTYPE …>), which can hide other"
        " files in it; take it out"
    )


def parts(
    robot: Element, path: str | Path
) -> tuple[list[str], list[tuple[str, str, str, Element]]]:
    """Names of the links, and joints as (name, parent, child, element)."""
    links = [_attribute(link, "name", "a link", path) for link in robot.findall("link")]
    joints = []
    for joint in robot.findall("joint"):
        name = _attribute(joint, "name", "a joint", path)
        parent, child = joint.find("parent"), joint.find("child")
        if parent is None or child is None:
            raise ValueError(
                f"{path}: joint {name}: expected <parent link=…/> and <child link=…/>, found one"
                " missing; name both links"
            )
        above = _attribute(parent, "link", f"joint {name}: parent", path)
        below = _attribute(child, "link", f"joint {name}: child", path)
        joints.append((name, above, below, joint))
    if not links or not joints:
        raise ValueError(
            f"{path}: expected links and joints, found {len(links)} links and {len(joints)} joints;"
            " is it a whole robot?"
        )
    for kind, names in (("link", links), ("joint", [joint[0] for joint in joints])):
        if len(set(names)) < len(names):
            twice = next(name for name in names if names.count(name) > 1)
            raise ValueError(f"{path}: expected every {kind} once, found {twice} twice; rename one")
    return links, joints


def _attribute(element, key, what, path):
    value = element.get(key)
    if not value:
        raise ValueError(
            f'{path}: {what}: expected the attribute {key}, found none; write {key}="…"'
        )
    if XACRO.search(value):
        raise ValueError(
            f"{path}: expected a URDF file, found the xacro expression {value}; {EXPAND}"
        )
    return value
