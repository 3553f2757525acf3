"""Generated C: how many operations a pose and a Jacobian take, and how long, beside ``arm.forward``
and ``arm.jacobian``. ``python benchmarks/generated.py`` prints Markdown.

Needs gcc. With SymPy, its common subexpressions of the same formulas are counted beside ours. Times
are ratios of one run: each is the least of several rounds, in which all take turns.
"""

import argparse
import ctypes
import platform
import subprocess
import tempfile
import time
from pathlib import Path

import numpy as np

import dhlab as dh
from dhlab.generating.formulas import forward_formulas, jacobian_formulas

POSES, ALONE = 1000, 50
LOOPS = """
void many_forward(const double *q, double *T, int m)
{{
    int i;
    for (i = 0; i < m; i++)
        {name}_forward(q + {n} * i, T + 16 * i);
}}

void many_jacobian(const double *q, double *J, int m)
{{
    int i;
    for (i = 0; i < m; i++)
        {name}_jacobian(q + {n} * i, J + 6 * {n} * i);
}}
"""
TEXTBOOK = """
#include <math.h>
#include <string.h>

static const double start[16] = {{{base}}}, end[16] = {{{tool}}};
static const double rows[{n}][4] = {{{rows}}}, sign[{n}] = {{{sign}}};
static const int slides[{n}] = {{{slides}}};

static void times(double *T, const double *A)
{{
    double found[16] = {{0}};
    int i, j, k;
    for (i = 0; i < 4; i++)
        for (j = 0; j < 4; j++)
            for (k = 0; k < 4; k++)
                found[4 * i + j] += T[4 * i + k] * A[4 * k + j];
    memcpy(T, found, sizeof found);
}}

void textbook_forward(const double *q, double *T)
{{
    int i;
    memcpy(T, start, sizeof start);
    for (i = 0; i < {n}; i++) {{
        const double theta = rows[i][0] + (slides[i] ? 0 : sign[i] * q[i]);
        const double d = rows[i][1] + (slides[i] ? sign[i] * q[i] : 0), a = rows[i][2];
        const double ct = cos(theta), st = sin(theta), ca = cos(rows[i][3]), sa = sin(rows[i][3]);
        const double standard[16] = {{ct, -st * ca, st * sa, a * ct, st, ct * ca, -ct * sa, a * st,
                                      0, sa, ca, d, 0, 0, 0, 1}};
        const double craig[16] = {{ct, -st, 0, a, st * ca, ct * ca, -sa, -d * sa,
                                   st * sa, ct * sa, ca, d * ca, 0, 0, 0, 1}};
        times(T, {convention});
    }}
    times(T, end);
}}

void many_textbook(const double *q, double *T, int m)
{{
    int i;
    for (i = 0; i < m; i++)
        textbook_forward(q + {n} * i, T + 16 * i);
}}
"""


class Compiled:
    """The generated functions of an arm and the textbook's, in loops over many q."""

    def __init__(self, arm, folder):
        self.n = len(arm)
        source, library = folder / "arm.c", folder / f"{len(list(folder.iterdir()))}.so"
        loops = LOOPS.format(name="arm", n=self.n)
        source.write_text(dh.generate(arm, "c", name="arm") + loops + textbook(arm))
        subprocess.run(
            ["gcc", "-std=c99", "-O2", "-shared", "-fPIC", source, "-lm", "-o", library], check=True
        )
        self.library = ctypes.CDLL(str(library))

    def many(self, what, q, out):
        """Fill ``out`` for every row of ``q``; ``what`` is forward, jacobian or textbook."""
        pointer = ctypes.POINTER(ctypes.c_double)
        call = getattr(self.library, f"many_{what}")
        call(q.ctypes.data_as(pointer), out.ctypes.data_as(pointer), len(q))
        return out


def textbook(arm):
    """Link by link, with 4 x 4 products in loops, as a first program has it."""

    def listed(values):
        return ", ".join(map(repr, np.asarray(values, dtype=float).ravel().tolist()))

    return TEXTBOOK.format(
        n=len(arm),
        base=listed(arm.base),
        tool=listed(arm.tool),
        rows=", ".join(f"{{{listed(row)}}}" for row in arm.table.rows),
        sign=listed(arm.sign),
        slides=", ".join(str(int(slides)) for slides in arm.table.prismatic),
        convention=arm.table.convention,
    )


def operations():
    """A table of counts: multiplications + additions, sines and cosines."""
    print("| arm | pose | pose, SymPy | pose, 4 x 4 | Jacobian | Jacobian, SymPy |")
    print("|---|---|---|---|---|---|")
    for name in dh.robots():
        arm = dh.load(name)
        ours = [forward_formulas(arm).count, jacobian_formulas(arm).count]
        forward, jacobian = (" + ".join(map(str, count.values())) for count in ours)
        pose, velocity = sympy_counts(arm)
        products = (
            len(arm) - 1 + sum(not np.array_equal(T, np.eye(4)) for T in (arm.base, arm.tool))
        )
        plain = f"{64 * products + 6 * len(arm)} + {48 * products} + {4 * len(arm)}"
        print(f"| {name} | {forward} | {pose} | {plain} | {jacobian} | {velocity} |")


def sympy_counts(arm):
    """The same of ``sympy.cse`` over the product of ``dhlab.symbolic``; its derivatives and the
    axes for the Jacobian.
    """
    try:
        import sympy
    except ImportError:
        return "", ""
    T = dh.symbolic.product(arm)
    ways = [dh.symbolic.derivative(T[:3, 3], i + 1) for i in range(len(arm))]
    axes = [axis(arm, i) for i, letter in enumerate(arm.table.joints) if letter == "R"]
    velocity = [entry for column in ways + axes for entry in column]
    return counted(sympy, T[:3, :]), counted(sympy, sympy.Matrix(velocity))


def axis(arm, i):
    """The z of joint i (from 0) as formulas: the last column of a shorter arm's rotation."""
    joints = i + 1 if arm.table.convention == "craig" else i
    if joints == 0:
        return list(arm.base[:3, 2])
    columns = [getattr(arm.table, name)[:joints] for name in ("theta", "d", "a", "alpha")]
    table = dh.DHTable(arm.table.convention, *columns, arm.table.joints[:joints])
    return list(dh.symbolic.product(dh.Arm(table, base=arm.base, sign=arm.sign[:joints]))[:3, 2])


def counted(sympy, matrix):
    """multiplications + additions + sines and cosines of a matrix after ``cse``."""
    replaced, reduced = sympy.cse(list(matrix.evalf(17)))
    count = {"times": 0, "plus": 0, "functions": 0}
    for part in [formula for _, formula in replaced] + reduced:
        for node in sympy.preorder_traversal(part):
            if node.is_Mul:
                count["times"] += sum(factor != -1 for factor in node.args) - 1
            elif node.is_Pow:
                count["times"] += 1
            elif node.is_Add:
                count["plus"] += len(node.args) - 1
            elif node.func in (sympy.cos, sympy.sin):
                count["functions"] += 1
    return " + ".join(map(str, count.values()))


def times(rounds, folder):
    """A table of ratios, and the largest difference from ``arm.forward`` and ``arm.jacobian``."""
    print(
        "| arm | C, textbook | dhlab, batch | dhlab, alone | J: dhlab, batch | J: alone | error |"
    )
    print("|---|---|---|---|---|---|---|")
    for name in dh.robots():
        arm = dh.load(name)
        made, q = Compiled(arm, folder), np.random.default_rng(0).uniform(-3, 3, (POSES, len(arm)))
        T, U, J = np.empty((POSES, 4, 4)), np.empty((POSES, 4, 4)), np.empty((POSES, 6, len(arm)))
        tasks = {
            "C": lambda made=made, q=q, T=T: made.many("forward", q, T),
            "textbook": lambda made=made, q=q, U=U: made.many("textbook", q, U),
            "batch": lambda arm=arm, q=q: arm.forward(q),
            "alone": lambda arm=arm, q=q: [arm.forward(row) for row in q[:ALONE]],
            "J": lambda made=made, q=q, J=J: made.many("jacobian", q, J),
            "J batch": lambda arm=arm, q=q: arm.jacobian(q),
            "J alone": lambda arm=arm, q=q: [arm.jacobian(row) for row in q[:ALONE]],
        }
        took = least(tasks, rounds)
        assert abs(T - U).max() < 1e-12
        error = max(abs(T - arm.forward(q)).max(), abs(J - arm.jacobian(q)).max())
        pose = [took["textbook"], took["batch"], POSES / ALONE * took["alone"]]
        velocity = [took["J batch"], POSES / ALONE * took["J alone"]]
        ratios = [value / took["C"] for value in pose] + [value / took["J"] for value in velocity]
        print(f"| {name} | {' | '.join(f'{ratio:.3g}' for ratio in ratios)} | {error:.1e} |")


def least(tasks, rounds):
    """The least time of each task, in turns."""
    took = dict.fromkeys(tasks, np.inf)
    for _ in range(rounds):
        for name, task in tasks.items():
            start = time.perf_counter()
            task()
            took[name] = min(took[name], time.perf_counter() - start)
    return took


def main():
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n\n")[0])
    parser.add_argument("--rounds", type=int, default=25, help="of timing")
    chosen = parser.parse_args()
    gcc = subprocess.run(["gcc", "--version"], capture_output=True, text=True, check=True).stdout
    print(f"# Generated C ({gcc.splitlines()[0]}, -O2; Python {platform.python_version()})\n")
    print("## Operations: multiplications + additions + sines and cosines\n")
    operations()
    print("\n## Time of a pose or a Jacobian, as multiples of the generated C's\n")
    with tempfile.TemporaryDirectory() as folder:
        times(chosen.rounds, Path(folder))


if __name__ == "__main__":
    main()
