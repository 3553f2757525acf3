"""Joint variables: their zeros, their senses, whose they are, and joints that slide."""

import numpy as np

from ..changes import SLIDING, ArmChange, JointChange, RowChange, Slip, scaled
from ..registry import OFFSET, SENSE, mistake
from ..remade import THETA, with_parts, with_rows

DEG = 180 / np.pi


# ---- zeros


@mistake("offset-missing", preference=OFFSET)
def offset_missing():
    yield RowChange(scaled(theta=0), "theta", reading="")


@mistake("offset-sign", preference=OFFSET)
def offset_sign():
    yield RowChange(scaled(theta=-1), "theta", reading="")


@mistake("offset-subtracted")
def offset_subtracted():
    yield JointChange(lambda n: -np.eye(n), reading="")


@mistake("offset-counted-twice")
def offset_counted_twice():
    yield RowChange(scaled(theta=2), "theta", reading="")


@mistake("offset-in-degrees")
def offset_in_degrees():
    yield RowChange(scaled(theta=DEG), "theta", reading="", within=1e-3 * DEG)


@mistake("offset-on-wrong-joint")
def offset_on_wrong_joint():
    yield ArmChange(_offset_moved, "theta", twice=True)


def _offset_moved(arm):
    """The offset of each row added to its neighbour's; moved back, it is where it was."""
    for i in range(len(arm)):
        for k in (i - 1, i + 1):
            if 0 <= k < len(arm) and arm.table.theta[i]:
                rows = arm.table.rows
                rows[k, THETA] += rows[i, THETA]
                rows[i, THETA] = 0
                place = f"it belongs to row {i + 1}, you have it in row {k + 1}"
                yield i + 1, place, with_rows(arm, rows)


# ---- senses


@mistake("joint-reversed", preference=SENSE, value_of=("sign",))
def joint_reversed():
    yield ArmChange(_each_sense, "sign", twice=True)


def _each_sense(arm):
    for i in range(len(arm)):
        turned = arm.sign * np.where(np.arange(len(arm)) == i, -1, 1)
        yield i + 1, "", with_parts(arm, sign=turned)


@mistake("all-joints-left-handed")
def all_joints_left_handed():
    def make(arm):
        yield None, "", with_parts(arm, sign=-arm.sign)
        yield None, "", with_rows(arm, arm.table.rows * [-1, 1, 1, 1], sign=-arm.sign)

    yield ArmChange(make, "sign", twice=True)
    yield Slip("reading", "", lambda rows, q: (rows * [-1, 1, 1, 1], -q))


@mistake("other-hand")
def other_hand():
    """Mirrored in the plane of x and z, turns about x and z change their sign and shifts stay."""

    def make(arm):
        sense = np.where(arm.table.prismatic, 1, -1)
        yield None, "", with_rows(arm, arm.table.rows * [-1, 1, 1, -1], sign=arm.sign * sense)

    yield ArmChange(make, "sign", twice=True)


# ---- whose value it is


@mistake("joint-values-unused")
def joint_values_unused():
    yield JointChange(lambda n: np.zeros((n, n)), reading="")


@mistake("theta-unused")
def theta_unused():
    yield RowChange(scaled(theta=0), rows=(), argument="")


@mistake("joint-index-off-by-one")
def joint_index_off_by_one():
    rows = {1: "the row before", -1: "the row after"}
    measured = {1: "q is one place off, the other way", -1: "q is one place off"}
    for step, row in rows.items():
        yield JointChange(_rolled(step), f"the q of {row}", measured[step])
    for step, row in rows.items():
        yield JointChange(lambda n, step=step: np.eye(n, k=-step), f"the q of {row}")
    for k in (0, -1):
        yield JointChange(lambda n, k=k: np.eye(n)[[k] * n], "the same q for all rows")
    yield JointChange(lambda n: np.eye(n)[::-1], "the order of q is turned round")
    for step, row in rows.items():
        yield Slip("reading", f"{row}, with this joint's q", _rows_rolled(step))


def _rolled(step):
    return lambda n: np.roll(np.eye(n), step, axis=0)


def _rows_rolled(step):
    return lambda rows, q: (np.roll(rows, step, axis=-2), q)


@mistake("one-row-for-all-joints")
def one_row_for_all_joints():
    for k, name in ((-1, "last"), (0, "first")):
        yield Slip(
            "reading", f"the {name} row", lambda rows, q, k=k: (0 * rows + rows[..., [k], :], q)
        )
        yield Slip("reading", f"d, a and alpha of the {name} row", _lent(k))


def _lent(row):
    """d, a and alpha of one row for all."""

    def change(rows, q):
        return np.concatenate([rows[..., :1], 0 * rows[..., 1:] + rows[..., [row], 1:]], axis=-1), q

    return change


@mistake("joints-summed")
def joints_summed():
    yield JointChange(_sums, "", "q holds angles against the base")
    yield Slip("reading", "offsets too", _offsets_summed)
    yield JointChange(
        lambda n: np.linalg.inv(_sums(n)),
        "the other way: differences of q",
        "q was taken as a running sum",
    )


def _sums(n):
    return np.tril(np.ones((n, n)))


def _offsets_summed(rows, q):
    sums = np.cumsum(rows[..., 0] + q, axis=-1)
    return np.concatenate([0 * rows[..., :1], rows[..., 1:]], axis=-1), sums


@mistake("joints-coupled", value_of=("coupling",))
def joints_coupled():
    yield ArmChange(_coupled_otherwise, "coupling", undo=_coupled_back, only="arm")


def _coupled_otherwise(arm):
    """Each coupling left out, counted twice, with the wrong sign; and one where there is none."""
    C = _coupling(arm)
    for j, k in _pairs(arm):
        for value in (0.0, 2 * C[j, k], -C[j, k]) if C[j, k] else (1.0, -1.0):
            yield j + 1, "", _with_coupling(arm, j, k, value)


def _coupled_back(arm):
    """What takes these back; a coupling that is twice what it should be is halved."""
    C = _coupling(arm)
    for j, k in _pairs(arm):
        for value in (0.0, -C[j, k], C[j, k] / 2, 2 * C[j, k]) if C[j, k] else (1.0, -1.0):
            yield _with_coupling(arm, j, k, value), ()


def _coupling(arm):
    return np.eye(len(arm)) if arm.coupling is None else arm.coupling


def _pairs(arm):
    """(joint, what moves it too), from 0: the joint before, or the one before that as in a wrist
    that two motors drive; and whatever the arm itself couples.
    """
    C, joints, n = _coupling(arm), arm.table.joints, len(arm)
    for j in range(n):
        for k in range(n):
            usual = (k == j - 1 and j >= 1) or (k == j - 2 and j >= 2)
            if j != k and joints[j] == joints[k] and (usual or C[j, k]):
                yield j, k


def _with_coupling(arm, j, k, value):
    """The arm with one number of its coupling changed; None where nothing is coupled any more."""
    C = _coupling(arm).copy()
    C[j, k] = value
    return with_parts(arm, coupling=None if np.array_equal(C, np.eye(len(arm))) else C)


# ---- sliding joints


@mistake("prismatic-variable-in-theta")
def prismatic_variable_in_theta():
    def undo(arm):
        yield from ((right, ()) for _, _, right in _relettered(arm, "RP"))

    yield ArmChange(lambda arm: _relettered(arm, "P"), undo=undo)
    yield ArmChange(lambda arm: _relettered(arm, "R"), only="typed")


def _relettered(arm, letters):
    """Each joint of these letters made one of the other letter."""
    joints = arm.table.joints
    for i, letter in enumerate(joints):
        if letter in letters:
            other = joints[:i] + {"P": "R", "R": "P"}[letter] + joints[i + 1 :]
            yield i + 1, f"row {i + 1}", with_rows(arm, arm.table.rows, joints=other)


@mistake("prismatic-constant-lost")
def prismatic_constant_lost():
    yield RowChange(scaled(theta=0), "theta", rows=(SLIDING,))
    yield RowChange(scaled(d=0), "d", rows=(SLIDING,))
    yield RowChange(scaled(theta=0, d=0), rows=(), typed=(SLIDING,))
