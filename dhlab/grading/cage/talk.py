"""Asks a program in the cage, one call at a time, and hears its answers; nothing that it says is
trusted.
"""

import contextlib
import json
import select
import signal
import socket
import time
from collections.abc import Mapping
from typing import Any

__all__ = ["Talk"]

MOST = 200_000  # bytes of one answer


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

    def ask(self, question: Mapping[str, Any] | None = None) -> dict[str, Any] | None:
        """The answer to a question, or to none, which is how a talk begins; None when there is no
        answer.
        """
        with contextlib.suppress(OSError):
            if question is not None:
                self._channel.sendall(json.dumps(question).encode() + b"\n")
            line = self._line(min(time.monotonic() + self._most, self._deadline))
            with contextlib.suppress(ValueError, RecursionError):
                found = json.loads(line)
                if not isinstance(found, dict):
                    return None
                if question is None:
                    self.first.append(found)
                return found
        return None

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
