"""What a program computes beside what is read of its text: one settles or corrects the other."""

from dataclasses import replace

from ..completing.accounted import joints_said
from ..dialects.lined.grid import NoRows
from ..dialects.lined.widths import NotFour
from ..evidence.ending import require_whole
from ..evidence.source import source_of
from ..language.wrapping.notebook import without_notebook
from ..readings import NoOrder
from .reading import differs_in_theta, moves_alike

__all__ = ["is_cut_off", "settled", "stands_alone"]


def is_cut_off(text):
    """Whether a text ends within a row, so that a program in it may have had more links.

    Examples
    --------
    >>> is_cut_off("dh = [[0, 0.1, 0, 1.57],\\n[0, 0, 0.3"), is_cut_off("dh = [[0, 0.1, 0, 1.57]]")
    (True, False)
    """
    try:
        source = source_of(without_notebook(text))
    except ValueError:
        return False
    try:
        require_whole(source)
    except ValueError:
        return True
    return False


def stands_alone(program, error, text):
    """Whether what a program computes counts, where its text is not read: a link function that it
    does not call answers no question but that for rows, or for the order of their columns.

    Parameters
    ----------
    program : Computed
    error : ValueError
        Why the text is not read.
    text : str
    """
    if is_cut_off(text):
        return False
    said = joints_said(source_of(without_notebook(text))) if program.of_function else ()
    own = len(program.readings[0].arm)
    asked = program.of_function and not isinstance(error, NoRows | NotFour | NoOrder)
    return not asked and (not said or own in said)


def settled(written, program, convention=None, doubted=False):
    """(Readings, notes) of a text of which a program is computed, too.

    Parameters
    ----------
    written : list of Reading
        What the text is read as; nothing, where it is not read.
    program : Computed
    convention : str, optional
        In which the table is wanted.
    doubted : bool
        Whether the numbers themselves speak against what is written.

    Returns
    -------
    tuple
        Readings that are written and computed; else the computed ones. Beside them stands what is
        written where that was sure of itself, unless only angles of joints differ: the program adds
        to them or turns them round, which its rows do not say.
    """
    if any(_reaches(one) for one in program.readings):
        written = [one for one in written if _reaches(one)]
    alike = [
        one
        for one in written
        if any(moves_alike(own, one, program.ends) for own in program.readings)
    ]
    if program.of_function and written:
        return _by_function(written, program, alike), ()
    if alike:
        return alike, ()
    own = program.readings
    if written and min(len(one.arm) for one in written) > program.rows:
        return written, ()  # the program multiplies a part of them
    if convention:
        own = [replace(one, arm=one.arm.to(convention)) for one in own]
    if len(written) != 1 or doubted:
        return list(own), program.notes
    if any(differs_in_theta(one, written[0]) for one in own):
        note = "theta and the senses are those of the product; the rows in the text have others"
        return list(own), (*program.notes, note)
    return [*(_beside(one, written[0]) for one in own), written[0]], program.notes


def _reaches(reading):
    """Whether an arm has a length: what is read with none of those that the program multiplies is
    no arm.
    """
    return bool(reading.arm.table.rows[:, 1:3].any())


def _by_function(written, program, alike):
    """Readings that have order, convention and units of one that the link function gives; which
    rows have a joint, it does not say. Beside a sure reading stands another one of the same joints.
    """
    kept = [one for one in written if any(_columns(one) == _columns(other) for other in alike)]
    if kept or len(written) > 1:
        return kept or written
    own = program.readings
    joints = {one.arm.table.joints for one in (*own, *written)}
    if len(joints) > 1 or any(differs_in_theta(one, written[0]) for one in own):
        return written
    return [*(_beside(one, written[0]) for one in own), written[0]]


def _columns(reading):
    said = dict(reading.choices)
    return [said[name] for name in ("order", "convention", "angle", "length")]


def _beside(own, written):
    """A computed reading of which it is asked whether it is meant, beside what is written."""
    choices = dict(written.choices) | {"form": "computed", "length": dict(own.choices)["length"]}
    return replace(own, choices=tuple(choices.items()))
