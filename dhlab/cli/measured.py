"""What ``dhlab doctor`` is told of measurements: their units, and how far they scatter."""

import re

from ..formats.files import read_text
from ..formats.plainyaml import placed
from ..formats.posefile import LARGEST
from ..units import ANGLE, LENGTH
from .common import units_of

__all__ = ["noise_of", "units_of_poses"]

ANGLES = {**ANGLE, "°": ANGLE["deg"]}


def units_of_poses(told: str, path: str) -> tuple[str, str]:
    """The unit of length and that of angles: as told, as a line of the poses file says, or both
    alike.
    """
    line, written = _written_units(path)
    if not (told or written):
        raise ValueError(
            f"doctor: expected the units of {path}, found none; add --units mm,deg or --units"
            " m,rad, or a line # units: mm,deg to the file"
        )
    if not written:
        return units_of(told, "doctor")
    units = placed(f"{path}: line {line}", lambda: units_of(written, "doctor"))
    if told and units_of(told, "doctor") != units:
        raise ValueError(
            f"doctor: --units: expected the units that {path} names, {written}, found {told}; leave"
            " --units out, or correct the line in the file"
        )
    return units


def _written_units(path):
    """The line of the poses file that names its units, and the units; 0 and "" where none does."""
    text = read_text(path, "a poses file", LARGEST)
    pattern = r"^[ \t]*#.*\bunits:[ \t]*([^;\n]*?)[ \t,]*(?:;|$)"
    lines = [
        (text.count("\n", 0, found.start()) + 1, found[1])
        for found in re.finditer(pattern, text, re.MULTILINE)
    ]
    for line, said in lines[1:]:
        if said != lines[0][1]:
            raise ValueError(
                f"{path}: line {line}: expected the units of line {lines[0][0]}, {lines[0][1]},"
                f" found {said}; leave one of the lines out"
            )
    return lines[0] if lines else (0, "")


def noise_of(text: str) -> tuple[float, ...] | None:
    """(m, rad) or one number from "1mm,0.2deg"; None when nothing was given."""
    if not text.strip():
        return None
    parts = [part.strip() for part in text.split(",")]
    if len(parts) > 2:
        raise _bad_noise(text)
    return tuple(_amount(part, known, text) for part, known in zip(parts, (LENGTH, ANGLES)))


def _amount(part, known, text):
    found = re.fullmatch(r"(\d+\.?\d*|\.\d+)(?:[eE]([+-]?\d{1,2}))?\s*([a-z°]+)", part)
    if not found or found[3] not in known:
        raise _bad_noise(text)
    value = float(found[1] + ("e" + found[2] if found[2] else "")) * known[found[3]]
    if not 0 < value < 10:
        raise _bad_noise(text)
    return value


def _bad_noise(text):
    return ValueError(
        "doctor: --noise: expected a length and perhaps an angle above 0, each with its unit, such"
        f" as 1mm,0.2deg, found {text!r}"
    )
