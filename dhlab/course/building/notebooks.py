"""Building the course: ``solutions/NN-name.md`` becomes an executed solution and the lesson that is
handed out.

python -m dhlab.course.building.notebooks            # lint, then rebuild everything python -m
dhlab.course.building.notebooks 04         # lint and rebuild one lesson python -m
dhlab.course.building.notebooks --check    # say what differs from what is committed, change nothing
"""

import argparse
import re
import sys
from pathlib import Path

import nbformat

from ...formats.files import write_text
from ...view.explorer.stored import without_widgets
from ..exercises import exercises

__all__ = [
    "sources",
    "read_source",
    "lesson_notebook",
    "solution_notebook",
    "without_outputs",
    "build",
    "stale",
    "ran",
    "lines_of",
]

ROOT = Path(__file__).parents[3]
SOLUTIONS, LESSONS = ROOT / "solutions", ROOT / "lessons"
REGION = re.compile(
    r"^([ \t]*)### BEGIN SOLUTION[ \t]*\n.*?### END SOLUTION[ \t]*$", re.MULTILINE | re.DOTALL
)
DOTS = re.compile(
    r"^(?=([ \t]*)[^#\"\n]*\.\.\.)", re.MULTILINE
)  # the beginning of a line of code with dots
HERE = "\0"  # where a solution stood
SECONDS = 120  # for a cell
KERNEL = {
    "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
    "language_info": {"name": "python"},
}


def sources(only=()):
    """The lessons' sources, in order: all of them, or those named by number.

    Raises
    ------
    ValueError
        A number without a lesson.
    """
    found = sorted(SOLUTIONS.glob("[0-9][0-9]-*.md")) if SOLUTIONS.is_dir() else []
    numbers = [path.name[:2] for path in found]
    for number in only:
        if number not in numbers:
            raise ValueError(
                f"expected the number of a lesson ({', '.join(numbers)}), found {number!r}; write"
                " it with two digits, such as 05"
            )
    return [path for path in found if not only or path.name[:2] in only]


def read_source(path):
    """A lesson's source as a notebook: cell ids from lesson and position, nbgrader's metadata on
    exercises and checks.

    Raises
    ------
    ValueError
        The head, or what stands between a cell's first line and its code, cannot be read.
    """
    notebook = _parsed(path)
    lesson, about = path.name[:2], notebook.metadata.get("dhlab", {})
    if not isinstance(about, dict):
        raise ValueError(
            f"{_name(path)}: expected dhlab: in the head with lines such as minutes: 15 under it,"
            f" found {about!r}; indent them by two spaces"
        )
    notebook.metadata = nbformat.from_dict({**KERNEL, "dhlab": {"lesson": lesson, **about}})
    notebook.nbformat, notebook.nbformat_minor = 4, 5
    for position, cell in enumerate(notebook.cells):
        cell["id"] = f"{lesson}-{position:03d}"
        if cell.cell_type == "code":
            cell.execution_count, cell.outputs = None, []
            _add_grading(cell)
    return notebook


def _parsed(path):
    import jupytext
    from jupytext.myst import MystMetadataParsingError
    from yaml import YAMLError

    try:
        return jupytext.reads(path.read_text(encoding="utf-8"), fmt="md:myst")
    except (YAMLError, MystMetadataParsingError) as error:
        mark = getattr(error, "problem_mark", None)
        found = getattr(error, "problem", None) or " ".join(str(error).split())
        raise ValueError(
            f"{_name(path)}{f', line {mark.line + 1}' if mark else ''}: expected YAML in the head"
            f" and in the lines that begin with a colon, found: {found}; look there and in the line"
            " above for a bracket, a quote or an indent"
        ) from None


def _name(path):
    return f"{path.parent.name}/{path.name}"


def lines_of(path, notebook):
    """Where each cell's text begins in its source: {cell id: line number}."""
    text, lines, at = path.read_text(encoding="utf-8"), {}, 0
    for cell in notebook.cells:
        found = text.find("\n" + cell.source, at)
        at = found + 1 if found >= 0 else at
        lines[cell.id] = text.count("\n", 0, at) + 1
        at += len(cell.source) if found >= 0 else 0
    return lines


def _add_grading(cell):
    """nbgrader's metadata: an exercise's stub is a solution cell, its check a graded one."""
    number = cell.metadata.get("exercise")
    checked = re.match(r'check\("([^"]+)"', cell.source)
    if number is not None:
        cell.metadata["nbgrader"] = {
            "grade": False,
            "grade_id": f"stub-{number}",
            "locked": False,
            "schema_version": 3,
            "solution": True,
            "task": False,
        }
    elif checked and checked[1] in exercises():
        cell.metadata["nbgrader"] = {
            "grade": True,
            "grade_id": f"check-{checked[1]}",
            "locked": True,
            "points": exercises()[checked[1]].points,
            "schema_version": 3,
            "solution": False,
            "task": False,
        }


def lesson_notebook(source):
    """What is handed out: the solutions cut out, a stub in their place, no outputs."""
    notebook = nbformat.from_dict(source)
    for cell in notebook.cells:
        if cell.cell_type == "code" and REGION.search(cell.source):
            cell.source = _stub(cell.source)
    return notebook


def _stub(source):
    """A cell without its solution: what is to be done stands in its place, or above the dots that
    are to be replaced.
    """
    stub = REGION.sub(
        lambda region: f"{region[1]}...  # your code here" if region[1] else HERE, source
    )
    todo = (
        "# your answer here: replace the dots"
        if "..." in stub
        else "# your answer here: change the lines above"
    )
    if HERE not in stub or not DOTS.search(stub):
        return stub.replace(HERE, todo)
    return DOTS.sub(
        lambda line: f"{line[1]}{todo}\n",
        stub.replace(f"\n{HERE}", "").replace(f"{HERE}\n", ""),
        count=1,
    )


def solution_notebook(source):
    """The notebook with its outputs, from one run from top to bottom."""
    notebook = without_widgets(ran(source))
    for cell in notebook.cells:
        cell.metadata.pop("execution", None)
    notebook.metadata = nbformat.from_dict(source).metadata
    return notebook


def ran(notebook):
    """A copy of a notebook after a run from top to bottom; an error is among its outputs."""
    from nbclient import NotebookClient
    from nbclient.exceptions import CellTimeoutError, DeadKernelError

    notebook = nbformat.from_dict(notebook)
    try:
        NotebookClient(
            notebook,
            timeout=SECONDS,
            kernel_name="python3",
            allow_errors=True,
            coalesce_streams=True,
            extra_arguments=["--IPKernelApp.log_level=40"],
            resources={"metadata": {"path": str(ROOT)}},
        ).execute()
    except (CellTimeoutError, DeadKernelError) as error:
        found = (
            f"one that takes longer than {SECONDS} s"
            if isinstance(error, CellTimeoutError)
            else "one that ends Python"
        )
        raise ValueError(
            f"lesson {notebook.metadata['dhlab']['lesson']}: expected cells that run to their end,"
            f" found {found}; look for a loop without an end, or an exit"
        ) from None
    return notebook


def without_outputs(notebook):
    """A copy with outputs and counts taken out: what a rebuild must give again exactly."""
    bare = nbformat.from_dict(notebook)
    for cell in bare.cells:
        if cell.cell_type == "code":
            cell.outputs, cell.execution_count = [], None
    return bare


def build(only=()):
    """Rebuild the lessons named by number, or all.

    Raises
    ------
    ValueError
        A source that cannot become a lesson, a broken line of the contract, a solution that its
        checks do not find right, an answer that would be handed out; of this lesson, then, nothing
        is written.
    """
    from .contract import report
    from .faults import refuse_runs, refuse_sources

    try:
        refuse_sources(sources(only))
    except ValueError as error:
        raise ValueError(f"nothing was built:\n{error}") from None
    _, failures = report(only)
    if failures:
        raise ValueError(
            "the lessons break their contract, nothing was built:\n" + "\n".join(failures)
        )
    LESSONS.mkdir(exist_ok=True)
    for path in sources(only):
        source = read_source(path)
        lesson, solution = lesson_notebook(source), solution_notebook(source)
        refuse_runs(path, solution, ran(lesson))
        write_text(LESSONS / f"{path.stem}.ipynb", nbformat.writes(lesson) + "\n", overwrite=True)
        write_text(
            SOLUTIONS / f"{path.stem}.ipynb", nbformat.writes(solution) + "\n", overwrite=True
        )
        print(f"built {path.stem}")
    glossary = SOLUTIONS / "glossary.md"
    write_text(LESSONS / "glossary.md", glossary.read_text(encoding="utf-8"), overwrite=True)


def stale(only=()):
    """Which committed notebooks a rebuild would change (outputs apart)."""
    differing = []
    for path in sources(only):
        source = read_source(path)
        for committed, wanted in (
            (LESSONS / f"{path.stem}.ipynb", lesson_notebook(source)),
            (SOLUTIONS / f"{path.stem}.ipynb", source),
        ):
            found = (
                nbformat.writes(without_outputs(nbformat.read(committed, as_version=4)))
                if committed.exists()
                else ""
            )
            if found != nbformat.writes(wanted):
                differing.append(str(committed.relative_to(ROOT)))
    glossary = SOLUTIONS / "glossary.md", LESSONS / "glossary.md"
    if not glossary[1].exists() or glossary[0].read_bytes() != glossary[1].read_bytes():
        differing.append("lessons/glossary.md")
    return differing


def main():
    """The command line of this module."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("lessons", nargs="*", help="numbers such as 05; all when left out")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    try:
        if options.check:
            differing = stale(options.lessons)
            print(
                "\n".join(
                    f"{name}: not what its source gives; run make lessons" for name in differing
                )
                or "all notebooks are what their sources give"
            )
            sys.exit(bool(differing))
        build(options.lessons)
    except ValueError as error:
        sys.exit(str(error))


if __name__ == "__main__":
    main()
