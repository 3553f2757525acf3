"""Claims about tables and the arms that they describe; forward kinematics by scipy's rotations."""

import re
from itertools import permutations, product

import numpy as np
from oracles import elementary_pose
from scipy.optimize import least_squares

import dhlab as dh
from dhlab.course.kinds import as_arm

from . import typed
from .general import FACTORS
from .vectors import walk

COLUMN = {"θ": 0, "d": 1, "a": 2, "α": 3, "theta": 0, "alpha": 3}


def arm_of(answer, given):
    right = right_of(given)
    return as_arm(answer, right), right


def right_of(given):
    return given["exercise"].right_arm(given["variant"])


def ends(arm, q):
    """End poses of an arm, base and tool included, by another forward kinematics."""
    return np.array(
        [arm.base @ elementary_pose(arm.table, x, arm.sign) @ arm.tool for x in np.atleast_2d(q)]
    )


def some_q(n, seed=5):
    return np.random.default_rng(seed).uniform(0.3, 1.2, (4, n)) * [[1], [-1], [1], [-1]]


def same(one, other, by=1e-6):
    q = some_q(len(other))
    return np.allclose(ends(one, q), ends(other, q), atol=by)


def degrees_of(arm):
    table = arm.table
    return np.column_stack([np.degrees(table.theta), table.d, table.a, np.degrees(table.alpha)])


def with_rows(arm, rows):
    make = dh.DHTable.standard if arm.table.convention == "standard" else dh.DHTable.craig
    table = make(np.asarray(rows).tolist(), angle="deg", joints=arm.table.joints)
    return dh.Arm(table, base=arm.base, tool=arm.tool, sign=arm.sign)


def in_units(answer, given, found):
    """Scaled in the named columns or entries, the table is the right arm; as it stands it is
    not.
    """
    arm, right = arm_of(answer, given)
    rows = degrees_of(arm)
    for what, unit in (("what", "unit"), ("more", "more_unit")):
        for name in filter(None, (found.get(what) or "").replace(" and ", ", ").split(", ")):
            of = re.fullmatch(r"(?P<column>[θdaα])(?: of row )?(?P<row>\d)?", name)
            which = slice(None) if not of["row"] else int(of["row"]) - 1
            factor = FACTORS[found[unit]]
            rows[which, COLUMN[of["column"]]] *= factor
    return same(with_rows(arm, rows), right, 2e-2) and not same(arm, right)


def put_right(slip, rows):
    """Rows of a table without a slip that is told."""
    if found := re.fullmatch(r"rows (\d) and (\d) have changed places", slip):
        i, k = int(found[1]) - 1, int(found[2]) - 1
        rows[[i, k]] = rows[[k, i]]
    elif found := re.fullmatch(r"([θdaα]) and ([θdaα]) have changed places", slip):
        i, k = COLUMN[found[1]], COLUMN[found[2]]
        rows[:, [i, k]] = rows[:, [k, i]]
    else:
        found = re.fullmatch(r"in other units: (.+) in (\w+); \w+ are asked", slip)
        rows[:, [COLUMN[name] for name in found[1].split(" and ")]] *= FACTORS[found[2]]
    return rows


def _straightened(answer, given, found):
    """The two angles beside a link, turned against each other, and its length make the right arm;
    as it stands it is not.
    """
    arm, right = arm_of(answer, given)
    rows, i, j = degrees_of(arm), int(found["row"]) - 1, int(found["other"]) - 1
    q = some_q(len(right))

    def bent(x):
        changed = rows.copy()
        changed[i, 0], changed[i, 2], changed[j, 0] = rows[i, 0] + x[0], x[1], rows[j, 0] - x[0]
        return with_rows(arm, changed)

    fits = [
        least_squares(lambda x: (ends(bent(x), q) - ends(right, q)).ravel(), [start, rows[i, 2]])
        for start in (-20, 0, 20)
    ]
    return min(fit.cost for fit in fits) < 1e-9 and not same(arm, right)


def is_arm(made):
    """The answer is the arm of these rows (degrees, metres), with the right one's base and tool."""

    def holds(answer, given, found):
        arm, right = arm_of(answer, given)
        return same(arm, with_rows(right, made(given, found)))

    return holds


def _far_off(answer, given, found):
    arm, right = arm_of(answer, given)
    exercise, variant = given["exercise"], given["variant"]
    q = exercise.poses_at(variant)
    A, B = ends(arm, q), ends(right, q)
    way = 1000 * np.linalg.norm(A[:, :3, 3] - B[:, :3, 3], axis=1).max()
    turn = max(
        np.degrees(np.arccos(np.clip((np.trace(R.T @ S) - 1) / 2, -1, 1)))
        for R, S in zip(A[:, :3, :3], B[:, :3, :3])
    )
    told = [float(found[name].replace(" ", "").replace(",", "")) for name in ("mm", "deg")]
    return np.allclose(told, [way, turn], rtol=0.06, atol=0.02)


def lines(arm, q):
    """Direction and moment of every joint's axis at q, in the base; up to a common sign."""
    T, found = arm.base.copy(), []
    x_first = arm.table.convention == "craig"
    for i, value in enumerate(np.asarray(q) * arm.sign):
        table = arm.table
        theta, d = table.theta[i], table.d[i]
        theta, d = (theta, d + value) if table.prismatic[i] else (theta + value, d)
        x = walk([[0, 0, table.a[i], np.degrees(table.alpha[i])]], [0])
        z = walk([[np.degrees(theta), d, 0, 0]], [0])
        axis = T @ x if x_first else T
        u, p = axis[:3, 2], axis[:3, 3]
        found.append(np.concatenate([u, np.cross(p, u)]) * arm.sign[i])
        T = axis @ z if x_first else axis @ z @ x
    return np.array(found)


def _first_axis_off(arm, right):
    """The first joint whose axis, with its sense, is not the right one at some q; 0 when none."""
    bad = [np.abs(lines(arm, q) - lines(right, q)).max(axis=1) > 1e-7 for q in some_q(len(right))]
    every = np.any(bad, axis=0)
    return int(np.argmax(every)) + 1 if every.any() else 0


def _lengths_alone(arm, right):
    q = some_q(len(right))
    return np.allclose(ends(arm, q)[:, :3, :3], ends(right, q)[:, :3, :3], atol=1e-6)


def _angles_equal(arm, right):
    """Whether only lengths differ from the right table: every θ and α points the same way."""
    one, other = arm.table, right.table
    return all(
        np.allclose(np.exp(1j * x), np.exp(1j * y))
        for x, y in ((one.theta, other.theta), (one.alpha, other.alpha))
    )


def another_arm(answer, given, found):
    """How far off the end is, the first axis that is not where it must be, and whether the rotation
    is right throughout.
    """
    arm, right = arm_of(answer, given)
    first = _first_axis_off(arm, right)
    told = int(found.get("joint") or 0)
    return (
        _far_off(answer, given, found)
        and first == told
        and _lengths_alone(arm, right) == bool(found.get("turned"))
        and (not found.get("lengths") or _angles_equal(arm, right))
        and (not found.get("first") or _hidden_steps(right, first, found))
        and (not found.get("first") or _step_mends(arm, right, first, found))
    )


def _step_mends(arm, right, joint, found):
    """The axis that is off comes to its place with another d alone."""
    rows, k = degrees_of(arm), int(found["last"]) - 1
    lacks = (degrees_of(right) - rows)[int(found["first"]) - 1 : k + 1, 1].sum()
    rows[k, 1] += lacks
    return _first_axis_off(with_rows(arm, rows), right) != joint


def _hidden_steps(right, joint, found):
    """In the right table another d in each of these rows moves that joint's axis first, and in no
    row before them.
    """
    rows, first, last = degrees_of(right), int(found["first"]), int(found["last"])
    for k in range(first, last + 1):
        other = rows.copy()
        other[k - 1, 1] += 0.05
        if _first_axis_off(with_rows(right, other), right) != joint:
            return False
    axes = np.array([lines(right, q)[first - 1 : last, :3] for q in some_q(len(right))])
    return last == joint - 1 and np.allclose(np.cross(axes, axes[:, :1]), 0, atol=1e-7)


def _on_its_side(answer, given, found):
    """Of as many columns as there are joints; of four joints, right when it is turned round."""
    numbers, right = np.asarray(answer, dtype=float), right_of(given)
    if numbers.shape != (4, len(right)):
        return False
    return len(right) != 4 or same(with_rows(right, numbers.T), right)


OFF = r"this is another arm: up to (?P<mm>[\d., ]+) mm and (?P<deg>[\d., ]+)° off at the end @ "
LENGTHS = (
    r"(?P<turned>; the rotation is right at every pose(?P<lengths>, so look at the lengths)?)?"
    r"(; axes (?P<first>\d) (?:and|to) (?P<last>\d) are parallel: a wrong d in any of these rows"
    r" shows only here)?"
)
ANOTHER = [
    (r"rows and columns have changed places", _on_its_side),
    (OFF + r"every joint's axis is where it must be, only the end is not" + LENGTHS, another_arm),
    (OFF + r"the axis of joint (?P<joint>1) is not where it must be" + LENGTHS, another_arm),
    (
        OFF
        + r"the axis of joint \d is where it must be, that of joint (?P<joint>\d) is not: look at"
        r" its point and its direction" + LENGTHS,
        another_arm,
    ),
    (
        OFF
        + r"the axis of joint \d is where it must be, that of joint (?P<joint>\d) is not: .+ lead"
        r".* from the one to the other" + LENGTHS,
        another_arm,
    ),
]
UNITS = [
    (
        r"in other units: (?P<what>[θα][^;]*?) in (?P<unit>[^;]+?), (?P<more>[da][\d ,][^;]*?) in"
        r" (?P<more_unit>[^;]+); degrees and metres are asked",
        in_units,
    ),
    (r"in other units: (?P<what>[θdaα][^;]*?) in (?P<unit>[^;]+); \w+ are asked", in_units),
]


def _of_the_doctor(answer, given, found):
    """One change of the named kind, in the named row, makes the right table this arm."""
    arm, right = arm_of(answer, given)
    rows, i = degrees_of(right), int(found["row"]) - 1
    k = COLUMN[found["column"]]
    trial = degrees_of(arm)
    other = rows.copy()
    other[i, k] = -rows[i, k]
    if found["kind"] == "sign":
        return same(arm, with_rows(right, other))
    other[i, k] = trial[i, k]
    return same(arm, with_rows(right, other)) or _some_value(arm, right, i, k)


def _some_value(arm, right, i, k):
    """Whether one number of the right table, changed, makes the arm: found by least squares."""
    from scipy.optimize import least_squares

    rows, q = degrees_of(right), some_q(len(right))
    wanted = ends(arm, q)

    def off(x):
        tried = rows.copy()
        tried[i, k] = x[0]
        return (ends(with_rows(right, tried), q) - wanted).ravel()

    starts = [rows[i, k] + s for s in ((-0.2, 0.2) if k in (1, 2) else (-120, -40, 40, 120))]
    return any(least_squares(off, [x]).cost < 1e-10 for x in starts)


def _over(change):
    """All rows, or the one that is named, changed as said make the right table this arm."""

    def holds(answer, given, found):
        arm, right = arm_of(answer, given)
        rows = degrees_of(right)
        which = found.get("row")
        k = slice(None) if not which else slice(int(which) - 1, int(which))
        return any(
            same(
                arm,
                with_rows(
                    right, np.vstack([rows[: k.start], other, rows[k.stop :]]) if which else other
                ),
                2e-3,
            )
            for other in change(rows[k])
        )

    return holds


def _columns(rows):
    """The columns in any other order, the numbers kept in degrees, or in radians."""
    for order in permutations(range(4)):
        yield rows[:, list(order)]
        in_radians = (rows * [np.pi / 180, 1, 1, np.pi / 180])[:, list(order)]
        yield in_radians * [180 / np.pi, 1, 1, 180 / np.pi]


def _lengths(rows):
    inches = [unit for k in (1, 1e2, 1e3) for unit in (0.0254 * k, 1 / 0.0254 / k)]
    for factor in (10, 100, 1000, 0.1, 0.01, 0.001, 304.8, 3.28084, 0.3048, *inches):
        yield rows * [1, factor, factor, 1]
        yield rows * [1, factor, 1, 1]
        yield rows * [1, 1, factor, 1]


def _rounded(answer, given, found):
    arm, right = arm_of(answer, given)
    return same(arm, right, 3e-2) and not same(arm, right, 1e-9)


def _from_the_row_before(rows):
    yield np.column_stack([rows[:, :2], np.roll(rows[:, 2:], 1, axis=0)])
    yield np.column_stack([rows[:, :2], _pairs(rows, 1)])


def _across(answer, given, found):
    """Some joint's axis has another direction than it must have, a right angle away at q = 0."""
    arm, right = arm_of(answer, given)
    zero = np.zeros(len(right))
    dots = (lines(arm, zero)[:, :3] * lines(right, zero)[:, :3]).sum(axis=1)
    return (np.abs(dots) < 1e-6).any() or not same(arm, right)


def _half_flipped(edits):
    """Some of the entries that hang on an axis are turned round with it, and not all."""

    def holds(answer, given, found):
        arm, right = arm_of(answer, given)
        rows, k = degrees_of(right), int(found["k"])
        craig = right.table.convention == "craig"
        there = [e for e in edits(k, craig) if 0 <= e[0] < len(rows)]
        for taken in product((False, True), repeat=len(there)):
            other = rows.copy()
            for (i, column, change), take in zip(there, taken):
                other[i, column] = change(other[i, column]) if take else other[i, column]
            if any(taken) and same(arm, with_rows(right, other), 1e-5):
                return True
        return False

    return holds


def _minus(x):
    return -x


def _about(x):
    return x + 180


def _of_x(k, craig):
    """What hangs on x_k: the turns to and from it, and the link along it."""
    link = k if craig else k - 1
    return (k - 1, 0, _about), (k, 0, _about), (link, 2, _minus), (link, 3, _minus)


def _of_z(k, craig):
    """What hangs on z_k: the twists to and from it, and the joint about it."""
    joint = k - 1 if craig else k
    return (*((i, 3, _about) for i in (k - 1, k)), (joint, 0, _minus), (joint, 1, _minus))


def _in_other_row(answer, given, found):
    arm, right = arm_of(answer, given)
    rows, i, j = degrees_of(right), int(found["row"]) - 1, int(found["other"]) - 1
    moved, swapped = rows.copy(), rows.copy()
    moved[[i, j], 0] = 0, rows[i, 0] + rows[j, 0]
    swapped[[i, j], 0] = rows[[j, i], 0]
    return rows[i, 0] != 0 and any(same(arm, with_rows(right, r), 1e-5) for r in (moved, swapped))


def _twice(answer, given, found):
    arm, right = arm_of(answer, given)
    rows, i, j = degrees_of(right), int(found["row"]) - 1, int(found["other"]) - 1
    tried = []
    for one, other in ((i, j), (j, i)):
        tried.append(rows.copy())
        tried[-1][one, 1] += rows[other, 1]
    stands = (degrees_of(arm)[[i, j], 1] != 0).all()
    return stands and any(same(arm, with_rows(right, r), 1e-5) for r in tried)


def _given_a_length(answer, given, found):
    """The two axes that the row connects meet on the right arm, and pass each other by on this."""
    arm, right = arm_of(answer, given)
    i = int(found["row"]) - (1 if arm.table.convention == "standard" else 2)
    passing = []
    for one in (right, arm):
        axes = lines(one, np.zeros(len(one)))
        (u, m), (v, w) = np.split(axes[i], 2), np.split(axes[i + 1], 2)
        passing.append(abs(u @ w + v @ m))
    return passing[0] < 1e-9 < 1e-6 < passing[1]


ROW = (
    r"( @ (?:(?:row|joint) (?P<row>\d)|all (?:rows|joints|lengths|angles)|every row that has one)"
    r"(?:, (?:theta|d|a|alpha))?)?"
)
DOCTOR = [
    (pattern + ROW, _over(change))
    for pattern, change in (
        (r"alpha has the wrong sign", lambda r: [r * [1, 1, 1, -1]]),
        (r"The zero offset is left out", lambda r: [r * [0, 1, 1, 1]]),
        (r"The zero offset has the wrong sign", lambda r: [r * [-1, 1, 1, 1]]),
        (r"The zero offset is counted twice", lambda r: [r * [2, 1, 1, 1]]),
        (
            r"All lengths were made positive",
            lambda r: [np.column_stack([r[:, 0], abs(r[:, 1:3]), r[:, 3]])],
        ),
        (r"Lengths in another unit", _lengths),
        (r"a and alpha come from the row before", _from_the_row_before),
        (r"The columns are in another order", _columns),
        (r"a and d have changed places", lambda r: [r[:, [0, 2, 1, 3]]]),
        (r"theta and alpha have changed places", lambda r: [r[:, [3, 1, 2, 0]]]),
        (
            r"A length has the wrong sign",
            lambda r: [r * [1, -1, 1, 1], r * [1, 1, -1, 1], r * [1, -1, -1, 1]],
        ),
    )
] + [
    (r"Rounded on the way" + ROW, _rounded),
    (
        r"An x axis was turned round, but not everything that hangs on it @ x(?P<k>\d)",
        _half_flipped(_of_x),
    ),
    (
        r"A z axis was turned round, but not everything that hangs on it @ z(?P<k>\d)",
        _half_flipped(_of_z),
    ),
    (
        r"the length along the last axis is left out, or counted twice" + ROW,
        _over(lambda r: [r * [1, 0, 1, 1], r * [1, 2, 1, 1]]),
    ),
    (
        r"The base height is missing, or counted twice" + ROW,
        _over(lambda r: [r * [1, 0, 1, 1], r * [1, 2, 1, 1]]),
    ),
    (r"The step along parallel axes is counted twice @ rows (?P<row>\d) and (?P<other>\d)", _twice),
    (
        r"The zero offset stands in another row @ it belongs to row (?P<row>\d), you have it in row"
        r" (?P<other>\d)",
        _in_other_row,
    ),
    (r"Two axes that meet were given a distance a @ row (?P<row>\d)", _given_a_length),
    (r"z does not lie along the joint's axis" + ROW, _across),
    (
        r"(?P<column>alpha) has the wrong (?P<kind>value) @ row (?P<row>\d)(?:, alpha)?",
        _of_the_doctor,
    ),
    (
        r"A length has the wrong (?P<kind>value) @ row (?P<row>\d), (?P<column>[da])(?:: .+)?",
        _of_the_doctor,
    ),
    (
        r"A bent link is written as a straight one @ rows (?P<row>\d) and (?P<other>\d)",
        _straightened,
    ),
]


def _maker(g, order):
    rows = np.array(g["rows"], dtype=float)  # θ, a, d, α in radians
    ours = np.column_stack([np.degrees(rows[:, 0]), rows[:, 2], rows[:, 1], np.degrees(rows[:, 3])])
    return ours[:, order]


COPIED = [
    (
        r"these are the rows as printed: θ, a, d, α, the angles in radians",
        is_arm(lambda g, f: g["rows"]),
    ),
    (r"the columns stand as printed: θ, a, d, α", is_arm(lambda g, f: _maker(g, [0, 2, 1, 3]))),
    *typed.claims(lambda g: _maker(g, [0, 1, 2, 3])),
]


def _pairs(rows, step, wrap=False):
    """The columns a and α, moved by rows: down 1, up -1; zeros where nothing comes."""
    moved = np.roll(np.asarray(rows, dtype=float)[:, 2:], step, axis=0)
    if not wrap:
        moved[0 if step > 0 else -1] = 0
    return moved


ABOVE = r"(?P<above>above the last row: )?"  # of what is said of all rows but the last


def _conversion(source, down):
    """Claims of a conversion: rows of ``source`` in the given numbers, a and α one row down (or
    up).
    """

    def parts(g):
        rows = np.array(g[source], dtype=float)
        return rows, np.column_stack([rows[:, :2], _pairs(rows, 1 if down else -1)])

    def below(made):
        """As ``made``, in all rows or under a right row 1."""

        def holds(answer, g, f):
            rows, right = parts(g)
            wrong = np.array(made(rows, right, f), dtype=float)
            if f.get("below"):
                wrong[0] = right[0]
            if f.get("above"):  # the last row is right, or as it was
                return any(
                    is_arm(lambda g, f, last=last: np.vstack([wrong[:-1], last]))(answer, g, f)
                    for last in (right[-1:], rows[-1:])
                )
            return is_arm(lambda g, f: wrong)(answer, g, f)

        return holds

    return [
        (
            r"(?P<below>row 1 is right, and the others are those of the standard table)",
            below(lambda rows, right, f: rows),
        ),
        (
            rf"{ABOVE}the rows are those of (the standard|Craig's) table",
            below(lambda rows, right, f: rows),
        ),
        (
            rf"{ABOVE}α moved(, |(?P<below>; from row 2 on ))a did not",
            below(lambda rows, right, f: np.column_stack([rows[:, :3], right[:, 3]])),
        ),
        (
            rf"{ABOVE}a moved(, |(?P<below>; from row 2 on ))α did not",
            below(lambda rows, right, f: np.column_stack([right[:, :3], rows[:, 3]])),
        ),
        (
            rf"{ABOVE}(?P<below>from row 2 on )?θ and d moved as well; they stay in their rows",
            below(
                lambda rows, right, f: (
                    np.vstack([np.zeros(4), rows[:-1]])
                    if down
                    else np.vstack([rows[1:], np.zeros(4)])
                )
            ),
        ),
        (
            r"the pairs moved down by two rows, and not by one",
            below(
                lambda rows, right, f: np.column_stack(
                    [rows[:, :2], np.vstack([np.zeros((2, 2)), rows[:-2, 2:]])]
                )
            ),
        ),
        (
            r"(?P<below>from row 2 on )?the pairs moved up; from standard to Craig they move down",
            lambda a, g, f: any(
                below(
                    lambda rows, right, f, w=w: np.column_stack([rows[:, :2], _pairs(rows, -1, w)])
                )(a, g, f)
                for w in (False, True)
            ),
        ),
        (
            r"the last pair came back in row 1; it belongs in the tool",
            below(lambda rows, right, f: np.column_stack([rows[:, :2], _pairs(rows, 1, True)])),
        ),
        (
            r"(?P<below>from row 2 on )?θ and d moved, a and α did not",
            below(
                lambda rows, right, f: np.column_stack(
                    [np.roll(rows[:, :2], 1, axis=0), rows[:, 2:]]
                )
            ),
        ),
        (
            r"row (?P<row>\d) is still that of the standard table",
            below(
                lambda rows, right, f: [
                    rows[k] if k == int(f["row"]) - 1 else right[k] for k in range(len(rows))
                ]
            ),
        ),
        (
            rf"{ABOVE}the pairs moved up by two rows, and not by one",
            below(
                lambda rows, right, f: np.column_stack(
                    [rows[:, :2], np.vstack([rows[2:, 2:], np.zeros((2, 2))])]
                )
            ),
        ),
        (
            rf"{ABOVE}the pairs moved down; from Craig to standard they move up",
            lambda a, g, f: any(
                below(
                    lambda rows, right, f, w=w: np.column_stack([rows[:, :2], _pairs(rows, 1, w)])
                )(a, g, f)
                for w in (False, True)
            ),
        ),
        (
            r"the last row keeps a pair; nothing comes after it",
            below(lambda rows, right, f: np.vstack([right[:-1], rows[-1]])),
        ),
        *typed.claims(lambda g: parts(g)[1]),
    ]


HALF_MENDED = [
    (
        r"some of column a is right by now, and not all of it @ right so far, a of row"
        r" (?P<rows>[\d, ]+)",
        is_arm(
            lambda g, f: np.column_stack(
                [
                    np.array(g["converted"])[:, :2],
                    [
                        (0 if k == 0 else g["standard"][k - 1][2])
                        if str(k + 1) in f["rows"].split(", ")
                        else row[2]
                        for k, row in enumerate(g["converted"])
                    ],
                    np.array(g["converted"])[:, 3],
                ]
            )
        ),
    ),
    (
        r"a moved up; from standard to Craig it moves down",
        lambda answer, g, f: any(
            is_arm(
                lambda g, f, a=a: np.column_stack(
                    [
                        np.array(g["converted"])[:, :2],
                        [*np.array(g["standard"])[1:, 2], a],
                        np.array(g["converted"])[:, 3],
                    ]
                )
            )(answer, g, f)
            for a in (0, g["standard"][0][2])
        ),
    ),
    (
        r"both columns moved, α for the second time",
        is_arm(
            lambda g, f: np.column_stack(
                [np.array(g["converted"])[:, :2], _pairs(g["converted"], 1)]
            )
        ),
    ),
]

# ---- 04.5, 06.6

ENTRY = {"θ": 0, "d": 1, "a": 2, "α": 3}


def _named(f):
    return [
        (int(name[1:]) - 1, ENTRY[name[0]])
        for name in f["names"].replace(" and ", ", ").split(", ")
    ]


def _misread(judge):
    """Exactly the named entries differ from those of the drawn frames, and as is said."""

    def holds(answer, g, f):
        rows, right = (np.array(answer, dtype=float), degrees_of(right_of(g)))
        off = np.abs(rows - right)
        off[:, [0, 3]] = np.abs((rows - right + 180) % 360 - 180)[:, [0, 3]]
        named = _named(f)
        return sorted(named) == sorted(map(tuple, np.argwhere(off > 1e-3).tolist())) and all(
            judge(rows[i, k], right[i, k]) for i, k in named
        )

    return holds


NAMES = r"(?P<names>[θdaα]\d(?:(?:, | and )[θdaα]\d)*)"
DRAWN = [
    (
        rf"the same arm, but a table of other frames: these have another {NAMES}",
        lambda a, g, f: same(*arm_of(a, g)) and _misread(lambda x, right: x != right)(a, g, f),
    ),
    *typed.claims(lambda g: degrees_of(right_of(g))),
]


def _heading(angle):
    return {
        0: "is level, pointing forward",
        90: "points straight up",
        180: "is level, pointing backward",
        270: "points straight down",
    }[angle % 360]


def _stands(answer, g, f):
    """Where upper arm and forearm point at q = 0, from the origins of the arm's frames."""
    arm = arm_of(answer, g)[0]
    points = [arm.frames(np.zeros(6))[k][:3, 3] for k in (1, 2, 3)]
    for words, way in zip((f.get("upper"), f.get("fore")), np.diff(points, axis=0)):
        if words and words != _heading(round(np.degrees(np.arctan2(way[2], way[0]))) % 360):
            return False
    return (
        f.get("upper")
        or _heading(round(np.degrees(np.arctan2(*np.diff(points, axis=0)[0][[2, 0]]))) % 360)
        == "points straight up"
    )


STANDING = [
    (r"where the encoders read 0, your upper arm (?P<upper>.+)", _stands),
    (r"the upper arm is right; where the encoders read 0, your forearm (?P<fore>.+)", _stands),
    (
        r"the offsets look like radians",
        lambda a, g, f: (np.abs(np.degrees(arm_of(a, g)[0].table.theta)) < 4).all(),
    ),
]

# ---- repairs


def _changed(answer, g):
    broken = np.array(g["rows"], dtype=float)
    rows = degrees_of(arm_of(answer, g)[0])
    right = degrees_of(right_of(g))
    return [tuple(x) for x in np.argwhere(np.abs(rows - broken) > 1e-4)], broken, right


def _places(text):
    return [
        (int(place.split(", ")[0][4:]) - 1, COLUMN[place.split(", ")[1]])
        for place in text.split("; ")
    ]


def _was_right(answer, g, f):
    changed, broken, right = _changed(answer, g)
    told = _places(f["places"])
    return told == [x for x in changed if abs(broken[x] - right[x]) < 1e-4] and (
        len(changed) == int(f.get("count") or 1)
    )


def _right_entry(answer, g, f):
    changed, broken, right = _changed(answer, g)
    return changed == _places(f["places"]) and abs(broken[changed[0]] - right[changed[0]]) > 1e-6


def _turns_the_arc(answer, g, f):
    """Axis 5 stands where it must; seen in frame 3, the end is half a turn of joint 4 further."""
    rows, right = (degrees_of(arm) for arm in arm_of(answer, g))
    q = np.degrees(some_q(6)[0])
    fifth = [walk(one[:4], q[:4]) for one in (rows, right)]
    before = np.linalg.inv(walk(right[:3], q[:3]))
    turned, asked = (
        np.arctan2(p[1], p[0]) for p in (before @ walk(x, q)[:, 3] for x in (rows, right))
    )
    half = np.isclose(abs(turned - asked), np.pi, atol=1e-6)
    return np.allclose(*(T[:3, 2:] for T in fifth), atol=1e-6) and bool(half)


REPAIR = [
    (
        r"(?P<place>row \d, .) is 0, and 0 has no sign to lose",
        lambda a, g, f: np.array(a, dtype=float)[_places(f["place"])[0]] == 0,
    ),
    (r"θ4 brings the axis of joint 5 to its place, too, but turns the arc .+", _turns_the_arc),
    (
        r"(?P<count>\d+) entries are changed, and one change is enough @"
        r" (?P<places>.+) (?:was|were) right before",
        _was_right,
    ),
    (r"this entry was right before you changed it @ (?P<places>.+)", _was_right),
    (r"the right entry, but not yet the right number @ (?P<places>.+)", _right_entry),
]


def _at_zero(answer, g, f):
    arm, right = arm_of(answer, g)
    zero = np.zeros(len(right))
    A, B = ends(arm, zero)[0], ends(right, zero)[0]
    turn = np.degrees(np.arccos(np.clip((np.trace(A[:3, :3].T @ B[:3, :3]) - 1) / 2, -1, 1)))
    way = 1000 * np.linalg.norm(A[:3, 3] - B[:3, 3])
    return np.allclose([float(f["mm"]), float(f["deg"])], [way, turn], rtol=0.06, atol=0.02)


IMPOSTOR = [
    (r"q = 0 finds this one out: (?P<mm>[\d.]+) mm and (?P<deg>[\d.]+)° off there", _at_zero),
    (
        r"this table passes because it is right: it is the same arm at every q",
        lambda a, g, f: same(*arm_of(a, g)),
    ),
]

# ---- 09


def _axis_slip(answer, g, f):
    """The axes of the arm at q = 0, as lines: which of them is off, and how."""
    arm, right = arm_of(answer, g)
    zero = np.zeros(len(right))
    mine, ours = lines(arm, zero), lines(right, zero)
    j = int(f["joint"]) - 1
    others = [k for k in range(len(right)) if k != j]
    if not np.allclose(mine[others], ours[others], atol=1e-7):
        return False
    if f["slip"] == "reversed":
        return np.allclose(mine[j], -ours[j], atol=1e-7)
    if f["slip"] == "another one":
        return not np.allclose(mine[j, :3], ours[j, :3], atol=1e-7)
    return np.allclose(mine[j, :3], ours[j, :3], atol=1e-7) and not np.allclose(mine[j], ours[j])


def _two_axes(turned):
    """All axes of the arm at q = 0 are in place but two, which are the right ones, turned."""

    def holds(answer, g, f):
        arm, right = arm_of(answer, g)
        zero, (i, k) = np.zeros(len(right)), (int(f["one"]) - 1, int(f["other"]) - 1)
        mine, ours = lines(arm, zero), lines(right, zero)
        ours[[i, k]] = turned(ours[i].copy(), ours[k].copy())
        return np.allclose(mine, ours, atol=1e-7) and not same(arm, right)

    return holds


def _written_round(answer, g, f):
    """One axis goes through the point that is the direction of the right one, towards a point that
    lies on that.
    """
    arm, right = arm_of(answer, g)
    zero, j = np.zeros(len(right)), int(f["joint"]) - 1
    mine, ours = lines(arm, zero), lines(right, zero)
    (u, m), (v, w) = np.split(mine[j], 2), np.split(ours[j], 2)
    u_on_ours = np.cross(np.cross(u, v), w)  # u times a number lies on the line (v, w)
    through = np.allclose(np.cross(v, u), m, atol=1e-7)
    others = [k for k in range(len(right)) if k != j]
    return (
        through
        and np.allclose(u_on_ours, 0, atol=1e-7)
        and np.allclose(mine[others], ours[others], atol=1e-7)
    )


def _last_points(answer, g, f):
    arm, right = arm_of(answer, g)
    zero, first = np.zeros(len(right)), int(f["first"]) - 1
    mine, ours = lines(arm, zero), lines(right, zero)
    ours[first:, 3:] *= 1000
    return np.allclose(mine, ours, atol=1e-4)


def _end_only(answer, g, f):
    arm, right = arm_of(answer, g)
    zero = np.zeros(len(right))
    return np.allclose(lines(arm, zero), lines(right, zero), atol=1e-7) and not same(arm, right)


def _thousand(points, end):
    """Moments of the axes, and the end's place, 1000 times what they should be, or right."""

    def holds(answer, g, f):
        arm, right = arm_of(answer, g)
        zero = np.zeros(len(right))
        mine, ours = lines(arm, zero), lines(right, zero)
        A, B = ends(arm, zero)[0], ends(right, zero)[0]
        return np.allclose(mine[:, 3:], ours[:, 3:] * (1000 if points else 1), atol=1e-4) and (
            np.allclose(A[:3, 3], B[:3, 3] * (1000 if end else 1), atol=1e-4)
        )

    return holds


def _fifth_through(step):
    """Axis 5 has its direction, and goes through the point so many hands beyond the flange."""

    def holds(answer, g, f):
        arm, right = arm_of(answer, g)
        mine, ours = lines(arm, np.zeros(6)), lines(right, np.zeros(6))
        end, u = np.asarray(g["end"]), ours[4, :3]
        ours[4, 3:] = np.cross(end[:3, 3] + step * g["hand"] * end[:3, 2], u)
        return np.allclose(mine, ours, atol=1e-7)

    return holds


BOTH_JOINTS = r"joints (?P<one>\d) and (?P<other>\d)"
SHEET = [
    (rf"the lines of {BOTH_JOINTS} have changed places", _two_axes(lambda a, b: [b, a])),
    (rf"the directions of {BOTH_JOINTS} are reversed", _two_axes(lambda a, b: [-a, -b])),
    (r"point and direction of joint (?P<joint>\d) have changed places", _written_round),
    (
        r"in other units: the points of joints? (?P<first>\d)(?: (?:and|to) 6)? in millimetres; .+",
        _last_points,
    ),
    (r"this arm was loaded: it says where its numbers come from", lambda a, g, f: bool(a.source)),
    (r"these are joint axes, not yet an arm", lambda a, g, f: np.shape(a[0]) == (2, 3)),
    (
        r"this is the AR4 of the library, and yours has other lengths",
        lambda a, g, f: same(arm_of(a, g)[0], dh.load("ar4")) and not same(*arm_of(a, g)),
    ),
    (r"axis 5 goes through the flange", _fifth_through(0)),
    (r"axis 5 goes through a point as far before the flange as .+ is behind", _fifth_through(1)),
    (r"the direction of joint (?P<joint>\d) is (?P<slip>reversed|another one)", _axis_slip),
    (r"axis (?P<joint>\d) goes through the point that axis \d was given(?P<slip>)", _axis_slip),
    (r"the [xyz] of the point on axis (?P<joint>\d) has the other sign(?P<slip>)", _axis_slip),
    (r"the end was put where the last axis was given", _end_only),
    (r"the end's directions are those of the base", _end_only),
    (r"the end's angles were left in degrees", _end_only),
    (r"the end's pitch has the other sign", _end_only),
    (r"the end's angle was taken about another axis", _end_only),
    (r"in other units: the points and the end in millimetres; .+", _thousand(True, True)),
    (r"in other units: the points of the axes in millimetres; .+", _thousand(True, False)),
    (r"in other units: the end in millimetres; .+", _thousand(False, True)),
    (r"both units: the points and the flange are in millimetres, .+", _thousand(True, True)),
    (r"both units: the flange is in millimetres, .+", _thousand(False, True)),
    (r"both units: the points are in millimetres, .+", _thousand(True, False)),
]


def _kr6_rows(g):
    """The rows that are given, and the right ones: a and α one row up."""
    given = degrees_of(dh.Arm(g["table"]))
    return given, np.column_stack([given[:, :2], _pairs(given, -1)])


def _kr6(made):
    return is_arm(lambda g, f: made(*_kr6_rows(g)))


MOVED = [
    (r"these are still Craig's rows", _kr6(lambda rows, right: rows)),
    (
        r"a and α moved down, and to the standard convention they move up",
        _kr6(lambda rows, right: np.column_stack([rows[:, :2], _pairs(rows, 1)])),
    ),
    (
        r"a moved, α did not",
        _kr6(lambda rows, right: np.column_stack([rows[:, :2], right[:, 2], rows[:, 3]])),
    ),
    (r"α moved, a did not", _kr6(lambda rows, right: np.column_stack([rows[:, :3], right[:, 3]]))),
    (
        r"the last row still holds a pair, and behind the last joint there is no link",
        lambda a, g, f: any(
            _kr6(lambda rows, right, k=k: np.vstack([right[:-1], [*rows[-1, :2], *rows[k, 2:]]]))(
                a, g, f
            )
            for k in range(1, 6)
        ),
    ),
    (
        r"whole rows moved up, and θ and d belong to a joint: they stay",
        lambda a, g, f: np.allclose(degrees_of(arm_of(a, g)[0])[:5], _kr6_rows(g)[0][1:]),
    ),
    (
        r"θ moved up with a and α, and it belongs to the joint: it stays",
        lambda a, g, f: (
            np.allclose(degrees_of(arm_of(a, g)[0])[:5, 0], _kr6_rows(g)[0][1:, 0])
            and np.allclose(degrees_of(arm_of(a, g)[0])[:, 1:], _kr6_rows(g)[1][:, 1:])
        ),
    ),
    *typed.claims(lambda g: _kr6_rows(g)[1]),
]
MAKERS = [
    (
        r"this is still the arm of the maker's table",
        is_arm(lambda g, f: degrees_of(right_of(g)) + 270 * np.outer(np.eye(6)[5], np.eye(4)[3])),
    ),
    (
        r"α of row 5 of the maker's table was right before you changed it",
        is_arm(
            lambda g, f: (
                degrees_of(right_of(g))
                + np.outer(270 * np.eye(6)[5] - 180 * np.eye(6)[4], np.eye(4)[3])
            )
        ),
    ),
]
EVERY = [*UNITS, *ANOTHER, *DOCTOR]
REFUSED = [(r"expected .+, found .+", lambda a, g, f: True)]
CLAIMS = {
    key: [*claims, *EVERY, *REFUSED]
    for key, claims in {
        "02.7": COPIED,
        "03.7": _conversion("rows", True),
        "03.8": _conversion("rows", False),
        "03.9": [*HALF_MENDED, *_conversion("standard", True)],
        "04.5": DRAWN,
        "06.6": STANDING,
        "07.3": REPAIR,
        "07.4": IMPOSTOR,
        "07.6": REPAIR,
        "07.8": REPAIR,
        "09.2": SHEET,
        "09.3": MAKERS,
        "09.4": SHEET,
        "09.7": MOVED,
    }.items()
}
