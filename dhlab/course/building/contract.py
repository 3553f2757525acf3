"""The lesson contract, counted: every line of it for every lesson; a broken line stops the build.

Run it as a module::

    python -m dhlab.course.building.contract          # every lesson
    python -m dhlab.course.building.contract 04       # one
"""

import argparse
import sys
from collections.abc import Sequence

from ...printing import grid_text
from . import exerciserules, rules
from .faults.sources import refuse_sources
from .lesson import Lesson
from .reading import sources

__all__ = ["CONTRACT", "WAIVED", "report"]

SHORT, UNTAUGHT = (
    "style.md: 00 is shorter, and free of the lines on minutes and words",
    "nothing is taught yet: 00 shows the tools and asks",
)
WAIVED = {
    ("00", "time"): SHORT,
    ("00", "prose"): SHORT,
    ("00", "misconceptions"): UNTAUGHT,
    ("00", "worked example"): UNTAUGHT,
    ("00", "transfer"): "no arm has been studied yet, so none can be new",
}  # (lesson, line): why the line makes no sense there
CONTRACT = {
    "time": rules.time,
    "practice": rules.practice,
    "opening": rules.opening,
    "prose": rules.prose,
    "new terms": rules.terms,
    "checks": exerciserules.checks,
    "predictions": rules.predictions,
    "misconceptions": rules.misconceptions,
    "choices": exerciserules.choices,
    "worked example": rules.worked,
    "why": rules.tag("why"),
    "modify, make": rules.tag("modify", "make"),
    "low typing": exerciserules.typing,
    "debugging": exerciserules.debugging,
    "feedback": exerciserules.feedback,
    "strength": exerciserules.strength,
    "code": rules.code,
    "transfer": exerciserules.transfer,
    "close": rules.close,
    "teacher sheet": rules.teacher,
}


def report(only: Sequence[str] = ()) -> tuple[str, list[str]]:
    """The contract's table as text, and the broken lines as sentences; of the lessons named by
    number, or of all.
    """
    lessons = [
        lesson for lesson in map(Lesson, sources(only)) if lesson.about.get("contract", True)
    ]  # a teacher's own sheet may leave it out
    rows, failures = [], []
    for line, rule in CONTRACT.items():
        for lesson in lessons:
            kept, found = rule(lesson)
            waived = "" if kept else WAIVED.get((lesson.number, line), "")
            rows.append(
                [
                    line,
                    lesson.number,
                    "kept" if kept else "waived" if waived else "BROKEN",
                    "; ".join(filter(None, (found, waived))),
                ]
            )
            if not kept and not waived:
                failures.append(f"lesson {lesson.number}, {line}: {found}")
    return grid_text(["line", "lesson", "", "found"], rows), failures


def main() -> None:
    """Print the table; exit 1 when a line is broken."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("lessons", nargs="*", help="numbers such as 05; all when left out")
    try:
        only = parser.parse_args().lessons
        refuse_sources(sources(only))
        table, failures = report(only)
    except ValueError as error:
        sys.exit(str(error))
    print(table)
    sys.exit(bool(failures))


if __name__ == "__main__":
    main()
