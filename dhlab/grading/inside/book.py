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
MOST = 50  # notes of one exercise: who calls check in a loop is heard the first times


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

    def noted_in(self, cell: int) -> set[str]:
        """The exercises that were noted while a cell ran."""
        return {key for key, where in self._where if where == cell}

    def note(self, key: str, answer: Any) -> None:
        """Send one answer out."""
        if (
            not isinstance(key, str)
            or self.noted.get(key, 0) >= MOST
            or (self.only and key not in self.only)
        ):
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
            self.send({"check": key, "cell": self.cell, **line})

    @contextmanager
    def _on_time(self, key):
        try:
            yield
        except TimeLimit:
            self.send({"check": key, "cell": self.cell, "stopped": "timed out"})
            raise
