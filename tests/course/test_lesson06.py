"""What lessons 01, 05 and 06 say of arms, by geometry that knows no table."""

import json
from itertools import permutations, product

import numpy as np
import pytest
from draws import variants

from dhlab.arm import Arm
from dhlab.course.building import reading
from dhlab.course.exercises import exercises
from dhlab.course.exercises.offsets06 import UPRIGHT
from dhlab.robots import load
from dhlab.table import DHTable
from tests.oracles import chain_joints, shift, turn

ARMS = {"ur5e": "a", "ar4_mk3": "b", "piper_2025": "b"}
ROUNDED = 2e-3  # rad and m: the files' 1.5708, and the Piper's lengths


def lines(chain, q):
    """The joint axes (point, direction) of a URDF chain at q."""
    from scipy.spatial.transform import Rotation

    T, found, moving = np.eye(4), [], iter(q)
    for joint in chain_joints(chain):
        T = T @ shift(joint["xyz"])
        T[:3, :3] = T[:3, :3] @ Rotation.from_euler("xyz", joint["rpy"]).as_matrix()
        if joint["type"] != "fixed":
            axis = np.array(joint["axis"]) / np.linalg.norm(joint["axis"])
            found.append((T[:3, 3].copy(), T[:3, :3] @ axis))
            T = T @ turn(axis * next(moving))
    return found


def meet(axes):
    """Whether three lines pass through one point: least squares of the distances."""
    across = [np.eye(3) - np.outer(z, z) for _, z in axes]
    point = np.linalg.solve(sum(across), sum(P @ p for P, (p, _) in zip(across, axes)))
    return max(np.linalg.norm(P @ (point - p)) for P, (p, _) in zip(across, axes)) < ROUNDED


@pytest.mark.parametrize("chain, letter", ARMS.items())
def test_the_structures_of_06_9_by_their_urdf(chain, letter):
    for q in np.random.default_rng(6).uniform(-1.2, 1.2, (5, 6)):
        axes = lines(chain, q)
        parallel = all(
            np.linalg.norm(np.cross(axes[k][1], axes[k + 1][1])) < ROUNDED for k in (1, 2)
        )
        assert (parallel, meet(axes[3:])) == (letter == "a", letter == "b")


def test_every_other_answer_to_06_9_is_wrong_and_named():
    for letters in product("abcd", repeat=4):
        verdict = exercises()["06.9"].judge(list(letters))
        assert (verdict.status == "right") == (letters == ("c", "a", "b", "b")) and (
            verdict.status == "right" or verdict.mistake
        )
    assert (
        exercises()["06.9"].judge("cabb").status
        == exercises()["06.9"].judge("C, A, B, B").status
        == "right"
    )


def outputs(name, text):
    """What the cell of a solution printed that holds a text."""
    cells = json.loads((reading.SOLUTIONS / f"{name}.ipynb").read_text(encoding="utf-8"))["cells"]
    (cell,) = (
        cell for cell in cells if cell["cell_type"] == "code" and text in "".join(cell["source"])
    )
    return "".join("".join(output.get("text", "")) for output in cell["outputs"])


def test_the_camera_is_found_from_the_tool_and_not_from_the_flange():
    rows = list(outputs("01-frames", "from flange").splitlines())
    places = np.array(
        [
            [float(v) for part in row.split("[")[1:] for v in part.split("]")[0].split()]
            for row in rows
        ]
    )
    assert places.shape == (3, 6)
    np.testing.assert_allclose(places[:, 3:], [[0.9, 0.3, 0.5]] * 3)
    steps = np.linalg.norm(places[:, :3] - places[:, 3:], axis=1)
    np.testing.assert_allclose(steps, 0.12, atol=2e-3)  # the pen's length, every time
    assert (
        np.linalg.norm(places[0, :3] - places[1, :3]) > 0.03
        and np.linalg.norm(places[0, :3] - places[2, :3]) > 0.03
    )


def test_the_neighbours_arm_and_the_neighbours_goal_are_named():
    irb120, ur5e = exercises()["06.10"], exercises()["08.13"]
    for variant in variants(2):
        q = np.deg2rad(irb120.given(variant)["q"])
        assert "article's arm" in irb120.judge(load("article-6r").forward(q), variant).headline
    cup = load("article-6r").forward(np.deg2rad([30, 60, -80, -30, 40, 0]))
    assert "to the cup" in ur5e.judge(load("ur5e").solve(cup).q[0]).headline


def test_a_place_with_its_1_is_told_so():
    unseen = exercises()["03.10"]
    for variant in variants(2):
        point = unseen.answer(**unseen.given(variant))
        assert "the 1 at the end" in unseen.judge([*point, 1], variant).headline


def test_matching_names_the_parts_and_where_to_look():
    judge = exercises()["06.1"].judge
    assert judge("bdace").headline == "d4 and d6 are exchanged" and "z3" in judge("bdace").next
    assert (
        judge("badec").headline == "a2 and a3 are exchanged"
        and judge("dbaec").mistake == "a-d-exchanged"
    )
    for letters in permutations("abcde"):
        verdict = judge(list(letters))
        assert verdict.status == "right" or (verdict.next and "digit" not in str(verdict))


def test_06_9_names_the_arm_and_the_numbers_to_read():
    judge = exercises()["06.9"].judge
    assert (
        "Piper" in judge("cabd").headline
        and "a4, a5 and d5" in judge("cabd").next
        and "Craig" not in str(judge("cabd"))
    )
    assert "UR5e" in judge("ccbb").headline and "a4, a5 and d5" in judge("ccbb").next
    assert "AR4" in judge("cacb").headline and "α2 and α3" in judge("cacb").next


@pytest.mark.parametrize("variant", variants(4))
def test_two_slips_of_the_loop_have_words_of_their_own(variant):
    def link(row, x):
        theta, d, a, alpha = row
        return shift([0, 0, d]) @ turn([0, 0, theta + x]) @ shift([a, 0, 0]) @ turn([alpha, 0, 0])

    def thrown_away(rows, q):
        T = np.eye(4)
        for row, x in zip(rows, q):
            T = link(row, x)
        return T

    def returns_at_once(rows, q):
        return link(rows[0], q[0])

    for key in ("06.2", "06.7"):
        last, first = (exercises()[key].judge(f, variant) for f in (thrown_away, returns_at_once))
        assert (
            last.mistake == "product-starts-late"
            and "T = T @ A" in last.next
            and "range" not in str(last)
        )
        assert first.mistake == "product-stops-early" and "return" in first.next


def upright(offset_2, offset_3):
    rows = [list(row) for row in UPRIGHT]
    rows[1][0], rows[2][0] = offset_2, offset_3
    return rows


@pytest.mark.parametrize("variant", range(3))
def test_06_6_says_how_the_arm_stands(variant):
    judge = exercises()["06.6"].judge
    for radians in ((np.pi / 2, -np.pi / 2), (1.57, -1.57), (np.pi / 2, 0)):
        verdict = judge(upright(*radians), variant)
        assert verdict.mistake == "angle-unit" and "radians" in verdict.headline
    words = {
        (1, 0): "level, pointing forward",
        (0, 1): "straight up",
        (-1, 0): "level, pointing backward",
        (0, -1): "straight down",
    }
    for offsets in product((0, 90, -90, 180), repeat=2):
        verdict = judge(upright(*offsets), variant)
        frames = Arm(DHTable.standard(upright(*offsets), angle="deg")).frames(np.zeros(6))
        upper, fore = (
            words[tuple(np.round((b - a)[[0, 2]] / length).astype(int))]
            for a, b, length in (
                (frames[1][:3, 3], frames[2][:3, 3], 0.4),
                (frames[2][:3, 3], frames[3][:3, 3], 0.35),
            )
        )
        if offsets == (90, -90):
            assert verdict.status == "right" and (upper, fore) == (
                "straight up",
                "level, pointing forward",
            )
        else:
            assert (
                verdict.status == "wrong"
                and verdict.mistake
                and (upper if offsets[0] != 90 else fore) in verdict.headline
            )
    assert (
        judge(upright(90, 0), variant).mistake == "offset-missing"
        and "not from the floor" in judge(upright(90, 0), variant).next
    )


@pytest.mark.parametrize("variant", variants(4))
def test_the_rows_of_06_10_converted_twice(variant):
    exercise = exercises()["06.10"]
    q = np.deg2rad(exercise.given(variant)["q"])
    rows = load("irb120").table.rows
    twice = Arm(DHTable.standard(rows * [np.pi / 180, 1, 1, np.pi / 180], angle="rad")).forward(q)
    assert exercise.judge(twice, variant).headline == "the rows were converted twice"
    assert exercise.judge(load("irb120").forward(q), variant).status == "right"


def test_the_axes_are_parallel_at_both_printed_poses():
    for line in outputs("06-forward-kinematics", 'print("axes 2, 3, 4:"').splitlines():
        axes = [part.split("]")[0] for part in line.split("[")[1:]]
        assert len(axes) == 3 and len(set(axes)) == 1
    assert len(outputs("06-forward-kinematics", 'print("axes 2, 3, 4:"').splitlines()) == 2
