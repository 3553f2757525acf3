"""Functions of a program that multiply two matrices in their own way, place by place."""

import numpy as np

from ..held.budget import FAILURES
from ..held.factors import is_known_pose
from ..held.values import Unknown, plain

__all__ = ["OwnProducts"]

RETURNED, LAST, FIRST = "returned", "last", "first"  # where the product is


class OwnProducts:
    """Which functions were seen to multiply, and where they put the product: they are not carried
    out again.
    """

    def __init__(self):
        self.seen: dict = {}

    def look_at(self, run, node, args, result):
        """Look at a call that has ended: it may have multiplied two of its arguments."""
        poses = [one for one in args if is_known_pose(one)]
        trials = [(RETURNED, result, *poses)] if len(poses) == 2 else []
        if len(poses) == 3:  # void times(A, B, product), or with the product first
            trials = [(LAST, poses[2], *poses[:2]), (FIRST, poses[0], *poses[1:])]
        if len(poses) == 2 and not is_known_pose(result):
            if any(isinstance(one, Unknown) for one in args):
                run.factors.spoil(*poses)  # written into something that is not known
            return
        for place, found, one, other in trials:
            try:
                made = is_known_pose(found) and run.factors.seen_as_product(found, one, other)
            except FAILURES:
                continue
            if made and len(args) == len(poses):
                self.seen[id(node)] = place

    def again(self, run, node, args):
        """(What a function returns) that was seen to multiply; None of others."""
        place = self.seen.get(id(node))
        if place is None or not all(map(is_known_pose, args)):
            return None
        if place == RETURNED and len(args) == 2:
            found = run.factors.product(*args)
            return (found if isinstance(args[0], np.ndarray) else found.tolist(),)
        if len(args) == 3:
            target = args[2] if place == LAST else args[0]
            factors = args[:2] if place == LAST else args[1:]
            found = plain(run.factors.product(*factors))
            for row, numbers in zip(target, found):
                row[:] = numbers.tolist()
            return (None,)
        return None
