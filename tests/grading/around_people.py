"""Attacks on others that need no program: their names, their files, their good name, and the time
of the class. Each is (name, a function of an empty folder) that raises where something got through;
``mallory`` attacks, ``ada`` is honest.
"""

import base64
import json
import os
import struct
import tempfile
import zlib
from datetime import UTC, datetime
from pathlib import Path
from urllib.parse import urlsplit

import corpus
import numpy as np
from around_desk import asked, desk

from dhlab.course.exercises import exercises
from dhlab.course.kinds import Function, Table, Value
from dhlab.doctor.programs.running.calling import Called
from dhlab.grading.inside.wire import encode
from dhlab.grading.intake.roster import Student
from dhlab.grading.intake.submissions import submissions
from dhlab.grading.judging.asking import Asked, _told
from dhlab.grading.judging.judge import _judged
from dhlab.grading.judging.programs import _called
from dhlab.grading.plan import plan
from dhlab.grading.reports.alike import alike
from dhlab.grading.settings import Settings

NOTEBOOK = json.dumps(corpus.solved()).encode()
LATER = datetime(2026, 11, 20, 12, tzinfo=UTC)
ROSTER = [Student("ada_l", "Ada Lovelace", "ada@example.org"), Student("mallory", "Mallory")]


def put(path, data=NOTEBOOK, when=LATER):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(data)
    os.utime(path, (when.timestamp(), when.timestamp()))


def times_that_no_calendar_has(top):
    """From a tar: a file of the year 300,000, and one from before the year 1."""
    with tempfile.TemporaryDirectory(dir="/dev/shm") as folder:  # which keeps such times
        for name, seconds in (("later", 10**13), ("before", -(10**12)), ("edge", 253402300799)):
            put(Path(folder) / "mallory" / f"{name}.ipynb")
            os.utime(Path(folder) / "mallory" / f"{name}.ipynb", (seconds, seconds))
        put(Path(folder) / "ada_l" / "05.ipynb")
        found = submissions(folder, ROSTER)
        assert [one.when for one in found["ada_l"].notebooks] == [LATER]
        assert len(found["mallory"].notebooks) == 3


def _only_hers(top, roster=ROSTER):
    """Ada's own file, in a folder of hers, is all that counts as hers."""
    found = submissions(top, roster)
    names = [one.name for one in found["ada_l"].notebooks]
    assert names == ["ada_l/05.ipynb"], f"of ada_l are taken {names}"


def an_id_by_other_signs(top):
    """Names that become an id of the roster once they are made to name a file."""
    put(top / "ada_l" / "05.ipynb", when=LATER.replace(day=1))
    for name in ("ada,l.ipynb", "ada:l.ipynb", "ada\u200bl.ipynb", "ada\u202el.ipynb", "ada|l"):
        put(top / name)
    _only_hers(top)


def a_folder_within_a_strangers(top):
    """A platform's folder of somebody who is not on the roster holds one with Ada's id."""
    put(top / "ada_l" / "05.ipynb", when=LATER.replace(day=1))
    put(top / "Eve X_771_assignsubmission_file_" / "ada_l" / "05.ipynb")
    put(top / "evex_771_772_05.zip", corpus.zipped({"ada_l/05.ipynb": NOTEBOOK}))
    _only_hers(top)


def an_address_like_an_id(top):
    """Mallory's e-mail begins with Ada's id; a file called by Ada's name lies beside the others."""
    roster = [ROSTER[0], Student("mallory", "Mallory", "ada_l@evil.example")]
    put(top / "ada_l" / "05.ipynb", when=LATER.replace(day=1))
    put(top / "mallory" / "05.ipynb")
    put(top / "ada_l@evil.example.ipynb")
    _only_hers(top, roster)
    put(top / "Ada Lovelace.ipynb")
    names = [one.name for one in submissions(top, roster)["ada_l"].notebooks]
    assert "ada_l/05.ipynb" in names, f"of ada_l are taken {names}"


def two_files_of_one_name(top):
    """Names that are shown alike: the teacher reads the one, and the other ran."""
    for name in ("x\x1b.ipynb", "x\\x1b.ipynb", "y\n.ipynb", "y\\n.ipynb"):
        put(top / "mallory" / name)
    shown = [one.name for one in submissions(top, ROSTER)["mallory"].notebooks]
    assert len(shown) == len(set(shown)) == 4, shown


WORDS = "theta", "d", "a", "2", "7.5"


def _programs(number):
    """Sixty lines of one person's own, for 05.6 and 05.7; another number, another person."""
    rng = np.random.default_rng(number)
    own = {}
    for key in ("05.6", "05.7"):
        lines = [
            f"    v{k} = {'+-*/'[rng.integers(4)].join(rng.choice(WORDS, 5))}" for k in range(30)
        ]
        own[key] = "def f(theta, d, a, alpha):\n" + "\n".join(lines) + "\n    return v3\n"
    return own


def a_kitchen_sink(top):
    """Mallory's answer holds what many others wrote: they are not said to be alike to her."""
    codes = {f"s{k}": _programs(k) for k in range(20)}
    codes["mallory"] = {
        key: "".join(codes[f"s{k}"][key] for k in range(8)) for key in ("05.6", "05.7")
    }
    assert alike({k: v for k, v in codes.items() if k != "mallory"}, {}) == []
    named = [pair.students for pair in alike(codes, {})]
    assert len(named) < 3, f"innocents beside mallory: {named}"


def a_copy_in_another_place(top):
    """All that the neighbour wrote, in the first cell: no exercise is like another's."""
    codes = {f"s{k}": _programs(k) for k in range(20)}
    copied = "".join(codes["s3"].values())
    codes["mallory"] = {"05.1": copied, "05.6": "x = f\n", "05.7": "x = f\n"}
    assert ("mallory", "s3") in [pair.students for pair in alike(codes, {})]


def a_lesson_for_all(top):
    """One of five hands in other lessons too; without a course.yaml they count for nobody."""
    for student in ("a", "b", "c", "d", "mallory"):
        put(top / "in" / student / "05.ipynb")
    for lesson in ("06", "07", "09"):
        cell = {"cell_type": "code", "source": f'check("{lesson}.1", 1)', "metadata": {}, "id": "x"}
        put(top / "in" / "mallory" / f"{lesson}.ipynb", json.dumps({"cells": [cell]}).encode())
    assert plan(top / "in").course.lessons == ("05",)


def _png(width, height):
    """A PNG of no more than a head and an end."""
    head = struct.pack(">II5B", width, height, 8, 6, 0, 0, 0)
    chunks = (b"IHDR", head), (b"IDAT", b""), (b"IEND", b"")
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
        for kind, data in chunks
    )


def a_picture_of_gigabytes(top):
    """Small on the disk, and too large for the browser that the review is read in."""
    large = 65_500
    pictures = {
        "image/png": _png(large, large),
        "image/gif": b"GIF89a" + struct.pack("<HH", large, large) + bytes(3),
        "image/jpeg": b"\xff\xd8\xff\xe0\x00\x04xx\xff\xc2\x00\x11\x08"
        + struct.pack(">HH", large, large)
        + bytes(12),
        "image/webp": b"RIFF\x1e\x00\x00\x00WEBPVP8X\x0a\x00\x00\x00\x00\x00\x00\x00"
        + struct.pack("<I", large - 1)[:3]
        + struct.pack("<I", large - 1)[:3],
    }
    pictures["image/png "] = _png(1000, 800)
    pictures["image/jpeg "] = pictures["image/gif"]  # a browser looks at what it is
    pictures["image/webp "] = b"<svg xmlns='http://www.w3.org/2000/svg' onload='alert(1)'/>"
    sent = [[kind.strip(), base64.b64encode(data).decode()] for kind, data in pictures.items()]
    with desk(top) as (folder, address):
        told = json.dumps({"05.2": ["mine", sent]})
        (folder / "answers" / "mallory.json").write_text(told, encoding="utf-8")
        path = urlsplit(address).path
        text, kinds = json.loads(asked(address, path + "answers/mallory")[1])["05.2"]
        assert kinds == ["image/png"] and "not shown" in text and text.startswith("mine")
        status = [asked(address, f"{path}picture/mallory/05.2/{k}")[0] for k in range(3)]
        assert status == [200, 404, 404]


def _judged_as(exercise, value, settings=Settings(partial=0.5)):
    return _judged(exercise, {"value": encode(value)}, 7, settings, exercise.points)


def angles_without_end(top):
    """So large that every right angle is within a rounding of it, whole turns apart."""
    turned = [e for e in exercises().values() if isinstance(e, Value) and e.turns]
    assert len(turned) > 3
    for exercise in turned:
        for size in (1e12, 1e17, -1e20, 360 * 2.0**80, 1e300):
            answer = exercise.expected(7).copy()
            answer[list(exercise.turns)] = size
            assert _judged_as(exercise, answer).points == 0, (exercise.id, size)


def tables_without_end(top):
    """Lengths whose sums are infinite, and NaN where they are compared: no mark, and no fault."""
    for exercise in (e for e in exercises().values() if isinstance(e, Table) and e.points):
        rows = exercise.right_arm(7).table.rows * [180 / np.pi, 1, 1, 180 / np.pi]
        for lengths in (1.7e308, -1.7e308, 1e155):
            for column in ([1], [2], [1, 2]):
                answer = rows.copy()
                answer[:, column] = lengths
                answer[::2, column] *= -1 if lengths > 1e200 else 1
                found = _judged_as(exercise, answer)
                assert (found.points, found.status) == (0, "wrong"), (exercise.id, found.note)


def an_arm_that_is_no_number(top):
    """Forged on the wire: couplings, bases and tools in which an infinity becomes NaN, in the
    rotation of the last joint alone or everywhere.
    """
    for exercise in (e for e in exercises().values() if isinstance(e, Table) and e.points):
        right = exercise.right_arm(7)
        n = len(right)
        sent = encode(right)["arm"]
        infinite = {"array": ["f8", [n, n], (np.eye(n) * 1.7e308).ravel().tolist()]}
        odd = np.eye(n)
        odd[-1, 0] = 1.7e308
        tool = np.eye(4)
        tool[:3, :3] = np.nan
        for place, value in ((4, infinite), (4, encode(odd)), (2, encode(tool)), (1, encode(tool))):
            forged = {"arm": [*sent[:place], value, *sent[place + 1 : 5], False]}
            found = _judged(exercise, {"value": forged}, 7, Settings(), exercise.points)
            assert found.points == 0, (exercise.id, place, found.headline)


def half_the_points_for_nothing(top):
    """A share for a mistake that is recognised, and no work: programs that change their inputs,
    give back nothing or an argument; what was handed out, hardly touched.
    """
    settings = Settings(partial=0.5)
    for exercise in map(exercises().get, ("01.4", "05.6", "06.2", "08.6", "03.9", "07.3", "07.4")):
        if isinstance(exercise, Function):
            cases = exercise.cases(5)
            shape = exercise.shape
            tries = [_told({"kind": "changed"}, exercise, False)]
            constants = [
                np.zeros(shape),
                np.ones(shape),
                np.full(shape, 1e300),
                np.eye(4),
                [],
                None,
            ]
            given = [[one] * len(cases) for one in constants]
            given += [[case[k] for case in cases] for k in range(len(exercise.names))]
            given += [[np.ones(shape) * (1 + k) for k in range(len(cases))]]
            given += [[np.eye(4)[:3] + k for k in range(len(cases))], [[[1], [1, 2]]] * len(cases)]
            given += [["x"] * len(cases), [{}] * len(cases)]
            tries += [Called(tuple(one), one[0]) for one in given]
            for k, called in enumerate(tries):
                found = _called(exercise, Asked(called), 5, settings, exercise.points)
                assert found.points == 0, (exercise.id, k, found.headline)
        else:
            rows = np.array(exercise.handed_out(**exercise.given(7)), dtype=float)
            for place in [(0, 0), (2, 2), (1, 3)]:
                touched = rows.copy()
                touched[place] += 360
                found = _judged_as(exercise, touched, settings)
                assert (found.status, found.points) == ("wrong", 0), (exercise.id, place)


PEOPLE = [
    ("times that no calendar has", times_that_no_calendar_has),
    ("an id by other signs", an_id_by_other_signs),
    ("a folder within a stranger's", a_folder_within_a_strangers),
    ("an address like an id", an_address_like_an_id),
    ("two files of one name", two_files_of_one_name),
    ("a kitchen sink", a_kitchen_sink),
    ("a copy in another place", a_copy_in_another_place),
    ("a lesson for all", a_lesson_for_all),
    ("a picture of gigabytes", a_picture_of_gigabytes),
    ("angles without end", angles_without_end),
    ("tables without end", tables_without_end),
    ("an arm that is no number", an_arm_that_is_no_number),
    ("half the points for nothing", half_the_points_for_nothing),
]
