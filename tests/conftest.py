"""What every test may use, what each test needs (markers), which tests share a set-up (groups), and
from which seeds numbers are drawn.
"""

import gc
import importlib
import os
import platform
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from draws import ALL
from hypothesis import currently_in_test_context, settings
from hypothesis.database import DirectoryBasedExampleDatabase
from system_packages import CHROMIUMS, WINDOWLESS

# numba joins in once batches have kept a process busy, and differs by rounding: when that is would
# depend on which tests ran before
os.environ.setdefault("DHLAB_NUMBA", "0")
# a test for each core: threads in products of matrices would wait for work in turns that the other
# tests need; read by the workers and by all that a test starts
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

HERE = Path(__file__).parent
FOUND = HERE.parent / ".fuzz"  # where ``make fuzz`` keeps what it finds
SEED = os.environ.get("DHLAB_SEED")  # set by ``make fuzz`` alone
FLAGS = [
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--webgl-antialiasing-mode=none",  # solids are drawn without a graphics card, in half the time
]
# pybullet has wheels up to Python 3.11 only; the others are asked for on Linux
WANTED = {
    "pinocchio": sys.platform == "linux",
    "roboticstoolbox": sys.platform == "linux",
    "pybullet": sys.platform == "linux" and sys.version_info < (3, 12),
    "trac_ik": sys.platform == "linux" and platform.machine() == "x86_64",
}

# ---- draws: the same in every run, and others under ``make fuzz``

settings.register_profile(
    "same", max_examples=40 if ALL else 20, derandomize=True, database=None, deadline=None
)
settings.register_profile(
    "fuzz",
    max_examples=400,
    database=DirectoryBasedExampleDatabase(FOUND / "hypothesis"),
    deadline=None,
)
settings.load_profile("fuzz" if SEED else "same")


def pytest_configure(config):
    """Under ``make fuzz``, seeds in the tests' own files mean other numbers. A pytest in which
    xdist leaves the groups out, which it does without a word, is refused.
    """
    if SEED:
        np.random.default_rng = _shifted(np.random.default_rng)
    if config.getoption("dist", "no") == "loadgroup" and not hasattr(pytest.Item, "_nodeid"):
        raise pytest.UsageError(
            f"expected pytest before 9.2, found {pytest.__version__}, where pytest-xdist does not"
            " keep groups together; install what constraints.txt names, as make does"
        )


@pytest.hookimpl(wrapper=True)
def pytest_collection():
    """All that is collected stays to the end: to look again and again, then and later, what of it
    may go would take a third of the time.
    """
    gc.disable()
    try:
        return (yield)
    finally:
        gc.freeze()
        gc.enable()


def _shifted(default_rng):
    def shifted(seed=None):
        drawn_here = Path(sys._getframe(1).f_code.co_filename).is_relative_to(HERE)
        # what hypothesis draws is new already, and must be found again by its seed
        if drawn_here and isinstance(seed, int | np.integer) and not currently_in_test_context():
            seed = (int(seed), int(SEED))
        return default_rng(seed)

    return shifted


def pytest_terminal_summary(terminalreporter):
    """What failed under ``make fuzz`` is written down with the seed that shows it again."""
    if not SEED or hasattr(terminalreporter.config, "workerinput"):
        return
    failed = [report.nodeid for report in terminalreporter.stats.get("failed", [])]
    if failed:
        FOUND.mkdir(exist_ok=True)
        with open(FOUND / "failed.txt", "a", encoding="utf-8") as kept:
            kept.writelines(f"DHLAB_SEED={SEED} {test}\n" for test in failed)
    terminalreporter.write_line(
        f"Numbers were drawn with DHLAB_SEED={SEED}; {len(failed)} tests failed. What is found is"
        f" kept in {FOUND.name}/ and tried first the next time; make fuzz DHLAB_SEED={SEED} shows"
        " it again."
    )


# ---- markers and groups

# a test that uses one of these fixtures opens what stands on the right
NEEDS = {
    "chromium": "browser",
    "graded": "cage",
    "reference": "cage",
    "simulated": "cage",
    "ours": "cage",
    "lab": "notebook",
    "site": "notebook",
    "course": "notebook",
    "clone": "notebook",
    "packages": "slow",
    "built": "slow",
}
# set up once a session: the tests of all files that use one of these run in one process
SHARED = ("site", "packages", "built")
COSTLY = frozenset(NEEDS.values())


@pytest.hookimpl(tryfirst=True)  # before xdist reads the groups
def pytest_collection_modifyitems(items):
    """Mark tests by what they open, keep those together that share a set-up, and put the longest
    first: what is shared by files, by the tests of a file, then the other costly ones, which are
    short, so that at the end no core is left without work.
    """
    when = {}
    for item in items:
        for name in NEEDS.keys() & getattr(item, "fixturenames", ()):
            item.add_marker(NEEDS[name])
        if item.path.suffix == ".ipynb":
            item.add_marker("notebook")
        costly = not COSTLY.isdisjoint(mark.name for mark in item.iter_markers())
        group = _group(item, costly)
        if group:
            item.add_marker(pytest.mark.xdist_group(group))
        when[item] = (2 if group is None else 0 if group in SHARED else 1) if costly else 3
    items.sort(key=when.get)


def _group(item, costly):
    """The tests that run in one process: the cells of a notebook, the examples of a module, the
    users of a fixture that lives longer than a test, and the quick tests of one file, which share
    what is worked out once (arms that are loaded, letters that are drawn).
    """
    if not (isinstance(item, pytest.Function) and costly):
        return str(item.path)
    fixtures = item._fixtureinfo.name2fixturedefs
    shared = [name for name in SHARED if name in fixtures]
    long_lived = any(each[-1].scope == "module" for each in fixtures.values())
    return shared[0] if shared else str(item.path) if long_lived else None


# ---- fixtures


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
    """The path of a Chromium, of one without windows where there is one: the same pages take a
    third less of the processor in it. Tests that look at pages are skipped, saying so, where there
    is none.
    """
    return _first_of(WINDOWLESS, *CHROMIUMS)


@pytest.fixture(scope="session")
def whole_chromium():
    """The path of a Chromium that tells a page when the pointer leaves something; the one without
    windows does not.
    """
    return _first_of(*CHROMIUMS)


def _first_of(*names):
    """The path of the first of these programs that is here."""
    path = next(filter(None, map(shutil.which, names)), None)
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


@pytest.fixture(scope="session")
def packages(tmp_path_factory):
    """A copy of the explorer's source with what its lock file names; skipped, saying so, where npm
    is not there or has no registry.
    """
    if shutil.which("npm") is None:
        _without("npm is not installed")
    folder = tmp_path_factory.mktemp("npm") / "js"
    shutil.copytree(
        HERE.parent / "dhlab/view/explorer/js",
        folder,
        ignore=shutil.ignore_patterns("node_modules"),
    )
    done = subprocess.run(
        ["npm", "ci", "--ignore-scripts", "--no-audit", "--no-fund"],
        cwd=folder,
        capture_output=True,
        text=True,
    )
    if done.returncode:
        _without(f"npm ci failed: {done.stderr.strip().splitlines()[-1:]}")
    return folder


def _without(reason):
    if os.environ.get("CI"):
        pytest.fail(f"CI needs npm and a registry: {reason}")
    pytest.skip(
        f"{reason}, so the explorer's module was not built again and no page was checked with axe"
    )


@pytest.fixture(scope="module")
def new_page(browser):
    """``new_page(…)`` is a page on which what is waited for has four minutes to happen: what takes
    longer does not happen, whatever else the machine does. Pages of the same settings share a
    context, in which one more stays open: a new window costs Chromium more than what most show.
    """
    from playwright.sync_api import expect

    expect.set_options(timeout=240_000)
    contexts = {}

    def make(**settings):
        key = repr(settings)
        if key not in contexts:
            contexts[key] = browser.new_context(**settings)
            contexts[key].set_default_timeout(240_000)
            contexts[key].new_page()
        return contexts[key].new_page()

    yield make
    for context in contexts.values():
        context.close()  # what is drawn on its pages costs while others are looked at


@pytest.fixture(scope="session")
def site(tmp_path_factory):
    """The folder of the pages, built as ``make site`` does; beside it stand the lessons as they
    were run for it, in ``executed``, and the class edition, in ``class``.
    """
    out = tmp_path_factory.mktemp("site")
    build = [sys.executable, HERE.parent / "docs" / "build.py", "--both", out]
    done = subprocess.run(build, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    return out / "html"
