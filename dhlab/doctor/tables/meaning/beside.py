"""Columns of a pasted table beside the four: what they are, or the question what they are; none is
left out in silence.
"""

import re
from dataclasses import replace

from ..cells import Cell, cell_of, cell_or_none
from ..evidence.branches import (
    added_at_joints,
    added_in_words,
    slid_by_calls,
    sliding_at_joints,
    turned_at_joints,
)
from ..language.words import KINDS

__all__ = [
    "APART",
    "DASH",
    "Contradicted",
    "labelled",
    "require_no_fifth",
    "slid",
    "with_added",
    "with_theta",
    "with_types",
]


class Contradicted(ValueError):
    """A row has a number that the program leaves out: nobody but its author knows which counts."""


DASH = Cell(0.0, text="-")
ENUMERATED = re.compile(  # JointType::Static
    r"(?:::|\.)(revolute|rotary|rotational|hinge|prismatic|linear|fixed|static)\b", re.IGNORECASE
)
OF_ONE = re.compile(  # types(3) = 'P', joint_type[2] = "prismatic"
    r"\b\w*type\w*([(\[])(\d)[)\]]\s*=\s*['\"](r|p|revolute|prismatic)['\"]", re.IGNORECASE
)
SMALL = re.compile(  # type = ['r', 'r', 'p']
    r"\w*(?:type|joint|kind)\w*\s*=\s*[\[{(]((?:\s*['\"][rp]['\"]\s*,?)+)[\]})]"
)
FIFTH = ("b", "beta", "gamma", "epsilon")  # of branched arms and of nearly parallel axes
# what stands in tables beside the four and moves nothing
APART = re.compile(
    r"mass|weight|inerti|speed|veloc|torque|gear|ratio|range|limit|max|min|home|servo|motor|port"
    r"|pin|pulse|steps?\b|note|comment|remark|name|desc|example|pose|power|payload|accel|encoder|id\b"
    r"|^#$|child|parent|initial|current|value|page|step|^mu\b|^i_?(?:xx|yy|zz)\b|^q[^\w\s]"
    r"|mas[ao]\b|peso|gewicht|poids|geschwindigkeit|vitesse|velocidad|drehmoment|couple|масса|вес|质量|質量"
    # a unit of neither a length nor an angle: (kg), [Nm], deg/s
    r"|[\[(/,_ ](?:k?g|n|n[ .*·]?m|rpm|kw|w|v|ms|s|hz|%)\s*[\])]?\s*$",
    re.IGNORECASE,
)


def slid(row, roles):
    """A row whose column of variables names the length that its joint changes."""
    if not {"theta", "d"} <= set(roles):
        return row
    theta, d = (row[roles.index(role)] for role in ("theta", "d"))
    if theta.variable != "d" or not (d.is_constant or d.letters == theta.letters):
        return row
    moved = Cell(d.value, theta.letters, d.unit, f"{d.text}*")
    swapped = {"theta": Cell(0.0), "d": moved}
    return tuple(swapped.get(role, cell) for role, cell in zip(roles, row))


def with_theta(table_rows, roles):
    """(rows, roles, notes) where a heading has d, a and alpha and no column theta."""
    if "theta" in roles or "offset" in roles or not {"d", "alpha"} & set(roles):
        return table_rows, roles, ()
    if not {"d", "a", "alpha"} <= set(roles) and not {"d", "r", "alpha"} <= set(roles):
        return table_rows, roles, ()
    note = "no column theta: each row is taken for a joint that turns, with its zero at theta = 0"
    return tuple((*row, Cell(0.0)) for row in table_rows), (*roles, "theta"), (note,)


def with_added(table, source):
    """The table with what the program adds to theta at single joints.

    Raises
    ------
    ValueError
        It is not said which row that is.
    """
    n, notes = len(table.rows), []
    zeros = list(table.zeros) or [Cell(0.0)] * n
    by_name = table.why == "as the names of the arrays say"
    added = {**added_in_words(source.text), **added_at_joints(source.code, by_name)}
    for k, text in added.items():
        value = source.value(text)
        if k is None or not 0 <= k < n or value is None:
            raise ValueError(
                f"recognise_table: the program adds {text} to theta at one joint; in which row is"
                " it? Write it into the row, as theta - 90"
            )
        own = [*zip(table.rows[k], table.roles or ())]
        if any(role == "theta" and _says(cell, value) for cell, role in own):
            continue  # the row itself is where the program adds it
        if zeros[k].value or any(cell.value for cell, role in own if role in ("theta", "offset")):
            raise ValueError(
                f"recognise_table: row {k + 1} has a zero of its own, and the program adds {text}"
                " to theta; do both count? Leave one of them out, or add them up"
            )
        zeros[k] = cell_of(value, text)
        notes.append(f"{text} is added to theta of row {k + 1}, as the program does")
    signs = list(table.signs) or [1] * n
    for k in turned_at_joints(source.code) if by_name else ():
        if k < len(signs):
            signs[k] = -1
            notes.append(f"joint {k + 1} counts against its axis, as the program has it")
    zeros = tuple(zeros) if any(cell.value for cell in zeros) else ()
    table = replace(table, signs=tuple(signs), zeros=zeros, notes=(*table.notes, *notes))
    return _with_slides(table, source)


def _says(cell, zero):
    """Whether a cell is a variable with this zero, ``q[0] + pi/2``."""
    return bool(cell.letters) and abs(cell.value - zero.number) < 1e-9


def _with_slides(table, source):
    """The table whose joints slide where the program moves their d."""
    if "P" in table.kinds or not table.roles or not {"theta", "d"} <= set(table.roles):
        return table
    kinds, notes = [kind or "R" for kind in table.kinds or [""] * len(table.rows)], []
    sliding = {**sliding_at_joints(source.code), **slid_by_calls(source.code)}
    for k, counts in sliding.items():
        if k is None and all(table.kinds or ("",)):
            continue  # each row says whether it is one of these
        if k is None or not 0 <= k < len(kinds):
            raise ValueError(
                "recognise_table: the program moves d and not theta at some joint; which rows"
                " slide? Write q3 into column d of the third row if it is that one"
            )
        held = [cell for cell, role in zip(table.rows[k], table.roles) if role == "d"]
        if not counts and any(cell.value for cell in held):
            raise Contradicted(
                f"recognise_table: row {k + 1} has a d of its own, and the program puts q in its"
                " place; does it count? Write 0 there, or add it up in the program"
            )
        kinds[k] = "P"
        notes.append(f"joint {k + 1} slides, as the program moves its d")
    if not notes:
        return table
    return replace(table, kinds=tuple(kinds), notes=(*table.notes, *notes))


def labelled(table, grid, source):
    """The table with the comments behind its rows for labels, where it has none."""
    said = dict(source.comments)
    words = [said.get(int(where.split()[1]), "").strip() for where, _ in grid if "line" in where]
    if len(words) != len(table.rows) or any(table.labels):
        return table
    return replace(table, labels=tuple(words))


def require_no_fifth(names, cells, where):
    """A fifth number that is not 0 makes the row another one than Denavit and Hartenberg's."""
    for name, cell in zip(names, cells):
        read = cell_or_none(str(cell)) if name in FIFTH else None
        if read is not None and (read.value or read.letters):
            raise ValueError(
                f"recognise_table: {where}: expected four numbers of Denavit and Hartenberg, found"
                f" {name} = {str(cell)[:20]} as well; give the joint axes instead, as an axis sheet"
            )


def with_types(table, source):
    """The table with the types of ``rigidBodyJoint('j1', 'prismatic')`` and of lists of types."""
    word = r"['\"](revolute|prismatic|fixed)['\"]"
    made = re.findall(
        rf"Joint\s*\(\s*(?:['\"][^'\"\n]*['\"]|\[[^\]\n]*\])\s*,\s*{word}", source.code
    )
    listed = re.search(rf"[\[{{(]\s*{word}(?:[\s,;]+{word})+\s*[\]}})]", source.code)
    types = re.findall(word, listed[0]) if listed else made
    letters = re.findall(rf"['\"]([RP]{{{len(table.rows)}}})['\"]", source.code)
    listed = re.findall(r"[\[{(]((?:\s*['\"][RP]['\"]\s*,?)+)[\]})]", source.code)
    letters += [joined for one in listed if (joined := re.sub(r"[^RP]", "", one))]
    letters += [re.sub(r"[^rp]", "", one).upper() for one in SMALL.findall(source.code)]
    typed = [KINDS[one.lower()] for one in ENUMERATED.findall(source.code)]
    single = {
        int(k) - (mark == "("): KINDS[kind.lower()] for mark, k, kind in OF_ONE.findall(source.code)
    }
    if not any(table.kinds) and "P" in single.values() and max(single) < len(table.rows):
        return replace(table, kinds=tuple(single.get(k, "R") for k in range(len(table.rows))))
    if not any(table.kinds) and len(typed) == len(table.rows):
        return replace(table, kinds=tuple(typed))
    if not any(table.kinds) and any("P" in one and len(one) == len(table.rows) for one in letters):
        return replace(table, kinds=tuple(letters[0]))
    if "prismatic" not in types or any(table.kinds):
        return table
    if len(types) == len(table.rows):
        return replace(table, kinds=tuple(KINDS[one] for one in types))
    if all(cell.is_constant for row in table.rows for cell in row):
        raise ValueError(
            "recognise_table: a joint of this text is prismatic; which row is it? Write its"
            " variable, as d3, into the row"
        )
    return table
