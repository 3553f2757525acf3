"""Attacks that would read, or reach, what is not their own."""

from corpus import ANY, FULL, first, spy

READ = [
    (
        "reads the room's error file",
        "what an earlier submission printed past Python, through /proc/self/fd/2",
        spy(
            "import os\nos.write(2, b'for the next one')\ntry:\n"
            "    leaked = b'next one' in open('/proc/self/fd/2', 'rb').read()\n"
            "except OSError:\n    pass"
        ),
        FULL,
    ),
    (
        "reads every open file",
        "all descriptors that it inherits, from their beginning",
        spy(
            "import os\nfor fd in range(64):\n    try:\n        os.lseek(fd, 0, 0)\n"
            "        data = os.read(fd, 1 << 20)\n"
            "        leaked = leaked or b'canary' in data or b'student' in data\n"
            "    except OSError:\n        pass"
        ),
        FULL,
    ),
    (
        "reads the mounts",
        "paths of the class, of the key and of the marks in /proc/self",
        spy(
            "import os\nfor name in ('mountinfo', 'environ', 'cmdline', 'maps'):\n    try:\n"
            "        text = open(f'/proc/self/{name}').read()\n"
            "        leaked = leaked or 'teacher.key' in text or FACTS['class'] in text\n"
            "    except OSError:\n        pass"
        ),
        FULL,
    ),
    (
        "looks through its parent",
        "root, working folder and files of the warm parent",
        spy(
            "import os\nfor pid in (1, 2, os.getppid()):\n    for name in ('root', 'cwd', 'fd/0',"
            " 'fd/3'):\n        try:\n            path = f'/proc/{pid}/{name}'\n"
            "            target = os.readlink(path) if name != 'root' else path\n"
            "            leaked = leaked or bool(os.stat(path + FACTS['key']))\n"
            "        except OSError:\n            pass"
        ),
        FULL,
    ),
    (
        "guesses a handle",
        "opens files by handles, without a name",
        spy(
            "import ctypes\nleaked = ctypes.CDLL(None).open_by_handle_at(-100,"
            " ctypes.create_string_buffer(64), 0) >= 0"
        ),
        FULL,
    ),
    (
        "a socket pair and a message",
        "passes its open files to a process outside",
        spy(
            "import ctypes, os\nlibc = ctypes.CDLL(None)\n"
            "leaked = libc.pidfd_open(1, 0) >= 0 or libc.syscall(438, 3, 0, 0) >= 0"
        ),
        FULL,
    ),
    (
        "another number of the same call",
        "the 32-bit numbers of calls, which a filter may have forgotten",
        first(
            "import ctypes\nlibc = ctypes.CDLL(None)\nfor number in (57, 58, 59):\n"
            "    libc.syscall(0x40000000 + number)"
        ),
        ANY,
    ),
    (
        "waits for the next one",
        "locks and watches the library's files for whoever comes after",
        first(
            "import fcntl, numpy\nf = open(numpy.__file__)\n"
            "try: fcntl.flock(f, fcntl.LOCK_EX | fcntl.LOCK_NB)\nexcept OSError: pass"
        ),
        FULL,
    ),
    (
        "asks for what others were given",
        "the numbers of other exercises and students through given",
        spy(
            "from dhlab import course\nleaked = any(key[:2] != '05' for key in course.book.given)"
            " or 'seeds' in vars(course.book)"
        ),
        FULL,
    ),
]
READ += [
    (
        "a signal by way of an open file",
        "makes another process the owner of its files, who is then signalled",
        spy(
            "import ctypes, os\nlibc = ctypes.CDLL(None)\nout, into = os.pipe()\n"
            "for command in (8, 10, 8 + 2**32):\n"
            "    leaked = leaked or libc.fcntl(out, ctypes.c_long(command), os.getppid()) >= 0"
        ),
        FULL,
    ),
    (
        "the same by the older way",
        "FIOSETOWN and SIOCSPGRP of ioctl",
        spy(
            "import ctypes, os, socket\nlibc, pair = ctypes.CDLL(None), socket.socketpair()\n"
            "out = pair[0].fileno()\n"
            "owner = ctypes.byref(ctypes.c_int(os.getppid()))\n"
            "leaked = any(libc.ioctl(out, ctypes.c_long(c), owner) >= 0 for c in"
            " (0x8901, 0x8902, 0x8901 + 2**32))"
        ),
        FULL,
    ),
]
