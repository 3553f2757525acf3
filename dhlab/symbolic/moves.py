"""The link matrix, built up from its four elementary moves."""

from dataclasses import dataclass

from ..table import CONVENTIONS
from .numbers import Expression, Matrix, elementary, exact, the_sympy
from .shorthand import latex

__all__ = ["Step", "Steps", "steps", "link"]


# the order: Siciliano et al., Robotics, eq. 2.52; Craig, Introduction to Robotics, eq. 3.6
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

    Examples
    --------
    >>> import dhlab as dh
    >>> last = dh.symbolic.steps("craig")[-1]
    >>> last.name, last.matrix[2, 3], last.product[2, 3]
    ('Trans(z, d)', d, d*cos(alpha))
    """

    name: str
    matrix: Matrix
    product: Matrix

    def _repr_latex_(self) -> str:
        return f"${self._latex()}$"

    def _latex(self):
        kind, axis, symbol = self.name.replace("(", " ").replace(")", "").replace(",", "").split()
        greek = {"theta": r"\theta", "alpha": r"\alpha"}.get(symbol, symbol)
        return (
            rf"\mathrm{{{kind}}}({axis}, {greek}) = {latex(self.matrix)} \qquad \text{{so far: }}"
            rf" {latex(self.product)}"
        )


class Steps(tuple[Step, ...]):
    """The four moves in their order; a notebook shows them one below the other.

    Examples
    --------
    >>> import dhlab as dh
    >>> len(dh.symbolic.steps("standard"))
    4
    """

    def _repr_latex_(self) -> str:
        return (
            r"$$\begin{array}{l}"
            + r" \\[2ex] ".join(step._latex() for step in self)
            + r"\end{array}$$"
        )


def steps(convention: str = "standard") -> Steps:
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


def link(
    theta: Expression | None = None,
    d: Expression | None = None,
    a: Expression | None = None,
    alpha: Expression | None = None,
    convention: str = "standard",
) -> Matrix:
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


def _symbols(names):
    return {name: the_sympy().Symbol(name, real=True) for name in names.split()}


def _known(convention):
    if convention not in CONVENTIONS:
        raise ValueError(
            f'symbolic: expected the convention "standard" or "craig", found {convention!r};'
            ' "modified" is "craig" here'
        )
    return convention
