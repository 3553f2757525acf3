"""Link matrices that a text multiplies together, step by step, from elementary ones of its own:
``h = np.matmul(np.matmul(A, B), C)``, where A, B and C stand in the text as matrices.
"""

import re

import numpy as np

from .....transform import rot_x, rot_z, trans
from ...language.brackets import groups
from ...language.expressions import NoExpression, evaluate
from .entries import in_rows
from .matrices import INDEX

__all__ = ["multiplied_moves"]

BY = 0.3  # what the one letter of an elementary matrix is taken for
MOVES = {"Rz": rot_z(BY), "Rx": rot_x(BY), "Tz": trans([0, 0, BY]), "Tx": trans([BY, 0, 0])}
STATEMENT = re.compile(r"\b(\w+)(?:\.(?:append|push_back|add)\(|\s*(?<![=!<>])=(?!=))([^\n;]+)")
WORDS = {"np", "numpy", "matmul", "dot", "linalg", "multi_dot", "mtimes", "times", "copy"}


def multiplied_moves(code):
    """The elementary moves, as "Rz" and "Tx", of the first product of four that the text makes of
    its own matrices; () where it makes none.

    Examples
    --------
    >>> multiplied_moves('''A = [[cos(t), -sin(t), 0, 0], [sin(t), cos(t), 0, 0], [0, 0, 1, 0],
    ...  [0, 0, 0, 1]]
    ... B = [[1, 0, 0, l], [0, 1, 0, 0], [0, 0, 1, d], [0, 0, 0, 1]]
    ... T = A @ B''')
    ()
    """
    held = _elementary(code)
    for name, said in STATEMENT.findall(code) if len(held) == len(MOVES) else ():
        parts = re.findall(r"[A-Za-z_]\w*", INDEX.sub("", said))
        parts = [part for part in parts if part not in WORDS]
        if not parts or not all(part in held for part in parts):
            continue
        held.setdefault(name, sum((held[part] for part in parts), ()))
        if len(held[name]) == len(MOVES):
            return held[name]
    return ()


def _elementary(code):
    """{name: (move,)} of the matrices in the text that are one elementary move each."""
    held: dict = {}
    for group in groups(code):
        owner = group
        while owner is not None and not owner.target:
            owner = owner.outer
        cells = in_rows(group) if owner is not None and 20 < len(group.text) < 600 else []
        if len(cells) == 16 and (move := _move(cells)):
            held.setdefault(owner.target, (move,))
    return held


def _move(cells):
    """The name of the elementary move that a matrix is; "" of others."""
    text = INDEX.sub("", "\n".join(cells))
    letters = set(re.findall(r"(?<![\w.])([A-Za-z_]\w*)(?![\w.]|\s*\()", text))
    if len(letters) != 1:
        return ""
    try:
        values = [evaluate(cell, {letters.copy().pop(): BY}) for cell in text.split("\n")]
    except NoExpression:
        return ""
    M = np.array([value.number for value in values]).reshape(4, 4)
    return next((name for name, move in MOVES.items() if np.allclose(M, move)), "")
