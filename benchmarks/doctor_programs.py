"""How many wrong programs the doctor names, how many right ones it leaves alone, and how long it
takes.

Run ``python benchmarks/doctor_programs.py`` from the project's top folder. The programs and what is
wrong with each stand in ``tests/doctor/wrong_programs.py``; they were written, with their
expectations, before the doctor was run on them, and the doctor was then improved on them. Those of
``unseen_programs.py`` came after and were not used to improve it. Of the sixty of
``fresh_programs.py``, by another hand, every second one was used: the share of the others is the
honest one.
"""

import sys
import time
from pathlib import Path

import numpy as np

import dhlab.doctor.programs.functions as functions

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "doctor" / "programs"))
from fresh_programs import PROGRAMS
from unseen_programs import UNSEEN
from wrong_programs import KINDS, RIGHT, WRONG, program

from dhlab.doctor import catalogue


def diagnosed(kind, text):
    """The diagnosis of a program run anew, and the seconds it took."""
    f = program(kind, text)
    start = time.perf_counter()
    answer = functions.diagnose_function(f, kind)
    return answer, time.perf_counter() - start


def named(answer, expected):
    """Whether one of the mistakes is the first finding or its look-alike; and whether all are
    named. "|" stands between equally good names.
    """
    found = [_id(finding.mistake) for finding in answer.findings]
    alike = {found[0], *map(_id, answer.findings[0].look_alikes)} if found else set()
    wanted = [set(map(_id, names.split("|"))) for names in expected]
    return any(names & alike for names in wanted), all(
        names & (set(found) | alike) for names in wanted
    )


def _id(name):
    return catalogue()[name].id if name in catalogue() else name


def count(name, programs, times):
    """Print the shares of one collection, and what was missed."""
    groups, missed = {1: [0, 0, 0], 2: [0, 0, 0]}, []
    for kind, expected, text in programs:
        answer, seconds = diagnosed(kind, text)
        times.append(seconds)
        first, every = named(answer, expected)
        groups[len(expected)] = [
            old + new for old, new in zip(groups[len(expected)], (1, first, every))
        ]
        if not every:
            missed.append((kind, expected, answer))
    print(
        f"{name}, one mistake:  {groups[1][1]} of {groups[1][0]} named right (first finding or its"
        " look-alike)"
    )
    print(
        f"{name}, two mistakes: {groups[2][1]} of {groups[2][0]} with one of the two as first"
        f" finding, {groups[2][2]} with both named"
    )
    for kind, expected, answer in missed:
        print(
            "  missed:",
            kind,
            *expected,
            "->",
            answer.verdict,
            *(finding.mistake for finding in answer.findings),
            "|",
            answer.headline,
        )


def main():
    # what is computed once is computed now
    functions.diagnose_function(lambda theta, d, a, alpha: np.eye(4), "dh_transform")
    times = []
    count("corpus", WRONG, times)
    count("unseen", UNSEEN, times)
    fresh = [(KINDS[kind], ids.split(" + "), text) for kind, ids, text in PROGRAMS]
    count("fresh, used", fresh[::2], times)
    count("fresh, kept", fresh[1::2], times)
    alarms = [
        (kind, answer)
        for kind, text in RIGHT
        for answer in [diagnosed(kind, text)[0]]
        if answer.verdict != "agrees"
    ]
    print(f"right programs: {len(alarms)} false alarms in {len(RIGHT)}")
    for kind, answer in alarms:
        print("  false alarm:", kind, answer)
    print(
        f"time: median {1000 * np.median(times):.0f} ms, worst {1000 * max(times):.0f} ms on this"
        " machine; machines differ"
    )


if __name__ == "__main__":
    main()
