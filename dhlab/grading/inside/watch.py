"""Notices calls to the library's own kinematics, by any name and from any thread, while a learner's
function is being called.
"""

import os
import sys
import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager

import dhlab

__all__ = ["library"]

ROOT = os.path.dirname(dhlab.__file__) + os.sep
# rooms and modules that know the right programs
FAST = os.path.join(ROOT, "fast") + os.sep
CLOSED = ("kinematics.py", "symbolic", "geometry", "placing", "doctor", "inverse")
# a function that calls these wants to be unseen
BLINDING = (sys.setprofile, threading.setprofile.__code__)
# a room that loads while a function is watched would look like a call
for name in ("assign_frames", "equivalent", "load", "read_urdf", "symbolic"):
    getattr(dhlab, name)


@contextmanager
def library(own: Sequence[str] | None) -> Iterator[set[str]]:
    """A set that fills with the names of the library's programs that are called within.

    Parameters
    ----------
    own : sequence of str or None
        Names that the exercise asks to write and that therefore count wherever they stand; None:
        the exercise leaves the library free.
    """
    used: set[str] = set()
    written_here = own or ()

    def see(frame, event, argument):
        if event == "call":
            file, name = frame.f_code.co_filename, frame.f_code.co_name
            if file.startswith(FAST):
                used.update(_asked_by(frame))
            elif file.startswith(ROOT) and (_closed(file[len(ROOT) :]) or name in written_here):
                used.add(name)
        called = frame.f_code if event == "call" else argument if event == "c_call" else None
        watching = library.__wrapped__.__code__  # type: ignore[attr-defined]
        if any(called is one for one in BLINDING) and frame.f_code is not watching:
            used.add("setprofile")

    if own is None:
        yield used
        return
    threading.setprofile(see)
    sys.setprofile(see)
    try:
        yield used
    finally:
        unseen = sys.getprofile() is not see
        sys.setprofile(None)
        threading.setprofile(None)  # unseen itself, now
        if unseen:
            used.add("setprofile")


def _closed(path):
    return path.split(os.sep)[0] in CLOSED


def _asked_by(frame):
    """The arm's method that asked for what the fast room does, told instead of what is behind it.
    A frame of compiled code has nobody behind it.
    """
    caller = frame.f_back and frame.f_back.f_code
    if caller is None or caller.co_filename.startswith(FAST) or caller.co_name.startswith("_"):
        return ()
    return (caller.co_name,)
