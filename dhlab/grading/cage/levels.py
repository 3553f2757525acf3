"""How strong a cage is, and the strongest that works here.

Three levels; the first unless another is named, since a mark needs walls that hold:

- **bubblewrap**: its own file system, network, processes and user, with seccomp and limits on top;
- **landlock**: the same user and processes as the grader, but files restricted by Landlock, calls
  by seccomp, with limits; its files together are counted every few hundredths of a second;
- **rlimits**: limits of memory, time and files only. A submission could read what the teacher can
  read. Said in every report.
"""

import contextlib
import shutil
import sys
from collections.abc import Callable

from ..settings import LEVELS
from .cage import Cage, check_system

__all__ = ["RISKS", "best_level"]

RISKS = {
    "bubblewrap": (
        "bubblewrap: submissions see no network, no files but Python's, no processes but their own"
    ),
    "landlock": (
        "Landlock with seccomp: submissions read no files but Python's and the system's, reach no"
        " network, start no program"
    ),
    "rlimits": (
        "limits only, since neither bubblewrap nor Landlock works here: a hostile submission could"
        " read the teacher's files and use the network; grade only people you trust, or install"
        " bubblewrap"
    ),
}


def _start_one(level):
    with Cage(level):
        pass


def best_level(start: Callable[[str], object] = _start_one) -> str:
    """The strongest level that works here, found by trying: ``start`` raises ValueError where one
    does not. ValueError where there is none.
    """
    check_system()
    for level in LEVELS:
        if (level == "bubblewrap" and not shutil.which("bwrap")) or (
            level == "landlock" and not sys.platform.startswith("linux")
        ):
            continue
        with contextlib.suppress(ValueError):
            start(level)
            return level
    raise ValueError(
        "grade: expected a way to run submissions with limits, found none that works on this"
        " machine; is it Linux or macOS?"
    )
