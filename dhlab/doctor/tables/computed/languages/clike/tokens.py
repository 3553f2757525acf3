"""Expressions of the languages with braces, in Python's grammar."""

import re

from ..brackets import CLOSED, deeper, split

__all__ = ["NoProgram", "expression", "tokens_of"]

TOKEN = re.compile(
    r"(?P<number>(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)[fFlLuUdD]*(?!\w)"
    r"|(?P<name>[A-Za-z_$]\w*)|(?P<string>\"[^\"\n]*\"|'[^'\n]*'|`[^`]*`)"
    r"|(?P<op>\+\+|--|<<=|>>=|<<|>>|===|!==|[-+*/%=!<>]=|&&|\|\||->|=>|::|[-+*/%=<>(){}\[\],;:.?!&|^~@])"
    r"|(?P<space>\s+)"
)
SAID = {"&&": " and ", "||": " or ", "!": " not ", "===": "==", "!==": "!=", "->": ".", "{": "[",
        "}": "]", "=>": "=>"}  # fmt: skip
WORDS = {"true": "True", "false": "False", "null": "None", "nullptr": "None", "this": "self",
         "M_PI": "pi", "NULL": "None"}  # fmt: skip
KEPT = ("lambda", "def", "class", "in", "is", "not", "and", "or", "None", "from", "import", "pass",
        "del", "raise", "with", "as", "assert", "yield", "except", "elif", "nonlocal")  # fmt: skip
SIZES = re.compile(r"\[[ ]*,[ ]*\]")  # C#: double[,]
MOST_CHOICES = 12  # a ? b : c in one expression
MADE = ("]", "[]", "()")  # before a list in braces
SPREAD = [("op", ".")] * 3
TYPES = r"(?:const\s+)?(?:unsigned\s+)?(?:double|float|int|long|size_t|real_t|T|Scalar|f64|f32)"
CAST = re.compile(rf"\(\s*{TYPES}\s*\)\s*(?=[\w(.-])")
TEMPLATE = re.compile(
    r"\b(?:static_cast|block|cast|head|tail|topLeftCorner|topRightCorner|template)\s*(<[\w\s,:]*>)"
)
GENERIC = re.compile(  # vector<double>, Matrix<double, 4, 4>, map<string, vector<double>>
    r"\b([A-Za-z_][\w:.]{0,40})<[ ]?(?:const )?[-\w:., <*&]{1,60}?>+(?=[ ]?[\w&({>*:])"
)


class NoProgram(Exception):
    """A statement that is not of the kind that is known."""


def simplified(text):
    """A text without casts and what stands in angle brackets."""
    text = CAST.sub("", text)
    text = TEMPLATE.sub(lambda match: match[0][: match.start(1) - match.start()], text)
    return SIZES.sub("[][]", GENERIC.sub(r"\1", text))


def tokens_of(text):
    """The (kind, text) of the tokens of a text, without spaces.

    Examples
    --------
    >>> tokens_of("a += 2.0f;")
    [('name', 'a'), ('op', '+='), ('number', '2.0'), ('op', ';')]
    """
    found = []
    at = 0
    while at < len(text):
        match = TOKEN.match(text, at)
        if not match:
            raise NoProgram
        if match.lastgroup == "number":
            found.append(("number", match["number"]))
        elif match.lastgroup != "space":
            found.append((match.lastgroup, match[0]))
        at = match.end()
    return found


def expression(tokens):
    """Tokens as an expression of Python's grammar.

    Examples
    --------
    >>> expression(tokens_of("i == 1 && !b ? std::cos(q[0]) : {0.5f, -M_PI / 2}"))
    '(cos(q[0]) if i==1 and  not b else [0.5,-pi/2])'
    """
    condition = split(tokens, "?")
    if len(condition) > MOST_CHOICES:
        raise NoProgram
    if len(condition) > 1:
        rest = [one for part in condition[1:] for one in (*part, ("op", "?"))][:-1]
        choices = split(rest, ":")
        if len(choices) < 2:
            raise NoProgram
        other = [one for part in choices[1:] for one in (*part, ("op", ":"))][:-1]
        return f"({expression(choices[0])} if {expression(condition[0])} else {expression(other)})"
    found: list = []
    at = 0
    while at < len(tokens):
        kind, text = tokens[at]
        if kind == "op" and text in CLOSED:
            inside, at = _inside(tokens, at)
            parts = [part for part in split(inside, ",") if part]
            if text == "{" and parts and _is_record(parts):
                found.append(_record(parts))
                continue
            if text == "{" and parts and all(_is_placed(part) for part in parts):
                found.append(_placed(parts))
                continue
            if text == "[" and _is_new(tokens, at, found):
                sizes, at = [inside], at
                while at < len(tokens) and tokens[at] == ("op", "["):
                    inside, at = _inside(tokens, at)
                    sizes.append(inside)
                found[-1] = f"_new({','.join(expression(one) for one in sizes)})"
                continue
            items = ",".join(expression(part) for part in parts)
            if text == "{" and found and (found[-1].isidentifier() or found[-1] in MADE):
                _drop_maker(found)
            found.append(f"{SAID.get(text, text)}{items}{SAID.get(CLOSED[text], CLOSED[text])}")
            continue
        at += 1
        if kind == "op" and text == "::":
            while found and (found[-1].isidentifier() or found[-1] == "."):
                found.pop()
        elif (kind, text) == ("name", "new") or (text in ("&", "*") and not found):
            continue  # an address, and what stands there
        elif tokens[at - 1 : at + 2] == SPREAD:
            at += 2
            found.append("*")
        elif kind == "string":
            found.append(repr(text[1:-1]))
        elif kind == "name":
            word = WORDS.get(text, text.replace("$", "_"))
            found.append(f"{word}_" if word in KEPT and word != "None" else word)
        elif kind == "op" and text in ("++", "--", "=>", ";"):
            raise NoProgram
        else:
            found.append(SAID.get(text, text))
    return "".join(found)


def _is_record(parts):
    """Whether items in braces are a record: all have names, or some have and the others are names
    that stand for themselves, ``{...row, a: 0.3, d}``.
    """
    named = [_is_named(part) for part in parts]
    return any(named or [False]) and all(
        one or len(part) == 1 or part[:3] == SPREAD for one, part in zip(named, parts)
    )


def _is_new(tokens, at, found):
    """Whether brackets that end at a place are the sizes of an array: new double[4][4]."""
    end = at
    while end < len(tokens) and tokens[end] == ("op", "["):
        _, end = _inside(tokens, end)
    start = next((k for k in range(at - 1, 0, -1) if tokens[k] == ("op", "[")), 0)
    while start > 2 and tokens[start - 1] == ("op", "]"):
        start -= 1
    made = tokens[start - 2 : start - 1] == [("name", "new")] and bool(found)
    braces = end < len(tokens) and tokens[end] == ("op", "{")
    return made and not braces and tokens[at - 2] != ("op", "[")


def _is_placed(tokens):
    """Whether an item says its place: [2] = 0.3."""
    return tokens[0] == ("op", "[") and ("op", "=") in tokens and split(tokens, "=")[0] != tokens


def _placed(parts):
    """Items with their places as a list."""
    pairs = [split(part, "=") for part in parts]
    said = ",".join(f"({expression(one[0][1:-1])},{expression(one[1])})" for one in pairs)
    return f"_placed([{said}])"


def _is_named(tokens):
    """Whether an item has a name: d: 0.3, "d": 0.3, .d = 0.3."""
    texts = [text for _, text in tokens[:3]]
    return texts[1:2] == [":"] or (texts[:1] == ["."] and texts[2:] == ["="])


def _record(parts):
    """Items with names as what _record makes an object of."""
    said = []
    for part in parts:
        if part[:3] == SPREAD:
            said.append(f"**{expression(part[3:])}")
            continue
        if len(part) == 1:
            said.append(f"{part[0][1]!r}:{expression(part)}")
            continue
        named = part[0][1] != "."
        name, value = (part[0][1], part[2:]) if named else (part[1][1], part[3:])
        said.append(f"{name.strip(chr(34) + chr(39))!r}:{expression(value)}")
    return f"_record({{{','.join(said)}}})"


def _drop_maker(found):
    """Take away the name before a list in braces: Vector{1, 2}, double[]{1, 2}."""
    while found and (found[-1].isidentifier() or found[-1] in (".", *MADE)):
        found.pop()


def _inside(tokens, at):
    """(The tokens in a bracket, the place behind it)."""
    depth = 0
    for end in range(at, len(tokens)):
        depth += deeper(tokens[end])
        if depth == 0:
            return tokens[at + 1 : end], end + 1
    raise NoProgram
