"""The attacks of ``corpus_inside.py`` in both cages with walls, among honest notebooks that do odd
things for a reason: marks fair, nothing leaked.
"""

import os
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
import corpus
from corpus_honest import HONEST
from corpus_inside import INSIDE
from draws import few

from dhlab.grading.grade import grade
from dhlab.grading.reports.publish import publish
from dhlab.grading.settings import Limits, Settings

LIMITS = Limits(cell_seconds=0.9, seconds=12.0, memory_mb=256, files_mb=8, threads=16)
# these take long and hurt nobody else; benchmarks/hostile.py runs them
LONG = {"stops itself", "a tracer over the room", "twenty thousand cells"}
ATTACKS = [one for one in INSIDE if one[0] not in LONG]
MOST = {"bubblewrap": len(INSIDE), "landlock": 12}  # all where marks are given
CANARY = "canary-8086"


@pytest.fixture(scope="module", params=["bubblewrap", "landlock"])
def graded(request, tmp_path_factory):
    """(marks by student, the folder that they were written to, the attacks)."""
    top = tmp_path_factory.mktemp(request.param)
    (top / "teacher.key").write_text(CANARY)
    facts = {"key": str(top / "teacher.key"), "class": str(top / "class")}
    attacks = few(ATTACKS, MOST[request.param])
    makes = {f"a{k}": one[2] for k, one in enumerate(attacks)}
    makes |= {f"h{k}": make for k, (_, make) in enumerate(HONEST)}
    for name, make in makes.items():
        corpus.put(top / "class" / name, make, facts)
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("GRADER_SECRET", CANARY)
        settings = Settings(limits=LIMITS, cage=request.param)
        try:
            results, planned = grade(top / "class", top / "out", settings=settings)
        except ValueError as error:
            if "expected the cage" not in str(error):
                raise
            pytest.skip(f"{request.param} does not work on this machine")
        if (
            request.param == "bubblewrap"
        ):  # what is shown depends on what was found, not on the cage
            publish(planned, results, (), top / "out")
    return {one.student: one for one in results}, top, attacks


def test_no_attack_earns_a_mark_or_gets_at_anything(graded):
    results, top, attacks = graded
    unfair = {}
    for k, (name, _, _, lost) in enumerate(attacks):
        one = results[f"a{k}"]
        fair = lost == corpus.ANY or one.status == "graded"
        if lost != corpus.ANY:
            fair &= set(lost) <= corpus.lost(one) if lost else not corpus.lost(one)
        if not fair:
            unfair[name] = one.status, corpus.lost(one), one.notes
    assert not unfair
    assert not os.listxattr(top / "teacher.key")


def test_honest_notebooks_keep_their_marks(graded):
    results, _, _ = graded
    found = {name: corpus.lost(results[f"h{k}"]) for k, (name, _) in enumerate(HONEST)}
    assert found == {name: set() for name, _ in HONEST}


def test_nothing_leaks_and_no_cursor_moves(graded):
    _, top, _ = graded
    for path in (one for one in (top / "out").rglob("*") if one.is_file()):
        text = path.read_text(encoding="utf-8")
        assert CANARY not in text and "\x1b" not in text and "\\u001b" not in text, path
