"""Lessons 01 and 04 in their page by keys alone: Tab and Shift with Tab go to what is meant,
arrows, Space and Enter use it, as somebody without a mouse does.

    make site LIVE=1
    python benchmarks/by_keys.py

A prediction, an order, a choice and a matching are done on their cards, the frames of 04.2 on the
board of bare axes, and each is written into its cell by running it again and then checked; in the
explorer of 01 a joint is moved and the view turned. No mouse event is sent, and nothing is focused
but by Tab. It prints for each how many keys were pressed; exit 1 where something was not reached or
was not right.
"""

import re
import sys

import nbformat
import numpy as np
from placing_by_mouse import Lines
from serving import ROOT, arguments, chromium, served

from dhlab.course.exercises import exercises

# what has the focus, through every shadow root
FOCUS = """() => {
    let at = document.activeElement;
    while (at?.shadowRoot?.activeElement) at = at.shadowRoot.activeElement;
    const outside = (one) => one.getRootNode().host;
    const place = (one) => one && (one.closest("div.cell") ?? place(outside(one)));
    const text = (at.ariaLabel ?? at.innerText ?? "").trim();
    return { tag: at.tagName, kind: at.type ?? "", text, value: at.value ?? "",
        cell: cells.indexOf(place(at)) }; }"""
MOUSE = """() => {
    window.mouse = 0;
    window.cells = [...document.querySelectorAll("div.cell:has(> .cell_input)")];
    for (const kind of ["mousedown", "pointerdown", "touchstart"])
        addEventListener(kind, () => window.mouse++, true); }"""
RAN = "(k) => ['ran', 'failed'].includes(cells[k].dataset.live)"
MOST = 400  # presses of Tab until something is not in reach


class Keys:
    """A keyboard on a lesson's page."""

    def __init__(self, browser, address, lesson):
        self.pressed = 0
        self.page = browser.new_page(viewport={"width": 1280, "height": 900})
        self.page.set_default_timeout(240_000)
        self.page.goto(f"{address}/lessons/{lesson}.html", wait_until="networkidle")
        self.page.evaluate(MOUSE)
        self.given, self.solved = (code(folder, lesson) for folder in ("lessons", "solutions"))
        self.at = -1
        self.to(lambda one: one["text"] == "Run this lesson")
        self.press("Enter")
        self.page.locator(".live-cell textarea").first.wait_for()

    def press(self, *keys):
        for key in keys:
            self.page.keyboard.press(key)
        self.pressed += len(keys)

    @property
    def focus(self):
        return self.page.evaluate(FOCUS)

    def to(self, meant, key="Tab"):
        """Tab, or Shift and Tab, until what is meant has the focus."""
        for _ in range(MOST):
            now = self.focus
            if meant(now):
                return now
            if now["tag"] == "TEXTAREA":  # where Tab indents
                self.press("Escape")
            self.press(key)
        raise SystemExit(f"not in reach of {key}; the focus ended at {now}")

    def cell(self, number):
        """The focus into a cell's text."""
        key = "Shift+Tab" if self.focus["cell"] >= number else "Tab"
        self.to(lambda one: one["tag"] == "TEXTAREA" and one["cell"] == number, key)

    def run(self, number):
        """Run a cell; what is under it then."""
        self.cell(number)
        self.press("Control+Enter")
        self.page.wait_for_function(RAN, arg=number)
        return self.page.locator("div.cell:has(> .cell_input)").nth(number)

    def until(self, number):
        """Run the cells before one."""
        for k in range(self.at + 1, number):
            self.run(k)
        self.at = number

    def number(self, text):
        """Of the first cell with a text in it."""
        return next(k for k, one in enumerate(self.given) if text in one)

    def cards(self, exercise, told="Right"):
        """The letters of the solution, on their cards; the answer written and checked."""
        number = self.number(f'("{exercise}",')  # its check, or its prediction
        answer = number if "predict" in self.given[number] else number - 1
        self.until(number)
        self.run(number)
        letters = re.findall(r'"(\w)"', own(self.solved[answer]))
        self.to(lambda one: one["cell"] == number and one["tag"] in ("INPUT", "BUTTON"))
        for letter in letters if len(letters) > 1 else ():
            key = "Tab" if self.focus["text"].partition("\n")[0] < letter else "Shift+Tab"
            self.to(lambda one, x=letter: re.match(rf"{x}\s", one["text"]), key)
            self.press("Enter")
        if len(letters) == 1:
            self.press("Space")
            while self.focus["value"] != letters[0]:
                self.press("ArrowDown")
        self.written(answer, number, told)

    def written(self, answer, number, told):
        """What hands chose into its cell, and the check."""
        self.page.get_by_text("is not in the notebook yet").last.wait_for()
        self.run(answer)
        self.run(number).get_by_text(told).first.wait_for()

    def board(self, exercise):
        """The frames of an exercise on bare axes."""
        number = self.number(f'("{exercise}",')  # its check, or its prediction
        self.until(number)
        self.run(number)
        task = exercises()[exercise].given(0)
        lines = Lines(task["axes"], task["end"])
        self.page.wait_for_function(PLACING)
        points = [axis[0] for axis in task["axes"]] + [np.array(task["end"])[:3, 3]]
        for one in self.page.evaluate(PLACING)["placed"]:  # what stands there already
            lines.keep(one["step"], one["value"], points[int(one["step"][1:])])
        while (answer := self.page.evaluate(PLACING))["next"]:
            step, offers = answer["next"], answer["offers"]
            fits = [lines.fits(step, one["value"], one.get("point")) for one in offers]
            wanted = offers[fits.index(True)]
            self.to(lambda one: one["kind"] == "radio" and one["cell"] == number)
            self.press("Space", *["ArrowDown"] * fits.index(True))
            self.to(lambda one: one["text"] == "Place it")
            self.press("Enter")
            judged = f"(before) => ({PLACING})().turn !== before"
            self.page.wait_for_function(judged, arg=answer["turn"])
            if not self.page.evaluate(PLACING)["said"]["right"]:
                raise SystemExit(f"{exercise}, {step}: placed as the lines say, and not right")
            lines.keep(step, wanted["value"], wanted.get("point") or [0, 0, 0])
        self.written(number - 1, number, "Right")

    def explorer(self, text):
        """Joint 2 by arrows, joint 3 by its number, the view turned."""
        number = self.number(text)
        self.until(number)
        self.run(number)
        self.page.wait_for_function(f"{VIEW}?.stage.drawn > 0")
        before, turned = self.page.evaluate(STATE)
        self.to(lambda one: one["cell"] == number and one["tag"] == "CANVAS")
        self.press("ArrowLeft", "ArrowUp", "+")
        self.to(lambda one: one["text"].startswith("Joint 2, degrees") and one["kind"] == "range")
        self.press(*["ArrowRight"] * 4)
        self.to(lambda one: one["text"] == "Joint 3, degrees, exactly")
        self.press("Control+a", *"12.5", "Enter")
        after, now = self.page.evaluate(STATE)
        moved = np.rad2deg(np.subtract(after, before))
        if np.round(moved[1], 6) != 2 or np.round(np.rad2deg(after[2]), 6) != 12.5 or now == turned:
            raise SystemExit(f"the explorer by keys moved {moved}, and the view {turned} to {now}")


# the view in the last cell that shows one, and the board among them
VIEW = "[...document.querySelectorAll('div.cell div')].findLast((one) => one.explorer)?.explorer"
STATE = f"() => [{VIEW}.host.get('q'), {VIEW}.stage.camera.azimuth]"
PLACING = """() => [...document.querySelectorAll('div.cell div')]
    .map((one) => one.explorer?.host.get('_answer')).findLast((answer) => answer?.offers)"""


def own(source):
    return source.partition("BEGIN SOLUTION")[2].partition("### END")[0]


def code(folder, lesson):
    notebook = nbformat.read(ROOT / folder / f"{lesson}.ipynb", as_version=4)
    return [one.source for one in notebook.cells if one.cell_type == "code"]


def main():
    """The command line."""
    given = arguments(__doc__).parse_args()
    print("| done by keys alone | keys | mouse events |\n|---|---|---|")
    with served(given.html) as address, chromium() as browser:
        one = Keys(browser, address, "01-frames")
        line(one, "01.P1, a prediction", lambda: one.cards("01.P1", "Noted"))
        line(one, "the explorer", lambda: one.explorer("dh.explore(arm, q=cup_pose)"))
        line(one, "01.5, an order", lambda: one.cards("01.5"))
        line(one, "01.6, a choice", lambda: one.cards("01.6"))
        one = Keys(browser, address, "04-placing-frames")
        line(one, "04.1, a matching", lambda: one.cards("04.1"))
        line(one, "04.2, frames on bare axes", lambda: one.board("04.2"))


def line(keys, what, done):
    before = keys.pressed
    done()
    mouse = keys.page.evaluate("window.mouse")
    print(f"| {what} | {keys.pressed - before} | {mouse} |", flush=True)
    if mouse:
        sys.exit(1)


if __name__ == "__main__":
    main()
