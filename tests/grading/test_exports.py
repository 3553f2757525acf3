"""The course in other hands: nbgrader's own commands, Gradescope's folders, Canvas's and Moodle's
tables; the same marks everywhere.
"""

import csv
import io
import json
import os
import re
import subprocess
import sys
import zipfile
from datetime import UTC, datetime
from pathlib import Path

import nbformat
import pytest
from judging import marks_of
from terminal import dhlab

from dhlab.course.exercises import exercises
from dhlab.grading.cage.cage import Cage
from dhlab.grading.exports.gradebooks import canvas_csv, moodle_csv, read_marks
from dhlab.grading.exports.gradescope import export_gradescope
from dhlab.grading.exports.gradescope_run import _student, main, results
from dhlab.grading.exports.nbgrader import export_nbgrader
from dhlab.grading.exports.nbgrader_cell import graded_check
from dhlab.grading.grade import grade
from dhlab.grading.handing_out.release import release
from dhlab.grading.handing_out.variants import variants
from dhlab.grading.intake.roster import Student
from dhlab.grading.judging import running
from dhlab.grading.judging.running import close
from dhlab.grading.results.marks import Graded, Mark
from dhlab.grading.settings import read_settings

ROOT = Path(__file__).parents[2]
LESSON = "05-link-matrix"
COURSE = """lessons:
  "05": {due: 2026-11-01 12:00, points: {"05.2": 3}}
late: {percent_per_day: 10, floor: 50, grace_hours: 1}
partial: 0.5
"""
RIGHT = {
    "05.1": (
        "def rot_x(alpha):\n    c, s = np.cos(alpha), np.sin(alpha)\n    return np.array([[1, 0, 0,"
        " 0], [0, c, -s, 0], [0, s, c, 0], [0, 0, 0, 1]])"
    ),
    "05.2": 'rule = "b"',
    "05.3": 'order = ["b", "a", "c", "d"]',
    "05.4": (
        "def dh_transform(theta, d, a, alpha):\n    return rot_z(theta) @ trans_z(d) @ trans_x(a) @"
        " rot_x(alpha)"
    ),
}
NOISY = {
    **RIGHT,
    "05.4": (
        "import sys, warnings\ndef dh_transform(theta, d, a, alpha):\n    print(theta)\n   "
        " print('noise', file=sys.stderr)\n    warnings.warn('careful')\n    return rot_z(theta) @"
        " trans_z(d) @ trans_x(a) @ rot_x(alpha)"
    ),
}
WRONG = {
    "05.1": RIGHT["05.1"].replace("-s", "s", 1).replace("0, s, c", "0, -s, c"),
    "05.2": 'rule = "a"',
    "05.3": "order = 1 / 0",
    "05.4": RIGHT["05.4"].replace("rot_x(alpha)", "rot_x(d)"),
}
BORROWED = {
    **RIGHT,
    "05.4": (
        "def dh_transform(theta, d, a, alpha):\n    return dh.DHTable.standard([[theta, d, a,"
        " alpha]], angle='rad') and dh.Arm(dh.DHTable.standard([[theta, d, a, alpha]],"
        " angle='rad')).forward([0.0])"
    ),
}
ANSWERS = {"noisy": NOISY, "wrong": WRONG, "borrowed": BORROWED, "untouched": {}}
LATE = datetime(2026, 11, 3, 6, tzinfo=UTC)
ON_TIME = datetime(2026, 11, 1, 10, tzinfo=UTC)


def fill_in(notebook, answers):
    made = nbformat.from_dict(notebook)
    for cell in made.cells:
        cell.source = answers.get(cell.metadata.get("exercise"), cell.source)
    return made


def environment():
    """nbgrader starts alembic by its name."""
    return {
        **os.environ,
        "PATH": os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]]),
        "PYTHONWARNINGS": "ignore",
    }


NBGRADER = """
import sys
from contextlib import suppress
from jupyter_core.application import NoStart
from nbgrader.apps import NbGraderApp
from nbgrader.preprocessors import execute
sys.path.append(sys.argv[1])
from kernels import Forked
execute.AsyncKernelManager = Forked  # as for the site: dhlab is imported once for all
for line in sys.stdin:
    app = NbGraderApp.instance()
    app.initialize(line.split())
    with suppress(NoStart):  # a command below it has done the work
        app.start()
    while app:  # one of a kind, each with the next below it
        app.clear_instance()
        app = app.subapp
    print("done", flush=True)
"""


@pytest.fixture(scope="module")
def nbgrader(tmp_path_factory):
    """The folder of a course, and nbgrader's commands there, one after the other in one process: to
    load it takes a second.
    """
    pytest.importorskip("nbgrader")
    top = tmp_path_factory.mktemp("nbgrader")
    (top / "course").mkdir()
    with (
        open(top / "log", "w+", encoding="utf-8") as log,
        subprocess.Popen(
            [sys.executable, "-c", NBGRADER, ROOT / "docs"],
            cwd=top / "course",
            env=environment(),
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=log,
            text=True,
        ) as process,
    ):

        def run(*commands):
            for command in commands:
                print(command, file=process.stdin, flush=True)
                assert "done\n" in process.stdout, (command, log.seek(0), log.read())

        yield top / "course", run
        process.stdin.close()


@pytest.fixture(scope="module")
def course(nbgrader):
    """A course that nbgrader has generated, that students have handed in to, and that nbgrader has
    graded and exported.
    """
    place, run = nbgrader
    (place.parent / "course.yaml").write_text(COURSE)
    everybody = [Student(name, f"Student {name}", f"{name}@example.org") for name in ANSWERS]
    assert export_nbgrader(place, everybody, read_settings(place.parent / "course.yaml")) == [
        LESSON
    ]
    run(
        "db student import students.csv",
        "db assignment import assignments.csv",
        f"generate_assignment {LESSON}",
    )
    handed_out = nbformat.read(place / "release" / LESSON / f"{LESSON}.ipynb", as_version=4)
    for name, answers in ANSWERS.items():
        folder = place / "submitted" / name / LESSON
        folder.mkdir(parents=True)
        notebook = fill_in(handed_out, answers)
        if name == "borrowed":  # and without one of the check cells
            notebook.cells = [
                cell for cell in notebook.cells if not cell.source.startswith('check("05.2"')
            ]
        nbformat.write(notebook, folder / f"{LESSON}.ipynb")
        moment = LATE if name == "noisy" else ON_TIME
        (folder / "timestamp.txt").write_text(f"{moment:%Y-%m-%d %H:%M:%S} UTC")
        os.utime(folder / f"{LESSON}.ipynb", (moment.timestamp(), moment.timestamp()))
    run(f"autograde {LESSON}", "export", f"generate_feedback {LESSON} --student wrong")
    return place


@pytest.fixture(scope="module")
def exported(course):
    return {
        row["student_id"]: row
        for row in csv.DictReader((course / "grades.csv").read_text().splitlines())
    }


@pytest.fixture(scope="module")
def ours(course, kept_cages, tmp_path_factory):
    """The same notebooks through dhlab grade."""
    everybody = [Student(name) for name in ANSWERS]
    results, _ = grade(
        course / "submitted",
        tmp_path_factory.mktemp("ours"),
        roster=everybody,
        settings=read_settings(course.parent / "course.yaml"),
    )
    return {graded.student: graded for graded in results}


def test_nbgrader_hands_out_what_we_hand_out(course):
    """No solution, no hidden test; the learner's lines as in our own lesson."""
    text = (course / "release" / LESSON / f"{LESSON}.ipynb").read_text(encoding="utf-8")
    assert (
        "SOLUTION" not in text
        and "HIDDEN" not in text
        and "graded_check" not in text
        and "NotImplementedError" not in text
    )
    theirs = list(nbformat.reads(text, as_version=4).cells)
    own = nbformat.read(ROOT / "lessons" / f"{LESSON}.ipynb", as_version=4).cells
    assert [c.source for c in theirs if c.cell_type == "markdown"] == [
        c.source for c in own if c.cell_type == "markdown"
    ]
    checks = [cell for cell in theirs if cell.source.startswith("check(")]
    assert [c.source for c in checks] == [
        c.source for c in own if c.source.startswith("check(")
    ] and all(c.metadata.nbgrader.locked for c in checks)


def test_nbgrader_gives_honest_work_the_marks_that_dhlab_grade_gives(exported, ours):
    assert set(exported) == set(ours) == set(ANSWERS)
    for name, row in exported.items():
        if name == "borrowed":  # there programs run beside the library's own
            continue
        assert float(row["raw_score"]) == pytest.approx(ours[name].points), name
        assert (
            float(row["score"]) == pytest.approx(ours[name].total, abs=0.005)
            and float(row["max_score"]) == ours[name].of
        ), name


def test_and_these_are_the_right_marks(exported, ours):
    """By hand: 05.1 to 05.4 are worth 1, 3 (by course.yaml), 1 and 2; nothing else was answered."""
    points = {name: float(row["raw_score"]) for name, row in exported.items()}
    assert points == {"noisy": 7, "untouched": 0, "borrowed": 7, "wrong": points["wrong"]}
    assert (
        points["wrong"]
        == 0.5
        * sum(m.of for m in ours["wrong"].marks if m.mistake and m.exercise in ("05.1", "05.4"))
        >= 0.5
    )
    assert float(exported["noisy"]["score"]) == pytest.approx(7 * 0.8), "two days begun, 10 % each"
    assert float(exported["borrowed"]["score"]) == 7, "in time"
    assert {mark.exercise: mark.status for mark in ours["borrowed"].marks}["05.4"] == "not allowed"
    assert ours["borrowed"].points == 5


def test_nbgraders_own_gradebook_says_the_same(course, exported):
    """Its database, by its own programming interface."""
    from nbgrader.api import Gradebook

    with Gradebook(f"sqlite:///{course / 'gradebook.db'}") as book:
        for name, row in exported.items():
            found = book.find_submission(LESSON, name)
            assert (found.score, found.max_score) == (
                pytest.approx(float(row["raw_score"])),
                float(row["max_score"]),
            )
            assert not found.needs_manual_grade


def test_nbgrader_without_our_grader_agrees_with_the_exercises_themselves(course, exported):
    for name in ("noisy", "untouched"):
        notebook = nbformat.read(
            course / "submitted" / name / LESSON / f"{LESSON}.ipynb", as_version=4
        )
        marks = marks_of(notebook)
        assert sum(mark.points * (3 if mark.exercise == "05.2" else 1) for mark in marks) == float(
            exported[name]["raw_score"]
        )


def test_nbgrader_makes_its_feedback(course):
    page = (course / "feedback" / "wrong" / LESSON / f"{LESSON}.html").read_text(encoding="utf-8")
    assert "Not yet" in page


def test_a_second_export_overwrites_nothing(course):
    with pytest.raises(ValueError, match="found one that exists"):
        export_nbgrader(course)


def test_every_lesson_can_be_exported(tmp_path):
    pytest.importorskip("nbgrader")
    from nbgrader.nbgraderformat import MetadataValidator

    for name in export_nbgrader(tmp_path / "all"):
        graded = {}
        for path in (tmp_path / "all" / "source" / name).glob("*.ipynb"):
            notebook = nbformat.read(path, as_version=4)
            MetadataValidator().validate_nb(notebook)
            solutions = [cell for cell in notebook.cells if "BEGIN SOLUTION" in cell.source]
            assert all(cell.metadata.nbgrader.solution for cell in solutions)
            graded |= {
                cell.metadata.nbgrader.grade_id: cell.metadata.nbgrader.points
                for cell in notebook.cells
                if cell.metadata.get("nbgrader", {}).get("grade")
            }
        assert graded == {
            f"check-{key.replace('.', '-')}": e.points
            for key, e in exercises().items()
            if key.startswith(name[:2]) and e.points
        }


@pytest.mark.parametrize(
    "answer, points", [(lambda theta, d, a, alpha: None, 0), (..., 0), ("nonsense", 0)]
)
def test_a_graded_cell_never_fails(answer, points):
    assert graded_check(2)("05.4", answer) == points


# ---- Gradescope


def autograder(tmp_path, answers, user="ada@example.org", key=None):
    """Gradescope's folders with a submission in them."""
    everybody = [Student("ada", "Ada", "Ada@example.org"), Student("bo", "Bo", "bo@example.org")]
    (tmp_path / "course.yaml").write_text(COURSE)
    export_gradescope(tmp_path / "autograder.zip", everybody, key, tmp_path / "course.yaml")
    root = tmp_path / "autograder"
    for name in ("source", "submission", "results"):
        (root / name).mkdir(parents=True)
    with zipfile.ZipFile(tmp_path / "autograder.zip") as archive:
        archive.extractall(root / "source")
        modes = {entry.filename: entry.external_attr >> 16 for entry in archive.infolist()}
    assert modes["setup.sh"] & modes["run_autograder"] & 0o111, "Gradescope runs them"
    (root / "run_autograder").write_bytes((root / "source" / "run_autograder").read_bytes())
    (root / "venv" / "bin").mkdir(parents=True)
    (root / "venv" / "bin" / "python").write_text(f'#!/bin/sh\nexec "{sys.executable}" "$@"\n')
    for path in (root / "run_autograder", root / "venv" / "bin" / "python"):
        path.chmod(0o755)
    (root / "submission_metadata.json").write_text(
        json.dumps(
            {
                "id": 1,
                "created_at": "2027-01-01T00:00:00+00:00",
                "users": [{"email": user, "id": 1, "name": "Ada"}],
            }
        )
    )
    release(tmp_path / "out", everybody, key, ("05",))
    notebook = nbformat.read(tmp_path / "out" / "ada" / f"{LESSON}.ipynb", as_version=4)
    nbformat.write(fill_in(notebook, answers), root / "submission" / "my work (1).ipynb")
    return root


def run_autograder(root):
    """What it has written into results.json."""
    done = subprocess.run([str(root / "run_autograder")], cwd=root, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    return json.loads((root / "results" / "results.json").read_text(encoding="utf-8"))


# Gradescope's documentation, Autograder Specifications, "Output format"; there is no checker of it
TOLD = {
    "score": (int, float),
    "execution_time": int,
    "output": str,
    "visibility": str,
    "stdout_visibility": str,
    "tests": list,
}
OF_A_TEST = {
    "score": (int, float),
    "max_score": (int, float),
    "status": str,
    "name": str,
    "number": str,
    "output": str,
    "visibility": str,
}


def of_the_format(told, known):
    return all(name in known and isinstance(value, known[name]) for name, value in told.items())


@pytest.mark.cage
@pytest.mark.skipif(os.name == "nt", reason="Gradescope runs Linux")
def test_gradescope_in_its_own_folders(tmp_path):
    key = bytes(range(32))
    number = variants(key, ["ada"])["ada"]
    answer = exercises()["05.5"].answer(**exercises()["05.5"].given(number)).tolist()
    own = {"05.5": f"origin = {answer}"}
    for exercise in ("05.2", "05.3"):  # the letters of ada's own lesson
        for_all, hers = exercises()[exercise].letters(), exercises()[exercise].letters(number)
        seen = {for_all[option]: hers[option] for option in for_all}
        own[exercise] = re.sub(r'"(\w)"', lambda m, seen=seen: f'"{seen[m[1]]}"', RIGHT[exercise])
    root = autograder(tmp_path, NOISY | own, key=key)
    told = run_autograder(root)
    scores = {test["number"]: test["score"] for test in told["tests"]}
    assert {n: s for n, s in scores.items() if s} == {
        "05.1": 1,
        "05.2": 3,
        "05.3": 1,
        "05.4": 2,
        "05.5": 1,
    }, "late is Gradescope's own affair"
    assert (
        all({"name", "max_score", "status", "output"} <= test.keys() for test in told["tests"])
        and told["stdout_visibility"] == "hidden"
    )
    assert of_the_format(told, TOLD)
    assert all(of_the_format(test, OF_A_TEST) for test in told["tests"])
    assert {test["status"] for test in told["tests"]} <= {"passed", "failed"}
    assert told["execution_time"] >= 0 and "Run in" in told["output"] and "score" not in told
    inside = b"".join(path.read_bytes() for path in (root / "source").rglob("*") if path.is_file())
    assert key not in inside and key.hex().encode() not in inside


@pytest.mark.cage
@pytest.mark.skipif(os.name == "nt", reason="Gradescope runs Linux")
def test_gradescope_shows_no_test_and_survives_a_stranger(tmp_path, monkeypatch):
    """By the library that is installed: what stands in the zip is looked at above."""
    answers = {**WRONG, "05.4": "def dh_transform(theta, d, a, alpha):\n    return [theta]"}
    start, rooms = Cage._start, []
    monkeypatch.setattr(Cage, "_start", lambda self: rooms.append(self.room) or start(self))
    found = results(autograder(tmp_path, answers, user="stranger@example.org"))
    close()
    assert sorted(rooms) == ["open", "own"]  # none is started only to see that it works
    assert "seen at" not in json.dumps(found)
    assert sum(test["score"] for test in found["tests"]) == 0.5


@pytest.mark.parametrize(
    "users", [[{"email": None}], None, [{"email": None}, {"email": "Bo@x.org"}]]
)
def test_gradescope_knows_accounts_without_an_address(tmp_path, users):
    (tmp_path / "source").mkdir()
    (tmp_path / "source" / "variants.json").write_text('{"bo@x.org": 7}', encoding="utf-8")
    told = json.dumps({"users": users})
    (tmp_path / "submission_metadata.json").write_text(told, encoding="utf-8")
    known = ("bo@x.org", 7) if len(users or ()) > 1 else ("unknown", 0)
    assert _student(tmp_path) == known


@pytest.mark.skipif(os.name == "nt", reason="Gradescope runs Linux")
def test_gradescope_gives_no_marks_without_walls(tmp_path, monkeypatch, capsys):
    def refuses(self, level=None, *limits):
        if level != "rlimits":
            raise ValueError("grade: expected the cage to work")

    monkeypatch.setattr(Cage, "__init__", refuses)
    root = autograder(tmp_path, RIGHT, key=bytes(32))
    monkeypatch.setattr(sys, "argv", ["gradescope_run", str(root)])
    with pytest.raises(SystemExit) as stopped:
        main()
    running._cages.clear()  # the one that was only tried
    assert "write cage: rlimits into course.yaml and export again" in str(stopped.value.code)
    assert "\n" not in str(stopped.value.code)
    assert not (root / "results" / "results.json").exists()


@pytest.mark.cage
@pytest.mark.skipif(os.name == "nt", reason="Gradescope runs Linux")
def test_gradescope_with_limits_alone_holds_no_others_numbers(tmp_path):
    root = autograder(tmp_path, {}, key=bytes(32))
    place = root / "source" / "variants.json"
    assert set(json.loads(place.read_text())) == {"ada@example.org", "bo@example.org"}
    (root / "source" / "course.yaml").write_text(COURSE + "cage: rlimits\n")
    [notebook] = (root / "submission").iterdir()
    read = f"rule = 'b'\nif 'bo@' in open({str(place)!r}).read(): rule = ''"
    made = nbformat.read(notebook, as_version=4)
    nbformat.write(fill_in(made, {"05.2": read}), notebook)
    found = results(root)
    close()
    assert "Run in: rlimits." in found["output"]
    assert json.loads(place.read_text()) == variants_by_address("ada", bytes(32))
    [rule] = [test for test in found["tests"] if test["number"] == "05.2"]
    assert "expected one of" not in rule["output"], "the addresses of others were read"


def variants_by_address(student, key):
    return {f"{student}@example.org": variants(key, [student])[student]}


def test_gradescope_needs_addresses(tmp_path):
    with pytest.raises(ValueError, match="e-mail address"):
        export_gradescope(tmp_path / "a.zip", [Student("ada")], bytes(32))


# ---- gradebooks


def graded_folder(tmp_path):
    (tmp_path / "graded" / "marks").mkdir(parents=True)
    marks = (Mark("05.1", "right", 1, 1), Mark("05.2", "right", 2, 2), Mark("05.3", "wrong", 0, 1))
    none = tuple(Mark(mark.exercise, "not attempted", 0, mark.of) for mark in marks)
    for graded in (
        Graded("ada", "a", "graded", marks, penalty=0.25),
        Graded("bo", "b", "unreadable", none),
        Graded("cy", "", "missing", none),
        Graded("=evil", "c", "graded", marks),
        Graded("dee", "d", "not attempted", none),
    ):
        (tmp_path / "graded" / "marks" / f"{graded.student}.json").write_text(
            json.dumps(graded.to_dict())
        )
    return tmp_path / "graded"


CLASS = (
    Student("ada", 'Lovelace, "Ada"', "ada@x.org"),
    Student("bo", "=cmd|' /c calc'!A1", "bo@x.org"),
    Student("cy"),
    Student("dee"),
    Student("never"),
)


def test_canvas_gets_its_columns_and_no_silent_zero(tmp_path):
    rows = list(
        csv.reader(io.StringIO(canvas_csv(read_marks(graded_folder(tmp_path)), CLASS), newline=""))
    )
    assert (
        rows[0] == ["Student", "ID", "SIS User ID", "SIS Login ID", "Section", "dhlab 05"]
        and rows[1][0].strip() == "Points Possible"
        and rows[1][-1] == "4"
    )
    points = {row[3]: row[-1] for row in rows[2:]}
    assert points == {"ada": "2.25", "bo": "", "cy": "", "dee": "0", "never": ""}
    assert rows[2][0] == 'Lovelace, "Ada"' and not any(
        cell.startswith(("=", "+", "-", "@")) for row in rows for cell in row
    )


def test_another_reader_of_canvas_files_finds_the_same_points(tmp_path):
    """Of finalgrade, which is written for what Canvas itself exports; an empty cell is no 0. No
    extra installs it: it wants an older ruamel.yaml than dhlab is tested with.
    """
    pytest.importorskip("finalgrade")
    from finalgrade.canvas.read import is_canvas_export, read_canvas

    path = tmp_path / "canvas.csv"
    path.write_text(canvas_csv(read_marks(graded_folder(tmp_path)), CLASS), encoding="utf-8")
    found = read_canvas(path)
    assert is_canvas_export(path) and found["points"].to_dict() == {"dhlab05": 4}
    points, given = found["df_score"]["dhlab05"], found["df_submit"]["dhlab05"]
    assert points[given].to_dict() == {"ada": 2.25, "dee": 0}


def test_moodle_likewise(tmp_path):
    rows = list(
        csv.DictReader(
            io.StringIO(moodle_csv(read_marks(graded_folder(tmp_path)), CLASS), newline="")
        )
    )
    assert {row["ID number"]: row["dhlab 05"] for row in rows} == {
        "ada": "2.25",
        "bo": "",
        "cy": "",
        "dee": "0",
        "never": "",
    }
    assert rows[0]["Email address"] == "ada@x.org" and rows[1]["Full name"].startswith("'=")


def test_marks_that_are_none_are_named(tmp_path):
    with pytest.raises(ValueError, match="found no marks in it"):
        read_marks(tmp_path)
    folder = graded_folder(tmp_path)
    (folder / "marks" / "x.json").write_text('{"student": "x"}')
    with pytest.raises(ValueError, match="grade again"):
        read_marks(folder)


@pytest.mark.parametrize(
    "arguments, words",
    [
        (["nbgrader"], "--out"),
        (["canvas", "no-such", "--out", "g.csv"], "found no marks"),
        (["moodle", "--out", "g.csv"], "GRADED"),
        (["gradescope", "--out", "a.zip", "--key", "no.key"], "no such file"),
        (["otter"], "otter"),
        ([], "Missing command"),
    ],
)
def test_errors_are_one_sentence(tmp_path, arguments, words):
    answer = dhlab("export", *arguments, cwd=tmp_path)
    assert answer.returncode == 2 and words in answer.stderr and answer.stderr.count("\n") == 1


@pytest.mark.slow
def test_the_commands(tmp_path):
    folder = graded_folder(tmp_path)
    (tmp_path / "class.csv").write_text("student,name,email\nada,Ada,ada@x.org\ncy,,\n")
    for verb in ("canvas", "moodle"):
        answer = subprocess.run(
            [
                sys.executable,
                "-m",
                "dhlab",
                "export",
                verb,
                str(folder),
                "--out",
                f"{verb}.csv",
                "--roster",
                "class.csv",
            ],
            capture_output=True,
            text=True,
            cwd=tmp_path,
        )
        assert (
            answer.returncode == 0
            and "Empty, since there is nothing to mark: 1. " in answer.stdout
            and "Left out, since they are not on the roster: =evil, bo, dee." in answer.stdout
            and "2.25" in (tmp_path / f"{verb}.csv").read_text()
        ), answer.stderr
