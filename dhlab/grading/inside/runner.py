"""Runs one notebook inside the cage, cell by cell, and writes what it noted as lines of JSON.
Nothing that is wanted here is a secret.

Every line is an object: ``{"cell": 3, "ids": [...]}`` when a cell begins, ``{"cell": 3, "ended":
"error", ...}`` when it ends badly, ``{"check": "05.1", ...}`` for an answer, ``{"done": ...}`` at
the end, ``{"unreadable": ...}`` when there is nothing to run.
"""

import builtins
import json
import os
import random
import signal
import sys
import types

import numpy as np

from . import notebook as notebooks
from .book import Book
from .cells import TimeLimit, run_cell
from .wire import decode

__all__ = ["run"]

LONGEST = 1_000_000  # bytes of a line


def run(request_file: int, answer_file: int) -> None:
    """Read the request and the notebook from one open file, write the answers to the other."""
    with os.fdopen(request_file, "rb") as file:
        request = json.loads(file.readline())
        raw = file.read()
    send = _sender(answer_file)
    try:
        cells = notebooks.read(raw, request["checks"])
    except Exception as error:  # whatever was sent in: this process has nothing else to do
        send(
            {
                "unreadable": (
                    str(error)[:200] if isinstance(error, ValueError) else type(error).__name__
                )
            }
        )
        return
    _Run(request, cells, send).go()
    send({"done": cells.lesson})


def _sender(file):
    def send(line):
        data = json.dumps(line).encode()
        if len(data) > LONGEST:
            data = json.dumps(
                {key: value for key, value in line.items() if key in ("check", "cell")}
                | {"value": {"other": "an answer too large to send"}}
            ).encode()
        data += b"\n"
        while data:
            data = data[os.write(file, data) :]

    return send


class _Run:
    def __init__(self, request, cells, send):
        self.request, self.cells, self.send = request, cells, send
        self.book = Book(
            {key: decode(value) for key, value in request["given"].items()},
            _functions(request["functions"]),
            send,
            request["only"],
        )
        self.space = self._space()

    def _space(self):
        """The notebook's names: those that every lesson's first cell imports are there even when
        that cell is not.
        """
        import dhlab
        from dhlab import course, transform, view

        course.book = self.book  # type: ignore[attr-defined]  # the one that stands in
        module = types.ModuleType("__main__")
        sys.modules["__main__"] = module
        module.__dict__.update(
            {name: getattr(course, name) for name in course.__all__},
            np=np,
            dh=dhlab,
            transform=transform,
            view=view,
            __builtins__=builtins,
        )
        return module.__dict__

    def go(self):
        random.seed(0)
        np.random.seed(0)  # noqa: NPY002  (a submission may use the old generator)
        signal.signal(signal.SIGALRM, _too_long)
        for number, cell in enumerate(self.cells.code):
            self._cell(number, cell)
            if number == self.cells.last_for(self.book.only):
                break
        for key in self.cells.unplaced:
            if key not in self.book.noted:
                self._fallback(key)

    def _cell(self, number, cell):
        self.send({"cell": number, "ids": cell.ids})
        self.book.cell = number
        if number in self.request["skip"]:
            return
        outcome = self._limited(lambda: run_cell(cell.source, f"<cell {number + 1}>", self.space))
        if outcome:
            self.send({"cell": number, "ended": outcome[0], "message": outcome[1], "ids": cell.ids})
        for key in cell.answers:
            if key not in self.book.noted_in(number):
                self._fallback(key)

    def _fallback(self, key):
        """The answer of an exercise whose check is missing or broken: what the handed-out check
        would have been given.
        """
        self._limited(lambda: self.book.note(key, eval(self.cells.expressions[key], self.space)))

    def _limited(self, act):
        """None when ``act`` came to its end; otherwise what stopped it, in two words."""
        try:
            signal.setitimer(signal.ITIMER_REAL, self.request["cell_seconds"], 0.25)
            act()
        except TimeLimit:
            return "timed out", ""
        except (
            BaseException
        ) as error:  # SystemExit and KeyboardInterrupt end a cell, not the notebook
            return "error", _message(error)
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
        return None


def _message(error):
    try:
        return f"{type(error).__name__}: {error}"[:300]
    except BaseException:
        return "an error that cannot be shown"


def _too_long(signal_number, frame):
    raise TimeLimit


def _functions(sent):
    return {
        key: (
            tuple(f["names"]),
            [tuple(decode(value) for value in case) for case in f["cases"]],
            f["own"],
        )
        for key, f in sent.items()
    }
