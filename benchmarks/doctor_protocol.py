"""The tape-measure protocol: the end points at the eight poses it chooses, 4 mm noise, one mistake
at a time, as a Markdown table.

    python benchmarks/doctor_protocol.py    # every arm (about half an hour)
    python benchmarks/doctor_protocol.py --arms ur5e,panda --every 5

The poses are chosen with the wrong table, as its owner would. A mistake is visible when it moves
one of the points by 5 σ (20 mm); explained means that the repaired table is within 5 σ (rms) of the
truth at other poses.
"""

import argparse
import time
import warnings

import numpy as np
from doctor import ALIKE, LEFT_OUT, drawn_faults, explained, visible

import dhlab as dh
from dhlab.doctor import diagnose
from dhlab.doctor.arms.protocol import protocol

NOISE = (4e-3, 4e-3)


def measured(right, q, rng):
    """What a tape would show."""
    p = right.forward(q)[:, :3, 3]
    return p + rng.normal(0, NOISE[0], p.shape)


def singles(name, options, rng, missed):
    """Cases, explained, named right, seconds."""
    right, cases, good, named, times = dh.load(name), 0, 0, 0, []
    for mistake, wrong in list(drawn_faults(right, rng))[
        rng.integers(options.every) :: options.every
    ]:
        q = protocol(wrong, options.count).q
        if not visible(wrong, right, q, NOISE, True, False):
            continue
        begun = time.perf_counter()
        answer = diagnose(wrong, q, measured(right, q, rng), noise=NOISE)
        times.append(time.perf_counter() - begun)
        told = {f.mistake for f in answer.findings} | {
            a for f in answer.findings for a in f.look_alikes
        }
        told |= {ALIKE.get(other) for other in told}
        well = explained(answer, right, q, NOISE, True, False)
        cases, good, named = cases + 1, good + well, named + (mistake in told)
        if not well:
            missed.append((name, mistake, answer.verdict, [f.mistake for f in answer.findings]))
    return cases, good, named, times


def left_alone(name, options, rng):
    """Of how many right tables how many are called right."""
    right = dh.load(name)
    q = protocol(right, options.count).q
    verdicts = [
        diagnose(right, q, measured(right, q, rng), noise=NOISE).verdict
        for _ in range(options.right)
    ]
    return len(verdicts), sum(verdict in ("agrees", "calibrated") for verdict in verdicts)


def main():
    """A line per arm and their sum."""
    warnings.simplefilter("ignore")
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--arms", default=",".join(dh.robots()))
    parser.add_argument("--every", type=int, default=1, help="take every k-th mistake")
    parser.add_argument("--count", type=int, default=8, help="how many poses")
    parser.add_argument("--right", type=int, default=50, help="how many right tables per arm")
    parser.add_argument("--missed", action="store_true")
    options = parser.parse_args()
    rng, sums, all_times, missed = np.random.default_rng(11), np.zeros(5, int), [], []
    print(
        "| arm | visible mistakes | explained | named | median s | right tables | left alone"
        " |\n|---|---|---|---|---|---|---|"
    )
    for name in options.arms.split(","):
        cases, good, named, times = singles(name, options, rng, missed)
        row = np.array([cases, good, named, *left_alone(name, options, rng)])
        sums, all_times = sums + row, all_times + times
        _print(name + (" *" if name in LEFT_OUT else ""), row, times)
    _print("all", sums, all_times)
    if options.missed:
        for line in missed:
            print("   missed", *line)


def _print(title, row, times):
    cases, good, named, right, alone = row
    print(
        f"| {title} | {cases} | {good / max(cases, 1):.1%} | {named / max(cases, 1):.1%} |"
        f" {np.median(times or [0]):.2f} | {right} | {alone / max(right, 1):.1%} |",
        flush=True,
    )


if __name__ == "__main__":
    main()
