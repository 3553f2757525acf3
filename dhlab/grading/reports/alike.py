"""Whose code is suspiciously alike: short runs of tokens that few people write, whatever the names
and comments.

A run of tokens is a fingerprint (Schleimer, Wilkerson & Aiken, "Winnowing", SIGMOD 2003, section
2). Within each run the names are numbered in the order in which they come up, so that renaming
changes nothing. What was handed out, and what many in the class write, is no evidence.
"""

import io
import keyword
import tokenize
from collections import Counter, defaultdict
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import combinations
from typing import Any

from ...course.exercises import exercises
from .cells import answered

__all__ = ["Pair", "alike", "answers"]

RUN = 12  # tokens: about a line of a formula
# a run that more than this share of the class, or this many, wrote is how one writes it, no copy:
# of twenty, four who copied one from the other are still found
FEW, MANY = 0.2, 10
# rare runs in common, and as a share of the shorter one's; measured in benchmarks/classroom.py
ENOUGH, SHARE = 40, 0.8
SINK = 3  # people, of whom no two are alike, that one person's code is alike to
LARGEST = 10_000  # characters of one answer that are read; a long one has a thousand
MOST = 20_000  # of all answers to one lesson; the longest lesson's have eight thousand
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
    """The code of each exercise in a notebook: what stands between its check and the one before.

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
    {'05.1': 'x = 1\\n'}
    """
    found: dict[str, str] = {}
    left: dict[str, int] = defaultdict(lambda: MOST)
    code = ""
    for _, part, exercise in answered(notebook):
        code += part or ""
        if exercise:
            code = code[: min(LARGEST, left[exercise[:2]])]
            if exercise in exercises():
                found[exercise] = code
                left[exercise[:2]] -= len(code)
            code = ""
        elif part is not None:
            code += "\n"
    return found


def alike(codes: Mapping[str, Mapping[str, str]], handed_out: Mapping[str, str]) -> list[Pair]:
    """The pairs whose answers share more rare runs than chance and a common lesson explain, most
    alike first.

    Parameters
    ----------
    codes : mapping of str to mapping
        For each student the code of each exercise, as :func:`answers` gives it.
    handed_out : mapping
        The same of the lesson as it was handed out.

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
    most = min(max(2, FEW * len(codes)), MANY)
    common: Counter[tuple[str, ...]] = Counter()
    rare: Counter[str] = Counter()
    for students in writers.values():
        if len(students) <= most:
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
            _where(codes, pair, lambda run: 1 < len(writers.get(run, ())) <= most),
        )
        for pair, share in found.items()
        if share >= SHARE
    ]
    return sorted(_without_sinks(pairs), key=lambda pair: (-pair.share, pair.students))


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
    tokens = _tokens(code)
    return {hash(_numbered(tokens[i : i + RUN])) for i in range(len(tokens) - RUN + 1)}


def _tokens(code):
    """(kind, text) of each token that means something; a program that cannot be read gives those up
    to the fault.
    """
    found: list[tuple[str, str]] = []
    try:
        for token in tokenize.generate_tokens(io.StringIO(code).readline):
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
    except (tokenize.TokenError, SyntaxError):
        pass
    return found


def _numbered(tokens):
    numbers: dict[str, int] = {}
    return tuple(
        numbers.setdefault(text, len(numbers)) if kind == "name" else text for kind, text in tokens
    )
