"""``Diagnosis``: what the doctor says, for a terminal, a notebook and a program."""

from dataclasses import dataclass, field
from functools import cached_property
from html import escape
from textwrap import fill

import numpy as np

from ..arm import Arm
from ..printing import number
from .catalogue import catalogue
from .finding import Finding

__all__ = ["Diagnosis", "Line", "AGREES", "CALIBRATED", "EXPLAINED", "UNDECIDED", "UNEXPLAINED"]

AGREES, CALIBRATED, EXPLAINED, UNEXPLAINED = "agrees", "calibrated", "explained", "unexplained"
UNDECIDED = "undecided"  # too few poses to tell
WIDTH = 100  # characters of a line, in a terminal


@dataclass(frozen=True)
class Line:
    """A line of a program that must change: its number from 1 in the file or the cell, what stands
    there, and what makes the program right.

    Examples
    --------
    >>> print(Line(7, "T = A @ T", "T = T @ A"))
    7: T = A @ T  →  T = T @ A
    """

    number: int
    found: str
    instead: str

    def __str__(self):
        return f"{self.number}: {self.found}  →  {self.instead}"


@dataclass(frozen=True)
class Diagnosis:
    """The answer of the doctor.

    Parameters
    ----------
    verdict : "agrees", "calibrated", "explained", "undecided" or "unexplained"
    headline : str
        One sentence.
    findings : tuple of Finding
        Best first; together they explain what was seen when ``verdict`` is "explained" (a pair of
        mistakes is two findings).
    before, after : (float, float) or None
        Largest residual in mm and degrees, of the arm as given and as repaired; the angle is NaN
        where only positions were compared.
    lines : tuple of Line
        Of a program: what was changed in its text, by way of trial, so that it gave the right pose
        in every call; empty when no small change was found.
    repaired : str or None
        The program's text with these lines changed; None where there are none.
    notes : tuple of str
        What else a reader should know: look-alikes, too few poses, how the noise was estimated.
    next_pose : array (n,) or None
        A configuration whose measurement would tell the remaining explanations apart; radians and
        metres.
    fits : tuple of Finding
        Where ``verdict`` is "undecided": what fits these poses, the likeliest first; none of them
        is claimed.
    fitted : Arm or None
        Where there is no finding and still something was found: the arm with its free base and tool
        in place, or as calibrated.
    compared : (Arm, q, measured) or None
        What :attr:`picture` draws: the arm as given (its base and tool in place where they are
        free), q (m, n), poses (m, 4, 4) or positions (m, 3).

    Examples
    --------
    >>> import numpy as np, dhlab as dh
    >>> arm = dh.load("article-6r")
    >>> q = np.random.default_rng(1).uniform(-2, 2, (6, 6))
    >>> answer = dh.diagnose(arm, q, arm.forward(q))
    >>> answer.verdict, answer.findings, len(answer.before)
    ('agrees', (), 2)
    """

    verdict: str
    headline: str
    findings: tuple[Finding, ...] = ()
    before: tuple | None = None
    after: tuple | None = None
    notes: tuple = ()
    next_pose: np.ndarray | None = None
    fits: tuple[Finding, ...] = ()
    fitted: Arm | None = field(default=None, repr=False, compare=False)
    compared: tuple | None = field(default=None, repr=False, compare=False)
    lines: tuple[Line, ...] = ()
    repaired: str | None = field(default=None, repr=False, compare=False)

    @cached_property
    def picture(self):
        """The :class:`dhlab.view.Picture` of predicted against measured, drawn when first asked
        for; None where there is nothing to draw.
        """
        if self.compared is None:
            return None
        from ..view import compared  # matplotlib takes longer to load than most diagnoses take

        return compared(*self.compared)

    def __bool__(self):
        """True when nothing is wrong."""
        return self.verdict == AGREES

    def to_dict(self):
        """Plain values for a program."""
        return {
            "verdict": self.verdict,
            "headline": self.headline,
            "findings": [finding.to_dict() for finding in self.findings],
            "fits": [finding.to_dict() for finding in self.fits],
            "before": _pair(self.before),
            "after": _pair(self.after),
            "lines": [vars(line) for line in self.lines],
            "notes": list(self.notes),
            "next_pose": None if self.next_pose is None else np.asarray(self.next_pose).tolist(),
        }

    def _lines(self):
        for k, finding in enumerate(self.findings, 1):
            words = catalogue()[finding.mistake]
            lead = f"{k}. " if len(self.findings) > 1 else ""
            yield (
                "What",
                f"{lead}{words.title}"
                + (f" ({finding.place})" if finding.place else "")
                + (f": {finding.detail}" if finding.detail else ""),
            )
            yield "Seen", words.see
            yield "Why", words.why
            yield "Next", words.next
            if finding.look_alikes:
                yield (
                    "Same",
                    "looks the same on this arm: "
                    + "; ".join(catalogue()[name].title for name in finding.look_alikes),
                )
        for finding in self.fits:
            told = ": ".join(part for part in (finding.place, finding.detail) if part)
            title = catalogue()[finding.mistake].title
            yield "Fits", title + (f" ({told})" if told else "")
        if self.before is not None:
            yield (
                "Off by",
                _size(self.before)
                + (f", once repaired {_size(self.after)}" if self.after is not None else ""),
            )
        for line in self.lines:
            yield "Line", str(line)
        if self.lines:
            one = "this change" if len(self.lines) == 1 else "these changes together"
            yield "", f"with {one} the program was right in every call that was tried"
        for note in self.notes:
            yield "Note", note
        if self.next_pose is not None:
            told_apart = (
                " would tell them apart" if self.fits or self.findings else ", then ask again"
            )
            yield "Measure", self._pose_to_measure() + told_apart

    def _pose_to_measure(self):
        slides = (
            self.compared[0].table.prismatic
            if self.compared is not None
            else np.zeros(len(self.next_pose), dtype=bool)
        )
        return "q = " + ", ".join(
            f"{number(v * 1e3, 0)} mm" if slide else f"{number(np.rad2deg(v), 0)}°"
            for v, slide in zip(self.next_pose, slides)
        )

    def __str__(self):
        return "\n".join(
            [
                self.headline,
                *(
                    fill(
                        text,
                        WIDTH,
                        initial_indent=f"  {label + ':' if label else '':8} ",
                        subsequent_indent=" " * 11,
                    )
                    for label, text in self._lines()
                ),
            ]
        )

    __repr__ = __str__

    def _repr_html_(self):
        rows = "".join(
            f"<div><em>{label + ':' if label else ''}</em> {escape(text)}</div>"
            for label, text in self._lines()
        )
        picture = self.picture._repr_mimebundle_()["text/html"] if self.picture is not None else ""
        return (
            '<div role="status" style="border-left:4px solid #0b62c4;padding:.3em'
            f' .8em"><div><strong>{escape(self.headline)}</strong></div>{rows}</div>{picture}'
        )


def _pair(residual):
    return (
        None
        if residual is None
        else {
            "mm": float(residual[0]),
            "deg": None if np.isnan(residual[1]) else float(residual[1]),
        }
    )


def _size(residual):
    millimetres, degrees = residual
    return f"{number(millimetres, 3)} mm" + (
        "" if np.isnan(degrees) else f" and {number(degrees, 3)}°"
    )
