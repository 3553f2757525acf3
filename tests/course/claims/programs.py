"""Claims about programs for a link or a chain: what is said of one is asked of the program itself,
by a product of turns and shifts that is not dhlab's.
"""

import math
from itertools import permutations

import numpy as np

NAMES = ("theta", "d", "a", "alpha")
DEG = 180 / math.pi
ROW = (0.4, 0.3, 0.5, 0.9)
STANDARD, CRAIG = ("Rz", "Tz", "Tx", "Rx"), ("Rx", "Tx", "Rz", "Tz")
MOVES = {"Rz": "theta", "Tz": "d", "Tx": "a", "Rx": "alpha", "Rytheta": "theta", "Ryalpha": "alpha"}


def move(name, by):
    T, c, s = np.eye(4), math.cos(by), math.sin(by)
    if name == "Rz":
        T[:2, :2] = [[c, -s], [s, c]]
    elif name.startswith("Ry"):
        T[0, [0, 2]], T[2, [0, 2]] = [c, s], [-s, c]
    elif name == "Rx":
        T[1:3, 1:3] = [[c, -s], [s, c]]
    else:
        T["TxTyTz".index(name) // 2, 3] = by
    return T


def link(row, order):
    T = np.eye(4)
    for name in order:
        T = T @ move(name, row[NAMES.index(MOVES[name])])
    return T


def chain(links):
    T = np.eye(4)
    for one in links:
        T = T @ one
    return T


class Program:
    """A program and some calls of it, each as rows and q, also where it computes one link."""

    def __init__(self, f, is_chain, order=STANDARD):
        rng = np.random.default_rng(8)
        signs = rng.choice([-1, 1], (5, 5, 4))
        sizes = rng.uniform([0.3, 1.1, 1.1, 0.3], [1.3, 2.6, 2.6, 1.3], (5, 5, 4))
        many = (signs * sizes)[:, : 4 if is_chain else 1]
        self.cases = [(rows, 0.7 * rng.normal(size=len(rows)) * is_chain) for rows in many]
        self.f, self.is_chain, self.order = f, is_chain, order
        self.given = np.array([self.call(*case) for case in self.cases])
        self.right = np.array([self.pose(*case) for case in self.cases])

    def call(self, rows, q):
        answer = self.f(rows.copy(), q.copy()) if self.is_chain else self.f(*rows[0])
        return np.array(answer, dtype=float)

    def pose(self, rows, q, order=None):
        return chain(self.links(rows, q, order))

    def links(self, rows, q, order=None):
        return [link([row[0] + x, *row[1:]], order or self.order) for row, x in zip(rows, q)]

    def gives(self, poses):
        return np.allclose(self.given, np.array(poses), rtol=1e-6, atol=1e-9)

    def fits(self, change):
        """Whether the answers are right for other rows and q."""
        return self.gives([self.pose(*change(rows.copy(), q.copy())) for rows, q in self.cases])

    def has(self, names, change, joined=True):
        """Whether they are right for rows in which some numbers are changed, theta with its q."""

        def changed(rows, q):
            for name in names:
                k = NAMES.index(name)
                if k == 0 and joined:
                    rows[:, 0], q = change(rows[:, 0] + q), 0 * q
                else:
                    rows[:, k] = change(rows[:, k])
            return rows, q

        return self.fits(changed)

    def ordered(self, *order):
        return self.gives([self.pose(rows, q, order) for rows, q in self.cases])

    def of_links(self, change):
        """Whether the answers are the chain of links that are changed as a list."""
        return self.gives([chain(change(self.links(*case))) for case in self.cases])

    @property
    def rotation_right(self):
        return np.allclose(self.given[:, :3, :3], self.right[:, :3, :3])

    @property
    def off(self):
        return {(i, k) for _, i, k in np.argwhere(~np.isclose(self.given, self.right, atol=1e-9))}


def named(place):
    """The numbers that a place speaks of, all angles or lengths where it names none."""
    words = place.replace(",", " ").replace(":", " ").split()
    return [name for name in NAMES if name in words]


def angles(place):
    return named(place) or ["theta", "alpha"]


def lengths(place):
    return named(place) or ["d", "a"]


def scaled_angles(factor):
    def holds(p, place):
        if place in ("q", ""):
            return p.fits(lambda rows, q: (rows, q * factor))
        if place == "the theta column":
            return p.has(["theta"], lambda x: x * factor, joined=False)
        if place == "the angles of the rows":
            return p.has(["theta", "alpha"], lambda x: x * factor, joined=False)
        return p.has(angles(place), lambda x: x * factor)

    return holds


def another_value(p, place):
    """Not used, half, twice, or so many degrees too much."""
    (name,) = named(place)
    if "not used" in place or "no effect" in place:
        return p.has([name], lambda x: 0 * x)
    if "°" in place:
        more = float(place.split(": ")[1].split("°")[0]) / DEG
        return p.has([name], lambda x: x + more)
    return p.has([name], lambda x: x * {"half": 0.5, "twice": 2}[place.split()[0]])


def lost_digits(p, place):
    """To fewer digits, in what the place names."""
    if "multiples of 90°" in place:
        return p.has(angles(place), lambda x: np.round(x / (math.pi / 2)) * math.pi / 2)
    if "whole degrees" in place:
        return p.has(angles(place), lambda x: np.round(x * DEG) / DEG)
    digits = int(place.replace(",", " ").split()[-2])
    if named(place):
        return p.has(named(place), lambda x: np.round(x, digits))
    if "each link" in place:
        return p.of_links(lambda links: np.round(links, digits))
    return bool(np.allclose(p.given, np.round(p.given, digits), rtol=0, atol=1e-12))


def cut_off(p, place):
    """To whole numbers, in what the place names."""
    if place == "q":
        return p.fits(lambda rows, q: (rows, np.trunc(q)))
    if place == "the table":
        return p.fits(lambda rows, q: (np.trunc(rows), q))
    if named(place):
        return p.has(named(place), np.trunc)
    if place == "the sums of offset and q":
        return p.has(["theta"], np.trunc)
    return bool((p.given == np.trunc(p.given)).all())


def columns(p, place):
    if place.startswith("q is added"):
        (name,) = named(place)

        def added(rows, q):
            rows[:, NAMES.index(name)] += q
            return rows, 0 * q

        return p.fits(added)
    order = place.removeprefix("read as ").removeprefix("taken as ").split(", ")
    joined = place.startswith("taken as")

    def read(rows, q):
        if joined:
            rows[:, 0] += q
        made = np.empty_like(rows)
        for column, name in enumerate(order):
            made[:, NAMES.index(name)] = rows[:, column]
        return made, 0 * q if joined else q

    return p.fits(read)


def used_for(p, place):
    given, wanted = (NAMES.index(name) for name in place.split()[::4][:2])

    def used(rows, q):
        rows[:, 0] += q
        rows[:, wanted] = rows[:, given]
        return rows, 0 * q

    return p.fits(used)


def another_joint(p, place):
    step = {"before": 1, "after": -1}.get(place.split(",")[0].split()[-1], 0)
    if "this joint's q" in place:
        return p.fits(lambda rows, q: (np.roll(rows, step, axis=0), q))
    if place == "the same q for all rows":
        return any(p.fits(lambda rows, q, k=k: (rows, 0 * q + q[k])) for k in (0, -1))
    if "turned round" in place:
        return p.fits(lambda rows, q: (rows, q[::-1]))
    wrapped = p.fits(lambda rows, q: (rows, np.roll(q, step)))
    return wrapped or p.fits(lambda rows, q: (rows, np.eye(len(q), k=-step) @ q))


def summed(p, place):
    if place == "offsets too":
        return p.fits(lambda rows, q: (rows * [0, 1, 1, 1], np.cumsum(rows[:, 0] + q)))
    if "differences" in place:
        return p.fits(lambda rows, q: (rows, np.diff(q, prepend=0)))
    return p.fits(lambda rows, q: (rows, np.cumsum(q)))


def of_another_row(p, place):
    steps = (-1,) if "after" in place else (1,)

    def lent(rows, q, step, wrap):
        moved = np.roll(rows[:, 2:], step, axis=0)
        if not wrap:
            moved[0 if step > 0 else -1] = 0
        return np.column_stack([rows[:, :2], moved]), q

    return any(p.fits(lambda rows, q, s=s, w=w: lent(rows, q, s, w)) for s in steps for w in (0, 1))


def fewer(p, place):
    """Some of the links, in their order."""
    n = len(p.cases[0][1])
    kept = [[k for k in range(n) if bits >> k & 1] for bits in range(1, 2**n - 1)]
    return any(p.of_links(lambda links, ks=ks: [links[k] for k in ks]) for ks in kept)


def mistyped(p, place):
    """The named entries of the link, and no others."""
    parts = [part for part in place.replace(" and row", "; row").split("; ") if "row" in part]
    words = [part.split(":")[0].replace(",", "").split() for part in parts]
    places = {(int(word[1]) - 1, int(word[3]) - 1) for word in words}
    return p.is_chain or p.off == places


def not_rigid(p, place):
    R = p.given[:, :3, :3]
    return not np.allclose(R @ np.swapaxes(R, 1, 2), np.eye(3))


def in_some_quadrants(p, place):
    """Right where all angles are small and positive; the doctor was asked where it is wrong."""
    rows = np.array([[0.4, 0.3, 0.2, 0.5], [0.7, 0.1, 0.4, 0.6]])[: 2 if p.is_chain else 1]
    q = np.array([0.2, 0.1])[: len(rows)] * p.is_chain
    return np.allclose(p.call(rows, q), p.pose(rows, q))


def without_last_link(p, place):
    def kept(rows, q):
        rows[-1, 2:] = 0
        return rows, q

    return p.fits(kept)


def mirrored(p, place):
    """A column of every link has the other sign; or two entries of a turn."""
    for k in range(3):
        if p.of_links(lambda links, k=k: [T * np.where(np.arange(4) == k, [[-1]] * 3 + [[1]], 1)
                                          for T in links]):  # fmt: skip
            return True
    return False


def reversed_factors(p, place):
    if "positions" in place or "rotations" in place:
        turned = np.array([chain(p.links(*case)[::-1]) for case in p.cases])
        part = np.s_[:, :3, 3] if "positions" in place else np.s_[:, :3, :3]
        return np.allclose(p.given[part], turned[part])
    return p.of_links(lambda links: links[::-1]) or p.ordered("Rx", "Tx", "Tz", "Rz")


def exchanged(p, place):
    """In every order that makes these matrices a move stands before those it is said to, and in
    every right order behind them.
    """
    told = [
        (one, other)
        for part in place.split("; ")
        if " stands before " in part
        for one, others in [part.split(" stands before ")]
        for other in others.split(" and ")
    ]
    orders = list(permutations(STANDARD))
    made = [order for order in orders if p.ordered(*order)]
    right = [order for order in orders if np.allclose(link(ROW, order), link(ROW, p.order))]
    return not told or (
        bool(made)
        and all(order.index(one) < order.index(other) for order in made for one, other in told)
        and all(order.index(one) > order.index(other) for order in right for one, other in told)
    )


def unlike(part):
    return lambda p, place: not np.allclose(p.given[part], p.right[part])


def same_for_every_q(p, place):
    zero = [p.pose(rows, 0 * q) for rows, q in p.cases]
    return p.gives(zero)


CLAIMS = {
    "joint-values-unused": same_for_every_q,
    "theta-unused": lambda p, place: p.has(["theta"], lambda x: 0 * x),
    "degrees-in-sin-cos": scaled_angles(DEG),
    "converted-to-radians-twice": scaled_angles(1 / DEG),
    "alpha-in-degrees": lambda p, place: p.has(["alpha"], lambda x: x * DEG),
    "offset-in-degrees": lambda p, place: p.has(["theta"], lambda x: x * DEG, joined=False),
    "angle-factor": lambda p, place: p.has(
        angles(place.split(":")[0]), lambda x: x * (2 if "twice" in place else 0.5)
    ),
    "row-vector-convention": lambda p, place: p.has(
        ["theta"] if "about z" in place or place.startswith("theta turns") else ["theta", "alpha"],
        lambda x: -x,
    ),
    "one-number-for-another": used_for,
    "alpha-sign": lambda p, place: p.has(["alpha"], lambda x: -x),
    "length-sign": lambda p, place: p.has(lengths(place), lambda x: -x),
    # of a chain no number is named: "a negative length"
    "lengths-made-positive": lambda p, place: (
        p.has(lengths(place), abs) or ("a negative" in place and p.has(["d", "a"], abs))),
    "length-unit": lambda p, place: (
        p.rotation_right and any(p.has(lengths(place), lambda x, f=f: x * f) for f in (1e3, 1e-3))
    ),
    "a-d-exchanged": lambda p, place: p.fits(lambda rows, q: (rows[:, [0, 2, 1, 3]], q)),
    "theta-alpha-exchanged": lambda p, place: (
        p.fits(lambda rows, q: (rows[:, [3, 1, 2, 0]], q))
        or p.fits(lambda rows, q: ((rows + np.outer(q, [1, 0, 0, 0]))[:, [3, 1, 2, 0]], 0 * q))
    ),
    "columns-misread": columns,
    "pi-rounded": lost_digits,
    "integer-arrays": cut_off,
    "sign-lost": in_some_quadrants,
    "atan-for-atan2": in_some_quadrants,
    "sin-cos-exchanged": lambda p, place: (
        "everywhere" in place or p.has(named(place), lambda x: math.pi / 2 - x)
    ),
    "length-value": another_value,
    "alpha-value": another_value,
    "offset-value": another_value,
    "shift-not-turned-by-theta": lambda p, place: p.ordered("Tx", "Rz", "Tz", "Rx"),
    "alpha-before-d": lambda p, place: p.rotation_right and p.ordered("Rz", "Tx", "Rx", "Tz"),
    "standard-rows-in-craig-matrix": lambda p, place: (
        p.ordered("Rx", "Tx", "Rz", "Tz") and exchanged(p, place)),
    "craig-rows-in-standard-matrix": lambda p, place: p.ordered(*STANDARD),
    "order-taken-for-free": exchanged,
    "elementwise-product": not_rigid,
    "mirror": mirrored,
    "pose-inverted": unlike(np.s_[:, :3]),
    "rotation-transposed": unlike(np.s_[:, :3, :3]),
    "matrix-transposed": unlike(np.s_[:]),
    "last-row-missing": unlike(np.s_[:, 3]),
    "matrix-entry-mistyped": mistyped,
    "offset-missing": lambda p, place: p.fits(lambda rows, q: (rows * [0, 1, 1, 1], q)),
    "offset-sign": lambda p, place: p.fits(lambda rows, q: (rows * [-1, 1, 1, 1], q)),
    "offset-subtracted": lambda p, place: p.fits(lambda rows, q: (rows, -q)),
    "offset-counted-twice": lambda p, place: p.fits(lambda rows, q: (rows * [2, 1, 1, 1], q)),
    "all-joints-left-handed": lambda p, place: (
        p.fits(lambda rows, q: (rows, -q)) or p.has(["theta"], lambda x: -x)
    ),
    "joint-index-off-by-one": another_joint,
    "one-row-for-all-joints": lambda p, place: not p.gives(p.right),
    "joints-summed": summed,
    "a-alpha-from-previous-row": of_another_row,
    "product-reversed": reversed_factors,
    "translations-not-rotated": unlike(np.s_[:, :3, 3]),
    "product-from-zeros": lambda p, place: not p.given.any(),
    "product-stops-early": fewer,
    "product-starts-late": fewer,
    "last-link-by-half": without_last_link,
    "turn-about-y": lambda p, place: p.gives(
        [p.pose(rows, q, ["Ry" + named(place)[0] if MOVES[m] == named(place)[0] and m[0] == "R"
                          else m for m in p.order]) for rows, q in p.cases]
    ),
    "link-counted-twice": lambda p, place: any(
        p.of_links(lambda links, k=k: [*links[:k], links[k], *links[k:]])
        for k in range(len(p.cases[0][1]))
    ),
    "not-rigid": not_rigid,
}  # fmt: skip


def judged(verdict, f, family):
    """Whether what is said of a program is true of it; None where no predicate knows."""
    holds = CLAIMS.get(verdict.mistake)
    if holds is None:
        return None
    order = CRAIG if family == "craig_transform" else STANDARD
    place = verdict.place or verdict.headline  # own words name the number there
    return bool(holds(Program(f, family == "forward_kinematics", order), place))
