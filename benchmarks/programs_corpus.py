"""How many wrong programs of a folder the doctor explains, how many right ones it leaves alone, and
how long it takes.

Run ``python benchmarks/programs_corpus.py FOLDER`` from the project's top folder. In the folder
stand programs NNN.py, each with NNN.yaml that says what is wrong with it (``kind``, ``mistakes``
with the ``line`` that must change, ``entry``, ``arm``), and beside or above it ``arms.yaml`` with
the tables. The corpus of the figures in docs/doctor.md was written by somebody who had not seen the
doctor, half of it kept until they were taken.

A mistake counts as told when the doctor tells its line, or tells lines whose change makes the
program right on the arm it is for, by a product of links that is not dhlab's; or when it names a
mistake of the catalogue that goes by its family. A sentence is false when a line is told and its
change does not make the program right.
"""

import importlib.util
import math
import sys
import time
from pathlib import Path

import numpy as np
from ruamel.yaml import YAML

import dhlab as dh

# the catalogue's names for what the corpus calls a family; "|" stands between equally good ones
NAMES = {
    "matrix-entry": "matrix-entry-mistyped",
    "matrix-sign": "matrix-entry-mistyped|mirror|alpha-sign|row-vector-convention",
    "transposed": "rotation-transposed|matrix-transposed|row-vector-convention",
    "multiplication-order": "product-reversed|order-taken-for-free",
    "joint-reversed": "joint-reversed",
    "joint-coupled": "joints-coupled|joints-summed",
    "degrees": "degrees-in-sin-cos|converted-to-radians-twice|alpha-in-degrees|offset-in-degrees",
    "half-angle": "angle-unit",
    "wrong-column": "columns-misread|a-d-exchanged|theta-alpha-exchanged",
    "index-one": "joint-index-off-by-one",
    "elementwise-product": "elementwise-product",
    "last-row-dropped": "product-stops-early",
    "craig": "standard-rows-in-craig-matrix",
    "rounding": "pi-rounded",
    "hardcoded-pi": "pi-rounded",
    "integer-array": "integer-arrays",
    "position-only": "pose-incomplete",
    "state-between-calls": "state-between-calls|inputs-changed",
    "mutable-default": "state-between-calls",
    "tool-missing": "tool-missing",
    "tool-side": "tool-on-wrong-side",
    "joint-offset-lost": "offset-missing",
    "joint-offset-double": "offset-counted-twice",
    "composed-apart": "translations-not-rotated|shift-not-turned-by-theta",
    "half-flip": "mirror|alpha-value|row-vector-convention",
    "early-return": "product-stops-early",
}
YAML_READER = YAML(typ="safe")


def reference(rows, q):
    """The product of the links, point by point, without dhlab."""
    p, x, y, z = np.zeros(3), *np.eye(3)
    for (theta, d, a, alpha), angle in zip(rows, q):
        c, s = math.cos(theta + angle), math.sin(theta + angle)
        x, y = c * x + s * y, c * y - s * x
        p = p + d * z + a * x
        y, z = math.cos(alpha) * y + math.sin(alpha) * z, math.cos(alpha) * z - math.sin(alpha) * y
    T = np.eye(4)
    T[:3] = np.column_stack([x, y, z, p])
    return T


def loaded(path):
    """The module that stands in a file, made anew."""
    spec = importlib.util.spec_from_file_location("learner", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def arm_of(truth, arms):
    """The arm that a program is for; base and tool where the program has to do with them."""
    given, entry = arms[truth["arm"]], truth["entry"]
    ends = {
        name: np.array(given[name], dtype=float)
        for name in ("base", "tool")
        if name in entry or name in entry["args"]
    }
    return dh.Arm(dh.DHTable.standard(given["dh"], angle="rad"), **ends)


def is_right(text, truth, arm):
    """Whether an edited program gives the reference's poses."""
    space, entry = {"__name__": "learner"}, truth["entry"]
    rng = np.random.default_rng(9)
    rows = [row.tolist() for row in arm.table.rows]
    try:
        exec(compile(text, "<edited>", "exec"), space)
        f = space[entry["function"]]
        for _ in range(8):
            q = rng.uniform(-3, 3, len(rows)).tolist()
            if entry["function"] == "dh_transform":
                given = [(f(r[0] + x, *r[1:]), reference([r], [x])) for r, x in zip(rows, q)]
            else:
                ends = [getattr(arm, n) for n in ("base", "tool") if n in entry["args"]]
                given = [(f(rows, q, *ends), arm.base @ reference(rows, q) @ arm.tool)]
            if not all(np.allclose(T, right, atol=1e-6) for T, right in given):
                return False
    except Exception:
        return False
    return True


def judged(path, arms):
    """The kind of a program; how many of its mistakes are told; whether a sentence is false; the
    seconds; the diagnosis.
    """
    truth = YAML_READER.load(path.with_suffix(".yaml").read_text())
    arm, entry = arm_of(truth, arms), truth["entry"]
    f = getattr(loaded(path), entry["function"])
    start = time.process_time()
    answer = dh.diagnose_function(f, entry["function"], arm=arm)
    seconds = time.process_time() - start
    if truth["kind"] == "right":
        return truth, int(bool(answer)), False, seconds, answer
    told = {line.number for line in answer.lines}
    found = {
        name for finding in answer.findings for name in (finding.mistake, *finding.look_alikes)
    }
    mended = bool(answer.repaired) and is_right(answer.repaired, truth, arm)
    count = sum(
        mended
        or not told.isdisjoint(mistake["line"])
        or not found.isdisjoint(NAMES.get(mistake["family"], mistake["family"]).split("|"))
        for mistake in truth["mistakes"]
    )
    return truth, count, bool(answer.lines) and not mended, seconds, answer


def main():
    folder = Path(sys.argv[1])
    arms = next(p for p in (folder / "arms.yaml", folder.parent / "arms.yaml") if p.exists())
    arms = YAML_READER.load(arms.read_text())
    counts, times, false = {"right": [], "single": [], "double": []}, [], 0
    for path in sorted(folder.glob("[0-9]*.py")):
        truth, count, untrue, seconds, answer = judged(path, arms)
        wanted = max(1, len(truth["mistakes"]))
        counts[truth["kind"]].append(count == wanted)
        times.append(seconds)
        false += untrue
        if count < wanted or untrue or seconds > 2:
            families = [mistake["family"] for mistake in truth["mistakes"]]
            print(f"{path.name} {truth['kind']} {families} {seconds:.1f} s", "FALSE" * untrue)
            print("  ", "\n   ".join(str(answer).splitlines()))
    for kind, done in counts.items():
        print(f"{kind}: {sum(done)} of {len(done)} ({100 * np.mean(done):.0f} %)")
    print(f"lines told whose change does not help: {false}")
    print(f"time: median {np.median(times):.2f} s, worst {max(times):.2f} s of the processor")


if __name__ == "__main__":
    main()
