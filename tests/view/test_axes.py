"""The picture of bare axes: lines where the axes are, feet where the shortest way is, words that
say the same.
"""

import numpy as np
import pytest
from scipy.optimize import minimize

from dhlab import view
from dhlab.placing.board import Placement
from dhlab.transform import from_xyz_rpy, trans

X, Y, Z = np.eye(3)
AXES = [
    ([0, 0, 0], Z),
    ([0.1, -0.2, 0.4], [0.2, 1, 0.1]),
    ([0.5, 0, 0.4], [0.2, 1, 0.1]),
    ([0.7, 0, 0.2], X, "P"),
]
END = from_xyz_rpy([0.9, 0.1, 0.2], [0.3, 0.2, 0.1])


@pytest.fixture(scope="module")
def picture():
    return view.axes(AXES, END)


def test_lines_lie_on_the_axes_and_point_along_them(picture):
    for k, (p, z, *_) in enumerate(AXES, 1):
        start, tip = picture.points[f"axis:{k}"]
        z = np.asarray(z) / np.linalg.norm(z)
        assert np.cross(start - p, z) == pytest.approx(np.zeros(3), abs=1e-12) and (
            tip - start
        ) @ z == pytest.approx(np.linalg.norm(tip - start))
        assert (start - p) @ z < 0 < (tip - p) @ z


def test_lines_stop_below_the_floor_with_a_dot_on_it():
    points = view.axes(
        [([0, 0, 0], Z), ([0.1, 0, 0.4], Y), ([0.4, 0, 0.05], -Z)], trans([0.5, 0, 0.1])
    ).points
    assert (
        -0.05 < points["axis:1"][0][2] < 0
        and -0.05 < points["axis:3"][1][2] < 0
        and points["axis:1"][1][2] > 0.4
    )
    assert (
        points["foot:1"][0] == pytest.approx(np.zeros(3))
        and points["foot:3"][0] == pytest.approx([0.4, 0, 0])
        and "foot:2" not in points
    )
    deep = view.axes([([0, 0, 0], Z), ([0.2, 0, -0.6], X), ([0.4, 0, 0.2], Y)], END).points
    assert deep["axis:1"][0][2] < -0.6 and deep["normal:1"].min() == pytest.approx(-0.6), (
        "a line goes on to what lies on it"
    )


def test_the_normal_is_the_shortest_way(picture):
    (p, w), (q, z) = (
        (np.asarray(point), np.asarray(d) / np.linalg.norm(d)) for point, d in AXES[:2]
    )
    found = minimize(lambda s: np.sum((p + s[0] * w - q - s[1] * z) ** 2), [0, 0], tol=1e-16)
    assert picture.points["normal:1"] == pytest.approx(
        np.array([p + found.x[0] * w, q + found.x[1] * z]), abs=1e-6
    )
    # beside the sliding joint there is none
    assert "normal:3" not in picture.points and "normal:4" not in picture.points
    without = view.axes(AXES, END, normals=False)
    assert "normal:1" not in without.points
    assert "to the next axis" in str(picture.table) and "skew" in picture.alt
    assert "to the next axis" not in str(without.table) and "skew" not in without.alt


def test_the_tool_and_placed_frames_are_drawn():
    board = Placement(AXES, END)
    assert board.set_z(0, Z) and board.set_origin(0, [0, 0, 0.1]) and board.set_x(0, Y)
    points = view.axes(AXES, END, board.frames).points
    start, tip = points["x-axis:0"]
    assert (
        start == pytest.approx([0, 0, 0.1])
        and np.cross(tip - start, Y) == pytest.approx(np.zeros(3))
        and (tip - start) @ Y > 0
    )
    assert points["z-axis:tool"][0] == pytest.approx(END[:3, 3])
    assert points["z-axis:tool"][1] - points["z-axis:tool"][0] == pytest.approx(
        END[:3, 2] * np.linalg.norm(np.diff(points["z-axis:tool"], axis=0))
    )


@pytest.mark.parametrize(
    "second, words",
    [
        (([0.3, 0, 0], Y), "skew: 0.3 m apart, 90° between them"),
        (([0, 0.2, 0.3], Y), "they meet, 90° between them"),
        (([0.3, 0, 1], Z), "parallel: 0.3 m apart"),
        (([0.3, 0, 1], -Z), "parallel, opposite senses: 0.3 m apart"),
        (([0, 0, 1], Z), "one line"),
        (([0, 0, 1], -Z), "one line, opposite senses"),
        (([0.3, 0, 0], Y, "P"), "of a sliding joint only the direction counts"),
    ],
)
def test_how_two_axes_lie_is_said(second, words):
    picture = view.axes([([0, 0, 0], Z), second], trans([0.5, 0.1, 0.2]))
    assert (
        picture.table.splitlines()[2].endswith(f"  {words}")
        and f"Axis 1 to axis 2: {words}." in picture.alt
    )


def test_arrow_heads_on_one_line_do_not_cover_each_other():
    points = view.axes(
        [([0, 0, 0], X), ([0.2, 0, 0], X), ([0.4, 0, 0], X)],
        from_xyz_rpy([0.5, 0, 0], [0, np.pi / 2, 0]),
    ).points
    tips = [points[f"axis:{k}"][1][0] for k in (1, 2, 3)] + [points["z-axis:tool"][1][0]]
    assert min(abs(a - b) for i, a in enumerate(tips) for b in tips[:i]) > 0.02


def test_words_table_and_nothing_cut_off(picture):
    assert picture.alt.startswith(
        "The bare axes of 3 revolute joints and 1 prismatic joint at q = 0, with the tool at x ="
        " 0.9, y = 0.1, z = 0.2 m."
    )
    assert (
        len(picture.table.splitlines()) == 2 + 5
        and "The axes as a table" in picture._repr_mimebundle_()["text/html"]
    )
    renderer = picture.figure.canvas.get_renderer()
    for artist in [
        artist
        for axes in picture.figure.axes
        for artist in [*axes.lines, *axes.patches, *axes.texts]
    ]:
        box = artist.get_tightbbox(renderer)
        assert (
            box.x0 >= -1
            and box.y0 >= -1
            and box.x1 <= picture.figure.bbox.x1 + 1
            and box.y1 <= picture.figure.bbox.y1 + 1
        ), artist


def test_errors_are_sentences():
    with pytest.raises(ValueError, match="expected a list of joint axes"):
        view.axes("axes", END)
    with pytest.raises(ValueError, match="4×4 pose"):
        view.axes(AXES, np.eye(3))


def test_frames_may_come_as_a_learner_writes_them():
    axes, end = [([0, 0, 0], [0, 0, 1]), ([0.4, 0, 0.1], [0, 1, 0])], np.eye(4)
    rows = [[[0, 0, 1], [0, 0, 0.2], [0, 1, 0]], [[0, 1, 0], [0.4, 0, 0.1], [1, 0, 0]]]
    picture = view.axes(axes, end, rows)
    assert "Frames placed: {0} and {1}." in picture.alt
    arrow = np.diff(picture.points["y-axis:0"], axis=0)[0]
    np.testing.assert_allclose(arrow / np.linalg.norm(arrow), [-1, 0, 0], atol=1e-12)
    with pytest.raises(ValueError, match=r"expected \(z, origin, x\) .* for frame 1"):
        view.axes(axes, end, [rows[0], [..., ..., ...]])
