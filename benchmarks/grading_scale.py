"""``dhlab grade`` on 20, 200 and 2,000 copies of a lesson's solution: with one job, with two, and
over a Dask cluster of two workers on this machine. Plan, marks, feedback and report included.

    python benchmarks/grading_scale.py                      # 05 in all three numbers, 07 with 200
    python benchmarks/grading_scale.py --ways "1 job,Dask" --minutes 5 05:20,200

It ends within the minutes that it has: a run that would take longer, as the smaller ones of its
lesson tell, is left out and said so.

Every student has numbers of their own for the programs' inputs; the tasks' numbers are those of
everybody. Seconds are of processor, of all processes together, the last twentieth of a second left
out: the wall's clock says more of what else the machine does. Memory is the largest sum of what the
processes hold for themselves (PSS). What Dask costs a task is its seconds less those of one job.
"""

import argparse
import contextlib
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import psutil
from grading import ROOT, Watched

WAYS = {"1 job": ["--jobs", "1"], "2 jobs": ["--jobs", "2"], "Dask": []}
USUAL = "05:20,200,2000", "07:200"
INTERVAL = 0.25


@contextlib.contextmanager
def cluster(folder):
    """(address, processes) of a scheduler and two workers of one thread each."""
    file, tool = Path(folder) / "scheduler.json", [sys.executable, "-m", "distributed.cli."]
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    begin = [sys.executable, "-m", f"{tool[2]}dask_scheduler", "--no-dashboard", "--port", "0"]
    follow = [sys.executable, "-m", f"{tool[2]}dask_worker", "--nworkers", "2", "--nthreads", "1"]
    named = ["--scheduler-file", str(file)]
    both = [subprocess.Popen([*begin, *named], cwd=folder, **quiet)]
    while not file.exists():
        time.sleep(0.1)
    both.append(subprocess.Popen([*follow, *named, "--no-dashboard"], cwd=folder, **quiet))
    try:
        from distributed import Client

        with Client(scheduler_file=str(file)) as client:
            client.wait_for_workers(2)
            yield client.scheduler.address, [one.pid for one in both]
    finally:
        for one in reversed(both):
            one.terminate()
            one.wait()


def graded(lesson, count, way):
    """(seconds of processor, seconds on the clock, MB) of one run."""
    with tempfile.TemporaryDirectory() as top, contextlib.ExitStack() as stack:
        (Path(top) / "course.yaml").write_text(f'lessons: {{"{lesson}": {{}}}}\n', encoding="utf-8")
        for path in sorted((ROOT / "solutions").glob(f"{lesson}*.ipynb")):
            for number in range(count):
                folder = Path(top) / "in" / f"s{number:04}"
                folder.mkdir(parents=True, exist_ok=True)
                (folder / path.name).write_bytes(path.read_bytes())
        words, others = list(WAYS[way]), []
        if way == "Dask":
            address, others = stack.enter_context(cluster(top))
            words = ["--scheduler", address]
        before = sum(used(other) for other in others)
        watched, begun = Watched(others, INTERVAL), time.perf_counter()
        verb = ["grade", f"{top}/in", "--out", f"{top}/out", "--course", f"{top}/course.yaml"]
        watched.run([sys.executable, "-m", "dhlab", *verb, *words])
        return watched.processor - before, time.perf_counter() - begun, watched.peak / 1e6


class Clock:
    """The minutes that there are, and what a submission took so far, by lesson and way."""

    def __init__(self, minutes):
        self.end, self.each = time.monotonic() + 60 * minutes, {}

    def allows(self, lesson, count, way):
        """Whether a run will end in time; of a new lesson, whether any time is left."""
        known = max((each for key, each in self.each.items() if key[0] == lesson), default=0.0)
        return time.monotonic() + count * self.each.get((lesson, way), known) < self.end


def used(process):
    """Seconds of processor of a process and all below it, so far."""
    root = psutil.Process(process)
    return sum(sum(one.cpu_times()[:4]) for one in [root, *root.children(recursive=True)])


def row(lesson, count, way, alone, clock):
    """One line of the table, and the seconds of processor that each took; None where it was left
    out.
    """
    if not clock.allows(lesson, count, way):
        print(f"| {lesson} | {count:,} | {way} | left out, for want of time | | | |", flush=True)
        return None
    processor, took, memory = graded(lesson, count, way)
    each, clock.each[lesson, way] = processor / count, took / count
    dask = f"{each - alone:.3f}" if way == "Dask" and alone else ""
    print(
        f"| {lesson} | {count:,} | {way} | {each:.3f} | {dask} | {took:.0f} | {memory:.0f} |",
        flush=True,
    )
    return each


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n\n")[0])
    parser.add_argument("lessons", nargs="*", metavar="LESSON:COUNT,COUNT")
    parser.add_argument("--ways", default=",".join(WAYS))
    parser.add_argument("--minutes", type=float, default=15)
    options = parser.parse_args()
    clock = Clock(options.minutes)
    print("| lesson | submissions | how | CPU s each | of these Dask | clock s in all | MB |")
    print("|---|---|---|---|---|---|---|", flush=True)
    for lesson, _, counts in (asked.partition(":") for asked in options.lessons or USUAL):
        for count in map(int, counts.split(",")):
            alone = None
            for way in options.ways.split(","):
                each = row(lesson, count, way, alone, clock)
                alone = each if way == "1 job" else alone


if __name__ == "__main__":
    main()
