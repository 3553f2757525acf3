"""A class graded: the same marks however it is done, nothing lost whatever breaks, and the
teacher's settings kept.
"""

import json
import os
import shutil
import signal
import subprocess
import sys
import time
from datetime import UTC, datetime
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
import corpus
from terminal import dhlab

from dhlab.course.exercises import exercises
from dhlab.grading.grade import grade
from dhlab.grading.handing_out.variants import variant
from dhlab.grading.intake.roster import Student
from dhlab.grading.judging import running
from dhlab.grading.plan import plan
from dhlab.grading.results.gradebook import Gradebook
from dhlab.grading.settings import Lesson, Settings

ROSTER = tuple(Student(name) for name in ("ada", "bo", "cy", "dee", "eve", "fay", "gus"))
WRONG = "def dh_closed(theta, d, a, alpha):\n    return dh_transform(theta, d, a, -alpha)"
KEY = b"k" * 32
pytestmark = [
    pytest.mark.skipif(
        not hasattr(os, "fork"), reason="submissions run apart on Linux and macOS only"
    ),
    pytest.mark.usefixtures("kept_cages"),
]


@pytest.fixture(scope="module")
def reference(tmp_path_factory):
    """Six of seven hand in: right, one mistake, an error, untouched, the library called, broken.
    (folder, results, out) of one job.
    """
    top = tmp_path_factory.mktemp("reference")
    for student, change in {
        "ada": None,
        "bo": corpus.answer("05.6", WRONG),
        "cy": corpus.blog("raise ValueError('x')"),
        "eve": corpus.closed(f"return {corpus.FORWARD}"),
    }.items():
        hand_in(top / "class", student, change)
    (top / "class" / "dee").mkdir()
    shutil.copy(corpus.ROOT / "lessons" / "05-link-matrix.ipynb", top / "class" / "dee")
    (top / "class" / "fay").mkdir()
    (top / "class" / "fay" / "05.ipynb").write_text("{", encoding="utf-8")
    return top / "class", grade(top / "class", top / "out", roster=ROSTER)[0], top / "out"


@pytest.fixture
def folder(reference, tmp_path):
    """A copy of the class, to be changed."""
    return shutil.copytree(reference[0], tmp_path / "class")


def handed_out():
    """The lesson as everybody gets it."""
    path = corpus.ROOT / "lessons" / "05-link-matrix.ipynb"
    notebook = json.loads(path.read_text(encoding="utf-8"))
    for cell in notebook["cells"]:
        cell["source"] = "".join(cell["source"])
    return notebook


def hand_in(folder, student, change=None, replace=(), of=corpus.solved):
    """Write a submission made from the right one, or another."""
    notebook = of()
    if change:
        change(notebook, {})
    text = json.dumps(notebook)
    for old, new in replace:
        assert json.dumps(old)[1:-1] in text
        text = text.replace(json.dumps(old)[1:-1], json.dumps(new)[1:-1])
    (folder / student).mkdir(parents=True, exist_ok=True)
    (folder / student / "05-link-matrix.ipynb").write_text(text, encoding="utf-8")


def on_disk(out):
    """All marks as they stand on disk, but for the seconds they took and the number that inputs
    are drawn from.
    """
    found = {
        path.stem: json.loads(path.read_text(encoding="utf-8"))
        for path in (out / "marks").glob("*.json")
    }
    return {
        student: {key: value for key, value in graded.items() if key not in ("seconds", "number")}
        for student, graded in found.items()
    }


def marks_in(out):
    return sorted((out / "marks").glob("*.json"))


def test_a_class(reference):
    _, results, out = reference
    by = {graded.student: graded for graded in results}
    assert [graded.student for graded in results] == [student.student for student in ROSTER]
    assert {s: g.status for s, g in by.items()} == {
        "ada": "graded",
        "bo": "graded",
        "cy": "graded",
        "dee": "not attempted",
        "eve": "graded",
        "fay": "unreadable",
        "gus": "missing",
    }
    assert by["ada"].points == by["ada"].of == sum(exercises()[key].points for key in corpus.LESSON)
    marks = {s: {m.exercise: m for m in g.marks} for s, g in by.items()}
    assert all(set(own) == set(corpus.LESSON) for own in marks.values())
    assert (marks["bo"]["05.6"].status, marks["bo"]["05.6"].mistake, by["bo"].points) == (
        "wrong",
        "alpha-sign",
        by["ada"].points - 2,
    )
    assert marks["cy"]["05.7"].status == "wrong" and "ValueError" in marks["cy"]["05.7"].headline
    assert (
        marks["eve"]["05.6"].status == "not allowed"
        and marks["eve"]["05.6"].points == 0
        and "forward" in marks["eve"]["05.6"].headline
    )
    grades = (out / "grades.csv").read_text(encoding="utf-8").splitlines()
    assert (
        len(grades) == 8
        and grades[1].startswith("ada,,graded,12,12,12,0,0,1,")
        and grades[7].startswith("gus,,missing,0,")
    )


def test_one_job_two_jobs_and_a_cluster_that_loses_a_worker_give_the_same(reference, tmp_path):
    """Of the class only one has written programs, so that one worker alone needs a second cage."""
    dask, distributed = pytest.importorskip("dask"), pytest.importorskip("distributed")
    folder = tmp_path / "class"
    shutil.copytree(reference[0], folder, ignore=shutil.ignore_patterns("ada", "cy", "eve"))
    for student, letter in {"ada": "b", "cy": "a", "eve": "?"}.items():
        hand_in(folder, student, corpus.answer("05.2", f'rule = "{letter}"'), of=handed_out)
    outs = one, two, three = [tmp_path / name for name in ("one", "two", "three")]
    grade(folder, one, roster=ROSTER)
    grade(folder, two, roster=ROSTER, jobs=2)
    with (
        # looks into every worker a hundred times a second: a quarter of all that this test takes
        dask.config.set({"distributed.worker.profile.enabled": False}),
        distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None
        ) as cluster,
    ):
        with distributed.Client(cluster) as client:
            first = next(iter(client.run(os.getpid).values()))
            client.run(_for_good, nanny=True)

        def kill_one(done, of):
            if done == 1:
                os.kill(first, signal.SIGKILL)

        address = cluster.scheduler_address
        grade(folder, three, roster=ROSTER, scheduler=address, progress=kill_one)
    found = on_disk(one)
    points = {student: sum(m["points"] for m in own["marks"]) for student, own in found.items()}
    assert points == {**dict.fromkeys(points, 0), "ada": 1, "bo": 10} and len(points) == 7
    assert found == on_disk(two) == on_disk(three)
    grades = [(out / "grades.csv").read_bytes() for out in outs]
    assert grades[0] == grades[1] == grades[2]


def _for_good(dask_worker):
    """A worker that is lost is not started again."""
    dask_worker.auto_restart = False


def test_two_graders_do_not_share_a_folder(reference, tmp_path):
    folder, _, _ = reference
    with Gradebook(tmp_path / "out").alone():
        second = dhlab("grade", folder, "--out", tmp_path / "out")
    assert (
        second.returncode != 0
        and "another grader is at work in it" in " ".join(second.stderr.replace("│", " ").split())
        and on_disk(tmp_path / "out") == {}
    )
    with Gradebook(tmp_path / "out").alone():
        pass


def test_what_is_made_of_the_marks_is_made_before_another_grader_may_write(reference, tmp_path):
    folder, _, whole = reference
    out = tmp_path / "out"
    shutil.copytree(whole, out)
    refused = []

    def finish(results, planned):
        with pytest.raises(ValueError, match="another grader is at work"), Gradebook(out).alone():
            pass
        refused.append([one.student for one in results])

    grade(folder, out, roster=ROSTER, finish=finish)
    assert refused == [[student.student for student in ROSTER]]


def test_killed_in_the_middle_and_taken_up_again(reference, tmp_path):
    folder, _, whole = reference
    # who has no programs comes first: then the grader is killed with one cage, not with two
    out, roster = (
        tmp_path / "out",
        _roster(tmp_path, sorted(ROSTER, key=lambda s: s.student != "dee")),
    )
    process = subprocess.Popen(
        [sys.executable, "-m", "dhlab", "grade", folder, "--out", out, "--roster", roster],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    deadline = time.monotonic() + 120
    while not (out / "marks").is_dir() or not list((out / "marks").glob("*.json")):
        assert process.poll() is None and time.monotonic() < deadline
        time.sleep(0.005)
    below = _below(process.pid)
    process.kill()
    process.wait()
    while any(Path(f"/proc/{pid}").exists() for pid in below):  # the cage dies with its grader
        assert time.monotonic() < deadline
        time.sleep(0.01)
    before = {path: path.stat().st_mtime_ns for path in (out / "marks").glob("*.json")}
    assert 0 < len(before) < 7 and all(
        json.loads(path.read_text(encoding="utf-8"))["marks"] for path in before
    )
    run = dhlab("grade", folder, "--out", out, "--roster", roster, "--json")
    assert run.returncode == 0 and len(json.loads(run.stdout)) == 7
    assert all(path.stat().st_mtime_ns == moment for path, moment in before.items())
    assert on_disk(out) == on_disk(whole)
    assert (out / "class-report.html").exists() and len(
        list((out / "feedback").glob("*.html"))
    ) == 7


def _below(pid):
    """The processes that a process has started, and those that they have."""
    try:
        children = [
            int(child) for child in Path(f"/proc/{pid}/task/{pid}/children").read_text().split()
        ]
    except OSError:
        return []
    return [*children, *(one for child in children for one in _below(child))]


def test_a_full_disk_and_a_folder_that_cannot_be_written(reference, tmp_path):
    folder, _, whole = reference
    out = tmp_path / "out"
    out.mkdir()
    if subprocess.run(
        ["mount", "-t", "tmpfs", "-o", "size=256k", "tmpfs", str(out)], capture_output=True
    ).returncode:
        pytest.skip("mounting a small disk takes root")
    try:
        (out / "filler").write_bytes(bytes(248 * 1024))
        full = dhlab("grade", folder, "--out", out, "--roster", _roster(tmp_path))
        assert (
            full.returncode == 2
            and full.stderr.count("\n") == 1
            and "expected to write here" in full.stderr
        )
        assert all(
            json.loads(path.read_text(encoding="utf-8"))["marks"]
            for path in (out / "marks").glob("*.json")
        )
        subprocess.run(["mount", "-o", "remount,ro", str(out)], check=True)
        locked = dhlab("grade", folder, "--out", out, "--roster", _roster(tmp_path))
        assert locked.returncode == 2 and locked.stderr.count("\n") == 1
        subprocess.run(["mount", "-o", "remount,rw,size=8m", str(out)], check=True)
        (out / "filler").unlink()
        grade(folder, out, roster=ROSTER)
        assert (
            on_disk(out) == on_disk(whole)
            and (out / "grades.csv").read_bytes() == (whole / "grades.csv").read_bytes()
        )
    finally:
        subprocess.run(["umount", str(out)], check=True)


def _roster(folder, students=ROSTER):
    path = folder / "roster.csv"
    path.write_text(
        "student\n" + "\n".join(student.student for student in students) + "\n", encoding="utf-8"
    )
    return path


def test_a_second_run_grades_what_is_new_and_one_exercise_leaves_the_rest(folder, tmp_path):
    out = tmp_path / "out"
    grade(folder, out, roster=ROSTER)
    before = {path.stem: path.stat().st_mtime_ns for path in (out / "marks").glob("*.json")}
    hand_in(folder, "gus")
    hand_in(folder, "bo")
    results, _ = grade(folder, out, roster=ROSTER)
    after = {path.stem: path.stat().st_mtime_ns for path in (out / "marks").glob("*.json")}
    assert {student for student in after if after[student] != before[student]} == {"gus", "bo"}
    assert [graded.points for graded in results if graded.student in ("bo", "gus")] == [12, 12]
    path = out / "marks" / "cy.json"
    edited = json.loads(path.read_text(encoding="utf-8"))
    for mark in edited["marks"]:
        mark["note"] = "seen by a person"
    path.write_text(json.dumps(edited), encoding="utf-8")
    numbers = {path: json.loads(path.read_text("utf-8"))["number"] for path in marks_in(out)}
    results, _ = grade(folder, out, roster=ROSTER, exercise="05.7")
    assert numbers == {
        path: json.loads(path.read_text("utf-8"))["number"] for path in marks_in(out)
    }
    assert len(set(numbers.values())) == len(numbers)
    notes = {
        mark.exercise: mark.note for mark in next(g for g in results if g.student == "cy").marks
    }
    assert notes.pop("05.7") == "" and set(notes.values()) == {"seen by a person"}


def test_the_teachers_settings(folder, tmp_path):
    os.utime(folder / "bo" / "05-link-matrix.ipynb", (1_700_000_000, 1_700_000_000))
    due = datetime.fromtimestamp(1_700_000_000 - 30 * 3600, UTC)
    late = Settings(
        {"05": Lesson(due, {"05.6": 4})},
        percent_per_day=10,
        floor=50,
        partial=0.5,
        own_kinematics=0.25,
    )
    by = {graded.student: graded for graded in grade(folder, tmp_path / "out", settings=late)[0]}
    marks = {s: {m.exercise: m for m in g.marks} for s, g in by.items()}
    # half of it, for a mistake that is recognised
    assert (marks["bo"]["05.6"].points, marks["bo"]["05.6"].of) == (2, 4)
    assert (marks["eve"]["05.6"].status, marks["eve"]["05.6"].points) == ("not allowed", 1)
    assert (by["bo"].late_days, by["bo"].penalty, by["bo"].points, by["bo"].total) == (
        1.25,
        0.2,
        12,
        9.6,
    )
    assert by["ada"].penalty == 0.5  # years late


@pytest.mark.cage
def test_variants_come_from_the_key_and_copies_show(tmp_path):
    folder = tmp_path / "class"
    numbers = {student: variant(KEY, student) for student in ("ada", "bo", "cy")}
    copied = [
        (f'given("{key}")', repr(exercises()[key].given(numbers["ada"])))
        for key in ("05.5", "05.9")
    ]
    hand_in(folder, "ada", corpus.first("from dhlab.course import set_variant\nset_variant(99)"))
    hand_in(folder, "bo", replace=copied)
    hand_in(folder, "cy")
    by = {graded.student: graded for graded in grade(folder, tmp_path / "out", key=KEY)[0]}
    assert {student: graded.variant for student, graded in by.items()} == numbers
    letters = {"05.2", "05.3", "05.8"}  # of the lesson for all, in notebooks that are nobody's
    for one in (by["ada"], by["cy"]):
        left = {mark.exercise for mark in one.marks if mark.status == "to be marked"}
        assert left <= letters and one.points == one.of and one.guess_of is None
    assert "to be marked" in {mark.status for mark in by["ada"].marks}
    assert {mark.exercise for mark in by["bo"].marks if mark.status == "wrong"} == {
        "05.5",
        "05.9",
    } and by["bo"].guess_of == "ada"


def test_a_dry_run_runs_and_writes_nothing(folder, tmp_path):
    hand_in(folder, "bad", corpus.first(f"open({str(tmp_path / 'ran')!r}, 'w')"))
    run = dhlab("grade", folder, "--out", tmp_path / "out", "--dry-run")
    assert (
        run.returncode == 0
        and "bad" in run.stdout
        and "Lessons: 05." in run.stdout
        and "Nothing was run or written." in run.stdout
    )
    assert not (tmp_path / "out").exists() and not (tmp_path / "ran").exists()


@pytest.mark.parametrize(
    "change, words",
    [
        ({"exercise": "05.99"}, "number of an exercise"),
        ({"settings": Settings({"77": Lesson()})}, "name the lessons in course.yaml"),
        ({"place": "nowhere"}, "no such folder"),
    ],
)
def test_what_cannot_be_graded(folder, change, words):
    with pytest.raises(ValueError, match=words):
        plan(**{"place": folder, **change})


@pytest.mark.cage
def test_every_lessons_solution_earns_everything_and_its_stubs_nothing(
    tmp_path, kept_cages, monkeypatch
):
    monkeypatch.setattr("dhlab.grading.grade.close", kept_cages)
    for student in ("solutions", "lessons"):
        shutil.copytree(
            corpus.ROOT / student,
            tmp_path / "class" / student,
            ignore=shutil.ignore_patterns("*.md", "teacher"),
        )
    solutions, lessons = sorted(
        grade(tmp_path / "class", tmp_path / "out")[0],
        key=lambda graded: graded.student,
        reverse=True,
    )
    assert running._cages == {}, "no cage stays when a class is graded"
    assert {m.exercise: m.status for m in solutions.marks if m.status != "right"} == {}
    assert solutions.points == solutions.of == sum(e.points for e in exercises().values())
    assert {m.status for m in lessons.marks} == {
        "not attempted"
    } and lessons.status == "not attempted"
