"""The learner's own folder: lessons are copied into it, never over anything, and JupyterLab opens
on it.
"""

import json
import os
import re
import signal
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

from ..formats.files import read_text, write_text
from .progress import MARKER, Log
from .route import counted, file_of, stopped_in

__all__ = [
    "handed_out",
    "prepare",
    "write_settings",
    "lab_command",
    "open_lab",
    "where_one_stopped",
]

OWN_NUMBERS = re.compile(
    r'"variant"\s*:\s*[1-9]'
)  # in the metadata of a notebook that dhlab release wrote
PACKAGE = Path(__file__).parents[1]
SETTINGS = {
    "@jupyterlab/apputils-extension:notification": {"fetchNews": "false", "checkForUpdates": False},
    "@jupyter-widgets/jupyterlab-manager:plugin": {"saveState": True},
}  # the explorer is still there when the notebook is opened again


def handed_out() -> Path:
    """The folder of the lessons: inside an installed package, beside it in a checkout.

    Raises
    ------
    ValueError
        There are no lessons; the installation is broken.
    """
    for folder in (PACKAGE / "lessons", PACKAGE.parent / "lessons"):
        if any(folder.glob("*.ipynb")):
            return folder
    raise ValueError(
        "lab: expected the lessons beside the package, found none; install dhlab again"
    )


def prepare(folder: str | Path) -> list[str]:
    """Copy the lessons into the learner's folder; what is there stays, a newer lesson arrives
    beside the old one.

    A folder that a teacher handed out, with a student's own numbers in it, gets no lessons: theirs
    would have the numbers that are the same for all.

    Parameters
    ----------
    folder : str or path
        Made when it does not exist.

    Returns
    -------
    list of str
        A sentence for each file that was added.

    Raises
    ------
    ValueError
        The folder cannot be made or written to, or is a file.
    """
    folder = Path(folder).expanduser()
    try:
        (folder / MARKER).mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise ValueError(
            f"lab: {folder}: expected a folder to put the lessons in, found that it cannot be made"
            f" ({error.strerror}); choose another"
        ) from None
    given = _given(folder)
    added = []
    kinds = (".md",) if _has_own_numbers(folder) else (".ipynb", ".md")
    for source in sorted(
        p for p in handed_out().iterdir() if p.suffix in kinds and p.name != "LICENSE.md"
    ):
        text = source.read_text(encoding="utf-8")
        target = _free_name(folder / source.name, text, given.get(source.name))
        if target:
            write_text(target, text)
            added.append(
                f"{target.name}:"
                f" {'new' if target.name == source.name else 'a newer version, beside your own'}"
            )
        given[source.name] = _fingerprint(text)
    write_text(folder / MARKER / "lessons.json", json.dumps(given, indent=1) + "\n", overwrite=True)
    return added


def _has_own_numbers(folder):
    """Whether a notebook of the folder was handed out with a student's own numbers."""
    return any(
        OWN_NUMBERS.search(path.read_text(encoding="utf-8", errors="replace"))
        for path in folder.glob("*.ipynb")
    )


def _free_name(target, text, given_before):
    """Where this version of a lesson goes, or None when the learner has it already."""
    if not target.exists():
        return target
    if given_before == _fingerprint(text):
        return None
    number = 1
    while target.exists():
        if target.read_text(encoding="utf-8", errors="replace") == text:
            return None
        number += 1
        target = target.with_name(f"{target.name.split('.')[0]}.version-{number}{target.suffix}")
    return target


def _given(folder):
    """Which version of each lesson was handed out here before; empty when that is not known."""
    try:
        known = json.loads(read_text(folder / MARKER / "lessons.json", "the list of lessons"))
    except (ValueError, json.JSONDecodeError):
        return {}
    return known if isinstance(known, dict) else {}


def _fingerprint(text):
    from hashlib import sha256

    return sha256(text.encode()).hexdigest()


def write_settings(folder: str | Path) -> None:
    """JupyterLab's settings for the course: no news, no questions about updates, nothing asked of
    the outside; what stood on the page stays in the notebook.
    """
    settings = Path(folder) / MARKER / "lab"
    settings.mkdir(parents=True, exist_ok=True)
    write_text(settings / "overrides.json", json.dumps(SETTINGS) + "\n", overwrite=True)


def where_one_stopped(folder: str | Path) -> str:
    """The notebook of a folder in which something was checked last, or the one after it where all
    of it is done; lesson 00 at first. "" where the folder has no such file.

    Examples
    --------
    >>> where_one_stopped("no-such-folder")
    ''
    """
    log = Log(Path(folder))
    name = file_of(stopped_in(log.entries(), counted(log.best())))
    return name if (Path(folder) / name).is_file() else ""


def lab_command(folder: str | Path, *, port: int | None = None, browser: bool = True) -> list[str]:
    """The command that starts JupyterLab on a prepared folder, with the lesson open where one
    stopped.
    """
    name = where_one_stopped(folder)
    command = [
        sys.executable,
        "-m",
        "jupyterlab",
        f"--ServerApp.root_dir={folder}",
        *([f"--LabApp.default_url=/lab/tree/{name}"] if name else []),
        f"--LabApp.app_settings_dir={Path(folder) / MARKER / 'lab'}",
    ]
    command += [f"--ServerApp.port={port}"] if port else []
    command += [] if browser else ["--no-browser"]
    command += ["--allow-root"] if hasattr(os, "geteuid") and os.geteuid() == 0 else []
    return command


def open_lab(folder: str | Path, *, port: int | None = None, browser: bool = True) -> int:
    """Prepare the folder and run JupyterLab on it until it is closed; returns its exit status."""
    if find_spec("jupyterlab") is None:
        raise ValueError(
            "lab: expected JupyterLab, found that it is not installed; run: pip install"
            ' "dhlab-kinematics[lab]"'
        )
    folder = Path(folder).expanduser().resolve()
    for sentence in prepare(folder):
        print(sentence)
    write_settings(folder)
    print(f"Your course is in {folder}; close JupyterLab with Ctrl + C.")
    lab = subprocess.Popen(lab_command(folder, port=port, browser=browser))
    signal.signal(signal.SIGTERM, lambda *_: lab.terminate())  # who ends this ends the lab
    try:
        return lab.wait()
    except KeyboardInterrupt:
        lab.terminate()  # on Ctrl + C alone it would ask first
        lab.wait()
        return 0
