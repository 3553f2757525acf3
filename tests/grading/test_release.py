"""Handing out: own numbers for everybody, nothing overwritten, the key stays at home; the notebooks
run as handed out.
"""

import json
import subprocess
import sys

import nbformat
import numpy as np
import pytest
from judging import marks_of
from terminal import dhlab

from dhlab.course.building.questions import question_of
from dhlab.course.exercises import exercises
from dhlab.course.workspace import handed_out, prepare
from dhlab.grading.handing_out.release import key_of, release
from dhlab.grading.handing_out.variants import variant
from dhlab.grading.intake.roster import Student

KEY = bytes(range(32))
CLASS = (Student("ada"), Student("bo"), Student("李"))


@pytest.fixture
def out(tmp_path):
    assert release(tmp_path / "out", CLASS, KEY, ("05",))[1] == 0
    return tmp_path / "out"


def test_everybody_gets_the_own_number_and_nothing_else_differs(out):
    plain = nbformat.read(handed_out() / "05-link-matrix.ipynb", as_version=4)
    for student in CLASS:
        notebook = nbformat.read(out / student.student / "05-link-matrix.ipynb", as_version=4)
        nbformat.validate(notebook)
        number = variant(KEY, student.student)
        own = [cell for cell in notebook.cells if "variant" in cell.metadata.get("tags", [])]
        assert (
            len(own) == 1
            and f"set_variant({number})" in own[0].source
            and notebook.metadata.dhlab.variant == number
        )
        notebook.cells.remove(own[0])
        for cell, as_for_all in zip(notebook.cells, plain.cells, strict=True):
            lines, common = (c.source.splitlines() for c in (cell, as_for_all))
            if question_of(cell):  # the same options, at other places
                lines, common = (sorted(line[5:] for line in part) for part in (lines, common))
            assert lines == common


def test_a_handed_out_notebook_runs_with_its_own_numbers(out):
    notebook = nbformat.read(out / "bo" / "05-link-matrix.ipynb", as_version=4)
    code = [cell.source for cell in notebook.cells if cell.cell_type == "code"]
    first = code.index(next(source for source in code if "set_variant" in source))
    program = "\n".join(
        [code[first], code[first + 1], 'import json; print(json.dumps(given("05.5")))']
    )
    printed = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, cwd=out
    )
    assert json.loads(printed.stdout) == exercises()["05.5"].given(variant(KEY, "bo")), (
        printed.stderr
    )


def test_the_right_answer_of_one_is_wrong_for_another(out):
    notebook = nbformat.read(out / "ada" / "05-link-matrix.ipynb", as_version=4)
    cell = next(cell for cell in notebook.cells if cell.metadata.get("exercise") == "05.5")
    right = np.asarray(exercises()["05.5"].answer(**exercises()["05.5"].given(variant(KEY, "ada"))))
    cell.source = f"origin = {right.tolist()}"
    status = [
        {mark.exercise: mark.status for mark in marks_of(notebook, variant(KEY, who))}["05.5"]
        for who in ("ada", "bo")
    ]
    assert status == ["right", "wrong"]


def test_a_second_run_adds_who_is_new_and_touches_nothing(out):
    mine = out / "ada" / "05-link-matrix.ipynb"
    before = {
        path: (path.read_bytes(), path.stat().st_mtime_ns)
        for path in out.rglob("*")
        if path.is_file()
    }
    assert release(out, CLASS, KEY, ("05",)) == (0, len(before))
    written, kept = release(out, (*CLASS, Student("dora")), KEY, ("05",))
    assert kept == len(before) and written == len(before) // 3
    assert (
        all((path.read_bytes(), path.stat().st_mtime_ns) == was for path, was in before.items())
        and mine.exists()
    )


def test_another_key_or_a_file_in_the_way_stops_before_anything_is_written(out):
    before = sorted(out.rglob("*"))
    with pytest.raises(ValueError, match="nothing was written"):
        release(out, (*CLASS, Student("dora")), KEY[::-1], ("05",))
    (out / "bo" / "05-link-matrix.ipynb").write_text("my notes")
    with pytest.raises(ValueError, match="nothing was written"):
        release(out, (*CLASS, Student("dora")), KEY, ("05",))
    assert (
        sorted(out.rglob("*")) == before
        and (out / "bo" / "05-link-matrix.ipynb").read_text() == "my notes"
    )


def test_the_key_is_nowhere_in_what_is_handed_out(tmp_path):
    key, new = key_of(tmp_path / "teacher.key", tmp_path / "out")
    assert new and not (tmp_path / "teacher.key").exists()
    release(tmp_path / "out", CLASS, key, new_key_at=tmp_path / "teacher.key")
    assert key_of(tmp_path / "teacher.key", tmp_path / "out") == (key, False)
    handed = b"".join(path.read_bytes() for path in (tmp_path / "out").rglob("*") if path.is_file())
    assert key not in handed and key.hex().encode() not in handed and len(handed) > 100_000
    for place in (
        tmp_path / "out" / "k",
        tmp_path / "out" / "ada" / "k",
        tmp_path / "x" / ".." / "out" / "k",
    ):
        with pytest.raises(ValueError, match="outside the folder"):
            key_of(place, tmp_path / "out")


@pytest.mark.slow
def test_a_release_that_is_refused_leaves_no_key(tmp_path):
    """The roster was moved away from its key: the lessons there have other numbers, and no new key
    may look like theirs.
    """
    (tmp_path / "class.csv").write_text("student\nada\nbo\n")
    call = ["release", "--out", "out", "--roster"]
    assert dhlab(*call, "class.csv", cwd=tmp_path).returncode == 0
    (tmp_path / "moved").mkdir()
    (tmp_path / "class.csv").rename(tmp_path / "moved" / "class.csv")
    refused = dhlab(*call, "moved/class.csv", cwd=tmp_path)
    assert (
        refused.returncode == 2
        and "nothing was written" in refused.stderr
        and not (tmp_path / "moved" / "teacher.key").exists()
    )


def test_without_a_roster_one_folder_for_all(tmp_path):
    release(tmp_path / "all")
    for path in handed_out().glob("*.ipynb"):
        assert (tmp_path / "all" / path.name).read_bytes() == path.read_bytes()


def test_dhlab_lab_lays_no_second_copy_beside_a_students_lessons(out):
    added = prepare(out / "ada")
    assert not [line for line in added if line.startswith("05-link-matrix")] and not list(
        (out / "ada").glob("*version*")
    )


def test_lessons_that_are_not_there(tmp_path):
    with pytest.raises(ValueError, match="two digits"):
        release(tmp_path / "out", CLASS, KEY, ("5",))
    assert not (tmp_path / "out").exists()


def test_a_folder_that_cannot_be_made(tmp_path):
    (tmp_path / "file").write_text("not a folder\n")
    with pytest.raises(ValueError, match="choose another --out"):
        release(tmp_path / "file" / "out", CLASS, KEY)


@pytest.mark.slow
def test_the_command(tmp_path):
    (tmp_path / "class.csv").write_text("student,name\nada,Ada\nbo,Bo\n")
    (tmp_path / "course.yaml").write_text('lessons:\n  "05": {due: 2026-11-20 23:59}\n')
    call = ["release", "--roster", "class.csv", "--out", "out", "--course", "course.yaml"]
    first, second = dhlab(*call, cwd=tmp_path), dhlab(*call, cwd=tmp_path)
    assert first.returncode == second.returncode == 0, first.stderr + second.stderr
    assert "Your new key: teacher.key" in first.stdout and "0 files written" in second.stdout
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == ["ada", "bo"]
    assert [path.name for path in (tmp_path / "out" / "ada").glob("*.ipynb")] == [
        "05-link-matrix.ipynb"
    ]


@pytest.mark.parametrize(
    "arguments, words",
    [
        (["--out", "o", "--roster", "no.csv"], "no such file"),
        (["--out", "o", "--key", "k"], "goes with --roster"),
        (["--out", "o", "--roster", "r.csv", "--key", "o/k"], "outside the folder"),
        (["--out", "o", "--course", "no.yaml"], "no such file"),
        ([], "--out"),
    ],
)
def test_errors_are_one_sentence(tmp_path, arguments, words):
    (tmp_path / "r.csv").write_text("student\nada\n")
    answer = dhlab("release", *arguments, cwd=tmp_path)
    assert answer.returncode == 2 and words in answer.stderr and answer.stderr.count("\n") == 1
