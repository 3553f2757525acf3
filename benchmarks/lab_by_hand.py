"""Lesson 04 in JupyterLite by hand: a card clicked, frames placed on bare axes by mouse, and the
answers checked, in the JupyterLab that the site carries.

    make site LIVE=1
    python benchmarks/lab_by_hand.py [--shots FOLDER]

A guess is chosen by its card and written by running its cell again; the three frames of exercise
04.2 are placed by clicks and drags in the view, written into their cell in the same way, and then
checked. Which choice is right is found here, from the lines alone. It ends with an error where
JupyterLab does not show what it should.
"""

import time
from pathlib import Path

import numpy as np
from placing_by_mouse import Hand, Lines
from serving import Quiet, arguments, chromium, served

from dhlab.course.exercises import exercises

LESSON = "04-placing-frames"
GUESS, FRAMES = "04.P1", "04.2"


class Lab:
    """The lesson in JupyterLab: its cells by what stands in them."""

    def __init__(self, page):
        self.page = page

    def cell(self, text):
        """The first code cell with a text in it."""
        return self.page.locator(".jp-Notebook .jp-CodeCell").filter(has_text=text).first

    def run(self, cell):
        """Run one cell and wait until it has run."""
        cell.locator(".cm-content").first.click()
        before = cell.locator(".jp-InputPrompt").first.inner_text()
        self.page.keyboard.press("Control+Enter")
        for _ in range(1200):
            now = cell.locator(".jp-InputPrompt").first.inner_text()
            if now != before and now.strip("[]: ").isdigit():
                return
            self.page.wait_for_timeout(100)
        raise SystemExit(f"expected a cell to end, found {now!r} after {before!r}")


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
    """Everything that is done, and what it gives."""
    lab.cell("from dhlab.course import").wait_for()
    cells = lab.page.locator(".jp-Notebook .jp-CodeCell")
    lab.run(lab.cell("from dhlab.course import"))
    seconds, size = time.perf_counter() - began, Quiet.sent / 1e6
    print(f"first cell: {seconds:.0f} s, {size:.0f} MB")

    guess = lab.cell(f'predict("{GUESS}"')
    lab.run(guess)
    guess.locator(".cards label").first.click()
    guess.get_by_text("is not in the notebook yet").wait_for()
    picture(lab, shots, "lab-card")
    lab.run(guess)
    expect(guess, 'guess = "', "Noted")
    print("a card clicked, and written into its cell")

    lab.run(lab.cell(f'task = given("{FRAMES}")'))
    check, answer = lab.cell(f'check("{FRAMES}"'), cells.filter(has_text="frame 2, on the tool")
    lab.run(answer.first)
    lab.run(check)
    task = exercises()[FRAMES].given(0)
    hand = Hand(lab.page, np.random.default_rng(4))
    hand.place(Lines(task["axes"], task["end"]))
    picture(lab, shots, "lab-frames")
    lab.run(answer.first)
    lab.run(check)
    expect(check, "Right")
    picture(lab, shots, "lab-checked")
    print(f"{FRAMES} placed by hand, written and right:", dict(hand.count))


def expect(cell, *texts):
    for text in texts:
        cell.get_by_text(text).first.wait_for()


def picture(lab, shots, name):
    if shots:
        lab.page.screenshot(path=shots / f"{name}.png")


if __name__ == "__main__":
    main()
