"""The site, built and then opened in Chromium: nothing fetched from elsewhere, nothing broken,
nothing given away in the class edition.
"""

import base64
import gzip
import importlib.util
import io
import re
import sys
import threading
import zipfile
from functools import partial
from html import unescape
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from itertools import pairwise
from pathlib import Path
from urllib.parse import unquote, urljoin, urlsplit

import nbformat
import numpy as np
import pytest
from PIL import Image

import dhlab as dh

ROOT = Path(__file__).parents[1]
sys.path.insert(0, str(ROOT / "docs"))
import reference  # noqa: E402

ROOMS = reference.rooms()
LESSONS = sorted(path.stem for path in (ROOT / "lessons").glob("[0-9]*.ipynb"))
PAGES = [
    "index",
    "bench/index",
    "robots/index",
    "robots/ur5e",
    "robots/irb2400",
    "doctor",
    "explorer",
    "generate",
    "inverse",
    "teaching",
    "add-an-exercise",
    "hosting",
    "conventions",
    "cheat-sheet",
    "arms",
    "add-an-arm",
    "table-files",
    "reference",
    *(f"reference/{room}" for room in ROOMS),
    "lessons/glossary",
    "search",
    "genindex",
    *(f"lessons/{name}" for name in LESSONS),
]
DRAWS = r"^(view\.|dh\.explore\()"  # what ends a cell in a picture
WORKED = re.compile(rb'<details class="worked-answer">.*?</details>\n?', re.DOTALL)
BLOCK = re.compile(
    r"```\{code-block\} \w+\n:caption: (\S+)\n\n(.*?)```(?:\n\n```\{code-block\} text\n:class:"
    r" error\n(.*?)```)?",
    re.DOTALL,
)


@pytest.fixture(scope="session")
def address(site):
    """Where the site is served, on a free port of this machine."""
    handler = type("Quiet", (SimpleHTTPRequestHandler,), {"log_message": lambda *_: None})
    with ThreadingHTTPServer(("127.0.0.1", 0), partial(handler, directory=site)) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}"
        server.shutdown()


@pytest.fixture
def page(new_page):
    """A page, closed at the end: what it draws costs while others are looked at."""
    page = new_page()
    yield page
    page.close()


@pytest.fixture(scope="module")
def opened(new_page, address):
    """``opened(name)`` is a page after loading, and what goes wrong on it: one reader for all,
    since a new one costs as much as most pages.
    """
    page, faults = reader(new_page(), address)

    def get(name):
        page.set_viewport_size({"width": 1280, "height": 720})
        faults.clear()
        page.goto(f"{address}/{name}.html")
        page.wait_for_function(
            "[...document.querySelectorAll('.dhlab-explorer')].every((e) => e.explorer)"
        )
        return page, faults

    return get


def reader(page, address):
    """A page, and the list of what goes wrong on it."""
    faults = []
    page.on(
        "request",
        lambda r: (
            None
            if r.url.startswith((address, "data:", "blob:"))
            else faults.append(f"outside: {r.url}")
        ),
    )
    page.on(
        "response", lambda r: faults.append(f"{r.status}: {r.url}") if r.status >= 400 else None
    )
    page.on("pageerror", lambda e: faults.append(f"script: {e}"))
    page.on("console", lambda m: faults.append(f"console: {m.text}") if m.type == "error" else None)
    return page, faults


@pytest.mark.parametrize("name", PAGES)
def test_a_page_is_whole(opened, site, name):
    """All claims on one page after another, since to open it costs more than to look at it."""
    page, faults = opened(name)
    assert page.locator("h1").count() == 1
    pictures_have_words(page)
    formulas_are_set(page)
    assert page.locator("pre:not([tabindex])").count() == 0, "keys reach what scrolls"
    assert page.locator("aside:not([aria-label])").count() == 0, "what surrounds has a name"
    folder, _, stem = name.rpartition("/")
    if folder == "reference":
        for entry in reference.room(stem)[1]:
            assert page.locator(f'dt[id="{entry}"]').count() == 1, f"{entry} is not there"
    if name == "robots/index":
        the_gallery_finds_every_arm(page, site)
    if stem in LESSONS:
        the_lesson_is_whole(page, stem)
        each_exercise_has_its_worked_answer_folded(page, stem)
        no_picture_scrolls_sideways_on_a_telephone(page)
    if stem == "01-frames":
        assert page.locator("math mtable mtr").count() >= 2, "a formula is a matrix"
    assert faults == [], "nothing from elsewhere and no fault"


def pictures_have_words(page):
    images = page.locator("img").evaluate_all(
        """images => Promise.all(images.map(async (image) => {
        image.loading = 'eager';
        if (!image.complete) await new Promise((done) => { image.onload = image.onerror = done; });
        return [image.getAttribute('alt') ?? '', image.naturalWidth]; }))"""
    )
    for alt, width in images:
        assert len(alt.split()) >= 8 and not re.search(r"\.(png|svg|jpe?g)$", alt), alt
        assert width > 100, alt


def no_picture_scrolls_sideways_on_a_telephone(page):
    page.set_viewport_size({"width": 390, "height": 844})
    figures = page.locator("figure.dhlab-picture").evaluate_all(
        """figures => Promise.all(figures.map(async (figure) => {
        const image = figure.querySelector('img');
        image.loading = 'eager';
        await image.decode();
        return [figure.scrollWidth - figure.clientWidth, image.clientWidth, image.naturalWidth,
            image.currentSrc]; }))"""
    )
    assert page.evaluate("document.documentElement.scrollWidth") <= 390
    for beyond, shown, whole, source in figures:
        assert beyond <= 1, source
        # drawn for this width, so that its letters are as large as elsewhere
        assert not shown or abs(whole / shown - 1) < 0.15, (source, shown, whole)


def formulas_are_set(page):
    page.evaluate("document.querySelectorAll('.later').forEach((e) => e.classList.remove('later'))")
    assert not re.search(
        r"\\(begin|hat|theta|frac|text|qquad)\b|\$\$",
        page.locator("#furo-main-content").inner_text(),
    )
    widths = "[...document.querySelectorAll('math')].map((m) => m.getBoundingClientRect().width)"
    assert all(width > 3 for width in page.evaluate(widths)), "a formula has a width"


def the_lesson_is_whole(page, lesson):
    notebook = nbformat.read(ROOT / "lessons" / f"{lesson}.ipynb", as_version=4)
    prose = "\n".join(cell.source for cell in notebook.cells if cell.cell_type == "markdown")
    cells = [cell.source for cell in notebook.cells if cell.cell_type == "code"]
    headings = page.locator("#furo-main-content :is(h1, h2)").all_inner_texts()
    assert [one.rstrip("¶#").strip() for one in headings] == re.findall(
        r"^##? (.+)$", prose, re.MULTILINE
    )
    drawn = page.locator("div.cell").evaluate_all(
        "cells => cells.map(cell => cell.querySelectorAll('figure.dhlab-picture img').length)"
    )
    draws = [bool(re.search(DRAWS, source, re.MULTILINE)) for source in cells]
    assert len(drawn) == len(cells) and any(draws)
    for source, wanted, count in zip(cells, draws, drawn):
        assert not wanted or count == 1, source
    assert page.locator("[role=status]", has_text="Not attempted yet").count() >= len(
        re.findall(r"^check\(", "\n".join(cells), re.MULTILINE)
    )
    assert page.locator("div.cell_input button.copybtn").count() == len(cells)
    assert page.locator(".traceback, .stderr").count() == 0 and "Traceback" not in page.content()
    assert page.locator('a[href$="index.html#set-up"]').count() == 1


def each_exercise_has_its_worked_answer_folded(page, name):
    solution = nbformat.read(ROOT / "solutions" / f"{name}.ipynb", as_version=4)
    regions = {
        cell.metadata["exercise"]: re.findall(
            r"### BEGIN SOLUTION\n(.*?)### END SOLUTION", cell.source, re.DOTALL
        )
        for cell in solution.cells
        if cell.cell_type == "code" and cell.metadata.get("exercise")
    }
    answers = page.locator("details.worked-answer").evaluate_all(
        "all => all.map(one => [one.open, one.querySelector('summary').textContent,"
        " one.querySelector('pre').textContent])"
    )
    assert len(answers) == len(regions) and not any(is_open for is_open, _, _ in answers)
    for exercise, texts in regions.items():
        [answer] = [code for _, title, code in answers if title.strip().endswith(f"to {exercise}")]
        lines = {" ".join(line.split()) for line in answer.splitlines()}
        for line in (line for text in texts for line in text.splitlines() if line.strip()):
            unknown = line.strip().endswith('= "?"')  # there the right letter stands
            assert unknown or " ".join(line.split()) in lines, f"{exercise}: {line}"


def the_gallery_finds_every_arm(page, site):
    assert page.locator(".arm-card").count() == len(dh.robots())
    assert all((site / f"robots/{name}.html").is_file() for name in dh.robots())
    page.fill(".arm-search input", "UR5-e")
    # its text as it stands: a card that has just come into view has no inner text before a frame is
    # drawn (content-visibility)
    assert page.locator(".arm-card:visible b").all_text_contents() == ["UR5e"]
    page.fill(".arm-search input", "kuka iiwa")
    assert page.locator(".arm-card:visible").count() == 2
    page.fill(".arm-search input", "no such arm")
    assert "No arm" in page.locator(".arm-search [role=status]").inner_text()


def test_formulas_have_space_round_functions_and_no_unknown_commands():
    spec = importlib.util.spec_from_file_location("mathml", ROOT / "docs" / "mathml.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    assert re.findall(r"<mspace|<m[io]>.*?</m[io]>", module.mathml(r"a\cos\theta + \sin 2")) == [
        "<mi>a</mi>",
        "<mspace",
        "<mi>cos</mi>",
        "<mspace",
        "<mi>θ</mi>",
        "<mo>+</mo>",
        "<mi>sin</mi>",
        "<mspace",
    ]
    for tex in (r"\curvy x", r"\begin{bmatrix} 1"):
        with pytest.raises(ValueError, match="formula"):
            module.mathml(tex)


def test_search_finds_what_is_called_so(page, address):
    for asked, page_found in (
        ("flange", "glossary"),
        ("atan2", "02-parameters"),
        ("UR5e", "robots/ur5e"),
        ("wrong place", "doctor"),
    ):
        page.goto(f"{address}/search.html?q={asked}")
        links = page.locator("#search-results li a")
        links.first.wait_for()
        found = links.evaluate_all("all => all.map(one => one.getAttribute('href') ?? '')")
        assert any(page_found in link for link in found), asked


def test_pages_are_light_and_pictures_come_when_they_are_seen(site):
    for path in site.rglob("*.html"):
        text = path.read_text(encoding="utf-8")
        assert len(gzip.compress(text.encode())) < 60_000, path
        assert "data:image/png" not in text, path
        assert all('loading="lazy"' in tag for tag in re.findall(r"<img [^>]*webp[^>]*>", text))


def test_on_paper_what_follows_a_prediction_is_there_with_its_views(page, address):
    page.goto(f"{address}/lessons/04-placing-frames.html", wait_until="load")
    page.wait_for_function(
        "[...document.querySelectorAll('.dhlab-explorer')].every(e => e.explorer)"
    )
    folded = page.locator(".later").count()
    page.pdf()
    drawn = "[...document.querySelectorAll('.dhlab-explorer')].map(e => e.explorer.stage.drawn)"
    assert 0 not in page.evaluate(drawn)
    assert page.locator(".later").count() == folded > 0, "on the screen all is as before"


def test_the_outcome_of_a_prediction_is_seen_after_choosing(page, address):
    page.goto(f"{address}/lessons/02-parameters.html")
    outcome = page.get_by_text("Only the y1 and z1 arrows tip")
    assert outcome.is_hidden()
    page.get_by_role("button", name="it stays where it is").click()
    assert outcome.is_visible()
    assert page.locator(".predict-wait").first.inner_text().startswith("Your guess")


def test_the_site_and_a_lesson_can_be_taken_along(site):
    with zipfile.ZipFile(site / "dhlab-site.zip") as archive:
        names = archive.namelist()
    assert {"dhlab/index.html", "dhlab/robots/ur5e.html", "dhlab/_static/explorer.js"} <= set(names)
    for name in LESSONS:
        page = (site / f"lessons/{name}.html").read_text(encoding="utf-8")
        assert f'<a href="{name}.ipynb" download>' in page
        nbformat.read(site / f"lessons/{name}.ipynb", as_version=4)


def test_an_arm_is_changed_shared_and_saved_on_its_page(page, address, tmp_path):
    page.goto(f"{address}/robots/ur5e.html#q=10,-60,80,-110,-80,20")
    page.get_by_text("Change the table").click()
    page.get_by_role("radio", name="Craig's").check(force=True)
    a = page.get_by_role("spinbutton", name="a of row 3, millimetres")
    assert a.input_value() == "-425"
    a.fill("-400")
    a.press("Enter")
    changed = dh.load("ur5e").to("craig")
    rows = changed.table.rows
    rows[2, 2] = -0.4
    table = dh.DHTable.craig(rows, angle="rad")
    wanted = dh.Arm(table, base=changed.base, tool=changed.tool)
    q = np.deg2rad([10, -60, 80, -110, -80, 20])
    with page.expect_download() as taken:
        page.get_by_role("button", name="Save the table").click()
    taken.value.save_as(tmp_path / "arm.yaml")
    np.testing.assert_allclose(
        dh.load(tmp_path / "arm.yaml").forward(q), wanted.forward(q), atol=1e-12
    )
    page.get_by_role("button", name="Copy a link").click()
    page.wait_for_function("location.hash.includes('rows=')")
    other = page.context.new_page()
    other.goto(page.url)
    other.wait_for_function("document.querySelector('.dhlab-explorer').explorer?.stage.drawn > 0")
    other.get_by_text("Change the table").wait_for()
    for one in (page, other):
        words = one.locator(".readout dd").first.inner_text().replace("−", "-")
        found = [float(number) for number in re.findall(r"-?\d+\.?\d*", words)]
        np.testing.assert_allclose(found, 1000 * wanted.forward(q)[:3, 3], atol=0.051)
    with page.expect_download() as taken:
        page.get_by_role("button", name="Save the picture").click()
    assert taken.value.suggested_filename == "universal-robots-ur5e.png"
    page.get_by_role("button", name="Back to the published table").click()
    assert page.get_by_role("spinbutton", name="a of row 2, millimetres").input_value() == "-425"


def test_a_motion_is_planned_played_and_told_of_on_an_arms_page(page, address):
    arm = dh.load("irb2400")
    page.set_viewport_size(
        {"width": 390, "height": 844}
    )  # what plays is drawn sixty times a second
    page.goto(f"{address}/robots/irb2400.html#q=40,20,-20,30,-50,60")
    page.get_by_text("Play a motion").click()
    keep = page.get_by_role("button", name="Keep this pose")
    explorer = "document.querySelector('.dhlab-explorer').explorer"
    page.evaluate(
        f"q => {explorer}.host.set('q', q)", np.deg2rad([-40, 0, 0, 30, -60, 60]).tolist()
    )
    keep.click()
    hand, joints = (
        np.array(page.evaluate(f"{explorer}.motion.ways.{way}.qs")) for way in ("hand", "joints")
    )
    np.testing.assert_allclose(np.diff(joints, 2, axis=0), 0, atol=1e-12)
    points = arm.forward(hand)[:, :3, 3]
    line = np.linspace(points[0], points[-1], len(points))
    assert np.abs(points - line).max() < 2e-4 * np.linalg.norm(points[0])
    np.testing.assert_allclose(arm.forward(hand[-1]), arm.forward(joints[-1]), atol=2e-3)
    page.get_by_role("radio", name="Both").check(force=True)
    said = page.locator(".motion [role=status]")
    assert "followed all the way" in said.inner_text()
    page.get_by_role("button", name="Play", exact=True).click()
    page.wait_for_function(f"{explorer}.motion.shown === 90")
    page.evaluate(f"q => {explorer}.host.set('q', q)", np.deg2rad([170, 0, 0, 0, 0, 0]).tolist())
    keep.click()
    assert "With the hand straight: from pose 2 to 3" in said.inner_text()


def test_a_motion_is_saved_as_a_gif_where_no_video_can_be_made(new_page, address, tmp_path):
    page = new_page(viewport={"width": 1280, "height": 900})
    page.add_init_script("delete globalThis.MediaRecorder")
    page.goto(f"{address}/robots/ur5e.html#q=40,-60,80,-110,-80,20")
    page.get_by_text("Play a motion").click()
    programs = []
    page.on(
        "request",
        lambda request: programs.append(request.url) if request.resource_type == "script" else None,
    )
    explorer = "document.querySelector('.dhlab-explorer').explorer"
    page.evaluate(f"{explorer}.host.set('q', [0, -1, 1, 0, 0, 0])")
    page.get_by_role("button", name="Keep this pose").click()
    assert page.get_by_role("button", name="Save as a video").count() == 0 and programs == []
    with page.expect_download() as taken:
        page.get_by_role("button", name="Save as a GIF").click()
    assert len(programs) == 1 and "gif" in programs[0]
    assert taken.value.suggested_filename == "universal-robots-ur5e.gif"
    taken.value.save_as(tmp_path / "motion.gif")
    shown = page.evaluate(f"{explorer}.stage.canvas.toDataURL()").partition(",")[2]
    end = Image.open(io.BytesIO(base64.b64decode(shown))).convert("RGBA")
    assert (tmp_path / "motion.gif").stat().st_size < 2e6
    with Image.open(tmp_path / "motion.gif") as gif:
        assert gif.n_frames == 31 and gif.size[0] == min(640, end.width)
        times, pictures = [], []
        for k in range(gif.n_frames):
            gif.seek(k)
            times.append(gif.info["duration"])
            pictures.append(np.asarray(gif.convert("RGB"), dtype=float))
    assert sum(times[:-1]) == pytest.approx(2500, rel=0.06) and times[-1] > 1000
    assert all((a != b).any() for a, b in pairwise(pictures))
    ground = Image.new("RGBA", end.size, tuple(map(int, pictures[0][0, 0])))
    end = Image.alpha_composite(ground, end).convert("RGB").resize(gif.size)
    assert np.abs(pictures[-1] - np.asarray(end, dtype=float)).mean() < 3  # of 255


def test_the_real_robot_stands_where_its_urdf_says(page, address):
    yourdfpy = pytest.importorskip("yourdfpy")
    model = Path(pytest.importorskip("pybullet_data").getDataPath()) / "kuka_iiwa" / "model.urdf"
    q = [40, 20, -20, 30, -50, 60, 10]
    page.goto(f"{address}/robots/iiwa14.html#q={','.join(map(str, q))}")
    page.get_by_text("Show the real robot").click()
    files = [model, *sorted(model.parent.glob("meshes/*.stl"))]
    page.locator("input[type=file]").set_input_files(files)
    body = "document.querySelector('.dhlab-explorer').explorer.body"
    page.wait_for_function(f"{body}.parts.length === 8")
    assert page.evaluate(f"{body}.said.textContent") == "8 parts are drawn."
    found = page.evaluate(f"{body}.parts.map(({{ frame, pose }}) => [frame, pose])")
    robot = yourdfpy.URDF.load(model, load_meshes=False, build_scene_graph=True)
    robot.update_cfg(np.deg2rad(q))
    frames = dh.load("iiwa14").frames(np.deg2rad(q))
    for frame, pose in found:  # no visual has a place of its own in this file
        wanted = robot.get_transform(f"lbr_iiwa_link_{frame}")
        np.testing.assert_allclose(frames[frame] @ np.reshape(pose, (4, 4)), wanted, atol=2e-3)


def test_links_inside_the_site_resolve(site):
    texts = {
        path.relative_to(site).as_posix(): path.read_text(encoding="utf-8")
        for path in site.rglob("*.html")
    }
    targets = {name: set(re.findall(r'\bid="([^"]+)"', text)) for name, text in texts.items()}
    broken = []
    for name, text in texts.items():
        for link in re.findall(r'<a [^>]*?href="([^"]*)"', text):
            parts = urlsplit(urljoin(f"http://site/{name}", unescape(link)))
            path, anchor = unquote(parts.path.lstrip("/")), unquote(parts.fragment)
            if parts.netloc == "site" and not (
                (path in targets or (site / path).is_file())
                and (not anchor or anchor in targets[path] or path == "bench/index.html")  # a case
            ):
                broken.append(f"{name}: {link}")
    assert broken == []


def test_terms_of_the_lessons_are_linked_to_the_glossary(site):
    linked = sum(
        len(
            re.findall(
                r'href="glossary\.html#',
                (site / f"lessons/{name}.html").read_text(encoding="utf-8"),
            )
        )
        for name in LESSONS
    )
    assert linked >= len(LESSONS)


def _solution_regions():
    for path in sorted((ROOT / "solutions").glob("[0-9]*.md")):
        for region in re.findall(
            r"### BEGIN SOLUTION\n(.*?)### END SOLUTION",
            path.read_text(encoding="utf-8"),
            re.DOTALL,
        ):
            yield (
                path.stem,
                [" ".join(line.split()) for line in region.splitlines() if line.strip()],
            )


@pytest.fixture(scope="session")
def class_edition(site):
    """The folder of the class edition, of the same runs as the site."""
    return site.parent / "class" / "html"


def test_two_builds_differ_in_nothing_but_the_worked_answers(site, class_edition):
    ours, theirs = _contents(site), _contents(class_edition)
    differ = [path for path in ours | theirs if ours.get(path) != theirs.get(path)]
    lessons = [f"lessons/{name}.html" for name in LESSONS]
    assert sorted(differ) == sorted([*lessons, "dhlab-site.zip", "searchindex.js"])
    for path in lessons:
        assert re.sub(WORKED, b"", ours[path]) == theirs[path], path


def _contents(folder):
    return {
        path.relative_to(folder).as_posix(): path.read_bytes()
        for path in folder.rglob("*")
        if path.is_file()
    }


def test_the_class_edition_gives_no_solution_away(class_edition):
    site = class_edition
    files = [
        path
        for path in site.rglob("*")
        if path.suffix in (".html", ".js", ".ipynb", ".txt", ".md") and "_static" not in path.parts
    ]
    words = " ".join(
        " ".join(unescape(re.sub(r"<[^>]+>", "", path.read_text(encoding="utf-8"))).split())
        for path in files
    )
    handed_out = " ".join(
        " ".join(
            cell.source
            for cell in nbformat.read(ROOT / "lessons" / f"{name}.ipynb", as_version=4).cells
        )
        for name in LESSONS
    )
    handed_out = " ".join(handed_out.split())
    checks = re.findall(r'check\("[^)]+\)', handed_out)
    assert "The worked answer" not in words
    assert checks and all(line in words for line in checks), (
        "code is not found on the pages, so this test would see nothing"
    )
    regions = list(_solution_regions())
    assert len(regions) > 20
    for lesson, lines in regions:
        assert " ".join(lines) not in words, (
            f"{lesson}: the class edition shows the solution {lines}"
        )
        for line in lines:  # lines such as "def f(x):" stand in the task as well
            assert line in handed_out or line not in words, (
                f"{lesson}: the class edition shows {line!r}"
            )


def _examples():
    return BLOCK.findall((ROOT / "docs" / "table-files.md").read_text(encoding="utf-8"))


@pytest.mark.parametrize("name, text, error", _examples(), ids=[name for name, _, _ in _examples()])
def test_examples_of_the_table_files_page(tmp_path, monkeypatch, name, text, error):
    monkeypatch.chdir(tmp_path)
    Path(name).write_text(text, encoding="utf-8")
    if error:
        with pytest.raises(ValueError) as raised:
            dh.load(name)
        assert str(raised.value) == " ".join(error.split())
    else:
        table = dh.load(name).table
        assert (table.convention, table.joints) == ("standard", "RRP")
        np.testing.assert_allclose(
            table.rows,
            [[0, 0.3, 0, np.pi / 2], [np.pi / 2, 0, 0.25, 0], [0, 0.12, 0, 0]],
            atol=1e-15,
        )


def test_the_arm_of_the_table_files_page_is_where_the_page_says(tmp_path):
    (name, text, _), *_ = _examples()
    (tmp_path / name).write_text(text, encoding="utf-8")
    arm = dh.load(tmp_path / name)
    np.testing.assert_allclose(arm.forward([0, 0, 0])[:3, 3], [0, -0.22, 0.55], atol=1e-12)
    assert arm.limits[2] is None and arm.sign.tolist() == [1, -1, 1]
    arm.save(tmp_path / "copy.yaml")
    np.testing.assert_allclose(
        dh.load(tmp_path / "copy.yaml").forward([0.1, 0.2, 0.3]),
        arm.forward([0.1, 0.2, 0.3]),
        atol=1e-15,
    )
