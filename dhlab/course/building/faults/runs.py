"""What keeps a lesson from being handed out once it and its solution have been run."""

import re
from pathlib import Path

from nbformat import NotebookNode

from ...exercises import exercises
from ...kinds import Explain, Prediction, PreTest
from ...verdict import MARKS, NOT_ATTEMPTED, RECORDED, RIGHT
from ..reading import lines_of, read_source
from .cells import CALL
from .sources import refuse

__all__ = ["refuse_runs"]

VERDICT = re.compile(rf"([{''.join(mark for mark, _ in MARKS.values())}]) (\S+)  .*")
STATUS = {mark: status for status, (mark, _) in MARKS.items()}


def refuse_runs(path: Path, solution: NotebookNode, handed_out: NotebookNode) -> None:
    """Refuse a solution that its checks do not find right, and a notebook that answers an exercise
    as it is handed out.

    Parameters
    ----------
    path : Path
        The source.
    solution, handed_out : notebook
        Both after a run.

    Raises
    ------
    ValueError
        A sentence for each thing that is wrong.
    """
    lines, name = lines_of(path, read_source(path)), f"{path.parent.name}/{path.name}"
    for notebook, what, wanted, advice in (
        (solution, "the solution", _full, "correct the solution, or the exercise"),
        (
            handed_out,
            "the lesson that is handed out",
            lambda key: NOT_ATTEMPTED,
            (
                "leave dots (...) to be replaced, and the answer between ### BEGIN SOLUTION and ###"
                " END SOLUTION"
            ),
        ),
    ):
        failed = [
            (cell, output)
            for cell in notebook.cells
            if "raises-exception" not in cell.metadata.get("tags", [])
            for output in cell.get("outputs", ())
            if output.output_type == "error"
        ]
        for cell, error in failed[:1]:
            refuse(
                [
                    f"{name}, line {lines[cell.id]}: expected {what} to run, found {error.ename} in"
                    f" this cell: {(error.evalue.splitlines() or [''])[0]}; correct it"
                ]
            )
        refuse(
            [
                f"{name}, line {lines[cell.id]}: expected {key} to be {wanted(key)!r} in {what},"
                f" found {said!r}; {advice}"
                for cell, key, status, said in _verdicts(notebook)
                if status != wanted(key)
            ]
        )


def _full(key):
    return RECORDED if isinstance(exercises()[key], (Explain, PreTest, Prediction)) else RIGHT


def _verdicts(notebook):
    """(cell, id, status, the verdict's first line) of every check and prediction."""
    for cell in notebook.cells:
        said = "\n".join(
            output.data.get("text/plain", "")
            for output in cell.get("outputs", ())
            if output.output_type in ("execute_result", "display_data")
        )
        shown = {found[2]: found for found in VERDICT.finditer(said)}
        for key in (
            dict.fromkeys(
                number for call, number in CALL.findall(cell.source) if call in ("check", "predict")
            )
            if cell.cell_type == "code"
            else ()
        ):
            found = shown.get(key)
            yield (
                cell,
                key,
                found and STATUS[found[1]],
                found[0] if found else "no verdict: the check must be the last line of its cell",
            )
