"""Every lesson in its page: with nothing filled in, with the solutions, and with wrong answers,
whose sentences must be those of a notebook's kernel.

    make site LIVE=1
    python benchmarks/lessons_in_page.py            # all lessons, five answers to each exercise
    python benchmarks/lessons_in_page.py 05 09 --wrong 20

A wrong answer is a solution in which one number, sign, name or letter is another, drawn from a
seed; some of them are right after all, and both sides have to say so. An exercise of which fewer
are different, such as a choice of three, has those. What they are told is compared letter by
letter. The kernel runs the same cells through nbclient. Exit 1 where anything differs.
"""

import io
import json
import re
import sys
import time
import tokenize

import nbformat
import numpy as np
from nbclient import NotebookClient
from serving import ROOT, arguments, chromium, served

CHECK = re.compile(r'^check\("([\w.]+)".*\)', re.MULTILINE)
RIGHT = re.compile("Right:|Noted:")  # lesson 00 notes what somebody knows before
OTHER = {"+": "-", "-": "+", "*": "+", "/": "*", "sin": "cos", "cos": "sin", "True": "False"}
OTHER |= {"X": "Y", "Y": "Z", "Z": "X", "a": "d", "d": "a", "alpha": "theta"}
NUMBERS = ("({} + 1)", "(-{})", "({} / 2)")
LETTERS = "abcd?"  # of a choice
TOLD = """
import json, linecache
told = []
for k, (code, asked) in enumerate({cases!r}):
    names, file = dict(globals()), f"<wrong {{k}}>"
    linecache.cache[file] = len(code), None, code.splitlines(True), file
    try:
        exec(compile(code, file, "exec"), names)
        told.append(str(eval(asked, names)))
    except Exception as error:
        told.append(f"{{type(error).__name__}}: {{error}}")
print(json.dumps(told))
"""
ENDED = "document.querySelectorAll('[data-live=ran], [data-live=failed]').length"
ALL = f"{ENDED} === document.querySelectorAll('.live-cell').length"


def code_cells(folder, lesson):
    notebook = nbformat.read(ROOT / folder / f"{lesson}.ipynb", as_version=4)
    return {one.id: one.source for one in notebook.cells if one.cell_type == "code"}


def another(token, rng):
    """What may stand in the place of a token; None where nothing is known."""
    word = token.string.strip("\"'")
    if token.type == tokenize.NUMBER:
        return str(rng.choice(NUMBERS)).format(word)
    if token.type == tokenize.STRING and word in LETTERS:
        return repr(str(rng.choice([one for one in LETTERS if one != word])))
    return token.string.replace(word, OTHER[word]) if word in OTHER else None


def changed(source, rng):
    """The source with one token between the marks of the solution another one; None where that
    leaves no program, or one that may not end.
    """
    lines = source.splitlines()
    marks = [k for k, line in enumerate(lines) if "SOLUTION" in line]
    if len(marks) != 2 or "while" in source:
        return None
    read = tokenize.generate_tokens(io.StringIO(source).readline)
    own = [one for one in read if marks[0] < one.start[0] - 1 < marks[1]]
    found = [(one, new) for one in own if (new := another(one, rng))]
    if not found:
        return None
    one, new = found[rng.integers(len(found))]
    row = one.start[0] - 1
    lines[row] = lines[row][: one.start[1]] + new + lines[row][one.end[1] :]
    text = "\n".join(lines)
    try:
        compile(text, "wrong", "exec")
    except SyntaxError:
        return None
    return text


def wrong_answers(cells, many):
    """[code of an answer, call of its check]: so many to each exercise, or as many as there are."""
    sources, rng = list(cells.values()), np.random.default_rng(19)
    checks = [(k, CHECK.search(one)) for k, one in enumerate(sources)]
    cases = []
    for answer, asked in [(sources[k - 1], found[0]) for k, found in checks if found and k]:
        drawn = dict.fromkeys(changed(answer, rng) for _ in range(20 * many))
        cases += [[text, asked] for text in list(drawn) if text][:many]
    return cases


def by_the_kernel(cells, program):
    """What a notebook's kernel says of the wrong answers, after the solution."""
    notebook = nbformat.v4.new_notebook()
    notebook.cells = [nbformat.v4.new_code_cell(one) for one in (*cells.values(), program)]
    NotebookClient(notebook, timeout=600, resources={"metadata": {"path": ROOT}}).execute()
    streams = [one["text"] for one in notebook.cells[-1].outputs if one.output_type == "stream"]
    return json.loads(streams[-1].splitlines()[-1])


class InPage:
    """A lesson's page, Python begun."""

    def __init__(self, browser, address, lesson):
        self.page = browser.new_page()
        self.page.set_default_timeout(600_000)
        self.wrong = []
        self.page.on("pageerror", lambda error: self.wrong.append(str(error)))
        self.page.on("request", lambda asked: self.asked(asked.url, address))
        self.page.goto(f"{address}/lessons/{lesson}.html")
        self.page.get_by_role("button", name="Run this lesson").click()

    def asked(self, url, address):
        if not url.startswith((address, "data:", "blob:")):
            self.wrong.append(f"asked for {url}")

    def run_all(self):
        self.page.get_by_role("button", name="Run all").click()
        self.page.wait_for_function(ALL)

    def fill(self, texts):
        """Other texts into all cells, and Python from its beginning."""
        for k, text in enumerate(texts):
            self.page.locator(".live-cell textarea").nth(k).fill(text)
        self.page.get_by_role("button", name="Restart").click()

    def texts(self):
        return self.page.locator("div.cell:has(.live-cell) .live-output").all_inner_texts()

    def failed(self):
        return self.page.locator("[data-live=failed]").count()


def lesson_in_page(browser, address, lesson, many):
    """A line of the table; how many things differ."""
    began, given, solved = time.perf_counter(), *(code_cells(f, lesson) for f in FOLDERS)
    checks = [k for k, one in enumerate(given.values()) if CHECK.search(one)]
    place = InPage(browser, address, lesson)
    place.run_all()
    empty = ["Not attempted yet" in place.texts()[k] for k in checks]
    program = TOLD.format(cases=wrong_answers(solved, many))
    place.fill(solved.values())
    place.run_all()
    right = [bool(RIGHT.search(place.texts()[k])) for k in checks]
    last = place.page.locator(".live-cell textarea").last
    last.fill(program)
    failed = place.failed()
    last.press("Control+Enter")
    place.page.wait_for_function(ALL)
    here = json.loads(place.texts()[-1].strip().splitlines()[-1])
    there = by_the_kernel(solved, program)
    differ = [(a, b) for a, b in zip(here, there, strict=True) if a != b]
    wrong = sum(one.startswith("✗") for one in there)
    print(
        f"| {lesson} | {sum(empty)} of {len(checks)} | {sum(right)} of {len(checks)} | {failed}"
        f" | {len(there)}, {wrong} wrong | {len(there) - len(differ)} | {len(place.wrong)}"
        f" | {time.perf_counter() - began:.0f} |"
    )
    for a, b in differ:
        print("    page:  ", a, "\n    kernel:", b)
    print(*[f"    {fault}\n" for fault in place.wrong], sep="", end="", flush=True)
    place.page.close()
    missed = 2 * len(checks) - sum(empty) - sum(right)
    return missed + failed + len(differ) + len(place.wrong)


FOLDERS = ("lessons", "solutions")


def main():
    """The command line."""
    parser = arguments(__doc__)
    parser.add_argument("lessons", nargs="*", help="such as 05; all where none")
    parser.add_argument("--wrong", type=int, default=5, help="wrong answers to an exercise")
    given = parser.parse_args()
    names = sorted(path.stem for path in (ROOT / "lessons").glob("[0-9]*.ipynb"))
    names = [one for one in names if not given.lessons or one.split("-")[0] in given.lessons]
    print(
        "| lesson | not attempted, untouched | right, solved | cells that failed | other answers |"
        " told the same | errors, outside requests | s |\n|---|---|---|---|---|---|---|---|"
    )
    with served(given.html) as address, chromium() as browser:
        faults = sum(lesson_in_page(browser, address, one, given.wrong) for one in names)
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
