"""The built site on a free port of this machine, and a Chromium to open it with."""

import argparse
import contextlib
import shutil
import threading
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

from playwright.sync_api import sync_playwright

__all__ = ["ROOT", "Quiet", "arguments", "chromium", "served"]

ROOT = Path(__file__).resolve().parents[1]
FLAGS = [
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
]


def arguments(words):
    """A parser that knows where the site lies."""
    parser = argparse.ArgumentParser(description=words.partition("\n\n")[0])
    parser.add_argument(
        "--html",
        type=Path,
        default=ROOT / "docs" / "_build" / "html",
        help="the site, as make site LIVE=1 builds it",
    )
    return parser


class Quiet(SimpleHTTPRequestHandler):
    """Keeps connections open, as hosts do, and says nothing."""

    protocol_version = "HTTP/1.1"
    sent = 0  # bytes of files, since the module was loaded

    def log_message(self, *_):
        pass

    def copyfile(self, source, outputfile):
        data = source.read()
        Quiet.sent += len(data)
        outputfile.write(data)


@contextlib.contextmanager
def served(folder):
    """The address of a folder's files while the block runs."""
    if not (folder / "live").is_dir():
        raise SystemExit(f"expected a site with Python in {folder}, found none: make site LIVE=1")
    with ThreadingHTTPServer(("127.0.0.1", 0), partial(Quiet, directory=folder)) as server:
        server.daemon_threads = True
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}"
        server.shutdown()


@contextlib.contextmanager
def chromium(profile=None):
    """A browser that knows no page yet; with a folder for its profile one context of it, which
    keeps files on disk as a visitor's browser does.
    """
    path = shutil.which("chromium") or shutil.which("google-chrome")
    with sync_playwright() as playwright:
        start = playwright.chromium
        known = {"executable_path": path, "args": FLAGS}
        browser = (
            start.launch_persistent_context(profile, **known) if profile else start.launch(**known)
        )
        yield browser
        browser.close()
