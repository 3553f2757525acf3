"""Zero offsets from 30 noisy poses against those put in: errors, and whether the stated uncertainty
is honest. Prints Markdown.
"""

import argparse
import time

import numpy as np

from dhlab import load
from dhlab.measure import calibrate_offsets
from dhlab.transform import from_xyz_rpy

POSES, NOISE = 30, (1e-4, np.deg2rad(0.02))  # m, rad
# arm, data, base, tool, is the noise told, offsets up to (deg)
FIXED, BASE, BOTH = ("fixed", "fixed"), ("free", "fixed"), ("free", "free")
CASES = [
    ("article-6r", "positions", *FIXED, True, 2),
    ("article-6r", "positions", *FIXED, False, 2),
    ("article-6r", "positions", *BASE, True, 2),
    ("article-6r", "positions", *FIXED, True, 30),
    ("article-6r", "positions", *BASE, True, 30),
    ("article-6r", "poses", *FIXED, True, 30),
    ("article-6r", "poses", *FIXED, False, 30),
    ("article-6r", "poses", *BOTH, True, 30),
    ("ur5e", "positions", *BASE, True, 30),
    ("ur5e", "positions", *BOTH, True, 30),
    ("ur5e", "poses", *BOTH, True, 30),
    ("panda", "positions", *BASE, True, 30),
    ("panda", "poses", *BASE, False, 30),
    ("irb120", "positions", *FIXED, True, 30),
    ("irb120", "poses", *BASE, True, 30),
]
HEADINGS = (
    "arm",
    "data",
    "base / tool",
    "noise",
    "offsets",
    "not determined",
    "lost",
    "rms error, deg",
    "rms σ stated, deg",
    "inside 1σ",
    "inside 2σ",
    "largest, σ",
    "time",
)


def draw(arm, data, base, tool, told, largest, rng):
    """One measurement and its evaluation: errors (rad), standard deviations, residual after (m),
    and whether the offsets explain the data.
    """
    n = len(arm)
    q, wrong = rng.uniform(-2.5, 2.5, (POSES, n)), np.deg2rad(rng.uniform(-largest, largest, n))
    B = from_xyz_rpy(rng.uniform(-1, 1, 3), rng.uniform(-3, 3, 3)) if base == "free" else np.eye(4)
    E = (
        from_xyz_rpy(rng.uniform(-0.2, 0.2, 3), rng.uniform(-3, 3, 3))
        if tool == "free"
        else np.eye(4)
    )
    T = B @ arm.forward(q + arm.sign * wrong) @ E
    T[:, :3, 3] += NOISE[0] * rng.normal(size=(POSES, 3))
    T[:, :3, :3] = (
        T[:, :3, :3]
        @ from_xyz_rpy(np.zeros((POSES, 3)), NOISE[1] * rng.normal(size=(POSES, 3)))[:, :3, :3]
    )
    poses, noise = (T, NOISE) if data == "poses" else (T[:, :3, 3], NOISE[0])
    found = calibrate_offsets(arm, q, poses, noise=noise if told else None, base=base, tool=tool)
    return found.offsets - wrong, found.sigma, found.after.position


def case(name, data, base, tool, told, largest, draws, rng):
    arm, start = load(name), time.time()
    errors, sigmas, left = (
        np.array(part)
        for part in zip(*(draw(arm, data, base, tool, told, largest, rng) for _ in range(draws)))
    )
    lost = left > 5e-4  # another minimum, far from the noise
    known = np.isfinite(sigmas).all(axis=0)
    errors, sigmas = errors[~lost][:, known], sigmas[~lost][:, known]
    ratio = np.abs(errors) / sigmas
    hidden = ", ".join(str(i + 1) for i in np.flatnonzero(~known)) or "none"
    return [
        name,
        data,
        f"{base} / {tool}",
        "told" if told else "estimated",
        f"±{largest}°",
        hidden,
        f"{lost.sum()} of {draws}",
        f"{np.rad2deg(np.sqrt((errors**2).mean())):.4f}",
        f"{np.rad2deg(np.sqrt((sigmas**2).mean())):.4f}",
        f"{100 * (ratio < 1).mean():.1f} %",
        f"{100 * (ratio < 2).mean():.1f} %",
        f"{ratio.max():.1f}",
        f"{1000 * (time.time() - start) / draws:.0f} ms",
    ]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--draws", type=int, default=200)
    draws, rng = parser.parse_args().draws, np.random.default_rng(0)
    print(
        f"# Zero offsets from {POSES} poses, noise {1000 * NOISE[0]} mm and"
        f" {np.rad2deg(NOISE[1]):.2f}°, {draws} draws per line\n"
    )
    print("Right standard deviations put 68.3 % of the errors inside 1σ and 95.4 % inside 2σ.\n")
    print("| " + " | ".join(HEADINGS) + " |")
    print("|" + "---|" * len(HEADINGS))
    for line in CASES:
        print("| " + " | ".join(case(*line, draws, rng)) + " |", flush=True)


if __name__ == "__main__":
    main()
