"""What the names of a program tell: joints' values, and the order of matrices."""

import re

__all__ = ["JOINT", "NO_JOINT", "has_zero", "numbered"]

JOINT = re.compile(
    r"_?(?:q|thetas?|th|joint|angles?|ang|tita|phi|j|config|t(?=_?\d)|motor|servo|pose|rads?|gdl)"
    r"(?:_?\w*)?$",
    re.IGNORECASE,
)
NO_JOINT = re.compile(
    r"off|zero|lim|min|max|num|dof|type|name|count|len|bias|home|init|n_|_n\b|idx|index|twist"
    r"|q(?:uat|uit)|json|jac|sign|dir|range|matri|trans|param|dh|table",
    re.IGNORECASE,
)
WITH_ZERO = re.compile(r"\s*-?(\w+)(?:\[\d\]|\(\d\))?\s*[-+]\s*(?:\d|(?:np\.|math\.)?pi\b).*")
BETWEEN = re.compile(r"(\D*)(\d+)_(\w+)")
LAST = "G", "g", "E", "e", "EE", "ee", "EF", "ef", "T", "tool"  # what a last link leads to


def numbered(name):
    """The stem and the number of a name: ``A2``, ``T12``, or ``T1_2`` for what leads from 1 to 2.

    Examples
    --------
    >>> numbered("T1_2"), numbered("A12"), numbered("T0_6")
    (('T', '1'), ('A', '12'), ('T0_', '6'))
    """
    between = BETWEEN.fullmatch(name)
    if between and between[3] in (str(int(between[2]) + 1), *LAST):
        return between[1], between[2]
    end = re.search(r"\d+$", name)
    return (name[: end.start()], end[0]) if end else (name, "")


def has_zero(text):
    """Whether a text is a joint's value and what is added to it.

    Examples
    --------
    >>> has_zero("q2 - np.pi/2"), has_zero("q2"), has_zero("arm-1")
    (True, False, False)
    """
    said = WITH_ZERO.fullmatch(text)
    return bool(said and JOINT.match(said[1]))
