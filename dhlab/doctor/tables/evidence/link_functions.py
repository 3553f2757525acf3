"""The link functions that a text defines, one by one: of two, one may have a turn of its own built
in, and the joints that it is called for have that turn for their zero.
"""

import math
import re
from dataclasses import replace

from ..language.expressions import evaluate
from ..language.shifted import QUARTER
from .branches import row_of
from .conventions import has_formula
from .matrix.entries import matrices
from .matrix.matrices import link_matrix_in, said_plainly

__all__ = ["calls_of", "link_functions", "rows_of_calls"]

QUARTERS = (math.pi / 2, -math.pi / 2, math.pi)
HEAD = re.compile(
    r"^[ \t]*(?:(?:export|pub|public|private|static|inline|async|local)\s+)*(?:"
    r"(?:def|fn|func|fun|sub)\s+(?:\w+\.)?(\w+)|function\s+(?:[^=\n(]*=\s*)?(?:\w+\.)?(\w+)"
    r"|(?:(?:const|let|var|auto)\s+)?(\w+)\s*=\s*"
    r"(?:@\(|lambda\b|function\b|\[[&=]?\]\s*\(|\([\w, ]*\)\s*=\s*\{)"
    r"|(\w+)\([A-Za-z_][\w, ]*\)\s*=\s*\["
    r"|(?:[\w:<>,.*&\[\]]+[ \t]+)+[*&]?(?:\w+::)*(\w+)\s*\([^;{}()]*\)\s*(?:const\s*)?\{)",
    re.MULTILINE,
)
NO_NAMES = ("if", "for", "while", "switch", "catch", "return")
ONE = r"\bif\s*\(?\s*(\w+)\s*([=!])=\s*(\d+)\b"
BEHIND = re.compile(r"\s*if\s+(\w+)\s*([=!])=\s*(\d+)\s+else\b")
CHOICE = re.compile(r"(\w+)\s*([=!])=\s*(\d+)\s*\)?\s*\?([^?;\n]*)$")
INDEX = re.compile(r"\w([\[(])(\d+)[\])]")
MULTIPLIED = re.compile(  # sin(t)*cos(b)
    r"(?:cos|sin)[fd]?\s*\(([^()]*)\)\s*\*\s*(?:\w+(?:\.|::))?(?:cos|sin)[fd]?\s*\(([^()]*)\)",
    re.IGNORECASE,
)
MOVED = rf"^[ \t]*{{0}}\s*(?:=\s*{{0}}\s*)?([-+])=?\s*({QUARTER})[ \t]*;?[ \t]*$"
SHIFTED = re.compile(rf"[A-Za-z_]\w*\s*([-+])\s*({QUARTER})")
ENDED = re.compile(r"\breturn\b|^\s*end\b|\}")
WRAPPER = 5  # lines of a function that only calls another
FARTHEST = 240  # characters between a condition and the call that it chooses


def link_functions(code):
    """{name: LinkMatrix, or None where it cannot be read} of the text's functions whose matrix
    multiplies cosines and sines of theta and alpha.

    Examples
    --------
    >>> text = '''def up(t, d, a, b): return [[sin(t), cos(t)*cos(b), -cos(t)*sin(b), a*sin(t)],
    ...     [-cos(t), sin(t)*cos(b), -sin(t)*sin(b), -a*cos(t)], [0, sin(b), cos(b), d],
    ...     [0, 0, 0, 1]]'''
    >>> round(link_functions(text)["up"].turn, 4)
    -1.5708
    """
    heads = [(head, next(filter(None, head.groups()), "")) for head in HEAD.finditer(code)]
    heads = [(head, name) for head, name in heads if name and name not in NO_NAMES]
    bodies = {
        name: code[head.start() : heads[k + 1][0].start() if k + 1 < len(heads) else len(code)]
        for k, (head, name) in enumerate(heads)
    }
    found = {}
    for name, body in bodies.items():
        entries = [*_in_full(body)] if re.search(r"(?i)cos", body) else []
        if any(_is_of_a_link(" ".join(one)) for one in entries):
            found[name] = _one_matrix(body)
    for name, body in bodies.items():
        if name not in found and (of := _wrapped(body, found)):
            found[name] = of
    return found


def _one_matrix(body):
    """The LinkMatrix of a function; None of one that cannot be read, and of two that differ."""
    plain, turned = link_matrix_in(body), link_matrix_in(body, QUARTERS)
    one = plain or turned
    if one is None or (plain and turned):
        return None
    angle = next((name for name, role in one.roles.items() if role == "theta"), "")
    moved = re.findall(MOVED.format(re.escape(angle)), body, re.MULTILINE) if angle else []
    turns = [evaluate("".join(parts)).number for parts in moved]
    return replace(one, turn=one.turn + sum(turns))


def _wrapped(body, found):
    """The LinkMatrix of a function that calls one of the link functions once, with a quarter turn
    more: ``return link(theta - pi/2, d, a, alpha)``; None of others.
    """
    lines = body.split("\n")[1:WRAPPER] or [body]
    last = next((k for k, line in enumerate(lines) if ENDED.search(line)), len(lines))
    short = "\n".join(lines[: last + 1])
    calls = [(n, args) for n in found for args in re.findall(rf"\b{n}\s*\(([^()\n]*)\)", short)]
    if len(calls) != 1 or found[calls[0][0]] is None:
        return None
    args = [arg.strip() for arg in calls[0][1].split(",")]
    shifted = [match for arg in args if (match := SHIFTED.fullmatch(arg))]
    if len(shifted) != 1 or sum(bool(re.fullmatch(r"[A-Za-z_]\w*", arg)) for arg in args) < 3:
        return None
    one = found[calls[0][0]]
    return replace(one, turn=one.turn + evaluate(shifted[0][1] + shifted[0][2]).number)


def _is_of_a_link(text):
    """Whether entries multiply a cosine or sine of one angle by one of another, and of no third."""
    angles = {angle.strip() for both in MULTIPLIED.findall(text) for angle in both}
    plain = len(angles) == 2 and not any(re.search(r"\d", angle) for angle in angles)
    return plain or has_formula(text)


def _in_full(body):
    """The entries of each matrix in a function, with what stands for cosines and sines."""
    return (said_plainly(entries, body) for entries in matrices(body))


def calls_of(name, code):
    """Where a function is called, as matches; not where it is defined."""
    heads = [(head.start(), head.end()) for head in HEAD.finditer(code)]
    return [
        call
        for call in re.finditer(rf"(?<![\w]){re.escape(name)}\s*\(", code)
        if not any(start <= call.start() < end for start, end in heads)
    ]


def rows_of_calls(name, n, code):
    """The rows, counted from 0, of n for which a program calls a function, as its conditions say;
    None where they do not.

    Examples
    --------
    >>> text = "for i in range(3):\\n  if i != 1: A = f(q[i])\\n  else: A = g(q[i])"
    >>> rows_of_calls("g", 3, text), rows_of_calls("f", 3, text)
    ([1], [0, 2])
    """
    rows = set()
    for call in calls_of(name, code):
        chosen = _chosen(call, n, code)
        if chosen is None:
            return None
        rows |= chosen
    return sorted(rows)


def _chosen(call, n, code):
    """The rows of one call; None where nothing says it."""
    before = code[max(0, call.start() - FARTHEST) : call.start()]
    conditions = list(re.finditer(ONE, before))
    indices = set(INDEX.findall(code[call.end() : _closed(call.end(), code)]))
    if len(indices) == 1:  # elbow(q[1], d[1], a[1], alpha[1])
        mark, k = indices.pop()
        row = int(k) - (mark == "(")
        return {row} if 0 <= row < n else None
    behind = BEHIND.match(code, _closed(call.end(), code))
    choice = CHOICE.search(before.rsplit("\n", 1)[-1])
    if behind or choice:
        found = behind or choice
        other = bool(choice and ":" in choice[4])
    elif conditions:
        found = conditions[-1]
        between = before[found.end() :]
        other = bool(re.search(r"\belse\b|\botherwise\b", between))
        ended = re.search(r"\bend\b|\bfor\b|\bdef\b|\breturn\b", between)
        if ended or re.search(r"el(?:se ?)?if", before) or re.match(r"\s*(?:and|or|&|\|)", between):
            return None
    else:
        return None
    row = row_of(found[1], found[3], code)
    if row is None or not 0 <= row < n:
        return None
    return {row} if (found[2] == "=") != other else {*range(n)} - {row}


def _closed(at, code):
    """Where the bracket that was opened before a place is closed."""
    depth = 1
    while at < len(code) and depth:
        depth += (code[at] in "([{") - (code[at] in ")]}")
        at += 1
    return at
