"""Tables in the markup of wikis and manuals, MediaWiki, DokuWiki, Textile, AsciiDoc,
reStructuredText, with the rows as lines and pipes between the cells.
"""

import re

__all__ = ["as_html", "with_pipes"]

WIKI = re.compile(r"^[ \t:]*\{\|[^\n]*\n(.*?)(?:^[ \t]*\|\}|\Z)", re.MULTILINE | re.DOTALL)
# style="…" | before what a cell of MediaWiki holds
ATTRIBUTES = re.compile(r"^\s*(?:\w+\s*=\s*(?:\"[^\"\n]*\"|'[^'\n]*'|\w+)\s*)+\|(?!\|)")
TAG = re.compile(r"</?(?:math|small|big|nowiki|br|b|i|center|span)\b[^<>\n]*>", re.IGNORECASE)
DOKUWIKI = re.compile(r"^[ \t]*\^[^\n]*\^[^\n]*\^[ \t]*$", re.MULTILINE)
CONFLUENCE = re.compile(r"^[ \t]*\|\|(?:[^|\n]+\|\|){3,}[ \t]*$", re.MULTILINE)
BBCODE = re.compile(r"\[(/?(?:table|tr|td|th|b|i|u|center))\]", re.IGNORECASE)
BREAK = re.compile(r"<br\s*/?>", re.IGNORECASE)
TEXTILE = re.compile(r"(?<=\|)_\.")
ASCIIDOC = re.compile(r"^\|={3,}[ \t]*\n(.*?)^\|={3,}[ \t]*$", re.MULTILINE | re.DOTALL)
CSV_TABLE = re.compile(
    r"^[ \t]*\.\. csv-table::([^\n]*)\n((?:[ \t]*\n|[ \t]+[^\n]*(?:\n|\Z))+)", re.MULTILINE
)


def with_pipes(text):
    r"""The text whose tables have a line for each row.

    Examples
    --------
    >>> with_pipes("{| class='wikitable'\n! i !! d\n|-\n| 1\n| align=right | 0.2\n|}")
    '| i | d |\n| 1 | 0.2 |\n'
    >>> with_pipes("^ i ^ d ^\n| 1 | 0.2 |")
    '| i | d |\n| 1 | 0.2 |'
    """
    text = WIKI.sub(lambda m: _of_wiki(m[1]), text)
    text = CONFLUENCE.sub(lambda m: m[0].replace("||", "|"), TEXTILE.sub(" ", text))
    text = "\n".join(BREAK.sub(" ", line) if "|" in line else line for line in text.split("\n"))
    text = DOKUWIKI.sub(lambda m: m[0].replace("^", "|"), text)
    text = ASCIIDOC.sub(lambda m: _one_row_a_line(m[1]), text)
    return CSV_TABLE.sub(lambda m: m[1].strip() + "\n" + _listed(m[2]), text)


def as_html(text):
    """A forum's table, ``[td]0.2[/td]``, with the tags of a page.

    Examples
    --------
    >>> as_html("[tr][td]0.2[/td][/tr]"), as_html("x[b]")
    ('<tr><td>0.2</td></tr>', 'x[b]')
    """
    return BBCODE.sub(r"<\1>", text) if re.search(r"\[/td\]", text, re.IGNORECASE) else text


def _of_wiki(inside):
    """The rows of a MediaWiki table: a cell a line, or several with || and !! between."""
    rows, said = [[]], []
    for line in TAG.sub("", inside).split("\n"):
        line = line.strip()
        if line.startswith("|-"):
            rows.append([])
        elif line.startswith("|+"):
            said.append(line[2:])
        elif line[:1] in ("|", "!"):
            cells = re.split(r"\|\||!!" if line[0] == "!" else r"\|\|", line[1:])
            rows[-1] += [ATTRIBUTES.sub("", cell).strip() for cell in cells]
    lines = [f"| {' | '.join(cells)} |" for cells in rows if cells]
    return "\n".join([*said, *lines]) + "\n"


def _one_row_a_line(inside):
    """The rows of AsciiDoc, whose cells may stand in lines of their own below the heading."""
    lines = [line for line in inside.split("\n") if line.strip()]
    counts = [line.count("|") for line in lines]
    width = counts[0] if counts else 0
    if width < 4 or set(counts[1:]) != {1} or (len(lines) - 1) % width:
        return inside
    below = (lines[at : at + width] for at in range(1, len(lines), width))
    return "\n".join([lines[0], *(" ".join(map(str.strip, row)) for row in below)]) + "\n"


def _listed(inside):
    """The heading and the rows of reStructuredText's ``csv-table``."""
    inside = re.sub(r"^[ \t]*:header:[ \t]*", "", inside, flags=re.MULTILINE)
    inside = re.sub(r"^[ \t]*:[\w-]+:[^\n]*\n?", "", inside, flags=re.MULTILINE)
    return inside.replace('"', "")
