"""How many forms of pasted tables are read right: ``python benchmarks/pasted.py [FOLDER]``.

The folder holds ``NN.txt`` with what somebody pastes and ``NN.yaml`` with the truth:
``convention``, ``rows`` (theta_offset, d, a, alpha in radians and metres, joint, sign),
``must_ask`` what the text leaves open, ``may_ask`` what may be asked, ``accept`` other right
readings, ``kind`` or ``form`` what it is in words. Poses are compared, at random joint values,
with a product that shares nothing with dhlab.

A second form of truth is read too: rows of ``theta``, ``d``, ``a``, ``alpha`` and ``joint`` (R, P,
fixed), ``signs``, ``unknown`` what the text leaves open, and a ``note`` that says where taking the
obvious is as right as asking.

right: one reading, and it is the truth; or, where the text leaves something open, it is asked,
with the truth among the readings. needless: asked though the text says it. wrong: one reading that
is not the truth, or nothing asked where something had to be. unread: a sentence instead of a table.
"""

import argparse
import collections
import pathlib
import re
import time

import numpy as np
import yaml

import dhlab as dh

NUMBERS = "theta_offset", "d", "a", "alpha"
TOLERANCE = 1e-4  # of the arm's size: the truth of a few forms is written with rounded angles
ASKS = {
    "convention": "For which matrix",
    "column order": "In which order",
    "length units": "In which unit",
    "angle units": "degrees or radians",
    "rows": "without a joint",
    "zeros": "added to the joints' values",
}


def link(convention, theta, d, a, alpha):
    """The 4×4 matrix of a row, multiplied out of elementary moves."""

    def turn(angle, i, j):
        T = np.eye(4)
        T[[i, i, j, j], [i, j, i, j]] = np.cos(angle), -np.sin(angle), np.sin(angle), np.cos(angle)
        return T

    def move(length, i):
        T = np.eye(4)
        T[i, 3] = length
        return T

    along_z, along_x = turn(theta, 0, 1) @ move(d, 2), move(a, 0) @ turn(alpha, 1, 2)
    return along_z @ along_x if convention == "standard" else along_x @ along_z


def poses(truth, q):
    """The end poses of a table of the corpus at joint values (m, n)."""
    for values in q:
        T, values = np.eye(4), iter(values)
        for row in truth["rows"]:
            theta, d = row["theta_offset"], row["d"]
            if row["joint"] != "fixed":
                step = row["sign"] * next(values)
                theta, d = (theta, d + step) if row["joint"] == "prismatic" else (theta + step, d)
            T = T @ link(truth["convention"], theta, d, row["a"], row["alpha"])
        yield T


def truths(case):
    """Every table that is right: the truth and what is accepted beside it, in both conventions
    where either will do.
    """
    for one in (case, *(case.get("accept") or ())):
        if any(row[name] is None for row in one["rows"] for name in NUMBERS):
            continue
        both = one["convention"] not in ("standard", "craig")
        for convention in ("standard", "craig") if both else (one["convention"],):
            yield {"rows": one["rows"], "convention": convention}


def is_truth(arm, case):
    """Whether an arm's poses are those of a right table."""
    q = np.random.default_rng(5).uniform(-1.5, 1.5, (6, len(arm)))
    found = arm.forward(q)
    for truth in truths(case):
        letters = "".join(
            "P" if r["joint"] == "prismatic" else "R"
            for r in truth["rows"]
            if r["joint"] != "fixed"
        )
        if letters != arm.table.joints:
            continue
        right = np.array(list(poses(truth, q)))
        size = max(1.0, *(abs(row[k]) for row in truth["rows"] for k in ("d", "a")))
        if case.get("any_tool"):
            left = np.linalg.solve(right, found)
            right = right @ left[0]
        if np.abs(found - right).max() < TOLERANCE * size:
            return True
    return False


COLUMNS = "theta", "d", "a", "alpha"
KINDS = {"R": "revolute", "P": "prismatic", "fixed": "fixed"}
WAIVED = {  # what of a note makes taking as right as asking
    "convention": r"(?:standard|craig|convention)[^.]*(?:right|acceptable)",
    "length units": r"(?:metres?|mm|length)[^.]*(?:obvious|right|plainly|may be taken)"
    r"|plainly (?:metres|mm)",
}
SCALES = 1e-3, 1e-2, 0.0254, 1.0


def in_one_form(case):
    """The second form of truth as the first."""
    if "unknown" not in case:
        return case
    signs = case.get("signs") or [1] * len(case["rows"])
    rows = [
        {"theta_offset": row["theta"], "d": row["d"], "a": row["a"], "alpha": row["alpha"],
         "joint": KINDS[row["joint"]], "sign": sign}
        for row, sign in zip(case["rows"], signs)
        if all(isinstance(row[name], int | float) for name in COLUMNS)  # letters have no values
    ]  # fmt: skip
    left = [{"length": "length units", "order": "column order"}.get(w, w) for w in case["unknown"]]
    note = case.get("note") or ""
    may = [what for what in left if what in WAIVED and re.search(WAIVED[what], note, re.IGNORECASE)]
    scales = SCALES if "length units" in left else (1.0,)
    accept = [
        {"convention": case["convention"],
         "rows": [{**row, "d": row["d"] * s, "a": row["a"] * s} for row in rows]}
        for s in scales
        if len(rows) == len(signs)
    ]  # fmt: skip
    return {
        "form": case["kind"], "convention": case["convention"], "rows": rows, "accept": accept,
        "must_ask": [what for what in left if what not in may], "may_ask": may,
        "any_tool": "either is right" in note,
    }  # fmt: skip


def judged(text, case):
    """(verdict, what was said)."""
    must, may = case.get("must_ask") or [], case.get("may_ask") or []
    try:
        answer = dh.recognise_table(text)
    except ValueError as error:
        asked = must and "?" in str(error)
        return ("right" if asked else "unread"), str(error)
    hit = any(is_truth(reading.arm, case) for reading in answer.readings)
    if not hit:
        return "wrong", str(answer)
    if len(answer.readings) == 1:
        return ("wrong" if must else "right"), str(answer)
    missing = [
        what for what in must if what in ASKS and ASKS[what] not in " ".join(answer.questions)
    ]
    if missing:
        return "wrong", f"does not ask for {missing}: {answer}"
    return ("right" if must or may else "needless"), str(answer)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folder", nargs="?", default="benchmarks/pasted", type=pathlib.Path)
    parser.add_argument("--show", action="store_true", help="what was said of each")
    options = parser.parse_args()
    counts, worst = collections.Counter(), 0.0
    for path in sorted(options.folder.glob("*.yaml")):
        case = in_one_form(yaml.safe_load(path.read_text(encoding="utf-8")))
        text = path.with_suffix(".txt").read_text(encoding="utf-8")
        start = time.process_time()
        verdict, said = judged(text, case)
        worst = max(worst, time.process_time() - start)
        counts[verdict] += 1
        if verdict != "right" or options.show:
            print(f"{path.stem} {case.get('form') or case.get('kind')}: {verdict}: {said}\n")
    n = sum(counts.values())
    print(f"{n} texts, {counts['right'] / max(n, 1):.0%} read right")
    print(", ".join(f"{counts[name]} {name}" for name in ("right", "needless", "wrong", "unread")))
    print(f"the slowest took {worst:.2f} s")


if __name__ == "__main__":
    main()
