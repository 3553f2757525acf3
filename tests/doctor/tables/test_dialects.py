"""Tables pasted in other dialects: the library's arms written in many ways, by a writer that shares
nothing with the reader.
"""

from fractions import Fraction
from itertools import product

import numpy as np
import pytest
from draws import few, shared_out

import dhlab as dh
from dhlab.doctor.tables.cells import read_cell
from dhlab.doctor.tables.recognise import recognise_table

# 710 mm of the CRX-10iA/L are 452 quarter turns to four digits
ARMS = sorted({*few(dh.robots(), 9), "crx10ia_l"})
ORDERS = [
    "theta d a alpha",
    "a alpha d theta",
    "alpha a d theta",
    "a d alpha theta",
    "alpha a theta d",
    "theta a d alpha",
]
HEADS = {
    "standard": {"theta": "θ", "d": "d", "a": "a", "alpha": "α"},
    "craig": {"theta": "θ_i", "d": "d_i", "a": "a_{i-1}", "alpha": "α_{i-1}"},
}


def plain_arm(name):
    """An arm of the library without base and tool."""
    arm = dh.load(name)
    return dh.Arm(arm.table, sign=arm.sign)


def as_pi(value):
    """π/2 and its like where the angle is one; all digits otherwise."""
    share = Fraction(value / np.pi).limit_denominator(12)
    if abs(float(share) * np.pi - value) > 1e-12 or not share:
        return repr(float(value))
    top = {1: "π", -1: "-π"}.get(share.numerator, f"{share.numerator}*π")
    return top if share.denominator == 1 else f"{top}/{share.denominator}"


def written(arm, order, angle="rad", length="m", symbol="q{i}", mark=""):
    """The cells of every row as texts."""
    t = arm.table
    turn = as_pi if angle == "rad" else lambda value: f"{np.rad2deg(value):.12g}{mark}"
    size = (
        (lambda value: repr(float(value)))
        if length == "m"
        else (lambda value: f"{1000 * value:.12g}")
    )
    for i in range(len(arm)):
        cells = {
            "theta": turn(t.theta[i]),
            "d": size(t.d[i]),
            "a": size(t.a[i]),
            "alpha": turn(t.alpha[i]),
        }
        moved = "d" if t.joints[i] == "P" else "theta"
        if symbol:
            name = f"d{i + 1}" if moved == "d" else symbol.format(i=i + 1)
            value = {"theta": t.theta, "d": t.d}[moved][i]
            offset = (
                ""
                if value == 0
                else cells[moved]
                if cells[moved].startswith("-")
                else f" + {cells[moved]}"
            )
            cells[moved] = ("-" if arm.sign[i] < 0 else "") + name + offset
        yield [cells[name] for name in order.split()]


def text(rows, separator=" | ", head=None, index=None):
    """Lines of cells, with a header and row numbers where asked."""
    rows = [[str(k + index), *row] if index is not None else row for k, row in enumerate(rows)]
    lines = [
        separator.join(row)
        for row in ([["i", *head] if index is not None else head] if head else []) + rows
    ]
    return "\n".join(f"| {line} |" for line in lines) if separator == " | " else "\n".join(lines)


def close(a, b):
    q = np.random.default_rng(1).uniform(-2, 2, (4, len(a)))
    return len(a) == len(b) and np.allclose(a.forward(q), b.forward(q), rtol=0, atol=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("name", ARMS)
@pytest.mark.parametrize("separator", [" | ", "\t", ", ", ";"])
def test_with_a_header_one_reading_is_left_and_it_is_the_arm(name, separator):
    arm = plain_arm(name)
    ways = product(
        ORDERS[:4],
        [("rad", "m", ""), ("deg", "mm", "°"), ("deg", "m", "")],
        [("θ{i}*", 1), ("q{i}", None)],
    )
    # each way is read of five or six arms
    for order, (angle, length, mark), (symbol, index) in shared_out(ways, ARMS.index(name), 3):
        units = {"theta": {"deg": " (deg)", "rad": " [rad]"}[angle], "d": f" ({length})"}
        units |= {"alpha": units["theta"], "a": units["d"]}
        head = [HEADS[arm.table.convention][k] + units[k] for k in order.split()]
        found = recognise_table(
            text(written(arm, order, angle, length, symbol, mark), separator, head, index),
            convention=arm.table.convention,
        )
        assert len(found.readings) == 1 and not found.questions and close(found.arm, arm), (
            order,
            angle,
            str(found),
        )
        assert found.arm.table.joints == arm.table.joints


@pytest.mark.slow
@pytest.mark.parametrize("name", ARMS)
def test_without_a_header_the_right_arm_picks_the_reading(name):
    arm = plain_arm(name)
    ways = product(ORDERS, [("rad", "m"), ("deg", "mm")], [("  ", None), ("\t", 1), (", ", 0)])
    # each way is read of two arms or three
    for order, (angle, length), (separator, index) in shared_out(ways, ARMS.index(name), 4):
        said = (
            text(written(arm, order, angle, length, "θ{i}"), separator, None, index).replace(
                " + ", "+"
            )
            if separator == "  "
            else text(written(arm, order, angle, length, "θ{i}"), separator, None, index)
        )
        found = recognise_table(said, arm)
        assert found.matches and len(found.readings) == 1 and close(found.arm, arm), (
            order,
            angle,
            said,
            str(found),
        )
        alone = recognise_table(said)
        assert any(close(reading.arm, arm) for reading in alone.readings)
        assert (len(alone.readings) == 1) == (not alone.questions)


@pytest.mark.parametrize("name", ["ur5e", "panda", "irb120", "article-6r", "piper"])
def test_the_telling_configuration_tells(name):
    arm = plain_arm(name)
    found = recognise_table(text(written(arm, "a alpha d theta", "deg", "mm", "q{i}"), "\t"))
    assert (
        len(found.readings) >= 2
        and "standard one or" not in str(found)
        and any("Craig" in question for question in found.questions)
    )
    for k, one in enumerate(found.poses):
        assert np.allclose(one, found.readings[k].arm.forward(found.tell_apart))
        assert all(np.abs(one - other).max() > 1e-3 for other in found.poses[k + 1 :])


def test_frankas_table_with_its_flange():
    said = """a (m)   d (m)   α (rad)   θ (rad)
    Joint 1   0        0.333    0      θ1
    Joint 2   0        0       -π/2    θ2
    Joint 3   0        0.316    π/2    θ3
    Joint 4   0.0825   0        π/2    θ4
    Joint 5  -0.0825   0.384   -π/2    θ5
    Joint 6   0        0        π/2    θ6
    Joint 7   0.088    0        π/2    θ7
    Flange    0        0.107    0      0"""
    said = said.replace("Joint ", "Joint")
    found = recognise_table(said, convention="craig")
    assert (
        len(found.readings) == 1
        and len(found.arm) == 7
        and np.isclose(found.arm.tool[2, 3], 0.107)
        and "flange" in found.readings[0].words
    )
    panda = dh.load("panda")
    assert dh.equivalent(panda, found.arm, tool="free")
    assert (
        recognise_table(said, panda).matches
        and recognise_table(said, panda).arm.table.convention == "craig"
    )


def test_toolboxes_and_tex():
    toolbox = """robot = DHRobot([
        RevoluteDH(d=0.1, alpha=pi/2),
        RevoluteDH(a=0.4),
        PrismaticDH(theta=-pi/2, alpha=0)])"""
    found = recognise_table(toolbox)
    assert (
        found.arm.table.joints == "RRP"
        and len(found.readings) == 1
        and found.arm.table.convention == "standard"
    )
    assert (
        recognise_table(
            "RevoluteMDH(d=0.1, alpha=0)\nRevoluteMDH(a=0.4, alpha=pi/2)"
        ).arm.table.convention
        == "craig"
    )
    matlab = "dhparams = [0 pi/2 0.1 0; 0.4 0 0 0; 0.35 0 0 0]"
    answer = recognise_table(matlab, order="a alpha d theta", convention="standard")
    assert np.allclose(
        answer.arm.table.rows, [[0, 0.1, 0, np.pi / 2], [0, 0, 0.4, 0], [0, 0, 0.35, 0]]
    )
    tex = (
        "$i$ & $\\theta_i$ & $d_i$ & $a_i$ & $\\alpha_i$ \\\\ \\hline\n1 & $q_1$ & 0.1 & 0 &"
        " $\\pi/2$ \\\\\n2 & $q_2$ & 0 & 0.4 & 0 \\\\"
    )
    assert np.allclose(
        recognise_table(tex, convention="standard").arm.table.rows,
        [[0, 0.1, 0, np.pi / 2], [0, 0, 0.4, 0]],
    )


def test_numbers_and_lists_are_taken_too():
    rows = [[0, 0.1, 0, 90], [0, 0, 0.4, 0], [0, 0.1, 0, -90]]
    for given in (rows, np.array(rows), [tuple(map(str, row)) for row in rows]):
        found = recognise_table(given, order="theta d a alpha", convention="standard")
        assert np.allclose(found.arm.table.rows, np.array(rows) * [np.pi / 180, 1, 1, np.pi / 180])


def test_patterns_are_noted():
    mixed = recognise_table(
        "0 0.1 0 1.5708\n0 0 0.4 0\n0 0.3 0.2 90", order="theta d a alpha", convention="standard"
    )
    assert np.allclose(mixed.arm.table.alpha, [np.pi / 2, 0, np.pi / 2])
    assert "degrees in a radian column" in str(mixed) and "1.5708 is meant as it stands" in str(
        mixed
    )
    positive = recognise_table(
        [[0, 0.1, 0, 90], [0, 0.2, 0.4, 0], [0, 0.1, 0.3, 90]],
        order="theta d a alpha",
        convention="standard",
    )
    assert "no number is negative" in str(positive)
    with_a_minus = recognise_table(
        [[0, 0.1, 0, -90], [0, 0.2, 0.4, 0], [0, 0.1, 0.3, 90]],
        order="theta d a alpha",
        convention="standard",
    )
    assert "is negative" not in str(with_a_minus)
    wrong = recognise_table(
        text(written(plain_arm("irb120"), "theta d a alpha"), "\t"), plain_arm("ur5e")
    )
    assert wrong.matches is False and "no reading is the right arm" in str(wrong)


def test_columns_that_changed_places_are_noted():
    found = recognise_table(
        "theta d a alpha\nq1 0.1 1.5708 0.03\nq2 0 0 0.4", convention="standard"
    )
    assert "a and alpha" in str(found) and "changed places" in str(found)
    assert "changed places" not in str(
        recognise_table("theta d a alpha\nq1 0.1 0.03 1.5708\nq2 0 0.4 0", convention="standard")
    )


BOX = """Example: 2 axes (RR), standard DH parameters
┌─────┬──────┬──────┬────────┐
│ θⱼ  │  dⱼ  │  aⱼ  │   ⍺ⱼ   │
├─────┼──────┼──────┼────────┤
│ q1  │  0.1 │    0 │  90.0° │
│ q2  │    0 │  0.4 │   0.0° │
└─────┴──────┴──────┴────────┘
"""
BOX_CRAIG = BOX.replace("standard", "modified").replace("aⱼ ", "aⱼ₋₁ ").replace("⍺ⱼ ", "⍺ⱼ₋₁ ")
MATLAB_TOOLBOX = """Example:: 2 axis, RR, stdDH, slowRNE
+---+-----------+-----------+-----------+-----------+-----------+
| j |     theta |         d |         a |     alpha |    offset |
+---+-----------+-----------+-----------+-----------+-----------+
|  1|         q1|        0.1|          0|     1.5708|          0|
|  2|         q2|          0|        0.4|          0|     1.5708|
+---+-----------+-----------+-----------+-----------+-----------+
"""


def test_what_toolboxes_print():
    rows = np.array([[0, 0.1, 0, np.pi / 2], [0, 0, 0.4, 0]])
    for said, convention in ((BOX, "standard"), (BOX_CRAIG, "craig")):
        found = recognise_table(said)
        assert (
            len(found.readings) == 1
            and found.arm.table.convention == convention
            and np.allclose(found.arm.table.rows, rows)
        )
    found = recognise_table(MATLAB_TOOLBOX, convention="standard")
    assert len(found.readings) == 1 and np.allclose(
        found.arm.table.rows, rows + [[0, 0, 0, 0], [np.pi / 2, 0, 0, 0]]
    )


def test_decimal_commas_of_a_spreadsheet():
    found = recognise_table("theta;d;a;alpha\n0;0,1;0;90\n0;0;0,4;0", convention="standard")
    assert np.allclose(found.arm.table.d, [0.1, 0]) and np.allclose(found.arm.table.a, [0, 0.4])


@pytest.mark.parametrize(
    "given, words",
    [
        ("", "at least one row"),
        ("hello world", "at least one row"),
        (7, "found int"),
        ("1 2 3\n4 5 6", "four numbers"),
        ("0 0 0 90\n0 0 0", "as many cells"),
        ("theta d a alpha\n0 0 0 __import__('os')", "line 2"),
        ("theta d a alpha\n0 0 0 (1).__class__", "line 2"),
        ([[0, 0, 0, float("nan")]], "finite"),
        ("theta d a\n0 0 0", "no column alpha"),
        ("x" * 70_000, "one table"),
        ("0 0.3 0.4 0.2\n0 0.35 0.1 0.7", "no order"),
        ("theta,d,a,alpha\n0,,0,90", "empty cell"),
        ("theta d a alpha\n0 0 0 1/0", "line 2"),
        ({}, "found dict"),
        ([["(" * 39, 0, 0, 0]], "row"),
        ("0 0 0 0\n" * 100, "at most"),
    ],
)
def test_errors_are_one_sentence(given, words):
    with pytest.raises(ValueError) as error:
        recognise_table(given)
    assert (
        words in str(error.value) and "\n" not in str(error.value) and len(str(error.value)) < 300
    )


@pytest.mark.parametrize(
    "options, words",
    [
        ({"order": "theta d a"}, "order"),
        ({"convention": "modified"}, "standard or craig"),
        ({"angle": "grad"}, "deg or rad"),
        ({"length": "inch"}, "mm or cm or m or in"),
    ],
)
def test_wrong_options_are_said(options, words):
    with pytest.raises(ValueError, match=words):
        recognise_table("0 0.1 0 90", **options)


@pytest.mark.slow
def test_noise_never_crashes():
    rng = np.random.default_rng(4)
    letters = list("0123456789.,;|\t\n -+*/()πθqdaα°i_=[]%#e")
    for _ in few(range(3000), 300):  # most are no table at the first look
        said = "".join(rng.choice(letters, rng.integers(1, 60)))
        for read in (recognise_table, read_cell):
            fault = None
            try:
                read(said)
            except ValueError as error:
                fault = str(error)
            assert fault is None or fault.startswith(("recognise_table", "expected")), said


LINK = """
def link(theta, d, a, alpha):
    ct, st, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    return np.array([[ct, -st*ca, st*sa, a*ct], [st, ct*ca, -ct*sa, a*st],
                     [0, sa, ca, d], [0, 0, 0, 1]])
rows = [[0, 0.3, 0.1, 1.5], [0, 0, 0.4, 0], [0, {d}, 0, 0]]
for i, (theta, d, a, alpha) in enumerate(rows):
"""
IN_ONE = """    if i == 2:
        T = T @ link(theta, {moved}, a, alpha)
    else:
        T = T @ link(theta + q[i], d, a, alpha)
"""
CHOSEN = """    T = T @ (link(theta, q[i], a, alpha) if i == 2 else link(theta + q[i], d, a, alpha))
"""
ASSIGNED = """    if i == 2:
        d += q[i]
    else:
        theta += q[i]
    T = T @ link(theta, d, a, alpha)
"""


@pytest.mark.parametrize(
    "d, text",
    [
        ("0", IN_ONE.format(moved="q[i]")),
        ("0.2", IN_ONE.format(moved="d + q[i]")),
        ("0", CHOSEN),
        ("0.2", ASSIGNED),
    ],
)
def test_a_joint_that_slides_in_one_branch_alone_slides(d, text):
    arm = dh.recognise_table(LINK.format(d=d) + text).arm
    assert arm.table.joints == "RRP" and arm.table.d[2] == float(d)


@pytest.mark.parametrize(
    "d, text, words",
    [
        ("0.2", IN_ONE.format(moved="q[i]"), "row 3 has a d of its own"),
        ("0", IN_ONE.format(moved="q[i]").replace("i == 2", "kind[i] == 'P'"), "which rows slide"),
    ],
)
def test_a_branch_that_leaves_open_which_joint_slides_is_asked_about(d, text, words):
    with pytest.raises(ValueError, match=words):
        dh.recognise_table(LINK.format(d=d) + text)
