"""Somebody's frames beside the joint axes that they were meant for, with the first thing that does
not fit marked; what would fit is not drawn.
"""

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from ...printing import number
from .. import words
from ..drawing.camera import orbit
from ..drawing.floor import add_floor, floor_height
from ..drawing.page import View, compose
from ..drawing.scene import Dot, Label, Scene, Stroke
from ..drawing.style import AXES, INK, axis_name
from ..drawing.triads import add_triads
from ..given import spread
from ..picture import Picture
from .axes import add_lines, pairs_of

__all__ = ["tried"]

Vector = NDArray[np.float64]
MARK = "#b35900"  # as the word "Not yet" is written
FAR = 4.0  # times the size of the axes: what stands further off cannot be drawn beside them
SMALL = 0.2  # m, the size of a picture in which nothing has one


def tried(
    lines: Sequence[tuple[Vector, Vector, str]],
    frames: Mapping[str, Mapping[str, Vector]],
    mark: str,
    *,
    title: str = "Yours, beside the joint axes",
) -> Picture | None:
    """Frames as somebody placed them, whole or in part, beside joint axes.

    Parameters
    ----------
    lines : list of (point (3,), direction (3,), "R" | "P")
        The joint axes; none for a pose alone, which is drawn beside the base.
    frames : dict of dict
        By the frame's name what is placed of it: "o", a point (3,); "x", "z" and, where it is not
        z × x, "y", directions (3,); "at", where they stand while there is no "o".
    mark : str
        What does not fit, such as "x1" or "o2": it is drawn thick, and said.

    Returns
    -------
    Picture, or None where what is placed stands too far off to be drawn.

    Examples
    --------
    >>> e, o = np.eye(3), np.zeros(3)
    >>> print(tried([(o, e[2], "R")], {"0": {"z": e[0], "at": o}}, "z0").alt)
    Your frames beside 1 joint axis. Marked is what does not fit: z0, along (1, 0, 0).
    """
    stands = np.array([part.get("o", part.get("at")) for part in frames.values()])
    points = np.array([p for p, *_ in lines] or [np.zeros(3)])
    size = max(spread(points), SMALL if lines else min(spread(np.vstack([points, stands])), 2.0))
    size = size or SMALL
    if not np.isfinite(stands).all() or np.abs(stands - points.mean(axis=0)).max() > FAR * size:
        return None
    scene, camera = Scene(), orbit()
    height = floor_height(np.vstack([points, stands]))
    if lines:
        given = [*lines, (stands[-1], lines[-1][1], "tool")]
        add_lines(scene, given, pairs_of(given, size), size, height)
    _add_frames(scene, frames, mark, 0.22 * size)
    add_floor(scene, camera, height)
    told = _told(frames, mark)
    axes = f"{len(lines)} joint {'axis' if len(lines) == 1 else 'axes'}" if lines else "the base"
    picture = Picture(
        compose([View(scene, camera)], f"{title}\nmarked: {_name(mark)} does not fit"),
        f"Your frames beside {axes}. Marked is what does not fit: {told}.",
        ("frame", "origin (m)", "x axis", "z axis"),
        [_row(_title(name), part) for name, part in frames.items()],
        "Your frames",
        scene.named(),
    )
    picture.summary = "Your frames, as a table"
    return picture


def _add_frames(scene, frames, mark, length):
    whole = {
        name: _pose(part)
        for name, part in frames.items()
        if {"o", "x", "z"} <= part.keys() and name != mark[1:]
    }
    if whole:
        titles = [_title(name) for name in whole]
        add_triads(scene, np.array(list(whole.values())), list(whole), length, titles=titles)
    for name, part in frames.items():
        if name in whole:
            continue
        at = part.get("o", part.get("at"))
        for style in AXES:
            if style.letter in part:
                here = style.letter + name == mark
                _add_arrow(scene, at, part[style.letter], style, name, length, here)
        if "o" in part:
            _add_origin(scene, at, name, mark == f"o{name}")


def _add_arrow(scene, at, direction, style, name, length, here):
    tip = at + length * (1.25 if here else 1.0) * direction
    text = axis_name(style.letter, name)
    scene.add(
        Stroke(
            np.array([at, tip]),
            MARK if here else style.color,
            5.0 if here else style.width,
            "-" if here else style.dash,
            "mark" if here else "frame",
            head=15.0 if here else 4.5 + 1.5 * style.width,
            casing=1.2 if here else 0.6,
            gid=f"marked:{style.letter}{name}" if here else f"{style.letter}-axis:{name}",
        ),
        Label(
            tip,
            rf"{text}\ \mathrm{{does\ not\ fit}}" if here else text,
            direction,
            MARK if here else style.color,
            math=True,
            root=at,
            gid="axis-label",
        ),
    )


def _add_origin(scene, at, name, here):
    size, color = (13.0, MARK) if here else (5.0, INK)
    text = f"{_name(f'o{name}')} does not fit" if here else _title(name)
    scene.add(
        Dot(at, size, color, "mark", gid=f"marked:o{name}" if here else None),
        Label(at, text, np.array([0, 0, -1.0]), color, far=True, gid="frame-label"),
    )


def _pose(part):
    T = np.eye(4)
    T[:3, 0], T[:3, 2], T[:3, 3] = part["x"], part["z"], part["o"]
    T[:3, 1] = part.get("y", np.cross(part["z"], part["x"]))
    return T


def _told(frames, mark):
    part = frames[mark[1:]]
    value = part[mark[0]]
    where = f"at {words.place(value)}" if mark[0] == "o" else f"along {_numbers(value)}"
    return f"{_name(mark)}, {where}"


def _title(name):
    return f"{{{name}}}" if name.isdigit() else name


def _name(mark):
    """What is marked, in words."""
    letter, name = mark[0], mark[1:]
    if letter == "o":
        return f"the origin of {_title(name)}"
    return mark if name.isdigit() else f"{letter} of {name}"


def _numbers(v):
    return "(" + ", ".join(number(x, 3) for x in v) + ")"


def _row(name, part):
    return [
        name,
        ", ".join(number(x, 4) for x in part["o"]) if "o" in part else "",
        *(_numbers(part[letter]) if letter in part else "" for letter in "xz"),
    ]
