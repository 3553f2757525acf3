"""What is wrong with a program whose answers are known: general tests first, then the wrong versions that give the same answers."""

import numpy as np

from ..transform import inverse, pose_fault
from .finding import find
from .wrong_links import WRONG_COMPOSE, WRONG_LINKS, WRONG_ROT_X
from .wrong_products import WRONG_PRODUCTS

__all__ = ["explain_function", "WRONG_VERSIONS"]

WRONG_VERSIONS = {"dh_transform": WRONG_LINKS, "forward_kinematics": WRONG_PRODUCTS, "rot_x": WRONG_ROT_X, "compose": WRONG_COMPOSE}


def explain_function(answers, expected, cases, kind):
    """The mistake that explains the answers of a pose-valued program.

    Parameters
    ----------
    answers : sequence of arrays
        What the program gave, each as numpy holds it; not all right.
    expected : sequence of (4, 4) arrays
        What is right.
    cases : sequence of tuples
        The arguments of each call.
    kind : str
        A key of :data:`WRONG_VERSIONS`, which holds the wrong versions to compare with.

    Returns
    -------
    Finding or None
        None when nothing known explains them.

    Examples
    --------
    >>> from dhlab.doctor.wrong_links import standard
    >>> from dhlab.transform import inverse
    >>> cases = [(0.3, 0.1, 0.4, 0.5), (1.1, -0.2, 0.3, -0.7)]
    >>> right = [standard(*case) for case in cases]
    >>> explain_function(inverse(right), right, cases, "dh_transform").mistake
    'pose-inverted'
    """
    answers, expected = np.array(answers), np.array(expected, dtype=float)
    if answers.dtype.kind in "iub":
        return find("integer-arrays")
    if answers.shape != expected.shape:
        return find("last-row-missing") if answers.shape[-2:] == (3, 4) else None
    return _wrong_version(answers, cases, kind) or _relation(answers, expected) or _entries(answers, expected) or _not_a_pose(answers)


def _wrong_version(answers, cases, kind):
    with np.errstate(all="ignore"):
        for mistake, place, version in WRONG_VERSIONS.get(kind, ()):
            if all(_same(version(*case), answer) for case, answer in zip(cases, answers)):
                return find(mistake, place)
    return None


def _same(a, b, tolerance=1e-9):
    return np.allclose(a, b, rtol=tolerance, atol=tolerance)


def _relation(answers, expected):
    """How the answers stand to the right poses as wholes, whatever program made them."""
    transposed = np.swapaxes(expected, -1, -2)
    scaled = expected * np.where(np.arange(4) == 3, np.array([1000, 1000, 1000, 1])[:, None], 1)
    turned = expected.copy()
    turned[..., :3, :3] = transposed[..., :3, :3]
    for mistake, other in (("pose-inverted", inverse(expected)), ("matrix-transposed", transposed),
                           ("rotation-transposed", turned), ("length-unit", scaled), ("integer-arrays", np.trunc(expected))):
        if _same(answers, other):
            return find(mistake)
    if np.abs(answers - expected).max() < 0.02 and _same(answers, expected, 2e-2):
        return find("pi-rounded")
    if _same(answers[..., :3, :], expected[..., :3, :]):
        return find("last-row-missing")
    return None


def _entries(answers, expected):
    """One or two wrong entries in an otherwise right matrix."""
    wrong = np.argwhere((np.abs(answers - expected) > 1e-9 * (1 + np.abs(expected))).any(axis=0))
    if 0 < len(wrong) <= 2:
        return find("matrix-entry-mistyped", " and ".join(f"row {i + 1}, column {j + 1}" for i, j in wrong))
    return None


def _not_a_pose(answers):
    fault = pose_fault(answers)
    if fault is None:
        return None
    if "last row" in fault:
        return find("last-row-missing")
    return find("mirror") if "mirror" in fault else find("not-rigid")
