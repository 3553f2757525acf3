"""Sentences that give numbers to names, said as assignments, a row or a list in a line."""

import re

from .brackets import cells_in
from .roles import ROLES, role_of

__all__ = ["in_lines"]

UNITS = r"(?:mm|cm|m|deg|°|rad)"
NAME = r"\$?[^\W\d][\w{}]*\$?"
NUMBER = r"[-+−]?\d*\.?\d+"
# d (mm) = 210
UNIT_BEFORE = re.compile(
    rf"(?<![\w.])([^\W\d]\w*)(?:[ \t]*(?!\(m\))|[ \t]+)[(\[]({UNITS})[)\]]"
    r"[ \t]*([=:])[ \t]*([^,;|\n=:()]+?)(?=[ \t]*(?:[,;|\n]|$))"
)
# (d1, a2) = (210, 340) mm
TUPLES = re.compile(
    rf"\(\s*((?:{NAME}\s*,\s*)+{NAME})\s*\)\s*(?:=|are|sind|:=)\s*"
    rf"\(([^()=\n]+)\)[ \t]*({UNITS}\b)?"
)
# L1/L2 = 210/340 mm, and two lines of a table
SLASHES = re.compile(
    rf"(?<![\w/])((?:[^\W\d]\w*/)+[^\W\d]\w*)[ \t]*[=:][ \t]*((?:{NUMBER}/)+{NUMBER})"
    rf"[ \t]*({UNITS}\b)?"
)
LENGTH = r"[ \t]*(?:[lLdDaAhHrR]_?[\d₀-₉]+)[ \t]*"
BELOW = re.compile(
    rf"^[ \t]*\|({LENGTH}(?:\|{LENGTH})+)\|[ \t]*\n[ \t]*\|[-:| \t]+\|[ \t]*\n"
    rf"[ \t]*\|((?:[ \t]*{NUMBER}[ \t]*{UNITS}?[ \t]*\|)+)()[ \t]*$",
    re.MULTILINE,
)
# **L1** = 210, *L1* = 210; L1 → 210 mm alone in its line
BOLD = re.compile(r"(?<![\w)\]*])\*\*(?=[^\s*])([^*\n]+?)(?<=\S)\*\*(?![\w(*])")
ITALIC = re.compile(r"(?<![\w)\]*])[*_]([^\W\d_]\w*?)[*_](?=[ \t]*[=:][^=])")
NAMED_SO = re.compile(
    rf"^([ \t]*(?:[-*•][ \t]+)?[^\W\d]\w{{0,12}})[ \t]*(?:→|->|=>|⇒|≈|≃|~|\.{{2,}})[ \t]*"
    rf"(?=[~≈]?{NUMBER}(?:[ \t]*{UNITS})?[ \t]*(?:\([^()\n]*\))?[ \t]*[.,;]?[ \t]*$)",
    re.MULTILINE,
)
# L1: base height, 210 mm
WORDS_BETWEEN = re.compile(
    rf"^([ \t]*(?:[-*•][ \t]+)?{LENGTH})[:=–-][ \t]*[^\d\n|=:]*[^\W\d]{{3}}[^\d\n|=:]*"
    rf"[,:=–(-][ \t]*({NUMBER}[ \t]*(?:mm|cm|m))\)?[ \t]*[.,;]?[ \t]*$",
    re.MULTILINE,
)
# L1 (210 mm) is the base
IN_BRACKETS = re.compile(rf"(?<!\w)({LENGTH})\(({NUMBER}[ \t]*(?:mm|cm|m))\)")
BETWEEN_BARS = re.compile(
    rf"^[ \t|]*(?:[ \t]*[^\W\d]\w*[ \t]*=[ \t]*{NUMBER}[^|=\n]*(?:\||$)){{2,}}[ \t]*$", re.MULTILINE
)
# link 2 has d = 0, a = 340 mm and alpha = 0; link 3 has …
LINK = re.compile(
    r"(?:(?<=[;:.,])|(?<=\band)|^)[ \t]*(?:and[ \t]+)?(?:for[ \t]+|the[ \t]+)?"
    r"((?:link|joint|axis)[ \t]*#?\d|[jl]\d(?=:))\b[ \t]*(?:has|is|uses|with|having|:|,)?[ \t]+",
    re.IGNORECASE | re.MULTILINE,
)
NAMED = re.compile(r"(?<!\w)(?:theta|alpha|[θαadr])[₀-₉\d]?[ \t]*[=:]", re.IGNORECASE)
# link lengths a: 0, 340, 270 mm
LIST = re.compile(
    r"(?P<words>[^\W\d][^\d=:;,|\[\]{}]{0,40}?)[ \t]*(?:[=:]|\bare\b)[ \t]*"
    rf"(?P<cells>[^=:;|\[\]{{}}]+?,[^=:;|\[\]{{}}]+?)[ \t]*(?P<unit>{UNITS})?[ \t]*\.?"
)
ENDS = re.compile(r";[ \t]*|\.[ \t]+(?=[^\W\d])|\.?\n")
CSV = re.compile(r'[ \t]*(?:"[^"\n]*"|[^"()\[\]{}=\n;,\t]*)([;,\t])[^()\[\]{}=\n]*')
FEWEST = 3


def in_lines(text):
    """The text, with numbers that sentences give to names said as assignments.

    Examples
    --------
    >>> in_lines("d (mm) = 210, with (a1, a2) = (0.3, 0.2) m")
    'd = 210 mm, with a1 = 0.3 m; a2 = 0.2 m'
    >>> in_lines("Link lengths a: 0, 0.3; offsets d: 1, 0; twists alpha: 90, 0.")
    'a = [0, 0.3]\\nd = [1, 0]\\nalpha = [90, 0]'
    """
    text = ITALIC.sub(r"\1", BOLD.sub(r"\1", _without_quotes(text)))
    text = UNIT_BEFORE.sub(_with_unit, NAMED_SO.sub(r"\1 = ", text))
    for several in (TUPLES, SLASHES, BELOW):
        text = several.sub(_one_by_one, text)
    text = WORDS_BETWEEN.sub(r"\1 = \2", text)
    text = "\n".join(
        line if re.search(r"[|\t&]", line) else IN_BRACKETS.sub(r"\1 = \2;", line)
        for line in text.split("\n")
    )
    text = BETWEEN_BARS.sub(lambda m: m[0].replace("|", ";").strip("; "), text)
    return _lists("\n".join(map(_links, text.split("\n"))))


def _with_unit(match):
    """``d (mm) = 210`` as ``d = 210 mm``; what has no number, or pi, needs no unit."""
    name, unit, mark, said = match.groups()
    bare = not re.search(r"\d", re.sub(r"[^\W\d]\w*", "", said)) or re.search(r"pi\b|π", said)
    return f"{name} {mark} {said}" if bare else f"{name} {mark} {said} {unit}"


def _one_by_one(match):
    names, cells = (cells_in(re.sub(r"[/|]", ",", match[k])) for k in (1, 2))
    unit = f" {match[3]}" if match[3] else ""
    if len(names) != len(cells) or not all(re.search(r"[\d₀-₉]\W*$", name) for name in names):
        return match[0]
    bare = all(re.fullmatch(NUMBER, cell) for cell in cells)
    unit = unit if bare else ""
    return "; ".join(f"{name} = {cell}{unit}" for name, cell in zip(names, cells))


def _links(line):
    """A sentence that gives each link its numbers, with a line for each link."""
    at = list(LINK.finditer(line))
    parts = [
        line[one.end() : after.start() if after else len(line)]
        for one, after in zip(at, [*at[1:], None])
    ]
    if len(parts) < 2 or not all(len(NAMED.findall(part)) > 1 for part in parts):
        return line
    *parts, last = parts
    last, *more = re.split(r"(?<=[^.])\.\s+(?=[^\W\d])", last, maxsplit=1)
    said = (re.sub(r",?[ \t]+and[ \t]+", ", ", p).strip(" ;.,") for p in (*parts, last))
    rows = [f"{one[1]}: {part}" for one, part in zip(at, said)]
    return "\n".join([line[: at[0].start()], *rows, *more])


def _role(words):
    """What words name: the letter at their end says it better than they, as in ``offsets d``."""
    last = words.split()[-1]
    named = role_of(last)[0] if len(last) == 1 or last.lower() in ROLES else None
    return named or role_of(words.split(".")[-1])[0]


def _lists(text):
    """``Link lengths a: 0, 0.3; …`` as ``a = [0, 0.3]``, where three parameters are given so."""
    found = {}
    for part in ENDS.split(text):
        one = LIST.fullmatch(part.strip(" \t-*"))
        role = _role(one["words"]) if one else None
        cells = cells_in(re.sub(r",?\s+and\s+", ", ", one["cells"])) if role else []
        if role in (*ROLES, "r", "offset") and len(cells) > 1:
            if role in found:
                return text
            found[role] = (part, cells, one["unit"])
    counts = {len(cells) for _, cells, _ in found.values()}
    if not {"alpha", "a", "d"} <= set(found) or len(counts) > 1:
        return text
    if text.count("\n") and all(f"{part}\n" in f"{text}\n" for part, *_ in found.values()):
        return text  # a list a line is read as it is
    for role, (part, cells, unit) in found.items():
        name = "theta_offset" if role == "offset" else role
        listed = f"{name} = [{', '.join(cells)}]" + (f" ({unit})" if unit else "")
        text = text.replace(part, f"\n{listed}\n", 1)
    return re.sub(r"\n[ \t;.]*(?=\n)", "", text).strip("\n; .")


def _without_quotes(text):
    """The rows of a spreadsheet's file without quotation marks; a comma in them is decimal."""
    lines = text.split("\n")
    rows = [k for k, line in enumerate(lines) if '"' in line and CSV.fullmatch(line)]
    if len(rows) < FEWEST or len({CSV.fullmatch(lines[k])[1] for k in rows}) > 1:
        return text
    for k in rows:
        lines[k] = re.sub(r'"([^"\n]*)"', lambda m: re.sub(r"(?<=\d),(?=\d)", ".", m[1]), lines[k])
    return "\n".join(lines)
