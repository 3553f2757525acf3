"""The way back, measured: what ``arm.solve`` finds, misses and says.

``python benchmarks/inverse.py`` prints Markdown. ``--quick`` is a small part of it, for CI, on
every fourth arm and without the Toolbox; ``--prepare`` first derives what the closed form of the
general arms needs (minutes each, kept on disk). Where Robotics Toolbox is installed it solves the
same poses in the same run.
"""

import argparse
import sys
import time
from importlib.util import find_spec
from pathlib import Path

import numpy as np

import dhlab as dh
from dhlab.inverse import prepare
from dhlab.inverse.candidates import needs_preparation

sys.path.insert(0, str(Path(__file__).parent))
from inverse_targets import just_out_of_reach, never_within_reach, wrong_orientation

MET = 1e-6  # rad, m: the q that made the pose is among the solutions
ALLOWED = 1e-9  # m, rad


def table(headings, rows):
    print("| " + " | ".join(headings) + " |")
    print("|" + "---|" * len(headings))
    for row in rows:
        print("| " + " | ".join(str(cell) for cell in row) + " |")
    print(flush=True)


def arms(joints):
    """The library's arms with so many turning joints; every fourth of them in a quick run."""
    loaded = {name: dh.load(name) for name in dh.robots()}
    found = {name: arm for name, arm in loaded.items() if arm.table.joints == "R" * joints}
    return dict(list(found.items())[:: 4 if "--quick" in sys.argv else 1])


def random_q(arm, rng, count, *, within=False):
    """Half a turn to either side, or the limits; sliding joints always keep theirs."""
    low, high = np.full(len(arm), -np.pi), np.full(len(arm), np.pi)
    for i, pair in enumerate(arm.limits or ()):
        if pair is not None and (within or arm.table.prismatic[i]):
            low[i], high[i] = pair
    return rng.uniform(low, high, (count, len(arm)))


def distance(arm, q, found):
    """How far the nearest of the solutions is from q, whole turns aside."""
    if not len(found):
        return np.inf
    apart = np.abs(np.asarray(found) - q)
    turned = np.abs((apart + np.pi) % (2 * np.pi) - np.pi)
    return np.where(arm.table.prismatic, apart, turned).max(axis=1).min()


class Tally:
    """What came back for many poses of one arm."""

    def __init__(self, arm):
        self.arm, self.found, self.counts, self.worst, self.seconds = arm, 0, [], np.zeros(2), []
        self.method, self.missed = "", []

    def ask(self, q, **conditions):
        T = self.arm.forward(q)
        start = time.perf_counter()
        answer = self.arm.solve(T, **conditions)
        self.seconds.append(time.perf_counter() - start)
        self.counts.append(len(answer))
        self.method = answer.method.split(" from ")[0]
        if answer:
            self.worst = np.maximum(self.worst, answer.residuals.max(axis=0))
        if distance(self.arm, q, answer.q) < MET:
            self.found += 1
        else:
            self.missed.append(q)
        return answer

    def row(self):
        low, high = min(self.counts), max(self.counts)
        return [
            f"{self.found} of {len(self.counts)}",
            f"{low} to {high}, {np.mean(self.counts):.2f}",
            f"{self.worst[0]:.1e}",
            f"{self.worst[1]:.1e}",
            f"{1e3 * np.median(self.seconds):.2f}",
            self.method,
        ]


HEADINGS = ["arm", "q found", "solutions, mean", "worst m", "worst rad", "ms", "how"]


def six(count):
    print(f"## 1. Six turning joints, {count} random poses each\n")
    rows = []
    for name, arm in arms(6).items():
        tally, rng = Tally(arm), np.random.default_rng(1)
        for q in random_q(arm, rng, count):
            tally.ask(q)
        rows.append([name, *tally.row()])
        for q in tally.missed:
            sizes = np.linalg.svd(arm.jacobian(q))[1]
            print(f"missed: {name}, singular values {sizes[0]:.2g} to {sizes[-1]:.2g}", flush=True)
    table(HEADINGS, rows)


def seven(count):
    print(f"## 2. Seven turning joints, {count} random poses each\n")
    from dhlab.inverse.redundancy import joint_to_hold

    rows, alone = [], []
    for name, arm in arms(7).items():
        tally, joint = Tally(arm), joint_to_hold(arm)
        others = {"nothing stated": {}, "nothing stated, limits kept": {"limits": True}}
        solved = dict.fromkeys(others, 0)
        seconds = {word: [] for word in others}
        for q in random_q(arm, np.random.default_rng(2), count, within=True):
            tally.ask(q, redundancy={joint + 1: q[joint]})
            for words, conditions in others.items():
                start = time.perf_counter()
                answer = arm.solve(arm.forward(q), **conditions)
                seconds[words].append(time.perf_counter() - start)
                good = answer and answer.residuals.max() <= ALLOWED
                solved[words] += bool(good and (not conditions or answer.within_limits.all()))
        rows.append([f"{name}, joint {joint + 1} stated", *tally.row()])
        alone += [
            [name, words, f"{solved[words]} of {count}", f"{1e3 * np.median(seconds[words]):.2f}"]
            for words in others
        ]
    table(HEADINGS, rows)
    table(["arm", "conditions", "solved", "ms"], alone)


def by_search(count):
    print(f"## 3. Every arm by search, as without the extra, {count} poses each, as one batch\n")
    rows = []
    for name in dh.robots():
        arm = dh.load(name)
        q = random_q(arm, np.random.default_rng(3), count, within=len(arm) > 6)
        T = arm.forward(q)
        start = time.perf_counter()
        answers = arm.solve(T, method="search")
        seconds = (time.perf_counter() - start) / count
        met = sum(distance(arm, row, a.q) < MET for row, a in zip(q, answers, strict=True))
        worst = np.max([a.residuals.max(axis=0) for a in answers if a], axis=0)
        rows.append(
            [
                name,
                arm.table.joints,
                f"{sum(map(bool, answers))} of {count}",
                f"{met} of {count}" if len(arm) <= 6 else "",
                f"{np.mean([len(a) for a in answers]):.2f}",
                f"{worst[0]:.1e}",
                f"{worst[1]:.1e}",
                f"{1e3 * seconds:.1f}",
            ]
        )
    headings = ["arm", "joints", "solved", "q found", "solutions", "worst m", "worst rad", "ms"]
    table(headings, rows)


def out_of_reach(count):
    print(f"## 4. {count} poses that no arm can reach\n")
    rng, rows = np.random.default_rng(4), []
    for title, cases in (
        ("farther than all links end to end", never_within_reach(rng, count // 2)),
        ("wrist centre up to 1 cm out of reach", just_out_of_reach(rng, count // 4)),
        ("orientation alone", wrong_orientation(rng, count - count // 2 - count // 4)),
    ):
        solved, told, gap, seconds, kinds = 0, 0, 0.0, [], {}
        for arm, T, expected, short in cases:
            start = time.perf_counter()
            answer = arm.solve(T, limits=bool(arm.table.prismatic.any()))
            reason, nearest = (None, None) if answer else (answer.reason, answer.nearest)
            seconds.append(time.perf_counter() - start)
            solved += bool(answer)
            if reason is None:
                continue
            kinds[reason.kind] = kinds.get(reason.kind, 0) + 1
            told += reason.kind in expected and nearest is not None
            if short is not None:
                gap = max(gap, abs(reason.short - short))
        said = ", ".join(f"{kind} {number}" for kind, number in sorted(kinds.items()))
        ms = f"{1e3 * np.median(seconds):.0f}"
        rows.append([title, len(cases), solved, f"{told} of {len(cases)}", said, f"{gap:.1e}", ms])
    headings = [
        "poses",
        "number",
        "called solved",
        "told so",
        "reasons",
        "error of the exact distance (m)",
        "ms",
    ]
    table(headings, rows)


def singular(count):
    print(f"## 5. Singular poses, {count} of each kind: wrist straight (q5 = 0), all at 0\n")
    rows = []
    for name, arm in arms(6).items():
        rng, met, family, solved, worst = np.random.default_rng(5), 0, 0, 0, np.zeros(2)
        q = random_q(arm, rng, count)
        q[:, 4] = -arm.table.theta[4] * arm.sign[4]
        q[-1] = 0
        for row in q:
            answer = arm.solve(arm.forward(row))
            solved += bool(answer)
            family += any(answer.families)
            met += belongs(arm, row, answer)
            if answer:
                worst = np.maximum(worst, answer.residuals.max(axis=0))
        rows.append(
            [
                name,
                f"{solved} of {count}",
                family,
                f"{met} of {count}",
                f"{worst[0]:.1e}",
                f"{worst[1]:.1e}",
            ]
        )
    headings = [
        "arm",
        "solved",
        "told of a family",
        "q met, or in a family",
        "worst m",
        "worst rad",
    ]
    table(headings, rows)


def belongs(arm, q, answer):
    """Whether q is a solution, or one of a family that was told: alike in the joints that stay."""
    for found, moving in zip(answer.q, answer.families, strict=True):
        stays = [i for i in range(len(arm)) if i + 1 not in moving]
        apart = np.abs((found - q + np.pi) % (2 * np.pi) - np.pi)[stays]
        if apart.max(initial=0.0) < (1e-4 if moving else MET):
            return True
    return False


def limited(count):
    print(f"## 6. Limits kept, {count} poses from within the limits\n")
    rows = []
    for name in dh.robots():
        arm = dh.load(name)
        if arm.limits is None or len(arm) != 6:
            continue
        tally, broken = Tally(arm), 0
        for q in random_q(arm, np.random.default_rng(6), count, within=True):
            answer = tally.ask(q, limits=True)
            broken += int((~answer.within_limits).sum())
        rows.append([name, *tally.row()[:2], broken])
    table(["arm", "q found", "solutions, mean", "outside the limits"], rows)


def toolbox(count):
    if find_spec("roboticstoolbox") is None:
        print("## 7. Robotics Toolbox is not installed: not compared\n")
        return
    from inverse_toolbox import compared

    print(f"## 7. Beside Robotics Toolbox, {count} random poses each, in turns\n")
    table(*compared(count, random_q, distance, MET))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="few poses and arms")
    parser.add_argument("--prepare", action="store_true", help="derive the general arms first")
    parser.add_argument("--poses", type=int, default=1000)
    parser.add_argument("--only", type=int, nargs="*", help="numbers of the tables wanted")
    chosen = parser.parse_args()
    count = 20 if chosen.quick else chosen.poses
    print(f"# Inverse kinematics\n\nssik is {'' if find_spec('ssik') else 'not '}installed.\n")
    if chosen.prepare:
        for name, arm in arms(6).items():
            if needs_preparation(arm):
                start = time.perf_counter()
                prepare(arm)
                print(f"Prepared {name} in {time.perf_counter() - start:.0f} s.\n", flush=True)
    parts = [
        (six, count),
        (seven, count),
        (by_search, max(10, count // 5)),
        (out_of_reach, 40 if chosen.quick else 500),
        (singular, max(10, count // 20)),
        (limited, max(10, count // 5)),
        (toolbox, max(10, count // 5)),
    ]
    for number, (part, size) in enumerate(parts, 1):
        wanted = chosen.only or ([1, 2, 3, 4, 5, 6] if chosen.quick else range(1, 8))
        if number in wanted:
            part(size)


if __name__ == "__main__":
    main()
