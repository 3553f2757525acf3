"""The lessons as they are handed out and as they are solved: marks, sources, contract."""

import json
import re
import shutil

import nbformat
import pytest

from dhlab.course.building import build, contract, notebooks, reading
from dhlab.course.exercises import exercises, sittings
from dhlab.course.kinds import Prediction

NAMES = [path.stem for path in reading.sources()]


ROW = re.compile(r"^\s*(\d\d\.\d+)\s.*([✓✗○•]) (\w[\w ]*?)\s+([\d.]+) of ([\d.]+)$", re.MULTILINE)


def earned(notebook, lesson):
    """What ``progress()`` said in its last cell: {exercise: (status, points, of)}."""
    said = notebook.cells[-1].outputs[-1].data["text/plain"]
    found = {
        key: (status, float(points), float(of)) for key, _, status, points, of in ROW.findall(said)
    }
    asked = [exercises()[key] for key in sittings()[lesson]]
    asked = [exercise for exercise in asked if not isinstance(exercise, Prediction)]
    assert list(found) == [e.id for e in sorted(asked, key=lambda e: e.practice)]
    return found


def said_by_checks(notebook):
    """The words of every check."""
    return [
        cell.outputs[-1].data["text/plain"]
        for cell in notebook.cells
        if cell.cell_type == "code" and cell.source.startswith("check(")
    ]


@pytest.mark.parametrize("name", NAMES)
def test_every_solution_earns_full_marks(name):
    """By the outputs that are stored; that a run gives them again is nbval's to say."""
    notebook = nbformat.read(reading.SOLUTIONS / f"{name}.ipynb", as_version=4)
    rows = earned(notebook, name.partition("-")[0])
    for status, points, of in rows.values():
        assert (status, points) == ("right" if of else "noted", of)
    said = said_by_checks(notebook)
    assert len(said) == len(rows)
    assert all(text.startswith(("✓ ", "• ")) for text in said)


@pytest.mark.parametrize("name", NAMES)
def test_every_untouched_lesson_runs_and_earns_nothing(name, site):
    """By the outputs of the run for the site, in which no cell may fail."""
    (ran,) = (site.parent / "executed" / "lessons").glob(f"{name}.*.ipynb")
    notebook = nbformat.read(ran, as_version=4)
    rows = earned(notebook, name.partition("-")[0])
    assert {(status, points) for status, points, _ in rows.values()} == {("not attempted yet", 0)}
    said = said_by_checks(notebook)
    assert len(said) == len(rows)
    assert all("Not attempted yet" in text for text in said)


@pytest.mark.parametrize("name", NAMES)
def test_no_solution_is_handed_out(name):
    source = (reading.SOLUTIONS / f"{name}.md").read_text(encoding="utf-8")
    lesson = (reading.LESSONS / f"{name}.ipynb").read_text(encoding="utf-8")
    regions = re.findall(r"### BEGIN SOLUTION\n(.*?)### END SOLUTION", source, re.DOTALL)
    assert len(regions) == len(sittings()[name.partition("-")[0]])
    assert "SOLUTION" not in lesson
    for region in regions:
        for line in region.strip().splitlines():
            if len(line.strip()) > 40:
                quoted = json.dumps(line.strip(), ensure_ascii=False)[1:-1]
                assert quoted not in lesson or quoted in source.replace(region, ""), line


def test_rebuilding_gives_what_is_committed():
    assert build.stale() == []


def test_rebuilding_is_repeatable():
    path = reading.sources()[0]
    once, twice = (
        nbformat.writes(notebooks.lesson_notebook(reading.read_source(path))) for _ in range(2)
    )
    assert once == twice


def test_a_changed_source_is_noticed(tmp_path, monkeypatch):
    for folder in ("solutions", "lessons"):
        (tmp_path / folder).mkdir()
        for path in (reading.ROOT / folder).glob("*.*"):
            (tmp_path / folder / path.name).write_bytes(path.read_bytes())
    shutil.copytree(reading.SOLUTIONS / "teacher", tmp_path / "solutions" / "teacher")
    monkeypatch.setattr(reading, "ROOT", tmp_path)
    monkeypatch.setattr(reading, "SOLUTIONS", tmp_path / "solutions")
    monkeypatch.setattr(reading, "LESSONS", tmp_path / "lessons")
    assert build.stale() == []
    source = tmp_path / "solutions" / "01-frames.md"
    source.write_text(
        source.read_text(encoding="utf-8").replace("lesson 07 you", "lesson 08 you"),
        encoding="utf-8",
    )
    sheet = tmp_path / "solutions" / "teacher" / "01-frames.md"
    sheet.write_text(
        sheet.read_text(encoding="utf-8").replace("Name three reasons", "Name four reasons"),
        encoding="utf-8",
    )
    assert build.stale() == [
        "lessons/01-frames.ipynb",
        "solutions/01-frames.ipynb",
        "dhlab/course/discussion.yaml",
    ]


def test_the_contract_is_kept():
    table, failures = contract.report()
    assert failures == [] and len(table.splitlines()) == 1 + len(contract.CONTRACT) * len(NAMES)


BREAKS = {
    "time": ("  minutes: 50", "  minutes: 20"),
    "practice": ("about 10 more", "much more"),
    "opening": ('read the arrows and the origin of a frame off its pose"', 'understand frames"'),
    "prose": ("## Key points", "word " * 700 + "\n\n## Key points"),
    "new terms": ("(glossary.md#pose)", "(elsewhere.md#pose)"),
    "checks": ('check("01.5", chain)', 'print("01.5")'),
    "predictions": ('reveal("01.P1")', 'print("01.P1")'),
    "misconceptions": ("**Against it.** The quarter", "The quarter"),
    "choices": (':exercise: "01.6"\n', ""),
    "worked example": (":tags: [worked]", ":tags: [shown]"),
    "why": ("[exercise, why]", "[exercise]"),
    "modify, make": ("[modify]", "[play]"),
    "code": ("length = 0.12", "import matplotlib\nlength = 0.12"),
    "transfer": ("[exercise, transfer]", "[exercise]"),
    "close": ("## Where next", "## And so on"),
}


@pytest.mark.parametrize("line", BREAKS)
def test_the_linter_refuses(line, tmp_path, monkeypatch):
    for path in reading.SOLUTIONS.glob("*.md"):
        (tmp_path / path.name).write_bytes(path.read_bytes())
    (tmp_path / "teacher").mkdir()
    for path in (reading.SOLUTIONS / "teacher").glob("*.md"):
        (tmp_path / "teacher" / path.name).write_bytes(path.read_bytes())
    source = tmp_path / "01-frames.md"
    text = source.read_text(encoding="utf-8")
    old, new = BREAKS[line]
    assert old in text
    source.write_text(text.replace(old, new), encoding="utf-8")
    monkeypatch.setattr(reading, "SOLUTIONS", tmp_path)
    monkeypatch.setattr(reading, "LESSONS", tmp_path / "lessons")
    assert any(f"lesson 01, {line}:" in failure for failure in contract.report(["01"])[1])
    with pytest.raises(ValueError, match="nothing was built"):
        build.build(["01"])
    assert not (tmp_path / "lessons").exists()


def test_nbgrader_knows_every_cell():
    for path in reading.sources():
        cells = reading.read_source(path).cells
        ids = [cell.metadata.nbgrader.grade_id for cell in cells if "nbgrader" in cell.metadata]
        assert len(ids) == len(set(ids)) and len({cell.id for cell in cells}) == len(cells)
        points = sum(
            cell.metadata.nbgrader.get("points", 0) for cell in cells if "nbgrader" in cell.metadata
        )
        assert points == sum(
            exercises()[key].points for key in sittings()[reading.sitting_of(path)]
        )
