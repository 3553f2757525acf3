"""Worked answers on the reading site, folded under each exercise; the class edition has none."""

import ast
import re
from pathlib import Path

import nbformat

from dhlab.course.exercises import exercises
from dhlab.course.kinds import Lettered

__all__ = ["with_answers", "worked"]

SOLUTIONS = Path(__file__).resolve().parents[1] / "solutions"
REGION = re.compile(r"### BEGIN SOLUTION\n(.*?)### END SOLUTION\n?", re.DOTALL)
MARKERS = re.compile(r"^[ \t]*### (BEGIN|END) SOLUTION\n?", re.MULTILINE)
FOLDED = """<details class="worked-answer"><summary>The worked answer to {id}</summary>

```python
{code}
```
{words}
</details>"""


def with_answers(text, name):
    """A lesson that was run, as text, with a folded answer below the check of each exercise."""
    notebook = nbformat.reads(text, as_version=4)
    answers = worked(name)
    cells = []
    for cell in notebook.cells:
        cells.append(cell)
        asked = re.findall(r'^check\("([^"]+)"', cell.source, re.MULTILINE)
        for exercise in asked if cell.cell_type == "code" else ():
            if exercise in answers:
                folded = nbformat.v4.new_markdown_cell(answers.pop(exercise))
                folded["id"] = f"answer-{exercise.replace('.', '-')}"
                cells.append(folded)
    if answers:
        raise SystemExit(f"{name}: expected a check for each exercise, found none for {[*answers]}")
    notebook.cells = cells
    return nbformat.writes(notebook)


def worked(name):
    """The folded answer of each exercise of a lesson, by its id, as Markdown."""
    notebook = nbformat.read(SOLUTIONS / f"{name}.ipynb", as_version=4)
    answers = {}
    for cell in notebook.cells:
        exercise = cell.metadata.get("exercise")
        if cell.cell_type == "code" and exercise:
            code, words = _lettered(exercise, _answer(cell.source))
            answers[exercise] = FOLDED.format(id=exercise, code=code, words=words)
    return answers


def _answer(source):
    """What is to be written: the region alone where it sets all that stands before it once more,
    else the whole cell.
    """
    whole = MARKERS.sub("", source).strip()
    regions = REGION.findall(source)
    if not regions:
        return whole
    try:
        if len(regions) == 1 and _names(REGION.sub("", source)) <= _names(regions[0]):
            return regions[0].strip()
    except SyntaxError:  # the region is the inside of a function
        return whole
    dots = {one.lineno for one in ast.parse(whole).body if _is_dots(one)}
    kept = (line for k, line in enumerate(whole.splitlines(), 1) if k not in dots)
    return "\n".join(kept).strip()


def _names(source):
    """What a text sets or defines at its top."""
    found = set()
    for one in ast.parse(source).body:
        if isinstance(one, (ast.FunctionDef, ast.ClassDef)):
            found.add(one.name)
        elif isinstance(one, ast.Assign):
            found |= {ast.unparse(target) for target in one.targets}
        else:
            found.add(ast.unparse(one))  # stays where it is
    return found


def _is_dots(statement):
    """Whether a statement sets names to dots and no more."""
    if not isinstance(statement, ast.Assign):
        return False
    values = getattr(statement.value, "elts", [statement.value])
    return all(isinstance(one, ast.Constant) and one.value is ... for one in values)


def _lettered(exercise, code):
    """The code with its letters, and the options that they stand for. Where the solution says that
    it does not know, as a beginner does before the course, the right letter stands here.
    """
    one = exercises()[exercise]
    if not isinstance(one, Lettered):
        return code, ""
    letters = one.letters(0)
    if code.endswith('"?"'):
        code = code.replace('"?"', f'"{letters[one.correct]}"')
    texts = {letter: one.texts()[key] for key, letter in letters.items()}
    chosen = [value for value in re.findall(r'"(\w)"', code) if value in texts]
    lines = [f"- `{letter}` {texts[letter]}" for letter in dict.fromkeys(chosen)]
    return code, "\n".join(["", *lines, ""])
