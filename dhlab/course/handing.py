"""Answers given by hand, on their way into the notebook.

A check of an answer that is still dots shows cards, or bare axes, under it. What hands do there is
only stored. When the answer's own cell is run again, what was stored takes the place of its dots:
in that run, and in the text of the cell, so that the notebook alone holds the answer. No other cell
is ever changed, and nothing that was typed is overwritten.

Where the program that runs the notebook does not name its cells (nbclient, graders), nothing of
this happens.
"""

import ast
import re
import sys
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np

from .celltext import calls, set_to, tree_of, written
from .kinds import Exercise, Lettered, Order
from .kinds.frames.placed import Frames
from .kinds.lettered import I_DONT_KNOW, UNDECIDED
from .verdict import NOT_ATTEMPTED, Verdict

__all__ = ["as_rows", "offer", "watch"]

NOT_WRITTEN = (
    "is not in the notebook yet. Run the cell with {name} = again, and it is written there."
)
LESSON = re.compile(r"(\d\d[a-z]?)-(\d+)")  # the id of a cell in a lesson
_texts: dict[str, str] = {}  # what was run, by the cell's id, the latest last
_here: list[str | None] = [None]  # the cell that runs
_offers: dict[str, "Offer"] = {}  # by the exercise's id


@dataclass
class Offer:
    """What is shown for an exercise, and the cell and the name that its answer belongs to."""

    exercise: Exercise
    cell: str
    name: str
    shown: Any

    def chosen(self) -> Any:
        """What hands have made, plain; None while there is nothing."""
        if isinstance(self.exercise, Frames):
            placement = self.shown.placing.placement
            return placement.placed if placement.z else None
        letters = self.shown.chosen
        if not self.shown.complete:
            return None
        if UNDECIDED in letters:
            return UNDECIDED
        return list(letters) if isinstance(self.exercise, Order) else letters[0]

    def said(self) -> str:
        """What hands have made, in words, and that it is not written yet; "" while there is
        nothing.
        """
        chosen = self.chosen()
        if chosen is None:
            return ""
        what = (
            "What you placed"
            if isinstance(self.exercise, Frames)
            else f"What you chose, {', '.join(chosen)},"
        )
        return f"{what} {NOT_WRITTEN.format(name=self.name)}"


def as_rows(answer: Any) -> Any:
    """A board or an explorer with frames as the rows that an answer has; all else as it is.

    Examples
    --------
    >>> as_rows("a")
    'a'
    """
    placing = getattr(answer, "placing", None)
    placement = answer if placing is None else placing.placement
    return placement.placed if hasattr(placement, "placed") else answer


def watch() -> None:
    """Note which cell runs, where a kernel with named cells runs them."""
    if "IPython" not in sys.modules:
        return
    from IPython import get_ipython

    shell: Any = get_ipython()
    if getattr(shell, "kernel", None) is None or any(
        isinstance(one, _Writer) for one in shell.ast_transformers
    ):
        return
    shell.events.register("pre_run_cell", partial(_note, shell))
    shell.ast_transformers.append(_Writer(shell))
    _note_now(shell)


def offer(exercise: Exercise, answer: Any, verdict: Verdict, variant: int) -> Verdict:
    """Show what hands need for an answer that was not attempted; the verdict, which also says what
    is chosen and not written yet.
    """
    if (
        verdict.status != NOT_ATTEMPTED
        or not isinstance(exercise, (Lettered, Frames))
        or "frames" in exercise.given(variant)  # broken ones, which are to be changed
    ):
        _offers.pop(exercise.id, None)
        return verdict
    found = _answers_cell(exercise.id)
    if found is None:
        return verdict
    known = _offers.get(exercise.id)
    if known is None or (known.cell, known.name) != found:
        cell, name = found
        known = Offer(exercise, cell, name, _view(exercise, answer, variant))
        _offers[exercise.id] = known
    from IPython.display import display

    display(known.shown)
    said = known.said()
    how = "Choose" if isinstance(exercise, Lettered) else "Place the frames"
    return replace(
        verdict,
        next=said
        or f"{how} above, and run the cell with {known.name} = again; or write the answer there.",
    )


def _answers_cell(exercise_id):
    """(id, name) of the cell in which an exercise is answered: above the cell that runs, the
    nearest one that set the name which is checked there; None where that is not plain.
    """
    here = _here[0]
    tree = tree_of("" if here is None else _texts[here])
    for call in [*calls(tree, "check"), *calls(tree, "predict")]:
        name = getattr(call.args[1], "id", None) if len(call.args) == 2 else None
        if name and getattr(call.args[0], "value", None) == exercise_id:
            found = [
                cell for cell in _above(here) if set_to(tree_of(_texts[cell]), name) is not None
            ]
            return (
                (found[-1], name)
                if found and not calls(tree_of(_texts[found[-1]]), "check")
                else None
            )
    return None


def _above(here):
    """The cells that have run, up to the one that runs: in the order of the lesson where their ids
    have its number, else as they ran.
    """
    at = LESSON.fullmatch(here)
    if at is None:
        return list(_texts)
    numbered = [found for found in map(LESSON.fullmatch, _texts) if found and found[1] == at[1]]
    return [
        found[0]
        for found in sorted(numbered, key=lambda found: int(found[2]))
        if int(found[2]) <= int(at[2])
    ]


def _view(exercise, answer, variant):
    from ..view.cards import Cards
    from ..view.explorer import explore

    if isinstance(exercise, Frames):
        given = exercise.given(variant)
        explorer = explore(given["axes"], mode="place", end=given["end"])
        _take_over(explorer, answer)
        return explorer
    letters, texts = exercise.letters(variant), exercise.texts()
    options = {letter: texts[key] for key, letter in letters.items()} | {UNDECIDED: I_DONT_KNOW}
    title = f"{exercise.id} {exercise.title}"
    if isinstance(exercise, Order):
        places = exercise.places or [""] * exercise.size
        cards = Cards(title, options, places, exercise.repeats)
    else:
        cards = Cards(title, options)
    cards.observe(lambda change: setattr(cards, "told", _offers[exercise.id].said()), "chosen")
    return cards


def _take_over(explorer, answer):
    """Place what was typed."""
    rows = answer if isinstance(answer, list) else []
    for column, letter in enumerate("zox"):
        for i, row in enumerate(rows):
            if np.shape(row) != () and len(row) == 3 and row[column] is not Ellipsis:
                explorer.place(f"{letter}{i}", row[column])


def _note(shell, info):
    cell = getattr(info, "cell_id", None) or _running(shell)
    _here[0] = cell
    if cell is not None:
        _texts.pop(cell, None)
        _texts[cell] = info.raw_cell


def _running(shell):
    """The id of the cell that runs, as whoever sent it says; None where nobody says."""
    kernel = getattr(shell, "kernel", None)
    if kernel is None:
        return None
    try:
        parent = kernel.get_parent("shell")
    except TypeError:  # JupyterLite's kernel has one channel alone, and passes no id on to events
        parent = kernel.get_parent()
    return parent.get("metadata", {}).get("cellId")


def _note_now(shell):
    """The cell in which the course is imported has begun before anybody noted it."""
    cell = _running(shell)
    if cell is not None:
        _here[0], _texts[cell] = cell, shell.history_manager.input_hist_raw[-1]


def _write_back(shell, text):
    """Have the notebook put a text into the cell that runs. JupyterLite's shell has the payload
    that says so, and a ``set_next_input`` that does not use it.
    """
    payload = getattr(shell, "payload_manager", None)
    if payload is None:
        shell.set_next_input(text, replace=True)
    else:
        payload.write_payload({"source": "set_next_input", "text": text, "replace": True})


class _Writer(ast.NodeTransformer):
    """Puts what hands chose into the cell that runs, where it is the answer's own."""

    def __init__(self, shell):
        self.shell = shell

    def visit(self, node):
        """A whole cell, before it runs."""
        for key, one in list(_offers.items()):
            if _here[0] is None or one.cell != _here[0]:
                continue
            chosen, text = one.chosen(), _texts[one.cell]
            del _offers[key]
            new = None if chosen is None else written(text, one.name, chosen)
            if new is not None:
                _texts[one.cell] = new
                _write_back(self.shell, new)
                node = ast.parse(new)
        return node
