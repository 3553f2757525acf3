"""Grading against nbgrader and otter-grader: the same 20 submissions of lesson 05 in one run;
seconds each, peak memory, the marks that come out.

    python benchmarks/grading.py                # ours, nbgrader, otter
    python benchmarks/grading.py --count 4 --minutes 5   # the same in small
    python benchmarks/grading.py --many 1000    # ours alone, on so many submissions with two jobs
    python benchmarks/grading.py --lessons 20   # ours alone, so many solutions of each lesson

Otter is installed into a temporary environment. A grader that is not done when the minutes are
over is stopped and its line says so.

"Each" is the time of all less the time of 1 (the best of three), divided by their number less 1:
what one more submission costs once everything runs. Memory is the largest sum of what the
grader's processes hold for themselves (PSS), sampled twenty times a second. Pages of files that
other programs hold too count in part: let no other Python run meanwhile, or 10 MB may be missing.
"""

import argparse
import csv
import json
import math
import os
import subprocess
import sys
import tempfile
import threading
import time
import venv
from pathlib import Path

import numpy as np
import psutil

ROOT = Path(__file__).parents[1]
sys.path[:0] = [str(ROOT / "tests" / "doctor" / "programs"), str(ROOT / "tests" / "grading")]
import corpus  # noqa: E402
from wrong_programs import WRONG  # noqa: E402

from dhlab.course.exercises import exercises  # noqa: E402
from dhlab.grading.cage.cage import Cage  # noqa: E402
from dhlab.grading.exports.nbgrader import export_nbgrader  # noqa: E402
from dhlab.grading.intake.roster import Student  # noqa: E402
from dhlab.grading.judging import running, work  # noqa: E402
from dhlab.grading.judging.questions import Course, handed_out_checks, seed  # noqa: E402
from dhlab.grading.settings import Lesson, Settings  # noqa: E402

LESSON = "05-link-matrix"
OTTER = "otter-grader==7.0.0"
TEST = """from otter.test_files import test_case
OK_FORMAT = False
name, points = "{name}", {points}

@test_case(points={points})
def judged(env):
    from dhlab.course.exercises import exercises
    assert exercises()["{key}"].judge(eval("{expression}", dict(env))).points == {points}
"""


def submissions(count):
    """Notebooks of lesson 05: every other one right, the others with one wrong program each."""
    wrong = [text for family, _, text in WRONG if family == "dh_transform"]
    found = {}
    for number in range(count):
        notebook = corpus.solved()
        if number % 2:
            corpus.answer(
                "05.6", wrong[number // 2 % len(wrong)].replace("dh_transform", "dh_closed")
            )(notebook, {})
        found[f"s{number:04d}"] = json.dumps(notebook)
    return found


class Late(Exception):
    """The minutes are over."""


class Watched:
    """Runs commands, and remembers the largest sum of memory that their processes held, and the
    seconds of processor that they took, both with those of ``others`` beside them. What still runs
    at ``until``, on the clock, is stopped, and Late is raised.
    """

    def __init__(self, others=(), interval=0.05, until=math.inf):
        self.peak, self.processor, self.until = 0, 0.0, until
        self.others, self.interval = [psutil.Process(other) for other in others], interval

    def run(self, command, cwd=None, env=None):
        process = psutil.Popen(
            [str(word) for word in command],
            cwd=cwd,
            env=env,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )
        over = threading.Event()
        watcher = threading.Thread(target=self._watch, args=(process, over))
        watcher.start()
        try:
            out, _ = process.communicate(timeout=self.left())
        except subprocess.TimeoutExpired:
            for one in [*_children(process), process]:
                one.kill()
            raise Late from None
        finally:
            over.set()
            watcher.join()
        if process.returncode:
            raise SystemExit(f"{command[:4]}: exit {process.returncode}\n{out[-2000:]}")

    def left(self):
        """Seconds that are left; None where there is no end."""
        return None if self.until == math.inf else max(0.1, self.until - time.monotonic())

    def _watch(self, process, over):
        while not over.wait(self.interval):
            memory, processor = 0, 0.0
            for root in [process, *self.others]:
                for one in [root, *_children(root)]:
                    try:
                        if _borrows_its_memory(one):
                            continue
                        memory += one.memory_full_info().pss
                        processor += sum(one.cpu_times()[:4])  # its own, and those it has buried
                    except psutil.Error:
                        continue
            self.peak, self.processor = max(self.peak, memory), max(self.processor, processor)


def _borrows_its_memory(process):
    """Whether a process is about to become another program: until then it has its parent's memory,
    which waits for it (vfork) and is counted there.
    """
    parent = process.parent()
    return (
        parent is not None
        and parent.status() == psutil.STATUS_DISK_SLEEP
        and parent.cmdline() == process.cmdline()
    )


def _children(process):
    try:
        return process.children(recursive=True)
    except psutil.Error:
        return []


def timed(grader, many, one, until):
    """(seconds each, seconds in all, MB, marks) of a grader on many submissions and on one."""
    watched, singles = Watched(until=until), []
    for _ in range(3):
        # the first is slow for reasons of its own: files not in memory, modules not compiled yet
        begun = time.perf_counter()
        grader(one, Watched(until=until))
        singles.append(time.perf_counter() - begun)
    single = min(singles)
    begun = time.perf_counter()
    marks = grader(many, watched)
    whole = time.perf_counter() - begun
    return (whole - single) / (len(many) - 1), whole, watched.peak / 1e6, marks


def ours(handed_in, watched, jobs=1):
    """``dhlab grade``, with feedback and class report."""
    with tempfile.TemporaryDirectory() as top:
        for student, text in handed_in.items():
            (Path(top) / "in" / student).mkdir(parents=True)
            (Path(top) / "in" / student / f"{LESSON}.ipynb").write_text(text, encoding="utf-8")
        watched.run(
            [
                sys.executable,
                "-m",
                "dhlab",
                "grade",
                f"{top}/in",
                "--out",
                f"{top}/out",
                "--jobs",
                jobs,
            ]
        )
        with open(f"{top}/out/grades.csv", encoding="utf-8") as file:
            return {row["student"]: float(row["points"]) for row in csv.DictReader(file)}


def nbgrader(handed_in, watched):
    """``nbgrader autograde`` and ``export``, on the course that ``dhlab export nbgrader``
    writes.
    """
    with tempfile.TemporaryDirectory() as top:
        course, env = (
            Path(top) / "course",
            os.environ | {"PATH": f"{Path(sys.executable).parent}:{os.environ['PATH']}"},
        )
        export_nbgrader(
            course, [Student(student) for student in handed_in], Settings({"05": Lesson()})
        )
        command = [sys.executable, "-m", "nbgrader"]
        for words in (
            ["db", "student", "import", "students.csv"],
            ["db", "assignment", "import", "assignments.csv"],
            ["generate_assignment", LESSON],
        ):
            Watched(until=watched.until).run([*command, *words], course, env)
        release = json.loads(
            (course / "release" / LESSON / f"{LESSON}.ipynb").read_text(encoding="utf-8")
        )
        for student, text in handed_in.items():
            folder = course / "submitted" / student / LESSON
            folder.mkdir(parents=True)
            (folder / f"{LESSON}.ipynb").write_text(
                json.dumps(_answered(release, text)), encoding="utf-8"
            )
        watched.run([*command, "autograde", LESSON], course, env)
        watched.run([*command, "export"], course, env)
        with open(course / "grades.csv", encoding="utf-8") as file:
            return {row["student_id"]: float(row["raw_score"]) for row in csv.DictReader(file)}


def _answered(release, text):
    """nbgrader's own release with the answers of a submission in it."""
    answers = {
        cell["id"]: cell["source"]
        for cell in json.loads(text)["cells"]
        if "exercise" in cell["metadata"]
    }
    return release | {
        "cells": [
            cell | {"source": answers.get(cell["id"], cell["source"])} for cell in release["cells"]
        ]
    }


def otter_environment(folder, watched):
    """A temporary environment with otter-grader, which sees this environment's packages behind its
    own.
    """
    venv.create(folder, with_pip=True)
    python = Path(folder) / "bin" / "python"
    watched.run([python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", OTTER])
    own = next(Path(folder).glob("lib/python*/site-packages"))
    (own / "dhlab_bench.pth").write_text(
        f"import site; site.addsitedir({str(Path(np.__file__).parents[1])!r})\n", encoding="utf-8"
    )


def otter(environment):
    """``otter run``, submission by submission, with one test an exercise that asks the exercise
    itself; the environment is a folder.
    """

    def grade(handed_in, watched):
        python = environment / "bin" / "python"
        if not python.exists():
            otter_environment(environment, watched)
        with tempfile.TemporaryDirectory() as top:
            tests = Path(top) / "tests"
            tests.mkdir()
            for key, (expression, _) in handed_out_checks()["05"].items():
                name = "q" + key.replace(".", "_")
                (tests / f"{name}.py").write_text(
                    TEST.format(
                        name=name, points=exercises()[key].points, key=key, expression=expression
                    ),
                    encoding="utf-8",
                )
            env = os.environ | {"PATH": f"{python.parent}:{os.environ['PATH']}"}
            subprocess.run(
                [
                    python,
                    "-m",
                    "otter",
                    "generate",
                    "-t",
                    tests,
                    "-o",
                    f"{top}/autograder.zip",
                    "--no-environment",
                ],
                check=True,
                cwd=top,
                env=env,
                capture_output=True,
            )
            marks = {}
            for student, text in handed_in.items():
                folder = Path(top) / student
                folder.mkdir()
                (folder / "lesson.ipynb").write_text(text, encoding="utf-8")
                watched.run(
                    [
                        python,
                        "-m",
                        "otter",
                        "run",
                        "-a",
                        f"{top}/autograder.zip",
                        "-o",
                        folder,
                        folder / "lesson.ipynb",
                    ],
                    cwd=folder,
                    env=env,
                )
                scores = json.loads((folder / "results.json").read_text(encoding="utf-8"))["tests"]
                marks[student] = sum(test.get("score", 0) for test in scores)
            return marks

    return grade


def of_each_lesson(count):
    """Seconds of processor and MB of each lesson, on so many copies of its solution."""
    print(
        "| lesson | points | CPU s each | of these in the cage | MB, 1 job | MB, 2 jobs |"
        "\n|---|---|---|---|---|---|"
    )
    for lesson in sorted({path.name[:2] for path in (ROOT / "solutions").glob("*.ipynb")}):
        files = {
            path.name: path.read_bytes()
            for path in sorted((ROOT / "solutions").glob(f"{lesson}*.ipynb"))
        }
        points, outside, inside = _processor(lesson, files, count)
        peaks = [_peak(lesson, files, count, jobs) for jobs in (1, 2)]
        print(
            f"| {lesson} | {points} | {outside + inside:.3f} | {inside:.3f} | {peaks[0]:.0f} |"
            f" {peaks[1]:.0f} |",
            flush=True,
        )


def _processor(lesson, files, count):
    """(points, seconds outside the cage, seconds in it) of one submission; what is done once for
    all is left out. The cage itself tells what its processes took.
    """
    course, inside = Course((lesson,), Settings(), {}), []
    finish = Cage._finish

    def counted(cage):
        told = finish(cage)
        inside.append(told[1])
        return told

    def task(number):
        seeds = {e.id: seed(None, str(number), "s", e.id) for e in course.exercises}
        handed = tuple(work.Handed(name, raw) for name, raw in files.items())
        return work.Task("s", handed, number=str(number), seeds=seeds)

    Cage._finish = counted
    try:
        work.work(task(0), course)
        inside.clear()
        begun = time.process_time()
        for number in range(count):
            graded = work.work(task(number), course)
        outside = time.process_time() - begun
    finally:
        Cage._finish = finish
        running.close()
    return f"{graded.points:g} of {graded.of:g}", outside / count, sum(inside) / count


def _peak(lesson, files, count, jobs):
    """MB that ``dhlab grade`` holds at most, all its processes together."""
    watched = Watched()
    with tempfile.TemporaryDirectory() as top:
        (Path(top) / "course.yaml").write_text(f'lessons: {{"{lesson}": {{}}}}\n', encoding="utf-8")
        for number in range(count):
            folder = Path(top) / "in" / f"s{number}"
            folder.mkdir(parents=True)
            for name, raw in files.items():
                (folder / name).write_bytes(raw)
        words = ["grade", f"{top}/in", "--out", f"{top}/out", "--course", f"{top}/course.yaml"]
        watched.run([sys.executable, "-m", "dhlab", *words, "--jobs", jobs])
    return watched.peak / 1e6


def compare(graders, count, until):
    """The table in Markdown, each line as soon as it is known; ours is the first."""
    many, one, own = submissions(count), submissions(1), None
    print(
        f"| grader | seconds each | whole ({count}) | times ours, whole | peak MB | same marks as"
        " ours |\n|---|---|---|---|---|---|",
        flush=True,
    )
    for name, grader in graders.items():
        try:
            each, whole, peak, marks = timed(grader, many, one, until)
        except (Late, subprocess.TimeoutExpired):
            print(f"| {name} | not done when the minutes were over | | | | |", flush=True)
            if own is None:
                return
            continue
        own = own or (whole, marks)
        same = sum(abs(marks[student] - points) < 1e-9 for student, points in own[1].items())
        print(
            f"| {name} | {each:.3f} | {whole:.1f} | {whole / own[0]:.0f} | {peak:.0f} |"
            f" {same} of {len(own[1])} |",
            flush=True,
        )


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--many", type=int, default=0)
    parser.add_argument("--lessons", type=int, default=0)
    parser.add_argument("--count", type=int, default=20)
    parser.add_argument("--minutes", type=float, default=20)
    options = parser.parse_args()
    if options.lessons:
        of_each_lesson(options.lessons)
        return
    if options.many:
        begun, watched = time.perf_counter(), Watched()
        marks = ours(submissions(options.many), watched, jobs=2)
        seconds = time.perf_counter() - begun
        print(
            f"{len(marks)} submissions, 2 jobs: {seconds:.1f} s in all with feedback and report,"
            f" {seconds / len(marks):.3f} s each; {watched.peak / 1e6:.0f} MB at most"
        )
        return
    until = time.monotonic() + 60 * options.minutes
    with tempfile.TemporaryDirectory() as folder:
        graders = {"dhlab grade": ours, "nbgrader 0.9": nbgrader}
        compare(graders | {"otter-grader 7.0": otter(Path(folder))}, options.count, until)


if __name__ == "__main__":
    main()
