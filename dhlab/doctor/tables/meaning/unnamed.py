"""Columns of a table whose headings no word of a parameter names: the joint variable, the last of
the four, a name of the row, something apart, or the question what they are.
"""

import re
from itertools import pairwise

from ..cells import cell_or_none, plain
from ..language.roles import ROLES, unit_in
from ..language.words import KINDS
from .beside import APART
from .columns import kind_of_column

__all__ = ["explained"]

WORDS = re.compile(r"[^\W\d_]{4,}(?: ?[-/(&]? ?[^\W\d_]+\)?)*")  # shoulder, flange (fixed)
COUNTED = re.compile(r"(?:joint|link|axis|motor|servo|frame)_?\d+", re.IGNORECASE)
NUMBERED = re.compile(r"[^\W\d]{4,}_?\d+")
UNITS = ("mm", "cm", "m", "in", "deg", "rad")
UNIT = re.compile(r"\s*[\[(,/]\s*(?:mm|cm|m|in|deg|rad|°)\s*[\])]?\s*$")
FLAGS = {"0", "1", "-1", "yes", "no", "true", "false", "y", "n"}
ONE_LETTER = {  # what a length, or the twist, is called where its usual letter has no column
    "length": re.compile(r"(?:[lsbhp]|len|link)[\W_]*[ijkn]?[\W_]*"),
    "angle": re.compile(r"(?:[βγδτψλ]|beta|gamma|delta|tau|psi|phi|lambda)[\W_]*[ijkn]?[\W_]*"),
}
# a fifth number that may count: it turns, moves or is a length, or has one letter for a name
COUNTS = re.compile(
    r"off|zero|null|cero|bias|shift|delta|corr|calib|adjust|add|plus|ref|rest|sign|dir|sens|rever"
    r"|inver|flip|polar|trim|coupl|depend|mimic|scale|factor|mult|len|long|lang|läng|height|stroke|dist|tool|ext|rot|trans"
    r"|angle|winkel|angul|theta|alpha|beta|gamma|phi|psi|eps|偏|零|角|长|[+±]|^\w(?:[\W_]|\d|$)",
    re.IGNORECASE,
)


def _may_count(name, said):
    """Whether a column beside theta, d, a and alpha may change the arm, by its name, or because it
    says yes or no of each row.
    """
    words = {plain(text).strip("+*` ") for text in said}
    flags = len(words) > 1 and words <= FLAGS
    return bool(flags or COUNTS.search(plain(name)) or unit_in(name) in UNITS)


def explained(roles, heading, rows):
    """(roles, notes) where columns without a known name hold numbers: the joint variable, something
    apart, or a question. Beside all four a name that says nothing of angles and lengths is passed
    over.

    Parameters
    ----------
    roles : tuple of str or None
    heading : list of str
    rows : list of list
        The cells of each line.

    Raises
    ------
    ValueError
        A column of numbers has a name that says nothing.

    Examples
    --------
    >>> explained(("label", None, "a", "alpha", "d"), ["i", "var", "a", "al", "d"], [list("1") +
    ...     ["q1", "0", "90", "0.1"]])
    (('label', 'theta', 'a', 'alpha', 'd'), ('the column var is taken for theta',))
    """
    roles, notes = list(roles), []
    rows = [cells for cells in rows if len(cells) == len(roles)]
    for k in [*range(1, len(roles)), 0]:  # what names the rows is known by the others
        role, name = roles[k], heading[k]
        said = [str(cells[k]) for cells in rows if str(cells[k])[:1] not in ("'", '"')]
        found = [one for text in said if (one := cell_or_none(text)) is not None]
        again = role == "label" and "label" in roles[:k]  # one column names the rows
        again = again and all(cell.is_constant for cell in found)
        if (role is not None and not again) or 2 * len(found) <= len(rows) or _counts(found):
            continue
        name = str(name).strip(" *$`") or f"number {k + 1}"
        letters = {letter for cell in found for letter, _ in cell.letters}
        four = _are_four(roles)
        if k == 0 and letters and (four or all(COUNTED.fullmatch(letter) for letter in letters)):
            roles[k] = "label"
        elif letters and "theta" not in roles:
            roles[k] = "theta"
            notes.append(f"the column {name[:20]} is taken for theta")
        elif letters and letters <= _letters(rows, k) | _plain(roles, rows):
            continue  # the variable is named once more
        elif APART.search(name):
            notes.append(f"the column {name[:20]} was left out")
        elif all(_is_a_word(text) for text in said if text.strip(" -")):
            roles[k] = "label"
        elif {*ROLES} <= {*roles} and all(NUMBERED.fullmatch(text.strip(" *`")) for text in said):
            roles[k] = "label"  # Revolute_3
        elif meant := _last_of_four(roles, name, found):
            roles[k] = meant
            notes.append(f"the column {name[:20]} is taken for {meant}")
        elif four and not _may_count(name, said):
            notes.append(f"the column {name[:20]} was left out")
        elif any(cell.value or cell.letters for cell in found):
            raise ValueError(
                f"recognise_table: expected columns theta, d, a, alpha, found a column of numbers"
                f" {name[:20]!r}; what is it? Give it one of these names, or leave it out"
            )
    return tuple(roles), tuple(notes)


def _are_four(roles):
    """Whether theta, alpha and two lengths have their columns."""
    return {"theta", "alpha"} <= {*roles} and len({"d", "a", "r"} & {*roles}) > 1


def _last_of_four(roles, name, cells):
    """The one of d, a and alpha that has no column yet, where a name of one letter and the numbers
    fit it: l for a, s for d; None of others.
    """
    missing = {*ROLES, "r"} - {*roles}
    missing = missing - {"r"} if "r" in missing else set()
    role = missing.pop() if len(missing) == 1 else "theta"
    kind = "angle" if role == "alpha" else "length"
    fits = role != "theta" and kind_of_column(cells) in (kind, "any")
    return role if fits and ONE_LETTER[kind].fullmatch(UNIT.sub("", plain(name))) else None


def _is_a_word(text):
    """Whether a cell is a word or two, and no kind of joint."""
    return bool(WORDS.fullmatch(text)) and plain(text) not in KINDS


def _counts(cells):
    """Whether the numbers are those of links, one after the other."""
    values = [cell.value for cell in cells]
    return all(cell.is_constant for cell in cells) and all(
        after - before == 1 for before, after in pairwise(values)
    )


def _letters(rows, without):
    """The letters of all columns but one."""
    cells = (cell_or_none(str(cell)) for row in rows for k, cell in enumerate(row) if k != without)
    return {letter for cell in cells if cell is not None for letter, _ in cell.letters}


def _plain(roles, rows):
    """The variables that a column of numbers leaves to be understood."""
    return {f"theta{k}" for k in range(len(rows) + 2)} if "theta" in roles else set()
