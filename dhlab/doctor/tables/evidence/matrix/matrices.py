"""The link matrix that a text computes itself: for which convention it is, and which of its names
is which parameter, whatever they are called.
"""

import math
import re
from dataclasses import dataclass, replace
from itertools import permutations, product

import numpy as np

from .....kinematics import link_matrices
from ...language.expressions import NoExpression, evaluate
from ...language.roles import ROLES, role_of
from .entries import matrices

__all__ = ["INDEX", "LinkMatrix", "link_matrix_in", "said_plainly"]

ANGLES = {"theta": 0.3, "d": 0.5, "a": 0.7, "alpha": 1.1}
SHORT = re.compile(r"(c|s)(?:os|in)?_?([tqa])(?:h|heta|l|lpha|lfa)?_?\d?", re.IGNORECASE)
LOCAL = re.compile(
    r"\b(\w+)\s*=\s*((?:\w+(?:\.|::))?(?:cos|sin)f?d?\s*\((?:[^()\n]|\([^()\n]*\))*\))",
    re.IGNORECASE,
)
LIKE = re.compile(r"\b(?:\w+\.)*(zero|one)s(?:_like)?\([^()]*\)")
PRODUCT = re.compile(  # cos_theta_a = cos_theta * a
    r"\b(\w+)\s*=\s*(-?\s*[A-Za-z_]\w*(?:\s*\*\s*[A-Za-z_]\w*)+)[ \t]*(?=[;\n]|$)"
)
# one number of a row: dh[i][2], dh(i, 3), params[:, 0], dh[4*i + 1], p[2]
COLUMN = re.compile(
    r"\b([A-Za-z_]\w*)\s*(?:\[[^\[\]]*\]\s*\[\s*(\d)\s*\]|\[[^\[\],]*,\s*(\d)\s*\]"
    r"|\(\s*[\w:+\- ]+,\s*(\d)\s*\)|\[\s*(?:\w+\s*\*\s*[45]|[45]\s*\*\s*\w+)\s*\+\s*(\d)\s*\])"
)
ONE = re.compile(r"\b([A-Za-z_]\w*)\s*[\[(]\s*(\d)\s*[\])]")
INDEX = re.compile(
    r"(?<=\w)\s*(?:\[[^\[\]]*\]|\((?:\d+|[ijkn])(?:\s*[-+]\s*1)?(?:\s*,\s*[\d:]+)?\)|_\{?[ijkn]\}?(?:-1)?(?!\w))"
)
# row.alpha, libm::cos
FIELD_OF = re.compile(r"\b[A-Za-z_]\w*\.(?=[A-Za-z_]\w*\b(?![\w.]|\s*\())|\b[a-z]\w*::(?=\w)")
KEY_OF = re.compile(r"\b([A-Za-z_]\w*)\[['\"]([A-Za-z]\w*)['\"]\]")  # row['alpha']
# (q[i] if row.kind == 'revolute' else 0)
IF_SUCH = re.compile(r"\(\s*(\w+(?:\[\w+\])?) if [^()\n]{1,60} else 0(?:\.0)?\s*\)")
MOST_UNKNOWN, MOST_TRIED = 4, 8
NO_NAMES = ("pi", "np", "math", "cos", "sin")


@dataclass(frozen=True)
class LinkMatrix:
    """The convention of a link matrix ("" where a text has one of each), the parameter that each of
    its names means, and the order of the columns that it takes its numbers from, () where it takes
    names; ``listed`` are the names of which it takes one number for each link, as ``a[i]``;
    ``turn`` the angle in radians that it adds to theta.
    """

    convention: str
    roles: dict
    order: tuple = ()
    listed: tuple = ()
    turn: float = 0.0


def link_matrix_in(code, turns=(0.0,)):
    """The LinkMatrix that the text computes; None where it computes none, or one that adds another
    angle to theta than the ``turns`` in radians.

    Examples
    --------
    >>> text = '''T = [[cos(t), -sin(t)*cos(b), sin(t)*sin(b), l*cos(t)],
    ...      [sin(t), cos(t)*cos(b), -cos(t)*sin(b), l*sin(t)],
    ...      [0, sin(b), cos(b), d], [0, 0, 0, 1]]'''
    >>> found = link_matrix_in(text)
    >>> found.convention, found.roles["b"], found.roles["l"]
    ('standard', 'alpha', 'a')
    """
    code = IF_SUCH.sub(r"\1", KEY_OF.sub(r"\1.\2", code))
    local, solved, tried = _locals(code), None, 0
    for entries in matrices(code):
        if tried == MOST_TRIED:
            break
        if not re.search(
            r"\b(?:\w+\.)?((?i:cos|sin)\w*|[cs]_?[taq]\w{0,9}|[cs])\b", " ".join(entries)
        ):
            continue
        tried += 1
        entries = [_plain(entry, local) for entry in entries]
        found = _solved(_by_column(entries), turns)
        if found:
            listed = re.findall(rf"\b(\w+)(?={INDEX.pattern})", " ".join(entries))
            found = replace(found, listed=tuple(set(listed) & set(found.roles)))
            if solved is not None and solved.convention != found.convention:
                return replace(solved, convention="")
            solved = solved or found
    return solved


def _locals(code):
    """What stands for the cosines and sines, and for products of them: ``ct = cos(theta)``."""
    local = dict(LOCAL.findall(code))
    for name, said in PRODUCT.findall(code):
        if set(re.findall(r"\w+", said)) & set(local):
            local.setdefault(name, f"({said})")
    return local


def said_plainly(entries, code):
    """The entries with what the code lets stand for their cosines and sines."""
    local = _locals(code)
    return [_plain(entry, local) for entry in entries]


def _plain(entry, local):
    for _ in range(2):
        entry = re.sub(r"\b[A-Za-z_]\w*\b", lambda m: f"{local.get(m[0], m[0])}", entry)
    entry = LIKE.sub(lambda m: {"zero": "0", "one": "1"}[m[1]], entry)
    return re.sub(r"\b(?:self|this)\.", "", entry)


def _by_column(entries):
    """The entries with ``row[2]`` as a name, ``row_at2``, where a row has three such, and without
    the numbers of links.
    """
    text = COLUMN.sub(
        lambda m: f"{m[1]}_at{next(filter(None, m.groups()[1:]))}", "\n".join(entries)
    )
    held: dict = {}
    for name, index in ONE.findall(text):
        held.setdefault(name, set()).add(index)
    text = ONE.sub(lambda m: f"{m[1]}_at{m[2]}" if len(held[m[1]]) > 2 else m[0], text)
    return FIELD_OF.sub("", INDEX.sub("", text)).split("\n")


def _order(roles):
    """The roles by column, () where the names are no columns."""
    at = {int(name[-1]): role for name, role in roles.items() if re.search(r"_at\d$", name)}
    return tuple(at[k] for k in sorted(at)) if len(at) > 2 else ()


def _solved(entries, turns):
    """The LinkMatrix of entries: names as they are usually meant, else as they make it one."""
    text = " ".join(entries)
    names = list(dict.fromkeys(re.findall(r"(?<![\w.])([A-Za-z_]\w*)(?![\w.]|\s*\()", text)))
    short = {name: _shortened(name) for name in names if SHORT.fullmatch(name)}
    names = [name for name in names if name not in short and name not in NO_NAMES]
    usual = {name: role_of(name)[0] for name in names}
    usual = {name: "a" if role == "r" else role for name, role in usual.items()}
    turned = [name for name in names if usual[name] == "theta"]
    if "theta" in turned and len(turned) == 2:  # cos(theta + q[i]): the row's theta is a zero
        usual |= {name: "offset" for name in turned if name != "theta"}
    for roles in _assignments(names, usual, bool(short)):
        known = {**short, **{name: ANGLES.get(role, 0.0) for name, role in roles.items()}}
        convention, turn = _convention(entries, known, turns)
        if convention:
            held = {name: role for name, role in roles.items() if role in ROLES}
            return LinkMatrix(convention, held, _order(held), turn=turn)
    return None


def _assignments(names, usual, shortened):
    if all(role in (*ROLES, "offset") for role in usual.values()):
        yield usual
    free = [name for name in names if usual[name] != "offset"]
    if not 1 <= len(free) <= MOST_UNKNOWN:
        return
    known = {name: role for name, role in usual.items() if role in ROLES}
    unknown = [name for name in free if name not in known]
    if unknown and len(set(known.values())) == len(known):
        left = [role for role in ROLES if role not in known.values()]
        for roles in permutations(left, len(unknown)) if len(unknown) <= len(left) else ():
            yield {**usual, **known, **dict(zip(unknown, roles))}
    if len(free) >= (2 if shortened else 3):
        for roles in permutations(ROLES, len(free)):
            yield {**usual, **dict(zip(free, roles))}


def _convention(entries, known, turns):
    """(convention, turn) of a link matrix; ("", 0) of another."""
    known = {re.sub(r"_", "", name): value for name, value in known.items()}
    try:
        values = [evaluate(_called(entry), dict(known)) for entry in entries]
    except NoExpression:
        return "", 0.0
    if any(value.letters for value in values):
        return "", 0.0
    M = np.array([value.number for value in values]).reshape(-1, 4)[:3]
    for convention, turn in product(("standard", "craig"), turns):
        row = [ANGLES[role] + (turn if role == "theta" else 0.0) for role in ROLES]
        if np.allclose(M, link_matrices(convention, *row)[: len(M)], atol=1e-6):
            return convention, turn
    return "", 0.0


def _called(entry):
    """``sind``, ``cosf`` and ``cos theta`` as the functions that the grammar knows."""
    entry = re.sub(r"\b((?:\w+(?:\.|::))?(?:cos|sin))[fd]\s*\(", r"\1(", entry)
    return re.sub(r"\b(cos|sin)\s+(\w+)", r"\1(\2)", entry)


def _shortened(name):
    function, angle = SHORT.fullmatch(name).groups()
    of = math.cos if function.lower() == "c" else math.sin
    return of(ANGLES["theta" if angle.lower() in "tq" else "alpha"])
