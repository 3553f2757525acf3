"""What one student may cost outside the cage: however much is handed in, little of it is read, and
nobody else loses anything by it.
"""

import sys
import zipfile
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
import corpus

from dhlab.grading.intake import notebooks, submissions
from dhlab.grading.intake.files import LARGEST, MOST_FILES
from dhlab.grading.intake.roster import Student
from dhlab.grading.intake.submissions import Notebook, Submission
from dhlab.grading.plan import plan
from dhlab.grading.reports import alike, answered

EMPTY = b'{"cells": []}'


def test_many_zips_of_one_student_have_one_budget(tmp_path):
    (tmp_path / "in" / "mallory").mkdir(parents=True)
    (tmp_path / "in" / "ada").mkdir()
    for number in range(4):
        members = {f"{i}.ipynb": EMPTY for i in range(MOST_FILES // 2)}
        (tmp_path / "in" / "mallory" / f"{number}.zip").write_bytes(corpus.zipped(members))
    (tmp_path / "in" / "ada" / "mine.zip").write_bytes(corpus.zipped({"a.ipynb": EMPTY}))
    roster = [Student("mallory"), Student("ada")]
    found = submissions.submissions(tmp_path / "in", roster)
    assert [one.name for one in found["ada"].notebooks] == ["ada/mine.zip/a.ipynb"]
    told = " ".join(found["mallory"].notes)
    assert f"{MOST_FILES} notebooks" in told and told.count("too many files") == 2


def test_all_notebooks_of_a_student_together_are_no_larger_than_one_may_be():
    mine = Submission("ada")
    for name, size in (("old", LARGEST), ("new", LARGEST // 2), ("newest", LARGEST // 2)):
        mine.notebooks.append(Notebook(name, bytes, None, "", size))
    mine.notebooks[0], mine.notebooks[-1] = mine.notebooks[-1], mine.notebooks[0]
    submissions._settle(mine)  # without a time they stand in the order of their names
    assert [one.name for one in mine.notebooks] == ["old"]
    assert len(mine.notes) == 2 and "80 MB" in mine.notes[0]


def test_a_notebook_is_read_once_to_be_looked_at(tmp_path, monkeypatch):
    read = []
    look = submissions.look
    monkeypatch.setattr(submissions, "look", lambda raw: read.append(raw) or look(raw))
    with zipfile.ZipFile(tmp_path / "in.zip", "w") as file:
        for student in ("ada", "bo"):
            file.writestr(f"{student}/05.ipynb", f'{{"cells": "check(\\"05.1\\", {student})"}}')
    planned = plan(tmp_path / "in.zip")
    assert planned.course.lessons == ("05",) and len(read) == 2


@pytest.mark.parametrize(
    "raw",
    [
        b"[" + b"[]," * 300_000 + b"1]",
        b"[" * 100_000 + b"]" * 100_000,
        b'"' + b"x" * notebooks.LARGEST + b'"',
        b"\xe9",
    ],
    ids=["parts", "depth", "bytes", "no text"],
)
def test_what_is_costly_to_parse_is_not_parsed(raw):
    with pytest.raises(ValueError):
        notebooks.parsed(raw)
    assert answered.read_notebook(raw) == {}


def test_names_and_numbers_are_no_longer_than_real_ones():
    raw = b"".join(b'check("%d.1")  set_variant(%d) ' % (n, n) for n in range(5000))
    seen = notebooks.look(raw)
    assert len(seen.lessons) == len(seen.numbers) + 1 == notebooks.MOST
    assert notebooks.look(b'check("' + b"5" * 99 + b'.1")').lessons == frozenset()


def test_code_made_slow_to_compare_is_cut():
    cells = [corpus.code("+".join(f"x{i}" for i in range(1500)))]
    long = [
        cell
        for key in [*corpus.LESSON, *(f"77.{n}" for n in range(50))]
        for cell in (*cells, corpus.code(f"check({key!r}, 1)"))
    ]
    found = alike.answers({"cells": long})
    assert set(found) == set(corpus.LESSON)
    assert sum(map(len, found.values())) == alike.MOST


def test_an_answer_of_thousands_of_numbers_is_not_compared():
    from dhlab.course.exercises import exercises
    from dhlab.grading.inside.wire import encode
    from dhlab.grading.judging import judge
    from dhlab.grading.settings import Settings

    for answer in ([[0.5] * 40] * 40, {f"k{n}": [0.5] * 9 for n in range(200)}):
        line = {"value": encode(answer)}
        found = judge._judged(exercises()["05.9"], line, 0, Settings(), 1)
        assert found.status == "wrong" and "cannot be read" in found.headline


def test_half_a_letter_stops_no_class():
    import os
    import time

    from dhlab.grading.cage.listener import Listener

    read, write = os.pipe()
    os.write(
        write, b'{"cell": 1, "ended": "error", "message": "\\ud800x", "ids": []}\n{"done": 1}\n'
    )
    os.close(write)
    run = Listener(read, 5, time.monotonic() + 5).listen()
    os.close(read)
    assert run.ended == "done" and run.lines[0]["message"] == "?x"
    run.lines[0]["message"].encode()  # what no file could hold ended the run for everybody
