"""Link functions of a text: in whatever way their matrix is filled, and where a second one has a
turn of its own built in. The judge is the product of the moves, multiplied out by the test.
"""

import numpy as np
import pytest

from dhlab.doctor import recognise_table
from tests.doctor.tables.test_forms import is_the_form

UP = """[[cos(t), -sin(t)*cos(b), sin(t)*sin(b), a*cos(t)],
            [sin(t), cos(t)*cos(b), -cos(t)*sin(b), a*sin(t)],
            [0, sin(b), cos(b), d], [0, 0, 0, 1]]"""
ASIDE = """[[sin(t), cos(t)*cos(b), -cos(t)*sin(b), a*sin(t)],
            [-cos(t), sin(t)*cos(b), -sin(t)*sin(b), -a*cos(t)],
            [0, sin(b), cos(b), d], [0, 0, 0, 1]]"""
LINKS = f"def link(t, d, a, b):\n    return np.array({UP})\n"
ELBOW = f"def elbow(t, d, a, b):\n    return np.array({ASIDE})\n"
ROWS = "dh = [[0, 0.31, 0, pi/2], [0, 0, 0.42, 0], [0, 0, 0.13, pi/2]]  # theta, d, a, alpha, m\n"
HALF = np.pi / 2


def arm_with(*zeros):
    """What the texts below describe, with these zeros."""
    lengths = ((0.31, 0, HALF), (0, 0.42, 0), (0, 0.13, HALF))
    rows = [(zero, *row) for zero, row in zip(zeros, lengths)]
    return {"convention": "standard", "rows": rows, "joints": "RRR", "sign": [1, 1, 1]}


@pytest.mark.parametrize(
    "program, zeros",
    [
        ("for i in range(3):\n    f = elbow if i == 1 else link\n", None),
        (
            "for i, row in enumerate(dh):\n    if i == 1:\n        A = elbow(q[i], *row[1:])\n"
            "    else:\n        A = link(q[i], *row[1:])\n    T = T @ A\n",
            (0, -HALF, 0),
        ),
        (
            "for i in range(3):\n    if i != 0:\n        A = link(q[i], *dh[i][1:])\n"
            "    else:\n        A = elbow(q[i], *dh[i][1:])\n    T = T @ A\n",
            (-HALF, 0, 0),
        ),
        (
            "for i in range(3):\n"
            "    T = T @ (elbow(q[i], *dh[i][1:]) if i == 2 else link(q[i], *dh[i][1:]))\n",
            (0, 0, -HALF),
        ),
        (
            "T = elbow(q[0], *dh[0][1:]) @ link(q[1], *dh[1][1:]) @ link(q[2], *dh[2][1:])\n",
            (-HALF, 0, 0),
        ),
        ("T = elbow(p, *first)\nfor row in rest:\n    T = T @ link(q, *row)\n", None),
    ],
)
def test_a_second_link_function_gives_its_turn_to_the_rows_it_is_called_for(program, zeros):
    text = LINKS + ELBOW + ROWS + program
    if zeros:
        assert is_the_form(recognise_table(text).arm, arm_with(*zeros))
    elif "elbow(" in program:
        with pytest.raises(ValueError, match=r"elbow adds -1\.5708.*for which rows"):
            recognise_table(text)
    else:  # nothing of it is called
        assert is_the_form(recognise_table(text).arm, arm_with(0, 0, 0))


def test_calls_of_two_link_functions_are_rows_of_one_arm():
    calls = (
        "T1 = link(q1, 0.31, 0, pi/2)  # m\nT2 = elbow(q2, 0, 0.42, 0)\n"
        "T3 = link(q3, 0, 0.13, pi/2)\n"
    )
    assert is_the_form(recognise_table(LINKS + ELBOW + calls).arm, arm_with(0, -HALF, 0))
    numbers = calls.replace("q1", "0").replace("q2", "0").replace("q3", "0")
    assert is_the_form(recognise_table(LINKS + ELBOW + numbers).arm, arm_with(0, -HALF, 0))


def test_a_second_matrix_that_is_no_link_of_denavit_and_hartenberg_is_asked_about():
    odd = ELBOW.replace("-cos(t), sin(t)", "-cos(t), 2*sin(t)")
    program = "if i == 1: A = elbow(q[i], *dh[i][1:])\nelse: A = link(q[i], *dh[i][1:])\n"
    with pytest.raises(ValueError, match="link function elbow, whose matrix is none"):
        recognise_table(LINKS + odd + ROWS + program)


CRAIG = {
    "Unity, rows": """
        m.SetRow(0, new Vector4(Mathf.Cos(t), -Mathf.Sin(t), 0, a));
        m.SetRow(1, new Vector4(Mathf.Sin(t) * Mathf.Cos(al), Mathf.Cos(t) * Mathf.Cos(al),
                                -Mathf.Sin(al), -d * Mathf.Sin(al)));
        m.SetRow(2, new Vector4(Mathf.Sin(t) * Mathf.Sin(al), Mathf.Cos(t) * Mathf.Sin(al),
                                Mathf.Cos(al), d * Mathf.Cos(al)));
        m.SetRow(3, new Vector4(0, 0, 0, 1));""",
    "shaders, columns": """
        m[0] = vec4(cos(t), sin(t) * cos(al), sin(t) * sin(al), 0);
        m[1] = vec4(-sin(t), cos(t) * cos(al), cos(t) * sin(al), 0);
        m[2] = vec4(0, -sin(al), cos(al), 0);
        m[3] = vec4(a, -d * sin(al), d * cos(al), 1);""",
    "fields": """
        m.m00 = Cos(t); m.m01 = -Sin(t); m.m02 = 0; m.m03 = a;
        m.m10 = Sin(t) * Cos(al); m.m11 = Cos(t) * Cos(al); m.m12 = -Sin(al); m.m13 = -d * Sin(al);
        m.m20 = Sin(t) * Sin(al); m.m21 = Cos(t) * Sin(al); m.m22 = Cos(al); m.m23 = d * Cos(al);
        """,
    "Eigen": """
        m.row(0) << cos(t), -sin(t), 0, a;
        m.row(1) << sin(t) * cos(al), cos(t) * cos(al), -sin(al), -d * sin(al);
        m.row(2) << sin(t) * sin(al), cos(t) * sin(al), cos(al), d * cos(al);
        m.row(3) << 0, 0, 0, 1;""",
    "MATLAB": """
        T(1,:) = [cos(t) -sin(t) 0 a];
        T(2,:) = [sin(t)*cos(al) cos(t)*cos(al) -sin(al) -d*sin(al)];
        T(3,:) = [sin(t)*sin(al) cos(t)*sin(al) cos(al) d*cos(al)];
        T(4,:) = [0 0 0 1];""",
}
CALLS = "T1 = Link(q1, 0.31, 0, 0);\nT2 = Link(q2, 0, 0.12, PI/2);\nT3 = Link(q3, 0.3, 0, -PI/2);\n"
DEFINED = "Matrix4x4 Link(float t, float d, float a, float al) {{\n{}\n}}\n"


@pytest.mark.parametrize("filled", CRAIG.values(), ids=CRAIG)
def test_a_matrix_that_is_filled_line_by_line_says_the_convention(filled):
    found = recognise_table(DEFINED.format(filled) + CALLS)
    assert {reading.arm.table.convention for reading in found.readings} == {"craig"}
    doubtful = recognise_table("// the standard table\n" + DEFINED.format(filled) + CALLS)
    assert "convention" in doubtful.open  # the comment says one, the program the other


def test_beside_a_matrix_that_cannot_be_read_words_leave_the_convention_open():
    odd = CRAIG["Eigen"].replace("m.row(0) << cos(t)", "m.row(0) << camber(t) * cos(t)")
    found = recognise_table("// the standard table, m\n" + DEFINED.format(odd) + CALLS)
    assert found.open == ("convention",) and "could not be read" in str(found)


@pytest.mark.parametrize(
    "functions",
    [
        LINKS + "def elbow(t, d, a, b):\n    return link(t - pi/2, d, a, b)\n",
        LINKS + ELBOW.replace(ASIDE, UP).replace("    return", "    t = t - pi/2\n    return"),
    ],
    ids=["a function around the first", "a statement before the matrix"],
)
def test_a_turn_before_the_matrix_counts_as_one_within_it(functions):
    program = "for i in range(3):\n    A = elbow(q[i], *dh[i][1:]) if i == 1 else link(q[i], 0)\n"
    assert is_the_form(recognise_table(functions + ROWS + program).arm, arm_with(0, -HALF, 0))


def test_calls_with_an_index_say_their_row():
    arrays = "a = [0, 0.42, 0.13]\nd = [0.31, 0, 0]\nalpha = [pi/2, 0, pi/2]\n"
    calls = [
        f"T = {name}(q[{k}], d[{k}], a[{k}], alpha[{k}])\n"
        for k, name in enumerate(("link", "elbow", "link"))
    ]
    found = recognise_table("# metres\n" + LINKS + ELBOW + arrays + "".join(calls))
    assert is_the_form(found.arm, arm_with(0, -HALF, 0)), str(found)


def test_a_function_with_two_matrices_is_asked_about():
    both = LINKS.replace(
        "    return", f"    if aside:\n        return np.array({ASIDE})\n    return"
    )
    program = "for i in range(3):\n    A = link(q[i], *dh[i][1:])\n"
    with pytest.raises(ValueError, match="link function link, whose matrix"):
        recognise_table(both + ROWS + program)
