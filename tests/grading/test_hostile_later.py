"""The attacks of ``corpus_calls.py`` in both cages with walls, among honest notebooks; those of
``around_people.py``; and values that an answer may be, judged by themselves.
"""

import re
import socket
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
import corpus
from around_people import PEOPLE
from corpus_calls import CALLED, HONEST_KINDS

from dhlab.grading.cage import cage
from dhlab.grading.grade import grade
from dhlab.grading.reports.publish import publish
from dhlab.grading.settings import Limits, Settings

LIMITS = Limits(cell_seconds=2.0, seconds=12.0, memory_mb=256, files_mb=8, threads=16)
CANARY = "canary-8086"


@pytest.fixture(scope="module", params=["bubblewrap", "landlock"])
def graded(request, tmp_path_factory):
    """(marks by student, the folder that they were written to, what came to a socket outside)."""
    try:
        cage.Cage(request.param).close()
    except ValueError:
        pytest.skip(f"{request.param} does not work on this machine")
    top = tmp_path_factory.mktemp(request.param)
    (top / "teacher.key").write_text(CANARY)
    facts = {"key": str(top / "teacher.key"), "class": str(top / "class")}
    makes = {f"a{k}": one[2] for k, one in enumerate(CALLED)}
    makes |= {f"h{k}": make for k, (_, make) in enumerate(HONEST_KINDS)}
    for name, make in makes.items():
        corpus.put(top / "class" / name, make, facts)
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as outside:
        outside.bind(facts["class"] + ".socket")
        outside.setblocking(False)
        settings = Settings(limits=LIMITS, cage=request.param)
        results, planned = grade(top / "class", top / "out", settings=settings)
        publish(planned, results, (), top / "out")
        try:
            came = outside.recv(100)
        except BlockingIOError:
            came = b""
    return {one.student: one for one in results}, top, came


def test_no_attack_earns_a_mark_or_gets_at_anything(graded):
    results, top, came = graded
    unfair = {}
    for k, (name, _, _, lost) in enumerate(CALLED):
        one = results[f"a{k}"]
        if lost != corpus.ANY and (one.status, corpus.lost(one)) != ("graded", set(lost)):
            unfair[name] = one.status, corpus.lost(one), one.notes
    assert not unfair
    assert came == b"" and (top / "teacher.key").read_text() == CANARY


def test_honest_notebooks_keep_their_marks(graded):
    results, _, _ = graded
    found = {name: corpus.lost(results[f"h{k}"]) for k, (name, _) in enumerate(HONEST_KINDS)}
    assert found == {name: set() for name, _ in HONEST_KINDS}


def test_nothing_of_its_own_or_of_the_grader_is_said_back(graded):
    results, _, _ = graded
    said = [" ".join((m.headline, m.place, m.next)) for one in results.values() for m in one.marks]
    assert len(said) > 50
    assert not [text for text in said if CANARY in text or re.search("0x[0-9a-f]{6}", text)]


@pytest.mark.parametrize("attack", [pytest.param(one, id=name) for name, one in PEOPLE])
def test_who_hands_in_harms_nobody(attack, tmp_path):
    attack(tmp_path)
