"""Labels that keep out of each other's way: each tries places around its anchor and takes the one
that hides least.

All coordinates here are page points from the panel's lower left corner.
"""

from typing import Any

import numpy as np
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from .letters import Letters
from .paint import Panel
from .scene import LAYERS, Dot, Face, Label, Scene
from .style import QUIET

__all__ = ["place_labels"]

ANGLES = np.deg2rad(np.arange(0, 360, 22.5))
NEAR, FAR = (3.0, 7.0, 12.0), (7.0, 13.0, 20.0, 28.0, 38.0, 50.0)  # gaps between anchor and text
BESIDE = (0.0, 0.25, 0.45)  # of an arrow, from its tip back: where its letter may stand
SAME = 9.0  # page points; one label for two of one text at points nearer than this
SPACING = 2.5  # between the samples that stand for a line


def place_labels(scene: Scene, panel: Panel) -> list[Letters]:
    """Write every label of a scene where it is best read.

    Parameters
    ----------
    scene : Scene
    panel : Panel
        What is drawn in it already is kept free where there is room.

    Returns
    -------
    list of Letters
    """
    labels = _once(scene.labels, panel)
    texts = [_text(label, panel) for label in labels]
    sizes = [text.measured()[:2] for text in texts]
    ink = _ink(scene, panel)
    own = [_own_points(label, panel) for label in labels]
    choices = [
        _places(label, size, points, panel) for label, size, points in zip(labels, sizes, own)
    ]
    choices = [
        (boxes, costs + _doubt(k, boxes, labels, own) + _hidden(boxes, ink, panel.size))
        for k, (boxes, costs) in enumerate(choices)
    ]
    taken: list[Any] = [None] * len(texts)
    # those with least choice first
    order = sorted(range(len(texts)), key=lambda k: (len(choices[k][0]), -sizes[k][0]))
    for _sweep in range(3):  # the second and third time each one knows where all others are
        for k in order:
            boxes, costs = choices[k]
            others = np.array(
                [box for j, box in enumerate(taken) if box is not None and j != k]
            ).reshape(-1, 4)
            taken[k] = boxes[np.argmin(costs + _overlap(boxes, others))]
    for k, (label, text, box) in enumerate(zip(labels, texts, taken)):
        doubtful = _doubt(k, box[None], labels, own)[0] > 0
        _put(label, text, box, panel, doubtful)
    return texts


def _once(labels, panel):
    """The labels, without those that say of almost the same point what another one says already."""
    kept: dict[tuple[str, str, str | None], list[tuple[NDArray[np.float64], Label]]] = {}
    for label in labels:
        at = panel.to_page(panel.camera.flat(label.anchor))
        same = kept.setdefault((label.text, label.color, label.gid), [])
        if all(np.hypot(*(at - there)) >= SAME for there, _ in same):
            same.append((at, label))
    chosen = {id(label) for same in kept.values() for _, label in same}
    return [label for label in labels if id(label) in chosen]


def _text(label, panel):
    letters = Letters(
        label.text,
        label.math,
        color=label.color,
        fontsize=label.size,
        zorder=LAYERS["mark"] + 1,
        gid=label.gid,
    )
    panel.axes.add_artist(letters)
    letters.set_clip_on(False)
    return letters


def _ink(scene, panel):
    """Samples (k, 3) of what is drawn: where, and how bad it is to cover it."""
    samples = [np.empty((0, 3))]
    for item in scene.items:
        if LAYERS[item.layer] < LAYERS["body"] or (isinstance(item, Face) and not item.outline):
            continue
        weight = 2.0 if item.layer == "frame" else 1.0
        points = np.atleast_2d(item.point) if isinstance(item, Dot) else item.points
        where = _along(panel.to_page(panel.camera.flat(points)))
        samples.append(np.column_stack([where, np.full(len(where), weight)]))
    return np.vstack(samples)


def _along(path):
    """A path (k, 2) filled with points so near each other that no letter fits between."""
    if len(path) == 1:
        return path
    pieces = np.diff(path, axis=0)
    parts = np.maximum(1, np.ceil(np.hypot(*pieces.T) / SPACING).astype(int))
    piece = np.repeat(np.arange(len(pieces)), parts + 1)
    step = np.arange(len(piece)) - np.repeat(np.cumsum(parts + 1) - parts - 1, parts + 1)
    return path[piece] + step[:, None] * (pieces / parts[:, None])[piece]


def _own_points(label, panel):
    """What a label belongs to (k, 2): its anchor, or the outer half of its arrow."""
    anchor = panel.to_page(panel.camera.flat(label.anchor))
    if label.root is None:
        return anchor[None]
    return anchor + np.outer(BESIDE, panel.to_page(panel.camera.flat(label.root)) - anchor)


def _places(label, size, own, panel):
    """Boxes (k, 4) left, bottom, right, top to choose from, and how far each is from what the label
    wants.
    """
    wanted = _wanted(label, panel.camera)
    if label.fixed is not None:
        centre = own[0] + wanted * (label.fixed + np.abs(wanted) @ size / 2)
        return np.hstack([centre - size / 2, centre + size / 2])[None], np.zeros(1)
    straying = 4.0 if label.toward is not None and np.any(label.toward) else 0.6
    base = np.arctan2(wanted[1], wanted[0])
    rays = np.column_stack([np.cos(base + ANGLES), np.sin(base + ANGLES)])
    half = _half(size, rays)
    centres, costs = [], []
    for back, point in enumerate(own):
        turned = straying * (1 - np.cos(ANGLES)) if back == 0 else np.full(len(ANGLES), 4.0 + back)
        for gap in FAR if label.far else NEAR:
            centres.append(point + rays * (gap + half)[:, None])
            costs.append(0.12 * gap + turned)
    middle = np.vstack(centres)
    return np.hstack([middle - size / 2, middle + size / 2]), np.concatenate(costs)


def _doubt(k, boxes, labels, own):
    """A price on boxes (m, 4) nearer to what another label of the same kind names than to what
    label k names; less with a line to it.
    """
    rivals = [
        own[j]
        for j, label in enumerate(labels)
        if j != k and label.gid == labels[k].gid and label.fixed is None
    ]
    if labels[k].fixed is not None or not rivals:
        return np.zeros(len(boxes))
    return (8.0 if labels[k].far else 25.0) * (
        _distance(boxes, np.vstack(rivals)) < _distance(boxes, own[k]) + 3.0
    )


def _distance(boxes, points):
    """From each box (m, 4) to the nearest of the points (k, 2)."""
    beyond = np.maximum(boxes[:, None, :2] - points, points - boxes[:, None, 2:]).clip(0)
    return np.linalg.norm(beyond, axis=-1).min(axis=1)


def _wanted(label, camera):
    """The unit direction (2,) on the page in which a label wants to stand; up when it does not
    care.
    """
    flat = np.zeros(2) if label.toward is None else camera.flat(label.toward)
    length = np.linalg.norm(flat)
    return flat / length if length > 1e-9 else np.array([0.0, 1.0])


def _half(size, rays):
    """From the middle of a box to its edge along unit rays (k, 2)."""
    with np.errstate(divide="ignore"):
        return np.min(size / 2 / np.abs(rays), axis=1)


def _hidden(boxes, ink, page):
    """The price of the lines that each box (k, 4) would cover, and of what of it lies beyond the
    panel.
    """
    within = (ink[:, :2] > boxes[:, :2].min(axis=0)) & (ink[:, :2] < boxes[:, 2:].max(axis=0))
    x, y, weight = ink[within.all(axis=1)].T
    inside = (x > boxes[:, :1]) & (x < boxes[:, 2:3]) & (y > boxes[:, 1:2]) & (y < boxes[:, 3:])
    outside = np.clip(2 - boxes[:, :2], 0, None).sum(axis=1) + np.clip(
        boxes[:, 2:] - page + 2, 0, None
    ).sum(axis=1)
    return 0.8 * inside @ weight + 100 * outside


def _overlap(boxes, others):
    """The price of the other labels (j, 4) that each box (k, 4) would cover."""
    shared = np.minimum(boxes[:, None, 2:], others[None, :, 2:] + 2) - np.maximum(
        boxes[:, None, :2], others[None, :, :2] - 2
    )
    return 0.9 * np.prod(np.clip(shared, 0, None), axis=-1).sum(axis=1)


def _put(label, text, box, panel, doubtful):
    """Move a text into its box, and tie it to its anchor when it stands far off."""
    text.set_position(panel.from_page((box[:2] + box[2:]) / 2))
    anchor = panel.to_page(panel.camera.flat(label.anchor))
    nearest = np.clip(anchor, box[:2], box[2:])
    distance = np.hypot(*(nearest - anchor))
    if label.far and (distance > 11 or (doubtful and distance > 3)):
        ends = panel.from_page(np.array([anchor, nearest]))
        panel.axes.add_artist(
            Line2D(*ends.T, color=QUIET, linewidth=0.7, zorder=LAYERS["mark"] + 0.5)
        )
