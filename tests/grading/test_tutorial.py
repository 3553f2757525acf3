"""The page "Add an exercise and a lesson", done as it says in a copy of the tree: built, handed
out, answered, graded, reported.
"""

import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import nbformat
import pytest

ROOT = Path(__file__).parents[2]
BLOCK = re.compile(
    r"^(`{3,})\{code-block\} (\w+)\n:caption: (\S+)\n\n(.*?)^\1$", re.DOTALL | re.MULTILINE
)
OPTION = re.compile(r'^- `"(\w)"` (.*)$', re.MULTILINE)
ANSWERS = {
    "ada": (
        (
            'touches = (dh.load("article-6r").forward(np.deg2rad(task["q"])) @ [0, 0,'
            ' task["length"], 1])[:3]'
        ),
        'changed = "{the tool, and nothing of the table}"',  # the letter that it has in her lesson
    ),
    "bo": (
        'touches = dh.load("article-6r").forward(np.deg2rad(task["q"]))[:3, 3]',
        'changed = "?"',
    ),
}


@pytest.fixture(scope="module")
def blocks():
    return {
        name: text
        for _, _, name, text in BLOCK.findall(
            (ROOT / "docs" / "add-an-exercise.md").read_text(encoding="utf-8")
        )
    }


@pytest.fixture(scope="module")
def clone(tmp_path_factory, blocks):
    """A copy of the repository's library with the page's two files in it."""
    place = tmp_path_factory.mktemp("clone")
    caches = shutil.ignore_patterns("__pycache__", "node_modules")
    for name in ("dhlab", "solutions"):
        shutil.copytree(ROOT / name, place / name, ignore=caches)
    for name in (
        "dhlab/course/exercises/lesson10.py",
        "solutions/10-suction-cup.md",
        "course.yaml",
    ):
        (place / name).write_text(blocks[name], encoding="utf-8")
    (place / "roster.csv").write_text("student,name\nada,Ada\nbo,Bo\n")
    run(place, blocks["build"])
    return place


def run(place, line):
    """A command of the page, with the copy's library in the place of the installed one."""
    words = shlex.split(line)
    command = (
        [sys.executable, *words[1:]] if words[0] == "python" else [sys.executable, "-m", *words]
    )
    done = subprocess.run(
        command,
        cwd=place,
        env={**os.environ, "PYTHONPATH": str(place)},
        capture_output=True,
        text=True,
        encoding="utf-8",
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def _with_letter(answer, letters):
    """An answer with the letter in the place of an option's text."""
    return re.sub(r"\{(.*?)\}", lambda text: letters[text[1]], answer)


@pytest.fixture(scope="module")
def graded(clone, blocks):
    run(clone, blocks["release"])
    for student, answers in ANSWERS.items():
        source = clone / "handed-out" / student / "10-suction-cup.ipynb"
        notebook = nbformat.read(source, as_version=4)
        cells = [cell for cell in notebook.cells if "exercise" in cell.metadata]
        shown = "\n".join(cell.source for cell in notebook.cells)
        letters = {text: letter for letter, text in OPTION.findall(shown)}
        for cell, answer in zip(cells, answers):
            cell.source = f"{cell.source}\n{_with_letter(answer, letters)}"
        (clone / "handed-in" / student).mkdir(parents=True)
        nbformat.write(notebook, clone / "handed-in" / student / source.name)
    run(clone, blocks["grade"])
    return {
        student: json.loads(
            (clone / "graded" / "marks" / f"{student}.json").read_text(encoding="utf-8")
        )
        for student in ANSWERS
    }


def test_the_lesson_is_built_without_its_solutions(clone):
    handed_out, solution = (
        (clone / folder / "10-suction-cup.ipynb").read_text(encoding="utf-8")
        for folder in ("lessons", "solutions")
    )
    assert "SOLUTION" not in handed_out and "T_0F" not in handed_out and "T_0F" in solution
    assert solution.count("10.1  Right") + solution.count("10.1 Right") >= 1


def test_every_student_has_own_numbers(clone, graded):
    first, second = (
        nbformat.read(
            clone / "handed-out" / student / "10-suction-cup.ipynb", as_version=4
        ).metadata.dhlab.variant
        for student in ANSWERS
    )
    assert first != second and {graded["ada"]["variant"], graded["bo"]["variant"]} == {
        first,
        second,
    }


def test_it_is_graded_and_the_mistake_has_its_name(graded, blocks):
    right, wrong = graded["ada"]["marks"], graded["bo"]["marks"]
    assert [(mark["status"], mark["points"], mark["of"]) for mark in right] == [
        ("right", 2, 2),
        ("right", 3, 3),
    ]
    assert [mark["status"] for mark in wrong] == ["wrong", "wrong"] and wrong[0][
        "mistake"
    ] == "wrong-frame-compared"
    assert (
        blocks["verdict"].split()
        == f"✗ 10.1 Not yet: {wrong[0]['headline']} Next: {wrong[0]['next']}".split()
    )


def test_it_is_in_the_report(clone, graded):
    report = (clone / "graded" / "class-report.html").read_text(encoding="utf-8")
    assert (
        "10.1 Where the cup touches" in report and "10 A suction cup, “Where it touches”" in report
    )


def test_the_contract_is_asked_of_our_own_lessons():
    from dhlab.course.building.reading import read_source, sources

    assert all(read_source(path).metadata["dhlab"].get("contract", True) for path in sources())


def test_the_exercise_passes_what_every_exercise_must(clone):
    run(
        clone,
        "python -m pytest -q -o addopts= -p no:cacheprovider"
        f" {shlex.quote(str(ROOT / 'tests' / 'course' / 'test_exercises.py'))} -k 10.1 --rootdir"
        f" {shlex.quote(str(clone))}",
    )


def test_the_program_of_the_page_is_built_and_its_mistakes_have_names(clone, blocks):
    for name in ("dhlab/course/exercises/lesson11.py", "solutions/11-cup-pose.md"):
        (clone / name).write_text(blocks[name], encoding="utf-8")
    try:
        run(clone, "python -m dhlab.course.building.build 11")
        told = run(clone, f"python -c {shlex.quote(PROGRAM)}")
        assert blocks["said"] in told and told.splitlines()[3:] == [
            "wrong True",
            *["wrong True"] * 3,
        ]
        assert "T_FC" not in (clone / "lessons" / "11-cup-pose.ipynb").read_text(encoding="utf-8")
    finally:
        for name in ("dhlab/course/exercises/lesson11.py", "solutions/11-cup-pose.md"):
            (clone / name).unlink()


PROGRAM = """
import sys
sys.stdout.reconfigure(encoding="utf-8")
from dhlab.course import check
from dhlab.course.exercises import exercises
from dhlab.doctor.programs.explain import WRONG_VERSIONS
exercises()
print(check("11.1", lambda T_0F, length: T_0F), end="\\n\\n")
for mistake, place, version in WRONG_VERSIONS["cup_pose"]:
    verdict = check("11.1", version)
    print(verdict.status, verdict.mistake == mistake)
"""


def test_students_get_what_the_page_says_they_get(clone, blocks, tmp_path):
    for name in ("pyproject.toml", "README.md", "LICENSE"):
        shutil.copy(ROOT / name, clone / name)
    run(clone, blocks["wheel"].replace("--no-deps", "--no-deps --no-build-isolation --no-index"))
    (wheel,) = (clone / "wheels").glob("*.whl")
    assert wheel.name in (ROOT / "docs" / "add-an-exercise.md").read_text(encoding="utf-8")
    names = zipfile.ZipFile(wheel).namelist()
    assert {"dhlab/course/exercises/lesson10.py", "dhlab/lessons/10-suction-cup.ipynb"} <= set(
        names
    ) and not any(name.startswith("solutions") for name in names)


# ---- the page "Teaching with dhlab"

TEACHING = (ROOT / "docs" / "teaching.md").read_text(encoding="utf-8")


def test_the_files_of_the_teaching_page_are_read(tmp_path):
    from dhlab.grading.intake.roster import read_roster
    from dhlab.grading.settings import read_settings

    files = {name: text for _, _, name, text in BLOCK.findall(TEACHING)}
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    students, settings = (
        read_roster(tmp_path / "roster.csv"),
        read_settings(tmp_path / "course.yaml"),
    )
    assert (
        [student.language for student in students] == ["en", "zh_CN"]
        and settings.percent_per_day == 10
        and set(settings.lessons) == {"05", "06"}
    )
    assert (
        settings.lessons["06"].points == {"06.2": 5}
        and settings.lessons["05"].due.utcoffset().total_seconds() == 3600
    )


def test_the_limits_of_the_teaching_page_are_the_defaults():
    from dhlab.grading.settings import Limits

    limits = Limits()
    assert (
        f"{limits.cell_seconds:g} s of processor for a cell, {limits.seconds:g} s for a notebook,"
        f" {limits.memory_mb} MB of memory and {limits.files_mb} MB of files"
        in " ".join(TEACHING.split())
    )


@pytest.mark.parametrize(
    "line", re.findall(r"(?m)(?:^|`)dhlab ((?:release|grade|export) [^`\n|]+)", TEACHING)
)
def test_the_commands_of_the_teaching_page_exist(line):
    import typer

    from dhlab.cli.app import app

    command, words = typer.main.get_command(app), shlex.split(line)
    while hasattr(command, "commands"):
        command = command.commands[words.pop(0)]
    known = {option for parameter in command.params for option in parameter.opts}
    assert {word for word in words if word.startswith("--")} <= known and words
