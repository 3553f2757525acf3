"""Marks that nobody earned: every way of sending right lines without having written the program,
and honest programs of every shape beside them.
"""

import inspect
import json
import shutil
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
import corpus
from corpus_making import RIGHT_FORM

from dhlab import kinematics
from dhlab.course.exercises import exercises
from dhlab.grading import grade
from dhlab.grading.cage.sight import OPEN, OWN
from dhlab.grading.cage.stage import stage
from dhlab.grading.settings import Limits, Settings

pytestmark = pytest.mark.cage
ROW = "[[theta, d, a, alpha]]"
FORWARD = f"dh.Arm(dh.DHTable.standard({ROW}, angle='rad')).forward([0])"
LINK = "('standard', [theta], [d], [a], [alpha])[0]"


def table_of_answers(exercise, variants):
    """What was public once: the inputs, and so the answers."""
    known = {}
    for variant in variants:
        for case in exercise.cases(variant):
            known[round(case[0], 9)] = exercise.answer(*case).tolist()
    return f"known = {known!r}"


def closed(body, before=""):
    """05.6 answered in another way; in the notebook itself it is right."""
    return corpus.closed(body, before)


CHEATS = {
    "a table of answers": closed(
        "return known[round(theta, 9)]", table_of_answers(exercises()["05.6"], (0, 2**31))
    ),
    "sends the lines itself": corpus.answer(
        "05.6",
        "import os, json\nrow = json.dumps({'value': {'array': ['f8', [4, 4], [0.0] * 16]}})\n"
        "for fd in range(3, 64):\n    try: os.write(fd, (row + chr(10)).encode() * 40)\n"
        "    except OSError: pass\ndef dh_closed(theta, d, a, alpha): return np.eye(4)",
    ),
    "sends lines of the grader": corpus.answer(
        "05.6",
        "import os, sys\nframe = sys._getframe()\nwhile frame:\n"
        "    for value in list(frame.f_locals.values()):\n"
        "        send = getattr(value, 'send', None)\n"
        "        if send: send({'check': '05.6', 'cell': 0, 'calls': [1] * 29, 'again': 1})\n"
        "    frame = frame.f_back\ndef dh_closed(theta, d, a, alpha): return np.eye(4)",
    ),
    "replaces what watches": closed(
        f"sys.setprofile(None); threading.setprofile(None)\nreturn {FORWARD}",
        "import sys, threading",
    ),
    "runs the library's source": closed(
        f"return names['link_matrices']{LINK}",
        "import inspect, dhlab.kinematics\nnames = {'__name__': 'mine'}\n"
        "exec(inspect.getsource(dhlab.kinematics).replace('from .', 'from dhlab.'), names)",
    ),
    "copies a code object": closed(
        f"return mine{LINK}",
        "import types, dhlab.kinematics as k\n"
        "mine = types.FunctionType(k.link_matrices.__code__, k.__dict__, 'mine')",
    ),
    "an older thread": closed(
        "to.put((theta, d, a, alpha))\nreturn back.get(timeout=1)",
        "import queue, threading\nto, back = queue.Queue(), queue.Queue()\n"
        "def serve():\n    while True:\n        theta, d, a, alpha = to.get()\n"
        f"        back.put({FORWARD})\n"
        "threading.Thread(target=serve, daemon=True).start()",
    ),
    "evaluated later": closed(
        "return Later(theta, d, a, alpha)",
        "class Later:\n    def __init__(self, *row): self.row = row\n"
        "    def __deepcopy__(self, memo): return self\n"
        "    def __array__(self, *more, **named):\n"
        f"        theta, d, a, alpha = self.row\n        return {FORWARD}",
    ),
    "a profiler in C": closed(f"return {FORWARD}", "import cProfile\ncProfile.Profile().enable()"),
    "a search of the machine": closed(
        f"return found[0].link_matrices{LINK}",
        "import sys, importlib.util, os, gc\nfound = []\n"
        "for top in {*sys.path, sys.prefix, '/', '/cage'}:\n"
        "    for folder, _, names in os.walk(top):\n"
        "        if 'kinematics.py' in names and 'dhlab' in folder:\n"
        "            sys.path.insert(0, os.path.dirname(folder)); sys.modules.pop('dhlab', None)\n"
        "            import dhlab.kinematics as k; found.append(k)\n"
        "found += [m for m in gc.get_objects() if hasattr(m, 'link_matrices')]",
    ),
    "is another after another": lambda notebook, facts: (
        corpus.answer(
            "05.1",
            "import builtins\ndef rot_x(alpha):\n    builtins.seen = 1\n"
            "    return np.array([[1, 0, 0, 0], [0, np.cos(alpha), -np.sin(alpha), 0],"
            " [0, np.sin(alpha), np.cos(alpha), 0], [0, 0, 0, 1]])",
        )(notebook, facts),
        closed(
            "seen = hasattr(builtins, 'seen')\n"
            "return dh_transform(theta, d, a, alpha) if seen else np.eye(4)",
            "import builtins",
        )(notebook, facts),
    ),
    "asks what is not here quietly": closed(
        "T = dh.assign_frames([([0, 0, 0], [0, 0, 1])]).forward([theta])\nreturn np.asarray(T)"
    ),
}
MOVES = {
    "the move itself": "def rot_x(alpha): return transform.rot_x(alpha)",
    "another that holds it": "def rot_x(alpha):\n"
    "    return transform.from_xyz_rpy([0, 0, 0], [alpha, 0, 0])",
    "its private part": "from dhlab.transform import _rotation\n"
    "def rot_x(alpha): return _rotation(alpha, 1, 2)",
    "by name": "import importlib\n"
    "def rot_x(alpha): return importlib.import_module('dhlab.transform').rot_x(alpha)",
}
# each student's own, in a cell of its own
FORM = "def form(theta, d, a, alpha):\n" + "".join(
    f"    {line}\n" for line in RIGHT_FORM.splitlines()
)
HONEST = {
    "as handed out": lambda notebook, facts: None,
    "with the moves of dhlab": corpus.answer(
        "05.4",
        "def dh_transform(theta, d, a, alpha):\n"
        "    return transform.rot_z(theta) @ transform.trans([a * 0, 0, d]) @ transform.trans_x(a)"
        " @ transform.rot_x(alpha)",
    ),
    "helpers, constants and a cache": lambda notebook, facts: (
        corpus.first(
            "import functools, math as m\nONE, cache = 1.0, {}\n"
            "@functools.lru_cache\ndef cs(x): return m.cos(x), m.sin(x)"
        )(notebook, facts),
        closed(
            "cache[theta] = ONE\n(c, s), (k, l) = cs(theta), cs(alpha)\n"
            "return np.array([[c, -s * k, s * l, a * c], [s, c * k, -c * l, a * s],"
            " [0, l, k, d], [0, 0, 0, cache[theta]]])"
        )(notebook, facts),
    ),
    "tries the library and goes on": closed(
        f"try:\n    return np.array({FORWARD})\nexcept Exception:\n"
        "    return form(theta, d, a, alpha)"
    ),
    "a class": corpus.answer(
        "05.6",
        "class Link:\n    def __call__(self, theta, d, a, alpha):\n"
        "        return form(theta, d, a, alpha)\ndh_closed = Link()",
    ),
    "made by exec": corpus.answer(
        "05.6", "exec('def dh_closed(theta, d, a, alpha): return form(theta, d, a, alpha)')"
    ),
    "data of an arm": closed(
        "return one * form(theta, d, a, alpha)",
        "arm = dh.load('ur5e')\none, T = len(arm.table.rows) / 6, arm.forward(np.zeros(6))",
    ),
    "lists, not arrays": closed("return form(theta, d, a, alpha).tolist()"),
    "redefined after its check": lambda notebook, facts: notebook["cells"].append(
        corpus.code("def dh_closed(*row): return 0\ndef form(*row): return None")
    ),
    "its helper's name taken by the lesson afterwards": lambda notebook, facts: (
        corpus.answer(
            "05.6",
            "def frames(*row): return form(*row)\n"
            "def dh_closed(theta, d, a, alpha): return frames(theta, d, a, alpha)",
        )(notebook, facts),
        notebook["cells"].append(corpus.code("frames = 3\nprint(frames)")),
    ),
    "another program spoils what they share": lambda notebook, facts: corpus.answer(
        "05.4",
        "asked = []\ndef dh_transform(theta, d, a, alpha):\n    asked.append(theta)\n"
        "    T = transform.rot_z(theta) @ transform.trans([a, 0, d]) @ transform.rot_x(alpha)\n"
        "    if len(asked) == 40: np.cos = np.sin = None\n    return T",
    )(notebook, facts),
    "checked in one line": lambda notebook, facts: next(
        cell for cell in notebook["cells"] if cell["source"] == 'check("05.6", dh_closed)'
    ).update(source="mine = dh_closed\nfor key, f in [('05.6', mine)]: check(key, f)"),
}


def lost(name):
    return {"05.1"} if name in MOVES else {"05.6"}


@pytest.fixture(scope="module")
def by_name(kept_cages, tmp_path_factory):
    """Every student's Graded, by the name of what they did."""
    if not shutil.which("bwrap"):
        pytest.skip("bubblewrap is not installed")
    top = tmp_path_factory.mktemp("own")
    moves = {name: corpus.answer("05.1", source) for name, source in MOVES.items()}
    deep = corpus.answer("05.6", "def dh_closed(theta, d, a, alpha): return dh_closed(*[0] * 4)")
    everybody = {**CHEATS, **moves, **HONEST, "endless recursion": deep}
    names = {}
    for number, (name, make) in enumerate(everybody.items()):
        own = top / "class" / f"s{number:02d}"
        own.mkdir(parents=True)
        notebook = corpus.solved()
        corpus.first(FORM)(notebook, {})
        make(notebook, {})
        (own / "05-link-matrix.ipynb").write_text(json.dumps(notebook), encoding="utf-8")
        names[own.name] = name
    settings = Settings(limits=Limits(cell_seconds=2))
    results, _ = grade.grade(top / "class", top / "out", settings=settings)
    again, _ = grade.grade(top / "class", top / "out", settings=settings, exercise="05.6")
    assert [one.points for one in again] == [one.points for one in results]
    return {names[one.student]: one for one in results}


@pytest.mark.parametrize("name", [*CHEATS, *MOVES])
def test_it_earns_nothing(by_name, name):
    found = {mark.exercise: mark for mark in by_name[name].marks if mark.points < mark.of}
    assert set(found) == lost(name), {key: mark.headline for key, mark in found.items()}
    assert all(mark.points == 0 for mark in found.values())


@pytest.mark.parametrize("name", HONEST)
def test_an_honest_program_is_right(by_name, name):
    assert {mark.exercise: mark.headline for mark in by_name[name].marks if not mark.points} == {}


def test_who_is_wrong_is_not_accused(by_name):
    (mark,) = (mark for mark in by_name["endless recursion"].marks if mark.exercise == "05.6")
    assert mark.status == "wrong" and mark.headline == "the function stops with RecursionError"
    assert mark.place == "line 1 of the function"


def test_who_uses_the_library_is_told_which_part(by_name):
    (mark,) = (mark for mark in by_name["a profiler in C"].marks if mark.exercise == "05.6")
    assert mark.status == "not allowed" and "(forward)" in mark.headline


def test_the_room_for_own_programs_holds_no_kinematics(tmp_path):
    for room in (OPEN, OWN):
        (tmp_path / room).mkdir()
        stage(tmp_path / room, room)
    text = {
        room: "".join(path.read_text("utf-8") for path in (tmp_path / room).rglob("*.py"))
        for room in (OPEN, OWN)
    }
    for name, function in inspect.getmembers(kinematics, inspect.isfunction):
        if function.__module__ == kinematics.__name__:
            assert f"def {name}(" in text[OPEN] and f"def {name}(" not in text[OWN]
    assert "def rot_x(" in text[OPEN] and "def rot_x(" not in text[OWN]
