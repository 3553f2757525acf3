"""Predicted against measured: where an arm's table says the end is, and where it was found."""

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.spatial.transform import Rotation

from ...arm import Arm
from ...printing import number
from .. import words
from ..drawing.bodies import dh_path
from ..drawing.camera import PLANES, orbit, widest_plane
from ..drawing.floor import add_floor, add_wall, floor_height
from ..drawing.page import View, compose
from ..drawing.scene import Dot, Label, Scene, Stroke
from ..drawing.style import AXES, INK
from ..given import require_arm, spread
from ..picture import Picture

__all__ = ["compared", "measured_and_predicted"]

FAINT = "#c9ced4"
ERROR = AXES[0].color
HEADINGS = ("pose", "measured x, y, z (m)", "predicted x, y, z (m)", "error (mm)")
NUMBERED = 14  # with more poses only the worst are numbered
# of the picture's size: where even the longest line is shorter, all are drawn longer, to this
SMALL, SEEN = 0.015, 0.08
FACTORS = [step * 10**k for k in range(6) for step in (1, 2, 5)][2:]
NOTHING = 1e-9  # m, rad


def compared(arm: Arm, q: ArrayLike, measured: ArrayLike, *, title: str | None = None) -> Picture:
    """Measured end points as open circles, predicted ones as dots, a line between the two, and the
    arm where it is furthest off.

    Parameters
    ----------
    arm : Arm
    q : array (m, n)
        Radians, metres for a prismatic joint.
    measured : array (m, 4, 4) or (m, 3)
        Poses or positions, metres.
    title : str, optional

    Returns
    -------
    Picture
        The table holds every pose with its error.

    Raises
    ------
    ValueError
        No arm, a ``q`` that does not fit it, or not one measurement per configuration.

    Notes
    -----
    A line is as long as the error. Where even the longest could hardly be seen, all are drawn 5,
    10, 20, … times as long, and the title says so.

    Examples
    --------
    >>> import dhlab as dh
    >>> from dhlab import view
    >>> arm = dh.load("article-6r")
    >>> q = [[0.3, 0.4, -0.7, 0.5, 0.9, 0.2], [1.1, 0.8, -0.5, 0.2, 0.4, 0.3]]
    >>> print(view.compared(arm, q, arm.forward(q)[:, :3, 3] + [0, 0, 0.05]).table)
    Measured and predicted end points
     pose  measured x, y, z (m)    predicted x, y, z (m)   error (mm)
     1     0.646, 0.0301, 0.1868   0.646, 0.0301, 0.1368   50
     2     0.4338, 0.4288, 0.5217  0.4338, 0.4288, 0.4717  50
    """
    q, T, p, turns = measured_and_predicted(arm, q, measured)
    errors = np.linalg.norm(p - T[:, :3, 3], axis=1)
    worst = int(np.argmax(errors if turns is None or errors.max() > NOTHING else turns))
    path = _path(arm, q[worst])
    size = spread(np.vstack([path, p, T[:, :3, 3]])) or 0.1
    factor = _longer(errors.max(), size)
    ends = p + factor * (T[:, :3, 3] - p)
    views = [_view(path, p, ends, errors), _side_view(path, p, ends, errors)]
    headings, rows = _table(T, p, errors, turns)
    picture = Picture(
        compose(views, _title(title, arm, errors, worst, factor)),
        _alt(arm, q, errors, turns, worst, factor),
        headings,
        rows,
        "Measured and predicted end points",
        views[0].scene.named(),
    )
    picture.summary = "The numbers as a table"
    return picture


def measured_and_predicted(
    arm: Arm, q: ArrayLike, measured: ArrayLike
) -> tuple[
    NDArray[np.float64], NDArray[np.float64], NDArray[np.float64], NDArray[np.float64] | None
]:
    """q (m, n), predicted poses, measured positions and the angle between measured and predicted
    (m,) or None.
    """
    require_arm(arm, "view.compared")
    T, measured = arm.forward(q), np.asarray(measured, dtype=float)
    if (
        T.ndim != 3
        or measured.shape not in ((len(T), 3), (len(T), 4, 4))
        or not len(T)
        or not np.isfinite(measured).all()
    ):
        raise ValueError(
            f"view.compared: expected q (m, {len(arm)}) and as many finite poses (m, 4, 4) or"
            f" positions (m, 3), found shapes {np.shape(q)} and {measured.shape}"
        )
    q = np.asarray(q, dtype=float)
    if measured.ndim == 2:
        return q, T, measured, None
    turns = Rotation.from_matrix(
        np.swapaxes(T[:, :3, :3], -1, -2) @ measured[:, :3, :3]
    ).magnitude()
    return q, T, measured[:, :3, 3], turns


def _path(arm, q):
    chain = arm.frames(q)
    return np.vstack([dh_path(arm.table.convention, chain), (chain[-1] @ arm.tool)[:3, 3]])


def _longer(largest, size):
    """How many times as long the lines are drawn."""
    if largest <= NOTHING or largest >= SMALL * size:
        return 1
    return next((factor for factor in FACTORS if largest * factor >= SEEN * size), FACTORS[-1])


def _add(scene, path, p, ends, numbered):
    scene.add(
        Stroke(path, FAINT, 4.5, gid="arm"),
        *(Dot(point, 5.0, FAINT, "body") for point in path[::2]),
        Dot(path[0], 9.0, FAINT, "body", gid="base"),
    )
    for k, (found, end) in enumerate(zip(p, ends), 1):
        scene.add(
            Stroke(np.array([found, end]), ERROR, 1.3, layer="mark", gid=f"error:{k}"),
            Dot(found, 8.0, INK, "frame", gid=f"measured:{k}"),
            Dot(found, 5.6, "white", "frame"),
            Dot(end, 4.4, INK, "mark", gid=f"predicted:{k}"),
        )
        if k - 1 in numbered:
            scene.add(Label(found, str(k), far=True, gid="pose-number"))


def _numbered(errors):
    return set(np.argsort(-errors)[: len(errors) if len(errors) <= NUMBERED else 5].tolist())


def _view(path, p, ends, errors):
    scene, camera = Scene(), orbit()
    _add(scene, path, p, ends, _numbered(errors))
    add_floor(scene, camera, floor_height(scene.points()))
    return View(scene, camera)


def _side_view(path, p, ends, errors):
    plane = widest_plane(np.vstack([path, p, ends]))
    camera, scene = PLANES[plane], Scene()
    _add(scene, path, p, ends, set())
    add_wall(scene, camera, plane)
    kind = "view from above" if plane == "x-y" else "side view"
    return View(scene, camera, f"{kind}, {plane.replace('-', '–')} plane", (40.0, 34.0, 24.0, 20.0))


def _title(title, arm, errors, worst, factor):
    name = title if title is not None else f"{arm.name or 'Arm'}: predicted against measured"
    long = f", lines drawn {factor} times as long" if factor > 1 else ""
    return (
        f"{name}\n○ measured   ● predicted   largest error {number(1e3 * errors.max(), 2)} mm at"
        f" pose {worst + 1} (arm in grey){long}"
    )


def _alt(arm, q, errors, turns, worst, factor):
    many = (
        f"{len(errors)} measured end points and where the table puts them"
        if len(errors) > 1
        else "1 measured end point and where the table puts it"
    )
    angles = (
        ""
        if turns is None
        else (
            f" The axes are turned by up to {number(np.rad2deg(turns.max()), 2)}°,"
            f" {number(np.rad2deg(turns.mean()), 2)}° on average."
        )
    )
    long = f" The lines are drawn {factor} times as long as the errors." if factor > 1 else ""
    return (
        f"{words.who(arm)}. Drawn are {many}, joined by lines. The error is"
        f" {number(1e3 * errors.max(), 2)} mm at the most and {number(1e3 * errors.mean(), 2)} mm"
        f" on average.{angles} The arm is drawn in grey at the worst, pose {worst + 1}: q ="
        f" {words.configuration(arm.table.joints, q[worst])}.{long}"
    )


def _table(T, p, errors, turns):
    def point(v):
        return ", ".join(number(x, 4) for x in v)

    rows = [
        [str(k), point(found), point(pose[:3, 3]), number(1e3 * error, 2)]
        for k, (found, pose, error) in enumerate(zip(p, T, errors), 1)
    ]
    if turns is None:
        return HEADINGS, rows
    return (*HEADINGS, "error (deg)"), [
        [*row, number(np.rad2deg(turn), 2)] for row, turn in zip(rows, turns)
    ]
