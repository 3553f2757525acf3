"""The end pose of a whole arm as formulas in its joint variables, and their derivatives."""

from collections.abc import Mapping

from ..arm import Arm
from ..table import DHTable
from .gathered import gathered_product
from .numbers import Expression, Matrix, elementary, exact, exact_pose, the_sympy

__all__ = ["product", "variables", "derivative"]


def variables(n: int) -> tuple[Expression, ...]:
    """The joint variables ``q_1 … q_n`` as :func:`product` uses them.

    Examples
    --------
    >>> variables(2)
    (q_1, q_2)
    """
    return tuple(the_sympy().Symbol(f"q_{i}", real=True) for i in range(1, n + 1))


def product(table_or_arm: DHTable | Arm, fixed: Mapping[int, Expression] | None = None) -> Matrix:
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


def _moved(arm, values, i):
    """What the joint of row ``i`` (0-based) makes of the variables."""
    if arm.coupling is None:
        return int(arm.sign[i]) * values[i + 1]
    rates = [exact(rate, "length") for rate in arm.coupling[i] * arm.sign]
    return sum(rate * values[j] for j, rate in enumerate(rates, 1))


def _chain(arm, values):
    """``(before, rows, after)``: a list of ``(turn, shift)`` about and along z, each with the
    constant matrix behind it.
    """
    table, craig = arm.table, arm.table.convention == "craig"
    before, after, rows = exact_pose(arm.base), exact_pose(arm.tool), []
    for i, (theta, d, a, alpha) in enumerate(table.rows):
        turn, shift = exact(theta, "angle"), exact(d, "length")
        moved = _moved(arm, values, i)
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


def derivative(T: Matrix, q: int | Expression) -> Matrix:
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
