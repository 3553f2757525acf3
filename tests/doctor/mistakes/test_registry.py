"""One mistake has one home: its words in the catalogue, what it does in one function; and what that
function says of taking it back is true.
"""

import ast
from collections import defaultdict
from pathlib import Path

import numpy as np
import pytest

import dhlab
from dhlab.doctor import catalogue
from dhlab.doctor.mistakes.changes import ALL, ArmChange, JointChange, RowChange, Symptom
from dhlab.doctor.mistakes.faults import faults, repairs
from dhlab.doctor.mistakes.registry import changes, mistake, only_seen, value_mistake

DOCTOR = Path(dhlab.__file__).parent / "doctor"
REGISTERED = {change.mistake for change in changes()}
ARMS = ("ar4", "article-6r", "cobra600", "panda", "stanford")
# what a call shows is told where functions are called; other programs of the course have lists
# of wrong versions of their own
ELSEWHERE = {
    "programs/running/answers.py",
    "programs/running/calling.py",
    "programs/compared.py",
    "programs/search/ends.py",
    "programs/explain.py",
}


def _ids_in(path):
    """The ids in a module's text constants, docstrings left out."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    shown = {
        node.body[0].value
        for node in ast.walk(tree)
        if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef))
        and node.body
        and isinstance(node.body[0], ast.Expr)
    }
    return {
        node.value
        for node in ast.walk(tree)
        if isinstance(node, ast.Constant) and node not in shown and node.value in REGISTERED
    }


def test_every_mistake_that_does_something_has_its_words():
    assert len(REGISTERED) > 60
    assert [name for name in REGISTERED if name not in catalogue()] == []
    assert all(catalogue()[name].id == name for name in REGISTERED)


def test_a_mistake_stands_in_one_module():
    found = defaultdict(set)
    for path in DOCTOR.rglob("*.py"):
        name = path.relative_to(DOCTOR).as_posix()
        if name not in ELSEWHERE and not name.startswith("programs/wrong/"):
            for id in _ids_in(path):
                found[id].add(name)
    assert set(found) == REGISTERED
    assert {id: names for id, names in found.items() if len(names) > 1} == {}


def test_a_second_function_for_one_mistake_is_refused():
    def pose_inverted():
        yield from ()

    pose_inverted.__module__ = "dhlab.doctor.mistakes.themes.poses"
    with pytest.raises(ValueError, match="expected one function, found two"):
        mistake("pose-inverted")(pose_inverted)
    pose_inverted.__module__ = "dhlab.doctor.mistakes.elsewhere"
    with pytest.raises(ValueError, match="add it there"):
        mistake("a-new-one")(pose_inverted)


@pytest.mark.parametrize(
    "change",
    [c for c in changes(RowChange) if c.undone is not None and c.undo is None],
    ids=lambda c: f"{c.mistake}-{c.place}",
)
def test_a_change_of_rows_is_taken_back(change):
    row = tuple(np.random.default_rng(1).uniform(-2, 2, (4, 5)))
    wrong = change.change(*row)
    np.testing.assert_allclose(change.undone(*wrong), row, rtol=1e-12)
    np.testing.assert_allclose(change.change(*change.undone(*row)), row, rtol=1e-12)


@pytest.mark.slow
@pytest.mark.parametrize("name", ARMS)
def test_what_takes_an_arm_s_mistake_back_gives_its_poses(name):
    """Of every change that says how it is undone, on the wrong arm, one repair moves as the right
    arm does; entries that are left to be fitted are filled in from the right table.
    """
    arm = dhlab.load(name)
    q = np.random.default_rng(2).uniform(0.2, 1.3, (4, len(arm)))
    right, tried = arm.forward(q), set()
    for fault in faults(arm):
        change = fault.change
        if not isinstance(change, ArmChange) or not (change.undo or change.twice):
            continue
        tried.add(fault.mistake)
        assert any(
            np.allclose(_filled(repaired, free, arm).forward(q), right, atol=1e-9)
            for repaired, free in change.taken_back(fault.arm)
        ), (fault.mistake, fault.place)
    assert {"joint-reversed", "all-joints-left-handed", "x-flip-incomplete"} <= tried


def _filled(repaired, free, arm):
    rows = repaired.table.rows
    for entry in free:
        rows[entry] = arm.table.rows[entry]
    table = dhlab.DHTable(repaired.table.convention, *rows.T, repaired.table.joints)
    return dhlab.Arm(table, repaired.base, repaired.tool, sign=repaired.sign)


@pytest.mark.parametrize("name", ARMS)
def test_repairs_undo_what_all_rows_share(name):
    arm = dhlab.load(name)
    for fault in faults(arm):
        change = fault.change
        if isinstance(change, RowChange) and fault.row == 0 and change.undone and not change.undo:
            assert any(
                repaired.table.convention == arm.table.convention
                and np.allclose(repaired.table.rows, arm.table.rows, atol=1e-12)
                for repaired, _ in repairs(fault.arm)
            ), (fault.mistake, fault.place)


@pytest.mark.parametrize("name", ARMS)
def test_a_typed_table_changes_in_nothing_else(name):
    arm = dhlab.load(name)
    wrong = list(faults(arm, typed=True))
    assert len({fault.mistake for fault in wrong}) >= 15
    for fault in wrong:
        assert fault.arm.table != arm.table and fault.place is not None
        assert all(
            np.array_equal(getattr(fault.arm, part), getattr(arm, part))
            for part in ("base", "tool", "sign")
        )


def test_joint_values_that_were_measured_can_be_given_back():
    told = [change for change in changes(JointChange) if change.measured is not None]
    assert len(told) >= 5
    for change in told:
        for n in (2, 3, 7):
            assert np.linalg.cond(change.matrix(n)) < 1e3


def test_every_number_has_a_name_when_it_is_only_wrong():
    names = {
        what: value_mistake(what)
        for what in ("theta", "d", "a", "alpha", "sign", "tool", "base turn", "base shift")
    }
    assert set(names.values()) <= REGISTERED and len(set(names.values())) == 7
    assert only_seen("not-rigid") and not only_seen("alpha-sign")
    assert {change.mistake for change in changes(Symptom)} <= REGISTERED


def test_whole_tables_are_put_into_words():
    assert all(
        change.place == "" or change.place.startswith("all ")
        for change in changes(RowChange)
        if ALL in change.rows
    )
