"""Lesson 04 in JupyterLite by hand to its end: guesses and answers chosen by their cards, frames
placed on bare axes by mouse, all answers checked, in the JupyterLab that the site carries.

    make site LIVE=1
    python benchmarks/lab_by_hand.py [--shots FOLDER]

A card or a view comes under the cell; what hands chose there is written into the answer's cell by
running it again, and then checked. Exercise 04.7, where a wrong line of code is mended, is typed.
The letters of the cards are the solution's; which choice in a view is right is found here, from the
lines alone. It prints the marks that the lesson shows at its end, and ends with an error where
JupyterLab does not show what it should.
"""

import re
import time
from pathlib import Path

import nbformat
import numpy as np
from placing_by_mouse import Hand, Lines
from serving import ROOT, Quiet, arguments, chromium, served

from dhlab.course.exercises import exercises

LESSON = "04-placing-frames"
GUESSES, CARDS, PLACED, TYPED = (
    ("04.P1", "04.P3"),
    ("04.1", "04.3"),
    ("04.2", "04.4", "04.10"),
    "04.7",
)


def sources(folder):
    """The code cells of the lesson, in their order."""
    notebook = nbformat.read(ROOT / folder / f"{LESSON}.ipynb", as_version=4)
    return [one.source for one in notebook.cells if one.cell_type == "code"]


class Lab:
    """The lesson in JupyterLab: its code cells by their place in the notebook."""

    def __init__(self, page):
        self.page, self.given, self.solved = page, sources("lessons"), sources("solutions")

    def at(self, text):
        """The number of the first code cell with a text in it."""
        return next(k for k, source in enumerate(self.given) if text in source)

    def cell(self, number):
        return self.page.locator(".jp-Notebook .jp-CodeCell").nth(number)

    def run(self, number):
        """Run one cell, wait until it has run, and return it."""
        cell = self.cell(number)
        cell.locator(".cm-content").first.click()
        before = cell.locator(".jp-InputPrompt").first.inner_text()
        self.page.keyboard.press("Control+Enter")
        for _ in range(1200):
            now = cell.locator(".jp-InputPrompt").first.inner_text()
            if now != before and now.strip("[]: ").isdigit():
                return cell
            self.page.wait_for_timeout(100)
        raise SystemExit(f"expected a cell to end, found {now!r} after {before!r}")

    def write(self, number, text):
        """Type a cell's text anew."""
        self.cell(number).locator(".cm-content").first.click()
        self.page.keyboard.press("Control+a")
        self.page.keyboard.insert_text(text)

    def letters(self, number):
        """The letters that the solution of a cell chooses."""
        own = self.solved[number].partition("BEGIN SOLUTION")[2].partition("### END")[0]
        return re.findall(r'"(\w)"', own)


def main():
    """The command line."""
    parser = arguments(__doc__)
    parser.add_argument("--shots", type=Path, help="a folder for pictures of what is seen")
    given = parser.parse_args()
    with served(given.html) as address, chromium() as browser:
        page = browser.new_page(viewport={"width": 1280, "height": 1000})
        page.set_default_timeout(120_000)
        began = time.perf_counter()
        page.goto(f"{address}/lab/lab/index.html?path={LESSON}.ipynb")
        by_hand(Lab(page), began, given.shots)


def by_hand(lab, began, shots):
    """Everything that is done, and what it gives, in the order of the lesson."""
    lab.page.get_by_text("from dhlab.course import").first.wait_for()
    lab.page.wait_for_function(
        f"document.querySelectorAll('.jp-CodeCell').length === {len(lab.given)}"
    )
    lab.run(0)
    print(f"first cell: {time.perf_counter() - began:.0f} s, {Quiet.sent / 1e6:.0f} MB", flush=True)
    for number in range(1, len(lab.given)):
        asked = re.search(r'(check|predict)\("([\w.]+)"', lab.given[number])
        if not asked:
            lab.run(number)
        elif asked[2] in GUESSES:
            by_cards(lab, number, number, "Noted")
        elif asked[2] in CARDS:
            by_cards(lab, number, number - 1, "Right")
        elif asked[2] in PLACED:
            by_view(lab, number, asked[2])
        elif asked[2] == TYPED:
            lab.write(number - 1, lab.solved[number - 1])
            lab.run(number - 1)
            expect(lab.run(number), "Right")
        if asked:
            print(f"{asked[2]}: done, {time.perf_counter() - began:.0f} s", flush=True)
            picture(lab, shots, f"lab-{asked[2]}")
    print("the lesson says at its end:")
    print(lab.cell(len(lab.given) - 1).locator(".jp-OutputArea").inner_text())
    picture(lab, shots, "lab-end")


def by_cards(lab, number, answer, told):
    """Choose the cards under a cell, and let them be written into the answer's cell."""
    cell = lab.run(number)
    cards = cell.locator(".cards")
    cards.first.wait_for()
    for letter in lab.letters(answer):
        cards.locator(".card").filter(has=lab.page.locator(f".letter:text-is('{letter}')")).click()
    cell.get_by_text("is not in the notebook yet").wait_for()
    lab.run(answer)
    expect(cell if number == answer else lab.run(number), told)


def by_view(lab, number, exercise):
    """Place the frames in the view under a check."""
    lab.run(number)
    task = exercises()[exercise].given(0)
    hand = Hand(lab.page, np.random.default_rng(4))
    hand.place(Lines(task["axes"], task["end"]))
    lab.run(number - 1)
    expect(lab.run(number), "Right")
    print(f"{exercise} placed by hand, written and right:", dict(hand.count))


def expect(cell, *texts):
    for text in texts:
        cell.get_by_text(text).first.wait_for()


def picture(lab, shots, name):
    if shots:
        lab.page.screenshot(path=shots / f"{name}.png")


if __name__ == "__main__":
    main()
