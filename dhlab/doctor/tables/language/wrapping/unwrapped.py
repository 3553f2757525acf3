"""What a text was copied from, taken off: a mail, a prompt, a page, a change under version control,
a table drawn with signs.
"""

import html
import re

from ..restated import restated
from ..sentences import in_lines
from .markup import as_html, with_pipes
from .pictures import without_pictures

__all__ = ["unwrapped"]

FIELDS = re.compile(  # theta: float, as a class has it
    r"(?:^[ \t]+\w+[ \t]*:[ \t]*(?:float|int|str|bool)\b[^\n]*(?:\n|$))+", re.MULTILINE
)
STYLED = re.compile(  # <b>210</b>
    r"<(b|i|u|em|strong|small|code|kbd|span|font)\b[^<>\n]*>([^<>\n]*)</\1>", re.IGNORECASE
)
LENGTH = re.compile(r"[ \t]+[A-Za-z]\w*\d[ \t]*:[ \t]*\w+[ \t]*=[ \t]*-?[\d.]+[ \t]*(?:#.*)?")
RULE = r"[ \t]*\+[-=+]{3,}\+[ \t]*"
DRAWN = re.compile(rf"^{RULE}\n((?:[ \t]*\|.*\n)+)(?={RULE}$)", re.MULTILINE)


def unwrapped(text):
    """Quotation marks of mails and prompts off, frames of toolboxes drawn with ASCII, HTML rows as
    lines.
    """
    text = text.replace("\r\n", "\n").replace("\r", "\n").expandtabs(1) if "\r" in text else text
    text = re.sub(r"[ \t]+$", "", _without_diff(without_pictures(text)), flags=re.MULTILINE)
    text = re.sub(r"<(sub|sup)>\s*(.*?)\s*</\1>", r"_\2", text, flags=re.IGNORECASE)
    text = as_html(STYLED.sub(r"\2", text))
    if re.search(r"<t[dh]\b", text, re.IGNORECASE):
        text = re.sub(r"</t[dh]\s*>\s*", " | ", text, flags=re.IGNORECASE)
        text = re.sub(r"</?(tr|table|thead|tbody)[^>]*>", "\n", text, flags=re.IGNORECASE)
        text = re.sub(r"<[^>\n]{1,80}>", "", text)
    text = with_pipes(text)
    text = html.unescape(text).replace("\xa0", " ").replace("−", "-")
    text = re.sub(r"^```.*$", "", text, flags=re.MULTILINE)
    # the fields of a class, before anything is made of it
    text = FIELDS.sub(_as_comment, text)
    text = re.sub(r"^(?:\s*(?:>>>|\.\.\.(?=\s)|>)\s?)+", "", text, flags=re.MULTILINE)
    text = re.sub(r"\.\.\.[ \t]*(?:%.*)?\n", " ", text)
    text = re.sub(r"'(\[[^'\]\n]*\])'", r"\1", text)
    if len(re.findall(r"^.*\|\|.*\|\|.*$", text, re.MULTILINE)) > 1:
        text = text.replace("||", "|")
    text = restated(in_lines(text))
    text = _listed_table(text)
    text = _joined_heading(re.sub(r":math:`([^`\n]*)`", r"\1", text))
    text = re.sub("[┌┐└┘├┤┬┴┼─━┏┓┗┛┣┫┳┻╋═╔╗╚╝╠╣╦╩╬]+", "", text)
    return text


def _as_comment(match):
    """The names of fields; the lengths of a class, ``L1: float = 0.1``, as they are."""
    if all(LENGTH.fullmatch(line) for line in match[0].splitlines()):
        return match[0]
    names = re.findall(r"^[ \t]+(\w+)[ \t]*:", match[0], re.MULTILINE)
    return f"# {', '.join(names)}" + "\n" * match[0].count("\n")


def _without_diff(text):
    """The new lines of a change as version control prints it, without their marks."""
    lines = text.split("\n")
    marked = [line for line in lines if line.strip()]
    if len(marked) < 3 or not all(line[0] in "+- @\\" for line in marked):
        return text
    added = sum(line[0] == "+" for line in marked)
    if 2 * added <= len(marked):
        return text
    gone = [line[:1] in ("-", "@", "\\") or line.startswith("+++") for line in lines]
    return "\n".join("" if left else line[1:] for line, left in zip(lines, gone))


def _listed_table(text):
    """The rows of reStructuredText's ``list-table``, a cell a line, as lines."""
    if "list-table::" not in text:
        return text
    text = re.sub(r"\n[ \t]*:[\w-]+:[^\n]*", "", text)
    text = re.sub(r"\n[ \t]*-[ \t]+([^\n]*)", r" | \1", text)
    return re.sub(r"^[ \t]*\*[ \t]+-[ \t]+", "| ", text, flags=re.MULTILINE)


def _joined_heading(text):
    """A table drawn with + and -, with a heading of two or three lines on one."""
    drawn = DRAWN.search(text)
    lines = [line.strip().strip("|").split("|") for line in drawn[1].splitlines()] if drawn else []
    if drawn is None or not 2 <= len(lines) <= 3 or len({len(cells) for cells in lines}) > 1:
        return text
    cells = (" ".join(map(str.strip, parts)) for parts in zip(*lines))
    return text[: drawn.start(1)] + f"| {' | '.join(cells)} |\n" + text[drawn.end(1) :]
