"""Tables of small arms that the library does not hold, wrong in the ways of people who build them;
every headline and every place must be true of the case. Poses are products of elementary moves.
"""

import numpy as np
import pytest
from oracles import elementary_pose
from scipy.spatial.transform import Rotation

import dhlab as dh
from dhlab.doctor import diagnose

HOBBY = [
    [0, 0.095, 0.012, 90],
    [90, 0, 0.127, 0],
    [0, 0, 0.018, 90],
    [0, 0.141, 0, -90],
    [0, 0, 0, 90],
    [0, 0.083, 0, 0],
]
SCARA = [[0, 0.21, 0.225, 0], [0, 0, 0.175, 180], [0, 0.05, 0, 0], [0, 0.03, 0, 0]]


def table(rows, joints=None):
    return dh.DHTable.standard(rows, angle="deg", joints=joints or "R" * len(rows))


def measured(right, seed, m=8):
    """Joint values, and poses with 0.5 mm and 0.1° of noise."""
    rng = np.random.default_rng(seed)
    q = rng.uniform(-1.8, 1.8, (m, len(right)))
    slides = right.prismatic
    q[:, slides] = rng.uniform(0, 0.15, (m, int(slides.sum())))
    T = np.array([elementary_pose(right, one) for one in q])
    T[:, :3, 3] += rng.normal(0, 5e-4, (m, 3))
    turn = Rotation.from_rotvec(rng.normal(0, np.deg2rad(0.1), (m, 3))).as_matrix()
    T[:, :3, :3] = T[:, :3, :3] @ turn
    return q, T


def with_numbers(rows, changes):
    rows = [list(row) for row in rows]
    for (i, column), value in changes.items():
        rows[i][column] = value
    return rows


@pytest.mark.parametrize(
    "changes",
    [
        {(0, 3): -90, (1, 2): -0.127},  # two signs
        {(1, 2): 0.138, (2, 0): 90},  # a length and a zero
    ],
)
def test_two_numbers_that_no_one_mistake_changes_are_two_mistakes(changes):
    q, T = measured(table(HOBBY), 1)
    answer = diagnose(table(with_numbers(HOBBY, changes)), q, T)
    assert answer.headline.startswith("Two mistakes together")
    said = {(f.joint - 1, ("theta", "d", "a", "alpha").index(f.parameter)) for f in answer.findings}
    assert said == set(changes)


@pytest.mark.parametrize("factor", [1 / 25.4, 25.4, 1 / 2.54])  # mm or cm and inches
def test_inches_beside_millimetres_are_one_unit(factor):
    q, T = measured(table(HOBBY), 2)
    rows = np.array(HOBBY) * [1, factor, factor, 1]
    answer = diagnose(table(rows), q, T)
    assert answer.findings[0].mistake == "length-unit" and len(answer.findings) == 1
    assert answer.after[0] < 4


def test_the_place_is_the_number_that_the_words_tell():
    right = with_numbers(SCARA, {(3, 1): 0.09})  # 60 mm more: row 4's own d twice, too
    q, T = measured(table(right, "RRPR"), 3)
    (finding,) = diagnose(table(SCARA, "RRPR"), q, T).findings
    assert finding.place == f"row {finding.joint}, d" and finding.detail.startswith("is ")


@pytest.mark.parametrize("seed", [77, 289])  # of 400, those that scatter most
def test_an_unlucky_right_table_is_not_said_to_be_wrong(seed):
    right = table(SCARA, "RRPR")
    q, T = measured(right, seed)
    answer = diagnose(right, q, T, budget=0.5)
    assert answer.verdict in ("agrees", "undecided") and "sure to be wrong" in answer.headline


@pytest.mark.parametrize("order", [[1, 0, 2], [0, 2, 1]])
def test_three_points_whose_columns_are_exchanged_are_no_base_that_is_turned(order):
    q, T = measured(table(HOBBY), 4, m=3)
    answer = diagnose(table(HOBBY), q, T[:, order, 3], noise=5e-4)
    assert answer.findings[0].mistake == "columns-misread"


def test_half_a_turn_is_not_told_from_itself():
    right = table(SCARA, "RRPR")
    q, T = measured(right, 5)
    mirror = np.diag([1, -1, 1])
    T[:, :3, :3], T[:, 1, 3] = mirror @ T[:, :3, :3] @ mirror, -T[:, 1, 3]
    (finding,) = diagnose(right, q, T).findings
    assert finding.mistake == "other-hand" and "alpha" not in finding.detail
