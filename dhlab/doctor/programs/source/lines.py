"""The lines of a learner's function that must change, with what was tried."""

import ast
import contextlib
import io
import sys
import warnings

from ...diagnosis import Line
from .repair import repaired
from .text import text_of
from .tried import Tried

__all__ = ["lines_to_change"]


def lines_to_change(f, calls, tolerance, seconds, arm=None):
    """The lines of a function's text that must change so that it is right in every call.

    Parameters
    ----------
    f : callable
    calls : list of (tuple, array)
        Arguments and right answers, the simplest calls first.
    tolerance : float
    seconds : float
        Of the processor.
    arm : Arm, optional
        The one arm that the program is for; then the first calls are at q = 0, and with each joint
        moved alone.

    Returns
    -------
    (tuple of Line, int, str or None, list of (tuple of Line, function))
        The lines, empty when no small change of the text makes it right; how many places
        change, also where they stand in one line; the whole text with them changed; then
        single changes that make more right, with the functions that they make.
    """
    text = text_of(f)
    if text is None or (sys.platform == "emscripten" and _may_go_on(text)):
        return (), 0, None, []
    joints = 0 if arm is None else len(arm)
    with contextlib.redirect_stdout(io.StringIO()), warnings.catch_warnings():
        warnings.simplefilter("ignore")
        changes, better = repaired(text, Tried(calls, tolerance, joints), seconds, arm)
    whole = text.edited([edit for change in changes for edit in change]) if changes else None
    halves = [(_lines_of(text, [change]), g) for change, g in better]
    return _lines_of(text, changes), sum(len(c) or 1 for c in changes), whole, halves


def _lines_of(text, changes):
    """The lines that changes of a text change, as Lines."""
    edits = [edit for change in changes for edit in change]
    edited = text.edited(edits).splitlines()
    found = []
    for edit in sorted(edits, key=lambda edit: edit.start):
        number = text.line_at(edit.start)
        before = text.data[: edit.start].count(b"\n")
        moved = sum(
            e.new.count(b"\n") - text.data[e.start : e.end].count(b"\n")
            for e in edits
            if e.start < edit.start
        )
        instead = edited[before + moved].strip() if before + moved < len(edited) else ""
        if edit.start == edit.end and b"\n" in edit.new:
            where = "behind" if edit.new.startswith(b"\n") else "before"
            instead = f"{edit.new.decode().strip()}  (a new line {where} this one)"
        found.append(Line(number, text.line(number), instead))
    return tuple(dict.fromkeys(found))


def _may_go_on(text):
    """Whether a loop may have no end; a browser has nothing to stop it."""
    return any(isinstance(node, ast.While) for node in ast.walk(text.tree))
