"""A line of MATLAB as tokens, and these as an expression of Python's grammar."""

import re

from ..brackets import CLOSED

__all__ = ["NoMatlab", "expression", "target", "tokens_of"]

TOKEN = re.compile(
    r"(?P<space>[ \t]+)|(?P<number>\d+\.?\d*(?:[eE][-+]?\d+)?|\.\d+(?:[eE][-+]?\d+)?)"
    r"|(?P<name>[A-Za-z_]\w*(?:\.[A-Za-z_]\w*)*)|(?P<field>\.[A-Za-z_]\w*)"
    r"|(?P<op>\.\*|\./|\.\^|\.'|&&|\|\||[~!=<>]=|\n|[-+*/^=<>(){},;:~!@&|\\]|\[|\])"
)
STRING = re.compile(r"\"(?:[^\"\n]|\"\")*\"|'(?:[^'\n]|'')*'")
SAID = {
    ".*": "%", "./": "//", ".^": "**", "^": "**", "&&": " and ", "||": " or ", "~=": "!=",
    "!=": "!=", "&": " and ", "|": " or ", "~": " not ", "!": " not ",
}  # fmt: skip
OWNERS = ("obj", "self", "this", "app", "robot_obj")
KEPT = ("lambda", "def", "class", "in", "is", "not", "and", "or", "None", "from", "import", "pass",
        "del", "raise", "with", "as", "assert", "yield", "async", "await", "except", "finally",
        "elif", "True", "False", "nonlocal")  # fmt: skip


class NoMatlab(Exception):
    """A line that is no MATLAB of the kind that is known."""


def tokens_of(text):
    """The (kind, text) of the tokens of a text.

    Examples
    --------
    >>> tokens_of("T = A' * 2;")[2:5]
    [('op', '='), ('space', ' '), ('name', 'A')]
    """
    found: list = []
    at = 0
    while at < len(text):
        last = found[-1] if found else ("", "")
        operand = last[0] in ("name", "number", "turned") or last[1] in (")", "]", "}")
        if text[at] == "'" and operand:
            found.append(("turned", ".T"))
            at += 1
            continue
        if text[at] in "'\"":
            match = STRING.match(text, at)
            if not match:
                raise NoMatlab
            found.append(("string", repr(match[0][1:-1])))
            at = match.end()
            continue
        match = TOKEN.match(text, at)
        if not match:
            raise NoMatlab
        kind = "turned" if match[0] == ".'" else match.lastgroup
        found.append((kind, ".T" if kind == "turned" else match[0]))
        at = match.end()
    return found


def expression(tokens):
    """Tokens as an expression of Python's grammar.

    Examples
    --------
    >>> expression(tokens_of("A(1, :) .* [1 -2; a+b 3]' + q(end)"))
    'A(1,_all)%_matrix([[1,-2],[a+b,3]]).T+q(0)'
    """
    parts, at = _segments(tokens, 0, "", False)
    if at != len(tokens) and parts is None:
        raise NoMatlab
    return parts[0][0] if parts and parts[0] else ""


def _tight(tokens):
    """Tokens without spaces, but for those in square brackets, where they part items."""
    depth = 0
    for kind, text in tokens:
        depth += (text == "[") - (text == "]")
        if kind != "space" or depth:
            yield kind, text


def target(tokens):
    """What stands on the left of an assignment, as Python's grammar has it.

    Examples
    --------
    >>> target(tokens_of("A (2, [1 4])"))
    'A[2,_matrix([[1,4]])]'
    """
    tokens = list(_tight(tokens))
    if not tokens or tokens[0][0] != "name":
        raise NoMatlab
    name = _name(tokens[0][1])
    if len(tokens) == 1:
        return name
    if tokens[1][1] not in ("(", "{"):
        raise NoMatlab
    rows, at = _segments(tokens, 2, CLOSED[tokens[1][1]], True)
    field = "".join(text for kind, text in tokens[at:] if kind == "field")
    if at != len(tokens) - bool(field):
        raise NoMatlab
    return f"{name}[{','.join(rows[0])}]{field}"


def _name(text):
    head, *rest = text.split(".")
    head = "SELF" if head in OWNERS and rest else head
    name = "__".join([head, *rest])
    return f"{name}_" if name in KEPT else name


def _segments(tokens, at, closer, is_index):
    """(Rows of items as texts, the place behind the closing bracket)."""
    in_list = closer in ("]", "}") and not is_index
    rows: list = [[]]
    spans: list = [""]
    last = ""  # kind of the token before, "operand" where a value has ended

    def finish():
        nonlocal spans, last
        parts = [part.strip() for part in spans]
        if parts == ["", ""]:
            rows[-1].append("_all")
        elif len(parts) > 1:
            rows[-1].append(f"_span({','.join(parts)})")
        elif parts[0]:
            rows[-1].append(parts[0])
        spans, last = [""], ""

    while at < len(tokens):
        kind, text = tokens[at]
        if kind == "op" and text == closer:
            finish()
            return rows, at + 1
        if kind == "space":
            if in_list and last == "operand" and _begins(tokens, at + 1):
                finish()
            at += 1
            continue
        at += 1
        if kind == "op" and text == "," and closer:
            finish()
        elif kind == "op" and text in (";", "\n") and in_list:
            finish()
            rows.append([])
        elif kind == "op" and text == ":":
            spans.append("")
            last = ""
        elif kind == "op" and text in CLOSED:
            inside, at = _bracket(tokens, at, text, last)
            spans[-1] += inside
            last = "operand"
        elif kind == "op" and text == "@":
            if at < len(tokens) and tokens[at][1] == "(":
                names, at = _segments(tokens, at + 1, ")", False)
                rest, at = _segments(tokens, at, closer, is_index)
                body = rest[0][0] if rest and rest[0] else "None"
                spans[-1] += f"(lambda {','.join(names[0])}: {body})"
                finish()
                return [*rows[:-1], rows[-1] + rest[0][1:], *rest[1:]], at
        elif kind == "name":
            spans[-1] += "0" if text == "end" and is_index else _name(text)
            last = "operand"
        else:
            spans[-1] += SAID.get(text, text)
            last = "operand" if kind in ("number", "string", "turned", "field") else ""
    if closer:
        raise NoMatlab
    finish()
    return rows, at


def _bracket(tokens, at, mark, before):
    """(What an opened bracket holds, as a text; the place behind it)."""
    index = before == "operand"
    rows, at = _segments(tokens, at, CLOSED[mark], index)
    if index:
        return f"({','.join(rows[0])})", at
    if mark == "(":
        if len(rows[0]) != 1:
            raise NoMatlab
        return f"({rows[0][0]})", at
    rows = [row for row in rows if row]
    listed = ",".join(f"[{','.join(row)}]" for row in rows)
    return (f"_matrix([{listed}])" if mark == "[" else f"_cells([{listed}])"), at


def _begins(tokens, at):
    """Whether an item of a list begins here."""
    if at >= len(tokens):
        return False
    kind, text = tokens[at]
    if kind in ("name", "number", "string") or text in ("(", "[", "{", "@"):
        return True
    following = tokens[at + 1] if at + 1 < len(tokens) else ("space", "")
    return text in ("+", "-", "~") and following[0] != "space"
