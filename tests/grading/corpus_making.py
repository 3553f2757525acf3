"""What the attacks of hostile.py are made of: changes of the solved notebook of lesson 05."""

import io
import json
import warnings
import zipfile

import corpus
from corpus import answer, closed, first


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


RIGHT = "def right(case):\n    theta, d, a, alpha = map(float, case)\n" + "".join(
    f"    {line}\n" for line in RIGHT_FORM.splitlines()
)


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
