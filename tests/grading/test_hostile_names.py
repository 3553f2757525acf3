"""What students call themselves and their files takes nothing from anybody else, and a file that
becomes a link once it was looked at leads nowhere.
"""

import os
import re
import zipfile
from datetime import UTC, datetime

import pytest

from dhlab.grading.exports.gradescope import export_gradescope
from dhlab.grading.intake import layouts
from dhlab.grading.intake.layouts import Names
from dhlab.grading.intake.roster import Student, read_roster
from dhlab.grading.intake.submissions import submissions
from dhlab.grading.results.gradebook import Gradebook
from dhlab.grading.results.marks import GRADED, Graded, Mark

NOTEBOOK = b'{"cells": []}'
ADA, MALLORY = Student("ada", "Ada Lovelace", "ada@x.org"), Student("mallory", "Mallory")


def put(path, data=NOTEBOOK, day=1):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(data)
    when = datetime(2026, 11, day, tzinfo=UTC).timestamp()
    os.utime(path, (when, when))


def taken(top, *roster):
    return {
        student: [one.name for one in mine.notebooks]
        for student, mine in submissions(top, roster).items()
    }


def test_a_platforms_name_that_is_anothers_id(tmp_path):
    put(tmp_path / "lovelaceada_771_900_05.ipynb")
    put(tmp_path / "ada_880_901_05.ipynb", day=9)
    assert taken(tmp_path, ADA, MALLORY)["ada"] == ["lovelaceada_771_900_05.ipynb"]


def test_a_name_on_the_roster_that_is_anothers_id(tmp_path):
    put(tmp_path / "ada" / "05.ipynb")
    put(tmp_path / "Ada Lovelace.ipynb", day=9)
    assert "ada/05.ipynb" in taken(tmp_path, ADA, Student("mallory", "ada"))["ada"]


def test_a_letter_that_capitals_make_anothers(tmp_path):
    """A long s is no s, though both have the capital S, and on some systems one file."""
    sam, strasse = Student("sam"), Student("straße")
    for folder in ("SAM", "\u017fam", "STRASSE"):
        put(tmp_path / folder / "05.ipynb")
    found = taken(tmp_path, sam, strasse)
    assert found["sam"] == ["SAM/05.ipynb"] and found["straße"] == ["STRASSE/05.ipynb"]
    assert len({student.casefold() for student in found}) == 3


@pytest.mark.parametrize("other", [("", "lovelaceada@x.org"), ("lovelaceada", "")])
def test_an_address_or_a_name_as_canvas_writes_anothers(tmp_path, other):
    put(tmp_path / "lovelaceada_771_900_05.ipynb")
    assert taken(tmp_path, ADA, Student("mallory", *other))["mallory"] == []


def test_without_a_roster_other_signs_are_another_name(tmp_path):
    for folder in ("ada_l", "ada,l", "ada:l"):
        put(tmp_path / folder / "05.ipynb")
    found = taken(tmp_path)
    assert found["ada_l"] == ["ada_l/05.ipynb"] and len(found) == 3


@pytest.mark.parametrize("depth", [0, 1])
def test_a_folder_that_becomes_a_link(tmp_path, depth):
    own = tmp_path / "class" / "mallory" / "hw"
    put(own / "05.ipynb")
    put(tmp_path / "class" / "ada" / "05.ipynb", b"hers")
    (mine,) = submissions(tmp_path / "class", (ADA, MALLORY))["mallory"].notebooks
    place = (own, own / "05.ipynb")[depth]
    place.rename(tmp_path / "away")
    place.symlink_to(tmp_path / "class" / "ada" / ("05.ipynb" if depth else ""))
    assert mine.read() == b""


def test_a_zip_that_becomes_a_link(tmp_path):
    def zipped(path, data):
        put(path)
        with zipfile.ZipFile(path, "w") as archive:
            archive.writestr("05.ipynb", data)

    for student in ("mallory", "w", "x", "y", "z"):  # of several, not all stay open
        zipped(tmp_path / "class" / student / "x.zip", b"own")
    zipped(tmp_path / "other.zip", b"hers")
    (mine,) = submissions(tmp_path / "class")["mallory"].notebooks
    place = tmp_path / "class" / "mallory" / "x.zip"
    place.unlink()
    place.symlink_to(tmp_path / "other.zip")
    assert mine.read() != b"hers"


def test_marks_are_read_whatever_their_owner_is_called(tmp_path):
    book = Gradebook(tmp_path)
    graded = Graded("coding=utf-16 李, perhaps ada", "x", GRADED, (Mark("05.1", "right", 1, 1),))
    with book.alone():
        book.write(graded)
    assert book.read(graded.student) == graded


@pytest.mark.parametrize("said", ["coding: utf-16", "encoding='latin-1'", "coding=cp1252"])
def test_a_roster_is_read_whatever_its_students_are_called(tmp_path, said):
    path = tmp_path / "roster.csv"
    path.write_text(f"student,name\nmallory,{said}\nli,李小龙\n", encoding="utf-8")
    assert [student.name for student in read_roster(path)] == [said, "李小龙"]


def test_names_are_shown_no_longer_than_one_reads(tmp_path):
    put(tmp_path / "mallory" / "05.ipynb")
    folders = "/".join(["\U000e0041" * 200] * 39)
    with zipfile.ZipFile(tmp_path / "mallory" / "x.zip", "w") as archive:
        for number in range(12):
            archive.writestr(f"{folders}/{number}.ipynb", NOTEBOOK)
    mine = submissions(tmp_path)["mallory"]
    names = [one.name for one in mine.notebooks]
    assert len(names) == len(set(names)) == 12
    assert max(map(len, (*names, *mine.notes))) < 600


def test_folders_in_folders_of_somebody_unknown_cost_little(tmp_path, monkeypatch):
    searches = []
    search = re.search
    monkeypatch.setattr(re, "search", lambda *given: searches.append(1) or search(*given))
    roster = [Student(f"s{number:04d}", f"N{number} M{number}") for number in range(1000)]
    put(tmp_path / "nobody" / "x.zip")
    with zipfile.ZipFile(tmp_path / "nobody" / "x.zip", "w") as archive:
        for number in range(400):
            archive.writestr("/".join([f"d{number}"] * 39) + "/x.txt", b"")
    submissions(tmp_path, roster)
    assert len(searches) < 10_000  # there were sixty million


@pytest.mark.parametrize("between", ["", " "])
def test_names_full_of_ids_cost_little(monkeypatch, between):
    looked = []
    monkeypatch.setattr(layouts, "_is_set_off", lambda *given: looked.append(1) or True)
    names = Names([Student(str(number)) for number in range(100, 1000)], ())
    name = between.join(str(number) for number in range(300, 360))
    assert names.within(name) is None
    assert len(looked) <= 60


@pytest.mark.parametrize(
    "text, student",
    [
        ("hw_ada.l final", "ada.l"),
        ("ada.l-b", "ada.l"),
        ("xada.l", None),
        ("ada.l2", "ada"),
        ("2ada, ada!", "ada"),
        ("ada and bo_", None),
    ],
)
def test_an_id_in_a_longer_name_is_set_off(text, student):
    names = Names([Student("ada"), Student("ada.l"), Student("bo_")], ())
    assert names.within(text) == student


def test_two_students_of_one_address_are_told(tmp_path):
    roster = [ADA, Student("mallory", "Mallory", "ADA@x.org")]
    with pytest.raises(ValueError, match="ada and mallory"):
        export_gradescope(tmp_path / "a.zip", roster, b"k" * 32)
    assert not (tmp_path / "a.zip").exists()


@pytest.mark.parametrize("login", ["lovelace-a", "adalovelace", "LovelaceAda"])
def test_a_login_like_a_name_or_an_address_beside_the_others_own(tmp_path, login):
    roster = (Student("1001", "Ada Lovelace", "lovelace-a@x.org"), Student("1002", "Bo"))
    put(tmp_path / login / "05.ipynb", day=9)
    put(tmp_path / "1002" / "05.ipynb")
    assert taken(tmp_path, *roster)["1001"] == [f"{login}/05.ipynb"]
    put(tmp_path / "1001" / "05.ipynb")
    found = submissions(tmp_path, roster)
    assert [one.name for one in found["1001"].notebooks] == ["1001/05.ipynb"]
    assert f"{login}, perhaps 1001" in found["1001"].notes[0]


@pytest.mark.parametrize("called", ["1001", "ada x", "lovelace-a@x.org"])
def test_what_no_login_is_stays_the_students(tmp_path, called):
    """Several files of one student, named in several ways."""
    roster = (Student("1001", "Ada X", "lovelace-a@x.org"), Student("1002", "Bo"))
    put(tmp_path / "ada x.ipynb")
    put(tmp_path / called / "05.ipynb")
    assert f"{called}/05.ipynb" in taken(tmp_path, *roster)["1001"]


def test_two_long_names_in_doubt_are_two_peoples(tmp_path):
    put(tmp_path / "ada" / "05.ipynb")
    for end in ("one", "two"):
        put(tmp_path / f"{'x' * 75} ada {end}" / "05.ipynb")
    found = taken(tmp_path, ADA, MALLORY)
    assert [len(files) for files in found.values()] == [1, 0, 1, 1]
