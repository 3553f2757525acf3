"""A lesson that runs in its page: by hand, in Chromium, from the files that the site serves."""

import csv
import importlib.util
import json
import re
import shutil
import threading
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import nbformat
import numpy as np
import pytest
from typer.testing import CliRunner

import dhlab as dh
from dhlab.cli.app import app

ROOT = Path(__file__).parents[2]
LESSON = "05-link-matrix"
RAN = '[data-live="ran"]'


def gathered():
    """The module docs/live/gather.py, by its file: beside it stands another anywidget."""
    spec = importlib.util.spec_from_file_location("gather", ROOT / "docs" / "live" / "gather.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def address(site, tmp_path_factory):
    """Where the site with its Python is served."""
    folder = tmp_path_factory.mktemp("live") / "html"
    shutil.copytree(site, folder)
    gathered().into(folder)
    handler = type("Quiet", (SimpleHTTPRequestHandler,), {"log_message": lambda *_: None})
    with ThreadingHTTPServer(("127.0.0.1", 0), partial(handler, directory=folder)) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}"
        server.shutdown()


@pytest.fixture
def lesson(address, new_page):
    """The page, begun; what it asked for elsewhere and what went wrong in it must be nothing."""
    page = new_page(accept_downloads=True)
    wrong = []
    page.on("request", lambda r: r.url.startswith((address, "blob:")) or wrong.append(r.url))
    page.on("pageerror", lambda error: wrong.append(str(error)))
    page.goto(f"{address}/lessons/{LESSON}.html")
    yield page
    assert wrong == []


def code(folder):
    """The code of a notebook of the lesson: {id of the cell: text}."""
    notebook = nbformat.read(ROOT / folder / f"{LESSON}.ipynb", as_version=4)
    return {one.id: one.source for one in notebook.cells if one.cell_type == "code"}


def cell(page, name):
    """The place of one code cell of the lesson, by its id."""
    return page.locator("div.cell:has(.live-cell)").nth(list(code("lessons")).index(name))


def run(place):
    place.locator("textarea").press("Shift+Enter")
    place.and_(place.page.locator('[data-live="ran"], [data-live="failed"]')).wait_for()


def cells_of(exercise):
    """The ids of the cell for an answer, and of its check."""
    sources = code("lessons")
    ids = list(sources)
    at = next(i for i, one in enumerate(ids) if f'check("{exercise}"' in sources[one])
    return ids[at - 1], ids[at]


def test_a_lesson_runs_in_its_page_and_leaves_as_a_notebook(lesson, tmp_path):
    answer, check = cells_of("05.2")
    lesson.click("text=Run this lesson")
    run(cell(lesson, "05-001"))
    run(cell(lesson, answer))
    run(cell(lesson, check))
    cards = cell(lesson, check).locator(".cards label")
    cell(lesson, check).get_by_text("Not attempted yet").wait_for()
    cards.first.click()  # by hand; then the answer's own cell takes it over
    cell(lesson, check).get_by_text("is not in the notebook yet").wait_for()
    run(cell(lesson, answer))
    assert "..." not in cell(lesson, answer).locator("textarea").input_value()

    solution = code("solutions")[answer]
    cell(lesson, answer).locator("textarea").fill(solution)
    run(cell(lesson, answer))
    run(cell(lesson, check))
    cell(lesson, check).get_by_text("Right").wait_for()

    cell(lesson, answer).locator("textarea").fill("while True: pass")
    cell(lesson, answer).locator("textarea").press("Control+Enter")
    lesson.click("text=Stop")  # the page answers while a cell does not end
    lesson.get_by_text("Python begins anew").wait_for()
    cell(lesson, answer).locator("textarea").fill(solution)

    lesson.click("text=My work")
    with lesson.expect_download() as saved:
        lesson.click("text=Save as a notebook")
    saved.value.save_as(tmp_path / "mine.ipynb")
    mine = nbformat.read(tmp_path / "mine.ipynb", as_version=4)
    nbformat.validate(mine)
    given = nbformat.read(ROOT / "lessons" / f"{LESSON}.ipynb", as_version=4)
    assert [one.id for one in mine.cells] == [one.id for one in given.cells]
    changed = [a.id for a, b in zip(mine.cells, given.cells) if a.source != b.source]
    assert changed == [answer]
    assert mine.metadata == given.metadata

    lesson.reload()  # the work has stayed
    lesson.click("text=Run this lesson")
    assert cell(lesson, answer).locator("textarea").input_value() == solution


def test_work_on_an_older_lesson_stays_beside_the_new_one(lesson):
    answer, _ = cells_of("05.2")
    old = {"handedOut": {answer: "an older text"}, "mine": {answer: "mine"}}
    lesson.evaluate(
        "work => localStorage.setItem('dhlab:work:05-link-matrix', work)", json.dumps(old)
    )
    lesson.click("text=Run this lesson")
    lesson.get_by_text("This cell has changed since you wrote in it").wait_for()
    assert cell(lesson, answer).locator("textarea").input_value() == code("lessons")[answer]


# of five answers, which are the solution's, and what stands in the others
RIGHT = ("05.1", "05.5", "05.6")
WRONG = {
    "05.3": 'order = ["c", "d", "a", "b"]',
    "05.4": "def dh_transform(theta, d, a, alpha):\n"
    "    return rot_z(theta) @ trans_z(d) @ trans_x(a) @ rot_x(-alpha)",
}


@pytest.mark.cage
def test_the_notebook_that_leaves_the_page_gets_the_marks_that_the_page_showed(lesson, tmp_path):
    lesson.click("text=Run this lesson")
    solutions = code("solutions")
    answers = {cells_of(exercise)[0]: solutions[cells_of(exercise)[0]] for exercise in RIGHT}
    answers |= {cells_of(exercise)[0]: text for exercise, text in WRONG.items()}
    for name, source in answers.items():
        cell(lesson, name).locator("textarea").fill(source)
    lesson.click("text=Run all")
    places = [cell(lesson, name) for name in code("lessons")]
    for place in places:
        place.and_(lesson.locator('[data-live="ran"], [data-live="failed"]')).wait_for()
    rows = places[-1].locator("tbody tr").all()
    table = [row.locator("td").all_inner_texts() for row in rows]
    shown = {name: points.split(" of ") for name, _, _, points in table}
    assert {name for name, (mine, most) in shown.items() if mine == most} == set(RIGHT)
    for exercise in WRONG:
        assert "Not attempted" not in cell(lesson, cells_of(exercise)[1]).inner_text()

    handed_in = tmp_path / "handed-in"
    handed_in.mkdir()
    lesson.click("text=My work")
    with lesson.expect_download() as saved:
        lesson.click("text=Save as a notebook")
    saved.value.save_as(handed_in / f"ada_{LESSON}.ipynb")
    done = CliRunner().invoke(app, ["grade", str(handed_in), "--out", str(tmp_path / "graded")])
    assert done.exit_code == 0, done.output
    with open(tmp_path / "graded" / "grades.csv", encoding="utf-8") as file:
        marks = next(csv.DictReader(file))
    graded = {name: float(mark) for name, mark in marks.items() if re.fullmatch(r"05\.\d", name)}
    assert graded == {name: float(mine) for name, (mine, _) in shown.items()}


def test_the_bench_takes_a_name_and_bare_numbers_and_says_what_it_misses(address, new_page):
    page = new_page(viewport={"width": 390, "height": 844}, has_touch=True, is_mobile=True)
    page.goto(f"{address}/bench/index.html")
    page.locator("textarea").first.fill("UR5e")
    page.locator(".bench-do", has_text="What is wrong?").tap()
    q = np.random.default_rng(3).integers(-120, 120, (4, 6))
    p = 1000 * dh.load("ur5e").forward(np.deg2rad(q))[:, :3, 3] * [-1, -1, 1]  # turned by 180°
    lines = [" ".join(map(str, [*a, *b])) for a, b in zip(q, p.round(2))]
    for text, told in [
        (lines[0].rpartition(" ")[0], "expected 9 numbers a line"),
        ("\n".join(lines), "The base frame is turned"),
    ]:
        page.get_by_label("Measured poses").fill(text)
        page.get_by_role("button", name="Answer").tap()
        page.get_by_text(told).first.wait_for()
    page.get_by_text("turned by 180°").first.wait_for()
    assert page.evaluate("document.documentElement.scrollWidth <= innerWidth")
