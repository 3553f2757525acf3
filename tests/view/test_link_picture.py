"""The four parameters of a row, as drawn, against their definitions."""

import itertools

import numpy as np
import pytest
from draws import few
from scipy.spatial.transform import Rotation

import dhlab as dh
from dhlab import view
from dhlab.view.drawing.moves import moves_of

STANDARD = dh.DHTable.standard([[40, 0.3, 0.4, 50]], angle="deg")
CRAIG = dh.DHTable.craig([[0, 0.1, 0, 0], [40, 0.3, 0.4, 50]], angle="deg")


def turned(axis, degrees):
    return Rotation.from_euler(axis, degrees, degrees=True).as_matrix()


def check_arc(points, centre, axis, first, angle):
    """Points on a circle about ``axis`` through ``centre``, from the direction ``first``, over
    ``angle`` radians.
    """
    rays = points - centre
    assert rays @ axis == pytest.approx(np.zeros(len(rays)), abs=1e-9)
    radii = np.linalg.norm(rays, axis=1)
    assert radii == pytest.approx(np.full(len(radii), radii[0]), rel=1e-9)
    assert rays[0] / radii[0] == pytest.approx(first, abs=1e-9)
    steps = [np.arctan2(axis @ np.cross(a, b), a @ b) for a, b in itertools.pairwise(rays)]
    assert sum(steps) == pytest.approx(angle, abs=1e-9)


@pytest.mark.parametrize(
    "theta, alpha", [(40, 50), (-120, -70), (170, 90), (10, -179), (-350, 200)]
)
def test_standard_arcs(theta, alpha):
    points = view.link(dh.DHTable.standard([[theta, 0.3, 0.4, alpha]], angle="deg"), 1).points
    x, z = np.eye(3)[0], np.eye(3)[2]
    x_1 = turned("z", theta) @ x
    check_arc(points["theta-arc"], np.zeros(3), z, x, np.deg2rad(theta))
    check_arc(points["alpha-arc"], 0.3 * z + 0.4 * x_1, x_1, z, np.deg2rad(alpha))


def test_craig_arcs():
    points = view.link(CRAIG, 2).points
    x, z = np.eye(3)[0], np.eye(3)[2]
    z_2 = turned("x", 50) @ z
    check_arc(points["alpha-arc"], np.zeros(3), x, z, np.deg2rad(50))
    check_arc(points["theta-arc"], 0.4 * x, z_2, x, np.deg2rad(40))


@pytest.mark.parametrize(
    "table, i, along_d", [(STANDARD, 1, [0, 0, 1]), (CRAIG, 2, turned("x", 50)[:, 2])]
)
def test_lengths_are_measured_along_their_axes(table, i, along_d):
    points = view.link(table, i).points
    along_a = turned("z", 40)[:, 0] if table.convention == "standard" else np.eye(3)[0]
    assert np.diff(points["d-length"], axis=0)[0] == pytest.approx(
        0.3 * np.array(along_d), abs=1e-9
    )
    assert np.diff(points["a-length"], axis=0)[0] == pytest.approx(0.4 * along_a, abs=1e-9)


@pytest.mark.parametrize(
    "table, i",
    [(STANDARD, 1), (CRAIG, 2), (dh.DHTable.standard([[30, 0.3, -0.4, -50]], angle="deg"), 1)],
)
def test_a_is_measured_beside_the_common_normal(table, i):
    picture = view.link(table, i)
    length = np.linalg.norm(np.diff(picture.points["x-axis:1"], axis=0)) / 0.85
    (move,) = [move for move in moves_of(table, i, 0) if move.kind == "a"]
    shift = picture.points["a-length"] - [move.start[:3, 3], move.end[:3, 3]]
    assert np.linalg.norm(shift[0]) < 0.2 * length and shift[0] == pytest.approx(shift[1]), (
        "far off it would look like an axis"
    )
    (text,) = [text for text in picture.figure.axes[0].texts if text.get_text() == "common normal"]
    corner, edge = text.get_window_extent().min, text.get_window_extent().max
    assert (corner > 0).all() and (edge < picture.figure.bbox.max).all()


def test_a_short_normal_has_no_name():
    for row in ([0, 0.3, 0, 90], [30, 0.4, 0.05, 90]):
        picture = view.link(dh.DHTable.standard([row], angle="deg"), 1)
        assert "common normal" not in [text.get_text() for text in picture.figure.axes[0].texts]


def test_negative_lengths_point_back():
    points = view.link(dh.DHTable.standard([[0, -0.2, -0.4, 0]], angle="deg"), 1).points
    assert np.diff(points["d-length"], axis=0)[0] == pytest.approx([0, 0, -0.2])
    assert np.diff(points["a-length"], axis=0)[0] == pytest.approx([-0.4, 0, 0])


def test_second_frame_is_where_the_matrices_put_it():
    points = view.link(CRAIG, 2).points
    R = turned("x", 50) @ turned("z", 40)
    origin = np.array([0.4, 0, 0]) + 0.3 * turned("x", 50)[:, 2]
    for k, letter in enumerate("xyz"):
        start, tip = points[f"{letter}-axis:2"]
        assert start == pytest.approx(origin, abs=1e-9)
        assert (tip - start) / np.linalg.norm(tip - start) == pytest.approx(R[:, k], abs=1e-9)


@pytest.mark.parametrize(
    "table, i, symbols",
    [
        (STANDARD, 1, [r"\theta_{1} = 40°", r"d_{1} = 0.3", r"a_{1} = 0.4", r"\alpha_{1} = 50°"]),
        (CRAIG, 2, [r"\alpha_{1} = 50°", r"a_{1} = 0.4", r"\theta_{2} = 40°", r"d_{2} = 0.3"]),
    ],
)
def test_symbols_carry_the_subscripts_of_the_convention(table, i, symbols):
    picture = view.link(table, i)
    texts = " ".join(text.get_text() for text in picture.figure.axes[0].texts)
    for symbol in symbols:
        assert symbol in texts
    order = [line.split()[0] for line in picture.table.splitlines()[2:]]
    plain = [
        symbol.split(" ")[0].replace("\\", "").replace("{", "").replace("}", "")
        for symbol in symbols
    ]
    assert order == plain


def test_table_says_about_which_axis():
    rows = [line.split() for line in view.link(STANDARD, 1).table.splitlines()[2:]]
    assert [row[3] for row in rows] == ["z_0", "z_0", "x_1", "x_1"]
    rows = [line.split() for line in view.link(CRAIG, 2).table.splitlines()[2:]]
    assert [row[3] for row in rows] == ["x_1", "x_1", "z_2", "z_2"]


def test_zero_is_listed_but_not_drawn():
    picture = view.link(dh.DHTable.standard([[0, 0, 0.4, 90]], angle="deg"), 1)
    assert "theta-arc" not in picture.points and "d-length" not in picture.points
    assert "theta_1" in picture.table and "d_1" in picture.table
    view.link(dh.DHTable.standard([[0, 0, 0, 0]], angle="deg"), 1)


def test_q_is_added_where_the_joint_moves():
    stanford = dh.load("stanford").table
    points = view.link(stanford, 3, 0.6).points
    assert np.diff(points["d-length"], axis=0)[0] == pytest.approx([0, 0, 0.6])
    assert "theta_1 = 70°" in view.link(STANDARD, 1, np.deg2rad(30)).alt


@pytest.mark.slow
@pytest.mark.parametrize("name", few(["article-6r", "panda", "stanford", "jaco6"], 2))
def test_nothing_is_cut_off(name):
    table = dh.load(name).table
    for i in range(1, len(table) + 1):
        figure = view.link(table, i, 0.5).figure
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
            ), (name, i, artist)


@pytest.mark.parametrize(
    "call, words",
    [
        (lambda: view.link(dh.load("ur5e"), 1), "expected a DHTable"),
        (lambda: view.link(STANDARD, 0), "rows are counted from 1"),
        (lambda: view.link(STANDARD, 2), "a row from 1 to 1"),
        (lambda: view.link(STANDARD, 1.0), "a row from 1 to 1"),
        (lambda: view.link(STANDARD, 1, [0, 0]), "one finite number for q"),
        (lambda: view.link(STANDARD, 1, np.nan), "one finite number for q"),
    ],
)
def test_errors_are_sentences(call, words):
    with pytest.raises(ValueError, match=words):
        call()
