"""Changes of what turns: an elementary rotation about another axis, an angle wherever it stands in
a cosine or sine, cosines and sines exchanged in a whole formula.
"""

import ast
from itertools import permutations

from .numbers import DEG

__all__ = ["rotation_changes"]

TURNS = {  # rows of rotations about x, y and z; C, S and N stand for cos, sin and -sin
    "x": ("100", "0CN", "0SC"),
    "y": ("C0S", "010", "N0C"),
    "z": ("CN0", "SC0", "001"),
}
MOST_FACTORS = 10  # of one function
SINGLE = ast.Name, ast.Attribute, ast.Subscript, ast.Call
OF_ANGLES = ("({}) / 2", "2 * ({})", "-({})", "({}) * " + DEG, "({}) / " + DEG)


def rotation_changes(text):
    """Yields tuples of Edit that belong together.

    Parameters
    ----------
    text : Text
    """
    for node in text.nodes():
        if isinstance(node, ast.List):
            yield from _turned(node, text)
        if isinstance(node, ast.FunctionDef):
            yield from _angles(node, text)
            yield from _entries_set(node, text)
            yield from _lost_factors(node, text)
        if isinstance(node, (ast.Assign, ast.AugAssign, ast.Return)) and node.value is not None:
            yield from _flipped(node.value, text)


def _flipped(value, text):
    """Every cosine of a formula a sine, and every sine a cosine."""
    for entry in value.elts if isinstance(value, (ast.List, ast.Tuple)) else (value,):
        called = [node.func for node in ast.walk(entry) if _turning(node)]
        if len(called) > 1:
            yield tuple(text.edit(function, _sister(function, text)) for function in called)


def _lost_factors(function, text):
    """What is a factor in the function before what stands alone, in a list or an assignment."""
    factors, alone = {}, []
    for node in ast.walk(function):
        if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Mult):
            for part in (node.left, node.right):
                if isinstance(part, SINGLE) and text.of(part) not in factors:
                    factors[text.of(part)] = None
        if isinstance(node, ast.List):
            alone += [entry for entry in node.elts if _stands_alone(entry)]
        if isinstance(node, ast.Assign) and _turning(node.value):
            alone.append(node.value)
    for entry in alone if len(factors) <= MOST_FACTORS else ():
        for factor in factors:
            if factor != text.of(entry):
                yield (text.edit(entry, f"{factor} * {text.of(entry)}", 2),)


def _stands_alone(entry):
    entry = entry.operand if isinstance(entry, ast.UnaryOp) else entry
    return isinstance(entry, SINGLE)


def _turning(node):
    """ "cos" or "sin" of what is called; "" else."""
    function = getattr(node, "func", None)
    name = getattr(function, "attr", getattr(function, "id", ""))
    return name if name in ("cos", "sin") else ""


def _sister(function, text):
    shown = text.of(function)
    return shown[:-3] + {"cos": "sin", "sin": "cos"}[shown[-3:]]


def _turned(node, text):
    """An elementary rotation written out, 3×3 or 4×4, about each axis and either way."""
    rows = [row.elts for row in node.elts if isinstance(row, (ast.List, ast.Tuple))]
    n = len(node.elts)
    if n not in (3, 4) or [len(row) for row in rows] != [n] * n:
        return
    cos, sin = _cos_and_sin([entry for row in rows[:3] for entry in row[:3]], text)
    if cos is None:
        return
    words = {"0": "0.0", "1": "1.0", "C": cos, "S": sin, "N": f"-{sin}"}
    for turn in TURNS.values():
        for way in (turn, tuple(map("".join, zip(*turn)))):
            new = [[words[letter] for letter in row] for row in way]
            for i, row in enumerate(new):
                row.extend(text.of(entry) for entry in rows[i][3:])
            new.extend([text.of(entry) for entry in row] for row in rows[3:])
            yield (text.edit(node, f"[{', '.join('[' + ', '.join(r) + ']' for r in new)}]"),)


def _entries_set(function, text):
    """The entries of a rotation, set one by one, set for another axis."""
    found = {}
    for node in ast.walk(function):
        if isinstance(node, ast.Subscript) and isinstance(node.ctx, ast.Store):
            name, indices = _indices(node)
            if len(indices) == 2 and all(index.value in (0, 1, 2) for index in indices):
                found.setdefault(text.of(name), []).extend(indices)
    for indices in found.values():
        for order in permutations(range(3)) if len(indices) == 8 else ():
            yield tuple(text.edit(index, str(order[index.value])) for index in indices)


def _indices(node):
    """The name, and the two constant indices, of T[i, k] or T[i][k]."""
    inner, index = node.value, node.slice
    if isinstance(inner, ast.Subscript):
        name, indices = inner.value, [inner.slice, index]
    else:
        name, indices = inner, index.elts if isinstance(index, ast.Tuple) else []
    constant = all(isinstance(i, ast.Constant) for i in indices)
    return name, indices if constant else []


def _cos_and_sin(entries, text):
    """The texts of the only two things that stand in a rotation beside 0 and 1, the cosine first;
    (None, None) where it is none.
    """
    found = {}
    for entry in entries:
        if isinstance(entry, ast.UnaryOp) and isinstance(entry.op, ast.USub):
            entry = entry.operand
        if isinstance(entry, ast.Constant):
            if entry.value not in (0, 1):
                return None, None
        elif isinstance(entry, (ast.Call, ast.Name)):
            found.setdefault(text.of(entry), []).append(entry)
        else:
            return None, None
    names = sorted(found, key=lambda name: "s" in name.replace("cos", "c").split("(")[0])
    return tuple(names) if len(names) == 2 else (None, None)


def _angles(function, text):
    """One angle changed wherever a cosine or a sine of it is taken in a function."""
    found = {}
    for node in ast.walk(function):
        if _turning(node) and len(node.args) == 1:
            found.setdefault(text.of(node.args[0]), []).append(node.args[0])
    for shown, places in found.items():
        others = (other for other in found if other != shown)
        for new in (*(form.format(shown) for form in OF_ANGLES), *others):
            if len(places) > 1:
                yield tuple(text.edit(place, new) for place in places)
