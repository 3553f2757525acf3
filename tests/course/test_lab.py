"""JupyterLab in Chromium, on a learner's folder: lesson 06 opened, run, an answer given and
judged.
"""

import json
import re
import socket
import subprocess
import time
import urllib.request

import nbformat
import numpy as np
import pytest
from draws import few

from dhlab.course import workspace


@pytest.fixture(scope="module")
def lab(tmp_path_factory):
    """The address of a JupyterLab on a prepared folder."""
    tmp_path = tmp_path_factory.mktemp("lab")
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    folder = tmp_path / "course"
    workspace.prepare(folder)
    workspace.write_settings(folder)
    command = workspace.lab_command(folder, port=port, browser=False) + [
        "--IdentityProvider.token=",
        "--LabApp.expose_app_in_browser=True",
        "--ServerApp.port_retries=0",
    ]
    with open(tmp_path / "lab.log", "w") as log:
        process = subprocess.Popen(command, stdout=log, stderr=log)
    address = f"http://127.0.0.1:{port}"
    try:
        for _ in range(240):
            try:
                urllib.request.urlopen(f"{address}/api", timeout=2)
                break
            except OSError:
                assert process.poll() is None, (tmp_path / "lab.log").read_text()[-2000:]
                time.sleep(0.5)
        yield address, folder
    finally:
        process.terminate()
        process.wait(20)


def wait_for(page, what, event):
    """Wait until ``event()`` is done, a call of Playwright's that waits for ``what``; what was on
    the page is said when it does not come.
    """
    from playwright.sync_api import Error

    try:
        return event()
    except (Error, AssertionError) as error:
        status = page.locator("#jp-main-statusbar").all_text_contents()
        prompts = "".join(page.locator(".jp-CodeCell .jp-InputPrompt").all_text_contents())
        errors = page.locator("[data-mime-type*=stderr]").all_inner_texts()
        dialogs = page.locator(".jp-Dialog").all_inner_texts()
        views = [text[:200] for text in page.locator(".jupyter-widgets").all_inner_texts()]
        pytest.fail(
            f"waited for {what}; saw the status bar {status}, the cells {prompts}, the errors"
            f" {errors}, the dialogs {dialogs}, the views {views}\n{error}"
        )


def kernel_is_idle(page):
    """The kernel answers. JupyterLab runs only the first cell of all when it does not yet."""
    idle = page.get_by_text("| Idle")
    wait_for(page, "an idle kernel", lambda: idle.wait_for())


def faults(page):
    """A list of what the page will have asked for that is not on this machine, and of the errors
    of the library's own JavaScript.
    """
    found = []
    page.on(
        "request",
        lambda request: (
            found.append(request.url)
            if not re.match(r"(http|ws)s?://127\.0\.0\.1|data:|blob:", request.url)
            else None
        ),
    )
    page.on("pageerror", lambda error: found.append(str(error)) if "dhlab" in str(error) else None)
    return found


@pytest.fixture(scope="module")
def jupyter(lab, new_page):
    """JupyterLab in a page, which all tests share: to load it takes longer than what they do."""
    page = new_page(viewport={"width": 1280, "height": 1400})
    page.faults = faults(page)
    page.goto(f"{lab[0]}/lab/workspaces/tests?reset")
    page.wait_for_function("window.jupyterapp")
    page.evaluate("jupyterapp.restored.then(() => null)")
    return page


def opened(page, name):
    """The panel of a notebook, opened as by a click on its file, with a kernel that answers."""
    page.evaluate("path => void jupyterapp.commands.execute('docmanager:open', { path })", name)
    # by its own kernel: the status bar may still tell of the notebook that was opened before
    idle = """path => { const { context, sessionContext } = jupyterapp.shell.currentWidget ?? {};
        return context?.path === path && sessionContext.session?.kernel?.status === "idle"; }"""
    wait_for(page, f"an idle kernel for {name}", lambda: page.wait_for_function(idle, arg=name))
    return page.locator(".jp-NotebookPanel:not(.lm-mod-hidden)")


def test_lesson_06_runs_in_the_browser(lab, jupyter):
    from playwright.sync_api import expect

    name, log = "06-forward-kinematics.ipynb", lab[1] / ".dhlab" / "progress.jsonl"
    logged = log.read_text(encoding="utf-8") if log.exists() else None
    panel = opened(jupyter, name)
    heading = panel.get_by_role("heading", name="06 Six axes")
    wait_for(jupyter, "the heading of lesson 06", lambda: heading.wait_for())
    jupyter.get_by_role("menuitem", name="Run", exact=True).click()
    jupyter.get_by_text("Run All Cells", exact=True).click()
    lesson = json.loads((lab[1] / name).read_text(encoding="utf-8"))
    cells = sum(cell["cell_type"] == "code" for cell in lesson["cells"])
    # while JupyterLab builds its toolbar there may be two indicators
    ran = panel.locator(".jp-Notebook-ExecutionIndicator").filter(
        has_text=f"Executed {cells} cells"
    )
    wait_for(jupyter, f"{cells} cells that have run", lambda: expect(ran.first).to_be_attached())
    points = panel.get_by_text(re.compile(r"^0 of \d+ points$")).first
    wait_for(jupyter, "0 of the points", lambda: expect(points).to_be_attached())
    assert jupyter.faults == []
    assert (log.read_text(encoding="utf-8") if log.exists() else None) == logged, (
        "an untouched lesson leaves nothing in the log"
    )


CELLS = [
    """import dhlab as dh
explorer = dh.explore(dh.load("article-6r"))
seen = []
explorer.observe(lambda change: seen.append(change.new[0]), "q")
explorer""",
    """print("q is", (1e4 * explorer.q).round().astype(int).tolist(), "table", round(float(explorer.table.theta[1]), 4), "calls", len(seen) > 0)""",
    "explorer.q = [0.5, 0, 0, 0, 0, -0.25]",
    """placing = dh.explore(dh.load("article-6r"), mode="place")
placing""",
    """print("placed", sorted(placing.placing.placement.z), placing.arm)""",
]


def run(panel, cell):
    """Run one cell, from 0, perhaps once more, and wait until it is done."""
    cells = panel.locator(".jp-CodeCell")
    prompt = cells.nth(cell).locator(".jp-InputPrompt")
    before = prompt.text_content()
    cells.nth(cell).locator(".cm-content").click()
    panel.page.keyboard.press("Shift+Enter")
    done = prompt.filter(has_text=re.compile(r"\[\d+\]"), has_not_text=before)
    wait_for(panel.page, f"cell {cell} to be run", lambda: done.wait_for())
    return cells.nth(cell)


def test_explorer_is_moved_by_mouse_keyboard_and_python_and_is_still_there_tomorrow(
    lab, jupyter, new_page
):
    from playwright.sync_api import expect

    address, folder = lab
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(text) for text in CELLS])
    notebook.metadata["kernelspec"] = {
        "display_name": "Python 3",
        "language": "python",
        "name": "python3",
    }
    nbformat.write(notebook, folder / "explorer.ipynb")
    page, panel = jupyter, opened(jupyter, "explorer.ipynb")
    run(panel, 0)
    first, second = (page.get_by_role("slider", name=f"Joint {k}, degrees") for k in (1, 2))
    box = first.bounding_box()
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.mouse.down()
    page.mouse.move(box["x"] + 0.75 * box["width"], box["y"] + box["height"] / 2, steps=5)
    page.mouse.up()
    second.focus()
    for _ in range(4):
        page.keyboard.press("ArrowRight")
    shown = [float(slider.evaluate("s => s.value")) for slider in (first, second)]
    assert shown[0] > 30 and shown[1] == 2.0
    exactly = page.get_by_role("spinbutton", name="Joint 3, degrees, exactly")
    exactly.click()
    expect(exactly).to_be_focused()
    page.keyboard.press("Control+a")
    for key in ["-", "1", "2", "Enter", "a", "b", "d", "d", "m"]:
        page.keyboard.press(key)
    expect(page.get_by_role("slider", name="Joint 3, degrees")).to_have_attribute(
        "aria-valuetext", "-12 degrees"
    )
    q = [round(1e4 * np.deg2rad(value)) for value in [*shown, -12]] + [0] * 3
    expect(run(panel, 1)).to_contain_text(f"q is {q} table {np.deg2rad(2):.4f} calls True")
    run(panel, 2)
    expect(first).to_have_attribute("aria-valuetext", "28.65 degrees")
    expect(page.get_by_role("slider", name="Joint 6, degrees")).to_have_attribute(
        "aria-valuetext", "-14.32 degrees"
    )
    assert panel.locator(".jp-CodeCell").count() == len(CELLS), (
        "keys in the view are no commands of the notebook"
    )
    run(panel, 3)
    page.get_by_role("radio", name="A: axis of joint 1, forward").check(force=True)
    page.get_by_role("button", name="Place it").click()
    expect(page.get_by_text("Along the axis of joint 1.")).to_be_visible()
    page.get_by_role("radio", name="A: axis of joint 1, forward").check(force=True)
    page.get_by_role("button", name="Place it").click()
    expect(
        page.get_by_text(
            "This points along the axis of joint 1; in the standard convention z1 is the axis of joint 2."
        )
    ).to_be_visible()
    expect(run(panel, 4)).to_contain_text("placed [0] None")
    page.keyboard.press("Control+s")
    page.wait_for_function(
        "() => !document.querySelector('.lm-TabBar-tab.lm-mod-current.jp-mod-dirty')"
    )
    page.get_by_role("menuitem", name="Kernel", exact=True).click()
    page.get_by_text("Shut Down Kernel", exact=True).click()
    page.get_by_text("No Kernel").first.wait_for()
    assert page.faults == []
    page = new_page(viewport={"width": 1280, "height": 1400})
    found = faults(page)
    first = page.get_by_role("slider", name="Joint 1, degrees")
    anew = page.get_by_role("button", name="Start over")
    # where the kernel is connected sooner than the notebook is read, JupyterLab does not look for
    # views there (jupyterlab-widgets 3.0.17) and says so, of all of them or of one; then it is
    # loaded again, as one would do
    not_read = page.get_by_text("Error displaying widget: model not found").first
    for _ in range(5):
        page.goto(f"{address}/lab/workspaces/again/tree/explorer.ipynb?reset")
        for view in (first, anew):
            one = view.or_(not_read).first
            wait_for(page, "the views of yesterday", lambda one=one: one.wait_for())
        if not not_read.is_visible():
            break
    kernel_is_idle(page)
    expect(first).to_have_attribute("aria-valuetext", "28.65 degrees")
    first.press("ArrowRight")
    expect(first).to_have_attribute("aria-valuetext", "29 degrees")
    wait_for(page, "the view of placing", anew.click)
    expect(page.get_by_text("Python has not answered. Run the cell above again")).to_be_visible()
    page.close()
    assert found == []


# the lesson that is open already, and another one
CARDS = {
    "06-forward-kinematics.ipynb": ("06.5", "it is a third pitch", 'joint_4 = "c"'),
    "01-frames.ipynb": ("01.6", "the controller reported the flange", 'why = "c"'),
}


@pytest.mark.parametrize("name", few(CARDS, 1))
def test_a_card_that_is_clicked_is_written_into_its_own_cell_alone(lab, jupyter, name):
    from playwright.sync_api import expect

    path = lab[1] / name
    exercise, card, written = CARDS[name]
    before = json.loads(path.read_text(encoding="utf-8"))["cells"]
    codes = ["".join(cell["source"]) for cell in before if cell["cell_type"] == "code"]
    checks = next(k for k, text in enumerate(codes) if text.startswith(f'check("{exercise}"'))
    page, panel = jupyter, opened(jupyter, path.name)
    for cell in (0, checks - 1, checks):
        run(panel, cell)
    panel.get_by_role("radio", name=card).check(force=True)
    expect(panel.get_by_text("is not in the notebook yet").first).to_be_visible()
    cell = run(panel, checks - 1)
    expect(cell.locator(".cm-content")).to_contain_text(written)
    expect(run(panel, checks)).to_contain_text("Right")
    # the server empties the file before it writes it anew: read it when it says that it is saved
    with page.expect_response(lambda one: one.request.method == "PUT" and path.name in one.url):
        page.keyboard.press("Control+s")
    after = json.loads(path.read_text(encoding="utf-8"))["cells"]
    changed = [one["id"] for one, old in zip(after, before) if one["source"] != old["source"]]
    assert len(after) == len(before) and len(changed) == 1
    assert written in "".join(next(one for one in after if one["id"] == changed[0])["source"])
