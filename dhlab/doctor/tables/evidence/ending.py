"""Where a text was cut off: within a row, within the brackets that hold the rows, or within a table
whose end has a mark.
"""

import re

from ..language.brackets import left_open

__all__ = ["require_closed", "require_whole"]

FORMULA = re.compile(r"(?<![a-z])(?:cos|sin|[cs]_?(?:t|q|th|theta|a|al|alpha))[a-z_]*\d*\b", re.I)
PROSE = re.compile(r"(?:[^\W\d_]{2,}[ ,]+){6}")
# what begins a table, and what ends it
TABLES = (
    (r"^[ \t:]*(\{\|)", r"^[ \t]*\|\}"),
    (r"(<table)\b", r"</table\b"),
    (r"(\[table\])", r"\[/table\]"),
    (r"(\\begin\{(?:tabular\w*|longtable|tabu)\})", r"\\end\{(?:tabular\w*|longtable|tabu)\}"),
)
OF_PAGES = re.compile(
    r"(?:p|br|hr|img|div|center|a|h\d|b|i|em|font|[uo]l|li|t\w|span|html|body)\b", re.I
)
ROOT = re.compile(  # the first element of an XML file
    r"\s*(?:<\?xml[^>]*>\s*)?(?:<!--.*?-->\s*)*<([A-Za-z][\w:.-]*)\b(?:[^<>]*[^<>/])?>", re.DOTALL
)
MOST = 2  # numbers in a line that breaks off; more are a row of a table
FEWEST = 2  # lines of one beginning, before a last line that breaks off may be another of them


def require_closed(text):
    """The table of a page, a wiki, TeX or an XML file has its end.

    Raises
    ------
    ValueError
        It has none: rows may have stood behind.
    """
    opened = ""
    for begins, ends in TABLES:
        found = re.findall(begins, text, re.MULTILINE | re.IGNORECASE)
        if len(found) > len(re.findall(ends, text, re.MULTILINE | re.IGNORECASE)):
            opened = found[-1]
    root = ROOT.match(text)
    if root and not OF_PAGES.match(root[1]) and f"</{root[1]}" not in text:
        opened = f"<{root[1]}>"
    if opened:
        raise ValueError(
            f"recognise_table: the text ends within {opened[:60]}, which nothing closes; what else"
            " stands in it? Paste it to its end"
        )


def require_whole(source, last_row=0):
    """The text ends where a row ends.

    Parameters
    ----------
    source : Source
    last_row : int
        The line of the last row, where it is known.

    Raises
    ------
    ValueError
        It ends within a bracket that holds numbers, or within a line that begins as others do.
    """
    code = source.code.rstrip()
    lines = code.split("\n")
    whole = source.text.split("\n")
    opened = (group for group in left_open(code) if not _is_closed(whole, group))
    opened = next(
        (one for one in opened if _holds_rows(one, lines) or _begins_alike(one, lines)), None
    )
    last = lines[-1].strip()
    broken = _breaks_off(last, lines[:-1]) or _within_a_word(source.text)
    drawn = _lacks_its_bar(whole) or _counts_on(whole, last_row)
    if opened is None and not broken and not drawn:
        return
    last = last if broken else source.text.rstrip().split("\n")[-1].strip()
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


def _begins_alike(group, lines):
    """Whether a call that nothing closes begins as whole ones before it: ``chain.add(Segment(``."""
    head = lines[group.line - 1].partition(group.mark)[0].strip()
    before = [line for line in lines[: group.line - 1] if line.strip().startswith(head + "(")]
    shows = re.search(r"print|log|disp|plot|cout|write|assert", head, re.IGNORECASE)
    return group.mark == "(" and bool(head) and not shows and len(before) >= FEWEST


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


def _within_a_word(text):
    """Whether the text ends without the end of a line, within a word or a rule that the beginning
    of another line has whole: ``cha`` below ``chain.add(…)``.
    """
    *before, last = text.split("\n")
    start = _counted(last)
    if not start or start == "end":
        return False
    longer = [line for line in map(_counted, before) if line.startswith(start)]
    rest = [line[len(start) :] for line in longer]
    if re.fullmatch(r"[-+=|: ]{4,}", start):
        return bool(rest) and all(len(line) > 1 for line in rest)
    return bool(rest) and start[-1].isalpha() and all(line[:1].isalpha() for line in rest)


def _lacks_its_bar(lines):
    """Whether the last line of the text is a row between bars, of which it alone has none at its
    end.
    """
    lines = [line.strip() for line in lines if line.strip()]
    *before, last = [line for line in lines if line.startswith("|")] or [""]
    whole = len(before) >= FEWEST and all(line.endswith("|") for line in before)
    return whole and last == lines[-1] and not re.search(r"\|(?:-->|[\s\"'}\]),;])*$", last)


def _counts_on(lines, last_row):
    """Whether one line more, the text's last, stands directly below the last row and has the number
    that follows the last row's.
    """
    below = [line for line in lines[last_row:] if re.search(r"\w", line)]
    if not 0 < last_row <= len(lines) or len(below) != 1:
        return False
    numbers = [re.match(r"[|\s]*(\d+)(?![\w.])", line) for line in (lines[last_row - 1], below[0])]
    return all(numbers) and int(numbers[1][1]) == int(numbers[0][1]) + 1


def _counted(line):
    return re.sub(r"\d+(?:\.\d+)?", "#", line.strip())
