"""What a program does with the rows that it holds, where that makes another arm of them: a column
that it replaces, subtracts or turns round, a number that its comment gives otherwise.
"""

import re
from dataclasses import replace

from ..dialects.called.functions import own_calls, places_in
from ..dialects.flat import arrays_in
from ..language.expressions import key

__all__ = ["with_uses"]

JOINT = r"(?:q|thetas?|th|joint\w*|angles?)\w{0,7}"
ONE = rf"{JOINT}\s*[\[(]\s*\w+\s*[\])]"  # of any joint: q[i]
# DH[:, 0] = q, row.theta = q[i], DH(i, 1) = q(i)
REPLACED = re.compile(
    rf"^[ \t]*[A-Za-z]\w*(?:\[[^\]\n]*\]\[\w+\]|\[[^\]\n]*,\s*\w+\]|\([^()\n]*,\s*\d\)"
    rf"|(?:\[\w+\])?(?:\.|->)theta\w*)\s*=\s*(?:{ONE}|q)\s*;?\s*$",
    re.MULTILINE,
)
SUBTRACTED = re.compile(
    rf"(?<![\w.]){JOINT}(?:[\[(]\w+[\])])?\s*-\s*(?:\w+(?:\[\w+\])?(?:\.|->))?"
    r"\w*(?:off(?:set)?s?|zeros?|bias|theta_?0|dh)\w*(?:[\[(][^\])\n]*[\])])*",
    re.IGNORECASE,
)
TURNED = re.compile(r"-\s*[A-Za-z]\w*(?:[\[(][^\])\n]*[\])]|(?:\.|->)\w+)*")
MEASURED = re.compile(  # no link 1 mm
    r"(?<![\w.])(?<!link )(?<!joint )(?<!axis )(?<!frame )(\d+\.?\d*)\s*(?:mm|cm|m)\b(?!\s*/)",
    re.IGNORECASE,
)
NAMED = re.compile(r"\s*(?:[\w*]+\s+)*([A-Za-z_]\w*)\s*=\s*([^;,=#]+)")


def with_uses(table, source):
    """The table, ``replaced`` where the program puts the joints' values in the place of theta.

    Parameters
    ----------
    table : Pasted
        Rows that do not come from the calls themselves.
    source : Source

    Raises
    ------
    ValueError
        One question: what else the program does, and whether it counts.
    """
    told = _of_calls(source) if not table.form else {}
    if told.get("lying") and "a column for each link" not in table.why:
        raise ValueError(
            f"recognise_table: the program takes {told['lying'][:60]} for one link, a parameter"
            " from each row; which column is which link? Write a row for each link"
        )
    if told.get("turned"):
        raise ValueError(
            f"recognise_table: the program takes {told['turned'][:40]} of each row, with a minus,"
            " and the rows are read without it; does it count? Write the numbers as they are used"
        )
    zeros = [
        cell.text
        for row in table.rows
        for cell, role in zip(row, table.roles or ())
        if role in ("theta", "offset") and cell.value
    ]
    if zeros and not table.form:
        replaced = REPLACED.search(source.code)
        left = (replaced and replaced[0].strip()) or told.get("replaced")
        subtracted = SUBTRACTED.search(source.code)
        if left:
            note = f"the program puts the joint's value in the place of theta: {left[:40]}"
            table = replace(table, replaced=True, notes=(*table.notes, note))
        elif subtracted and not any(note.endswith("is added to theta") for note in table.notes):
            raise ValueError(
                f"recognise_table: the rows have {zeros[0][:20]} in theta, and the program has"
                f" {subtracted[0][:40]}; is it subtracted? Write the zeros as they are added"
            )
    _require_as_commented(table, source)
    return table


def _of_calls(source):
    """What calls of the text's own link function do with theta, and with the other columns."""
    found: dict = {}
    arrays = arrays_in(source)
    for call, roles in own_calls(source):
        texts = [item.text for item in call.items]
        if "theta" not in roles:
            continue
        angle = texts[roles.index("theta")]
        named = re.match(r"\w+", angle)
        own = named and named[0] in arrays
        others = [text for text, role in zip(texts, roles) if role in ("d", "a", "alpha")]
        if re.fullmatch(ONE, angle) and not own and any("[" in one or "(" in one for one in others):
            found.setdefault("replaced", f"{call.name}({angle}, …)")
        if places_in(call):
            found.setdefault("lying", ", ".join(texts))
        turned = next((one for one in others if TURNED.fullmatch(one)), None)
        if turned:
            found.setdefault("turned", turned)
    return found


def _require_as_commented(table, source):
    """A length that the rows use is what the comment behind it says, whatever its unit."""
    words = {key(w) for row in table.rows for c in row for w in re.findall(r"[A-Za-z_]\w*", c.text)}
    lines = source.code.split("\n")
    for number, comment in source.comments:
        said = MEASURED.findall(comment)
        named = NAMED.match(lines[number - 1]) if number <= len(lines) else None
        value = source.value(named[2].strip()) if named and key(named[1]) in words else None
        if len(said) != 1 or value is None or value.letters or not value.number:
            continue
        ratio = float(said[0]) / abs(value.number)
        if not any(abs(ratio / 10.0**k - 1) < 0.01 for k in range(-3, 4)):
            raise ValueError(
                f"recognise_table: line {number}: the program has {named[1]} ="
                f" {named[2].strip()[:20]}, and the comment behind it {comment[:40]!r}; which one"
                " counts? Leave the other out"
            )
