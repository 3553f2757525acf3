"""The seven modes of ``dhlab.explore``: each checks what it is given and hands it on as numbers."""

from collections.abc import Callable

import numpy as np

from ...arm import Arm
from ...geometry.conversion import as_arm, require_uncoupled
from ...placing.board import Placement
from ...table import DHTable
from ...transform import require_pose, trans
from .content import arm_data, pose_data
from .meshes import parts_of
from .placing import Placing, axes_of
from .widget import Explorer

__all__ = ["MODES"]


def _at(arm, q):
    """One configuration (n,), zeros when none is given."""
    q = arm._checked(np.zeros(len(arm)) if q is None else q)
    if q.ndim != 1:
        raise ValueError(
            f"explore: expected one configuration of {len(arm)} values for q, found shape"
            f' {q.shape}; several go with poses, in mode "compare"'
        )
    return q


def _explorer(
    mode,
    arm,
    title,
    still,
    data=None,
    *,
    alt=None,
    q=(),
    row=(0, 0, 0, 0),
    poses=(),
    convention="standard",
    step=0,
    placing=None,
    parts=(),
):
    data = {"mode": mode, "title": title, "alt": alt or title, **(data or {})}
    return Explorer(
        mode,
        arm,
        data,
        still,
        state={"q": q, "row": row, "poses": poses, "convention": convention, "step": step},
        placing=placing,
        parts=parts,
    )


def _name(arm):
    return arm.name or "Arm"


def _arm(arm, *, q=None, jacobian=False, meshes=None):
    arm = as_arm(arm, "explore")
    q = _at(arm, q)
    parts = [] if meshes is None else parts_of(arm, meshes)
    more = {"jacobian": jacobian, "meshes": bool(parts)}
    return _explorer(
        "arm",
        arm,
        _name(arm),
        lambda: _stills().arm(arm, q),
        {"arm": arm_data(arm), **{name: True for name, on in more.items() if on}},
        q=q,
        convention=arm.table.convention,
        parts=parts,
    )


def _link(arm, *, q=None, joint=1):
    arm = as_arm(arm, "explore")
    q, n = _at(arm, q), len(arm)
    if isinstance(joint, bool) or not isinstance(joint, (int, np.integer)) or not 1 <= joint <= n:
        raise ValueError(
            f"explore: expected a joint from 1 to {n}, found {joint!r}; rows are counted from 1"
        )
    variable = float(arm.joint_values(q)[joint - 1])
    row = arm.table.rows[joint - 1].copy()
    row[int(arm.table.prismatic[joint - 1])] += variable
    reach = max(0.1, *(1.25 * abs(row[1:3])), float(np.abs(arm.table.rows[:, 1:3]).max()))
    return _explorer(
        "link",
        arm,
        f"{_name(arm)}: row {joint}",
        lambda: _stills().link(arm.table, int(joint), variable),
        {"index": int(joint), "reach": reach, "steps": (0, 4)},
        q=q,
        row=row,
        convention=arm.table.convention,
        step=4,
    )


def _conventions(arm, *, q=None):
    arm = as_arm(arm, "explore")
    q = _at(arm, q)
    arms = {name: arm.to(name) for name in ("standard", "craig")}
    return _explorer(
        "conventions",
        arm,
        f"{_name(arm)}: standard and Craig frames",
        lambda: _stills().conventions(arm, q),
        {"arms": {name: arm_data(one) for name, one in arms.items()}},
        q=q,
        convention=arm.table.convention,
    )


def _compare(arm, *, q=None, poses=None, other=None):
    arm = as_arm(arm, "explore")
    if (poses is None) == (other is None):
        raise ValueError(
            'explore: mode "compare" expected either poses (with their q) or other, a second arm;'
            " give one of the two"
        )
    if other is None:
        return _measured(arm, q, poses)
    other = as_arm(other, "explore")
    if len(other) != len(arm):
        raise ValueError(
            f"explore: expected a second arm of {len(arm)} joints, found {len(other)}; only arms of"
            " as many joints can be moved together"
        )
    q = _at(arm, q)
    return _explorer(
        "compare",
        arm,
        f"{_name(arm)} and {_name(other)}",
        lambda: _stills().two(arm, other, q),
        {"arm": arm_data(arm), "other": arm_data(other)},
        q=q,
        convention=arm.table.convention,
    )


def _measured(arm, q, poses):
    from ..pictures.compared import measured_and_predicted  # with matplotlib

    q, T, p, turns = measured_and_predicted(arm, q, poses)
    full = np.array(T) if turns is None else np.asarray(poses, dtype=float)
    full[:, :3, 3] = p
    data = {
        "arm": arm_data(arm),
        "qs": q.tolist(),
        "poses": [pose_data(pose) for pose in full],
        "positions": turns is None,
        "steps": (1, len(q)),
    }
    worst = int(np.argmax(np.linalg.norm(p - T[:, :3, 3], axis=1)))
    return _explorer(
        "compare",
        arm,
        f"{_name(arm)}: predicted against measured",
        lambda: _stills().measured(arm, q, poses),
        data,
        q=q[worst],
        step=worst + 1,
        convention=arm.table.convention,
    )


def _branches(arm, *, q=()):
    arm = as_arm(arm, "explore")
    qs = np.asarray(q, dtype=float) if len(q) else np.empty(0)
    if qs.ndim != 2:
        raise ValueError(
            'explore: mode "branches" expected q, one or more configurations (k,'
            f" {len(arm)}), found shape {qs.shape}; give what arm.solve(T) gives"
        )
    qs = arm._checked(qs)
    return _explorer(
        "branches",
        arm,
        f"{_name(arm)}: {len(qs)} ways to one pose",
        lambda: _stills().branches(arm, qs),
        {"arm": arm_data(arm), "qs": qs.tolist(), "steps": (1, len(qs))},
        q=qs[0],
        step=1,
        convention=arm.table.convention,
    )


def _place(arm, *, end=None, convention=None):
    name = "Frames on bare axes"
    if isinstance(arm, Placement):
        if end is not None or convention is not None:
            raise ValueError("explore: a board brings its own end and convention; leave them out")
        return _placing(name, Placing.of(arm))
    if not isinstance(arm, (list, tuple)):
        arm = as_arm(arm, "explore")
        if end is not None:
            raise ValueError(
                "explore: end goes with a list of axes; an arm brings its own, leave it out"
            )
        require_uncoupled(arm, 'explore, mode "place"')
        convention, name = convention or arm.table.convention, f"{_name(arm)}: place the frames"
        arm, end = axes_of(arm)
    elif end is None:
        raise ValueError(
            "explore: expected end, the end pose (4, 4) at the zero pose, with a list of axes;"
            " found none"
        )
    return _placing(name, Placing(arm, end, convention or "standard"))


def _placing(name, placing):
    data = placing.data()
    return _explorer(
        "place",
        None,
        name,
        lambda: _stills().place(placing),
        data,
        convention=placing.placement.convention,
        step=data["steps"][1] if placing.shown else 0,
        placing=placing,
    )


def _pose(arm):
    given = [PLATE] if arm is None else arm
    if isinstance(given, (Arm, DHTable)) or np.ndim(given) not in (2, 3):
        raise ValueError(
            'explore: mode "pose" expected a pose (4, 4), or two, [T_01, T_12], found'
            f" {type(arm).__name__}; build one with dhlab.transform (trans, rot_z, ...)"
        )
    given = [given] if np.ndim(given) == 2 else list(given)
    if not 1 <= len(given) <= 2:
        raise ValueError(f'explore: mode "pose" expected one pose or two, found {len(given)}')
    poses = np.array([require_pose(T, f"explore: pose {k}") for k, T in enumerate(given, 1)])
    far = np.abs(np.cumsum(poses[:, :3, 3], axis=0)).max()
    return _explorer(
        "pose",
        None,
        "A plate and its pose" if len(poses) == 1 else "Two plates, and the product of their poses",
        lambda: _stills().plates(poses),
        {"reach": max(0.5, float(round(1.3 * far, 2)))},
        poses=poses,
    )


def _stills():
    """What draws the still pictures, with matplotlib: loaded when one is needed."""
    from . import stills

    return stills


PLATE = trans([0.4, 0.3, 0.2])
MODES: dict[str, Callable[..., Explorer]] = {
    "arm": _arm,
    "link": _link,
    "conventions": _conventions,
    "compare": _compare,
    "branches": _branches,
    "place": _place,
    "pose": _pose,
}
