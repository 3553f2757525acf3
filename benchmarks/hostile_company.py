"""Attacks of one program on the next, and on what all of them are born with."""

from corpus import answer, closed
from corpus_making import IDENTITY, RIGHT, RIGHT_FORM, in_company

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
        "the first program replaces the room's encoder by one that sends the right answer",
        in_company(
            f"{RIGHT}\nfor m in list(sys.modules.values()):\n"
            "    if getattr(m, '__name__', '').endswith('inside.calls'):\n"
            "        m.encode = lambda v, e=m.encode: e(right(sys._getframe(1).f_locals['case']))",
            IDENTITY,
        ),
        {"05.6"},
    ),
    (
        "renames itself in the room",
        "before it is chosen, it is the program of another task, which may use the moves",
        answer(
            "05.1",
            "import sys\nf = sys._getframe()\nwhile f:\n"
            "    room = f.f_locals.get('self')\n"
            "    if hasattr(room, 'request'): room.key = room.request['call'] = '05.6'\n"
            "    f = f.f_back\n"
            "def rot_x(alpha):\n    from dhlab import transform\n"
            "    return transform.rot_x(alpha)\ndh_closed = rot_x",
        ),
        {"05.1"},
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
