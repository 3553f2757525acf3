"""Where the ends of many arms are, worked out together."""

import numpy as np

from ... import kinematics
from ...fast.plain import Plain
from .remade import ALPHA, THETA, A, D

__all__ = ["ends_of"]

ENDS = "base", "tool"
PARTS = "table", *ENDS, "sign", "coupling"
AT_ONCE = 2000  # poses, whose frames take 2 MB


def ends_of(arms, q):
    """The end poses of several arms (k, m, 4, 4), many in one product: of a few poses the steps
    take longer than the numbers.
    """
    kinds, ends = {}, np.empty((len(arms), len(q), 4, 4))
    for k, arm in enumerate(arms):
        kinds.setdefault((arm.table.convention, arm.table.joints), []).append(k)
    together = max(1, AT_ONCE // len(q))
    for which in kinds.values():
        for begin in range(0, len(which), together):
            some = which[begin : begin + together]
            ends[some] = _ends_of_one_kind([arms[k] for k in some], q)
    return ends


def _ends_of_one_kind(arms, q):
    convention, slides = arms[0].table.convention, arms[0].table.prismatic
    rows = np.stack([arm.table.rows for arm in arms])[:, None]
    base, tool = (np.stack([getattr(arm, end) for arm in arms])[:, None] for end in ENDS)
    moved = np.stack(
        [Plain(*(getattr(arm, part) for part in PARTS)).joint_values(q) for arm in arms]
    )
    theta, d = rows[..., THETA] + ~slides * moved, rows[..., D] + slides * moved
    links = kinematics.link_matrices(convention, theta, d, rows[..., A], rows[..., ALPHA])
    return kinematics.frames(base, links)[..., -1, :, :] @ tool
