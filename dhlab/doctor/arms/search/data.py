"""Mistakes that sit in the measurements, not in the arm: what takes them back."""

from dataclasses import replace

import numpy as np

from ...mistakes.changes import JointChange, MeasuredChange, PoseChange
from ...mistakes.registry import changes

__all__ = ["data_repairs"]


def data_repairs(data):
    """Yield ((mistake, joint, parameter, place), repaired Measured) for each change of the data
    worth trying.
    """
    for change in changes(JointChange, PoseChange, MeasuredChange):
        if isinstance(change, JointChange):
            made = _of_joints(change, data)
        elif isinstance(change, PoseChange):
            made = _of_poses(change, data)
        else:
            made = _of_measured(change, data)
        for joint, parameter, place, repaired in made:
            yield (change.mistake, joint, parameter, place), repaired


def _of_joints(change, data):
    if change.measured is not None:
        back = np.linalg.inv(change.matrix(data.q.shape[1]))
        yield None, "q", change.measured, replace(data, q=data.q @ back.T)


def _of_poses(change, data):
    if change.measured is not None and data.R is not None:
        T = np.tile(np.eye(4), (len(data.q), 1, 1))
        T[:, :3, :3], T[:, :3, 3] = data.R, data.p
        T = change.change(T)
        yield None, "poses", change.measured, replace(data, p=T[:, :3, 3], R=T[:, :3, :3])


def _of_measured(change, data):
    if change.rotations and data.R is None:
        return
    for joint, place, repair in change.undo(data.q.shape[1]):
        q, p, R = repair(data.q, data.p, data.R)
        larger = np.linalg.norm(p) / (np.linalg.norm(data.p) or 1.0)
        reach = data.reach * (larger or 1.0)
        yield joint, change.of, place, replace(data, q=q, p=p, R=R, reach=reach)
