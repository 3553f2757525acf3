"""A calibration in print: degrees and millimetres, and what cannot be known said in words."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING

import numpy as np

from ..printing import grid_html, grid_text, number

if TYPE_CHECKING:
    from .calibration import Calibration

__all__ = ["calibration_text", "calibration_html"]

HEADINGS = ("joint", "offset", "±", "unit", "")
LEFT = ("", "position rms, mm", "worst, mm", "rotation rms, deg", "worst, deg")


def _rows(result):
    told = {i: group for group in result.undetermined for i in group.joints}
    for i, (offset, sigma, letter) in enumerate(
        zip(result.offsets, result.sigma, result.arm.table.joints), 1
    ):
        scale, unit = (1000, "mm") if letter == "P" else (180 / np.pi, "deg")
        note = "" if i not in told else "known only roughly" if told[i].vague else "not determined"
        spread = number(scale * sigma, 4) if np.isfinite(sigma) else "unknown"
        yield [str(i), number(scale * offset, 4), spread, unit, note]


def _left(result):
    for name, left in (("before", result.before), ("after", result.after)):
        rotation = (
            ["", ""]
            if left.rotation is None
            else [number(np.rad2deg(v), 4) for v in (left.rotation, left.worst_rotation)]
        )
        yield [
            name,
            number(1000 * left.position, 4),
            number(1000 * left.worst_position, 4),
            *rotation,
        ]


def _sentences(result):
    yield from (group.words for group in result.undetermined)
    kind = "estimated from what is left over" if result.explained is None else "as given"
    rotation = (
        ""
        if result.noise[1] is None or result.after.rotation is None
        else f" and {number(np.rad2deg(result.noise[1]), 4)} deg"
    )
    yield f"Noise, {kind}: {number(1000 * result.noise[0], 4)} mm{rotation}."
    if result.explained is False:
        yield (
            "Offsets alone do not explain the measurements: more is left over than the noise; "
            "a length, a twist or a sign is wrong, or the base or tool is. Ask dhlab.diagnose."
        )


def _title(result):
    return (
        f"Zero offsets from {result.poses} poses (added to theta; to d of a joint that slides), ±"
        " one standard deviation"
    )


def calibration_text(result: Calibration) -> str:
    """A calibration as plain text."""
    return "\n".join(
        [
            _title(result),
            grid_text(HEADINGS, _rows(result)),
            "Left over",
            grid_text(LEFT, _left(result)),
            *_sentences(result),
        ]
    )


def calibration_html(result: Calibration) -> str:
    """A calibration as HTML for a notebook."""
    return (
        grid_html(HEADINGS, _rows(result), _title(result))
        + grid_html(LEFT, _left(result), "Left over")
        + "".join(f"<p>{escape(sentence)}</p>" for sentence in _sentences(result))
    )
