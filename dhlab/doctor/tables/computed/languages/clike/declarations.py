"""Declarations and assignments of the languages with braces, without their types."""

from ..brackets import deeper, split
from .tokens import NoProgram, expression

__all__ = [
    "NO_TYPES", "assignment", "behind", "closing", "closing_or_none", "declared", "initialised",
    "matrix_of", "parameters", "references", "step", "without_type",
]  # fmt: skip

MODIFIERS = {"const", "static", "final", "public", "private", "protected", "constexpr", "inline",
             "readonly", "export", "async", "extern", "volatile", "unsigned", "override",
             "virtual", "unsafe", "struct"}  # fmt: skip
BRACKETS = [("op", "(")], [("op", "{")]
MATRICES = {"Matrix4d", "Matrix4f"}
NO_TYPES = {"return", "else", "new", "delete", "throw", "if", "for", "while", "case", "goto"}


def assignment(tokens):
    """An assignment, or a declaration without a value, which is empty or zeros."""
    for mark in ("=", "+=", "-=", "*=", "/="):
        sides = split(tokens, mark)
        if len(sides) > 1:
            *targets, value = sides
            if not value:
                raise NoProgram
            names = [declared(one) for one in targets]
            return f"{mark.join(names)}{mark}{expression(value)}"
    if tokens[0][0] == "name" and tokens[1:2] == [("op", "{")]:  # vector<Row> rows{{…}};
        return f"{tokens[0][1]} = {expression(tokens[1:])}"
    sizes = [k for k, one in enumerate(tokens) if one == ("op", "[")]
    if tokens[0][0] == "name" and sizes == [] and len(tokens) == 1:
        return f"{tokens[0][1]} = _new()"
    if tokens[0][0] == "name" and sizes and sizes[0] == 1:
        ends = [expression(tokens[k + 1 : closing(tokens, k)]) for k in sizes]
        return f"{tokens[0][1]} = _new({','.join(ends)})"
    return expression(tokens)


def matrix_of(tokens, part):
    """One of the names that are declared as 4×4 matrices: zeros, or the numbers in its braces; ""
    of all else.
    """
    before = tokens[: tokens.index(part[0])]
    if not any(text in MATRICES for _, text in before):
        return ""
    if len(part) == 1:
        return f"{part[0][1]} = Zero()"
    if part[1:3] == [("op", "="), ("op", "{")]:
        return f"{part[0][1]} = _filled({expression(part[2:])})"
    return ""


def initialised(tokens, at):
    """([(name, tokens of its value)] of what a constructor sets before its body, the place of the
    body): ``: reach(0.3), lift(0.1) {``; nothing of all else.
    """
    found, end = [], at
    while end < len(tokens) and tokens[end][1] == (":" if end == at else ","):
        end += 1
        while end < len(tokens) and (tokens[end][0] == "name" or tokens[end][1] == "::"):
            end += 1
        close = closing_or_none(tokens, end) if tokens[end:][:1] in BRACKETS else None
        if close is None:
            return [], at
        found.append((tokens[end - 1][1], tokens[end + 1 : close]))
        end = close + 1
    return found, end


def declared(tokens):
    """What stands on the left: a name without its type and sizes, a place of an array."""
    tokens = without_type(tokens)
    if tokens and tokens[-1] == ("op", ")"):  # T(0, 3)
        last = len(tokens) - 1
        start = max(k for k in range(last) if closing_or_none(tokens, k) == last)
        places = [expression(one) for one in split(tokens[start + 1 : last], ",")]
        owner, _, part = expression(tokens[:start]).rpartition(".")
        if part in ("row", "col") and owner:  # T.row(0) << 1, 0, 0, 0;
            return f"{owner}[{places[0]}]" if part == "row" else f"{owner}[:,{places[0]}]"
        return f"{expression(tokens[:start])}[{','.join(places)}]"
    return expression(tokens)


def without_type(tokens):
    """A declaration without its type: const double a[6] = {…} as a = {…}."""
    kept = [one for one in tokens if one[1] not in MODIFIERS]
    k = 0
    while k < len(kept) and (kept[k][0] == "name" or kept[k][1] in ("::", "*", "&", ".")):
        k += 1
    names = [j for j in range(k) if kept[j][0] == "name"]
    typed = (
        len(names) > 1 and kept[names[-1] - 1][1] not in ("::", ".") and kept[0][1] not in NO_TYPES
    )
    after_list = not typed and len(kept) > 3 and [one[1] for one in kept[1:3]] == ["[", "]"]
    if after_list or (
        typed and [one[1] for one in kept[k : k + 2]] == ["[", "]"] and kept[k + 2][0] == "name"
    ):
        while (kept and kept[0][1] != "]") or (len(kept) > 1 and kept[1][1] in ("[", "]")):
            kept = kept[1:]
        return kept[1:]
    if not typed:
        return kept
    start = names[-1]
    end = start + 1
    sized = [one == ("op", "=") for one in kept]
    if any(sized):  # a[6] = {…}
        while kept[end][1] == "[":
            end = closing(kept, end) + 1
        if kept[end][1] != "=":
            end = start + 1
        return [kept[start], *kept[end:]]
    return kept[start:]


def parameters(tokens):
    """The parameters of a function; a matrix that it fills is zeros, where nobody gives it."""
    given = [part for part in split(tokens, ",") if part]
    found = [parameter(part) for part in given]
    for k in range(len(found) - 1, -1, -1):
        sizes = [expression(one) for one in _sizes(given[k])]
        if len(sizes) != 2 or "=" in found[k] or not all(sizes):
            break
        found[k] += f"=_new({','.join(sizes)})"
    return found


def references(tokens):
    """The parameters that are 4×4 matrices of the caller, which a function fills."""
    found = set()
    for part in split(tokens, ","):
        texts = {text for _, text in part}
        if "&" in texts and "const" not in texts and texts & MATRICES:
            found.add(parameter(part))
    return found


def _sizes(tokens):
    starts = [k for k, one in enumerate(tokens) if one == ("op", "[")]
    return [tokens[k + 1 : closing(tokens, k)] for k in starts]


def parameter(tokens):
    """A parameter without its type, with its default."""
    sides = split(tokens, "=")
    names = [text for kind, text in sides[0] if kind == "name"]
    if not names:
        raise NoProgram
    colon = [k for k, one in enumerate(sides[0]) if one[1] == ":"]  # TypeScript
    name = sides[0][0][1] if colon else names[-1]
    return f"{name}={expression(sides[1])}" if len(sides) > 1 else name


def step(tokens):
    """The last part of a loop's head: i++, i += 2."""
    texts = [text for _, text in tokens]
    for mark in ("++", "--"):
        if mark in texts:
            name = expression([one for one in tokens if one[1] != mark])
            return f"{name}{mark[0]}=1"
    return assignment(tokens)


def closing(tokens, at):
    """The place of the bracket that closes another."""
    found = closing_or_none(tokens, at)
    if found is None:
        raise NoProgram
    return found


def closing_or_none(tokens, at):
    """The place of the bracket that closes another; None without one."""
    depth = 0
    for k in range(at, len(tokens)):
        depth += deeper(tokens[k])
        if depth <= 0:
            return k if k > at else None
    return None


def behind(tokens, at):
    """The place behind the semicolon that ends a statement."""
    depth = 0
    for k in range(at, len(tokens)):
        depth += deeper(tokens[k])
        if depth < 0:
            return k
        if depth == 0 and tokens[k] == ("op", ";"):
            return k + 1
    return len(tokens)
