"""The reference names everything that is public, once, each with an example."""

import importlib
import inspect
import pathlib
import sys

import pytest

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "docs"))
import reference

PAGES = reference.rooms()
NAMES = {name: page for page in PAGES for name in reference.room(page)[1]}


def the(name):
    """What a public name stands for, even where a module has the same name."""
    module, _, last = name.rpartition(".")
    return getattr(sys.modules.get(module) or importlib.import_module(module), last)


def public():
    """Every public function and class, by its name; modules are pages, and constants explain
    themselves.
    """
    for page in PAGES:
        module, _ = reference.room(page)
        module = sys.modules.get(module) or importlib.import_module(module)
        for name in getattr(module, "__all__", ()):
            if callable(getattr(module, name)):
                yield f"{module.__name__}.{name}", getattr(module, name)


def test_every_file_is_a_page_of_the_reference():
    assert sorted(PAGES) == sorted(path.stem for path in reference.FOLDER.glob("*.md"))


def test_every_public_name_stands_in_the_reference_once():
    listed = [name for page in PAGES for name in reference.room(page)[1]]
    things = [id(the(name)) for name in listed]
    assert len(set(things)) == len(things), "a thing has two entries"
    known = dict(public())
    assert [name for name, thing in known.items() if id(thing) not in things] == []
    assert [name for name in listed if name not in known] == [
        "dhlab.robots.search",
        "dhlab.robots.adding.add",
        "dhlab.robots.example",
    ]


@pytest.mark.parametrize("name", NAMES)
def test_an_entry_says_what_it_is_for_and_has_an_example(name):
    text = inspect.getdoc(the(name))
    assert text.split("\n\n")[0].rstrip().endswith("."), "one sentence first"
    assert ">>> " in text, f"{name} has no example"


def test_a_page_is_written_out_for_sphinx():
    page = reference.FOLDER / "files.md"
    text = reference.filled_in(page.read_text(encoding="utf-8"))
    assert text.startswith("# Files\n")
    assert ".. automodule:: dhlab.formats\n" in text
    assert "   dhlab.read_urdf\n" in text
    assert ".. autofunction:: dhlab.read_urdf\n" in text
    arm = reference.filled_in("```{room} dhlab\ndhlab.Arm\n```\n")
    assert ".. autoclass:: dhlab.Arm\n   :members:\n\n   .. automethod:: dhlab.Arm.forward" in arm
    assert "automethod:: dhlab.Arm.save" not in arm, "its own methods are among the members"
    overview = reference.filled_in("```{rooms}\nfiles\n```\n")
    assert "| [Files](reference/files.md) |" in overview
    assert "`~dhlab.read_urdf`" in overview
