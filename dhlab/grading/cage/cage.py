"""The cage: a warm parent behind bars, from which each submission is forked; what comes out is
lines of JSON, and a word on how it ended.
"""

import contextlib
import json
import os
import signal
import socket
import subprocess
import tempfile
import time
from collections.abc import Iterable, Iterator, Mapping
from typing import Any, Self

from ..inside.clock import IDLE, WAIT
from ..settings import Limits
from . import stage
from .folder import Folder, staged
from .launch import launch
from .listener import Listener, Run, used
from .sight import OPEN
from .talk import Talk

try:
    import fcntl
except ImportError:  # Windows, where check_system says what to do
    fcntl = None  # type: ignore[assignment]

__all__ = ["Cage", "check_system"]

AS_NEEDED = ("dhlab.grading.inside.reading.magics",)
START = 60  # seconds to load the libraries
GRACE = 5  # seconds after a cell's own limit until it is stopped from outside


class Cage:
    """Runs notebooks, one after the other; a context manager.

    ``learnt``: whether the last one had to load what is loaded for those after it.

    Parameters
    ----------
    level : "bubblewrap", "landlock", "rlimits" or None
        None: bubblewrap; the others are weaker and must be asked for.
    limits : Limits
    warm : sequence of str
        Modules that are loaded once, for all, as soon as one submission has loaded them.
    room : "open" or "own"
        With the library, or without any kinematics.
    lessons : sequence of str
        Cells that most notebooks hold unchanged, to be read once, for all.

    Raises
    ------
    ValueError
        The level does not work on this machine.
    """

    def __init__(
        self,
        level: str | None = None,
        limits: Limits = Limits(),
        warm: Iterable[str] = (),
        room: str = OPEN,
        lessons: Iterable[str] = (),
    ) -> None:
        check_system()
        self.level, self.limits = level or "bubblewrap", limits
        self.warm = frozenset({*AS_NEEDED, *warm})
        self.room, self.lessons = room, tuple(lessons)
        # of the modules to be warm: those that submissions loaded, and those that are warm by now
        self._used: set[str] = set()
        self._loaded: set[str] = set()
        self.learnt = False
        # all three None while nothing runs
        self._process: Any = None
        self._folder: Any = None
        self._control: Any = None
        try:
            self._start()
        except ValueError:
            if level is not None:
                raise
            raise ValueError(
                "grade: expected bubblewrap, in which submissions run closed in, found that it does"
                " not work here; install it (apt install bubblewrap), or, where you know what a"
                " submission could then do, name a weaker cage: --cage landlock or --cage rlimits"
            ) from None

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()

    def run(self, request: Mapping[str, Any], notebook: bytes, seconds: float) -> Run:
        """Run a notebook once.

        Parameters
        ----------
        request : dict
            See :func:`dhlab.grading.judging.questions.request`.
        notebook : bytes
        seconds : float
            Of processor, for all of it; on the wall's clock it may take ``clock.WAIT`` times that.

        Returns
        -------
        Run
        """
        answers, write_end = os.pipe()
        begun = time.monotonic()
        try:
            self._send(request, notebook, write_end)
            run = Listener(
                answers, WAIT * request["cell_seconds"] + GRACE, begun + WAIT * seconds
            ).listen()
            self._learn(run.lines[-1:])
            status, seconds = self._finish()
            run.seconds = _counted(seconds, begun)
            if status == -signal.SIGXCPU:
                run.ended = "timed out"
        except OSError:  # the whole cage has died; the next run builds another
            run = Run()
            run.seconds = time.monotonic() - begun
            self.close()
        except BaseException:
            self.close()  # its parent waits for the end of this one, and would take the next for it
            raise
        finally:
            os.close(answers)
        return run

    @contextlib.contextmanager
    def talk(self, request: Mapping[str, Any], notebook: bytes, seconds: float) -> Iterator[Talk]:
        """Talk with one program of a notebook: what ``with`` gives asks it, call after call.

        Parameters
        ----------
        request : dict
            See :func:`dhlab.grading.judging.questions.call_request`.
        notebook : bytes
        seconds : float
            Of processor, for all of it.
        """
        ours, theirs = socket.socketpair()
        talk = Talk(ours, WAIT * request["cell_seconds"] + GRACE, WAIT * seconds)
        begun = time.monotonic()
        try:
            self._send(request, notebook, theirs.detach())
            yield talk
            self._learn(talk.first)
            talk.status, seconds = self._finish()
            talk.seconds = _counted(seconds, begun)
        except OSError:
            talk.seconds = time.monotonic() - begun
            self.close()
        except BaseException:  # as in run
            self.close()
            raise
        finally:
            ours.close()

    def _learn(self, lines):
        """Keep in mind which modules a submission has loaded."""
        found = used(lines, self.warm)
        self.learnt = not found <= self._used
        self._used |= found

    def _send(self, request, notebook, channel):
        """Hand a notebook and an open file for the answers to the warm parent."""
        if self._process is None:
            self._start()
        try:
            with tempfile.TemporaryFile() as file:
                file.write(json.dumps(request).encode() + b"\n" + notebook)
                file.flush()
                file.seek(0)
                wanted = json.dumps(sorted(self._used - self._loaded)).encode()
                socket.send_fds(self._control, [wanted], [file.fileno(), channel])
                self._loaded |= self._used
        finally:
            os.close(channel)

    def _finish(self):
        """Let the warm parent kill what is left and clean up; where it cannot, build a new one.
        How the submission ended, and the seconds of processor that it took.
        """
        self._control.settimeout(10)
        self._control.sendall(b"x")
        answer = json.loads(self._control.recv(1000) or b"{}")
        if not answer.get("clean"):
            self.close()
        return answer.get("status"), answer.get("seconds", 0.0)

    def _start(self):
        problem = self._try(proc=True)
        if "proc" in problem and self.level == "bubblewrap":
            problem = self._try(proc=False)
        if problem:
            raise ValueError(
                f"grade: expected the cage {self.level!r} to work here, found that it does not"
                f" ({problem}); choose another, or leave it out for the best there is"
            )

    def _try(self, proc):
        """Start the warm parent; empty when it is ready, otherwise what is wrong."""
        self._folder = Folder()
        self._loaded = set()
        seen = self._seen()
        self._control, theirs = socket.socketpair()
        with theirs, open(os.path.join(self._folder.path, "errors"), "wb") as errors:
            command, environment = launch(
                self.level, self.limits, self.room, seen, self._folder.work, theirs.fileno(), proc
            )
            try:
                self._process = subprocess.Popen(
                    command,
                    pass_fds=[theirs.fileno()],
                    env=environment,
                    stdin=subprocess.DEVNULL,
                    stdout=subprocess.DEVNULL,
                    stderr=errors,
                    start_new_session=True,
                    cwd="/",
                )
            except FileNotFoundError:
                errors.write(b"it is not installed")
        problem = self._greeting()
        if problem:
            self.close()
        return problem

    def _seen(self):
        """The folder with the library; without walls, where it might be written to, one's own."""
        if self.level != "rlimits":
            return staged(self.room)
        own = os.path.join(self._folder.path, "staged")
        os.mkdir(own)
        stage.stage(own, self.room)
        return own

    def _greeting(self):
        """Empty when the warm parent is ready, otherwise what it says, or what Python printed."""
        self._control.settimeout(START)
        try:
            self._control.sendall(json.dumps(self.lessons).encode() + b"\n")
            answer = json.loads(self._control.recv(10_000) or b"{}")
        except (TimeoutError, ValueError, OSError):
            answer = {}
        if answer.get("ready"):
            return ""
        with open(
            os.path.join(self._folder.path, "errors"), encoding="utf-8", errors="replace"
        ) as file:
            return (
                answer.get("problem") or " ".join(file.read().split())[-200:] or "it does not start"
            )

    def close(self) -> None:
        """Kill everything in the cage and remove its folder."""
        if self._control is not None:
            with contextlib.suppress(OSError):
                self._control.close()
        if self._process is not None:
            self._process.kill()
            self._process.wait()
        if self._folder is not None:
            self._folder.remove()
        self._process = self._folder = self._control = None


def _counted(seconds, begun):
    """What a run takes of the time that there is: seconds of processor, and of those on the wall's
    clock a part, so that sleeping comes to an end too; of one that did nothing else half of them.
    """
    passed = time.monotonic() - begun
    return max(seconds, passed / (2 if seconds < IDLE * passed else WAIT))


def check_system() -> None:
    """ValueError where no level can work."""
    if fcntl is None:
        raise ValueError(
            "grade: expected Linux or macOS, found a system that cannot run submissions apart; on"
            " Windows use the Windows Subsystem for Linux"
        )
