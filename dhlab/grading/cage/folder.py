"""The folder of a cage: what is staged, and what a submission may write. It goes when the grader
goes, however that ends.
"""

import contextlib
import os
import shutil
import subprocess
import sys
import tempfile

from .sight import packages

__all__ = ["Folder", "readable_by_others"]

PREFIX = "dhlab-cage-"
# waits until the other end of its input closes, which happens also when the grader is killed
CLEARING = 'read _; chmod -R u+rwx -- "$1" 2>/dev/null; rm -rf -- "$1"'


class Folder:
    """A new folder, with ``staged`` and ``work`` in it."""

    def __init__(self) -> None:
        self.path = tempfile.mkdtemp(prefix=PREFIX)
        self.staged, self.work = (os.path.join(self.path, name) for name in ("staged", "work"))
        for folder in (self.staged, self.work):
            os.mkdir(folder)
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
