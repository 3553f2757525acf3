"""The joints of a URDF file between two links: XML read safely, the chain found, and its numbers
parsed by yourdfpy.
"""

import io
import logging
import re
from xml.etree import ElementTree
from xml.parsers import expat

import numpy as np

from .files import read_text
from .plainyaml import FLOAT

__all__ = ["read_chain"]

MOVABLE = ("revolute", "continuous", "prismatic")
XACRO = re.compile(r"\$[({]")
OTHER_FORMATS = {
    "sdf": "an SDF file",
    "mujoco": "a MuJoCo file",
    "COLLADA": "a COLLADA file",
    "html": "a web page",
}
EXPAND = "expand it first: xacro file.urdf.xacro > file.urdf"


def read_chain(path, base, tip):
    """The joints from ``base`` to ``tip`` in order, and the names of the robot and of the two
    links.

    Parameters
    ----------
    path : str or path
    base, tip : str or None
        Names of links; None: the root and the only leaf.

    Returns
    -------
    joints : list of yourdfpy.Joint
        Fixed ones included; origins, axes and limits hold finite numbers.
    name, base, tip : str

    Raises
    ------
    ValueError
        One sentence: what was expected, what was found, what to do.
    """
    robot = _parse(read_text(path, "a URDF file"), path)
    links, joints = _parts(robot, path)
    above = _joint_above(links, joints, path)
    base, tip = _ends(links, above, base, tip, path)
    chain = _chain(above, base, tip, path)
    for joint in chain:
        _check(joint, path)
    return _numbers(chain, path), robot.get("name", ""), base, tip


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


def _joint_above(links, joints, path):
    """From each link to the joint that carries it: (name, parent, child, element)."""
    above, known = {}, set(links)
    for joint in joints:
        name, parent, child, _ = joint
        for link in (parent, child):
            if link not in known:
                raise ValueError(
                    f"{path}: joint {name}: expected a link of the file, found {link}, which is not"
                    " in it; add the link or correct the name"
                )
        if child in above:
            raise ValueError(
                f"{path}: expected a tree of links, found a loop: link {child} hangs on the joints"
                f" {above[child][0]} and {name}; a DH table can only describe a chain without loops"
            )
        above[child] = joint
    return above


def _ends(links, above, base, tip, path):
    for name, link in (("base", base), ("tip", tip)):
        if link is not None and link not in links:
            raise ValueError(
                f"{path}: {name}: expected a link of the file, found {link!r}; the links are"
                f" {_listed(links)}"
            )
    if base is None and tip is not None:
        return _path(above, tip, path)[-1], tip
    if base is None:
        roots = [link for link in links if link not in above]
        if not roots:
            raise ValueError(
                f"{path}: expected a tree of links, found a loop without a root; a DH table can"
                " only describe a chain without loops"
            )
        if len(roots) > 1:
            raise ValueError(
                f"{path}: expected one root link, found {_listed(roots)}; name one of them as base"
            )
        base = roots[0]
    if tip is None:
        tip = _only_leaf(links, above, base, path)
    return base, tip


def _only_leaf(links, above, base, path):
    parents = {joint[1] for joint in above.values()}
    leaves = [link for link in links if link not in parents and base in _path(above, link, path)]
    if leaves == [base] or not leaves:
        raise ValueError(f"{path}: expected joints below {base}, found none; name another base")
    if len(leaves) > 1:
        raise ValueError(
            f"{path}: expected one tip, found {len(leaves)} leaves below {base}; "
            f"name one of them (or a link before it) as tip: {_listed(leaves)}"
        )
    return leaves[0]


def _path(above, link, path):
    """The links from ``link`` up to its root, both included."""
    found = [link]
    while found[-1] in above:
        found.append(above[found[-1]][1])
        if found[-1] in found[:-1]:
            raise ValueError(
                f"{path}: expected a tree of links, found a loop through {found[-1]}; "
                "a DH table can only describe a chain without loops"
            )
    return found


def _chain(above, base, tip, path):
    """The joint elements from base to tip."""
    up = _path(above, tip, path)
    if base not in up:
        raise ValueError(
            f"{path}: expected a chain from {base} to {tip}, found that {tip} is not below {base}"
            f" (it hangs on {_listed(up[1:])}); name a base above the tip"
        )
    return [above[link][3] for link in reversed(up[: up.index(base)])]


def _listed(names, most=20):
    return (
        ", ".join(names[:most]) + (f" and {len(names) - most} more" if len(names) > most else "")
        or "nothing"
    )


def _check(joint, path):
    """Refuse what a DH table cannot hold, and numbers that a lenient parser would take for
    others.
    """
    where = f"{path}: joint {joint.get('name')}"
    kind = joint.get("type")
    if kind not in (*MOVABLE, "fixed"):
        hint = {
            "floating": "; it has six freedoms, a DH row has one",
            "planar": "; it has three freedoms, a DH row has one",
        }.get(kind, "")
        raise ValueError(
            f"{where}: expected revolute, continuous, prismatic or fixed, found"
            f" {kind or 'no type'}{hint}; choose a base behind it"
        )
    if kind != "fixed" and joint.find("mimic") is not None:
        raise ValueError(
            f"{where}: expected a joint of its own, found one that mimics"
            f" {joint.find('mimic').get('joint')}; a DH table gives every joint its own variable:"
            " choose a tip before it"
        )
    for tag, keys in (("origin", ("xyz", "rpy")), ("axis", ("xyz",))):
        for key in keys:
            text = joint.find(tag) is not None and joint.find(tag).get(key)
            values = _floats(text, 3, f"{where}: {tag} {key}") if text else None
            if tag == "axis" and kind != "fixed" and values == [0, 0, 0]:
                raise ValueError(
                    f"{where}: axis: expected a direction, found 0 0 0; write the axis, such as"
                    " 0 0 1"
                )
    for key in ("lower", "upper"):
        text = joint.find("limit") is not None and joint.find("limit").get(key)
        if text and kind in ("revolute", "prismatic"):
            _floats(text, 1, f"{where}: limit {key}")


def _floats(text, n, where):
    if XACRO.search(text):
        raise ValueError(f"{where}: expected numbers, found the xacro expression {text}; {EXPAND}")
    words = text.split()
    if len(words) != n or not all(FLOAT.match(word) and np.isfinite(float(word)) for word in words):
        raise ValueError(
            f"{where}: expected {'a finite number' if n == 1 else f'{n} finite numbers'}, found"
            f" {text[:60]!r}; write numbers with spaces between them and decimal points"
        )
    return [float(word) for word in words]


def _numbers(chain, path):
    """The joints as yourdfpy reads them, in the order of the chain; meshes and everything else
    never reach it.
    """
    try:
        import yourdfpy
    except ImportError:
        raise ValueError(
            "read_urdf: expected the library yourdfpy, found it is not installed; run pip install"
            " dhlab-kinematics[urdf]"
        ) from None
    robot, names = ElementTree.Element("robot", name="chain"), []
    for joint in chain:
        names += [joint.find(end).get("link") for end in ("parent", "child")]
        robot.append(joint)
    for name in dict.fromkeys(names):
        ElementTree.SubElement(robot, "link", name=name)
    quiet = logging.getLogger("yourdfpy.urdf")
    level = quiet.level
    quiet.setLevel(logging.CRITICAL)  # what it would say about missing efforts is no matter here
    try:
        model = yourdfpy.URDF.load(
            io.BytesIO(ElementTree.tostring(robot)), load_meshes=False, build_scene_graph=False
        )
    finally:
        quiet.setLevel(level)
    return [model.joint_map[joint.get("name")] for joint in chain]
