"""Rows that a program changes after it has written them: the truth is multiplied out here."""

import numpy as np
import pytest

import dhlab as dh
from tests.oracles import shift, turn

ROWS = [(0.0, 0.31, 0.0, np.pi / 2), (0.0, 0.0, 0.27, 0.0), (0.0, 0.12, 0.05, 0.0)]
LONGER = [*ROWS[:2], (0.0, 0.2, 0.05, 0.0)]
LISTED = """
import numpy as np
# theta, d, a, alpha
arm = [[0, 0.31, 0, np.pi / 2],
       [0, 0, 0.27, 0],
       [0, 0.12, 0.05, 0]]
"""
NAMED = """
import numpy as np
arm = [dict(d=0.31, a=0, alpha=np.pi / 2), dict(d=0, a=0.27, alpha=0),
       dict(d=0.12, a=0.05, alpha=0)]
"""
BY_PARAMETER = """
import numpy as np
d = [0.31, 0, 0.12]
a = [0, 0.27, 0.05]
alpha = [np.pi / 2, 0, 0]
"""
LINK = """
def link(th, d, a, al):
    c, s, ca, sa = np.cos(th), np.sin(th), np.cos(al), np.sin(al)
    return np.array([[c, -s*ca, s*sa, a*c], [s, c*ca, -c*sa, a*s], [0, sa, ca, d], [0, 0, 0, 1]])
"""
CHAIN = """
def forward(q):
    T = np.eye(4)
    for k, (th, d, a, al) in enumerate(arm):
        T = T @ link(th + q[k], d, a, al)
    return T
"""


def is_arm(found, rows):
    """Whether the one reading of a text is the arm of rows, all of whose joints turn."""
    assert len(found.readings) == 1, str(found)
    q = np.random.default_rng(4).uniform(-1, 1, (5, len(rows)))
    expected = []
    for values in q:
        T = np.eye(4)
        for (theta, d, a, alpha), value in zip(rows, values):
            T = T @ turn([0, 0, theta + value]) @ shift([a, 0, d]) @ turn([alpha, 0, 0])
        expected.append(T)
    return np.allclose(found.arm.forward(q), expected, rtol=0, atol=1e-9)


@pytest.mark.parametrize(
    "change",
    [
        "arm[2][1] += 0.08",
        "arm[-1][1] = arm[-1][1] + 0.08  # gripper",
        "arm[2] = [0, 0.2, 0.05, 0]",
        "for k, row in enumerate(arm):\n    if k == 2:\n        row[1] += 0.08",
        "def with_tool(rows, length):\n    rows[2][1] += length\nwith_tool(arm, 0.08)",
        "arm = np.array(arm)\narm[2, 1] += 0.08",
        "arm = [[t, d + 0.08 * (a == 0.05), a, w] for t, d, a, w in arm]",
    ],
)
@pytest.mark.parametrize("more", [LINK, LINK + CHAIN])
def test_the_last_numbers_of_rows_count(change, more):
    """Changed in place, replaced, by a function, or made anew; with a product and without."""
    found = dh.recognise_table(LISTED + change + "\n" + more)
    assert is_arm(found, LONGER)


@pytest.mark.parametrize(
    "rows, change",
    [
        (NAMED, "arm[2]['d'] += 0.08"),
        (NAMED, "arm[-1].update(d=0.2)"),
        (BY_PARAMETER, "d[2] += 0.08"),
        (BY_PARAMETER, "d = np.array(d)\nd[-1] = 0.2"),
    ],
)
def test_the_last_numbers_of_names_count(rows, change):
    """Dictionaries, and an array for each parameter."""
    found = dh.recognise_table(rows + change + LINK, convention="standard")
    assert is_arm(found, LONGER)
    assert any("later" in note for note in found.notes)


def test_a_change_stands_in_the_unit_of_the_rows():
    """Millimetres and degrees that are converted in place, and a tool in metres."""
    found = dh.recognise_table(
        """
import numpy as np
# theta d a alpha (deg, mm)
arm = np.array([[0, 310.0, 0, 90], [0, 0, 270, 0], [0, 120, 50, 0]])
arm[:, 1:3] /= 1000
arm[:, 3] = np.radians(arm[:, 3])
arm[2, 1] += 0.08
"""
        + LINK
    )
    assert is_arm(found, LONGER)


def test_a_change_in_matlab_counts():
    """Indices from one, in round brackets."""
    found = dh.recognise_table(
        """
% theta d a alpha
arm = [0 0.31 0 pi/2; 0 0 0.27 0; 0 0.12 0.05 0];
arm(3,2) = arm(3,2) + 0.08;
""",
        convention="standard",
    )
    assert is_arm(found, LONGER)


@pytest.mark.parametrize("change", ["del arm[2]", "arm.pop()", "arm = arm[:2]"])
def test_rows_that_are_taken_away_are_no_links(change):
    """The product has them no more; without one it is asked."""
    assert is_arm(dh.recognise_table(f"{LISTED}{change}\n{LINK}{CHAIN}"), ROWS[:2])
    with pytest.raises(ValueError, match=r"number of rows .*which ones are meant\?"):
        dh.recognise_table(f"{LISTED}{change}\n{LINK}")


def test_rows_that_a_loop_appends_are_links():
    """One row is written, and one that is appended twice."""
    text = "import numpy as np\narm = [[0, 0.31, 0, np.pi / 2]]\n"
    text += "for _ in range(2):\n    arm.append([0, 0, 0.27, 0])\n"
    assert is_arm(dh.recognise_table(text + LINK + CHAIN), [ROWS[0], ROWS[1], ROWS[1]])
    with pytest.raises(ValueError, match=r"number of rows .*which ones are meant\?"):
        dh.recognise_table(text + LINK)


def test_what_is_converted_only_stays_as_it_is_written():
    """A conversion is no change of the arm, nor is a joint's value that is put into theta."""
    text = LISTED + "arm[1][0] = 0.3\nlengths = [[1e3 * d, 1e3 * a] for _, d, a, _ in arm]\n" + LINK
    assert is_arm(dh.recognise_table(text), ROWS)


def test_what_is_called_from_outside_changes_nothing():
    """A method that nobody calls may, or may not."""
    text = LISTED + "def reset(length=0.5):\n    arm[2][1] = length\n" + LINK
    assert is_arm(dh.recognise_table(text), ROWS)


@pytest.mark.parametrize(
    "copy", ["np.array(arm)", "copy.deepcopy(arm)", "[list(row) for row in arm]"]
)
def test_a_changed_copy_of_the_rows_is_asked_about(copy):
    """A perturbed table beside the nominal one; in a function it is one among many."""
    change = f"other = {copy}\nother[2][1] += 0.08\n"
    with pytest.raises(ValueError, match="changed ones in other; which ones are meant"):
        dh.recognise_table(LISTED + change + LINK)
    inside = (
        "def perturbed():\n    " + change.replace("\n", "\n    ") + "return other\nperturbed()\n"
    )
    assert is_arm(dh.recognise_table(LISTED + inside + LINK), ROWS)
