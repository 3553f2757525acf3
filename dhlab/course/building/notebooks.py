"""What a source becomes: the lesson that is handed out, and the solution with its outputs."""

import re

import nbformat
from nbformat import NotebookNode

from ...view.explorer.stored import without_widgets
from .reading import ROOT

__all__ = ["lesson_notebook", "ran", "solution_notebook", "without_outputs"]

REGION = re.compile(
    r"^([ \t]*)### BEGIN SOLUTION[ \t]*\n.*?### END SOLUTION[ \t]*$", re.MULTILINE | re.DOTALL
)
# the beginning of a line of code with dots
DOTS = re.compile(r"^(?=([ \t]*)[^#\"\n]*\.\.\.)", re.MULTILINE)
HERE = "\0"  # where a solution stood
SECONDS = 120  # for a cell


def lesson_notebook(source: NotebookNode) -> NotebookNode:
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


def solution_notebook(source: NotebookNode) -> NotebookNode:
    """The notebook with its outputs, from one run from top to bottom."""
    notebook = without_widgets(ran(source))
    for cell in notebook.cells:
        cell.metadata.pop("execution", None)
        if cell.cell_type == "code":
            cell.outputs = [output for output in cell.outputs if not _taken_back(output)]
    notebook.metadata = nbformat.from_dict(source).metadata
    return notebook


def _taken_back(output):
    """Whether it is what a search says on its way on a slow machine: nothing in the end."""
    return dict(output.get("data", {"": "kept"})) == {"text/plain": ""}


def ran(notebook: NotebookNode) -> NotebookNode:
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


def without_outputs(notebook: NotebookNode) -> NotebookNode:
    """A copy with outputs and counts taken out: what a rebuild must give again exactly."""
    bare = nbformat.from_dict(notebook)
    for cell in bare.cells:
        if cell.cell_type == "code":
            cell.outputs, cell.execution_count = [], None
    return bare
