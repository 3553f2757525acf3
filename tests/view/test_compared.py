"""The picture of predicted against measured."""

import numpy as np
import pytest

import dhlab as dh
from dhlab import view

ARM = dh.load("article-6r")
Q = np.random.default_rng(2).uniform(-2, 2, (5, 6))


def test_lines_are_as_long_as_the_errors_and_the_words_say_so():
    shifts = np.array([[0, 0, 0.05], [0.1, 0, 0], [0, 0.2, 0], [0, 0, 0], [0.01, 0, 0]])
    picture = view.compared(ARM, Q, ARM.forward(Q)[:, :3, 3] + shifts)
    lengths = [np.linalg.norm(np.diff(picture.points[f"error:{k}"], axis=0)) for k in range(1, 6)]
    assert (
        np.allclose(lengths, [0.05, 0.1, 0.2, 0, 0.01])
        and "200 mm at the most and 72 mm on average" in picture.alt
        and "pose 3" in picture.alt
    )
    assert np.allclose(picture.points["measured:2"], ARM.forward(Q[1])[:3, 3] + [0.1, 0, 0])
    assert "axes" not in picture.alt and "deg" not in picture.table


def test_small_errors_are_drawn_longer_and_the_title_says_how_much():
    picture = view.compared(ARM, Q, ARM.forward(Q)[:, :3, 3] + [0, 0, 1e-3])
    length = np.linalg.norm(np.diff(picture.points["error:1"], axis=0))
    said = f"{round(length / 1e-3)} times as long"
    assert (
        length > 0.02
        and said in picture.alt
        and any(said in text.get_text() for text in picture.figure.texts)
    )


def test_full_poses_have_angles_and_one_pose_is_enough():
    T = ARM.forward(Q[:1]) @ dh.transform.rot_x(0.1)
    picture = view.compared(ARM, Q[:1], T)
    assert "5.73" in picture.table and "1 measured end point" in picture.alt


def test_what_does_not_fit_is_refused():
    for q, p in ((Q, np.zeros((4, 3))), (Q, np.full((5, 3), np.nan)), (Q[0], np.zeros(3))):
        with pytest.raises(ValueError, match="view.compared"):
            view.compared(ARM, q, p)
