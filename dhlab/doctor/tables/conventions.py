"""For which convention a table is, by its heading and by what the rest of the text says; left open
where they contradict each other, or where a matrix stands in the text that cannot be read.
"""

from dataclasses import replace

from .evidence.conventions import convention_in, defined_in, has_formula
from .evidence.makers import called_convention
from .evidence.orders import previous_in

__all__ = ["with_convention"]

NAMES = {"standard": "standard", "craig": "modified (Craig)"}
BY_INDEX = "by the index i-1", "since all headings carry the index"


def with_convention(table, source):
    """The table with the convention that its text says, None where that is to be asked."""
    if table.because.startswith(BY_INDEX[0]) and (against := _against_the_index(source)):
        return _left_open(table, f"the index i-1 in the header is Craig's, and the text {against}")
    if table.because.startswith(BY_INDEX) and _is_unread(source):
        note = (
            "a link matrix of the text could not be read, and it may be another than the heading's"
        )
        return _left_open(table, note)
    return table if table.convention else _said(table, source)


def _against_the_index(source):
    """What the text does against the index i-1 of a heading; "" where it does nothing."""
    computed = convention_in(source)
    if computed and computed[0] == "standard":
        return "computes or names the other"
    return "speaks of the standard rows" if source.convention == "standard" else ""


def _left_open(table, note):
    return replace(table, convention=None, because="", notes=(*table.notes, note))


def _is_unread(source):
    """Whether formulas of a link matrix stand in the text, and nothing says of which."""
    return not source.convention and has_formula(source.text) and convention_in(source) is None


def _said(table, source):
    """The table with the convention that the text computes, calls, names or defines."""
    computed = convention_in(source)
    if computed and source.convention and computed[0] != source.convention:
        told, found = NAMES[source.convention], NAMES[computed[0]]
        note = f"the text names the {told} convention, and its program computes the {found} one"
        return replace(table, notes=(*table.notes, note))
    if computed:
        return replace(table, convention=computed[0], because=computed[1])
    if called := called_convention(source.code):
        return replace(table, convention=called, because="as the call in the text says")
    if table.why == "as the comment says" and previous_in(source):
        return replace(table, convention="craig", because="by the index i-1 in the comment")
    if source.convention:
        return replace(table, convention=source.convention, because="as the text says")
    if defined := defined_in(source):
        return replace(table, convention=defined, because="as the text defines a and alpha")
    return table
