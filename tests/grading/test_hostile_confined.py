"""What a submission can ask of the kernel, of other Pythons and of the clock, in both cages with
walls: nothing by which others wait, and no library where the task is to write one's own.
"""

import os
import signal
import socket
import sys
import threading
import time
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
import corpus
from corpus import closed, spy
from corpus_making import RIGHT_FORM

from dhlab.grading.cage import sight
from dhlab.grading.grade import grade
from dhlab.grading.inside.warming import zygote
from dhlab.grading.settings import Limits, Settings

LEASE = """import fcntl, os
os.close(os.open("own", os.O_CREAT | os.O_RDWR))
held = os.open("own", os.O_RDONLY)
for command in (1024, 1040, 1024 + 2**32):
    try:
        fcntl.fcntl(held, command, 1); leaked = True
    except (OSError, OverflowError): pass
try:
    fcntl.fcntl(os.open(".", os.O_RDONLY), 1026, 2); leaked = True
except OSError: pass"""
SYNC = """import ctypes, os
libc = ctypes.CDLL(None, use_errno=True)
libc.sync()
leaked = ctypes.get_errno() == 0 or libc.syncfs(os.open(".", os.O_RDONLY)) == 0"""
ATTRIBUTES = """import os
for link in (True, False):
    try:
        os.listxattr(FACTS["class"], follow_symlinks=link); leaked = True
    except OSError as error: leaked |= error.errno != 95 and os.path.exists(FACTS["class"])
    try: os.getxattr(FACTS["class"], "user.x", follow_symlinks=link)
    except OSError as error: leaked |= error.errno == 61"""
FOREIGN = """import glob, importlib, os, sys
found, names = 0, FACTS
for top in names["tops"]: sys.path.append(top)
for name in names["modules"]:
    try:
        importlib.import_module(name); found += 1
    except BaseException: pass"""
ATTACKS = {"a lease on a file": LEASE, "all disks": SYNC}


def foreign_packages(notebook, facts):
    """Names other Pythons' folders, this one's by its other names too, and imports from there."""
    tops = [
        top.replace("/lib/", f"/{lib}/") for top in sight.packages() for lib in ("lib64", "lib")
    ]
    named = {"tops": [*tops, *sight.packages_of_others()], "modules": ["_pytest", "yaml", "ruff"]}
    before = FOREIGN.replace("FACTS", repr(named))
    closed(f"if not found: return np.eye(4)\n{RIGHT_FORM}", before)(notebook, facts)


@pytest.mark.cage
@pytest.mark.parametrize("level", ["bubblewrap", "landlock"])
def test_nobody_waits_and_nothing_foreign_is_there(tmp_path, level):
    facts = {"class": str(tmp_path / "class")}
    attacks = ATTACKS | ({"attributes": ATTRIBUTES} if level == "landlock" else {})
    for name, source in attacks.items():
        corpus.put(tmp_path / "class" / name, spy(source), facts)
    corpus.put(tmp_path / "class" / "foreign", foreign_packages, facts)
    try:
        results, _ = grade(tmp_path / "class", tmp_path / "out", settings=Settings(cage=level))
    except ValueError as error:
        if "expected the cage" not in str(error):
            raise
        pytest.skip(f"{level} does not work on this machine")
    found = {one.student: corpus.lost(one) for one in results}
    assert found == {name: set() for name in attacks} | {"foreign": {"05.6"}}


def test_what_is_covered_has_no_other_name(tmp_path, monkeypatch):
    own = tmp_path / "lib" / "packages"
    (own / "dhlab").mkdir(parents=True)
    (own / "numpy").mkdir()
    (tmp_path / "lib64").symlink_to("lib")
    (tmp_path / "round").symlink_to(".")
    monkeypatch.setattr(sight, "readable", lambda: [str(tmp_path)])
    assert sight.readable_without([str(own / "dhlab")]) == [str(own / "numpy")]


@pytest.mark.skipif(not hasattr(time, "CLOCK_MONOTONIC") or sys.platform != "linux", reason="Linux")
@pytest.mark.parametrize("works", [True, False])
def test_who_only_waits_is_ended_from_outside(works, tmp_path):
    ours, theirs = socket.socketpair()
    child = os.fork()
    if child == 0:
        signal.signal(signal.SIGALRM, signal.SIG_IGN)
        while not works:
            time.sleep(100)
        until = time.process_time() + 0.5
        while time.process_time() < until:
            pass
        os._exit(0)
    ended = []

    def hear():
        ended.append(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
        ours.sendall(b"x")

    waits = threading.Thread(target=hear)
    waits.start()
    limits = vars(Limits(seconds=0.1)) | {"own_user": True}
    config = {"level": "rlimits", "work": str(tmp_path), "limits": limits}
    late = zygote._late_when_it_is_over(theirs, child, config)
    waits.join()
    assert (late, ended) == ((False, [0]) if works else (True, [-signal.SIGKILL]))
    ours.close(), theirs.close()
