"""Building a lesson: what would hand out an answer or leave a student without a verdict is refused
in a sentence, with its line.
"""

import os
import re
import shutil
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import nbformat
import pytest

from dhlab.course.building import notebooks, reading
from dhlab.course.building.faults import runs, sources
from dhlab.course.exercises import exercises
from dhlab.course.kinds import Option, Said

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "add-an-exercise.md").read_text(encoding="utf-8")
BLOCK = re.compile(
    r"^(`{3,})\{code-block\} (\w+)\n:caption: (\S+)\n\n(.*?)^\1$", re.DOTALL | re.MULTILINE
)
SHEET = {name: text for _, _, name, text in BLOCK.findall(PAGE)}["solutions/10-suction-cup.md"]


# ---- stubs


@pytest.mark.parametrize(
    "source, stub",
    [
        (
            "x = ...\n### BEGIN SOLUTION\nx = 1\n### END SOLUTION",
            "# your answer here: replace the dots\nx = ...",
        ),
        (
            "q = 1  # in m, ...\nx = ...\n### BEGIN SOLUTION \nx = 1\n### END SOLUTION\nshow(x)",
            "q = 1  # in m, ...\n# your answer here: replace the dots\nx = ...\nshow(x)",
        ),
        (
            "x = [1,\n     ..., ...]\n### BEGIN SOLUTION\nx = 1\n### END SOLUTION",
            "x = [1,\n     # your answer here: replace the dots\n     ..., ...]",
        ),
        (
            "x = -1\n### BEGIN SOLUTION\nx = 1\n### END SOLUTION",
            "x = -1\n# your answer here: change the lines above",
        ),
        (
            (
                'def f():\n    """Of (rows, ...)."""\n    ### BEGIN SOLUTION\n    return 1\n    ###'
                " END SOLUTION"
            ),
            'def f():\n    """Of (rows, ...)."""\n    ...  # your code here',
        ),
    ],
)
def test_a_stub_says_where_the_answer_goes(source, stub):
    assert notebooks._stub(source) == stub


# ---- sources, before anything is run: lesson 05 with one change


def source(tmp_path, old, new):
    text = (reading.SOLUTIONS / "05-link-matrix.md").read_text(encoding="utf-8")
    assert old in text
    path = tmp_path / "solutions" / "05-link-matrix.md"
    path.parent.mkdir(exist_ok=True)
    path.write_text(text.replace(old, new, 1), encoding="utf-8")
    return path


def said(path):
    with pytest.raises(ValueError) as refused:
        sources.refuse_sources([path])
    return str(refused.value)


@pytest.mark.slow
def test_every_lesson_of_the_course_may_be_built():
    sources.refuse_sources(reading.sources())


RULE = 'rule = ...\n### BEGIN SOLUTION\nrule = "b"\n### END SOLUTION'


@pytest.mark.parametrize(
    "begin, end",
    [
        ("### BEGIN SOLUTION", "### END SOLUTON"),
        ("### BEGIN SOLUTION", None),
        (None, "### END SOLUTION"),
        ("### Begin solution", "### END SOLUTION"),
        ("# BEGIN SOLUTION", "# END SOLUTION"),
        ("###BEGIN SOLUTION", "### END SOLUTION"),
        ("### BEGIN SOLUTIONS", "### END SOLUTION"),
        ("### BEGIN SOLUTION", "### ENDSOLUTION"),
        ("### BEGIN SOLUTION", "### BEGIN SOLUTION"),
        ("### END SOLUTION", "### BEGIN SOLUTION"),
        ("### BEGIN SOLUTION ###", "### END SOLUTION"),
        (None, None),
        ("### LÖSUNG", "### ENDE"),
    ],
)
def test_a_marker_that_would_hand_out_the_answer_is_refused(begin, end, tmp_path):
    path = source(tmp_path, RULE, "\n".join(filter(None, ["rule = ...", begin, 'rule = "b"', end])))
    stub = path.read_text(encoding="utf-8").splitlines().index("rule = ...") + 1
    words = said(path)
    assert all(
        re.match(r"solutions/05-link-matrix.md, line \d+: expected ### (BEGIN|END) SOLUTION", line)
        for line in words.splitlines()
    ), words
    lines = [int(line) for line in re.findall(r"line (\d+)", words)]
    assert lines and all(stub - 6 <= line <= stub + 3 for line in lines), (words, stub)


def test_a_marker_is_named_with_its_line(tmp_path):
    path = source(tmp_path, RULE, RULE.replace("END SOLUTION", "END SOLUTON"))
    line = path.read_text(encoding="utf-8").splitlines().index("### END SOLUTON") + 1
    assert (
        said(path)
        == f"solutions/05-link-matrix.md, line {line}: expected ### BEGIN SOLUTION or ### END"
        " SOLUTION alone in its line, found '### END SOLUTON'; write it exactly so"
    )


@pytest.mark.parametrize(
    "old, new, words",
    [
        (
            "```{code-cell} ipython3\n:tags: [exercise, why]",
            "```{code-cel} ipython3\n:tags: [exercise, why]",
            "expected ### BEGIN SOLUTION in a code cell, found it in the text",
        ),
        (
            ':exercise: "05.2"',
            ':exercise: "05.22"',
            "found :exercise: '05.22' above this line; did you mean \"05.2\"?",
        ),
        (
            ':exercise: "05.2"',
            ":exercise: 05.2",
            "expected the id of an exercise in quotes, found :exercise: 5.2",
        ),
        (
            ':exercise: "05.2"',
            ':exercise: "05.1"',
            'expected one cell with :exercise: "05.1" above its code, found 2',
        ),
        (
            'check("05.2", rule)',
            'check("05.22", rule)',
            'expected the id of an exercise in quotes, found check("05.22"); did you mean "05.2"?',
        ),
        (
            'predict("05.P1"',
            'predict("05.1"',
            'expected the id of a prediction in quotes, found predict("05.1")',
        ),
        (
            '```{code-cell} ipython3\ncheck("05.2", rule)\n```\n',
            "",
            'expected one cell that begins with check("05.2", ...), found none',
        ),
        ("  minutes: 50", "  minutes: [50", "expected YAML in the head"),
        (":tags: [worked]", ":tags: [worked", "expected YAML in the head"),
        (
            "dhlab:\n",
            "dhlab: yes\nmore:\n",
            "expected dhlab: in the head with lines such as minutes: 15 under it",
        ),
        ("rule = ...", "rule = (", "expected Python, found a syntax error"),
        (
            "rule = ...",
            '#   "a" none of them\nrule = ...',
            "expected the options of 05.2 in its exercise alone, from where the lesson takes them",
        ),
        (
            "## A joint that slides",
            "## More practice\n\n## A joint that slides",
            "expected 05.9 elsewhere, found it below ## More practice; move its cell, or write"
            " practice=True in the exercise",
        ),
        (
            "## Where next",
            "## More practice",
            "expected ## More practice at the beginning of a cell; write +++ in the line above it",
        ),
    ],
)
def test_a_source_that_is_no_lesson_is_refused(old, new, words, tmp_path):
    found = said(source(tmp_path, old, new))
    assert words in found and all(
        line.startswith("solutions/05-link-matrix.md") for line in found.splitlines()
    ), found


def test_ipythons_commands_are_python(tmp_path):
    sources.refuse_sources(
        [source(tmp_path, "rot_z(np.pi / 2)\n", "%precision 3\nrot_z(np.pi / 2)\n")]
    )


def misspelt(exercise):
    options = {**exercise.options, "none": Option("x", "y", "wrong-frame-comparred")}
    return replace(exercise, options=options)


@pytest.mark.parametrize(
    "key, change, words",
    [
        (
            "05.2",
            lambda e: replace(e, correct="z"),
            "expected correct= one of none, about-one-axis, turns-with-shifts, both-turns,"
            " found 'z'",
        ),
        (
            "05.P1",
            lambda e: replace(e, correct="b"),
            "expected correct= one of same-place, step-turned, step-straight, found 'b'",
        ),
        (
            "05.P1",
            lambda e: replace(e, options={**e.options, "b": "elsewhere"}),
            "such as any-order, found 'b'; its letter is given when it is shown",
        ),
        (
            "05.3",
            lambda e: replace(e, items={**e.items, "rz": "Tz(d)"}),
            "expected options that differ, found one text twice",
        ),
        ("05.8", lambda e: replace(e, question=" "), "expected a question, found none"),
        ("05.2", misspelt, "found 'wrong-frame-comparred'; did you mean 'wrong-frame-compared'?"),
        (
            "05.2",
            lambda e: replace(e, words={"product-revresed": Said("x")}),
            "did you mean 'product-reversed'?",
        ),
        (
            "05.5",
            lambda e: replace(e, mistakes=lambda **row: [("lenght-unit", "", [1, 2, 3])] * 5),
            "did you mean 'length-unit'?",
        ),
        (
            "05.5",
            lambda e: replace(e, mistakes=lambda theta: []),
            "expected draw, answer and mistakes that run, found TypeError",
        ),
        (
            "05.3",
            lambda e: replace(e, explain=lambda letters: ("lenght-unit", "")),
            "did you mean 'length-unit'?",
        ),
        ("05.4", lambda e: replace(e, family="dh_transfrom"), "found 'dh_transfrom'"),
        ("05.5", lambda e: replace(e, hints=("a")), "found one text, 'a'; brackets alone make no"),
        ("05.8", lambda e: replace(e, hints=("a",)), "expected two hints, each a text, found ('a'"),
        ("05.3", lambda e: replace(e, praise=" "), "expected praise, found none"),
        (
            "05.5",
            lambda e: replace(e, mistakes=lambda **row: list(e.mistakes(**row))[:1] * 4),
            "with 5 wrong values or more, found 4",
        ),
        (
            "05.5",
            lambda e: replace(e, mistakes=lambda **row: [(None, "", e.answer(**row))] * 9),
            "with 5 wrong values or more, found 0",
        ),
    ],
)
def test_an_exercise_that_would_fail_a_student_is_refused(
    key, change, words, tmp_path, monkeypatch
):
    changed = {**exercises(), key: change(exercises()[key])}
    monkeypatch.setattr(sources, "exercises", lambda: changed)
    found = said(source(tmp_path, "## Key points", "## Key points"))
    assert (
        words in found
        and re.match(rf"dhlab/course/exercises/lesson05\.py(, line \d+)?, {key}: ", found)
        and "\n" not in found
    )


# ---- a lesson after its run: lesson 05 with one output changed


def after_a_run():
    """(source, solution, lesson that is handed out), each check with what it must say."""
    (path,) = reading.sources(["05"])
    solution = nbformat.read(path.with_suffix(".ipynb"), as_version=4)
    handed_out = notebooks.lesson_notebook(reading.read_source(path))
    for key, cell in checks(handed_out).items():
        say(cell, f"○ {key}  Not attempted yet")
    return path, solution, handed_out


def checks(notebook):
    """The cells that must say something: {exercise or prediction: cell}."""
    code = [cell for cell in notebook.cells if cell.cell_type == "code"]
    found = (re.search(r'\b(?:check|predict)\("([^"]+)"', cell.source) for cell in code)
    return {match[1]: cell for match, cell in zip(found, code) if match}


def say(cell, text):
    cell.outputs = [nbformat.v4.new_output("execute_result", {"text/plain": text})]


def fail(cell):
    cell.outputs = [
        nbformat.v4.new_output("error", ename="NameError", evalue="no letter\nx", traceback=[])
    ]


def refused(path, solution, handed_out):
    with pytest.raises(ValueError) as refused:
        runs.refuse_runs(path, solution, handed_out)
    return str(refused.value)


def test_a_lesson_whose_checks_say_what_they_must_is_built():
    runs.refuse_runs(*after_a_run())


WRONG = "✗ 05.2  Not yet: A turn about x."
GIVEN_AWAY = "✓ 05.2  Right: Turn and shift."


@pytest.mark.parametrize(
    "which, said, words",
    [
        (
            "solution",
            WRONG,
            f"expected 05.2 to be 'right' in the solution, found '{WRONG}'; correct the solution,"
            " or the exercise",
        ),
        (
            "solution",
            None,
            "found 'no verdict: the check must be the last line of its cell'; correct the solution",
        ),
        (
            "handed out",
            GIVEN_AWAY,
            "expected 05.2 to be 'not attempted' in the lesson that is handed out, found"
            f" '{GIVEN_AWAY}'; leave dots",
        ),
        (
            "handed out",
            None,
            "found 'no verdict: the check must be the last line of its cell'; leave dots",
        ),
    ],
)
def test_a_check_that_says_something_else_is_refused(which, said, words):
    path, solution, handed_out = after_a_run()
    cell = checks(solution if which == "solution" else handed_out)["05.2"]
    say(cell, said) if said else cell.outputs.clear()
    found = refused(path, solution, handed_out)
    line = path.read_text(encoding="utf-8").splitlines().index('check("05.2", rule)') + 1
    assert found.startswith(f"solutions/05-link-matrix.md, line {line}: ")
    assert words in found
    assert "\n" not in found


@pytest.mark.parametrize(
    "which, what", [("solution", "the solution"), ("handed out", "the lesson that is handed out")]
)
def test_a_cell_that_fails_is_named_before_its_checks(which, what):
    path, solution, handed_out = after_a_run()
    notebook = solution if which == "solution" else handed_out
    fail(checks(notebook)["05.2"])
    words = f"expected {what} to run, found NameError in this cell: no letter; correct it"
    assert words in refused(path, solution, handed_out)
    shown = next(cell for cell in notebook.cells if cell.source.startswith("import"))
    say(checks(notebook)["05.2"], "✓ 05.2  Right" if which == "solution" else "○ 05.2  Not yet")
    fail(shown)
    shown.metadata["tags"] = ["raises-exception"]
    runs.refuse_runs(path, solution, handed_out)


# ---- a sheet of one's own, built in a copy


@pytest.fixture(scope="module")
def clone(tmp_path_factory):
    place = tmp_path_factory.mktemp("clone")
    for name in ("dhlab", "solutions"):  # with what is compiled: it fits files of the same age
        shutil.copytree(ROOT / name, place / name, ignore=shutil.ignore_patterns("node_modules"))
    blocks = {name: text for _, _, name, text in BLOCK.findall(PAGE)}
    (place / "dhlab/course/exercises/lesson10.py").write_text(
        blocks["dhlab/course/exercises/lesson10.py"], encoding="utf-8"
    )
    return place


@pytest.mark.parametrize(
    "file, old, new, words",
    [
        (
            "sheet",
            'changed = "b"',
            'changed = "c"',
            (
                "expected 10.2 to be 'right' in the solution, found '✗ 10.2  Not yet: The base is"
                " where the arm stands.'; correct the solution"
            ),
        ),
        (
            "exercises",
            'correct="tool"',
            'correct="b"',
            (
                "dhlab/course/exercises/lesson10.py, line 40, 10.2: expected correct= one of table,"
                " tool, base, found 'b'"
            ),
        ),
        (
            "exercises",
            'title="A longer cup",',
            'title="A longer cup"',
            "dhlab/course/exercises/lesson10.py, line ",
        ),
        (
            "exercises",
            "tolerance=1e-4",
            "tolerence=1e-4",
            "found TypeError: Value.__init__() got an unexpected keyword argument 'tolerence'",
        ),
    ],
)
def test_what_a_sheet_of_ones_own_is_told(file, old, new, words, clone):
    module, sheet, lesson = (
        clone / "dhlab/course/exercises/lesson10.py",
        clone / "solutions/10-suction-cup.md",
        clone / "lessons/10-suction-cup.ipynb",
    )
    sheet.write_text(SHEET, encoding="utf-8")
    lesson.unlink(missing_ok=True)
    kept, changed = module.read_text(encoding="utf-8"), sheet if file == "sheet" else module
    text = changed.read_text(encoding="utf-8")
    assert old in text
    changed.write_text(text.replace(old, new), encoding="utf-8")
    try:
        done = subprocess.run(
            [sys.executable, "-m", "dhlab.course.building.build", "10"],
            cwd=clone,
            env={**os.environ, "PYTHONPATH": str(clone), "PYTHONDONTWRITEBYTECODE": "1"},
            capture_output=True,
            text=True,
            encoding="utf-8",
        )
    finally:
        module.write_text(kept, encoding="utf-8")
    assert (
        done.returncode == 1
        and words in done.stderr
        and "Traceback" not in done.stderr
        and not lesson.exists()
    ), done.stdout + done.stderr
    assert len(done.stderr.removeprefix("nothing was built:\n").strip().splitlines()) == 1
