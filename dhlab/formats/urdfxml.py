"""URDF's XML read safely, down to the names of its links and joints; numbers stay text here."""

import re
from pathlib import Path
from xml.etree import ElementTree
from xml.etree.ElementTree import Element
from xml.parsers import expat

from .files import read_text

__all__ = ["EXPAND", "XACRO", "read_parts"]

XACRO = re.compile(r"\$[({]")
OTHER_FORMATS = {
    "sdf": "an SDF file",
    "mujoco": "a MuJoCo file",
    "COLLADA": "a COLLADA file",
    "html": "a web page",
}
EXPAND = "expand it first: xacro file.urdf.xacro > file.urdf"


def read_parts(path: str | Path) -> tuple[str, list[str], list[tuple[str, str, str, Element]]]:
    """The name of the robot, its links and its joints.

    Parameters
    ----------
    path : str or path

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
    robot = _parse(read_text(path, "a URDF file"), path)
    return robot.get("name", ""), *_parts(robot, path)


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
    robot = builder.close()
    if robot.tag.startswith("xacro:") or any(
        element.tag.startswith("xacro:") for element in robot.iter()
    ):
        raise ValueError(f"{path}: expected a URDF file, found xacro macros in it; {EXPAND}")
    if robot.tag != "robot":
        found = OTHER_FORMATS.get(robot.tag, f"the element <{robot.tag}>")
        raise ValueError(
            f"{path}: expected a URDF file, whose outermost element is <robot>, found {found};"
            " convert it or name another file"
        )
    return robot


def _refuse_doctype(path):
    raise ValueError(
        f"{path}: expected plain URDF, found a document type (<!DOCTYPE …>), which can hide other"
        " files in it; take it out"
    )


def _parts(robot, path):
    """Names of the links, and joints as (name, parent, child, element)."""
    links = [_attribute(link, "name", "a link", path) for link in robot.findall("link")]
    joints = []
    for joint in robot.findall("joint"):
        name = _attribute(joint, "name", "a joint", path)
        ends = [joint.find(end) for end in ("parent", "child")]
        if None in ends:
            raise ValueError(
                f"{path}: joint {name}: expected <parent link=…/> and <child link=…/>, found one"
                " missing; name both links"
            )
        joints.append(
            (
                name,
                *(_attribute(end, "link", f"joint {name}: {end.tag}", path) for end in ends),
                joint,
            )
        )
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
