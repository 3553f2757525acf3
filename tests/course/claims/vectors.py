"""Claims about numbers, points, arrows and matrices: lessons 00, 01, 02, 03, 05 to 09."""

import numpy as np
from scipy.spatial.transform import Rotation

import dhlab as dh

from .general import near, right_of

C, S = (lambda x: np.cos(np.radians(x))), (lambda x: np.sin(np.radians(x)))


def is_value(value):
    """The answer is this value of the task's numbers."""
    return lambda answer, given, found: near(np.squeeze(answer), value(given), 3e-3)


def one_row(theta, d, a, alpha):
    """Link matrix, entry by entry, from degrees."""
    return np.array(
        [
            [C(theta), -S(theta) * C(alpha), S(theta) * S(alpha), a * C(theta)],
            [S(theta), C(theta) * C(alpha), -C(theta) * S(alpha), a * S(theta)],
            [0, S(alpha), C(alpha), d],
            [0, 0, 0, 1],
        ]
    )


def back(T):
    """The inverse of a pose."""
    T = np.asarray(T)
    R = T[:3, :3].T
    return np.vstack([np.column_stack([R, -R @ T[:3, 3]]), [0, 0, 0, 1]])


LAST_ROW = (r"every number is 0, as in the last row of a pose", lambda a, g, f: not np.any(a))

# ---- 00, 01

PRODUCT = [
    (r"this is v @ R: .+", is_value(lambda g: np.dot(g["v"], g["R"]))),
    (
        r"multiplied entry by entry, with \* in place of @( @ the sums of the columns of R \* v)?",
        lambda answer, g, f: any(
            near(answer, wrong)
            for wrong in (
                np.einsum("ij,j->j", g["R"], g["v"]),
                np.einsum("ij,j->ij", g["R"], g["v"]),
                np.einsum("ij,i->ij", g["R"], g["v"]),
            )
        ),
    ),
    (
        r"only the diagonal of R was used",
        is_value(lambda g: [g["R"][k][k] * g["v"][k] for k in range(3)]),
    ),
    (r"this is v itself, R was not used", is_value(lambda g: g["v"])),
    (r"this is the first column of R, v was not used", is_value(lambda g: [r[0] for r in g["R"]])),
    (r"this is the first row of R, v was not used", is_value(lambda g: g["R"][0])),
    (r"R was applied twice", is_value(lambda g: np.einsum("ij,jk,k->i", g["R"], g["R"], g["v"]))),
]
NUMBER = {"first": 0, "second": 1, "third": 2, "x": 0, "y": 1, "z": 2}
ARROW = [
    (
        r"this is the (?P<which>\w+) row; the plate's arrows are columns",
        lambda a, g, f: near(np.ravel(a)[:3], g["T_01"][NUMBER[f["which"]]][:3]),
    ),
    (
        r"this is the plate's (?P<which>[xyz]) arrow",
        lambda a, g, f: near(a, [row[NUMBER[f["which"]]] for row in g["T_01"][:3]]),
    ),
    (
        r"this is the plate's x arrow turned round",
        is_value(lambda g: [-row[0] for row in g["T_01"][:3]]),
    ),
    (r"this is the plate's origin", is_value(lambda g: [row[3] for row in g["T_01"][:3]])),
    (
        r"the last 0 is not part of the arrow",
        lambda a, g, f: near(np.ravel(a), [*(row[0] for row in g["T_01"][:3]), 0]),
    ),
]


def _corner(g, columns, origin=None):
    T = np.eye(4)
    T[:3, :3] = np.array(columns).T
    T[:3, 3] = [g["x"], g["y"], g["z"]] if origin is None else origin
    return T


AHEAD = ([0, 1, 0], [-1, 0, 0], [0, 0, 1])  # the right arrows of 01.2
PLATE = [
    (
        r"turned the other way: the x arrow points against y0",
        is_value(lambda g: _corner(g, ([0, -1, 0], [1, 0, 0], [0, 0, 1]))),
    ),
    (r"The whole 4×4 is transposed", lambda a, g, f: near(np.transpose(a), _corner(g, AHEAD))),
    (
        r"this is the inverse: where the base is, seen from the camera plate",
        lambda a, g, f: near(np.matmul(a, _corner(g, AHEAD)), np.eye(4)),
    ),
    (
        r"the y arrow points the wrong way: x, y and z form a left hand",
        lambda a, g, f: (
            near(a, _corner(g, ([0, 1, 0], [1, 0, 0], [0, 0, 1])))
            and np.linalg.det(np.asarray(a)[:3, :3]) < 0
        ),
    ),
    (
        r"the plate is not turned: its x arrow still points along x0",
        is_value(lambda g: _corner(g, np.eye(3))),
    ),
    (
        r"The last row is not 0 0 0 1",
        lambda a, g, f: (
            near(np.asarray(a)[:3], _corner(g, AHEAD)[:3])
            and not near(np.asarray(a)[3], [0, 0, 0, 1])
        ),
    ),
    (
        r"the shift was made along the turned arrows",
        is_value(lambda g: _corner(g, AHEAD, [-g["y"], g["x"], g["z"]])),
    ),
    (
        r"90 was taken for radians",
        is_value(
            lambda g: _corner(
                g, ([np.cos(90), np.sin(90), 0], [-np.sin(90), np.cos(90), 0], [0, 0, 1])
            )
        ),
    ),
    (
        r"turned about (?P<axis>[xy]): the z arrow no longer points up",
        lambda a, g, f: (
            np.asarray(a)[2, 2] < 0.9
            and near(np.asarray(a)[:3, NUMBER[f["axis"]]], np.eye(3)[NUMBER[f["axis"]]])
        ),
    ),
]


def _two(turned, shifted):
    """A point from R (…) p, as the two say of R, p_01 and p_12."""
    return is_value(
        lambda g: (
            turned(np.asarray(g["T_01"])[:3, :3], np.asarray(g["p_12"]))
            + shifted(np.asarray(g["T_01"])[:3, :3], np.asarray(g["T_01"])[:3, 3])
        )
    )


POINT = [
    (r"the two shifts were added, and p_12 was not turned", _two(lambda R, p: p, lambda R, o: o)),
    (r"p_12 was turned the wrong way: .+", _two(lambda R, p: p @ R, lambda R, o: o)),
    (
        r"the shift of plate 1 is missing",
        lambda a, g, f: near(np.ravel(a)[:3], np.asarray(g["T_01"])[:3, :3] @ g["p_12"]),
    ),
    (r"this is p_12 itself, still written in plate 1", _two(lambda R, p: p, lambda R, o: 0 * o)),
    (
        r"this goes the other way: from the base into plate 1",
        is_value(lambda g: (back(g["T_01"]) @ [*g["p_12"], 1])[:3]),
    ),
    (r"you shifted first and then turned", _two(lambda R, p: R @ p, lambda R, o: R @ o)),
    (
        r"the shift of plate 1 was taken away, where it is added",
        _two(lambda R, p: R @ p, lambda R, o: -o),
    ),
    (
        r"the turned p_12 was taken away, where it is added",
        _two(lambda R, p: -R @ p, lambda R, o: o),
    ),
    (r"this is the origin of plate 1; p_12 was not used", _two(lambda R, p: 0 * p, lambda R, o: o)),
    (
        r"the place is right, but the 1 at the end is not part of it",
        lambda a, g, f: near(np.ravel(a), [*right_of(g), 1]),
    ),
    ARROW[-1],
    (
        r"multiplied entry by entry, with \* in place of @",
        lambda a, g, f: near(
            a, np.einsum("ij,j->ij", g["T_01"][:3, :3], g["p_12"]) + g["T_01"][:3, 3]
        ),
    ),
]


def _tip(made):
    return is_value(lambda g: made(np.asarray(g["T_0F"]), np.asarray(g["T_FT"])))


TIP = [
    (r"this is the flange's origin, not the tip", _tip(lambda F, T: F[:3, 3])),
    (
        r"the two shifts were added, and the tool's was not turned",
        _tip(lambda F, T: F[:3, 3] + T[:3, 3]),
    ),
    (
        r"the two poses are multiplied in the reverse order",
        _tip(lambda F, T: T[:3, :3] @ F[:3, 3] + T[:3, 3]),
    ),
    (
        r"the tool's pose was inverted",
        _tip(lambda F, T: F[:3, 3] - F[:3, :3] @ T[:3, :3].T @ T[:3, 3]),
    ),
    (r"the flange's pose was inverted", _tip(lambda F, T: F[:3, :3].T @ (T[:3, 3] - F[:3, 3]))),
    (
        r"this is the base's origin, seen from the tool",
        _tip(lambda F, T: (back(T) @ back(F))[:3, 3]),
    ),
    (r"this is the tip in the flange's arrows, not in the base's", _tip(lambda F, T: T[:3, 3])),
    (r"the way from the base to the flange is missing", _tip(lambda F, T: F[:3, :3] @ T[:3, 3])),
    (
        r"you shifted first and then turned",
        _tip(lambda F, T: F[:3, :3] @ F[:3, 3] + F[:3, :3] @ T[:3, 3]),
    ),
    (
        r"the tool's shift was turned the wrong way: .+",
        _tip(lambda F, T: T[:3, 3] @ F[:3, :3] + F[:3, 3]),
    ),
    (
        r"the tool's shift was taken away, where it is added",
        _tip(lambda F, T: F[:3, 3] - F[:3, :3] @ T[:3, 3]),
    ),
    (
        r"the way to the flange was taken away, where it is added",
        _tip(lambda F, T: F[:3, :3] @ T[:3, 3] - F[:3, 3]),
    ),
    LAST_ROW,
    (r"this is the tool's z arrow", _tip(lambda F, T: F[:3, :3] @ T[:3, 2])),
    POINT[7],
    ARROW[-1],
    (
        r"this is the tool's whole pose, and its origin is asked",
        lambda a, g, f: near(a, np.matmul(g["T_0F"], g["T_FT"])),
    ),
]

# ---- 02


def _row_but(change):
    """The answer is the right row but for what is changed in it: a dict of places to values."""

    def holds(answer, given, found):
        row = right_of(given).copy()
        for k, value in change(row, given, found).items():
            row[k] = value
        off = np.asarray(answer, dtype=float) - row
        off[[0, 3]] = (off[[0, 3]] + 180) % 360 - 180
        return bool((np.abs(off) < 3e-3 * (1 + np.abs(row))).all())

    return holds


def _way(T):
    """The direction of the origin in the plane of x0 and y0."""
    return np.asarray(T)[:2, 3] / np.linalg.norm(np.asarray(T)[:2, 3])


def _arc(y, x):
    return np.degrees(np.arctan2(y, x))


LINK = [
    (r"a and d have changed places", _row_but(lambda r, g, f: {1: r[2], 2: r[1]})),
    (r"theta and alpha have changed places", _row_but(lambda r, g, f: {0: r[3], 3: r[0]})),
    (
        r"a: this is the distance of the two origins",
        _row_but(lambda r, g, f: {2: np.hypot(r[1], r[2])}),
    ),
    (r"a: this is the step along x0, not along x1", _row_but(lambda r, g, f: {2: r[2] * C(r[0])})),
    (
        r"α: this is the angle about x0, not about x1",
        _row_but(lambda r, g, f: {3: _arc(C(r[0]) * S(r[3]), C(r[3]))}),
    ),
    (
        r"θ was read off the first row",
        _row_but(lambda r, g, f: {0: _arc(-S(r[0]) * C(r[3]), C(r[0]))}),
    ),
    (
        r"θ: the two arguments of arctan2 have changed places",
        _row_but(lambda r, g, f: {0: 90 - r[0]}),
    ),
    (
        r"α: the two arguments of arctan2 have changed places",
        _row_but(lambda r, g, f: {3: 90 - r[3]}),
    ),
    (
        r"θ and a follow the way to the origin, not x1",
        lambda a, g, f: (
            _row_but(lambda r, *_: {0: r[0] + 180, 2: -r[2]})(a, g, f)
            and near([C(a[0]), S(a[0])], _way(g["T_01"]))
        ),
    ),
    (r"θ is off by half a turn", _row_but(lambda r, g, f: {0: r[0] + 180})),
    (r"α is off by half a turn", _row_but(lambda r, g, f: {3: r[3] + 180})),
    (r"θ has the wrong sign", _row_but(lambda r, g, f: {0: -r[0]})),
    (
        r"α has the right sine and the wrong cosine",
        lambda a, g, f: (
            near(S(a[3]), S(right_of(g)[3])) and _row_but(lambda r, *_: {3: a[3]})(a, g, f)
        ),
    ),
    (r"α has the wrong sign", _row_but(lambda r, g, f: {3: -r[3]})),
    (
        r"a has lost its minus sign",
        lambda a, g, f: right_of(g)[2] < 0 and _row_but(lambda r, *_: {2: -r[2]})(a, g, f),
    ),
    (
        r"a is positive, as if x1 were turned round; but x1 is given",
        lambda a, g, f: (
            np.asarray(a)[2] > 0
            and _row_but(lambda r, *_: {0: r[0] + 180, 2: -r[2], 3: -r[3]})(a, g, f)
        ),
    ),
    (
        r"a and α have lost their minus signs",
        lambda a, g, f: (
            (right_of(g)[2:] < 0).all() and _row_but(lambda r, *_: {2: -r[2], 3: -r[3]})(a, g, f)
        ),
    ),
    (
        r"(?P<name>[θdaα]) is an array of three numbers: \* in place of @",
        lambda a, g, f: np.size(a["θdaα".index(f["name"])]) == 3,
    ),
    (
        r"(?P<name>[θdaα]) is an array, where one number belongs",
        lambda a, g, f: np.ndim(a["θdaα".index(f["name"])]) > 0,
    ),
]
LEAN, LONG = _arc(284.5, 53.5), np.hypot(0.2845, 0.0535)
TUBE = [
    (
        r"θ and a are told as if x1 pointed from axis 3 to axis 2",
        _row_but(lambda r, g, f: {0: r[0] + 180, 2: -r[2]}),
    ),
    (r"a: this is the way along the tube", _row_but(lambda r, g, f: {2: 0.338})),
    (
        r"a: this is one piece of the tube",
        lambda a, g, f: any(_row_but(lambda r, *_, x=x: {2: x})(a, g, f) for x in (0.2845, 0.0535)),
    ),
    (
        r"θ and a follow the first piece of the tube",
        _row_but(lambda r, g, f: {0: g["q2"] + 90, 2: 0.2845}),
    ),
    (
        r"the step of 53.5 mm does not run along the joint's axis",
        lambda a, g, f: near(a[1], 0.0535),
    ),
    (
        r"the piece of 284.5 mm does not run along the joint's axis",
        lambda a, g, f: near(a[1], 0.2845) and right_of(g)[1] == 0,
    ),
    (
        r"θ follows the first piece of the tube, not the straight line",
        _row_but(lambda r, g, f: {0: g["q2"] + 90}),
    ),
    (r"a and d have changed places", _row_but(lambda r, g, f: {1: r[2], 2: r[1]})),
    (r"θ is q2 alone, .+", _row_but(lambda r, g, f: {0: g["q2"]})),
    (r"θ is right at q2 = 0 only", _row_but(lambda r, g, f: {0: LEAN})),
    (
        r"the angle of x1 at q2 = 0 has the wrong sign in θ",
        _row_but(lambda r, g, f: {0: g["q2"] - LEAN}),
    ),
    (r"q2 has the wrong sign in θ", _row_but(lambda r, g, f: {0: LEAN - g["q2"]})),
    (
        r"θ: the angle of x1 at q2 = 0 was taken from y0",
        _row_but(lambda r, g, f: {0: g["q2"] + _arc(53.5, 284.5)}),
    ),
    (
        r"θ: radians were added to degrees",
        _row_but(lambda r, g, f: {0: g["q2"] + np.radians(LEAN)}),
    ),
    (
        r"α: the two axes are parallel and point the same way",
        lambda a, g, f: (
            near(abs(np.asarray(a)[3]) % 360, 180) and _row_but(lambda r, *_: {3: 180})(a, g, f)
        ),
    ),
    (
        r"α: the tube is bent, the two axes are not",
        lambda a, g, f: not near(a[3], 0) and _row_but(lambda r, *_: {3: LEAN})(a, g, f),
    ),
    *LINK[-2:],
]


def _one_row_makes(T):
    """x1 is level, and its line meets z0: the two conditions, from the pose alone."""
    level = abs(T[2][0]) < 1e-9
    meets = abs(T[0][0] * T[1][3] - T[1][0] * T[0][3]) < 1e-9
    return level, meets


def _wrongly(given_as):
    def holds(answer, given, found):
        k = list(given["exercise"].given(given["variant"])).index(found["name"])
        level, meets = _one_row_makes(np.asarray(given[found["name"]]))
        return (
            bool(round(float(answer[k]))) == (given_as != "made")
            and {"leans": not level, "passes": level and not meets, "made": level and meets}[
                given_as
            ]
        )

    return holds


MAKEABLE = [
    (
        r"1 and 0 look exchanged",
        lambda a, g, f: all(
            bool(x) != all(_one_row_makes(np.asarray(T)))
            for x, T in zip(a, g["exercise"].given(g["variant"]).values())
        ),
    ),
    (r"(?P<name>T_[a-d]) cannot be made by one row: its x1 leans towards z0", _wrongly("leans")),
    (r"(?P<name>T_[a-d]) cannot be made by one row: its x1 passes z0 by", _wrongly("passes")),
    (r"(?P<name>T_[a-d]) can be made by one row", _wrongly("made")),
]

# ---- 03.10


def walk(rows, q, convention="standard"):
    """The end pose of rows (degrees, metres) at q (degrees), move by move."""
    T = np.eye(4)
    for (theta, d, a, alpha), value in zip(rows, q):
        if convention == "standard":
            T = T @ one_row(theta + value, d, a, alpha)
        else:
            T = T @ one_row(0, 0, a, alpha) @ one_row(theta + value, d, 0, 0)
    return T


def _convention(g):
    miss = {
        name: np.abs(walk(g["rows"], g["q_check"], name)[:3, 3] - g["p_check"]).max()
        for name in ("standard", "craig")
    }
    return min(miss, key=miss.get)


def _unnamed(made):
    """A point of the reading that the check pose fits, or of the other."""
    return is_value(lambda g: made(g, _other(_convention(g)) if g.get("other") else _convention(g)))


def _other(name):
    return "craig" if name == "standard" else "standard"


def _converted(g, name):
    """The rows in the other convention, a and α one row on, without what base or tool takes up."""
    rows = np.array(g["rows"], dtype=float)
    step = 1 if name == "standard" else -1
    rows[:, 2:] = np.roll(rows[:, 2:], step, axis=0)
    rows[0 if step == 1 else -1, 2:] = 0
    return rows


OF_A_READING = [
    (
        r"this is the rows' other reading, which the check pose does not fit",
        _unnamed(lambda g, name: walk(g["rows"], g["q"], _other(name))[:3, 3]),
    ),
    (r"this is the point at q = 0", _unnamed(lambda g, n: walk(g["rows"], np.zeros(6), n)[:3, 3])),
    (
        r"q was left in degrees",
        _unnamed(lambda g, n: walk(g["rows"], np.degrees(g["q"]), n)[:3, 3]),
    ),
    (
        r"the rows were read as radians",
        _unnamed(
            lambda g, n: walk(np.array(g["rows"]) * [180 / np.pi, 1, 1, 180 / np.pi], g["q"], n)[
                :3, 3
            ]
        ),
    ),
    (
        r"the rows' θ were left out",
        _unnamed(lambda g, n: walk(np.array(g["rows"]) * [0, 1, 1, 1], g["q"], n)[:3, 3]),
    ),
    (
        r"this is the point at −q: all joints turned the other way",
        _unnamed(lambda g, n: walk(g["rows"], np.negative(g["q"]), n)[:3, 3]),
    ),
    (
        r"the rows were converted and then read in the convention they came from",
        _unnamed(lambda g, n: walk(_converted(g, n), g["q"], n)[:3, 3]),
    ),
    (
        r"the rows were converted, and base or tool forgotten",
        _unnamed(lambda g, n: walk(_converted(g, n), g["q"], _other(n))[:3, 3]),
    ),
    (r"this is the end's z arrow", _unnamed(lambda g, n: walk(g["rows"], g["q"], n)[:3, 2])),
    (
        r"this is the last row of the rotation",
        _unnamed(lambda g, n: walk(g["rows"], g["q"], n)[2, :3]),
    ),
    (
        r"this is the base's origin, seen from the end",
        _unnamed(lambda g, n: back(walk(g["rows"], g["q"], n))[:3, 3]),
    ),
]
UNNAMED = [
    LAST_ROW,
    (
        r"this is the end's whole pose, and its place is asked",
        lambda a, g, f: np.shape(a) == (4, 4) and near(np.asarray(a)[:3, 3], right_of(g)),
    ),
    *OF_A_READING,
    *(
        (
            pattern + r", in the reading that the check pose does not fit",
            lambda a, g, f, holds=holds: holds(a, g | {"other": True}, f),
        )
        for pattern, holds in OF_A_READING[1:]
    ),
    (
        r"this is the point at q_check, in the reading that the check pose does not fit",
        is_value(lambda g: walk(g["rows"], g["q_check"], _other(_convention(g)))[:3, 3]),
    ),
    (
        r"this is p_check, the point at q_check; the point at q is asked",
        is_value(lambda g: g["p_check"]),
    ),
]

# ---- 05


def _origin(made):
    return is_value(lambda g: made(g["theta"], g["d"], g["a"], g["alpha"]))


ORIGIN = [
    (r"The shift along x is made before the turn about z", _origin(lambda t, d, a, al: [a, 0, d])),
    (r"this is the x arrow, without its length", _origin(lambda t, d, a, al: [C(t), S(t), 0])),
    (r"this is the z arrow", _origin(lambda t, d, a, al: [S(t) * S(al), -C(t) * S(al), C(al)])),
    (
        r"Degrees passed to sin and cos",
        _origin(lambda t, d, a, al: [a * np.cos(t), a * np.sin(t), d]),
    ),
    (r"a and d have changed places", _origin(lambda t, d, a, al: [d * C(t), d * S(t), a])),
    (
        r"sine and cosine of θ have changed places",
        _origin(lambda t, d, a, al: [a * S(t), a * C(t), d]),
    ),
    (r"α stands where θ belongs", _origin(lambda t, d, a, al: [a * C(al), a * S(al), d])),
    (
        r"the x moves come before the z moves",
        _origin(lambda t, d, a, al: [a, -d * S(al), d * C(al)]),
    ),
    (
        r"this is the old origin, seen from the new frame",
        _origin(lambda t, d, a, al: back(one_row(t, d, a, al))[:3, 3]),
    ),
    (
        r"rounded too early",
        lambda a, g, f: near(a, right_of(g), 6e-3) and near(np.round(a, 2), a, 1e-9),
    ),
]


def _slide(made):
    return is_value(lambda g: made(g["q3"]))


SLIDE = [
    (r"θ is −90° here, not 0", _slide(lambda q: one_row(0, q, 0.05, 90))),
    (r"θ is −90° here, not \+90°", _slide(lambda q: one_row(90, q, 0.05, 90))),
    (r"α is \+90° here, not −90°", _slide(lambda q: one_row(-90, q, 0.05, -90))),
    (
        r"θ and α have changed places, or both their signs",
        _slide(lambda q: one_row(90, q, 0.05, -90)),
    ),
    (r"q3 is left out", _slide(lambda q: one_row(-90, 0, 0.05, 90))),
    (
        r"q3 was added to θ; this joint slides",
        _slide(lambda q: one_row(np.degrees(q) - 90, 0, 0.05, 90)),
    ),
    (
        r"q3 stands in place of θ; this joint slides",
        _slide(lambda q: one_row(np.degrees(q), 0, 0.05, 90)),
    ),
    (
        r"rounded on the way",
        lambda a, g, f: (
            near(a, one_row(-90, g["q3"], 0.05, 90), 2e-3)
            and not near(a, one_row(-90, g["q3"], 0.05, 90), 1e-9)
        ),
    ),
    (
        r"both angles are in degrees, and the function takes radians",
        _slide(lambda q: one_row(np.degrees(-90), q, 0.05, np.degrees(90))),
    ),
    (
        r"θ is in degrees, and the function takes radians",
        _slide(lambda q: one_row(np.degrees(-90), q, 0.05, 90)),
    ),
    (
        r"α is in degrees, and the function takes radians",
        _slide(lambda q: one_row(-90, q, 0.05, np.degrees(90))),
    ),
    (r"d and a have changed places", _slide(lambda q: one_row(-90, 0.05, q, 90))),
    (
        r"θ and d have changed places",
        _slide(lambda q: one_row(np.degrees(q), -np.pi / 2, 0.05, 90)),
    ),
    (r"a was left out: it is 0.05", _slide(lambda q: one_row(-90, q, 0, 90))),
    (r"a is 0.05, not 0.5", _slide(lambda q: one_row(-90, q, 0.5, 90))),
    (r"α was left out: it is 90°", _slide(lambda q: one_row(-90, q, 0.05, 0))),
    (r"this is Craig's matrix", _slide(lambda q: one_row(0, 0, 0.05, 90) @ one_row(-90, q, 0, 0))),
    (
        r"The rotation block is transposed",
        lambda a, g, f: (
            near(np.asarray(a)[:3, :3].T, one_row(-90, g["q3"], 0.05, 90)[:3, :3])
            and near(np.asarray(a)[:3, 3], one_row(-90, g["q3"], 0.05, 90)[:3, 3])
        ),
    ),
    (
        r"The whole 4×4 is transposed",
        lambda a, g, f: near(np.transpose(a), one_row(-90, g["q3"], 0.05, 90)),
    ),
    (
        r"this is the inverse of the right matrix",
        lambda a, g, f: near(np.matmul(a, one_row(-90, g["q3"], 0.05, 90)), np.eye(4)),
    ),
]

# ---- 06

ARTICLE = [
    [0, 0.1, 0, 90],
    [0, 0, 0.4, 0],
    [0, 0, 0.35, 0],
    [0, 0.1, 0, 90],
    [0, 0, 0, -90],
    [0, 0.1, 0, 0],
]


def _irb120():
    table = dh.load("irb120").table
    return np.column_stack([np.degrees(table.theta), table.d, table.a, np.degrees(table.alpha)])


def _chain(rows_and_q, made):
    return lambda answer, given, found: near(answer, made(*rows_and_q(given), found), 3e-3)


def _of_a_chain(of):
    turns = [180 / np.pi, 1, 1, 180 / np.pi]
    return [
        (pattern, _chain(of, made))
        for pattern, made in (
            (r"α was left in degrees", lambda r, q, f: walk(r * [1, 1, 1, turns[0]], q)),
            (r"θ was left in degrees", lambda r, q, f: walk(r * [turns[0], 1, 1, 1], q)),
            (r"the rows were converted twice", lambda r, q, f: walk(r / turns, q)),
            (
                r"this is the pose of frame \{(?P<k>\d)\}, after \d of 6 rows",
                lambda r, q, f: walk(r[: int(f["k"])], q[: int(f["k"])]),
            ),
            (
                r"row (?P<k>\d)( or row \d)* was left out",
                lambda r, q, f: walk(
                    np.delete(r, int(f["k"]) - 1, 0), np.delete(q, int(f["k"]) - 1)
                ),
            ),
            (r"this is np.eye\(4\), the pose before the first row", lambda r, q, f: np.eye(4)),
            (
                r"the lengths went through np.deg2rad too",
                lambda r, q, f: walk(np.radians(r) * [turns[0], 1, 1, turns[0]], q),
            ),
            (r"the rows were left in degrees", lambda r, q, f: walk(r * turns, q)),
            (r"rows and q were left in degrees", lambda r, q, f: walk(r * turns, np.degrees(q))),
            (r"q was left in degrees", lambda r, q, f: walk(r, np.degrees(q))),
            (r"q was converted twice", lambda r, q, f: walk(r, np.radians(q))),
            (
                r"the rows and q were converted twice",
                lambda r, q, f: walk(r / turns, np.radians(q)),
            ),
            (r"both offsets were left out", lambda r, q, f: walk(r * [0, 1, 1, 1], q)),
            (r"both offsets were added twice", lambda r, q, f: walk(r * [2, 1, 1, 1], q)),
            (
                r"the offset of joint 2 has the other sign",
                lambda r, q, f: walk(
                    [[-x[0], *x[1:]] if k == 1 else x for k, x in enumerate(r)], q
                ),
            ),
            (r"q was taken off the offsets, not added", lambda r, q, f: walk(r, -q)),
            (r"this is the pose at q = 0", lambda r, q, f: walk(r, 0 * q)),
            (
                r"every joint has the q of the joint behind it",
                lambda r, q, f: walk(r, [*q[1:], q[0]]),
            ),
            (
                r"every joint has the q of the joint before it",
                lambda r, q, f: walk(r, [q[-1], *q[:-1]]),
            ),
            (
                r"the offset of joint (?P<joint>\d) was left out",
                lambda r, q, f: walk(
                    [
                        [0, *row[1:]] if k == int(f["joint"]) else row
                        for k, row in enumerate(r.tolist(), 1)
                    ],
                    q,
                ),
            ),
            (r"this is what Craig's matrix makes of the rows", lambda r, q, f: walk(r, q, "craig")),
            (r"the last row was left out", lambda r, q, f: walk(r[:-1], q[:-1])),
            (r"the first row was left out", lambda r, q, f: walk(r[1:], q[1:])),
            (r"this is the base's pose, seen from the end", lambda r, q, f: back(walk(r, q))),
            (r"The whole 4×4 is transposed", lambda r, q, f: walk(r, q).T),
            (r"The rotation block is transposed", lambda r, q, f: _turned_block(walk(r, q))),
            (r"a and d have changed places", lambda r, q, f: walk(r[:, [0, 2, 1, 3]], q)),
            (
                r"the links are multiplied in the reverse order",
                lambda r, q, f: walk(r[::-1], q[::-1]),
            ),
            (
                r"The last row is not 0 0 0 1",
                lambda r, q, f: np.vstack([walk(r, q)[:3], np.zeros(4)]),
            ),
        )
    ]


def _turned_block(T):
    return np.vstack([np.column_stack([T[:3, :3].T, T[:3, 3]]), [0, 0, 0, 1]])


# ---- 07.7


def _offsets(made):
    return lambda a, g, f: bool(
        (np.abs((np.asarray(a) - made(right_of(g)) + 180) % 360 - 180) < 0.5).all()
    )


OFFSETS = [
    (r"both offsets are twice as large as they should be", _offsets(lambda r: 2 * r)),
    (r"both offsets have the other sign", _offsets(lambda r: -r)),
    (r"the offset of joint 2 has the other sign", _offsets(lambda r: r * [-1, 1])),
    (r"the offset of joint 3 has the other sign", _offsets(lambda r: r * [1, -1])),
    (r"the offsets of joints 2 and 3 have changed places", _offsets(lambda r: r[::-1])),
    (r"neither offset is 0", lambda a, g, f: near(a, [0, 0]) and (np.abs(right_of(g)) > 1).all()),
    (r"joint 3 has an offset too", _offsets(lambda r: r * [1, 0])),
    (r"joint 2 has an offset too", _offsets(lambda r: r * [0, 1])),
    (
        r"these are joints 1 and 2: offsets\[0\] belongs to joint 1",
        lambda a, g, f: abs(a[1] - right_of(g)[0]) < 0.5,
    ),
    (
        r"these are joints 3 and 4: offsets\[0\] belongs to joint 1",
        lambda a, g, f: abs(a[0] - right_of(g)[1]) < 0.5,
    ),
]

# ---- 08, 09


def jacobian_of(name, q, tool=None):
    """Columns by small motions: what the end does when one joint moves a little, from the poses
    alone.
    """
    arm, h = dh.load(name), 1e-6
    T, columns = arm.forward(q), []
    for k in range(6):
        step = h * np.eye(6)[k]
        d = (arm.forward(q + step) - arm.forward(q - step)) / (2 * h)
        W = d[:3, :3] @ T[:3, :3].T
        columns.append([*d[:3, 3], W[2, 1], W[0, 2], W[1, 0]])
    return np.array(columns).T


def _column(made):
    """(v, ω) of column 3 against what is made of them, of the frames and of the end."""

    def holds(answer, g, f):
        q = np.radians(g["q"])
        arm = dh.load("article-6r")
        v, w = np.split(jacobian_of("article-6r", q)[:, 2], 2)
        return near(answer, np.concatenate(made(v, w, arm.frames(q)[2], arm.forward(q))), 3e-3)

    return holds


BENT = np.radians([0, 40, -60, 50, 40, 0])


def _memory(answer, g, f):
    arm, q = dh.load("article-6r"), np.radians(g["q"])
    at, to = {
        "this is the column at bent, whose frames and p are still in memory": (BENT, BENT),
        "the frames are those of bent, still in memory": (BENT, q),
        "p is the end at bent, still in memory": (q, BENT),
    }[f["what"]]
    frame, p = arm.frames(at)[2], arm.forward(to)[:3, 3]
    return near(answer, [*np.cross(frame[:3, 2], p - frame[:3, 3]), *frame[:3, 2]], 3e-3)


COLUMN = [
    (r"(?P<what>.*in memory)", _memory),
    (
        r"this is row 3 of J",
        lambda a, g, f: near(a, jacobian_of("article-6r", np.radians(g["q"]))[2]),
    ),
    (
        r"this is column (?P<k>\d)",
        lambda a, g, f: near(a, jacobian_of("article-6r", np.radians(g["q"]))[:, int(f["k"]) - 1]),
    ),
    (r"ω is right, and v has the other sign", _column(lambda v, w, F, T: (-v, w))),
    (r"v is right, and ω has the other sign", _column(lambda v, w, F, T: (v, -w))),
    (r"all six numbers have the other sign", _column(lambda v, w, F, T: (-v, -w))),
    (r"ω stands above v, and v above ω is asked", _column(lambda v, w, F, T: (w, v))),
    (r"v is right, and ω is left out", _column(lambda v, w, F, T: (v, 0 * w))),
    (r"this is a sliding joint's column: v = z, ω = 0", _column(lambda v, w, F, T: (w, 0 * w))),
    (
        r"ω is right, v is not: this lever runs from the base's origin",
        _column(lambda v, w, F, T: (np.cross(w, T[:3, 3]), w)),
    ),
    (
        r"ω is right, v is not: this v is the lever, without the axis",
        _column(lambda v, w, F, T: (T[:3, 3] - F[:3, 3], w)),
    ),
    (
        r"ω is right, v is not: this lever ends at the joint",
        _column(lambda v, w, F, T: (np.cross(w, F[:3, 3]), w)),
    ),
    (
        r"ω is right, v is not: this lever is p \+ o",
        _column(lambda v, w, F, T: (np.cross(w, T[:3, 3] + F[:3, 3]), w)),
    ),
    (
        r"written in the end's own axes",
        _column(lambda v, w, F, T: (T[:3, :3].T @ v, T[:3, :3].T @ w)),
    ),
    (
        r"q was left in degrees",
        lambda a, g, f: near(a, jacobian_of("article-6r", np.array(g["q"]))[:, 2], 3e-3),
    ),
]


def _at(g):
    q = np.array(g["q"]) * [np.pi / 180, np.pi / 180, 1, np.pi / 180, np.pi / 180, np.pi / 180]
    return q, jacobian_of("stanford", q), np.array([*g["v"], *g["omega"]])


def _speeds(made):
    """The speeds do what is said: ``made(J, twist, speeds, q)`` is true."""
    return lambda a, g, f: bool(made(*_at(g)[1:], np.asarray(a, dtype=float), _at(g)[0]))


def _fits(J, twist, speeds):
    return near(J @ speeds, twist, 5e-3)


def _ends(J, twist, s, q):
    """Some other point would go as the hand was told: with ω the speeds turn the hand as asked."""
    return near(J[3:] @ s, twist[3:], 5e-3) and not near(J[:3] @ s, twist[:3], 5e-3)


def _at_degrees(g, slide_only):
    q = np.array(g["q"], dtype=float)
    if slide_only:
        q = np.radians(q)
    return jacobian_of("stanford", q)


def _reversed(J, q):
    other = J.copy()
    other[:3, [0, 1, 3, 4, 5]] *= -1
    return other


def _from_base(J, q):
    other, p = J.copy(), dh.load("stanford").forward(q)[:3, 3]
    for k in (0, 1, 3, 4, 5):
        other[:3, k] = np.cross(J[3:, k], p)
    return other


def _in_own_axes(J, q):
    R = dh.load("stanford").forward(q)[:3, :3]
    return np.vstack([R.T @ J[:3], R.T @ J[3:]])


def _slides_and_turns(J, q):
    other = J.copy()
    other[3:, 2] = J[:3, 2]
    return other


def _turning(q):
    """The Jacobian of the Stanford arm if its joint 3 turned."""
    arm = dh.load("stanford")
    frames, p = arm.frames(q), arm.forward(q)[:3, 3]
    columns = [[*np.cross(F[:3, 2], p - F[:3, 3]), *F[:3, 2]] for F in frames[:6]]
    return np.array(columns).T


def _next_frames(J, q):
    arm = dh.load("stanford")
    frames, p = arm.frames(q)[1:], arm.forward(q)[:3, 3]
    columns = [
        [*F[:3, 2], 0, 0, 0] if k == 2 else [*np.cross(F[:3, 2], p - F[:3, 3]), *F[:3, 2]]
        for k, F in enumerate(frames)
    ]
    return np.array(columns).T


HAND = [
    (r"v was put where ω belongs", _speeds(lambda J, t, s, q: _fits(J, np.roll(t, 3), s))),
    (
        r"this is Jᵀ times the hand's velocity, .+",
        _speeds(lambda J, t, s, q: near(s, J.T @ t, 5e-3)),
    ),
    (r"this is J times the hand's velocity", _speeds(lambda J, t, s, q: near(s, J @ t, 5e-3))),
    *(
        (
            rf"ω went through {name}: it is given in rad/s, and rad/s are asked",
            _speeds(lambda J, t, s, q, by=by: _fits(J, np.array([*t[:3], *by(t[3:])]), s)),
        )
        for name, by in (("deg2rad", np.radians), ("rad2deg", np.degrees))
    ),
    (
        r"these speeds fit the Jacobian of the article's arm",
        _speeds(lambda J, t, s, q: _fits(jacobian_of("article-6r", q), t, s)),
    ),
    (r"all six speeds have the other sign", _speeds(lambda J, t, s, q: _fits(J, -t, s))),
    (r"all six went through rad2deg: .+", _speeds(lambda J, t, s, q: _fits(J, t, np.radians(s)))),
    (
        r"q was left in degrees",
        lambda a, g, f: _fits(_at_degrees(g, False), _at(g)[2], np.asarray(a)),
    ),
    (
        r"joint 3's value went through deg2rad too",
        lambda a, g, f: _fits(_at_degrees(g, True), _at(g)[2], np.asarray(a)),
    ),
    (
        r"this is a damped step: the hand lags behind what was asked",
        _speeds(lambda J, t, s, q: 0 < (J @ s) @ t < t @ t),
    ),
    (
        r"the hand goes at v, but does not turn with ω",
        _speeds(lambda J, t, s, q: near((J @ s)[:3], t[:3], 5e-3) and not near((J @ s)[3:], t[3:])),
    ),
    (
        r"the hand turns with ω, but does not go at v",
        _speeds(lambda J, t, s, q: near((J @ s)[3:], t[3:], 5e-3) and not near((J @ s)[:3], t[:3])),
    ),
    (
        r"the slide is treated as a turning joint",
        lambda a, g, f: near(
            _turning(_at(g)[0]).T @ (_turning(_at(g)[0]) @ np.asarray(a) - _at(g)[2]),
            np.zeros(6),
            1e-3,
        ),
    ),
    (r"these speeds are beyond all measure: .+", lambda a, g, f: np.linalg.norm(a) > 1e5),
    (r"these speeds fit another end point", _speeds(_ends)),
    *(
        (
            rf"these speeds fit a Jacobian {words}",
            _speeds(lambda J, t, s, q, made=made: _fits(made(J, q), t, s)),
        )
        for words, made in (
            ("whose cross products are the wrong way round", _reversed),
            ("that takes the axis of joint i from frame i", _next_frames),
            ("whose levers all begin at the base's origin", _from_base),
            ("in which joint 3 slides and turns", _slides_and_turns),
            ("that is written in the end's own axes", _in_own_axes),
        )
    ),
]


def _away(answer, g):
    T, goal = dh.load("ur5e").forward(np.asarray(answer, dtype=float)), np.array(g["T"])
    turn = Rotation.from_matrix(goal[:3, :3].T @ T[:3, :3]).magnitude()
    return 1000 * np.linalg.norm(T[:3, 3] - goal[:3, 3]), np.degrees(turn)


def _turns(q, g):
    """How far each joint is from where it stands, degrees."""
    return np.abs(np.degrees(np.asarray(q, dtype=float)) - g["q_now"])


FAR = r"joint (?P<joint>\d) would turn by (?P<by>\d+)°, and 45° is the most"


def _too_far(whole):
    def holds(a, g, f):
        turns, k = _turns(a, g), int(f["joint"]) - 1
        left = np.abs((turns + 180) % 360 - 180)
        return (
            near(_away(a, g), [0, 0], 0.2)
            and turns[k] == max(turns)
            and abs(turns[k] - int(f["by"])) <= 0.5
            and (max(left) <= 45) == whole
        )

    return holds


REACHED = [
    (
        r"these are degrees, and q is in radians",
        lambda a, g, f: near(_away(np.radians(a), g), [0, 0], 0.2),
    ),
    (
        r"these are (?P<n>\d+) q, and one is asked @ (?P<near>\d+|none) of them reach(es)? the pose"
        r" with no joint turned further than 45°",
        lambda a, g, f: (
            len(a) == int(f["n"])
            and [near(_away(q, g), [0, 0], 0.2) and max(_turns(q, g)) <= 45 for q in a].count(True)
            == int(f["near"].replace("none", "0"))
        ),
    ),
    (r"the pose is right, but whole turns are left in q @ " + FAR, _too_far(whole=True)),
    (r"the pose is right, but on another branch than the near one @ " + FAR, _too_far(whole=False)),
    (
        r"the hand is (?P<mm>[\d.e+-]+) mm and (?P<deg>[\d.e+-]+)° away from the pose",
        lambda a, g, f: np.allclose(
            _away(a, g), [float(f["mm"]), float(f["deg"])], rtol=6e-3, atol=1e-3
        ),
    ),
]
HANDS_ARROW = [
    (
        r"this is the third row: the base's z arrow, seen from the hand",
        is_value(lambda g: g["T"][2][:3]),
    ),
    (
        r"this is the hand's (?P<which>[xy]) arrow",
        lambda a, g, f: near(a, [r[NUMBER[f["which"]]] for r in g["T"][:3]], 3e-3),
    ),
    (r"this is the hand's place", is_value(lambda g: [r[3] for r in g["T"][:3]])),
    (
        r"this is the base's place, seen from the hand",
        lambda a, g, f: near(
            np.asarray(g["T"])[:3, :3] @ a + np.asarray(g["T"])[:3, 3], [0, 0, 0], 5e-3
        ),
    ),
    (r"this is the hand's z arrow turned round", is_value(lambda g: [-r[2] for r in g["T"][:3]])),
]


def _craig_row(k, *columns):
    """Entries of row ``joint + k`` (1-based joint) of the Craig table: θ, d, a, α in degrees."""

    def entries(g):
        table, i = g["table"], g["joint"] - 1 + k
        row = np.degrees(table.theta[i]), table.d[i], table.a[i], np.degrees(table.alpha[i])
        return [row[c] for c in columns]

    return entries


def _of_rows(i, k):
    """α of row i of the Craig table and a of row k, counted from 1."""
    return lambda g: [*_craig_row(i - g["joint"], 3)(g), *_craig_row(k - g["joint"], 2)(g)]


BETWEEN = [
    (r"these are a and α of the earlier joint's row; .+", is_value(_craig_row(0, 3, 2))),
    (r"angle and distance have changed places", is_value(_craig_row(1, 2, 3))),
    (r"the distance is d, and a is asked", is_value(_craig_row(1, 3, 1))),
    (r"the angle is θ, and α is asked", is_value(_craig_row(1, 0, 2))),
    (r"these are θ and d of the earlier joint's row", is_value(_craig_row(0, 0, 1))),
    (
        r"the distance is a of row (?P<row>\d), which leads to another axis",
        lambda a, g, f: is_value(_of_rows(g["joint"] + 1, int(f["row"])))(a, g, f),
    ),
    (
        r"the angle is α of row (?P<row>\d), which leads to another axis",
        lambda a, g, f: is_value(_of_rows(int(f["row"]), g["joint"] + 1))(a, g, f),
    ),
]


def _turn(g):
    return g["at_stop"] / 4096 * 360


def _whole(angle):
    """Whether an angle in degrees is some whole turns."""
    return abs((angle + 180) % 360 - 180) < 0.5


BENCH = [
    (
        r"at the stop these two give (?P<angle>-?\d+)°, a whole turn from where the joint is",
        lambda a, g, f: (
            np.isclose(a[0] * _turn(g) + a[1], float(f["angle"]))
            and np.isclose(abs(float(f["angle"]) - g["stop"]), 360)
        ),
    ),
    (
        r"right at the stop, and from there the wrong way",
        lambda a, g, f: a[0] == 1 and _whole(a[0] * _turn(g) + a[1] - g["stop"]),
    ),
    (
        r"the offset is right; the sign is not",
        lambda a, g, f: a[0] == 1 and _whole(-_turn(g) + a[1] - g["stop"]),
    ),
    *(
        (
            rf"the sign is (?P<sign>right;|not right; and) in the offset {said}",
            lambda a, g, f, of=of: (
                a[0] == (-1 if f["sign"] == "right;" else 1)
                and _whole(a[1] - of(g["stop"], _turn(g), g["at_stop"]))
            ),
        )
        for said, of in (
            (r"the stop's angle has the other sign", lambda stop, turn, at: turn - stop),
            (r"the reading has the other sign", lambda stop, turn, at: stop - turn),
            (r"both parts have the other sign", lambda stop, turn, at: -stop - turn),
            (r"the stop's angle is left out", lambda stop, turn, at: turn),
            (r"the reading at the stop is left out", lambda stop, turn, at: stop),
            (
                r"the reading is left out, and the stop's angle has the other sign",
                lambda stop, turn, at: -stop,
            ),
            (r"the reading is still in counts", lambda stop, turn, at: stop + at),
        )
    ),
]

CLAIMS = {
    "00.1": PRODUCT,
    "01.1": ARROW,
    "01.2": PLATE,
    "01.3": POINT,
    "01.7": TIP,
    "02.3": LINK,
    "02.4": LINK,
    "02.6": MAKEABLE,
    "02.8": TUBE,
    "03.10": UNNAMED,
    "05.5": ORIGIN,
    "05.9": SLIDE,
    "06.3": _of_a_chain(lambda g: (np.array(ARTICLE, dtype=float), np.zeros(6))),
    "06.10": [
        *_of_a_chain(lambda g: (_irb120(), np.asarray(g["q"], dtype=float))),
        (
            r"this is the pose of the article's arm, and that of the IRB 120 is asked",
            lambda a, g, f: near(a, walk(ARTICLE, g["q"])),
        ),
    ],
    "07.7": OFFSETS,
    "08.1": COLUMN,
    "08.9": HAND,
    "08.13": REACHED,
    "09.10": BENCH,
    "09.5": HANDS_ARROW,
    "09.6": BETWEEN,
}
