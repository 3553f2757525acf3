"""What of a program is comment: taken out, or taken for the program where most of it is one."""

import re

__all__ = ["uncommented", "without_comments"]

BLOCK = re.compile(
    r"/\*.*?\*/|\"\"\".*?\"\"\"|'''.*?'''|<!--.*?-->|\(\*\s.*?\*\)|\{-\s.*?-\}|--\[\[.*?\]\]|#=.*?=#",
    re.DOTALL,
)
# one more mark of a line's comment: Lua, SQL and Haskell; Lisp and INI; Fortran; Basic
MARKED = re.compile(
    r"(?:(?<=\s)|^)--(?=\s+[^\W\d_])|^\s*;+(?=\s*[^\W\d_])|(?:(?<=\s)|^)!(?=\s*[^\W\d_])|^\s*'(?=\s*[^\W\d_][^']*$)"
)


def without_comments(text, comments):
    """The text with comments blanked, which are added to ``comments`` with their line."""

    def blanked(match):
        line = text.count("\n", 0, match.start()) + 1
        comments.extend(
            (line + k, re.sub(r"-->\s*$|^<!--", "", part).strip(" */'\""))
            for k, part in enumerate(match[0].split("\n"))
        )
        return "\n" * match[0].count("\n")

    lines = BLOCK.sub(blanked, text).split("\n")
    for k, line in enumerate(lines):
        cut = _comment_at(line)
        other = MARKED.search(line) if "|" not in line else None
        if other and (cut is None or other.start() < cut):
            comments.append((k + 1, line[other.end() :].strip()))
            lines[k] = line[: other.start()]
        elif cut is not None:
            comments.append((k + 1, line[cut:].lstrip("#%/! \t")))
            lines[k] = line[:cut]
    return "\n".join(lines)


def uncommented(text):
    """The text with the marks of its comments taken off, where most of it is one; None of others.

    Examples
    --------
    >>> uncommented("# L1 = Link(d=0.1)\\n# L2 = Link(a=0.4)")
    'L1 = Link(d=0.1)\\nL2 = Link(a=0.4)'
    """
    plain, n = re.subn(
        r"^[ \t]*(?:#+|//+|%+|--|\*)[ \t]?(?=.*[\w\])}])", "", text, flags=re.MULTILINE
    )
    return plain if n > 1 else None


def _comment_at(line):
    """Where a comment begins in a line, None when there is none."""
    if re.match(r"\s*#\s*(define|include|if|endif|pragma)\b", line):
        cut = line.find("//")
        return cut if cut >= 0 else None
    quote = ""
    for at, letter in enumerate(line):
        if quote:
            quote = "" if letter == quote else quote
        elif (
            letter in "'\""
            and line.find(letter, at + 1) > 0
            and line[:at].rstrip()[-1:] in "([{,=:;"
        ):
            quote = letter
        elif (
            (letter == "%" and line[at + 1 : at + 3] != "pi")
            or (
                letter == "#"
                and "|" not in line[:at]
                and line[at + 1 : at + 2] not in (",", "|", "\t")
            )
            or (line.startswith("//", at) and line[at - 1 : at] != ":")
        ):
            return at
    return None
