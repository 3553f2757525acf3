"""An autograder for Gradescope: a zip with ``setup.sh`` and ``run_autograder`` at its root, and the
library beside them.

Gradescope's documents: gradescope-autograders.readthedocs.io, "Autograder Specifications" and
"Submission Metadata".
"""

import io
import json
import re
import zipfile
from collections.abc import Sequence
from importlib.metadata import requires, version
from pathlib import Path

from ...course.workspace import handed_out
from ...formats.files import read_text, write_bytes
from ..handing_out.variants import variants
from ..intake.roster import Student
from ..settings import read_settings

__all__ = ["export_gradescope"]

PACKAGE = Path(__file__).parents[2]
SETUP = """#!/usr/bin/env bash
# Once, when Gradescope builds the image: Python 3.11 or newer, the cage, the libraries.
set -euo pipefail
apt-get update
if python3 -c 'import sys; sys.exit(sys.version_info < (3, 11))'
then python=python3; else python=python3.11; fi
apt-get install -y "$python" "$python-venv" bubblewrap
"$python" -m venv /autograder/venv
/autograder/venv/bin/python -m pip install --requirement /autograder/source/requirements.txt
"""
RUN = """#!/usr/bin/env bash
# For every submission: read submission/, write results/results.json.
set -euo pipefail
root="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
cd "$root"
export PYTHONPATH="$root/source"
exec "$root/venv/bin/python" -m dhlab.grading.exports.gradescope_run "$root"
"""


def export_gradescope(
    out: str | Path,
    roster: Sequence[Student] = (),
    key: bytes | None = None,
    course: str | Path = "",
) -> int:
    """Write the autograder; an existing file is kept.

    The key stays here: what goes along is the variant of each e-mail address.

    Parameters
    ----------
    out : str or path
        The zip.
    roster : sequence of Student
        With the addresses that Gradescope knows.
    key : bytes or None
    course : str
        A ``course.yaml``; its lessons are the assignment. Lateness is left to Gradescope.

    Returns
    -------
    int
        How many files are in it.

    Raises
    ------
    ValueError
        A student of the roster has no e-mail address, by which Gradescope would know them, or
        another one's.
    """
    nameless = [student.student for student in roster if not student.email]
    if key and nameless:
        raise ValueError(
            "export gradescope: expected an e-mail address for everybody, found none for"
            f" {', '.join(nameless[:5])}; add the column email to the roster"
        )
    owners: dict[str, str] = {}
    for student in roster:
        owner = owners.setdefault(student.email.casefold(), student.student)
        if key and owner != student.student:
            raise ValueError(
                "export gradescope: expected an e-mail address of their own for everybody, found"
                f" {student.email} for {owner} and {student.student}; Gradescope knows people by it"
            )
    numbers = variants(key, [student.student for student in roster])
    files = {
        "setup.sh": SETUP,
        "run_autograder": RUN,
        "requirements.txt": "\n".join(_requirements()) + "\n",
        "variants.json": (
            json.dumps(
                {student.email.casefold(): numbers[student.student] for student in roster}, indent=1
            )
            + "\n"
        ),
    }
    if course:
        read_settings(course)
        files["course.yaml"] = read_text(course, "a course's settings")
    files |= {f"dhlab/{name}": path for name, path in _package().items()} | {
        f"dhlab/lessons/{path.name}": path for path in sorted(handed_out().glob("*.ipynb"))
    }
    write_bytes(out, _zipped(files))
    return len(files)


def _package():
    """The library's files, by their names in it."""
    found = (
        path
        for path in sorted(PACKAGE.rglob("*"))
        if path.is_file()
        and path.suffix in (".py", ".pyi", ".yaml", ".html", ".js", ".csv", ".urdf", ".json")
    )
    named = {path.relative_to(PACKAGE).as_posix(): path for path in found}
    return {
        name: path
        for name, path in named.items()
        if not set(Path(name).parts[:-1]) & {"__pycache__", "lessons", "teacher", "node_modules"}
    }


def _requirements():
    """What the library and its lessons need, in the versions that are installed here."""
    wanted = [
        line
        for line in requires("dhlab-kinematics") or []
        if "extra ==" not in line or re.search(r"""extra == ["']symbolic["']""", line)
    ]
    names = {re.findall(r"[\w.-]+", line)[0] for line in wanted} | {"ipython", "nbformat"}
    return sorted(f"{name}=={version(name)}" for name in names)


def _zipped(files):
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            entry = zipfile.ZipInfo(name, (2000, 1, 1, 0, 0, 0))
            entry.external_attr = (0o755 if name in ("setup.sh", "run_autograder") else 0o644) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, content if isinstance(content, str) else content.read_bytes())
    return out.getvalue()
