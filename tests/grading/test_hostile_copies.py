"""A copier is named, and the teacher reads what ran, wherever in a notebook the code stands and
whatever stands around it.
"""

import json
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
import corpus
from corpus import code

from dhlab.course.workspace import handed_out
from dhlab.grading.own_items import YOUR_NUMBERS
from dhlab.grading.reports.alike import alike, answers, is_cut, tokens_of
from dhlab.grading.reports.answered import Answer, keep_answers, own_answers
from dhlab.grading.reports.cells import written
from dhlab.grading.reports.made import made_while_running
from dhlab.grading.reports.publish import _compared
from dhlab.grading.results.gradebook import Gradebook
from dhlab.grading.results.marks import GRADED, Graded, Mark
from dhlab.grading.reviewing.desk import Desk
from dhlab.grading.shown import readable

CHECK = "check('05.1', 1)"
PROGRAM = "def dh_closed("  # of ada's, and of who copied it


def handed_out_code():
    (path,) = handed_out().glob("05-*.ipynb")
    return answers(json.loads(path.read_text(encoding="utf-8")))


def is_named(notebook, others=(), counted=()):
    """Whether ada and the copier stand in the report, beside each other or as not compared."""
    codes = {"ada": answers(corpus.solved()), "copier": answers(notebook)}
    codes |= {name: answers(corpus.solved()) for name in others}
    pairs = [pair.students for pair in alike(codes, handed_out_code(), counted)]
    return ("ada", "copier") in pairs or is_cut(notebook)


def answered_by(change):
    """The solved notebook, each answer's cell changed: ``change(source, exercise)``."""
    notebook = corpus.solved()
    for cell in notebook["cells"]:
        if key := cell.get("metadata", {}).get("exercise"):
            cell["source"] = change(cell["source"], key)
    return notebook


def below_the_last_check():
    notebook = corpus.solved()
    below = ["from dhlab.course import check as c"]
    for cell in notebook["cells"]:
        if cell.get("metadata", {}).get("exercise"):
            below.append(cell["source"])
            cell["source"] = "x = 1"
        elif cell["source"].startswith("check("):
            below.append(cell["source"].replace("check(", "c("))
    notebook["cells"].append(code("\n".join(below)))
    return notebook


def checked_twice():
    notebook = corpus.solved()
    cells = [cell for cell in notebook["cells"] if cell["source"].startswith("check(")]
    notebook["cells"] += [code(cell["source"]) for cell in cells]
    return notebook


def behind_a_broken_cell():
    notebook = answered_by(lambda source, key: source)
    at = [k for k, cell in enumerate(notebook["cells"]) if cell.get("metadata", {}).get("exercise")]
    for k in reversed(at):
        notebook["cells"].insert(k, code("x = ((('''"))
    return notebook


WAYS = {
    "a shell line that opens a text": lambda: answered_by(lambda s, key: f"!echo '''\n{s}"),
    "one whose answer is taken": lambda: answered_by(lambda s, key: f"x = !echo '''\n{s}"),
    "comments without end": lambda: answered_by(
        lambda s, key: "x = 1\n" + 120 * "# blah\n" * 20 + s
    ),
    "texts without end": lambda: answered_by(lambda s, key: f"x = '''{'blah ' * 3000}'''\n{s}"),
    "behind a check": lambda: answered_by(lambda s, key: f"x = 1\ncheck('{key}', None)\n{s}"),
    "behind one in its line": lambda: answered_by(
        lambda s, key: f"check('{key}', '('); x = 2\n{s}"
    ),
    "as a text": lambda: answered_by(lambda s, key: f"exec({s!r})"),
    "below a shell line that opens a bracket": lambda: answered_by(
        lambda s, key: f"y = [0]\ny[0] = !echo (\n{s}"
    ),
    "above a check of nothing": lambda: answered_by(lambda s, key: f"{s}\ncheck('77.7', 0)"),
    "above one in a comment": lambda: answered_by(lambda s, key: f"{s}\n# check('77.7')"),
    "above a guess's check": lambda: answered_by(lambda s, key: f"{s}\ncheck('00.P1', 'a')"),
    "above another lesson's": lambda: answered_by(lambda s, key: f"{s}\ncheck('06.2', 0)"),
    "below the last check": below_the_last_check,
    "checked twice": checked_twice,
    "behind a broken cell": behind_a_broken_cell,
}


@pytest.mark.parametrize("make", WAYS.values(), ids=WAYS)
def test_a_copier_is_named(make):
    assert is_named(make())


def test_what_strangers_hand_in_is_not_what_many_write():
    strangers = [f"stranger{number}" for number in range(30)]
    assert is_named(corpus.solved(), strangers, ("ada", "copier"))


def test_a_newer_file_without_answers_hides_nothing():
    untouched = corpus.solved()
    for cell in untouched["cells"]:
        if cell.get("metadata", {}).get("exercise"):
            cell["source"] = "x = ..."
    graded = Graded("m", "old; new", GRADED, (Mark("05.6", "right", 2, 2, file="old"),))
    found = _compared(graded, {"old": corpus.solved(), "new": untouched})
    assert PROGRAM in found["05.6"] and found == answers(corpus.solved())


@pytest.mark.parametrize(
    "make", [WAYS[name] for name in ("behind a check", "below the last check", "checked twice")]
)
def test_the_teacher_reads_what_ran(make):
    assert sum(PROGRAM in answer.code for answer in own_answers(make()).values()) == 1


@pytest.mark.parametrize("make", [make for name, make in WAYS.items() if name.startswith("above")])
def test_a_check_of_something_else_takes_no_code_away(make):
    assert PROGRAM in own_answers(make())["05.6"].code


def test_checks_and_numbers_without_end_are_read_once():
    """Work grows as the file does, and no long cell is parsed."""
    many = {"cells": [code("abcdefghijkl;check('05.1');" * 2000)]}
    parts = written(many)["05.1"]
    assert len(parts) == 2001 and len(answers(many)["05.1"]) == 10_000
    assert own_answers({"cells": [code(YOUR_NUMBERS + "task = 1" + "+1" * 10_000), code(CHECK)]})
    assert own_answers({"cells": [code(YOUR_NUMBERS + "task = 1\n1\n"), code(CHECK)]})


@pytest.mark.parametrize(
    "begin",
    [
        "from dhlab.course import set_variant\nset_variant(17)\n",
        "from dhlab.course import set_variant\nset_variant(17)  # own\n",
        "# your own numbers: leave this cell as it is\ntask = {'a': 1}\n",
        "# your own numbers: leave this cell as it is\ntask = open\n",
    ],
)
def test_what_stands_below_ones_own_numbers_is_shown(begin):
    found = own_answers(answered_by(lambda source, key: begin + source))
    assert PROGRAM in found["05.6"].code


@pytest.mark.parametrize(
    "cell",
    [
        "from dhlab.course import set_variant\nset_variant(17)  # your own numbers: leave it",
        "# your own numbers: leave this cell as it is\ntask = {'q': np.array([-1]), 'n': ['a;']}",
    ],
)
def test_ones_own_numbers_are_no_answer(cell):
    cells = [code(cell), code("y = 2"), code("check('05.6', y)")]
    assert own_answers({"cells": cells}) == {"05.6": Answer("y = 2")}


def test_the_review_shows_what_is_there(tmp_path):
    book = Gradebook(tmp_path)
    graded = Graded("m", "a", GRADED, (Mark("05.2", "right", 1, 1, file="a"),))
    with book.alone():
        book.write(graded)
    hidden = "rule = 'a' # \u202e 'b' = elur \u2066\u200b\x9b2J"
    keep_answers(graded, {("a", ""): {"05.2": Answer(hidden)}}, tmp_path)
    ((text, _),) = Desk(tmp_path).answers("m").values()
    assert text == readable(hidden) and text.isprintable() and "·" in text


def test_lines_that_cannot_be_read_cost_themselves_alone():
    broken = "\n".join(f"{' ' * (9 - k % 9)}x{k} = 1" for k in range(900))
    assert {("name", f"x{k}") for k in range(0, 900, 9)} <= set(tokens_of(broken))


# ada's program, so that nobody sees what runs
BURIED = {
    "in short texts": lambda text: f"exec({' '.join(map(repr, chopped(text)))})",
    "in base64": lambda text: f"import base64\nexec(base64.b64decode({text.encode()!r}))",
    "as bytes": lambda text: f"import marshal, types\nexec(marshal.loads({text.encode()!r}))",
    "in comments": lambda text: (
        "\n".join(f"# {line}" for line in text.splitlines()) + "\nimport linecache\n"
    ),
    "in a file": lambda text: (
        "f = open('m.py', 'w')\n"
        + "\n".join(f"f.write({part!r})" for part in chopped(text))
        + "\nf.close()\nfrom m import *"
    ),
    "in a file that is run": lambda text: (
        f"open('m.py', 'w').write({text[::-1]!r}[::-1])\n%run m.py"
    ),
}


def chopped(text):
    return [text[k : k + 20] for k in range(0, len(text), 20)]


@pytest.mark.parametrize("bury", BURIED.values(), ids=BURIED)
def test_a_program_that_is_made_while_it_runs_is_told(bury):
    notebook = answered_by(lambda source, key: bury(source) if key == "05.6" else source)
    assert made_while_running(answers(notebook)) == ["05.6"]


def test_an_honest_notebook_makes_no_program_while_it_runs():
    for path in sorted((corpus.ROOT / "solutions").glob("*.ipynb")):
        assert made_while_running(answers(json.loads(path.read_text(encoding="utf-8")))) == []
    saved = "import re, helpers\np = re.compile('exec')\nmodel.eval()\nprint('exec(x)')"
    assert made_while_running({"05.4": saved, "05.6": "open('table.csv')"}) == ["05.4", "05.6"]
    assert made_while_running({"05.4": saved, "05.6": "df.to_csv('table.csv')"}) == []


@pytest.mark.parametrize(
    "source",
    [
        "import cProfile\ncProfile.runctx(f'{a}', globals(), {})",
        "import code\ncode.InteractiveInterpreter(globals()).runsource(a)",
        "from code import (\n    InteractiveConsole as Own,\n)\nOwn(globals()).push(a)",
        "import typing\nf = typing.get_type_hints(A)['x']",
        "from sys import modules as known\nknown['built' + 'ins']",
        "import sys\n1 in sys.modules\\\n    .values()",
        "import importlib.util\nimportlib.util.find_spec('m').loader.load_module()",
    ],
)
def test_a_text_that_a_part_of_python_runs_is_told(source):
    assert made_while_running({"05.6": source}) == ["05.6"]


@pytest.mark.parametrize(
    "source",
    [
        "import sys\nIN_COLAB = 'google.colab' in sys.modules\nif IN_COLAB:\n    print(1)",
        "import sys, importlib.util\nif importlib.util.find_spec('dhlab') is None:\n    print(1)",
        "get_ipython().system('pip install dhlab')\n"
        "get_ipython().run_line_magic('matplotlib', 'inline')",
        "modules = 3\nlengths = [0.1] * modules",
        "from dhlab.transform import *",
    ],
)
def test_who_asks_whether_a_package_is_there_makes_no_program(source):
    assert made_while_running({"05.6": source}) == []


def test_what_a_magic_runs_is_compared():
    cells = [code(f"{begin} f = lambda x: x + 1\n%timeit f(1)") for begin in ("%time", "  %prun")]
    found = answers({"cells": [*cells, code("check('05.6', f)")]})["05.6"]
    assert found.count("f = lambda x: x + 1\n") == 2 and "timeit" not in found


@pytest.mark.parametrize("option, told", [("", []), ("-a ", ["05.6"])])
def test_a_file_that_is_run_is_told_where_it_is_written_in_pieces(option, told):
    cells = [
        code("%%writefile kin.py\ndef f(x):"),
        code(f"%%writefile {option}kin.py\n    return x"),
    ]
    cells += [code("%run kin.py"), code("check('05.6', f)")]
    assert made_while_running(answers({"cells": cells})) == told


def test_what_python_says_of_a_students_texts_is_not_told_on_the_teachers_screen(recwarn):
    text = "The angle \\delta of the link and \\\x9b2J, which is a sign that moves a cursor"
    assert tokens_of(f"x = '{text}'")
    # what else is heard meanwhile is of other tests' files, closed by whoever clears them away
    assert [str(one.message) for one in recwarn if "escape" in str(one.message)] == []
