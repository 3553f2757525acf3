"""A cell that says its number more than once, or something beside it: ``L1 + L2 = 210``,
``210 mm (0.21 m)``, ``ca. 210 (see note 1)``, ``theta2 = q2 + 90``. Taken apart into what each part
says; what does not agree is no cell.
"""

import math
import re

from .expressions import NoExpression, evaluate
from .values import TO_METRES, added
from .words import RANGE

__all__ = ["decorated", "is_doubled"]

# behind a cell, in brackets: (see note 1), [d1]; the gap tells it from q(1) and 2(L1 + L2)
BEHIND = re.compile(
    r"(?P<before>.*\S)(?:\s+|(?<=[\d°*])(?=[(\[](?:[A-Za-z_]+\d?|[^\d()\[\]+*/-]*)[)\]]))"
    r"(?P<inside>\((?:[^()]|\([^()]*\))*\)|\[[^\[\]]*\])"
)
PARTS = re.compile(r"\s*(?:==?|≈|≃|≅|→|->|⇒|:|;|\||#|//)\s*|\s*,\s+|\s+/\s+")
ABOUT = re.compile(  # in front of a number
    r"(?:ca|approx|env|circ?a|etwa|about|roughly|around|nom|typ|aprox)\b\.?\s*|[~≈≃约約@]\s*",
    re.IGNORECASE,
)
MARK = re.compile(r"\s*[?†‡§]+$|(?<=[\d°])\s*\*+$|\^[a-z*]$")
WORDS = re.compile(r"[^\d]*")
REMARK = re.compile(r"[^\W\d_]{3,}|[⊥⟂∥]")  # of which the number is no number of the arm
COUNTS = re.compile(r"off|zero|home|plus|minus|add|shift|bias|incl|without|excl|tool|^[+-]", re.I)
OFFSET = re.compile(r"(?:offset|zero|off\.?)\s*[:=]?\s*(?:of\s+)?(.+)", re.IGNORECASE)
WITH_OFFSET = re.compile(r"(\S.*?)[,;]?\s+(?:with\s+)?(?=(?:offset|zero)\b)(.+)", re.IGNORECASE)
DOMAIN = re.compile(  # of a joint: ∈ [-120, 120]
    r"\s*(?:∈|\bin\s*(?=\[)).*|(?:\s*\[|\s{2,})\s*-?\d[^\[\],]*[,;][^\[\],]*\]?$"
)
DOUBLED = re.compile(  # 210 (d1), d1 [210], -90 / -1.5708: no product, element or quotient
    r"[-+]?(?:\d{2,}|\d*\.\d+)\s*(?:mm|cm|m|°|deg)?\s*\(\s*[A-Za-z]\w*\s*\)|[A-Za-z]\w*\s+\[\s*[\d.]{2,}\s*\]"
    r"|[-+]?\d[\d.]*\s*(?:mm|cm|m|in|°|deg|rad)?\s+\(\s*[-+]?(?:[\d.]{2,}|\d+\s*[a-z°]+)[^()]*\)"
    r"|[-+]?[\d.]+°?\s*/\s*[-+]?\d\.\d{2,}(?:\s*rad)?"
)
QUOTIENT = re.compile(r"(\d+\.?\d*) / (\d+\.?\d*)")
NEAR = 2e-3


def is_doubled(text):
    """Whether a cell that is an expression as it stands says its number twice.

    Examples
    --------
    >>> is_doubled("210 (d1)"), is_doubled("2*(L1)")
    (True, False)
    """
    if two := QUOTIENT.fullmatch(text.strip()):
        one, other = float(two[1]), float(two[2])
        return other > 10 and 0.2 < one / other < 5  # 210 / 250 are two lengths
    return bool(DOUBLED.fullmatch(text.strip()))


def decorated(text, known=None):
    """The Value of a cell with more in it than an expression.

    Raises
    ------
    NoExpression
        Its parts say different numbers, or one of them cannot be read.

    Examples
    --------
    >>> decorated("L1 + L2 = 0.21 m"), decorated("210 (see note 1)").number
    (Value(number=0.21, letters={}, unit='m'), 210.0)
    >>> decorated("theta2 = q2 + 90").letters
    {'q2': 1.0}
    """
    outer, remarks = DOMAIN.sub("", text.strip().replace("**", "")), []
    while found := BEHIND.fullmatch(outer):
        outer = found["before"]
        remarks.append(found["inside"][1:-1].strip())
    if apart := WITH_OFFSET.fullmatch(outer):
        outer, remarks = apart[1], [*remarks, apart[2]]
    said = [one for part in PARTS.split(outer) if (one := _said(part, known)) is not None]
    shifts = []
    for remark in remarks:
        if offset := OFFSET.fullmatch(remark):
            shifts.append(evaluate(offset[1], known))
        elif not RANGE.fullmatch(remark):
            said += _beside(remark, known)
    return _agreed(said, shifts)


def _said(part, known):
    """The Value of a part; None of words without a number."""
    plain = MARK.sub("", ABOUT.sub("", part, count=1)).strip(" *`'\"")
    try:
        value = evaluate(plain, known)
        if not _moves(value) and any(share != 1 for share in value.letters.values()):
            raise NoExpression  # 20 flange
        return value
    except NoExpression:
        if WORDS.fullmatch(plain) and "+" not in plain:
            return None
        if re.fullmatch(r"[A-Za-z_][A-Za-z_\d]*", plain):
            return None
        raise


def _beside(remark, known):
    """The Values of a remark in brackets; none of words that are no number's."""
    try:
        return [one for part in PARTS.split(remark) if (one := _said(part, known)) is not None]
    except NoExpression:
        if COUNTS.search(remark) or not REMARK.search(remark):
            raise
        return []


def _agreed(said, shifts):
    """The one Value that the parts say."""
    moving = [one for one in said if _moves(one)]
    numbers = [one for one in said if not one.letters]
    named = [one for one in said if one.letters and not _moves(one)]
    if moving and not numbers:
        whole = [one for one in moving if one.number] or moving[:1]
        if shifts and len(whole) == 1 and not whole[0].number:
            whole = [added(whole[0], shifts[0])]
        elif shifts and abs(whole[0].number - shifts[0].number) > NEAR:
            raise NoExpression
        if len({(one.number, *one.letters) for one in whole}) == 1 and not named:
            return whole[0]
    alike = numbers and all(_same(numbers[0], other) for other in numbers[1:])
    if alike and not moving and not shifts:
        return next((one for one in numbers if one.unit), numbers[0])
    raise NoExpression


def _moves(value):
    """Whether it holds a joint's variable: theta2, q[1]."""
    return any(re.match(r"(?:theta|th|q|var)", name.lower()) for name in value.letters)


def _same(a, b):
    """Whether two numbers are one, in units of their own."""
    if a.unit in TO_METRES or b.unit in TO_METRES:
        factors = [
            [TO_METRES[one.unit]] if one.unit in TO_METRES else list(TO_METRES.values())
            for one in (a, b)
        ]
        return any(
            math.isclose(a.number * s, b.number * t, rel_tol=NEAR)
            for s in factors[0]
            for t in factors[1]
        )
    radians = [
        [math.radians(one.number)] * (one.unit != "rad") + [one.number] * (one.unit != "deg")
        for one in (a, b)
    ]
    return math.isclose(a.number, b.number, rel_tol=1e-9) or any(
        math.isclose(s, t, rel_tol=NEAR) for s in radians[0] for t in radians[1]
    )
