"""Wrong tables: each is told, by a mistake that gives the same arm."""

import numpy as np
import pytest
from draws import few

import dhlab as dh
from dhlab.doctor import catalogue, explain_rows
from dhlab.doctor.tables.rows import wrong_tables


@pytest.mark.slow
@pytest.mark.parametrize("name", few(dh.robots(), 6))
def test_every_wrong_table_is_explained(name):
    right = dh.load(name)
    q = np.random.default_rng(2).uniform(0.2, 1.3, (5, len(right)))
    ids = set()
    for mistake, place, table in wrong_tables(right.table):
        arm = dh.Arm(table, right.base, right.tool, sign=right.sign)
        if mistake in ids or np.allclose(arm.forward(q), right.forward(q), rtol=0, atol=1e-8):
            continue
        ids.add(mistake)
        assert explain_rows(arm, right, q) is not None, (mistake, place)
    assert len(ids) >= 10 and ids <= catalogue().keys()


def test_slips_of_placing_frames_have_their_names():
    right = dh.Arm(
        dh.DHTable.standard(
            [
                [20, 0.1, 0.2, 90],
                [30, -0.2, 0.4, 0],
                [-90, 0.3, -0.1, 50],
                [10, 0.1, 0, 180],
                [0, 0.2, 0.1, -90],
            ],
            angle="deg",
            joints="RRRPR",
        )
    )
    q = np.random.default_rng(3).uniform(0.2, 1.3, (5, 5))

    def named(change):
        rows = right.table.rows
        change(rows)
        return explain_rows(
            dh.Arm(dh.DHTable.standard(rows, angle="rad", joints="RRRPR")), right, q
        ).mistake

    def flipped(rows):
        rows[2, 2:] *= -1

    def absolute(rows):
        rows[:, 1:3] = abs(rows[:, 1:3])

    def parallel(rows):
        rows[3, 3] = 0

    def twice(rows):
        rows[1, 1] = rows[2, 1] = 0.1

    assert (named(flipped), named(absolute), named(parallel), named(twice)) == (
        "x-flip-incomplete",
        "lengths-made-positive",
        "antiparallel-taken-for-parallel",
        "parallel-offset-in-both-rows",
    )
