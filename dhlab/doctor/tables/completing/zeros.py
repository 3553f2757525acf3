"""Zeros that a text adds to joint angles beside the rows: the rows must have them, or it asks."""

import re

from ..dialects.flat import arrays_in
from ..language.roles import role_of
from ..meaning.columns import snapped

__all__ = ["require_zeros"]

QUARTER = (
    r"(?:\(?-?\d*\.?\d*\s*\*?\s*(?:(?:np|math|numpy|sp)\.)?pi\b(?!\s*/\s*180)(?:\s*/\s*\d)?"
    r"|1\.57\d*|3\.14\d*|(?<!/)(?<!/ )(?:90|180)(?:\.0*)?(?!\.?\d|\s*/\s*[\w.]*pi))"
)
ANGLE = r"(?<![\w.])(?:q|theta|th|t(?=[_\d]))\w{0,7}?(?:_?\{?\d\}?|[\[(]\w+[\])])?"
# q2 - pi/2, theta[1] += 90, q + deg2rad([0, -90])
SHIFTED = re.compile(
    rf"{ANGLE}(?:[-+]| [-+]=?(?= ))[ ]?(?:(?!\bq|theta|,\s)[^;\n=|]){{0,24}}?(?<![\w.]){QUARTER}",
    re.IGNORECASE,
)
# an angle brought back between -pi and pi
WRAPPED = re.compile(
    r"^[^\n]*[-+]=?\s*2(?:\.0)?\s*\*\s*[\w.]*pi\b[^\n]*$|[-+]\s*(?:2\s*\*?\s*pi\b(?!\s*/)|360\b)"
    r"|\b(?:if|while|else)\b[^\n]*\n?[ \t]*(\w+)\s*(?:=\s*\1\s*)?[-+]=?\s*[\w.]*pi\s*;?\s*$",
    re.IGNORECASE | re.MULTILINE,
)
# joint_zero = {2: -90}
ZERO = re.compile(r"\b((?:\w+\.)*\w*(?:off|zero|bias)\w*)\s*[:=](?!=)\s*([^\n]*)", re.IGNORECASE)
# theta + offset, q[i] - zeros[i]
BY_NAME = re.compile(
    r"(?<![\w.])(?:q|theta|th|joint\w*|angles?)\w{0,8}(?:[\[(]\w+[\])])?\s*[-+]"
    r"\s*((?:\w+\.)*\w*(?:off|zero|bias|shift|home)\w*)",
    re.IGNORECASE,
)
# joint 2 has an offset of -90 deg
STATED = re.compile(
    r"\b(?:(?:joint|axis|theta|q)[ _]?\d|(?:first|second|third|fourth|fifth|sixth) (?:joint|axis))"
    r"[^.,;|\n]{0,30}\b(?:offset|zero|shift|rotated)\w*"
    r"[^.,;|\n\d]{0,20}[-+]?(?:90|180|1\.57\d*|pi)\b",
    re.IGNORECASE,
)
MOST = 360  # degrees
OF_AN_END = re.compile(r"grip|tool|tcp|ee|end|flange|base|hand|camera|link", re.IGNORECASE)


def require_zeros(table, source):
    """What is added to joint angles beside the table must be in the table."""
    held = [
        row[k]
        for row in table.rows
        for k, role in enumerate(table.roles)
        if role in ("theta", "offset")
    ]
    if any(cell.value for cell in (*held, *table.zeros)):
        return
    found = SHIFTED.search(WRAPPED.sub("", source.text)) or STATED.search(source.text)
    told = found[0].strip() if found else _named_zero(source, table)
    if not told:
        return
    raise ValueError(
        f"recognise_table: the text has {told[:40]}, and no row has such a zero; to which row"
        " does it belong? Write it into the row, as theta - 90"
    )


def _named_zero(source, table):
    """The zeros that the text names and no row has."""
    own = any(role in ("theta", "offset") for role in table.roles)
    for name in BY_NAME.findall(source.code):
        if own and "." in name and name.split(".")[-1] not in arrays_in(source):
            continue  # dh.theta_offset of a row is its column theta
        if own and re.search(rf"\bfor\b[^\n:]*\b{re.escape(name)}\b[^\n:]*\bin\b", source.code):
            continue  # for theta_offset, d, a, alpha in rows
        if not _is_zero(name, source):
            return f"{name} added to joint angles"
    used = " ".join(cell.text for row in table.rows for cell in row)
    lengths = {
        abs(cell.value)
        for row in table.rows
        for cell, role in zip(row, table.roles)
        if role in ("d", "a", "r") and cell.value % 15 and not snapped(cell.value)[1]
    }
    for name, said in ZERO.findall(source.code):
        placed = any(note.startswith(f"{name} is taken for a place") for note in table.notes)
        if name in used or OF_AN_END.search(name) or placed:
            continue  # a length by its name
        said = re.split(r",\s*\w+\s*=(?!=)", said)[0]  # theta_offset=0, d=0.1
        said = said if re.match(r"[^;]*[\[{(]", said) else said.partition(";")[0]
        value = source.value(said.strip(" ,;"))
        if value is not None and (abs(value.number) in lengths or _is_length(value, table)):
            continue  # wrist_offset: 0.072, which is the d of the wrist
        counts = re.match(r"\s*-?(\d+)", said)
        if counts and int(counts[1]) > MOST:
            continue  # 2048 steps of a servo
        none = re.match(r"\s*(?:\w+\.)?zeros\(", said)
        number = not none and re.search(r"(?<!\w)[\d.]*[1-9]|pi\b", said)
        if number and (role_of(name)[0] == "offset" or re.search(r"zero|bias", name.lower())):
            return f"{name} = {said}"
    return ""


def _is_length(value, table):
    """Whether a number, no round angle, is a length of the rows in another unit: 0.0659 of 65.9."""
    if not value.number or not value.number % 15 or snapped(value.number)[1]:
        return False
    held = [
        abs(cell.value / value.number)
        for row in table.rows
        for cell, role in zip(row, table.roles)
        if role in ("d", "a", "r") and cell.is_constant
    ]
    return any(abs(ratio * 10.0**-k - 1) < 1e-9 for ratio in held for k in (-3, -2, -1, 1, 2, 3))


def _is_zero(name, source):
    """Whether a name stands for zeros, or for a length."""
    values = arrays_in(source).get(name.split(".")[-1])
    if values is not None:
        return not any(value.number for value, _ in values)
    value = source.value(name)
    return role_of(name)[0] in ("d", "a") or (
        value is not None and not value.letters and not value.number
    )
