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
        pytest.fail(
            f"waited for {what}; saw the status bar {status}, the cells {prompts}, the errors"
            f" {errors}, the dialogs {dialogs}\n{error}"
        )


def kernel_is_idle(page):
    """The kernel answers. JupyterLab runs only the first cell of all when it does not yet."""
    idle = page.get_by_text("| Idle")
    wait_for(page, "an idle kernel", lambda: idle.wait_for())


def asked_elsewhere(page):
    """A list of what the page will have asked for that is not on this machine."""
    asked = []
    page.on(
        "request",
        lambda request: (
            asked.append(request.url)
            if not re.match(r"(http|ws)s?://127\.0\.0\.1|data:|blob:", request.url)
            else None
        ),
    )
    return asked


def test_lesson_06_runs_in_the_browser(lab, new_page):
    from playwright.sync_api import expect

    address, folder = lab
    page = new_page(viewport={"width": 1280, "height": 900})
    asked = asked_elsewhere(page)
    page.goto(f"{address}/lab/tree/06-forward-kinematics.ipynb")
    heading = page.get_by_role("heading", name="06 Six axes")
    wait_for(page, "the heading of lesson 06", lambda: heading.wait_for())
    kernel_is_idle(page)
    page.get_by_role("menuitem", name="Run", exact=True).click()
    page.get_by_text("Run All Cells", exact=True).click()
    lesson = json.loads((folder / "06-forward-kinematics.ipynb").read_text(encoding="utf-8"))
    cells = sum(cell["cell_type"] == "code" for cell in lesson["cells"])
    # while JupyterLab builds its toolbar there may be two indicators
    ran = page.locator(".jp-Notebook-ExecutionIndicator").filter(has_text=f"Executed {cells} cells")
    wait_for(page, f"{cells} cells that have run", lambda: expect(ran.first).to_be_attached())
    points = page.get_by_text(re.compile(r"^0 of \d+ points$")).first
    wait_for(page, "0 of the points", lambda: expect(points).to_be_attached())
    page.close()
    assert asked == []
    assert not (folder / ".dhlab" / "progress.jsonl").exists(), (
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


def run(page, cell):
    """Run one cell, from 0, and wait until it is done."""
    cells = page.locator(".jp-CodeCell")
    cells.nth(cell).locator(".cm-content").click()
    page.keyboard.press("Shift+Enter")
    done = cells.nth(cell).locator(".jp-InputPrompt", has_text=re.compile(r"\[\d+\]"))
    wait_for(page, f"cell {cell} to be run", lambda: done.wait_for())
    return cells.nth(cell)


def test_explorer_is_moved_by_mouse_keyboard_and_python_and_is_still_there_tomorrow(lab, new_page):
    from playwright.sync_api import expect

    address, folder = lab
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(text) for text in CELLS])
    notebook.metadata["kernelspec"] = {
        "display_name": "Python 3",
        "language": "python",
        "name": "python3",
    }
    nbformat.write(notebook, folder / "explorer.ipynb")
    page = new_page(viewport={"width": 1280, "height": 1400})
    faults = asked_elsewhere(page)
    page.on("pageerror", lambda error: faults.append(str(error)) if "dhlab" in str(error) else None)
    page.goto(f"{address}/lab/workspaces/explorer/tree/explorer.ipynb?reset")
    page.locator(".jp-CodeCell").first.wait_for()
    kernel_is_idle(page)
    run(page, 0)
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
    page.get_by_role("spinbutton", name="Joint 3, degrees, exactly").click()
    page.keyboard.press("Control+a")
    for key in ["-", "1", "2", "Enter", "a", "b", "d", "d", "m"]:
        page.keyboard.press(key)
    expect(page.get_by_role("slider", name="Joint 3, degrees")).to_have_attribute(
        "aria-valuetext", "-12 degrees"
    )
    q = [round(1e4 * np.deg2rad(value)) for value in [*shown, -12]] + [0] * 3
    expect(run(page, 1)).to_contain_text(f"q is {q} table {np.deg2rad(2):.4f} calls True")
    run(page, 2)
    expect(first).to_have_attribute("aria-valuetext", "28.65 degrees")
    expect(page.get_by_role("slider", name="Joint 6, degrees")).to_have_attribute(
        "aria-valuetext", "-14.32 degrees"
    )
    assert page.locator(".jp-CodeCell").count() == len(CELLS), (
        "keys in the view are no commands of the notebook"
    )
    run(page, 3)
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
    expect(run(page, 4)).to_contain_text("placed [0] None")
    page.keyboard.press("Control+s")
    page.wait_for_function(
        "() => !document.querySelector('.lm-TabBar-tab.lm-mod-current.jp-mod-dirty')"
    )
    page.get_by_role("menuitem", name="Kernel", exact=True).click()
    page.get_by_text("Shut Down Kernel", exact=True).click()
    page.get_by_text("No Kernel").first.wait_for()
    page.close()
    page = new_page(viewport={"width": 1280, "height": 1400})
    asked = asked_elsewhere(page)
    page.goto(f"{address}/lab/workspaces/again/tree/explorer.ipynb?reset")
    kernel_is_idle(page)
    first = page.get_by_role("slider", name="Joint 1, degrees")
    expect(first).to_have_attribute("aria-valuetext", "28.65 degrees")
    first.press("ArrowRight")
    expect(first).to_have_attribute("aria-valuetext", "29 degrees")
    page.get_by_role("button", name="Start over").click()
    expect(page.get_by_text("Python has not answered. Run the cell above again")).to_be_visible()
    page.close()
    assert faults == asked == []


def test_a_card_that_is_clicked_is_written_into_its_own_cell_alone(lab, new_page):
    from playwright.sync_api import expect

    address, folder = lab
    path = folder / "01-frames.ipynb"
    before = json.loads(path.read_text(encoding="utf-8"))["cells"]
    codes = ["".join(cell["source"]) for cell in before if cell["cell_type"] == "code"]
    checks = next(k for k, text in enumerate(codes) if text.startswith('check("01.6"'))
    page = new_page(viewport={"width": 1280, "height": 1400})
    page.goto(f"{address}/lab/workspaces/cards/tree/{path.name}?reset")
    page.locator(".jp-CodeCell").first.wait_for()
    kernel_is_idle(page)
    for cell in (0, checks - 1, checks):
        run(page, cell)
    page.get_by_role("radio", name="the controller reported the flange").check(force=True)
    expect(page.get_by_text("is not in the notebook yet").first).to_be_visible()
    cell = run(page, checks - 1)
    expect(cell.locator(".cm-content")).to_contain_text('why = "c"')
    expect(run(page, checks)).to_contain_text("Right")
    # the server empties the file before it writes it anew: read it when it says that it is saved
    with page.expect_response(lambda one: one.request.method == "PUT" and path.name in one.url):
        page.keyboard.press("Control+s")
    after = json.loads(path.read_text(encoding="utf-8"))["cells"]
    changed = [one["id"] for one, old in zip(after, before) if one["source"] != old["source"]]
    assert len(after) == len(before) and len(changed) == 1
    assert 'why = "c"' in "".join(next(one for one in after if one["id"] == changed[0])["source"])
    page.close()
