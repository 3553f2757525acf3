"""The picture of the condition number along a path."""

import numpy as np
import pytest

import dhlab as dh
from dhlab import view

ARM = dh.load("article-6r")
BENT = np.deg2rad([0, 40, -60, 50, 40, 0])


def path(arm, rest, joint, low, high, m=25):
    q = np.tile(np.asarray(rest, dtype=float), (m, 1))
    q[:, joint - 1] = np.linspace(low, high, m)
    return q


def by_differences(arm, q, h=1e-6):
    """The Jacobian from nothing but poses, and with it the condition number."""
    columns = []
    for k in range(len(q)):
        step = h * np.eye(len(q))[k]
        T, before, after = arm.forward(q), arm.forward(q - step), arm.forward(q + step)
        spin = (after - before)[:3, :3] / (2 * h) @ T[:3, :3].T
        columns.append([*(after - before)[:3, 3] / (2 * h), spin[2, 1], spin[0, 2], spin[1, 0]])
    sizes = np.linalg.svd(np.array(columns).T, compute_uv=False)
    return sizes[0] / sizes[-1]


def test_the_curve_is_the_condition_number_of_the_poses_derivative():
    q = path(ARM, BENT, 5, 0.2, 1.2, 7)
    curve = view.condition(ARM, q, 5).points["curve"]
    assert np.allclose(curve[:, 0], np.rad2deg(q[:, 4])) and np.allclose(
        curve[:, 1], [by_differences(ARM, row) for row in q], rtol=1e-4
    )


def test_a_singularity_is_said_drawn_and_tabled():
    picture = view.condition(ARM, path(ARM, BENT, 5, -1, 1), 5)
    assert "singular at joint 5 = 0°" in picture.alt and len(picture.points["curve"]) == 25
    row = next(line for line in picture.table.splitlines() if line.startswith(" 0 "))
    assert row.split() == ["0", "singular", "0", "5"]
    gids = [line.get_gid() for line in picture.figure.axes[0].lines]
    assert gids == ["curve", "singular"]


def test_a_path_without_singularity_says_where_it_comes_nearest():
    picture = view.condition(ARM, path(ARM, BENT, 5, 0.3, 1.0), 5, title="along the wrist")
    assert (
        "meets no singularity" in picture.alt
        and "highest" in picture.alt
        and "17.19°" in picture.alt
    )
    assert picture.figure.texts[
        0
    ].get_text() == "along the wrist" and "singular" not in picture.table.replace(
        "singular value", ""
    )


def test_sliding_joints_are_in_metres():
    arm = dh.load("stanford")
    picture = view.condition(arm, path(arm, [0.3, 0.7, 0.5, 0.4, 0.6, 0.2], 3, 0.3, 1.2), 3)
    assert "joint 3 (m)" in picture.table and "from 0.3 m to 1.2 m" in picture.alt


def test_what_does_not_fit_is_refused():
    q = path(ARM, BENT, 5, -1, 1)
    for wrong, joint, words in (
        (q, 0, "joint from 1 to 6"),
        (q, 4, "joint 4 to move"),
        (q[:1], 5, "two configurations"),
        (q[0], 5, "two configurations"),
    ):
        with pytest.raises(ValueError, match=words):
            view.condition(ARM, wrong, joint)
    with pytest.raises(ValueError, match="view.condition: expected an Arm"):
        view.condition(ARM.table, q, 5)
    with pytest.raises(ValueError, match="six joints or more"):
        cobra = dh.load("cobra600")
        view.condition(cobra, path(cobra, np.full(len(cobra), 0.4), 2, 0.1, 1), 2)


def test_the_same_picture_is_the_same_bytes():
    once, twice = (
        view.condition(ARM, path(ARM, BENT, 5, -1, 1), 5)._repr_mimebundle_() for _ in range(2)
    )
    assert once == twice and 'alt="' in once["text/html"] and "<table" in once["text/html"]
