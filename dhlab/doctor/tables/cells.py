"""One cell of a pasted table: a number, π/2, 90°, a joint variable with an offset, a letter. Parsed
with a small grammar, never evaluated.
"""

import math
import re
from dataclasses import dataclass
from functools import lru_cache
from itertools import product

from .language.decorated import decorated, is_doubled
from .language.expressions import NoExpression, Value, evaluate
from .language.letters import KEPT, plain, unified

__all__ = [
    "BESIDE",
    "FOOTNOTE",
    "Cell",
    "cell_or_none",
    "read_cell",
    "cell_of",
    "kind_of_letter",
    "plain",
]

LONGEST = 200
TWO_JOINTS = re.compile(r"\bprismatic\b.*\brevolute\b|\brevolute\b.*\bprismatic\b", re.IGNORECASE)
TURNED = re.compile(  # theta2 (reversed)
    r"^[^-−]*(?:θ|theta|\bq)[₀-₉_\d].*\b(?:revers|invert|flip|mirror|opposit)", re.IGNORECASE
)
BESIDE = re.compile(  # theta2 (-90), where q(2) is an element
    r"((?:theta|th|q)_?\d+|variable|var)\s*\(\s*([-+]?(?:\d[\d.]*°?|\d*\*?pi(?:/\d)?)(?:[-+][A-Za-z]\w*)?)\s*\)"
)
NAMED_NUMBER = re.compile(  # L_ARM (0.146), d1 (290 mm), and no element L(2)
    r"([LDAHR]\w*)(?:\s*\(\s*([-+]?\d*\.\d+\s*(?:mm|cm|m)?)\s*\)|\s+\(\s*([-+]?\d{2,}\s*(?:mm|cm|m)?)\s*\))",
    re.IGNORECASE,
)
RANGE = re.compile(  # theta1 (-120, 120); atan2(0.1, 0.2) is another thing
    r"^((?:theta|th|q)_?\d+\*?)\s*\(\s*[-+]?\d[\d.]*°?\s*[,;~]\s*[-+]?\d[\d.]*°?\s*\)$"
)
TOLERANCE = re.compile(  # 0.200 ± 0.001 mm
    r"^([-+]?\d[\d.,]*)\s*(?:±|\+/-)\s*\d[\d.,]*(\s*(?:mm|cm|m|°|deg|rad)?)$"
)
MEASURED = re.compile(r"[LDAH]_?[A-Za-z]{1,12}\s*=\s*(?=[-+]?\d*\.?\d+\s*(?:mm|cm|m)$)")
FOOTNOTE = re.compile(  # 150¹, 150 [1], 150†, 150<sup>1</sup>; ten to a power is none
    r"^(?![-+]?10\D)([-+]?\d[\d.,]*(?: ?(?:mm|cm|m|°|deg|rad))?)"
    r"(?:[¹²³⁴⁵⁶⁷⁸⁹]|[†‡§¶]+| ?\[\d\]|_\d| \(\d\))$"
)
VARIABLE = re.compile(  # theta1 (variable) - 90, variable theta1, theta1(t)
    r"(?<=\w)\s*\((?:(?:joint )?var(?:iable|\.)?|t)\)|^(?:joint )?var(?:iable|\.)?\s+(?=\w*\d)"
    r"|(?<=^var)\.$|(?<=^joint)\s+(?=\d$)|(?<=^joint) angle\s+(?=\d$)",
    re.IGNORECASE,
)
BOLD = re.compile(r"(?<![\w)])\*\*([^*]+)\*\*(?!\w)")  # a part of the cell
BOTH = re.compile(  # pi/2 (90°) and -90° (-pi/2)
    r"(?<![\w.])((?:[\d.]*\*?pi(?:/\d+)?|\d[\d.]*)\s*(?:rad|°)?|\(+pi\)/\(\d\)+)\s*"
    r"\(\s*((?:[-+]?[\d.]*\*?pi(?:/\d+)?|[-+]?\d[\d.]*)\s*(?:rad|°)?)\s*\)$"
)
KINDS = (
    ("alpha", r"(?:alpha|alfa|alp|al)\d*"),
    ("theta", r"(?:theta|th|t|tt|tht)\w{0,2}?(?:\d+|\[.*\]|[ijk])?"),
    (
        "q",
        r"(?:q\w{0,3}?|var|variable|joints?|ja?|phi|conf\w*|angles?|jointangles?)\d*(?:\[.*\])?|q[ijk]|x\d",
    ),
    ("d", r"d(?:\d+|[ijk]|\[.*\])?"),
    ("a", r"[ar](?:\d+|[ijk]|\[.*\])?"),
    ("length", r"[lh]\d*|(?:link|len|length)\d+"),
)


@dataclass(frozen=True)
class Cell:
    """What a cell says: ``value`` (the constant part), the letters in it with their factors, and
    the unit it names. ``text`` is it as written.
    """

    value: float
    letters: tuple = ()
    unit: str = ""
    text: str = ""

    @property
    def is_constant(self):
        """Whether no letter stands in it."""
        return not self.letters

    @property
    def variable(self):
        """What its letter looks like: "theta", "q", "d", "a", "alpha", "length" or "?"; "" without
        one.
        """
        return kind_of_letter(self.letters[0][0]) if self.letters else ""

    @property
    def sign(self):
        """How its letter counts."""
        return -1 if self.letters and self.letters[0][1] < 0 else 1


def kind_of_letter(name):
    """What a letter usually stands for, by its name.

    Examples
    --------
    >>> kind_of_letter("theta1"), kind_of_letter("q[2]"), kind_of_letter("L1")
    ('theta', 'q', 'length')
    """
    low = name.lower()
    return next((kind for kind, names in KINDS if re.fullmatch(names, low)), "?")


def cell_of(value: Value, text=""):
    """The Cell of a Value."""
    return Cell(value.number + 0.0, tuple(value.letters.items()), value.unit, text)


def read_cell(text, known=None, loosely=False):
    """The Cell in a text; ``known`` says what letters stand for. Read ``loosely``, there may be
    more in it than an expression, as in ``L1 = 0.2 (see note 1)``.

    Raises
    ------
    ValueError
        Expected what, found what.

    Examples
    --------
    >>> read_cell("-π/2").value, read_cell("90°").unit
    (-1.5707963267948966, 'deg')
    >>> read_cell("θ2* - 90").value, read_cell("-q3").sign
    (-90.0, -1)
    """
    if len(text) > LONGEST:
        raise ValueError(
            f"expected a number or a joint variable, found a text of {len(text)} characters; a cell"
            " holds one value"
        )
    if TWO_JOINTS.search(text):
        raise ValueError(
            f"expected one joint in a row, found {text.strip()[:60]!r}; which of them moves first?"
            " Write a row for each"
        )
    if TURNED.search(text):
        raise ValueError(
            f"expected a joint variable with its sign, found {text.strip()[:60]!r}; does the joint"
            " count against its axis? Write -q or q"
        )
    try:
        if loosely and is_doubled(unified(text)):
            return cell_of(decorated(unified(text), known), text.strip())
        try:
            written = _trimmed(unified(text))
            return cell_of(_once(written, evaluate(written, known)), text.strip())
        except NoExpression:
            if not loosely:
                raise
        return cell_of(decorated(unified(text), known), text.strip())
    except NoExpression:
        shown = text.strip() if len(text.strip()) <= 40 else text.strip()[:37] + "…"
        expected = "a number, a multiple of pi, or a joint variable such as q2 - 90"
        raise ValueError(
            f"expected {expected}, found {shown!r}; write it as one of these"
        ) from None


def _once(written, value):
    """The Value of a cell; the zero of its variable counts once where the text says that of the
    variable which the row says itself: ``q2: theta2 - pi/2`` beside ``q2 - pi/2``.
    """
    if not value.letters or not value.number:
        return value
    try:
        own = evaluate(written)
    except NoExpression:  # a letter of which a root is taken
        return value
    names = {kind_of_letter(letter) for letter in own.letters}
    if not names or names - {"theta", "q"} or not own.number:
        return value
    return own if abs(value.number - 2 * own.number) < 1e-9 else value


@lru_cache(KEPT)
def cell_or_none(text):
    """The Cell in a text, None where there is none.

    Examples
    --------
    >>> cell_or_none("90°").value, cell_or_none("link length")
    (90.0, None)
    """
    try:
        return read_cell(text)
    except ValueError:
        return None


def _once_in_one_unit(text):
    """A cell without the second of two angles that are the same one: ``pi/2 (90°)``.

    Raises
    ------
    NoExpression
        They are two.
    """
    found = BOTH.search(text)
    if not found:
        return text
    one, other = (evaluate(part) for part in found.groups())
    minus = -1 if text[: found.start()].rstrip().endswith("-") else 1
    angles = [(one.number * minus, one.unit), (other.number, other.unit)]
    in_radians = ([n if u == "rad" else math.radians(n)] + [n] * (u == "") for n, u in angles)
    if not any(math.isclose(*pair, rel_tol=1e-3) for pair in product(*in_radians)):
        raise NoExpression(text)
    return text[: found.end(1)]


def _trimmed(text):
    """Without what decorates a cell: quotes, Markdown's stars, `(var)`, a decimal comma."""
    text = text.strip().strip("`'\"").strip()
    bold = re.fullmatch(r"\*\*(.+)\*\*|__(.+)__|\*([^*]+)\*|_([^_]+)_", text)
    text = next(part for part in bold.groups() if part) if bold else text
    text = VARIABLE.sub("", BOLD.sub(r"\1", _once_in_one_unit(FOOTNOTE.sub(r"\1", text))))
    text = re.sub(r"(?<=\w)\s*[(\[]\s*±[^()\[\]]*[)\]]$", "", text)  # theta1 (±180°)
    text = RANGE.sub(r"\1", text)
    text = TOLERANCE.sub(r"\1\2", text)
    text = re.sub(rf"^{BESIDE.pattern}$", r"\1 + (\2)", text)
    text = re.sub(r"(?<=.)\s*\((?:var|offset)\)|(?<=[^-+\s])\s+\([^\d()*+/=°]+\)$", "", text)
    text = re.sub(r"^([-+]?\d*|\w+ ?[-+] ?\d+),(\d+)(?=\D|$)", r"\1.\2", text)
    text = re.sub(r"^[~≈]\s*(?=[-+]?[\d.])", "", text)  # as somebody measured it
    if beside := NAMED_NUMBER.fullmatch(text):
        text = beside[2] or beside[3]  # the number of a length or twist
    named = re.match(r"([A-Za-z]\w*)\s*=\s*(?=[-+.\w(])", text)
    if named and kind_of_letter(named[1].replace("_", "")) in ("d", "a", "alpha", "length"):
        text = text[named.end() :]  # d1 = 0.5 in a cell is 0.5
    text = MEASURED.sub("", text)  # L_hh = 0.0255 m
    return re.sub(r"^=\s*", "", text)
