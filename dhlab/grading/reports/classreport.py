"""What a class got wrong, on one page for its teacher: marks, mistakes, what to teach again,
questions that may be bad, code that is alike.
"""

from collections import Counter
from collections.abc import Iterable, Sequence
from itertools import groupby
from pathlib import Path
from statistics import median
from urllib.parse import quote

from ...course.exercises import exercises
from ...doctor import catalogue
from ...formats.files import write_text
from ..cage.levels import RISKS
from ..intake.roster import Student
from ..results.marks import ERROR, GRADED, MISSING, NOT_ALLOWED, RIGHT, TIMED_OUT, WRONG, Graded
from ..results.names import marks_stem, page_stem
from .alike import Pair
from .chosen import chosen_answers
from .items import items
from .pages import duration, render, words
from .sections import question, section_of_exercise, section_of_mistake, sheet_question

__all__ = ["class_report", "write_class_report", "headcount", "reports_of_sections"]

NAME = "class-report.html"
# mistakes of the class as a whole, and of one exercise before the rest is folded away
TOP, SHOWN = 8, 5
UNNAMED = "without a name: look at a few of these yourself"
MOST_NAMES = 8  # of students whose mistake has no name


def class_report(
    results: Sequence[Graded],
    roster: Sequence[Student] = (),
    pairs: Iterable[Pair] = (),
    section: str = "",
) -> str:
    """The page for the teacher, as HTML that stands alone.

    Parameters
    ----------
    results : sequence of Graded
    roster : sequence of Student
        For the names.
    pairs : sequence of Pair
        From :func:`dhlab.grading.reports.alike.alike`.
    section : str
        Whose results these are; the whole class when empty.

    Returns
    -------
    str

    Examples
    --------
    >>> from dhlab.grading.results.marks import Graded, Mark
    >>> wrong = Mark("05.1", "wrong", 0, 1, mistake="mirror")
    >>> page = class_report([Graded("ada", "", "graded", (wrong,))])
    >>> "<code class=\\"soft\\">mirror</code>" in page
    True
    """
    names = {student.student: student.name or student.student for student in roster}
    looked_at = [graded for graded in results if graded.status in (GRADED, TIMED_OUT)]
    found = items(results)
    return render(
        "class-report.html",
        **_numbers(looked_at),
        lang="en",
        shown=SHOWN,
        looked_at=len(looked_at),
        section=section,
        sections={} if section else reports_of_sections(roster),
        counted=headcount(results, [s for s in roster if section in ("", s.section)]),
        statuses=Counter(graded.status for graded in results).most_common(),
        cages=sorted({RISKS.get(graded.cage, graded.cage) for graded in results if graded.cage}),
        top=_top(looked_at),
        attention=list(_attention(results, names)),
        lessons=_lessons(found, looked_at, names),
        suspects=[item.exercise for item in found if item.suspect],
        guesses=[
            (_called(g.student, names), _called(g.guess_of, names)) for g in results if g.guess_of
        ],
        # who matches nobody stands above
        drawn=[
            (_called(g.student, names), _called(g.numbers_of, names))
            for g in results
            if g.numbers_of and (g.student in names or not names)
        ],
        pairs=[
            {
                "names": [_called(student, names) for student in pair.students],
                "share": pair.share,
                "exercises": pair.exercises,
            }
            for pair in pairs
        ],
        students=[_row(graded, names) for graded in results],
    )


def _numbers(looked_at):
    """The marks of the class in numbers."""
    marks = [mark for graded in looked_at for mark in graded.marks]
    wrong = [mark for mark in marks if mark.status == WRONG]
    shares = [100 * graded.total / graded.of for graded in looked_at if graded.of]
    return {
        "median": median(shares) if shares else 0,
        "histogram": _histogram(shares),
        "wrong": len(wrong),
        "named": sum(mark.mistake is not None for mark in wrong),
        "stopped": sum(mark.status == TIMED_OUT for mark in marks),
    }


def write_class_report(
    results: Sequence[Graded],
    roster: Sequence[Student],
    folder: str | Path,
    pairs: Iterable[Pair] = (),
) -> Path:
    """Write ``class-report.html`` into a folder, over the one of an earlier run, and one for each
    section of the roster.

    Returns
    -------
    Path
    """
    path = Path(folder) / NAME
    pairs = list(pairs)
    write_text(path, class_report(results, roster, pairs), overwrite=True)
    for section, name in reports_of_sections(roster).items():
        own = [student for student in roster if student.section == section]
        ids = {student.student for student in own}
        page = class_report(
            [graded for graded in results if graded.student in ids],
            roster,
            [pair for pair in pairs if ids & set(pair.students)],
            section,
        )
        write_text(Path(folder) / name, page, overwrite=True)
    return path


def reports_of_sections(roster: Iterable[Student]) -> dict[str, str]:
    """The file of each section's report.

    Examples
    --------
    >>> reports_of_sections([Student("ada", section="B/1"), Student("bo")])
    {'B/1': 'class-report-B%2F1.html'}
    """
    sections = sorted({student.section for student in roster if student.section})
    return {section: f"class-report-{marks_stem(section)}.html" for section in sections}


def _called(student, names):
    name = names.get(student, student)
    return name if name == student else f"{name} ({student})"


def headcount(results: Sequence[Graded], roster: Sequence[Student]) -> str:
    """How many students there are; with a roster how many are on it, and how many match nobody.

    Examples
    --------
    >>> from dhlab.grading.results.marks import Graded
    >>> headcount([Graded("ada", "", "missing", ()), Graded("bo", "", "missing", ())], ())
    '2 students'
    """
    known = {student.student for student in roster}
    strangers = sum(graded.student not in known for graded in results)
    return (
        f"{len(results) - strangers} on the roster"
        + (f", {strangers} that match nobody on it" if strangers else "")
        if known
        else f"{len(results)} students"
    )


def _histogram(shares):
    """(label, how many, share of the class) for each tenth of the points."""
    tenths = Counter(min(int(share // 10), 9) for share in shares)
    return (
        [
            (f"{10 * k} to {10 * k + 10} %", tenths[k], tenths[k] / len(shares))
            for k in range(9, -1, -1)
        ]
        if shares
        else []
    )


def _top(looked_at):
    """The mistakes most students made, one count a student; of as many the one that came first."""
    counts = Counter(
        mistake
        for graded in looked_at
        for mistake in dict.fromkeys(
            mark.mistake
            for mark in graded.marks
            if mark.status == WRONG and mark.mistake in catalogue()
        )
    )
    return [
        _line(mistake, count, len(looked_at)) | {"section": section_of_mistake(mistake)}
        for mistake, count in counts.most_common(TOP)
    ]


def _line(mistake, count, of):
    known = catalogue().get(mistake)
    return {
        "id": mistake or "",
        "title": known.title if known else UNNAMED if mistake is None else mistake,
        "count": count,
        "share": count / of,
    }


def _lessons(found, looked_at, names):
    lessons = groupby(found, key=lambda item: item.exercise.partition(".")[0])
    return [
        {
            "number": number,
            "question": sheet_question(number),
            "exercises": [_exercise(item, looked_at, names) for item in own],
        }
        for number, own in lessons
    ]


def _exercise(item, looked_at, names):
    of = item.statuses.total()
    marks = [mark for graded in looked_at for mark in graded.marks]
    unnamed = [
        _called(graded.student, names)
        for graded in looked_at
        for mark in graded.marks
        if mark.exercise == item.exercise and mark.status == WRONG and mark.mistake is None
    ]
    known = exercises().get(item.exercise)
    first = next(
        (mistake for mistake, _ in item.mistakes.most_common() if mistake in catalogue()), None
    )
    return {
        "item": item,
        "title": known.title if known else "",
        "statuses": item.statuses.most_common(),
        "of": of,
        "unnamed": unnamed[:MOST_NAMES],
        "more": max(0, len(unnamed) - MOST_NAMES),
        "section": section_of_exercise(item.exercise),
        "answers": chosen_answers(
            known, [mark for mark in marks if mark.exercise == item.exercise]
        ),
        "bars": [_line(mistake, count, of) for mistake, count in item.mistakes.most_common()],
        "treated": section_of_mistake(first) if first else "",
        "question": question(known, first) if first else "",
    }


def _attention(results, names):
    """(who, what) for each student whose work a person should look at; those of whom there is
    nothing in one line.
    """
    missing = [
        _called(graded.student, names)
        for graded in results
        if graded.status == MISSING and (not names or graded.student in names)
    ]
    if missing:
        yield f"Nothing handed in ({len(missing)})", ", ".join(missing)
    for graded in results:
        if names and graded.student not in names:
            yield _called(graded.student, names), "; ".join(graded.notes) or "not on the roster"
        elif graded.status not in (GRADED, MISSING):
            yield (
                _called(graded.student, names),
                ": ".join([graded.status, *filter(None, ["; ".join(graded.notes)])]),
            )
        for mark in graded.marks if graded.status in (GRADED, TIMED_OUT) else ():
            if mark.status in (ERROR, TIMED_OUT, NOT_ALLOWED):
                yield (
                    _called(graded.student, names),
                    f"{mark.exercise} {mark.status}" + (f": {mark.note}" if mark.note else ""),
                )


def _row(graded, names):
    return {
        "graded": graded,
        "name": names.get(graded.student, graded.student),
        "link": f"feedback/{quote(page_stem(graded.student))}.html",
        "late": duration(graded.late_days, words("en")) if graded.late_days else "",
        "right": sum(mark.status == RIGHT for mark in graded.marks),
    }
