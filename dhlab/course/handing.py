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

from .kinds import Exercise, Lettered, Order
from .kinds.lettered import I_DONT_KNOW, UNDECIDED
from .kinds.placed import Frames
from .verdict import NOT_ATTEMPTED, Verdict

__all__ = ["as_rows", "offer", "watch", "written"]

NOT_WRITTEN = (
    "is not in the notebook yet. Run the cell with {name} = again, and it is written there."
)
LESSON = re.compile(r"(\d\d[a-z]?)-(\d+)")  # the id of a cell in a lesson
DIGITS = 6  # of a length in metres or a direction; hands are told to be nearer than 2 mm and 0.6°
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


def written(text: str, name: str, chosen: Any) -> str | None:
    """The text of a cell with a choice in place of the dots that ``name`` is set to; None where no
    dots stand there.

    Examples
    --------
    >>> written("# replace the dots\\nwhy = ...", "why", "c")
    '# replace the dots\\nwhy = "c"'
    >>> written('why = "a"', "why", "c") is None
    True
    >>> written("rows = [*first, [..., [0, 1], ...]]", "rows", [[1, 2, 3], [[1, 0], 5, ...]])
    'rows = [*first, [[1, 0], [0, 1], ...]]'
    """
    try:
        value = _set_to(ast.parse(text), name)
    except SyntaxError:
        return None
    edits = [] if value is None else list(_edits(value, chosen))
    if not edits:
        return None
    data = text.encode()
    starts = [0]
    for line in data.splitlines(keepends=True):
        starts.append(starts[-1] + len(line))
    for node, new in sorted(edits, key=lambda edit: (-edit[0].lineno, -edit[0].col_offset)):
        begin = starts[node.lineno - 1] + node.col_offset
        end = starts[node.end_lineno - 1] + node.end_col_offset
        data = data[:begin] + new.encode() + data[end:]
    return data.decode()


def _edits(node, chosen):
    """(node, new text) for all dots of a node that a choice has something for."""
    if chosen is Ellipsis:
        return
    dots = isinstance(node, ast.Constant) and node.value is Ellipsis
    entries = node.elts if isinstance(node, ast.List) else []
    if dots or (entries and isinstance(chosen, str) and all(map(_is_dots, entries))):
        yield node, _literal(chosen)
    elif entries and isinstance(chosen, list):
        own = [entry for entry in entries if not isinstance(entry, ast.Starred)]
        for entry, part in zip(reversed(own), reversed(chosen)):  # what is starred stands in front
            yield from _edits(entry, part)


def _is_dots(node):
    return isinstance(node, ast.Constant) and node.value is Ellipsis


def _literal(value):
    if value is Ellipsis:
        return "..."
    if isinstance(value, str):
        return f'"{value}"'
    if isinstance(value, list):
        return f"[{', '.join(map(_literal, value))}]"
    return f"{round(float(value), DIGITS) + 0.0:.{DIGITS}g}"


def _set_to(tree, name):
    """The value that a name is set to at the top of a cell, where that happens once."""
    found = [
        statement.value
        for statement in tree.body
        if isinstance(statement, ast.Assign)
        and [getattr(target, "id", "") for target in statement.targets] == [name]
    ]
    return found[0] if len(found) == 1 else None


def _calls(tree, function):
    return [
        node
        for node in ast.walk(tree)
        if isinstance(node, ast.Call) and getattr(node.func, "id", "") == function
    ]


def _answers_cell(exercise_id):
    """(id, name) of the cell in which an exercise is answered: above the cell that runs, the
    nearest one that set the name which is checked there; None where that is not plain.
    """
    here = _here[0]
    tree = _tree("" if here is None else _texts[here])
    for call in [*_calls(tree, "check"), *_calls(tree, "predict")]:
        name = getattr(call.args[1], "id", None) if len(call.args) == 2 else None
        if name and getattr(call.args[0], "value", None) == exercise_id:
            found = [
                cell for cell in _above(here) if _set_to(_tree(_texts[cell]), name) is not None
            ]
            return (
                (found[-1], name)
                if found and not _calls(_tree(_texts[found[-1]]), "check")
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


def _tree(text):
    try:
        return ast.parse(text)
    except SyntaxError:
        return ast.Module([], [])


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
