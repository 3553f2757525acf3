"""What a text says of the order in which four numbers stand, in a comment, a heading, a structure
or the head of a function; and which matrix its own function computes.
"""

import re

from ..language.brackets import groups
from ..language.roles import ROLES, role_of, unit_in

__all__ = [
    "every_column_in",
    "names_in_a_row",
    "order_in",
    "order_of_names",
    "order_of_three",
    "previous_in",
]

NAME = re.compile(r"[A-Za-z][\w.]*(?:[({\[]i(?:\s*-\s*1)?[)}\]]|_\{?i-1\}?|(?<=_i)-1)?")
PREVIOUS = re.compile(r"\b(?:a|alpha)_?[({\[]?i\s*-\s*1", re.IGNORECASE)
NO_COLUMN = re.compile(
    r"standard|modified|craig|classic|\bdh\b|\b(?:mm?|cm|deg|rad)\b|\s\S+\s", re.IGNORECASE
)
BETWEEN = re.compile(
    r"[\s,;|&/\[\](){}:=*'\"_.>→%#-]*(?:(?:const|double|float|real|int|f64|self|np)\b[\s,;.]*)*"
)
ROW = re.compile(  # al, a, to, d = dh[i]; for al, a, to, d in dh
    r"(?:^|[;(]|\bfor\s)\s*\(?(\w+)\s*,\s*(\w+)\s*,\s*(\w+)\s*,\s*(\w+)\)?\s*"
    r"(?:=\s*[\w.]+\s*(?:\[\w+\]|\(\w+,\s*:\))|\bin\s)",
    re.MULTILINE,
)
_LISTED = re.compile(r"[(\[{]([^()\[\]{}]{12,200})[)\]}]")
INDEXED = re.compile(  # Col 0: theta_offset, DH[i][0]=a
    r"(?:\bcol(?:umn)?s?\.? ?|\[i\]\[)(\d)\]?\s*[:=-]\s*([A-Za-z]\w*)", re.IGNORECASE
)
UNPACKED = re.compile(
    r"(\w+)(?:\s*=|['\"]\s*,)\s*[\w.]+[\[(](?:[\w:]+\s*(?:,|\]\s*\[)\s*)?(\d)[\])]"
)


def order_in(source):
    """(roles, units by role, where it says so, line) of the first place that names four columns in
    a row; None without one.
    """
    used = source.link_matrix
    if used and len(used.order) == 4:
        return (used.order, {}, "as its own link matrix takes them", 0)
    for line, text in source.comments:
        found = order_of_names(text)
        if found:
            return (*found, "as the comment says", line)
    found = order_of_names(source.code, in_code=True)
    if found:
        return (*found, "as the program says", 0)
    for names in ROW.findall(source.code):
        if roles := _completed([source.role(name) for name in names]):
            return roles, {}, "as the program takes them apart", 0
    picked = {}
    for name, index in UNPACKED.findall(source.code):
        role = role_of(name)[0]
        if role in (*ROLES, "r", "offset"):
            picked.setdefault(int(index), role)
    for index, name in INDEXED.findall(source.text):
        if role_of(name)[0] in (*ROLES, "r", "offset"):
            picked.setdefault(int(index), role_of(name)[0])
    if "theta" not in picked.values():
        picked = {k: "theta" if role == "offset" else role for k, role in picked.items()}
    if len(picked) >= 4 and len(set(list(picked.values())[:4])) == 4:
        roles = tuple(picked[k] for k in sorted(picked))[:4]
        return (roles, {}, "as the program says", 0)
    said = dict(reversed(source.comments))
    beside = {_roles_beside(group, said) for group in groups(source.code) if said} - {None}
    return (
        (beside.pop(), {}, "as the comments beside the numbers say", 0)
        if len(beside) == 1
        else None
    )


def _roles_beside(group, said):
    """The roles of four numbers, one a line, as the comments behind these say ({line: comment});
    None where not all are said.
    """
    at, roles, lines = 0, [], set()
    for item in group.items[:4]:
        at = group.text.find(item.text, at) + len(item.text)
        line = group.line + group.text.count("\n", 0, at)
        role = role_of(re.split(r"[:=(,]|\s-", said.get(line, ""))[0])[0]
        roles.append("theta" if role == "offset" else role)
        lines.add(line)
    return tuple(roles) if len(lines) == 4 and set(roles) == set(ROLES) else None


def _completed(roles):
    """Four roles of which one says nothing, or is an offset: it is the one that is left."""
    roles = [role if role in (*ROLES, "r") else None for role in roles]
    roles = ["a" if role == "r" and "a" not in roles else role for role in roles]
    left = set(ROLES) - set(roles)
    if len(left) > 1 or roles.count(None) != len(left):
        return None
    return tuple(role or left.pop() for role in roles)


def every_column_in(source, width):
    """What a comment or a definition calls each of more than four columns, "apart" what is none of
    the table's; None where nothing names as many.

    Examples
    --------
    >>> from .source import source_of
    >>> every_column_in(source_of("% name, theta, d, a, alpha, qmin"), 6)
    ('label', 'theta', 'd', 'a', 'alpha', 'low')
    """
    for text in (*(text for _, text in source.comments), *_LISTED.findall(source.code)):
        parts = [part.strip(" .)]}>`'\"") for part in re.split(r"[,;|]", text)]
        parts = [part for part in parts if part not in ("self", "cls", "this", "obj")]
        for at in range(len(parts) - width + 1):
            named = [re.split(r"[:(\[{=]\s*", parts[at])[-1], *parts[at + 1 : at + width]]
            found = [
                source.role(re.split(r"\s+|[*&]", one)[-1]) or role_of(one)[0] for one in named
            ]
            if "theta" not in found and "offset" in found:
                found[found.index("offset")] = "theta"
            told = any(NO_COLUMN.search(one) for one, role in zip(named, found) if role is None)
            if all(found.count(role) == 1 for role in ROLES) and not told:
                return tuple(role or "apart" for role in found)
    return None


def order_of_three(source):
    """(roles, why) of rows of three numbers: a, d and alpha in some order, where theta stands
    elsewhere or nowhere, or alpha, theta and the one length that the text does not say to be 0;
    None where nothing says the order.
    """
    four = source.order
    if four and "r" not in four[0]:
        return tuple(role for role in four[0] if role != "theta"), four[2]
    for text, why in (
        *((text, "as the comment says") for _, text in source.comments),
        (source.code, "as the program says"),
    ):
        words = re.findall(r"\b[A-Za-z]\w*|[^\s\w]|\d+", re.sub(r"\(\w+\)|\[\w+\]", "", text))
        words = [word for word in words if word not in (",", "|", ";", "-", "/", "double", "float")]
        for at in range(len(words) - 2):
            roles = tuple(role_of(word)[0] for word in words[at : at + 3])
            if set(roles) == {"a", "d", "alpha"}:
                return roles, why
            roles = tuple("theta" if role == "offset" else role for role in roles)
            left = {*ROLES} - {*roles}
            if len(left) == 1 and left <= {"a", "d"} and _is_0(*left, source.text):
                return roles, why
    return None


def _is_0(name, text):
    return bool(re.search(rf"(?<![\w.]){name}(?:_?i)?\s*=+\s*0(?![.\d])", text))


def previous_in(source):
    """Whether the comment that names the columns counts a or alpha from the link before.

    Examples
    --------
    >>> from .source import source_of
    >>> previous_in(source_of("% a(i-1), alpha(i-1), d(i), theta(i)\\nDH = [0 0 1 0]"))
    True
    """
    named = (text for _, text in source.comments if order_of_names(text))
    return any(PREVIOUS.search(text) for text in named)


def order_of_names(text, in_code=False):
    """(roles, units) where four names of columns follow each other; None otherwise.

    Examples
    --------
    >>> order_of_names("{theta0(deg), d, a, alpha(deg)}")
    (('theta', 'd', 'a', 'alpha'), {'theta': 'deg', 'alpha': 'deg'})
    """
    found = names_in_a_row(text, in_code)
    if found is None and not in_code and (roles := _of_phrases(text) or _of_letters(text)):
        return roles, {}
    return found and found[:2]


def _of_letters(text):
    """The roles of four letters, each once, among words of a script that has not these letters."""
    if not re.search(r"[\u0400-\u04ff\u3040-\u30ff\u4e00-\u9fff\uac00-\ud7af]", text):
        return None
    found = re.findall(r"(?<![A-Za-z])(?:theta|alpha|[adr])(?![A-Za-z])", text.lower())
    roles = tuple("a" if letter == "r" and "a" not in found else letter for letter in found)
    return roles if len(roles) == 4 and set(roles) == set(ROLES) else None


def _of_phrases(text):
    """The roles of four phrases in a row, at commas or bars: ``theta offset, d, length, …``."""
    text = re.sub(r"\s*[(\[]\s*(?:deg|rad|°|mm|cm|m)\s*[)\]]", "", text)
    parts = [part.strip(" .)]}") for part in re.split(r"[,;|/]|->|\band\b", text)]
    for at in range(len(parts) - 3):
        first = re.split(r"[:(\[{=]", parts[at])[-1]
        words, ending = first.split(), parts[at + 3].split()
        starts = [first, " ".join(words[-2:]), " ".join(words[-1:])]
        ends = [parts[at + 3], " ".join(ending[:2]), " ".join(ending[:1])]
        roles = tuple(
            next(
                (role for one in said if (role := role_of(one)[0]) in (*ROLES, "r", "offset")), None
            )
            for said in (starts, [parts[at + 1]], [parts[at + 2]], ends)
        )
        roles = tuple(
            "theta" if role == "offset" and "theta" not in roles else role for role in roles
        )
        if len({*roles} - {"offset", None}) == 4 and {"theta", "alpha"} <= set(roles):
            return roles
    return None


def names_in_a_row(text, in_code=False):
    """(roles, units, where they end) as :func:`order_of_names`."""
    run, units, last = [], {}, 0
    for match in NAME.finditer(text):
        gap = text[last : match.start()]
        if re.fullmatch(r"[ms]?dh", match[0].lower()) or text[match.start() :][:3].lower() == "d-h":
            run, last = ([] if len(run) < 4 else run), match.end()
            continue
        role = role_of(match[0] if in_code else re.sub(r"(?<=[a-z])_?\d$", "", match[0]))[0]
        role = "theta" if role == "offset" and "theta" not in run else role
        unit = unit_in("x (" + match[0] + ")") if match[0] not in ("d", "a") else ""
        if (unit and run and "(" in gap) or (unit and "[" in gap and run):
            units[run[-1]] = unit
            last = match.end()
            continue
        if match[0] in ("const", "double", "float", "real", "f64", "self", "T", "var", "int"):
            continue
        if role in ("theta", "d", "a", "alpha", "r") and not (in_code and match[0].endswith(".")):
            fits = run and role not in run and BETWEEN.fullmatch(text, last, match.start())
            if run and not fits and len(run) >= 4 and role not in run:
                pass
            if len(run) < 4 or fits:
                near = BETWEEN.fullmatch(text, last, match.start()) if run else None
                kept = run[run.index(role) + 1 :] if near and role in run else []
                run = [*run, role] if fits else [*kept, role]
            last = match.end()
            if len(run) == 4 and not in_code:
                units.update(_unit_after(text, last, role))
            if len(run) == 4 and {"theta", "alpha"} <= set(run):
                return tuple(run), units, last
        else:
            run = [] if len(run) < 4 else run
            last = match.end()
    return None


def _unit_after(text, at, role):
    unit = re.match(r"\s*[\[(]\s*(deg|rad|mm|cm|m|°)\s*[\])]", text[at:])
    return {role: {"°": "deg"}.get(unit[1], unit[1])} if unit else {}
