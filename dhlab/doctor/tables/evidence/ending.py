"""Where a text was cut off: within a row, or within the brackets that hold the rows."""

import re

from ..language.brackets import left_open

__all__ = ["require_whole"]

FORMULA = re.compile(r"(?<![a-z])(?:cos|sin|[cs]_?(?:t|q|th|theta|a|al|alpha))[a-z_]*\d*\b", re.I)
PROSE = re.compile(r"(?:[^\W\d_]{2,}[ ,]+){6}")
MOST = 2  # numbers in a line that breaks off; more are a row of a table
FEWEST = 2  # lines of one beginning, before a last line that breaks off may be another of them


def require_whole(source):
    """The text ends where a row ends.

    Parameters
    ----------
    source : Source

    Raises
    ------
    ValueError
        It ends within a bracket that holds numbers, or within a line that begins as others do.
    """
    code = source.code.rstrip()
    lines = code.split("\n")
    whole = source.text.split("\n")
    opened = (group for group in left_open(code) if not _is_closed(whole, group))
    opened = next((group for group in opened if _holds_rows(group, lines)), None)
    last = lines[-1].strip()
    if opened is None and not _breaks_off(last, lines[:-1]):
        return
    where = f"{opened.name or ''}{opened.mark} of line {opened.line}" if opened else repr(last[:40])
    raise ValueError(
        f"recognise_table: the text ends within {where[:60]}; what else stands in it? Paste it to"
        " its end"
    )


def _is_closed(lines, group):
    """Whether the line as it stands closes what it opens: a mark of a comment in quotation marks,
    as in ``print("%s" % name)``, takes the rest of the line away.
    """
    line = lines[group.line - 1] if group.line <= len(lines) else ""
    return all(line.count(left) == line.count(right) for left, right in ("()", "[]", "{}"))


def _holds_rows(group, lines):
    """Whether what an open bracket holds are numbers, and no statements nor a link matrix."""
    tail = "\n".join(lines[group.line - 1 :])
    tail = tail[tail.find(group.mark) :]
    if not re.search(r"\d", tail) or FORMULA.search(tail) or PROSE.search(tail):
        return False
    if group.mark == "{" and ";" in tail:  # statements, as in a function
        return False
    return group.mark != "(" or bool(group.name or group.target or group.outer)


def _breaks_off(last, before):
    """Whether the last line is the beginning of what stands in others, with other numbers."""
    start = _counted(last)
    if re.search(r"(?<=[\w)\]])\s*(?:=|\s\*)$", last):
        return True
    whole = re.search(r"[)\]};]$", start) and "=" in start
    if whole or not re.search(r"\w", start) or start.count("#") > MOST:
        return False
    longer = [line for line in map(_counted, before) if line.startswith(start)]
    fuller = [line for line in longer if len(line) > len(start) + 2 and line.count("#") > MOST]
    return len(fuller) >= FEWEST and len(fuller) == len(longer)


def _counted(line):
    return re.sub(r"\d+(?:\.\d+)?", "#", line.strip())
