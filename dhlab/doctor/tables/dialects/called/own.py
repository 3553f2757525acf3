"""Classes and structures that a text defines itself for links, with d, a and alpha and no theta: in
which order they take them.
"""

import re

from ...language.roles import ROLES, role_of

__all__ = ["member_of", "own_classes"]

HEAD = re.compile(
    r"^[ \t]*(?:[a-z]+[ \t]+)*?(?:class|classdef|struct|record|type)[ \t]+(\w+)", re.MULTILINE
)
MADE = re.compile(  # DH = namedtuple("DH", "a d alpha"), Struct.new(:a, :d, :alpha)
    r"\b(\w+)\s*=\s*(?:\w+\.)*(?:namedtuple|NamedTuple|make_dataclass|Struct\.new)\s*\(([^\n]*)"
)
NAMED = re.compile(  # somebody else's: denavitHartenberg(d=0.3, alpha=pi/2)
    r"\b(denavit_?hartenberg\w*)\s*\("
    r"(?:\s*(?:theta|d|a|alpha)\s*=(?:[^=,()\n]|\([^()\n]*\))+,?)+\)",
    re.IGNORECASE,
)
COMMENT = re.compile(r"(?:#|//|%).*|/\*.*?\*/|\"\"\".*?\"\"\"")
METHOD = re.compile(r"\b(?:def|function|methods|public:)\b|\)\s*[:{]")
BEFORE = r"(?:__init__|constructor|initialize|__construct|\b{})\s*\(([^()]*)\)"
OWNERS = ("self", "this", "obj", "cls")
LONGEST = 900  # characters of a class that are looked at


def own_classes(text):
    """{name: roles} of the classes that the text defines, "apart" for what is no parameter.

    Examples
    --------
    >>> own_classes("class DH:\\n    def __init__(self, a, d, alpha):\\n        self.a = a")
    {'DH': ('a', 'd', 'alpha')}
    >>> own_classes("@dataclass\\nclass Link:\\n    alpha: float\\n    d: float\\n    a: float")
    {'Link': ('alpha', 'd', 'a')}
    """
    text = COMMENT.sub("", text)
    heads = [*HEAD.finditer(text)]
    found = {}
    for head, following in zip(heads, [*heads[1:], None]):
        end = following.start() if following else len(text)
        if roles := _roles_of(head[1], text[head.end() : min(end, head.end() + LONGEST)]):
            found[head[1]] = roles
    for name, said in MADE.findall(text):
        words = re.sub(rf"(['\"]){name}\1", "", said)
        if roles := _roles(re.findall(r"[A-Za-z_]\w*", words)):
            found[name] = roles
    return found | dict.fromkeys(NAMED.findall(text), ("d", "a", "alpha"))


def member_of(name, classes):
    """The class of the text's own whose numbered member a constructor makes, ``link2(0.3, 0, 0)``;
    the name itself of all else.
    """
    stem = name.rstrip("0123456789_").lower()
    alike = [one for one in classes if stem != name.lower() and one.lower().endswith(stem or "?")]
    return alike[0] if len(alike) == 1 else name


def _roles_of(name, body):
    """The roles of a class by its brackets, its constructor or its fields."""
    taken = re.match(r"\s*\(([^()]*)\)", body), re.search(BEFORE.format(name), body)
    for match in filter(None, taken):
        if roles := _roles([_name(part) for part in match[1].split(",")]):
            return roles
    fields = re.split(r"[;,{}\n]", METHOD.split(body)[0])
    return _roles([one for one in map(_name, fields) if one])


def _name(part):
    """The name in ``const double& a = 0``, ``a: float`` or Go's ``Alpha float64``."""
    words = re.findall(r"[A-Za-z_]\w*", re.split(r"=|:(?!:)|::", part)[0])
    words = [re.sub(r"_?(?<=[a-z_])(?:Value|value|Val|val|In|in)$", "", word) for word in words]
    return next((word for word in words[::-1] if role_of(word)[0] in (*ROLES, "r", "offset")),
                words[-1] if words else "")  # fmt: skip


def _roles(names):
    """The roles that names mean, from the first parameter on; None where they are no link's, or
    have a theta.
    """
    roles = [role_of(name)[0] for name in names if name and name not in OWNERS]
    roles = ["a" if role == "r" and "a" not in roles else role for role in roles]
    held = [role for role in roles if role in ("d", "a", "alpha")]
    if sorted(held) != ["a", "alpha", "d"] or {"theta", "offset"} & set(roles):
        return None
    return tuple(role if role in held else "apart" for role in roles)
