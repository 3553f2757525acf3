"""Building the site: pages from ``docs/``, the lessons as they are handed out, all cells run, no
reader's browser sent elsewhere.

    python docs/build.py          # docs/_build/html
    python docs/build.py OUT      # OUT/html
    python docs/build.py --live   # lessons that run in their page as well, 37 MB more
    python docs/build.py --class  # the class edition: without the worked answers
    python docs/build.py --both   # the site, and the class edition in docs/_build/class/html

In OUT the folders html, source, doctrees, executed and class belong to the build.

A lesson is run again when it or anything in ``dhlab`` has changed; a cell that fails, and any
warning of Sphinx, ends the build.
"""

import argparse
import functools
import gc
import hashlib
import os
import re
import shutil
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from importlib.metadata import version
from pathlib import Path

import jupytext
import nbformat
from answers import with_answers
from finishing import finish
from kernels import Forked
from library import library, linked, with_arms
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError
from reference import filled_in
from sphinx.cmd.build import main as sphinx

from dhlab.view.explorer import without_widgets

__all__ = ["build", "edition", "executed", "pages"]

DOCS = Path(__file__).resolve().parent
ROOT = DOCS.parent
NOTE = """:::{admonition} Read it here, do it in Jupyter
:class: tip
This is the lesson as it is handed out: nothing is filled in, so every check says *Not attempted
yet*. To work in it, type `make lab`; [Set up](../index.md#set-up) says how to begin. Or take
<a href="{name}.ipynb" download>the notebook</a> to a Jupyter of your own that has dhlab.
:::"""
ALIASES = {"02-parameters": "! atan2, ! arctan2"}  # what the search finds a lesson by as well
PARTS = ("", "reference/", "benchmarks/", "bench/")  # where pages, and what pages include, stand


def build(out, answers=True, both=False):
    """Everything, into ``out``; returns Sphinx's exit status. Only the runs of notebooks are kept
    from the build before. ``both`` adds the class edition, in the folder ``class``.
    """
    texts = pages(out / "executed")
    for name in ("source", "doctrees", "html", "class"):
        shutil.rmtree(out / name, ignore_errors=True)
    html, theirs, status = out / "html", out / "class" / "html", 0
    if both:
        status = edition(out, theirs, texts, answers=False)
        # Sphinx goes on from there, with the lessons alone; it copies _static itself
        shutil.copytree(theirs, html, ignore=shutil.ignore_patterns("_static"))
    status = edition(out, html, texts, answers) or status
    if both:
        _with_all_entries(html, theirs)
        finish(theirs)
    finish(html)
    return status


def edition(out, html, texts, answers):
    """The pages that Sphinx makes of the texts, into the folder ``html``; returns its exit status.
    With ``answers`` a worked one is folded under each exercise.
    """
    source = out / "source"
    for name, text in texts.items():
        lesson = Path(name).stem if name.startswith("lessons/") and answers else ""
        _write(source / name, with_answers(text, lesson) if lesson[:2].isdigit() else text)
    for picture in (*DOCS.glob("benchmarks/*.svg"), *DOCS.glob("_static/*.png")):
        target = source / picture.relative_to(DOCS)
        target.parent.mkdir(exist_ok=True)
        shutil.copy2(picture, target)
    options = ["-W", "--keep-going", "-q", "-b", "html", "-c", str(DOCS)]
    status = sphinx([*options, "-d", str(out / "doctrees"), str(source), str(html)])
    for path in (ROOT / "lessons").glob("*.ipynb"):  # to be downloaded
        shutil.copy(path, html / "lessons")
    return status


def _with_all_entries(html, other):
    """Give a search index the entries of another, of the same pages: Sphinx forgets those of the
    pages that it does not read again.
    """
    entries = r'(?<="indexentries":)\{.*?\}'
    text = (other / "searchindex.js").read_text(encoding="utf-8")
    whole = re.search(entries, text)[0]
    path = html / "searchindex.js"
    text = path.read_text(encoding="utf-8")
    path.write_text(re.sub(entries, lambda _: whole, text), encoding="utf-8", newline="\n")


def _write(path, text):
    """What stands there already stays, with its time, so that Sphinx does not read it again."""
    if not path.exists() or path.read_text(encoding="utf-8") != text:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8", newline="\n")


def pages(cache):
    """What Sphinx reads, by name: pages as they are, and notebooks (lessons and pages with cells)
    after a run.
    """
    plain, notebooks = {}, {}
    for path in sorted(path for part in PARTS for path in DOCS.glob(f"{part}*.md")):
        text = with_arms(path.read_text(encoding="utf-8"))
        if "{code-cell}" in text:
            notebooks[path.stem] = jupytext.reads(text, fmt="md:myst")
        else:
            plain[path.relative_to(DOCS).as_posix()] = filled_in(text)
    for path in sorted((ROOT / "lessons").glob("*.ipynb")):
        notebooks[f"lessons/{path.stem}"] = with_note(nbformat.read(path, as_version=4), path.stem)
    plain["arms.md"] = linked(plain["arms.md"])
    plain["lessons/glossary.md"] = (ROOT / "lessons" / "glossary.md").read_text(encoding="utf-8")
    with ThreadPoolExecutor(2) as pool:
        runs = dict(
            zip(
                notebooks,
                pool.map(lambda name: executed(name, notebooks[name], cache), notebooks),
                strict=True,
            )
        )
    for path in set(cache.rglob("*.ipynb")) - set(runs.values()):
        path.unlink()
    texts = plain | {
        f"{name}.ipynb": path.read_text(encoding="utf-8") for name, path in runs.items()
    }
    return {name: _relinked(text, runs) for name, text in texts.items()} | library()


def _relinked(text, runs):
    """Links to a page with cells, which is Markdown here and a notebook once it has been run."""
    names = "|".join(name for name in runs if "/" not in name)
    return re.sub(rf"\]\(((?:\.\./)?(?:{names}))\.md", r"](\1.ipynb", text)


def with_note(notebook, name):
    """A lesson with a line under its title that says where it is worked through."""
    title, _, rest = notebook.cells[0].source.partition("\n")
    note = NOTE.replace("{name}", name)
    if name in ALIASES:
        note = f"```{{index}} {ALIASES[name]}\n```\n\n{note}"
    notebook.cells[0].source = f"{title}\n\n{note}\n{rest}"
    return notebook


def executed(name, notebook, cache):
    """The file of a notebook with its outputs; run only when there is no stored run of the same
    cells and the same ``dhlab``.

    What cells print to stderr goes to the terminal and not to the page.
    """
    for position, cell in enumerate(notebook.cells):
        cell["id"] = f"cell-{position:03d}"
    stored = cache / f"{name}.{_key(notebook)}.ipynb"
    if not stored.exists():
        _run(name, notebook)
        _write(stored, nbformat.writes(notebook) + "\n")
    return stored


def _key(notebook):
    """A fingerprint of all that the outputs depend on."""
    return hashlib.sha256(nbformat.writes(notebook).encode() + _ours()).hexdigest()[:16]


@functools.cache
def _ours():
    """What of it is the same for all notebooks."""
    found = hashlib.sha256()
    for path in sorted(
        p
        for p in (ROOT / "dhlab").rglob("*")
        if p.suffix in (".py", ".pyi", ".yaml", ".js", ".urdf", ".csv")
        and "node_modules" not in p.parts
    ):
        found.update(path.read_bytes())
    for package in ("numpy", "matplotlib", "ipython"):
        found.update(version(package).encode())
    return found.digest()


def _run(name, notebook):
    with tempfile.TemporaryDirectory() as empty:  # no learner's log above it
        try:
            NotebookClient(
                notebook,
                timeout=300,
                kernel_name="python3",
                kernel_manager_class=Forked,
                shutdown_kernel="immediate",
                extra_arguments=["--IPKernelApp.log_level=40"],
                resources={"metadata": {"path": empty}},
            ).execute(env=os.environ | {"DHLAB_NARROW_PICTURES": "yes"})
        except CellExecutionError as error:
            raise SystemExit(f"{name}: a cell failed, so no site was built\n{error}") from None
    for cell in without_widgets(notebook).cells:
        cell.metadata.pop("execution", None)
        noise = [
            o for o in cell.get("outputs", []) if o.output_type == "stream" and o.name == "stderr"
        ]
        for output in noise:
            print(f"{name}, {cell.id}, to stderr: {output.text.strip()}", file=sys.stderr)
            cell.outputs.remove(output)


def main():
    """The command line."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("out", nargs="?", type=Path, default=DOCS / "_build")
    parser.add_argument("--live", action="store_true", help="with Python for the pages")
    which = parser.add_mutually_exclusive_group()
    which.add_argument(
        "--class", action="store_false", dest="answers", help="without the worked answers"
    )
    which.add_argument("--both", action="store_true", help="and the class edition, in OUT/class")
    given = parser.parse_args()
    gc.disable()  # Sphinx keeps nearly all it makes; to look what of it may go takes long
    status = build(given.out.resolve(), given.answers, given.both)
    if given.live:
        sys.path.insert(0, str(DOCS / "live"))
        from gather import into, pinned
        from lite import lite

        into(given.out.resolve() / "html")
        lite(given.out.resolve() / "html", pinned())
    sys.exit(status)


if __name__ == "__main__":
    main()
