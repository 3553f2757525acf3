"""The picture of one joint moved alone: the measured circle against the table's."""

import numpy as np
import pytest

import dhlab as dh
from dhlab import view

ARM = dh.load("article-6r")
REST = np.array([0.5, 1.0, -1.4, -0.5, 0.7, 0.3])


def sweep(joint, m=13):
    q = np.tile(REST, (m, 1))
    q[:, joint - 1] = np.linspace(-1, 1, m)
    return q


def about(direction, through, radius_point, angles):
    """Points on a circle, by Rodrigues' formula: no arm in it."""
    n, r = np.asarray(direction, dtype=float), np.asarray(radius_point, dtype=float)
    c, s = np.cos(angles)[:, None], np.sin(angles)[:, None]
    return through + c * r + s * np.cross(n, r)


def test_measured_circle_is_drawn_where_it_was_put():
    q = sweep(2)
    n = np.array([0.6, -0.8, 0])
    points = about(n, [0.1, 0.2, 0.3], 0.4 * np.array([0.8, 0.6, 0]), q[:, 1])
    picture = view.circle(ARM, q, points)
    root, tip = picture.points["axis:measured axis"]
    assert np.allclose(root, [0.1, 0.2, 0.3]) and np.allclose(
        (tip - root) / np.linalg.norm(tip - root), n
    )
    assert all(
        np.allclose(picture.points[f"measured:{k + 1}"], point) for k, point in enumerate(points)
    )
    assert (
        "0.1, 0.2, 0.3" in picture.table
        and "400 mm about an axis along (0.6, -0.8, 0)" in picture.alt
        and "13 measured points" in picture.alt
    )


def test_the_tables_arc_begins_and_ends_where_the_arm_does():
    q = sweep(3)
    picture = view.circle(ARM, q, ARM.forward(q))
    arc = picture.points["model"]
    assert np.allclose(arc[[0, -1]], ARM.forward(q[[0, -1]])[:, :3, 3])
    assert (
        "differ by 0°" in picture.alt
        and "0 mm apart" in picture.alt
        and "Joint 3 moved alone" in picture.table
    )
    q = q[::-1]
    assert np.allclose(view.circle(ARM, q, ARM.forward(q)).points["model"][0], arc[-1])


def test_a_reversed_axis_points_the_other_way_in_picture_and_words():
    rows = ARM.table.rows
    rows[3, 3] *= -1
    wrong = dh.Arm(dh.DHTable.standard(rows, angle="rad"), name="wrong")
    q = sweep(5)
    picture = view.circle(wrong, q, ARM.forward(q), title="the cup")
    one, other = (
        np.diff(picture.points[f"axis:{name}"], axis=0)[0]
        for name in ("measured axis", "the table's axis")
    )
    assert np.allclose(one, -other) and "differ by 180°" in picture.alt
    assert next(text.get_text() for text in picture.figure.texts) == "the cup"


@pytest.mark.parametrize("joint", range(1, 6))
def test_no_circle_is_seen_from_its_edge(joint):
    from dhlab.view.pictures.circle import _camera

    q = sweep(joint)
    (axis,) = (circle.axis for circle in dh.fit_circles(q, ARM.forward(q), ARM).circles)
    assert abs(_camera(axis).toward @ axis) > 0.25


def test_what_is_no_single_sweep_is_refused():
    both = np.vstack([sweep(2), sweep(3)])
    for q, words in ((both, "joint 2, 3"), (sweep(6), "joint 6")):
        with pytest.raises(ValueError, match=words):
            view.circle(ARM, q, ARM.forward(q))
    with pytest.raises(ValueError, match="view.circle: expected an Arm"):
        view.circle(ARM.table, sweep(2), ARM.forward(sweep(2)))


def test_the_same_picture_is_the_same_bytes():
    q = sweep(4)
    once, twice = (view.circle(ARM, q, ARM.forward(q))._repr_mimebundle_() for _ in range(2))
    assert (
        once == twice
        and "<table" in once["text/html"]
        and "two circles as a table" in once["text/html"]
    )
