"""A small picture of an arm as SVG, without matplotlib: links, joints on their axes, the hand's
frame. Its colours are the page's, so it is right in light and dark.
"""

from html import escape
from itertools import pairwise

import numpy as np

from dhlab.view.drawing.camera import orbit

__all__ = ["posture", "picture"]

WIDTH, HEIGHT, MARGIN = 160, 130, 14
CAMERA = orbit(20, -55)
TURN = np.deg2rad(120)  # where a joint without near limits is looked for


def posture(arm, draws=160):
    """Joint values (n,) in which an arm is well seen: bent, above its floor, the hand in front;
    the same ones every time.
    """
    rng = np.random.default_rng(len(arm))
    low, high = np.array([_range(arm, i) for i in range(len(arm))]).T
    q = rng.uniform(low, high, (draws, len(arm)))
    q[:, 0] *= 0.3 if arm.table.joints[0] == "R" else 1
    return np.round(q[np.argmax(_clear(arm.frames(q)[..., :3, 3]))], 2)


def _range(arm, i):
    free = TURN if arm.table.joints[i] == "R" else 0.3
    low, high = (arm.limits or [None] * len(arm))[i] or (-free, free)
    return max(low, -free) if high > -free else low, min(high, free) if low < free else high


def _clear(origins):
    """How well arms (m, n + 1, 3) are seen: wide on the picture, the hand in front, little folded,
    nothing under the floor.
    """
    flat = CAMERA.flat(origins)
    way = flat[:, -1] - flat[:, 0]
    length = np.linalg.norm(np.diff(flat, axis=1), axis=2).sum(axis=1)
    below = np.maximum(0, origins[:, 0, 2] - origins[..., 2].min(axis=1))
    reach = np.linalg.norm(np.ptp(origins, axis=1), axis=1)
    wide = np.ptp(flat, axis=1).min(axis=1)
    folded = length - np.linalg.norm(way, axis=1)
    return (wide + 0.6 * way[:, 0] - 3 * below - 0.15 * folded) / reach


def _path(arm, q):
    """The way along d and a with the tool at its end, and each joint's middle and direction."""
    chain, standard = arm.frames(q), arm.table.convention == "standard"
    origins = chain[:, :3, 3]
    first = chain[:-1, :3, 2 if standard else 0]
    part = np.einsum("ik,ik->i", np.diff(origins, axis=0), first)
    corners = origins[:-1] + part[:, None] * first
    path = np.empty((2 * len(chain), 3))
    path[:-1:2], path[1:-1:2], path[-1] = origins, corners, arm.forward(q)[:3, 3]
    if standard:
        middles, axes = (origins[:-1] + corners) / 2, chain[:-1, :3, 2]
    else:
        middles, axes = (corners + origins[1:]) / 2, chain[1:, :3, 2]
    return path, middles, axes


def picture(arm, q, words=""):
    """The arm at ``q`` (n,) as an ``<svg>``; ``words`` are read out in its place, an empty text
    leaves it unspoken.
    """
    path, middles, axes = _path(arm, q)
    size = max(np.ptp(path, axis=0).max(), 1e-3)
    end = arm.forward(q)
    tips = end[:3, 3] + 0.17 * size * end[:3, :3].T
    floor = path * [1, 1, 0] + [0, 0, path[:, 2].min()]
    seen = CAMERA.flat(np.vstack([path, tips, floor]))
    low, high = seen.min(axis=0), seen.max(axis=0)
    scale = min((WIDTH - 2 * MARGIN) / (high - low)[0], (HEIGHT - 2 * MARGIN) / (high - low)[1])
    shift = np.array([WIDTH, HEIGHT]) / 2 - scale * (low + high) / 2 * [1, -1]

    def at(points):
        return CAMERA.flat(points) * [scale, -scale] + shift

    half = 0.035 * size * axes
    joints = [
        _joint(at(np.array([p - h, p + h])), letter)
        for p, h, letter in zip(middles, half, arm.table.joints, strict=True)
    ]
    hand = [_line(at(np.array([end[:3, 3], tip])), name) for tip, name in zip(tips, "xyz")]
    spoken = f'role="img" aria-label="{escape(words)}"' if words else 'aria-hidden="true"'
    shadow, links = _line(at(floor), "s"), _line(at(path), "l")
    return (
        f'<svg class="arm-picture" viewBox="0 0 {WIDTH} {HEIGHT}" {spoken}>'
        f"{shadow}{links}{''.join(joints)}{''.join(hand)}</svg>"
    )


def _joint(ends, letter):
    """A joint from its side, or from its end where its axis points at the viewer."""
    if np.linalg.norm(ends[1] - ends[0]) < 5:
        return _line(ends[:1] / 2 + ends[1:] / 2, "je")
    return _line(ends, "jp" if letter == "P" else "j")


def _line(points, name):
    """Points (k, 2) as one path; those that round to the one before are left out."""
    points = np.round(points, 1)
    kept = [points[0]] + [b for a, b in pairwise(points) if not np.array_equal(a, b)]
    text = "L".join(f"{x:g} {y:g}" for x, y in kept)
    return f'<path class="{name}" d="M{text}{"h0" if len(kept) == 1 else ""}"/>'
