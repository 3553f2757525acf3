"""What the geometry room does, measured: frames from axes, equivalence, published pairs. ``python
benchmarks/geometry.py`` prints Markdown.
"""

import argparse
import sys
import time
import warnings
from collections import Counter, defaultdict
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))
from geometry_cases import (
    CHAINS,
    PUBLISHED,
    TRUE_CHANGES,
    chain_axes,
    chain_poses,
    exponentials,
    incomplete_recipes,
    moves,
    pose_error,
    random_arm,
    random_axes,
    random_pose,
    random_walk,
    read_chain,
    sampled_difference,
    true_change,
    with_rows,
)

import dhlab as dh
from dhlab.geometry.canonical import gaps, joint_axes
from dhlab.geometry.equivalence import equivalent
from dhlab.geometry.procedure.frames import NearlyParallelWarning, assign_frames

FREEDOMS = (("fixed", "fixed"), ("fixed", "free"), ("free", "fixed"), ("free", "free"))


def table(headings, rows):
    print("| " + " | ".join(headings) + " |")
    print("|" + "---|" * len(headings))
    for row in rows:
        print("| " + " | ".join(str(cell) for cell in row) + " |")
    print()


def chains(rng):
    print("## 1. URDF chains through assign_frames, 100 random q each (largest pose error)\n")
    rows, worst = [], [0.0, 0.0]
    for path in CHAINS:
        chain = read_chain(path)
        axes, end = chain_axes(chain)
        q = rng.uniform(-np.pi, np.pi, (100, len(axes)))
        T = chain_poses(chain, q)
        row = [path.stem, len(axes)]
        for convention in ("standard", "craig"):
            errors = pose_error(T, assign_frames(axes, end=end, convention=convention).forward(q))
            row += [f"{x:.1e}" for x in errors]
            worst = np.maximum(worst, errors)
        rows.append(row)
    rows.append(["**worst**", "", f"{worst[0]:.1e} m", f"{worst[1]:.1e} rad", "", ""])
    table(["chain", "joints", "standard m", "rad", "Craig m", "rad"], rows)


def walks(rng, count):
    print(f"## 2a. equivalent: {count} random arms × 12 random free moves\n")
    accepted, made, worst_pose, worst_gap, seconds = Counter(), Counter(), 0.0, [0.0, 0.0], 0.0
    for _ in range(count):
        arm = random_arm(rng)
        kinds, walked = random_walk(arm, rng)
        made.update(str(kind) for kind in kinds)
        worst_pose = max(worst_pose, sampled_difference(arm, walked, rng))
        worst_gap = np.maximum(
            worst_gap, [g.max() for g in gaps(joint_axes(arm), joint_axes(walked))]
        )
        for base, tool in FREEDOMS:
            B = random_pose(rng) @ walked.base if base == "free" else walked.base
            E = walked.tool @ random_pose(rng) if tool == "free" else walked.tool
            other = with_rows(walked, walked.table.rows, base=B, tool=E)
            start = time.perf_counter()
            accepted[base, tool] += bool(equivalent(arm, other, base=base, tool=tool))
            seconds += time.perf_counter() - start
    table(
        ["base", "tool", "walks", "accepted"], [(b, t, count, accepted[b, t]) for b, t in FREEDOMS]
    )
    print(
        f"Largest pose change along a walk (sampled): {worst_pose:.1e} (m + rad); largest gap"
        f" between axes that `equivalent` saw: {worst_gap[0]:.1e} rad, {worst_gap[1]:.1e} m"
        f" (tolerance 1e-9); {seconds / count / len(FREEDOMS) * 1000:.1f} ms per call.\n"
    )
    print(
        "Moves in these walks: "
        + ", ".join(f"{kind} {made[kind]}" for kind in sorted(made))
        + ".\n"
    )


def single_moves(rng, count):
    print(f"## 2b. Each free move by itself, on {count} random arms\n")
    tried, accepted, worst, named = Counter(), Counter(), defaultdict(float), Counter()
    for _ in range(count):
        arm = random_arm(rng)
        for kind, make in moves(arm, rng):
            try:
                other = make()
            except ValueError:  # this arm has no such freedom there
                continue
            result = equivalent(arm, other)
            tried[kind] += 1
            accepted[kind] += bool(result)
            named[kind] += bool(result.differences)
            worst[kind] = max(worst[kind], sampled_difference(arm, other, rng, count=4))
    table(
        [
            "move",
            "made",
            "accepted",
            "with the choice told in words",
            "largest pose change (m + rad)",
        ],
        [
            (kind, tried[kind], accepted[kind], named[kind], f"{worst[kind]:.1e}")
            for kind in sorted(tried)
        ],
    )


def true_changes(rng, count):
    print(
        f"## 2c. {count} random arms × 12 free moves and one true change (1e-6 to 1 m or rad): none"
        " may be accepted\n"
    )
    made, accepted, smallest, missed = Counter(), Counter(), {}, Counter()
    for _ in range(count):
        arm = random_arm(rng)
        _, walked = random_walk(arm, rng)
        for kind in TRUE_CHANGES:
            for size in (1e-6, 10 ** rng.uniform(-6, 0)):
                changed = true_change(walked, rng, kind, size)
                seen = sampled_difference(walked, changed, rng, count=6)
                smallest[kind] = min(smallest.get(kind, np.inf), seen)
                made[kind] += 1
                accepted[kind] += bool(equivalent(arm, changed))
            for base, tool in FREEDOMS[1:3]:
                seen = sampled_difference(walked, changed, rng, base, tool, count=6)
                missed[base, tool] += (seen > 1e-8) and bool(
                    equivalent(arm, changed, base=base, tool=tool)
                )
                missed[base, tool, "false alarm"] += (seen < 1e-11) and not equivalent(
                    arm, changed, base=base, tool=tool
                )
    table(
        ["entry changed", "made", "accepted", "smallest change of a sampled pose (m + rad)"],
        [(kind, made[kind], accepted[kind], f"{smallest[kind]:.1e}") for kind in TRUE_CHANGES],
    )
    table(
        ["base", "tool", "changed in sampled poses but accepted", "unchanged but refused"],
        [(b, t, missed[b, t], missed[b, t, "false alarm"]) for b, t in FREEDOMS[1:3]],
    )


def controls(rng):
    print("## 2d. Negative controls: incomplete recipes, 20 random tables each\n")
    made, accepted, smallest = Counter(), Counter(), {}
    for _ in range(20):
        n = rng.integers(4, 8)
        arm = dh.Arm(
            dh.DHTable.standard(
                rng.uniform([-3, 0.1, 0.1, 0.3], [3, 0.5, 0.5, 1.3], (n, 4)), angle="rad"
            )
        )
        for name, wrong in incomplete_recipes(arm, rng.integers(1, n)):
            made[name] += 1
            accepted[name] += bool(equivalent(arm, wrong))
            smallest[name] = min(smallest.get(name, np.inf), sampled_difference(arm, wrong, rng))
    table(
        ["recipe", "made", "accepted", "smallest pose change (m + rad)"],
        [(k, made[k], accepted[k], f"{smallest[k]:.2g}") for k in made],
    )


def published():
    print("## 3. Published pairs: verdict and words\n")
    rows = []
    for one, other, *_ in PUBLISHED:
        a, b = dh.load(one), dh.load(other)
        strict, loose = equivalent(a, b), equivalent(a, b, base="free", tool="free")
        rows.append(
            (
                f"{one} / {other}",
                "same" if strict else "different",
                "same" if loose else "different",
                strict.message,
                loose.message,
            )
        )
    table(
        [
            "tables",
            "as printed",
            "base and tool free",
            "words (as printed)",
            "words (base and tool free)",
        ],
        rows,
    )


def placements(rng, count):
    print(
        f"## 4. {count} random arms of 3 to 7 joints with special cases, placed by assign_frames"
        " (each in one convention at random)\n"
    )
    cases, failures, warned, lengths, worst = Counter(), 0, 0, [], [0.0, 0.0]
    for _ in range(count):
        axes, end, special = random_axes(rng)
        cases.update(
            [str(case) for case in special] + ["sliding joint" for axis in axes if axis[2] == "P"]
        )
        q = np.vstack([np.zeros(len(axes)), rng.uniform(-np.pi, np.pi, (3, len(axes)))])
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always", NearlyParallelWarning)
            try:
                arm = assign_frames(axes, end=end, convention=rng.choice(["standard", "craig"]))
            except Exception as error:  # counted and shown, whatever it is
                failures += 1
                print(f"failed: {type(error).__name__}: {error}\n")
                continue
        warned += bool(caught)
        errors = np.array(pose_error(exponentials(axes, end, q), arm.forward(q)))
        lengths.append((np.abs(arm.table.rows[:, 1:3]).max(), *errors))
        worst = np.maximum(worst, errors)
    longest, metres, _ = np.array(lengths).T
    table(
        [
            "placed",
            "failures",
            "largest error m",
            "rad",
            "with a warning",
            "largest length in a table m",
            "largest error ÷ longest length",
        ],
        [
            (
                count,
                failures,
                f"{worst[0]:.1e}",
                f"{worst[1]:.1e}",
                warned,
                f"{longest.max():.3g}",
                f"{(metres / np.maximum(longest, 1)).max():.1e}",
            )
        ],
    )
    print(
        "Cases: " + ", ".join(f"{case} {number}" for case, number in sorted(cases.items())) + ".\n"
    )


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--arms", type=int, default=1000, help="random arms of part 2")
    options.add_argument("--placements", type=int, default=10_000, help="random arms of part 4")
    options.add_argument("--seed", type=int, default=2024)
    chosen = options.parse_args()
    rng = np.random.default_rng(chosen.seed)
    print(f"# The geometry room (seed {chosen.seed})\n")
    chains(rng)
    walks(rng, chosen.arms)
    single_moves(rng, max(1, chosen.arms // 5))
    true_changes(rng, chosen.arms)
    controls(rng)
    published()
    placements(rng, chosen.placements)


if __name__ == "__main__":
    main()
