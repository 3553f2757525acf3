"""Runs one notebook inside the cage, cell by cell, and writes what it noted as lines of JSON.
Nothing that is wanted here is a secret.

Every line is an object: ``{"slim": ...}``, the notebook's code, before any of it runs; ``{"cell":
3, "ids": [...]}`` when a cell begins, ``{"cell": 3, "ended": "error", ...}`` when it ends badly,
with ``absent`` where it used a module that is not there, ``{"check": "05.1", ...}`` for an answer,
``{"done": ...}`` at the end, ``{"unreadable": ...}`` when there is nothing to run.
"""

import ast
import json
import os
import random
from collections.abc import Collection
from typing import Any

import numpy as np

from . import calls
from .book import Book
from .clock import limited
from .reading import notebook as notebooks
from .reading.demonstrations import showing, skippable
from .shell import Absent, run_cell
from .space import loaded, space
from .wire import decode

__all__ = ["run"]

LONGEST = 1_000_000  # bytes of a line
MOST_CODE = 2_000_000  # bytes of a notebook without its outputs


def run(request_file: int, answer_file: int, warm: Collection[str] = ()) -> None:
    """Read the request and the notebook from one open file, write the answers to the other;
    ``warm`` are the modules that need not be told of.
    """
    with os.fdopen(request_file, "rb") as file:
        request = json.loads(file.readline())
        raw = file.read()
    if "slim" in request:
        _slim(raw, answer_file)
        return
    if "call" in request:
        calls.answer(request, raw, answer_file, warm)
        return
    send = _sender(answer_file)
    try:
        notebook = notebooks.opened(raw)
        cells = notebooks.cells_of(notebook, request["checks"])
        code = notebooks.slim(notebook)
    except Exception as error:  # whatever was sent in: this process has nothing else to do
        send(
            {
                "unreadable": (
                    str(error)[:200] if isinstance(error, ValueError) else type(error).__name__
                )
            }
        )
        return
    del raw, notebook  # with all its pictures
    send({"slim": code})
    _Run(request, cells, send).go()
    send({"done": cells.lesson, "loaded": loaded(warm)})


def _slim(raw, answer_file):
    """A notebook without its outputs, or what is wrong with it; nothing of it is run."""
    try:
        line = {"slim": notebooks.slim(notebooks.opened(raw)), "done": ""}
    except Exception as error:
        line = {"unreadable": type(error).__name__}
    _sender(answer_file, MOST_CODE)(line)


def _sender(file, longest=LONGEST):
    def send(*lines):
        data = b"".join(map(_line, lines))
        while data:
            data = data[os.write(file, data) :]

    def _line(line):
        data = json.dumps(line).encode()
        if len(data) > longest:
            data = json.dumps(
                {key: value for key, value in line.items() if key in ("check", "cell")}
                | {"value": {"other": "an answer too large to send"}}
            ).encode()
        return data + b"\n"

    return send


class _Run:
    def __init__(self, request, cells, send):
        self.request, self.cells, self.send = request, cells, send
        self.book = Book(
            {key: decode(value) for key, value in request["given"].items()},
            request["functions"],
            send,
            request["only"],
        )
        self.space = space(self.book)
        self.begun: list[dict[str, Any]] = []  # cells of which nobody has been told yet
        self.shown: set[int] = set()  # cells that only show something
        self.showing: Collection[str] = ()  # functions of the lesson that do

    def _look(self):
        answered = {number: self._used(cell.answers) for number, cell in enumerate(self.cells.code)}
        untouched, used = set(self.request["untouched"]), self._used(self.cells.unplaced)
        self.shown = skippable(self.cells.code, untouched, used, answered)
        self.showing = showing(self.cells.code, untouched)

    def _used(self, keys):
        """The names that the handed-out checks of some exercises read."""
        return {
            node.id
            for key in keys
            if key in self.cells.expressions
            for node in ast.walk(ast.parse(self.cells.expressions[key]))
            if isinstance(node, ast.Name)
        }

    def go(self):
        random.seed(0)
        np.random.seed(0)  # noqa: NPY002  (a submission may use the old generator)
        self._limited(self._look)
        for number, cell in enumerate(self.cells.code):
            self._cell(number, cell)
            if number == self.cells.last_for(self.book.only):
                break
        self._tell()
        for key in self._unheard():
            self._fallback(key)

    def _unheard(self):
        """The exercises of whose answers nothing was noted: there is no place for them, or a check
        stopped, since its cell stands above the one that was run before it.
        """
        gone = {key for n in self.request["skip"] for key in self._answered_in(n)}
        return [key for key in self.cells.expressions if key not in {*self.book.noted, *gone}]

    def _answered_in(self, number):
        return self.cells.code[number].answers if number < len(self.cells.code) else ()

    def _cell(self, number, cell):
        self.begun.append({"cell": number, "ids": cell.ids})
        self.book.cell = number
        if number in self.request["skip"] or number in self.shown:
            return
        self._tell()
        name = f"<cell {number + 1}>"
        Absent.used.clear()
        outcome = self._limited(lambda: run_cell(cell.source, name, self.space, self.showing))
        self.book.send_last()
        if outcome:
            line = {"cell": number, "ended": outcome[0], "message": outcome[1], "ids": cell.ids}
            self.send(line | {"absent": bool(Absent.used)})
        for key in cell.answers:
            if key not in self.book.noted_in(number):
                self._fallback(key)

    def _tell(self):
        """Send which cells have begun: those that are passed over with the next that runs, since
        whoever hears it is woken each time.
        """
        self.send(*self.begun)
        self.begun.clear()

    def _fallback(self, key):
        """The answer of an exercise whose check is missing or broken: what the handed-out check
        would have been given.
        """
        self._limited(lambda: self.book.note(key, eval(self.cells.expressions[key], self.space)))

    def _limited(self, act):
        return limited(act, self.request["cell_seconds"])
