"""Rows that a program makes several times over, alike: written out as often as it makes them."""

import re

__all__ = ["repeated"]

MOST = 12  # links of an arm
ROW = r"((?:\w[\w.:]*\s*)?(?:\((?:[^()\n]|\([^()\n]*\))*\)|\[[^\[\]\n]*\]|\{[^{}\n]*\}))"
LISTED = (  # [[0, 0, 0.2, 0]] * 6, [Link(a=0.2) for _ in range(6)], [Link { a: 0.2 }; 6]
    re.compile(rf"\[\s*{ROW}\s*\]\s*\*\s*(\w+)"),
    re.compile(rf"\[\s*{ROW}\s+for\s+\w+\s+in\s+range\(\s*(\w+)\s*\)\s*\]"),
    re.compile(rf"\[\s*{ROW}\s*;\s*(\w+)\s*\]"),
)
IN_BRACES = re.compile(
    r"\bfor\s*(?:\(\s*(?:(?:int|size_t|unsigned|auto|let|var|std::size_t)\s+)*(\w+)\s*=\s*0\s*;\s*\1\s*<\s*"
    r"([\w.]+(?:\(\))?)\s*;[^)]*\)|(\w+)\s+in\s+0\s*\.\.\s*(\w+))\s*\{([^{}]*(?:\{[^{}]*\}[^{}]*)*)\}"
)
BY_INDENT = re.compile(
    r"^([ \t]*)for[ ]+(\w+)[ ]+in[ ]+range\(\s*(\w+)\s*\):((?:[ \t]*\n\1[ \t]+[^\n]+)+|[^\n]+)",
    re.MULTILINE,
)
TO_END = re.compile(
    r"^[ \t]*for[ ]+(\w+)\s*=\s*1\s*:\s*(\w+)[ \t,;]*\n?((?:(?!\bfor\b|\bend\b)[^\0])*?)\bend\b",
    re.M,
)
FIELD = re.compile(r"\b(?:theta\w*|alpha|[adr])['\"]?\s*[:=](?!=)", re.IGNORECASE)
MADE = re.compile(r"\b\w*(?:Link|DH|Revolute)\w*\s*[({\[]|append\s*\(\s*[\[(]", re.IGNORECASE)


def repeated(code):
    """The code with rows that are repeated, or made alike in a loop, as often as they are made.

    Examples
    --------
    >>> repeated("DH = [[0, 0, 0.2, 0]] * 3")
    'DH = [[0, 0, 0.2, 0], [0, 0, 0.2, 0], [0, 0, 0.2, 0]]'
    """
    for pattern in LISTED:
        code = pattern.sub(lambda m: _listed(m, m.string), code)
    code = IN_BRACES.sub(lambda m: _loop(m, m[1] or m[3], m[2] or m[4], m[5]), code)
    code = BY_INDENT.sub(lambda m: _loop(m, m[2], m[3], m[4]), code)
    return TO_END.sub(lambda m: _loop(m, m[1], m[2], m[3], 1), code)


def _count(name, code):
    """How many times, by a number, a name that is given one, or the size of a vector; 0 unknown."""
    of = name.removesuffix(".size()")
    made = (
        rf"\b{re.escape(of)}(?:\.resize)?\s*\(\s*(\d+)\s*\)"
        if of != name
        else rf"\b{name}(?:\s*:\s*\w+)?\s*=\s*(\d+)\b(?!\.)"
    )
    found = re.fullmatch(r"\d+", name) or re.search(made, code)
    count = int(found[found.re.groups]) if found else 0
    return count if count <= MOST else 0


def _listed(match, code):
    count = _count(match[2], code)
    numbers = len(re.findall(r"(?<![\w.])-?\d", match[1]))
    alike = numbers > 1 or FIELD.search(match[1])
    return f"[{', '.join([match[1]] * count)}]" if count > 1 and alike else match[0]


def _loop(match, name, count, body, first=0):
    """The body of a loop once for each turn, on its first line; as it is where it says more than
    numbers.
    """
    times = _count(count, match.string)
    places = re.sub(rf"\b[\w.]+\s*[\[(]\s*{name}\s*[\])](?=\s*(?:\.\w+)?\s*=(?!=))", "", body)
    links = len(set(FIELD.findall(body))) > 1 or MADE.search(body)
    if times < 2 or not links or re.search(rf"\b{name}\b|\b(?:cos|sin|for|if)\b|@", places):
        return match[0]
    said = "; ".join(part.strip(" ;\t") for part in body.split("\n") if part.strip())
    turns = (re.sub(rf"\b{name}\b", str(k + first), said) for k in range(times))
    return "; ".join(turns) + "\n" * match[0].count("\n")
