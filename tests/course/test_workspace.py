"""The learner's folder: copied once, never written over, newer lessons beside the old; the log of
what was checked.
"""

import os
from dataclasses import replace
from pathlib import Path

import pytest

from dhlab.course import exercises as exercises_room
from dhlab.course import session, workspace
from dhlab.course.exercises import exercises, sittings
from dhlab.course.kinds import PreTest
from dhlab.course.progress import Log, Progress
from dhlab.course.route import ASKED_BY, SITTINGS, Map, counted, file_of, stopped_in
from dhlab.course.verdict import RECORDED, RIGHT, WRONG, Verdict

ROOT = Path(__file__).parents[2]


@pytest.fixture
def lessons(tmp_path, monkeypatch):
    folder = tmp_path / "handed-out"
    folder.mkdir()
    (folder / "01-frames.ipynb").write_text("first version")
    monkeypatch.setattr(workspace, "handed_out", lambda: folder)
    return folder


def test_lessons_are_copied_and_kept(lessons, tmp_path):
    mine = tmp_path / "mine" / "course"
    assert workspace.prepare(mine) == ["01-frames.ipynb: new"]
    (mine / "01-frames.ipynb").write_text("my work")
    assert workspace.prepare(mine) == [] and (mine / "01-frames.ipynb").read_text() == "my work"


def test_a_newer_version_arrives_beside(lessons, tmp_path):
    mine = tmp_path / "mine"
    workspace.prepare(mine)
    (mine / "01-frames.ipynb").write_text("my work")
    for number, text in ((2, "second version"), (3, "third version")):
        (lessons / "01-frames.ipynb").write_text(text)
        workspace.prepare(mine)
        assert (mine / f"01-frames.version-{number}.ipynb").read_text() == text
        assert workspace.prepare(mine) == []
    assert (mine / "01-frames.ipynb").read_text() == "my work" and len(
        list(mine.glob("*.ipynb"))
    ) == 3


def test_a_folder_that_had_other_files_keeps_them(lessons, tmp_path):
    (tmp_path / "01-frames.ipynb").write_text("something of mine")
    workspace.prepare(tmp_path)
    assert (tmp_path / "01-frames.ipynb").read_text() == "something of mine"
    assert (tmp_path / "01-frames.version-2.ipynb").read_text() == "first version"


def test_a_broken_list_loses_nothing(lessons, tmp_path):
    workspace.prepare(tmp_path)
    (tmp_path / "01-frames.ipynb").write_text("my work")
    (tmp_path / ".dhlab" / "lessons.json").write_text("{broken")
    workspace.prepare(tmp_path)
    assert (tmp_path / "01-frames.ipynb").read_text() == "my work"


def test_a_deleted_lesson_comes_back(lessons, tmp_path):
    workspace.prepare(tmp_path)
    (tmp_path / "01-frames.ipynb").unlink()
    assert workspace.prepare(tmp_path) == ["01-frames.ipynb: new"]


def test_a_file_is_no_folder(lessons, tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(ValueError, match="expected a folder"):
        workspace.prepare(tmp_path / "file")


def test_the_real_lessons_are_handed_out(tmp_path):
    workspace.prepare(tmp_path)
    assert {p.name for p in tmp_path.glob("*.ipynb")} == {
        p.name for p in (ROOT / "lessons").glob("*.ipynb")
    } and (tmp_path / "glossary.md").exists()


def test_the_log_is_appended_to_and_read_back(tmp_path, monkeypatch):
    workspace.prepare(tmp_path)
    monkeypatch.chdir(tmp_path)
    Log().add(Verdict("05.2", WRONG, of=1))
    Log().add(Verdict("05.2", RIGHT, points=1, of=1))
    Log().add(Verdict("05.2", WRONG, of=1))
    with open(tmp_path / ".dhlab" / "progress.jsonl", "a") as file:
        file.write('{"half a li\n["not", "an", "entry"]\n')
    assert Log().best() == {"05.2": (RIGHT, 1)}
    monkeypatch.setattr(session, "_log", Log())
    assert session.progress().to_dict()["05.2"]["status"] == RIGHT and "1 of" in str(
        session.progress("05")
    )


def test_nothing_is_written_outside_a_course_folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Log().add(Verdict("05.2", RIGHT, points=1, of=1))
    assert os.listdir(tmp_path) == []


def test_a_handed_out_folder_gets_no_lessons_of_other_numbers(tmp_path):
    from dhlab.grading.handing_out.release import with_variant

    own = with_variant(
        (workspace.handed_out() / "05-link-matrix.ipynb").read_text(encoding="utf-8"), 17
    )
    (tmp_path / "05-link-matrix.ipynb").write_text(own, encoding="utf-8")
    workspace.prepare(tmp_path)
    assert [path.name for path in tmp_path.glob("*.ipynb")] == ["05-link-matrix.ipynb"] and (
        tmp_path / "glossary.md"
    ).exists()
    assert (tmp_path / "05-link-matrix.ipynb").read_text(encoding="utf-8") == own


# --- where one is in the course, and where to begin ---


def checked(*ids, known=None):
    return [
        Verdict(key, RIGHT if known is None else RECORDED, points=1, of=1, known=known)
        for key in ids
    ]


def test_the_files_of_the_map_are_the_lessons_and_their_links_lead_on():
    assert [file_of(name) for name in SITTINGS] == sorted(
        path.name for path in (ROOT / "lessons").glob("*.ipynb")
    )
    assert list(SITTINGS) == list(sittings())
    assert {
        key: one.lesson for key, one in exercises().items() if isinstance(one, PreTest)
    } == ASKED_BY
    assert 'href="04b-a-whole-arm.ipynb"' in session.progress("04")._repr_html_()
    assert "href" not in session.progress("09")._repr_html_()


@pytest.mark.parametrize(
    "right, wrong, lesson",
    [
        ((), (), "01"),
        ((), ("00.2", "00.3", "00.4", "00.5", "00.6"), "01"),  # sure of oneself, and wrong
        (("00.3", "00.4", "00.5", "00.6"), ("00.2",), "01"),
        (("00.2", "00.4"), ("00.3",), "01"),  # of 01 and 02 one right letter, which may be luck
        (("00.2", "00.3"), (), "03"),
        (("00.2", "00.3", "00.4"), ("00.5",), "04"),
        (("00.2", "00.3", "00.4", "00.5", "00.6"), (), "04"),
    ],
)
def test_the_pre_test_sends_by_what_was_right(monkeypatch, right, wrong, lesson):
    log = Log()
    monkeypatch.setattr(session, "_log", log)
    for verdict in (*checked(*right, known=True), *checked(*wrong, known=False)):
        log.add(verdict)
    told = session.route()
    assert f"Begin with lesson {lesson}." in str(told)
    assert f'<a href="{file_of(lesson)}">lesson {lesson}</a>' in told._repr_html_()
    assert ("where 01.1 and 01.2 come" in str(told)) == (lesson == "01" and "00.2" in right)


def test_the_lab_opens_where_one_stopped(tmp_path, monkeypatch):
    workspace.prepare(tmp_path)
    monkeypatch.chdir(tmp_path)
    assert "--LabApp.default_url=/lab/tree/00-start-here.ipynb" in workspace.lab_command(tmp_path)
    log = Log()
    core = [key for key in sittings()["04"] if ".P" not in key and not exercises()[key].practice]
    for verdict in checked("04.1", core[-1]):
        log.add(verdict)
    assert workspace.where_one_stopped(tmp_path) == "04-placing-frames.ipynb"
    assert counted(Log(tmp_path).best())["04"][:2] == (2, len(core))
    for verdict in checked(*core):
        log.add(verdict)
    assert workspace.where_one_stopped(tmp_path) == "04b-a-whole-arm.ipynb"
    assert "04 ✓" in str(session.course_map("04b"))
    (tmp_path / "04b-a-whole-arm.ipynb").unlink()
    assert not any("default_url" in part for part in workspace.lab_command(tmp_path))


def test_a_lesson_is_finished_without_its_practice(tmp_path, monkeypatch):
    """02 with two exercises in *More practice*, whichever these are."""
    asked = {key: exercise for key, exercise in exercises().items() if key.startswith("02.")}
    changed = {key: replace(asked[key], practice=key in ("02.7", "02.8")) for key in asked}
    monkeypatch.setattr(exercises_room, "exercises", lambda: {**exercises(), **changed})
    core = [key for key in changed if ".P" not in key and key not in ("02.7", "02.8")]
    done = counted(dict.fromkeys(core, (RIGHT, 1)))["02"]
    assert done == (6, 6, 0, 2) and done.finished and str(done) == "✓"
    more = counted(dict.fromkeys((*core[1:], "02.8"), (RIGHT, 1)))["02"]
    assert more == (5, 6, 1, 2) and not more.finished and str(more) == "5/6 +1"
    assert stopped_in([{"exercise": core[-1]}], {"02": done}) == "03"
    assert stopped_in([{"exercise": "02.8"}], {"02": more}) == "02"
    label = "5 of 6 exercises done, and 1 of 2 of More practice"
    assert label in Map({"02": more})._repr_html_()
    said = str(Progress(changed, {core[0]: (RIGHT, 1), "02.8": (RIGHT, 2)}))
    above, below = said.split("\n 1 of 9 points\n")
    assert "02.8" not in above and "02.6" not in below
    assert below.endswith("\n More practice: 2 of 4 points")
