"""A table pasted in somebody else's dialect, read into an ``Arm``: column order, convention, units,
extra rows; where two readings fit, both.
"""

from dataclasses import replace
from itertools import combinations

import numpy as np

from ...geometry.equivalence import equivalent
from ...geometry.parallels import cancelling
from .answers import require_answers
from .computed.reading import computed
from .computed.settled import settled, stands_alone
from .dialects.lined.lines import TwoTables
from .meaning.beside import Contradicted
from .meaning.columns import misplaced
from .meaning.scales import UNIT_WORDS
from .readings import BOOKS, QUESTIONS, Reading, readings, require_some
from .recognised import Recognised
from .take_apart import take_apart
from .twice import told_once

__all__ = ["Reading", "Recognised", "recognise_table"]

MOST_READINGS = 24
CHANGED_PLACES = "have columns changed places?"
TRIES = 60  # random configurations among which the one that tells the readings apart best is taken


def recognise_table(
    given,
    right=None,
    *,
    order=None,
    convention=None,
    angle=None,
    length=None,
    values=None,
    nominal=None,
    tidy=False,
):
    """Read a table pasted from a paper, a program, a configuration file or a spreadsheet.

    Parameters
    ----------
    given : str or rows
        A text: a table with tabs, spaces, commas or pipes between the cells, in LaTeX or Markdown;
        source code in Python, MATLAB, C or Julia; calls of a toolbox; KDL segments, elementary
        transforms, OPW parameters; a controller's calibration. Or rows of numbers and texts.
        Everything is parsed, nothing is executed.
    right : Arm, optional
        The arm the table should be; readings that are not equivalent to it are left out, if one is.
    order, convention, angle, length : optional
        Answers to the questions: ``"theta d a alpha"`` (any order), ``"standard"`` or ``"craig"``,
        ``"deg"`` or ``"rad"``, ``"m"``, ``"mm"``, ``"cm"`` or ``"in"``.
    values : dict of str to float, optional
        What letters of the table stand for, in its units.
    nominal : Arm, optional
        The table to which a calibration file's differences are added.
    tidy : bool
        Take 1.5708 for π/2 and the like; left out, every number is kept as it is written.

    Returns
    -------
    Recognised

    Raises
    ------
    ValueError
        One sentence: which line and cell, what was expected, what was found, what to do.

    Examples
    --------
    >>> said = '''i  a    alpha  d    theta
    ...           1  0    90°    0.1  q1
    ...           2  0.4  0      0    q2 - 90°'''
    >>> found = recognise_table(said, convention="standard")
    >>> print(found)
    Read as columns a, alpha, d, theta, as the header says; standard convention, as you say;
    degrees, as the cells say; metres by size: all links in a row reach 0.5 m.
    >>> found.arm.table.theta.round(4)
    array([ 0.    , -1.5708])
    """
    require_answers(order, convention, angle, length)
    said = {"order": order, "convention": convention, "angle": angle, "length": length,
            "values": values, "nominal": nominal, "tidy": tidy}  # fmt: skip
    try:
        written = _as_written(given, right, **said)
    except Contradicted:
        raise
    except ValueError as error:
        program = _program(given, nominal, length)
        if program is None or not stands_alone(program, error, given):
            raise
        readings, notes = settled([], program, convention)
        return _answer(readings, notes, right)
    if len(written.readings) == 1 and (order or convention or angle or written.matches):
        return written
    program = _program(given, nominal, length)
    if program is None or (program.posed and "zero" in written.open):
        return written
    doubted = any(note.endswith(CHANGED_PLACES) for note in written.notes)
    readings, notes = settled(written.readings, program, doubted=doubted)
    if all(one in written.readings for one in readings):
        notes = written.notes
        if len(readings) == len(written.readings):
            return written
    return _answer(readings, notes, right)


def _program(given, nominal, length):
    """What a text computes, where it is a program."""
    return computed(given, length) if isinstance(given, str) and nominal is None else None


def _as_written(given, right, *, order, convention, angle, length, values, nominal, tidy):
    """What is Recognised in a table as it stands, without what its program does."""
    try:
        table = take_apart(given, values, nominal, length)
    except TwoTables as error:
        said = {"order": order, "angle": angle, "length": length, "values": values, "tidy": tidy}
        if found := _of_one_arm(error.parts, right, convention, said):
            return found
        if once := told_once(error.parts):
            rest, note = once
            found = recognise_table(rest, right, convention=convention, **said)
            return replace(found, notes=(*found.notes, note))
        raise
    if isinstance(table, list):  # read as an arm: nothing is left to ask of columns
        told = [replace(one, arm=one.arm.to(convention)) for one in table] if convention else table
        kept = _different(told)
        return _answer(kept, (*kept[0].notes, *_calibrated(kept[0].arm)), right)
    found = list(readings(table, order, convention, angle, length, right, tidy))
    require_some(found, table)
    kept = _different(found)[:MOST_READINGS]
    return _answer(kept, (*table.notes, *_notes(table, kept)), right)


def _of_one_arm(parts, right, convention, said):
    """What is Recognised in the first of two tables, where the second is the same arm by another
    convention; None where they are not, or where a question is open.
    """
    try:
        found = [recognise_table(part, right, **said) for part in parts]
    except ValueError:
        return None
    one, other = (part.readings[0] for part in found)
    if any(len(part.readings) > 1 for part in found) or not _same_arm(one.arm, other.arm):
        return None
    meant = [part for part in found if part.arm.table.convention == convention] or found
    words = BOOKS[other.arm.table.convention]
    note = f"the text has the arm twice; the second table is the same one, in {words}"
    return replace(meant[0], notes=(*meant[0].notes, note))


def _equivalent(right, readings):
    """The first reading that is the right arm, as given or up to a constant tool or base; and a
    note that says so.
    """
    for free, words in (
        ((), ""),
        (("tool",), "its tool"),
        (("base",), "its base"),
        (("base", "tool"), "its base and tool"),
    ):
        for reading in readings:
            if equivalent(right, reading.arm, **dict.fromkeys(free, "free")):
                return [reading], (
                    (f"this reading is the right arm but for {words}",) if words else ()
                )
    n = len(readings[0].arm)
    differs = f"it has {len(right)} joints, the text {n}" if n != len(right) else "an entry differs"
    return [], (f"no reading is the right arm: {differs}",)


def _different(readings):
    """The readings without those that are an earlier one's arm: what makes no difference needs no
    question.
    """
    kept = []
    for reading in readings:
        if not any(_same_arm(reading.arm, other.arm) for other in kept):
            kept.append(reading)
    return kept


def _same_arm(a, b):
    if len(a) != len(b) or a.table.joints != b.table.joints:
        return False
    q = np.random.default_rng(8).uniform(-1.3, 1.3, (3, len(a)))
    return np.allclose(a.forward(q), b.forward(q), rtol=0, atol=1e-9)


def _answer(readings, notes, right):
    matches = None
    if right is not None:
        same, but_for = _equivalent(right, readings)
        readings, notes, matches = same or readings, (*but_for, *notes), bool(same)
    asked = tuple(
        name for name in QUESTIONS if len({dict(reading.choices)[name] for reading in readings}) > 1
    )
    questions = tuple(_question(name, readings) for name in asked)
    q = _telling(readings)
    poses = None if q is None else np.array([reading.arm.forward(q) for reading in readings])
    return Recognised(tuple(readings), questions, q, poses, notes, matches, asked)


def _question(name, readings):
    values = list(dict.fromkeys(dict(reading.choices)[name] for reading in readings))
    if name == "order":
        return f"{QUESTIONS[name]}: " + ", or ".join(" ".join(roles) for roles in values) + "?"
    if name == "length":
        return f"{QUESTIONS[name]}: {', or '.join(UNIT_WORDS[unit] for unit in values)}?"
    slides = any(letter == "P" for still in values if name == "row" for _, letter in still)
    if slides:
        return "Which joint slides, and does a row without a joint stand among these?"
    if name == "form":
        return f"{QUESTIONS[name]}: {', or '.join(_forms(readings))}?"
    return QUESTIONS[name]


def _forms(readings):
    """The readings' words before their units: what the text is taken for."""
    return list(dict.fromkeys(reading.words.partition(";")[0] for reading in readings))


def _telling(readings):
    """The configuration at which the two readings that are nearest to each other differ most; None
    when one cannot tell.
    """
    arms = [reading.arm for reading in readings]
    if len(arms) < 2 or len({(len(arm), arm.table.joints) for arm in arms}) > 1:
        return None
    q = np.random.default_rng(9).uniform(0.2, 1.4, (TRIES, len(arms[0]))).round(2)
    poses = [arm.forward(q) for arm in arms]
    gaps = [np.abs(one - other).max(axis=(-1, -2)) for one, other in combinations(poses, 2)]
    return q[int(np.argmax(np.min(gaps, axis=0)))]


def _notes(table, readings):
    """What in the numbers is worth a second look."""
    notes = []
    choices = dict(readings[0].choices)
    rows = readings[0].arm.table.rows
    if choices["angle"] == "mixed":
        notes.append(
            "some angles are beyond 2π while others are multiples of π/2: degrees in a radian"
            " column?"
        )
    odd = misplaced(
        {
            role: [row[k] for row in table.rows]
            for k, role in enumerate(choices["order"])
            if k < len(table.rows[0])
        }
    )
    if odd:
        notes.append(
            f"{' and '.join(odd)}: multiples of π/2 stand among lengths, or lengths among angles;"
            f" {CHANGED_PLACES}"
        )
    lengths = rows[:, 1:3][rows[:, 1:3] != 0]
    plain = len(lengths) >= 4 and (rows >= 0).all()  # a minus elsewhere has come through
    if plain and readings[0].arm.table.convention == "standard":
        notes.append(
            "no number is negative; d and a are coordinates along an axis, so look whether the"
            " source lost a minus"
        )
    sizes = np.abs(lengths)
    calibrated = _calibrated(readings[0].arm)
    if calibrated:
        notes += calibrated
    elif len(sizes) > 1 and sizes.max() > 100 * np.median(sizes) and sizes.max() > 3:
        notes.append(
            "one length is more than 100 times the usual one here: millimetres among metres?"
        )
    return tuple(notes)


def _calibrated(arm):
    """What is to be said of nearly parallel axes, which look like a mistake and are none."""
    return [f"{run}; dhlab convert FILE.yaml --tidy makes it readable" for run in cancelling(arm)]
