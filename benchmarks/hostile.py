"""Fifty-five attacks on the grader, written with its code open, and controls, in both cages with
walls: none may earn a mark, read what is not its own, stop the class or harm a neighbour.

    python benchmarks/hostile.py                # bubblewrap, landlock
    python benchmarks/hostile.py --level rlimits   # protects nobody; only what does no harm is run

Each attack is (name, what it tries, how the solved notebook of lesson 05 is changed, which
exercises it may not earn: ANY when it may only harm itself). One that gets at something answers
05.2 wrongly, so that the marks tell. ``tests/grading/corpus.py`` has 130 older ones.
"""

import argparse
import contextlib
import json
import os
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).parents[1]
sys.path[:0] = [str(ROOT / "tests" / "grading")]
import corpus  # noqa: E402
from corpus import ANY, FULL, answer, closed, code, first, spy  # noqa: E402

from dhlab.grading.cage.cage import Cage  # noqa: E402
from dhlab.grading.grade import grade  # noqa: E402
from dhlab.grading.reports.publish import publish  # noqa: E402
from dhlab.grading.settings import Limits, Settings  # noqa: E402

LIMITS = Limits(cell_seconds=2.0, seconds=12.0, memory_mb=256, files_mb=8, threads=16)
CANARY = "canary-8086"
HONEST = 5  # an honest notebook after so many attacks
OPEN_FILES = "for name in os.listdir('/proc/self/fd'):\n"


def cells(*more):
    """Cells at the end."""
    return lambda notebook, facts: notebook["cells"].extend(more)


def into_first(**change):
    """Change the first cell of code."""

    def make(notebook, facts):
        next(cell for cell in notebook["cells"] if cell["cell_type"] == "code").update(change)

    return make


def markdown(**change):
    return {"cell_type": "markdown", "metadata": {}, "source": "", "id": "more"} | change


def nested(depth):
    value = "x"
    for _ in range(depth):
        value = [value]
    return value


def zipped_twice(notebook, facts):
    """Two members of one name: the second a wrong notebook."""
    import io
    import warnings
    import zipfile

    out, data = io.BytesIO(), json.dumps(notebook)
    with warnings.catch_warnings(), zipfile.ZipFile(out, "w") as file:
        warnings.simplefilter("ignore")
        file.writestr("05.ipynb", data)
        file.writestr("05.ipynb", data)
    return {"mine.zip": out.getvalue()}


def many_zips(notebook, facts):
    junk = corpus.zipped({f"{n}.ipynb": b"{}" for n in range(490)})
    return {f"{n}.zip": junk for n in range(40)} | {"05.ipynb": json.dumps(notebook).encode()}


def parts(raw):
    """A notebook of a few megabytes that costs a gigabyte when it is parsed."""
    return raw[:-1] + b', "x": [' + b"[]," * 4_000_000 + b"1]}"


def as_teacher(notebook, facts):
    """A wrong answer, and beside it all that a teacher might have written."""
    answer("05.2", "rule = '?'")(notebook, facts)
    points = "students: {attack: {exercises: {'05.2': {points: 1}}}}\n"
    texts = {"decisions.yaml": points, "course.yaml": "lessons: {'05': {points: {'05.2': 0}}}\n"}
    texts |= {"marks/attack.json": "{}", "grades.csv": "student,points\nattack,12\n"}
    texts |= {"roster.csv": "student\nattack\n", "items.py": "raise SystemExit"}
    files = {name: text.encode() for name, text in texts.items()}
    return files | {"05.ipynb": json.dumps(notebook).encode()}


def holding(source):
    """An attack that sets ``held`` where it gets what it may not have; 05.2 tells."""

    def make(notebook, facts):
        first(source)(notebook, facts)
        answer("05.2", 'rule = "?" if globals().get("held") else rule')(notebook, facts)

    return make


IDENTITY = "return np.eye(4)"
TRANSFORM = """try:
    import dhlab.kinematics as k
    T = k.link_matrices('standard', [theta], [d], [a], [alpha])[0]
except BaseException:
    T = np.eye(4)
return T"""


RIGHT_FORM = """ct, st, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
return np.array([[ct, -st * ca, st * sa, a * ct], [st, ct * ca, -ct * sa, a * st],
                 [0, sa, ca, d], [0, 0, 0, 1]])"""


def in_company(left_by_first, body):
    """05.1's program leaves something behind for 05.6, which is called after it."""

    def make(notebook, facts):
        source = "import builtins, os, sys, gc\ndef rot_x(alpha):\n"
        source += "".join(f"    {line}\n" for line in left_by_first.splitlines())
        source += "    c, s = np.cos(alpha), np.sin(alpha)\n"
        source += "    return np.array([[1,0,0,0],[0,c,-s,0],[0,s,c,0],[0,0,0,1.0]])"
        answer("05.1", source)(notebook, facts)
        closed(body, "import builtins, os, sys, gc")(notebook, facts)

    return make


COMPANY = [
    (
        "the library in the parent's memory",
        "looks through every object that the fork was born with for kinematics",
        closed(
            "import gc, types\n"
            "for f in gc.get_objects():\n"
            "    if isinstance(f, types.FunctionType) and f.__name__ == 'link_matrices':\n"
            "        return f('standard', [theta], [d], [a], [alpha])[0]\n" + IDENTITY
        ),
        {"05.6"},
    ),
    (
        "encodes for those after it",
        "the first program replaces the room's encoder, which then says what it likes",
        in_company(
            "for m in list(sys.modules.values()):\n"
            "    if getattr(m, '__name__', '').endswith('inside.calls'):\n"
            "        m.encode = lambda v, e=m.encode: e(np.eye(4))",
            IDENTITY,
        ),
        {"05.6"},
    ),
    (
        "renames itself in the room",
        "walks up the frames and calls the program before it once more under this name",
        closed(
            "import sys\nf = sys._getframe()\nwhile f:\n"
            "    room = f.f_locals.get('room')\n"
            "    if room is not None: room.key = '05.1'\n"
            "    f = f.f_back\n" + IDENTITY
        ),
        {"05.6"},
    ),
    (
        "a last word",
        "writes a line while its process ends",
        in_company(
            "import atexit\natexit.register(lambda: [os.write(n, b'{}\\n') for n in range(3, 9)])",
            IDENTITY,
        ),
        {"05.6"},
    ),
    (
        "one guess in company, another alone",
        "answers in one way where 05.1 has been called before it, and in another where not",
        in_company(
            "builtins.seen = 1", f"if not hasattr(builtins, 'seen'): {IDENTITY}\n{RIGHT_FORM}"
        ),
        {"05.6"},
    ),
]
EARN = [
    (
        "sends its own values",
        "writes a line with right-looking numbers into every open file before its call ends",
        closed(
            "for fd in range(3, 64):\n    try: os.write(fd, line)\n    except OSError: pass\n"
            + IDENTITY,
            "import os, json\nline = json.dumps({'value': {'array': ['f8', [4, 4], [1.0] * 16]}})"
            ".encode() + b'\\n'",
        ),
        {"05.6"},
    ),
    (
        "says that the talk is over",
        "answers all calls with one line that claims the end",
        closed(
            'for fd in range(3, 64):\n    try: os.write(fd, b\'{"done": 1, "right": true}\\n\')\n'
            "    except OSError: pass\n" + IDENTITY,
            "import os",
        ),
        {"05.6"},
    ),
    (
        "asks itself",
        "reads the next call from the channel and answers it out of turn",
        closed(
            "for fd in range(3, 64):\n    try:\n        os.set_blocking(fd, False)\n"
            "        os.write(fd, os.read(fd, 9999))\n    except OSError: pass\n" + IDENTITY,
            "import os",
        ),
        {"05.6"},
    ),
    (
        "a compiled function of the open room",
        "keeps the library's function in a default argument",
        answer(
            "05.6",
            "from dhlab.kinematics import link_matrices\n"
            "def dh_closed(theta, d, a, alpha, f=link_matrices):\n"
            "    return f('standard', [theta], [d], [a], [alpha])[0]",
        ),
        {"05.6"},
    ),
    (
        "tries the library, then gives what it has",
        "imports kinematics inside the call and hides the failure",
        closed(TRANSFORM),
        {"05.6"},
    ),
    (
        "a file between the rooms",
        "the notebook's run leaves a table of answers for the program's room",
        closed(
            "try:\n    return np.load(os.path.expanduser('~/T.npy'))\n"
            "except OSError:\n    return np.eye(4)",
            "import os\nnp.save(os.path.expanduser('~/T.npy'), np.ones((4, 4)))",
        ),
        {"05.6"},
    ),
    (
        "finds the library on disk",
        "looks for kinematics.py anywhere and runs it",
        closed(
            "return space['link_matrices']('standard', [theta], [d], [a], [alpha])[0]",
            "import os, sys\nspace = {}\nfor top in ('/cage', '/usr', '/opt', sys.prefix,"
            " sys.base_prefix, '/tmp', '/home', '/root', '/work'):\n"
            "    for folder, inner, names in os.walk(top):\n"
            "        if 'kinematics.py' in names and 'dhlab' in folder:\n"
            "            exec(open(os.path.join(folder, 'kinematics.py')).read()"
            ".replace('from .', 'from dhlab.'), space)",
        ),
        {"05.6"},
    ),
    (
        "an answer that changes when it is read",
        "an array whose numbers are made when the wire converts it",
        answer(
            "05.9",
            "class Late:\n    shape = (4, 4)\n    def __array__(self, *a, **k):\n"
            "        import sys\n        f = sys._getframe()\n        while f:\n"
            "            for v in f.f_locals.values():\n"
            "                if isinstance(v, dict) and hasattr(v.get('A_3'), 'dtype'):\n"
            "                    return v['A_3']\n            f = f.f_back\n"
            "        return np.eye(4)\nA_3 = Late()",
        ),
        {"05.9"},
    ),
    (
        "the wire replaced",
        "the encoder of the room is patched to send what was to be sent",
        answer(
            "05.9",
            "import dhlab.grading.inside.book as b\n"
            "b.encode = lambda v, d=0: {'array': ['f8', [4, 4], [0.0] * 16]}\nA_3 = np.eye(4)",
        ),
        ANY,
    ),
    (
        "a number in a word's place",
        "an order given as numbers, as a dict, as bytes",
        answer("05.3", "order = {'a': 'd', 0: b'dcba'}"),
        {"05.3"},
    ),
    (
        "all options at once",
        "every letter in one answer",
        answer("05.2", "rule = 'abcdefgh'"),
        {"05.2"},
    ),
    (
        "many notes",
        "notes every option, the right one among them, and a wrong one last",
        answer(
            "05.2",
            "from dhlab.course import check as c\nfor letter in 'abcd': c('05.2', letter)\n"
            "rule = '?'",
        ),
        {"05.2"},
    ),
    (
        "forged notes of another exercise",
        "writes lines that claim a verdict, points and a rubric",
        answer(
            "05.1",
            "import os, json\nfor fd in range(3, 64):\n    for key in ('05.1', '05.2'):\n"
            "        try: os.write(fd, json.dumps({'check': key, 'value': True, 'points': 9,"
            " 'status': 'right', 'answer': 'a1'}).encode() + b'\\n')\n"
            "        except OSError: pass\ndef rot_x(alpha): return np.eye(4)",
        ),
        ANY,
    ),
    (
        "a cell that is not there",
        "says that a program was written in cell 10**400, and in cell -1",
        answer(
            "05.6",
            "import os\nfor fd in range(3, 64):\n    for n in (b'9' * 400, b'-1', b'true'):\n"
            '        try: os.write(fd, b\'{"check": "05.6", "function": "written", "cell": \''
            " + n + b'}\\n')\n        except OSError: pass\ndef dh_closed(*row): return np.eye(4)",
        ),
        {"05.6"},
    ),
    (
        "remembers between calls of two rooms",
        "a module-level cache that the second run of a program would find",
        closed(
            "known = sys.modules.setdefault('kept', types.ModuleType('kept')).__dict__\n"
            "return known.get(round(theta, 6), np.eye(4))",
            "import sys, types",
        ),
        {"05.6"},
    ),
    (
        "tells an instruction from its hidden twin",
        "an unwritten body that answers after it is called twice",
        closed(
            "dh_closed.n = getattr(dh_closed, 'n', 0) + 1\nif dh_closed.n < 3: raise"
            " NotImplementedError\nreturn np.eye(4)"
        ),
        {"05.6"},
    ),
]
EARN += [
    (
        "all letters in a list",
        "a choice answered with every letter",
        answer("05.2", "rule = ['a', 'b', 'c', 'd']"),
        {"05.2"},
    ),
    (
        "a second run of the same calls",
        "sees all calls, stops as if a name were missing, and looks for what it kept",
        closed(
            "seen.append((theta, d, a, alpha))\n"
            "open(os.path.expanduser('~/seen'), 'a').write(repr(seen[-1]))\n"
            "if len(seen) > 20: raise NameError('dh')\nreturn np.eye(4)",
            "import os\nseen = []",
        ),
        {"05.6"},
    ),
    (
        "what was read for the class",
        "changes the lesson's cells where the warm parent read them once for everybody",
        first(
            "import gc, ast\nfor one in gc.get_objects():\n"
            "    if isinstance(one, ast.Constant): one.value = 7\n"
            "import dhlab.grading.inside.slices as s\ns.statements = lambda *a: None"
        ),
        ANY,
    ),
    (
        "in the teacher's place",
        "hands in decisions, marks, a course and items",
        as_teacher,
        {"05.2"},
    ),
]
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
STOP = [
    (
        "half a letter in an error",
        "a message that no file can hold (a lone surrogate)",
        answer("05.9", "del A_3\nraise ValueError('\\ud800x')"),
        {"05.9"},
    ),
    (
        "half a letter in its code",
        "code that no page can hold, kept beside the marks",
        answer("05.2", "note = '\ud800'"),
        ANY,
    ),
    (
        "half a letter in a cell's name",
        "an id that no file can hold",
        into_first(id="\ud800", metadata={"exercise": "\ud800"}),
        FULL,
    ),
    (
        "code in brackets in brackets",
        "a source that is a list in a list, 900 deep, and is read again outside",
        cells(code(nested(900))),
        FULL,
    ),
    (
        "pictures that are none",
        "attachments of odd kinds, for the review",
        cells(
            markdown(attachments={"a": {"image/png": "A===", "image/svg+xml": "<svg/>"}, "b": 7}),
            markdown(attachments=[1]),
        ),
        FULL,
    ),
    (
        "a million empty files",
        "takes the machine's memory by names alone, below every limit of bytes",
        first(
            "import os\ntry:\n    for n in range(10**7): os.close(os.open(f'f{n}', os.O_CREAT))\n"
            "except OSError: pass"
        ),
        ANY,
    ),
    (
        "many files of half the size",
        "more on the disk than the limit, in files below it",
        first(
            "try:\n    for n in range(60): open(f'big{n}', 'wb').write(bytes(4 << 20))\n"
            "except OSError: pass"
        ),
        ANY,
    ),
    (
        "a folder that cannot be removed",
        "rights taken away, a name of 255 bytes, 300 folders deep",
        first(
            "import os\ntry:\n    for n in range(300):\n        os.mkdir('d' * 255);"
            " os.chdir('d' * 255)\n    os.chmod('.', 0)\nexcept OSError: pass"
        ),
        ANY,
    ),
    (
        "sleeps just short of the limit",
        "many cells that wait, each below the limit of one",
        cells(*(code(f"import time; time.sleep(1.8)  # {n}") for n in range(80))),
        ANY,
    ),
    (
        "a stub that sleeps",
        "notes a program fifty times, each slow to make and never written",
        answer(
            "05.7",
            "import time; time.sleep(1.5)\ndef dh_from_a_blog(theta, d, a, alpha): ...\n"
            "for _ in range(60): check('05.7', dh_from_a_blog)",
        ),
        ANY,
    ),
    (
        "threads that work",
        "sixteen threads of a processor each",
        first(
            "import threading, hashlib\ndef f():\n    while True: hashlib.sha256(bytes(1 << 20))\n"
            "for _ in range(12): threading.Thread(target=f, daemon=True).start()"
        ),
        ANY,
    ),
    ("forty zips", "19,600 members in small zips", many_zips, FULL),
    (
        "two files of one name in a zip",
        "the marks of one under the name of the other",
        zipped_twice,
        FULL,
    ),
    (
        "parts and parts",
        "a JSON of 12 MB that is a gigabyte when it is parsed",
        corpus.raw(parts),
        ANY,
    ),
    (
        "an answer of a hundred thousand numbers",
        "slow to compare with everybody's",
        answer("05.9", "A_3 = np.arange(99_999.0)"),
        {"05.9"},
    ),
]
STOP += [
    (
        "files without a name",
        "more on the disk than the limit, in files that are open and removed, or never had a name",
        holding(
            "import os\nkept = []\ntry:\n    for n in range(40):\n"
            "        try:\n            f = os.open('.', os.O_TMPFILE | os.O_RDWR)\n"
            "        except OSError:\n            f = os.open(f'f{n}', os.O_CREAT | os.O_RDWR)\n"
            "            os.unlink(f'f{n}')\n"
            "        kept.append(os.write(f, bytes(2 << 20)))\nexcept OSError: pass\n"
            "import time; time.sleep(0.3)\nheld = sum(kept) > 32 << 20"
        ),
        FULL,
    ),
    (
        "a file in another's place",
        "the same with files over which others are moved",
        holding(
            "import os\nkept = []\ntry:\n    for n in range(40):\n"
            "        f = os.open(f'f{n}', os.O_CREAT | os.O_RDWR)\n"
            "        os.replace(f'f{n}', 'one')\n"
            "        kept.append(os.write(f, bytes(2 << 20)))\nexcept OSError: pass\n"
            "import time; time.sleep(0.3)\nheld = sum(kept) > 32 << 20"
        ),
        FULL,
    ),
    (
        "room without a size",
        "takes blocks beyond the end of a file, where no limit of its size looks",
        holding(
            "import ctypes, os\nlibc = ctypes.CDLL(None)\n"
            "f = os.open('f', os.O_CREAT | os.O_RDWR)\n"
            "held = libc.fallocate(f, 1, ctypes.c_long(0), ctypes.c_long(64 << 20)) == 0"
        ),
        FULL,
    ),
    (
        "slow to read",
        "a cell whose statements cost the square of their number before anything runs",
        cells(code("\n".join(f"a{n} = a{n + 1} if 0 else {n}" for n in range(30_000)))),
        ANY,
    ),
]
ATTACKS = [*EARN, *COMPANY, *READ, *STOP]
# not run where nothing protects the machine: they signal others or take its room
HARMFUL = {
    "a signal by way of an open file",
    "the same by the older way",
    "a million empty files",
    "many files of half the size",
    "a folder that cannot be removed",
    "threads that work",
    "files without a name",
    "a file in another's place",
    "room without a size",
}
HARMLESS = [one for one in ATTACKS if one[0] not in HARMFUL]


def run(level, top):
    """(unfair marks, honest students who lost something, leaks) of the class in one cage."""
    attacks = HARMLESS if level == "rlimits" else ATTACKS
    (top / "class").mkdir()
    for name in ("teacher.key", "marks.json"):
        (top / name).write_text(f"GRADER_SECRET {CANARY}", encoding="utf-8")
    facts = {"key": str(top / "teacher.key"), "class": str(top / "class")}
    for number, (_, _, make, _) in enumerate(attacks):
        _put(top / "class" / f"attack{number:02d}", make, facts)
        if number % HONEST == 0:
            _put(top / "class" / f"honest{number:02d}", lambda notebook, facts: None, facts)
    os.environ["GRADER_SECRET"] = CANARY
    results, planned = grade(
        top / "class", top / "out", settings=Settings(limits=LIMITS, cage=level)
    )
    publish(planned, results, (), top / "out")
    found = {graded.student: graded for graded in results}
    unfair = [
        f"{name}: {one.status}, lost {sorted(_lost(one))}; {'; '.join(one.notes)[:200]}"
        for number, (name, _, _, lost) in enumerate(attacks)
        if not _fair(one := found[f"attack{number:02d}"], lost)
    ]
    harmed = [g.student for g in results if g.student.startswith("honest") and g.points != g.of]
    texts = [path for path in (top / "out").rglob("*") if path.is_file()]
    leaks = [path.name for path in texts if CANARY in path.read_text(encoding="utf-8")]
    return len(attacks), unfair, harmed, leaks


def _put(folder, make, facts):
    notebook = corpus.solved()
    made = make(notebook, facts)
    raw = made if isinstance(made, bytes) else json.dumps(notebook).encode()
    folder.mkdir()
    for name, data in (made if isinstance(made, dict) else {"05-link-matrix.ipynb": raw}).items():
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_bytes(data)


def _lost(graded):
    return {mark.exercise for mark in graded.marks if mark.points < mark.of}


def _fair(graded, lost):
    if lost == ANY:
        return 0 <= graded.points <= graded.of
    found = _lost(graded)  # who loses more by an attack has done that alone
    return graded.status == "graded" and (set(lost) <= found if lost else not found)


def main():
    known = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    known.add_argument("--level", action="append", choices=["bubblewrap", "landlock", "rlimits"])
    for level in known.parse_args().level or ["bubblewrap", "landlock"]:
        try:
            Cage(level).close()
        except ValueError as error:
            print(f"{level}: {error}")
            continue
        with tempfile.TemporaryDirectory() as top:
            count, unfair, harmed, leaks = run(level, Path(top))
        print(f"{level}: {count - len(unfair)} of {count} attacks came to nothing")
        print(*(f"  got through, or cost too much: {line}" for line in unfair), sep="\n")
        print(f"  honest students who lost something: {harmed or 'none'}; leaks: {leaks or 'none'}")


if __name__ == "__main__":
    with contextlib.suppress(KeyboardInterrupt):
        main()
