"""From a browser that knows nothing: seconds and megabytes until Python in the page has answered.

    make site LIVE=1
    python benchmarks/first_answers.py

Each line begins with a new browser on a page that is open; the clock starts with the first press. A
second visit opens the page once more in the same browser. Processor-bound: what a machine that is
doing other things takes is no measure of one that is not. Bytes are those of the files that were
sent, uncompressed where a host would compress them.
"""

import tempfile
import time

import nbformat
from serving import ROOT, Quiet, arguments, chromium, served

LESSON = "05-link-matrix"
BEGIN = "import numpy as np\nimport dhlab as dh\nfrom dhlab import view\n"
POSE = BEGIN + 'dh.load("ur5e").forward([0.1] * 6)'
PICTURE = BEGIN + 'view.arm(dh.load("ur5e"))'
CHECK = BEGIN + "from dhlab.course import check\n{answer}\ncheck('05.1', rot_x)"
POSES = """q1,q2,q3,q4,q5,q6,x,y,z
20,-60,80,-110,-80,20,-588.19,-374.34,298.33
50,-100,60,-40,70,120,-91.03,-368.86,908.00
-70,-80,120,30,-60,10,-257.92,173.29,375.90
110,-30,-70,140,20,-90,302.81,-168.56,662.97
-20,-120,100,60,-110,45,-52.98,-86.32,648.49
75,-45,35,-85,140,-30,-146.95,-768.66,603.59
"""


def right(exercise):
    """The solution's code of an exercise."""
    notebook = nbformat.read(ROOT / "solutions" / f"{LESSON}.ipynb", as_version=4)
    return next(c.source for c in notebook.cells if c.metadata.get("exercise") == exercise)


def in_a_lesson(source, seen):
    """What runs ``source`` in the first cell of a lesson, until ``seen`` is there."""

    def asked(page):
        page.get_by_role("button", name="Run this lesson").click()
        area = page.locator(".live-cell textarea").first
        area.fill(source)
        area.press("Control+Enter")
        page.locator(f".live-output {seen}").first.wait_for()

    return f"lessons/{LESSON}", asked


def at_the_bench(page):
    """What asks the doctor about a table whose first alpha has lost its sign."""
    page.locator("textarea").first.fill(table())
    page.locator('input[value="diagnose"]').check(force=True)
    page.get_by_label("Measured poses").fill(POSES)
    page.get_by_role("button", name="Answer").click()
    page.get_by_role("heading", name="The doctor says").wait_for()


def table():
    import dhlab as dh

    arm = dh.load("ur5e")
    rows = arm.table.rows
    rows[0, 3] *= -1
    head = "convention: standard\nunits: {length: m, angle: rad}\njoints:\n"
    return head + "\n".join(
        f"  - {{theta: {t}, d: {d}, a: {a}, alpha: {alpha}}}" for t, d, a, alpha in rows.tolist()
    )


WANTED = {
    "first pose": in_a_lesson(POSE, "pre"),
    "first check": in_a_lesson(CHECK.format(answer=right("05.1")), "[role=status]"),
    "first picture": in_a_lesson(PICTURE, "figure img"),
    "first doctor's answer": ("bench/index", at_the_bench),
}


def timed(context, address, name, asked):
    """Seconds from the first press, and bytes sent since the page was asked for."""
    page = context.new_page()
    page.set_default_timeout(600_000)
    before = Quiet.sent
    page.goto(f"{address}/{name}.html", wait_until="networkidle")
    began = time.perf_counter()
    asked(page)
    seconds = time.perf_counter() - began
    page.close()
    return seconds, (Quiet.sent - before) / 1e6


def main():
    """The command line."""
    given = arguments(__doc__).parse_args()
    print("| until | s | MB | second visit: s | MB |\n|---|---|---|---|---|")
    with served(given.html) as address:
        for words, (name, asked) in WANTED.items():
            with tempfile.TemporaryDirectory() as profile, chromium(profile) as context:
                cold = timed(context, address, name, asked)
                again = timed(context, address, name, asked)
            print("|", words, *(f"| {value:.1f}" for value in (*cold, *again)), "|", flush=True)


if __name__ == "__main__":
    main()
