"""Whose code is suspiciously alike: short runs of tokens that few people write, whatever the names
and comments.

A run of tokens is a fingerprint (Schleimer, Wilkerson & Aiken, "Winnowing", SIGMOD 2003, section
2). Within each run the names are numbered in the order in which they come up, so that renaming
changes nothing. What was handed out, and what many in the class write, is no evidence.
"""

import ast
import io
import keyword
import re
import tokenize
import warnings
from collections import Counter, defaultdict
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from itertools import combinations
from typing import Any

from .cells import written

__all__ = ["APART", "Pair", "alike", "answers", "is_cut", "tokens_of"]

RUN = 12  # tokens: about a line of a formula
# a run that more than this share of the class, or this many, wrote is how one writes it, no copy:
# of twenty, four who copied one from the other are still found
FEW, MANY = 0.2, 10
# rare runs in common, and as a share of the shorter one's; measured in benchmarks/classroom.py
ENOUGH, SHARE = 40, 0.8
SINK = 3  # people, of whom no two are alike, that one person's code is alike to
LARGEST = 10_000  # characters of one answer that are read; a long one has a thousand
MOST = 20_000  # of all answers to one lesson; the longest lesson's have eight thousand
APART = "\f"  # no letter of a program that means anything
# comments, magics, and whatever else makes a cell longer and not another
NO_CODE = re.compile(r"^[ \t]*(?:[#!%?][^\n]*)?(?:\n|\Z)|^[\w, \t]+=[ \t]*[!%][^\n]*", re.M)
# magics by which a program comes to run that stands nowhere whole, and Python that does the same
RUNS, APPENDS = re.compile(r"[ \t]*%run\b"), re.compile(r"[ \t]*%%(?:writefile|file)\b.* -a\b")
TIMED = re.compile(r"[ \t]*%(?:time|prun)\b[ \t]*")  # what stands behind it is Python, and runs
AGAIN = 10  # lines with an open bracket in a cell below which is read anew
STRING = 40  # letters of a text that may be a program
SKIPPED = (tokenize.COMMENT, tokenize.NL, tokenize.ENCODING, tokenize.ENDMARKER)


@dataclass(frozen=True)
class Pair:
    """Two students, how much of the rarer code of the shorter one is in both (0 to 1), and in which
    exercises.
    """

    students: tuple[str, str]
    share: float
    exercises: tuple[str, ...]


def answers(notebook: Any) -> dict[str, str]:
    """The code of each exercise in a notebook: what stands between its check and the one before,
    without comments and lines that are no Python; what stands below the last check is the last
    one's. Cells are set apart by a form feed.

    Parameters
    ----------
    notebook : dict
        As in the file; nothing in it is trusted to have the right form.

    Returns
    -------
    dict of str to str

    Examples
    --------
    >>> cells = [{"source": "x = 1"}, {"source": ["check('05.1', ", "x)"]}]
    >>> answers({"cells": [{"cell_type": "code", **cell} for cell in cells]})
    {'05.1': 'x = 1\\x0c\\x0c'}
    """
    return _cut(_written_in(notebook))


def is_cut(notebook: Any) -> bool:
    """Whether there is more code in a notebook than is compared."""
    written = _written_in(notebook)
    return _cut(written) != written


def _cut(written):
    """The code of each exercise, no longer than is compared."""
    found: dict[str, str] = {}
    left: dict[str, int] = defaultdict(lambda: MOST)
    for exercise, code in written.items():
        found[exercise] = code[: min(LARGEST, left[exercise[:2]])]
        left[exercise[:2]] -= len(found[exercise])
    return found


def _written_in(notebook):
    return {
        exercise: "".join(NO_CODE.sub(_left, code) + APART for _, code in parts if code is not None)
        for exercise, parts in written(notebook).items()
    }


def _left(line):
    """What is left of a line that is no Python: that a file is run, or that one is added to, and
    what a magic runs.
    """
    if timed := TIMED.match(line[0]):
        return line[0][timed.end() :]
    if RUNS.match(line[0]):
        return "import file_that_is_run\n"
    return "open\n" if APPENDS.match(line[0]) else ""


def alike(
    codes: Mapping[str, Mapping[str, str]],
    handed_out: Mapping[str, str],
    counted: Collection[str] = (),
) -> list[Pair]:
    """The pairs whose answers share more rare runs than chance and a common lesson explain, most
    alike first.

    Parameters
    ----------
    codes : mapping of str to mapping
        For each student the code of each exercise, as :func:`answers` gives it.
    handed_out : mapping
        The same of the lesson as it was handed out.
    counted : collection of str
        By whom is counted what many write, all when empty: files of nobody's name may be anybody's.

    Returns
    -------
    list of Pair
    """
    given: dict[str, set[int]] = defaultdict(set)
    for exercise, code in handed_out.items():
        given[exercise[:2]] |= runs(code)
    written = {student: _written(own, given) for student, own in codes.items()}
    writers = defaultdict(list)
    for student, own in written.items():
        for run in own:
            writers[run].append(student)
    known = (set(counted) & codes.keys()) or codes.keys()
    most = min(max(2, FEW * len(known)), MANY)
    rarely = {run for run, students in writers.items() if _count(students, known) <= most}
    common: Counter[tuple[str, ...]] = Counter()
    rare: Counter[str] = Counter()
    for run in rarely:
        # each pair costs time, and strangers may be as many as somebody likes
        few = len(writers[run]) <= 2 * MANY
        students = [one for one in writers[run] if few or one in known]
        rare.update(students)
        common.update(combinations(sorted(students), 2))
    found = {
        pair: shared / min(rare[student] for student in pair)
        for pair, shared in common.items()
        if shared >= ENOUGH
    }
    pairs = [
        Pair(
            (pair[0], pair[1]),
            share,
            _where(codes, pair, lambda run: run in rarely and len(writers[run]) > 1),
        )
        for pair, share in found.items()
        if share >= SHARE
    ]
    return sorted(_without_sinks(pairs), key=lambda pair: (-pair.share, pair.students))


def _count(students, known):
    return sum(student in known for student in students)


def _written(own, given):
    """A student's fingerprints, each bound to its lesson, without those that were handed out. In
    which cell of the lesson something is defined says nothing.
    """
    return {
        hash((exercise[:2], run))
        for exercise, code in own.items()
        for run in runs(code) - given.get(exercise[:2], set())
    }


def _where(codes, pair, is_rare):
    """The exercises, of either, whose code holds rare runs of the other's lesson."""
    found = [
        {
            (exercise, hash((exercise[:2], run)))
            for exercise, code in own.items()
            for run in runs(code)
        }
        for own in (codes[student] for student in pair)
    ]
    shared = {run for _, run in found[0]} & {run for _, run in found[1]}
    rare = {run for run in shared if is_rare(run)}
    return tuple(sorted({exercise for own in found for exercise, run in own if run in rare}))


def _without_sinks(pairs):
    """The pairs, and in place of one person's with several who have nothing in common one line: an
    answer that holds what many would write says nothing of them.
    """
    near: dict[str, set[str]] = defaultdict(set)
    for pair in pairs:
        for one, other in (pair.students, pair.students[::-1]):
            near[one].add(other)
    sinks = {
        one
        for one, others in near.items()
        if len(others) >= SINK and not any(near[other] & others for other in others)
    }
    kept = [pair for pair in pairs if not sinks & set(pair.students)]
    for one in sinks:
        own = [pair for pair in pairs if one in pair.students]
        told = f"{len(own)} others who have no code in common: look at this one's answers"
        where = {exercise for pair in own for exercise in pair.exercises}
        kept.append(Pair((one, told), max(p.share for p in own), tuple(sorted(where))))
    return kept


def runs(code):
    """The fingerprints of a program: each run of tokens with its names numbered, as a hash."""
    tokens = tokens_of(code)
    return {hash(_numbered(tokens[i : i + RUN])) for i in range(len(tokens) - RUN + 1)}


def tokens_of(code: str) -> list[tuple[str, str]]:
    """(kind, text) of each token that means something, of a program that is a text too; a line that
    cannot be read costs neither its cell's rest nor the next cell.
    """
    found: list[tuple[str, str]] = []
    for cell in code.split(APART):
        again = AGAIN
        while cell:
            cell, again = _read(cell, found, again), again - 1
    return found


def _read(cell, found, again):
    """Read the tokens of a cell into ``found``; what stands behind a line that cannot be read, or,
    while there is still an ``again``, behind one with a bracket that nothing closes: within it the
    lines would be read as one.
    """
    known, line = len(found), 0
    try:
        for token in tokenize.generate_tokens(io.StringIO(cell).readline):
            if token.type == tokenize.STRING and len(token.string) > STRING:
                found += _tokens_of_text(token.string)
            if (
                token.type in SKIPPED
                or token.string in ("(", ")")
                or (token.type == tokenize.STRING and (not found or found[-1][0] == "layout"))
            ):
                continue  # the last of these is a docstring
            layout = token.type in (tokenize.NEWLINE, tokenize.INDENT, tokenize.DEDENT)
            name = (
                token.type == tokenize.NAME
                and not keyword.iskeyword(token.string)
                and (not found or found[-1][1] != ".")
            )
            found.append(
                ("layout", tokenize.tok_name[token.type])
                if layout
                else ("name" if name else "text", token.string)
            )
            if token.type == tokenize.NEWLINE:
                known, line = len(found), token.end[0]
    except tokenize.TokenError as error:
        if again <= 0 or "string" in error.args[0]:
            return _below(cell, error.args[1][0])
        del found[known:]
        return _below(cell, line + 1)
    except SyntaxError as error:
        return _below(cell, error.lineno or 1)
    return ""


def _below(cell, line):
    return "".join(cell.splitlines(keepends=True)[line:])


def _tokens_of_text(text):
    """The tokens of a program in quotes, which somebody may run; none of another text."""
    try:
        with warnings.catch_warnings(action="ignore"):  # of a "\\alpha", told to the teacher
            inner = ast.literal_eval(text)
            program = isinstance(inner, str) and ast.parse(inner).body
    except (ValueError, SyntaxError, RecursionError, MemoryError):
        return []
    return tokens_of(inner) if program else []


def _numbered(tokens):
    numbers: dict[str, int] = {}
    return tuple(
        numbers.setdefault(text, len(numbers)) if kind == "name" else text for kind, text in tokens
    )
