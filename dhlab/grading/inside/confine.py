"""What a submission may not do: limits of the process, Landlock, seccomp. Linux's own calls; where
one is missing the caller is told.

Landlock: kernel documentation, userspace-api/landlock. seccomp through libseccomp, which knows the
numbers of every machine.
"""

import contextlib
import ctypes
import os
import resource
import signal
import sys
from collections.abc import Iterable, Mapping
from ctypes import c_int, c_long, c_uint32, c_uint64
from typing import Any

__all__ = [
    "libseccomp",
    "landlock_version",
    "restrict_files",
    "filter_of_calls",
    "restrict_calls",
    "restrict_resources",
    "look_at_memory",
    "memory_in_use",
    "threads_of_all",
    "no_new_privileges",
    "drop_to",
    "drop_capabilities",
]

LINUX = sys.platform == "linux"
libc: Any = ctypes.CDLL(None, use_errno=True) if LINUX else None

CREATE, ADD_RULE, RESTRICT = 444, 445, 446  # Landlock's calls, the same numbers on every machine
READ = 1 << 2 | 1 << 3  # read a file, list a folder
EXECUTE = 1 << 0
# write, remove folder and file, make folder and file, truncate
WRITE = 1 << 1 | 1 << 4 | 1 << 5 | 1 << 7 | 1 << 8 | 1 << 14
RIGHTS = {1: 13, 2: 14, 3: 15, 4: 15}  # how many rights each version knows; 16 from the fifth on

DENIED = """
socket fork vfork execve execveat kill tkill tgkill rt_sigqueueinfo rt_tgsigqueueinfo pidfd_open
pidfd_send_signal pidfd_getfd ptrace process_vm_readv process_vm_writev process_madvise kcmp
shmget shmat shmctl semget semop semctl msgget msgsnd msgrcv msgctl mq_open mq_unlink memfd_create
memfd_secret mount umount2 pivot_root chroot unshare setns open_tree move_mount fsopen fsconfig
fsmount fspick mount_setattr keyctl add_key request_key bpf perf_event_open userfaultfd
io_uring_setup io_uring_enter io_uring_register open_by_handle_at name_to_handle_at init_module
finit_module delete_module kexec_load kexec_file_load reboot swapon swapoff setpriority
sched_setscheduler sched_setparam sched_setattr sched_setaffinity ioprio_set personality
fanotify_init quotactl acct syslog iopl ioperm mknod mknodat migrate_pages move_pages setuid
setgid setreuid setregid setresuid setresgid setgroups setfsuid setfsgid capset sethostname
setdomainname settimeofday clock_settime clock_adjtime adjtimex lookup_dcookie chown fchown lchown
fchownat link linkat symlink symlinkat
bind connect listen accept accept4 sendmsg sendmmsg inotify_init inotify_init1 inotify_add_watch
""".split()
# where a submission has the grader's own user: no file of that user may change what it is
DENIED_TO_OWN_USER = """
chmod fchmod fchmodat fchmodat2 utime utimes utimensat futimesat setxattr lsetxattr fsetxattr
removexattr lremovexattr fremovexattr
fallocate rename renameat renameat2 openat2 truncate
""".split()
# there nothing is removed, though it looks so: a file that is open and has no name any more would
# take room that nobody can count
UNDONE = "unlink", "unlinkat"
NAMELESS = 0x400000  # O_TMPFILE: a file that never had a name
ONLY_CUT, CUT = 0x203, 0x200  # O_TRUNC with O_RDONLY: a right that Landlock knows from 6.2 on
# kinds of ioctl that set what a file is, or seal it, and want no right to write to it
FLAGS = "f", "X", "v"
# the same by calls that are newer than many a libseccomp; these have one number on every machine:
# setxattrat, removexattrat, file_setattr
NEWER = 463, 466, 469
# other processes named as owners of a file, whom the kernel then signals
OWNERS = {"fcntl": (8, 10, 15), "ioctl": (0x8901, 0x8902)}
ALLOW, DONE, EPERM, ENOSYS = 0x7FFF0000, 0x00050000, 0x00050001, 0x00050026
NOT_EQUAL, MASKED = 1, 7
CLONE_THREAD = 0x10000
INT = 0xFFFFFFFF  # the kernel reads no more of such an argument


class Compare(ctypes.Structure):
    """libseccomp's scmp_arg_cmp: argument number, comparison, two operands."""

    _fields_ = [("arg", ctypes.c_uint), ("op", c_int), ("a", c_uint64), ("b", c_uint64)]


def libseccomp() -> Any:
    """libseccomp, or None where it is not installed."""
    try:
        return ctypes.CDLL("libseccomp.so.2", use_errno=True) if LINUX else None
    except OSError:
        return None


def filter_of_calls(library: Any, own_user: bool = True) -> bytes:
    """The kernel's program for :func:`restrict_calls`, the same for every process: no new process,
    no program, no socket, no signal to anybody, no trick of the kernel. Threads stay possible.
    Where the user is the grader's (not ``own_user``) nothing either that makes files other than
    they look.

    Raises OSError where it cannot be made.
    """
    library.seccomp_init.restype = ctypes.c_void_p
    filter_ = ctypes.c_void_p(library.seccomp_init(c_uint32(ALLOW)))
    if not filter_:
        raise OSError("seccomp_init failed")
    for name in DENIED:
        _rule(library, filter_, EPERM, name)
    if not own_user:
        _keep_files(library, filter_)
    for name, commands in OWNERS.items():
        for command in commands:
            _rule(library, filter_, EPERM, name, Compare(1, MASKED, INT, command))
    # PR_SET_PDEATHSIG, PR_SET_DUMPABLE: that it dies with its parent, and leaves no core to the
    # machine's handler, is not its to take back
    for option in (1, 4):
        _rule(library, filter_, EPERM, "prctl", Compare(0, MASKED, INT, option))
    # half of a pair may write to the other half, and to no socket that has a name
    _rule(library, filter_, EPERM, "sendto", Compare(4, NOT_EQUAL, 0))
    # the C library then takes clone, whose flags can be looked at
    _rule(library, filter_, ENOSYS, "clone3")
    _rule(library, filter_, EPERM, "clone", Compare(0, MASKED, CLONE_THREAD, 0))
    _rule(library, filter_, EPERM, "prlimit64", Compare(0, NOT_EQUAL, 0, 0))
    out, into = os.pipe()  # a few kilobytes, which a pipe holds
    with os.fdopen(out, "rb") as written:
        failed = library.seccomp_export_bpf(filter_, c_int(into))
        os.close(into)
        program = written.read()
    library.seccomp_release(filter_)
    if failed:
        raise OSError("seccomp_export_bpf failed")
    return program


class _Program(ctypes.Structure):
    _fields_ = [("length", ctypes.c_ushort), ("instructions", ctypes.c_char_p)]


def restrict_calls(program: bytes) -> None:
    """From here on only the calls that :func:`filter_of_calls` leaves; it wants
    :func:`no_new_privileges` before. Raises OSError where it cannot be done.
    """
    given = _Program(len(program) // 8, program)  # eight bytes an instruction
    if libc.prctl(22, 2, ctypes.byref(given), 0, 0):  # PR_SET_SECCOMP, SECCOMP_MODE_FILTER
        raise OSError(ctypes.get_errno(), "seccomp")


def _keep_files(library, filter_):
    """Files stay what they look like, and where they can be counted."""
    for name in (*DENIED_TO_OWN_USER, *NEWER):
        _rule(library, filter_, EPERM, name)
    for name in UNDONE:
        _rule(library, filter_, DONE, name)
    for argument, name in ((1, "open"), (2, "openat")):
        _rule(library, filter_, EPERM, name, Compare(argument, MASKED, NAMELESS, NAMELESS))
        _rule(library, filter_, EPERM, name, Compare(argument, MASKED, ONLY_CUT, CUT))
    for kind in FLAGS:
        _rule(library, filter_, EPERM, "ioctl", Compare(1, MASKED, 0xFF00, ord(kind) << 8))


def _rule(library, filter_, action, name, *comparisons):
    number = name
    if isinstance(name, str):
        number = library.seccomp_syscall_resolve_name(name.encode())
    if number < 0:
        return  # a call that this machine does not have needs no rule
    if library.seccomp_rule_add_array(
        filter_,
        c_uint32(action),
        c_int(number),
        ctypes.c_uint(len(comparisons)),
        (Compare * max(1, len(comparisons)))(*comparisons),
    ):
        raise OSError(f"seccomp takes no rule for {name}")


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


def threads_of_all() -> int:
    """How many threads there are on the machine; 0 where the system does not tell."""
    told = (c_long * 16)()
    if not LINUX or libc.sysinfo(told):
        return 0
    return ctypes.c_ushort.from_buffer(told, 10 * ctypes.sizeof(c_long)).value
