"""One call for each row: ``T01 = dh(q1, 0.3, 0, pi/2)``, in the order of its definition."""

import re
from collections import Counter

from ...cells import cell_of
from ...evidence.link_functions import link_functions
from ...evidence.orders import every_column_in
from ...evidence.poses import multiplied_out, with_given_angles
from ...evidence.several import apart, in_parts
from ...language.brackets import groups, keyword
from ...language.roles import ROLES, role_of
from ...language.words import KINDS
from ...meaning.beside import labelled
from ...pasted import Pasted
from .factors import with_factors

__all__ = ["definitions", "own_calls", "places_in", "read"]

PLACE = re.compile(r"\w+[\[(]\s*(\d)\s*(?:,|\]\s*\[)\s*(\w+)\s*[\])]")  # dh[0, i]
FACTORED = re.compile(r"\bdhfactor\b", re.IGNORECASE)  # the Robotics Toolbox prints such calls
HEAD = re.compile(r"\s*(?:def|function|fn|func)\b")  # of a function: no call
CLASS = re.compile(r"\s*class\s+(\w+)")
NAMES = ("frame", "joint")  # of calls that are no links, unless the text names their columns
FLAGS = ("true", "false", "null", "nullptr", "none")
JOINTS = ("theta", "q")  # what letters of a joint's variable look like
MOST_ITEMS = 10  # the four with limits, a name and flags
NOT_A_LINK = re.compile(
    r"(?:range|vector\d?|rpy|euler\w*|quaternion|linspace|np|array|color|plot\w*|print\w*|rotation|frame"
    r"|twist|pose|transl?|vec3|tuple|list|origin\w*|size|inertia|cuboid|box|mass|rgba|trplot|axis"
    r"|joint|segment|max|min|sum|diag|zip|atan2|random\w*|uniform|opw\w*)$",
    re.IGNORECASE,
)


def read(source, nominal=None):
    """The Pasted table of calls with four numbers each; None when there are none."""
    calls = [
        group
        for group in groups(source.code)
        if group.mark == "(" and group.name and not HEAD.match(source.lines[group.line - 1])
    ]
    orders = definitions(source)
    found: dict = {}
    kinds: dict = {}
    for call in calls:
        cells = _cells(call, source, orders.get(_last(call.name)))
        name = _last(call.name)
        known = name in orders or (name.lower() in NAMES and source.order)
        if cells and (known or not NOT_A_LINK.match(name)):
            found.setdefault((_last(call.name), len(cells)), []).append((call.line, cells))
            kinds[call.line, cells] = _kind(call)
    found, callers = _together(found, orders, source)
    found = {name: rows for name, rows in found.items() if len(rows) >= 2}
    found = found or _of_all_links(calls, source)
    if not found:
        return None
    (name, width), _ = Counter({one: len(rows) for one, rows in found.items()}).most_common(1)[0]
    _require_all(name, width, calls, found[name, width], source)
    parts = apart([(line, (line, cells)) for line, cells in found[name, width]], source.code)
    made = in_parts(parts, _numbers, f"calls of {name}") or _once(found[name, width])
    lines, rows = zip(*made)
    kinds = _kinds([kinds.get(one, "") for one in made], source)
    roles, why = orders.get(name), f"as the definition of {name} says"
    if roles is None:
        said = source.order
        roles, why = (said[0], said[2]) if said else (None, "")
    factored = roles is None and bool(FACTORED.search(source.text))
    if factored:
        roles, why = ROLES, "as DHFactor has them"
    notes: tuple = ()
    if roles is not None and len(roles) < width:
        roles, notes = _with_behind(roles, rows, source)
    if roles is not None and (len(roles) != width or width != 4):
        keep = [k for k, role in enumerate(roles[:width]) if role in (*ROLES, "r", "offset")]
        rows, roles = [tuple(row[k] for k in keep) for row in rows], tuple(roles[k] for k in keep)
        width = len(roles)
    if width != 4:
        return None
    n = len(rows)
    table = Pasted(
        tuple(tuple(row) for row in rows), roles, why,
        labels=("",) * n, kinds=kinds, signs=(1,) * n, form=f"calls of {name}",
        lines=(min(lines), max(lines)),
        convention="standard" if factored else None,
        because="as DHFactor has it" if factored else "", notes=notes,
        callers=tuple(callers[one] for one in made) if callers else (),
        posed=multiplied_out(source.code) and all(c.is_constant for row in rows for c in row),
    )  # fmt: skip
    table = labelled(table, [(f"line {line}", ()) for line in lines], source)
    return with_factors(with_given_angles(table, source), name, source)


def _together(found, orders, source):
    """(what :func:`read` collects with the calls of all link functions of the text under the name
    that is called most, {call: its function}); nothing in the second where one function makes all.
    """
    of_links = link_functions(source.code) if len(found) > 1 else {}
    several = [
        one for one in found if one[0] in of_links and len(orders.get(one[0], ())) == one[1] == 4
    ]
    if len(several) < 2:
        return found, {}
    main = max(several, key=lambda one: len(found[one]))
    rows, callers = [], {}
    for name, width in several:
        at = [orders[name].index(role) for role in orders[main[0]] if role in orders[name]]
        if len(at) < width:
            return found, {}
        for line, cells in found[name, width]:
            row = line, tuple(cells[k] for k in at)
            rows.append(row)
            callers[row] = name
    rest = {one: calls for one, calls in found.items() if one not in several}
    return {**rest, main: sorted(rows, key=lambda row: row[0])}, callers


def _with_behind(roles, rows, source):
    """(roles, notes) where numbers stand behind those that are named: limits, or a question.

    Raises
    ------
    ValueError
        Nothing says what they are.
    """
    n, width = len(roles), len(rows[0])
    if named := every_column_in(source, width):
        return named, ()
    said = [
        k for k in range(n, width) if any(_last(row[k].text).lower() not in KINDS for row in rows)
    ]
    said = [k for k in said if any(row[k].value or row[k].letters for row in rows)]
    if not said:
        return roles, ()
    low, high = (([row[k].value for row in rows]) for k in (said[0], said[-1]))
    if len(said) == 2 and all(a < b for a, b in zip(low, high)):
        return roles, (f"the two numbers behind {roles[-1]} are taken for limits of the joints",)
    raise ValueError(
        f"recognise_table: expected {n} numbers in a row, found {width}; what are those behind"
        f" {roles[-1]}? Name all columns in a comment above the rows"
    )


def _kind(call):
    """What a call says of its joint: a kind, or "true" or "false"; "" when nothing."""
    for text in (item.text for item in call.items[4:]):
        word = re.split(r"\.|::", text.strip("'\" "))[-1].lower()
        if word in ("true", "false"):
            return word
        if KINDS.get(word) and (len(word) > 1 or text[:1] in "'\""):
            return KINDS[word]
    return ""


def _kinds(said, source):
    """The kinds of the rows, where calls may say it with True and False.

    Raises
    ------
    ValueError
        Some say True and others do not, and the text does not say of what.
    """
    if len(set(said)) < 2 or "true" not in said:
        return tuple("" if one in ("true", "false") else one for one in said)
    slides, turns = (bool(re.search(word, source.text, re.I)) for word in ("prismatic", "revolut"))
    if slides == turns:
        raise ValueError(
            f"recognise_table: row {said.index('true') + 1} has True behind its numbers, and other"
            " rows have not; is it a joint that slides? Write R or P into the rows"
        )
    return tuple("P" if (one == "true") == slides else "R" for one in said)


def _of_all_links(calls, source):
    """What :func:`read` collects, of one call that takes the numbers of all links, four of each:
    ``fk(0, pi/2, 0.1, q1, 0.3, 0, 0, q2)``.
    """
    for call in calls:
        values = [source.value(item.text) for item in call.items]
        if len(values) < 8 or len(values) % 4 or None in values:
            continue
        cells = [cell_of(value, item.text) for value, item in zip(values, call.items)]
        rows = [tuple(cells[at : at + 4]) for at in range(0, len(cells), 4)]
        moving = [{k for k, cell in enumerate(row) if cell.variable in JOINTS} for row in rows]
        if len(moving[0]) == 1 and all(one == moving[0] for one in moving):
            return {(_last(call.name), 4): [(call.line, row) for row in rows]}
    return {}


def _require_all(name, width, calls, rows, source):
    """No call of the function is left out because a number in it cannot be read.

    Raises
    ------
    ValueError
        One is, with its line; another has letters for all its numbers: the definition, or a loop.
    """
    lines = {line for line, _ in rows}
    for call in calls:
        texts = [item.text for item in call.items if item.text.lower() not in FLAGS]
        texts = [text for text in texts if text[:1] not in "'\"" or not text]
        if _last(call.name) != name or abs(len(texts) - width) > 1 or call.line in lines:
            continue
        read = [text for text in texts if source.value(text) is not None]
        if sum(bool(re.search(r"\d", text)) for text in read) > 1:
            raise ValueError(
                f"recognise_table: line {call.line}: expected {width} numbers in {name}, found"
                f" {', '.join(texts)[:60]!r}; what is each? Write the numbers, or what its letters"
                " are"
            )


def _numbers(row):
    """What a call says but for its joint's variable."""
    return [cell.value for cell in row[1]]


def _once(rows):
    """The rows without their repetition, where a session prints the same calls again."""
    half = len(rows) // 2
    same = [cells for _, cells in rows[:half]] == [cells for _, cells in rows[half:]]
    moving = any(not cell.is_constant for _, cells in rows for cell in cells)
    return rows[:half] if same and moving and half > 1 else rows


def definitions(source):
    """{name: roles} of the functions and classes that the text defines with four columns."""
    orders: dict = {}
    used = source.link_matrix.roles if source.link_matrix else {}
    for call in groups(source.code):
        roles = tuple(
            used.get(_bare(item.text), role_of(_bare(item.text))[0])
            for item in call.items
            if item.text not in ("self", "this", "obj", "cls")
        )
        if "theta" not in roles:
            roles = tuple("theta" if role == "offset" else role for role in roles)
        named = [role for role in roles if role in (*ROLES, "r")]
        if call.mark == "(" and call.name and len(set(named)) == 4 and "alpha" in named:
            orders.setdefault(_class_of(call, source) or _last(call.name), roles)
    return orders


def own_calls(source):
    """(call, roles) of the calls of the text's own link functions, with an argument for each."""
    orders = definitions(source)
    for call in groups(source.code):
        roles = orders.get(_last(call.name)) if call.mark == "(" else None
        if roles and len(call.items) == len(roles):
            yield call, roles


def places_in(call):
    """The arguments ``dh[0, i]``, ``dh[1, i]``, … of a call that takes a column of a matrix for
    each link, as matches of PLACE; none of others.
    """
    found = [PLACE.fullmatch(item.text.strip()) for item in call.items]
    if all(found) and len({one[2] for one in found}) == 1 < len({one[1] for one in found}):
        return found
    return []


def _class_of(call, source):
    """The class whose ``__init__`` this is; "" of another function."""
    if _last(call.name) != "__init__":
        return ""
    before = source.code.split("\n")[: call.line]
    return next((found[1] for line in before[::-1] if (found := CLASS.match(line))), "")


def _last(name):
    return re.split(r"\.|::|->", name)[-1]


def _bare(text):
    """A parameter without its type and default."""
    return re.split(r"\s+|[*&]", text.split("=")[0].split(":")[0].strip())[-1]


def _cells(call, source, roles):
    """The Cells of a call of four to six numbers; None of another, and of the definition itself."""
    items = call.items
    if not 4 <= len(items) <= MOST_ITEMS:
        return None
    texts = [item.text for item in items if item.text.lower() not in FLAGS]
    if roles is None and sum(text[:1] in "'\"" for text in texts) <= len(texts) - 4:
        texts = [text for text in texts if text[:1] not in "'\""]  # the joint's name
    pairs = [keyword(text) for text in texts]
    if all(pairs) and roles is None:
        return None
    if all(role_of(_bare(text))[0] in (*ROLES, "r") for text in texts[:4]):
        return None
    values = [source.value(text) for text in texts]
    if any(value is None for value in values[:4]):
        return None
    values = values[: next((k for k, value in enumerate(values) if value is None), len(values))]
    if not any(re.search(r"\d", text) for text in texts):
        return None
    return tuple(cell_of(value, text) for value, text in zip(values, texts))
