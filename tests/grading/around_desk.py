"""Attacks on the review: other sites, odd and slow requests, script in what students write, ids and
comments as YAML.
"""

import contextlib
import http.client
import json
import socket
import sys
import threading
from urllib.parse import urlsplit

from dhlab.grading.intake.roster import Student
from dhlab.grading.reports.answered import keep_answers, own_answers
from dhlab.grading.results.decisions import read_decisions
from dhlab.grading.results.gradebook import Gradebook
from dhlab.grading.results.marks import GRADED, Graded, Mark
from dhlab.grading.reviewing.desk import Desk
from dhlab.grading.reviewing.server import serve

SCRIPT = "</pre><script>alert(1)</script><img src=x onerror=alert(1)>"
IDS = ("null", "true", "~", "2026-11-27", "1e5", "a: {b", "- x", "#x", "&a", "*a", "ada")


@contextlib.contextmanager
def desk(top, students=("ada", "mallory")):
    """(the folder, the address of its review)."""
    book = Gradebook(top)
    with book.alone():
        for student in students:
            graded = Graded(student, "a.ipynb", GRADED, (Mark("05.2", "right", 1, 1, file="a"),))
            book.write(graded)
            cells = [{"source": SCRIPT}, {"source": 'check("05.2", x)'}]
            notebook = {"cells": [{"cell_type": "code", **cell} for cell in cells]}
            keep_answers(graded, {("a", ""): own_answers(notebook)}, top)
    server, address = serve(Desk(top, [Student("mallory", SCRIPT)]))
    crashed = []  # who hangs up is no error of the server's
    server.handle_error = lambda *_: crashed.append(sys.exception())
    threading.Thread(target=server.serve_forever, daemon=True).start()
    try:
        yield top, address
        own = [error for error in crashed if not isinstance(error, OSError)]
        assert not own, f"{len(own)} requests ended in an error of the server's own: {own[:2]}"
    finally:
        server.shutdown()
        server.server_close()


def asked(address, path, method="GET", body=None, headers=None):
    """(status, text, headers); 0 where nothing came back."""
    parts = urlsplit(address)
    connection = http.client.HTTPConnection(parts.hostname, parts.port, timeout=60)
    try:
        connection.request(method, path, body, headers or {})
        reply = connection.getresponse()
        return reply.status, reply.read().decode("utf-8", "replace"), dict(reply.getheaders())
    except (http.client.HTTPException, OSError):
        return 0, "", {}
    finally:
        connection.close()


def save(address, given, **headers):
    body = given if isinstance(given, bytes) else json.dumps(given)
    sent = {"Content-Type": "application/json"} | headers
    return asked(address, urlsplit(address).path + "save", "POST", body, sent)


def another_site(top):
    """A page elsewhere that knows the port, and even one that knows the address."""
    given = {"student": "mallory", "exercise": "05.2", "points": 1, "comment": "forged"}
    with desk(top) as (folder, address):
        path, port = urlsplit(address).path, urlsplit(address).port
        for origin in (
            "null",
            "http://evil.example",
            f"https://127.0.0.1:{port}",
            "http://localhost",
        ):
            assert save(address, given, Origin=origin)[0] == 400
        for host in ("evil.example", f"127.0.0.1.evil.example:{port}", f"localhost:{port + 1}", ""):
            assert save(address, given, Host=host)[0] == 404
            assert asked(address, path + "class", headers={"Host": host})[0] == 404
        for kind in ("text/plain", "application/x-www-form-urlencoded", "application/json; x=1"):
            assert save(address, given, **{"Content-Type": kind})[0] == 400
        for method in ("OPTIONS", "PUT", "HEAD", "TRACE"):
            status, _, headers = asked(address, path + "save", method, headers={"Origin": "null"})
            assert status >= 400 and not any(h.startswith("Access-Control") for h in headers)
        for odd in (
            "/..%2f" + path,
            path + "answers/..%2f..%2fdecisions",
            path + "%2e%2e/class",
            path + "picture/../../../etc/passwd/0",
            "//evil.example" + path,
        ):
            assert asked(address, odd)[0] in (400, 404)
        assert not (folder / "decisions.yaml").exists()


def odd_requests(top):
    """None of them stops the desk, or ends in an error that nobody expects."""
    with desk(top) as (folder, address):
        path = urlsplit(address).path
        for given in (
            {"student": "ada", "exercise": ["05.2"]},
            {"student": "ada", "exercise": {}},
            {"student": ["ada"], "hold": "x"},
            {"student": "ada", "exercise": "05.2", "points": float("nan")},
            {"student": "ada", "exercise": "05.2", "points": 10**400},
            {"student": "ada", "exercise": "05.2", "ticks": {"a": 1}},
            {"student": "ada", "hold": "\ud800"},
            b"[" * 50_000,
            b"\xff\xfe",
            b"9" * 5000,
        ):
            assert save(address, given)[0] in (200, 400), given
        for length in ("²", "-1", "1" * 5000, "1_0"):
            head = {"Content-Length": length.encode("latin-1")}
            assert save(address, b"{}", **head)[0] == 400, length
        for odd in ("picture/ada/05.2/" + "9" * 5000, "picture/ada", "answers/%e9", "%ff%00"):
            assert asked(address, path + odd)[0] in (400, 404), odd
        assert save(address, {"student": "ada", "hold": "we talk"})[0] == 200
        assert read_decisions(folder / "decisions.yaml").students["ada"].hold == "we talk"


def slow_bodies(top):
    """Fifty that send a letter and wait; the teacher's own decision is saved meanwhile."""
    with desk(top) as (folder, address), contextlib.ExitStack() as held:
        parts = urlsplit(address)
        for k in range(50):
            one = held.enter_context(socket.create_connection((parts.hostname, parts.port), 60))
            path = parts.path if k % 2 else "/"
            one.sendall(
                f"POST {path}save HTTP/1.1\r\nHost: {parts.netloc}\r\nContent-Type:"
                f" application/json\r\nContent-Length: 90000\r\n\r\n{{".encode()
            )
        assert save(address, {"student": "ada", "hold": "we talk"})[0] == 200
        assert read_decisions(folder / "decisions.yaml").students["ada"].hold == "we talk"


def script_in_what_is_shown(top):
    """Answers, names, comments and ids hold script: they are sent as JSON, never as a page."""
    with desk(top) as (_, address):
        path = urlsplit(address).path
        given = {"student": "mallory", "exercise": "05.2", "points": 1, "comment": SCRIPT}
        replies = [asked(address, path + name) for name in ("class", "answers/mallory")]
        for status, text, headers in (*replies, save(address, given)):
            assert status == 200 and "<script>" in text
            assert headers["Content-Type"] == "application/json"
            assert headers["X-Content-Type-Options"] == "nosniff"
            assert "script-src 'self'" in headers["Content-Security-Policy"]
        for name in ("", "review.js"):
            assert "<script>alert" not in asked(address, path + name)[1]


def ids_and_comments_as_yaml(top):
    """What is decided of one is decided of nobody else, whatever their ids and the comment are."""
    comment = 'x"\n  ada:\n    hold: no\n--- !!python/object &a *a \u202e\x1b[2J #'
    with desk(top, IDS) as (folder, address):
        for student in IDS:
            given = {"student": student, "exercise": "05.2", "points": 0.5, "comment": comment}
            assert save(address, given)[0] == 200, student
            assert save(address, {"student": student, "hold": "once more"})[0] == 200
        for student in IDS:
            assert save(address, {"student": student, "hold": f"{student}, 2"})[0] == 200
        known = read_decisions(folder / "decisions.yaml").students
        assert list(known) == list(IDS)
        for student, own in known.items():
            assert (own.hold, own.exercises["05.2"].points) == (f"{student}, 2", 0.5)
            said = own.exercises["05.2"].comment
            assert said.replace("\n", "").isprintable() and said.startswith('x"')


DESK = [
    ("another site at the desk", another_site),
    ("odd requests", odd_requests),
    ("slow bodies", slow_bodies),
    ("script in what is shown", script_in_what_is_shown),
    ("ids and comments as YAML", ids_and_comments_as_yaml),
]
