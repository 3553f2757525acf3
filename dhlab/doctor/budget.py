"""How long an answer may take: processor time, asked for wherever the work loops; and where it
stands.
"""

import sys
import time
from functools import partial

import numpy as np

from ..printing import number

__all__ = ["CHOICE", "NAMES", "SECONDS", "Budget", "budget_of"]

SECONDS = 10.0  # of processor time, unless told
# shares of it, until which is searched, and what was found is fitted once more and named; the rest
# is for the step that was begun
SEARCH, CHOICE, NAMES = 0.65, 0.75, 0.9
SILENT = 2.0  # a search that takes no longer says nothing on its way
EVERY = 0.5  # seconds between two words


def budget_of(seconds, where):
    """The Budget of a caller's ``budget=``.

    Raises
    ------
    ValueError
        It is no time.

    Examples
    --------
    >>> budget_of(2, "diagnose").seconds
    2.0
    """
    number_like = isinstance(seconds, (int, float, np.integer, np.floating))
    if isinstance(seconds, bool) or not number_like or not 0 < seconds < np.inf:
        raise ValueError(
            f"{where}: budget: expected seconds of processor time above 0, found {seconds!r}"
        )
    return Budget(float(seconds))


class Budget:
    """Processor time that an answer may take; asked between two steps, since neither signals nor
    threads are had everywhere.

    Parameters
    ----------
    seconds : float
    shown : callable, optional
        Is told in words where the search stands, and ``""`` at its end; when left out, a terminal
        or a notebook shows it, and nothing does elsewhere.

    Examples
    --------
    >>> budget = Budget(0.0)
    >>> list(budget.within(range(10), "numbers")), budget.over, budget.cut_short
    ([], True, ['numbers'])
    """

    def __init__(self, seconds=SECONDS, shown=None):
        self.seconds, self.cut_short = seconds, []
        self._begun, self._said = time.process_time(), SILENT
        self._shown = shown or _screen()

    @property
    def spent(self):
        """Seconds of processor time so far."""
        return time.process_time() - self._begun

    @property
    def over(self):
        """Whether the time for searching is used up."""
        return self.past(SEARCH)

    def past(self, share):
        """Whether a share of the time is used up."""
        return self.spent >= share * self.seconds

    @property
    def left(self):
        """Seconds of processor time that are left."""
        return self.seconds - self.spent

    def part(self, doing, share=SEARCH):
        """What hands out the items of any loop, as :meth:`within` does: for a search that loops in
        many places.

        Examples
        --------
        >>> of = Budget(10.0).part("one mistake")
        >>> [x * y for x in of((2, 3)) for y in of((5, 7))]
        [10, 14, 15, 21]
        """
        return partial(self.within, doing=doing, share=share)

    def within(self, items, doing, share=SEARCH, least=0):
        """The items one by one, ``least`` of them at any rate, then as long as there is time, or a
        share of it; ``doing`` says in words what is tried.
        """
        for count, item in enumerate(items):
            spent = self.spent
            if count >= least and spent >= share * self.seconds:
                self.cut_short.append(doing)
                return
            if self._shown and spent > self._said:
                self._said = spent + EVERY
                self._shown(f"{spent:.0f} s of {self.seconds:.0f}: {doing}, {count} tried")
            yield item

    @property
    def notes(self):
        """What was not tried to the end, in one sentence; nothing where all was."""
        if not self.cut_short:
            return ()
        tried = ", ".join(dict.fromkeys(self.cut_short))
        said = (
            f"Not everything was tried ({tried}), with {number(self.seconds, 1)} s in all: this is"
            " the best so far; more time (budget=, --budget) may find more."
        )
        return (said,)

    def close(self):
        """Take the last words off the screen."""
        if self._shown and self._said > SILENT:
            self._shown("")


def _screen():
    """What shows a line that the next one replaces: a notebook's output, a terminal's last line."""
    if "IPython" in sys.modules:
        from IPython import get_ipython

        if getattr(get_ipython(), "kernel", None) is not None:
            return _Notebook()
    stream = sys.stderr
    return _on_terminal if stream is not None and stream.isatty() else None


def _on_terminal(words):
    sys.stderr.write("\r\x1b[K" + words)
    sys.stderr.flush()


class _Notebook:
    """One output of a cell, whose words are replaced."""

    def __init__(self):
        self.output = None

    def __call__(self, words):
        from IPython.display import display

        text = {"text/plain": words}
        if self.output is None:
            self.output = display(text, raw=True, display_id=True)
        else:
            self.output.update(text, raw=True)
