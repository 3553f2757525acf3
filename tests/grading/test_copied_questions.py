"""What a task gives, handed back as it is, earns nothing: it is not right, and no share of the
points is for it. What is work keeps its share.
"""

import numpy as np
import pytest

from dhlab import Arm, DHTable, load
from dhlab.course.exercises import exercises
from dhlab.course.kinds import Function, Prediction, PreTest
from dhlab.doctor.programs.running.calling import Called
from dhlab.grading.exports.nbgrader_cell import graded_check
from dhlab.grading.judging.shares import share
from dhlab.grading.settings import Settings

NUMBER = 2**32 + 777  # of somebody whose lesson was released
IN_DEGREES = [180 / np.pi, 1, 1, 180 / np.pi]
MAKERS = [  # as the cell of 09.3 types it
    [0, 0.16977, 0, 0],
    [-90, 0, 0.0642, -90],
    [0, -0.007, 0.305, 0],
    [0, 0.22263, 0, -90],
    [0, 0, 0, 90],
    [180, 0.041, 0, 180],
]
UPRIGHT = [  # as the cell of 06.6 has it, but for the two offsets
    [0, 0.1, 0, 90],
    [0, 0, 0.4, 0],
    [0, 0, 0.35, 0],
    [0, 0.1, 0, 90],
    [0, 0, 0, -90],
    [0, 0.1, 0, 0],
]
ASKED = [
    e
    for e in exercises().values()
    if e.points and not isinstance(e, (Function, Prediction, PreTest))
]


def earned(exercise, answer, number=NUMBER):
    verdict = exercise.judge(answer, number)
    return share(exercise, answer, number, verdict, Settings(partial=0.5))


def parts(value):
    """A thing that is given, and what it is made of."""
    yield value
    if isinstance(value, (DHTable, Arm)):
        rows = getattr(value, "table", value).rows
        yield from (rows, rows * IN_DEGREES)
    if isinstance(value, dict):
        yield from value.values()
    if isinstance(value, (list, tuple, np.ndarray)):
        yield from value


def dressed(value):
    """A thing as it is and, where it may be rows, as a table of either convention in any unit."""
    yield value
    try:
        rows = np.asarray(value, dtype=float)
    except (TypeError, ValueError):
        return
    if rows.ndim == 2 and rows.shape[1] == 4:
        for make in (DHTable.standard, DHTable.craig):
            for angle, length in (("deg", "m"), ("rad", "m"), ("deg", "mm"), ("rad", "mm")):
                table = make(rows, angle=angle, length=length)
                yield from (table, Arm(table))


@pytest.mark.parametrize("exercise", ASKED, ids=lambda exercise: exercise.id)
def test_what_is_given_is_no_answer(exercise):
    for value in exercise.given(NUMBER).values():
        for part in parts(value):
            for answer in dressed(part):
                assert earned(exercise, answer) == 0, answer


def rows_of(key, number=NUMBER):
    """The table that a task gives."""
    rows = list(exercises()[key].given(number).values())[-1]
    return np.array(rows) if isinstance(rows, list) else rows.rows * IN_DEGREES


@pytest.mark.parametrize("key", ["03.7", "03.8", "09.7"])
def test_nor_is_it_with_a_turn_more_or_with_what_the_lesson_fills_in(key):
    rows = rows_of(key)
    for turned in (rows + [360, 0, 0, 0], rows - [0, 0, 0, 360], rows + 1e-7):
        assert earned(exercises()[key], turned) == 0
    for k in (0, -1):  # the row without a link
        filled = rows.copy()
        filled[k, 2:] = 0
        assert earned(exercises()[key], filled) == 0


@pytest.mark.parametrize(
    "key, answer",
    [
        ("06.6", UPRIGHT),
        ("06.6", load("article-6r")),
        ("06.6", load("article-6r").to("craig")),
        ("09.3", MAKERS),
        ("09.3", Arm(DHTable.craig(MAKERS, angle="deg"), sign=[-1, *[1] * 5]).to("standard")),
        ("09.3", [*MAKERS[:5], [180, 0.041, 0, 45]]),
        ("09.2", load("ar4")),
        ("09.2", Arm(load("ar4").table, base=load("ar4").base, tool=load("ar4").tool)),
    ],
)
def test_a_table_that_the_lesson_shows_is_no_work(key, answer):
    assert earned(exercises()[key], answer) == 0


def test_a_half_converted_table_is_asked_in_craigs_convention():
    exercise = exercises()["03.9"]
    given = exercise.given(NUMBER)
    before = DHTable.standard(given["standard"], angle="deg")
    verdict = exercise.judge(before, NUMBER)
    assert verdict.status == "wrong"
    assert verdict.headline == "these are standard rows of the right arm; Craig's rows are asked"
    rows = np.array(given["converted"])
    rows[:, 2] = [0, *np.array(given["standard"])[:-1, 2]]
    assert earned(exercise, rows) == earned(exercise, DHTable.craig(rows, angle="deg")) == 1


def called(exercise, program):
    """What a program gave when it was called as in the grader."""
    answers = [np.array(program(*case)) for case in exercise.cases(7)]
    return Called(tuple(answers), answers[0])


def test_a_program_that_the_lesson_shows_is_no_work():
    """rot_z, which stands in a cell of 05, and the blog's program of 05.7."""

    def about_z(angle):
        c, s = np.cos(angle), np.sin(angle)
        return [[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]

    def other_way(angle):
        c, s = np.cos(angle), np.sin(angle)
        return [[1, 0, 0, 0], [0, c, s, 0], [0, -s, c, 0], [0, 0, 0, 1]]

    def of_the_blog(theta, d, a, alpha):
        ct, st, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
        rows = [ct, -st * ca, st * sa, a * ct], [st, ct * ca, ct * sa, a * st]
        return [*rows, [0, sa, ca, d], [0, 0, 0, 1]]

    about_x, of_moves = exercises()["05.1"], exercises()["05.4"]
    assert earned(about_x, called(about_x, about_z), 7) == 0
    assert earned(of_moves, called(of_moves, of_the_blog), 7) == 0
    assert earned(about_x, called(about_x, other_way), 7) == 0.5


def test_work_keeps_its_share():
    rows = rows_of("03.7")
    alpha_alone = np.column_stack([rows[:, :3], [0, *rows[:-1, 3]]])
    theta, a, d, alpha = rows_of("02.7").T
    in_order = np.column_stack([np.rad2deg(theta), d, a, np.rad2deg(alpha)])
    offsets = [UPRIGHT[0], [-90, *UPRIGHT[1][1:]], [90, *UPRIGHT[2][1:]], *UPRIGHT[3:]]
    work = {
        "03.7": alpha_alone,
        "02.7": in_order[:, [0, 2, 1, 3]],  # turned into degrees, in the printed order
        "06.6": offsets,
    }
    assert {key: earned(exercises()[key], answer) for key, answer in work.items()} == dict.fromkeys(
        work, 0.5
    )
    assert earned(exercises()["02.7"], in_order) == 1


def test_nbgrader_gives_what_is_given_no_more():
    for key in ("02.7", "03.7", "03.8", "09.7"):
        assert graded_check(2, 0.5)(key, rows_of(key, 0)) == 0
    assert graded_check(2, 0.5)("06.6", [*UPRIGHT[:2], [90, 0, 0.35, 0], *UPRIGHT[3:]]) == 1


def test_a_number_too_large_to_turn_is_no_unit():
    exercise = exercises()["09.7"]
    rows = exercise.right_arm(NUMBER).table.rows * IN_DEGREES
    rows[:, 3] = 1e308
    with np.errstate(all="ignore"):
        assert earned(exercise, rows) == 0
