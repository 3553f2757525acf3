"""Attacks that need no program: zips, names, times, copies and exports as an attacker would make
them. Each is (name, a function of an empty folder) that raises where something got through;
``mallory`` attacks, ``ada`` is honest.
"""

import csv
import io
import json
import os
import re
import resource
import socket
import struct
import subprocess
import zipfile
from datetime import UTC, datetime
from pathlib import Path

import corpus
from around_desk import DESK

from dhlab.grading.grade import grade
from dhlab.grading.intake.roster import read_roster
from dhlab.grading.intake.submissions import submissions
from dhlab.grading.reports.publish import publish
from dhlab.grading.results.gradebook import Gradebook
from dhlab.grading.results.marks import GRADED, Graded, Mark

NOTEBOOK = json.dumps(corpus.solved()).encode()
FORMULA = re.compile(r"\s*[=+\-@＝＋－＠]")


def put(path, data=NOTEBOOK, when=None):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(data)
    if when:
        os.utime(path, (when.timestamp(), when.timestamp()))


def looked_at(top, at_least=1):
    """What was handed in, each notebook looked at; ada's is among it, whatever mallory did."""
    put(top / "ada" / "05.ipynb")
    found = submissions(top)
    for mine in found.values():
        for notebook in mine.notebooks:
            assert notebook.look.print
        assert sum(map(len, mine.notes)) < 50_000, "the notes are as long as an attacker likes"
    assert [one.name for one in found["ada"].notebooks] == ["ada/05.ipynb"]
    return found["mallory"]


def an_offset_that_no_number_holds(top):
    """The zip64 field of a member says that it stands at 2**64 - 2, in a file and in memory."""
    data = bytearray(corpus.zipped({"05.ipynb": NOTEBOOK}))
    at, end = data.index(b"PK\x01\x02"), data.index(b"PK\x05\x06")
    data[at + 42 : at + 46] = b"\xff" * 4
    data[at + 30 : at + 32] = struct.pack("<H", 12)
    more = struct.pack("<HHQ", 1, 8, 2**64 - 2)
    data[end + 12 : end + 16] = struct.pack("<L", end - at + len(more))
    made = bytes(data[:end] + more + data[end:])
    put(top / "mallory" / "x.zip", made)
    put(top / "mallory" / "y.zip", corpus.zipped({"z.zip": made}))
    looked_at(top)


def a_dictionary_of_four_gigabytes(top):
    """LZMA, whose own head asks for as much memory as it likes."""
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_LZMA) as archive:
        archive.writestr("05.ipynb", NOTEBOOK)
    data = bytearray(out.getvalue())
    at = 30 + len("05.ipynb") + 4 + 1  # after the local head, LZMA's version, size and first byte
    data[at : at + 4] = b"\xff" * 4
    put(top / "mallory" / "x.zip", bytes(data))
    before = resource.getrlimit(resource.RLIMIT_AS)
    used = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
    resource.setrlimit(
        resource.RLIMIT_AS, (used + (3 << 30), before[1])
    )  # three gigabytes are free
    try:
        looked_at(top)
    finally:
        resource.setrlimit(resource.RLIMIT_AS, before)


def a_list_of_a_million_members(top):
    """What a zip lists costs memory before any of it is counted."""
    import tracemalloc

    member = b"PK\x01\x02" + bytes(24) + struct.pack("<H", 1) + bytes(16) + b"x"
    count = 1_000_000
    raw = member * count
    end = struct.pack("<4s4H2LH", b"PK\x05\x06", 0, 0, 1, 1, len(raw), 0, 0)
    put(top / "mallory" / "x.zip", raw + end)
    tracemalloc.start()
    looked_at(top)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 200 << 20, f"the list alone took {peak >> 20} MB"


def names_that_no_disk_holds(top):
    """Names in a zip may have 65,535 letters, and as many folders."""
    names = [" " * 60_000 + "x", ".zip" * 15_000 + "x", "/".join("a" * 30_000), "_-" * 30_000 + "x"]
    put(top / "mallory" / "x.zip", corpus.zipped({f"{name}.txt": b"{}" for name in names}))
    looked_at(top)


def a_tree_deeper_than_a_path(top):
    """Folders from a home or a repository: deeper than a name may be long, and than calls may."""
    put(top / "mallory" / "05.ipynb")
    try:
        for letters, depth in ((200, 30), (1, 1500)):
            here = os.open(top / "mallory", os.O_RDONLY)
            for _ in range(depth):
                os.mkdir("d" * letters, dir_fd=here)
                inner = os.open("d" * letters, os.O_RDONLY, dir_fd=here)
                os.close(here)
                here = inner
            for name in ("05.ipynb", "x" * 200):
                os.close(os.open(name, os.O_CREAT | os.O_WRONLY, dir_fd=here))
            os.close(here)
        assert len(looked_at(top).notebooks) == 1
    finally:  # Python's own rmtree calls itself for each folder
        subprocess.run(["rm", "-rf", str(top / "mallory")], check=True)


def files_that_are_none(top):
    """A pipe, a socket, a device by a link, holes of a terabyte, and another's file by its name."""
    own = top / "mallory"
    put(own / "a.ipynb")
    put(top / "ada" / "05.ipynb")
    os.mkfifo(own / "pipe.ipynb")
    os.mkfifo(own / "pipe.zip")
    os.symlink("/dev/zero", own / "zero.ipynb")
    os.link(top / "ada" / "05.ipynb", own / "linked.ipynb")
    (own / "folder.ipynb").mkdir()
    for name in ("holes.ipynb", "holes.zip", "holes"):
        with open(own / name, "wb") as file:
            file.truncate(1 << 40)
    with socket.socket(socket.AF_UNIX) as one:
        here = os.getcwd()
        os.chdir(own)  # the name of a socket may not be long
        one.bind("socket.ipynb")
        os.chdir(here)
        mine = looked_at(top)
    names = {one.name.partition("/")[2] for one in mine.notebooks}
    assert names == {"a.ipynb", "linked.ipynb"}
    for name in ("pipe.ipynb", "pipe.zip", "zero.ipynb", "socket.ipynb", "holes.ipynb"):
        assert any(name in note and "refused" in note for note in mine.notes), name


def a_result_of_ones_own(top):
    """Graded again with files touched and results forged beside them: every mark is as before."""
    wrong = corpus.solved()
    corpus.answer("05.2", "rule = '?'")(wrong, {})
    put(top / "in" / "ada" / "05.ipynb")
    put(top / "in" / "mallory" / "05.ipynb", json.dumps(wrong).encode())

    def marks():
        results, _ = grade(top / "in", top / "out")
        return {g.student: [(m.exercise, m.status, m.points) for m in g.marks] for g in results}

    before = marks()
    mine = top / "in" / "mallory"
    kept = json.loads((top / "out" / "marks" / "mallory.json").read_text(encoding="utf-8"))
    for one in kept["marks"]:
        one.update(status="right", points=one["of"])
    forged = json.dumps(kept).encode()
    for name in ("marks/mallory.json", "mallory.json", "out/marks/mallory.json", "decided.json"):
        put(mine / name, forged)
    for path in (top / "in").rglob("*"):
        os.utime(path, (10**9, 10**9))
    assert marks() == before
    assert {m[0] for m in before["mallory"] if m[1] != "right"} == {"05.2"}


def a_timestamp_of_ones_own(top):
    """Beside a notebook in a folder of one's own lies the file that nbgrader would write."""
    late = datetime(2026, 11, 20, 12, tzinfo=UTC)
    for student in ("mallory", "bo", "cy", "dee"):
        put(top / student / "hw5" / "05.ipynb", when=late)
    put(top / "mallory" / "hw5" / "timestamp.txt", b"2026-11-01 08:00:00 UTC", late)
    (mine,) = looked_at(top).notebooks
    assert mine.when == late, f"it came {late}, and counts as of {mine.when}"


def _copied(top, change):
    """Mallory hands in ada's work, changed; the report names both, or says that it was not read."""
    put(top / "in" / "ada" / "05.ipynb")
    made = change(corpus.solved())
    put(top / "in" / "mallory" / "05.ipynb", made)
    results, planned = grade(top / "in", top / "out")
    assert [one.points == one.of for one in results] == [True, True]
    page = publish(planned, results, (), top / "out").read_text(encoding="utf-8")
    alike = page.partition("Suspiciously alike")[2].partition("<h2>")[0]
    noted = [line for line in page.splitlines() if "mallory" in line and "not compared" in line]
    assert ("ada" in alike and "mallory" in alike) or noted, "a copy that nobody is told of"


def _unlike_checks(notebook):
    for cell in notebook["cells"]:
        cell["source"] = re.sub(r"(?m)^check\(", "_ = check(", cell["source"])
    return json.dumps(notebook).encode()


def _without_checks(notebook):
    notebook["cells"] = [c for c in notebook["cells"] if not c["source"].startswith("check(")]
    return json.dumps(notebook).encode()


def _parts(notebook):
    cell = next(cell for cell in notebook["cells"] if cell["cell_type"] == "code")
    cell["outputs"] = [[]] * 600_000
    return json.dumps(notebook).encode()


COPIES = {
    "as it is": lambda notebook: json.dumps(notebook).encode(),
    "as version 3": lambda notebook: corpus._version_3(notebook),
    "in latin-1": lambda notebook: (
        json.dumps(notebook).encode().replace(b'"cells": [', b'"author": "\xe9", "cells": [', 1)
    ),
    "with other checks": _unlike_checks,
    "without checks": _without_checks,
    "with a million outputs": _parts,
}


def a_cell_within_a_cell(top):
    """Names as a spreadsheet reads them where cells end with a semicolon, or a tab."""
    names = ["x;=HYPERLINK(1)", "x;\t@SUM(1)", "Eve\n=1+1", "x\t+1", 'x";-1+1', "x; ＝1"]
    book = Gradebook(top)
    marks = (Mark("05.1", "right", 1, 1),)
    with book.alone():
        book.write_grades(
            [Graded(f"s{k}", name, GRADED, marks, notes=(name,)) for k, name in enumerate(names)]
        )
    text = (top / "grades.csv").read_text(encoding="utf-8-sig")
    for delimiter in ",;\t":
        for row in csv.reader(io.StringIO(text, newline=""), delimiter=delimiter):
            assert not [cell for cell in row if FORMULA.match(cell)], (delimiter, row)


def a_name_that_moves_the_cursor(top):
    """A name in the roster, as students enter them on a platform."""
    path = top / "roster.csv"
    path.write_text('student,name\nada,Ada\nmallory,"Eve\x1b[2J\x1b]0;x\x07"\n', encoding="utf-8")
    try:
        told = [student.name for student in read_roster(path)]
    except ValueError as error:
        told = [str(error)]
    assert all(text.isprintable() for text in told), told


AROUND = [
    ("an offset that no number holds", an_offset_that_no_number_holds),
    ("a dictionary of four gigabytes", a_dictionary_of_four_gigabytes),
    ("a list of a million members", a_list_of_a_million_members),
    ("names that no disk holds", names_that_no_disk_holds),
    ("a tree deeper than a path", a_tree_deeper_than_a_path),
    ("files that are none", files_that_are_none),
    ("a result of one's own", a_result_of_ones_own),
    ("a timestamp of one's own", a_timestamp_of_ones_own),
    *(
        (f"a copy, {how}", lambda top, change=change: _copied(top, change))
        for how, change in COPIES.items()
    ),
    ("a cell within a cell", a_cell_within_a_cell),
    ("a name that moves the cursor", a_name_that_moves_the_cursor),
    *DESK,
]
