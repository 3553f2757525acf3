"""The link functions that a text defines, one by one: of two, one may have a turn of its own built
in, and the joints that it is called for have that turn for their zero.
"""

import math
import re

from .branches import row_of
from .conventions import has_formula
from .entries import matrices
from .matrices import link_matrix_in, said_plainly

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
MULTIPLIED = re.compile(  # sin(t)*cos(b)
    r"(?:cos|sin)[fd]?\s*\(([^()]*)\)\s*\*\s*(?:\w+(?:\.|::))?(?:cos|sin)[fd]?\s*\(([^()]*)\)",
    re.IGNORECASE,
)
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
    found = {}
    for k, (head, name) in enumerate(heads):
        end = heads[k + 1][0].start() if k + 1 < len(heads) else len(code)
        body = code[head.start() : end]
        if not re.search(r"(?i)cos", body):
            continue
        if any(_is_of_a_link(" ".join(entries)) for entries in _in_full(body)):
            found[name] = link_matrix_in(body) or link_matrix_in(body, QUARTERS)
    return found


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
