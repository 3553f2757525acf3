"""Circle-point analysis: the circles that single joints draw, with uncertainty, against those that
a model draws.
"""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..arm import Arm
from ..geometry.conversion import require_uncoupled
from .circlefit import fit_circle
from .circlewords import circle_words, report_html, report_text
from .inputs import measured, noise_of

__all__ = ["fit_circles", "CircleReport", "Circle"]

FEWEST = 4  # points; three always lie on a circle
STILL = 1e-3  # rad or m; encoders of a joint at rest wander less


@dataclass(frozen=True, eq=False)
class Circle:
    """The circle one joint draws.

    ``joint`` (1-based), ``points`` (how many), ``span`` (rad between the outermost joint values),
    ``axis`` (3,) in the sense of increasing q, ``centre`` (3,) in m, ``radius`` in m, ``height`` of
    the centre along the axis (m, from the base's origin), ``phase`` (rad, at q = 0, about the axis,
    from the base's x projected on the plane, y when the axis runs along x), ``off_circle`` (rms
    distance, m), ``off_angle`` (rms of what the points lead or lag the joint by, rad). ``sigma``
    holds standard deviations of axis (rad), centre (m, across the axis), height, radius, phase.
    ``differs`` holds measured minus model's, each as (value, standard deviation): axis, shift,
    height, radius, phase; empty without a model. ``noise`` is what was given, ``convention`` the
    model's. ``fault`` says why there is no circle; the numbers are then None.

    Examples
    --------
    >>> import dhlab as dh
    >>> arm = dh.load("article-6r")
    >>> q = np.tile([0.3, 0.0, -0.7, 0.5, 0.9, 0.2], (9, 1))
    >>> q[:, 1] = np.linspace(-1, 1, 9)
    >>> circle = dh.fit_circles(q, arm.forward(q)).circles[0]
    >>> circle.joint, circle.points, round(circle.span, 3), round(circle.radius, 4)
    (2, 9, 2.0, 0.6271)
    """

    joint: int
    points: int
    span: float
    fault: str = ""
    axis: NDArray[np.float64] | None = None
    centre: NDArray[np.float64] | None = None
    radius: float | None = None
    height: float | None = None
    phase: float | None = None
    off_circle: float | None = None
    off_angle: float | None = None
    sigma: dict[str, float] = field(default_factory=dict)
    differs: dict[str, tuple[float, float]] = field(default_factory=dict)
    noise: float | None = None
    convention: str = "standard"

    @property
    def words(self) -> str:
        """What this circle says, in a sentence or two."""
        return circle_words(self)

    def __str__(self) -> str:
        return self.words


@dataclass(frozen=True, eq=False, repr=False)
class CircleReport:
    """The circles found (``circles``), one per sweep; how many measurements belonged to no sweep
    (``left_out``).

    Examples
    --------
    >>> import dhlab as dh
    >>> arm = dh.load("article-6r")
    >>> q = np.tile([0.3, 0.0, -0.7, 0.5, 0.9, 0.2], (9, 1))
    >>> q[:, 1] = np.linspace(-1, 1, 9)
    >>> report = dh.fit_circles(q, arm.forward(q))
    >>> len(report.circles), report.left_out
    (1, 0)
    """

    circles: tuple[Circle, ...]
    left_out: int

    def __repr__(self) -> str:
        return f"<CircleReport: {len(self.circles)} circles>"

    def __str__(self) -> str:
        return report_text(self)

    def _repr_html_(self) -> str:
        return report_html(self)


def fit_circles(
    q: ArrayLike, points: ArrayLike, arm: Arm | None = None, *, noise: float | None = None
) -> CircleReport:
    """Fit a circle to each stretch of measurements in which one joint alone moved, and compare it
    with the model's.

    Parameters
    ----------
    q : array (m, n)
        Joint values of every measurement, in order, in radians: a sweep of one joint after the
        other. The joints at rest may hold any value.
    points : array (m, 3), or poses (m, 4, 4) of which the positions are taken
        The measured end point, in metres, in the base frame.
    arm : Arm, optional
        The model to compare with.
    noise : float, optional
        Standard deviation of a measured coordinate, m; estimated from the scatter when left out.

    Returns
    -------
    CircleReport
        Printed, it says for each joint what the circle tells about the model.

    Raises
    ------
    ValueError
        Shapes that do not fit, or no stretch of at least four measurements in which one joint alone
        moved.

    Notes
    -----
    That a joint draws an arc proves nothing about a table: T(q) = L Rz(θ_i) M with L and M
    constant, so every table draws an exact circle. Axis, centre, radius, height and phase can be
    compared. Stone, Kinematic Modeling, Identification, and Control of Robotic Manipulators (1987),
    calls this circle-point analysis; the circle is the one of least squared distances, standard
    deviations are of first order.

    Examples
    --------
    >>> import dhlab as dh
    >>> arm = dh.load("article-6r")
    >>> q = np.tile([0.3, 0.0, -0.7, 0.5, 0.9, 0.2], (9, 1))
    >>> q[:, 1] = np.linspace(-1, 1, 9)
    >>> circle, = fit_circles(q, arm.forward(q), arm).circles
    >>> circle.axis.round(3) + 0.0, round(circle.radius, 6)
    (array([ 0.296, -0.955,  0.   ]), 0.6271)
    """
    if arm is not None and not isinstance(arm, Arm):
        raise ValueError(
            f"fit_circles: arm: expected an Arm or nothing, found {type(arm).__name__}; load one"
            " with dhlab.load"
        )
    if arm is not None:
        require_uncoupled(arm, "fit_circles")
    q, points = measured(q, points, None if arm is None else len(arm), "fit_circles")
    points = points[:, :3, 3] if points.ndim == 3 else points
    given = noise_of(noise, "fit_circles")
    sweeps = list(_sweeps(q))
    if not sweeps:
        raise ValueError(
            f"fit_circles: expected at least {FEWEST} measurements in a row in which one joint"
            " alone moves, found no such stretch; move one joint at a time"
        )
    circles = tuple(
        _circle(joint, q[rows], points[rows], arm, given and given[0]) for joint, rows in sweeps
    )
    return CircleReport(circles, len(q) - sum(circle.points for circle in circles))


def _sweeps(q):
    """(joint from 0, rows) of every stretch in which one joint alone moves, long enough for a
    circle.
    """
    first = 0
    while first < len(q):
        last, joint = first + 1, None
        while last < len(q):
            moved = np.flatnonzero(np.abs(q[last] - q[first]) > STILL)
            if len(moved) > 1 or (len(moved) == 1 and joint is not None and moved[0] != joint):
                break
            joint = moved[0] if len(moved) else joint
            last += 1
        if joint is not None and last - first >= FEWEST:
            yield int(joint), slice(first, last)
            first = last
        else:
            first += 1


def _circle(joint, q, points, arm, noise):
    angles = q[:, joint]
    known = {
        "joint": joint + 1,
        "points": len(points),
        "span": float(np.ptp(angles)),
        "noise": noise,
        "convention": arm.table.convention if arm else "standard",
    }
    if arm is not None and arm.table.joints[joint] == "P":
        return Circle(**known, fault="it slides, so its points lie on a line")
    fit = fit_circle(angles, points, noise)
    if isinstance(fit, str):
        return Circle(**known, fault=fit)
    reference = np.eye(3)[1 if abs(fit.axis[0]) > 0.9 else 0]
    return Circle(
        **known,
        axis=fit.axis,
        centre=fit.centre,
        radius=fit.radius,
        height=float(fit.axis @ fit.centre),
        phase=_turn(reference, fit.at_zero, fit.axis),
        off_circle=fit.off_circle,
        off_angle=fit.off_angle,
        sigma=fit.sigma,
        differs={} if arm is None else _differences(fit, *_model(arm, q, joint)),
    )


def _model(arm, q, joint):
    """Axis, centre, radius and radius direction at q = 0 of the model's circle: a point p that
    turns with ω × r has r = v × ω across the axis.
    """
    J, p = arm.jacobian(q)[..., joint], arm.forward(q)[..., :3, 3]
    v, w = J[..., :3], J[..., 3:]
    out = np.cross(v, w)
    axis, radius = w.mean(axis=0), float(np.linalg.norm(out, axis=1).mean())
    c, s = np.cos(q[:, joint])[:, None], np.sin(q[:, joint])[:, None]
    at_zero = (c * out - s * v).mean(axis=0)  # each radius turned back by its q
    return axis / np.linalg.norm(axis), (p - out).mean(axis=0), radius, at_zero


def _differences(fit, axis, centre, radius, at_zero):
    """Measured minus model's, as (value, standard deviation)."""
    apart, sigma = fit.centre - centre, fit.sigma
    along = float(apart @ axis)
    angle = float(np.arctan2(np.linalg.norm(np.cross(axis, fit.axis)), axis @ fit.axis))
    found = {
        "axis": (angle, sigma["axis"]),
        "shift": (float(np.linalg.norm(apart - along * axis)), sigma["centre"]),
        "height": (along, sigma["along"]),
        "radius": (fit.radius - radius, sigma["radius"]),
    }
    if radius > 1e-9:
        found["phase"] = (_turn(at_zero, fit.at_zero, axis), sigma["phase"])
    return found


def _turn(a, b, axis):
    """The angle from a to b about the axis, radians."""
    a = a - (a @ axis) * axis
    return float(np.arctan2(np.cross(a, b) @ axis, a @ b))
