"""Programs written for this by somebody who has not seen the doctor: of how many the mistakes are
told, how many right ones are left alone, and how long it takes.

Run ``python benchmarks/programs_fresh.py FOLDER`` from the project's top folder. In the folder
stand programs NNN.py, each with NNN.yaml: ``kind`` (dh_transform, forward_kinematics, or arm for
one that knows its table), ``convention``, ``right``, ``mistakes`` with ``family``, ``line``,
``now`` and ``fixed``, and ``arm`` for the last kind.

A mistake counts as told by the lines when its line is told, or when the lines that are told make
the program right, by a product of links that is not dhlab's. It counts as named where the doctor
explains the answers with as many findings as there are mistakes, or with one and the line of
another: whether these truly are the mistakes that were made is read by a person, for whom they are
printed. A line is false when its change does not make the program right.
"""

import math
import sys
import time
from pathlib import Path

import numpy as np
from programs_corpus import YAML_READER, loaded

import dhlab as dh

NAMES = {"dh_transform": "dh_transform"}  # the function that a kind has; forward_kinematics else
SIZES = (3, 1, 7, 4, 2)  # rows of the chains that an edited program is tried with


def product(rows, q, joints, craig):
    """The product of the links, each of four elementary moves."""
    T = np.eye(4)
    for (theta, d, a, alpha), letter, value in zip(rows, joints, q):
        z = _move(theta + value * (letter == "R"), d + value * (letter == "P"), 0, 1, 2)
        x = _move(alpha, a, 1, 2, 0)
        T = T @ x @ z if craig else T @ z @ x
    return T


def _move(angle, shift, i, j, k):
    """A turn in the plane of axes i and j, and a shift along axis k."""
    T = np.eye(4)
    c, s = math.cos(angle), math.sin(angle)
    T[i, i], T[i, j], T[j, i], T[j, j], T[k, 3] = c, -s, s, c, shift
    return T


def arm_of(truth):
    """The arm that a program is for; None where it is for any."""
    given = truth.get("arm")
    if given is None:
        return None
    made = dh.DHTable.craig if truth["convention"] == "craig" else dh.DHTable.standard
    table = made(given["rows"], angle="rad", joints=given["joints"])
    return dh.Arm(table, base=given["base"], tool=given["tool"], sign=given["sign"])


def calls_of(truth):
    """Arguments and right answers that the doctor does not know."""
    rng, craig = np.random.default_rng(31), truth["convention"] == "craig"
    given = truth.get("arm")
    for n in SIZES:
        if given is not None:
            ends = [np.eye(4) if given[end] is None else given[end] for end in ("base", "tool")]
            q = rng.uniform(-3, 3, given["n"])
            chain = product(given["rows"], q * given["sign"], given["joints"], craig)
            yield (q,), np.array(ends[0]) @ chain @ np.array(ends[1])
            continue
        rows = rng.uniform(-3, 3, (n, 4)) * [1, 0.2, 0.2, 1]
        q = rng.uniform(-3, 3, n)
        if truth["kind"] == "dh_transform":
            yield tuple(rows[0]), product(rows[:1], [0], "R", craig)
        else:
            yield (rows, q), product(rows, q, "R" * n, craig)


def is_right(text, truth):
    """Whether an edited program gives the right poses."""
    space = {"__name__": "learner"}
    try:
        exec(compile(text, "<edited>", "exec"), space)
        f = space[NAMES.get(truth["kind"], "forward_kinematics")]
        return all(
            np.allclose(np.array(f(*case), float), right, atol=1e-6)
            for case, right in calls_of(truth)
        )
    except Exception:
        return False


def judged(path):
    """What is wrong with a program; how many of its mistakes are told by lines, and how many with
    findings too; whether a line is false; the seconds; the diagnosis.
    """
    truth = YAML_READER.load(path.with_suffix(".yaml").read_text())
    name = NAMES.get(truth["kind"], "forward_kinematics")
    f = getattr(loaded(path), name)
    start = time.process_time()
    answer = dh.diagnose_function(f, name, arm=arm_of(truth), convention=truth["convention"])
    seconds = time.process_time() - start
    if truth["right"]:
        return truth, int(bool(answer)), int(bool(answer)), False, seconds, answer
    told = {line.number for line in answer.lines}
    mended = bool(answer.repaired) and is_right(answer.repaired, truth)
    lines = sum(mended or mistake["line"] in told for mistake in truth["mistakes"])
    halves = sum(note.startswith("The other one stands in line") for note in answer.notes)
    named = max(lines, len(answer.findings) + halves) if answer.verdict == "explained" else lines
    return truth, lines, named, bool(answer.lines) and not mended, seconds, answer


def main():
    counts, times, false = {}, [], 0
    for path in sorted(Path(sys.argv[1]).glob("[0-9]*.py")):
        truth, lines, named, untrue, seconds, answer = judged(path)
        wanted = max(1, len(truth["mistakes"]))
        many = "right" if truth["right"] else f"{wanted} wrong"
        for group in ((truth["kind"], many), ("all", many)):
            counts.setdefault(group, []).append((lines >= wanted, named >= wanted))
        times.append(seconds)
        false += untrue
        if lines < wanted or untrue or seconds > 2:
            print(f"{path.name} {truth['kind']} {many}, {seconds:.1f} s", "FALSE LINE" * untrue)
            for mistake in truth["mistakes"]:
                print(f"   made: line {mistake['line']}, {mistake['family']}")
            print("   told:", "\n         ".join(str(answer).splitlines()))
    print(f"\n{'kind':20} {'programs':9} {'of':>3} {'by lines':>9} {'named or by lines':>18}")
    for (kind, many), told in sorted(counts.items()):
        by_lines, named = np.sum(told, axis=0)
        print(f"{kind:20} {many:9} {len(told):3} {by_lines:9} {named:18}")
    print(f"lines told whose change does not help: {false}")
    print(f"processor time: median {np.median(times):.2f} s, worst {max(times):.2f} s")


if __name__ == "__main__":
    main()
