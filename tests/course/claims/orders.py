"""Claims about orders, matches and classifications; the answer is a list of the items' ids."""

from itertools import pairwise

import numpy as np

from .vectors import one_row

PLACES = "θ", "d", "a", "α"
ASKED = "about-old-z", "along-old-z", "along-new-x", "about-new-x"
PLATE = {"about-old-z": 0, "along-old-z": 0, "along-new-x": 1, "about-new-x": 1}
ENDS = {"t-01": "01", "t-12": "12", "t-2f": "2F", "t-ft": "FT", "t-tf": "TF", "t-10": "10"}


def says(pattern, holds):
    return (pattern, lambda answer, given, found: holds(list(answer), found))


def wrong_places(answer, right, names=None):
    names = names or [str(k) for k in range(1, len(right) + 1)]
    return [name for name, one, wanted in zip(names, answer, right) if one != wanted]


def these(right, names=None):
    """The named places are the wrong ones, and no others."""
    return lambda a, f: (
        f["names"].replace(" and ", ", ").split(", ") == wrong_places(a, right, names)
    )


def _apart(a, f):
    first = next((x, y) for x, y in pairwise(a) if ENDS[x][1] != ENDS[y][0])
    return [f"T_{ENDS[x]}" for x in first] == [f["one"], f["two"]] and (
        f["out"] == f["one"][-1] and f["in"] == f["two"][2]
    )


def _inverses(a, f):
    return f["names"].split(" and ") == [f"T_{ENDS[x]}" for x in a if x in ("t-tf", "t-10")]


MEET = r"(?P<one>T_\w+), then (?P<two>T_\w+): (?P<out>\w) does not meet (?P<in>\w)"
ONE_OR_TWO = r"(an inverse, which is|(?P<both>two inverses), which are) not needed"
CHAIN = [
    says(
        rf"(?P<names>[T_\w ]+): {ONE_OR_TWO} @ {MEET}",
        lambda a, f: _inverses(a, f) and _apart(a, f),
    ),
    says(
        rf"(?P<names>[T_\w ]+): {ONE_OR_TWO} @ the product begins with"
        r" (?P<first>\w) and ends with (?P<last>\w)",
        lambda a, f: _inverses(a, f) and (ENDS[a[0]][0], ENDS[a[-1]][1]) == (f["first"], f["last"]),
    ),
    says(rf"two neighbours do not meet @ {MEET}", _apart),
    says(
        r"the four are right, in the reverse order",
        lambda a, f: a == ["t-ft", "t-2f", "t-12", "t-01"],
    ),
]


def _imitates(a, f):
    told = f["names"].split(", ")
    return told == [
        name
        for name, way in zip(PLACES, a)
        if (name, way) in (("θ", "about-new-z"), ("a", "along-old-x"))
    ]


def _kinds(a, f):
    angle = {"θ": True, "d": False, "a": False, "α": True}
    return f["names"].split(", ") == [
        name for name, way in zip(PLACES, a) if way.startswith("about") != angle[name]
    ]


AXES = [
    says(r"the right kind of number, on the wrong plate @ (?P<names>.+)", _imitates),
    says(r"an angle stands for a length, or a length for an angle @ (?P<names>.+)", _kinds),
    says(
        r"θ and α have changed places", lambda a, f: a == [ASKED[3], ASKED[1], ASKED[2], ASKED[0]]
    ),
    says(
        r"d and a have changed places", lambda a, f: a == [ASKED[0], ASKED[2], ASKED[1], ASKED[3]]
    ),
    says(
        r"the right kinds of numbers, along or about the wrong arrows @ (?P<names>.+)",
        lambda a, f: (
            these(ASKED, PLACES)(a, f)
            and all(
                (x in "about-old-z about-new-x about-new-z") == (k in (0, 3))
                for k, x in enumerate(a)
            )
        ),
    ),
]
FAR_END = {"standard": "far", "craig": "near"}  # where plate i stands on link i
WHOSE = ["craig", "standard", "craig", "craig", "standard", "standard"]
TABLES = ["craig", "standard", "standard", "craig", "standard", "craig"]
PAIRS = ["convention", "hand", "digit", "zero-pose", "reversed-joint"]


def _zeros(a, f):
    """Of the wrong ones, Craig's have their zeros in row 1 and the standard ones in the last."""
    wrong = [int(k) for k in wrong_places(a, TABLES)]
    first = [k for k in wrong if TABLES[k - 1] == "craig"]
    told = {
        "row 1": [int(k) for k in (f["first"] or "").split(", ") if k],
        "last": [int(k) for k in (f["last"] or "").split(", ") if k],
    }
    return told == {"row 1": first, "last": [k for k in wrong if k not in first]}


def _matrix(order):
    moves = {
        "rz": one_row(20, 0, 0, 0),
        "tz": one_row(0, 0.3, 0, 0),
        "tx": one_row(0, 0, 0.4, 0),
        "rx": one_row(0, 0, 0, 50),
    }
    T = np.eye(4)
    for move in order:
        T = T @ moves[move]
    return T


STANDARD, CRAIG = _matrix(["rz", "tz", "tx", "rx"]), _matrix(["rx", "tx", "rz", "tz"])


def _before(one, other):
    return lambda a, f: a.index(one) < a.index(other)


LIE = ["meet", "parallel", "parallel", "meet", "meet"]  # the article's six axes, pair by pair
LINE = {"axis-1": 1, "axis-2": 2, "axis-3": 3}
LENGTHS = ["shoulder-height", "upper-arm", "forearm", "sideways", "wrist-to-tool"]
ARMS = ["the article's arm", "the UR5e", "the AR4", "the Piper"]
STRUCTURE = ["both", "parallel", "one-point", "one-point"]
SYMPTOMS = ["degrees", "length", "reversed-joint", "base-height", "tool"]
NEEDS = {  # what a line of the loop needs, by what it makes
    "frames": "q",
    "error": "T",
    "jacobian": "T",
}

CLAIMS = {
    "01.5": CHAIN,
    "02.1": AXES,
    "03.1": [
        says(
            r"all six: the two conventions have changed places",
            lambda a, f: len(wrong_places(a, WHOSE)) == 6,
        ),
        says(r"look again at statements? (?P<names>[\d, ]+)(: .+)?", these(WHOSE)),
    ],
    "03.2": [
        says(
            r"this is the standard matrix: the joint turns first, then comes the link",
            lambda a, f: np.allclose(_matrix(a), STANDARD),
        ),
        says(
            r"this is neither Craig's matrix nor the standard one",
            lambda a, f: (
                not np.allclose(_matrix(a), STANDARD) and not np.allclose(_matrix(a), CRAIG)
            ),
        ),
    ],
    "03.5": [
        says(
            r"all six: the two have changed places", lambda a, f: len(wrong_places(a, TABLES)) == 6
        ),
        says(
            r"(the zeros of tables? (?P<first>[\d, ]+) stand in row 1)?( and )?"
            r"(the zeros of tables? (?P<last>[\d, ]+) stand in the last row)?",
            _zeros,
        ),
    ],
    "03.6": [says(r"look again at pairs? (?P<names>[\d, ]+)", these(PAIRS))],
    "04.1": [
        says(
            r"z1 and z2: these are the axes of joints 1 and 2",
            lambda a, f: a[1:] == ["axis-1", "axis-2"],
        ),
        says(
            r"z0 and z1: these are the axes of joints 2 and 3, one joint too far",
            lambda a, f: a[:2] == ["axis-2", "axis-3"],
        ),
        says(
            r"(?P<names>[z\d, ]+): (this line is|these lines are) no joint's axis"
            r"(; (?P<others>[z\d, ]+): the axis of another joint)?",
            lambda a, f: (
                f["names"].split(", ") == [f"z{k}" for k, line in enumerate(a) if line not in LINE]
                and (f["others"] or "").split(", ")
                == ([f"z{k}" for k, x in enumerate(a) if LINE.get(x, k + 1) != k + 1] or [""])
            ),
        ),
        says(
            r"(?P<names>[z\d, ]+): the axis of another joint",
            lambda a, f: (
                all(line in LINE for line in a)
                and f["names"].split(", ") == [f"z{k}" for k, x in enumerate(a) if LINE[x] != k + 1]
            ),
        ),
    ],
    "04.11": [
        says(
            r"axes (?P<k>\d) and (?P<next>\d) lie otherwise",
            lambda a, f: wrong_places(a, LIE)[0] == f["k"] and int(f["next"]) == int(f["k"]) + 1,
        )
    ],
    "05.3": [
        says(
            r"this is the order that was given, and another is asked",
            lambda a, f: a == ["rz", "tz", "tx", "rx"],
        ),
        says(r"the x moves come before the z moves", lambda a, f: set(a[:2]) == {"tx", "rx"}),
        says(r"Tx\(a\) stands before Rz\(θ\)", _before("tx", "rz")),
        says(r"Rx\(α\) stands before Tz\(d\)", _before("rx", "tz")),
        says(r"Rx\(α\) stands before Rz\(θ\)", _before("rx", "rz")),
    ],
    "06.1": [
        says(
            r"(?P<names>\w\d and \w\d) are exchanged",
            lambda a, f: (
                these(LENGTHS, ["d1", "a2", "a3", "d4", "d6"])(a, f)
                and sorted(a) == sorted(LENGTHS)
            ),
        ),
        says(
            r"(?P<names>.+) are not in their places", these(LENGTHS, ["d1", "a2", "a3", "d4", "d6"])
        ),
    ],
    "06.9": [says(r"look again at (?P<names>.+)", these(STRUCTURE, ARMS))],
    "07.1": [
        says(
            r"symptom (?P<k>\d) has another cause",
            lambda a, f: wrong_places(a, SYMPTOMS)[0] == f["k"],
        )
    ],
    "08.5": [
        says(r"q = dq forgets the q before", lambda a, f: "forget-q" in a),
        says(r"a line without damping\*\*2 is among the five", lambda a, f: "undamped" in a),
        says(
            r"pose_error\(T_goal, T\) leads from the goal to here",
            lambda a, f: "error-reversed" in a,
        ),
        says(r"the frames come first", lambda a, f: a[0] != "frames"),
        says(r"q = q \+ dq comes last", lambda a, f: a[-1] != "add-step"),
        says(
            r"dq comes too early",
            lambda a, f: a.index("damped") < max(a.index("error"), a.index("jacobian")),
        ),
    ],
    "08.10": [
        says(r"frames\[i\] stands behind joint i", lambda a, f: "own-frame" in a),
        says(r"o - p points from the end to the axis", lambda a, f: "lever-reversed" in a),
        says(r"this lever begins at the base's origin", lambda a, f: "base-origin" in a),
        says(r"axis and origin come before frames", _before("frame-before", "frames")),
        says(
            r"v comes too early",
            lambda a, f: a.index("lever") < max(a.index("end"), a.index("frame-before")),
        ),
        says(r"the column is stacked too early", _before("stack", "lever")),
    ],
    "09.1": [
        says(r"axes were drawn before it was agreed from where", _before("axes", "agree")),
        says(r"frames were placed before the axes were known", _before("frames", "axes")),
        says(r"the doctor has nothing to compare with yet", _before("doctor", "compare")),
        says(
            r"the measured poses come in at the wrong place",
            lambda a, f: a.index("compare") != 3 or a.index("doctor") != 4,
        ),
    ],
}
for _claims in CLAIMS.values():
    _claims.append(says(r"not in this order", lambda a, f: True))
    _claims.append(says(r"(?P<letter>\w) stands there twice", lambda a, f: len(set(a)) < len(a)))
