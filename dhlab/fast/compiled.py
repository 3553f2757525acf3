"""The paths that numba compiles, where the extra ``[fast]`` is installed."""

import numpy as np
from .chain import Chain

__all__ = ["packed"]


def packed(chain: Chain):
    """A chain as one row of numbers, as ``kernels.py`` reads it."""
    joints = zip((0.0, *chain.theta), (0.0, *chain.d), (False, *chain.slides))
    rows = [[*joint, step.a, step.c, step.s] for joint, step in zip(joints, chain.steps)]
    rates = chain.rates if chain.coupled else np.diag(chain.rates)
    return np.concatenate(
        [
            [chain.standard, chain.coupled],
            chain.base[:3].T.ravel(),
            chain.end[:3].ravel(),
            np.ravel(rows),
            rates.ravel(),
        ]
    )
