"""A teacher's own items, as the page "Teaching" says: handed out without their definition, graded
with it.
"""

import json
import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from dhlab.course import check
from dhlab.course.exercises import exercises
from dhlab.grading.handing_out import own_notebooks
from dhlab.grading.intake.notebooks import numbers_of
from dhlab.grading.own_items import Items, install, own_checks, read_items
from dhlab.grading.settings import Settings

ROOT = Path(__file__).parents[2]
BLOCK = re.compile(
    r"^```\{code-block\} \w+\n:caption: (\S+)\n\n(.*?)^```$", re.DOTALL | re.MULTILINE
)


@pytest.fixture(scope="module")
def blocks():
    return dict(BLOCK.findall((ROOT / "docs" / "teaching.md").read_text(encoding="utf-8")))


def run(place, line):
    done = subprocess.run(
        [sys.executable, "-m", *shlex.split(line)],
        cwd=place,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.mark.cage
def test_the_page(tmp_path, blocks):
    for name in ("own_items.py", "course-own.yaml"):
        (tmp_path / name).write_text(blocks[name], encoding="utf-8")
    (tmp_path / "roster.csv").write_text("student,name\nada,Ada\nbo,Bo\n")
    run(tmp_path, blocks["release-own"])
    tasks = {}
    for student in ("ada", "bo"):
        path = tmp_path / "handed-out" / student / "90-own.ipynb"
        text = path.read_text(encoding="utf-8")
        # nothing that tells: not the programs, the wrong answers, or what is said of options
        for secret in ("def tip", "article-6r", "forward", "not the tip", "ends at the flange"):
            assert secret not in text, secret
        notebook = json.loads(text)
        cells = {cell["id"]: "".join(cell["source"]) for cell in notebook["cells"]}
        tasks[student] = eval(cells["numbers-90-1"].partition("task = ")[2], {"np": np})
        letters = {said: letter for letter, said in re.findall(r'- `"(\w)"` (.*)', text_of(cells))}
        right = _tip(**tasks[student])
        answers = {
            "answer-90-1": f"answer_1 = {(right if student == 'ada' else _tip(**tasks['ada']))}",
            "answer-90-2": f"answer_2 = {letters['the tool alone']!r}",
            "answer-90-3": "answer_3 = 'It ends at the flange.'",
        }
        for cell in notebook["cells"]:
            cell["source"] = answers.get(cell["id"], cell["source"])
        (tmp_path / "handed-in" / student).mkdir(parents=True)
        copy = tmp_path / "handed-in" / student / path.name
        copy.write_text(json.dumps(notebook), encoding="utf-8")
    assert any(np.any(tasks["ada"][key] != tasks["bo"][key]) for key in tasks["ada"])
    run(tmp_path, blocks["grade-own"])
    for student, points in (("ada", [3, 1, 0]), ("bo", [0, 1, 0])):
        told = json.loads((tmp_path / "graded" / "marks" / f"{student}.json").read_text())
        assert [mark["points"] for mark in told["marks"]] == points
        assert told["marks"][2]["status"] == "to be marked"
        page = (tmp_path / "graded" / "feedback" / f"{student}.html").read_text(encoding="utf-8")
        assert "The tip" in page and "your own numbers" not in page


def text_of(cells):
    return "\n".join(cells.values())


def _tip(q, length):
    """By the arm's URDF-free product of its own frames, written out: Rz Tz Tx Rx, row by row."""
    rows = [(0.1, 0, 90), (0, 0.4, 0), (0, 0.35, 0), (0.1, 0, 90), (0, 0, -90), (0.1, 0, 0)]
    T = np.eye(4)
    for theta, (d, a, alpha) in zip(np.deg2rad(q), rows):
        c, s, ca, sa = np.cos(theta), np.sin(theta), *_exact(alpha)
        T = T @ [
            [c, -s * ca, s * sa, a * c],
            [s, c * ca, -c * sa, a * s],
            [0, sa, ca, d],
            [0, 0, 0, 1],
        ]
    return (T @ [0, 0, length, 1])[:3].tolist()


def _exact(alpha):
    return {0: (1, 0), 90: (0, 1), -90: (0, -1)}[alpha]


def test_a_copy_says_whose_numbers_it_has_in_its_cells_too(monkeypatch):
    """Some programs keep nothing that stands beside the cells."""
    monkeypatch.setattr(own_notebooks, "install", lambda items: None)
    text = "EXERCISES = [Value(id='94.1', title='x', answer=lambda: 1)]"
    items = Items("94.py", f"from dhlab.course.kinds import Value\n{text}")
    (made,) = own_notebooks.notebooks_of(items, 2**32 + 7).values()
    notebook = json.loads(made) | {"metadata": {}}
    assert numbers_of(json.dumps(notebook).encode()) == {2**32 + 7}


def test_a_student_is_told_only_that_it_is_noted():
    assert check("91.1", ...).status == "not attempted"
    told = check("91.1", 5)
    assert told.status == "recorded" and "teacher" in str(told)


@pytest.mark.parametrize(
    "text, words",
    [
        ("import numpy\n\n1 / 0", "line 3: .*ZeroDivisionError"),
        ("x = (", "line 1: .*SyntaxError"),
        ("EXERCISES = 5", "a list of exercises"),
        (
            "from dhlab.course.kinds import Value\n"
            "EXERCISES = [Value(id='05.1', title='x', answer=lambda: 1)]",
            "ids from 90.1 on",
        ),
        (
            "from dhlab.course.kinds import Value\n"
            "EXERCISES = [Value(id='93.1', title='x', answer=lambda x: 1,"
            " draw=lambda rng: {'x': rng})]",
            "found Generator",
        ),
    ],
)
def test_a_wrong_file_is_told(tmp_path, text, words):
    (tmp_path / "mine.py").write_text(text)
    with pytest.raises(ValueError, match=words):
        read_items(tmp_path / "mine.py")


def test_nothing_by_which_it_is_judged_enters_the_cage(blocks):
    from dhlab.grading.judging.questions import Course, request

    before = dict(exercises())
    try:
        items = Items("test.py", blocks["own_items.py"])
        install(items)
        assert list(own_checks()["90"]) == ["90.1", "90.2", "90.3"]
        asked = json.dumps(request(Course(("90",), Settings(items=items), {}), 7))
        assert "tip" not in asked and "tool" not in asked and "length" in asked
    finally:
        for key in set(exercises()) - set(before):
            del exercises()[key]
        from dhlab.grading import own_items

        own_items._installed.clear()
