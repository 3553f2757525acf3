"""Bare joint axes in space, before anybody has placed a frame: lines with their directions, the
common normals between them, the tool.
"""

import itertools
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ...geometry.lines import nearest_on
from ...placing.board import Placement
from ...placing.geometry import Geometry, geometry
from ...printing import listed, number
from .. import words
from ..drawing.bodies import add_joint
from ..drawing.camera import orbit
from ..drawing.floor import add_drops, add_floor, floor_height
from ..drawing.page import View, compose
from ..drawing.scene import Dot, Label, Scene, Stroke
from ..drawing.style import INK, QUIET
from ..drawing.triads import add_triads
from ..given import spread
from ..picture import Picture

__all__ = ["add_lines", "axes", "pairs_of"]

HEADINGS = ("axis", "kind", "a point (m)", "direction", "to the next axis")
KINDS = {"R": "turns", "P": "slides", "tool": "end"}
AXIS_DASH = (0, (9, 2, 2, 2))
# of the arm's size: how far a line goes past what lies on it, and below the floor; how much further
# one on another's; an arrow of a frame
BEYOND, BELOW, STEP, TRIAD = 0.22, 0.04, 0.09, 0.15


def axes(
    axes: Iterable[Sequence[Any]],
    end: ArrayLike,
    frames: Mapping[int, ArrayLike] | Sequence[Any] | None = None,
    *,
    normals: bool = True,
    title: str | None = None,
) -> Picture:
    """Joint axes as lines, arrow heads in the direction of positive motion, with the tool's frame
    at the end. A notebook shows them as a view that can be turned.

    Parameters
    ----------
    axes : list
        As :func:`dhlab.assign_frames` takes them: per joint (point, direction) or (point,
        direction, "R" | "P").
    end : array (4, 4)
        The end pose at q = 0.
    frames : dict of int to array (4, 4), or list, optional
        Frames already placed, such as ``frames`` of a :class:`dhlab.placing.Placement`; or a list
        of (z, origin, x), frame 0 first, as a learner writes them.
    normals : bool
        Draw the common normals of neighbouring axes as thin lines (of parallel ones, one of the
        many), and say how each axis lies to the next; without, both are left to the reader.
    title : str, optional

    Returns
    -------
    Picture
        The table holds every axis and, with ``normals``, how it lies to the next.

    Raises
    ------
    ValueError
        As from ``assign_frames``.

    Examples
    --------
    >>> from dhlab import view
    >>> print(view.axes([([0, 0, 0], [0, 0, 1]), ([0.4, 0, 0.1], [0, 1, 0])], np.eye(4)).table)
    Joint axes at q = 0, in the base frame
     axis  kind   a point (m)  direction  to the next axis
     1     turns  0, 0, 0      (0, 0, 1)  skew: 0.4 m apart, 90° between them
     2     turns  0.4, 0, 0.1  (0, 1, 0)  skew: 0.4 m apart, 90° between them
     tool  end    0, 0, 0      (0, 0, 1)
    """
    bare = Placement(axes, end)
    given = [
        (np.array(entry[0], dtype=float), axis.z, axis.letter)
        for entry, axis in zip(axes, bare.axes)
    ]
    given.append((bare.end[:3, 3], bare.end[:3, 2], "tool"))
    pairs = pairs_of(given, bare.reach)
    size = max(spread(np.array([p for p, *_ in given])), 0.5 * bare.reach)
    scene, camera = Scene(), orbit()
    height = floor_height(np.array([p for p, *_ in given]))
    add_lines(scene, given, pairs, size, height)
    if normals:
        _add_normals(scene, pairs, size)
    placed = _placed(frames)
    add_triads(
        scene,
        np.array([*placed.values(), bare.end]),
        [*map(str, placed), "tool"],
        TRIAD * size,
        titles=[*(f"{{{i}}}" for i in placed), "tool"],
    )
    add_drops(scene, np.array([p for p, *_ in given]), height)
    add_floor(scene, camera, height)
    rows = [_row(k, *line, pairs) for k, line in enumerate(given, 1)]
    picture = Picture(
        compose([View(scene, camera)], title or ""),
        _alt(given, pairs if normals else [], placed),
        HEADINGS if normals else HEADINGS[:-1],
        rows if normals else [row[:-1] for row in rows],
        "Joint axes at q = 0, in the base frame",
        scene.named(),
    )
    picture.summary = "The axes as a table"
    return picture


def _placed(frames):
    """Poses (4, 4) by number, of a dict of them or of rows (z, origin, x)."""
    if frames is None or isinstance(frames, Mapping):
        return frames or {}
    placed = {}
    for k, row in enumerate(frames):
        try:
            z, origin, x = np.array(row, dtype=float).reshape(3, 3)
        except (TypeError, ValueError):
            raise ValueError(
                f"view.axes: expected (z, origin, x) with three numbers each for frame {k}, found"
                f" {row!r}; leave frames out while one is not placed"
            ) from None
        placed[k] = np.eye(4)
        placed[k][:3] = np.column_stack([x, np.cross(z, x), z, origin])
    return placed


def pairs_of(given: Sequence[Any], reach: float) -> list[Geometry | None]:
    """How each line lies to the next: Geometry, or None beside a sliding joint, whose line may be
    anywhere.
    """
    found: list[Geometry | None] = []
    for k, ((p, w, one), (q, z, other)) in enumerate(itertools.pairwise(given), 1):
        before = found[-1] if found else None
        anchor = p if before is None or before.feet is None else before.feet[1]
        found.append(
            None
            if "P" in (one, other)
            else geometry(k, ("", ""), reach, z, (q, z), (p, w), anchor=anchor)
        )
    return found


def add_lines(
    scene: Scene, given: Sequence[Any], pairs: Sequence[Geometry | None], size: float, height: float
) -> None:
    """Add joint axes to a scene: (point, direction, letter) for each, the tool's last, which is not
    drawn.
    """
    tool, along, _ = given[-1]
    # no arrow head on the tool's frame
    tips = [tool + reach * size * along for reach in (0, TRIAD / 2, TRIAD)]
    for k, (p, z, letter) in enumerate(given[:-1], 1):
        # the normals that leave this axis and arrive on it
        beside = [(pairs[k - 1], 0), (pairs[k - 2] if k > 1 else None, 1)]
        feet = [pair.feet[side] for pair, side in beside if pair and pair.feet is not None]
        on_it = [p, *feet]
        stops = np.clip([(point - p) @ z for point in on_it], -size, size)
        used = p + np.outer([stops.min(), stops.max()], z)
        start, tip, foot = _to_floor(used, z, BEYOND * size, height, BELOW * size)
        while any(np.linalg.norm(tip - other) < 0.7 * STEP * size for other in tips):
            tip = tip + STEP * size * z
        tips.append(tip)
        if foot is not None:
            scene.add(Dot(foot, 4.0, QUIET, "aid", gid=f"foot:{k}"))
        scene.add(
            Stroke(
                np.array([start, tip]),
                INK,
                1.3,
                AXIS_DASH,
                "body",
                head=9.0,
                casing=0.8,
                gid=f"axis:{k}",
            ),
            Label(tip, f"joint {k}", z, INK, root=start, gid="axis-label"),
        )
        add_joint(scene, letter, p, z, 0.022 * size, 0.08 * size, f"joint:{k}")


def _to_floor(used, z, beyond, floor, below):
    """The ends of a line that goes past its used part (2, 3), only a little below the floor, and
    where it meets the floor (None where it does not).
    """
    start, tip = used[0] - beyond * z, used[1] + beyond * z
    lowest, level = (start, tip)[int(z[2] < 0)], min(floor, *used[:, 2]) - below
    if lowest[2] >= level:
        return start, tip, None
    foot, end = (lowest + (height - lowest[2]) / z[2] * z for height in (floor, level))
    return (end, tip, foot) if z[2] > 0 else (start, end, foot)


def _add_normals(scene, pairs, size):
    for k, pair in enumerate(pairs, 1):
        if pair is None or pair.feet is None:
            continue
        p, z = pair.other
        if np.abs(pair.feet - nearest_on(p, z, pair.feet[0])).max() > 2 * size:
            continue
        scene.add(
            Stroke(pair.feet, QUIET, 1.1, (0, (3, 2)), "aid", casing=0.6, gid=f"normal:{k}"),
            *(Dot(foot, 4.0, QUIET, "aid") for foot in pair.feet),
        )


def _row(k, p, z, letter, pairs):
    last = k > len(pairs)
    return [
        "tool" if last else str(k),
        KINDS[letter],
        ", ".join(number(v, 4) for v in p),
        "(" + ", ".join(number(v, 3) for v in z) + ")",
        "" if last else _relation(pairs[k - 1]),
    ]


def _relation(pair):
    """How two neighbouring lines lie to each other, in words."""
    if pair is None:
        return "of a sliding joint only the direction counts"
    if pair.feet is None:
        return "one line" if pair.case == "same line" else "one line, opposite senses"
    apart = number(np.linalg.norm(pair.feet[1] - pair.feet[0]), 4)
    angle = number(np.rad2deg(np.arccos(np.clip(pair.line[1] @ pair.other[1], -1, 1))), 2)
    return {
        "skew": f"skew: {apart} m apart, {angle}° between them",
        "meet": f"they meet, {angle}° between them",
        "parallel": f"parallel: {apart} m apart",
        "antiparallel": f"parallel, opposite senses: {apart} m apart",
    }[pair.case]


def _alt(given, pairs, frames):
    n = len(given) - 1
    kinds = words.joint_words("".join(letter for *_, letter in given[:-1]))
    told = "".join(
        f" Axis {k} to {f'axis {k + 1}' if k < n else 'the z axis of the tool'}: {_relation(pair)}."
        for k, pair in enumerate(pairs, 1)
    )
    placed = f" Frames placed: {listed(f'{{{i}}}' for i in frames)}." if frames else ""
    return (
        f"The bare axes of {kinds} at q = 0, with the tool at {words.place(given[-1][0])}."
        f"{told}{placed}"
    )
