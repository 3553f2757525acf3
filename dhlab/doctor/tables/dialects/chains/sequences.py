"""Sequences of elementary transforms: ``Rz(q1) Tz(0.3) Rx(-90°)``, ``ET.Rz() * ET.tz(0.3)``."""

import math
import re

from .....transform import rot_x, rot_y, rot_z, trans
from ...cells import kind_of_letter
from ...chain import arm_of, joint_along, still
from ...language.expressions import Value
from .told import told

__all__ = ["read"]

MOVE = re.compile(
    r"\b(?:E[T2]?S?3?\.)?(rot|trot|transl?|R|T|t|Rot|Trans)_?([xyz])\b\s*\(\s*((?:[^()]|\([^()]*\))*)\)"
    r"|\b(Rot|Trans|rot|trans)\s*\(\s*['\"]?([xyz])['\"]?\s*,\s*((?:[^()]|\([^()]*\))*)\)"
)
# a move by three lengths: transl(0.1, 0, 0.3), SE3.Trans(…), Translation(…)
BY_THREE = re.compile(
    r"\b(?:SE3\.)?(?:transl|[Tt]rans(?:lation)?)\s*\(\s*\[?([^(),\[\]]+),([^(),\[\]]+),([^(),\[\]]+)\]?\s*\)"
)
MOVING = re.compile(r"\b(?:t?rot|transl?|rotation|translation)[xyz]?\s*\(", re.IGNORECASE)
TURNS = {"x": rot_x, "y": rot_y, "z": rot_z}


def read(source, nominal=None):
    """The Readings of a sequence with at least two joints; None of other texts."""
    code = BY_THREE.sub(r"transx(\1) * transy(\2) * transz(\3)", source.code)
    moves = [_move(match, source) for match in MOVE.finditer(code)]
    if len(moves) < 3 or any(move is None for move in moves):
        return None
    joints = [move for move in moves if move[3]]
    if len(joints) < 2 or any(
        kind_of_letter(letter) in ("alpha", "a", "length") for _, _, _, letter, _ in joints
    ):
        return None
    if re.search(r"\bA_?i\b|T_i\b|\[i\]|\(i\)", source.code) or any(
        letter and not re.search(r"\d", letter) for *_, letter, _ in joints if letter != "q"
    ):
        return None  # one row for all: the general link matrix
    _require_all_read(code)
    angles = [abs(value.number) for turns, _, value, _, _ in moves if turns and not value.unit]
    degrees = any(angle > 2 * math.pi + 0.01 for angle in angles)
    lengths = [value.number for turns, _, value, _, _ in moves if not turns]
    why = "numbers beyond 2π being degrees" if degrees else ""

    def make(scale):
        return arm_of([step for move in moves for step in _steps(move, scale, degrees)])

    notes = _sideways(moves)
    return told("a sequence of elementary transforms", make, lengths, source, why, notes=notes)


def _require_all_read(code):
    """No move may be left out in silence."""
    left = MOVING.search(MOVE.sub(" ", code))
    if left:
        found = MOVE.sub(" ", code)[left.start() : left.start() + 40].split("\n")[0]
        raise ValueError(
            "recognise_table: expected moves such as rotz(q1), transx(0.3) or transl(0, 0, 0.3),"
            f" found {found!r}; write it as one of these"
        )


def _sideways(moves):
    """A DH row has no step along y: where one stands, what it becomes."""
    steps = [value for turns, axis, value, letter, _ in moves if axis == "y" and not turns]
    if not steps or any(letter for turns, axis, _, letter, _ in moves if axis == "y"):
        return ()
    step = steps[0].number
    told = f"Ty({step:g}) Rz(-90) is Rz(-90) Tx({-step:g})"
    return (
        "a DH row has no step along y and needs none: turned by 90 degrees about z first, it is a"
        f" step along x ({told}), which the row holds as a, with the turn in theta",
    )


def _move(match, source):
    """(whether it turns, axis, value, letter of the joint or "", sign); None when it is no move."""
    word, axis, text = (
        (match[1], match[2], match[3]) if match[1] else (match[4], match[5], match[6])
    )
    turns = word.lower() in ("r", "rot", "trot")
    parts = [part.strip() for part in text.split(",")]
    flip = any(re.fullmatch(r"flip\s*=\s*(True|1|true)", part) for part in parts)
    unit = " deg" if any(part.strip("'\"") == "deg" for part in parts[1:]) else ""
    first = next((part for part in parts if part and "=" not in part), "")
    if not first:
        return turns, axis, Value(0.0), "q", -1 if flip else 1
    value = source.value(f"({first}){unit}" if unit else first)
    if value is None or len(value.letters) > 1:
        return None
    letter = next(iter(value.letters), "")
    if letter and abs(value.letters[letter]) != 1:
        return None
    return turns, axis, value, letter, int(value.letters.get(letter, 1)) * (-1 if flip else 1)


def _steps(move, scale, degrees):
    turns, axis, value, letter, sign = move
    if turns:
        number = value.number
        if value.unit == "deg" or (not value.unit and degrees):
            number = math.radians(number)
        constant = still(TURNS[axis](number)) if number else None
    else:
        number = value.number * scale
        constant = still(trans([number * (axis == one) for one in "xyz"])) if number else None
    joint = [joint_along("R" if turns else "P", axis, sign)] if letter else []
    return [*joint, *([constant] if constant else [])]
