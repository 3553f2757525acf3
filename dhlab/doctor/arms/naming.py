"""What to call a repair: the mistakes which, made on the repaired arm, give the arm that was found
wrong.
"""

import numpy as np

from ...printing import number
from ..finding import Finding
from .faults import ALPHA, NAMES, THETA, A, D, faults
from .fitting import Measured, misfit

__all__ = ["name_change", "name_data_fault", "difference_text"]

# poses without zeros or right angles, at which two arms that agree are one arm for all practical
# purposes
SAMPLES = np.random.default_rng(20).uniform(0.3, 2.4, (8, 16)) * np.random.default_rng(21).choice(
    [-1, 1], (8, 16)
)
TOLERANCE = 1e-6
MOST_SHOWN = 8
SEEN = 0.03  # share of the largest change below which another zero is not worth a word
OWN = 0.1  # share of a change's misfit that a mistake may leave to be its name
ORDER = (
    "standard-rows-in-craig-matrix",
    "craig-rows-in-standard-matrix",
    "alpha-sign",
    "length-sign",
    "joint-reversed",
    "offset-missing",
    "offset-sign",
    "a-d-exchanged",
    "length-unit",
    "tool-missing",
    "base-turned",
)


def name_change(wrong, right, data, entries=(), ends=()):
    """The Finding for a change that makes a wrong arm right.

    Parameters
    ----------
    wrong, right : Arm
        Before and after the change.
    data : Measured
        Says whether base and tool are free, and how exact the fitted numbers are.
    entries, ends : tuples
        (row, column) of the entries that were fitted; "base" or "tool".

    Returns
    -------
    Finding
        Its ``look_alikes`` are the other mistakes that give the same poses.
    """
    alike = _made_on(right, wrong, data, bool(entries))
    if right.table.convention != wrong.table.convention:
        alike += _made_on(right.to(wrong.table.convention), wrong, data, bool(entries))
    own = (
        _by_offsets(wrong, right, entries)
        if len(entries) > 1
        else _by_value(wrong, right, entries, ends)
    )
    names = [own] if own and not alike else alike + ([own] if own else [])
    if not names:
        names = _by_difference(wrong, right)
    mistake, joint, parameter, place, detail = names[0]
    others = tuple(
        dict.fromkeys(
            name for name in [n[0] for n in names[1:]] + _twins(wrong, entries) if name != mistake
        )
    )
    return Finding(
        mistake, joint, parameter, place, detail or difference_text(wrong, right), right, others
    )


def name_data_fault(fault, arm):
    """The Finding for a mistake that sits in the measurements."""
    mistake, joint, parameter, place = fault
    return Finding(mistake, joint, parameter, place, "", arm)


def _twins(arm, entries):
    """Numbers at the two ends of a table do what a base or a tool does: they cannot be told apart
    by any pose.
    """
    twins, last = [], len(arm) - 1
    of_base, of_tool = (
        ((THETA, D), (A, ALPHA)) if arm.table.convention == "standard" else ((A, ALPHA), (THETA, D))
    )
    for i, column in entries if len(entries) == 1 else ():
        if (
            i == 0
            and column in of_base
            or i == 0
            and column == D
            and abs(np.sin(arm.table.alpha[0])) < 1e-9
        ):
            twins.append("base-height-missing-or-twice" if column == D else "base-turned")
        if (
            i == 0
            and arm.table.convention == "craig"
            and column in (THETA, D)
            and arm.table.a[0] == arm.table.alpha[0] == 0
        ):
            twins.append("base-turned" if column == THETA else "base-height-missing-or-twice")
        if i == last and (
            column in of_tool
            or arm.table.convention == "standard"
            and arm.table.a[i] == arm.table.alpha[i] == 0
        ):
            twins.append("tool-missing")
    return twins


def _made_on(right, wrong, data, fitted):
    """Every mistake of the catalogue that, made on the right arm, gives the wrong one as far as was
    measured: (mistake, joint, parameter, place, detail), simplest first.
    """
    q = SAMPLES[:, : len(right)]
    T = wrong.forward(q)
    slack = (
        max(TOLERANCE, 3 * data.noise[0] if fitted and data.noise[0] > 1e-5 else 0),
        max(TOLERANCE, 3 * data.noise[1] if fitted and data.noise[1] > 1e-5 else 0),
    )
    sample = Measured(
        q,
        T[:, :3, 3],
        None if data.R is None else T[:, :3, :3],
        slack,
        data.base_free,
        data.tool_free,
    )
    rank = {name: k for k, name in enumerate(ORDER)}
    enough = min(
        sample.count, OWN * misfit(right, sample).chi2
    )  # a fault that changes nothing is no name for a change
    found = [
        fault
        for fault in faults(right)
        if misfit(fault.arm, sample).chi2 <= enough and not _unit_of_nothing(fault, wrong)
    ]
    found.sort(
        key=lambda f: (
            f.joint is None and f.mistake not in rank,
            not _same_numbers(f.arm, wrong, max(slack)),
            rank.get(f.mistake, len(rank)),
        )
    )
    return list(
        dict.fromkeys(
            (f.mistake, f.joint, f.parameter, _place(f.joint, f.parameter), "") for f in found
        )
    )


def _unit_of_nothing(fault, wrong):
    """Whether a length would have been taken in another unit where 0 stands: then it is missing,
    whatever a thousandth of it is.
    """
    return (
        fault.mistake == "length-unit"
        and fault.joint is not None
        and abs(wrong.table.rows[fault.joint - 1, NAMES.index(fault.parameter)]) < 1e-9
    )


def _same_numbers(a, b, slack):
    """Whether two arms are written alike, not only posed alike: then a mistake is what stands in
    the table, not a twin of it.
    """
    apart = a.table.rows - b.table.rows
    apart[:, [THETA, ALPHA]] = _wrapped(apart[:, [THETA, ALPHA]])
    return (
        a.table.convention == b.table.convention
        and np.abs(apart).max() <= slack
        and np.array_equal(a.sign, b.sign)
    )


def _place(joint, parameter):
    if joint is None:
        return ""
    return f"row {joint}, {parameter}" if parameter in NAMES else f"joint {joint}"


def _by_value(wrong, right, entries, ends):
    if ends:
        return _by_end(wrong, right, ends[0])
    return _name_entry(wrong, right, entries) if len(entries) == 1 else None


def _by_offsets(wrong, right, entries):
    """Several zero offsets at once: left out where 0 stood and quarter turns belong, otherwise
    zeros that are off.
    """
    was, should = wrong.table.theta, right.table.theta
    turned = np.abs(_wrapped(should - was))
    changed = np.flatnonzero(turned > max(1e-9, SEEN * turned.max()))
    if (
        any(column != THETA for _, column in entries)
        or len(changed) < 2
        or not np.array_equal(wrong.table.rows[:, 1:], right.table.rows[:, 1:])
    ):
        return None
    quarters = np.abs(_wrapped(4 * should[changed])).max() < 1e-2 and not was[changed].any()
    rows = "rows " + ", ".join(str(i + 1) for i in changed)
    return (
        "offset-missing" if quarters else "offset-value",
        None,
        "theta",
        rows,
        "; ".join(f"theta{i + 1} {_from_to(was[i], should[i], THETA)}" for i in changed),
    )


def _name_entry(wrong, right, entries):
    """(mistake, joint, parameter, place, detail) of the one entry that was fitted, by what stood
    there and what should.
    """
    ((i, column),) = entries
    was, should = wrong.table.rows[i, column], right.table.rows[i, column]
    name = (
        _of_length(was, should, i, column, wrong)
        if column in (D, A)
        else _of_angle(was, should, column, wrong.table.joints[i])
    )
    return name, i + 1, NAMES[column], _place(i + 1, NAMES[column]), _from_to(was, should, column)


def _of_length(was, should, i, column, arm):
    if abs(was + should) < 1e-6 and abs(should) > 1e-6:
        return "length-sign"
    if abs(was) > 1e-9 and any(
        abs(should / was / factor - 1) < 1e-3 for factor in (1000, 1e-3, 25.4, 25.4e-3)
    ):
        return "length-unit"
    if column == D and i == 0 and (abs(was) < 1e-9 or abs(was - 2 * should) < 1e-6):
        return "base-height-missing-or-twice"
    if column == D and i == len(arm) - 1 and abs(was) < 1e-9:
        return "tool-missing"
    if column == D and arm.table.joints[i] == "P":
        return "prismatic-constant-lost" if abs(was) < 1e-9 else "length-value"
    return "length-value"


def _of_angle(was, should, column, letter):
    turn = np.rad2deg(_wrapped(should - was))
    if column == THETA:
        if letter == "P" and abs(was) < 1e-9:
            return "prismatic-constant-lost"
        if abs(was) < 1e-9:
            return "offset-missing"
        if abs(_wrapped(was + should)) < 1e-3:
            return "offset-sign"
        return (
            "offset-counted-twice"
            if abs(was - 2 * should) < 1e-3
            else "offset-in-degrees"
            if abs(was * np.pi / 180 - should) < 1e-3
            else "offset-value"
        )
    if abs(_wrapped(was + should)) < 1e-3:
        return "alpha-sign"
    if abs(was * np.pi / 180 - should) < 1e-3:
        return "alpha-in-degrees"
    if abs(abs(turn) - 180) < 0.1:
        return "z-flip-incomplete"
    if abs(abs(turn) - 90) < 0.1:
        return "z-across-joint-axis"
    return (
        "pi-rounded"
        if abs(turn) < 0.7 and abs(np.rad2deg(should) / 90 - round(np.rad2deg(should) / 90)) < 1e-6
        else "alpha-value"
    )


def _by_end(wrong, right, end):
    was, should = getattr(wrong, end), getattr(right, end)
    moved = should @ np.linalg.inv(was) if end == "base" else np.linalg.inv(was) @ should
    turn = np.rad2deg(np.arccos(np.clip((np.trace(moved[:3, :3]) - 1) / 2, -1, 1)))
    shift = ", ".join(number(v * 1000, 1) for v in moved[:3, 3])
    detail = f"moved by ({shift}) mm" + (
        f" and turned by {number(turn, 2)}°" if turn > 0.01 else ""
    )
    name = (
        "tool-missing"
        if end == "tool"
        else "base-turned"
        if turn > 0.5
        else "base-height-missing-or-twice"
    )
    return name, None, end, end, detail


def _by_difference(wrong, right):
    """A change that the catalogue does not know: named by the kind of the entries that differ."""
    changed = np.argwhere(np.abs(wrong.table.rows - right.table.rows) > 1e-9)
    for i, column in changed:
        own = _by_value(wrong, right, ((i, column),), ())
        if own:
            rows = ", ".join(f"row {r + 1}, {NAMES[c]}" for r, c in changed)
            return [
                (own[0], own[1] if len({r for r, _ in changed}) == 1 else None, own[2], rows, "")
            ]
    signs = np.flatnonzero(wrong.sign != right.sign)
    if len(signs):
        return [("joint-reversed", int(signs[0]) + 1, "sign", f"joint {signs[0] + 1}", "")]
    end = "base" if not np.allclose(wrong.base, right.base) else "tool"
    return [_by_end(wrong, right, end)]


def difference_text(wrong, right):
    """What stood there and what should."""
    if wrong.table.convention != right.table.convention:
        return f"the rows are {right.table.convention}"
    if wrong.table.joints != right.table.joints:
        return f"the joints are {right.table.joints}"
    changed = np.argwhere(np.abs(wrong.table.rows - right.table.rows) > 1e-9)
    if len(changed) > MOST_SHOWN:
        return f"{len(changed)} numbers of the table change"
    parts = [
        f"{NAMES[c]}{i + 1} {_from_to(wrong.table.rows[i, c], right.table.rows[i, c], c)}"
        for i, c in changed
    ]
    parts += [
        f"joint {i + 1} counts the other way" for i in np.flatnonzero(wrong.sign != right.sign)
    ]
    parts += [
        _by_end(wrong, right, end)[4]
        for end in ("base", "tool")
        if not np.allclose(getattr(wrong, end), getattr(right, end), atol=1e-9) and not parts
    ]
    return "; ".join(parts)


def _from_to(was, should, column):
    if column in (THETA, ALPHA):
        return (
            f"is {number(np.rad2deg(was), 3)}°, should be"
            f" {number(np.rad2deg(_wrapped(should)), 3)}°"
        )
    return f"is {number(was * 1000, 2)} mm, should be {number(should * 1000, 2)} mm"


def _wrapped(angle):
    """Into (-π, π]."""
    return np.pi - (np.pi - angle) % (2 * np.pi)
