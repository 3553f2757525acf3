"""A program with braces as one in Python's grammar."""

import re

from ..brackets import split
from .declarations import (
    NO_TYPES,
    assignment,
    behind,
    closing,
    declared,
    initialised,
    matrix_of,
    parameters,
    references,
    step,
    without_type,
)  # fmt: skip
from .inline import before, fields_taken, taken_apart
from .preparing import prepared
from .records import enumeration, fields, record
from .tokens import NoProgram, expression, tokens_of

__all__ = ["as_python", "is_clike"]

ENDED = re.compile(r"[;{}]\s*(?://.*)?$")
FEWEST = 2  # lines that end so
SURE = re.compile(
    r"\b(?:double|float|const|let|var|void|auto|int|function|Matrix\w*|std::\w+)\s+[\w\[*&<]"
)
OTHERS = re.compile(r"^\s*(?:def \w+\(|import numpy|from \w+ import|end\s*$|fn \w+)", re.MULTILINE)
BEHIND = ("const", "noexcept", "override")  # the head of a function
PUSHED = ("push_back", "push", "emplace_back", "add", "Add")


def is_clike(text):
    """Whether a text looks like a program with braces.

    Examples
    --------
    >>> is_clike("double a = 1;\\nint b = 2;"), is_clike("a = 1\\nb = 2")
    (True, False)
    """
    ended = sum(bool(ENDED.search(line)) for line in text.split("\n"))
    return ended >= FEWEST and bool(SURE.search(text)) and not OTHERS.search(text)


def as_python(text):
    """A program with braces in Python's grammar.

    Examples
    --------
    >>> print(as_python("int f(int x[]) { for (int i = 0; i < 2; i++) x[i] *= 2; return x[0]; }"))
    def f(x):
        pass
        i=0
        while i<2:
            pass
            x[i]*=2
            i+=1
        return x[0]
    """
    text, sizes = prepared(text)
    try:
        tokens = tokens_of(text)
    except NoProgram:
        return ""
    writer = _Writer(sizes)
    at = 0
    while at < len(tokens):  # what is cut out of a class ends more blocks than it begins
        at = writer.block(tokens, at)
    return "\n".join([*writer.lines, *writer.fields_set])


class _Writer:
    """The lines that are written."""

    def __init__(self, sizes):
        self.sizes = sizes
        self.lines: list = []
        self.depth = 0
        self.local: set | None = None  # what a function declares: other names belong to its object
        self.filled: set = set()  # the matrices of its caller
        self.fields_set: list = []  # by constructors
        self.around: list = []  # what the functions around this one declare
        self.inlined = 0

    def put(self, line):
        """Write a line."""
        self.lines.append("    " * self.depth + line)

    def put_all(self, lines, end=None):
        """Write lines; the place behind what they stand for."""
        for line in lines:
            self.put(line)
        return end

    def block(self, tokens, at):
        """Write statements until the block ends; the place behind it."""
        while at < len(tokens):
            if tokens[at] == ("op", "}"):
                return at + 1
            start = at
            try:
                at = self.statement(tokens, at)
            except (NoProgram, LookupError, ValueError, StopIteration):
                at = behind(tokens, start)
                names = [text for kind, text in tokens[start:at] if kind == "name"]
                marks = [k for k in range(start, at) if tokens[k] == ("op", "=")]
                before = (
                    [t for kind, t in tokens[start : marks[0]] if kind == "name"] if marks else []
                )
                self.put(f"{before[-1]} = _lost()" if before else "_lost()" if names else "pass")
            if at <= start:
                at = start + 1
        return at

    def statement(self, tokens, at):
        """Write the statement that begins here; the place behind it."""
        kind, word = tokens[at]
        if (kind, word) == ("op", ";"):
            return at + 1
        if (kind, word) == ("op", "{"):
            return self.block(tokens, at + 1)
        if word in ("if", "while", "for", "foreach"):
            return self.controlled(tokens, at, word)
        if word == "else":
            if tokens[at + 1][1] == "if":
                return self.controlled(tokens, at + 1, "if", "elif")
            self.put("else:")
            return self.body(tokens, at + 1)
        if word == "typedef":
            return at + 1
        if word == "struct":
            self.put_all(fields(tokens, at))
        if word == "enum":
            lines, end = enumeration(tokens, at)
            return self.put_all(lines, end)
        if word in ("class", "struct", "namespace", "public", "private", "protected", "record"):
            ends = ("{", ";", ":", "(", "=")
            end = next(k for k in range(at, len(tokens)) if tokens[k][1] in ends)
            if tokens[end][1] == ":" and end > at + 1:  # what it is derived from
                end = next(k for k in range(end, len(tokens)) if tokens[k][1] in ("{", ";", "("))
            if "record" in [text for _, text in tokens[at:end]] and tokens[end][1] == "(":
                lines, end = record(tokens, end)
                return self.put_all(lines, end)
            if tokens[end][1] == "{":
                return self.block(tokens, end + 1)
            if tokens[end][1] == ":" and end == at + 1:
                return end + 1
        head = self.function(tokens, at)
        if head:
            return head
        end = behind(tokens, at)
        self.simple(before(self, tokens[at : end - (tokens[end - 1] == ("op", ";"))]))
        return end

    def inline(self, name, names, taken, tokens):
        """Write a function that stands within an expression."""
        self.put(f"def {name}({', '.join(names)}):")
        self.inlined += 1
        lines = [line for pattern, one in taken for line in fields_taken(pattern, one)]
        kept = self.local, self.filled, self.around
        self.around = [*self.around, self.local or set()]
        self.local = {*names, *(line.split(" = ")[0] for line in lines)}
        self.depth += 1
        self.put_all(lines)
        self.depth -= 1
        block = tokens[:1] == [("op", "{")]
        self.body(tokens if block else [("name", "return"), *tokens], 0)
        self.local, self.filled, self.around = kept

    def body(self, tokens, at, last=""):
        """Write what a head governs: a block or one statement; the place behind it."""
        self.depth += 1
        self.put("pass")
        braces = tokens[at] == ("op", "{")
        at = self.block(tokens, at + 1) if braces else self.statement(tokens, at)
        if last:
            self.put(last)
        self.depth -= 1
        return at

    def controlled(self, tokens, at, word, said=""):
        """Write a loop or a branch."""
        if tokens[at + 1] != ("op", "("):
            raise NoProgram
        end = closing(tokens, at + 1)
        inside = tokens[at + 2 : end]
        if word not in ("for", "foreach"):
            self.put(f"{said or word} {expression(inside)}:")
            return self.body(tokens, end + 1)
        parts = split(inside, ";")
        if len(parts) == 3:
            self.simple(parts[0])
            self.put(f"while {expression(parts[1])}:")
            return self.body(tokens, end + 1, step(parts[2]))
        over = split(inside, ":")
        if len(over) == 1:
            at_word = next(k for k, one in enumerate(inside) if one[1] in ("of", "in"))
            over = [inside[:at_word], inside[at_word + 1 :]]
        item = over[0][-1][1]
        if item in (")", "]"):  # for (const [a, b] of rows)
            names = [text for kind, text in over[0] if kind == "name"]
            item = ", ".join(one for one in names if one not in ("var", "const", "let", "auto"))
        self.put(f"for {item} in {expression(over[1])}:")
        return self.body(tokens, end + 1)

    def function(self, tokens, at):
        """Write a function, where its head stands here; the place behind it, None of others."""
        k = at
        while k < len(tokens) and (
            tokens[k][0] == "name" or tokens[k][1] in ("::", "*", "&", "[", "]", ".")
        ):
            k += 1
        if k >= len(tokens) or tokens[k][1] != "(" or k == at or tokens[at][1] in NO_TYPES:
            return None
        end = closing(tokens, k)
        after = end + 1
        while tokens[after : after + 1] and tokens[after][1] in BEHIND:
            after += 1
        fields, after = initialised(tokens, after)
        if after >= len(tokens) or tokens[after] != ("op", "{"):
            return None
        names = parameters(tokens[k + 1 : end])
        self.set_fields(fields, {name.partition("=")[0] for name in names})
        self.put(f"def {tokens[k - 1][1]}({', '.join(names)}):")
        around = self.local, self.filled
        self.local = {name.partition("=")[0] for name in names}
        self.filled = references(tokens[k + 1 : end])
        end = self.body(tokens, after)
        self.local, self.filled = around
        return end

    def set_fields(self, fields, given):
        """Write the numbers that a constructor sets, where it is not given them."""
        for name, value in fields:
            kinds = {kind for kind, _ in value}
            if "number" in kinds and "string" not in kinds and not given & {t for _, t in value}:
                self.fields_set.append(f"{name} = {expression(value)}")

    def simple(self, tokens):
        """Write a declaration, an assignment, a return or a call."""
        if not tokens:
            return
        word = tokens[0][1]
        if word in ("return", "break", "continue"):
            self.put(f"{word} {expression(tokens[1:])}".rstrip())
            return
        if tokens[-1][1] in ("++", "--") or word in ("++", "--"):
            self.put(step(tokens))
            return
        filled = split(tokens, "<<")
        if len(filled) == 2 and len(filled[0]) >= 1 and tokens[0][1] not in ("cout", "std", "cerr"):
            self.set(filled[0], f"_filled([{expression(filled[1])}])")
            return
        texts = [text for _, text in tokens]
        if texts[1:2] == ["."] and texts[2:4] in (["setIdentity", "("], ["setZero", "("]):
            zeros = f"_new({self.sizes[texts[0]]})" if texts[0] in self.sizes else "Zero()"
            self.set(tokens[:1], "Identity()" if texts[2] == "setIdentity" else zeros)
            return
        if texts[-1] == ")" and texts[1:2] == ["."] and texts[2] in PUSHED and texts[3] == "(":
            self.put(f"{texts[0]} = _pushed({texts[0]}, {expression(tokens[4:-1])})")
            return
        bare = without_type(tokens)
        if apart := taken_apart(bare):
            self.put_all(apart)
            if self.local is not None:
                self.local.update(line.split(" = ")[0] for line in apart)
            return
        for part in split(bare, ","):
            if part[:1] and part[0][1] in self.filled and part[1:2] == [("op", "=")]:
                self.put(f"_into({part[0][1]}, {expression(part[2:])})")
                continue
            line = matrix_of(tokens, part) or assignment(part)
            name = re.match(r"(\w+)\s*=(?!=)", line)
            if name and self.local is not None:
                if len(bare) < len(tokens):
                    self.local.add(name[1])
                elif name[1] not in self.local:
                    self.put(f"{self.kept(name[1])} {name[1]}")
            self.put(line)

    def kept(self, name):
        """Where a name is kept that a function does not declare."""
        return "nonlocal" if any(name in one for one in self.around) else "global"

    def set(self, target, value):
        """Write what fills a matrix."""
        name = declared(target)
        if name in self.filled:
            self.put(f"_into({name}, {value})")
            return
        if self.local is not None and name.isidentifier():
            if len(target) > 1:
                self.local.add(name)
            elif name not in self.local:
                self.put(f"global {name}")
        self.put(f"{name} = {value}")
