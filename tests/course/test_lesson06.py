"""What lessons 01, 05 and 06 say of arms, by geometry that knows no table."""

import json
from itertools import product

import numpy as np
import pytest

from dhlab.course import build
from dhlab.course.exercises import exercises
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
        parallel = all(np.linalg.norm(np.cross(axes[k][1], axes[k + 1][1])) < ROUNDED for k in (1, 2))
        assert (parallel, meet(axes[3:])) == (letter == "a", letter == "b")


def test_every_other_answer_to_06_9_is_wrong_and_named():
    for letters in product("abcd", repeat=4):
        verdict = exercises()["06.9"].judge(list(letters))
        assert (verdict.status == "right") == (letters == ("c", "a", "b", "b")) and (verdict.status == "right" or verdict.mistake)
    assert exercises()["06.9"].judge("cabb").status == exercises()["06.9"].judge("C, A, B, B").status == "right"


def outputs(name, text):
    """What the cell of a solution printed that holds a text."""
    cells = json.loads((build.SOLUTIONS / f"{name}.ipynb").read_text(encoding="utf-8"))["cells"]
    cell, = (cell for cell in cells if cell["cell_type"] == "code" and text in "".join(cell["source"]))
    return "".join("".join(output.get("text", "")) for output in cell["outputs"])


def test_the_camera_is_found_from_the_tool_and_not_from_the_flange():
    rows = [line for line in outputs("01-frames", "from flange").splitlines()]
    places = np.array([[float(v) for part in row.split("[")[1:] for v in part.split("]")[0].split()] for row in rows])
    assert places.shape == (3, 6)
    np.testing.assert_allclose(places[:, 3:], [[0.9, 0.3, 0.5]] * 3)
    steps = np.linalg.norm(places[:, :3] - places[:, 3:], axis=1)
    np.testing.assert_allclose(steps, 0.12, atol=2e-3)  # the pen's length, every time
    assert np.linalg.norm(places[0, :3] - places[1, :3]) > 0.03 and np.linalg.norm(places[0, :3] - places[2, :3]) > 0.03


def test_lengths_never_enter_the_rotation():
    assert "rotation the same when d and a change? True" in outputs("05-link-matrix", "longer")
