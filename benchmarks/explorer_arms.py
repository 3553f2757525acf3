"""Every arm of the library in the explorer: its poses against Python's, and where hands can take
its end.

Run ``python benchmarks/explorer_arms.py`` from the project's top folder; it needs Node. For each
arm, 50 joint values in both conventions are computed by the explorer's JavaScript and by Python;
then the end is led to 200 random places in ten steps each, starting where it was. A place counts
as reached within 1e-3 of the arm's size, and all joints must be within their limits.
``--places 20`` leads it to fewer.
"""

import argparse
import json
import subprocess
import tempfile
from pathlib import Path

import numpy as np

import dhlab as dh
from dhlab.view.explorer.content import arm_data
from dhlab.view.explorer.widget import MODULE

STEPS = 10
NO_PAGE = """globalThis.document = { readyState: "loading", addEventListener() {} };
globalThis.matchMedia = () => document;
"""
PROGRAM = """
import { readFileSync } from "node:fs";
const { forward, reach } = await import(process.argv[2]);
const place = (T) => [T[3], T[7], T[11]], answers = [];
for (const { arm, size, qs, places, both } of JSON.parse(readFileSync(process.argv[3]))) {
  const poses = both.map((one) => qs.map((q) => forward(one, q)));
  let q = qs[0], slowest = 0;
  const ends = places.map((to) => {
    const start = forward(arm, q), from = place(start);
    for (let step = 1; step <= STEPS; step++) {
      const target = start.slice(), before = performance.now();
      [3, 7, 11].forEach((j, k) => { target[j] = from[k] + ((to[k] - from[k]) * step) / STEPS; });
      q = reach(arm, q, target, size).q;
      slowest = Math.max(slowest, performance.now() - before);
    }
    return q;
  });
  answers.push({ poses, ends, slowest });
}
console.log(JSON.stringify(answers));
"""


def case(name, many, rng):
    """An arm, and what is asked of it."""
    arm = dh.load(name)
    free = np.where(arm.table.prismatic, 0.3, np.pi)
    pairs = [pair or (-f, f) for pair, f in zip(arm.limits or [None] * len(arm), free, strict=True)]
    low, high = np.array(pairs).T
    qs = rng.uniform(low, high, (50, len(arm)))
    both = [arm.to("standard"), arm.to("craig")]
    asked = {
        "arm": arm_data(arm),
        "size": float(np.ptp(arm.frames(np.zeros(len(arm)))[:, :3, 3], axis=0).max()),
        "qs": qs.tolist(),
        "places": arm.forward(rng.uniform(low, high, (many, len(arm))))[:, :3, 3].tolist(),
        "both": [arm_data(one) for one in both],
    }
    return arm, asked


def judged(arm, asked, answer):
    """The largest difference of poses, how many places were missed, joints outside their limits."""
    wanted = arm.forward(np.array(asked["qs"]))
    apart = np.abs(np.reshape(answer["poses"], (2, *wanted.shape)) - wanted).max()
    ends = np.array(answer["ends"])
    gaps = np.linalg.norm(arm.forward(ends)[:, :3, 3] - asked["places"], axis=1)
    pairs = [pair or (-np.inf, np.inf) for pair in arm.limits or [None] * len(arm)]
    low, high = np.array(pairs).T
    outside = int(((ends < low - 1e-12) | (ends > high + 1e-12)).sum())
    return apart, int((gaps > 1e-3 * asked["size"]).sum()), outside


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--places", type=int, default=200)
    many = parser.parse_args().places
    rng = np.random.default_rng(19)
    cases = [case(name, many, rng) for name in dh.robots()]
    with tempfile.TemporaryDirectory() as folder:
        program, numbers = Path(folder) / "program.mjs", Path(folder) / "cases.json"
        module = Path(folder) / "explorer.mjs"
        module.write_text(NO_PAGE + MODULE.read_text(encoding="utf-8"), encoding="utf-8")
        program.write_text(f"const STEPS = {STEPS};{PROGRAM}", encoding="utf-8")
        numbers.write_text(json.dumps([asked for _, asked in cases]), encoding="utf-8")
        command = ["node", program, module, numbers]
        answers = json.loads(subprocess.run(command, check=True, capture_output=True).stdout)
    found = [judged(*one, answer) for one, answer in zip(cases, answers, strict=True)]
    missed = {name: miss for name, (_, miss, _) in zip(dh.robots(), found, strict=True) if miss}
    total = many * len(cases)
    print(
        f"{len(cases)} arms, both conventions, 50 q each: {max(a for a, _, _ in found):.1e} apart"
    )
    print(
        f"the end led to {many} places each: {total - sum(missed.values())} of {total} reached,"
        f" missed {missed or 'none'}; {sum(out for _, _, out in found)} joints outside their limits"
    )
    slowest = max(answer["slowest"] for answer in answers)
    print(f"slowest single move of a hand: {slowest:.0f} ms")


if __name__ == "__main__":
    main()
