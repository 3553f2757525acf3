"""The picture of one arm in both conventions, against frames multiplied out without dhlab's
kinematics.
"""

import numpy as np
import pytest
from draws import few
from oracles import shift, turn

import dhlab as dh
from dhlab import view

ROWS = dh.load("article-6r").table.rows
Q = np.deg2rad([-10, 50, -40])
THREE = dh.Arm(dh.DHTable.standard(ROWS[:3], angle="rad"), name="three joints")


def far_and_near_ends(rows, q):
    """The plates on the far ends of the links, and on their near ends: the same links, walked with
    stops elsewhere.
    """
    here, far, near = np.eye(4), [np.eye(4)], [np.eye(4)]
    for (theta, d, a, alpha), value in zip(rows, q):
        here = here @ turn([0, 0, theta + value]) @ shift([0, 0, d])
        near.append(here)
        here = here @ shift([a, 0, 0]) @ turn([alpha, 0, 0])
        far.append(here)
    return np.array(far), np.array(near)


def drawn(points, name, k):
    """Origin and unit axes of a frame as drawn."""
    ends = [points[f"{name} {letter}-axis:{k}"] for letter in "xyz"]
    return (
        ends[0][0],
        np.array([(tip - start) / np.linalg.norm(tip - start) for start, tip in ends]).T,
    )


@pytest.mark.parametrize("arm", [THREE, THREE.to("craig")])
def test_both_sets_of_frames_are_where_the_links_put_them(arm):
    picture = view.conventions(arm, Q)
    far, near = far_and_near_ends(ROWS[:3], Q)
    if arm is not THREE:
        far[3] = near[3]  # Craig's last link is in the tool, and stays there
    aside = drawn(picture.points, "Craig", 0)[0]
    assert np.linalg.norm(aside) > 0.5
    for k in range(4):
        for name, pose, moved in (("standard", far[k], 0), ("Craig", near[k], aside)):
            origin, axes = drawn(picture.points, name, k)
            assert np.allclose(origin - moved, pose[:3, 3], atol=1e-9) and np.allclose(
                axes, pose[:3, :3], atol=1e-9
            )
    assert np.allclose(picture.points["way:2"] - aside, [near[2][:3, 3], far[2][:3, 3]], atol=1e-9)


def test_words_and_table_say_where_they_part():
    picture = view.conventions(THREE, Q)
    assert (
        "The same in both: {0}." in picture.alt
        and "{1} is turned by 90°, {2} is 0.4 m away and {3} is 0.35 m away" in picture.alt
    )
    assert (
        "way:0" not in picture.points
        and "way:1" not in picture.points
        and {"way:2", "way:3"} <= picture.points.keys()
    )
    joints = [
        [cell for cell in ("joint 1", "joint 2", "joint 3", "no joint") if cell in line]
        for line in picture.table.splitlines()[2:]
    ]
    assert joints == [
        ["joint 1", "no joint"],
        ["joint 1", "joint 2"],
        ["joint 2", "joint 3"],
        ["joint 3", "no joint"],
    ]
    assert (
        "<figure" in picture._repr_mimebundle_()["text/html"]
        and picture._repr_mimebundle_() == view.conventions(THREE, Q)._repr_mimebundle_()
    )


def test_an_arm_that_is_one_point_and_sliding_joints_can_be_drawn():
    view.conventions(dh.Arm(dh.DHTable.standard([[0, 0, 0, 0]], angle="deg")))
    assert "0.5 m" in view.conventions(dh.load("stanford"), [0, 0.2, 0.5, 0, 0.4, 0]).alt


@pytest.mark.slow
@pytest.mark.parametrize("name", few(["article-6r", "panda", "stanford", "xarm6"], 2))
def test_nothing_is_cut_off(name):
    arm = dh.load(name)
    figure = view.conventions(arm, np.linspace(0.2, 0.7, len(arm))).figure
    renderer = figure.canvas.get_renderer()
    for artist in [
        artist for axes in figure.axes for artist in [*axes.lines, *axes.patches, *axes.texts]
    ]:
        box = artist.get_tightbbox(renderer)
        assert (
            box.x0 >= -1
            and box.y0 >= -1
            and box.x1 <= figure.bbox.x1 + 1
            and box.y1 <= figure.bbox.y1 + 1
        ), artist


@pytest.mark.parametrize(
    "call, words",
    [
        (lambda: view.conventions(ROWS), "expected an Arm"),
        (lambda: view.conventions(THREE, [0, 0]), "expected"),
        (lambda: view.conventions(THREE, np.zeros((2, 3))), "expected one configuration"),
        (lambda: view.conventions(THREE, [0, 0, np.nan]), "finite"),
    ],
)
def test_errors_are_sentences(call, words):
    with pytest.raises(ValueError, match=words):
        call()
