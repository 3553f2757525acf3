"""Chains in code: KDL's segments (C++ and PyKDL), ikpy's links."""

import re
from dataclasses import replace

import numpy as np

from .....kinematics import link_matrices
from .....transform import from_xyz_rpy, rot_x, rot_y, rot_z, trans
from ...chain import arm_of, joint_along, still
from ...language.brackets import cells_in, groups, keyword
from ..flat import arrays_in
from .looped import named, written_out
from .told import told

__all__ = ["read"]

FRAMES = "dh", "dh_craig1989", "vector", "frame", "identity", "rpy"
ROTATIONS = {"rotx": rot_x, "roty": rot_y, "rotz": rot_z}
JOINT = re.compile(r"\b(Rot|Trans)([XYZ])\b")


def read(source, nominal=None):
    """The Readings of a chain of segments or links; None where there are none."""
    code = written_out(source) if "segment" in source.code.lower() else source.code
    found = groups(code)
    calls = [group for group in found if group.mark == "("]
    segments = [group for group in calls if _last(group) == "segment"]
    if segments and any(re.search(r"\[\s*[a-z]\s*\]", one.text) for one in segments):
        return None  # filled in a loop: the numbers stand in arrays
    if segments:
        return _kdl(segments, source, code)
    frames = [
        group
        for group in calls
        if _last(group) in ("dh", "dh_craig1989") and "frame" in group.name.lower()
    ]
    if len(frames) >= 2:
        return _bare_frames(frames, source)
    links = [group for group in calls if _last(group) == "urdflink"]
    return _ikpy(links, source) if links else None


def _last(group):
    return re.split(r"\.|::", group.name)[-1].lower()


def _numbers(texts, source, what):
    values = [_value(text, source) for text in texts]
    if any(value is None or value.letters for value in values):
        shown = ", ".join(texts)[:60]
        raise ValueError(
            f"recognise_table: {what}: expected numbers, found {shown!r}; give the letters' values"
            " beside the text"
        )
    return [np.deg2rad(value.number) if value.unit == "deg" else value.number for value in values]


def _value(text, source):
    """The Value of an expression, or of an array's element, whatever its name is."""
    element = re.fullmatch(r"([\w.]+)\[(\d+)\]", text)
    held = arrays_in(source).get(element[1].split(".")[-1], ()) if element else ()
    return (
        held[int(element[2])][0] if element and int(element[2]) < len(held) else source.value(text)
    )


def _kdl(segments, source, code):
    """A segment moves about its joint, then goes to its tip."""
    parts, lengths = [], []
    for number, segment in enumerate(segments, 1):
        what = f"segment {number}"
        segment = _with_names(segment, code, what)
        joint = JOINT.search(
            " ".join(item.text for item in segment.items if "joint" in item.text.lower())
        )
        if joint and _axis_given(segment):
            raise ValueError(
                f"recognise_table: {what}: expected a joint about x, y or z, found an axis of its"
                " own; paste the URDF"
            )
        frame = _frame(segment, source, what, lengths)
        parts.append((joint, frame))

    def make(scale):
        steps = []
        for joint, frame in parts:
            if joint:
                steps.append(joint_along("R" if joint[1] == "Rot" else "P", joint[2].lower()))
            steps.append(still(frame(scale)))
        return arm_of(steps)

    return told("segments of KDL", make, lengths, source, "each moving about its joint first")


def _with_names(segment, code, what):
    """The segment with what the names of its joint and its frame stand for."""
    items, left = [], ""
    for item in segment.items:
        named_one = re.fullmatch(r"[A-Za-z_]\w*", item.text)
        said = named(item.text, code, segment.line) if named_one else ""
        left = item.text if named_one and not said else left
        items.append(replace(item, text=said, groups=groups(said)) if said else item)
    segment = replace(segment, items=items)
    if left and not any(_last(one) in FRAMES for one in _all_groups(segment)):
        raise ValueError(
            f"recognise_table: {what}: expected its joint and its frame, found {left[:30]}; what is"
            " that? Write it into the brackets of the segment"
        )
    return segment


def _axis_given(segment):
    return any(re.search(r"Joint\s*\([^()]*Vector", item.text) for item in segment.items)


def _frame(segment, source, what, lengths):
    """The pose of a segment's tip as a function of the scale of lengths."""
    inner = [part for part in _all_groups(segment) if part.mark == "("]
    for part in inner:
        if _last(part) in ("dh", "dh_craig1989"):
            a, alpha, d, theta = _four(part, source, what)
            lengths.extend((a, d))
            convention = "standard" if _last(part) == "dh" else "craig"
            return lambda s: link_matrices(convention, theta, d * s, a * s, alpha)
    shift = next((part for part in inner if _last(part) == "vector"), None)
    xyz = _numbers([item.text for item in shift.items], source, what) if shift else [0, 0, 0]
    lengths.extend(xyz)
    R = np.eye(4)
    for part in inner:
        if _last(part) == "rpy":
            R = R @ from_xyz_rpy([0, 0, 0], _numbers([i.text for i in part.items], source, what))
        elif _last(part) in ROTATIONS and "rotation" in part.name.lower():
            R = R @ ROTATIONS[_last(part)](*_numbers([i.text for i in part.items], source, what))
        elif _last(part) in ("quaternion", "eulerzyx", "eulerzyz", "rot", "rot2"):
            raise ValueError(
                f"recognise_table: {what}: expected a rotation as RPY or RotX, RotY, RotZ, found"
                f" {part.name}; write it as one of these"
            )
    return lambda s: trans(np.array(xyz) * s) @ R


def _all_groups(group):
    for item in group.items:
        for inner in item.groups:
            yield inner
            yield from _all_groups(inner)


def _four(group, source, what):
    if len(group.items) != 4:
        raise ValueError(
            f"recognise_table: {what}: expected a, alpha, d, theta, found {len(group.items)}"
            " numbers; write all four"
        )
    return _numbers([item.text for item in group.items], source, what)


def _bare_frames(frames, source):
    """Frames without joints: rows of their convention, or segments whose joint comes first."""
    numbers = [(_last(one), _four(one, source, f"frame {k}")) for k, one in enumerate(frames, 1)]
    lengths = [value for _, (a, _, d, _) in numbers for value in (a, d)]

    def make(joint_first):
        def chain(scale):
            steps = []
            for kind, (a, alpha, d, theta) in numbers:
                convention = "standard" if kind == "dh" else "craig"
                if joint_first or kind == "dh":
                    steps.append(joint_along("R", "z"))
                    steps.append(
                        still(link_matrices(convention, theta, d * scale, a * scale, alpha))
                    )
                else:
                    steps.append(still(link_matrices("craig", 0.0, 0.0, a * scale, alpha)))
                    steps.append(joint_along("R", "z"))
                    steps.append(still(link_matrices("craig", theta, d * scale, 0.0, 0.0)))
            return arm_of(steps, "craig" if kind != "dh" else "standard")

        return chain

    first = told("frames of KDL", make(False), lengths, source, "one row with its joint in each")
    if all(kind == "dh" for kind, _ in numbers):
        return first
    second = told(
        "frames of KDL", make(True), lengths, source, "each the tip of a segment that turns first"
    )
    return [
        _with_form(one, form)
        for form, made in (("rows", first), ("segments", second))
        for one in made
    ]


def _with_form(reading, form):
    choices = tuple((name, form if name == "form" else value) for name, value in reading.choices)
    return replace(reading, choices=choices)


def _ikpy(links, source):
    """A link goes to its origin, then turns about its axis."""
    steps, lengths = [], []
    for number, link in enumerate(links, 1):
        named = dict(pair for item in link.items if (pair := keyword(item.text)))
        what = f"link {number}"

        def triple(*names, named=named, what=what):
            text = next((named[name] for name in names if name in named), "")
            if not text or text == "None":
                return [0.0, 0.0, 0.0] if names[0] != "rotation" else None
            cells = cells_in(re.sub(r"^[\w.]*\(?\[|[\])]+$", "", text.strip()))
            if len(cells) != 3:
                raise ValueError(
                    f"recognise_table: {what}: expected three numbers, found {text[:40]!r};"
                    " write all three"
                )
            return _numbers(cells, source, what)

        xyz = triple("origin_translation", "translation_vector", "translation")
        rpy = triple("origin_orientation", "orientation")
        axis = triple("rotation")
        slide = (
            triple("translation")
            if named.get("joint_type", "").strip("'\"") == "prismatic"
            else None
        )
        lengths.extend(xyz)
        steps.append((xyz, rpy, slide or axis, "P" if slide else "R"))

    def make(scale):
        chain = []
        for xyz, rpy, axis, letter in steps:
            chain.append(still(from_xyz_rpy(np.array(xyz) * scale, rpy)))
            if axis is not None and any(axis):
                chain.append(joint_along(letter, axis))
        return arm_of(chain, "craig")

    return told("links of ikpy", make, lengths, source, "each at its origin, then turning")
