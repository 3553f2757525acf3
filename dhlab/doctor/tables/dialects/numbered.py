"""One name for each number: ``a1 = 0.05; alpha1 = -pi/2``, SymPy's ``{alpha0: 0, a0: 0, d1: …}``,
``dh(1).theta = 0``.
"""

import re

from ..cells import cell_of
from ..language.assigned import DEFINED
from ..language.roles import role_of
from ..pasted import Row, from_rows

__all__ = ["read"]

# what is assigned, with whatever leads to it: a1, dh[0].theta, link2->d, arm.dh.1.alpha, p['a1']
PATH = re.compile(
    r"(?<![\w.])([A-Za-z_]\w*(?:(?:\.|->)\w+|\[\s*['\"]?\w+['\"]?\s*\]|\{\d+\}|\(\s*['\"]?\w+['\"]?\s*\)(?=\.))*)"
    r"['\"]?\s*(?:=(?!=)|:(?![:=]))\s*([^=:;,\n{}]+)"
)
# a(2) = 0.3, a[2] = 0.3, and of a column or a row of numbers a(2,1) = 0.3, a[0][2] = 0.3
CELL = re.compile(
    r"\b([A-Za-z_]+)\s*[\[(](?:[01]\s*(?:,|\]\s*\[)\s*(?=\d+\s*[\])]))?(\d+)(?:\s*(?:,|\]\s*\[)\s*[01])?"
    r"\s*[\])]\s*=\s*([^;\n=]+)"
)
WIDE = re.compile(r"\b([A-Za-z_]+)\s*[\[(]\s*\d\s*(?:,|\]\s*\[)\s*[23]\s*[\])]\s*=(?!=)")
# MATLAB's a(1:6) = 0
SLICE = re.compile(r"(?<![\w.])([A-Za-z_][\w.]*)\((\d):(\d)\)\s*=(?!=)\s*([^;,\n=\[]+)")
NAMES = ("theta", "d", "a", "alpha", "r", "offset")


def read(source, nominal=None):
    """The Pasted table of numbered names; None when d, a and alpha are not all there."""
    found, unread, unknown, stopped = _collected(source)
    if "a" not in found and "r" in found:
        found["a"] = found.pop("r")
    other, twists = (
        _twists(unknown) if "alpha" not in found and {"a", "d"} <= set(found) else ("", {})
    )
    if twists:
        found["alpha"] = twists
    if not {"d", "alpha"} <= set(found) or len(found["alpha"]) < 2:
        return None
    _count_alike(found)
    shift, convention = _shift(found)
    first = min(found["d"])
    last = max(max(found["d"]), *(k + shift for k in found["alpha"]))
    rows = []
    for k in range(first, last + 1):
        cells = {
            role: cell_of(*values[at])
            for role, values in found.items()
            if (at := k - shift if role in ("a", "alpha") else k) in values
        }
        if "alpha" not in cells and "d" not in cells and "a" not in cells:
            continue
        rows.append((cells, _kind(cells, found, k)))
    if stopped == {(last, 0.0)}:  # theta7 = q7, and q7: 0 of no other joint
        rows[-1] = (rows[-1][0], "fixed")
    _require_read(unread, found)
    gaps = {
        role: [k for k, (cells, _) in enumerate(rows, first) if role not in cells]
        for role in ("d", "alpha", "a")
    }
    gaps["d"] = [k for k in gaps["d"] if not _is_behind(k, found)]
    notes = tuple(
        f"{role} is not given for row {', '.join(map(str, missing))} and is taken for 0"
        for role, missing in gaps.items()
        if missing
    )
    notes += (f"{other} is taken for alpha: it holds the angles",) if twists else ()
    return from_rows(
        [Row(cells, kind) for cells, kind in rows],
        why="as their names say",
        convention=convention,
        because="since a and alpha are counted from 0, d from 1" if convention else "",
        notes=notes,
    )


def _collected(source):
    """{role: {index: (Value, text)}} of what the text names; what of it cannot be read; names that
    are no parameters; and (index, number) of variables that are given a number.
    """
    found: dict = {}
    unread: dict = {}
    unknown: dict = {}
    stopped: set = set()
    named = [*_named(source.code)]
    names = {name for name, *_ in named}
    for name, index, text in named:
        role = source.role(name)
        if name.isupper() and name.lower() in names:
            role = None  # A1 beside a1 is another parameter
        value = source.value(text.strip()) or source.value(text.strip().rstrip(".)"))
        if text.strip().startswith("[") or re.match(r"\s*(?:\w+\.)?symbols\b", text):
            continue  # A12 = [ … is a matrix
        if role in NAMES and value is None:
            unread.setdefault((role, int(index)), text.strip())
        elif role is None and value is not None:
            unknown.setdefault(name, {}).setdefault(int(index), (value, text.strip()))
        elif role in NAMES:
            held = found.setdefault(role, {}).setdefault(int(index), (value, text.strip()))
            _require_one(role, int(index), held, (value, text.strip()))
            if role == "theta" and held[0].letters and not value.letters:
                stopped.add((int(index), value.number))
    return found, unread, unknown, stopped


def _require_one(role, index, first, again):
    """A number is given once, or twice the same."""
    (one, text), (other, later) = first, again
    constant = not (one.letters or other.letters) and role not in ("theta", "offset")
    if constant and abs(one.number - other.number) > 1e-9:
        raise ValueError(
            f"recognise_table: expected one {role}{index}, found {text[:20]} and {later[:20]}; are"
            " these two arms, or which one counts? Leave the other out"
        )


def _twists(unknown):
    """(name, its numbers) where one of the names that say nothing holds multiples of pi."""
    angles = {
        name: numbers
        for name, numbers in unknown.items()
        if len(numbers) > 2 and any(value.unit in ("rad", "deg") for value, _ in numbers.values())
        if not any(value.letters for value, _ in numbers.values())
    }
    return next(iter(angles.items())) if len(angles) == 1 else ("", {})


def _count_alike(found):
    """theta1 beside d0, as many of each: both are those of the first link."""
    theta, d = found.get("theta"), found["d"]
    if theta and min(theta) == min(d) + 1 and max(theta) == max(d) + 1:
        found["theta"] = {k - 1: value for k, value in theta.items()}


def _require_read(unread, found):
    """A number that is given and cannot be read must not be taken for 0."""
    for (role, k), text in unread.items():
        if k not in found.get(role, {}):
            raise ValueError(
                f"recognise_table: {role}{k}: expected a number, found {text[:40]!r}; write the"
                " number, or what its letters are"
            )


def _named(code):
    """(name, index, text) of every assignment with one number in its name, wherever it stands."""
    matrices = set(WIDE.findall(code))
    for match in CELL.finditer(code):
        if match[1] in matrices:
            continue  # T(0, 1) = -st * ca beside T(0, 3)
        yield match[1], match[2], match[3]
    for name, first, last, text in SLICE.findall(code):
        for index in range(int(first), int(last) + 1):
            yield _name(name), str(index), text
    defined = ((name, text.split("//")[0]) for name, text in DEFINED.findall(code))
    for path, text in (*PATH.findall(code), *defined):
        numbers = re.findall(r"\d+", path)
        if len(numbers) == 1 and not re.fullmatch(r"\w+[\[(]\d+[\])]", path):
            yield _name(path), numbers[0], text.strip()


def _name(path):
    """The words of a path without its number: ``kAlpha1`` is k_Alpha, ``arm.dh.1.a`` a."""
    words = re.findall(r"[A-Za-z]+", re.sub(r"(?<=[a-z])(?=[A-Z])", " ", path))
    whole = "_".join(words)
    return next((one for one in (whole, *words[-1:]) if role_of(one)[0] in NAMES), whole)


def _shift(found):
    """1 where alpha0 and a0 stand beside d1: then the rows are Craig's."""
    if min(found["alpha"]) == 0 and min(found["d"]) == 1 and 0 in found.get("a", {0: 0}):
        return 1, "craig"
    return 0, None


def _is_behind(k, found):
    """Whether a row has neither d nor theta while every row before it has a d: the flange."""
    angles = {at for role in ("theta", "offset") for at in found.get(role, ())}
    rows = range(min(found["d"]), max(found["d"]) + 1)
    return k > max({*angles, *found["d"]}) and len(rows) > 1 and set(rows) <= set(found["d"])


def _kind(cells, found, k):
    """A row whose theta is a number while other rows have variables has no joint, nor has one
    behind the joints.
    """
    theta = cells.get("theta")
    angles = found.get("theta", {})
    if _is_behind(k, found) or (set(angles) == {k} == {max(found["d"])} and _is_zero(theta)):
        return "fixed"  # q7 is put to 0, and no other joint to anything
    variables = any(value.letters for value, _ in found.get("theta", {}).values())
    if theta is not None and theta.is_constant and variables:
        return "fixed" if not any(value.letters for value, _ in [*found["d"].values()]) else ""
    return "R" if theta is None and variables else ""


def _is_zero(cell):
    return cell.is_constant and not cell.value
