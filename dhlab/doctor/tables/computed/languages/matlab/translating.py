"""A program in MATLAB as one in Python's grammar, line by line."""

import re

from ..brackets import split
from .tokens import NoMatlab, expression, target, tokens_of

__all__ = ["as_python", "is_matlab"]

MATLAB = re.compile(
    r"^[ \t]*(?:function\b[^\n:]*|for\s+\w+\s*=[^\n]*|end;?|clc\b.*|syms\b.*"
    r"|\w+\s*=\s*\[[^\n]*;\s*(?:\.\.\.)?)$"
    r"|^[ \t]*%|;[ \t]*%|\beye\(4\);|SerialLink\(|=\s*@\(|^(?:clear|close)\b[^\n=(]*$",
    re.MULTILINE,
)
NOT_MATLAB = re.compile(
    r"^\s*(?:def \w+\(|import \w|#include|using |public |from \w+ import|(?:const|let|var)\s+\w)"
    r"|\)\s*\{\s*$",
    re.MULTILINE,
)
BLOCK = re.compile(r"^[ \t]*%\{[ \t]*$.*?^[ \t]*%\}[ \t]*$", re.MULTILINE | re.DOTALL)
GOING_ON = re.compile(r"\.\.\.[^\n]*\n")
COMMANDS = re.compile(
    r"(?:clc|clear|close|hold|format|figure|warning|global|persistent|addpath|axis|grid|clearvars"
    r"|drawnow|more|pkg|load|rng|tic|toc|disp|fprintf|title|xlabel|ylabel|zlabel|legend|view|import)\b"
)
HEAD = re.compile(
    r"function\s+(?:(?:\[([^\]]*)\]|(\w+))\s*=\s*)?(\w+(?:\.\w+)*)\s*(?:\(([^)]*)\))?\s*$"
)
OPENERS = ("for", "parfor", "while", "if", "switch", "try", "function", "classdef", "properties",
           "methods", "unwind_protect")  # fmt: skip
ENDS = re.compile(r"end(?:function|for|if|while|switch)?$|end_try_catch$")


def is_matlab(text):
    """Whether a text looks like MATLAB.

    Examples
    --------
    >>> is_matlab("T = eye(4);  % start"), is_matlab("import numpy as np")
    (True, False)
    """
    return bool(MATLAB.search(text)) and not NOT_MATLAB.search(text)


def as_python(text):
    """A program in MATLAB in Python's grammar; "" where nothing of it is understood.

    Examples
    --------
    >>> print(as_python("for i = 1:2\\n  T = T * A(i);\\nend"))
    for i in _span(1,2):
        pass
        T=T*A(i)
    """
    text = BLOCK.sub("", text)
    lines = GOING_ON.sub(" ", text).split("\n")
    text = "\n".join(map(_without_comment, lines))
    writer = _Writer(list(_statements(text)))
    return "\n".join(writer.written())


def _without_comment(line):
    """A line without what stands behind a % or # that is in no text."""
    quote = ""
    for k, mark in enumerate(line):
        if mark == quote:
            quote = ""
        elif not quote and mark in "%#":
            return line[:k]
        elif not quote and mark in "'\"":
            turned = mark == "'" and k and (line[k - 1].isalnum() or line[k - 1] in "_)]}.'")
            quote = "" if turned else mark
    return line


def _statements(text):
    """The tokens of each statement, without spaces at its ends."""
    try:
        tokens = tokens_of(text)
    except NoMatlab:
        tokens = []
        for line in text.split("\n"):
            try:
                tokens += [*tokens_of(line), ("op", "\n")]
            except NoMatlab:
                tokens += [*_lost(line), ("op", "\n")]
    for part in split(tokens, ";", ",", "\n"):
        kept = part
        while kept and kept[0][0] == "space":
            kept = kept[1:]
        while kept and kept[-1][0] == "space":
            kept = kept[:-1]
        if kept:
            yield kept


class _Writer:
    """What is written so far, and the blocks that are open."""

    def __init__(self, statements):
        self.statements, self.lines, self.blocks = statements, [], []
        words = [one[0][1] for one in statements]
        opened = sum(word in OPENERS for word in words)
        closed = sum(bool(ENDS.match(word)) for word in words)
        self.closed = opened <= closed
        self.results: list = []

    def written(self):
        """The lines in Python's grammar."""
        for tokens in self.statements:
            try:
                self.statement(tokens)
            except (NoMatlab, LookupError, ValueError):
                named = tokens[0][0] == "name" and len(tokens) > 1
                self.put(f"{tokens[0][1].split('.')[0]} = _lost()" if named else "_lost()")
        while self.blocks:
            self.close()
        return self.lines

    def put(self, line):
        """Write a line."""
        self.lines.append("    " * len(self.blocks) + line)

    def open(self, word, line):
        """Open a block."""
        self.put(line)
        self.blocks.append(word)
        self.put("pass")

    def close(self):
        """Close the block that was opened last."""
        if not self.blocks:
            raise NoMatlab
        if self.blocks[-1] == "case":
            self.blocks.pop()
        if self.blocks[-1] == "function":
            self.put(f"return {self.results.pop()}")
        self.blocks.pop()

    def statement(self, tokens):
        """Write one statement."""
        if tokens[-1][0] == "lost":
            raise NoMatlab
        word = tokens[0][1] if tokens[0][0] == "name" else ""
        rest = tokens[1:]
        if ENDS.match(word) and len(tokens) == 1:
            self.close()
        elif word == "function":
            self.function("".join(text for _, text in tokens))
        elif word in ("for", "parfor"):
            name, values = split(_bare(rest), "=")[:2]
            self.open("for", f"for {target(name)} in {expression(values)}:")
        elif word in ("while", "if"):
            self.open(word, f"{word} {expression(rest)}:")
        elif word in ("elseif", "else"):
            self.blocks.pop()
            self.open("if", f"elif {expression(rest)}:" if word == "elseif" else "else:")
        elif word == "switch":
            self.open("switch", f"for _switched in [{expression(rest)}]:")
        elif word in ("case", "otherwise"):
            if self.blocks[-1] == "case":
                self.blocks.pop()
            said = f"if _is_case(_switched,{expression(rest)}):" if word == "case" else "if True:"
            self.open("case", said)
        elif word in ("try", "properties", "methods", "classdef"):
            static = any(text == "Static" for _, text in rest)
            self.open("static" if static else word, "if True:")
        elif word == "catch":
            self.blocks.pop()
            self.open("try", "if False:")
        elif word == "return":
            self.put(f"return {self.results[-1]}" if self.results else "pass")
        elif word in ("break", "continue"):
            self.put(word)
        elif word in ("syms", "sym") and rest and rest[0][0] == "space":
            for kind, name in rest:
                if kind == "name" and name not in ("real", "positive"):
                    self.put(f"{name} = symbols('{name}')")
        elif not COMMANDS.match(word):
            self.assignment(tokens)

    def function(self, text):
        """Write the head of a function."""
        head = HEAD.match(text)
        if not head:
            raise NoMatlab
        if not self.closed:
            while self.blocks:
                self.close()
        many, one, name, given = head.groups()
        names = re.findall(r"\w+", many or one or "")
        args = [
            re.split(r"\s*=", arg)[0].strip() for arg in (given or "").split(",") if arg.strip()
        ]
        args = [f"_{k}" if arg == "~" else arg for k, arg in enumerate(args)]
        args = ["*varargin" if arg == "varargin" else arg for arg in args]
        if "static" in self.blocks:
            self.put("@staticmethod")
        self.open("function", f"def {name.split('.')[-1]}({', '.join(args)}):")
        self.results.append(", ".join(names) if names else "None")

    def assignment(self, tokens):
        """Write an assignment, or an expression."""
        parts = split(tokens, "=")
        if len(parts) == 1:
            self.put(expression(tokens))
            return
        left, right = parts[0], parts[1:]
        value = expression([one for part in right for one in part])
        kept = [one for one in left if one[0] != "space"]
        if kept and kept[0][1] == "[":
            names = split(
                [("op", ",") if one[0] == "space" else one for one in left if one[1] not in "[]"],
                ",",
            )
            left_side = [target(one) if one[0][1] != "~" else "_" for one in names if one]
            self.put(f"{', '.join(left_side)}{',' if len(left_side) == 1 else ''} = {value}")
        else:
            self.set(target(left), value)

    def set(self, name, value):
        """Write an assignment; what an object holds is everywhere the same."""
        if name.startswith("SELF__") and self.blocks:
            self.put(f"global {name.split('[')[0]}")
        self.put(f"{name}={value}")
        if "properties" in self.blocks:
            self.put(f"SELF__{name}={name}")


def _lost(line):
    """The tokens of a line that cannot be read: what it is about, which is not known from there."""
    name = re.match(r"\s*([A-Za-z_]\w*)", line)
    known = name and name[1] not in OPENERS and not ENDS.match(name[1])
    return [("name", name[1]), ("lost", "")] if known else [("name", "_lost")]


def _bare(tokens):
    """Tokens without the brackets around all of them: for (i = 1:n)."""
    kept = [one for one in tokens if one[0] != "space"]
    if kept and kept[0][1] == "(" and kept[-1][1] == ")" and len(split(kept, "=")) == 1:
        return kept[1:-1]
    return tokens
