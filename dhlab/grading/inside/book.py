"""Notes answers: numbers as they are, and of a function only that there is one; it is called in
another room. It judges nothing.
"""

from collections.abc import Callable, Iterable, Iterator, KeysView, Mapping, ValuesView
from contextlib import contextmanager
from itertools import islice
from typing import Any

from .calling import is_stub
from .clock import TimeLimit
from .wire import encode

__all__ = ["Book"]

ONCE = Iterator, KeysView, ValuesView  # what can only be walked through, as for the check
ENTRIES = 1000  # that are taken of such an answer
# notes of one exercise that are sent as they come: of who calls check in a loop without end, then
# only the last in a cell, since the last one counts
MOST = 50


class Book:
    """The numbers of each task by exercise, which exercises ask for a function, and what has been
    noted.
    """

    def __init__(
        self,
        given: Mapping[str, Any],
        functions: Iterable[str],
        send: Callable[[dict[str, Any]], None],
        only: Iterable[str] = (),
    ) -> None:
        self.given, self.functions, self.send = given, frozenset(functions), send
        self.only = tuple(only)
        self.cell = 0
        self.noted: dict[str, int] = {}
        self._where: set[tuple[str, int]] = set()
        self._last: dict[str, dict[str, Any]] = {}  # what is not sent yet

    def noted_in(self, cell: int) -> set[str]:
        """The exercises that were noted while a cell ran."""
        return {key for key, where in self._where if where == cell}

    def note(self, key: str, answer: Any) -> None:
        """Send one answer out."""
        if not isinstance(key, str) or (self.only and key not in self.only):
            return
        self.noted[key] = self.noted.get(key, 0) + 1
        self._where.add((key, self.cell))
        with self._on_time(key):
            if isinstance(answer, ONCE):
                answer = list(islice(answer, ENTRIES))
            line = (
                {"function": "stub" if is_stub(answer) else "written"}
                if key in self.functions and callable(answer)
                else {"value": encode(answer)}
            )
            line = {"check": key, "cell": self.cell, **line}
            if self.noted[key] <= MOST:
                self.send(line)
            else:
                self._last[key] = line

    def send_last(self) -> None:
        """Send what was noted last of exercises that are noted without end; once a cell is over."""
        for line in self._last.values():
            self.send(line)
        self._last.clear()

    @contextmanager
    def _on_time(self, key):
        try:
            yield
        except TimeLimit:
            self.send({"check": key, "cell": self.cell, "stopped": "timed out"})
            raise
