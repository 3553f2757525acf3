"""What forward kinematics, all frames and Jacobians cost, beside the other libraries.

    python benchmarks/kinematics.py           # every library, in environments of their own
    python benchmarks/kinematics.py --quick   # dhlab beside plain numpy, half a minute

Every library runs in a process of its own (``kinematics_worker.py``) and is asked in turns, a few
hundredths of a second each, so that a busy moment of the machine meets all of them; what is shown
are medians over the rounds, and ratios of medians (on a machine that is busy all the time, the
least, with ``--least``). The full form writes its tables and pictures to
``docs/benchmarks/``. The environments are made where ``--envs`` says, once.
"""

import argparse
import json
import os
import platform
import statistics
import subprocess
import sys
import tempfile
import venv
from pathlib import Path

import numpy as np

import dhlab as dh

HERE, ROOT = Path(__file__).parent, Path(__file__).parents[1]
PAGES = ROOT / "docs" / "benchmarks"
# what an environment holds beside numpy; None: this one
LIBRARIES = {
    "usual numpy": None,
    "dhlab, numpy": None,
    "dhlab, numba, one core": ["numba", "lazy_loader"],
    "dhlab, numba": ["numba", "lazy_loader"],
    "Robotics Toolbox": ["roboticstoolbox-python"],
    "pinocchio": ["pin"],
    "MuJoCo": ["mujoco"],
    "JAX": ["jax"],
}
PEERS = ("Robotics Toolbox", "pinocchio", "MuJoCo", "JAX")
COLUMNS = {
    "FK 1": ("forward", 1),
    "FK 1,000": ("forward", 1000),
    "FK 1e5": ("forward", 100_000),
    "all frames 1e5": ("frames", 100_000),
    "Jacobian 1": ("jacobian", 1),
    "Jacobian 1e5": ("jacobian", 100_000),
}
SIZES = [int(10**k) for k in np.arange(0, 7.25, 0.5)]
JOINTS = (1, 2, 3, 6, 10, 20, 50, 100)
INKS = ("#6b737c", "#17479e", "#c23b00", "#d98032", "#00734f", "#7a3e9d", "#22262b", "#a3871f")


class Worker:
    """A library at work in another process; None instead of numbers where it cannot be had."""

    def __init__(self, name, python, arm):
        environment = {
            **os.environ,
            "PYTHONPATH": str(ROOT),
            "DHLAB_NUMBA": "1" if "numba" in name else "0",
        }
        self.name = name
        self.process = subprocess.Popen(
            [python, HERE / "kinematics_worker.py", name, arm],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, env=environment,
        )  # fmt: skip

    def ask(self, question, poses, **more):
        """Seconds a pose, or None."""
        self.process.stdin.write(json.dumps({"question": question, "poses": poses, **more}) + "\n")
        self.process.stdin.flush()
        line = self.process.stdout.readline()
        if not line:
            raise SystemExit(f"{self.name} stopped; its last words are above")
        return json.loads(line)

    def end(self):
        """Let the process go."""
        self.process.stdin.close()
        self.process.wait()


def python_of(packages, folder):
    """The Python of an environment with these packages, made where it is not there yet."""
    if packages is None:
        return sys.executable
    home = folder / packages[0]
    python = home / "bin" / "python"
    if not (home / "ready").exists():
        print(f"making an environment with {packages[0]} …", flush=True)
        venv.create(home, with_pip=True)
        subprocess.run([python, "-m", "pip", "install", "--quiet", "numpy", *packages], check=True)
        (home / "ready").touch()
    return python


def arm_file(rows, path):
    """The arm for the workers: its rows, and what it gives at some q by the plain product."""
    plain = dh.Arm(dh.DHTable.standard(rows, angle="rad"))._kinematics.plain
    q = np.random.default_rng(0).uniform(-3, 3, (5, len(rows)))
    answers = {name: getattr(plain, name)(q) for name in ("forward", "frames", "jacobian")}
    np.savez(path, rows=rows, q=q, **answers)
    return path


def started(names, folder, arm):
    """The workers, each found to give the right numbers."""
    workers = []
    for name in names:
        worker = Worker(name, python_of(LIBRARIES[name], folder), arm)
        for question in ("forward", "frames", "jacobian"):
            off = worker.ask(question, 5, check=True)
            if off is not None and off > 1e-12:
                raise SystemExit(f"{name}: {question} is {off:.1g} off the plain product")
        workers.append(worker)
    return workers


typical = statistics.median
PICTURES = """
![Cost of a pose over how many are asked at once](benchmarks/cost-by-size.svg)

![Cost of a pose over the number of joints](benchmarks/cost-by-joints.svg)
"""


def in_turns(workers, questions, rounds):
    """{(name, question): median of seconds a pose}, measured in turns."""
    seen = {}
    for _ in range(rounds):
        for key, (question, poses) in questions.items():
            for worker in workers:
                seen.setdefault((worker.name, key), []).append(worker.ask(question, poses))
    return {key: None if None in values else typical(values) for key, values in seen.items()}


def table(names, found):
    """The table in Markdown, microseconds a pose, and dhlab against the best other library."""
    lines = ["| | " + " | ".join(COLUMNS) + " |", "|---" * (len(COLUMNS) + 1) + "|"]
    for name in names:
        cells = [_figure(found[name, column]) for column in COLUMNS]
        lines.append(f"| {name} | " + " | ".join(cells) + " |")
    for name in names:
        if name.startswith("dhlab"):
            cells = [_against(found, name, column, names) for column in COLUMNS]
            lines.append(f"| *{name}, against the best peer* | " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def _figure(seconds):
    return "–" if seconds is None else f"{seconds * 1e6:.3g}"


def _against(found, name, column, names):
    peers = {peer: found[peer, column] for peer in PEERS if peer in names}
    best = min((peer for peer in peers if peers[peer] is not None), key=peers.get, default=None)
    if best is None:
        return "–"
    ratio = peers[best] / found[name, column]
    return f"{ratio:.2g} × ({best})"


def writing(worker, n, rounds):
    """Microseconds a pose that writing the results to fresh memory takes."""
    shapes = {"FK": (4, 4), "frames": (n + 1, 4, 4), "Jacobian": (6, n)}
    found = {
        name: typical(worker.ask("writing", 100_000, rest=[list(shape)]) for _ in range(rounds))
        for name, shape in shapes.items()
    }
    return ", ".join(f"{name} {value * 1e6:.3g}" for name, value in found.items())


def by_size(workers, path, rounds):
    """A picture: cost of a pose over how many are asked at once."""
    # more would take minutes, or more memory than there is
    most = {
        "pinocchio": 1e5,
        "MuJoCo": 1e5,
        "usual numpy": 1e6,
        "JAX": 1e6,
        "Robotics Toolbox": 1e6,
    }
    curves = {worker.name: [] for worker in workers}
    for size in SIZES:
        for worker in workers:
            if size <= most.get(worker.name, SIZES[-1]):
                times = [worker.ask("forward", size) for _ in range(rounds)]
                curves[worker.name].append((size, typical(times)))
    _drawn(curves, "poses asked at once", "One pose of a 6R arm costs", path)


def by_joints(folder, path, rounds):
    """A picture: cost of a pose over the number of joints, 1,000 poses at once."""
    names = ["usual numpy", "dhlab, numpy", "dhlab, numba, one core"]
    curves = {name: [] for name in names}
    rng = np.random.default_rng(0)
    for n in JOINTS:
        rows = np.column_stack(
            [np.zeros(n), rng.uniform(0, 0.1, n), rng.uniform(0, 0.1, n), rng.uniform(-2, 2, n)]
        )
        with tempfile.TemporaryDirectory() as place:
            workers = started(names, folder, arm_file(rows, Path(place) / "arm.npz"))
            found = in_turns(workers, {"FK": ("forward", 1000)}, rounds)
            for worker in workers:
                curves[worker.name].append((n, found[worker.name, "FK"]))
                worker.end()
    title = "One of 1,000 poses costs, twists at random,"
    _drawn(curves, "joints", title, path)


def _drawn(curves, across, title, path):
    from matplotlib.figure import Figure

    figure = Figure(figsize=(8, 4.6))
    axes = figure.add_subplot()
    order = list(LIBRARIES)
    for name, points in curves.items():
        x, y = np.array(points).T
        ours = name.startswith("dhlab")
        axes.loglog(
            x, y * 1e6, "-o" if ours else "--s", color=INKS[order.index(name)], label=name,
            markersize=4, linewidth=2 if ours else 1.2,
        )  # fmt: skip
    axes.set_xlabel(across)
    axes.set_ylabel("µs a pose")
    axes.set_title(title + " (libraries in turns)", fontsize=11)
    axes.grid(which="both", color="#e6e8eb", linewidth=0.5)
    axes.legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(path, metadata={"Date": None, "Creator": None})


def machine():
    """What it was measured on, in a line."""
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    return f"Python {platform.python_version()}, numpy {np.__version__}, {cores} cores"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="dhlab beside plain numpy only")
    parser.add_argument("--rounds", type=int, default=9)
    parser.add_argument("--envs", type=Path, default=Path(tempfile.gettempdir()) / "dhlab-peers")
    parser.add_argument("--least", action="store_true", help="least instead of median")
    given = parser.parse_args()
    if given.least:
        global typical
        typical = min
    rows = dh.load("article-6r").table.rows
    names = list(LIBRARIES)[:2] if given.quick else list(LIBRARIES)
    with tempfile.TemporaryDirectory() as place:
        workers = started(names, given.envs, arm_file(rows, Path(place) / "arm.npz"))
        found = in_turns(workers, COLUMNS, 3 if given.quick else given.rounds)
        text = table(names, found)
        limits = writing(workers[0], len(rows), 3 if given.quick else given.rounds)
        text += f"\nThe limit, to write the results to fresh memory, 1e5 poses: {limits}.\n"
        what = "least" if given.least else "medians"
        text += f"\nThe article's 6R arm, µs a pose, {what}; {machine()}.\n"
        print(text)
        if not given.quick:
            PAGES.mkdir(exist_ok=True)
            (PAGES / "kinematics.md").write_text(text)
            by_size(workers, PAGES / "cost-by-size.svg", 3)
            by_joints(given.envs, PAGES / "cost-by-joints.svg", 3)
            (PAGES / "kinematics.md").write_text(text + PICTURES)
        for worker in workers:
            worker.end()


if __name__ == "__main__":
    main()
