"""How well the doctor reads axis sheets: one mistake in a point, a direction or a sense, on arms of
six and of five axes, as a Markdown table.

    python benchmarks/axes.py                    # 300 mistakes, seen and kept halves; minutes
    python benchmarks/axes.py --draws 2          # fewer
    python benchmarks/axes.py --half seen --missed

The kept half has seeds of its own, and was not looked at while the search was made.
"""

import argparse
import time
import warnings

import numpy as np
from scipy.spatial.transform import Rotation

import dhlab as dh

NOISE = (1e-3, np.deg2rad(0.2))
POSES = 10
SIX = ("ur5e", "ar4", "irb120", "jaco6", "kr6_r700", "puma560", "xarm6")
FIVE = ("irb120", "puma560", "kr6_r700")  # without their fourth axis: waist to pitch and roll
KINDS = ("point", "direction", "sense")
SHOWS = 5  # σ, at one pose at least


def sheet_of(name, without=None):
    """The axes and the end pose of an arm of the library, at q = 0."""
    arm = dh.load(name)
    frames = arm.frames(np.zeros(len(arm)))
    of_joint = frames[:-1] if arm.table.convention == "standard" else frames[1:]
    axes = [
        (frame[:3, 3], frame[:3, 2] * sign)
        for k, (frame, sign) in enumerate(zip(of_joint, arm.sign))
        if k != without
    ]
    return axes, arm.forward(np.zeros(len(arm)))


def mistaken(axes, kind, rng):
    """The sheet with one mistake, the joint from 1, and what is wrong: metres (3,), rad or None."""
    axes, i = [list(axis) for axis in axes], int(rng.integers(len(axes)))
    p, z = axes[i]
    if kind == "point":
        off = np.zeros(3)
        across = [k for k in range(3) if abs(z[k]) < 0.9]
        off[rng.choice(across)] = rng.choice([-1, 1]) * rng.uniform(0.005, 0.05)
        axes[i][0], amount = p + off, -(off - z * (off @ z))
    elif kind == "direction":
        side = np.cross(z, rng.normal(size=3))
        amount = rng.uniform(np.deg2rad(1), np.deg2rad(15))
        axes[i][1] = Rotation.from_rotvec(amount * side / np.linalg.norm(side)).apply(z)
    else:
        axes[i][1], amount = -z, None
    return axes, i + 1, amount


def forward(axes, end, q):
    """The poses by SciPy's rotations alone: no product of the library."""
    poses = []
    for values in q:
        T = end
        for (p, z), value in reversed(list(zip(axes, values))):
            R = Rotation.from_rotvec(value * np.asarray(z)).as_matrix()
            motion = np.eye(4)
            motion[:3, :3], motion[:3, 3] = R, p - R @ p
            T = motion @ T
        poses.append(T)
    return np.array(poses)


def measured(axes, end, q, rng):
    """What would be measured."""
    T = forward(axes, end, q)
    T[:, :3, 3] += rng.normal(0, NOISE[0], (len(q), 3))
    T[:, :3, :3] = (
        T[:, :3, :3] @ Rotation.from_rotvec(rng.normal(0, NOISE[1], (len(q), 3))).as_matrix()
    )
    return T


def shows(right, wrong, end, q):
    """Whether the mistake moves a pose by 5 σ."""
    A, B = forward(right, end, q), forward(wrong, end, q)
    shift = np.linalg.norm(A[:, :3, 3] - B[:, :3, 3], axis=1) / NOISE[0]
    turn = Rotation.from_matrix(np.swapaxes(A[:, :3, :3], 1, 2) @ B[:, :3, :3]).magnitude()
    return max(shift.max(), (turn / NOISE[1]).max()) >= SHOWS


def judged(answer, wrong, joint, kind, amount):
    """Whether the right axis was named, with the right kind, and the amount within 3 σ of what the
    poses can tell."""
    if answer.verdict != "explained":
        return False, False, False
    finding = answer.findings[0]
    axis, named = finding.joint == joint, finding.joint == joint and finding.parameter == kind
    if not named or kind == "sense":
        return axis, named, named
    p, z, _ = answer.sheet.axes[joint - 1]
    if kind == "point":
        off = p - wrong[joint - 1][0]
        return axis, named, np.linalg.norm(off - z * (off @ z) - amount) < 3 * NOISE[0]
    angle = np.arccos(np.clip(z @ wrong[joint - 1][1], -1, 1))
    return axis, named, abs(angle - amount) < 3 * NOISE[1]


def run(half, draws, noise):
    """Counts by kind, seconds, what was missed, and how many right sheets agreed."""
    arms = [(name, sheet_of(name)) for name in SIX]
    arms += [(f"{name} without axis 4", sheet_of(name, 3)) for name in FIVE]
    counts, seconds, missed = {kind: np.zeros(4, int) for kind in KINDS}, [], []
    agreed = [0, 0]
    for number, (name, (axes, end)) in enumerate(arms):
        for draw in range(draws):
            rng = np.random.default_rng([half == "kept", number, draw])
            q = rng.uniform(-2, 2, (POSES, len(axes)))
            answer = dh.diagnose_axes(axes, end, q, measured(axes, end, q, rng), noise=noise)
            agreed = [agreed[0] + 1, agreed[1] + (answer.verdict == "agrees")]
            for kind in KINDS:
                while True:
                    wrong, joint, amount = mistaken(axes, kind, rng)
                    q = rng.uniform(-2, 2, (POSES, len(axes)))
                    if shows(axes, wrong, end, q):
                        break
                poses = measured(axes, end, q, rng)
                begun = time.process_time()
                answer = dh.diagnose_axes(wrong, end, q, poses, noise=noise)
                seconds.append(time.process_time() - begun)
                found = judged(answer, wrong, joint, kind, amount)
                counts[kind] += [1, *found]
                if not all(found):
                    missed.append((name, kind, joint, amount, answer))
    return counts, seconds, missed, agreed


def main():
    """The whole benchmark, or a part of it."""
    warnings.simplefilter("ignore")
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--draws", type=int, default=5, help="for each arm, kind and half")
    parser.add_argument("--half", choices=["seen", "kept", "both"], default="both")
    parser.add_argument("--noise", choices=["stated", "estimated"], default="stated")
    parser.add_argument("--missed", action="store_true")
    options = parser.parse_args()
    noise = NOISE if options.noise == "stated" else None
    print("| half | mistake in the | cases | right axis | right kind | amount within 3 σ |")
    print("|---|---|---|---|---|---|")
    for half in ("seen", "kept") if options.half == "both" else (options.half,):
        counts, seconds, missed, agreed = run(half, options.draws, noise)
        for kind, (cases, *good) in [*counts.items(), ("all", sum(counts.values()))]:
            shares = " | ".join(f"{count / cases:.1%}" for count in good)
            print(f"| {half} | {kind} | {cases} | {shares} |", flush=True)
        print(f"right sheets: {agreed[0]}, of which agree: {agreed[1]}")
        print(f"seconds: median {np.median(seconds):.2f}, worst {max(seconds):.2f}")
        for name, kind, joint, amount, answer in missed if options.missed else ():
            print("   missed", name, kind, "axis", joint, amount, answer, sep="  ")


if __name__ == "__main__":
    main()
