"""What to call a repair: the mistakes which, made on the repaired arm, give the arm that was found
wrong.
"""

import numpy as np

from ....table import COLUMNS
from ...finding import Finding
from ...mistakes.changes import Scaled
from ...mistakes.faults import faults
from ...mistakes.registry import OTHER, preference, value_mistake
from ...mistakes.remade import ALPHA, THETA, A, D
from ..search.fitting import misfit, misfits, within
from ..search.measured import Measured
from .differences import (
    changed_numbers,
    coupling_texts,
    difference_text,
    end_text,
    moved_by,
    number_text,
    wrapped,
)
from .numbers import name_number

__all__ = ["name_change", "name_changes", "name_data_fault", "name_every_change"]

# poses without zeros or right angles, at which two arms that agree are one arm for all practical
# purposes
SAMPLES = np.random.default_rng(20).uniform(0.3, 2.4, (8, 16)) * np.random.default_rng(21).choice(
    [-1, 1], (8, 16)
)
TOLERANCE = 1e-6
SEEN = 0.03  # share of the largest change below which another zero is not worth a word
OWN = 0.1  # share of a change's misfit that a mistake may leave to be its name
TURNED = 0.5  # degrees; a base that is turned less is only shifted


def name_changes(wrong, right, data, part, entries=(), ends=()):
    """The Findings for a change that makes a wrong arm right: one, where one mistake makes it, else
    one for each thing in which the arms differ.

    Parameters
    ----------
    wrong, right : Arm
        Before and after the change.
    data : Measured
        Says whether base and tool are free, and how exact the fitted numbers are.
    part : callable
        Hands out the mistakes that are tried, as long as there is time; then a change is named by
        what stood there and what should.
    entries, ends : tuples
        (row, column) of the entries that were fitted; "base" or "tool".

    Returns
    -------
    tuple of Finding
        Their ``look_alikes`` are the other mistakes that give the same poses.
    """
    alike = _made_on(right, wrong, data, bool(entries), part)
    if right.table.convention != wrong.table.convention:
        other = right.to(wrong.table.convention)
        alike += _made_on(other, wrong, data, bool(entries), part)
    own = (
        _by_offsets(wrong, right, entries)
        if len(entries) > 1
        else _by_value(wrong, right, entries, ends)
    )
    names = [own] if own and not alike else alike + ([own] if own else [])
    several = () if names else _by_everything(wrong, right)
    if len(several) > 1:
        return several
    if not names:
        names = _by_difference(wrong, right)
    if own and len(entries) == 1 and _of_another_number(names[0], own):
        names = [own, *(name for name in names if name != own)]
    mistake, joint, parameter, place, detail = names[0]
    same = [name[0] for name in names[1:]] + _same_as_ends(wrong, entries)
    others = tuple(dict.fromkeys(name for name in same if name != mistake))
    detail = detail or difference_text(wrong, right)
    return (Finding(mistake, joint, parameter, place, detail, right, others),)


def _of_another_number(name, own):
    """Whether a name is that of a number of the table, and another one than was fitted."""
    return name[1] is not None and name[2] in COLUMNS and name[1:3] != own[1:3]


def name_change(*given, **options):
    """The first Finding of :func:`name_changes`."""
    return name_changes(*given, **options)[0]


def name_data_fault(fault, arm):
    """The Finding for a mistake that sits in the measurements."""
    mistake, joint, parameter, place = fault
    return Finding(mistake, joint, parameter, place, "", arm)


def name_every_change(wrong, right, entries):
    """A Finding for each thing in which a rebuilt arm differs: the convention, senses of joints,
    and the entries (row, column) that were fitted.
    """
    found = []
    if right.table.convention != wrong.table.convention:
        mistake = value_mistake(f"rows are {right.table.convention}")
        found.append((mistake, None, None, "", ""))
    found += [
        (value_mistake("sign"), int(i) + 1, "sign", f"joint {i + 1}", "counts the other way")
        for i in np.flatnonzero(right.sign != wrong.sign)
    ]
    found += [_by_number(wrong, right, entry) for entry in entries]
    return tuple(Finding(*parts, right) for parts in found)


# ---- every mistake, tried


def _made_on(right, wrong, data, fitted, part):
    """Every mistake of the catalogue that, made on the right arm, gives the wrong one as far as was
    measured: (mistake, joint, parameter, place, detail), simplest first.
    """
    slack = [
        max(TOLERANCE, 3 * noise if fitted and noise > 1e-5 else 0) for noise in data.noise[:2]
    ]
    sample = _sample(wrong, data, slack)
    # a fault that changes nothing is no name for a change
    enough = min(sample.count, OWN * misfit(right, sample).chi2)
    tried = _within(part(faults(right)), sample, enough)
    found = [fault for fault in tried if not _scaled_to_nothing(fault, wrong)]
    found.sort(key=lambda fault: _order(fault, wrong, max(slack)))
    return list(
        dict.fromkeys(
            (f.mistake, f.joint, f.parameter, _place(f.joint, f.parameter), "") for f in found
        )
    )


def _within(tried, sample, enough):
    """Those of the faults tried whose arm leaves no more than ``enough``: with ends that are fixed
    all at once, which takes next to no time.
    """
    if sample.base_free or sample.tool_free:
        return [fault for fault in tried if within(fault.arm, sample, enough)]
    made = list(tried)
    left = misfits([fault.arm for fault in made], sample)
    return [fault for fault, each in zip(made, left) if each.chi2 <= enough]


def _sample(arm, data, noise):
    """Poses of an arm as measurements of the same kind as the data."""
    q = SAMPLES[:, : len(arm)]
    T = arm.forward(q)
    R = None if data.R is None else T[:, :3, :3]
    return Measured(q, T[:, :3, 3], R, tuple(noise), data.base_free, data.tool_free)


def _order(fault, wrong, slack):
    """What is told first: a place before the whole arm, what stands in the table before what does
    the same, the better known.
    """
    rank = preference(fault.mistake)
    return (fault.joint is None and rank == OTHER, not _same_numbers(fault.arm, wrong, slack), rank)


def _scaled_to_nothing(fault, wrong):
    """Whether a length would have been multiplied where 0 stands: then it is missing, whatever a
    thousandth of it is.
    """
    change = getattr(fault.change, "change", None)
    if fault.joint is None or fault.parameter not in ("d", "a") or not isinstance(change, Scaled):
        return False
    column = COLUMNS.index(fault.parameter)
    return change.factors[column] != 0 and abs(wrong.table.rows[fault.joint - 1, column]) < 1e-9


def _same_numbers(a, b, slack):
    """Whether two arms are written alike, not only posed alike: then a mistake is what stands in
    the table, and does not only do the same.
    """
    apart = a.table.rows - b.table.rows
    apart[:, [THETA, ALPHA]] = wrapped(apart[:, [THETA, ALPHA]])
    return (
        a.table.convention == b.table.convention
        and np.abs(apart).max() <= slack
        and np.array_equal(a.sign, b.sign)
        and not coupling_texts(a, b)
    )


def _place(joint, parameter):
    if joint is None:
        return ""
    return f"row {joint}, {parameter}" if parameter in COLUMNS else f"joint {joint}"


# ---- by what stood there and what should


def _by_value(wrong, right, entries, ends):
    if ends:
        return _by_end(wrong, right, ends[0])
    return _by_number(wrong, right, entries[0]) if len(entries) == 1 else None


def _by_number(wrong, right, entry):
    """(mistake, joint, parameter, place, detail) of the one entry that was fitted."""
    i, column = entry
    was, should = wrong.table.rows[entry], right.table.rows[entry]
    mistake = name_number(was, should, wrong, entry)
    return (
        mistake,
        int(i) + 1,
        COLUMNS[column],
        _place(i + 1, COLUMNS[column]),
        number_text(was, should, column),
    )


def _by_offsets(wrong, right, entries):
    """Several zero offsets at once: left out where 0 stood and quarter turns belong, otherwise
    zeros that are off.
    """
    was, should = wrong.table.theta, right.table.theta
    turned = np.abs(wrapped(should - was))
    changed = np.flatnonzero(turned > max(1e-9, SEEN * turned.max()))
    if (
        any(column != THETA for _, column in entries)
        or len(changed) < 2
        or not np.array_equal(wrong.table.rows[:, 1:], right.table.rows[:, 1:])
    ):
        return None
    names = {name_number(was[i], should[i], wrong, (i, THETA)) for i in changed}
    quarters = np.abs(wrapped(4 * should[changed])).max() < 1e-2
    return (
        names.pop() if quarters and len(names) == 1 else value_mistake("theta"),
        None,
        "theta",
        "rows " + ", ".join(str(i + 1) for i in changed),
        "; ".join(f"theta{i + 1} {number_text(was[i], should[i], THETA)}" for i in changed),
    )


def _by_end(wrong, right, end):
    _, turn = moved_by(wrong, right, end)
    moved = "tool" if end == "tool" else "base turn" if turn > TURNED else "base shift"
    return value_mistake(moved), None, end, end, end_text(wrong, right, end)


def _by_everything(wrong, right):
    """A Finding for each number and each sense that differs, where nothing else does."""
    if coupling_texts(wrong, right) or any(
        not np.allclose(getattr(wrong, end), getattr(right, end)) for end in ("base", "tool")
    ):
        return ()
    return name_every_change(wrong, right, map(tuple, changed_numbers(wrong, right)))


def _by_difference(wrong, right):
    """A change that the catalogue does not know: named by the kind of the entries that differ."""
    changed = changed_numbers(wrong, right)
    if len(changed):
        own = _by_number(wrong, right, tuple(changed[0]))
        rows = ", ".join(f"row {r + 1}, {COLUMNS[c]}" for r, c in changed)
        return [(own[0], own[1] if len({r for r, _ in changed}) == 1 else None, own[2], rows, "")]
    signs = np.flatnonzero(wrong.sign != right.sign)
    if len(signs):
        joint = int(signs[0]) + 1
        return [(value_mistake("sign"), joint, "sign", f"joint {joint}", "")]
    if coupled := coupling_texts(wrong, right):
        return [(value_mistake("coupling"), None, "coupling", "", "; ".join(coupled))]
    end = "base" if not np.allclose(wrong.base, right.base) else "tool"
    return [_by_end(wrong, right, end)]


def _same_as_ends(arm, entries):
    """Numbers at the two ends of a table do what a base or a tool does: no pose can tell them
    apart.
    """
    if len(entries) != 1:
        return []
    ((i, column),) = entries
    return [value_mistake(end) for end in _ends_moved(arm, i, column)]


def _ends_moved(arm, i, column):
    standard, table, last = arm.table.convention == "standard", arm.table, len(arm) - 1
    of_base, of_tool = ((THETA, D), (A, ALPHA)) if standard else ((A, ALPHA), (THETA, D))
    upright = abs(np.sin(table.alpha[0])) < 1e-9
    if i == 0 and (column in of_base or (column == D and upright)):
        yield "base shift" if column == D else "base turn"
    if i == 0 and not standard and column in (THETA, D) and table.a[0] == table.alpha[0] == 0:
        yield "base turn" if column == THETA else "base shift"
    if i == last and (column in of_tool or (standard and table.a[i] == table.alpha[i] == 0)):
        yield "tool"
