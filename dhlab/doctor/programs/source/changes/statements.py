"""What may stand in place of a statement in which something went wrong: behind the loop or in it,
added up or set anew, a copy, a name that starts afresh in every call.
"""

import ast
import re

__all__ = ["statement_edits", "turns_of"]

ENDS = re.compile("base|tool|flange|gripper|tcp", re.IGNORECASE)
SIMPLE = (ast.Assign, ast.AugAssign, ast.Expr, ast.Return)
UNITS = ("/ 2", "* (3.141592653589793 / 180)", "* (180 / 3.141592653589793)", "/ 1000")
OPERATORS = {
    ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.MatMult: "@", ast.Div: "/", ast.Mod: "%",
    ast.Pow: "**", ast.FloorDiv: "//",
}  # fmt: skip


def statement_edits(text):
    """Yields (rank, start, end, what stands there then), bytes and a text."""
    for node in text.nodes():
        for body in _bodies(node):
            yield from _in_body(body, node, text)
        if isinstance(node, ast.ClassDef):
            yield from _of_each_object(node, text)
        if isinstance(node, ast.FunctionDef):
            yield from _starting_afresh(node, text)
            yield from _returning(node, text)
            yield from _parameters(node, text)


def turns_of(text):
    """Yields the first and last byte of what says how often a loop turns, and of its returns.

    Parameters
    ----------
    text : Text
    """
    for node in text.nodes():
        if isinstance(node, (ast.For, ast.comprehension)):
            yield text.span(node.iter)
        if isinstance(node, (ast.For, ast.While)):
            yield from (text.span(s) for s in node.body if isinstance(s, ast.Return))


def _bodies(node):
    for name in ("body", "orelse"):
        body = getattr(node, name, None)
        if isinstance(body, list) and body and not isinstance(node, (ast.Module, ast.ClassDef)):
            yield body


def _in_body(body, node, text):
    for k, statement in enumerate(body):
        if isinstance(statement, ast.Assign):
            yield from _of_assignment(statement, text)
        elif isinstance(statement, ast.AugAssign):
            yield from _of_addition(statement, text)
        elif isinstance(statement, ast.Return) and statement.value is not None:
            yield from _of_return(statement, text)
        ends = isinstance(statement, ast.Return) and isinstance(node, ast.FunctionDef)
        if isinstance(statement, SIMPLE) and not _is_text(statement) and not ends:
            yield 1, *text.span(statement), "pass"
        after = body[k + 1] if k + 1 < len(body) else None
        if isinstance(statement, ast.Assign) and isinstance(after, ast.For):
            yield from _in_the_loop(statement, after, text)
        if isinstance(statement, SIMPLE) and isinstance(after, SIMPLE):
            yield (
                1,
                *_across(statement, after, text),
                f"\n{_margin(statement)}".join((text.of(after), text.of(statement))),
            )
        if isinstance(statement, (ast.For, ast.While)):
            yield from _of_loop(statement, after, text)


def _in_the_loop(statement, loop, text):
    """What is set before a loop set at its begin too, and in the loops that stand in it."""
    while isinstance(loop, ast.For):
        first = loop.body[0]
        place = text.span(first)[0]
        yield 1, place, place, f"{text.of(statement)}\n{_margin(first)}"
        loop = next((inner for inner in loop.body if isinstance(inner, ast.For)), None)


def _is_text(statement):
    return isinstance(statement, ast.Expr) and isinstance(statement.value, ast.Constant)


def _margin(statement):
    return " " * statement.col_offset


def _across(first, last, text):
    return text.span(first)[0], text.span(last)[1]


def _of_assignment(statement, text):
    target, value = text.of(statement.targets[0]), text.of(statement.value)
    span = text.span(statement.value)
    if isinstance(statement.value, (ast.Name, ast.Subscript, ast.Attribute)):
        yield 1, *span, f"{value}.copy()"
        yield 1, *span, f"list({value})"
    if isinstance(statement.value, ast.Name):  # made anew, as the other was
        for other in _made(statement.value.id, text):
            yield 1, *span, other
    if isinstance(statement.value, ast.Call) and "stack(" in value:  # rows for columns
        yield 1, *span, f"{value}.T"
    if isinstance(statement.targets[0], (ast.Name, ast.Subscript, ast.Attribute)):
        yield 1, *span, f"{target} @ ({value})"
        yield 1, *span, f"({value}) @ {target}"
        yield 1, *span, f"{target} + {value}"
        yield from ((1, *span, f"({value}) {unit}") for unit in UNITS)
        yield 2, *span, f"{target} * ({value})"
        for function in _products(text):
            yield 1, *span, f"{function}({target}, {value})"
            yield 1, *span, f"{function}({value}, {target})"


def _made(name, text):
    """What the text sets a name to."""
    for node in text.nodes():
        if isinstance(node, ast.Assign) and any(
            isinstance(target, ast.Name) and target.id == name for target in node.targets
        ):
            yield text.of(node.value)


def _of_addition(statement, text):
    target, value = text.of(statement.target), text.of(statement.value)
    used = OPERATORS.get(type(statement.op))
    if used is None:
        return
    span = text.span(statement)
    for other in {"@": "*+", "*": "@+/", "+": "-@*", "-": "+"}.get(used, ""):
        yield 0, *span, f"{target} {other}= {value}"
    yield 0, *span, f"{target} = {target} {used} ({value})"
    if used in "@*":
        yield 0, *span, f"{target} = ({value}) @ {target}"
        yield 0, *span, f"{target} = {target} @ ({value})"
    yield 1, *span, f"{target} = {value}"


def _of_return(statement, text):
    value = text.of(statement.value)
    span = text.span(statement.value)
    yield 1, *span, f"({value}).T" if not value.isidentifier() else f"{value}.T"
    if "stack" in value:
        yield 1, *span, f"np.vstack([{value}, [0, 0, 0, 1]])"
    for name in _ends(text):
        yield 1, *span, f"{value} @ {name}"
        yield 1, *span, f"{name} @ {value}"
        for function in _products(text):
            yield 1, *span, f"{function}({value}, {name})"
            yield 1, *span, f"{function}({name}, {value})"


def _ends(text):
    """What may be a base or a tool: 4×4 numbers at the top, parameters of that name, functions
    without arguments.
    """
    for name, value in text.space.items():
        if getattr(value, "shape", None) == (4, 4) or _is_square(value):
            yield name
    for name, defined in text.functions.items():
        if not defined.args.args and ENDS.search(name):
            yield f"{name}()"
    for node in text.nodes():
        if isinstance(node, ast.Call) and "base" in text.of(node).lower():
            yield text.of(node).replace("BASE", "TOOL").replace("base", "tool")
        if isinstance(node, ast.Call) and "tool" in text.of(node).lower():
            yield text.of(node).replace("TOOL", "BASE").replace("tool", "base")
    if text.entry is not None:
        yield from (a.arg for a in text.entry.args.args if a.arg in ("base", "tool"))


def _is_square(value):
    return (
        isinstance(value, (list, tuple))
        and len(value) == 4
        and all(isinstance(row, (list, tuple)) and len(row) == 4 for row in value)
    )


def _products(text):
    """The functions that may multiply: of two arguments, and not the one that is looked at."""
    return [
        name
        for name, defined in text.functions.items()
        if len(defined.args.args) == 2 and name != text.name
    ]


def _of_loop(loop, after, text):
    """The last step of a loop behind it, and the next one into it."""
    last = loop.body[-1]
    if isinstance(last, SIMPLE):
        rank = 0 if isinstance(last, ast.Return) else 1
        yield rank, *text.span(last), f"pass\n{_margin(loop)}{text.of(last)}"
    if isinstance(after, SIMPLE) and not isinstance(after, ast.Return):
        yield (
            1,
            text.span(after)[0] - after.col_offset,
            text.span(after)[1],
            (f"{_margin(last)}{text.of(after)}"),
        )


def _starting_afresh(function, text):
    """What is kept from call to call made anew: default values, and names of the whole file."""
    first = next((s for s in function.body if not _opens(s)), None)
    if first is None:
        return
    arguments, defaults = function.args.args, function.args.defaults
    place = text.span(first)[0]
    for argument, default in zip(arguments[len(arguments) - len(defaults) :], defaults):
        if not isinstance(default, ast.Constant):
            yield 0, place, place, f"{argument.arg} = {text.of(default)}\n{_margin(first)}"
    for statement in text.blocks if function.name == text.name else ():
        if isinstance(statement, ast.Assign) and isinstance(statement.targets[0], ast.Name):
            yield 1, place, place, f"{text.of(statement)}\n{_margin(first)}"


def _of_each_object(defined, text):
    """What all objects of a class share made anew for each."""
    makers = (s for s in defined.body if isinstance(s, ast.FunctionDef) and s.name == "__init__")
    maker = next(makers, None)
    for statement in defined.body if maker is not None else ():
        if isinstance(statement, ast.Assign) and isinstance(statement.targets[0], ast.Name):
            first = next((s for s in maker.body if not _opens(s)), maker.body[-1])
            place = text.span(first)[0]
            yield 0, place, place, f"self.{text.of(statement)}\n{_margin(first)}"


def _opens(statement):
    return _is_text(statement) or isinstance(statement, (ast.Global, ast.Nonlocal))


def _returning(function, text):
    """A return where none stands at the end."""
    last = function.body[-1]
    if not isinstance(last, ast.Return):
        names = dict.fromkeys(
            node.id
            for node in ast.walk(function)
            if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)
        )
        for name in names:
            end = text.span(last)[1]
            yield 0, end, end, f"\n{_margin(last)}return {name}"


def _parameters(function, text):
    """Two parameters exchanged."""
    arguments = function.args.args
    for i, first in enumerate(arguments):
        for second in arguments[i + 1 :]:
            start, end = text.span(first)[0], text.span(second)[1]
            between = text.data[text.span(first)[1] : text.span(second)[0]].decode()
            if "=" not in between and "self" not in (first.arg, second.arg):
                yield 1, start, end, f"{text.of(second)}{between}{text.of(first)}"
