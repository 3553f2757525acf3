"""A class's files as learning platforms and teachers lay them: each is its owner's."""

import os
import unicodedata
from datetime import UTC, datetime

import pytest
from test_others_files import notebook, put, taken, zipped

from dhlab.grading.intake.roster import Student
from dhlab.grading.intake.submissions import submissions

LESSONS = ("05-link-matrix", "06-forward-kinematics")
CLASS = (
    Student("ada_l", "Ada Lovelace", "ada@example.org"),
    Student("bo", "Bo Müller", "bo@example.org"),
    Student("cy", "Cy Twombly"),
    Student("li", "李 小龙"),
)
NFD = unicodedata.normalize("NFD", "Bo Müller")
METADATA = """---
submission_1:
  :submitters:
  - :name: Ada Lovelace
    :sid: 'ada_l'
    :email: ada@example.org
  :created_at: 2026-11-01 08:00:00.000000000 +00:00
  :results:
    output: |
      :sid: 'cy'
submission_2:
  :submitters:
  - :name: "Bo M\\xFCller"
    :sid:
    :email: bo@example.org
  :created_at: 2026-11-01 08:00:00.000000000 +00:00
"""
LAYOUTS = {
    "Brightspace": {
        "397063-2557369 - Ada Lovelace - Nov 1, 2026 926 PM/05 link matrix (1).ipynb": "ada_l",
        "397063-2557369 - Ada Lovelace - Nov 2, 2026 1026 AM/again.ipynb": "ada_l",
        f"397063-2557369 - {NFD} - Nov 1, 2026 9:26 PM - 05.ipynb": "bo",
        "index.html": "",
    },
    "Canvas": {
        "mullerbo_LATE_12_34_05-link-matrix-1.ipynb": "bo",
        "李小龙_13_35_Untitled (2).ipynb": "li",
        "lovelaceada_14_36_ada.zip": "ada_l",
    },
    "Moodle with groups": {
        "Group A-Ada Lovelace_77_assignsubmission_file_/05.ipynb": "ada_l",
        "Group B-Müller Bo_78_assignsubmission_file_/work/05.ipynb": "bo",
    },
    "Moodle, two assignments in one folder": {
        f"{name}_{number}_assignsubmission_file_/hw{number // 10}.ipynb": student
        for k, (name, student) in enumerate(
            [("Ada Lovelace", "ada_l"), ("Müller Bo", "bo"), ("Cy Twombly", "cy")]
        )
        for number in (50 + k, 60 + k)
    },
    "folders that are numbered, one of them with one student so far": {
        "Practical 1/ada_l/05.ipynb": "ada_l",
        "Practical 1/bo/05.ipynb": "bo",
        "Practical 2/ada_l/06.ipynb": "ada_l",
    },
    "GitHub Classroom": {
        "hw-5-submissions/hw-5-ada_l/src/05.ipynb": "ada_l",
        "hw-5-submissions/hw-5-bo/src/05.ipynb": "bo",
        "hw-5-submissions/hw-5-cy/05.ipynb": "cy",
    },
    "Google Classroom": {
        "Ada Lovelace - 05-link-matrix.ipynb": "ada_l",
        "Copy of 05-link-matrix - Bo Müller.ipynb": "bo",
        "cy (1).ipynb.txt": "cy",
    },
    "a zip each, in a folder": {
        "zips/ada_l.zip": "ada_l",
        "zips/bo.zip": "bo",
        "zips/cy.zip": "cy",
    },
    "a folder for each lesson": {
        "lesson05/ada_l.ipynb": "ada_l",
        "lesson05/bo.ipynb": "bo",
        "06-forward-kinematics/ada_l/06.ipynb": "ada_l",
    },
    "latecomers": {"ada_l/05.ipynb": "ada_l", "bo/05.ipynb": "bo", "late/cy/05.ipynb": "cy"},
    "the same name again, addresses, ids in brackets": {
        "ada_l/ada_l/05.ipynb": "ada_l",
        "bo@example.org/05.ipynb": "bo",
        "Twombly, C. (cy)/05.ipynb": "cy",
    },
    "Blackboard": {
        "Homework 5_ada_l_attempt_2026-11-01-10-00-00_05.ipynb": "ada_l",
        "Homework 5_ada_l_attempt_2026-11-02-10-00-00_05 (1).ipynb": "ada_l",
        "Homework 5_bo_attempt_2026-11-01-10-00-00_my_work.ipynb": "bo",
        "Homework 5_bo_attempt_2026-11-01-10-00-00.txt": "",
    },
    "nbgrader": {
        "submitted/ada_l/ps5/05.ipynb": "ada_l",
        "submitted/bo/ps5/05.ipynb": "bo",
        "gradebook.db": "",
    },
    "one of the class, and one of another": {
        "assignment1/ada_l/05.ipynb": "ada_l",
        "assignment1/guest/05.ipynb": "",
    },
    "sections": {
        "section A/ada_l/05.ipynb": "ada_l",
        "section A/bo/05.ipynb": "bo",
        "section B/cy/05.ipynb": "cy",
    },
    "folders of no known word": {
        "Kapitel 5/ada_l/05.ipynb": "ada_l",
        "Kapitel 5/bo/05.ipynb": "bo",
        "Kapitel 6/ada_l/05.ipynb": "ada_l",
        "Kapitel 6/cy/05.ipynb": "cy",
    },
    "a download for each lesson": {
        "submissions.zip/ada_l_1_2_05.ipynb": "ada_l",
        "submissions.zip/bo_3_4_05.ipynb": "bo",
        "submissions (1).zip/ada_l_1_5_06.ipynb": "ada_l",
        "submissions (1).zip/bo_3_6_06.ipynb": "bo",
    },
    "Teams": {
        "Submitted files/Ada Lovelace/Assignment 5/Version 1/05.ipynb": "ada_l",
        "Submitted files/Ada Lovelace/Assignment 5/Version 2/05.ipynb": "ada_l",
        "Submitted files/Bo Müller/Assignment 5/Version 1/05.ipynb": "bo",
    },
    "ILIAS": {
        "Abgaben/Lovelace_Ada_ada_l_12345/05.ipynb": "ada_l",
        "Abgaben/Mueller_Bo_bo_12346/05.ipynb": "bo",
    },
    "Sakai": {
        "Homework 5/Lovelace, Ada(ada_l)/Submission attachment(s)/05.ipynb": "ada_l",
        "Homework 5/Müller, Bo(bo)/Submission attachment(s)/05.ipynb": "bo",
        "Homework 5/grades.csv": "",
    },
    "a notebook of the teacher's beside a download": {
        "download of monday/ada_l/05.ipynb": "ada_l",
        "download of monday/bo/05.ipynb": "bo",
        "solution.ipynb": "",
    },
    "a later download, with one": {
        "download of monday/ada_l/05.ipynb": "ada_l",
        "download of monday/bo/05.ipynb": "bo",
        "download of friday/cy/05.ipynb": "",  # one is too few to tell
    },
    "a zip of Moodle's zips": {
        "CS1-Lesson 5-3321.zip/Ada Lovelace_771_assignsubmission_file_.zip": "ada_l",
        "CS1-Lesson 5-3321.zip/Bo Müller_772_assignsubmission_file_.zip": "bo",
    },
    "Gradescope": {
        "assignment_5_export/submission_1/05.ipynb": "ada_l",
        "assignment_5_export/submission_2/my/05.ipynb": "bo",
        "assignment_5_export/submission_metadata.yml": METADATA,
    },
}


def lay(top, layout):
    """Write a layout: a file in a zip is written into that zip."""
    zips = {}
    for name, owner in layout.items():
        outer, ending, inner = name.partition(".zip/")
        data = owner.encode() if owner == METADATA else notebook()
        if inner.endswith(".zip"):
            data = zipped({"05.ipynb": data})
        if ending:
            zips.setdefault(f"{outer}.zip", {})[inner] = data
        elif name.endswith(".zip"):
            zips[name] = {"work/05.ipynb": data}
        else:
            put(top / name, data if owner else b"<html>")
    for name, files in zips.items():
        put(top / name, zipped(files))


@pytest.mark.parametrize("called", LAYOUTS)
def test_each_file_is_its_owners(tmp_path, called):
    lay(tmp_path, LAYOUTS[called])
    expected = {}
    for name, owner in LAYOUTS[called].items():
        if owner in {student.student for student in CLASS}:
            expected.setdefault(owner, []).append(name.rpartition("/")[2].removesuffix(".zip"))
    found = {
        student.student: [one.name for one in mine.notebooks]
        for student in CLASS
        if (mine := submissions(tmp_path, CLASS, LESSONS)[student.student]).notebooks
    }
    assert {student: len(names) for student, names in found.items()} == {
        student: len(names) for student, names in expected.items()
    }
    for student, names in found.items():
        assert all(any(part in name for name in names) for part in expected[student])


@pytest.mark.parametrize("sid", ["Ada Lovelace", "ada", "ada@example.org"])
def test_what_stands_in_the_place_of_a_students_number_is_no_name_and_no_address(tmp_path, sid):
    other = f"submission_3:\n  :submitters:\n  - :name: Mallory M\n    :sid: '{sid}'\n"
    for number in (1, 3):
        put(tmp_path / f"submission_{number}" / "05.ipynb", day=number)
    put(tmp_path / "submission_metadata.yml", (METADATA + other).encode())
    assert taken(tmp_path, CLASS)["ada_l"] == ["ada_l/submission_1/05.ipynb"]


@pytest.mark.parametrize("second", [".", "-", "..", "_"])
def test_who_has_one_name_has_a_sign_for_the_second_on_moodle(tmp_path, second):
    name = f"Cher {second}_79_assignsubmission_file_"
    put(tmp_path / name / "05.ipynb")
    assert taken(tmp_path, (*CLASS, Student("c1", "Cher"))) == {"c1": [f"{name}/05.ipynb"]}


def test_a_group_on_gradescope_is_each_of_it(tmp_path):
    both = METADATA.replace(
        "  :created_at", "  - :name: Cy Twombly\n    :sid: cy\n  :created_at", 1
    )
    put(tmp_path / "submission_1" / "05.ipynb")
    put(tmp_path / "submission_metadata.yml", both.encode())
    assert taken(tmp_path, CLASS).keys() == {"ada_l", "cy"}


def test_ids_that_are_small_numbers_beside_folders_of_lessons(tmp_path):
    roster = [Student(str(number)) for number in range(1, 9)]
    for name in ("lesson 5/5.ipynb", "lesson 5/6.ipynb", "lesson 6/5.ipynb"):
        put(tmp_path / name)
    assert taken(tmp_path, roster) == {
        "5": ["lesson 5/5.ipynb", "lesson 6/5.ipynb"],
        "6": ["lesson 5/6.ipynb"],
    }


def test_the_platforms_whole_download_in_the_folder(tmp_path):
    """Its times are the platform's, and its files are those of many."""
    many = {f"{s.student}/{k}.txt": b"" for s in CLASS for k in range(200)}
    everyone = {f"{student.student}/05.ipynb": notebook() for student in CLASS}
    put(tmp_path / "submissions.zip", zipped(many | everyone), day=20)
    found = submissions(tmp_path, CLASS)
    assert taken(tmp_path, CLASS).keys() == {student.student for student in CLASS}
    (mine,) = found["ada_l"].notebooks
    assert mine.when == datetime(2026, 11, 2, tzinfo=UTC) and mine.source == "zip"


def test_canvas_numbers_people_and_one_may_be_anothers_id_by_chance(tmp_path):
    roster = [Student("12", "Ada Lovelace"), Student("77", "Bo Müller")]
    put(tmp_path / "lovelaceada_31_901_05.ipynb")
    put(tmp_path / "mullerbo_12_900_05.ipynb")
    assert taken(tmp_path, roster) == {"12": ["lovelaceada_31_901_05.ipynb"]}
    put(tmp_path / "someoneelse_77_902_05.ipynb")  # no other's name: the number says it
    assert taken(tmp_path, roster)["77"] == ["someoneelse_77_902_05.ipynb"]


def test_a_folder_that_cannot_be_looked_into_is_told(tmp_path, monkeypatch):
    for student in ("ada_l", "bo"):
        put(tmp_path / student / "05.ipynb")
    look = os.scandir

    def refuse(path):
        if str(path).endswith("ada_l"):
            raise PermissionError(13, "Permission denied", str(path))
        return look(path)

    monkeypatch.setattr(os, "scandir", refuse)
    found = submissions(tmp_path, CLASS)
    assert found["ada_l"].refused and "permissions" in found["ada_l"].notes[0]
    assert found["bo"].notebooks and not found["bo"].notes


def test_two_people_of_one_name_on_brightspace(tmp_path):
    put(tmp_path / "501-77 - Ada Lovelace - Nov 1, 2026 100 PM" / "05.ipynb")
    put(tmp_path / "501-77 - Ada Lovelace - Nov 2, 2026 100 PM" / "again.ipynb")
    put(tmp_path / "502-77 - Bo Müller - Nov 1, 2026 100 PM" / "05.ipynb")
    assert {student: len(files) for student, files in taken(tmp_path, CLASS).items()} == {
        "ada_l": 2,
        "bo": 1,
    }
    put(tmp_path / "503-77 - Ada Lovelace - Nov 3, 2026 100 PM" / "05.ipynb", day=9)
    assert taken(tmp_path, CLASS).keys() == {"bo"}
    (told,) = submissions(tmp_path, CLASS)["ada_l"].notes
    assert "several people of this name" in told and "501" in told and "503" in told


def test_a_number_beside_several_names_is_an_assignments(tmp_path):
    for name in ("Ada Lovelace", "Bo Müller", "Cy Twombly"):
        put(tmp_path / f"77-1 - {name} - Nov 1, 2026 100 PM" / "05.ipynb")
    for name in ("Ada Lovelace", "Eve X"):
        put(tmp_path / f"78-1 - {name} - Nov 8, 2026 100 PM" / "06.ipynb")
    found = taken(tmp_path, CLASS)
    assert {student: len(files) for student, files in found.items()} == {
        "ada_l": 2,
        "bo": 1,
        "cy": 1,
    }


def test_an_accent_makes_another_person(tmp_path):
    put(tmp_path / "Bo Müller_12_assignsubmission_file_/05.ipynb")
    put(tmp_path / "Bo Muller_13_assignsubmission_file_/05.ipynb")
    roster = (Student("b1", "Bo Müller"), Student("b2", "Bo Muller"))
    assert {name: len(files) for name, files in taken(tmp_path, roster).items()} == {
        "b1": 1,
        "b2": 1,
    }
    alone = taken(tmp_path, roster[:1])
    assert alone == {"b1": ["Bo Müller_12_assignsubmission_file_/05.ipynb"]}


@pytest.mark.parametrize("name", ["Àda Lovelace", "Ada Love lace", "Ada\u200b Lovelace"])
def test_a_strangers_name_of_the_same_letters_takes_nothing_away(tmp_path, name):
    put(tmp_path / f"{name}_13_assignsubmission_file_/05.ipynb", day=9)
    assert set(taken(tmp_path, CLASS)) == {"ada_l"}, "as when the roster has no accents"
    put(tmp_path / "Ada Lovelace_11_assignsubmission_file_/05.ipynb")
    assert taken(tmp_path, CLASS) == {"ada_l": ["Ada Lovelace_11_assignsubmission_file_/05.ipynb"]}


@pytest.mark.parametrize("name", ["李小龙", "小龙 李", "李, 小龙"])
def test_a_name_is_itself_with_its_words_run_together(tmp_path, name):
    put(tmp_path / "li" / "05.ipynb")
    put(tmp_path / f"{name}_13_assignsubmission_file_/05.ipynb", day=9)
    assert len(taken(tmp_path, CLASS)["li"]) == 2
