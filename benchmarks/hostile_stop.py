"""Attacks that would stop the class, or take more than the limits give."""

import corpus
from corpus import ANY, FULL, answer, code, first
from corpus_making import (
    cells,
    holding,
    into_first,
    many_zips,
    markdown,
    nested,
    parts,
    zipped_twice,
)

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
