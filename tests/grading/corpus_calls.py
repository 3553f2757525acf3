"""Attacks by what the kernel's filter and our own reading leave open: sockets that were a pair,
watches, flags of files, cores, threads without number, metadata of odd types; and honest notebooks
in whatever dress numpy and Python give them.
"""

from corpus import ANY, FULL, answer, changed, closed, code, first, spy
from corpus_making import RIGHT_FORM, cells, holding

FORM = "".join(f"    {line}\n" for line in RIGHT_FORM.splitlines())
CALLS = [
    (
        "a letter to the machine",
        "datagrams of a socket pair, sent by name to a socket outside, with open files in them",
        spy(
            "import array, socket\nplace = FACTS['class'] + '.socket'\n"
            "def by_name(one): one.sendto(b'x', place)\n"
            "def connected(one): one.connect(place); one.send(b'x')\n"
            "def with_files(one):\n    files = [(socket.SOL_SOCKET, socket.SCM_RIGHTS,"
            " array.array('i', [0]))]\n    one.sendmsg([b'x'], files, 0, place)\n"
            "for way in (by_name, connected, with_files):\n"
            "    one, other = socket.socketpair(socket.AF_UNIX, socket.SOCK_DGRAM)\n"
            "    try: way(one); leaked = True\n    except OSError: pass"
        ),
        FULL,
    ),
    (
        "a watch on the class",
        "inotify tells the names of the files that are opened in a folder, readable or not",
        spy(
            "import ctypes\nlibc = ctypes.CDLL(None)\nwatch = libc.inotify_init1(0o4000)\n"
            "leaked = libc.inotify_add_watch(watch, FACTS['class'].encode(), 0x20) >= 0"
        ),
        FULL,
    ),
    (
        "flags of a file",
        "ioctl sets what a file is (immutable, compressed, sealed), and wants no right to write",
        spy(
            "import ctypes, os\nlibc = ctypes.CDLL(None)\nfd = os.open(np.__file__, os.O_RDONLY)\n"
            "for get, put in ((0x80086601, 0x40086602), (0x801C581F, 0x401C5820)):\n"
            "    data = ctypes.create_string_buffer(64)\n"
            "    if libc.ioctl(fd, ctypes.c_ulong(get), data) == 0:\n"
            "        leaked |= libc.ioctl(fd, ctypes.c_ulong(put), data) == 0"
        ),
        FULL,
    ),
    (
        "a core for the machine",
        "says that its memory may be dumped, which a core handler does whatever the limits",
        spy(
            "import ctypes\nlibc = ctypes.CDLL(None)\nlibc.prctl(4, 1, 0, 0, 0)\n"
            "leaked = libc.prctl(3, 0, 0, 0, 0) == 1"
        ),
        FULL,
    ),
    (
        "cut off by an older kernel",
        "truncate by name, and by opening only to read: Landlock before Linux 6.2 lets it",
        spy(
            "import ctypes, errno, os\nlibc = ctypes.CDLL(None, use_errno=True)\n"
            "libc.truncate(FACTS['key'].encode(), ctypes.c_long(3))\n"
            "leaked = ctypes.get_errno() == errno.EACCES\n"
            "try: os.open(FACTS['key'], os.O_RDONLY | os.O_TRUNC)\n"
            "except OSError as error: leaked |= error.errno == errno.EACCES\n"
            "else: leaked = True"
        ),
        FULL,
    ),
    (
        "threads without number",
        "sleeping threads with stacks of 32 KB, of which no limit of memory counts many",
        holding(
            "import threading, time\nthreading.stack_size(32768)\nkept, go = 0, threading.Event()\n"
            "try:\n    for n in range(3000):\n"
            "        threading.Thread(target=go.wait, args=(5,), daemon=True).start(); kept += 1\n"
            "except (RuntimeError, MemoryError): pass\nfinally: go.set(); held = kept > 600"
        ),
        FULL,
    ),
]
READING = [
    (
        "a lesson that is a list",
        "metadata of types that nobody expects, read for the report of the whole class",
        changed(lambda notebook: notebook["metadata"].update(dhlab={"lesson": [], "variant": {}})),
        FULL,
    ),
    (
        "code in no tokens",
        "NUL, form feeds, half strings and brackets without end, where copies are looked for",
        cells(code("x = '''\x00\x0c\r\ufeff(((\\\n" + "[" * 300 + "f'{x:{y:{" + '")')),
        ANY,
    ),
    (
        "a sentence in short words",
        "a choice answered with a list of words, said back to it as the course's own",
        answer("05.2", "rule = ['FULL', 'POINTS', 'canary-' '8086', 'by', 'your', 'teacher']"),
        {"05.2"},
    ),
    (
        "an address of the grader",
        "a choice answered with a thing, whose name and place in memory are said back",
        answer("05.2", "rule = print"),
        {"05.2"},
    ),
]
CALLED = [*CALLS, *READING]

HONEST_KINDS = [
    (
        "numpy's own kinds",
        lambda notebook, facts: [
            answer("05.5", "origin = np.matrix(origin)")(notebook, facts),
            answer("05.9", "A_3 = np.asarray(A_3, dtype=np.longdouble)")(notebook, facts),
            answer("05.3", "order = np.array(list(order))")(notebook, facts),
            answer("05.2", "rule = np.array([rule])[0]")(notebook, facts),
        ],
    ),
    (
        "answers that are walked through once",
        lambda notebook, facts: [
            answer("05.5", "origin = map(float, origin)")(notebook, facts),
            answer("05.3", "order = (letter for letter in order)")(notebook, facts),
        ],
    ),
    (
        "annotations for others",
        lambda notebook, facts: [
            first("from __future__ import annotations")(notebook, facts),
            closed(
                "return form(theta, d, a, alpha)",
                "from typing import TYPE_CHECKING\n"
                "if TYPE_CHECKING:\n    from numpy.typing import NDArray\n"
                f"def form(theta: Angle, d, a, alpha) -> NDArray:\n{FORM}",
            )(notebook, facts),
        ],
    ),
    (
        "modern Python",
        closed(
            "return link(theta, d, a, alpha)",
            "import functools\nfrom dataclasses import dataclass\n"
            "def kept(f):\n    @functools.wraps(f)\n    def of(*args):\n"
            "        match args:\n            case [_, *rest] if (n := len(rest)) == 4:\n"
            "                return f(*args)\n        raise TypeError(n)\n    return of\n"
            "@dataclass(frozen=True)\nclass Link:\n    name: str = 'A'\n"
            "    @kept\n    @functools.lru_cache\n    def __call__(self, theta, d, a, alpha):\n"
            + "".join(f"    {line}\n" for line in FORM.splitlines())
            + "link = Link()",
        ),
    ),
]
