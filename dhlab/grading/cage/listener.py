"""Hears what a submission sends out of the cage, and when it has gone on for too long."""

import contextlib
import json
import os
import select
import time
from collections.abc import Collection, Iterable
from dataclasses import dataclass, field
from typing import Any

__all__ = ["Listener", "Run", "used"]


MOST = 3_000_000  # bytes that one submission may answer


@dataclass
class Run:
    """One run of a notebook: the lines it sent; how it ended ("done", "crashed", "timed out", "too
    much"); the cell it was in; the seconds it used up.
    """

    lines: list[dict[str, Any]] = field(default_factory=list)
    ended: str = "crashed"
    cell: int | None = None
    seconds: float = 0.0


def used(lines: Iterable[dict[str, Any]], known: Collection[str]) -> set[str]:
    """The modules that a submission says it has loaded, of those that are known: what it says may
    be made up, and a list of which each may be loaded is all that it can choose from.

    Examples
    --------
    >>> used([{"loaded": ["scipy", "sympy.tests", 3, []]}, {"done": ""}], {"scipy", "sympy"})
    {'scipy'}
    """
    said = [line["loaded"] for line in lines if isinstance(line.get("loaded"), list)]
    return {name for found in said for name in found if isinstance(name, str) and name in known}


class Listener:
    """Reads lines until the submission is done, dies, says too much, or is too late in a cell or in
    all.
    """

    def __init__(self, pipe: int, cell_seconds: float, deadline: float) -> None:
        self.pipe, self.cell_seconds, self.deadline = pipe, cell_seconds, deadline
        self.run, self.read, self.rest = Run(), 0, b""

    def listen(self) -> Run:
        cell_deadline = time.monotonic() + self.cell_seconds + 5  # reading the notebook
        while True:
            left = min(cell_deadline, self.deadline) - time.monotonic()
            if left <= 0 or not select.select([self.pipe], [], [], left)[0]:
                return self._over("timed out")
            data = os.read(self.pipe, 1 << 16)
            self.read += len(data)
            if not data or self.read > MOST:
                return self._over("too much" if data else "crashed")
            for line in self._lines(data):
                self.run.lines.append(line)
                if "done" in line or "unreadable" in line:
                    return self._over("done")
                if (
                    "cell" in line
                    and "ids" in line
                    and "ended" not in line
                    and isinstance(line["cell"], int)
                ):
                    self.run.cell = line["cell"]
                    cell_deadline = time.monotonic() + self.cell_seconds

    def _lines(self, data):
        *whole, self.rest = (self.rest + data).split(b"\n")
        for raw in whole:
            with contextlib.suppress(ValueError, RecursionError):
                line = json.loads(raw)
                if b"\\ud" in raw:  # perhaps half a letter, which no file can hold
                    text = json.dumps(line, ensure_ascii=False)
                    line = json.loads(text.encode("utf-8", "replace"))
                if isinstance(line, dict):
                    yield line

    def _over(self, ended):
        self.run.ended = ended
        return self.run
