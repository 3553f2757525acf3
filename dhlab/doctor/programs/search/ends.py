"""Programs for one arm with a base and a tool: what is made of the two, tried by name."""

import numpy as np

from ....transform import inverse
from ...finding import find

__all__ = ["at_the_ends"]


def at_the_ends(answers, chains, base, tool, tolerance=1e-9):
    """The Finding that explains what a program makes of its arm's base and tool, None when nothing
    fits.

    Parameters
    ----------
    answers, chains : arrays (m, 4, 4)
        What the program gave, and the right chain without base and tool.
    base, tool : (4, 4) arrays
    tolerance : float
        Largest deviation, absolute and relative.

    Examples
    --------
    >>> from dhlab.transform import rot_z, trans_x
    >>> chains, base, tool = rot_z(np.array([0.3, 0.5, 1.1])), trans_x(1), trans_x(0.2)
    >>> at_the_ends(base @ chains, chains, base, tool).place
    'the tool is left out'
    >>> at_the_ends(tool @ base @ chains, chains, base, tool).mistake
    'tool-on-wrong-side'
    """
    for mistake, place, poses in _programs(chains, base, tool):
        if np.allclose(answers, poses, rtol=tolerance, atol=tolerance):
            end = "base" if "base" in place and "tool" not in place else "tool"
            return find(mistake, place, parameter=end)
    return None


def _programs(C, b, t):
    """Mistake, place and poses of every program that is tried; those of an end that does nothing
    are left out.
    """
    if not np.allclose(t, np.eye(4)):
        yield from _of_tool(b @ C, b, C, t)
    if not np.allclose(b, np.eye(4)):
        yield from _of_base(C @ t, b, C, t)
    if not np.allclose(b, t):
        yield "ends-exchanged", "base and tool have changed places", t @ C @ b
    yield "ends-left-out", "base and tool are left out", C


def _of_tool(bare, b, C, t):
    yield "tool-missing", "the tool is left out", bare
    yield "tool-missing", "the tool is in twice", bare @ t @ t
    yield "tool-on-wrong-side", "the tool stands left of everything", t @ bare
    yield "tool-on-wrong-side", "the tool stands between base and chain", b @ t @ C
    yield "end-inverted", "the tool", bare @ inverse(t)
    turn, shift = _parts(t)
    yield "end-in-part", "the turn of the tool is left out", bare @ shift
    yield "end-in-part", "the shift of the tool is left out", bare @ turn
    added = bare.copy()
    added[..., :3, 3] += t[:3, 3]
    for rest, place in ((turn, ""), (np.eye(4), ", and its turn is left out")):
        yield (
            "tool-on-wrong-side",
            f"the tool's shift is added along the base's axes{place}",
            (added @ rest),
        )
    yield "end-in-part", "the tool: its turn comes before its shift", bare @ turn @ shift


def _of_base(bare, b, C, t):
    yield "base-missing", "the base is left out", bare
    yield "base-missing", "the base is in twice", b @ b @ bare
    yield "base-on-wrong-side", "the base stands right of everything", bare @ b
    yield "base-on-wrong-side", "the base stands between chain and tool", C @ b @ t
    yield "end-inverted", "the base", inverse(b) @ bare
    turn, shift = _parts(b)
    yield "end-in-part", "the turn of the base is left out", shift @ bare
    yield "end-in-part", "the shift of the base is left out", turn @ bare
    yield "end-in-part", "the base: its turn comes before its shift", turn @ shift @ bare


def _parts(T):
    """The turn and the shift of a pose, T = shift @ turn."""
    turn, shift = np.eye(4), np.eye(4)
    turn[:3, :3], shift[:3, 3] = T[:3, :3], T[:3, 3]
    return turn, shift
