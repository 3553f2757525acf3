"""The hostile corpus on every level of the cage that this machine has: marks fair, nothing leaked,
nothing damaged, neighbours graded.
"""

import hashlib
import json
import os
import shutil
import socket
import subprocess
import sys
import tempfile
from contextlib import closing
from dataclasses import replace
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
import corpus
from corpus_together import together

from dhlab.grading import grade
from dhlab.grading.cage import levels
from dhlab.grading.reports import publish
from dhlab.grading.settings import Limits, Settings

# after so little what hears nothing is ended by the kernel, which counts whole seconds
LIMITS = Limits(cell_seconds=0.9, seconds=12.0, memory_mb=256, files_mb=8, threads=16)
# Below bubblewrap only what the level has a part in is run once more: what another user, other
# processes, other files and other calls decide. The clock, the answers and the notebooks are in the
# hands of the same code at each level.
ALIKE = (
    "late thread, segmentation fault, ends the process, sys.exit, exit in a function, keyboard"
    " interrupt, memory of numpy, print flood, many answers, a huge answer, a deep answer, a huge"
    " number, forges lines, forges the end, json patched, asks for another variant"
).split(", ")
ROOMS = corpus.PROCESSES, corpus.RESOURCES, corpus.CHANNEL, corpus.READING, corpus.LEFT_BEHIND
ATTACKS = [case for room in ROOMS for case in room if case[0] not in ALIKE]
# Where the grader itself has no rights: another user outside, a user namespace, no rights to give
# up, files that are the submission's own. The filter of calls and the channel are the same.
AS_A_USER = "DHLAB_CORPUS_AS_A_USER"
OF_A_USER = [
    case
    for case in (*corpus.PROCESSES, *corpus.RESOURCES)
    if case[0]
    in "fork bomb, thread bomb, kills its parent, kills everybody, higher limits, disk, one large"
    " file, many files, deep folders".split(", ")
] + [case for case in (*corpus.READING, *corpus.LEFT_BEHIND) if case[0] not in ALIKE]
# for the level that protects nobody
HARMLESS = [
    *corpus.TIME[:1],
    *corpus.LIBRARY[:2],
    *corpus.LIBRARY[-2:],
    *corpus.PATCHES[:1],
    *corpus.NOTEBOOKS[:2],
]
CANARY = "canary-5731"  # what the files and the environment of the grader hold
LEVELS = {
    "bubblewrap": OF_A_USER if AS_A_USER in os.environ else corpus.CASES,
    "landlock": ATTACKS,
    "rlimits": HARMLESS,
}


@pytest.fixture(scope="module", params=LEVELS)
def graded(request, tmp_path_factory):
    """(cases, marks by student, output folder, what was found damaged) of the corpus on one
    level.
    """
    level, cases = request.param, together(LEVELS[request.param])
    top = tmp_path_factory.mktemp(level)
    with (
        closing(socket.create_server(("127.0.0.1", 0))) as server,
        pytest.MonkeyPatch.context() as patch,
    ):
        patch.setenv("GRADER_SECRET", CANARY)
        facts = _facts(top, server.getsockname()[1])
        corpus.write(top / "class", cases, facts)
        before = _prints(top)
        try:
            results, planned = grade.grade(
                top / "class", top / "out", settings=Settings(limits=LIMITS, cage=level)
            )
        except ValueError as error:
            if "expected the cage" not in str(error):
                raise
            pytest.skip(f"{level} does not work on this machine")
        if level == "bubblewrap":  # what is shown depends on what was found, not on the cage
            publish.publish(planned, results, (), top / "out")
        server.setblocking(False)
        with pytest.raises(BlockingIOError):
            server.accept()
    return cases, {one.student: one for one in results}, top, (before, _prints(top))


def _facts(top, port):
    for folder in ("class", "out"):
        (top / folder).mkdir()
    for name in ("teacher.key", "canary", "marks.json", "neighbour.ipynb"):
        (top / name).write_text(f"GRADER_SECRET {CANARY}", encoding="utf-8")
    return {
        "key": str(top / "teacher.key"),
        "canary": str(top / "canary"),
        "marks": str(top / "marks.json"),
        "neighbour": str(top / "neighbour.ipynb"),
        "class": str(top / "class"),
        "out": str(top / "out"),
        "solutions": str(corpus.ROOT / "solutions" / "05-link-matrix.md"),
        "exercises": str(corpus.ROOT / "dhlab" / "course" / "exercises" / "lesson05.py"),
        "port": port,
    }


def _prints(top):
    """Of everything an attack might damage."""
    paths = [
        *top.glob("*.*"),
        top / "canary",
        *(top / "class").rglob("*"),
        corpus.ROOT / "dhlab" / "__init__.py",
    ]
    return {
        str(path): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in paths
        if path.is_file() and not path.is_symlink()
    }


@pytest.mark.parametrize("key, rule", [("k", "1"), ("other", "b")])
def test_a_spy_that_succeeds_is_seen(key, rule):
    spies = [corpus.spy("leaked = False"), corpus.spy("leaked = FACTS['key'] == 'k'")]
    ((_, make, _),) = together([(str(spy), spy, corpus.FULL) for spy in spies])
    for one, seen in ((make, rule), (spies[1], rule.replace("1", "a"))):
        notebook, names = corpus.solved(), {}
        one(notebook, {"key": key})
        for source in (c["source"] for c in notebook["cells"] if c["cell_type"] == "code"):
            if "known" in source or "rule = " in source:
                exec(source, names)
        assert names["rule"] == seen


def test_marks_are_fair(graded):
    cases, results, _, _ = graded
    worth = {mark.exercise: mark.of for mark in results["s000-honest"].marks}
    unfair = {}
    for number, (name, _, lost) in enumerate(cases):
        one = results.get(corpus.student(number))
        found = corpus.lost(one) if one else None
        if lost == corpus.ANY:
            fair = one is not None and 0 <= one.points <= one.of
        elif isinstance(lost, str):
            fair = (one is None and lost == "missing") or (
                one is not None and one.status == lost and one.points == 0
            )
        else:
            fair = one is not None and one.status == "graded" and found == set(lost)
        if not fair:
            told = one and {mark.exercise: mark.headline for mark in one.marks}["05.2"]
            unfair[name] = (one and one.status, found, one and one.notes, told)
        assert one is None or {mark.exercise: mark.of for mark in one.marks} == worth
    assert not unfair


def test_neighbours_are_graded(graded):
    _, results, _, _ = graded
    honest = [one for student, one in results.items() if student.endswith(corpus.HONEST)]
    assert len(honest) >= 2
    assert all(
        one.status == "graded"
        and one.total == one.of
        and {mark.exercise for mark in one.marks} == set(corpus.LESSON)
        for one in honest
    )
    assert (
        len({tuple(replace(mark, file="", handed_in="") for mark in one.marks) for one in honest})
        == 1
    )


def test_nothing_is_damaged(graded):
    _, _, _, (before, after) = graded
    assert before == after


def test_special_files_are_refused(graded):
    _, results, _, _ = graded
    assert any("pipe" in note and "refused" in note for note in results[corpus.student(0)].notes)
    assert any("link" in note and "refused" in note for note in results[corpus.student(1)].notes)
    assert results["tardy"].status == "unreadable" and results["tardy"].points == 0


def test_nothing_leaks_and_nothing_is_rendered(graded):
    _, results, top, _ = graded
    for path in [
        *(top / "out").rglob("*.html"),
        *(top / "out").rglob("*.json"),
        top / "out" / "grades.csv",
    ]:
        text = path.read_text(encoding="utf-8")
        assert CANARY not in text, path
        assert path.suffix != ".html" or "<script>alert" not in text, path
    assert "bubblewrap" not in top.name or list((top / "out").rglob("*.html"))
    assert {
        json.loads(path.read_text(encoding="utf-8"))["student"]
        for path in (top / "out" / "marks").glob("*.json")
    } == set(results)


def test_the_level_is_told(graded):
    _, results, top, _ = graded
    assert {one.cage for one in results.values() if one.status == "graded"} == {
        top.name.rstrip("0123456789")
    }
    assert results["s000-honest"].cage in levels.RISKS


def test_every_line_of_the_grades_has_a_status(graded):
    _, results, top, _ = graded
    head, *lines = (top / "out" / "grades.csv").read_text(encoding="utf-8").splitlines()
    assert head.startswith("student,name,status,") and len(lines) == len(results)
    assert all(
        line.split(",")[2] in ("graded", "not attempted", "unreadable", "timed out", "missing")
        for line in lines
    )


def test_answers_do_not_enter_the_cage(tmp_path):
    from dhlab.grading.cage import stage

    stage.stage(tmp_path)
    text = "\n".join(path.read_text(encoding="utf-8") for path in tmp_path.rglob("*.py"))
    assert "EXERCISES" not in text and "RIGHT_ORDERS" not in text and "praise=" not in text
    assert not [
        path
        for path in tmp_path.rglob("*")
        if "lesson" in path.name or "kinds" in path.name or "judge" in path.name
    ]


@pytest.mark.cage
@pytest.mark.skipif(
    not hasattr(os, "geteuid") or os.geteuid() != 0 or not shutil.which("bwrap"),
    reason="where the tests do not run as root, they have shown it already",
)
def test_bubblewrap_without_root():
    """The attacks once more, with the grader itself run by a user without rights; Python may stand
    in root's own folder, which is shown to that user.
    """
    home = Path(sys.base_prefix).parts[:3]
    shown = (
        [
            "bwrap",
            "--dev-bind",
            "/",
            "/",
            "--perms",
            "0755",
            "--tmpfs",
            "/root",
            "--ro-bind",
            str(Path(*home)),
            str(Path(*home)),
        ]
        if home[1] == "root"
        else []
    )
    with tempfile.TemporaryDirectory() as folder:
        os.chmod(folder, 0o777)
        as_nobody = [
            *shown,
            "setpriv",
            "--reuid",
            "65534",
            "--regid",
            "65534",
            "--clear-groups",
            "env",
            f"HOME={folder}",
            f"TMPDIR={folder}",
            f"{AS_A_USER}=1",
        ]
        if subprocess.run(
            [*as_nobody, sys.executable, "-c", "import dhlab"], capture_output=True, cwd=corpus.ROOT
        ).returncode:
            pytest.skip("a user without rights cannot read this Python")
        run = subprocess.run(
            [
                *as_nobody,
                sys.executable,
                "-m",
                "pytest",
                "-q",
                "-o",
                "addopts=",
                "-p",
                "no:cacheprovider",
                __file__,
                "-k",
                "[bubblewrap]",
            ],
            capture_output=True,
            text=True,
            cwd=corpus.ROOT,
            timeout=600,
        )
        assert run.returncode == 0 and " passed" in run.stdout and "skipped" not in run.stdout, (
            run.stdout[-3000:]
        )
