"""Changes of a formula as a whole: two of its signs, a name wherever it stands in a statement, a
conjugate, what a matrix is multiplied with.
"""

import ast
from itertools import combinations

from ..text import Edit
from .names import name_called
from .operators import one_moved

__all__ = ["formula_changes"]

MOST_SIGNS = 12  # in one formula, of which two are tried at a time
MOST_NAMES = 6  # in a row, of which two are exchanged
SAME = 2  # places of a name in a statement that are changed together
CLAMPS = {"min", "max", "clip", "fmod", "mod", "minimum", "maximum", "remainder"}


def formula_changes(text):
    """Yields tuples of Edit that belong together.

    Parameters
    ----------
    text : Text
    """
    for node in text.nodes():
        if isinstance(node, (ast.Assign, ast.AugAssign, ast.Return)) and node.value is not None:
            yield from _two_signs(node.value, text)
        if isinstance(node, (ast.List, ast.Tuple, ast.Assign)):
            yield from _names_exchanged(node, text)
        if isinstance(node, ast.List):
            yield from _conjugate(node, text)
        if isinstance(node, ast.BinOp):
            yield from _out_of_brackets(node, text)
        if isinstance(node, ast.Call):
            yield from _unclamped(node, text)
            yield from _in_a_chain(node, text)
        if isinstance(node, ast.FunctionDef):
            yield from _renamed(node, text)


def _two_signs(formula, text):
    """Two of the plus and minus signs of a formula turned; single ones are tried elsewhere."""
    for entry in formula.elts if isinstance(formula, (ast.List, ast.Tuple)) else (formula,):
        signs = [
            node
            for node in ast.walk(entry)
            if isinstance(node, ast.BinOp) and isinstance(node.op, (ast.Add, ast.Sub))
        ]
        if len(signs) <= MOST_SIGNS:
            for pair in combinations(signs, 2):
                yield tuple(_turned_sign(node, text) for node in pair)


def _turned_sign(node, text):
    """The operator alone, so that two of one formula do not overlap."""
    start, end = text.span(node.left)[1], text.span(node.right)[0]
    old, new = (b"+", b"-") if isinstance(node.op, ast.Add) else (b"-", b"+")
    return Edit(start, end, text.data[start:end].replace(old, new, 1), 2)


def _conjugate(node, text):
    """All entries but one turned: of a quaternion, w first or last."""
    if not 3 <= len(node.elts) <= 4 or any(isinstance(e, (ast.List, ast.Tuple)) for e in node.elts):
        return
    turned = [_turned_entry(entry, text) for entry in node.elts]
    kept = [text.of(entry) for entry in node.elts]
    for chosen in (kept[:1] + turned[1:], turned[:-1] + kept[-1:]):
        yield (text.edit(node, f"[{', '.join(chosen)}]"),)


def _turned_entry(entry, text):
    if isinstance(entry, ast.UnaryOp) and isinstance(entry.op, ast.USub):
        return text.of(entry.operand)
    shown = text.of(entry)
    return f"-({shown})" if isinstance(entry, ast.BinOp) else f"-{shown}"


def _renamed(function, text):
    """A name that stands twice in a statement, and once on each side or in two cosines and sines,
    another one at each of its places.
    """
    known = dict.fromkeys(
        node.id
        for node in ast.walk(function)
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)
    )
    known |= dict.fromkeys(argument.arg for argument in function.args.args)
    for statement in ast.walk(function):
        if not isinstance(statement, (ast.Assign, ast.AugAssign)):
            continue
        places = {}
        for node in ast.walk(statement):
            if isinstance(node, ast.Name):
                places.setdefault(node.id, []).append(node)
        for name, nodes in places.items():
            if len(nodes) == SAME and name in known:
                for other in known:
                    if other not in places:
                        yield tuple(text.edit(node, other) for node in nodes)
        yield from _indexed_anew(statement, text)


def _indexed_anew(statement, text):
    """A part of a row that is taken twice in a statement, another part at both places."""
    places = {}
    for node in ast.walk(statement):
        if isinstance(node, ast.Subscript) and isinstance(node.slice, ast.Constant):
            places.setdefault(text.of(node), []).append(node)
    for nodes in places.values():
        if len(nodes) == SAME:
            for index in range(4):
                yield tuple(text.edit(node.slice, str(index)) for node in nodes)


def _names_exchanged(node, text):
    """Two names exchanged, each wherever it stands in a row or a statement of one line."""
    value = node.value if isinstance(node, ast.Assign) else node
    parts = value.elts if isinstance(value, (ast.List, ast.Tuple)) else [value]
    if any(isinstance(part, (ast.List, ast.Tuple)) for part in parts) or not parts:
        return
    places = {}
    for part in ast.walk(value):
        if isinstance(part, ast.Name) and part.id not in text.space | text.defined:
            places.setdefault(part.id, []).append(part)
    for one, other in combinations(places, 2) if len(places) <= MOST_NAMES else ():
        yield tuple(
            text.edit(part, new)
            for name, new in ((one, other), (other, one))
            for part in places[name]
        )


# ---- products and calls


def _out_of_brackets(node, text):
    """x + M y for M (x + y), and the other way round; of numbers too."""
    left, right = node.left, node.right
    if isinstance(node.op, ast.MatMult) and _is_sum(right):
        for x, y in ((right.left, right.right), (right.right, right.left)):
            yield (text.edit(node, f"({text.of(x)} + {text.of(left)} @ ({text.of(y)}))"),)
    if isinstance(node.op, ast.Mult):
        for both, factor in ((left, text.of(right)), (right, text.of(left))):
            if _is_sum(both):
                x, y = text.of(both.left), text.of(both.right)
                yield (text.edit(node, f"({x} * {factor} + {y})"),)
                yield (text.edit(node, f"({x} + {y} * {factor})"),)
    if isinstance(node.op, ast.Add):
        for product, other in ((left, right), (right, left)):
            if isinstance(product, ast.BinOp) and isinstance(product.op, (ast.Mult, ast.MatMult)):
                x, y, sign = text.of(product.left), text.of(product.right), _sign(product)
                yield (text.edit(node, f"(({x} + {text.of(other)}) {sign} {y})"),)
                yield (text.edit(node, f"({x} {sign} ({y} + {text.of(other)}))"),)


def _is_sum(node):
    return isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add)


def _sign(product):
    return "*" if isinstance(product.op, ast.Mult) else "@"


def _in_a_chain(node, text):
    """Calls of methods one behind the other, ``a.f(x).g(y)``, in another order."""
    links, inner = [], node
    while isinstance(inner, ast.Call) and isinstance(inner.func, ast.Attribute):
        start, end = text.span(inner.func.value)[1], text.span(inner)[1]
        links.insert(0, text.data[start:end].decode())
        inner = inner.func.value
    if 2 <= len(links) <= MOST_NAMES:
        for other in one_moved(links):
            yield (text.edit(node, text.of(inner) + "".join(other)),)


def _unclamped(node, text):
    """The value itself, where its least, its largest or its rest is taken."""
    inner, depth = node, 0
    while isinstance(inner, ast.Call) and name_called(inner) in CLAMPS and inner.args:
        inner = next((a for a in inner.args if _holds_call(a)), None) or next(
            (a for a in inner.args if not _is_constant(a)), inner.args[0]
        )
        depth += 1
    if depth:
        yield (text.edit(node, f"({text.of(inner)})"),)


def _holds_call(node):
    return isinstance(node, ast.Call) and name_called(node) in CLAMPS | {"sin", "cos"}


def _is_constant(node):
    """Whether it is a number, π or a part of it."""
    return not any(
        isinstance(part, ast.Name) and part.id not in ("np", "math", "numpy", "pi", "PI")
        for part in ast.walk(node)
    )
