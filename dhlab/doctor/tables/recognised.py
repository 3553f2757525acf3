"""The answer to a pasted table: its readings, and what has to be asked."""

from dataclasses import dataclass

import numpy as np

from ...printing import number

__all__ = ["Recognised"]


@dataclass(frozen=True)
class Recognised:
    """The answer of :func:`recognise_table`.

    Parameters
    ----------
    readings : tuple of Reading
        Most likely first; with ``right=`` only those that are the right arm, unless none is.
    questions : tuple of str
        What a person has to say to leave one reading.
    tell_apart : array (n,) or None
        A configuration, radians and metres, at which the readings' end points differ most; None
        with one reading.
    poses : array (readings, 4, 4) or None
        The end poses there.
    notes : tuple of str
        Patterns worth a look: degrees among radians, lengths all positive.
    open : tuple of str
        The names of the questions, in their order: "order", "convention", "angle", "length", "row",
        "form".
    matches : bool or None
        Whether the first reading is equivalent to ``right``; None without it.

    Examples
    --------
    >>> import dhlab as dh
    >>> found = dh.recognise_table("0 0.1 0 90\\n0 0 0.4 0")
    >>> len(found.readings) > 1, len(found.questions) > 0, found.matches
    (True, True, None)
    """

    readings: tuple
    questions: tuple = ()
    tell_apart: np.ndarray | None = None
    poses: np.ndarray | None = None
    notes: tuple = ()
    matches: bool | None = None
    open: tuple = ()

    @property
    def arm(self):
        """The most likely reading's arm."""
        return self.readings[0].arm

    def __str__(self):
        lines = [
            (
                f"Read as {self.readings[0].words}."
                if len(self.readings) == 1
                else f"{len(self.readings)} readings fit{_joints(self.readings)}:"
            )
        ]
        if len(self.readings) > 1:
            lines += [f"  {k}. {reading.words}" for k, reading in enumerate(self.readings, 1)]
        lines += [f"  Assumed: {text}" for text in self.readings[0].assumptions] + [
            f"  Note: {text}" for text in self.notes
        ]
        lines += [f"  Question: {text}" for text in self.questions]
        if self.tell_apart is not None:
            lines.append(
                "  Telling: measure at q = "
                + ", ".join(number(v, 4) for v in self.tell_apart)
                + " (rad, m): "
                + "; ".join(
                    f"{k}. ({', '.join(number(v, 3) for v in pose[:3, 3])}) m"
                    for k, pose in enumerate(self.poses, 1)
                )
            )
        return "\n".join(lines)

    __repr__ = __str__


def _joints(readings):
    """How many joints the arm has, where all readings agree."""
    counts = {len(reading.arm) for reading in readings}
    n = counts.pop()
    return "" if counts else f", each with {n} joint{'s' if n > 1 else ''}"
