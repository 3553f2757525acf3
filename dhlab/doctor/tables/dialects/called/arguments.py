"""What stands in the brackets of one link: pairs of name and text, numbers in an order, limits."""

import re

from ...cells import cell_of, read_cell
from ...language.brackets import cells_in, keyword
from ...language.roles import role_of

__all__ = ["by_order", "cell_in", "limits_in", "pairs_in"]

FLAGS = ("modified", "standard", "revolute", "prismatic", "flip")
QUOTED = re.compile(r"['\"]([\w .-]+)['\"]")


def pairs_in(items):
    """(name, text) of what is named, as keywords or as MATLAB's pairs; and the rest."""
    pairs, loose, at = [], [], 0
    of_one = [QUOTED.fullmatch(text) for text in items]
    numbers = len(items) > 3 and not any(map(keyword, items[1:]))
    if sum(map(bool, of_one)) == 1 and of_one[0] and (numbers or not role_of(of_one[0][1])[0]):
        loose, at = [items[0]], 1  # the link's name: DHLink("shoulder", 0, 40, 0, 90)
    while at < len(items):
        text = items[at]
        named = keyword(text) if text[:1] not in "'\"[" else None
        word = re.fullmatch(r"['\"](\w+)['\"]", text)
        if named:
            pairs.append(named)
        elif word and at + 1 < len(items) and word[1].lower() not in FLAGS:
            pairs.append((word[1], items[at + 1]))
            at += 1
        else:
            loose.append(text)
        at += 1
    return pairs, loose


def by_order(texts, order, source, number):
    fewest = 3 if order and "theta" not in order.split()[:3] else 4
    if not fewest <= len(texts) <= 6:
        raise ValueError(
            f"recognise_table: link {number}: expected four to six numbers, found {len(texts)};"
            " write theta, d, a, alpha or name them"
        )
    return {role: cell_in(text, source, number, role) for role, text in zip(order.split(), texts)}


def cell_in(text, source, number, role):
    try:
        return read_cell(text.strip(" '\""), source.known)
    except ValueError as error:
        raise ValueError(f"recognise_table: link {number}, {role}: {error}") from None


def limits_in(text, source):
    """(low, high) of "[-pi, pi]" or "[-120 120]*deg"; None when it is something else."""
    found = re.match(r"[\[({](.*)[\])}]\s*(\*.*)?$|np\.\w+\(\[(.*)\]\)", text.strip(), re.DOTALL)
    if not found:
        return None
    parts = cells_in(found[1] or found[3] or "")
    values = [source.value(f"({part}){found[2] or ''}") for part in parts]
    if len(values) != 2 or any(value is None or value.letters for value in values):
        return None
    return tuple(cell_of(value) for value in values)
