"""What was handed in, found in every layout, and matched with the roster."""

import zipfile

import pytest

from dhlab.grading.intake.roster import Student
from dhlab.grading.intake.submissions import submissions

ROSTER = (
    Student("ada", "Ada Lovelace", "ada.lovelace@example.org"),
    Student("u1234", "Grace Brewster Hopper", "hopper@example.org"),
    Student("li", "李 小龙"),
    Student("ada.b", "Ada Byron"),
)
LESSONS = ("05-link-matrix", "06-forward-kinematics")
NOTEBOOK = b'{"cells": [], "nbformat": 4}'
CANVAS = "lovelaceada_LATE_8812_99123_05-link-matrix-1.ipynb"
LAYOUTS = [
    ("a folder each", "ada/05-link-matrix.ipynb", "ada"),
    ("files by id", "ada_05-link-matrix.ipynb", "ada"),
    ("the id at the end", "05-link-matrix_ada.ipynb", "ada"),
    ("a longer id wins", "ada.b_05-link-matrix.ipynb", "ada.b"),
    ("by mail", "ada.lovelace@example.org/x.ipynb", "ada"),
    ("by the mail's name", "hopper/x.ipynb", "u1234"),
    ("Canvas", CANVAS, "ada"),
    ("Canvas in one word", "hoppergracebrewster_8813_99124_Untitled3.ipynb", "u1234"),
    (
        "Moodle's folders",
        "Grace Brewster Hopper_771_assignsubmission_file_/05-link-matrix.ipynb",
        "u1234",
    ),
    ("Moodle's folders, another order", "Lovelace Ada_771_assignsubmission_file/x.ipynb", "ada"),
    ("Moodle's files", "Grace Brewster Hopper_771_assignsubmission_file_05.ipynb", "u1234"),
    ("not only Latin letters", "李 小龙_5_assignsubmission_file_/a.ipynb", "li"),
    ("nbgrader", "ada/ps1/05-link-matrix.ipynb", "ada"),
    ("a folder per lesson", "lesson05/ada.ipynb", "ada"),
    ("a copy", "ada-Copy1.ipynb", "ada"),
    ("another case", "ADA/work.ipynb", "ada"),
]


def put(folder, name, data=NOTEBOOK):
    """Write a file, with its folders."""
    path = folder / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(data)


@pytest.mark.parametrize(
    "path, student", [layout[1:] for layout in LAYOUTS], ids=[layout[0] for layout in LAYOUTS]
)
@pytest.mark.parametrize("as_zip", [False, True])
def test_layouts(tmp_path, path, student, as_zip):
    folder = tmp_path / "class"
    # beside the id a login counts for nothing
    other = "li" if path.startswith("hopper/") else "u1234"
    for name in (path, f"{other}/other.ipynb"):
        put(folder, name)
    place = folder
    if as_zip:
        place = tmp_path / "class.zip"
        with zipfile.ZipFile(place, "w") as archive:
            for name in (path, f"{other}/other.ipynb"):
                archive.writestr(f"wrapped/{name}", NOTEBOOK)
    found = submissions(place, ROSTER, LESSONS)
    assert list(found) == [s.student for s in ROSTER]
    assert any(path.split("/")[-1] in one.name for one in found[student].notebooks)
    assert {s for s, mine in found.items() if mine.notebooks} == {student, other}
    assert all(one.read() == NOTEBOOK for mine in found.values() for one in mine.notebooks)


@pytest.mark.parametrize(
    "path, student",
    [
        ("ada/05-link-matrix.ipynb", "ada"),
        ("ada_05-link-matrix.ipynb", "ada"),
        ("05-link-matrix - Bo.ipynb", "Bo"),
        ("Ada Lovelace_771_assignsubmission_file_/x.ipynb", "Ada Lovelace"),
        (CANVAS, "lovelaceada"),
        ("05-link-matrix.ipynb", "class"),
    ],
)
def test_without_a_roster_the_name_is_what_is_left(tmp_path, path, student):
    put(tmp_path / "class", path)
    assert list(submissions(tmp_path / "class", (), LESSONS)) == [student]


def test_who_is_not_on_the_roster_is_told(tmp_path):
    put(tmp_path, "stranger/x.ipynb")
    found = submissions(tmp_path, ROSTER, LESSONS)
    assert (
        found["stranger"].notebooks and not found["stranger"].on_roster and found["ada"].on_roster
    )


def test_names_that_could_do_harm(tmp_path):
    put(tmp_path, "$(rm -rf)/x.ipynb")
    put(tmp_path, "=1+1.ipynb")
    assert all(not set("/$()=\n") & set(student) for student in submissions(tmp_path, (), LESSONS))


def test_a_students_own_zip(tmp_path):
    with zipfile.ZipFile(tmp_path / "Ada Lovelace_771_assignsubmission_file_.zip", "w") as archive:
        archive.writestr("work/05.ipynb", NOTEBOOK)
        archive.writestr("__MACOSX/._05.ipynb", b"x")
        archive.writestr("u1234/05.ipynb", NOTEBOOK)  # nobody's name but the outermost counts
    found = submissions(tmp_path, ROSTER, LESSONS)
    assert len(found["ada"].notebooks) == 2 and not found["u1234"].notebooks


def test_oldest_first_and_no_more_than_anyone_needs(tmp_path):
    import os

    for number in range(20):
        put(tmp_path, f"ada/{number}.ipynb")
        os.utime(tmp_path / "ada" / f"{number}.ipynb", (1000 - number, 1000 - number))
    mine = submissions(tmp_path, ROSTER, LESSONS)["ada"]
    assert [one.name for one in mine.notebooks] == [
        f"ada/{number}.ipynb" for number in range(11, -1, -1)
    ] and "20 notebooks" in mine.notes[0]


def test_an_encrypted_zip_is_refused(tmp_path):
    with zipfile.ZipFile(tmp_path / "ada.zip", "w") as archive:
        archive.writestr("x.ipynb", NOTEBOOK)
    data = bytearray((tmp_path / "ada.zip").read_bytes())
    data[data.index(b"PK\x01\x02") + 8] |= 1
    (tmp_path / "ada.zip").write_bytes(data)
    mine = submissions(tmp_path, ROSTER, LESSONS)["ada"]
    assert not mine.notebooks and "encrypted" in mine.notes[0]


@pytest.mark.parametrize(
    "make, words", [(lambda p: p, "no such folder"), (lambda p: p.write_text("x") and p, "neither")]
)
def test_a_place_that_is_none(tmp_path, make, words):
    with pytest.raises(ValueError, match=words):
        submissions(make(tmp_path / "x"), (), LESSONS)
