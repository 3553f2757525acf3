"""Notes answers: numbers as they are, functions by what they give for the numbers that the grader
drew. It judges nothing.
"""

from collections.abc import Callable, Iterable, Mapping
from contextlib import contextmanager
from typing import Any

from . import watch
from .calling import is_stub, record
from .cells import TimeLimit
from .wire import encode

__all__ = ["Book"]

MOST = 50  # notes of one exercise: who calls check in a loop is heard the first times


class Book:
    """The numbers of each task by exercise, the functions' inputs, and what has been noted."""

    def __init__(
        self,
        given: Mapping[str, Any],
        functions: Mapping[str, Any],
        send: Callable[[dict[str, Any]], None],
        only: Iterable[str] = (),
    ) -> None:
        self.given, self.functions, self.send, self.only = given, functions, send, tuple(only)
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
            line = (
                self._called(key, answer)
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

    def _called(self, key, function):
        """What a function gives, and which of the library's own programs it called on the way."""
        names, cases, own = self.functions[key]
        if is_stub(function):
            return {"value": {"...": 1}}
        with watch.library(own) as used:
            called = record(function, cases, names)
        if called.unwritten:
            return {"value": {"...": 1}}
        if called.fault:
            fault = called.fault
            return {
                "fault": [
                    str(text)[:300]
                    for text in (fault.headline, fault.place, fault.next, fault.mistake or "")
                ],
                "used": sorted(used),
            }
        return {
            "calls": [encode(answer) for answer in called.answers],
            "again": encode(called.again),
            "used": sorted(used),
        }
