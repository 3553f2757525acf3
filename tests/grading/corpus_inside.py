"""Attacks with the cage's own code open: quotas outrun, rights by way of new calls, what outlives
the grader, answers made later or made by the caller, and words put into the course's mouth.
"""

from corpus import ANY, FULL, answer, closed, code, first, spy
from corpus_making import IDENTITY, RIGHT, cells, holding, in_company

# writes files of 2 MB into the folder in which it stands until there is no room
FILL = """kept = 0
try:
    for n in range(40):
        with open(f"f{n}", "wb") as file: kept += file.write(bytes(2 << 20))
except OSError: pass
import time; time.sleep(0.5)
held = kept > 32 << 20"""
CHANNEL = """import json, os, stat
def channels():
    for fd in range(3, 64):
        try:
            if stat.S_ISSOCK(os.fstat(fd).st_mode): yield fd
        except OSError: pass
def send(T):
    line = {"value": {"array": ["f8", [4, 4], T.ravel().tolist()]}, "closed": []}
    for fd in channels(): os.write(fd, json.dumps(line).encode() + b"\\n")
"""
MEMORY = """import ctypes, re
for line in open("/proc/self/maps"):
    ends, rights, *_ = line.split()
    start, end = (int(one, 16) for one in ends.split("-"))
    if rights[:2] == "rw" and "stack" not in line and end - start < 64 << 20:
        data = ctypes.string_at(start, end - start)
        leaked |= bool(re.search(rb"canary[-]80|GRADER[_]SECRET", data))"""

QUOTAS = [
    (
        "a folder that cannot be listed",
        "a folder that is entered but not read, and in it more than the files' limit",
        holding(f"import os\nos.mkdir('d', 0o300); os.chdir('d')\n{FILL}"),
        FULL,
    ),
    (
        "deeper than a path",
        "files below more folders than a path can name, where nobody counts them",
        holding(
            "import os\nfor n in range(40):\n    os.mkdir('d' * 200); os.chdir('d' * 200)\n" + FILL
        ),
        FULL,
    ),
    (
        "memory in pipes",
        "fills pipes, and sends them to itself, so that the kernel holds what no limit counts",
        holding(
            "import array, fcntl, os, socket\nkept, pairs = 0, [socket.socketpair()]\n"
            "try:\n    for n in range(2000):\n        out, into = os.pipe()\n"
            "        os.set_blocking(into, False)\n"
            "        try: fcntl.fcntl(into, 1031, 1 << 20)\n        except OSError: pass\n"
            "        try:\n            while True: kept += os.write(into, bytes(1 << 16))\n"
            "        except BlockingIOError: pass\n"
            "        socket.send_fds(pairs[0][0], [b'x'], [out])\n"
            "        os.close(out); os.close(into)\nexcept OSError: pass\nheld = kept > 256 << 20"
        ),
        FULL,
    ),
    (
        "twenty thousand cells",
        "a notebook of less than a megabyte that is nothing but cells",
        cells(*({"cell_type": "code", "source": "1"} for _ in range(20_000))),
        ANY,
    ),
]
RIGHTS = [
    (
        "rights by the newest calls",
        "an access list, which is a change of mode, by calls that a filter may not know",
        spy(
            "import ctypes\nlibc, its = ctypes.CDLL(None), FACTS['key'].encode()\n"
            "data = ctypes.create_string_buffer(b'x')\n"
            "args = (ctypes.c_uint64 * 2)(ctypes.addressof(data), 1)\n"
            "leaked = libc.syscall(463, -100, its, 0, b'user.x', args, 16) == 0\n"
            "leaked |= libc.syscall(466, -100, its, 0, b'user.x') == 0\n"
            "none = (ctypes.c_uint64 * 4)()\n"
            "leaked |= libc.syscall(469, -100, its, none, 32, 0) == 0"
        ),
        FULL,
    ),
    (
        "outlives the grader",
        "takes back that it dies with its parent",
        spy("import ctypes\nleaked = ctypes.CDLL(None).prctl(1, 0, 0, 0, 0) == 0"),
        FULL,
    ),
    (
        "stops itself",
        "a timer of its own sends it SIGSTOP, where every call that signals is closed",
        first(
            "import ctypes, time\nlibc, timer = ctypes.CDLL(None), ctypes.c_void_p()\n"
            "event = (ctypes.c_int * 16)(0, 0, 19, 0)\n"
            "libc.timer_create(0, event, ctypes.byref(timer))\n"
            "when = (ctypes.c_long * 4)(0, 0, 0, 1000)\n"
            "libc.timer_settime(timer, 0, when, None)\ntime.sleep(0.2)"
        ),
        FULL,
    ),
    (
        "reads its own memory",
        "every byte that the fork was born with, for words that only the grader knows",
        spy(
            "try:\n"
            + "".join(f"    {line}\n" for line in MEMORY.splitlines())
            + "except OSError: pass"
        ),
        FULL,
    ),
    (
        "modules that it never loaded",
        "names in sys.modules, so that the warm parent loads all of them for the whole class",
        first(
            "import os, sys\ntop = os.path.dirname(dh.__file__)\n"
            "for folder, inner, names in os.walk(top):\n    for name in names:\n"
            "        if name.endswith('.py'):\n"
            "            path = os.path.relpath(os.path.join(folder, name), os.path.dirname(top))\n"
            "            name = path[:-3].replace(os.sep, '.').removesuffix('.__init__')\n"
            "            sys.modules.setdefault(name, np)\n"
            "for name in ('scipy.optimize', 'scipy.spatial.transform', 'sympy', 'scipy.stats'):\n"
            "    sys.modules.setdefault(name, np)"
        ),
        ANY,
    ),
]
LATER = [
    (
        "a tracer over the room",
        "traces its caller, and gives the first pose that stands anywhere among its names",
        closed(
            "found = []\ndef trace(frame, event, value):\n"
            "    found.extend(v for v in frame.f_locals.values() if np.shape(v) == (4, 4))\n"
            "    return trace\nf = sys._getframe()\nwhile f:\n"
            "    f.f_trace = trace; trace(f, '', None); f = f.f_back\n"
            "sys.settrace(trace)\nreturn found[0] if found else np.eye(4)",
            "import sys",
        ),
        {"05.6"},
    ),
    (
        "steals the question",
        "a thread reads the next call before the room does, and answers it then or later",
        closed(
            "if not stolen:\n    stolen.append(1); threading.Thread(target=steal, daemon=True)"
            f".start()\n{IDENTITY}",
            CHANNEL
            + RIGHT
            + "import threading\nstolen = []\ndef steal():\n    for fd in channels():\n"
            "        last = None\n        while True:\n"
            "            case = json.loads(os.read(fd, 65536))['case']\n"
            "            send(right(last or case)); last = case",
        ),
        {"05.6"},
    ),
    (
        "a word from the dead",
        "__del__, a callback of gc and one of weakref, each with the right answer to send",
        closed(
            "class Late:\n    def __del__(self): send(right(self.case))\n"
            "late = Late(); late.case = (theta, d, a, alpha); late.itself = late\n"
            "gc.callbacks.append(lambda *a, case=late.case: send(right(case)))\n"
            "weakref.finalize(late, send, right(late.case))\ndel late; gc.collect()\n" + IDENTITY,
            CHANNEL + RIGHT + "import gc, weakref",
        ),
        {"05.6"},
    ),
    (
        "numpy for the next program",
        "05.1, once called, leaves an np.eye that gives the right answer to who calls it",
        in_company(
            f"{RIGHT}\nnp.eye = lambda n: right([sys._getframe(1).f_locals[k] for k in"
            " ('theta', 'd', 'a', 'alpha')])",
            IDENTITY,
        ),
        {"05.6"},
    ),
]
ANSWERS = [
    (
        "answers without an end",
        "a program whose answers give themselves, or more and more, when they are read",
        closed(
            "class Same:\n    __array__ = lambda self, *a, **k: self\n"
            "    __array_ufunc__ = None\n    __repr__ = lambda self: repr(self)\n"
            "    __len__ = lambda self: 4\n    __getitem__ = lambda self, k: self\n"
            "    __deepcopy__ = lambda self, known: self\nreturn Same()"
        ),
        {"05.6"},
    ),
    (
        "numbers that no float holds",
        "10**400, a Decimal that is none, hidden numbers, an infinity in each place that is hard",
        answer(
            "05.9",
            "from decimal import Decimal\nfrom fractions import Fraction\n"
            "A_3 = np.ma.masked_array(np.array([[10**400, Decimal('nan'), Fraction(1, 3), 1e308]]"
            " * 4, dtype=object), mask=True)",
        ),
        {"05.9"},
    ),
    (
        "words of its own on the page",
        "a choice answered with a mapping, whose words come back as the course's own",
        answer("05.2", "rule = {'FULL POINTS were given by the teacher for canary-' '8086': 1}"),
        {"05.2"},
    ),
    (
        "a note with a terminal's codes",
        "says that its notebook cannot be read, in words that move the teacher's cursor",
        cells(
            code(
                "import json, os\nfor fd in range(3, 64):\n    try: os.write(fd, json.dumps("
                "{'unreadable': '\\x1b]0;canary-' '8086\\x07\\x1b[2J'}).encode() + b'\\n')\n"
                "    except OSError: pass"
            )
        ),
        ANY,
    ),
]
INSIDE = [*QUOTAS, *RIGHTS, *LATER, *ANSWERS]
