"""What a submission leaves behind, its processes and its files, taken away."""

import contextlib
import os
import signal
import time

__all__ = ["end", "clean"]

CLEANING = 5  # seconds; who leaves more behind costs a new cage


def end(child: int, own_processes: bool) -> tuple[int | None, float]:
    """Kill what is left of a submission, all of it. How its first process ended, an exit status or
    minus a signal, and the seconds of processor that it took. ``own_processes``: whether nothing
    else is in this namespace.
    """
    status, seconds = None, 0.0
    for _ in range(500):
        if own_processes:
            with contextlib.suppress(ProcessLookupError):
                # everything in this namespace but this process, which is the first
                os.kill(-1, signal.SIGKILL)
        else:
            for process in {child, *_descendants()} if status is None else _descendants():
                with contextlib.suppress(ProcessLookupError, PermissionError):
                    os.kill(process, signal.SIGKILL)
        try:
            process, ended, usage = os.wait4(-1, os.WNOHANG)
        except ChildProcessError:
            break
        if process == child:
            status = os.waitstatus_to_exitcode(ended)
            seconds = usage.ru_utime + usage.ru_stime
        if process == 0:
            time.sleep(0.001)
    return status, seconds


def _descendants():
    """Every process below this one, from /proc; those that lost their parents have been given to
    this one.

    Behind Landlock /proc cannot be read, and need not be: seccomp lets nobody start a process.
    """
    parents = {}
    try:
        names = os.listdir("/proc")
    except OSError:
        return set()
    for name in names:
        if name.isdigit():
            with (
                contextlib.suppress(OSError, IndexError, ValueError),
                open(f"/proc/{name}/stat", encoding="utf-8", errors="replace") as file,
            ):
                parents[int(name)] = int(file.read().rpartition(")")[2].split()[1])
    found = {os.getpid()}
    while more := {
        process for process, parent in parents.items() if parent in found and process not in found
    }:
        found |= more
    return found - {os.getpid()}


def clean(work: str, kept: set[str]) -> bool:
    """Empty the folder that submissions may write to; False when something stays, and the whole
    cage has to go.

    Folders are taken apart where they lie, so that depth costs nothing: what is in one is moved to
    the top, and the empty one removed.
    """
    number, until = 0, time.monotonic() + CLEANING
    while (left := set(os.listdir(work)) - kept) and time.monotonic() < until:
        for name in left:
            path = os.path.join(work, name)
            try:
                if os.path.islink(path) or not os.path.isdir(path):
                    os.unlink(path)
                    continue
                os.chmod(path, 0o700)
                for inner in os.listdir(path):
                    number += 1
                    os.rename(
                        os.path.join(path, inner), os.path.join(work, f".{number}-{name}"[:60])
                    )
                os.rmdir(path)
            except OSError:
                return False
    return set(os.listdir(work)) <= kept
