"""Asks a program in the cage and hears its answers; nothing that it says is trusted."""

import contextlib
import json
import select
import signal
import socket
import time
from collections.abc import Iterable, Iterator, Mapping
from itertools import accumulate
from typing import Any

__all__ = ["Talk"]

MOST = 200_000  # bytes of one answer
AHEAD = 60_000  # bytes of questions that wait; a socket holds more


class Talk:
    """A talk with one program.

    ``stopped``: empty, "timed out" or "crashed"; ``seconds`` of processor, once it is over.
    """

    def __init__(self, channel: socket.socket, most: float, seconds: float) -> None:
        self._channel, self._most = channel, most
        self._deadline = time.monotonic() + seconds
        self._rest = b""
        self.late = False
        self.status: int | None = None
        self.seconds = 0.0
        self.first: list[dict[str, Any]] = []  # what it said before it was asked

    @property
    def stopped(self) -> str:
        """How it ended, when it did not answer: "timed out" or "crashed"."""
        return "timed out" if self.late or self.status == -signal.SIGXCPU else "crashed"

    def hear(self) -> dict[str, Any] | None:
        """What it says next, which at first is whether there is a program; None when it says
        nothing.
        """
        with contextlib.suppress(OSError, ValueError, RecursionError):
            found = json.loads(self._line(min(time.monotonic() + self._most, self._deadline)))
            if isinstance(found, dict):
                self.first = self.first or [found]
                return found
        return None

    def ask(self, questions: Iterable[Mapping[str, Any]]) -> Iterator[dict[str, Any] | None]:
        """What it says to each question, in their order, as long as these are values.

        They are handed over together, which spares both sides a wait for each; as many as its end
        holds, so that neither waits for the other.
        """
        asked = [json.dumps(question).encode() + b"\n" for question in questions]
        while asked:
            count = 1 + sum(size <= AHEAD for size in accumulate(map(len, asked[1:])))
            with contextlib.suppress(OSError):
                self._channel.sendall(b"".join(asked[:count]))
            for _ in range(count):
                line = self.hear()
                yield line
                if line is None or "value" not in line:
                    return
            del asked[:count]

    def _line(self, deadline):
        while b"\n" not in self._rest:
            left = deadline - time.monotonic()
            if left <= 0 or not select.select([self._channel], [], [], left)[0]:
                self.late = True
                return b""
            data = self._channel.recv(1 << 16)
            if not data or len(self._rest) > MOST:
                return b""
            self._rest += data
        line, _, self._rest = self._rest.partition(b"\n")
        return line
