"""The derivation in SymPy: the link matrix from its four elementary moves, the product of a whole
arm, its derivatives; all as LaTeX in a notebook.

Needs the extra ``symbolic`` (``pip install dhlab-kinematics[symbolic]``). Angles are radians and
lengths metres, as exact numbers or as symbols.
"""

from dataclasses import dataclass

from ..arm import Arm
from ..table import CONVENTIONS, DHTable
from .gathered import gathered_product
from .numbers import elementary, exact, exact_pose, the_sympy

__all__ = [
    "Step",
    "Steps",
    "steps",
    "link",
    "product",
    "variables",
    "derivative",
    "short",
    "latex",
    "exact",
]

# the order of the moves: Siciliano et al., Robotics, eq. 2.52; Craig, Introduction to Robotics, eq.
# 3.6
MOVES = {
    "standard": (
        ("Rot", "z", "theta"),
        ("Trans", "z", "d"),
        ("Trans", "x", "a"),
        ("Rot", "x", "alpha"),
    ),
    "craig": (
        ("Rot", "x", "alpha"),
        ("Trans", "x", "a"),
        ("Rot", "z", "theta"),
        ("Trans", "z", "d"),
    ),
}


@dataclass(frozen=True)
class Step:
    """One elementary move of the link matrix: ``name``, its own ``matrix`` and the ``product`` of
    all moves so far (SymPy).
    """

    name: str
    matrix: object
    product: object

    def _repr_latex_(self):
        return f"${self._latex()}$"

    def _latex(self):
        kind, axis, symbol = self.name.replace("(", " ").replace(")", "").replace(",", "").split()
        greek = {"theta": r"\theta", "alpha": r"\alpha"}.get(symbol, symbol)
        return (
            rf"\mathrm{{{kind}}}({axis}, {greek}) = {latex(self.matrix)} \qquad \text{{so far: }}"
            rf" {latex(self.product)}"
        )


class Steps(tuple):
    """The four moves in their order; a notebook shows them one below the other."""

    def _repr_latex_(self):
        return (
            r"$$\begin{array}{l}"
            + r" \\[2ex] ".join(step._latex() for step in self)
            + r"\end{array}$$"
        )


def steps(convention="standard"):
    """The link matrix built up from its four elementary moves, each multiplied on the right.

    Parameters
    ----------
    convention : "standard" or "craig"

    Returns
    -------
    Steps
        A tuple of four :class:`Step`; the last one's ``product`` is the link matrix.

    Raises
    ------
    ValueError
        An unknown convention, or SymPy is missing.

    Examples
    --------
    >>> [step.name for step in steps()]
    ['Rot(z, theta)', 'Trans(z, d)', 'Trans(x, a)', 'Rot(x, alpha)']
    >>> steps()[-1].product == link()
    True
    """
    return Steps(_steps(_symbols("theta d a alpha"), _known(convention)))


def _steps(values, convention):
    running = the_sympy().eye(4)
    for kind, axis, name in MOVES[convention]:
        matrix = elementary(kind, axis, values[name])
        running = running * matrix
        yield Step(f"{kind}({axis}, {name})", matrix, running)


def link(theta=None, d=None, a=None, alpha=None, convention="standard"):
    """The matrix of one row.

    Parameters
    ----------
    theta, d, a, alpha : number or SymPy expression, optional
        Radians and metres; a symbol of that name when left out. Numbers are made exact
        (:func:`exact`).
    convention : "standard" or "craig"

    Returns
    -------
    sympy.Matrix (4, 4)

    Examples
    --------
    >>> import math
    >>> link(alpha=math.pi / 2)[:3, :3]
    Matrix([
    [cos(theta), 0,  sin(theta)],
    [sin(theta), 0, -cos(theta)],
    [         0, 1,           0]])
    """
    values = _symbols("theta d a alpha")
    for name, given in {"theta": theta, "d": d, "a": a, "alpha": alpha}.items():
        if given is not None:
            values[name] = exact(given, "angle" if name in ("theta", "alpha") else "length")
    return list(_steps(values, _known(convention)))[-1].product


def variables(n):
    """The joint variables ``q_1 … q_n`` as :func:`product` uses them.

    Examples
    --------
    >>> variables(2)
    (q_1, q_2)
    """
    return tuple(the_sympy().Symbol(f"q_{i}", real=True) for i in range(1, n + 1))


def product(table_or_arm, fixed=None):
    """The end pose as formulas in the joint variables, base, tool and signs included.

    Turns about parallel axes are gathered before anything is multiplied, so ``cos(q_2 + q_3)``
    stands where a plain product has four terms. Numbers are exact; only a constant that would take
    more than 40 operations to write is a decimal of 16 digits.

    Parameters
    ----------
    table_or_arm : DHTable or Arm
    fixed : dict, optional
        Joint number (from 1) to its value, radians or metres, or a SymPy expression; the other
        joints stay symbols.

    Returns
    -------
    sympy.Matrix (4, 4)

    Raises
    ------
    ValueError
        Something else than a table or an arm, or a joint it does not have.

    Examples
    --------
    >>> from dhlab.table import DHTable
    >>> product(DHTable.standard([[0, 0, 0.4, 0], [0, 0, 0.35, 0]], angle="deg"))[:2, 3]
    Matrix([
    [2*cos(q_1)/5 + 7*cos(q_1 + q_2)/20],
    [2*sin(q_1)/5 + 7*sin(q_1 + q_2)/20]])
    """
    arm = Arm(table_or_arm) if isinstance(table_or_arm, DHTable) else table_or_arm
    if not isinstance(arm, Arm):
        raise ValueError(
            f"product: expected a DHTable or an Arm, found {type(arm).__name__}; make one with"
            " DHTable.standard or dhlab.load"
        )
    return gathered_product(*_chain(arm, _joint_values(arm, fixed or {})))


def _joint_values(arm, fixed):
    values = dict(enumerate(variables(len(arm)), 1))
    for i, value in fixed.items():
        if i not in values:
            raise ValueError(
                f"product: fixed: expected joints from 1 to {len(arm)}, found {i!r}; joints are"
                " counted from 1"
            )
        values[i] = exact(value, "length" if arm.table.joints[i - 1] == "P" else "angle")
    return values


def _chain(arm, values):
    """``(before, rows, after)``: a list of ``(turn, shift)`` about and along z, each with the
    constant matrix behind it.
    """
    table, craig = arm.table, arm.table.convention == "craig"
    before, after, rows = exact_pose(arm.base), exact_pose(arm.tool), []
    for i, (theta, d, a, alpha) in enumerate(table.rows):
        turn, shift = exact(theta, "angle"), exact(d, "length")
        moved = int(arm.sign[i]) * values[i + 1]
        turn, shift = (turn, shift + moved) if table.prismatic[i] else (turn + moved, shift)
        bend = elementary("Trans", "x", exact(a, "length")) * elementary(
            "Rot", "x", exact(alpha, "angle")
        )
        if not craig:
            rows.append((turn, shift, bend))
            continue
        if rows:  # a Craig row bends before it turns: that bend belongs behind the row before
            rows[-1] = (*rows[-1][:2], bend)
        else:
            before = before * bend
        rows.append((turn, shift, the_sympy().eye(4)))
    return before, rows, after


def derivative(T, q):
    """The partial derivative of a matrix (or expression) with respect to one joint variable.

    Parameters
    ----------
    T : sympy.Matrix or expression
        From :func:`product`.
    q : int or symbol
        The joint's number, or ``variables(n)[i - 1]``.

    Returns
    -------
    sympy.Matrix or expression
        Of the shape of T; the last column of dT/dq_i is column i of the position rows of
        ``arm.jacobian``.

    Examples
    --------
    >>> from dhlab.table import DHTable
    >>> derivative(product(DHTable.standard([[0, 0, 0.4, 0]], angle="deg")), 1)[1, 3]
    2*cos(q_1)/5
    """
    sympy = the_sympy()
    symbol = variables(q)[-1] if isinstance(q, int) and not isinstance(q, bool) and q > 0 else q
    if not isinstance(symbol, sympy.Symbol):
        raise ValueError(
            f"derivative: expected the number of a joint (from 1) or its symbol, found {q!r}; see"
            " dhlab.symbolic.variables"
        )
    return sympy.diff(T, symbol)


def short(T):
    """The same in a textbook's shorthand: ``cos(q_2 + q_3)`` becomes ``c_23``, ``sin(q_2 - q_3)``
    becomes ``s_2-3``; to read, not to compute with.

    Examples
    --------
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


def latex(T, shorthand=True):
    """LaTeX of a matrix or expression, in shorthand (:func:`short`) unless told otherwise.

    Examples
    --------
    >>> q1, q2 = variables(2)
    >>> latex(the_sympy().cos(q1 + q2))
    'c_{12}'
    """
    return the_sympy().latex(short(T) if shorthand else T)


def _symbols(names):
    return {name: the_sympy().Symbol(name, real=True) for name in names.split()}


def _known(convention):
    if convention not in CONVENTIONS:
        raise ValueError(
            f'symbolic: expected the convention "standard" or "craig", found {convention!r};'
            ' "modified" is "craig" here'
        )
    return convention
