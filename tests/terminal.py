"""``dhlab`` as typed in a terminal, in this process: to start Python anew for each of some hundred
calls would take longer than all of what is called.
"""

import contextlib
import io
import sys
from dataclasses import dataclass

from dhlab.cli.app import main

__all__ = ["Done", "dhlab"]


@dataclass(frozen=True)
class Done:
    """The exit status and what was printed."""

    returncode: int
    stdout: str
    stderr: str


def dhlab(*arguments, cwd=".", typed=""):
    """What ``dhlab …`` does in a folder, with ``typed`` on its standard input."""
    out, err = (io.TextIOWrapper(io.BytesIO(), "utf-8", write_through=True) for _ in range(2))
    before = sys.argv, sys.stdin
    sys.argv = ["dhlab", *map(str, arguments)]
    sys.stdin = io.TextIOWrapper(io.BytesIO(typed.encode()), "utf-8")
    status = 0
    try:
        with (
            contextlib.chdir(cwd),
            contextlib.redirect_stdout(out),
            contextlib.redirect_stderr(err),
        ):
            main()
    except SystemExit as end:
        status = end.code or 0
    finally:
        sys.argv, sys.stdin = before
    return Done(status, *(stream.buffer.getvalue().decode() for stream in (out, err)))
