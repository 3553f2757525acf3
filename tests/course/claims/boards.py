"""Claims about placed frames: each sentence is asked of the lines and of what was typed."""

import re

import numpy as np

from dhlab.placing.board import Placement

from .general import FACTORS

SMALL = 2e-3  # rad, m
STEP = r"(?P<step>[zox]\d) is not right\. "
ALLOWED = r"( (?P<kept>[zox]\d( and [zox]\d)*) (was|were) allowed as handed out\.)?"


def unit(v):
    v = np.asarray(v, dtype=float)
    return v / np.linalg.norm(v)


class Board:
    """A step of an answer, the line of its z and that of the z before, as (point, direction)."""

    def __init__(self, answer, given, step):
        self.given, self.rows, self.i = given, answer, int(step[1:])
        self.value = np.asarray(answer[self.i]["zox".index(step[0])], dtype=float)

    def axis(self, joint):
        """The line of a joint from its drawing; of a slide, through the origin that was placed."""
        point, z, *letter = self.given["axes"][joint - 1]
        placed = self.rows[joint - 1][1]
        return np.asarray(placed if letter == ["P"] else point, dtype=float), unit(z)

    def line(self, k):
        """The line of z_k; that of the last one as it was placed."""
        if k < len(self.given["axes"]):
            return self.axis(k + 1)
        return np.asarray(self.rows[k][1], dtype=float), unit(self.rows[k][0])

    @property
    def own(self):
        return self.line(self.i)

    @property
    def before(self):
        return self.line(self.i - 1)


def off(line, point):
    """How far a point is from a line."""
    return np.linalg.norm(np.cross(line[1], np.asarray(point, dtype=float) - line[0]))


def between(one, other):
    """How far two lines pass each other by."""
    n = np.cross(one[1], other[1])
    if np.linalg.norm(n) < SMALL:
        return off(one, other[0])
    return abs((other[0] - one[0]) @ unit(n))


def turned(u, v):
    """The angle between two lines' directions, degrees."""
    return np.degrees(
        np.arctan2(np.linalg.norm(np.cross(unit(u), unit(v))), abs(unit(u) @ unit(v)))
    )


def across(u, v):
    return abs(unit(u) @ unit(v)) < 0.02


def on_wrong_joint(b, f):
    k, j = int(f["k"]), int(f["j"])
    return k == b.i + 1 and turned(b.value, b.axis(j)[1]) < 1 <= turned(b.value, b.axis(k)[1])


def tilted(b, f):
    away = turned(b.value, b.axis(int(f["k"]))[1])
    return int(f["k"]) == b.i + 1 and abs(away - float(f["deg"])) <= 0.6


def away_from_meeting(b, f):
    there = off(b.own, b.value) < SMALL and between(b.own, b.before) < SMALL
    return there and off(b.before, b.value) > SMALL


def not_the_foot(b, f):
    skew = turned(b.own[1], b.before[1]) > 1 and between(b.own, b.before) > SMALL
    x = np.cross(b.own[1], b.before[1])
    return skew and off(b.own, b.value) < SMALL and between((b.value, unit(x)), b.before) > SMALL


def beside(b, f):
    return abs(off(b.own, b.value) - float(f["far"])) < 6e-4


def foot_on_other(b, f):
    x = np.cross(b.own[1], b.before[1])
    return of_other(b, f) and between((b.value, unit(x)), b.own) < SMALL


def of_other(b, f):
    return off(b.before, b.value) < SMALL < off(b.own, b.value)


def no_single_row(b, f):
    """No line at right angles to both from here meets the z before."""
    x = np.cross(b.own[1], b.before[1])
    return np.linalg.norm(x) > SMALL and between((b.value, unit(x)), b.before) > SMALL


def along_own(b, f):
    return turned(b.value, b.own[1]) < 1


def in_plane(b, f):
    normal = np.cross(b.own[1], b.before[1])
    return between(b.own, b.before) < SMALL and across(b.value, normal)


def leaning(b, f):
    return abs(turned(b.value, b.own[1]) - float(f["deg"])) <= 0.6 and float(f["deg"]) < 90


def leaning_to_other(b, f):
    return across(b.value, b.own[1]) and not across(b.value, b.before[1])


def passes_by(b, f):
    return between((np.asarray(b.rows[b.i][1], dtype=float), unit(b.value)), b.before) > SMALL


OF_STEPS = [
    (r"This points along the axis of joint (?P<j>\d); in the standard convention z\d is the axis of"
     r" joint (?P<k>\d)\. Look at the axis of joint (?P=k)\.", on_wrong_joint),
    (r"This stands across the axis of joint (?P<k>\d)\. z lies on the line the joint (turns about|"
     r"slides along): .+", lambda b, f: (
        int(f["k"]) == b.i + 1 and across(b.value, b.axis(b.i + 1)[1]))),
    (r"This is (?P<deg>\d+)° away from the axis of joint (?P<k>\d); .+", tilted),
    (r"Joint (?P<k>\d) slides, and this is not its direction\.", lambda b, f: (
        b.given["axes"][int(f["k"]) - 1][2:] == ("P",)
        and turned(b.value, b.axis(int(f["k"]))[1]) > 0.5)),
    (r"This point is on z\d, but away from where z\d and z\d meet\. .+", away_from_meeting),
    (r"This point is on z\d, but x\d from here would miss z\d\. z\d and z\d are skew: .+",
     not_the_foot),
    (r"This point is (?P<far>[\d.]+) m beside z\d\. .+", beside),
    (r"This is the foot of the common normal on z\d\. .+", foot_on_other),
    (r"This is a point of z\d\. .+", of_other),
    (r"No single row leads here: .+", no_single_row),
    (r"This runs along z\d itself\. .+", along_own),
    (r"This lies in the plane of z\d and z\d\. .+", in_plane),
    (r"The angle between this and z\d is (?P<deg>\d+)°, not 90°\. .+", leaning),
    (r"This is at right angles to z\d, but not to z\d\. .+", leaning_to_other),
    (r"From o\d this line passes z\d by\. .+?(?P<through>( z\d runs through your o\d\.)*)",
     lambda b, f: passes_by(b, f) and all(
         off(b.line(int(k)), b.rows[int(k)][1]) < SMALL for k in re.findall(r"z(\d)", f["through"])
     )),
]  # fmt: skip
UNITS = r"in other units: (?P<what>.+) in (?P<unit>\w+); metres are asked"
FAR = r"o(?P<i>\d) lies (?P<m>\d+) m from the base"


def in_units(answer, given, f):
    """What is named, taken in the unit, lies on its joint's line, and does not as it stands."""
    names = re.fullmatch(r"(?:(?P<places>[xyz and]+) of )?(?:o(?P<i>\d)|the origins)", f["what"])
    rows = range(len(answer)) if names["i"] is None else [int(names["i"])]
    scale = [
        FACTORS[f["unit"]] if not names["places"] or c in names["places"].split(" and ") else 1
        for c in "xyz"
    ]
    changed = False
    for i in rows:
        point = np.asarray(answer[i][1], dtype=float)
        line = Board(answer, given, f"o{i}").own
        free = i == len(given["axes"]) or given["axes"][i][2:] == ("P",)
        if not free and off(line, point * scale) > SMALL:
            return False
        changed |= free or off(line, point) > SMALL
        if i and not changed:  # on its own line, and away from where it meets the one before
            before = Board(answer, given, f"o{i}").before
            changed = off(before, point) > off(before, point * scale) + SMALL
    return changed


def true_of(verdict, answer, given):
    """Whether what is said of placed frames is true; None where no predicate knows."""
    units, far = re.fullmatch(UNITS, verdict.headline), re.fullmatch(FAR, verdict.headline)
    if units:
        return in_units(answer, given, units)
    if far:
        point = np.asarray(answer[int(far["i"])][1], dtype=float)
        return abs(np.linalg.norm(point) - float(far["m"])) <= 0.5
    if verdict.headline.startswith("every rule is kept now"):
        return _changed_needlessly(answer, given, verdict.place.split(":")[0].split(", "))
    told = verdict.headline.replace("an origin", verdict.place).replace("an x arrow", verdict.place)
    told = told.replace("a z arrow", verdict.place)
    for pattern, holds in OF_STEPS:
        found = re.fullmatch(STEP + pattern + ALLOWED, told)
        if found:
            board = Board(answer, given, found["step"])
            return bool(holds(board, found)) and _kept(answer, given, found["kept"])
    return None


def _changed_needlessly(answer, given, named):
    """Each is otherwise than it was, and with them put back the frames are as good."""
    back = [list(row) for row in answer]
    for step in named:
        i, k = int(step[1:]), "zox".index(step[0])
        if np.allclose(np.asarray(answer[i][k], dtype=float), given["frames"][i][k], atol=1e-3):
            return False
        back[i][k] = given["frames"][i][k]
    board = Placement(given["axes"], given["end"])
    return all(board.set_z(i, z) for i, (z, _, _) in enumerate(back)) and all(
        board.set_origin(i, o) and board.set_x(i, x) for i, (_, o, x) in enumerate(back)
    )


def _kept(answer, given, kept):
    """The steps that are named stood otherwise when the frames were handed out."""
    for step in (kept or "").split(" and ") if kept else ():
        i, k = int(step[1:]), "zox".index(step[0])
        if np.allclose(np.asarray(answer[i][k], dtype=float), given["frames"][i][k]):
            return False
    return True
