"""The review as a page on this machine: nobody else can open it, and it asks nobody else."""

import json
import re
import secrets
import threading
from collections.abc import Callable
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any, ClassVar
from urllib.parse import unquote

from ..reports.answered import MOST_PICTURES
from .desk import Desk

__all__ = ["Server", "serve"]

HERE = Path(__file__).parent
PAGES = {
    "": ("page.html", "text/html; charset=utf-8"),
    "review.js": ("review.js", "text/javascript; charset=utf-8"),
    "review.css": ("review.css", "text/css; charset=utf-8"),
}
LARGEST = 100_000  # bytes of a decision
PLACES = [str(place) for place in range(MOST_PICTURES)]
HEADERS = {
    "Content-Security-Policy": (
        "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self';"
        " connect-src 'self'; base-uri"
        " 'none'; form-action 'none'; frame-ancestors 'none'"
    ),
    "Cache-Control": "no-store",
    "Referrer-Policy": "no-referrer",
    "X-Content-Type-Options": "nosniff",
}


def serve(desk: Desk, port: int = 0) -> tuple["Server", str]:
    """(the server, the address to open): bound to this machine, with a token in the address that
    nobody can guess. The caller runs ``serve_forever``, and gives a browser ``once`` of the server:
    others on the machine may read what a program is started with, and that address works one time.

    Parameters
    ----------
    desk : Desk
    port : int
        One that is free when 0.
    """
    token = secrets.token_urlsafe(24)
    lock = threading.Lock()  # one decision after the other

    class Handler(_Handler):
        def answer(self, name: str, given: Any = None) -> Any:
            with lock:
                return _answer(desk, name, given)

    Handler.token = token
    try:
        server = Server(("127.0.0.1", port), Handler)
    except OSError as error:
        raise ValueError(
            f"review: expected a free port, found {port} in use ({error.strerror}); leave --port"
            " out"
        ) from None
    Handler.hosts = frozenset(f"{name}:{server.server_port}" for name in ("127.0.0.1", "localhost"))
    door = f"/{secrets.token_urlsafe(24)}/"
    Handler.doors = {door}
    here = f"http://127.0.0.1:{server.server_port}"
    server.once = f"{here}{door}"
    return server, f"{here}/{token}/"


def _answer(desk, name, given):
    """What is asked for as JSON; None where there is no such thing."""
    if given is not None:
        return desk.save(given) if name == "save" else None
    if name == "class":
        return desk.show()
    if name.startswith("picture/"):
        _, student, exercise, place = (name.split("/") + 4 * [""])[:4]
        return desk.picture(student, exercise, int(place)) if place in PLACES else None
    kind, _, student = name.partition("/")
    return desk.answers(student) if kind == "answers" and student in desk.marks else None


class Server(ThreadingHTTPServer):
    """Serves the review; ``once`` is an address that leads to the page, the first time it is
    opened.
    """

    once = ""
    daemon_threads = True
    request_queue_size = 128  # the teacher does not wait behind others


class _Handler(BaseHTTPRequestHandler):
    token = ""
    hosts: frozenset[str] = frozenset()
    doors: ClassVar[set[str]] = set()
    answer: Callable[..., Any]
    timeout = 60
    server_version, sys_version = "dhlab", ""

    def do_GET(self) -> None:
        if self._opens():
            self._send(303, b"", Location=f"/{self.token}/")
            return
        name = self._name()
        if name in PAGES:
            file, kind = PAGES[name]
            self._send(200, (HERE / file).read_bytes(), kind)
        elif name is not None:
            self._say(lambda: self.answer(name))

    def do_POST(self) -> None:
        name = self._name()
        origin = self.headers.get("Origin", "")
        length = self.headers.get("Content-Length", "")
        if name is None:
            return
        if (
            self.headers.get("Content-Type") != "application/json"
            or (origin and origin.removeprefix("http://") not in self.hosts)
            or not re.fullmatch("[0-9]{1,6}", length)
            or int(length) > LARGEST
        ):
            self._send(400, b'{"error": "expected a decision from this page"}')
            return
        raw = self.rfile.read(int(length))
        self._say(lambda: self.answer(name, json.loads(raw)))

    def _opens(self):
        """Whether this is the address that works once, and the first time."""
        if self.path not in self.doors or self.headers.get("Host") not in self.hosts:
            return False
        try:
            self.doors.remove(self.path)
        except KeyError:  # another was quicker
            return False
        return True

    def _name(self):
        """What is asked for; None, and an answer, where the address is not this page's: another
        site's page may know the port, and neither the token nor this machine's name.
        """
        token, _, name = self.path.removeprefix("/").partition("?")[0].partition("/")
        known = secrets.compare_digest(token.encode(), self.token.encode())
        if known and self.headers.get("Host") in self.hosts:
            return unquote(name)
        self._send(404, b'{"error": "there is nothing here"}')
        return None

    def _say(self, make):
        try:
            told = make()
        except (ValueError, RecursionError) as error:
            self._send(400, json.dumps({"error": str(error)}).encode())
            return
        if isinstance(told, tuple):
            self._send(200, told[1], told[0])
            return
        status = 404 if told is None else 200
        self._send(status, json.dumps(told).encode())

    def _send(self, status, data, kind="application/json", **more):
        self.send_response(status)
        told = {**HEADERS, "Content-Type": kind, "Content-Length": len(data), **more}
        for name, value in told.items():
            self.send_header(name, str(value))
        self.end_headers()
        self.wfile.write(data)

    def log_message(self, format: str, *args: Any) -> None:
        """Nothing: the address has the token in it."""
