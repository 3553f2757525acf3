"""What a program computes beside what is read of its text: one settles or corrects the other."""

from dataclasses import replace

from ..evidence.ending import require_whole
from ..evidence.source import source_of
from ..language.wrapping.notebook import without_notebook
from .reading import differs_in_theta, moves_alike

__all__ = ["is_cut_off", "settled"]


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


def settled(written, program, convention=None):
    """(Readings, notes) of a text of which a program is computed, too.

    Parameters
    ----------
    written : list of Reading
        What the text is read as; nothing, where it is not read.
    program : Computed
    convention : str, optional
        In which the table is wanted.

    Returns
    -------
    tuple
        Readings that are written and computed; else the computed ones. Beside them stands what is
        written where that was sure of itself, unless only angles of joints differ: the program adds
        to them or turns them round, which its rows do not say.
    """
    alike = [
        one
        for one in written
        if any(moves_alike(own, one, program.ends) for own in program.readings)
    ]
    if alike:
        return alike, ()
    own = program.readings
    if written and min(len(one.arm) for one in written) > len(own[0].arm):
        return written, ()  # the program multiplies a part of them
    if convention:
        own = [replace(one, arm=one.arm.to(convention)) for one in own]
    if len(written) != 1:
        return list(own), program.notes
    if any(differs_in_theta(one, written[0]) for one in own):
        note = "theta and the senses are those of the product; the rows in the text have others"
        return list(own), (*program.notes, note)
    return [*(_beside(one, written[0]) for one in own), written[0]], program.notes


def _beside(own, written):
    """A computed reading of which it is asked whether it is meant, beside what is written."""
    choices = dict(written.choices) | {"form": "computed", "length": dict(own.choices)["length"]}
    return replace(own, choices=tuple(choices.items()))
