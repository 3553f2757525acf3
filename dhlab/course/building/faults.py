"""What keeps a source from becoming a lesson, a sentence for each thing: where, what is expected,
what was found, what to do.
"""

import ast
import re
import traceback
from difflib import SequenceMatcher, get_close_matches
from pathlib import Path

from ...doctor import catalogue
from ...doctor.programs.explain import WRONG_VERSIONS
from ..exercises import exercises
from ..kinds import Function, Order, Prediction, PreTest, Value
from ..verdict import MARKS, NOT_ATTEMPTED, RECORDED, RIGHT
from .reading import lines_of, read_source

__all__ = ["refuse_sources", "refuse_runs", "plain_python"]

MARKER = re.compile(r"[ \t]*### (BEGIN|END) SOLUTION[ \t]*")
ALIKE = 0.7  # a comment this near to a marker is meant to be one
CALL = re.compile(r"""\b(check|given|hint|predict|reveal)\(\s*["']([^"']+)["']""")
CHECKED = re.compile(r'check\("([^"]+)"')  # at the beginning of a cell
VERDICT = re.compile(rf"([{''.join(mark for mark, _ in MARKS.values())}]) (\S+)  .*")
STATUS = {mark: status for status, (mark, _) in MARKS.items()}


def refuse_sources(paths):
    """Refuse sources that cannot become lessons, before anything is run or written.

    Raises
    ------
    ValueError
        A sentence for each thing that is wrong.
    """
    _refuse([fault for path in paths for fault in _faults(path)])


def _refuse(faults):
    if faults:
        raise ValueError("\n".join(faults))


def _faults(path):
    _refuse(_broken_exercises())
    notebook, number = read_source(path), path.name[:2]
    lines, name = lines_of(path, notebook), f"{path.parent.name}/{path.name}"
    for cell in notebook.cells:
        found = [*_markers(cell)]
        if cell.cell_type == "code":
            found += [*_numbers(cell), *_region(cell), *_python(cell)]
        yield from (f"{name}, line {lines[cell.id] + at}: {words}" for at, words in found)
    yield from (f"{name}: {words}" for words in _missing(notebook, number))
    for exercise in _of(number):
        yield from (
            f"dhlab/course/exercises/lesson{number}.py, {exercise.id}: {words}"
            for words in _exercise(exercise)
        )


def _of(number, predictions=True):
    return [
        exercise
        for key, exercise in exercises().items()
        if key.startswith(f"{number}.") and (predictions or not isinstance(exercise, Prediction))
    ]


def _broken_exercises():
    """A module of exercises that Python cannot read."""
    try:
        exercises()
    except Exception as error:
        places = [(error.filename, error.lineno)] if isinstance(error, SyntaxError) else []
        places += [
            (frame.filename, frame.lineno)
            for frame in reversed(traceback.extract_tb(error.__traceback__))
            if Path(frame.filename).name.startswith("lesson")
        ]
        if not places:
            raise
        file, line = places[0]
        return [
            f"dhlab/course/exercises/{Path(file).name}, line {line}: expected Python that can be"
            f" imported, found {type(error).__name__}: {error}; correct it"
        ]
    return []


# ---- a cell: pairs of (lines below its first, what is wrong)


def _markers(cell):
    """Marks of a solution that are misspelt, alone, or outside a code cell: they would hand it
    out.
    """
    lines = [(at, line) for at, line in enumerate(cell.source.splitlines()) if _like_a_marker(line)]
    if cell.cell_type != "code":
        return [
            (
                at,
                (
                    f"expected {line.strip()} in a code cell, found it in the text; the cell's"
                    " first line must be ```{code-cell} ipython3"
                ),
            )
            for at, line in lines
        ]
    misspelt = [
        (
            at,
            (
                "expected ### BEGIN SOLUTION or ### END SOLUTION alone in its line, found"
                f" {line.strip()!r}; write it exactly so"
            ),
        )
        for at, line in lines
        if not MARKER.fullmatch(line)
    ]
    return misspelt or _alone([(at, MARKER.fullmatch(line)[1]) for at, line in lines])


def _like_a_marker(line):
    words = line.partition("#")[2].strip("# \t").lower()
    return any(
        SequenceMatcher(None, words, marker).ratio() > ALIKE
        for marker in ("begin solution", "end solution")
    )


def _alone(markers):
    for here, after in zip(markers, [*markers[1:], (None, None)]):
        if here[1] == "BEGIN" and after[1] != "END":
            yield (
                here[0],
                (
                    "expected ### END SOLUTION below this ### BEGIN SOLUTION, in the same cell,"
                    " found none; add it, or the solution is handed out"
                ),
            )
    for before, here in zip([(None, None), *markers], markers):
        if here[1] == "END" and before[1] != "BEGIN":
            yield (
                here[0],
                (
                    "expected ### BEGIN SOLUTION above this ### END SOLUTION, in the same cell,"
                    " found none; add it, or the solution is handed out"
                ),
            )


def _numbers(cell):
    """Ids that no exercise has."""
    asked = [
        (
            cell.source.count("\n", 0, call.start()),
            f'{call[1]}("{call[2]}")',
            call[2],
            call[1] in ("predict", "reveal"),
        )
        for call in CALL.finditer(cell.source)
    ]
    if "exercise" in cell.metadata:
        asked.insert(
            0,
            (
                0,
                f":exercise: {cell.metadata['exercise']!r} above this line",
                cell.metadata["exercise"],
                False,
            ),
        )
    for at, place, number, prediction in asked:
        known = [
            key
            for key, exercise in exercises().items()
            if isinstance(exercise, Prediction) == prediction
        ]
        if number not in known:
            near = get_close_matches(str(number), known, 1)
            what = "a prediction" if prediction else "an exercise"
            yield (
                at,
                f"expected the id of {what} in quotes, found {place}"
                + (f'; did you mean "{near[0]}"?' if near else "; correct it, or add the exercise"),
            )


def _region(cell):
    if (
        "exercise" in cell.metadata
        and "### BEGIN SOLUTION" not in cell.source
        and not any(_like_a_marker(line) for line in cell.source.splitlines())
    ):
        yield (
            0,
            (
                "expected ### BEGIN SOLUTION and ### END SOLUTION in the cell of exercise"
                f" {cell.metadata['exercise']}, found neither; put what is not handed out between"
                " them"
            ),
        )


def _python(cell):
    try:
        ast.parse(plain_python(cell.source))
    except SyntaxError as error:
        yield (
            (error.lineno or 1) - 1,
            f"expected Python, found a syntax error: {error.msg}; correct the cell",
        )


def plain_python(source):
    """A cell's code with IPython's own commands, such as ``%timeit``, written as Python."""
    from IPython.core.inputtransformer2 import TransformerManager

    return TransformerManager().transform_cell(source)


# ---- a lesson, and its exercises


def _missing(notebook, number):
    """Exercises without a cell of their own, or a check."""
    code = [cell for cell in notebook.cells if cell.cell_type == "code"]
    stubs = [cell.metadata.get("exercise") for cell in code]
    checks = [match[1] for match in (CHECKED.match(cell.source) for cell in code) if match]
    for key in (exercise.id for exercise in _of(number, predictions=False)):
        for what, there in (
            (f'one cell with :exercise: "{key}" above its code', stubs.count(key)),
            (f'one cell that begins with check("{key}", ...)', checks.count(key)),
        ):
            if there != 1:
                yield (
                    f"expected {what}, found {there or 'none'}; every exercise has its cell, and"
                    " its check below it"
                )


def _exercise(exercise):
    options = getattr(exercise, "options", {})
    if options and exercise.correct not in options:
        yield (
            f"expected correct= one of {', '.join(options)}, found {exercise.correct!r}; write the"
            " letter of the right option"
        )
    if isinstance(exercise, Function) and exercise.family and exercise.family not in WRONG_VERSIONS:
        yield (
            f"expected family= one of {', '.join(WRONG_VERSIONS)}, found {exercise.family!r}; give"
            ' your wrong versions that name in WRONG_VERSIONS, or write family=""'
        )
    try:
        named = _named(exercise)
    except Exception as error:
        yield (
            f"expected draw, answer and mistakes that run, found {type(error).__name__}: {error};"
            " correct them"
        )
        return
    for mistake in sorted(named - catalogue().keys()):
        near = get_close_matches(mistake, catalogue(), 1)
        yield f"expected the id of a mistake in dhlab/doctor/catalogue.yaml, found {mistake!r}" + (
            f"; did you mean {near[0]!r}?" if near else "; take one that is there"
        )


def _named(exercise):
    """The ids of the mistakes that an exercise may name."""
    options = getattr(exercise, "options", {}).values()
    found = {
        *(key[0] if isinstance(key, tuple) else key for key in exercise.words),
        *(option.mistake for option in options if not isinstance(option, str)),
    }
    if isinstance(exercise, Value):
        given = exercise.given(0)
        exercise.answer(**given)
        found |= {mistake for mistake, _, _ in exercise.mistakes(**given)}
    if isinstance(exercise, Function):
        exercise.answer(*exercise.cases(0)[0])
        found |= {mistake for mistake, _, _ in WRONG_VERSIONS.get(exercise.family, ())}
    if isinstance(exercise, Order):
        found |= {known[0] for known in map(exercise.explain, _orders(exercise)) if known}
    return found - {None}


def _orders(exercise):
    rng, items = exercise.rng(0), list(exercise.items)
    drawn = (
        rng.choice(items, exercise.length or len(items), replace=exercise.repeats).tolist()
        for _ in range(300)
    )
    return [letters for letters in drawn if not exercise.accepts(letters)]


# ---- after a run


def refuse_runs(path, solution, handed_out):
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
            _refuse(
                [
                    f"{name}, line {lines[cell.id]}: expected {what} to run, found {error.ename} in"
                    f" this cell: {(error.evalue.splitlines() or [''])[0]}; correct it"
                ]
            )
        _refuse(
            [
                f"{name}, line {lines[cell.id]}: expected {key} to be {wanted(key)!r} in {what},"
                f" found {said!r}; {advice}"
                for cell, key, status, said in _verdicts(notebook)
                if status != wanted(key)
            ]
        )


def _full(key):
    return RECORDED if isinstance(exercises()[key], (PreTest, Prediction)) else RIGHT


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
