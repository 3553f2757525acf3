"""What stands inside one person's folder or zip is that person's writing: it takes no marks, no
time and no vote from anybody else, and strangers' files do not stop a class.
"""

import io
import os
import zipfile
from datetime import UTC, datetime

import pytest

from dhlab.grading.handing_out.variants import variant
from dhlab.grading.intake.roster import Student
from dhlab.grading.intake.submissions import submissions
from dhlab.grading.plan import plan
from dhlab.grading.settings import Lesson, Settings

CLASS = (
    Student("ada_l", "Ada Lovelace", "ada@example.org"),
    Student("bo", "Bo Müller", "bo@example.org"),
    Student("cy", "Cy Twombly"),
)
KEY = b"k" * 32
NOBODY = 4_294_967_300  # numbers that the key gives to nobody here


def notebook(lesson="05", number=0):
    cell = f'set_variant({number})\\ncheck(\\"{lesson}.1\\", x)'
    return f'{{"cells": [{{"cell_type": "code", "source": "{cell}"}}]}}'.encode()


NOTEBOOK = notebook()


def put(path, data=NOTEBOOK, day=1):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(data)
    when = datetime(2026, 11, day, tzinfo=UTC).timestamp()
    os.utime(path, (when, when))


def zipped(files, when=(2026, 11, 2, 0, 0, 0)):
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w") as archive:
        for name, content in files.items():
            archive.writestr(zipfile.ZipInfo(name, when), content)
    return data.getvalue()


def own(top, *students):
    """A file of the first day for each, in a folder of their own."""
    for student in students:
        put(top / student / "05.ipynb")


def taken(top, roster=CLASS):
    """{student of the roster: names of what counts as theirs}, of those who have something."""
    found = submissions(top, roster)
    names = {s.student: [one.name for one in found[s.student].notebooks] for s in roster}
    return {student: files for student, files in names.items() if files}


def told(planned):
    return " | ".join(planned.notes)


OUTER = [
    "submission_881",
    "assignment-malnick",
    "1002-77 - Mallory M - Nov 1, 2026 100 PM",
    "Eve X_771_assignsubmission_file_",
    "mallory_880_901_05",
]


@pytest.mark.parametrize("outer", OUTER)
@pytest.mark.parametrize("inner", ["ada_l.ipynb", "ada_l/05.ipynb", "Ada Lovelace/05.ipynb"])
def test_a_name_within_somebodys_folder_is_not_anothers(tmp_path, outer, inner):
    own(tmp_path, "ada_l", "bo")
    put(tmp_path / outer / inner, day=20)
    assert taken(tmp_path) == {"ada_l": ["ada_l/05.ipynb"], "bo": ["bo/05.ipynb"]}
    planned = plan(tmp_path, CLASS)
    assert [mine for s, mine in planned.found.items() if not mine.on_roster and mine.notebooks]
    assert "ada_l" in told(planned) and "held apart" in told(planned)


@pytest.mark.parametrize("inner", ["ada_l.ipynb", "ada_l/05.ipynb"])
def test_nor_where_the_other_handed_in_nothing(tmp_path, inner):
    """Ada may have marks of an earlier run, and this file would replace them."""
    put(tmp_path / "bo" / "06.ipynb", notebook("06"))
    put(tmp_path / "submission_881" / inner)
    assert taken(tmp_path) == {"bo": ["bo/06.ipynb"]}
    assert any("submission_881" in note for note in submissions(tmp_path, CLASS)["ada_l"].notes)


def test_brightspaces_names_are_the_platforms(tmp_path):
    put(tmp_path / "1001-77 - Ada Lovelace - Nov 1, 2026 100 PM" / "05.ipynb")
    put(tmp_path / "1001-77 - Mallory M - Nov 1, 2026 100 PM" / "ada_l.ipynb", day=20)
    assert [name.partition(" - ")[2] for name in taken(tmp_path)["ada_l"]] == [
        "Ada Lovelace - Nov 1, 2026 100 PM/05.ipynb"
    ]


@pytest.mark.parametrize("name", ["homework.zip", "lesson05.zip", "submission_881.zip"])
def test_a_zip_with_a_folder_for_each_of_the_class(tmp_path, name):
    own(tmp_path, "ada_l", "bo")
    before = taken(tmp_path)
    everyone = {f"{student.student}/05.ipynb": notebook() for student in CLASS}
    put(tmp_path / name, zipped(everyone), day=20)
    assert taken(tmp_path) == before
    found = submissions(tmp_path, CLASS)
    assert not found["ada_l"].notes and name.removesuffix(".zip") in found["cy"].notes[0]


def test_a_folder_with_one_for_each_of_the_class(tmp_path):
    own(tmp_path, "ada_l", "bo")
    before = taken(tmp_path)
    own(tmp_path / "submission_881", "ada_l", "bo", "cy")
    assert taken(tmp_path) == before


def test_among_folders_that_name_nobody_one_is_not_the_class(tmp_path):
    for number in (1, 2, 3):
        put(tmp_path / f"submission_{number}" / "05.ipynb")
    own(tmp_path / "submission_4", "ada_l", "bo", "cy")
    assert taken(tmp_path) == {}


def test_anothers_room_for_zips_is_not_used_up(tmp_path):
    many = {f"{number}.txt": b"{}" for number in range(490)}
    put(tmp_path / "aaa" / "ada_l.zip", zipped(many))
    put(
        tmp_path / "ada_l" / "x.zip",
        zipped({"05.ipynb": notebook()} | dict(list(many.items())[:20])),
    )
    assert taken(tmp_path)["ada_l"] == ["ada_l/x.zip/05.ipynb"]


def test_a_platforms_names_within_a_folder_make_nobody_several_people(tmp_path):
    hers = "Ada Lovelace_771_assignsubmission_file_/05.ipynb"
    put(tmp_path / hers)
    for number in (1, 2):
        put(tmp_path / "zzz" / f"Ada Lovelace_{number}_assignsubmission_file_" / "05.ipynb")
    assert taken(tmp_path) == {"ada_l": [hers]}


def test_a_display_name_that_ends_with_anothers_makes_nobody_several_people(tmp_path):
    hers = "Ada Lovelace_771_assignsubmission_file_/05.ipynb"
    put(tmp_path / hers)
    put(tmp_path / "x-Ada Lovelace_880_assignsubmission_file_" / "05.ipynb", day=20)
    assert taken(tmp_path) == {"ada_l": [hers]}


def test_the_half_of_a_double_name_is_nobodys(tmp_path):
    put(tmp_path / "Anna-Bo Müller_79_assignsubmission_file_" / "05.ipynb")
    assert taken(tmp_path) == {}


def test_two_of_one_name_in_groups_are_two(tmp_path):
    for group, number in (("A", 77), ("B", 78)):
        put(tmp_path / f"Group {group}-Ada Lovelace_{number}_assignsubmission_file_" / "05.ipynb")
    assert taken(tmp_path) == {}


def test_a_file_called_as_moodle_would_on_canvas(tmp_path):
    put(tmp_path / "lovelaceada_771_900_05.ipynb")
    put(tmp_path / "adalove_880_901_lace_5_assignsubmission_file_.ipynb", day=20)
    assert taken(tmp_path) == {"ada_l": ["lovelaceada_771_900_05.ipynb"]}


def test_what_follows_blackboards_date_is_the_students(tmp_path):
    hers = "HW 5_ada_l_attempt_2026-11-01-10-00-00_hw.ipynb"
    put(tmp_path / hers)
    put(tmp_path / "HW 5_1002_attempt_2026-11-20-10-00-00_ada_l.ipynb", day=20)
    assert taken(tmp_path) == {"ada_l": [hers]}


def test_a_nick_that_ends_with_anothers_id(tmp_path):
    for nick, day in (("ada_l", 1), ("bo", 1), ("x-ada_l", 20)):
        put(tmp_path / f"hw-5-{nick}" / "05.ipynb", day=day)
    assert taken(tmp_path) == {"ada_l": ["hw-5-ada_l/05.ipynb"], "bo": ["hw-5-bo/05.ipynb"]}


@pytest.mark.parametrize("nick", ["x-ada_l", "ada_l-x"])
def test_nor_while_the_other_hands_in_nothing(tmp_path, nick):
    for name in ("bo", "cy", nick):
        put(tmp_path / f"hw-6-{name}" / "05.ipynb")
    assert taken(tmp_path).keys() == {"bo", "cy"}
    assert f"hw-6-{nick}" in submissions(tmp_path, CLASS)["ada_l"].notes[0]


@pytest.mark.parametrize("login", ["ada_l-2", "ada_l_v2", "ada_l final"])
def test_a_login_like_the_name_of_a_copy(tmp_path, login):
    own(tmp_path, "ada_l", "bo")
    put(tmp_path / login / "05.ipynb", day=20)
    assert taken(tmp_path)["ada_l"] == ["ada_l/05.ipynb"]
    assert login in submissions(tmp_path, CLASS)["ada_l"].notes[0]


def test_a_display_name_that_is_anothers_but_for_a_digit(tmp_path):
    put(tmp_path / "lovelaceada_771_900_05.ipynb")
    put(tmp_path / "lovelaceada2_880_902_05.ipynb", day=20)
    assert taken(tmp_path) == {"ada_l": ["lovelaceada_771_900_05.ipynb"]}


def test_gradescopes_name_alone_is_not_sure(tmp_path):
    people = [
        ("Ada Lovelace", "ada_l", ""),
        ("Ada Lovelace", "", "m@example.net"),
        ("Bo", "bo", ""),
    ]
    listed = [
        f"submission_{k}:\n  :submitters:\n  - :name: {name}\n    :sid: {sid}\n    :email: {mail}\n"
        for k, (name, sid, mail) in enumerate(people)
    ]
    put(tmp_path / "submission_metadata.yml", "".join(listed).encode())
    for k in range(3):
        put(tmp_path / f"submission_{k}" / "05.ipynb", day=1 + 10 * k)
    assert taken(tmp_path)["ada_l"] == ["ada_l/submission_0/05.ipynb"]
    assert "submission_1" in submissions(tmp_path, CLASS)["ada_l"].notes[0]


def test_nbgraders_time_is_of_all_that_was_handed_in_with_it(tmp_path):
    """In a folder of one's own files keep the times that their owner gave them."""
    for student in ("ada_l", "bo", "cy"):
        put(tmp_path / student / "ps5" / "timestamp.txt", b"2026-11-20 08:00:00 UTC", day=25)
    put(tmp_path / "ada_l" / "ps5" / "x" / "05.ipynb", day=1)
    put(tmp_path / "bo" / "ps5" / "05.ipynb", day=25)
    put(tmp_path / "cy" / "ps5" / "cy.zip", zipped({"05.ipynb": NOTEBOOK}), day=1)
    found = submissions(tmp_path, CLASS)
    assert [found[one.student].notebooks[0].when.day for one in CLASS] == [20, 20, 20]


def test_strangers_folders_do_not_switch_off_the_platforms_times(tmp_path):
    for student in ("ada_l", "bo", "cy"):
        put(tmp_path / student / "ps5" / "05.ipynb", day=20)
        put(tmp_path / student / "ps5" / "timestamp.txt", b"2026-11-01 08:00:00 UTC", day=20)
    for number in range(5):
        put(tmp_path / f"x{number}" / "ps5" / "05.ipynb", day=20)
    found = submissions(tmp_path, CLASS)
    assert {found[s.student].notebooks[0].source for s in CLASS} == {"timestamp.txt"}


@pytest.mark.parametrize("depth", [(), ("wrapped",)])
def test_latecomers_whose_one_zip_has_anothers_name_in_it(tmp_path, depth):
    put(tmp_path.joinpath(*depth, "homework.zip"), zipped({"ada_l/05.ipynb": notebook()}))
    assert taken(tmp_path) == {}


def test_the_one_folder_there_is_with_anothers_name_in_it(tmp_path):
    put(tmp_path / "submission_881" / "ada_l" / "05.ipynb")
    put(tmp_path / "submission_881" / "x" / "y.ipynb")
    assert taken(tmp_path) == {}


def test_a_display_name_like_a_teachers_folder(tmp_path):
    put(tmp_path / "Ada Lovelace_770_assignsubmission_file_" / "05.ipynb")
    put(tmp_path / "lesson05_771_assignsubmission_file_" / "ada_l.ipynb", day=20)
    assert len(taken(tmp_path)["ada_l"]) == 1


def test_a_name_like_a_teachers_folder_beside_the_others_own(tmp_path):
    own(tmp_path, "ada_l", "bo")
    put(tmp_path / "late" / "ada_l.ipynb", day=20)
    put(tmp_path / "late" / "cy.ipynb", day=20)
    found = submissions(tmp_path, CLASS)
    assert taken(tmp_path)["ada_l"] == ["ada_l/05.ipynb"]
    assert taken(tmp_path)["cy"] == ["late/cy.ipynb"]
    assert "late, perhaps ada_l" in found["ada_l"].notes[0]


def test_gradescopes_list_is_not_a_students_to_write(tmp_path):
    listed = """submission_1:
  :submitters:
  - :name: Ada Lovelace
    :sid: ada_l
  :created_at: 2026-11-01
submission_4:
  :submitters:
  - :name: "Mallory
    :sid: bo"
    :email: m@example.org
  :results:
    output: |-
submission_4:
"""
    put(tmp_path / "submission_metadata.yml", listed.encode())
    put(tmp_path / "submission_1" / "05.ipynb")
    mine = tmp_path / "submission_4"
    put(mine / "submission_metadata.yml", listed.encode(), day=20)
    put(mine / "submission_1" / "05.ipynb", day=20)
    assert taken(tmp_path) == {"ada_l": ["ada_l/submission_1/05.ipynb"]}


def test_strangers_do_not_vote_on_the_key(tmp_path):
    for student in CLASS:
        put(tmp_path / student.student / "05.ipynb", notebook("05", variant(KEY, student.student)))
    for number in range(5):
        put(tmp_path / f"x{number}.ipynb", notebook("05", NOBODY + number))
    planned = plan(tmp_path, CLASS, KEY)
    assert all(not planned.found[student.student].notes for student in CLASS)
    with pytest.raises(ValueError, match="3 of 3 students' notebooks have other numbers"):
        plan(tmp_path, CLASS, b"o" * 32)


def test_without_a_roster_a_few_stop_nobody_and_it_is_told(tmp_path):
    for student in CLASS:
        put(tmp_path / student.student / "05.ipynb", notebook("05", variant(KEY, student.student)))
    for number in range(5):
        put(tmp_path / f"x{number}.ipynb", notebook("05", NOBODY + number))
    planned = plan(tmp_path, (), KEY)
    assert not planned.found["ada_l"].notes
    assert "5 of 8 students' notebooks have other numbers than this key gives" in told(planned)
    with pytest.raises(ValueError, match="8 of 8 students' notebooks have other numbers"):
        plan(tmp_path, (), b"o" * 32)
    with pytest.raises(ValueError, match="8 of 8 students' notebooks have numbers of their own"):
        plan(tmp_path)


def test_copies_of_a_stranger_say_nothing_of_the_class(tmp_path):
    for student in CLASS:
        put(tmp_path / student.student / "05.ipynb", notebook("05", variant(KEY, student.student)))
    for number in range(12):
        put(tmp_path / "mallory" / f"{number}.ipynb")
    assert "leave out --key" not in told(plan(tmp_path, CLASS, KEY))


def test_strangers_do_not_vote_on_the_lessons(tmp_path):
    roster = [Student(f"s{number}") for number in range(10)]
    own(tmp_path, *(student.student for student in roster))
    for name in ("x1", "x2"):
        put(tmp_path / f"{name}.ipynb", notebook("09"))
    planned = plan(tmp_path, roster)
    assert planned.course.lessons == ("05",) and "lesson 09" in told(planned)


def test_a_lesson_that_few_of_the_class_handed_in_is_told(tmp_path):
    roster = [Student(f"s{number}") for number in range(10)]
    own(tmp_path, *(student.student for student in roster))
    for name in ("s1", "s2"):
        put(tmp_path / name / "06.ipynb", notebook("06"))
    planned = plan(tmp_path, roster)
    assert planned.course.lessons == ("05", "06")
    assert "lesson 06 was handed in by 2 of 10 and counts for everybody" in told(planned)


def test_without_a_roster_most_decide_on_the_lessons(tmp_path):
    own(tmp_path, *(f"s{number}" for number in range(10)))
    for name in ("x1", "x2", "x3"):
        put(tmp_path / f"{name}.ipynb", notebook("09"))
    assert plan(tmp_path).course.lessons == ("05",)


def test_a_class_whose_files_all_match_nobody_still_has_lessons(tmp_path):
    own(tmp_path, "x1", "x2")
    assert plan(tmp_path, CLASS).course.lessons == ("05",)


def test_one_old_file_of_a_stranger_hides_no_warning(tmp_path):
    own(tmp_path, "ada_l", "bo")
    os.utime(tmp_path / "ada_l" / "05.ipynb", (2e9, 2e9))
    os.utime(tmp_path / "bo" / "05.ipynb", (2e9, 2e9))
    put(tmp_path / "x.ipynb")
    due = Settings({"05": Lesson(datetime(2030, 1, 1, tzinfo=UTC))})
    assert "were the files copied?" in told(plan(tmp_path, CLASS, settings=due))


def test_a_zip_that_names_the_class_changes_nobodys_notes(tmp_path):
    roster = [Student(f"s{number}") for number in range(200)]
    own(tmp_path, *(student.student for student in roster))
    put(tmp_path / "homework.zip", zipped({f"{s.student}/a.ipynb": b"{}" for s in roster}))
    planned = plan(tmp_path, roster)
    assert not any(planned.found[student.student].notes for student in roster)
    assert sum(map(len, planned.notes)) < 1000
