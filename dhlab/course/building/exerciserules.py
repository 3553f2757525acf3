"""The contract's lines on a lesson's exercises: each says whether a Lesson keeps it, and what was
found.
"""

from ...doctor import catalogue
from ...doctor.programs.explain import WRONG_VERSIONS
from ...doctor.tables.rows import wrong_tables
from ..kinds import CASES, UNDECIDED, Choice, Function, Lettered, Order, PreTest, Table
from ..kinds.frames.placed import MISTAKES, Frames
from .lesson import Lesson

__all__ = ["checks", "choices", "debugging", "feedback", "strength", "transfer", "typing"]


def checks(lesson: Lesson) -> tuple[bool, str]:
    """A check soon, then one every few minutes, and each exercise checked."""
    clock, times = 0.0, []
    for cell in lesson.cells:
        clock += lesson.minutes(cell)
        if cell.cell_type == "code" and cell.source.startswith("check("):
            times.append(clock)
    gaps = [round(b - a) for a, b in zip([0, *times], [*times, clock])]
    complete = set(lesson.called("check")) == set(lesson.exercises)
    return (
        len(times) >= 3 and gaps[0] <= 8 and max(gaps[1:]) <= 12 and complete,
        f"{len(times)} checks, first after {gaps[0]} min, widest gap {max(gaps[1:])} min",
    )


def choices(lesson: Lesson) -> tuple[bool, str]:
    """Each wrong option is somebody's mistake, and "?" is always offered."""
    asked = [e for e in lesson.exercises.values() if isinstance(e, (Choice, PreTest))]
    bad = [
        e.id
        for e in asked
        if not all(
            option.answer and (option.mistake in catalogue()) == (key != e.correct)
            for key, option in e.options.items()
        )
    ]
    silent = [
        e.id
        for e in lesson.exercises.values()
        if isinstance(e, Lettered) and f'`"{UNDECIDED}"`' not in lesson.questions.get(e.id, "")
    ]
    return not bad and not silent, f"{len(asked)} choices" + "".join(
        f", {e} has an option without its mistake" for e in bad
    ) + "".join(f', {e} does not offer "?"' for e in silent)


def typing(lesson: Lesson) -> tuple[bool, str]:
    """An exercise without typing, in one of the lesson's sittings."""
    orders = [
        key
        for sitting in lesson.sittings
        for key in sitting.core.called("check")
        if isinstance(sitting.exercises.get(key), (Order, PreTest))
    ]
    return bool(orders), ", ".join(orders)


def debugging(lesson: Lesson) -> tuple[bool, str]:
    """From lesson 03 on, something to repair, in one of the lesson's sittings."""
    cells = [cell for sitting in lesson.sittings for cell in sitting.core.tagged("debug")]
    return len(cells) >= (int(lesson.number[:2]) >= 3), f"{len(cells)} cells"


def feedback(lesson: Lesson) -> tuple[bool, str]:
    """Two hints each."""
    without = [e.id for e in lesson.exercises.values() if len(e.hints) != 2 or not all(e.hints)]
    return not without, "two hints each" if not without else f"no two hints: {', '.join(without)}"


def strength(lesson: Lesson) -> tuple[bool, str]:
    """Many inputs, and many mistakes known."""
    known = {
        e.id: len({m for m, _, _ in WRONG_VERSIONS[e.family]})
        for e in lesson.exercises.values()
        if isinstance(e, Function)
    }
    known |= {
        e.id: len({m for m, _, _ in wrong_tables(e.right_arm().table)})
        for e in lesson.exercises.values()
        if isinstance(e, Table)
    }
    known |= {e.id: len(MISTAKES) for e in lesson.exercises.values() if isinstance(e, Frames)}
    programs = [e for e in lesson.exercises.values() if isinstance(e, Function)]
    inputs = min((e.calls + len(e.special) for e in programs), default=CASES)
    return inputs >= 16 and all(
        n >= 10 for n in known.values()
    ), f"{inputs} inputs; mistakes known: " + ", ".join(f"{key} {n}" for key, n in known.items())


def transfer(lesson: Lesson) -> tuple[bool, str]:
    """The core's last exercise is on something new."""
    marked = lesson.core.tagged("transfer")
    last = [c for c in lesson.core.code if "exercise" in c.metadata][-1:]
    return bool(marked) and marked[-1:] == last, (
        "the last exercise" if marked[-1:] == last else "not the last exercise"
    )
