"""The kinds of attack of hostile.py on nbgrader and otter-grader: one assignment with one hidden
test, each attack handed in by a student of its own, and an honest student after all of them.

    python benchmarks/hostile_others.py nbgrader PYTHON    # of an environment with nbgrader
    python benchmarks/hostile_others.py otter PYTHON       # and of one with otter-grader

Both run a submission as the teacher's own user, in one process with its tests. Otter is asked with
``otter run``; in a container of its own (``otter grade``) the files and processes of this machine
are out of reach.
"""

import csv
import json
import os
import shutil
import socket
import subprocess
import sys
import tempfile
from pathlib import Path

RIGHT = "answer = 8086"
TEST = "assert answer == 8086"
# what a cell begins with: the folders in which the grader's own files may stand
UPWARD = """import os, pathlib
here = pathlib.Path.cwd()
found = [p for top in (here, pathlib.Path(TOP)) for p in top.rglob("*")]
"""
ATTACKS = {
    "equals everything": "class Any:\n    __eq__ = lambda self, other: True\nanswer = Any()",
    "switches the tests off": (
        "get_ipython().input_transformers_post.append(lambda lines: [])\n"
        "import builtins, otter.test_files.abstract_test as t\n"
        "for one in vars(t).values():\n"
        "    if hasattr(one, 'passed'): one.passed = property(lambda self: True, lambda s, v: None)"
    ),
    "reads the hidden test": UPWARD + "import re, zipfile\nanswer = 0\nfor p in found:\n"
    "    try:\n"
    "        data = [p.read_bytes()]\n"
    "        if p.suffix == '.zip':\n"
    "            z = zipfile.ZipFile(p); data += [z.read(n) for n in z.namelist()]\n"
    "        for one in data:\n"
    "            m = re.search(rb'answer == (\\d+)', one)\n"
    "            if m: answer = int(m[1])\n"
    "    except Exception: pass",
    "raises its own mark": UPWARD + "import subprocess, sys\nfor p in found:\n"
    "    if p.suffix == '.db':\n"
    "        late = 'import sqlite3, time, pathlib, sys; time.sleep(6); d, e, m = sys.argv[1:]; '\n"
    "        late += 'db = sqlite3.connect(d, timeout=60); db.execute(\"UPDATE grade SET'\n"
    "        late += ' manual_score = 1 WHERE notebook_id IN (SELECT n.id FROM'\n"
    "        late += ' submitted_notebook n JOIN submitted_assignment a ON a.id = assignment_id'\n"
    "        late += ' WHERE a.student_id = ?)\", [m]); db.commit();'\n"
    "        late += ' pathlib.Path(e, \"mark\").touch()'\n"
    "        subprocess.Popen([sys.executable, '-c', late, str(p), EVIDENCE, ME],"
    " start_new_session=True)",
    "reads a neighbour's work": UPWARD
    + "for p in found:\n    if p.suffix == '.ipynb' and 'zoe' in str(p) and 'canary' in"
    " p.read_text():\n        pathlib.Path(EVIDENCE, 'read').touch()",
    "spoils a neighbour's work": UPWARD
    + "for p in found:\n    if p.suffix == '.ipynb' and 'yan' in str(p):\n"
    "        p.write_text(p.read_text().replace('8086', '0'))\n"
    "        pathlib.Path(EVIDENCE, 'spoilt').touch()",
    "uses the network": "import socket, pathlib\nsocket.create_connection(('127.0.0.1', PORT), 3)\n"
    "pathlib.Path(EVIDENCE, 'network').touch()",
    "leaves a program behind": "import subprocess\n"
    "subprocess.Popen(['sleep', '97'], start_new_session=True)",
    "never ends": "while True: pass",
    "ends the process": "import os\nos._exit(0)",
}
HONEST = {"yan": RIGHT, "zoe": RIGHT + "  # canary"}


def cell(source, name, **metadata):
    return {
        "cell_type": "code",
        "execution_count": None,
        "id": name,
        "metadata": metadata,
        "outputs": [],
        "source": source,
    }


def notebook(*cells):
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    return {
        "cells": list(cells),
        "metadata": {"kernelspec": kernel},
        "nbformat": 4,
        "nbformat_minor": 5,
    }


def students(top, evidence, port):
    begin = f"TOP, EVIDENCE, PORT = {str(top)!r}, {str(evidence)!r}, {port}\n"
    hostile = {
        f"eve{k}": f"{begin}ME = 'eve{k}'\n{text}" for k, text in enumerate(ATTACKS.values())
    }
    return hostile | HONEST


def nbgrader(python, top, evidence, port):
    def run(*words):
        return subprocess.run(
            [python, "-m", "nbgrader", *words],
            cwd=top,
            capture_output=True,
            text=True,
            env=os.environ | {"PATH": f"{Path(python).parent}:{os.environ['PATH']}"},
            timeout=400,
        )

    def marked(source, name, **more):
        base = {
            "schema_version": 3,
            "grade": False,
            "solution": False,
            "locked": False,
            "task": False,
            "grade_id": name,
        }
        return cell(source, name, nbgrader=base | more)

    source = top / "source" / "ps1"
    source.mkdir(parents=True)
    hidden = f"### BEGIN HIDDEN TESTS\n{TEST}\n### END HIDDEN TESTS"
    made = notebook(
        marked("### BEGIN SOLUTION\n" + RIGHT + "\n### END SOLUTION", "stub", solution=True),
        marked("assert answer is not None\n" + hidden, "test", grade=True, locked=True, points=1),
    )
    (source / "p.ipynb").write_text(json.dumps(made))
    print(run("generate_assignment", "ps1").stderr[-300:])
    release = json.loads((top / "release" / "ps1" / "p.ipynb").read_text())
    for student, text in students(top, evidence, port).items():
        folder = top / "submitted" / student / "ps1"
        folder.mkdir(parents=True)
        release["cells"][0]["source"] = text
        (folder / "p.ipynb").write_text(json.dumps(release))
    run("autograde", "ps1", "--Execute.timeout=10")
    run("export")
    with open(top / "grades.csv") as file:
        return {row["student_id"]: float(row["score"] or 0) for row in csv.DictReader(file)}


def otter(python, top, evidence, port):
    env = os.environ | {"PATH": f"{Path(python).parent}:{os.environ['PATH']}"}
    (top / "tests").mkdir()
    (top / "tests" / "q1.py").write_text(
        "from otter.test_files import test_case\nOK_FORMAT = False\nname, points = 'q1', 1\n\n"
        f"@test_case(points=1)\ndef judged(env):\n    answer = env.get('answer')\n    {TEST}\n"
    )
    subprocess.run(
        [
            python,
            "-m",
            "otter",
            "generate",
            "-t",
            "tests",
            "-o",
            "autograder.zip",
            "--no-environment",
        ],
        cwd=top,
        env=env,
        check=True,
        capture_output=True,
    )
    marks = {}
    texts = students(top, evidence, port)
    for student, text in texts.items():
        folder = top / "submitted" / student
        folder.mkdir(parents=True)
        (folder / "p.ipynb").write_text(json.dumps(notebook(cell(text, "a"))))
    for student in texts:
        folder = top / "submitted" / student
        try:
            subprocess.run(
                [
                    python,
                    "-m",
                    "otter",
                    "run",
                    "-a",
                    top / "autograder.zip",
                    "-o",
                    folder,
                    folder / "p.ipynb",
                ],
                cwd=folder,
                env=env,
                timeout=45,
                capture_output=True,
            )
            told = json.loads((folder / "results.json").read_text())
            marks[student] = sum(test.get("score", 0) for test in told["tests"])
        except subprocess.TimeoutExpired:
            marks[student] = "does not end in 45 s"
        except OSError:
            marks[student] = "no result"
    return marks


def main():
    name, python = sys.argv[1:]
    top, evidence = Path(tempfile.mkdtemp()), Path(tempfile.mkdtemp())
    with socket.create_server(("127.0.0.1", 0)) as server:
        marks = {"nbgrader": nbgrader, "otter": otter}[name](
            python, top, evidence, server.getsockname()[1]
        )
    for k, attack in enumerate(ATTACKS):
        print(f"| {attack} | {marks.get(f'eve{k}', 'no mark')} |")
    for student in HONEST:
        print(f"| honest {student} | {marks.get(student, 'no mark')} |")
    left = []
    for entry in Path("/proc").iterdir():
        if entry.name.isdigit():
            try:
                if (entry / "cmdline").read_bytes() == b"sleep\x0097\x00":
                    left.append(int(entry.name))
            except OSError:
                continue
    print("got at:", sorted(path.name for path in evidence.iterdir()), "left running:", len(left))
    for process in left:
        os.kill(process, 9)
    shutil.rmtree(top), shutil.rmtree(evidence)


if __name__ == "__main__":
    main()
