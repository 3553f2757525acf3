"""What may stand in place of an expression in which something went wrong: a sign, a factor, another
order, another index, a function's sister, a unit.
"""

import ast
from itertools import combinations, permutations

from .names import SISTERS, is_method, name_called, of_attribute, of_name
from .numbers import DEG, of_constant
from .operators import in_other_orders, is_product, moved_addends, of_two, one_moved, whole

__all__ = ["in_place_of"]

WRAPPERS = {
    "deg2rad", "rad2deg", "radians", "degrees", "abs", "fabs", "round", "int", "rint", "floor",
    "trunc", "transpose", "inv", "reversed", "sorted", "sqrt", "flip", "cumsum", "astype", "around",
    "sign",
}  # fmt: skip
MOST_MOVED = 7  # arguments of which one is moved elsewhere
UNITS = {"deg2rad", "rad2deg", "radians", "degrees"}
TURNED = f"* {DEG}", f"/ {DEG}"
SIGNS = {ast.Lt: "<=", ast.LtE: "<", ast.Gt: ">=", ast.GtE: ">", ast.Eq: "!=", ast.NotEq: "=="}


def in_place_of(node, parent, scope, text):
    """What may be meant by an expression.

    Parameters
    ----------
    node, parent : ast nodes
    scope : Scope
        The names that may be used there.
    text : Text

    Yields
    ------
    (int, str)
        A rank, 0 for what goes wrong most often, and the text that would stand there.
    """
    kind = {
        ast.BinOp: of_two,
        ast.UnaryOp: _of_sign,
        ast.Constant: of_constant,
        ast.Call: _of_call,
        ast.Attribute: of_attribute,
        ast.Name: of_name,
        ast.Slice: _of_slice,
        ast.Compare: _of_comparison,
        ast.IfExp: _of_choice,
        ast.Tuple: _of_list,
        ast.List: _of_list,
        ast.Subscript: _of_subscript,
    }.get(type(node))
    if kind is not None:
        yield from kind(node, parent, scope, text)
    if _is_number(node, parent):
        yield 1, f"-{whole(node, text)}"
    if _is_term(node, parent, scope):
        yield from ((1, f"({text.of(node)} {unit})") for unit in TURNED)
    if isinstance(parent, ast.Subscript) and isinstance(node, ast.BinOp):
        yield 1, f"{text.of(node)} - 1"
        yield 1, f"{text.of(node)} + 1"
        yield from _names_exchanged(node, text)
    if isinstance(node, (ast.Name, ast.Subscript)) and _is_number(node, parent):
        for name in scope.unused:
            yield 0, f"({name} + {text.of(node)})"
            yield 0, f"{name} * {text.of(node)}"
        for row in _row_of(node, scope, text):
            yield 1, f"({row}[0] + {text.of(node)})"


def _is_number(node, parent):
    """Whether a minus may be missing before it."""
    return isinstance(node, (ast.Name, ast.Call, ast.BinOp, ast.Subscript, ast.Attribute)) and (
        isinstance(parent, (ast.BinOp, ast.List, ast.Tuple, ast.Assign, ast.AugAssign))
        or (isinstance(parent, ast.Call) and node in parent.args)
    )


def _is_term(node, parent, scope):
    """Whether it may be an angle in the wrong unit: of a sum, in a tuple, or handed on."""
    if not isinstance(node, (ast.Name, ast.Subscript, ast.Attribute)):
        return False
    if isinstance(parent, ast.BinOp):
        return isinstance(parent.op, (ast.Add, ast.Sub))
    own = isinstance(parent, ast.Call) and getattr(parent.func, "id", "") in scope.functions
    return isinstance(parent, ast.Tuple) or (own and node in parent.args)


def _names_exchanged(node, text):
    names = [part for part in ast.walk(node) if isinstance(part, ast.Name)]
    start = text.span(node)[0]
    for first, second in combinations(names, 2):
        if first.id != second.id:
            shown = text.of(node).encode()
            parts = sorted((first, second), key=lambda part: text.span(part))
            (a, b), (c, d) = ((i - start, k - start) for i, k in map(text.span, parts))
            new = shown[:a] + shown[c:d] + shown[b:c] + shown[a:b] + shown[d:]
            yield 1, new.decode()


def _row_of(node, scope, text):
    """The row that a joint value belongs to, as it may be written there."""
    if (
        isinstance(node, ast.Subscript)
        and isinstance(node.value, ast.Name)
        and node.value.id in scope.parameters[1:2]
    ):
        yield f"{scope.parameters[0]}[{text.of(node.slice)}]"
    yield from scope.rows


def _of_sign(node, parent, scope, text):
    if isinstance(node.op, ast.USub):
        yield 0, whole(node.operand, text)
    if isinstance(parent, ast.Subscript):
        yield from ((0, name) for name in scope.around)


def _of_call(node, parent, scope, text):
    function = node.func
    name = name_called(node)
    arguments = [text.of(argument) for argument in node.args]
    keywords = [text.of(keyword) for keyword in node.keywords]
    called = text.of(function)

    def call(arguments, keywords=keywords, called=called):
        return f"{called}({', '.join([*arguments, *keywords])})"

    if name in ("dot", "matmul") and not is_product(parent):
        yield from in_other_orders(node, text)
    if name in ("arctan", "atan") and isinstance(getattr(node.args[0], "op", None), ast.Div):
        quotient = [text.of(node.args[0].left), text.of(node.args[0].right)]
        yield 0, call(quotient, called=f"{called}2")
    if name == "exp":
        yield from ((0, call([f"1j * ({one})"])) for one in arguments)
    if name in SISTERS:
        yield 0, call(arguments, called=called[: -len(name)] + SISTERS[name])
    if name in WRAPPERS:
        inner = arguments[:1] or [text.of(function.value)] if is_method(node) else arguments[:1]
        yield from ((0, f"({one})") for one in inner)
    if name in UNITS and isinstance(getattr(node.args[0], "op", None), (ast.Add, ast.Sub)):
        left, right = text.of(node.args[0].left), text.of(node.args[0].right)
        sign = "+" if isinstance(node.args[0].op, ast.Add) else "-"
        yield 0, f"({call([left])} {sign} {right})"
        yield 0, f"({left} {sign} {call([right])})"
    if is_method(node) and name in WRAPPERS | {"copy", "tolist"}:
        yield 0, text.of(function.value)
    for k, keyword in enumerate(node.keywords):
        rest = keywords[:k] + keywords[k + 1 :]
        if keyword.arg == "dtype":
            yield 0, call(arguments, [*rest, "dtype=float"])
        yield 0, call(arguments, rest)
    own = name in scope.functions
    for i, k in combinations(range(len(arguments)), 2):
        other = list(arguments)
        other[i], other[k] = other[k], other[i]
        yield 0 if own or len(arguments) == 2 else 1, call(other)
    yield from ((1, call(other)) for other in moved_addends(node.args, text))
    if own and len(arguments) == 3:
        yield from ((1, call(other)) for other in permutations(arguments))
    if 3 < len(arguments) <= MOST_MOVED:
        yield from ((1, call(other)) for other in one_moved(arguments))
    for k in range(len(arguments)):
        if len(arguments) > 1:
            yield 0 if name == "range" else 2, call(arguments[:k] + arguments[k + 1 :])
    if name == "range" and len(arguments) == 2 and isinstance(node.args[1], ast.BinOp):
        yield 0, call([text.of(node.args[1].left)])
    if name == "range":
        yield 1, call([*arguments[:-1], f"{arguments[-1]} + 1"])
    if own and len(arguments) == 1:
        yield 1, f"({arguments[0]})"
    for other in scope.functions if own else ():
        if other != name and scope.functions[other] == scope.functions[name]:
            yield 1, call(arguments, called=other)
        if 0 < scope.functions[other] < len(arguments) <= MOST_MOVED:
            for fewer in combinations(arguments, scope.functions[other]):
                yield 2, call(fewer, called=other)
    if name in ("cos", "sin") and arguments:
        yield 1, call([f"({arguments[0]}) / 2"])
        yield 2, call([f"2 * ({arguments[0]})"])
        yield 1, call([f"({arguments[0]}) * {DEG}"])
        yield 1, call([f"({arguments[0]}) / {DEG}"])
    if name == "array" and "int" in "".join(keywords):
        yield 0, call(arguments, ["dtype=float"])


def _of_subscript(node, parent, scope, text):
    """Swapped indices, and the whole in place of a part."""
    if isinstance(parent, ast.Return):
        yield 0, text.of(node.value)
    if isinstance(node.slice, ast.Tuple) and len(node.slice.elts) == 2:
        i, k = (text.of(index) for index in node.slice.elts)
        yield 1, f"{text.of(node.value)}[{k}, {i}]"
    inner = node.value
    if isinstance(inner, ast.Subscript):
        base = text.of(inner.value)
        yield 1, f"{base}[{text.of(node.slice)}][{text.of(inner.slice)}]"
    if isinstance(inner, (ast.List, ast.Tuple)) and isinstance(node.slice, ast.Tuple):
        yield 0, f"{text.of(inner)}, [{text.of(node.slice)}]"  # a comma is missing


def _of_slice(node, parent, scope, text):
    parts = [node.lower, node.upper, node.step]
    shown = [text.of(part) if part is not None else "" for part in parts]
    for k, part in enumerate(parts):
        if part is not None:
            kept = shown[:k] + [""] + shown[k + 1 :]
            yield 0, ":".join(kept[: 3 if kept[2] else 2])
    yield from ((2, part) for part in (":3", "1:", "1:4", ":-1") if part != text.of(node))


def _of_comparison(node, parent, scope, text):
    if len(node.ops) == 1 and type(node.ops[0]) in SIGNS:
        left, right = text.of(node.left), text.of(node.comparators[0])
        yield 1, f"{left} {SIGNS[type(node.ops[0])]} {right}"
    yield 1, f"not ({text.of(node)})"
    yield 1, "True"
    yield 1, "False"


def _of_choice(node, parent, scope, text):
    yield 1, text.of(node.body)
    yield 1, text.of(node.orelse)


def _of_list(node, parent, scope, text):
    """Entries in another order: two exchanged, or all moved on by one; or what was added to one of
    them added to another.
    """
    parts = [text.of(part) for part in node.elts]
    if not 2 <= len(parts) <= 4 or isinstance(parent, ast.Subscript):
        return
    first, last = text.of(node)[0], text.of(node)[-1]
    around = (first, last) if first in "[(" and last in "])" else ("", "")
    orders = list(combinations(range(len(parts)), 2))
    stored = isinstance(node.ctx, ast.Store)
    for i, k in orders:
        other = list(parts)
        other[i], other[k] = other[k], other[i]
        yield 0 if stored else 1, ", ".join(other).join(around)
    yield from ((1, ", ".join(other).join(around)) for other in moved_addends(node.elts, text))
    if len(parts) > 2:
        yield 0 if stored else 1, ", ".join(parts[1:] + parts[:1]).join(around)
        yield 0 if stored else 1, ", ".join(parts[-1:] + parts[:-1]).join(around)
