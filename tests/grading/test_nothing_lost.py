"""What a class has earned stays: lessons graded one after the other, latecomers, foreign files, a
wrong key; and every mark says where it comes from.
"""

import csv
import json
import os
import shutil
import sys
import zipfile
from datetime import UTC, datetime
from pathlib import Path

import nbformat
import pytest
from terminal import dhlab

from dhlab.grading.grade import grade
from dhlab.grading.handing_out.release import with_variant
from dhlab.grading.handing_out.variants import variant
from dhlab.grading.intake.roster import Student, read_roster
from dhlab.grading.intake.submissions import submissions
from dhlab.grading.plan import plan
from dhlab.grading.reports.classreport import class_report
from dhlab.grading.reports.feedback import feedback_page
from dhlab.grading.reports.items import items
from dhlab.grading.results.marks import Graded, Mark
from dhlab.grading.results.standing import together
from dhlab.grading.settings import Lesson, Settings

ROOT = Path(__file__).parents[2]
KEY, OTHER = b"k" * 32, b"o" * 32
ROSTER = (
    Student("s1021", "Jonas Maier"),
    Student("ada", "Ada Lovelace"),
    Student("bo", "Bo Müller"),
)
RULE = 'rule = "b"'
ZONE = UTC
pytestmark = [
    pytest.mark.skipif(
        not hasattr(os, "fork"), reason="submissions run apart on Linux and macOS only"
    ),
    pytest.mark.usefixtures("kept_cages"),
]


def notebook(lesson="05", number=0, answered=True):
    """The bytes of a lesson as handed out; with 05.2, or the first choice of another lesson,
    answered.
    """
    [path] = (ROOT / "lessons").glob(f"{lesson}-*.ipynb")
    text = path.read_text(encoding="utf-8")
    made = nbformat.reads(with_variant(text, number) if number else text, as_version=4)
    if answered:
        solved = {
            cell.metadata["exercise"]: cell.source
            for cell in nbformat.read(ROOT / "solutions" / path.name, as_version=4).cells
            if "exercise" in cell.metadata
        }
        for cell in made.cells:
            if cell.metadata.get("exercise") == f"{lesson}.2":
                cell.source = solved[f"{lesson}.2"]
    return nbformat.writes(made).encode()


def put(path, data, when=None):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(data)
    if when:
        os.utime(path, (when, when))


def by_student(results):
    return {graded.student: graded for graded in results}


def rows(out):
    with open(out / "grades.csv", encoding="utf-8", newline="") as file:
        return {row["student"]: row for row in csv.DictReader(file)}


def only(*lessons):
    return Settings({lesson: Lesson() for lesson in lessons})


def points(graded, lesson):
    return sum(mark.points for mark in graded.marks if mark.lesson == lesson)


@pytest.mark.cage
def test_a_second_lesson_and_latecomers_leave_the_marks_there_are(tmp_path):
    out = tmp_path / "graded"
    for student in ("ada", "bo"):
        put(tmp_path / "w5" / student / "05.ipynb", notebook("05"))
    put(tmp_path / "w6" / "bo" / "06.ipynb", notebook("06"))
    put(tmp_path / "late" / "s1021" / "05.ipynb", notebook("05"))
    first = by_student(grade(tmp_path / "w5", out, roster=ROSTER, settings=only("05"))[0])
    assert first["ada"].points > 0 and first["s1021"].status == "missing"
    second = by_student(grade(tmp_path / "w6", out, roster=ROSTER, settings=only("06"))[0])
    assert (
        second["ada"].status == "graded"
        and points(second["ada"], "05") == first["ada"].points
        and points(second["bo"], "06") > 0 < points(second["bo"], "05")
    )
    third = by_student(grade(tmp_path / "late", out, roster=ROSTER, settings=only("05"))[0])
    assert points(third["s1021"], "05") > 0 and points(third["bo"], "06") == points(
        second["bo"], "06"
    )
    handed_in = (tmp_path / "w5" / "ada" / "05.ipynb").stat().st_mtime
    date = f"{datetime.fromtimestamp(handed_in, ZONE):%Y-%m-%d}"
    assert (
        points(third["ada"], "05") == first["ada"].points
        and f"lesson 05: no file this time; the marks of {date} stand" in third["ada"].notes
    )
    fourth = by_student(grade(tmp_path / "late", out, settings=only("05"))[0])
    assert (
        points(fourth["ada"], "05") == first["ada"].points
        and fourth["ada"].notes.count(third["ada"].notes[-1]) == 1
    ), "nor without a roster"
    table = rows(out)
    assert (
        table["ada"]["total"] == f"{first['ada'].total:g}"
        and table["ada"]["06.1"] == ""
        and table["bo"]["06.2"] != ""
    ), "what was not handed in is no 0"


@pytest.mark.cage
def test_a_file_that_cannot_be_read_takes_no_mark_away(tmp_path):
    put(tmp_path / "in" / "ada" / "05.ipynb", notebook("05"))
    before = grade(tmp_path / "in", tmp_path / "out", settings=only("05"))[0][0]
    put(tmp_path / "in" / "ada" / "05.ipynb", b"{")
    [after] = grade(tmp_path / "in", tmp_path / "out", settings=only("05"))[0]
    assert (
        after.points == before.points > 0
        and after.status == "graded"
        and "the file cannot be read; the marks of" in after.notes[-1]
    )


def test_lateness_is_kept_for_each_lesson():
    late = Graded(
        "ada",
        "5",
        "graded",
        (Mark("05.1", "right", 2, 2, file="5", late_days=1, penalty=0.5),),
        late_days=1,
        penalty=0.5,
    )
    new = Graded(
        "ada", "6", "graded", (Mark("05.1", "not handed in", 0, 2), Mark("06.1", "right", 2, 2))
    )
    both = together(late, new)
    assert (both.points, both.total, both.late_days, both.file) == (4, 3, 1, "5; 6")


@pytest.mark.parametrize(
    "name, text",
    [
        ("grades.csv", "mine\n"),
        ("class-report.html", "<p>mine"),
        ("feedback/ada.html", "<p>mine"),
        ("marks/ada.json", "{}"),
    ],
)
def test_what_dhlab_did_not_write_stays(tmp_path, name, text):
    put(tmp_path / "in" / "ada" / "05.ipynb", notebook())
    put(tmp_path / "out" / name, text.encode())
    with pytest.raises(ValueError, match="move it away"):
        grade(tmp_path / "in", tmp_path / "out")
    assert (tmp_path / "out" / name).read_text() == text and len(
        [path for path in (tmp_path / "out").rglob("*") if path.is_file()]
    ) == 1


def hand_in(folder, numbers):
    for student, number in numbers.items():
        put(folder / student / "05.ipynb", notebook(number=number))


def test_a_forgotten_key_or_another_one_stops_before_anybody_is_marked(tmp_path):
    hand_in(tmp_path / "in", {student.student: variant(KEY, student.student) for student in ROSTER})
    with pytest.raises(
        ValueError, match="3 of 3 students' notebooks have numbers of their own; give the key"
    ):
        grade(tmp_path / "in", tmp_path / "out", roster=ROSTER)
    with pytest.raises(
        ValueError, match="3 of 3 .*notebooks have other numbers than this key gives"
    ):
        grade(tmp_path / "in", tmp_path / "out", roster=ROSTER, key=OTHER)
    assert not (tmp_path / "out").exists() and all(
        not mine.notes for mine in plan(tmp_path / "in", ROSTER, KEY).found.values()
    )


@pytest.mark.cage
def test_numbers_of_somebody_else_and_of_nobody_are_told(tmp_path):
    hand_in(
        tmp_path / "in",
        {
            "bo": variant(KEY, "ada"),
            "ada": variant(KEY, "ada"),
            "s1021": 0,
            "jonas": variant(KEY, "s1021"),
            "adah": 77,
        },
    )
    results, _planned = grade(tmp_path / "in", tmp_path / "out", roster=ROSTER, key=KEY)
    by = by_student(results)
    assert (
        by["bo"].numbers_of == "ada"
        and "has the numbers of ada (Ada Lovelace)" in by["bo"].notes[0]
        and by["ada"].notes == ()
        and by["ada"].numbers_of is None
    )
    assert "the same for all: was it the lesson of the course" in by["s1021"].notes[0]
    assert "these are the numbers of s1021 (Jonas Maier)" in by["jonas"].notes[0] and by[
        "jonas"
    ].variant == variant(KEY, "s1021")
    assert "perhaps ada (Ada Lovelace)" in by["adah"].notes[0]
    page = class_report(results, ROSTER)
    assert (
        "<b>Bo Müller (bo)</b> handed in a notebook with the numbers of <b>Ada Lovelace (ada)</b>"
        in page
    )
    assert (
        "3 on the roster, 2 that match nobody on it" in page
        and "<b>jonas</b>: not on the roster; these are the numbers" in page
    )


@pytest.mark.parametrize(
    "first, second",
    [
        ("mullerbo_LATE_12346_1_05.ipynb", "mullerbo_12347_2_05.ipynb"),
        (
            "Müller Bo_777126_assignsubmission_file_/05.ipynb",
            "Müller Bo_777127_assignsubmission_file_/05.ipynb",
        ),
    ],
)
@pytest.mark.parametrize("roster", [ROSTER, (*ROSTER, Student("bo2", "Bo Müller")), ()])
def test_two_people_of_one_name_are_two(tmp_path, first, second, roster):
    for name in (first, second, "other_1_1_05.ipynb"):
        put(tmp_path / name, b'{"cells": []}')
    found = {
        student: mine for student, mine in submissions(tmp_path, roster).items() if mine.notebooks
    }
    assert (
        len(found) == 3
        and all(len(mine.notebooks) == 1 for mine in found.values())
        and "bo" not in found
    )


def test_one_person_with_two_files_is_one(tmp_path):
    for name in (
        "mullerbo_12346_1_05.ipynb",
        "mullerbo_12346_2_06.ipynb",
        "ada_1_2_a.ipynb",
        "ada_3_4_b.ipynb",
    ):
        put(tmp_path / name, b'{"cells": []}')
    found = submissions(tmp_path, ROSTER)
    assert len(found["bo"].notebooks) == len(found["ada"].notebooks) == 2


@pytest.mark.cage
def test_when_it_came_and_how_that_is_known(tmp_path):
    from zoneinfo import ZoneInfo

    zone = ZoneInfo("Asia/Shanghai")
    put(tmp_path / "in" / "ada" / "ps" / "05.ipynb", notebook(), 2_000_000_000)
    put(tmp_path / "in" / "ada" / "ps" / "timestamp.txt", b"2026-11-17 10:03:12.5 UTC")
    (tmp_path / "in" / "bo").mkdir()
    with zipfile.ZipFile(tmp_path / "in" / "bo" / "x.zip", "w") as archive:
        # a date in a student's own zip is the student's
        archive.writestr(zipfile.ZipInfo("05.ipynb", (2026, 11, 1, 12, 0, 0)), notebook())
    late = datetime(2026, 11, 17, 18, 30, tzinfo=zone).timestamp()
    os.utime(tmp_path / "in" / "bo" / "x.zip", (late, late))
    put(
        tmp_path / "in" / "s1021" / "05.ipynb",
        notebook(),
        datetime(2026, 11, 16, 1, tzinfo=ZONE).timestamp(),
    )
    settings = Settings(
        {"05": Lesson(datetime(2026, 11, 17, 18, 0, tzinfo=zone))}, percent_per_day=10, zone=zone
    )
    by = by_student(grade(tmp_path / "in", tmp_path / "out", roster=ROSTER, settings=settings)[0])
    assert {student: (graded.late_days > 0, graded.penalty) for student, graded in by.items()} == {
        "ada": (True, 0.1),
        "bo": (True, 0.1),
        "s1021": (False, 0),
    }
    assert {student: row["handed_in"] for student, row in rows(tmp_path / "out").items()} == {
        "ada": "2026-11-17 18:03, timestamp.txt",
        "bo": "2026-11-17 18:30, file time",
        "s1021": "2026-11-16 09:00, file time",
    }
    (tmp_path / "course.yaml").write_text(
        'timezone: Asia/Shanghai\nlessons: {"05": {due: 2026-11-17 18:00}}\nlate: {percent_per_day:'
        " 10}\n"
    )
    shown = dhlab(
        "grade", "in", "--out", "out2", "--course", "course.yaml", "--dry-run", cwd=tmp_path
    ).stdout
    assert (
        "2026-11-17 18:30, file time, 30 min late: 10 % off" in shown
        and "2026-11-16 09:00, file time" in shown
    )


def test_a_students_own_timestamp_counts_for_nothing(tmp_path):
    for folder in ("Müller Bo_777126_assignsubmission_file_/x", "ada"):
        put(tmp_path / folder / "05.ipynb", notebook(), 2_000_000_000)
        put(tmp_path / folder / "timestamp.txt", b"2026-11-17 10:03:12 UTC")
    with zipfile.ZipFile(tmp_path / "s1021.zip", "w") as archive:
        for name, data in (
            ("a/05.ipynb", notebook()),
            ("a/timestamp.txt", b"2020-01-01 00:00:00 UTC"),
        ):
            archive.writestr(zipfile.ZipInfo(name, (2030, 1, 1, 0, 0, 0)), data)
    os.utime(tmp_path / "s1021.zip", (1_900_000_000,) * 2)  # 2030-03-17, when it came
    found = submissions(tmp_path, ROSTER)
    handed_in = [own for mine in found.values() for own in mine.notebooks]
    assert {own.source for own in handed_in} == {"file time"} and len(found) == 3
    assert sorted(own.when.timestamp() for own in handed_in) == [1.9e9, 2e9, 2e9]


def test_copied_files_that_are_all_late_are_doubted(tmp_path):
    put(tmp_path / "ada" / "05.ipynb", notebook(), 2_000_000_000)
    due = Settings({"05": Lesson(datetime(2030, 1, 1, tzinfo=ZONE))}, percent_per_day=10)
    assert (
        any("were the files copied?" in note for note in plan(tmp_path, settings=due).notes)
        and plan(tmp_path, settings=only("05")).notes == ()
    )


@pytest.mark.cage
def test_a_lesson_that_was_not_handed_in_is_no_silent_zero(tmp_path):
    put(tmp_path / "in" / "ada" / "05.ipynb", notebook("05"))
    put(tmp_path / "in" / "ada" / "old" / "05.ipynb", notebook("05", answered=False))
    put(tmp_path / "in" / "bo" / "06.ipynb", notebook("06"))
    by = by_student(grade(tmp_path / "in", tmp_path / "out", settings=only("05", "06"))[0])
    ada = by["ada"]
    assert {mark.status for mark in ada.marks if mark.lesson == "06"} == {
        "not handed in"
    } and "lesson 06: no file was found" in ada.notes
    assert "lesson 05: 2 files; the answers are those of ada/05.ipynb" in ada.notes
    assert "No file for lesson 06 was found" in feedback_page(
        ada
    ) and "lesson 05 was" not in feedback_page(ada)
    assert all(item.statuses.total() == 1 for item in items(by.values()))


def test_a_question_is_doubted_by_one_rule():
    def cohort(wrong):
        return [
            Graded(
                f"s{i}",
                "",
                "graded",
                (
                    Mark("05.1", "wrong" if i >= 30 - wrong else "right", i < 30 - wrong, 1),
                    Mark("05.2", "right" if i >= 20 else "wrong", float(i >= 20), 1),
                ),
            )
            for i in range(30)
        ]

    few, many = items(cohort(2))[0], items(cohort(4))[0]
    assert (
        few.discrimination < 0 > many.discrimination
        and not few.suspect
        and "misleading" not in few.warning
        and many.suspect
        and "misleading" in many.warning
    )


@pytest.mark.parametrize("out", ["in", "in/graded"])
def test_marks_are_not_written_among_the_submissions(tmp_path, out):
    put(tmp_path / "in" / "ada" / "05.ipynb", notebook())
    with pytest.raises(ValueError, match="outside the submissions"):
        grade(tmp_path / "in", tmp_path / out)
    assert not list(tmp_path.rglob("marks"))


def test_a_loose_note_is_no_student(tmp_path):
    put(tmp_path / "ada" / "05.ipynb", notebook())
    put(tmp_path / "notes from me.txt", b"buy milk")
    put(tmp_path / "bo.docx", b"PK")
    planned = plan(tmp_path, ROSTER)
    assert (
        set(planned.found) == {"s1021", "ada", "bo"}
        and any("notes from me.txt" in note for note in planned.notes)
        and planned.found["bo"].notes
    )


def test_one_exercise_of_a_lesson_that_is_not_graded_is_refused(tmp_path):
    put(tmp_path / "in" / "ada" / "05.ipynb", notebook())
    with pytest.raises(ValueError, match="name its lesson in course.yaml"):
        grade(tmp_path / "in", tmp_path / "out", settings=only("05", "06"), exercise="07.1")
    with pytest.raises(ValueError, match="without --exercise first"):
        grade(tmp_path / "in", tmp_path / "out", settings=only("05", "06"), exercise="05.1")


def test_what_a_program_says_of_its_error_is_not_in_the_feedback():
    page = feedback_page(
        Graded(
            "ada",
            "",
            "graded",
            (
                Mark(
                    "05.4",
                    "wrong",
                    0,
                    2,
                    headline="the function stops with ValueError: SECRET 0.25",
                ),
                Mark("05.1", "error", 0, 2, headline="the cell stops with E0_25: SECRET"),
            ),
        )
    )
    assert "SECRET" not in page and "stops with ValueError" in page and "E0_25" not in page


def test_lateness_is_told_in_hours_and_what_is_no_notebook_is_called_so():
    assert "Handed in 1 h 30 min late: 10 %" in feedback_page(
        Graded("ada", "a", "graded", (), late_days=0.0625, penalty=0.1)
    )
    unreadable = feedback_page(Graded("ada", "", "unreadable", ()))
    assert "is no notebook" in unreadable and "Open it in JupyterLab" not in unreadable


def test_who_made_a_mistake_without_a_name_is_named():
    assert "Without a name:</b> Ada Lovelace (ada)" in class_report(
        [Graded("ada", "", "graded", (Mark("05.1", "wrong", 0, 1),))], ROSTER
    )


@pytest.mark.parametrize(
    "text, words",
    [
        (
            "student,langauge\nada,en\n",
            'line 1: unknown column "langauge"; did you mean "language"',
        ),
        ("student,name\nada,Lovelace, Ada\n", "line 2: expected 2 cells"),
        ("student\nli\nbo\nli\n", "lines 2 and 4: expected every id once"),
        ("student\nx y\n", "line 2"),
        ("student\nCON\n", "Windows"),
        ("student\ncom1.x\n", "Windows"),
    ],
)
def test_rosters_are_read_strictly(tmp_path, text, words):
    (tmp_path / "r.csv").write_text(text)
    with pytest.raises(ValueError, match=words) as error:
        read_roster(tmp_path / "r.csv")
    assert "small and capital" not in str(error.value)


def test_a_stopped_run_says_how_to_go_on(tmp_path, monkeypatch, capsys):
    import dhlab.grading.grade as module
    from dhlab.cli.app import main

    def stop(*args, **options):
        raise KeyboardInterrupt

    monkeypatch.setattr(module, "grade", stop)
    monkeypatch.setattr(
        sys, "argv", ["dhlab", "grade", str(tmp_path), "--out", str(tmp_path / "out")]
    )
    with pytest.raises(SystemExit) as ended:
        main()
    assert (
        ended.value.code == 130 and "run the same command again to go on" in capsys.readouterr().err
    )


def test_gradebooks_refuse_over_an_existing_file_without_python(tmp_path):
    (tmp_path / "marks").mkdir()
    (tmp_path / "marks" / "ada.json").write_text(
        json.dumps(Graded("ada", "", "graded", (Mark("05.1", "right", 1, 1),)).to_dict())
    )
    (tmp_path / "c.csv").write_text("mine")
    answer = dhlab("export", "canvas", ".", "--out", "c.csv", cwd=tmp_path)
    assert (
        answer.returncode == 2
        and "overwrite" not in answer.stderr
        and (tmp_path / "c.csv").read_text() == "mine"
    )


@pytest.mark.slow
def test_gradescope_asks_for_the_key_or_for_same(tmp_path):
    (tmp_path / "r.csv").write_text("student,email\nada,a@x.org\n")
    (tmp_path / "teacher.key").write_text(KEY.hex())
    answer = dhlab("export", "gradescope", "--out", "a.zip", "--roster", "r.csv", cwd=tmp_path)
    assert answer.returncode == 2 and "--key" in answer.stderr and not (tmp_path / "a.zip").exists()
    shutil.move(tmp_path / "teacher.key", tmp_path / "k")
    assert (
        dhlab(
            "export", "gradescope", "--out", "a.zip", "--roster", "r.csv", cwd=tmp_path
        ).returncode
        == 0
    )


@pytest.mark.parametrize(
    "name", ["no file was found", "lesson 05: no file was found", "they stand"]
)
def test_a_files_name_takes_no_note_away(name):
    note = f"ada/{name}: has the numbers of bo: look whose work it is"
    ends = f"lesson 05: 2 files; the answers are those of {name}"
    marks = Mark("05.4", "right", 2, 2, file=name), Mark("06.2", "right", 2, 2)
    before = Graded("ada", name, "graded", marks, notes=(note, ends, f"{name}: {note}"))
    new = Graded("ada", "", "graded", (Mark("05.4", "not handed in", 0, 2),))
    for _ in range(2):
        before = together(before, new)
    assert before.notes == (
        note,
        ends,
        f"{name}: {note}",
        "lesson 05: no file this time; the marks of before stand",
    )
