"""The parameters of ortho-parallel arms with a spherical wrist (Brandstötter, Angerer and Hofbaur
2014), as opw_kinematics has them.
"""

import re

import numpy as np

from .....transform import rot_z, trans
from ...chain import arm_of, joint_along, still
from ...language.expressions import key
from ..flat import arrays_in
from .told import told

__all__ = ["read"]

TURN = 2 * np.pi + 0.01
NEEDED = ("a1", "a2", "c1", "c2", "c3", "c4")


def read(source, nominal=None):
    """The Readings of OPW parameters; None when they are not all there."""
    named = {
        key(name): source.value(text)
        for name, text in re.findall(
            r"(?<![\w])(?:\w+\.)?['\"]?([abc][1-4]?)['\"]?\s*[=:]\s*([^,;\n}]+)", source.code
        )
    }
    if any(named.get(name) is None for name in NEEDED) or (
        "alpha" in source.code and "opw" not in source.code.lower()
    ):
        return None
    numbers = {name: named[name].number for name in NEEDED}
    numbers["b"] = named["b"].number if named.get("b") else 0.0
    offsets, signs = _arrays(source)
    return told(
        "parameters of an ortho-parallel arm (OPW)",
        lambda scale: arm_of(_steps({k: v * scale for k, v in numbers.items()}, offsets, signs)),
        list(numbers.values()),
        source,
        "as opw_kinematics has it: the joint's value is sign · q - offset",
    )


def _arrays(source):
    """(offsets, signs) of the six joints."""
    found = {"offset": np.zeros(6), "sign": np.ones(6)}
    for name, values in arrays_in(source).items():
        for word in found:
            if word in name.lower() and len(values) == 6:
                numbers = np.array([value.number for value, _ in values])
                large = np.abs(numbers).max() > TURN
                found[word] = np.deg2rad(numbers) if word == "offset" and large else numbers
    for word, index, text in re.findall(
        r"(offset|sign)\w*\s*\[(\d)\]\s*=\s*([^,;\n]+)", source.code.lower()
    ):
        value = source.value(text)
        if value is not None and int(index) < 6:
            large = word == "offset" and (value.unit == "deg" or abs(value.number) > TURN)
            found[word][int(index)] = np.deg2rad(value.number) if large else value.number
    for joints in re.findall(r"((?:\bJ[1-6]\s*=\s*)+)-\s*1\b", source.code, re.IGNORECASE):
        for joint in re.findall(r"\d", joints):
            found["sign"][int(joint) - 1] = -1
    return found["offset"], np.where(found["sign"] < 0, -1, 1)


def _steps(p, offsets, signs):
    """Upright at zero: z, y, y, z, y, z; every joint turned back by its offset."""
    moves = [
        ("z", (0.0, 0.0, 0.0)),
        ("y", (p["a1"], p["b"], p["c1"])),
        ("y", (0.0, 0.0, p["c2"])),
        ("z", (p["a2"], 0.0, p["c3"])),
        ("y", (0.0, 0.0, 0.0)),
        ("z", (0.0, 0.0, 0.0)),
    ]
    for (axis, shift), offset, sign in zip(moves, offsets, signs):
        yield still(trans(shift))
        yield joint_along("R", axis, int(sign))
        yield still(_turn(axis, -offset))
    yield still(trans([0.0, 0.0, p["c4"]]))


def _turn(axis, angle):
    from .....transform import rot_y

    return rot_z(angle) if axis == "z" else rot_y(angle)
