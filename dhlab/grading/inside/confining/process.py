"""What a process may use and become: limits of its memory and time, its user, its rights; and how
much it and the machine have in use.
"""

import contextlib
import ctypes
import os
import resource
import signal
import sys
import time
from collections.abc import Mapping
from ctypes import c_long, c_uint32
from typing import Any

__all__ = [
    "restrict_resources",
    "look_at_memory",
    "memory_in_use",
    "give_back",
    "threads_of_all",
    "seconds_of",
    "no_new_privileges",
    "drop_to",
    "drop_capabilities",
]

LINUX = sys.platform == "linux"
libc: Any = ctypes.CDLL(None, use_errno=True) if LINUX else None


def no_new_privileges() -> None:
    """No program started from here can gain rights; nor can another process of the same user look
    into this one; it dies with its parent.
    """
    if LINUX:
        libc.prctl(38, 1, 0, 0, 0)  # PR_SET_NO_NEW_PRIVS
        libc.prctl(4, 0, 0, 0, 0)  # PR_SET_DUMPABLE
        libc.prctl(1, signal.SIGKILL, 0, 0, 0)  # PR_SET_PDEATHSIG


def drop_to(user: int) -> None:
    """Become another user, for good."""
    os.setgroups([])
    os.setresgid(user, user, user)
    os.setresuid(user, user, user)


def drop_capabilities() -> None:
    """root without any of root's rights: what it owns it can still read, and nothing more."""
    if LINUX:
        for capability in range(64):
            libc.prctl(24, capability, 0, 0, 0)  # PR_CAPBSET_DROP
        libc.capset((c_uint32 * 2)(0x20080522, 0), (c_uint32 * 6)())


def restrict_resources(limits: Mapping[str, Any]) -> None:
    """Memory above what is in use now, processor time, size of a file, open files, and, where the
    user is the cage's own, threads.
    """
    megabyte = 1 << 20
    wanted = {
        "RLIMIT_AS": limits["in_use"] + limits["memory_mb"] * megabyte,
        "RLIMIT_CPU": int(limits["seconds"]) + 5,
        "RLIMIT_FSIZE": limits["files_mb"] * megabyte,
        "RLIMIT_NOFILE": 128,
        "RLIMIT_CORE": 0,
        "RLIMIT_MSGQUEUE": 0,
    }
    if limits.get("own_user"):
        wanted["RLIMIT_NPROC"] = limits["threads"]
    for name, value in wanted.items():
        if hasattr(resource, name):
            with contextlib.suppress(ValueError, OSError):
                resource.setrlimit(getattr(resource, name), (value, value))


_size: list[int] = []  # an open file that tells how large this process is


def look_at_memory() -> None:
    """Open what tells how much memory this process has; later no such file may be opened."""
    with contextlib.suppress(OSError):
        _size.append(os.open("/proc/self/statm", os.O_RDONLY | os.O_CLOEXEC))


def memory_in_use() -> int:
    """Bytes of memory that this process has; a gigabyte where the system does not tell."""
    try:
        return int(os.pread(_size[0], 100, 0).split()[0]) * resource.getpagesize()
    except (OSError, IndexError, ValueError):
        return 1 << 30


def give_back() -> None:
    """Give back to the system what loading has left free, where the C library can (glibc)."""
    if hasattr(libc, "malloc_trim"):
        libc.malloc_trim(0)


def threads_of_all() -> int:
    """How many threads there are on the machine; 0 where the system does not tell."""
    told = (c_long * 16)()
    if not LINUX or libc.sysinfo(told):
        return 0
    return ctypes.c_ushort.from_buffer(told, 10 * ctypes.sizeof(c_long)).value


def seconds_of(process: int, unknown: float) -> float:
    """The seconds of processor that another process has used; ``unknown`` where the system does not
    tell.
    """
    try:
        return time.clock_gettime((~process << 3) | 2)  # its own clock, of all its threads
    except (OSError, AttributeError):
        return unknown
