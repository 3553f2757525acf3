"""Matrices and expressions to read: a textbook's shorthand, and LaTeX."""

from .numbers import Expression, the_sympy

__all__ = ["short", "latex"]


def short(T: Expression) -> Expression:
    """The same in a textbook's shorthand: ``cos(q_2 + q_3)`` becomes ``c_23``, ``sin(q_2 - q_3)``
    becomes ``s_2-3``; to read, not to compute with.

    Examples
    --------
    >>> from dhlab.symbolic import variables
    >>> q1, q2 = variables(2)
    >>> short(the_sympy().cos(q1 + q2))
    c_{12}
    """
    sympy = the_sympy()
    names = {}
    for call in T.atoms(sympy.cos, sympy.sin):
        label = _label(call.args[0])
        if label:
            names[call] = sympy.Symbol(f"{'c' if call.func is sympy.cos else 's'}_{{{label}}}")
    return T.xreplace(names)


def _label(angle):
    """ "23" for q_2 + q_3, "2-3" for q_2 - q_3, None for anything else."""
    terms = angle.as_ordered_terms() if angle.is_Add else [angle]
    label = ""
    for term in sorted(terms, key=lambda term: sorted(map(str, term.free_symbols))):
        sign, symbol = term.as_coeff_Mul()
        if abs(sign) != 1 or not symbol.is_Symbol or not symbol.name.startswith("q_"):
            return None
        label += ("-" if sign < 0 else "") + symbol.name[2:]
    return label


def latex(T: Expression, shorthand: bool = True) -> str:
    """LaTeX of a matrix or expression, in shorthand (:func:`short`) unless told otherwise.

    Examples
    --------
    >>> from dhlab.symbolic import variables
    >>> q1, q2 = variables(2)
    >>> latex(the_sympy().cos(q1 + q2))
    'c_{12}'
    """
    return the_sympy().latex(short(T) if shorthand else T)
