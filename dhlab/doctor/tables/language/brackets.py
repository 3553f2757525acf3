"""Brackets of any program: which groups there are, what stands before them, what is in them."""

import re
from dataclasses import dataclass, field

__all__ = ["Group", "Item", "cells_in", "groups", "keyword", "left_open"]

CLOSING = {"(": ")", "[": "]", "{": "}"}
BEFORE = re.compile(r"([A-Za-z_][\w.:>-]*(?:\s*<[\w\s,:]*>)?)\s?$")
TARGET = re.compile(
    r"([A-Za-z_][\w.]*)((?:\([\w:,\s]*\))?\s*(?:\[[\w\s*+]*\]\s*)*)['\"]?\s*"
    r"(?:=|:(?!:)|<<)\s*$"
)
DECLARED = re.compile(r"([A-Za-z_]\w*)\s*(?:\[[\w\s*+]*\]\s*)*$")  # double a[6] {…}
NO_NAMES = ("in", "return", "if", "and", "or", "not", "for", "while", "print", "else")
DEEPEST = 12
KEYWORD = re.compile(r"\s*\.?['\"]?([A-Za-z_][\w.]*)['\"]?\s*(?:=(?!=)|:(?!:))\s*(.*)\Z", re.DOTALL)


@dataclass(eq=False)
class Item:
    """One element of a group: its text, the groups in it, its line, and what ends it: "," ";" or a
    line's end.
    """

    text: str = ""
    groups: list = field(default_factory=list)
    line: int = 1
    after: str = ""


@dataclass(eq=False)  # a group knows what is around it, and that knows the group
class Group:
    """What stands between two brackets. ``name`` stands directly before, as the function of a call;
    ``target`` is what it is assigned to, ``index`` which item of that, ``outer`` what is around it.
    """

    mark: str
    name: str
    target: str
    line: int
    outer: "Group | None" = None
    items: list = field(default_factory=list)
    text: str = ""
    index: str = ""


def keyword(text):
    """(name, value) of ``name=value``, ``name: value`` or ``'name': value``; None otherwise.

    Examples
    --------
    >>> keyword("d=0.1"), keyword("'alpha': pi/2"), keyword("0.1")
    (('d', '0.1'), ('alpha', 'pi/2'), None)
    """
    match = KEYWORD.match(text)
    return (match[1], match[2].strip()) if match else None


def groups(text):
    """Every group of a text, the outer before the inner.

    Examples
    --------
    >>> [found] = groups("L1 = Link('d', 0.1, 'a', 0)")
    >>> found.name, [item.text for item in found.items]
    ('Link', ["'d'", '0.1', "'a'", '0'])
    """
    return [group for group in _opened_in(text) if group.text]


def left_open(text):
    """The groups whose closing bracket the text does not hold, the outer before the inner.

    Examples
    --------
    >>> [group.name for group in left_open("L1 = Link(0, 0.1, 0, 0); L2 = Link(0, 0.2,")]
    ['Link']
    """
    return [group for group in _opened_in(text) if not group.text]


def _opened_in(text):
    found, stack, line, at = [], [], 1, 0
    while at < len(text):
        letter = text[at]
        if letter == "\n":
            line += 1
        quoted = _quoted(text, at) if letter in "'\"" else at
        if quoted > at:
            _write(stack, text[at:quoted])
            at = quoted
            continue
        if letter in CLOSING and len(stack) < DEEPEST:
            group = _opened(text, at, line, stack)
            found.append(group)
            stack.append((group, at))
        elif stack and letter == CLOSING[stack[-1][0].mark]:
            group, start = stack.pop()
            group.text = text[start : at + 1]
            _finish(group)
            if stack:
                _write(stack, text[start : at + 1])
                stack[-1][0].items[-1].groups.append(group)
        elif stack and (letter in ",;" or (letter == "\n" and stack[-1][0].mark != "(")):
            _ended(stack[-1][0], letter, line)
        else:
            _write(stack, letter)
        at += 1
    return found


def _opened(text, at, line, stack):
    before = re.sub(r"=\s*\n\s*$", "= ", text[max(0, at - 120) : at]).rsplit("\n", 1)[-1]
    name = BEFORE.search(before)
    named = name and name[1] not in NO_NAMES and text[at] == "("
    target = TARGET.search(before[: name.start()] if named else before)
    if not target and text[at] == "{":
        target = DECLARED.search(before)
    return Group(
        text[at],
        name[1] if named else "",
        target[1] if target and target[1] not in NO_NAMES else "",
        line,
        stack[-1][0] if stack else None,
        [Item(line=line)],
        index=target[2].strip() if target and len(target.groups()) > 1 else "",
    )


def _write(stack, text):
    if stack:
        stack[-1][0].items[-1].text += text


def _ended(group, mark, line):
    """A separator: a line's end after a comma, or in an empty item, separates nothing more."""
    last = group.items[-1]
    if mark == "\n" and (not last.text.strip() or last.text.rstrip()[-1:] in "+-*/(=:"):
        if len(group.items) > 1 and not last.text.strip() and group.items[-2].after == ",":
            group.items[-2].after = ",\n"
        last.text += " "
        last.line = line if not last.text.strip() else last.line
        return
    last.after = mark
    group.items.append(Item(line=line))


def _finish(group):
    for item in group.items:
        item.text = item.text.strip()
    group.items = [item for item in group.items if item.text]


def _quoted(text, at):
    """Where the quotation that begins here ends; ``at`` itself when none begins."""
    before = text[max(0, at - 99) : at].rstrip(" \t")[-1:]
    if before and before not in "([{,=:;\n+%rfbu":
        return at
    end = text.find(text[at], at + 1, at + 400)
    return at if end < 0 or "\n" in text[at:end] else end + 1


def cells_in(text):
    """The cells of a row: at commas, else at spaces as MATLAB has it, where ``q - 1`` is one cell
    and ``q -1`` are two.

    Examples
    --------
    >>> cells_in("0, -pi / 2, q(2) - pi/2"), cells_in("0 -pi / 2  q(2) - pi/2 -1")
    (['0', '-pi / 2', 'q(2) - pi/2'], ['0', '-pi/2', 'q(2)-pi/2', '-1'])
    """
    text = text.strip()
    if "," in re.sub(r"[(\[][^()\[\]]*[)\]]", "", text):
        return [cell.strip() for cell in _at_commas(text) if cell.strip()]
    text = re.sub(r"(?<=[\w)\]])\s*([*/^])\s*(?=[\w(.+-])", r"\1", text)
    text = re.sub(r"(?<=[\w)\]*°])\s+([-+])\s+(?=[\w(.])", r"\1", text)
    return re.findall(r"(?:[^\s()\[\]]|\([^()]*(?:\([^()]*\)[^()]*)*\)|\[[^\[\]]*\])+", text)


def _at_commas(text):
    depth, start = 0, 0
    for at, letter in enumerate(text):
        depth += (letter in "([{") - (letter in ")]}")
        if letter == "," and depth == 0:
            yield text[start:at]
            start = at + 1
    yield text[start:]
