"""The reference's pages: what stands in a fenced block of a page becomes an overview table and an
entry for each name, made of docstrings.

A page in ``docs/reference/`` has one block, ``{room}``, with the room's module behind it and the
names below it; ``docs/reference.md`` has one block ``{rooms}`` with the names of the pages.
"""

import importlib
import inspect
import pkgutil
import re
from pathlib import Path

__all__ = ["filled_in", "room", "rooms"]

FOLDER = Path(__file__).parent / "reference"
ROOM = re.compile(r"^```\{room\} (\S+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
ROOMS = re.compile(r"^```\{rooms\}\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def room(page):
    """The module and the names on a page of the reference, by the page's name."""
    module, names = ROOM.search((FOLDER / f"{page}.md").read_text(encoding="utf-8")).groups()
    return module, names.split()


def rooms():
    """The pages of the reference, in their order."""
    return ROOMS.search(FOLDER.with_suffix(".md").read_text(encoding="utf-8"))[1].split()


def filled_in(text):
    """A page's text with its blocks written out in what Sphinx reads."""
    text = ROOM.sub(lambda found: _room(found[1], found[2].split()), text)
    return ROOMS.sub(lambda found: _rooms(found[1].split()), text)


def _room(module, names):
    """What the module is for, an overview, and an entry for each name, with what its class has."""
    rows = "\n".join(f"   {name}" for name in names)
    entries = "\n\n".join(_entry(name) for name in names)
    overview = f".. autosummary::\n   :nosignatures:\n\n{rows}"
    purpose = f".. automodule:: {module}\n\n.. currentmodule:: None"
    return f"```{{eval-rst}}\n{purpose}\n\n{overview}\n\n{entries}\n```"


def _entry(name):
    """With a class come its methods; those that it has from another class of ours first, as a chain
    comes before what an arm adds to it.
    """
    named = pkgutil.resolve_name(name)
    if not inspect.isclass(named):
        return f".. autofunction:: {name}"
    inherited = "\n".join(f"\n   .. automethod:: {name}.{method}" for method in _inherited(named))
    return f".. autoclass:: {name}\n   :members:\n{inherited}"


def _inherited(named):
    """The public methods of a class's bases that are ours and that it does not define itself."""
    return [
        method
        for base in named.__mro__[1:]
        if base.__module__.startswith("dhlab.")
        for method, value in vars(base).items()
        if not method.startswith("_") and inspect.isfunction(value) and method not in vars(named)
    ]


def _rooms(pages):
    """A table of the pages, what each is for and its names; and the pages as children."""
    rows = []
    for page in pages:
        module, names = room(page)
        title = (FOLDER / f"{page}.md").read_text(encoding="utf-8").partition("\n")[0].strip("# ")
        words = inspect.getdoc(importlib.import_module(module)).split("\n\n")[0].replace("\n", " ")
        links = ", ".join(f"{{py:obj}}`~{name}`" for name in names)
        rows.append(f"| [{title}](reference/{page}.md) | {words} | {links} |")
    table = "\n".join(["| page | what it is for | names |", "|---|---|---|", *rows])
    children = "\n".join(f"reference/{page}" for page in pages)
    return f"{table}\n\n```{{toctree}}\n:hidden:\n\n{children}\n```"
