"""Files of Universal Robots' controllers and drivers: calibration.conf with its differences to the
nominal table, urcontrol.conf, the driver's kinematics.yaml.
"""

import re
from dataclasses import replace

import numpy as np

from .....transform import from_xyz_rpy
from ...cells import Cell
from ...chain import arm_of, joint_along, still
from ...language.roles import ROLES
from ...pasted import Pasted
from ..flat import arrays_in
from .told import told

__all__ = ["read"]

LINKS = ("shoulder", "upper_arm", "forearm", "wrist_1", "wrist_2", "wrist_3")


def read(source, nominal=None):
    """The Pasted table or the Readings of such a file; None of others."""
    if all(re.search(rf"\b{link}\s*:", source.code) for link in LINKS) and "yaw" in source.code:
        return _kinematics(source)
    if not re.search(r"\bdelta_(theta|d|a|alpha)\b", source.code):
        return None
    arrays = {
        name: [value.number for value, _ in values] for name, values in arrays_in(source).items()
    }
    deltas = {role: arrays.get(f"delta_{role}") for role in ROLES}
    n = next(len(values) for values in deltas.values() if values) if any(deltas.values()) else 0
    if not all(deltas.values()) and nominal is None and _complete(arrays):
        return None  # a table with some differences beside it: the table is read by its arrays
    base = _nominal(arrays, nominal, n)
    if base is None:
        raise ValueError(
            "recognise_table: this calibration holds differences to the maker's table only; which"
            ' robot is it? Give its table, as nominal=dhlab.load("ur5e") or --nominal ur5e, or'
            " paste [DH] of urcontrol.conf with it"
        )
    rows = np.zeros((n, 4))
    for k, role in enumerate(ROLES):
        given = deltas[role] if deltas[role] else [0.0] * n
        if len(given) != n:
            raise ValueError(
                f"recognise_table: expected {n} numbers in delta_{role}, found {len(given)}; paste"
                " the whole file"
            )
        rows[:, k] = base[:, k] + given
    units = ("rad", "m", "m", "rad")
    return Pasted(
        tuple(tuple(Cell(float(v), (), unit) for v, unit in zip(row, units)) for row in rows),
        ROLES,
        "as the names of the arrays say",
        convention="standard",
        because="as Universal Robots has it",
        labels=("",) * n,
        kinds=("R",) * n,
        signs=(1,) * n,
        form="a Universal Robots calibration, added to the nominal table",
        length="m",
    )


def _complete(arrays):
    """Whether the text holds a whole table of its own, dh_a, dh_d, dh_alpha."""
    return all(len(arrays.get(f"dh_{role}", ())) > 2 for role in ("a", "d", "alpha"))


def _nominal(arrays, nominal, n):
    """The maker's rows (n, 4), in the text or given."""
    if n and all(len(arrays.get(role, ())) == n for role in ("a", "d", "alpha")):
        theta = arrays.get("theta", [0.0] * n)
        return np.column_stack([theta, arrays["d"], arrays["a"], arrays["alpha"]])
    if nominal is None:
        return None
    if len(nominal) != n or nominal.table.convention != "standard":
        raise ValueError(
            f"recognise_table: nominal: expected a standard table of {n} joints, found"
            f" {len(nominal)} in the {nominal.table.convention} convention; give the maker's"
        )
    return nominal.table.rows


def _kinematics(source):
    """Each link's pose in the link before it at zero; its joint turns about its own z."""
    poses = []
    for link in LINKS:
        block = re.search(rf"\b{link}\s*:(.*?)(?=\n\s*\w+\s*:\s*\n|\Z)", source.code, re.DOTALL)
        six = []
        for name in ("x", "y", "z", "roll", "pitch", "yaw"):
            found = re.search(rf"\b{name}\s*:\s*([-+\w.]+)", block[1] if block else "")
            value = source.value(found[1]) if found else None
            if value is None:
                raise ValueError(
                    f"recognise_table: {link}: expected x, y, z, roll, pitch and yaw, found no"
                    f" {name}; paste the whole file"
                )
            six.append(value.number)
        poses.append(six)

    def make(scale):
        steps = []
        for six in poses:
            steps += [
                still(from_xyz_rpy(np.array(six[:3]) * scale, six[3:])),
                joint_along("R", "z"),
            ]
        return arm_of(steps)

    made = told(
        "a kinematics file of the Universal Robots driver",
        make,
        [v for six in poses for v in six[:3]],
        source,
        "from base_link_inertia to wrist_3_link (the driver's base frame is turned by 180° to it)",
        ["m"],
    )
    return [replace(one, words=one.words.partition(" by size")[0]) for one in made]
