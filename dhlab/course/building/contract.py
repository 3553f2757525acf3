"""The lesson contract, counted: every line of it for every lesson; a broken line stops the build.

Run it as a module::

    python -m dhlab.course.building.contract          # every lesson
    python -m dhlab.course.building.contract 04       # one
"""

import argparse
import ast
import re
import sys

from ...doctor import catalogue
from ...doctor.programs.explain import WRONG_VERSIONS
from ...doctor.tables.rows import wrong_tables
from ...printing import grid_text
from ..exercises import exercises
from ..kinds import CASES, Choice, Function, Order, Prediction, PreTest, Table
from ..kinds.placed import MISTAKES, Frames
from . import reading
from .faults import plain_python, refuse_sources
from .notebooks import lesson_notebook
from .reading import read_source, sources

__all__ = ["Lesson", "report", "CONTRACT", "WAIVED"]

WORDS_A_MINUTE = 150  # slow, careful reading; prose for pleasure goes at about 240
WIDTH = 100  # characters of code that JupyterLab shows without scrolling beside its file list
CODE_MINUTES = 0.4  # to read and run a cell that is no exercise
VERBS = (
    "read",
    "build",
    "compose",
    "tell",
    "write",
    "derive",
    "name",
    "explain",
    "find",
    "predict",
    "compute",
    "compare",
    "place",
    "convert",
    "check",
    "choose",
    "repair",
    "put",
    "say",
    "run",
    "answer",
    "match",
    "classify",
    "recognise",
    "measure",
    "move",
    "solve",
    "show",
    "decide",
    "calibrate",
    "test",
    "draw",
    "turn",
    "count",
    "judge",
)
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


class Lesson:
    """A lesson's source with what the contract counts."""

    def __init__(self, path):
        self.path, self.number = path, path.name[:2]
        self.notebook = read_source(path)
        self.cells = self.notebook.cells
        self.about = self.notebook.metadata["dhlab"]
        self.exercises = {
            key: e
            for key, e in exercises().items()
            if key.startswith(self.number) and not isinstance(e, Prediction)
        }
        self.markdown = [cell for cell in self.cells if cell.cell_type == "markdown"]
        self.code = [cell for cell in self.cells if cell.cell_type == "code"]
        self.prose = "\n".join(cell.source for cell in self.markdown)
        self.calls = [
            call
            for cell in self.code
            for call in re.findall(r'\b(check|predict|reveal)\("([^"]+)"', cell.source)
        ]

    def called(self, name):
        """The ids given to ``check``, ``predict`` or ``reveal``, in order."""
        return [number for function, number in self.calls if function == name]

    def tagged(self, tag):
        """The cells that carry a tag."""
        return [cell for cell in self.cells if tag in cell.metadata.get("tags", [])]

    def minutes(self, cell):
        """How long a cell takes a learner."""
        if cell.cell_type == "markdown":
            return words(cell.source) / WORDS_A_MINUTE
        return cell.metadata.get(
            "minutes", 0.2 if cell.source.startswith("check(") else CODE_MINUTES
        )

    @property
    def total(self):
        """Minutes of the whole lesson."""
        return sum(self.minutes(cell) for cell in self.cells)


def words(text):
    """Words of prose: links, markup, formulas and tables counted as a reader meets them."""
    text = re.sub(r"\$\$.*?\$\$", " formula ", text, flags=re.DOTALL)
    text = re.sub(r"\]\([^)]*\)", " ", text)
    return len(re.findall(r"[^\W_][\w'’.-]*", text))


def _time(lesson):
    stated, total = lesson.about.get("minutes", 0), lesson.total
    doing = sum(lesson.minutes(cell) for cell in lesson.code if "minutes" in cell.metadata)
    return (
        30 <= stated <= 50 and abs(stated - total) <= 0.2 * stated and doing >= 0.4 * total,
        f"{stated} stated, {total:.0f} counted, exercises {doing / total:.0%}",
    )


def _opening(lesson):
    objectives = lesson.about.get("objectives", [])
    good = [
        o
        for o in objectives
        if o["text"].split()[0].lower() in VERBS
        and o["checks"]
        and set(o["checks"]) <= set(lesson.called("check"))
    ]
    shown = all(o["text"] in lesson.prose for o in objectives)
    return (
        2 <= len(objectives) <= 4
        and len(good) == len(objectives)
        and shown
        and "Prerequisites" in lesson.prose,
        f"{len(good)} of {len(objectives)} objectives",
    )


def _prose(lesson):
    longest = run = 0
    for cell in lesson.cells:
        run = run + words(cell.source) if cell.cell_type == "markdown" else 0
        longest = max(longest, run)
    total = words(lesson.prose)
    return 900 <= total <= 1600 and longest <= 120, f"{total} words, longest stretch {longest}"


def _terms(lesson):
    glossary = (reading.SOLUTIONS / "glossary.md").read_text(encoding="utf-8")
    terms = lesson.about.get("terms", [])
    missing = [
        term
        for term in terms
        if f"## {term}\n" not in glossary
        or f"(glossary.md#{term.replace(' ', '-')})" not in lesson.prose
    ]
    return 0 < len(terms) <= 7 and not missing, f"{len(terms)} terms" + (
        f", without entry or link: {', '.join(missing)}" if missing else ""
    )


def _checks(lesson):
    clock, times = 0, []
    for cell in lesson.cells:
        clock += lesson.minutes(cell)
        if cell.cell_type == "code" and cell.source.startswith("check("):
            times.append(clock)
    gaps = [b - a for a, b in zip([0, *times], [*times, clock])]
    complete = set(lesson.called("check")) == set(lesson.exercises)
    return (
        len(times) >= 3 and gaps[0] <= 8 and max(gaps[1:]) <= 12 and complete,
        f"{len(times)} checks, first after {gaps[0]:.0f} min, widest gap {max(gaps[1:]):.0f} min",
    )


def _predictions(lesson):
    asked, shown = lesson.called("predict"), lesson.called("reveal")
    return (
        len(set(asked)) >= 2
        and set(asked) == set(shown)
        and all(
            lesson.calls.index(("predict", p)) < lesson.calls.index(("reveal", p)) for p in asked
        ),
        f"{len(asked)} predictions",
    )


def _misconceptions(lesson):
    cells = lesson.tagged("misconception")
    good = [
        c
        for c in cells
        if c.metadata.get("mistake") in catalogue()
        and all(word in c.source for word in ("**The claim.**", "**Against it.**", "**Why.**"))
    ]
    return len(good) >= 2 and len(good) == len(cells), ", ".join(
        c.metadata.get("mistake", "?") for c in cells
    )


def _choices(lesson):
    bad = [
        e.id
        for e in lesson.exercises.values()
        if isinstance(e, (Choice, PreTest))
        and not all(
            o.answer and (o.mistake in catalogue()) == (letter != e.correct)
            for letter, o in e.options.items()
        )
    ]
    offered = [
        c
        for c in lesson.code
        if isinstance(lesson.exercises.get(c.metadata.get("exercise")), (Choice, PreTest))
    ]
    silent = [c.metadata["exercise"] for c in offered if '"?"' not in c.source]
    return not bad and not silent, f"{len(offered)} choices" + "".join(
        f", {e} has an option without its mistake" for e in bad
    ) + "".join(f', {e} does not offer "?"' for e in silent)


def _worked(lesson):
    order = [
        tag
        for cell in lesson.cells
        for tag in cell.metadata.get("tags", [])
        if tag in ("worked", "faded", "bare")
    ]
    return order == sorted(order, key=("worked", "faded", "bare").index) and set(order) == {
        "worked",
        "faded",
        "bare",
    }, ", ".join(order)


def _tag(*tags):
    def rule(lesson):
        counts = {tag: len(lesson.tagged(tag)) for tag in tags}
        return all(counts.values()), ", ".join(f"{n} {tag}" for tag, n in counts.items())

    return rule


def _typing(lesson):
    orders = [e.id for e in lesson.exercises.values() if isinstance(e, (Order, PreTest))]
    return bool(orders), ", ".join(orders)


def _debugging(lesson):
    cells = lesson.tagged("debug")
    return len(cells) >= (int(lesson.number) >= 3), f"{len(cells)} cells"


def _feedback(lesson):
    without = [e.id for e in lesson.exercises.values() if len(e.hints) != 2 or not all(e.hints)]
    return not without, "two hints each" if not without else f"no two hints: {', '.join(without)}"


def _strength(lesson):
    known = {
        e.id: len({m for m, _, _ in WRONG_VERSIONS[e.family]})
        for e in lesson.exercises.values()
        if isinstance(e, Function)
    }
    known |= {
        e.id: len({m for m, _, _ in wrong_tables(e.answer.table)})
        for e in lesson.exercises.values()
        if isinstance(e, Table)
    }
    known |= {e.id: len(MISTAKES) for e in lesson.exercises.values() if isinstance(e, Frames)}
    return CASES >= 20 and all(
        n >= 10 for n in known.values()
    ), f"{CASES} inputs; mistakes known: " + ", ".join(f"{key} {n}" for key, n in known.items())


def _code(lesson):
    known, faults = set(), []
    for lines in [
        cell.source.splitlines()
        for cell in lesson_notebook(lesson.notebook).cells
        if cell.cell_type == "code"
    ]:
        faults += [f"{lines[0]!r} begins {len(lines)} lines"] if len(lines) > 15 else []
        faults += [
            f"{line[:30]!r} has {len(line)} characters" for line in lines if len(line) > WIDTH
        ]
    for cell in lesson.code:
        if re.search(r"matplotlib|plt\.|\.plot\(|plotly", cell.source):
            faults.append(f"{cell.id} plots")
        new = library_calls(cell.source) - known
        if len(new) > 1:
            faults.append(f"{cell.id} has new calls {', '.join(sorted(new))}")
        known |= new
    return (
        not faults,
        "; ".join(faults) or f"{len(known)} library names in {len(lesson.code)} cells",
    )


def library_calls(source):
    """The dhlab calls of a cell: ``dh.load``, ``view.frames``, ``check`` …"""
    calls = [
        node.func
        for node in ast.walk(ast.parse(plain_python(source)))
        if isinstance(node, ast.Call)
    ]
    of_modules = {
        f"{f.value.id}.{f.attr}"
        for f in calls
        if isinstance(f, ast.Attribute)
        and isinstance(f.value, ast.Name)
        and f.value.id in ("dh", "view", "transform")
    }
    return of_modules | {
        f.id
        for f in calls
        if isinstance(f, ast.Name) and f.id in ("check", "given", "predict", "reveal", "progress")
    }


def _transfer(lesson):
    marked = lesson.tagged("transfer")
    last = [c for c in lesson.code if "exercise" in c.metadata][-1:]
    return bool(marked) and marked[-1:] == last, (
        "the last exercise" if marked[-1:] == last else "not the last exercise"
    )


def _close(lesson):
    missing = [h for h in ("## Key points", "## Where next") if h not in lesson.prose]
    return not missing, (
        "key points, where next" if not missing else f"missing: {', '.join(missing)}"
    )


def _teacher(lesson):
    path = reading.SOLUTIONS / "teacher" / lesson.path.name
    if not path.exists():
        return False, "none"
    text = path.read_text(encoding="utf-8")
    named = set(re.findall(r"`([a-z0-9-]+)`", text)) & catalogue().keys()
    parts = [
        h for h in ("## Minutes", "## Wrong answers to expect", "## To discuss") if h not in text
    ]
    return not parts and len(named) >= 3, f"{len(named)} mistakes named" + (
        f", missing {', '.join(parts)}" if parts else ""
    )


CONTRACT = {
    "time": _time,
    "opening": _opening,
    "prose": _prose,
    "new terms": _terms,
    "checks": _checks,
    "predictions": _predictions,
    "misconceptions": _misconceptions,
    "choices": _choices,
    "worked example": _worked,
    "why": _tag("why"),
    "modify, make": _tag("modify", "make"),
    "low typing": _typing,
    "debugging": _debugging,
    "feedback": _feedback,
    "strength": _strength,
    "code": _code,
    "transfer": _transfer,
    "close": _close,
    "teacher sheet": _teacher,
}


def report(only=()):
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


def main():
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
