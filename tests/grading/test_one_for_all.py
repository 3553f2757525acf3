"""One student's files stop nobody else's: names, zips, copies and sizes as an attacker would choose
them; and what a student writes decides neither whose a file is nor when it came.
"""

import io
import json
import os
import sys
import zipfile
from datetime import UTC, datetime
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
import corpus

from dhlab.grading.grade import grade
from dhlab.grading.handing_out.variants import variant, variants
from dhlab.grading.intake.owners import look_whose
from dhlab.grading.intake.roster import Student
from dhlab.grading.intake.submissions import Notebook, Submission, submissions
from dhlab.grading.results.gradebook import Gradebook
from dhlab.grading.results.marks import GRADED, Graded
from dhlab.grading.settings import Lesson, Settings

NOTEBOOK = json.dumps(corpus.solved()).encode()
ROSTER = (Student("zzz_good"), Student("ada"))
KEY = bytes(32)


def put(folder, name, data=NOTEBOOK):
    path = folder / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(data)
    return path


def zipped(files, when=(2020, 1, 1, 0, 0, 0)):
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            archive.writestr(zipfile.ZipInfo(name, when), content)
    return data.getvalue()


@pytest.mark.parametrize("name", ["李" * 65, "李" * 80, "a" * 245, "é" * 120])
def test_a_long_name_has_marks_and_a_page_of_its_own(tmp_path, name):
    put(tmp_path / "in", f"{name}.ipynb")
    (student,) = submissions(tmp_path / "in")
    book = Gradebook(tmp_path / "out")
    with book.alone():
        for one in (student, "李" * 100, "李" * 99 + "x"):
            book.write(Graded(one, "", GRADED, ()))
            assert book.read(one).student == one
    assert set(book.students()) == {student, "李" * 100, "李" * 99 + "x"}


def test_many_small_files_and_zips_in_zips_are_read_little(tmp_path, monkeypatch):
    opened = []
    real = zipfile.ZipFile

    def counted(*args, **named):
        opened.append(args)
        return real(*args, **named)

    many = zipped({f"{number}.txt": b"{}" for number in range(19_000)})
    inner = zipped({"05.ipynb": NOTEBOOK})
    nested = zipped({f"{number}.zip": inner for number in range(400)})
    some = zipped({f"{number}.txt": b"{}" for number in range(300)} | {"05.ipynb": NOTEBOOK})
    for name, data in (("many", many), ("nested", nested), ("some", some)):
        put(tmp_path, f"{name}/x.zip", data)
    monkeypatch.setattr(zipfile, "ZipFile", counted)
    found = submissions(tmp_path)
    assert "too many files" in found["many"].notes[0] and not found["many"].notebooks
    assert 0 < len(found["nested"].notebooks) <= 5 and len(found["some"].notebooks) == 1
    assert len(opened) < 30 and all(len(mine.notes) <= 21 for mine in found.values())


def test_copies_with_foreign_numbers_are_one_students_affair():
    ours = variants(KEY, ["ada", "zzz_good", "bo"])
    found = {}
    for student, count, number in (("ada", 1, 0), ("bo", 1, 0), ("zzz_good", 12, 4711)):
        raw = NOTEBOOK.replace(
            b'"metadata"', b'"variant": %d, "metadata"' % (number or variant(KEY, student)), 1
        )
        books = [Notebook(f"{k}.ipynb", lambda raw=raw: raw, None, "") for k in range(count)]
        found[student] = Submission(student, books)
    roster = [Student(student) for student in found]
    look_whose(found, roster, KEY, ours)
    assert "gives to nobody" in found["zzz_good"].notes[0] and not found["ada"].notes
    with pytest.raises(ValueError, match="1 of 1 students' notebooks"):
        look_whose({"zzz_good": found["zzz_good"]}, roster, KEY, ours)


@pytest.mark.parametrize(
    "forged", ["mallory_555_777_zzz_good.ipynb", "mallory_LATE_555_777_zzz_good.ipynb"]
)
def test_what_a_student_calls_a_file_takes_nobodys_place(tmp_path, forged):
    put(tmp_path, "zzz_good.ipynb")
    put(tmp_path, forged, b'{"cells": []}')
    found = submissions(tmp_path, ROSTER)
    assert [one.name for one in found["zzz_good"].notebooks] == ["zzz_good.ipynb"]
    assert [one.name for one in found["mallory"].notebooks] == [forged]


def test_in_doubt_both_are_held_and_it_is_said(tmp_path):
    put(tmp_path, "zzz_good.ipynb")
    put(tmp_path, "the real zzz_good.ipynb", b'{"cells": []}')
    found = submissions(tmp_path, ROSTER)
    assert [one.name for one in found["zzz_good"].notebooks] == ["zzz_good.ipynb"]
    (other,) = set(found) - {"ada", "zzz_good"}
    assert found[other].notebooks and not found[other].on_roster
    assert any("is held apart" in note and other in note for note in found["zzz_good"].notes)


def test_the_dates_in_a_students_zip_are_the_students(tmp_path):
    path = put(tmp_path / "in", "ada/x.zip", zipped({"05.ipynb": NOTEBOOK}))
    os.utime(path, (1_700_000_000, 1_700_000_000))
    (mine,) = submissions(tmp_path / "in", ROSTER)["ada"].notebooks
    assert mine.when == datetime.fromtimestamp(1_700_000_000, UTC)
    # what the platform gave for all is the platform's, also for a zip in it
    whole = put(
        tmp_path,
        "all.zip",
        zipped({"ada/x.zip": zipped({"05.ipynb": NOTEBOOK})}, (2026, 11, 1, 8, 0, 0)),
    )
    (mine,) = submissions(whole, ROSTER)["ada"].notebooks
    assert mine.when == datetime(2026, 11, 1, 8, tzinfo=UTC)


def test_names_move_no_cursor(tmp_path):
    put(tmp_path, "ada/\x1b[2J\u202egood.ipynb")
    mine = submissions(tmp_path, ROSTER)["ada"]
    assert mine.notebooks[0].name.isprintable()


@pytest.mark.cage
def test_pictures_cost_no_points(tmp_path):
    notebook = corpus.solved()
    notebook["cells"][3]["outputs"] = [
        {"output_type": "display_data", "metadata": {}, "data": {"image/png": "A" * 50_000_000}}
    ]
    put(tmp_path / "in", "ada/05.ipynb", json.dumps(notebook).encode())
    put(tmp_path / "in", "bo/05.ipynb")
    results, _ = grade(tmp_path / "in", tmp_path / "out", settings=Settings({"05": Lesson()}))
    assert [one.points for one in results] == [12, 12]
