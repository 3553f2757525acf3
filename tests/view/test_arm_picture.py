"""Pictures of whole arms against numbers found another way: elementary matrices, text boxes
measured by matplotlib.
"""

import sys

import matplotlib
import numpy as np
import pytest
from draws import few
from scipy.spatial.transform import Rotation

import dhlab as dh
from dhlab import transform, view


def elementary(kind, value):
    """One elementary move by scipy, not by our own code."""
    T = np.eye(4)
    if kind in "xz":
        T[:3, :3] = Rotation.from_euler(kind, value).as_matrix()
    else:
        T["XZ".index(kind) * 2, 3] = value
    return T


def chain_of(arm, q):
    """Base, then every frame, as a product of elementary matrices."""
    chain = [arm.base]
    for i, (theta, d, a, alpha) in enumerate(arm.table.rows):
        moved = arm.sign[i] * q[i]
        theta, d = (theta, d + moved) if arm.table.joints[i] == "P" else (theta + moved, d)
        about_z, about_x = (
            [elementary("z", theta), elementary("Z", d)],
            [elementary("X", a), elementary("x", alpha)],
        )
        moves = about_z + about_x if arm.table.convention == "standard" else about_x + about_z
        chain.append(chain[-1] @ np.linalg.multi_dot(moves))
    return chain


def random_q(arm, seed):
    rng = np.random.default_rng(seed)
    return np.where(
        arm.table.prismatic, rng.uniform(0.05, 0.4, len(arm)), rng.uniform(-np.pi, np.pi, len(arm))
    )


def numbers(row):
    """The numbers of one line of a picture's table."""
    return [
        float(word.strip("(),"))
        for word in row.split()
        if word.strip("(),").replace(".", "").replace("-", "").isdigit()
    ]


@pytest.mark.slow
@pytest.mark.parametrize("name", few(dh.robots(), 6))
def test_nothing_is_cut_off(name):
    arm = dh.load(name)
    for seed in few(range(3), 1):
        figure = view.arm(arm, random_q(arm, seed)).figure
        renderer = figure.canvas.get_renderer()
        page = figure.bbox
        artists = [
            artist for axes in figure.axes for artist in [*axes.lines, *axes.patches, *axes.texts]
        ] + figure.texts
        assert len(artists) > 30
        for artist in artists:
            box = (
                artist.get_window_extent(renderer)
                if artist in figure.texts
                else artist.get_tightbbox(renderer)
            )
            assert (
                box.x0 >= page.x0 - 1
                and box.y0 >= page.y0 - 1
                and box.x1 <= page.x1 + 1
                and box.y1 <= page.y1 + 1
            ), (name, seed, artist)


@pytest.mark.parametrize("name", ["article-6r", "panda", "stanford"])
def test_equal_scale(name):
    for axes in view.arm(dh.load(name)).figure.axes:
        width, height = axes.get_window_extent().size
        (x0, x1), (y0, y1) = axes.get_xlim(), axes.get_ylim()
        assert width / (x1 - x0) == pytest.approx(height / (y1 - y0), rel=1e-9)
        assert axes.get_aspect() == 1


@pytest.mark.parametrize("name", ["article-6r", "panda", "stanford", "ar4", "cobra600"])
def test_table_and_drawn_axes_are_the_frames(name):
    arm = dh.load(name)
    q = random_q(arm, 7)
    picture = view.arm(arm, q, side=False)
    lines = picture.table.splitlines()[2:]
    for i, (T, line) in enumerate(zip(chain_of(arm, q), lines)):
        assert line.split()[0] == f"{{{i}}}"
        assert numbers(line) == pytest.approx(
            [*T[:3, 3], *T[:3, 0], *T[:3, 1], *T[:3, 2]], abs=6e-4
        )
        for letter, axis in zip("xyz", T[:3, :3].T):
            start, tip = picture.points[f"{letter}-axis:{i}"]
            assert start == pytest.approx(T[:3, 3], abs=1e-9)
            assert (tip - start) / np.linalg.norm(tip - start) == pytest.approx(axis, abs=1e-9)


def test_projection_keeps_parallels_and_lengths():
    """The drawn lines are one linear map of the points in space, with a plane's true scale."""
    picture = view.arm(dh.load("ur5e"), [0.3, -1, 1, 0.2, 0.7, 0], side=False)
    drawn = {
        line.get_gid(): np.array(line.get_xydata())
        for line in picture.figure.axes[0].lines
        if line.get_gid() in picture.points
    }
    names = [name for name in drawn if name.endswith(tuple(f"axis:{i}" for i in range(7)))]
    starts = np.array([picture.points[name][0] for name in names])
    flat = np.array([drawn[name][0] for name in names])
    matrix, *_ = np.linalg.lstsq(starts, flat, rcond=None)
    assert starts @ matrix == pytest.approx(flat, abs=1e-9)
    assert matrix.T @ matrix == pytest.approx(np.eye(2), abs=1e-9)


@pytest.mark.parametrize("name", ["article-6r", "panda", "puma560", "cobra600"])
def test_every_axis_is_lettered(name):
    arm = dh.load(name)
    texts = " ".join(
        text.get_text() for text in view.arm(arm, random_q(arm, 1)).figure.axes[0].texts
    )
    for i in range(len(arm) + 1):
        assert f"{{{i}}}" in texts
        for letter in "xyz":
            assert f"{letter}_{{{i}}}" in texts


def test_letters_stand_by_their_own_axis():
    """Of all axes, the drawn arrow nearest to a letter is the one it names, for frames that are
    well apart.
    """
    poses = [
        np.eye(4),
        transform.trans([0.6, 0, 0]) @ transform.rot_x(0.6),
        transform.trans([0, 0.7, 0.3]) @ transform.rot_y(1),
    ]
    picture = view.frames(poses)
    axes = picture.figure.axes[0]
    tips = {
        line.get_gid(): line.get_xydata()[-1]
        for line in axes.lines
        if "-axis:" in str(line.get_gid())
    }
    for text in axes.texts:
        if text.get_gid() == "axis-label":
            letter, number = text.get_text().strip("$").replace("{", "").replace("}", "").split("_")
            nearest = min(tips, key=lambda name: np.hypot(*(tips[name] - text.get_position())))
            assert nearest == f"{letter}-axis:{number}"


def test_links_follow_the_dh_path():
    """Drawn links lie along z_{i-1} then x_i, in a standard table; their lengths add up to the sums
    of |d| and |a|.
    """
    arm = dh.load("ur5e")
    q = random_q(arm, 2)
    from dhlab.view.drawing.bodies import dh_path

    path = dh_path("standard", np.array(chain_of(arm, q)))
    steps = np.diff(path, axis=0)
    assert np.linalg.norm(steps[::2], axis=1) == pytest.approx(np.abs(arm.table.d), abs=1e-9)
    assert np.linalg.norm(steps[1::2], axis=1) == pytest.approx(np.abs(arm.table.a), abs=1e-9)
    panda = dh.load("panda")
    steps = np.diff(dh_path("craig", np.array(chain_of(panda, random_q(panda, 2)))), axis=0)
    assert np.linalg.norm(steps[::2], axis=1) == pytest.approx(np.abs(panda.table.a), abs=1e-9)
    assert np.linalg.norm(steps[1::2], axis=1) == pytest.approx(np.abs(panda.table.d), abs=1e-9)


@pytest.mark.parametrize("name", ["ur5e", "panda", "stanford"])
def test_a_joint_is_drawn_on_its_axis(name):
    """Turning joint i (or sliding it) moves no joint drawn up to i, whatever else it moves."""
    from dhlab.view.drawing.bodies import joint_places

    arm = dh.load(name)
    q = random_q(arm, 4)
    for i in range(len(arm)):
        if arm.table.joints[i] == "P":
            continue
        moved = q.copy()
        moved[i] += 0.7
        before, after = (
            joint_places(arm.table.convention, arm.frames(value)) for value in (q, moved)
        )
        assert after[0][: i + 1] == pytest.approx(before[0][: i + 1], abs=1e-9)
        assert after[1][: i + 1] == pytest.approx(before[1][: i + 1], abs=1e-9)


def test_alt_tells_the_end():
    arm = dh.load("article-6r")
    at_zero = view.arm(arm, side=False).alt
    assert (
        "x = 0.75, y = -0.2, z = 0.1 m" in at_zero
        and "6 revolute joints" in at_zero
        and "{4} and {5} share one origin" in at_zero
    )
    turned = view.arm(arm, [np.pi / 2, 0, 0, 0, 0, 0], side=False).alt
    assert "x = 0.2, y = 0.75, z = 0.1 m" in turned and "90°" in turned
    assert "1 prismatic joint" in view.arm(dh.load("cobra600"), side=False).alt


def test_base_and_tool_are_named():
    table = dh.load("article-6r").table
    plain = view.arm(dh.Arm(table), side=False)
    assert "tool" not in plain.table and "base" not in plain.table
    arm = dh.Arm(table, base=transform.trans([0, 0, 0.5]), tool=transform.trans([0, 0, 0.1]))
    picture = view.arm(arm)
    assert "tool" in picture.table and "{0} base" in picture.table
    assert "tool-line" in picture.points
    texts = [text.get_text() for text in picture.figure.axes[0].texts]
    assert any("tool" in text for text in texts) and any("base" in text for text in texts)
    assert numbers(picture.table.splitlines()[-1])[:3] == pytest.approx(
        arm.forward([0] * 6)[:3, 3], abs=1e-4
    )


def test_without_frames_only_the_end_is_drawn():
    picture = view.arm(dh.load("ur5e"), frames=False, side=False)
    assert [name for name in picture.points if "axis:" in name] == [
        "x-axis:6",
        "y-axis:6",
        "z-axis:6",
    ]


def test_side_view_says_its_plane():
    titles = [text.get_text() for text in view.arm(dh.load("cobra600")).figure.axes[1].texts]
    assert any("x–z plane" in title for title in titles)
    assert len(view.arm(dh.load("cobra600"), side=False).figure.axes) == 1


def test_configurations_differ_in_line_and_colour():
    arm = dh.load("ur5e")
    picture = view.poses(arm, [[0.3 * k] * 6 for k in range(5)], names=list("abcde"))
    lines = [
        line for line in picture.figure.axes[0].lines if str(line.get_gid()).startswith("pose:")
    ]
    assert len(lines) == 5
    assert (
        len({line.get_color() for line in lines}) == 5
        and len({str(line._unscaled_dash_pattern) for line in lines}) == 5
    )
    ends = [numbers(row)[:3] for row in picture.table.splitlines()[2:]]
    assert ends == [
        pytest.approx(chain_of(arm, [0.3 * k] * 6)[-1][:3, 3], abs=1e-4) for k in range(5)
    ]


@pytest.mark.parametrize(
    "call, words",
    [
        (lambda arm: view.arm(arm.table), "expected an Arm"),
        (lambda arm: view.arm(arm, [0, 0]), "expected 6 values"),
        (lambda arm: view.arm(arm, np.zeros((2, 6))), "several are for view.poses"),
        (lambda arm: view.poses(arm, np.zeros((6, 6))), "1 to 5 configurations"),
        (lambda arm: view.poses(arm, np.zeros(6)), "1 to 5 configurations"),
        (lambda arm: view.poses(arm, np.zeros((2, 6)), names=["one"]), "expected 2"),
    ],
)
def test_errors_are_sentences(call, words):
    with pytest.raises(ValueError, match=words):
        call(dh.load("article-6r"))


@pytest.mark.slow
def test_pyplot_never_hears_of_it():
    view.arm(dh.load("article-6r"))
    if "matplotlib.pyplot" in sys.modules:
        assert matplotlib.pyplot.get_fignums() == []
    import subprocess

    code = (
        "import sys, dhlab as dh; from dhlab import view; view.arm(dh.load('ur5e'));"
        " sys.exit('matplotlib.pyplot' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
