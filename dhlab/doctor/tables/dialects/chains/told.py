"""Readings of arms that are told as chains: nothing is to be asked but the unit of the lengths."""

from ...language.values import TO_METRES
from ...meaning.scales import TOY, UNIT_WORDS, reached, units_by_size
from ...readings import QUESTIONS, Reading

__all__ = ["told"]


def told(form, make, lengths, source, why="", units=None, notes=()):
    """The Readings of a chain, one for each unit that its lengths can have.

    Parameters
    ----------
    form : str
        What the text is, in words.
    make : callable
        ``make(scale)`` gives the Arm with its lengths scaled to metres.
    lengths : list of float
    source : Source
    notes : tuple of str
        What is worth a second look.
    """
    sizes = [abs(length) for length in lengths if length]
    small = max(sizes, default=0.0) < TOY
    said = source.length if not (source.length == "mm" and small) else ""
    if units is None:
        if source.asked_length:
            units = [source.asked_length]
        elif said:
            units = [said]
        elif source.length == "mm":
            units = ["m", "mm"]
        else:
            units = units_by_size(sizes)
    return [
        Reading(
            make(TO_METRES[unit]),
            f"{form}{', ' + why if why else ''}; {UNIT_WORDS[unit]}"
            + _why(unit, said, source, sizes),
            (),
            tuple(zip(QUESTIONS, ((), "", "rad", unit, (), "", "", ""))),
            tuple(notes),
        )
        for unit in units
    ]


def _why(unit, said, source, sizes):
    if source.asked_length:
        return ", as you say"
    return ", as the text says" if unit == said else f" {reached(sizes, unit)}"
