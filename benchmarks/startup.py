"""What a beginning costs: processor time of whole Python processes, as a multiple of ``import
numpy``.

    python benchmarks/startup.py           # min of 15 runs each, interleaved; prints Markdown
    python benchmarks/startup.py --runs 3
"""

import argparse
import resource
import subprocess
import sys

LOAD = "import dhlab as dh; arm = dh.load('ur5e')"
POSES = f"""{LOAD}
import numpy as np
rows = arm.table.rows.copy()
rows[{{row}}, {{column}}] += {{change}}
right = dh.Arm(dh.DHTable.standard(rows, angle='rad'))
q = np.random.default_rng(1).uniform(-2, 2, (12, 6))
print(dh.diagnose(arm, q, right.forward(q)).verdict)"""
CASES = {
    "import numpy": "import numpy",
    "Python alone": "pass",
    "import dhlab": "import dhlab",
    "and its tables": "import dhlab; dhlab.DHTable",
    "first dh.load": LOAD,
    "first forward": f"{LOAD}; arm.forward([0] * 6)",
    "import scipy's rotations": "import scipy.spatial.transform",
    "first diagnose, a right table": POSES.format(row=0, column=0, change=0),
    "first diagnose, one wrong entry": POSES.format(row=2, column=3, change=0.3),
}


def processor_seconds(code):
    """User and system time of a whole Python process that runs ``code``."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([sys.executable, "-c", code], check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


def main():
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=15)
    runs = parser.parse_args().runs
    best = dict.fromkeys(CASES, float("inf"))
    for _ in range(runs):
        for name, code in CASES.items():
            best[name] = min(best[name], processor_seconds(code))
    print(f"Min of {runs} runs.\n\n| process | s of processor | × import numpy |\n|---|---|---|")
    for name, seconds in best.items():
        print(f"| {name} | {seconds:.3f} | {seconds / best['import numpy']:.2f} |")


if __name__ == "__main__":
    main()
