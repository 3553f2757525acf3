"""Frames placed by a scripted hand: random exercises of lesson 04, in Chromium, by mouse; right
choices and wrong ones, clicked or dragged along their line; and the marks that ``dhlab grade``
gives for the notebooks saved after it.

Run ``python benchmarks/placing_by_mouse.py [STUDENTS [SEED]]`` from the project's top folder; each
student has three exercises with numbers of their own. It needs Chromium and the grader's cage.

The hand turns the view until its choice stands clear of the others, clicks it, and clicks it again
to place it. An origin it mostly takes where another choice stands and drags along its line: to the
choice, where it must snap, or to a place between the choices. Whether a choice was right is found here, from the lines alone, and a finished arm is
compared with the product of exponentials of its axes.
"""

import hashlib
import json
import shutil
import sys
import tempfile
from collections import Counter
from pathlib import Path

import nbformat
import numpy as np
from playwright.sync_api import sync_playwright

import dhlab as dh
from dhlab.course.celltext import written
from dhlab.course.exercises import exercises
from dhlab.grading.grade import grade
from dhlab.grading.handing_out.release import key_of, release
from dhlab.grading.handing_out.variants import variants
from dhlab.grading.intake.roster import Student
from dhlab.grading.settings import read_settings
from dhlab.view.explorer.widget import MODULE

sys.path[:0] = [str(Path(__file__).parents[1] / "tests" / name) for name in ("view", "")]
import oracles  # noqa: E402
from conftest import MODEL, PAGE, heard  # noqa: E402

KEYS = ("04.2", "04.4", "04.10")
FLAGS = ["--no-sandbox", "--disable-gpu", "--disable-background-networking"]
PATIENCE = 300  # looks, 10 ms apart
CLEAR, NEAR = 14.0, 1e-6  # page points to the next choice; metres and sines
WRONG = 0.3  # how often the hand takes any choice at all
ENDINGS = {"right": 0.6, "wrong": 0.25, "not attempted": 0.15}
DRAGGED = 0.7  # how often an origin that can be dragged is dragged
FREE = 0.2  # and how often to a place that nobody offered
# the explorer of the page on which frames are placed, and what it hands to Python
FOUND = """() => { window.placing = [...document.querySelectorAll('div')].findLast((div) => div.explorer?.host?.get('_answer')?.offers)?.explorer;
    if (!window.placing) return false;
    const { host } = window.placing, send = host.send.bind(host);
    window.sent = null;
    host.send = (message) => { window.sent = message; send(message); };
    return true; }"""
BOX = "() => { const { x, y } = placing.stage.canvas.getBoundingClientRect(); return [x, y]; }"
ANSWER = "() => placing.host.get('_answer')"
# where each choice is drawn, as lines of points on the page, nearest the tip first
SEEN = """() => { const { stage, host } = placing;
    const { next, offers, placed } = host.get('_answer'), { reach } = host.data;
    stage.canvas.scrollIntoView({ block: 'center' });
    const box = stage.canvas.getBoundingClientRect(), of = (step) => placed.find((one) => one.step === step)?.value;
    const add = (p, v, t) => p.map((x, k) => x + t * v[k]), size = (v) => Math.hypot(...v);
    return offers.map(({ value, point }) => {
        if (next[0] === 'o') return [stage.camera.flat(value)];
        const from = point ?? of('o' + next.slice(1)) ?? [0, 0, 0];
        const z = value.map((x) => x / size(value)), start = next[0] === 'z' ? add(from, value, 0.06 * reach) : from;
        return [1, 0.9, 0.8, 0.7, 0.6, 0.5, 0.4].map((t) => stage.camera.flat(add(start, z, 0.22 * reach * t)));
    }).map((points) => points.map(([x, y]) => [x + box.x, y + box.y])); }"""


class Lines:
    """The rules of lesson 04, from points and directions: what has been placed so far."""

    def __init__(self, axes, end):
        self.axes, self.end, self.z, self.o = axes, np.array(end, dtype=float), {}, {}

    def fits(self, step, value, point):
        """Whether a choice is right; None beside a sliding joint, which has no line."""
        letter, i, value = step[0], int(step[1:]), np.array(value)
        if self._slides(i) or self._slides(i - 1):
            return None
        if letter == "z":
            return self._on_its_axis(i, value, point)
        own, before = self.z[i], self.z.get(i - 1)
        if letter == "o":
            return _apart(value, own) < NEAR and (before is None or self._foot(value, own, before))
        x = value / np.linalg.norm(value)
        if abs(x @ own[1]) > NEAR:
            return False
        return before is None or self._crosses(x, self.o[i], own, before)

    def _slides(self, i):
        return 0 <= i < len(self.axes) and len(self.axes[i]) > 2 and self.axes[i][2] == "P"

    def _on_its_axis(self, i, z, point):
        if i == len(self.axes):
            return True  # any line will do
        p, along = map(np.array, self.axes[i][:2])
        along = along / np.linalg.norm(along)
        return bool(np.linalg.norm(np.cross(z, along)) < NEAR) and _apart(point, (p, along)) < NEAR

    def _foot(self, o, own, before):
        (q, z), (p, w) = own, before
        normal = np.cross(w, z)
        if np.linalg.norm(normal) < NEAR:
            return True
        # nearest to the other line among the points of this one
        M = np.column_stack([z, -w])
        s = np.linalg.lstsq(M, p - q, rcond=None)[0][0]
        return bool(np.linalg.norm(q + s * z - o) < NEAR)

    def _crosses(self, x, o, own, before):
        (_, z), (p, w) = own, before
        if abs(x @ w) > NEAR:
            return False
        if np.linalg.norm(np.cross(z, w)) > NEAR or _apart(o, before) < NEAR:
            return True
        across = p + w * ((o - p) @ w) - o
        return bool(np.linalg.norm(np.cross(x, across)) < NEAR)

    def along(self, step):
        """The line along which an origin can be dragged, (point, direction); None where it has
        none yet.
        """
        i = int(step[1:])
        known = step[0] == "o" and i in self.z and i < len(self.axes) and not self._slides(i)
        return self.z[i] if known else None

    def keep(self, step, value, point):
        i, value = int(step[1:]), np.array(value)
        if step[0] == "z":
            self.z[i] = (np.array(point), value / np.linalg.norm(value))
        elif step[0] == "o":
            self.o[i] = value


def _apart(point, line):
    p, z = line
    return float(np.linalg.norm(np.cross(np.array(point) - p, z)))


def _on(line, offers):
    """Which offers lie on a line."""
    return [j for j, one in enumerate(offers) if _apart(one["value"], line) < NEAR]


class Hand:
    """A mouse on one page, and what happened under it."""

    def __init__(self, page, rng):
        self.page, self.rng, self.count = page, rng, Counter()
        self.refused = []  # (step, value) of the wrong choices
        self.known = set()  # (step, number) of these
        page.wait_for_function(FOUND)

    @property
    def answer(self):
        """What Python said last."""
        return self.page.evaluate(ANSWER)

    def place(self, lines, stop=None):
        """Go on until every frame is placed, or for so many right steps."""
        done = 0
        while (step := (answer := self.answer).get("next")) and done != stop:
            offers = answer["offers"]
            fitting = [lines.fits(step, one["value"], one.get("point")) for one in offers]
            order = [k for k in self.rng.permutation(len(offers)) if (step, k) not in self.known]
            if self.rng.random() > WRONG:
                order.sort(key=lambda k: fitting[k] is not True)
            told = self.make(int(order[0]), answer, lines)
            sent, right = self.page.evaluate("() => window.sent"), told["said"]["right"]
            value, point = sent["value"], sent.get("point")
            fits = lines.fits(step, value, point)
            if fits is not None:
                self.count["judged as they should" if right == fits else "misjudged"] += 1
                self.count["right choices" if fits else "wrong choices"] += 1
            if right:
                lines.keep(step, value, point or [0, 0, 0])
                done += 1
                continue
            self.refused.append((step, value))
            same = [one["value"] == value and one.get("point") == point for one in offers]
            self.known |= {(step, j) for j, equal in enumerate(same) if equal}

    def make(self, k, answer, lines):
        """Choice k by a drag or by clicks; what Python said of it."""
        step, offers = answer["next"], answer["offers"]
        line = lines.along(step)
        along = [] if line is None else _on(line, offers)
        if k in along and len(along) > 1 and self.rng.random() < DRAGGED:
            told = self.drag(k, answer, along)
            if told:
                return told
        told = self.click(k, answer)
        sent = self.page.evaluate("() => window.sent")
        same = sent["value"] == offers[k]["value"] and sent.get("point") == offers[k].get("point")
        self.count["choices hit" if same else "choices missed"] += 1
        return told

    def drag(self, k, answer, on):
        """Take another choice on the line of z, drag it to choice k or to a place between them, and
        place it by a click; None where no other stands clear.
        """
        offers = answer["offers"]
        free = self.rng.random() < FREE
        for _ in range(4):
            seen = np.array([ats[0] for ats in self.page.evaluate(SEEN)])
            gaps = np.hypot(*(seen[:, None] - seen).transpose(2, 0, 1)) + 99 * np.eye(len(seen))
            clear = [j for j in on if gaps[j].min() > CLEAR]
            others = [j for j in clear if j != k]
            if others and k in clear:
                break
            self.turn()
        else:
            return None
        j = int(self.rng.choice(others))
        target = (seen[j] + seen[k]) / 2 if free else seen[k]
        if free and np.hypot(*(seen - target).T).min() < CLEAR:
            free, target = False, seen[k]
        self.press(seen[j])
        self.press(seen[j], target)
        self.press(target)
        told = self.judged(answer["turn"])
        if told is None:
            self.count["drags that placed nothing"] += 1
            return None
        value = self.page.evaluate("() => window.sent")["value"]
        if free:
            self.count["drags to a free place"] += 1
        else:
            snapped = value == offers[k]["value"]
            self.count["drags that snapped" if snapped else "drags that missed"] += 1
        return told

    def press(self, at, to=None):
        """A click, or a drag to a place."""
        self.page.mouse.move(*at)
        self.page.mouse.down()
        if to is not None:
            self.page.mouse.move(*to, steps=2)
        self.page.mouse.up()

    def click(self, k, answer):
        """Turn the view until choice k stands clear, click it twice; what Python said."""
        for _ in range(12):
            seen = self.page.evaluate(SEEN)
            others = np.array([at for j, ats in enumerate(seen) if j != k for at in ats])
            gaps = [np.hypot(*(others - at).T).min() if len(others) else 99.0 for at in seen[k]]
            if max(gaps) > CLEAR:
                break
            self.turn()
        else:
            self.count["no clear view, by its letter"] += 1
            return self.by_letter(k, answer)
        for _ in range(2):
            self.press(seen[k][int(np.argmax(gaps))])
        told = self.judged(answer["turn"])
        if told is None:
            self.count["clicks that hit nothing"] += 1
            return self.by_letter(k, answer)
        return told

    def by_letter(self, k, answer):
        view = self.page.locator(".explorer:has(.submit)").last
        view.locator(".offers input").nth(k).check(force=True)
        view.get_by_role("button", name="Place it").click()
        return self.judged(answer["turn"])

    def judged(self, before):
        """The answer once Python has judged; None where nothing was handed to it."""
        for _ in range(PATIENCE):
            told = self.answer
            if told["turn"] != before:
                return told
            self.page.wait_for_timeout(10)
        return None

    def turn(self):
        """Drag beside the arm: a corner of the canvas."""
        box = self.page.evaluate(BOX)
        at = np.array(box[:2]) + 25
        self.press(at, at + self.rng.uniform([60, -30], [260, 60]))


class Page:
    """One page on which one explorer after the other is alive, Python at the other end."""

    def __init__(self, browser):
        self.page = browser.new_page(viewport={"width": 800, "height": 640})
        self.page.goto("about:blank")
        module = MODULE.read_text(encoding="utf-8")
        names = dict(
            pair.split(" as ")[::-1]
            for pair in module[module.rindex("export{") + 7 : module.rindex("}")].split(",")
        )
        module += "".join(
            f"\nconst {name} = {names[own]};"
            for name, own in [("widget", "default")]
            + [(name, name) for name in ("forward", "frames", "jacobian", "reach")]
        )
        self.page.expose_function(
            "toPython", lambda kind, name, value: heard(self.explorer, kind, name, value)
        )
        self.page.set_content(PAGE.format("", module))
        self.page.wait_for_function("window.dhlab")

    def show(self, explorer):
        """Another explorer in the place of the last one."""
        self.explorer = explorer
        self.page.evaluate("document.querySelector('main').replaceChildren()")
        state = ["_data", "q", "row", "poses", "convention", "step", "_answer"]
        self.page.evaluate(MODEL, explorer.get_state(state))
        self.page.wait_for_function(
            "document.querySelector('main > div')?.explorer?.stage.drawn > 0"
        )


def one(shown, key, variant, rng, count):
    """An exercise by hand: what it should be marked, and the rows that go into the notebook."""
    given = exercises()[key].given(variant)
    explorer = dh.explore(given["axes"], mode="place", end=given["end"])
    shown.show(explorer)
    wanted = str(rng.choice([*ENDINGS], p=[*ENDINGS.values()]))
    hand = Hand(shown.page, rng)
    stop = int(rng.integers(1, 3 * len(given["axes"]))) if wanted == "not attempted" else None
    hand.place(Lines(given["axes"], given["end"]), stop)
    count.update(hand.count)
    rows = explorer.placing.placement.placed
    if explorer.arm is not None:
        q = rng.uniform(-1, 1, (3, len(given["axes"])))
        expected = [exponentials(given, values) for values in q]
        same = np.allclose(explorer.arm.forward(q), expected, atol=1e-4)
        count["finished arms that are the arm" if same else "finished arms that are another"] += 1
    if wanted == "wrong":
        spoilt = [with_step(rows, step, value) for step, value in hand.refused]
        spoilt = [one for one in spoilt if breaks_a_rule(given, one)]
        if not spoilt:
            return "right", rows
        rows = spoilt[int(rng.integers(len(spoilt)))]
    return wanted, rows


def with_step(rows, step, value):
    """Finished rows, one step of them another."""
    rows = [list(row) for row in rows]
    rows[int(step[1:])]["zox".index(step[0])] = list(value)
    return rows


def breaks_a_rule(given, rows):
    """Whether finished rows are wrong as a notebook holds them: of a line it keeps the direction.
    Where no joint fixes it, at the end and on a sliding joint, it goes through the origin: an
    origin refused beside the line that a hand had chosen may be right on one that is parallel to
    it.
    """
    axes, lines = given["axes"], Lines(given["axes"], given["end"])
    for i, row in enumerate(rows):
        fixed = i < len(axes) and len(axes[i]) == 2
        point = axes[i][0] if fixed else row[1]
        for step, value in zip((f"z{i}", f"o{i}", f"x{i}"), row):
            if lines.fits(step, value, point) is False:
                return True
            lines.keep(step, value, point)
    return False


def exponentials(given, q):
    """The end from the axes alone."""
    T = np.eye(4)
    for (point, along, *kind), value in zip(given["axes"], q):
        p, z = np.array(point, dtype=float), np.array(along, dtype=float) / np.linalg.norm(along)
        if kind == ["P"]:
            T = T @ oracles.shift(value * z)
        else:
            T = T @ oracles.shift(p) @ oracles.turn(value * z) @ oracles.shift(-p)
    return T @ np.array(given["end"], dtype=float)


def save(path, target, answers):
    """The lesson handed out, with the rows written where the dots were, as the course writes."""
    notebook = nbformat.read(path, as_version=4)
    for cell in notebook.cells:
        rows = answers.get(cell.metadata.get("exercise"))
        if cell.cell_type == "code" and rows is not None:
            cell.source = f"frames = {as_text(rows)}"
    target.parent.mkdir(parents=True, exist_ok=True)
    nbformat.write(notebook, target)


def as_text(rows):
    """Rows as the course writes what hands placed."""
    dots = "[" + ", ".join("[..., ..., ...]" for _ in rows) + "]"
    plain = [[v if v is ... else [float(x) for x in v] for v in row] for row in rows]
    return written(f"frames = {dots}", "frames", plain).removeprefix("frames = ")


def graded(folder, everybody, key, answers):
    """{(student, exercise): status} of the saved notebooks."""
    folder = Path(folder)
    (folder / "course.yaml").write_text('lessons:\n  "04": {}\n', encoding="utf-8")
    settings = read_settings(folder / "course.yaml")
    release(folder / "out", everybody, key, tuple(settings.lessons))
    for student in everybody:
        for path in sorted((folder / "out" / student.student).glob("04-*.ipynb")):
            save(path, folder / "in" / student.student / path.name, answers[student.student])
    results, _ = grade(
        folder / "in", folder / "graded", roster=everybody, key=key, settings=settings, jobs=2
    )
    for one in results:
        if one.status != "graded":
            print(one.student, one.status, *one.notes)
    return {(one.student, mark.exercise): mark.status for one in results for mark in one.marks}


def main(students, seed=17):
    """Print what was judged, and how the grader agrees."""
    rng, count, wanted, answers = np.random.default_rng(seed), Counter(), {}, {}
    everybody = [Student(f"s{seed}-{k:03}") for k in range(students)]
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        Path(folder, "teacher.key").write_text(hashlib.sha256(b"placing").hexdigest() + "\n")
        key, _ = key_of(Path(folder, "teacher.key"), Path(folder, "out"))
        numbers = variants(key, [one.student for one in everybody])
        browser = playwright.chromium.launch(executable_path=shutil.which("chromium"), args=FLAGS)
        shown = Page(browser)
        for name in numbers:
            print(name, end=" ", file=sys.stderr, flush=True)
            answers[name] = {}
            for exercise in KEYS:
                wanted[name, exercise], answers[name][exercise] = one(
                    shown, exercise, numbers[name], rng, count
                )
        browser.close()
        said = {
            (name, exercise): exercises()[exercise].judge(rows, numbers[name]).status
            for name, own in answers.items()
            for exercise, rows in own.items()
        }
        print(f"{len(wanted)} exercises by mouse: {json.dumps(dict(count), indent=2)}")
        print("should be:", dict(Counter(wanted.values())), flush=True)
        marks = graded(folder, everybody, key, answers)
    compare(wanted, {"check": said, "dhlab grade": marks})


def compare(wanted, found):
    """Print how many marks are what they should be, and those that are not."""
    for name, marks in found.items():
        same = sum(marks[pair] == status for pair, status in wanted.items())
        print(f"{name}: {same} of {len(wanted)} marked as they should")
        for pair, status in wanted.items():
            if marks[pair] != status:
                print("  ", *pair, "should be", status, "but is", marks[pair])


if __name__ == "__main__":
    main(*map(int, sys.argv[1:] or ["67"]))
