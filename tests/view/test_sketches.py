"""The sketches: what they draw obeys the rule that they teach, found from the drawn points."""

import numpy as np
import pytest

from dhlab import view
from dhlab.view.sketches.sketch import SKETCHES


def way(picture, name):
    """A drawn arrow's direction, from its first point to its last, of length 1."""
    points = picture.points[name]
    v = points[-1] - points[0]
    return v / np.linalg.norm(v)


@pytest.mark.parametrize("name", SKETCHES)
def test_each_says_in_words_and_numbers_what_it_shows(name):
    picture = view.sketch(name)
    assert len(picture.alt) > 120 and len(picture.table.splitlines()) >= 5
    assert 'alt="' in picture._repr_mimebundle_()["text/html"]


def test_the_hand_is_a_right_hand():
    points = view.sketch("right hand").points
    axes = [points[f"{letter}-axis:hand"] for letter in "xyz"]
    x, y, z = (end - start for start, end in axes)
    assert np.cross(x, y) @ z > 0
    fist = points["finger"].mean(axis=0)  # the hand drawn last, around "any axis"
    bent, up = points["finger"], np.diff(points["any-axis"], axis=0)[0]
    on_axis = points["any-axis"][0]
    radial = (bent - on_axis) - np.outer((bent - on_axis) @ up, up) / (up @ up)
    turning = np.cross(radial[:-1], radial[1:]) @ up
    assert (turning > 0).all()  # knuckles to tips: counter-clockwise, seen against the axis
    thumb = points["thumb"]
    assert (thumb[-1] - thumb[0]) @ up > 0
    forearm = points["forearm"].mean(axis=0) - fist
    palm = points["palm"].mean(axis=0) - fist
    assert np.cross(forearm, palm) @ up > 0  # a mirrored hand would have the palm's other side


def test_the_pipe_leaves_the_common_normal_alone():
    points = view.sketch("bent pipe").points
    foot, end = points["a-length"]
    for line in ("line:z_{i-1}", "line:z_i"):
        p, q = points[line]
        assert abs((end - foot) @ (q - p)) < 1e-12
    across = [np.cross(points[f"line:{z}"][1] - at, points[f"line:{z}"][0] - at)
              for z, at in (("z_{i-1}", foot), ("z_i", end))]  # fmt: skip
    np.testing.assert_allclose(across, 0, atol=1e-12)
    gaps = np.linalg.norm(points["pipe"][:, None] - np.linspace(foot, end, 50), axis=-1)
    assert gaps.min() > 0.1


def test_the_camera_looks_at_what_its_ring_closes_with():
    picture = view.sketch("hand-eye")
    starts = [picture.points[f"way:T_{{{pair}}}"] for pair in ("0F", "FC", "CP", "0P")]
    gaps = [
        starts[0][-1] - starts[1][0],
        starts[1][-1] - starts[2][0],
        starts[2][-1] - starts[3][-1],
    ]
    assert np.linalg.norm(gaps, axis=1).max() < 0.1
    assert way(picture, "way:T_{CP}") @ way(picture, "z-axis:C") > 0.9
    board = picture.points["pattern"].mean(axis=0)
    eye, z = picture.points["z-axis:C"][0], way(picture, "z-axis:C")
    beside = board - eye - (board - eye) @ z * z
    assert np.linalg.norm(beside) < 0.2  # within the picture of the camera


def test_frame_n_stands_on_the_tools_line_and_on_the_normal():
    points = view.sketch("last axis").points
    foot, origin = points["a-length"]
    start, end = points["tool-line"]  # the later of the two cases
    assert np.linalg.norm(np.cross(origin - start, end - start)) < 1e-12
    assert abs((origin - foot) @ (end - start)) < 1e-12
    joint = np.diff(points["joint-axis"], axis=0)[0]
    assert abs((origin - foot) @ joint) < 1e-12


def test_the_tube_has_the_measures_that_are_written_beside_it():
    points = view.sketch("bent tube").points["tube"]
    lengths = 1e3 * np.linalg.norm(np.diff(points, axis=0), axis=1)
    np.testing.assert_allclose(lengths, [284.5, 53.5])


def test_an_unknown_sketch_is_refused_with_the_names_there_are():
    with pytest.raises(ValueError, match="expected one of 'right hand', .* found 'left hand'"):
        view.sketch("left hand")
