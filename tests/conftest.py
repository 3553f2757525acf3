"""What every test may use: optional judges that are skipped by name where they cannot be had, and
never in CI.
"""

import importlib
import os
import platform
import shutil
import sys

import pytest

FLAGS = [
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
]
# pybullet has wheels up to Python 3.11 only; the others are asked for on Linux
WANTED = {
    "pinocchio": sys.platform == "linux",
    "roboticstoolbox": sys.platform == "linux",
    "pybullet": sys.platform == "linux" and sys.version_info < (3, 12),
    "trac_ik": sys.platform == "linux" and platform.machine() == "x86_64",
}


@pytest.fixture
def judge():
    """``judge("pinocchio")`` is that module; the test is skipped, saying so, where it is not
    installed.
    """

    def get(name):
        try:
            return importlib.import_module(name)
        except ImportError:
            if os.environ.get("CI") and WANTED.get(name, True):
                pytest.fail(f"CI needs {name}: install the [oracles] extra")
            pytest.skip(f"{name} is not installed, so nothing was compared with it")

    return get


@pytest.fixture(scope="session")
def chromium():
    """The path of a Chromium; tests that look at pages are skipped, saying so, where there is
    none.
    """
    path = (
        shutil.which("chromium")
        or shutil.which("chromium-browser")
        or shutil.which("google-chrome")
    )
    if path is None:
        if os.environ.get("CI"):
            pytest.fail("CI needs Chromium: apt-get install chromium")
        pytest.skip("no Chromium here, so no page was looked at")
    return path


@pytest.fixture(scope="module")
def browser(chromium):
    """A Chromium for one file of tests; Playwright cannot be started twice in a process, and its
    loop must not outlive them.
    """
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium, args=FLAGS)
        yield browser
        browser.close()
