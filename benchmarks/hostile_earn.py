"""Attacks that would earn a mark."""

from corpus import ANY, answer, closed, first
from corpus_making import IDENTITY, TRANSFORM, as_teacher

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
            "import dhlab.grading.inside.reading.slices as s\ns.statements = lambda *a: None"
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
