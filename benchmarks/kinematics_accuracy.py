"""How exact the fast paths are, and how much memory they take.

    python benchmarks/kinematics_accuracy.py            # a million poses a case: some minutes
    python benchmarks/kinematics_accuracy.py --quick    # ten thousand

Errors are in units of eps · reach for positions (eps = 2.2e-16, reach the sum of all lengths) and
of eps for rotations. "Plain" is the product of four elementary matrices in floating point, "exact"
the same in mpmath with 50 digits, from the same floating-point q and table. numba is measured where
it is installed.
"""

import argparse
import tracemalloc
from pathlib import Path

import mpmath
import numpy as np

import dhlab as dh
from dhlab.fast import compiled, many, one
from dhlab.fast.compiled import Compiled
from dhlab.fast.straight import straight

PAGES = Path(__file__).parents[1] / "docs" / "benchmarks"
EPS = np.finfo(float).eps
EXACT = 1000  # poses that are worked out with 50 digits


def random_arm(n, rng, scale=1.0, right_angles=False):
    """An arm of n turning joints; lengths up to ``scale``, twists at random or of 0 and ±90°."""
    alpha = rng.choice([0, 90, -90], n) if right_angles else rng.uniform(-180, 180, n)
    rows = np.column_stack(
        [rng.uniform(-180, 180, n), *(scale * rng.uniform(-1, 1, (2, n))), alpha]
    )
    convention = dh.DHTable.standard if rng.random() < 0.5 else dh.DHTable.craig
    return dh.Arm(convention(rows, angle="deg"))


def cases(count):
    """(name, arm, q): what might cost digits."""
    rng = np.random.default_rng(0)
    arm, turn = dh.load("article-6r"), np.pi
    shape = (count, 6)
    yield "q up to ±π", arm, rng.uniform(-turn, turn, shape)
    near = rng.choice([-turn, turn, turn / 2], shape)
    yield "θ within 1e-9 of ±180° and 90°", arm, near + rng.uniform(-1e-9, 1e-9, shape)
    yield "θ exactly ±180°, 90°", arm, near
    yield "q up to ±1e4", arm, rng.uniform(-1e4, 1e4, shape)
    for scale, name in ((1e-9, "a nanometre"), (1e6, "a thousand kilometres")):
        yield f"lengths of {name}", random_arm(6, rng, scale), rng.uniform(-turn, turn, shape)
    mixed = random_arm(6, rng).table.rows
    mixed[:, 1:3] *= 10.0 ** rng.integers(-9, 6, (6, 2))
    mixed_arm = dh.Arm(dh.DHTable.standard(mixed, angle="rad"))
    yield "lengths from 1e-9 to 1e5 m in one arm", mixed_arm, rng.uniform(-turn, turn, shape)
    for n in (1, 2, 3, 10, 30, 100):
        few = max(1000, count * 6 // n // (1 if n < 30 else 4))
        q = rng.uniform(-turn, turn, (min(few, count), n))
        yield f"{n} joints", random_arm(n, rng, right_angles=n == 100), q


def paths(arm):
    """{name: function of q (m, n) giving end poses}."""
    n, chain = len(arm), arm._kinematics.chain
    program = straight(one.forward, chain, (4, 4))
    plain = arm._kinematics.plain.forward
    machine = Compiled(chain, 0, (4, 4), fallback=None) if compiled.kernels() else None

    def one_of(row):
        answer = program(row)
        return plain(np.array(row)) if answer is None else answer

    def by(rows):
        def answer(q):
            out = np.empty((len(q), 4, 4))
            rows(chain, q, out)
            return out

        return answer

    found = {
        "plain": plain,
        "numpy": by(many.forward),
        "one pose": lambda q: np.array([one_of(row) for row in q.tolist()]),
    }
    if machine:
        found["numba"] = by(machine.rows)
        found["numba, one"] = lambda q: np.array([machine.take(row) for row in q])
    return found if n else {}


def exact_poses(arm, q):
    """End poses (m, 4, 4) with 50 digits, as mpmath matrices."""
    mpmath.mp.dps = 50
    rows = [[mpmath.mpf(float(x)) for x in row] for row in arm.table.rows]
    alphas = [(mpmath.cos(row[3]), mpmath.sin(row[3])) for row in rows]
    base, tool = mpmath.matrix(arm.base.tolist()), mpmath.matrix(arm.tool.tolist())
    for values in q:
        T = base
        for i, (theta, d, a, _) in enumerate(rows):
            angle = theta + mpmath.mpf(float(arm.sign[i])) * mpmath.mpf(float(values[i]))
            c, s = mpmath.cos(angle), mpmath.sin(angle)
            ca, sa = alphas[i]
            Z = mpmath.matrix([[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, d], [0, 0, 0, 1]])
            X = mpmath.matrix([[1, 0, 0, a], [0, ca, -sa, 0], [0, sa, ca, 0], [0, 0, 0, 1]])
            T = T * (Z * X if arm.table.convention == "standard" else X * Z)
        yield T * tool


def off(T, exact):
    """Largest error of poses (m, 4, 4) against mpmath's, rotations and positions."""
    R = p = 0.0
    for pose, right in zip(T, exact):
        for i in range(3):
            for j in range(4):
                error = abs(float(right[i, j] - mpmath.mpf(float(pose[i, j]))))
                R, p = (R, max(p, error)) if j == 3 else (max(R, error), p)
    return R, p


def line(name, arm, q):
    """A row of the table."""
    reach = max(np.abs(arm.table.rows[:, 1:3]).sum(), 1e-300)
    ways = paths(arm)
    few = q[:: max(1, len(q) // EXACT)][:EXACT]
    exact = list(exact_poses(arm, few if len(arm) < 30 else few[:100]))
    few = few[: len(exact)]
    cells = []
    for ask in ways.values():
        R, p = off(ask(few), exact)
        cells.append(f"{R / EPS:.2g} / {p / EPS / reach:.2g}")
    plain, found = ways["plain"], []
    for way in [w for w in ("numpy", "numba") if w in ways]:
        worst = np.zeros(2)
        for part in np.array_split(q, max(1, len(q) // 50_000)):
            gap = np.abs(ways[way](part) - plain(part))
            worst = np.maximum(worst, [gap[:, :3, :3].max(), gap[:, :3, 3].max() / reach])
        found.append(f"{worst[0] / EPS:.2g} / {worst[1] / EPS:.2g}")
    return f"| {name} | " + " | ".join([*cells, *found]) + " |", list(ways)


def memory():
    """Peak memory of a million poses beside q, as a multiple of the result."""
    found = {}
    q = np.random.default_rng(0).uniform(-3, 3, (1_000_000, 6))
    for question in ("forward", "frames", "jacobian"):
        arm = dh.load("article-6r")
        tracemalloc.start()  # numpy tells it of every array
        size = getattr(arm, question)(q).nbytes
        found[question] = tracemalloc.get_traced_memory()[1] / size
        tracemalloc.stop()
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument(
        "--quick", action="store_true", help="ten thousand poses a case, nothing written"
    )
    given = parser.parse_args()
    count = 10_000 if given.quick else 1_000_000
    lines, ways = [], []
    for case in cases(count):
        row, ways = line(*case)
        print(row, flush=True)
        lines.append(row)
    versus = [f"{way} against plain" for way in ("numpy", "numba") if way in ways]
    heads = ["largest error, rotation / position", *(f"{way} against exact" for way in ways)]
    head = "| " + " | ".join([*heads, *versus]) + " |\n|" + "---|" * (len(ways) + len(versus) + 1)
    peaks = ", ".join(f"{name} {value:.2f}" for name, value in memory().items())
    text = "\n".join([head, *lines, "", f"Peak memory of 1e6 poses over the result: {peaks}.", ""])
    print(text)
    text = f"{count:,} poses a case against the plain product, {EXACT:,} against mpmath.\n\n{text}"
    if not given.quick:
        PAGES.mkdir(exist_ok=True)
        (PAGES / "accuracy.md").write_text(text)


if __name__ == "__main__":
    main()
