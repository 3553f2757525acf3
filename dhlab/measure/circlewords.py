"""Circles in words: what each tells about the model, and what no arc can tell."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING

import numpy as np

from ..printing import grid_html, grid_text, number

if TYPE_CHECKING:
    from .circles import Circle, CircleReport

__all__ = ["circle_words", "report_text", "report_html", "NO_PROOF"]

NO_PROOF = (
    "That a joint draws an arc proves nothing about a table: every table, right or wrong, draws an"
    " exact circle when one joint turns. What can be wrong is where the axis lies and points, and"
    " the circle's height, radius and phase."
)
SURE = 3.0  # standard deviations
# rad and m; below it rounding, whatever the scatter
SMALLEST = {"axis": 1e-6, "shift": 1e-6, "height": 1e-6, "radius": 1e-6, "phase": 1e-6}
UNITS = {"axis": "deg", "shift": "mm", "height": "mm", "radius": "mm", "phase": "deg"}
HEADINGS = (
    "joint",
    "points",
    "axis (x y z)",
    "± deg",
    "centre, mm",
    "± mm",
    "radius, mm",
    "± mm",
    "phase, deg",
    "± deg",
    "off the circle, mm",
)
COMPARED = ("joint", "axis, deg", "axis shift, mm", "height, mm", "radius, mm", "phase, deg")


def circle_words(circle: Circle) -> str:
    """A sentence or two on one circle."""
    start = f"Joint {circle.joint}: "
    if circle.fault:
        todo = (
            ""
            if "line" in circle.fault or "step" in circle.fault
            else "; measure a point off the axis, or compare rotations"
        )
        return f"{start}no circle to compare: {circle.fault}{todo}."
    return start + " ".join(filter(None, [_verdict(circle), _scatter(circle), _short_arc(circle)]))


def _clear(circle, name):
    value, sigma = circle.differs.get(name, (0.0, 0.0))
    return abs(value) > max(SURE * sigma, SMALLEST[name])


def _said(circle, name):
    return f"{_with_sigma(circle.differs[name], UNITS[name])} {UNITS[name]}"


def _in_unit(value, unit, sigma=0.0):
    """A value in its unit, no further than two digits of its ± go; short where that is nothing."""
    scale = 1000 if unit == "mm" else 180 / np.pi
    if sigma * scale < 5e-4:
        return number(value * scale, 3)
    return _fixed(value * scale, _places(sigma * scale))


def _with_sigma(pair, unit):
    value, sigma = pair
    return f"{_in_unit(value, unit, sigma)} ± {_in_unit(sigma, unit, sigma)}"


def _places(sigma):
    """Decimals that show two digits of a standard deviation, three at most."""
    return int(np.clip(1 - np.floor(np.log10(sigma)), 0, 3))


def _fixed(value, digits):
    return f"{round(value, digits) + 0.0:.{digits}f}"


def _verdict(circle):
    """What the differences mean: a mistake before joint i moves its axis, one in or behind its row
    changes the circle about the axis.
    """
    if not circle.differs:
        return (
            f"a circle of {_with_sigma((circle.radius, circle.sigma['radius']), 'mm')} mm (no model"
            " to compare with)."
        )
    i, sentences = circle.joint, []
    if circle.differs["axis"][0] > np.pi / 2:
        sentences.append(
            f"turns the other way round than the model's ({_said(circle, 'axis')} between the"
            " axes): its sign, or an axis before it turned round."
        )
    elif _clear(circle, "axis") or _clear(circle, "shift"):
        rows = (
            f"the rows before joint {i}"
            if circle.convention == "standard"
            else f"a and alpha of the rows up to {i}, theta and d of those before"
        )
        sentences.append(
            f"its axis is not where the model has it ({_said(circle, 'axis')}, shifted by"
            f" {_said(circle, 'shift')}): look at the base and at {rows}."
        )
    about = [name for name in ("radius", "height") if _clear(circle, name)]
    if about:
        said = ", ".join(f"{name} by {_said(circle, name)}" for name in about)
        rows = f"row {i}" if circle.convention == "standard" else f"theta and d of row {i}"
        sentences.append(
            f"the circle itself differs ({said}): look at {rows}, at the rows behind it and at the"
            " tool."
        )
    elif _clear(circle, "phase"):
        sentences.append(
            f"only the phase differs ({_said(circle, 'phase')}): the zero offset of joint {i}."
            if not sentences
            else f"the phase differs too ({_said(circle, 'phase')})."
        )
    sentences = sentences or ["agrees with the model in axis, place, height, radius and phase."]
    return " ".join(
        sentences[:1] + [sentence[0].upper() + sentence[1:] for sentence in sentences[1:]]
    )


def _scatter(circle):
    if circle.noise and circle.off_circle > SURE * circle.noise:
        return (
            f"But the points leave the circle by {number(1000 * circle.off_circle, 3)} mm, more"
            " than the noise: another joint moved with it (a coupling), or there is play."
        )
    if (
        circle.noise
        and circle.off_angle * circle.radius > SURE * circle.noise + circle.sigma["centre"]
    ):
        return (
            f"But they lead or lag the joint by {number(np.rad2deg(circle.off_angle), 3)} deg: a"
            " gear ratio, or play."
        )
    return ""


def _short_arc(circle):
    if circle.span < np.deg2rad(45):
        return (
            f"The arc is short ({number(np.rad2deg(circle.span), 0)} deg), so centre and radius are"
            " badly known."
        )
    return ""


def _rows(report):
    for c in report.circles:
        if c.fault:
            yield [str(c.joint), str(c.points), "no circle"] + [""] * 8
            continue
        yield [
            str(c.joint),
            str(c.points),
            " ".join(_fixed(v, 4) for v in c.axis),
            _in_unit(c.sigma["axis"], "deg", c.sigma["axis"]),
            " ".join(_in_unit(v, "mm", c.sigma["centre"]) for v in c.centre),
            _in_unit(c.sigma["centre"], "mm", c.sigma["centre"]),
            _in_unit(c.radius, "mm", c.sigma["radius"]),
            _in_unit(c.sigma["radius"], "mm", c.sigma["radius"]),
            _in_unit(c.phase, "deg", c.sigma["phase"]),
            _in_unit(c.sigma["phase"], "deg", c.sigma["phase"]),
            _in_unit(c.off_circle, "mm"),
        ]


def _compared(report):
    for c in report.circles:
        if c.differs:
            yield [str(c.joint)] + [
                _with_sigma(c.differs[k], UNITS[k]) if k in c.differs else "" for k in UNITS
            ]


def _sentences(report):
    yield from (circle.words for circle in report.circles)
    if report.left_out:
        many = (
            "1 measurement belongs"
            if report.left_out == 1
            else f"{report.left_out} measurements belong"
        )
        yield f"{many} to no sweep of a single joint; left out."
    yield NO_PROOF


def report_text(report: CircleReport) -> str:
    """A report as plain text."""
    parts = ["Measured circles", grid_text(HEADINGS, _rows(report))]
    compared = list(_compared(report))
    if compared:
        parts += [
            "Measured minus the model's (± one standard deviation)",
            grid_text(COMPARED, compared),
        ]
    return "\n".join([*parts, *_sentences(report)])


def _unbroken(cells):
    """Cells whose numbers stay on one line, however narrow the screen."""
    return [cell.replace(" ", "\u00a0") for cell in cells]


def report_html(report: CircleReport) -> str:
    """A report as HTML for a notebook."""
    compared = list(_compared(report))
    tables = grid_html(HEADINGS, map(_unbroken, _rows(report)), "Measured circles")
    if compared:
        tables += grid_html(
            COMPARED,
            map(_unbroken, compared),
            "Measured minus the model's (± one standard deviation)",
        )
    return tables + "".join(f"<p>{escape(sentence)}</p>" for sentence in _sentences(report))
