"""Attacks on the grader, written with its code open, and controls, in both cages with walls: none
may earn a mark, read what is not its own, stop the class or harm a neighbour.

    python benchmarks/hostile.py                # bubblewrap, landlock
    python benchmarks/hostile.py --level rlimits   # protects nobody; only what does no harm is run
    python benchmarks/hostile.py --only pipes      # those with this word in their name

Each attack is (name, what it tries, how the solved notebook of lesson 05 is changed, which
exercises it may not earn: ANY when it may only harm itself). One that gets at something answers
05.2 wrongly, so that the marks tell. ``tests/grading/corpus.py`` has 130 older ones, and
``tests/grading/around.py`` those that need no program: on zips, names, pages and exports.
"""

import argparse
import contextlib
import os
import socket
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).parents[1]
sys.path[:0] = [str(ROOT / "tests" / "grading")]
import corpus  # noqa: E402
from around import AROUND  # noqa: E402
from around_people import PEOPLE  # noqa: E402
from corpus import ANY  # noqa: E402
from corpus_calls import CALLED, HONEST_KINDS  # noqa: E402
from corpus_honest import HONEST  # noqa: E402
from corpus_inside import INSIDE  # noqa: E402
from hostile_company import COMPANY  # noqa: E402
from hostile_earn import EARN  # noqa: E402
from hostile_read import READ  # noqa: E402
from hostile_stop import STOP  # noqa: E402

from dhlab.grading.cage.cage import Cage  # noqa: E402
from dhlab.grading.grade import grade  # noqa: E402
from dhlab.grading.reports.publish import publish  # noqa: E402
from dhlab.grading.settings import Limits, Settings  # noqa: E402

LIMITS = Limits(cell_seconds=2.0, seconds=12.0, memory_mb=256, files_mb=8, threads=16)
CANARY = "canary-8086"
APART = 5  # an honest notebook after so many attacks
ATTACKS = [*EARN, *COMPANY, *READ, *STOP, *INSIDE, *CALLED]
# not run where nothing protects the machine: they signal others or take its room
HARMFUL = {
    "a signal by way of an open file",
    "the same by the older way",
    "a million empty files",
    "many files of half the size",
    "a folder that cannot be removed",
    "threads that work",
    "files without a name",
    "a file in another's place",
    "room without a size",
    "a folder that cannot be listed",
    "deeper than a path",
    "memory in pipes",
    "rights by the newest calls",
    "outlives the grader",
    "a letter to the machine",
    "flags of a file",
    "a core for the machine",
    "cut off by an older kernel",
    "threads without number",
}


def run(level, top, attacks):
    """(unfair marks, honest students who lost something, leaks) of the class in one cage."""
    (top / "class").mkdir()
    for name in ("teacher.key", "marks.json"):
        (top / name).write_text(f"GRADER_SECRET {CANARY}", encoding="utf-8")
    facts = {"key": str(top / "teacher.key"), "class": str(top / "class")}
    for number, (_, _, make, _) in enumerate(attacks):
        corpus.put(top / "class" / f"attack{number:02d}", make, facts)
        if number % APART == 0:
            corpus.put(top / "class" / f"honest{number:02d}", corpus.as_solved, facts)
    for number, (_, make) in enumerate([*HONEST, *HONEST_KINDS]):
        corpus.put(top / "class" / f"honest-{number}", make, facts)
    os.environ["GRADER_SECRET"] = CANARY
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as outside:
        outside.bind(facts["class"] + ".socket")
        settings = Settings(limits=LIMITS, cage=level)
        results, planned = grade(top / "class", top / "out", settings=settings)
    publish(planned, results, (), top / "out")
    found = {graded.student: graded for graded in results}
    unfair = [
        f"{name}: {one.status}, lost {sorted(corpus.lost(one))}; {'; '.join(one.notes)[:200]!r}"
        for number, (name, _, _, lost) in enumerate(attacks)
        if not _fair(one := found[f"attack{number:02d}"], lost)
    ]
    harmed = [
        f"{g.student} {sorted(corpus.lost(g))}"
        for g in results
        if g.student.startswith("honest") and g.points != g.of
    ]
    slow = {
        attacks[int(g.student[6:])][0]: round(g.seconds)
        for g in results
        if g.student.startswith("attack") and g.seconds > 2 * 6 * LIMITS.seconds
    }
    return unfair, harmed, _leaks(top / "out"), slow


def _leaks(out):
    """Files that hold what only the grader knows, or what a terminal obeys."""
    found = []
    for path in (one for one in out.rglob("*") if one.is_file()):
        text = path.read_text(encoding="utf-8")
        if CANARY in text or "\x1b" in text or "\\u001b" in text:
            found.append(path.name)
    return found


def _fair(graded, lost):
    if lost == ANY:
        return 0 <= graded.points <= graded.of
    found = corpus.lost(graded)  # who loses more by an attack has done that alone
    return graded.status == "graded" and (set(lost) <= found if lost else not found)


def around():
    """Those that need no program: each says what happened where it should not."""
    failed = 0
    attacks = [*AROUND, *PEOPLE]
    for name, attack in attacks:
        begun = time.process_time()
        with tempfile.TemporaryDirectory() as top:
            try:
                attack(Path(top))
            except Exception as error:  # whatever stops the grader stops the class
                failed += 1
                print(f"  got through: {name}: {type(error).__name__}: {str(error)[:300]}")
        print(f"    {name}: {time.process_time() - begun:.1f} s", flush=True)
    print(f"around: {len(attacks) - failed} of {len(attacks)} attacks came to nothing")


def main():
    known = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    known.add_argument("--level", action="append", choices=["bubblewrap", "landlock", "rlimits"])
    known.add_argument("--only", default="")
    asked = known.parse_args()
    if not asked.only:
        around()
    for level in asked.level or ["bubblewrap", "landlock"]:
        try:
            Cage(level).close()
        except ValueError as error:
            print(f"{level}: {error}")
            continue
        attacks = [one for one in ATTACKS if asked.only in one[0]]
        if level == "rlimits":
            attacks = [one for one in attacks if one[0] not in HARMFUL]
        with tempfile.TemporaryDirectory() as top:
            unfair, harmed, leaks, slow = run(level, Path(top), attacks)
        print(f"{level}: {len(attacks) - len(unfair)} of {len(attacks)} attacks came to nothing")
        print(*(f"  got through, or cost too much: {line}" for line in unfair), sep="\n")
        print(f"  honest students who lost something: {harmed or 'none'}; leaks: {leaks or 'none'}")
        print(f"  longer than a student may take: {slow or 'none'}", flush=True)


if __name__ == "__main__":
    with contextlib.suppress(KeyboardInterrupt):
        main()
