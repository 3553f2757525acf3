"""Building the course: ``solutions/NN-name.md`` becomes an executed solution and the lesson that is handed out.

    python -m dhlab.course.build            # lint, then rebuild everything
    python -m dhlab.course.build 04         # lint and rebuild one lesson
    python -m dhlab.course.build --check    # say what differs from what is committed, change nothing
"""

import argparse
import re
import sys
from pathlib import Path

import nbformat

from ..files import write_text
from ..view.explorer.stored import without_widgets
from .exercises import exercises

__all__ = ["sources", "read_source", "lesson_notebook", "solution_notebook", "without_outputs", "build", "stale"]

ROOT = Path(__file__).parents[2]
SOLUTIONS, LESSONS = ROOT / "solutions", ROOT / "lessons"
REGION = re.compile(r"^([ \t]*)### BEGIN SOLUTION\n.*?### END SOLUTION[ \t]*$", re.MULTILINE | re.DOTALL)
KERNEL = {"kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"}, "language_info": {"name": "python"}}


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
            raise ValueError(f"expected the number of a lesson ({', '.join(numbers)}), found {number!r}; write it with two digits, such as 05")
    return [path for path in found if not only or path.name[:2] in only]


def read_source(path):
    """A lesson's source as a notebook: cell ids from lesson and position, nbgrader's metadata on exercises and checks."""
    import jupytext
    notebook = jupytext.reads(path.read_text(encoding="utf-8"), fmt="md:myst")
    lesson = path.name[:2]
    notebook.metadata = nbformat.from_dict({**KERNEL, "dhlab": {"lesson": lesson, **notebook.metadata.get("dhlab", {})}})
    notebook.nbformat, notebook.nbformat_minor = 4, 5
    for position, cell in enumerate(notebook.cells):
        cell["id"] = f"{lesson}-{position:03d}"
        if cell.cell_type == "code":
            cell.execution_count, cell.outputs = None, []
            _add_grading(cell)
    return notebook


def _add_grading(cell):
    """nbgrader's metadata: an exercise's stub is a solution cell, its check a graded one."""
    number = cell.metadata.get("exercise")
    checked = re.match(r'check\("([^"]+)"', cell.source)
    if number is not None:
        cell.metadata["nbgrader"] = {"grade": False, "grade_id": f"stub-{number}", "locked": False, "schema_version": 3, "solution": True, "task": False}
    elif checked:
        cell.metadata["nbgrader"] = {"grade": True, "grade_id": f"check-{checked[1]}", "locked": True, "points": exercises()[checked[1]].points,
                                     "schema_version": 3, "solution": False, "task": False}


def lesson_notebook(source):
    """What is handed out: the solutions cut out, a stub in their place, no outputs."""
    notebook = nbformat.from_dict(source)
    for cell in notebook.cells:
        if cell.cell_type == "code":
            given = REGION.sub("", cell.source)
            todo = "# your answer here: replace the dots" if "..." in given else "# your answer here: change the lines above"
            cell.source = REGION.sub(lambda region: f"{region[1]}...  # your code here" if region[1] else todo, cell.source)
    return notebook


def solution_notebook(source):
    """The notebook with its outputs, from one run from top to bottom."""
    from nbclient import NotebookClient
    notebook = nbformat.from_dict(source)
    NotebookClient(notebook, timeout=120, kernel_name="python3", coalesce_streams=True, extra_arguments=["--IPKernelApp.log_level=40"], resources={"metadata": {"path": str(ROOT)}}).execute()
    for cell in without_widgets(notebook).cells:
        cell.metadata.pop("execution", None)
    notebook.metadata = nbformat.from_dict(source).metadata
    return notebook


def without_outputs(notebook):
    """A copy with outputs and counts taken out: what a rebuild must give again exactly."""
    bare = nbformat.from_dict(notebook)
    for cell in bare.cells:
        if cell.cell_type == "code":
            cell.outputs, cell.execution_count = [], None
    return bare


def build(only=()):
    """Rebuild the lessons named by number, or all; refuses when the linter finds a broken contract line in them."""
    from .lint import report
    _, failures = report(only)
    if failures:
        raise ValueError("the lessons break their contract, nothing was built:\n" + "\n".join(failures))
    LESSONS.mkdir(exist_ok=True)
    for path in sources(only):
        source = read_source(path)
        write_text(LESSONS / f"{path.stem}.ipynb", nbformat.writes(lesson_notebook(source)) + "\n", overwrite=True)
        write_text(SOLUTIONS / f"{path.stem}.ipynb", nbformat.writes(solution_notebook(source)) + "\n", overwrite=True)
        print(f"built {path.stem}")
    glossary = SOLUTIONS / "glossary.md"
    write_text(LESSONS / "glossary.md", glossary.read_text(encoding="utf-8"), overwrite=True)


def stale(only=()):
    """Which committed notebooks a rebuild would change (outputs apart)."""
    differing = []
    for path in sources(only):
        source = read_source(path)
        for committed, wanted in ((LESSONS / f"{path.stem}.ipynb", lesson_notebook(source)), (SOLUTIONS / f"{path.stem}.ipynb", source)):
            found = nbformat.writes(without_outputs(nbformat.read(committed, as_version=4))) if committed.exists() else ""
            if found != nbformat.writes(wanted):
                differing.append(str(committed.relative_to(ROOT)))
    glossary = SOLUTIONS / "glossary.md", LESSONS / "glossary.md"
    if not glossary[1].exists() or glossary[0].read_bytes() != glossary[1].read_bytes():
        differing.append("lessons/glossary.md")
    return differing


def main():
    """The command line of this module."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("lessons", nargs="*", help="numbers such as 05; all when left out")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    try:
        if options.check:
            differing = stale(options.lessons)
            print("\n".join(f"{name}: not what its source gives; run make lessons" for name in differing) or "all notebooks are what their sources give")
            sys.exit(bool(differing))
        build(options.lessons)
    except ValueError as error:
        sys.exit(str(error))


if __name__ == "__main__":
    main()
