"""A class of 120 in two sections, 200 notebooks of all kinds, decisions, three regrades (one runs
everything again): every mark against what is worked out by hand.

Run ``python benchmarks/class_of_120.py [OUT]`` from the project's top folder. What is right is
planted: each student answers the first so many of lesson 05's exercises from the solution, and the
marks are reckoned here from that, the dates and the decisions, without the grader's own code.
"""

import argparse
import copy
import csv
import json
import os
import sys
import tempfile
import time
from collections import Counter
from datetime import UTC, datetime, timedelta
from pathlib import Path

from dhlab.course.exercises import exercises
from dhlab.grading.exports.gradebooks import canvas_csv, read_marks
from dhlab.grading.grade import grade
from dhlab.grading.intake.roster import Student
from dhlab.grading.reports.publish import publish
from dhlab.grading.settings import read_settings

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "grading"))
from corpus import solved

SIZE = 120
DUE = datetime(2026, 11, 20, 12, tzinfo=UTC)
ASKED = [key for key, e in exercises().items() if key.startswith("05.") and e.points]
WORTH = {key: exercises()[key].points for key in ASKED}
DROPPED = "05.7"
KINDS = (
    "plain",
    "late",
    "twice",
    "wrong name",
    "other lesson",
    "Colab",
    "VS Code",
    "R kernel",
    "50 MB of output",
    "unreadable",
    "missing",
    "twice",
)
COURSE = f"""timezone: UTC
lessons: {{"05": {{due: {DUE:%Y-%m-%d %H:%M}}}}}
late: {{percent_per_day: 10, floor: 50}}
"""


def kind_of(k):
    """How student k hands in; 50 MB of output is rare, to spare the disk."""
    kind = KINDS[k % len(KINDS)]
    return "plain" if kind == "50 MB of output" and k > 20 else kind


def count_of(k):
    """How many exercises student k answers."""
    return k % (len(ASKED) + 1)


def notebook(count):
    """The solution with the first ``count`` exercises answered, the others as handed out."""
    made = copy.deepcopy(solved())
    for cell, check in zip(made["cells"], made["cells"][1:]):
        key = cell.get("metadata", {}).get("exercise")
        if key in ASKED[count:]:
            name = check["source"].partition(", ")[2].rstrip(")\n")
            cell["source"] = f"{name} = ..."
    return made


def hand_in(folder):
    """Write everybody's files; how many notebooks there are."""
    written = 0
    for k in range(SIZE):
        kind, own = kind_of(k), folder / f"s{k:03d}"
        if kind == "missing":
            continue
        files = {"05-link-matrix.ipynb": dressed(notebook(count_of(k)), kind)}
        if kind == "unreadable":
            files = {"05-link-matrix.ipynb": b'{"cells": ['}
        elif kind == "wrong name":
            files = {"homework final (2).ipynb": files["05-link-matrix.ipynb"]}
        elif kind == "other lesson":
            files["00-start-here.ipynb"] = Path("lessons/00-start-here.ipynb").read_bytes()
        elif kind == "twice":  # the older copy has nothing in it
            files = {"old/05-link-matrix.ipynb": dressed(notebook(0), kind)} | files
        if (k % 2 == 0 or k % 12 == 1) and kind != "unreadable":
            files["untouched/05-link-matrix.ipynb"] = dressed(notebook(0), kind)
        for name, raw in files.items():
            path = own / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(raw)
            came = DUE + timedelta(days=1.5 if kind == "late" else -1)
            came -= timedelta(hours=5) if "/" in name else timedelta(0)
            os.utime(path, (came.timestamp(), came.timestamp()))
            written += 1
    return written


def dressed(made, kind):
    """A notebook as another program saves it."""
    if kind == "Colab":
        made["metadata"] = {"colab": {"provenance": []}, "kernelspec": {"name": "python3"}}
        for cell in made["cells"]:
            cell["metadata"] = {"id": "x"}
            cell["source"] = cell["source"].splitlines(keepends=True)
    elif kind == "VS Code":
        made["metadata"]["language_info"] = {"name": "python"}
        for cell in made["cells"]:
            cell.get("metadata", {}).setdefault("vscode", {"languageId": "python"})
    elif kind == "R kernel":
        made["metadata"]["kernelspec"] = {"name": "ir", "display_name": "R", "language": "R"}
    elif kind == "50 MB of output":
        text = {"output_type": "stream", "name": "stdout", "text": "x" * 50_000_000}
        next(cell for cell in made["cells"] if cell["cell_type"] == "code")["outputs"] = [text]
    return json.dumps(made).encode()


def decisions(folder):
    """What the teacher decides: extensions, points, a bonus, a hold, a dropped exercise."""
    text = f'dropped: {{"{DROPPED}": "unclear"}}  # by hand\nstudents:\n'
    for k in range(SIZE):
        if k % 24 == 1:
            text += f'  s{k:03d}: {{due: {{"05": {DUE + timedelta(days=2):%Y-%m-%d}}}}}\n'
        elif k % 24 == 0:
            text += f'  s{k:03d}: {{exercises: {{"05.4": {{points: 0.5, comment: "x"}}}}}}\n'
        elif k % 24 == 2:
            text += f"  s{k:03d}: {{bonus: 1}}\n"
        elif k == 3:
            text += f"  s{k:03d}: {{hold: talk}}\n"
    (folder / "decisions.yaml").write_text(text, encoding="utf-8")


def by_hand(k, decided):
    """The total of student k, reckoned from what was planted; None where no mark is given out."""
    kind = kind_of(k)
    if kind in ("missing", "unreadable") or (decided and k == 3):
        return None
    points = {key: WORTH[key] for key in ASKED[: count_of(k)]}
    if not decided:
        return round(sum(points.values()) * (0.8 if kind == "late" else 1), 2)
    points.pop(DROPPED, None)
    if k % 24 == 0:
        points["05.4"] = 0.5
    late = kind == "late" and k % 24 != 1
    # an exercise that was left out is late for nothing: two days begun are 20 % of what was earned
    return round(sum(points.values()) * (0.8 if late else 1) + (k % 24 == 2), 2)


def differences(found, decided):
    """(student, found, by hand) of every mark that is another one."""
    for k in range(SIZE):
        graded = found[f"s{k:03d}"]
        given = graded.status not in ("missing", "unreadable", "on hold")
        if (graded.total if given else None) != by_hand(k, decided):
            yield graded.student, kind_of(k), graded.status, graded.total, by_hand(k, decided)


def main():
    """Grade four times and print every mark that is not the one worked out by hand."""
    parser = argparse.ArgumentParser(description=__doc__.partition(":")[0])
    parser.add_argument("out", nargs="?", metavar="OUT", help="where the class is kept")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        top = Path(options.out or temporary)
        written = hand_in(top / "in")
        (top / "course.yaml").write_text(COURSE)
        settings = read_settings(top / "course.yaml")
        everybody = [Student(f"s{k:03d}", f"Student {k}", section="AB"[k % 2]) for k in range(SIZE)]
        print(f"{SIZE} students, {written} notebooks: {dict(Counter(map(kind_of, range(SIZE))))}")
        for run in range(4):
            begun = time.perf_counter()
            results, planned = grade(top / "in", top / "out", roster=everybody, settings=settings)
            publish(planned, results, everybody, top / "out")
            found = read_marks(top / "out")
            wrong = list(differences(found, run > 0))
            print(
                f"run {run + 1}: {time.perf_counter() - begun:.0f} s,"
                f" {dict(Counter(graded.status for graded in results))}, other marks than by hand:"
                f" {len(wrong)}"
            )
            print("\n".join(map(str, wrong[:20])))
            decisions(top / "out")
            if run == 1:  # other limits: everything runs again
                (top / "course.yaml").write_text(COURSE + "limits: {cell_seconds: 9}\n")
                settings = read_settings(top / "course.yaml")
            if run == 3:
                print("against marks without decisions:", len(list(differences(found, False))))
        rows = list(csv.reader(canvas_csv(found, everybody).splitlines()))[2:]
        print(
            "Canvas:", Counter(row[4] for row in rows), sum(row[5] == "" for row in rows), "empty"
        )


if __name__ == "__main__":
    main()
