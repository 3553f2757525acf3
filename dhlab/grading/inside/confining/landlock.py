"""Which files a submission may read and write: Landlock (kernel documentation,
userspace-api/landlock).
"""

import ctypes
import os
from collections.abc import Iterable
from ctypes import c_long, c_uint64

from .process import LINUX, libc, no_new_privileges

__all__ = ["landlock_version", "restrict_files"]

CREATE, ADD_RULE, RESTRICT = 444, 445, 446  # Landlock's calls, the same numbers on every machine
READ = 1 << 2 | 1 << 3  # read a file, list a folder
EXECUTE = 1 << 0
# write, remove folder and file, make folder and file, truncate
WRITE = 1 << 1 | 1 << 4 | 1 << 5 | 1 << 7 | 1 << 8 | 1 << 14
RIGHTS = {1: 13, 2: 14, 3: 15, 4: 15}  # how many rights each version knows; 16 from the fifth on


def landlock_version() -> int:
    """Landlock's version, 0 where the kernel has none."""
    return max(0, libc.syscall(c_long(CREATE), None, c_long(0), c_long(1))) if LINUX else 0


def restrict_files(readable: Iterable[str], writable: Iterable[str]) -> None:
    """From here on only these files and folders can be read, and only those written to. Raises
    OSError where it cannot be done.
    """
    version = landlock_version()
    handled = (1 << RIGHTS.get(version, 16)) - 1
    # files; TCP; abstract sockets and signals
    attributes = (c_uint64 * 3)(handled, 3 if version >= 4 else 0, 3 if version >= 6 else 0)
    size = 8 if version < 4 else 16 if version < 6 else 24
    rules = libc.syscall(c_long(CREATE), attributes, c_long(size), c_long(0))
    if rules < 0:
        raise OSError(ctypes.get_errno(), "Landlock")
    for path in readable:
        _allow(rules, path, READ | EXECUTE)
    for path in writable:
        _allow(rules, path, (READ | WRITE) & handled)
    no_new_privileges()
    failed = libc.syscall(c_long(RESTRICT), c_long(rules), c_long(0))
    os.close(rules)
    if failed:
        raise OSError(ctypes.get_errno(), "Landlock")


class _Beneath(ctypes.Structure):
    _pack_ = 1
    _fields_ = [("allowed", c_uint64), ("parent", ctypes.c_int32)]


def _allow(rules, path, rights):
    try:
        handle = os.open(path, os.O_PATH | os.O_CLOEXEC)
    except OSError:
        return  # what is not there needs no rule
    if not os.path.isdir(path):
        rights &= EXECUTE | 1 << 1 | 1 << 2 | 1 << 14  # what a file can have
    rule = _Beneath(rights, handle)
    libc.syscall(c_long(ADD_RULE), c_long(rules), c_long(1), ctypes.byref(rule), c_long(0))
    os.close(handle)
