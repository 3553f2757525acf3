"""A program for a chain taken for another arm: the mistakes that are made in one row or at one
joint, and a constant transform at either end.
"""

import re

import numpy as np

from ....arm import Arm
from ....table import DHTable
from ....transform import inverse, pose_fault
from ...finding import find
from ...mistakes.faults import faults
from ...mistakes.registry import value_mistake
from .steps import run_chain

__all__ = ["as_another_arm"]

NUMBER = re.compile(r"\d+")
VERIFIED = 5  # calls, after the first, on which an explanation must hold


def as_another_arm(answers, cases, tolerance=1e-9):
    """The Finding that explains what a program for a chain answers, None when nothing fits.

    Parameters
    ----------
    answers : array (m, 4, 4)
    cases : sequence of m (rows, q)
    tolerance : float
        Largest deviation, absolute and relative.

    Examples
    --------
    >>> rng = np.random.default_rng(2)
    >>> cases = [(rng.uniform(0.2, 1, (n, 4)), rng.uniform(0.2, 1, n)) for n in (3, 4, 2, 5)]
    >>> turned = [run_chain((), rows, q * ([1, -1] + [1] * (len(q) - 2))) for rows, q in cases]
    >>> finding = as_another_arm(np.array(turned), cases)
    >>> finding.mistake, finding.joint
    ('joint-reversed', 2)
    """
    if pose_fault(np.asarray(answers, dtype=float)) is not None:
        return None
    return _at_an_end(answers, cases, tolerance) or _in_a_row(answers, cases, tolerance)


def _near(a, b, tolerance):
    return bool(np.all(np.abs(a - b) <= tolerance * (1 + np.abs(b))))


# ---- a constant at either end


def _at_an_end(answers, cases, tolerance):
    right = np.array([run_chain((), *case) for case in cases])
    tools, bases = inverse(right) @ answers, answers @ inverse(right)
    if _near(tools, tools[:1], 10 * tolerance):
        return find(value_mistake("tool"), f"at the end of the product: {_words(tools[0])}")
    if _near(bases, bases[:1], 10 * tolerance):
        turned = not np.allclose(bases[0, :3, :3], np.eye(3), atol=1e-7)
        raised = not np.any(np.abs(bases[0, :2, 3]) > 1e-9)
        what = value_mistake("base turn" if turned else "base shift")
        what = what if turned or raised else "base-missing"
        return find(what, f"before the first link: {_words(bases[0])}")
    return None


def _words(T):
    """A constant pose in words."""
    shift = ", ".join(f"{x:.4g}" for x in np.round(T[:3, 3], 9) + 0.0)
    angle = np.degrees(np.arccos(np.clip((np.trace(T[:3, :3]) - 1) / 2, -1, 1)))
    turn = f"a turn by {angle:.4g}°" if angle > 1e-5 else ""
    step = f"a shift by ({shift}) m" if np.abs(T[:3, 3]).max() > 1e-9 else ""
    return " and ".join(filter(None, (turn, step)))


# ---- a mistake in one row, or at one joint


def _in_a_row(answers, cases, tolerance):
    """The mistakes of arms, made on the chain of the longest call that is short enough."""
    order = sorted(range(len(cases)), key=lambda k: (len(cases[k][1]) != 5, len(cases[k][1])))
    first, others = order[0], order[1:]
    fitting = {
        key: fault
        for key, fault in _faults(cases[first]).items()
        if _near(fault.arm.forward(cases[first][1]), answers[first], tolerance)
    }
    for k in others[:VERIFIED] if fitting else ():
        here, (_, q) = _faults(cases[k]), cases[k]
        right = run_chain((), *cases[k])
        fitting = {
            key: fault
            for key, fault in fitting.items()
            if _near(here[key].arm.forward(q) if key in here else right, answers[k], tolerance)
        }
    if not fitting:
        return None
    (_, joint, _, _), best = next(iter(fitting.items()))
    alike = tuple(dict.fromkeys(f.mistake for f in fitting.values() if f.mistake != best.mistake))
    place, row = best.place or f"joint {best.joint}", best.joint
    if joint is not None and joint < 0:  # counted from the end, whatever the number of rows
        place, row = "the last row" if joint == -1 else f"row {-joint} from the end", None
    return find(best.mistake, place, joint=row, parameter=best.parameter, look_alikes=alike)


def _faults(case):
    """Every mistake of the chain's arm, by what and where: its joint counted from 1, and from -1
    at the end.
    """
    arm = Arm(DHTable.standard(case[0], angle="rad"))
    made = list(faults(arm, program=True))
    ahead = {(f.mistake, f.joint, f.parameter, f.place): f for f in made}
    back = {
        (f.mistake, f.joint - len(arm) - 1, f.parameter, NUMBER.sub("", f.place)): f
        for f in made
        if f.joint is not None
    }
    return ahead | back
