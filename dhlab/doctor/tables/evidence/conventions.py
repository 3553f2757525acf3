"""For which matrix a text's rows are: by the link matrix that it computes, by elementary moves, by
definitions in words.
"""

import re

from ..language.roles import role_of
from .matrix.products import multiplied_moves
from .matrix.scenes import nested_moves

__all__ = ["convention_in", "defined_in", "has_formula"]

# z_{i-1}, Z(i), x_i, xi-1
AXIS = {
    name: re.compile(rf"(?<![a-z\\]){name}[ _]?[({{\[]*[ijkn]((?:\s?[-+]\s?1)?)[)}}\]]*(?![a-z])")
    for name in "zx"
}
MEASURED = re.compile(
    r"about|along|around|measured|绕|沿|um\b|entlang|alrededor|a lo largo|autour|selon"
)
NAMED_MOVE = r"\b(?:rot|rotation|trans|transl|translation|r|t)_?[xz]\b"
BARE = re.compile(  # Rz * Tz * Tx * Rx
    rf"{NAMED_MOVE}(?:\s*(?:[*@.]|\bdot\b|[()])+\s*{NAMED_MOVE}){{3}}", re.IGNORECASE
)
MOVES = re.compile(
    r"(?:\brot(?:ate|ation)?|\br|\btrot|\bt|\btrans(?:late|lation|l)?|\bdh)_?([xyz])\b\s*\(\s*([^()]*)\)"
    r"|\brot\w*\s*\(\s*['\"]?([xyz])['\"]?\s*,\s*([^()]*)\)"
    r"|\btrans(?:l|lation|late)?\s*\(\s*([^(),]*),([^(),]*),([^(),]*)\)"
    r"|\btrans\w*\s*\(\s*['\"]?([xyz])['\"]?\s*,\s*([^(),]*)\)",
    re.IGNORECASE,
)
# an entry of a link matrix: sin(theta)*cos(alpha), sin theta_i cos alpha_i-1, st*ca
OF = r"(?<![a-z])(?:cos|sin|[cs])[fd]?[ _]*\(? *(?:\w+\.)*(?:{})\w{{0,4}}(?:-1|\[[^\[\]]*\])?[ )]*"
TURN, TWIST = OF.format(r"theta|th|t|q"), OF.format(r"alpha|alfa|alp|al|a")
FORMULA = re.compile(rf"{TURN}\*? ?(?:\w+\.)?{TWIST}|{TWIST}\*? ?(?:\w+\.)?{TURN}", re.IGNORECASE)


def has_formula(text):
    """Whether the text multiplies a cosine or sine of theta by one of alpha, as link matrices do.

    Examples
    --------
    >>> has_formula("-sin(theta[i])*cos(alpha[i])"), has_formula("cos(theta1)*cos(theta2)")
    (True, False)
    """
    return FORMULA.search(text) is not None


def defined_in(source):
    """ "craig" or "standard" by the definitions of a or alpha in words: along or about which x axis
    they are measured between which z axes; "" where the text defines neither, or both ways.

    Examples
    --------
    >>> from .source import source_of
    >>> defined_in(source_of("a: distance from z_{i-1} to z_i along x_i"))
    'standard'
    """
    found = set()
    for line in source.text.lower().split("\n"):
        z, x = ({_index(k) for k in AXIS[name].findall(line)} for name in "zx")
        if len(z) == 2 and len(x) == 1 and max(z) - min(z) == 1 and MEASURED.search(line):
            found.add({min(z): "craig", max(z): "standard"}.get(*x, ""))
    return found.pop() if len(found) == 1 else ""


def _index(text):
    """The index of an axis, counted from i."""
    digits = re.sub(r"[^-+\d]", "", text)
    return int(digits) if digits.lstrip("+-").isdigit() else 0


def convention_in(source):
    """(convention, why) of the link matrix that the text itself computes, else of the elementary
    moves that it names; None without one.
    """
    found = source.link_matrix
    computed = found.convention if found else ""
    if computed and computed == source.convention:  # a formula in a comment may be wrong
        return computed, "by the matrix in it"
    for line in re.sub(r"\s*\n\s*(?=[*@])|(?<=[*@])\s*\n\s*", " ", source.text).split("\n"):
        if moves := _of_moves(line):
            return moves, "by the order of the elementary moves in it"
    if computed:
        return computed, "by the matrix in it"
    if multiplied := _by_moves(multiplied_moves(source.code)):
        return multiplied, "by the product of its own matrices"
    nested = _by_moves(nested_moves(source.text))
    return (nested, "by the order of its groups") if nested else None


def _of_moves(line):
    """Rz Tz Tx Rx is the standard row, Rx Tx Rz Tz Craig's."""
    bare = BARE.search(line)
    if bare:
        words = re.findall(r"([rt])\w*?([xz])\b", bare[0].lower())
        return _by_moves([kind.upper() + axis for kind, axis in words])
    if line.count("(") < 3:
        return None
    found = []
    for match in MOVES.finditer(line[:400]):
        axis = (match[1] or match[3] or match[8] or "").lower()
        turns = match[0].lower().startswith(("rot", "r", "trot"))
        if match[5] is not None:
            held = [k for k in range(3) if match[5 + k].strip() not in ("0", "0.0", "")]
            axis, turns = ("xyz"[held[0]] if len(held) == 1 else ""), False
        argument = match[2] or match[4] or match[9] or "d"
        if role_of(re.sub(r"_?\d+$", "", argument.split(",")[0]))[0] is None and match[5] is None:
            return None
        found.append(("R" if turns else "T") + axis)
    return _by_moves(found)


def _by_moves(found):
    if sorted(found) != ["Rx", "Rz", "Tx", "Tz"]:
        return None
    return {("Rz", "Tz"): "standard", ("Rx", "Tx"): "craig"}.get(tuple(sorted(found[:2])))
