"""One program of a student, called. It runs here with only the statements that it depends on, or
with the ``whole`` notebook, for which the lesson's own cells run where it needs them; arguments
arrive one call at a time from outside, answers leave as plain numbers.

Where the task is to write kinematics, this room has none: ``stand_in/own.py`` stands in for dhlab.
"""

import ast
import json
import marshal
import os
import random
import sys
import types
from base64 import b64decode
from collections.abc import Collection
from typing import Any

import numpy as np

from .calling import Fault, call, fits, is_stub, quiet
from .clock import limited
from .made import matrices_made
from .precision import says_single
from .reading import notebook as notebooks
from .reading.demonstrations import print_of
from .reading.slices import UNREADABLE, Statement, needed, statements
from .shell import Absent, run_statement
from .space import loaded, space
from .wire import decode, encode, unpack

__all__ = ["answer"]


def answer(request: dict[str, Any], raw: bytes, channel: int, warm: Collection[str]) -> None:
    """Find the program that a notebook hands in for an exercise, say whether there is one, then
    answer call after call until nobody asks any more.
    """
    room = _Room(request, notebooks.read(raw, request["checks"]))
    line = room.begin() | {"loaded": loaded(warm)}
    with os.fdopen(channel, "rb", buffering=0, closefd=False) as asked, quiet():
        while line is not None:
            data = json.dumps(line | room.missed()).encode() + b"\n"
            while data:
                data = data[os.write(channel, data) :]
            if "ready" not in line and "value" not in line:
                return
            question = _line(asked)
            line = room.call(question) if question else None


def _line(file):
    found = b""
    while not found.endswith(b"\n"):
        more = file.read(1 << 16)
        if not more:
            return None
        found += more
    return json.loads(found)


class _Room:
    def __init__(self, request, cells):
        self.request, self.cells, self.key = request, cells, request["call"]
        self.given = {key: decode(value) for key, value in request["given"].items()}
        self.seconds = request["cell_seconds"]
        self.noted = None
        self.function = None
        self.made_of: list[Statement] = []

    def note(self, key, answer):
        """What ``check`` is called for: the last one counts."""
        if key == self.key:
            self.noted = answer

    def missed(self):
        """Which parts of dhlab and which packages were asked for and are not here, where any were;
        after each call it begins anew.
        """
        # of the module itself: where all of dhlab is, it would look for a part of that name
        closed: set[str] = vars(sys.modules["dhlab"]).get("asked", set())
        if not closed and not Absent.used:
            return {}
        found = {"closed": sorted(closed)[:20], "absent": sorted(Absent.used)[:20]}
        closed.clear()
        Absent.used.clear()
        return found

    def begin(self):
        """Run what the program depends on; a line that says how that went."""
        if self.request["transform"]:
            _install_transform(self.request["transform"])
        random.seed(0)
        np.random.seed(0)  # noqa: NPY002  (a submission may use the old generator)
        names = space(self)
        ended = limited(lambda: self._make(names), self.seconds)
        if ended and ended[0] == "timed out":
            return {"stopped": "timed out"}
        found = self.noted
        if not callable(found):
            return {"nothing": 1}
        if is_stub(found):
            return {"stub": 1}
        if not fits(found, self.request["names"]):
            return {"fault": {"kind": "signature"}}
        self.function = found
        single = says_single([one.node for one in self.made_of], names)
        if self.request["whole"]:  # what other cells asked for is not told of this program
            self.missed()
        return {"ready": 1, "single": single}

    def _make(self, names):
        self.made_of = self._statements()
        for one in self.made_of:
            try:
                run_statement(one.node, f"<cell {one.cell + 1}>", names)
            except (Exception, SystemExit, KeyboardInterrupt):
                continue  # a cell that stops: the notebook itself has told of it
        if self.noted is None:
            self.noted = eval(self.cells.expressions[self.key], names)

    def _statements(self):
        """Those that make the program, up to the check that it was handed to."""
        found: list[Statement] = []
        last = self.request["cell"]
        for number, cell in enumerate(self.cells.code[: last + 1]):
            if number not in self.request["skip"]:
                found += statements(number, cell.source) or ()
        checks = [one for one in found if one.cell == last and "check" in one.reads]
        checks = [one for one in checks if self._asks(one.node)] or checks
        while checks and found[-1] is not checks[-1]:
            found.pop()
        wanted = {
            node.id
            for node in ast.walk(ast.parse(self.cells.expressions.get(self.key, "0")))
            if isinstance(node, ast.Name)
        }
        kept = self._own(found) if self.request["whole"] else checks
        for one in kept:
            wanted |= one.reads
        taken = {id(one) for one in (*needed(found, wanted), *kept)}
        return [one for one in found if id(one) in taken]

    def _own(self, found):
        """All that the student wrote, without the cells that the lesson handed out; with these too
        where what the student wrote does not show what it reads, as ``globals()`` does not.
        """
        untouched = set(self.request["untouched"])
        lesson = {
            number
            for number, cell in enumerate(self.cells.code)
            if print_of(cell.source) in untouched
        }
        own = [one for one in found if one.cell not in lesson]
        return found if any(one.reads & UNREADABLE for one in own) else own

    def _asks(self, node):
        return any(
            isinstance(inner, ast.Constant) and inner.value == self.key for inner in ast.walk(node)
        )

    def call(self, question):
        """The answer to one call, made plain before the clock stops."""
        case = tuple(unpack(value) for value in question["case"])
        line: dict[str, Any] = {"stopped": "timed out"}

        def act():
            nonlocal line
            try:
                found = call(self.function, case)
                absent = isinstance(found, Absent)
                line = {"fault": {"kind": "absent"}} if absent else {"value": encode(found)}
                if question.get("watched"):
                    line["made"] = self._made(case)
            except Fault as fault:
                error = type(fault.error).__name__
                line = {"fault": {"kind": fault.kind, "error": error, "line": fault.line}}
            except NotImplementedError:
                line = {"stub": 1}

        ended = limited(act, self.seconds)
        return {"stopped": "timed out"} if ended else line

    def _made(self, case):
        """How many functions make matrices for the program; none where it stops this time."""
        try:
            return len(matrices_made(self.function, case))
        except (Exception, SystemExit):
            return 0


def _install_transform(code):
    import dhlab

    module = types.ModuleType("dhlab.transform")
    exec(marshal.loads(b64decode(code)), module.__dict__)
    sys.modules["dhlab.transform"] = dhlab.transform = module
