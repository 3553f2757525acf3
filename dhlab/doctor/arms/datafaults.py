"""Mistakes that sit in the measurements, not in the arm: joint values in another order or unit,
poses inverted, transposed or in millimetres.
"""

from dataclasses import replace
from itertools import combinations

import numpy as np
from scipy.spatial.transform import Rotation

__all__ = ["data_repairs"]


def data_repairs(data):
    """Yield ((mistake, joint, parameter, place), repaired Measured) for each change of the data
    worth trying.
    """
    n = data.q.shape[1]
    for mistake, joint, place, matrix in _joint_maps(n):
        yield (mistake, joint, "q", place), replace(data, q=data.q @ matrix.T)
    for a, b in combinations(range(3), 2):
        swapped = data.p.copy()
        swapped[:, [a, b]] = data.p[:, [b, a]]
        yield (
            ("columns-misread", None, "poses", f"{'xyz'[a]} and {'xyz'[b]} have changed places"),
            replace(data, p=swapped),
        )
    for factor, place in (
        (1000, "the poses are 1000 times too small"),
        (1e-3, "the poses are in mm"),
        (25.4e-3, "the poses are in inches"),
    ):
        yield ("length-unit", None, "poses", place), replace(data, p=data.p * factor)
    if data.R is None:
        return
    Rt = np.swapaxes(data.R, -1, -2)
    yield (
        ("pose-inverted", None, "poses", "the measured poses are inverse"),
        replace(data, R=Rt, p=-(Rt @ data.p[..., None])[..., 0]),
    )
    yield (
        ("rotation-transposed", None, "poses", "the measured rotations are transposed"),
        replace(data, R=Rt),
    )
    for mistake, place, R in _orientations(data.R):
        yield (mistake, None, "poses", place), replace(data, R=R)


def _joint_maps(n):
    """(mistake, joint, place, matrix): the right q is matrix · q."""
    one = np.eye(n)
    yield "joint-index-off-by-one", None, "q is one place off", np.roll(one, 1, axis=0)
    yield (
        "joint-index-off-by-one",
        None,
        "q is one place off, the other way",
        np.roll(one, -1, axis=0),
    )
    sums = np.tril(np.ones((n, n)))
    yield "absolute-link-angles", None, "q holds angles against the base", np.linalg.inv(sums)
    yield "joints-summed", None, "q was taken as a running sum", sums
    for j in range(1, n):
        for sign in (1, -1):
            matrix = one.copy()
            matrix[j, j - 1] = sign
            yield (
                "joints-coupled",
                j + 1,
                f"q{j + 1} {'+' if sign > 0 else '-'} q{j} in place of q{j + 1}",
                matrix,
            )
    for i, j in combinations(range(n), 2):
        yield (
            "columns-misread",
            None,
            f"q{i + 1} and q{j + 1} have changed places",
            one[[j if k == i else i if k == j else k for k in range(n)]],
        )
    yield "degrees-in-sin-cos", None, "q is in degrees", one * np.pi / 180
    yield "converted-to-radians-twice", None, "q was converted twice", one * 180 / np.pi


def _orientations(R):
    """Rotations as they are once a mixed-up reading is undone."""
    rotation = Rotation.from_matrix(R)
    yield (
        "quaternion-order",
        "w was taken for x",
        Rotation.from_quat(rotation.as_quat()[:, [1, 2, 3, 0]]).as_matrix(),
    )
    yield (
        "quaternion-order",
        "x was taken for w",
        Rotation.from_quat(rotation.as_quat()[:, [3, 0, 1, 2]]).as_matrix(),
    )
    for name, read, meant in (("rpy-order", "xyz", "XYZ"), ("rpy-order", "XYZ", "xyz")):
        yield (
            name,
            "fixed and moving axes mixed up",
            Rotation.from_euler(meant, rotation.as_euler(read)).as_matrix(),
        )
    yield (
        "rpy-order",
        "roll, pitch, yaw were read as a rotation vector",
        Rotation.from_euler("xyz", rotation.as_rotvec()).as_matrix(),
    )
    yield (
        "rpy-order",
        "a rotation vector was read as roll, pitch, yaw",
        Rotation.from_rotvec(rotation.as_euler("xyz")).as_matrix(),
    )
    yield (
        "roll-yaw-exchanged",
        "",
        Rotation.from_euler("xyz", rotation.as_euler("xyz")[:, ::-1]).as_matrix(),
    )
