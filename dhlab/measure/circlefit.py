"""The circle of least squared distances through points that a joint drew, with its standard
deviations.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .leastsquares import least_squares

__all__ = ["fit_circle", "Fit"]

FLAT = 1e-7  # second singular value over the first; below it the points are a line
NO_RADIUS = 10.0  # × the scatter; a smaller circle is a cloud
# mean resultant length of the angles minus q; below it the points do not go round with the joint
IN_STEP = 0.9
NOTHING = 1e-7  # m; exact points that move less did not move


@dataclass(frozen=True)
class Fit:
    """Axis in the sense of increasing q, centre, radius, direction of the radius at q = 0, misfits
    and standard deviations.
    """

    axis: NDArray[np.float64]
    centre: NDArray[np.float64]
    radius: float
    at_zero: NDArray[np.float64]
    off_circle: float
    off_angle: float
    sigma: dict[str, float]


def fit_circle(
    q: NDArray[np.float64], points: NDArray[np.float64], noise: float | None
) -> Fit | str:
    """The :class:`Fit` to ``points`` (m, 3) drawn at joint values ``q`` (m,), or a clause that says
    why there is none.

    Examples
    --------
    >>> q = np.linspace(0, 2, 6)
    >>> fit = fit_circle(q, np.column_stack([np.cos(q), np.sin(q), 0 * q]), None)
    >>> fit.axis.round(9) + 0.0, round(fit.radius, 9)
    (array([0., 0., 1.]), 1.0)
    """
    middle = points.mean(axis=0)
    _, spread, directions = np.linalg.svd(points - middle, full_matrices=False)
    if spread[0] / np.sqrt(len(q)) < max(NOTHING, 3 * (noise or 0)):
        return (
            f"the measured point stays where it is (within {1000 * spread[0] / np.sqrt(len(q)):.2g}"
            " mm), so it lies on the axis of this joint"
        )
    if spread[1] < FLAT * spread[0]:
        return "its points lie on a straight line"
    centre, basis, radius = _first_guess(points - middle, directions)
    for _ in range(2):
        # the second time about the solution, where the tilts are 0 and the covariance is simple
        centre, basis, radius, J, off = _refine(
            points, centre + (middle if _ == 0 else 0), basis, radius
        )
    scatter = np.sqrt((off**2).sum() / (2 * len(q) - 6))
    if radius < NO_RADIUS * max(scatter, noise or 0):
        return (
            f"the measured point moves only {1000 * radius:.2g} mm from the axis of this joint, "
            f"no more than its scatter of {1000 * scatter:.2g} mm allows, so it lies on the axis"
        )
    return _with_angles(q, points, centre, basis, radius, J, off, noise or scatter)


def _first_guess(points, directions):
    """Plane by singular values, circle in it by linear least squares (Kåsa 1976)."""
    flat = points @ directions[:2].T
    system = np.column_stack([2 * flat, np.ones(len(flat))])
    (x, y, k), *_ = np.linalg.lstsq(system, (flat**2).sum(axis=1), rcond=None)
    basis = np.array([directions[0], directions[1], np.cross(directions[0], directions[1])])
    return x * directions[0] + y * directions[1], basis, np.sqrt(max(k + x * x + y * y, 0))


def _refine(points, centre, basis, radius):
    """Least squares over the centre (3, in the basis), two tilts of the normal and the radius."""
    y = (points - centre) @ basis.T
    size = np.abs(y).max()
    x = least_squares(
        lambda x: _off(x, y), [0, 0, 0, 0, 0, radius], lambda x: _jacobian(x, y, size)
    )
    n = _parts(x, y)[1] @ basis
    e1 = basis[0] - (basis[0] @ n) * n
    e1 /= np.linalg.norm(e1)
    return (
        centre + x[:3] @ basis,
        np.array([e1, np.cross(n, e1), n]),
        float(x[5]),
        _jacobian(x, y, size),
        _off(x, y),
    )


def _parts(x, y):
    """From the centre to the points ``y`` (m, 3), the normal (3,), and how far the points are along
    the normal (m,) and from it (m,).
    """
    n = np.array([x[3], x[4], 1.0])
    n /= np.linalg.norm(n)
    out = y - x[:3]
    h = out @ n
    return out, n, h, np.linalg.norm(out - h[:, None] * n, axis=1)


def _off(x, y):
    """How far the points are off the plane and off the radius: (2 m,)."""
    _, _, h, rho = _parts(x, y)
    return np.r_[h, rho - x[5]]


def _jacobian(x, y, size):
    """Derivative of :func:`_off`: (2 m, 6)."""
    out, n, h, rho = _parts(x, y)
    length = np.sqrt(1 + x[3] ** 2 + x[4] ** 2)
    dn = (np.eye(3)[:2] - np.outer(n[:2], n)) / length
    dh = np.column_stack([np.tile(-n, (len(h), 1)), out @ dn.T, np.zeros(len(h))])
    dy = np.column_stack([-out, np.zeros((len(h), 3))])
    drho = (dy - h[:, None] * dh) / np.maximum(rho, 1e-12 * size)[:, None]
    drho[:, 5] -= 1
    return np.vstack([dh, drho])


def _with_angles(q, points, centre, basis, radius, J, off, noise):
    """Sense and phase from the joint values, and the standard deviations of everything."""
    x, y, _ = ((points - centre) @ basis.T).T
    psi = np.arctan2(y, x)
    sense = (
        1.0 if abs(np.exp(1j * (psi - q)).mean()) >= abs(np.exp(1j * (psi + q)).mean()) else -1.0
    )
    lead = np.exp(1j * (sense * psi - q)).mean()
    if abs(lead) < IN_STEP:
        return (
            "its points do not go round in step with the joint: is q in radians, and is it the"
            " joint that moved?"
        )
    phase = np.angle(lead)
    axis = sense * basis[2]
    at_zero = np.cos(phase) * basis[0] + sense * np.sin(phase) * basis[1]
    off_angle = np.sqrt((np.angle(np.exp(1j * (sense * psi - q - phase))) ** 2).mean())
    off_circle = float(np.sqrt((off**2).sum() / len(q)))
    return Fit(
        axis,
        centre,
        radius,
        at_zero,
        off_circle,
        float(off_angle),
        _sigmas(J, basis, centre, radius, psi, noise),
    )


def _sigmas(J, basis, centre, radius, psi, noise):
    """Standard deviations from the covariance σ² (JᵀJ)⁻¹ of (centre in the basis, tilts, radius);
    the scatter along the circle is independent.
    """
    C = noise**2 * np.linalg.pinv(J.T @ J)
    tilted = np.r_[0, 0, 1, basis[:2] @ centre, 0]  # of the centre's height along its own axis
    turned = np.r_[np.sin(psi).mean(), -np.cos(psi).mean(), 0, 0, 0, 0] / radius
    variances = {
        "axis": C[3, 3] + C[4, 4],
        "centre": C[0, 0] + C[1, 1],
        "along": C[2, 2],
        "height": tilted @ C @ tilted,
        "radius": C[5, 5],
        "phase": turned @ C @ turned + noise**2 / (len(psi) * radius**2),
    }
    return {name: float(np.sqrt(variance)) for name, variance in variances.items()}
