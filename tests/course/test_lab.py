"""JupyterLab in Chromium, on a learner's folder: lesson 06 opened, run, an answer given and judged."""

import json
import re
import socket
import subprocess
import time
import urllib.request

import pytest

from dhlab.course import workspace

FLAGS = ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"]


@pytest.fixture
def lab(tmp_path):
    """The address of a JupyterLab on a prepared folder."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    folder = tmp_path / "course"
    workspace.prepare(folder)
    workspace.write_settings(folder)
    command = workspace.lab_command(folder, port=port, browser=False) + ["--IdentityProvider.token=", "--ServerApp.port_retries=0"]
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


def test_lesson_06_runs_in_the_browser(lab, chromium):
    from playwright.sync_api import expect, sync_playwright
    address, folder = lab
    outside = []
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium, args=FLAGS)
        page = browser.new_page(viewport={"width": 1280, "height": 900})
        page.on("request", lambda request: outside.append(request.url) if not re.match(r"(http|ws)s?://127\.0\.0\.1|data:|blob:", request.url) else None)
        page.goto(f"{address}/lab/tree/06-forward-kinematics.ipynb")
        page.get_by_role("heading", name="06 Six axes").wait_for(timeout=60_000)
        page.get_by_role("menuitem", name="Run", exact=True).click()
        page.get_by_text("Run All Cells", exact=True).click()
        expect(page.get_by_text(re.compile(r"^0 of \d+ points$")).first).to_be_attached(timeout=90_000)
        page.screenshot(path=folder.parent / "lesson-06.png")
        browser.close()
    assert outside == []
    assert not (folder / ".dhlab" / "progress.jsonl").exists(), "an untouched lesson leaves nothing in the log"
    assert json.loads((folder / "06-forward-kinematics.ipynb").read_text())["cells"]
