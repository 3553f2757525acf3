"""Angles that a program moves on under their own name, ``theta2 = theta2 - pi/2``: the joint's
variable with a zero.
"""

import re

__all__ = ["QUARTER", "with_shifts"]

QUARTER = (
    r"(?:\d\s*\*\s*)?(?:[\w.]*pi\b(?:\s*/\s*2(?:\.0*)?)?"
    r"|(?:1\.570?\d*|3\.141?\d*|90|180)(?:\.0*)?(?![\w.]))"
)
SHIFT = re.compile(
    r"(?P<start>^[ \t]*|;[ \t]*)(?P<name>(?P<stem>theta|th|q)_?(?P<k>\d))\s*"
    rf"(?:=\s*(?P=name)\s*(?P<sign>[-+])|(?P<other>[-+])=)\s*(?P<by>{QUARTER})[ \t]*(?=;|$)",
    re.MULTILINE | re.IGNORECASE,
)


def with_shifts(code):
    """The code with the joint's variable under another name, and without the numbers where the
    joints stand, ``theta2 = 0``, before one is moved on. Where the other name is there already,
    or an angle is moved on twice, or is used before, it is left to be asked about.

    Examples
    --------
    >>> with_shifts("theta2 = 0\\ntheta2 = theta2 - pi/2")
    '\\ntheta2 = q2 - pi/2'
    """
    found = [*SHIFT.finditer(code)]
    names = [shift["name"] for shift in found]
    others = {shift["name"]: _other(shift) for shift in found}
    taken = any(re.search(rf"\b{other}\b", code) for other in others.values())
    used = any(_is_used(shift["name"], code[: shift.start()]) for shift in found)
    if not found or taken or used or len(set(names)) < len(names):
        return code
    first, stems = found[0].start(), "|".join({shift["stem"] for shift in found})
    stands = rf"(?<![\w.])(?:{stems})_?\d[ \t]*=[ \t]*-?\d[\d.]*[ \t]*(?:;[ \t]*|$)"
    before = re.sub(stands, "", code[:first], flags=re.MULTILINE)
    return before + SHIFT.sub(lambda m: _moved(m, others[m["name"]]), code[first:])


def _is_used(name, before):
    """Whether anything but a number, a declaration or the head of a function names it before: then
    the joint is moved on, as a program that drives an arm does.
    """
    declared = re.compile(r"[ \t]*(?:syms\b|(?:def|function|fn|func|double|float|var|let|real)\b)")
    plain = re.compile(rf"(?<![\w.]){name}\s*=\s*(?:-?\d[\d.]*|{name})\s*(?:;|$)", re.MULTILINE)
    lines = (line for line in before.split("\n") if not declared.match(line))
    return any(re.search(rf"\b{name}\b", plain.sub("", line)) for line in lines)


def _other(shift):
    """The name that the joint's variable gets: q2 for theta2, theta2 for q2."""
    return f"theta{shift['k']}" if shift["stem"].lower() == "q" else f"q{shift['k']}"


def _moved(shift, other):
    """``theta2 = q2 - pi/2``."""
    sign = shift["sign"] or shift["other"]
    return f"{shift['start']}{shift['name']} = {other} {sign} {shift['by']}"
