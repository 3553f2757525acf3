"""Wrist arms given by their seven lengths: offsets and signs in every dress, against the chain as
the paper draws it.
"""

import numpy as np
import pytest
from oracles import shift, turn

import dhlab as dh

LENGTHS = {"a1": 0.5, "a2": 0.055, "b": 0.0, "c1": 1.045, "c2": 1.3, "c3": 1.525, "c4": 0.29}
TEXT = "".join(f"{name} = {value}\n" for name, value in LENGTHS.items())
DRESSES = {
    "lists": "offsets: [0, 0, deg(-90), 0, 0, 0]\nsign_corrections: [-1, 1, 1, -1, 1, -1]\n",
    "one by one": "p.offsets[2] = -M_PI / 2.0;\n"
    + "".join(f"p.sign_corrections[{k}] = -1;\n" for k in (0, 3, 5)),
    "in words": "offsets[2] = -M_PI / 2.0\nSign correction: J1=J4 =J6 = -1\n",
}


def drawn(q):
    """The end of Brandstötter, Angerer and Hofbaur's arm, upright at zero."""
    p = LENGTHS
    x = np.array([-1, 1, 1, -1, 1, -1]) * q - [0, 0, -np.pi / 2, 0, 0, 0]
    steps = [
        turn([0, 0, x[0]]),
        shift([p["a1"], p["b"], p["c1"]]) @ turn([0, x[1], 0]),
        shift([0, 0, p["c2"]]) @ turn([0, x[2], 0]),
        shift([p["a2"], 0, p["c3"]]) @ turn([0, 0, x[3]]),
        turn([0, x[4], 0]),
        turn([0, 0, x[5]]) @ shift([0, 0, p["c4"]]),
    ]
    return np.linalg.multi_dot(steps)


@pytest.mark.parametrize("dress", DRESSES)
def test_offsets_and_signs_are_read(dress):
    arm = dh.recognise_table("opw parameters\n" + TEXT + DRESSES[dress]).arm
    for q in np.random.default_rng(1).uniform(-2, 2, (5, 6)):
        assert np.allclose(arm.forward(q), drawn(q), atol=1e-9)
