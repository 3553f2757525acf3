"""The cage's own parts: what goes through the wire, what is watched, what a notebook of any age is
read as.
"""

import json
import marshal
import os
import subprocess
import sys
import time
from base64 import b64decode
from dataclasses import replace
from pathlib import Path

import numpy as np
import psutil
import pytest
from hypothesis import given
from hypothesis import strategies as st

sys.path.insert(0, str(Path(__file__).parent))
import contextlib

import corpus

import dhlab as dh
from dhlab.course.exercises import exercises
from dhlab.course.kinds import Function
from dhlab.doctor.programs.running.calling import Called, CallFault, record
from dhlab.grading.cage import cage, launch, levels, sight, stage
from dhlab.grading.inside.book import Book
from dhlab.grading.inside.clock import TimeLimit
from dhlab.grading.inside.reading import demonstrations, notebook
from dhlab.grading.inside.reading.cells import parsed
from dhlab.grading.inside.reading.slices import needed, statement
from dhlab.grading.inside.shell import run_cell
from dhlab.grading.inside.wire import Opaque, decode, encode
from dhlab.grading.judging import judge
from dhlab.grading.judging.asking import Asked
from dhlab.grading.judging.questions import Course, call_request, handed_out_checks, request, seed
from dhlab.grading.judging.work import Handed
from dhlab.grading.settings import Limits, Settings

COURSE = Course(("05", "06"), Settings(), {"ada": 7})


def through(value):
    """Out of the cage and in again, as text."""
    return decode(json.loads(json.dumps(encode(value))))


@pytest.mark.parametrize(
    "value",
    [
        None,
        True,
        3,
        2.5,
        "a",
        "",
        [1, [2, "b"], None],
        np.arange(6).reshape(2, 3),
        np.float32(1.1),
        np.array([1, 2], dtype="i2"),
        np.zeros((0, 4)),
        np.array(1e-300),
    ],
)
def test_values_come_through_exactly(value):
    found = through(value)
    if isinstance(value, (np.ndarray, np.generic)):
        assert (
            found.dtype == value.dtype
            and found.shape == value.shape
            and np.array_equal(found, value)
        )
    else:
        assert found == value and type(found) is type(value)


@pytest.mark.parametrize(
    "content",
    [
        ["f8", [2], "AAAAAAAA8D8="],
        ["f8", [-1], "AAAAAAAA8D8="],
        ["f8", [1] * 7, "AAAAAAAA8D8="],
        ["f8", [1], "AAAAAAAA8D8"],
        ["f8", [1], "AAAA_AAA8D8="],
        ["f8", [1], [1.0]],
        ["f8", "1", "AAAAAAAA8D8="],
        ["O", [1], "AAAAAAAA8D8="],
        ["f8", [100_001], "A" * 1_100_004],
    ],
)
def test_bytes_that_are_no_array_are_refused(content):
    assert decode({"packed": ["f8", [1], "AAAAAAAA8D8="]}) == [1.0]
    with pytest.raises(judge.DECODED):
        decode({"packed": content})


def test_numbers_come_through_whatever_the_order_of_their_bytes():
    assert through(np.array([1.5, -2.0], dtype=">f8")).tolist() == [1.5, -2.0]


def test_the_unattempted_and_what_is_no_number_come_through_as_such():
    assert through([..., ...]) == [Ellipsis, Ellipsis] and through((1, 2)) == [1, 2]
    assert (
        np.isnan(through(np.array([np.nan]))).all()
        and through(float("inf")) == float("inf")
        and through(2**70) == float(2**70)
    )
    for odd in (
        object(),
        b"x",
        {1, 2},
        3 + 4j,
        np.array([1j]),
        lambda: 0,
        type("X<script>", (), {})(),
    ):
        assert (
            isinstance(through(odd), Opaque) and type(through(odd)).__name__.isidentifier()
        ) or type(through(odd)).__name__.isprintable()
    # a stranger's class may be called anything
    assert type(through(type("You get 10 of 10", (), {})())).__name__ == "object"


def test_tables_and_arms_come_through():
    arm = dh.load("panda")
    q = np.linspace(-1, 1, len(arm))
    assert through(arm.table) == arm.table
    assert np.array_equal(through(arm).forward(q), arm.forward(q))


def test_that_an_arm_was_loaded_comes_through_and_no_word_of_its_source():
    assert through(dh.load("panda")).source == "loaded"
    own = dh.assign_frames([([0, 0, 0], [0, 0, 1])], end=np.eye(4), source="10 of 10")
    assert through(own).source == "loaded" and not through(replace(own, source="")).source


def test_a_coupling_comes_through():
    coupling = [[1, 0], [1, 1]]
    arm = dh.Arm(dh.DHTable.standard(np.eye(2, 4), angle="rad"), coupling=coupling)
    assert np.array_equal(through(arm).coupling, coupling)
    assert through(dh.Arm(arm.table)).coupling is None


JSON = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=5),
    lambda inner: (
        st.lists(inner, max_size=4)
        | st.dictionaries(
            st.sampled_from(["...", "array", "packed", "dict", "table", "arm", "other", "x"])
            | st.text(max_size=3),
            inner,
            max_size=2,
        )
    ),
    max_leaves=12,
)


@given(JSON)
def test_whatever_comes_out_is_read_or_refused(sent):
    with contextlib.suppress(judge.DECODED):
        decode(sent)


@given(
    st.dictionaries(
        st.sampled_from(["value", "function", "cell", "calls", "stopped"]), JSON, max_size=4
    ),
    st.sampled_from(["05.2", "05.3", "05.4", "05.5", "05.9", "06.6"]),
)
def test_whatever_was_noted_gets_a_mark(line, key):
    answers = judge.Answers()
    answers.add(
        cage.Run([{"check": key, **line}, {"cell": 1, "ids": [key]}], "done", 1),
        Handed("a.ipynb", b"{}"),
    )
    mark, _ = judge.mark(
        exercises()[key], answers, 7, Settings(), lambda *note: (Asked(stopped="crashed"), 7)
    )
    assert mark.of == exercises()[key].points and 0 <= mark.points <= mark.of
    assert mark.points == 0 or mark.status == "right"


@pytest.mark.slow
@pytest.mark.parametrize("key", [key for key, e in exercises().items() if isinstance(e, Function)])
def test_what_a_function_gave_elsewhere_is_judged_as_the_function_itself(key):
    exercise = exercises()[key]
    for variant in (0, seed(None, "00", "ada", key)):
        cases = exercise.cases(variant)
        for function in (
            exercise.answer,
            lambda *case: -np.asarray(exercise.answer(*case)),
            lambda *case: "x",
            lambda: 0,
        ):
            here, there = (
                exercise.judge(function, variant),
                exercise.judge(record(function, cases, exercise.names), variant),
            )
            assert here == there
    assert exercise.judge(Called(unwritten=True)).status == "not attempted"
    assert exercise.judge(Called(fault=CallFault("it stops"))).headline == "it stops"


def test_no_input_and_no_answer_is_sent_beforehand():
    sent = request(COURSE, 7)
    assert {
        name: decode(value) for name, value in decode(sent["given"]["05.5"]).items()
    } == exercises()["05.5"].given(7)
    assert set(sent) == {
        *("checks", "given", "functions", "only", "skip", "untouched", "cell_seconds")
    }
    asked = call_request(sent, exercises()["05.4"], 3)
    assert set(asked) == {
        *("checks", "given", "skip", "cell_seconds"),
        *("call", "names", "cell", "whole", "transform", "untouched"),
    }
    assert "rot_x" in marshal.loads(b64decode(asked["transform"])).co_names
    # the move that is to be written is not sent along, nor what it could be made from
    assert call_request(sent, exercises()["05.1"], 3)["transform"] == ""


def test_inputs_depend_on_the_key_and_on_the_recorded_number():
    drawn = {
        seed(key, number, student, exercise)
        for key in (None, b"k", b"l")
        for number in ("00", "01")
        for student in ("ada", "bo")
        for exercise in ("05.4", "05.6")
    }
    assert len(drawn) == 24
    cases = [exercises()["05.4"].cases(number) for number in sorted(drawn)[:3]]
    assert cases[0][0] != cases[1][0] != cases[2][0]


def test_every_scored_exercise_has_its_check_in_a_lesson():
    handed_out = {key for checks in handed_out_checks().values() for key in checks}
    assert {key for key, exercise in exercises().items() if exercise.points > 0} <= handed_out


def sliced(source, *names):
    """The lines of a cell that these names depend on."""
    found = needed([statement(0, node) for node in parsed(source, "<cell>")], names)
    return [one.node.lineno for one in found]


@pytest.mark.parametrize(
    "source, lines",
    [
        ("a = 1\nb = a + 1\nf = lambda: b\nc = 3", [1, 2, 3]),
        # names of its own are a function's own affair
        ("T = 1\ndef f(T):\n    x = T\n    return [T for T in x]", [2]),
        ("def g(): return 1\ndef f(): return g()", [1, 2]),
        ("import numpy as np\ndef f(): return np.pi", [1, 2]),
        # what is changed in place
        ("m = {}\nm[1] = 2\nk = []\nk.append(1)\ndef f(): return m, k", [1, 2, 3, 4, 5]),
        ("m = {}\ndef fill(): m[1] = 2\nfill()\ndef f(): return m", [1, 2, 3, 4]),
        ("for i in range(3):\n    total = i\nf = total", [1, 3]),
        ("class A:\n    k = c\nc = 1\nf = A()", [1, 3, 4]),
        ("print(f)\nf = 1\nprint(f)", [2]),
        ("from math import *\nf = 1", [1, 2]),
        ("exec('f = 1')\ng = 2", [1]),
        ("f = 1\nf += 1\ndel f\nf: int = 2", [1, 2, 3, 4]),
        ("if True:\n    def f(): return a\na = 1", [1, 3]),
        ("f = (a := 1)\nb = a", [1]),
    ],
)
def test_what_a_name_depends_on(source, lines):
    assert sliced(source, "f") == lines


def test_cells_run_as_in_jupyter():
    space = {}
    run_cell("%matplotlib inline\nfiles = !ls\nx = 1", "<1>", space)
    run_cell("%%time\ny = x + 1", "<2>", space)
    run_cell(
        "import not_here as n, math\nfrom neither_here import a, b\nz = math.pi\nn.f(1).g[0] if"
        " False else a(2)",
        "<3>",
        space,
    )
    run_cell("import asyncio\nawait asyncio.sleep(0)\nw = 3", "<4>", space)
    run_cell("try:\n    import not_here\nexcept ImportError:\n    fallback = True", "<5>", space)
    assert (space["x"], space["y"], space["z"], space["w"], space["fallback"], space["files"]) == (
        1,
        2,
        np.pi,
        3,
        True,
        [],
    )
    with pytest.raises(ZeroDivisionError):
        run_cell("1 / 0", "<6>", space)
    assert not issubclass(TimeLimit, Exception)


def test_only_one_exercise_runs_no_further_than_its_check():
    cells = notebook.read(json.dumps(corpus.solved()).encode(), handed_out_checks())
    assert cells.lesson == "05" and not cells.unplaced
    assert "05.3" in cells.code[cells.last_for(["05.3"])].ids and cells.last_for([]) is None
    assert cells.last_for(["05.3"]) < cells.last_for(["05.9"]) < len(cells.code)


def test_a_level_that_does_not_work_is_said(monkeypatch):
    monkeypatch.setattr(launch.shutil, "which", lambda name: "/bin/false")
    with pytest.raises(ValueError, match="expected the cage 'bubblewrap' to work here"):
        cage.Cage("bubblewrap")


@pytest.mark.parametrize("program", ["/bin/false", "/not/installed/bwrap"])
def test_marks_are_given_in_bubblewrap_unless_another_cage_is_named(program, monkeypatch):
    monkeypatch.setattr(launch.shutil, "which", lambda name: program)
    with pytest.raises(ValueError, match="expected bubblewrap, .* --cage landlock"):
        cage.Cage()


def test_python_by_a_relative_path(monkeypatch):
    here = os.path.relpath(sys.executable)
    monkeypatch.setattr(sys, "executable", here)
    assert os.path.isabs(stage.python_command("/x", "{}")[0])
    assert all(map(os.path.isabs, sight.readable()))


def test_the_room_for_own_programs_has_what_numpy_and_sympy_need_and_no_extra_of_theirs():
    seen = {Path(path).name for path in sight.kept()}
    assert {"numpy", "scipy", "sympy", "mpmath", "matplotlib", "pygments"} <= seen
    # of pytest, which tests numpy, an extra of theirs; and what knows kinematics
    assert not seen & {"_pytest", "pytest", "sphinx", "pinocchio", "roboticstoolbox", "dhlab"}


@pytest.mark.cage
@pytest.mark.parametrize("level", ["bubblewrap", "landlock"])
def test_a_grader_that_is_killed_leaves_nothing(level):
    source = (
        "import time; from dhlab.grading.cage.cage import Cage\n"
        "from dhlab.grading.cage.folder import staged\n"
        f"one = Cage({level!r})\n"
        "print(one._folder.path, staged(one.room), one._process.pid, flush=True)\n"
        "time.sleep(100)"
    )
    with subprocess.Popen(
        [sys.executable, "-c", source], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
    ) as grader:
        said = grader.stdout.readline().split()
        grader.kill()
    if not said:
        pytest.skip(f"{level} does not work on this machine")
    *folders, child = *map(Path, said[:-1]), int(said[-1])
    for _ in range(600):
        left = [folder for folder in folders if folder.exists()]
        if not left and not psutil.pid_exists(child):
            break
        time.sleep(0.1)
    assert not left and not psutil.pid_exists(child)


def test_the_best_level_is_taken_and_its_risk_is_known():
    assert levels.best_level() in levels.RISKS and "trust" in levels.RISKS["rlimits"]


FROM_A_FILE = """
import ctypes, os
libc, (out, into), got = ctypes.CDLL(None), os.pipe(), []
for command in (8, 10, 8 + 2**32):  # F_SETOWN, F_SETSIG
    got.append(libc.fcntl(out, ctypes.c_long(command), os.getppid()) >= 0)
"""
WITHOUT_A_NAME = """
f = os.open("f", os.O_CREAT | os.O_RDWR)
os.unlink("f")
got.append(not os.path.exists("f"))
for make in (lambda: os.open(".", os.O_TMPFILE | os.O_RDWR), lambda: os.rename("f", "g")):
    try:
        got.append(make() is None or True)
    except OSError:
        got.append(False)
got.append(libc.fallocate(f, 1, ctypes.c_long(0), ctypes.c_long(1 << 20)) == 0)
"""


@pytest.mark.cage
@pytest.mark.parametrize(
    "level, source", [("bubblewrap", FROM_A_FILE), ("landlock", FROM_A_FILE + WITHOUT_A_NAME)]
)
def test_a_file_signals_nobody_and_keeps_its_name(level, source):
    try:
        room = cage.Cage(level, Limits(cell_seconds=5))
    except ValueError:
        pytest.skip(f"{level} does not work on this machine")
    tell = "from dhlab.course import check\ncheck('05.2', [int(one) for one in got])"
    notebook = {"cells": [{"cell_type": "code", "source": source + tell, "metadata": {}}]}
    with room:
        asked = request(COURSE, 0)
        run = room.run(asked, json.dumps(notebook).encode(), 10)
    (said,) = [line["value"] for line in run.lines if "check" in line]
    assert not any(said)


@pytest.mark.cage
def test_a_cage_that_is_killed_is_built_again():
    if sys.platform != "linux":
        pytest.skip("processes are found in another way here")
    raw, asked = json.dumps(corpus.solved()).encode(), request(COURSE, 7)
    with cage.Cage(limits=Limits(cell_seconds=5)) as one:
        first = one.run(asked, raw, 60)
        one._process.kill()
        second, third = one.run(asked, raw, 60), one.run(asked, raw, 60)
    assert first.ended == third.ended == "done" and second.ended in ("done", "crashed")
    assert [line for line in first.lines if "check" in line] == [
        line for line in third.lines if "check" in line
    ]


@pytest.mark.cage
def test_whatever_stops_the_grader_in_a_submission_the_next_one_runs(monkeypatch):
    """Its parent would still wait for the end of the one before, and take this one for it."""
    asked = request(COURSE, 0)
    with cage.Cage() as one:
        with monkeypatch.context() as patched:
            patched.setattr(one, "_learn", lambda lines: 1 / 0)
            with pytest.raises(ZeroDivisionError):
                one.run(asked, _one_cell("x = 1"), 20)
        assert one.run(asked, _one_cell("x = 1"), 20).ended == "done"


def test_of_notes_without_end_the_first_and_the_last_are_heard():
    sent = []
    noted = Book({}, [], sent.append)
    for number in range(60):
        noted.note("05.2", number)
    noted.send_last()
    noted.send_last()
    assert [line["value"] for line in sent] == [*range(50), 59]


def code(source, *ids):
    return notebook.Cell(source, list(ids))


def test_cells_that_only_show_something_need_not_run():
    cells = [
        code("import numpy as np\nimport dhlab as dh\nnp.set_printoptions(precision=3)"),
        code("arm = dh.load('ur5e')\nq = np.zeros(6)"),  # what the answer uses
        code("print(arm.forward(q))\ndh.explore(arm)"),
        code(
            "def helper(x): return later(x)"
        ),  # called by the answer, which calls what comes later
        code("for name in ('a', 'b'):\n    other = dh.load(name)"),
        code("def later(x): return x"),
        code("answer = helper(arm.table.rows)", "06.1"),
        code("arm = dh.load('piper')\nshown = arm.forward(q)"),  # after it
        code("mine = 1"),  # the student's own
        code("def (", "06.2"),
    ]
    prints = {demonstrations.print_of(cell.source) for cell in cells} - {
        demonstrations.print_of("mine = 1")
    }
    assert demonstrations.skippable(cells, prints, ()) == {2, 4, 7}
    assert demonstrations.skippable(cells, prints, ("shown",)) == {2, 4}
    assert demonstrations.skippable(cells, (), ()) == set()


def test_what_is_bound_anew_need_not_be_made_before():
    cells = [
        code("board = slow()"),  # another board than the answer's
        code("board.move(1)"),
        code("board, rows = quick(), 1"),
        code("answer = board.arm", "06.1"),
        code("rows = slow()"),  # after the check that reads rows
        code("def f(): return late"),
        code("late = slow()"),  # which the function may read, whoever binds it
        code("late = 2"),
        code("mine = f()", "06.2"),
    ]
    prints = {demonstrations.print_of(cell.source) for cell in cells}
    assert demonstrations.skippable(cells, prints, (), {3: {"rows"}}) == {0, 1, 4}
    assert demonstrations.skippable(cells, prints, ("rows",)) == {0, 1}
    own = prints - {demonstrations.print_of(cells[2].source)}
    # a student's cell may stop before it binds anything
    assert demonstrations.skippable(cells, own, (), {3: {"rows"}}) == {4}


def test_a_diagnosis_that_is_only_shown_is_not_made():
    import ast

    import dhlab
    from dhlab.grading.inside.shell import _only_shows

    def shows(source, **names):
        return _only_shows(ast.parse(source).body[0], {"dh": dhlab, **names})

    assert shows("print(dh.diagnose(table, task['q'], noise=(1, 2)))")
    assert shows("dh.equivalent(a, b)")
    for source in (
        "found = dh.diagnose(table)",
        "print(dh.diagnose(mine()))",
        "print(dh.diagnose(table), file=there)",
        "dh.diagnose(table).save('x')",
        "print(dh.diagnose(q := 3))",
        "print(table)",
    ):
        assert not shows(source), source
    assert not shows("dh.diagnose(table)", dh=3)
    assert not shows("print(dh.diagnose(table))", print=3)


FORGED = """import os
for file in range(3, 30):
    try:
        os.write(file, b'\\n{"done": "", "loaded": ["this", "sympy", "pydoc", 3, []]}\\n')
    except OSError:
        pass
"""


def _one_cell(source):
    cells = [{"cell_type": "code", "source": source, "metadata": {}, "id": "a"}]
    return json.dumps({"cells": cells, "metadata": {}}).encode()


@pytest.mark.cage
def test_what_one_submission_has_loaded_is_warm_for_those_after_it_of_a_list_alone():
    warm = _one_cell("import sys\nif 'colorsys' in sys.modules: raise KeyError")
    with cage.Cage(warm=("colorsys",)) as one:

        def run(raw):
            return one.run(request(COURSE, 0), raw, 20), one.learnt

        assert run(_one_cell("import colorsys, this"))[1]
        told, learnt = run(warm)
        assert not learnt and any(line.get("ended") == "error" for line in told.lines)
        assert not run(_one_cell(FORGED))[1]
        told, _ = run(_one_cell("import sys\nassert not {'this', 'sympy'} & {*sys.modules}"))
        assert not any(line.get("ended") for line in told.lines)


@pytest.mark.cage
def test_a_run_tells_its_code_first_and_a_submission_cannot_tell_another():
    raw = _one_cell(FORGED.replace('"done": ""', '"slim": {"cells": []}'))
    with cage.Cage() as one:
        lines = one.run(request(COURSE, 0), raw, 20).lines
    assert [cell["source"] for cell in lines[0]["slim"]["cells"]] == [
        json.loads(raw)["cells"][0]["source"]
    ]
