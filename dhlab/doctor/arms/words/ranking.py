"""Among explanations that all fit: which is told first, under which name, what it cannot be told
from, and which pose would decide.
"""

import itertools
from dataclasses import replace

import numpy as np

from ...mistakes.remade import A, D, with_parts, with_rows
from ..search.fitting import Fit, fit, misfit
from ..search.measured import Measured, limit
from .differences import coupling_texts, difference_text
from .naming import name_change, name_changes, name_data_fault

__all__ = [
    "differs",
    "named",
    "ranked",
    "rivals_of",
    "snapped",
    "taken_over",
    "telling_pose",
    "with_equivalents",
]

MOST_EQUIVALENTS = 4
NEAR_ROUND = 5.0  # standard deviations within which a shift may be none
WORSE_ROUND = 12.0  # χ² that a rounder base or tool may cost


def ranked(arm, explanations, data, part):
    """The explanations, snapped to round numbers: fewest mistakes first, then fewest numbers that
    nobody would have guessed, then the smaller misfit. ``part`` hands out as many as there is time
    for.
    """
    return sorted(
        (snapped(e, data) for e in part(explanations, least=1)),
        key=lambda e: (
            e.changes,
            e.odd + 6 * len(e.ends),
            len(e.entries) > 2,
            round(e.fit.chi2, 3),
            _touched(arm, e.fit.arm),
            _not_signs(arm, e.fit.arm),
        ),
    )


def _touched(arm, repaired):
    """How many numbers and senses a repair changes: of two that make the same arm, the one that
    changes less is read first.
    """
    return int(
        (np.abs(arm.table.rows - repaired.table.rows) > 1e-9).sum()
        + (arm.sign != repaired.sign).sum()
        + len(coupling_texts(arm, repaired))
    )


def _not_signs(arm, repaired):
    """How many of the changed numbers are not the old number's negative: of two repairs of the same
    size, the wrong sign is read first.
    """
    return int((np.abs(np.abs(arm.table.rows) - np.abs(repaired.table.rows)) > 1e-9).sum())


def named(explanation, data, part):
    """The findings of an explanation, one a mistake; ``part`` as for :func:`name_changes`."""
    if explanation.data_fault is not None:
        return [name_data_fault(explanation.data_fault, explanation.fit.arm)]
    chain, findings = explanation.chain, []
    entries = list(explanation.entries)
    for step, (wrong, right) in enumerate(itertools.pairwise(chain)):
        last = step == len(chain) - 2
        own = (
            tuple(e for e in entries if abs(wrong.table.rows[e] - right.table.rows[e]) > 1e-12)
            if len(chain) > 2
            else tuple(entries)
        )
        ends = explanation.ends if last and not own else ()
        found = name_changes(wrong, right, data, part, own, ends)
        findings += [replace(one, repair=chain[-1]) for one in found]
    return findings


def with_equivalents(finding, best, others, data, part):
    """The finding with the names of the other repairs that make the same arm, and a note on those
    of a single number.
    """
    tables, names, notes = [best.fit.arm.table.rows], [*finding.look_alikes], []
    for other in part(others):
        if (
            len(tables) > MOST_EQUIVALENTS
            or other.changes > best.changes
            or other.data_fault is not None
            or len(other.entries) > 1
            or other.ends
        ):
            continue
        wrong, repaired = other.chain[0], other.fit.arm
        if any(
            np.allclose(repaired.table.rows, rows, atol=5 * max(data.noise)) for rows in tables
        ) or differs(best.fit.arm, repaired, data):
            continue
        same = name_change(wrong, repaired, data, part, other.entries)
        tables.append(repaired.table.rows)
        names += [same.mistake, *same.look_alikes]
        if _touched(wrong, repaired) == 1:
            notes.append(f"The same arm comes of this: {difference_text(wrong, repaired)}.")
    return replace(
        finding, look_alikes=tuple(name for name in dict.fromkeys(names) if name != finding.mistake)
    ), tuple(dict.fromkeys(notes))  # a whole turn apart, two are one to read


def snapped(explanation, data):
    """Fitted numbers made round where a round one fits: -90, not -89.97."""
    if explanation.ends and not explanation.entries:
        return _rounded_end(explanation, data)
    if not explanation.entries or explanation.fit.sigma is None:
        return replace(explanation, odd=len(explanation.entries))
    arm, start = explanation.fit.arm, explanation.chain[0]
    rows = arm.table.rows
    for entry, sigma in zip(explanation.entries, explanation.fit.sigma):
        slack, old = max(4 * sigma, 1e-8), start.table.rows[entry]
        stays = len(explanation.entries) > 2 and abs(rows[entry] - old) <= slack
        rows[entry] = old if stays else _round(rows[entry], start.table.rows, entry, slack)
    made_round = with_rows(arm, rows)
    found = (
        fit(made_round, data, ())
        if data.base_free or data.tool_free or explanation.ends
        else misfit(made_round, data)
    )
    if explanation.ends:
        found = Fit(
            made_round,
            float((data.residual(made_round.forward(data.q)) ** 2).sum()),
            explanation.fit.fitted,
        )
    if found.chi2 > max(limit(data.count), explanation.fit.chi2 * 1.5 + 20):
        return replace(explanation, odd=len(explanation.entries))
    odd = sum(rows[entry] == arm.table.rows[entry] for entry in explanation.entries)
    found = Fit(found.arm, found.chi2, explanation.fit.fitted, explanation.fit.sigma)
    return replace(explanation, fit=found, chain=taken_over(explanation, found.arm), odd=odd)


def _rounded_end(explanation, data):
    """A base or a tool that was fitted, not moved or turned where that fits about as well."""
    (end,) = explanation.ends
    was, found = getattr(explanation.chain[0], end), explanation.fit
    moved = np.linalg.inv(was) @ getattr(found.arm, end)
    moved = moved if end == "tool" else getattr(found.arm, end) @ np.linalg.inv(was)
    quarter = np.round(moved[:3, :3])
    turn = quarter if abs(np.linalg.det(quarter) - 1) < 1e-9 else moved[:3, :3]
    near = NEAR_ROUND * max(data.noise[0], data.noise[1] * data.reach)
    shift = np.where(np.abs(moved[:3, 3]) < near, 0, moved[:3, 3])
    for R, p in ((turn, shift), (turn, moved[:3, 3]), (moved[:3, :3], shift)):
        made_round = np.eye(4)
        made_round[:3, :3], made_round[:3, 3] = R, p
        changed = made_round @ was if end == "base" else was @ made_round
        arm = with_parts(found.arm, **{end: changed})
        chi2 = float((data.residual(arm.forward(data.q)) ** 2).sum())
        if chi2 < found.chi2 + WORSE_ROUND:
            done = replace(found, arm=arm, chi2=chi2, left=None)
            return replace(explanation, fit=done, chain=(*explanation.chain[:-1], arm))
    return explanation


def taken_over(explanation, arm):
    """The arms on the way to another last one, whose fitted numbers they take over."""
    rows, fitted = arm.table.rows, explanation.fit.arm.table.rows
    middle = [
        with_rows(link, _take(link.table.rows, rows, explanation.entries, fitted))
        for link in explanation.chain[1:-1]
    ]
    return (explanation.chain[0], *middle, arm)


def _take(link_rows, rows, entries, fitted):
    """An arm on the way takes the round numbers for the entries it has already repaired."""
    for entry in entries:
        if link_rows[entry] == fitted[entry]:
            link_rows[entry] = rows[entry]
    return link_rows


def _round(value, rows, entry, slack):
    """The first number within the slack that a person would have meant: a quarter turn, the old
    number's negative, its neighbour's, its double …
    """
    i, column = entry
    old = rows[i, column]
    if column in (D, A):
        near = [0, -old, rows[i, D], rows[i, A], 2 * old, old / 2, 1000 * old, old / 1000]
    else:
        turn = 2 * np.pi * np.round((value - old) / (2 * np.pi))
        quarter = np.pi / 2 * np.round(value / (np.pi / 2))
        near = [
            quarter,
            -old + turn,
            -old,
            old + np.pi,
            old - np.pi,
            old + np.pi / 2,
            old - np.pi / 2,
            2 * old,
            old / 2,
            old * np.pi / 180,
        ]
    value = next((v for v in near if v != old and abs(v - value) <= slack), value)
    return (
        value
        if column in (D, A) or abs(value) <= np.pi + 1e-9
        else (value + np.pi) % (2 * np.pi) - np.pi
    )


def rivals_of(best, others, data):
    """Explanations of as few mistakes whose repaired arm moves otherwise."""
    rivals = []
    for other in others:
        if other.changes > best.changes or other.data_fault is not None or len(rivals) == 3:
            continue
        if all(
            differs(other.fit.arm, arm, data)
            for arm in [best.fit.arm, *(r.fit.arm for r in rivals)]
        ):
            rivals.append(other)
    return rivals


def differs(a, b, data):
    """Whether two arms move otherwise by more than the noise would hide."""
    q = np.random.default_rng(3).uniform(-2.5, 2.5, (6, len(a)))
    T, U = a.forward(q), b.forward(q)
    sample = Measured(
        q, U[:, :3, 3], None if data.R is None else U[:, :3, :3], tuple(5 * s for s in data.noise)
    )
    return (sample.residual(T) ** 2).max() > 1


def telling_pose(arms):
    """Of 200 random configurations inside the limits the one at which the arms differ most: the
    pair that is told apart least well decides.
    """
    rng = np.random.default_rng(4)
    first = arms[0]
    slides = first.table.prismatic
    bounds = [
        pair or ((0.0, 0.5) if slide else (-2.5, 2.5))
        for pair, slide in zip(first.limits or [None] * len(first), slides)
    ]
    low, high = np.array(bounds).T
    q = rng.uniform(np.maximum(low, -2.5), np.minimum(high, 2.5), (200, len(first)))
    ends = [arm.forward(q)[:, :3, 3] for arm in arms]
    apart = [np.linalg.norm(a - b, axis=1) for a, b in itertools.combinations(ends, 2)]
    return q[np.argmax(np.min(apart, axis=0))] if apart else q[0]
