"""What the warm parent is started with: its command, its user and what it may read."""

import json
import os
import shutil
from dataclasses import asdict

from ..settings import Limits
from . import stage
from .folder import readable_by_others
from .sight import OWN, hidden, kept, packages, packages_of_others, readable_without

__all__ = ["launch"]

ALWAYS_WARM = tuple(
    "dhlab dhlab.course dhlab.view numpy.random numpy.typing heapq encodings.utf_8_sig".split()
)


def launch(
    level: str, limits: Limits, room: str, staged: str, work: str, control: int, proc: bool
) -> tuple[list[str], dict[str, str]]:
    """The command that starts the warm parent, and its environment.

    Parameters
    ----------
    level : str
    limits : Limits
    room : "open" or "own"
    staged, work : str
        The folders with the library, and that can be written to.
    control : int
        The open socket that the grader speaks through.
    proc : bool
        Whether bubblewrap gives it a /proc.
    """
    bubblewrap = level == "bubblewrap"
    root = os.geteuid() == 0
    user = (
        (2_000_000_000 + os.getpid() % 1_000_000)
        if root and (bubblewrap or readable_by_others())
        else None
    )
    own_user = user is not None or bubblewrap
    config = {
        "control": control,
        "level": level,
        "work": "/tmp" if bubblewrap else work,
        "user": user,
        "own_processes": bubblewrap,
        "warm": ALWAYS_WARM,
        "limits": asdict(limits) | {"own_user": own_user},
        "readable": ([*readable_without(_covered(room)), staged] if level == "landlock" else []),
    }
    command = stage.python_command(stage.INSIDE if bubblewrap else staged, json.dumps(config))
    if bubblewrap:
        return (
            stage.bubblewrap_command(
                shutil.which("bwrap") or "bwrap", staged, command, limits, proc, room
            ),
            {},
        )
    return command, stage.environment(work)


def _covered(room):
    """What Landlock must not let anybody read."""
    seen = set(kept())
    foreign = [
        entry.path
        for folder in (packages() if room == OWN else ())
        for entry in os.scandir(folder)
        if entry.path not in seen
    ]
    return [*hidden(), *foreign, *(packages_of_others() if room == OWN else ())]
