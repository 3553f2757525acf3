"""Python in a page: wheels that come when they are imported, stand-ins for the parts of IPython
that dhlab asks for, and cells that run.

The page hands in the module ``page``: ``page.wheel(file)`` gives the bytes of a wheel,
``page.send(text)`` takes one message as JSON.
"""

import ast
import builtins
import importlib
import importlib.machinery
import io
import json
import linecache
import os
import site
import sys
import traceback
import types
import zipfile

import page

os.environ["MPLBACKEND"] = "agg"
COURSE = "/course"  # dhlab keeps its log of checks here, and the page keeps the log
os.makedirs(f"{COURSE}/.dhlab", exist_ok=True)
os.chdir(COURSE)
SITE = site.getsitepackages()[0]


def send(kind, **fields):
    page.send(json.dumps({"type": kind, **fields}))


class Wheels:
    """Finds what no other finder found: unpacks its wheel, then looks again."""

    def __init__(self, wheels):
        self.wheels = dict(wheels)

    def find_spec(self, name, path=None, target=None):
        file = self.wheels.pop(name, None)
        if file is None:
            return None
        send("loading", file=file)
        with zipfile.ZipFile(io.BytesIO(page.wheel(file).to_bytes())) as held:
            held.extractall(SITE)
        importlib.invalidate_caches()
        send("loaded", file=file)
        return importlib.machinery.PathFinder.find_spec(name)


sys.meta_path.append(Wheels(json.loads(page.wheels)))


# ---- what a cell shows


def bundle_of(thing):
    """What a thing shows of itself: texts by their kind."""
    if "anywidget" in sys.modules and isinstance(thing, sys.modules["anywidget"].AnyWidget):
        return thing.shown()
    whole = getattr(type(thing), "_repr_mimebundle_", None)
    found = whole(thing) if whole else {}
    found = dict(found[0] if isinstance(found, tuple) else found)
    for kind, name in KINDS.items():
        method = getattr(type(thing), name, None)
        if kind not in found and method is not None:
            value = method(thing)
            if isinstance(value, str):
                found[kind] = value
    found.setdefault("text/plain", repr(thing))
    return found


KINDS = {
    "text/html": "_repr_html_",
    "image/svg+xml": "_repr_svg_",
    "text/markdown": "_repr_markdown_",
    "text/latex": "_repr_latex_",
}


class Handle:
    """An output whose content is replaced."""

    count = 0

    def __init__(self):
        Handle.count += 1
        self.id = f"output-{Handle.count}"

    def update(self, thing, raw=False, **keywords):
        send("display", cell=shell.cell, id=self.id, data=thing if raw else bundle_of(thing))


def display(*things, raw=False, display_id=None, **keywords):
    handle = Handle() if display_id else None
    for thing in things:
        data = thing if raw else bundle_of(thing)
        send("display", cell=shell.cell, data=data, **({"id": handle.id} if handle else {}))
    return handle


class Shown:
    """Text of one kind, to be displayed."""

    def __init__(self, data):
        self.data = data


class HTML(Shown):
    def _repr_html_(self):
        return self.data


class Markdown(Shown):
    def _repr_markdown_(self):
        return self.data


class Shell:
    """As much of IPython's shell as dhlab asks for."""

    def __init__(self):
        self.cell, self.ast_transformers, self.heard, self.namespace = None, [], [], None
        self.kernel = self.events = self.history_manager = self
        self.input_hist_raw = [""]

    def register(self, event, function):
        self.heard.append(function)

    def get_parent(self, channel):
        return {"metadata": {"cellId": self.cell}}

    def set_next_input(self, text, replace=False):
        send("replace", cell=self.cell, source=text)


shell = Shell()


def module(name, **members):
    made = types.ModuleType(name)
    made.__dict__.update(members)
    sys.modules[name] = made
    return made


shown = module("IPython.display", display=display, HTML=HTML, Markdown=Markdown)
module("IPython", get_ipython=lambda: shell, version_info=(9, 0), display=shown, __path__=[])


# ---- cells


def run(cell, source):
    """Run a cell: its last expression is shown; whether it went well."""
    shell.cell, shell.input_hist_raw[0] = cell, source
    info = types.SimpleNamespace(cell_id=cell, raw_cell=source)
    for heard in shell.heard:
        heard(info)
    name = f"<cell {cell}>"
    linecache.cache[name] = (len(source), None, source.splitlines(keepends=True), name)
    try:
        tree = ast.parse(source, name)
        for transformer in shell.ast_transformers:
            tree = transformer.visit(tree)
        last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
        exec(compile(tree, name, "exec"), shell.namespace)
        if last is not None:
            value = eval(compile(ast.Expression(last.value), name, "eval"), shell.namespace)
            if value is not None and not source.rstrip().endswith(";"):
                display(value)
                shell.namespace["_"] = value
        return True
    except BaseException as error:
        send("error", cell=cell, text=told(error, name))
        return False
    finally:
        sys.stdout.flush()
        sys.stderr.flush()


def told(error, name):
    """A traceback from the cell on, without this file's own lines."""
    if isinstance(error, KeyboardInterrupt):
        return "Stopped."
    frames = traceback.extract_tb(error.__traceback__)
    start = next((k for k, frame in enumerate(frames) if frame.filename == name), len(frames))
    own = [frame for frame in frames[start:] if frame.filename.startswith("<cell")]
    head = ["Traceback (most recent call last):\n"] if own else []
    lines = traceback.format_list(own) + traceback.format_exception_only(error)
    return "".join(head + lines).rstrip()


class Stream(io.TextIOBase):
    """What is printed, on its way to the page."""

    def __init__(self, name):
        self.name_of, self.held = name, ""

    def writable(self):
        return True

    def write(self, text):
        self.held += text
        if "\n" in text or len(self.held) > 200:
            self.flush()
        return len(text)

    def flush(self):
        if self.held:
            send("stream", cell=shell.cell, name=self.name_of, text=self.held)
            self.held = ""


def fresh():
    """Names as at the start of a notebook."""
    shell.namespace = {"__name__": "__main__", "__builtins__": builtins}


def hear(message):
    """What a view on the page has to say to its widget."""
    from anywidget import widgets

    message = json.loads(message)
    try:
        widgets[message["id"]].hear(message)
    except Exception as error:
        send("error", cell=shell.cell, text="".join(traceback.format_exception_only(error)))


def log(text=None):
    """The learner's log of checks, as text; with a text, that one takes its place."""
    path = f"{COURSE}/.dhlab/progress.jsonl"
    if text is not None:
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
    if not os.path.exists(path):
        return ""
    with open(path, encoding="utf-8") as file:
        return file.read()


sys.stdout, sys.stderr = Stream("stdout"), Stream("stderr")
fresh()
