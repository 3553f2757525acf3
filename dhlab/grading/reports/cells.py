"""The cells of a notebook that a student handed in, read as the cage reads them: what is shown to
the teacher and compared with others is what was run, all of it.
"""

import re
from collections.abc import Iterator
from typing import Any

from ...course.exercises import exercises
from ...course.kinds import Prediction, PreTest
from ..inside.reading.notebook import cells_of, listed

__all__ = ["answered", "written"]

LINE = 1000  # letters of a check
# a check, with what may stand before it in its line
CHECK = re.compile(
    r"""(?:^[ \t]*(?:\w+[ \t]*=[ \t]*)?|\b)check\(\s*["']([0-9A-Za-z.]+)["']""", re.MULTILINE
)


def answered(notebook: Any) -> Iterator[tuple[dict[str, Any], str | None, str | None]]:
    """(the cell, its code up to a check, the exercise that is answered once it has run) of each
    cell, and again for what stands behind a check in it; of one that is no code the second is None.

    Examples
    --------
    >>> cell = {"cell_type": "code", "source": ["x = 1\\n", "check('05.1', x)\\n", "y = 2"]}
    >>> [found[1:] for found in answered({"cells": [cell]})]
    [('x = 1\\n', '05.1'), ('\\ny = 2', None)]
    """
    try:
        found = cells_of(notebook, {}).code
        cells = listed(notebook)
    except (ValueError, AttributeError):
        return
    code, checks = iter(found), {key for one in found for key in one.checked}
    for cell in (one for one in cells if isinstance(one, dict)):
        if cell.get("cell_type") != "code":
            yield cell, None, None
            continue
        own = next(code)
        source = own.source.encode("utf-8", "replace").decode("utf-8")  # JSON has half letters
        yield from ((cell, *part) for part in _parts(source, own, checks))


def written(notebook: Any) -> dict[str, list[tuple[dict[str, Any], str | None]]]:
    """What stands above the check of each exercise, from the check before it of the same lesson on:
    (cell, its code up to a check), of one that is no code None. What stands below the last check is
    the last one's. A check of what is never marked ends nothing, so that it takes no code away from
    the exercise that it is of.

    Examples
    --------
    >>> sources = "x = 1", "check('77.7', x)", "check('05.1', x)"
    >>> found = written({"cells": [{"cell_type": "code", "source": one} for one in sources]})
    >>> [(key, [code for _, code in parts]) for key, parts in found.items()]
    [('05.1', ['x = 1', '', ''])]
    """
    found: dict[str, list[tuple[dict[str, Any], str | None]]] = {}
    parts: list[tuple[dict[str, Any], str | None]] = []
    begun: dict[str, int] = {}  # of each lesson, how many parts stand above its last check
    last = ""
    for cell, code, exercise in answered(notebook):
        parts.append((cell, code))
        known = exercises().get(exercise) if exercise else None
        if known and not isinstance(known, (Prediction, PreTest)):
            last, lesson = known.id, known.id.partition(".")[0]
            found.setdefault(last, []).extend(parts[begun.get(lesson, 0) :])
            begun[lesson] = len(parts)
    if last:
        below = parts[begun[last.partition(".")[0]] :]
        found[last] += [part for part in below if part[1] is not None]
    return found


def _parts(source, own, checks):
    """(code, exercise) up to each check, and what is left."""
    here = 0
    for checked in CHECK.finditer(source) if own.checked else ():
        if checked.start() >= here:
            yield source[here : checked.start()], checked[1]
            here = _behind(source, checked.end())
    rest = source[here:]
    if not here or rest.strip():
        yield rest, None if here else next((key for key in own.ids if key not in checks), None)


def _behind(source, place):
    """Where a call ends of which the first argument does: at its bracket or, where brackets stand
    in texts, at the first one, so that nothing behind it is lost.
    """
    open_, line = 1, source[place : place + LINE].partition("\n")[0]
    for number, sign in enumerate(line):
        open_ += (sign == "(") - (sign == ")")
        if not open_:
            return place + number + 1
    return place + line.find(")") + 1
