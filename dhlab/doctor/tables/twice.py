"""Two tables of one text that are one: in letters, and again with numbers."""

from .completing.alike import stands_for
from .take_apart import take_apart

__all__ = ["without_letters"]


def without_letters(parts):
    """A text without its first table, where the second one is the same with numbers for its
    letters; "" where it is not.
    """
    try:
        letters, numbers = map(take_apart, parts)
    except ValueError:
        return ""
    if isinstance(letters, list) or isinstance(numbers, list) or not letters.lines:
        return ""
    lines = parts[0].split("\n")
    first, last = letters.lines
    rest = [*lines[: first - 1], *[""] * (last - first + 1), *lines[last:], parts[1]]
    return "\n".join(rest) if stands_for(letters, numbers) else ""
