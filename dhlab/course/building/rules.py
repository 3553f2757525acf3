"""The contract's lines on a lesson's time, text and cells: each says whether a Lesson keeps it, and
what was found.
"""

import re
from collections.abc import Callable

from ...doctor import catalogue
from . import reading
from .lesson import Lesson, library_calls, words
from .notebooks import lesson_notebook

__all__ = [
    "close",
    "code",
    "misconceptions",
    "opening",
    "practice",
    "predictions",
    "prose",
    "tag",
    "teacher",
    "terms",
    "time",
    "worked",
]

TO_DO = {"predict", "faded", "modify"}  # tags of a cell in which something is to be done
WIDTH = 100  # characters of code that JupyterLab shows without scrolling beside its file list
VERBS = frozenset(
    """
    read build compose tell write derive name explain find predict compute compare place
    convert check choose repair put say run answer match classify recognise measure move solve
    show decide calibrate test draw turn count judge
    """.split()
)


def time(lesson: Lesson) -> tuple[bool, str]:
    """The core's minutes are stated, those counted to the nearest five, much of them exercises."""
    core, stated = lesson.core, lesson.about.get("minutes", 0)
    total = core.total
    doing = sum(core.minutes(cell) for cell in core.code if _to_do(cell))
    return (
        30 <= stated <= 50 and _near(stated, total) and doing >= 0.4 * total,
        f"{stated} stated, {total:.0f} counted, exercises {doing / total:.0%}",
    )


def _to_do(cell):
    """Whether something is to be answered or written in a cell."""
    return "exercise" in cell.metadata or TO_DO & {*cell.metadata.get("tags", [])}


def practice(lesson: Lesson) -> tuple[bool, str]:
    """The minutes of *More practice* are stated too, and the lesson's head says both."""
    stated, total = lesson.about.get("practice", 0), lesson.total - lesson.core.total
    wanted = [f"**{lesson.about.get('minutes', 0)} minutes"]
    wanted += [f"about {stated} more for the section *More practice*"] if stated else []
    head = " ".join(lesson.cells[0].source.split())
    gaps = [f", the head does not say {words!r}" for words in wanted if words not in head]
    return _near(stated, total) and not gaps, f"{stated} stated, {total:.0f} counted{''.join(gaps)}"


def _near(stated, counted):
    return stated % 5 == 0 and abs(stated - counted) <= 2.5


def opening(lesson: Lesson) -> tuple[bool, str]:
    """Two to four objectives that checks can verify, and what is to be known before."""
    objectives = lesson.about.get("objectives", [])
    good = [
        o
        for o in objectives
        if o["text"].split()[0].lower() in VERBS
        and o["checks"]
        and set(o["checks"]) <= set(lesson.core.called("check"))
    ]
    shown = all(o["text"] in " ".join(lesson.prose.split()) for o in objectives)
    return (
        2 <= len(objectives) <= 4
        and len(good) == len(objectives)
        and shown
        and "Prerequisites" in lesson.prose,
        f"{len(good)} of {len(objectives)} objectives",
    )


def prose(lesson: Lesson) -> tuple[bool, str]:
    """Not too many words in all, and few between two things to do."""
    longest = run = 0
    for cell in lesson.cells:
        run = run + words(cell.source) if cell.cell_type == "markdown" else 0
        longest = max(longest, run)
    total = words(lesson.prose)
    return 900 <= total <= 1600 and longest <= 120, f"{total} words, longest stretch {longest}"


def terms(lesson: Lesson) -> tuple[bool, str]:
    """Few new terms, each linked into the glossary."""
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


def predictions(lesson: Lesson) -> tuple[bool, str]:
    """Two guesses, each made before it is answered."""
    asked, shown = lesson.called("predict"), lesson.called("reveal")
    return (
        len(set(lesson.core.called("predict"))) >= 2
        and set(asked) == set(shown)
        and all(
            lesson.calls.index(("predict", p)) < lesson.calls.index(("reveal", p)) for p in asked
        ),
        f"{len(asked)} predictions",
    )


def misconceptions(lesson: Lesson) -> tuple[bool, str]:
    """Two claims of the catalogue, each refuted."""
    cells = lesson.tagged("misconception")
    good = [
        c
        for c in cells
        if c.metadata.get("mistake") in catalogue()
        and all(word in c.source for word in ("**The claim.**", "**Against it.**", "**Why.**"))
    ]
    core = [cell for cell in good if cell in lesson.core.cells]
    return len(core) >= 2 and len(good) == len(cells), ", ".join(
        c.metadata.get("mistake", "?") for c in cells
    )


def worked(lesson: Lesson) -> tuple[bool, str]:
    """An example worked in full, then with gaps, then bare; bare may be for practice."""
    order = [
        tag
        for cell in lesson.cells
        for tag in cell.metadata.get("tags", [])
        if tag in ("worked", "faded", "bare")
    ]
    kept = order == sorted(order, key=("worked", "faded", "bare").index) and "bare" in order
    return kept and tag("worked", "faded")(lesson)[0], ", ".join(order)


def tag(*tags: str) -> Callable[[Lesson], tuple[bool, str]]:
    """Something of each tag."""

    def rule(lesson):
        counts = {tag: len(lesson.core.tagged(tag)) for tag in tags}
        return all(counts.values()), ", ".join(f"{n} {tag}" for tag, n in counts.items())

    return rule


def code(lesson: Lesson) -> tuple[bool, str]:
    """Short cells, no plotting, at most one new call of the library in each."""
    known: set[str] = set()
    faults = []
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


def close(lesson: Lesson) -> tuple[bool, str]:
    """Key points, and where to go next."""
    missing = [h for h in ("## Key points", "## Where next") if h not in lesson.prose]
    return not missing, (
        "key points, where next" if not missing else f"missing: {', '.join(missing)}"
    )


def teacher(lesson: Lesson) -> tuple[bool, str]:
    """A sheet for teachers, with its parts, the lesson's minutes and three mistakes to expect."""
    path = reading.SOLUTIONS / "teacher" / lesson.path.name
    if not path.exists():
        return False, "none"
    text = path.read_text(encoding="utf-8")
    named = set(re.findall(r"`([a-z0-9-]+)`", text)) & catalogue().keys()
    minutes = f"## Minutes\n\n{lesson.about.get('minutes', 0)} in all"
    parts = [h for h in (minutes, "## Wrong answers to expect", "## To discuss") if h not in text]
    return not parts and len(named) >= 3, f"{len(named)} mistakes named" + (
        f", missing {', '.join(parts)}" if parts else ""
    )
