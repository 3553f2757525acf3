"""Which of the kernel's calls a submission may make: seccomp, through libseccomp, which knows the
numbers of every machine.
"""

import ctypes
import os
from ctypes import c_int, c_uint32, c_uint64
from typing import Any

from .process import LINUX, libc

__all__ = ["libseccomp", "filter_of_calls", "restrict_calls"]

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
sync syncfs
""".split()
# F_SETLEASE, F_NOTIFY, F_SETDELEG of fcntl: who opens a file of one's own user, the library's too,
# would wait for who has a lease on it
LEASES = 1024, 1026, 1040
# where a submission has the grader's own user: no file of that user may change what it is
DENIED_TO_OWN_USER = """
chmod fchmod fchmodat fchmodat2 utime utimes utimensat futimesat setxattr lsetxattr fsetxattr
removexattr lremovexattr fremovexattr
fallocate rename renameat renameat2 openat2 truncate
""".split()
# there nothing is removed, though it looks so: a file that is open and has no name any more would
# take room that nobody can count
UNDONE = "unlink", "unlinkat"
# attributes of any file, read by its name, of which Landlock knows nothing: a browser keeps there
# where a download came from. The last two are getxattrat and listxattrat.
UNKNOWN = "getxattr", "lgetxattr", "listxattr", "llistxattr", 464, 465
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
ENOTSUP = 0x0005005F  # what a file system without attributes says
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
    for command in LEASES:
        _rule(library, filter_, EPERM, "fcntl", Compare(1, MASKED, INT, command))
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
    :func:`.process.no_new_privileges` before. Raises OSError where it cannot be done.
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
    for name in UNKNOWN:
        _rule(library, filter_, ENOTSUP, name)
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
