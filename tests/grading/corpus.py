"""Hostile and unlucky submissions to lesson 05, made from the right one: what each does, and what
it must cost.

A case is (name, make, lost): ``make(notebook, facts)`` changes the solved notebook, a dict, or
returns bytes, or a dict of file names to bytes; ``lost`` are the exercises it may not earn, a
status of the whole submission, or ANY for one that may only harm itself. ``facts`` holds the paths
and the port that attacks aim at. An attack that succeeds answers 05.2 wrongly, so that the marks
tell.
"""

import copy
import io
import json
import os
import stat
import zipfile
from pathlib import Path

from dhlab.course.exercises import exercises

ROOT = Path(__file__).parents[2]
FULL, ANY = frozenset(), "any"
HONEST = "-honest"  # ends the ids of the honest students, who are graded among the others
LESSON = [key for key, e in exercises().items() if key.startswith("05.") and e.points]
_SOLVED = json.loads((ROOT / "solutions" / "05-link-matrix.ipynb").read_text(encoding="utf-8"))


def solved():
    """The right notebook, without outputs."""
    notebook = copy.deepcopy(_SOLVED)
    for cell in notebook["cells"]:
        cell["source"] = "".join(cell["source"])
        if cell["cell_type"] == "code":
            cell["outputs"], cell["execution_count"] = [], None
    return notebook


def code(source):
    """A cell."""
    return {
        "cell_type": "code",
        "metadata": {},
        "source": source,
        "outputs": [],
        "execution_count": None,
        "id": "extra",
    }


def first(source):
    """Put a cell after the imports."""

    def make(notebook, facts):
        at = next(i for i, cell in enumerate(notebook["cells"]) if cell["cell_type"] == "code") + 1
        notebook["cells"].insert(at, code(source.replace("FACTS", repr(facts))))

    return make


def answer(key, source):
    """Add to the answer of an exercise."""

    def make(notebook, facts):
        cell = next(
            cell for cell in notebook["cells"] if cell.get("metadata", {}).get("exercise") == key
        )
        cell["source"] += "\n" + source.replace("FACTS", repr(facts))

    make.answers = key
    return make


def spy(source):
    """An attack that sets ``leaked``; when that succeeds, 05.2 is answered wrongly."""

    def make(notebook, facts):
        first("leaked = False\nknown = FACTS\n" + source.replace("FACTS[", "known["))(
            notebook, facts
        )
        answer("05.2", 'rule = "a" if leaked else rule')(notebook, facts)

    make.looks = source
    return make


def reading(path):
    """A spy that opens a file."""
    return spy(f"try:\n    leaked = bool(open({path}, 'rb').read(1))\nexcept OSError:\n    pass")


def raw(change):
    """A submission made from the bytes of the right one."""
    return lambda notebook, facts: change(json.dumps(notebook).encode())


def changed(change):
    """Change the notebook in place."""
    return lambda notebook, facts: change(notebook)


def blog(body):
    """Another function for 05.7."""
    return answer(
        "05.7",
        "def dh_from_a_blog(theta, d, a, alpha):\n"
        + "".join(f"    {line}\n" for line in body.splitlines()),
    )


def moved(body):
    """The right function for 05.4, which does something else besides."""
    return answer(
        "05.4",
        f"def dh_transform(theta, d, a, alpha):\n    {body}\n"
        "    return rot_z(theta) @ trans_z(d) @ trans_x(a) @ rot_x(alpha)",
    )


def closed(body, before=""):
    """Another function for 05.6."""
    return answer(
        "05.6",
        f"{before}\ndef dh_closed(theta, d, a, alpha):\n"
        + "".join(f"    {line}\n" for line in body.splitlines()),
    )


FORWARD = "dh.Arm(dh.DHTable.standard([[theta, d, a, alpha]], angle='rad')).forward([0])"
FORGED = [
    b'{"check": "05.1", "points": 100, "status": "right"}',
    b'{"check": "05.1", "value": {"array": ["f8", [-1], [1]]}}',
    b'{"check": ["05.1"], "value": 1}',
    b'{"cell": "x", "ids": 5}',
    b'{"ended": "error", "ids": "05.2", "message": 7}',
    b"[" * 5000,
    b'{"check": "05.5", "value": 1' + b"0" * 5000 + b"}",
    b"\xff\xfe\x00",
    b'{"check": "05.4", "calls": [1], "again": 1, "used": 5}',
    b'{"check": "05.4", "fault": [1, 2]}',
    b'{"check": "05.9", "value": {"table": [1, 2, 3]}}',
    b'{"check": "05.3", "value": {"dict": [[[], {}]]}}',
    b'{"check": "05.9", "value": {"array": ["f8", [99999999999], []]}}',
    b"null",
    b"7",
]

TIME = [
    ("loop", first("while True: pass"), FULL),
    (
        "loop that swallows everything",
        first("while True:\n    try:\n        while True: pass\n    except BaseException: pass"),
        FULL,
    ),
    ("loop in C", first("sum(iter(int, 1))"), FULL),
    ("sleep", first("import time; time.sleep(1000)"), FULL),
    (
        "alarm ignored",
        first("import signal\nsignal.signal(signal.SIGALRM, signal.SIG_IGN)\nwhile True: pass"),
        FULL,
    ),
    ("loop in an answer", blog("while True: pass"), {"05.7"}),
    ("recursion", first("def f(): f()\nf()"), FULL),
    ("nested list shown", first("x = []\nfor _ in range(100000): x = [x]\nrepr(x)"), FULL),
    ("waits for input", first("name = input('who? ')"), FULL),
]
PROCESSES = [
    ("fork bomb", first("import os\nwhile True: os.fork()"), FULL),
    (
        "subprocess",
        spy(
            "import subprocess\ntry:\n    leaked = bool(subprocess.run(['/bin/echo', 'x'],"
            " capture_output=True).stdout)\nexcept OSError:\n    pass"
        ),
        FULL,
    ),
    ("system", spy("import os\nleaked = os.system('/bin/true') == 0"), FULL),
    ("exec", first("import os\nos.execv('/bin/sh', ['sh', '-c', 'sleep 100'])"), FULL),
    (
        "thread bomb",
        first(
            "import threading, time\nfor _ in range(3000): threading.Thread(target=time.sleep,"
            " args=(100,), daemon=True).start()"
        ),
        FULL,
    ),
    (
        "late thread",
        first(
            "import threading, time, builtins\ndef late():\n    time.sleep(0.05)\n    np.eye ="
            " None\nthreading.Thread(target=late).start()"
        ),
        ANY,
    ),
    (
        "thread that stays",
        first("import threading, time\nthreading.Thread(target=time.sleep, args=(1000,)).start()"),
        FULL,
    ),
    ("pool", first("from multiprocessing import Pool\nPool(4).map(abs, range(4))"), FULL),
    (
        "kills its parent",
        first(
            "import os\nfor pid in (os.getppid(), 1, 2):\n    try: os.kill(pid, 9)\n    except"
            " OSError: pass"
        ),
        FULL,
    ),
    ("kills everybody", first("import os\nos.kill(-1, 9)"), FULL),
    ("kills itself", first("import os\nos.kill(os.getpid(), 9)"), FULL),
    ("aborts", first("import os\nos.abort()"), FULL),
    ("segmentation fault", first("import ctypes\nctypes.string_at(0)"), FULL),
    ("ends the process", first("import os\nos._exit(0)"), FULL),
    ("sys.exit", first("import sys\nsys.exit()"), FULL),
    ("exit in a function", blog("raise SystemExit"), {"05.7"}),
    (
        "ends the process five times",
        lambda notebook, facts: [
            answer(key, "import os; os._exit(1)")(notebook, facts)
            for key in ("05.4", "05.5", "05.6", "05.7", "05.8")
        ],
        {"05.2", "05.4", "05.5", "05.6", "05.7", "05.8", "05.9"},
    ),
    ("keyboard interrupt", first("raise KeyboardInterrupt"), FULL),
]
RESOURCES = [
    ("memory at once", first("x = bytearray(50_000_000_000)"), FULL),
    ("memory by and by", first("x = []\nwhile True: x.append(bytearray(10_000_000))"), FULL),
    ("memory of numpy", first("np.ones((10**6, 10**5))"), FULL),
    (
        "higher limits",
        first(
            "import resource\nresource.setrlimit(resource.RLIMIT_AS, (-1, -1))\nx ="
            " bytearray(50_000_000_000)"
        ),
        FULL,
    ),
    (
        "disk",
        first("for i in range(200):\n    with open(f'f{i}', 'wb') as f: f.write(bytes(1_000_000))"),
        FULL,
    ),
    (
        "one large file",
        first("with open('f', 'wb') as f:\n    for _ in range(300): f.write(bytes(1_000_000))"),
        FULL,
    ),
    ("many files", first("for i in range(1000): open(f'f{i}', 'w').close()"), FULL),
    (
        "deep folders",
        first(
            "import os\nfor i in range(300):\n    os.mkdir('d'); os.chdir('d'); os.chmod('.',"
            " 0o500) if i == 299 else None"
        ),
        FULL,
    ),
    ("print flood", first("for _ in range(400): print('x' * 1_000_000)"), FULL),
    (
        "output flood past Python",
        first(
            "import os\nfor _ in range(2000):\n    os.write(1, bytes(100_000)); os.write(2,"
            " bytes(100_000))"
        ),
        FULL,
    ),
    # the last check of an exercise counts, which is the honest one below
    ("many answers", first("for i in range(20_000): check('05.9', i)"), FULL),
    ("a huge answer", answer("05.9", "A_3 = np.ones(10**6)"), {"05.9"}),
    (
        "a deep answer",
        answer("05.3", "order = []\nfor _ in range(50_000): order = [order]"),
        {"05.3"},
    ),
    ("a huge number", answer("05.5", "origin = [10**400, 1, 2]"), {"05.5"}),
]
CHANNEL = [
    (
        "floods every open file",
        first(
            "import os\nfor fd in range(3, 64):\n    try:\n        for _ in range(200):"
            " os.write(fd, b'x' * 100_000)\n    except OSError: pass"
        ),
        FULL,
    ),
    (
        "forges lines",
        first(
            f"import os\nfor fd in range(3, 64):\n    for line in {FORGED!r}:\n        try:"
            " os.write(fd, line + b'\\n')\n        except OSError: pass"
        ),
        FULL,
    ),
    (
        "forges the end",
        first(
            'import os\nfor fd in range(3, 64):\n    try: os.write(fd, b\'{"done": "05"}\\n\')\n   '
            " except OSError: pass"
        ),
        ANY,
    ),
    ("closes every file", first("import os\nos.closerange(3, 256)"), FULL),
    ("json patched", first("import json\njson.dumps = lambda *a, **k: '{}'"), ANY),
]
READING = [
    ("reads the solutions", reading("FACTS['solutions']"), FULL),
    ("reads the exercises", reading("FACTS['exercises']"), FULL),
    ("reads the key", reading("FACTS['key']"), FULL),
    ("reads a neighbour", reading("FACTS['neighbour']"), FULL),
    ("reads marks", reading("FACTS['marks']"), FULL),
    ("reads passwords", reading("'/etc/passwd'"), FULL),
    (
        "lists the class",
        spy(
            "import os\ntry:\n    leaked = bool(os.listdir(FACTS['class']))\nexcept OSError:\n   "
            " pass"
        ),
        FULL,
    ),
    (
        "imports the exercises",
        spy(
            "import importlib\nfor name in ('dhlab.course.exercises', 'dhlab.course.kinds',"
            " 'dhlab.grading.judging.judge', 'dhlab.course.exercises.lesson05'):\n    try:\n       "
            " importlib.import_module(name); leaked = True\n    except ImportError:\n        pass"
        ),
        FULL,
    ),
    (
        "searches memory",
        spy(
            "import gc\nleaked = any(type(o).__name__ in ('Choice', 'Function', 'Order', 'Verdict')"
            " for o in gc.get_objects())"
        ),
        FULL,
    ),
    (
        "searches frames",
        spy(
            "import sys\nframe = sys._getframe()\nwhile frame:\n    leaked = leaked or"
            " any('expected' in n or 'praise' in n or 'correct' in n for n in frame.f_locals)\n   "
            " frame = frame.f_back"
        ),
        FULL,
    ),
    (
        "searches modules",
        spy(
            "import sys\nleaked = any({'EXERCISES', 'RIGHT_ORDERS'} & {*getattr(m, '__dict__', ())}"
            " for m in list(sys.modules.values()))"
        ),
        FULL,
    ),
    (
        "searches the disk",
        spy(
            "import os\nfor top in ('/work', '/home', '/root', '/tmp', '/cage', '/srv', '/mnt'):\n "
            "   for folder, folders, files in os.walk(top):\n        folders[:] = [f for f in"
            " folders if f not in ('site-packages', 'lib')]\n        leaked = leaked or"
            " any('lesson05' in f or f.endswith('.key') or f.endswith('.ipynb') for f in files)"
        ),
        FULL,
    ),
    (
        "environment",
        spy("import os\nleaked = any('GRADER_SECRET' in name for name in os.environ)"),
        FULL,
    ),
    (
        "other processes",
        spy(
            "import glob\nfor path in glob.glob('/proc/[0-9]*/environ') +"
            " glob.glob('/proc/[0-9]*/cmdline'):\n    try:\n        leaked = leaked or"
            " b'GRADER_SECRET' in open(path, 'rb').read()\n    except OSError:\n        pass"
        ),
        FULL,
    ),
    (
        "memory of others",
        spy(
            "import os\nfor pid in (os.getppid(), 1):\n    try:\n        leaked = leaked or"
            " bool(os.open(f'/proc/{pid}/mem', os.O_RDWR))\n    except OSError:\n        pass"
        ),
        FULL,
    ),
    (
        "network",
        spy(
            "import socket\ntry:\n    socket.create_connection(('127.0.0.1', FACTS['port']), 1);"
            " leaked = True\nexcept OSError:\n    pass"
        ),
        FULL,
    ),
    (
        "datagrams and sockets of the system",
        spy(
            "import socket\nfor family in (socket.AF_INET, socket.AF_INET6, socket.AF_UNIX):\n   "
            " try:\n        socket.socket(family, socket.SOCK_DGRAM); leaked = True\n    except"
            " OSError:\n        pass"
        ),
        FULL,
    ),
    (
        "debugger",
        spy("import ctypes, os\nleaked = ctypes.CDLL(None).ptrace(16, os.getppid(), 0, 0) == 0"),
        FULL,
    ),
    (
        "shared memory",
        spy("import ctypes\nleaked = ctypes.CDLL(None).shmget(4711, 4096, 0o1666) >= 0"),
        FULL,
    ),
    (
        "new namespaces",
        spy("import ctypes\nleaked = ctypes.CDLL(None).unshare(0x10000000) == 0"),
        FULL,
    ),
    (
        "chroot",
        spy("import os\ntry:\n    os.chroot('/'); leaked = True\nexcept OSError:\n    pass"),
        FULL,
    ),
    (
        "becomes root",
        spy(
            "import os\ntry:\n    os.setuid(0); leaked = os.getuid() == 0 and"
            " bool(open('/etc/shadow'))\nexcept OSError:\n    pass"
        ),
        FULL,
    ),
    (
        "asks for another variant",
        first("from dhlab.course import set_variant\nset_variant(12345)"),
        FULL,
    ),
]
PATCHES = [
    (
        "numpy patched",
        first(
            "np.allclose = np.array_equal = lambda *a, **k: True\nnp.isfinite = lambda *a: np.True_"
        ),
        FULL,
    ),
    (
        "numpy patched, answer wrong",
        answer("05.9", "np.allclose = np.array_equal = lambda *a, **k: True\nA_3 = np.eye(4)"),
        {"05.9"},
    ),
    (
        "builtins patched",
        answer(
            "05.9",
            "import builtins\nbuiltins.len = builtins.isinstance = builtins.abs = lambda *a: True",
        ),
        ANY,
    ),
    ("check redefined", first("def check(*args): return 'right'"), FULL),
    (
        "the course patched",
        first("import dhlab.course\ndhlab.course.book = None\ndhlab.course.check = None"),
        ANY,
    ),
    (
        "a list that is equal to everything",
        answer("05.3", "class L(list):\n    __eq__ = lambda self, other: True\norder = L('dcba')"),
        {"05.3"},
    ),
    (
        "a text that lies",
        answer("05.2", "class S(str):\n    lower = strip = lambda self: 'b'\nrule = S('a')"),
        {"05.2"},
    ),
    (
        "an array that lies",
        answer(
            "05.9",
            "class A(np.ndarray):\n    __eq__ = __sub__ = __rsub__ = lambda s, o: np.zeros((4,"
            " 4))\nA_3 = np.ones((4, 4)).view(A)",
        ),
        {"05.9"},
    ),
    (
        "an object that lies",
        answer(
            "05.9",
            "class O:\n    shape = (4, 4)\n    def __array__(self, *a, **k): raise SystemExit\n   "
            " def __getattr__(self, n): return self\nA_3 = O()",
        ),
        {"05.9"},
    ),
    (
        "numbers that lie",
        answer(
            "05.5",
            "class F(float):\n    __sub__ = __rsub__ = lambda s, o: 0.0\norigin = [F(9), F(9),"
            " F(9)]",
        ),
        {"05.5"},
    ),
    ("NaN", answer("05.9", "A_3 = np.full((4, 4), np.nan)"), {"05.9"}),
    ("infinity", answer("05.5", "origin = [float('inf')] * 3"), {"05.5"}),
    ("an empty array", answer("05.5", "origin = np.array([])"), {"05.5"}),
    ("an array of objects", answer("05.5", "origin = np.array([None, {}, object()])"), {"05.5"}),
    ("complex numbers", answer("05.5", "origin = np.array(origin) + 0j"), {"05.5"}),
    ("a structured array", answer("05.5", "origin = np.zeros(3, dtype=[('x', float)])"), {"05.5"}),
    (
        "a pickle",
        answer(
            "05.9",
            "class P:\n    def __reduce__(self): return (open, (FACTS['canary'], 'w'))\nA_3 = P()",
        ),
        {"05.9"},
    ),
    (
        "a type in its name's clothes",
        answer("05.9", "A_3 = type('<script>alert(1)</script>', (), {})()"),
        {"05.9"},
    ),
    (
        "a page in its error",
        answer("05.9", "del A_3\nraise ValueError('<script>alert(1)</script>')"),
        {"05.9"},
    ),
    ("returns NaN", blog("return np.full((4, 4), np.nan)"), {"05.7"}),
    ("returns a generator", blog("yield np.eye(4)"), {"05.7"}),
    ("returns a 3×4", blog("return dh_transform(theta, d, a, alpha)[:3]"), {"05.7"}),
    (
        "right at first",
        blog(
            "dh_from_a_blog.n = getattr(dh_from_a_blog, 'n', 0) + 1\nreturn dh_transform(theta, d,"
            " a, alpha) if dh_from_a_blog.n < 24 else np.eye(4)"
        ),
        {"05.7"},
    ),
    (
        "remembers the notebook's own check",
        lambda notebook, facts: closed(
            "return known[round(theta, 9)]", f"known = {_remembered()!r}"
        )(notebook, facts),
        {"05.6"},
    ),
]
LIBRARY = [
    ("calls the library", closed(f"return {FORWARD}"), {"05.6"}),
    (
        "calls it by another name",
        closed(
            "return f('standard', [theta], [d], [a], [alpha])[0]",
            "from dhlab.kinematics import link_matrices as f",
        ),
        {"05.6"},
    ),
    (
        "calls it in a thread",
        closed(
            f"found = []\nt = threading.Thread(target=lambda: found.append({FORWARD}))\nt.start();"
            " t.join()\nreturn found[0]",
            "import threading",
        ),
        {"05.6"},
    ),
    (
        "calls it reloaded",
        closed(
            "return k.link_matrices('standard', [theta], [d], [a], [alpha])[0]",
            "import importlib, dhlab.kinematics\nk = importlib.reload(dhlab.kinematics)",
        ),
        {"05.6"},
    ),
    ("calls it unseen", closed(f"sys.setprofile(None)\nreturn {FORWARD}", "import sys"), {"05.6"}),
    (
        "calls it unseen for a moment",
        closed(
            f"p = sys.getprofile(); sys.setprofile(None); T = {FORWARD};"
            " sys.setprofile(p)\nreturn T",
            "import sys",
        ),
        {"05.6"},
    ),
    (
        "calls the move it was to write",
        answer("05.1", "def rot_x(alpha): return transform.rot_x(alpha)"),
        {"05.1"},
    ),
    (
        "draws while it computes",
        moved("view.link(dh.DHTable.standard([[theta, d, a, alpha]], angle='rad'), 1)"),
        FULL,
    ),
]
LEFT_BEHIND = [
    (
        "leaves start-up files",
        first(
            "import os\nfor folder in ('.', os.path.expanduser('~'), '/tmp', '/var/tmp',"
            " '/dev/shm', os.path.dirname(np.__file__), os.path.dirname(dh.__file__)):\n    for"
            " name in ('sitecustomize.py', 'usercustomize.py', 'numpy.py', 'x.pth', 'json.py'):\n  "
            "      try: open(os.path.join(folder, name), 'w').write('raise SystemExit')\n       "
            " except OSError: pass"
        ),
        FULL,
    ),
    (
        "looks for what was left",
        spy(
            "import os\nleaked = any(os.path.exists(os.path.join(folder, 'sitecustomize.py')) for"
            " folder in ('.', '/tmp', os.path.dirname(dh.__file__)))\nleaked = leaked or"
            " bool(os.listdir('.'))"
        ),
        FULL,
    ),
    (
        "writes into the library",
        first("with open(dh.__file__, 'a') as f: f.write('raise SystemExit')"),
        FULL,
    ),
    (
        "writes to the teacher",
        spy(
            "for path in (FACTS['canary'], FACTS['marks'], FACTS['neighbour'],"
            " FACTS['solutions']):\n    try:\n        open(path, 'a'); leaked = True\n    except"
            " OSError:\n        pass"
        ),
        FULL,
    ),
    (
        "removes files",
        first(
            "import os, shutil\nfor path in (FACTS['class'], FACTS['out'], '/cage',"
            " os.path.dirname(dh.__file__)):\n    shutil.rmtree(path, ignore_errors=True)"
        ),
        FULL,
    ),
]
NOTEBOOKS = [
    (
        "prints and warns",
        moved("import warnings\n    print('hello'); warnings.warn('careful')"),
        FULL,
    ),
    (
        "magics",
        first(
            "%matplotlib inline\n%load_ext autoreload\n!pip install nothing\nfiles = !ls\n%timeit"
            " -n 1 1 + 1\n?np"
        ),
        FULL,
    ),
    (
        "cell magics",
        changed(
            lambda n: [
                c.__setitem__("source", "%%time\n" + c["source"])
                for c in n["cells"]
                if c["cell_type"] == "code" and "exercise" in c["metadata"]
            ]
        ),
        FULL,
    ),
    (
        "libraries that are not here",
        first(
            "import seaborn_that_is_not_here as sns, numpy as np\nfrom torch_not_here.nn import"
            " Linear\nsns.set_theme()\nLinear(3)(2)"
        ),
        FULL,
    ),
    (
        "a missing library among others",
        changed(
            lambda n: next(c for c in n["cells"] if c["cell_type"] == "code").__setitem__(
                "source",
                "import not_here_at_all\n"
                + next(c for c in n["cells"] if c["cell_type"] == "code")["source"],
            )
        ),
        FULL,
    ),
    (
        "widgets",
        first(
            "import ipywidgets as w\nfrom IPython.display import"
            " display\ndisplay(w.interactive(lambda x: x, x=(0, 5)))"
        ),
        FULL,
    ),
    ("await", first("import asyncio\nawait asyncio.sleep(0.01)"), FULL),
    ("a syntax error", first("def ("), FULL),
    ("an error", first("1 / 0"), FULL),
    (
        "checks deleted",
        changed(
            lambda n: n.update(
                cells=[c for c in n["cells"] if not c["source"].startswith("check(")]
            )
        ),
        FULL,
    ),
    (
        "checks and metadata deleted",
        changed(
            lambda n: (
                n.update(cells=[c for c in n["cells"] if not c["source"].startswith("check(")]),
                [c.update(metadata={}) for c in n["cells"]],
            )
        ),
        FULL,
    ),
    (
        "every cell twice",
        changed(lambda n: n.update(cells=[c for c in n["cells"] for _ in range(2)])),
        FULL,
    ),
    (
        "imports deleted",
        changed(
            lambda n: n["cells"].remove(next(c for c in n["cells"] if c["cell_type"] == "code"))
        ),
        FULL,
    ),
    (
        "another kernel",
        changed(
            lambda n: n["metadata"].update(
                kernelspec={"name": "ir", "language": "R", "display_name": "R"}
            )
        ),
        FULL,
    ),
    ("no metadata at all", changed(lambda n: n.update(metadata=7)), FULL),
    (
        "cells that are none",
        changed(
            lambda n: n["cells"].extend(
                [
                    None,
                    7,
                    [],
                    {"cell_type": "code"},
                    {"cell_type": 5, "source": 3},
                    {"cell_type": "code", "source": {"a": 1}, "metadata": 3},
                ]
            )
        ),
        FULL,
    ),
    ("version 3", raw(lambda b: _version_3(json.loads(b))), FULL),
    ("UTF-16", raw(lambda b: json.dumps(json.loads(b), ensure_ascii=False).encode("utf-16")), FULL),
    ("a byte order mark", raw(lambda b: b"\xef\xbb\xbf" + b), FULL),
    (
        "latin-1",
        raw(lambda b: b.replace(b'"cells": [', b'"author": "\xe9\xe8", "cells": [', 1)),
        FULL,
    ),
    (
        "only words",
        changed(lambda n: n.update(cells=[c for c in n["cells"] if c["cell_type"] == "markdown"])),
        "not attempted",
    ),
    ("broken JSON", raw(lambda b: b[:-200]), "unreadable"),
    ("an empty file", raw(lambda b: b""), "unreadable"),
    ("a list", raw(lambda b: b"[1, 2, 3]"), "unreadable"),
    ("nested brackets", raw(lambda b: b"[" * 100_000 + b"]" * 100_000), "unreadable"),
    ("noise", raw(lambda b: bytes(range(256)) * 400), "unreadable"),
    (
        "a JSON bomb",
        raw(lambda b: b'{"cells": [' + b"[],[[]],".join([b""] * 800_000) + b"1]}"),
        ANY,
    ),
    ("twenty megabytes of nothing", raw(lambda b: b + b" " * 21_000_000), FULL),
]
FILES = [
    (
        "a zip",
        lambda n, facts: {"mine.zip": zipped({"work/05.ipynb": json.dumps(n).encode()})},
        FULL,
    ),
    ("renamed", lambda n, facts: {"homework (2).txt": json.dumps(n).encode()}, FULL),
    (
        "beside other files",
        lambda n, facts: {"a.pdf": b"%PDF", "05.ipynb": json.dumps(n).encode(), ".DS_Store": b"x"},
        FULL,
    ),
    (
        "a zip that leads out",
        lambda n, facts: {
            "mine.zip": zipped(
                {
                    "../../../../canary": b"x",
                    "/canary": b"x",
                    "..\\..\\05.ipynb": json.dumps(n).encode(),
                }
            )
        },
        "unreadable",
    ),
    (
        "a zip bomb",
        lambda n, facts: {"mine.zip": zipped({f"{i}.ipynb": bytes(30_000_000) for i in range(8)})},
        "unreadable",
    ),
    (
        "a zip in a zip in a zip",
        lambda n, facts: {
            "mine.zip": zipped({"a.zip": zipped({"b.zip": zipped({"05.ipynb": b"{}"})})})
        },
        ANY,
    ),
    (
        "a broken zip",
        lambda n, facts: {"mine.zip": zipped({"05.ipynb": json.dumps(n).encode()})[:-50]},
        "unreadable",
    ),
    (
        "a zip with a link",
        lambda n, facts: {"mine.zip": zipped({}, link=facts["key"])},
        "unreadable",
    ),
    ("a zip that lies about its size", lambda n, facts: {"mine.zip": _lying_zip()}, "unreadable"),
    ("a word file", lambda n, facts: {"answers.docx": b"PK not really"}, "unreadable"),
    ("nothing", lambda n, facts: {}, "missing"),
]
CASES = [
    *TIME,
    *PROCESSES,
    *RESOURCES,
    *CHANNEL,
    *READING,
    *PATCHES,
    *LIBRARY,
    *LEFT_BEHIND,
    *NOTEBOOKS,
    *FILES,
]


def put(folder, make, facts):
    """Hand in one case: the notebook that ``make`` changes, or the bytes or files that it gives."""
    notebook = solved()
    made = make(notebook, facts)
    if not isinstance(made, dict):
        raw = made if isinstance(made, bytes) else json.dumps(notebook).encode()
        made = {"05-link-matrix.ipynb": raw}
    folder.mkdir(parents=True)
    for name, data in made.items():
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_bytes(data)


def as_solved(notebook, facts):
    """Change nothing."""


def lost(graded):
    """The exercises that a student did not get all points for."""
    return {mark.exercise for mark in graded.marks if mark.points < mark.of}


def write(folder, cases, facts):
    """The class: a folder per case, with an honest student after every twenty and the last."""
    for number, (_, make, _) in enumerate(cases):
        put(folder / student(number), make, facts)
    for number in {*range(0, len(cases), 20), len(cases)}:
        put(folder / f"{student(number)}{HONEST}", as_solved, facts)
    os.mkfifo(folder / student(0) / "pipe.ipynb")
    os.symlink(facts["key"], folder / student(1) / "link.ipynb")
    (folder / "tardy").mkdir()
    os.symlink(facts["neighbour"], folder / "tardy" / "05-link-matrix.ipynb")


def student(number):
    """The id of a case's student."""
    return f"s{number:03d}"


def zipped(files, link=None):
    """The bytes of a zip."""
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            archive.writestr(name, content)
        if link:
            info = zipfile.ZipInfo("05.ipynb")
            info.external_attr = (stat.S_IFLNK | 0o777) << 16
            archive.writestr(info, link)
    return data.getvalue()


def _lying_zip():
    """30 MB that say they are 100 bytes."""
    data = bytearray(zipped({"05.ipynb": bytes(30_000_000)}))
    for sign, at in ((b"PK\x01\x02", 24), (b"PK\x03\x04", 22)):
        start = data.index(sign) + at
        data[start : start + 4] = (100).to_bytes(4, "little")
    return bytes(data)


def _version_3(notebook):
    cells = [
        {
            "cell_type": c["cell_type"],
            "metadata": c["metadata"],
            **(
                {"input": c["source"], "language": "python", "outputs": []}
                if c["cell_type"] == "code"
                else {"source": c["source"]}
            ),
        }
        for c in notebook["cells"]
    ]
    return json.dumps(
        {
            "nbformat": 3,
            "nbformat_minor": 0,
            "metadata": {"name": ""},
            "worksheets": [{"cells": cells, "metadata": {}}],
        }
    ).encode()


def _remembered():
    """What the notebook's own check asks, with the right answers."""
    exercise = exercises()["05.6"]
    return {round(case[0], 9): exercise.answer(*case).tolist() for case in exercise.cases(0)}
