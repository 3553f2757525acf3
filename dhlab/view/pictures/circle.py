"""One joint moved alone: the circle that was measured, and the one that the arm's table draws."""

import numpy as np
from numpy.typing import ArrayLike

from ...arm import Arm
from ...measure import fit_circles
from ...printing import number
from .. import words
from ..drawing.bodies import dh_path
from ..drawing.camera import orbit
from ..drawing.floor import add_floor, floor_height
from ..drawing.page import View, compose
from ..drawing.scene import Dot, Label, Scene, Stroke
from ..drawing.style import AXES, INK
from ..given import require_arm, spread
from ..picture import Picture

__all__ = ["circle"]

FAINT, MODEL = "#c9ced4", AXES[0].color
DASH = (0, (4, 2))
ROUND = 0.4  # of the way from edge-on (0) to face-on (1), at which a circle is seen as one
HEADINGS = ("circle", "axis", "centre (m)", "radius (m)", "first point (m)", "last point (m)")
FINE = 121  # configurations along the model's arc


def circle(arm: Arm, q: ArrayLike, points: ArrayLike, *, title: str | None = None) -> Picture:
    """Measured points of one joint's sweep and the arc that the arm's table draws at the same joint
    values, each with its axis.

    Parameters
    ----------
    arm : Arm
    q : array (m, n)
        Radians; one joint moves, the others rest.
    points : array (m, 3), or poses (m, 4, 4) of which the positions are taken
        What was measured, metres, in the base frame.
    title : str, optional

    Returns
    -------
    Picture
        The table holds both circles: axis in the sense of increasing q, centre, radius, first and
        last point.

    Raises
    ------
    ValueError
        No arm, shapes that do not fit, more than one sweep, or a joint that draws no circle.

    Examples
    --------
    >>> import dhlab as dh
    >>> from dhlab import view
    >>> arm, q = dh.load("article-6r"), np.tile([0.3, 0.0, -0.7, 0.5, 0.9, 0.2], (9, 1))
    >>> q[:, 1] = np.linspace(-1, 1, 9)
    >>> print(view.circle(arm, q, arm.forward(q) @ dh.transform.trans_z(0.1)).table)
    Joint 2 moved alone
     circle       axis                centre (m)            radius (m)  first point (m)           last point (m)
     measured     (0.296, -0.955, 0)  0.0663, -0.2143, 0.1  0.5497      0.1754, -0.1805, -0.4377  0.4879, -0.0839, 0.4276
     the table's  (0.296, -0.955, 0)  0.0479, -0.1549, 0.1  0.6271      0.1842, -0.1128, -0.5107  0.5217, -0.0084, 0.4838
    """  # noqa: E501  (a printed table)
    require_arm(arm, "view.circle")
    found = _only_circle(fit_circles(q, points, arm))
    q, points = np.asarray(q, dtype=float), np.asarray(points, dtype=float)
    points = points[:, :3, 3] if points.ndim == 3 else points
    fine = np.linspace(q[0], q[-1], FINE)
    arc = arm.forward(fine)[:, :3, 3]
    model = _only_circle(fit_circles(fine, arc, arm))
    scene, camera = Scene(), _camera(found.axis)
    _add(scene, arm, q[len(q) // 2], points, arc, found, model)
    add_floor(scene, camera, floor_height(scene.points()))
    rows = [_row("measured", found, points), _row("the table's", model, arc)]
    picture = Picture(
        compose([View(scene, camera)], _title(title, arm, found)),
        _alt(arm, found, model, points, arc),
        HEADINGS,
        rows,
        f"Joint {found.joint} moved alone",
        scene.named(),
    )
    picture.summary = "The two circles as a table"
    return picture


def _only_circle(report):
    """The one circle of a report, or a sentence."""
    if len(report.circles) != 1 or report.left_out:
        joints = ", ".join(str(circle.joint) for circle in report.circles)
        raise ValueError(
            f"view.circle: expected one sweep of one joint, found sweeps of joint {joints} and"
            f" {report.left_out} other measurements; hand in the rows of one sweep"
        )
    (circle,) = report.circles
    if circle.fault:
        raise ValueError(
            f"view.circle: expected a joint that draws a circle, found joint {circle.joint}:"
            f" {circle.fault}; choose another joint"
        )
    return circle


def _camera(axis):
    """The usual view, or one to its side when the circle would be seen from its edge."""
    return max(
        (orbit(azimuth=a) for a in (-58, -42, -74, -26, -90)),
        key=lambda camera: min(abs(camera.toward @ axis), ROUND),
    )


def _add(scene, arm, q, points, arc, found, model):
    chain = arm.frames(q)
    path = np.vstack([dh_path(arm.table.convention, chain), (chain[-1] @ arm.tool)[:3, 3]])
    scene.add(
        Stroke(path, FAINT, 4.5, gid="arm"),
        *(Dot(point, 5.0, FAINT, "body") for point in path[::2]),
        Dot(path[0], 9.0, FAINT, "body", gid="base"),
    )
    scene.add(
        Stroke(arc, MODEL, 1.8, DASH, "frame", head=9.0, casing=0.8, gid="model"),
        Dot(arc[0], 5.0, MODEL, "mark"),
    )
    for k, point in enumerate(points):
        scene.add(
            Dot(point, 7.5, INK, "frame", gid=f"measured:{k + 1}"),
            Dot(point, 5.2, "white" if k else INK, "frame"),
        )
    length = 0.3 * spread(np.vstack([path, arc, points]))
    for circle, name, color, dash, width in (
        (found, "measured axis", INK, "-", 2.6),
        (model, "the table's axis", MODEL, DASH, 1.6),
    ):
        tip = circle.centre + length * circle.axis
        scene.add(
            Stroke(
                np.array([circle.centre, tip]),
                color,
                width,
                dash,
                "mark",
                head=9.0,
                casing=0.6,
                gid=f"axis:{name}",
            ),
            Label(tip, name, circle.axis, color, far=True, gid="axis-name"),
        )


def _row(name, circle, points):
    def point(v):
        return ", ".join(number(x, 4) for x in v)

    return [
        name,
        f"({', '.join(number(v, 3) for v in circle.axis)})",
        point(circle.centre),
        number(circle.radius, 4),
        point(points[0]),
        point(points[-1]),
    ]


def _title(title, arm, found):
    name = title if title is not None else f"{arm.name or 'Arm'}: joint {found.joint} moved alone"
    return (
        f"{name}\n○ measured, the first one filled   - - what the table draws, to the arrow's tip  "
        " (arm in grey, as the table has it)"
    )


def _alt(arm, found, model, points, arc):
    angle = np.rad2deg(
        np.arctan2(np.linalg.norm(np.cross(found.axis, model.axis)), found.axis @ model.axis)
    )
    apart = 1000 * np.linalg.norm(points[[0, -1]] - arc[[0, -1]], axis=1)
    return (
        f"{words.who(arm)}; joint {found.joint} is moved alone. Its {len(points)} measured points"
        f" lie on a circle of {number(1000 * found.radius, 1)} mm about an axis"
        f" {words.direction(found.axis)}; the table draws one of {number(1000 * model.radius, 1)}"
        f" mm about an axis {words.direction(model.axis)}. The axes differ by {number(angle, 1)}°."
        f" The first points are {number(apart[0], 1)} mm apart, the last ones"
        f" {number(apart[1], 1)} mm."
    )
