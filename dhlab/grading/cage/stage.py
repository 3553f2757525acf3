"""What the cage sees of this machine: the library without the course's answers, Python and its
packages; and the command that locks it in.
"""

import os
import shutil
import site
import sys
import sysconfig
from collections.abc import Sequence
from pathlib import Path

from ..settings import Limits

__all__ = ["stage", "python_command", "bubblewrap_command", "readable", "environment"]

PACKAGE = Path(__file__).parents[2]
STAND_IN = PACKAGE / "grading" / "inside" / "stand_in"
LEFT_OUT = shutil.ignore_patterns("course", "grading", "lessons", "teacher", "view", "cli", "*.tmp")
# of the course: what lessons call and what holds no exercise
FREE_OF_ANSWERS = ("othersolvers.py", "simulator.py")
CALLING = ("calling.py", "stops.py")  # how a learner's function is called, and Python's errors
SYSTEM = (
    "/usr",
    "/lib",
    "/lib64",
    "/lib32",
    "/bin",
    "/etc/ld.so.cache",
    "/etc/localtime",
    "/etc/fonts",
)
INSIDE = "/cage"  # where the staged library stands inside bubblewrap
BLAS = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS")


def stage(folder: str) -> None:
    """Copy the library into a folder: no exercises, no grader; a course that only notes, pictures
    that are not drawn.
    """
    target = Path(folder) / "dhlab"
    shutil.copytree(PACKAGE, target, ignore=LEFT_OUT)
    (target / "grading").mkdir()
    (target / "grading" / "__init__.py").touch()
    shutil.copytree(
        PACKAGE / "grading" / "inside",
        target / "grading" / "inside",
        ignore=shutil.ignore_patterns("stand_in"),
    )
    for name in CALLING:
        shutil.copy2(PACKAGE / "doctor" / "programs" / name, target / "grading" / "inside")
    for name in ("course", "view"):
        (target / name).mkdir()
        shutil.copy2(STAND_IN / f"{name}.py", target / name / "__init__.py")
    (target / "course" / "session.py").write_text("from . import *\n", encoding="utf-8")
    for name in FREE_OF_ANSWERS:
        if (PACKAGE / "course" / name).exists():
            shutil.copy2(PACKAGE / "course" / name, target / "course")
    for path in (Path(folder), *Path(folder).rglob("*")):
        path.chmod(0o755 if path.is_dir() else 0o644)


def packages():
    """The folders that Python finds packages in, those of this user left out."""
    found = [sysconfig.get_path("purelib"), sysconfig.get_path("platlib"), *site.getsitepackages()]
    return [folder for folder in dict.fromkeys(found) if os.path.isdir(folder)]


def python_command(folder: str, config: str) -> list[str]:
    """The command that starts the warm parent: no start-up files, nothing of the user's, the staged
    library first.
    """
    path = [folder, *packages()]
    start = (
        f"import sys; sys.path[:0] = {path!r}; sys.argv = ['cage', {config!r}]; from"
        " dhlab.grading.inside.zygote import main; main()"
    )
    return [sys.executable, "-s", "-S", "-P", "-c", start]


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


def readable() -> list[str]:
    """What a submission may read besides the staged library: the system, Python, its packages;
    never the installed dhlab.
    """
    roots = [
        *SYSTEM,
        sys.base_prefix,
        sys.prefix,
        os.path.dirname(os.path.realpath(sys.executable)),
    ]
    return [root for root in dict.fromkeys(roots) if os.path.exists(root)]


def hidden():
    """Where dhlab itself stands among what is readable, and what must therefore be covered."""
    roots = [os.path.realpath(root) for root in readable()]
    wanted = [str(PACKAGE), *(str(PACKAGE.parent / name) for name in ("solutions", "lessons"))]
    return [
        path
        for path in wanted
        if os.path.isdir(path)
        and any(os.path.realpath(path).startswith(root + os.sep) for root in roots)
    ]


def readable_without(covered):
    """The readable paths with folders spread out wherever something in them must not be read:
    Landlock only allows.
    """
    found = []
    for root in readable():
        found += _spread(os.path.realpath(root), [os.path.realpath(path) for path in covered])
    return found


def _spread(path, covered):
    if path in covered:
        return []
    if not any(inner.startswith(path + os.sep) for inner in covered):
        return [path]
    return [found for entry in os.scandir(path) for found in _spread(entry.path, covered)]


def bubblewrap_command(
    program: str, folder: str, command: Sequence[str], limits: Limits, proc: bool
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
    lock += ["--proc", "/proc"] if proc else []
    lock += ["--ro-bind", folder, INSIDE, "--dev", "/dev"]
    lock += [word for path in ("/dev", *sorted(below), "/") for word in ("--remount-ro", path)]
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
