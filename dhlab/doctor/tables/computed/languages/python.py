"""A text as a Python program: the parts of it that parse."""

import ast
import re
import warnings

from ...language.letters import unified

__all__ = ["parsed", "statements_of"]

PYTHON = re.compile(
    r"^\s*(?:def \w+\(|import \w|from \w[\w.]* import|class \w+.*:\s*$)|\b(?:np|math|sp|rtb)\.\w",
    re.MULTILINE,
)
PROMPT = re.compile(r"^[ \t]*(?:>>>|\.\.\.|In ?\[\d*\]:)[ ]?", re.MULTILINE)
MAGIC = re.compile(r"^[ \t]*[%!][^\n]*$|^```[^\n]*$", re.MULTILINE)
SHORTEST = 40
MOST_TRIES = 24
FAILED = (SyntaxError, ValueError, RecursionError, MemoryError)


def statements_of(text, translated=False):
    """The statements of a program, the longest beginnings of its parts that parse; none of a text
    that is no Python.

    Examples
    --------
    >>> [type(node).__name__ for node in statements_of("    a = [1]\\n  import numpy\\n  a = ((")]
    ['Assign', 'Import']
    """
    if re.search(r"^[ \t]*>>> ", text, re.MULTILINE):
        lines = [line for line in text.split("\n") if PROMPT.match(line)]
        text = "\n".join(PROMPT.sub("", line) for line in lines)
    if not translated and not PYTHON.search(text):
        return []
    text = MAGIC.sub("", text).expandtabs(4)
    for written in (text, unified(text)):
        whole = parsed(written)
        if whole is not None:
            return _lifted(whole)
    found: list = []
    for part in _parts(text.split("\n")):
        found += _beginning(part)
    return _lifted(found)


def _lifted(statements):
    """The statements with methods that stand, by the indent of what was pasted, behind the return
    of a function, beside it.
    """
    found = []
    for node in statements:
        found.append(node)
        if isinstance(node, ast.FunctionDef):
            ends = [k for k, one in enumerate(node.body) if isinstance(one, ast.Return)]
            found += node.body[ends[0] + 1 :] if ends else []
    return found


def parsed(text):
    """The statements of a text; None where it does not parse."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            return ast.parse(text).body
        except FAILED:
            return None


def _parts(lines):
    """The lines, cut where they stand further to the left than all before, without their indent."""
    part: list = []
    least = None
    for line in lines:
        indent = len(line) - len(line.lstrip())
        if line.strip() and (least is None or indent < least):
            if part and least is not None:
                yield part
                part = []
            least = indent
        part.append(line[least or 0 :] if line.strip() else "")
    yield part


def _beginning(lines):
    """The statements of as many lines as parse; a line that does not is left out with its block."""
    for _ in range(MOST_TRIES):
        if not any(line.strip() for line in lines):
            return []
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            try:
                return ast.parse("\n".join(lines)).body
            except SyntaxError as error:
                at = min(max((error.lineno or 1) - 1, 0), len(lines) - 1)
            except FAILED:
                return []
        first = at
        while first and (not lines[first].strip() or lines[first][:1].isspace()):
            first -= 1
        if first == 0 and at == 0:
            lines = lines[1:]
        else:  # the statement in which it stands
            last = at + 1
            while last < len(lines) and (not lines[last].strip() or lines[last][:1].isspace()):
                last += 1
            lines = [*lines[:first], *lines[last:]] if first else lines[last:] or lines[:at]
    return []
