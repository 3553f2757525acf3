"""What the cage sees of this machine: the library without the course's answers, Python and its
packages; and the command that locks it in.
"""

import json
import os
import re
import shutil
import sys
from collections.abc import Sequence
from functools import cache
from pathlib import Path

from ..settings import Limits
from .sight import OPEN, OWN, PACKAGE, SYSTEM, hidden, kept, packages, packages_of_others, readable

__all__ = ["library", "stage", "python_command", "bubblewrap_command", "environment"]

STAND_IN = PACKAGE / "grading" / "inside" / "stand_in"
NOT_STAGED = "course", "grading", "lessons", "teacher", "view", "cli"
LEFT_OUT = shutil.ignore_patterns(*NOT_STAGED, "*.tmp")
KEPT = ("units.py", "checks.py", "table.py")  # of the library, in the second
# of the course: what lessons call and what holds no exercise
FREE_OF_ANSWERS = ("othersolvers.py", "simulator.py")
PROGRAMS = PACKAGE / "doctor" / "programs"
# how a learner's function is called, Python's errors, and how it comes to its answers
CALLING = (
    *("running/calling.py", "running/stops.py", "running/watched.py", "running/made.py"),
    "source/precision.py",
)
LOADED = re.compile(r'dh\.load\(\\?"([\w.-]+)\\?"\)')
COMPILED = "kernel_"  # of dhlab.fast: compiled when it is loaded, for many seconds, and off here
NEEDED = re.compile(r"^\s*(?:import|from)\s+((?:scipy|sympy)[\w.]*)", re.MULTILINE)
INSIDE = "/cage"  # where the staged library stands inside bubblewrap
BLAS = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS")


def stage(folder: str, room: str = OPEN) -> None:
    """Copy the library into a folder: no exercises, no grader; a course that only notes, pictures
    that are not drawn; in the room ``OWN`` no kinematics either.
    """
    target = Path(folder) / "dhlab"
    if room == OPEN:
        shutil.copytree(PACKAGE, target, ignore=LEFT_OUT)
    else:
        target.mkdir()
        for name in KEPT:
            shutil.copy2(PACKAGE / name, target)
        shutil.copy2(STAND_IN / "own.py", target / "__init__.py")
        (target / "arms.json").write_text(json.dumps(_arms()), encoding="utf-8")
    (target / "grading").mkdir()
    (target / "grading" / "__init__.py").touch()
    shutil.copytree(
        PACKAGE / "grading" / "inside",
        target / "grading" / "inside",
        ignore=shutil.ignore_patterns("stand_in"),
    )
    for name in CALLING:
        shutil.copy2(PROGRAMS / name, target / "grading" / "inside")
    for name in ("course", "view"):
        (target / name).mkdir()
        shutil.copy2(STAND_IN / f"{name}.py", target / name / "__init__.py")
    (target / "course" / "session.py").write_text("from . import *\n", encoding="utf-8")
    for name in FREE_OF_ANSWERS if room == OPEN else ():
        if (PACKAGE / "course" / name).exists():
            shutil.copy2(PACKAGE / "course" / name, target / "course")
    for path in (Path(folder), *Path(folder).rglob("*")):
        path.chmod(0o755 if path.is_dir() else 0o644)


@cache
def library() -> tuple[str, ...]:
    """The modules of the library that are copied into the room ``OPEN``, and what they load of
    ``NEEDED``.

    Examples
    --------
    >>> {"dhlab.geometry.equivalence", "scipy.optimize", "dhlab.course.check"} - {*library()}
    {'dhlab.course.check'}
    """
    found = set()
    for path in PACKAGE.rglob("*.py"):
        parts = path.relative_to(PACKAGE.parent).with_suffix("").parts
        if not {*NOT_STAGED, "__main__"} & {*parts} and not path.stem.startswith(COMPILED):
            found.add(".".join(parts).removesuffix(".__init__"))
            found |= set(NEEDED.findall(path.read_text(encoding="utf-8")))
    return tuple(sorted(found))


@cache
def _arms():
    """The arms that lessons load, as data."""
    from ...course.workspace import handed_out
    from ...robots import load, robots

    text = "".join(path.read_text(encoding="utf-8") for path in handed_out().glob("*.ipynb"))
    named = {name for name in LOADED.findall(text) if name.partition(".")[0] in robots()}
    return {name: _data(load(name)) for name in sorted(named)}


def _data(arm):
    return {
        "convention": arm.table.convention,
        "rows": arm.table.rows.tolist(),
        "joints": str(arm.table.joints),
        "base": arm.base.tolist(),
        "tool": arm.tool.tolist(),
        "sign": arm.sign.tolist(),
    }


def python_command(folder: str, config: str) -> list[str]:
    """The command that starts the warm parent: no start-up files, nothing of the user's, the staged
    library first.
    """
    path = [folder, *packages()]
    start = (
        f"import sys; sys.path[:0] = {path!r}; sys.argv = ['cage', {config!r}]; from"
        " dhlab.grading.inside.warming.zygote import main; main()"
    )
    return [os.path.abspath(sys.executable), "-s", "-S", "-P", "-c", start]


def environment(work: str) -> dict[str, str]:
    """All that the cage knows of the environment."""
    return {
        "PATH": "/usr/bin:/bin",
        "HOME": work,
        "TMPDIR": work,
        "LANG": "C.UTF-8",
        "MPLBACKEND": "Agg",
        "MPLCONFIGDIR": work,
        "IPYTHONDIR": work,
        "PYTHONHASHSEED": "0",
        "PYTHONDONTWRITEBYTECODE": "1",
        "PYDEVD_DISABLE_FILE_VALIDATION": "1",
        "DHLAB_NUMBA": "0",  # nothing is compiled for a notebook that runs once
        **dict.fromkeys(BLAS, "1"),
    }


def bubblewrap_command(
    program: str, folder: str, command: Sequence[str], limits: Limits, proc: bool, room: str
) -> list[str]:
    """``command`` inside bubblewrap: its own processes, users, network and files; one small folder,
    /tmp, that can be written to.

    As root another user is taken inside, for which the two capabilities are kept until then.
    ``proc``: whether there is a /proc, which an unprivileged container does not let us have.
    """
    root = os.geteuid() == 0
    lock = [
        program,
        "--unshare-pid",
        # the warm parent is the first process itself: bubblewrap's own would let itself be written
        # into by who has its user, and would outlive every submission
        "--as-pid-1",
        "--unshare-net",
        "--unshare-ipc",
        "--unshare-uts",
        "--unshare-cgroup-try",
        "--die-with-parent",
        "--new-session",
        "--clearenv",
        "--cap-drop",
        "ALL",
    ]
    lock += (
        ["--cap-add", "CAP_SETUID", "--cap-add", "CAP_SETGID"]
        if root
        else ["--unshare-user", "--disable-userns", "--uid", "65534", "--gid", "65534"]
    )
    lock += ["--perms", "1777", "--size", str(limits.files_mb << 20), "--tmpfs", "/tmp"]
    # Python itself may stand there: nothing else may be put beside it
    below = {str(Path(*Path(path).parts[:3])) for path in readable() if path.startswith("/tmp/")}
    lock += [word for path in sorted(below) for word in ("--perms", "0755", "--tmpfs", path)]
    parents = {str(parent) for path in readable() for parent in list(Path(path).parents)[:-1]}
    lock += [word for parent in sorted(parents) for word in ("--perms", "0755", "--dir", parent)]
    lock += [word for path in readable() for word in _bind(path)]
    lock += [word for path in hidden() for word in ("--tmpfs", path)]
    emptied = [*packages(), *packages_of_others()] if room == OWN else []
    lock += [word for path in emptied for word in ("--perms", "0755", "--tmpfs", path)]
    lock += [word for path in (kept() if emptied else ()) for word in ("--ro-bind", path, path)]
    lock += ["--proc", "/proc"] if proc else []
    lock += ["--ro-bind", folder, INSIDE, "--dev", "/dev"]
    lock += [
        word
        for path in ("/dev", *hidden(), *emptied, *sorted(below), "/")
        for word in ("--remount-ro", path)
    ]
    lock += [
        word for name, value in environment("/tmp").items() for word in ("--setenv", name, value)
    ]
    return [*lock, "--chdir", "/tmp", "--", *command]


def _bind(path):
    return (
        ("--symlink", os.readlink(path), path)
        if os.path.islink(path) and path in SYSTEM
        else ("--ro-bind", path, path)
    )
