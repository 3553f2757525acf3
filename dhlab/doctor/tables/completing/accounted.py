"""What a text says beside the rows that were read from it, and that they must account for: how many
joints there are, what is added to joint angles, lists of as many numbers, a second table.
"""

import re

from ..dialects.flat import arrays_in
from ..language.roles import role_of
from ..meaning.columns import is_a_table
from .alike import repeats, same_arm, stands_for
from .zeros import require_zeros

__all__ = ["counts_in", "joints_said", "require_accounted", "speaks_of_sliding"]

NUMBERS = {
    word: k for k, word in enumerate("one two three four five six seven eight nine".split(), 1)
}
SAID = re.compile(
    rf"(?<![\w.])(\d|{'|'.join(NUMBERS)})[- _]?"
    r"(?:dofs?(?![a-z])|degrees?[- ]of[- ]freedom|ax[ei]s\b(?! \d)|joint(?:ed|s)?\b(?! \d)"
    r"|r\b(?= (?:arm|robot|manip)))",
    re.IGNORECASE,
)
DECLARED = re.compile(r"^[ \t]*syms\b[^\n]*|^[^\n=]*=\s*(?:\w+\.)?symbols?\([^\n]*", re.MULTILINE)
NUMBERED = re.compile(r"\b([A-Za-z]+)_?(\d)\b")
VARIABLE = re.compile(r"(?<![\w.])(?:q|theta|th)_?\{?(\d)\}?(?!\w)")
TURNED = re.compile(
    r"(?:[,=]|(?<!sin)(?<!cos)\()\s*-\s*(?:q|theta|th)(?:_?\d|[\[(]\d[\])])\s*(?=[,);\n])"
    r"|(?:q|theta|th|joint\w*)\w{0,8}(?:[\[(]\w+[\])])?\s*\.?\*\s*((?:\w+\.)*\w*(?:sign|dir)\w*)"
    r"|\b((?:\w+\.)*\w*(?:sign|dir)\w*)(?:[\[(]\w+[\])])?\s*\.?\*\s*\(?(?:q|theta|th|joint\w*)\b",
    re.IGNORECASE,
)
SLIDING = re.compile(
    r"\bjoint[ _]?\d[^\n,;]{0,20}\bprismatic\b"
    r"|\bprismatic\b(?!['\"] else)[^\n,;]{0,12}\b(?:joint )?[dq]?\d\b"
    r"|[#%/]\s*prismatic\s*$",
    re.IGNORECASE | re.MULTILINE,
)
SLIDES = re.compile(
    r"\bprismati\w+|\bstroke\b|\btelescop\w+|\b(?:sliding|linear) (?:joint|axis|rail)",
    re.IGNORECASE,
)
SLIDING_ARM = re.compile(r"\bscara\b|\b(?=R*PR*\b)[RP]{3,6}\b", re.IGNORECASE)
# joint 2 turns in the negative direction, q .* [1 -1 1]
BACKWARDS = re.compile(
    r"\b(?:joint|axis|motor)[ _]?\d\s*[:=]\s*-\s*(?=[,;\n]|$|1(?![.\d]))"
    r"|\b(?:opposite|negative|reversed?|inverted)\s+(?:\w+\s+)?(?:direction|sense)\b"
    r"(?!\s+(?:to|from|than|of)\s+(?:\w+\s+){0,2}(?:diagram|figure|drawing|picture|sketch|paper)\b)"
    r"|(?<![\w.])(?:q|theta|joint\w*)\s*\.?\*\s*[\w.(]*\[[\s,1]*-\s*1[\s,\]][^\n]{0,20}",
    re.IGNORECASE,
)


def joints_said(source):
    """The numbers of joints that words of the text speak of, as in ``6-DOF arm``.

    Examples
    --------
    >>> from ..evidence.source import source_of
    >>> joints_said(source_of("a 7-DoF arm"))
    {7}
    """
    said = {NUMBERS.get(word.lower()) or int(word) for word in SAID.findall(source.text)}
    return {n for n in said if n > 1}


def counts_in(source):
    """How many joints the text speaks of, in words or by a whole set of variables, in order."""
    named = _variables(source) - {0}
    whole = len(named) > 1 and max(named) == len(named)
    return tuple(sorted(joints_said(source) | ({len(named)} if whole else set())))


def _variables(source):
    """The numbers of joint variables in the text, without those that only a list of symbols holds,
    and others of their number with them: ``syms th1 … th9 d1 … d9`` of an arm with 7 joints.
    """
    used = set(NUMBERED.findall(DECLARED.sub("", source.code)))
    spare: dict = {}
    for name, k in set(NUMBERED.findall(" ".join(DECLARED.findall(source.code)))) - used:
        spare.setdefault(int(k), set()).add(role_of(name)[0])
    numbers = {int(k) for k in VARIABLE.findall(source.code)}
    return {k for k in numbers if not {"theta", "d", "a"} <= spare.get(k, set())}


def speaks_of_sliding(source):
    """Whether the text calls its "arm" one of which a joint slides, or has some "word" of one.

    Examples
    --------
    >>> from ..evidence.source import source_of
    >>> speaks_of_sliding(source_of("a SCARA")), speaks_of_sliding(source_of("a stroke of 200 mm"))
    ('arm', 'word')
    """
    if SLIDING_ARM.search(source.text):
        return "arm"
    return "word" if SLIDES.search(source.text) else ""


def require_accounted(table, source, others=()):
    """Nothing that the text says of the rows may be lost.

    Parameters
    ----------
    table : Pasted
    source : Source
    others : iterable of Pasted
        What other readers make of the text.

    Raises
    ------
    ValueError
        One question: what the rows leave out.
    """
    _require_in_order(table)
    if table.form and not table.form.startswith("calls of"):
        return
    _require_joints(table, source)
    if table.roles is not None:
        require_zeros(table, source)
        _require_sliding(table, source)
    _require_senses(table, source)
    for other in others:
        same = same_arm(table, other) or repeats(other, table) or stands_for(other, table)
        if (
            len(other.rows) >= len(table.rows) > 1
            and other.roles
            and is_a_table(other)
            and not same
        ):
            raise ValueError(
                f"recognise_table: expected one table, found two of {len(table.rows)} and"
                f" {len(other.rows)} rows with different numbers; which one is meant? Leave the"
                " other out"
            )


def _require_in_order(table):
    """Rows stand from the base to the tool, and each joint has a variable of its own."""
    families: dict = {"": [int(label) for label in table.labels if str(label).isdigit()]}
    for row in table.rows:
        moving = next((cell for cell in row if cell.variable in ("theta", "q", "d")), None)
        named = re.fullmatch(r"([A-Za-z]+)_?\[?(\d+)\]?", moving.letters[0][0]) if moving else None
        if named:
            families.setdefault(named[1], []).append(int(named[2]))
    for name, numbers in families.items():
        again = next((k for k in numbers if numbers.count(k) > 1), None)
        if again is not None and name:
            raise ValueError(
                f"recognise_table: expected a variable of its own in each row, found {name}{again}"
                f" in {numbers.count(again)} rows; are the joints coupled? Give one of them another"
                " name, or leave its row without a variable"
            )
        if again is None and numbers != sorted(numbers):
            raise ValueError(
                "recognise_table: expected the rows from the base to the tool, found"
                f" {', '.join(f'{name}{k}' for k in numbers[:9])}; in which order do the links"
                " follow each other? Sort the rows"
            )


def _require_joints(table, source):
    n = len(table.rows)
    said = joints_said(source)
    most = max(_variables(source), default=0)
    if (said and n < min(said)) or n < most:
        told = f"{min(said)} joints" if said and n < min(said) else f"joint {most}"
        raise ValueError(
            f"recognise_table: the text speaks of {told}, and {n} rows were read; where are the"
            " others? Paste all rows, one form for all"
        )


def _require_senses(table, source):
    """A joint that counts backwards in the program must do so in the table."""
    if any(sign < 0 for sign in table.signs) or any(c.sign < 0 for row in table.rows for c in row):
        return
    if told := BACKWARDS.search(source.text):
        raise ValueError(
            f"recognise_table: the text says {told[0][:60]!r}, and every joint of the rows counts"
            " along its axis; which joint is turned? Write its variable as -q"
        )
    for match in TURNED.finditer(source.code):
        name = match[1] or match[2]
        values = arrays_in(source).get(name.split(".")[-1]) if name else None
        if not name or values is None or any(value.number < 0 for value, _ in values):
            raise ValueError(
                f"recognise_table: the text has {match[0].strip(' ,=(')[:40]!r}, and every joint of"
                " the rows counts along its axis; which joint is turned? Write its variable as -q"
            )


def _require_sliding(table, source):
    """A joint that the text calls prismatic must slide."""
    sliding = "P" in table.kinds or any(role == "sigma" for role in table.roles)
    letters = [cell for row in table.rows for cell in row if cell.variable in ("d", "q")]
    found = None if sliding or letters else SLIDING.search(source.text)
    if found:
        raise ValueError(
            f"recognise_table: the text says {found[0].strip()[:40]!r}, and no row slides; which"
            " one is it? Write its variable, as d3, into the row"
        )
