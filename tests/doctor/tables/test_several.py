"""Two arms in one text are asked about, however they are written: never the first in silence."""

import pytest

from dhlab import recognise_table

ONE = (("q1", 0.42, 0.06, "-pi/2"), ("q2", 0.0, 0.31, "0"), ("q3", 0.03, 0.045, "-pi/2"))
TWO = (("q1", 0.29, 0.0, "-pi/2"), ("q2", 0.0, 0.27, "0"), ("q3", 0.07, 0.302, "pi/2"))


def called(rows):
    return "".join(f"    T{i} = dh({t}, {d}, {a}, {al})\n" for i, (t, d, a, al) in enumerate(rows))


def linked(rows):
    return "".join(f"    RevoluteDH(d={d}, a={a}, alpha={al}),\n" for _, d, a, al in rows)


def listed(rows):
    return "".join(f"    {{'d': {d}, 'a': {a}, 'alpha': {al}}},\n" for _, d, a, al in rows)


def barred(rows):
    return "".join(f"| {t} | {d} | {a} | {al} |\n" for t, d, a, al in rows)


def matrix(rows):
    return "".join(f"  [0, {d}, {a}, {al}],\n" for _, d, a, al in rows)


def named(rows):
    return "".join(
        f"d{i} = {d}; a{i} = {a}; alpha{i} = {al}\n" for i, (_, d, a, al) in enumerate(rows, 1)
    )


FORMS = {
    "calls": lambda one, two: (
        "def dh(theta, d, a, alpha):  # standard\n    pass\n"
        f"def left(q1, q2, q3):\n{called(one)}def right(q1, q2, q3):\n{called(two)}"
    ),
    "links": lambda one, two: (
        f"class Left:\n  links = [\n{linked(one)}  ]\nclass Right:\n  links = [\n{linked(two)}  ]\n"
    ),
    "links, by name": lambda one, two: (
        f"def left():\n    L = [{linked(one)}]\ndef right():\n    M = [{linked(two)}]\n"
    ),
    "dictionaries": lambda one, two: (
        f"# standard\nleft = [\n{listed(one)}]\nright = [\n{listed(two)}]\n"
    ),
    "tables": lambda one, two: (
        "standard DH\n| theta | d | a | alpha |\n|--|--|--|--|\n"
        f"{barred(one)}\nthe other arm\n\n{barred(two)}"
    ),
    "matrices": lambda one, two: (
        f"# standard: theta, d, a, alpha\nA = [\n{matrix(one)}]\nB = [\n{matrix(two)}]\n"
    ),
    "named numbers": lambda one, two: f"# standard\n# left\n{named(one)}# right\n{named(two)}",
}


@pytest.mark.parametrize("form", FORMS)
def test_two_arms_are_asked_about(form):
    with pytest.raises(ValueError, match=r"one .*found.*\?"):
        recognise_table(FORMS[form](ONE, TWO))


@pytest.mark.parametrize("form", ["calls", "dictionaries", "matrices", "named numbers"])
def test_one_arm_that_stands_twice_is_one(form):
    found = recognise_table(FORMS[form](ONE, ONE))
    assert [len(reading.arm) for reading in found.readings] == [3]


def test_a_letter_of_the_rows_that_has_two_values_is_asked_about():
    rows = "# standard: theta, d, a, alpha\ndh = [[q1, L1, 0, 90], [q2, 0, 0.3, 0]]\n"
    with pytest.raises(ValueError, match=r"0\.1 in line 1 and 0\.2 in line 4; which one"):
        recognise_table(f"L1 = 0.1\n{rows}L1 = 0.2\n")
    assert len(recognise_table(f"L1 = 100\n{rows}L1 = L1 / 1000\n").arm) == 2


def test_another_matrix_of_four_columns_is_no_second_arm():
    links = "% standard\nL1 = 0.1;\nL(1) = Link([0 L1 0 pi/2]);\nL(2) = Link([0 0 0.3 0]);\n"
    faces = "R = SerialLink(L);\nfaces = [1 2 3 4; 5 6 7 8; 1 2 6 5; 2 3 7 6];\n"
    assert len(recognise_table(links + faces).arm) == 2
    with pytest.raises(ValueError, match="L1 has no value"):
        recognise_table(links.replace("L1 = 0.1;\n", "") + faces)


@pytest.mark.parametrize(
    "beside",
    [
        "waypoints = [[0.1, 0.2, 0.3, 90], [0.2, 0.2, 0.3, 90], [0.1, 0.4, 0.3, 0]]\n",
        "T = [[1, 0, 0, 0.3], [0, 0, -1, 0.2], [0, 1, 0, 0.5], [0, 0, 0, 1]]\n",
        "limits = [[-170, 170, 120, 50], [-90, 90, 120, 50], [-90, 90, 120, 50]]\n",
        "q_test = [0.1, 0.2, 0.3]\nprint('(', fk(q_test))\n",
        "pi = 3.14159\npi = 3.141592653\n",
    ],
)
def test_other_numbers_of_a_program_are_no_second_arm(beside):
    rows = f"# standard: theta, d, a, alpha\ndh = [\n{matrix(ONE)}]\n"
    assert [len(reading.arm) for reading in recognise_table(rows + beside).readings] == [3]
