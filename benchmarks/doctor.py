"""How well the doctor does: faults drawn over the catalogue on every arm of the library, as a
Markdown table.

    python benchmarks/doctor.py                  # everything (a good half hour)
    python benchmarks/doctor.py --draws 3 --arms ur5e,panda --only 1,2

Arms marked * were left out while the search was being tuned.
"""

import argparse
import time
import warnings
from dataclasses import replace

import numpy as np
from scipy.spatial.transform import Rotation

import dhlab as dh
from dhlab.doctor import diagnose
from dhlab.doctor.arms.search.fitting import misfit
from dhlab.doctor.arms.search.measured import Measured
from dhlab.doctor.mistakes.faults import faults
from dhlab.doctor.mistakes.remade import with_rows
from dhlab.transform import rot_x, rot_y, rot_z, trans

LEFT_OUT = ("kr6_r700", "cobra600", "xarm6", "ur10_cb", "puma560")
NOISE = (1e-3, np.deg2rad(0.2))


def drawn_faults(arm, rng):
    """Every fault of the catalogue at every place, with values drawn for those that have one."""
    yield from ((f.mistake, f.arm) for f in faults(arm))
    for i in range(len(arm)):
        for column in (1, 2):
            if arm.table.rows[i, column]:
                rows = arm.table.rows
                rows[i, column] *= 1 + rng.choice([-1, 1]) * rng.uniform(0.05, 0.3)
                yield "length-value", with_rows(arm, rows)
        rows = arm.table.rows
        rows[i, 0] += rng.choice([-1, 1]) * rng.uniform(0.1, 1)
        yield "offset-missing", with_rows(arm, rows)
    tool = (
        trans(rng.uniform(-0.15, 0.15, 3)) @ rot_x(rng.uniform(-1, 1)) @ rot_y(rng.uniform(-1, 1))
    )
    yield "tool-missing", replace(arm, tool=arm.tool @ tool)
    yield "base-turned", replace(arm, base=rot_z(rng.uniform(0.3, 3)) @ arm.base)
    yield (
        "base-height-missing-or-twice",
        replace(arm, base=trans([0, 0, rng.uniform(0.05, 0.5)]) @ arm.base),
    )


# the same entry and the same repair: whether the number has a reason decides the word
ALIKE = {"offset-value": "offset-missing", "alpha-value": "alpha-sign"}


def measure(arm, rng, m, noise, positions=False, free=False):
    """Random general q and what would be measured there."""
    q = rng.uniform(-2.5, 2.5, (m, len(arm)))
    q = np.where(arm.table.prismatic, np.abs(q) / 5, q)
    T = arm.forward(q)
    if free:
        T = trans(rng.uniform(-1, 1, 3)) @ rot_z(rng.uniform(-3, 3)) @ rot_x(rng.uniform(-3, 3)) @ T
    T = T.copy()
    if noise:
        T[:, :3, 3] += rng.normal(0, noise[0], (m, 3))
        T[:, :3, :3] = (
            T[:, :3, :3] @ Rotation.from_rotvec(rng.normal(0, noise[1], (m, 3))).as_matrix()
        )
    return q, T[:, :3, 3] if positions else T


def visible(wrong, right, q, noise, positions, free):
    """Whether the fault changes one of the poses by 5 σ (1e-6 without noise), through the best base
    when it is free.
    """
    T = right.forward(q)
    level = noise or (2e-7, 2e-7)
    sample = Measured(q, T[:, :3, 3], None if positions else T[:, :3, :3], level, free)
    r = sample.residual(misfit(wrong, sample).arm.forward(q))
    size = np.linalg.norm(r.reshape(len(q), -1, 3), axis=2)
    return size.max() >= 5


def explained(answer, right, q, noise, positions, free):
    """Whether the repaired arm is the right one: to 1e-6 without noise, within 5 σ at other poses
    with noise.
    """
    if answer.verdict != "explained" or answer.findings[0].repair is None:
        return False
    repair = answer.findings[0].repair
    fresh = np.random.default_rng(9).uniform(-2.5, 2.5, (20, len(right)))
    fresh = np.where(right.table.prismatic, np.abs(fresh) / 5, fresh)
    T, level = right.forward(fresh), noise or (2e-7, 2e-7)
    sample = Measured(fresh, T[:, :3, 3], None if positions else T[:, :3, :3], level, free)
    r = sample.residual(misfit(repair, sample).arm.forward(fresh))
    return np.sqrt((r**2).mean()) < 5


def run(title, arms, draws, *, m, noise, positions=False, free=False, pair=False, every=1):
    """One line of the table: share explained, share named right, time."""
    rng, counts, times, missed = np.random.default_rng(7), {}, [], {}
    for name in arms:
        right = dh.load(name)
        for _ in range(draws):
            q, poses = measure(right, rng, m, noise, positions, free)
            cases = list(drawn_faults(right, rng))
            if pair:
                cases = [_pair(right, cases, rng) for _ in range(pair)]
            for mistake, wrong in cases[::every]:
                if not visible(wrong, right, q, noise, positions, free):
                    continue
                begun = time.perf_counter()
                answer = diagnose(wrong, q, poses, noise=noise, base="free" if free else "fixed")
                times.append(time.perf_counter() - begun)
                told = {f.mistake for f in answer.findings} | {
                    a for f in answer.findings for a in f.look_alikes
                }
                told |= {ALIKE.get(name) for name in told}
                good = explained(answer, right, q, noise, positions, free)
                named = bool(told & set(mistake.split(" + ")))
                row = counts.setdefault(name in LEFT_OUT, [0, 0, 0])
                row[0], row[1], row[2] = row[0] + 1, row[1] + good, row[2] + named
                if not (good and named):
                    missed.setdefault((mistake, answer.verdict, good), []).append(name)
    for left_out, (total, good, named) in sorted(counts.items()):
        print(
            f"| {title}{' *' if left_out else ''} | {total} | {good / total:.2%} |"
            f" {named / total:.2%} | {np.median(times):.2f} | {max(times):.2f} |",
            flush=True,
        )
    return missed


def _pair(right, cases, rng):
    """Two faults, one made after the other."""
    first, wrong = cases[rng.integers(len(cases))]
    more = list(drawn_faults(wrong, rng))
    second, both = more[rng.integers(len(more))]
    return f"{first} + {second}", both


def alarms(arms, draws):
    """Right tables with noise, calibrated arms, garbage: what is said of them."""
    rng, said = np.random.default_rng(8), {}
    for k in range(draws):
        right = dh.load(arms[k % len(arms)])
        q, poses = measure(right, rng, 10, NOISE)
        _count(said, "right table, noise", diagnose(right, q, poses, noise=NOISE))
    for k in range(draws // 2):
        right = dh.load(arms[k % len(arms)])
        n = len(right)
        off = rng.normal(0, 1, (n, 4)) * [np.deg2rad(0.05), 5e-4, 5e-4, np.deg2rad(0.05)]
        real = with_rows(right, right.table.rows + off)
        for title, noise in (("calibrated arm, noise", NOISE), ("calibrated arm, no noise", None)):
            q, poses = measure(real, rng, 10, noise)
            _count(said, title, diagnose(right, q, poses, noise=noise))
    for k in range(draws // 5):
        right = dh.load(arms[k % len(arms)])
        q, poses = measure(right, rng, 10, NOISE)
        _count(said, "garbage", diagnose(right, rng.permutation(q), poses, noise=NOISE))
    for title, verdicts in said.items():
        total = sum(verdicts.values())
        print(
            f"| {title} | {total} | "
            + ", ".join(f"{v} {c / total:.1%}" for v, c in sorted(verdicts.items()))
            + " |",
            flush=True,
        )


def _count(said, title, answer):
    verdicts = said.setdefault(title, {})
    verdicts[answer.verdict] = verdicts.get(answer.verdict, 0) + 1


def main():
    """The whole benchmark, or a part of it."""
    warnings.simplefilter("ignore")
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--draws", type=int, default=1)
    parser.add_argument("--arms", default=",".join(dh.robots()))
    parser.add_argument("--only", default="1,2,3,4,5,6,7")
    parser.add_argument("--every", type=int, default=1, help="take every k-th fault")
    parser.add_argument("--pairs", type=int, default=20, help="pairs per arm and draw")
    parser.add_argument("--missed", action="store_true")
    options = parser.parse_args()
    arms, only = options.arms.split(","), options.only.split(",")
    print("| what | cases | explained | named | median s | worst s |\n|---|---|---|---|---|---|")
    lines = {
        "1": ("singles, exact, 10 poses", {"m": 10, "noise": None, "every": options.every}),
        "2": (
            "singles, 1 mm and 0.2°, 10 poses",
            {"m": 10, "noise": NOISE, "every": options.every},
        ),
        "3": (
            "singles, positions, base free, 1 mm, 20 poses",
            {"m": 20, "noise": NOISE, "positions": True, "free": True, "every": options.every},
        ),
        "4": ("pairs, 1 mm and 0.2°, 10 poses", {"m": 10, "noise": NOISE, "pair": options.pairs}),
        "6": (
            "pairs, positions, 1 mm, 20 poses",
            {"m": 20, "noise": NOISE, "positions": True, "pair": options.pairs},
        ),
        "7": (
            "pairs, positions, base free, 1 mm, 20 poses",
            {"m": 20, "noise": NOISE, "positions": True, "free": True, "pair": options.pairs},
        ),
    }
    for key, (title, settings) in lines.items():
        if key in only:
            missed = run(title, arms, options.draws, **settings)
            if options.missed:
                for what, where in sorted(missed.items(), key=lambda item: -len(item[1])):
                    print("   missed", what, len(where), where[:4])
    if "5" in only:
        print("\n| what | cases | verdicts |\n|---|---|---|")
        alarms(arms, 200 * options.draws)


if __name__ == "__main__":
    main()
