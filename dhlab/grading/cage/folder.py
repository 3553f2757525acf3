"""The folders of cages: the library as a room sees it, and what a submission may write. They go
when the grader goes, however that ends.
"""

import contextlib
import os
import shutil
import subprocess
import sys
import tempfile
from multiprocessing import util

from . import stage
from .sight import packages

__all__ = ["Folder", "readable_by_others", "staged"]

PREFIX = "dhlab-cage-"
# waits until the other end of its input closes, which happens also when the grader is killed
CLEARING = 'read _; chmod -R u+rwx -- "$1" 2>/dev/null; rm -rf -- "$1"'


_staged: dict[str, "Folder"] = {}


def staged(room: str) -> str:
    """A folder with the library as a room sees it, made once in this process, for all cages in
    which nobody can write to it.
    """
    if room not in _staged or not os.path.isdir(_staged[room].work):
        folder = Folder()
        util.Finalize(None, folder.remove, exitpriority=0)
        stage.stage(folder.work, room)
        _staged[room] = folder
    return _staged[room].work


class Folder:
    """A new folder, with ``work`` in it."""

    def __init__(self) -> None:
        self.path = tempfile.mkdtemp(prefix=PREFIX)
        self.work = os.path.join(self.path, "work")
        os.mkdir(self.work)
        os.chmod(self.path, 0o711)
        self._clearing = subprocess.Popen(
            ["/bin/sh", "-c", CLEARING, "clearing", self.path],
            stdin=subprocess.PIPE,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            start_new_session=True,
            cwd="/",
        )

    def remove(self) -> None:
        """Remove it, now."""
        if self._clearing.stdin:
            self._clearing.stdin.close()
        with contextlib.suppress(subprocess.TimeoutExpired):
            self._clearing.wait(10)
        shutil.rmtree(self.path, ignore_errors=True)


def readable_by_others() -> bool:
    """Whether another user could read Python and its packages; not where they stand in root's own
    folders.
    """
    paths = [
        os.path.realpath(path)
        for path in (sys.base_prefix, sys.prefix, *packages(), tempfile.gettempdir())
    ]
    folders = {
        path[:i] or "/"
        for path in paths
        for i in range(len(path) + 1)
        if i == len(path) or path[i] == "/"
    }
    return all(
        os.stat(folder).st_mode & 0o005 == 0o005 for folder in folders if os.path.isdir(folder)
    )
