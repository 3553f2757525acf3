"""A lesson that runs in its page: by hand, in Chromium, from the files that the site serves."""

import csv
import importlib.util
import json
import re
import shutil
import sys
import threading
import types
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import nbformat
import numpy as np
import pytest
from draws import ALL
from typer.testing import CliRunner

import dhlab as dh
from dhlab.cli.app import app

ROOT = Path(__file__).parents[2]
LESSON = "05-link-matrix"


def live(name):
    """A module of docs/live, by its file: beside it stands another anywidget."""
    spec = importlib.util.spec_from_file_location(name, ROOT / "docs" / "live" / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def address(site, tmp_path_factory):
    """Where the site with its Python is served."""
    folder = tmp_path_factory.mktemp("live") / "html"
    shutil.copytree(site, folder)
    gather = live("gather")
    gather.LEVEL = 1  # how small the files are is not looked at here
    gather.into(folder)
    handler = type("Quiet", (SimpleHTTPRequestHandler,), {"log_message": lambda *_: None})
    with ThreadingHTTPServer(("127.0.0.1", 0), partial(handler, directory=folder)) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}"
        server.shutdown()


@pytest.fixture
def lesson(address, new_page):
    """The lesson's page; what it asked for elsewhere and what went wrong in it must be nothing."""
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


# of five answers, which are the solution's, and what stands in the others
RIGHT = ("05.1", "05.5", "05.6")
WRONG = {
    "05.3": 'order = ["c", "d", "a", "b"]',
    "05.4": "def dh_transform(theta, d, a, alpha):\n"
    "    return rot_z(theta) @ trans_z(d) @ trans_x(a) @ rot_x(-alpha)",
}
OLDER = "05.9"  # of which an older version of the lesson was answered


@pytest.mark.cage
def test_a_lesson_runs_in_its_page_and_leaves_as_a_notebook_with_the_marks_shown(lesson, tmp_path):
    """On one page, since Python takes long to begin in it."""
    older = work_on_an_older_lesson_stays_beside_the_new_one(lesson)
    changed = {**answered_by_hand_then_in_words(lesson), **all_answered(lesson)}
    shown = marks_shown(lesson)
    file = tmp_path / "handed-in" / f"ada_{LESSON}.ipynb"
    saved(lesson, file, changed)
    assert graded(file.parent, tmp_path / "graded") == shown
    stopped_while_a_cell_does_not_end(lesson, cells_of("05.2")[0])

    lesson.reload()  # the work has stayed
    lesson.click("text=Run this lesson")
    for name, source in (changed | older).items():
        assert cell(lesson, name).locator("textarea").input_value() == source


def work_on_an_older_lesson_stays_beside_the_new_one(lesson):
    """Begins the lesson; the text of the cell whose older version had been answered."""
    answer, _ = cells_of(OLDER)
    old = {"handedOut": {answer: "an older text"}, "mine": {answer: "mine"}}
    lesson.evaluate(
        "work => localStorage.setItem('dhlab:work:05-link-matrix', work)", json.dumps(old)
    )
    lesson.click("text=Run this lesson")
    place = cell(lesson, answer)
    place.get_by_text("This cell has changed since you wrote in it").wait_for()
    given = code("lessons")[answer]
    assert place.locator("textarea").input_value() == given
    return {answer: given}


def answered_by_hand_then_in_words(lesson):
    """05.2 with its cards, then with the solution's text; {id: text} of its cell."""
    answer, check = cells_of("05.2")
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
    return {answer: solution}


def all_answered(lesson):
    """RIGHT and WRONG, and the whole lesson run; {id: text} of the cells."""
    solutions = code("solutions")
    answers = {cells_of(exercise)[0]: solutions[cells_of(exercise)[0]] for exercise in RIGHT}
    answers |= {cells_of(exercise)[0]: text for exercise, text in WRONG.items()}
    for name, source in answers.items():
        cell(lesson, name).locator("textarea").fill(source)
    lesson.click("text=Run all")
    return answers


def marks_shown(lesson):
    """{exercise: points} of the table at the end, once every cell has run."""
    places = [cell(lesson, name) for name in code("lessons")]
    for place in places:
        place.and_(lesson.locator('[data-live="ran"], [data-live="failed"]')).wait_for()
    rows = places[-1].locator("tbody tr").all()
    table = [row.locator("td").all_inner_texts() for row in rows]
    shown = {name: points.split(" of ") for name, _, _, points in table}
    assert {name for name, (mine, most) in shown.items() if mine == most} == {*RIGHT, "05.2"}
    for exercise in WRONG:
        assert "Not attempted" not in cell(lesson, cells_of(exercise)[1]).inner_text()
    return {name: float(mine) for name, (mine, _) in shown.items()}


def saved(lesson, file, changed):
    """The notebook that leaves the page is the lesson's own, but for the answers."""
    file.parent.mkdir()
    lesson.click("text=My work")
    with lesson.expect_download() as download:
        lesson.click("text=Save as a notebook")
    download.value.save_as(file)
    mine = nbformat.read(file, as_version=4)
    nbformat.validate(mine)
    given = nbformat.read(ROOT / "lessons" / f"{LESSON}.ipynb", as_version=4)
    assert [one.id for one in mine.cells] == [one.id for one in given.cells]
    assert {a.id: a.source for a, b in zip(mine.cells, given.cells) if a.source != b.source} == (
        changed
    )
    assert mine.metadata == given.metadata


def graded(handed_in, out):
    """{exercise: points} of the one student, as ``dhlab grade`` gives them."""
    done = CliRunner().invoke(app, ["grade", str(handed_in), "--out", str(out)])
    assert done.exit_code == 0, done.output
    with open(out / "grades.csv", encoding="utf-8") as file:
        marks = next(csv.DictReader(file))
    return {name: float(mark) for name, mark in marks.items() if re.fullmatch(r"05\.\d", name)}


def stopped_while_a_cell_does_not_end(lesson, name):
    """The page answers meanwhile; its text is then as before."""
    area = cell(lesson, name).locator("textarea")
    before = area.input_value()
    area.fill("while True: pass")
    area.press("Control+Enter")
    lesson.route(
        "**/worker.js", lambda route: route.fulfill(body="", content_type="text/javascript")
    )  # Python is not wanted again
    lesson.click("text=Stop")
    lesson.get_by_text("Python begins anew").wait_for()
    area.fill(before)


def measured(arm, n):
    """Lines of bare numbers: joint values and where the end was, from a base turned by 180°."""
    q = np.random.default_rng(3).integers(-120, 120, (n, len(arm)))
    p = 1000 * arm.forward(np.deg2rad(q))[:, :3, 3] * [-1, -1, 1]
    return [" ".join(map(str, [*a, *b])) for a, b in zip(q, p.round(2))]


TURNED = ("The base frame is turned", "turned by 180°")


def test_the_bench_takes_a_name_and_bare_numbers_and_says_what_it_misses(address, new_page):
    page = new_page(viewport={"width": 390, "height": 844}, has_touch=True, is_mobile=True)
    page.goto(f"{address}/bench/index.html")
    arm, answer = dh.load("ur5e"), page.get_by_role("button", name="Answer")
    page.locator("textarea").first.fill("UR5e")
    page.locator(".bench-do", has_text="What is wrong?").tap()
    lines = measured(arm, 4)
    page.get_by_label("Measured poses").fill(lines[0].rpartition(" ")[0])
    answer.tap()
    page.get_by_text("expected 9 numbers a line").first.wait_for()
    if ALL:  # the doctor needs scipy, which takes as long to begin as Python
        page.get_by_label("Measured poses").fill("\n".join(lines))
        answer.tap()
        for told in TURNED:
            page.get_by_text(told).first.wait_for()
    page.locator(".bench-do", has_text="Where is its end?").tap()
    page.get_by_label("Joint values (degrees").fill("10 -60 80 -110 -80 20")
    answer.tap()
    page.get_by_text("position").first.wait_for()
    words = page.locator(".bench-results").inner_text().partition("position")[2]
    found = [float(number) for number in words.replace("−", "-").split()[:3]]
    wanted = 1000 * arm.forward(np.deg2rad([10, -60, 80, -110, -80, 20]))[:3, 3]
    np.testing.assert_allclose(found, wanted, atol=5.1e-4)
    assert page.evaluate("document.documentElement.scrollWidth <= innerWidth")


def test_the_bench_has_the_doctor_say_what_is_wrong(tmp_path, monkeypatch):
    """As Python in the page does, without a page."""
    monkeypatch.chdir(tmp_path)
    bridge = types.SimpleNamespace(bundle_of=lambda shown: {"text/plain": str(shown)})
    monkeypatch.setitem(sys.modules, "bridge", bridge)
    poses = "\n".join(measured(dh.load("ur5e"), 4))
    asked = {"arm": "UR5e", "do": "diagnose", "poses": poses, "units": "mm,deg"}
    answer = live("bench").Bench(asked).answered()
    said = " ".join(part["data"].get("text/plain", "") for part in answer["parts"])
    assert all(told in said for told in TURNED), said
