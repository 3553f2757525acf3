"""The product of an arm in SymPy, short from the start: neighbouring turns about parallel axes are
added before anything is multiplied.
"""

from collections.abc import Iterable

from .numbers import Expression, Matrix, exact, the_sympy

__all__ = ["gathered_product"]

PARALLEL = 1e-30  # of numbers computed to DIGITS: exact zeros pass, 1.5708 for pi/2 does not
# operations; an exact number longer than this is nothing to read, and some take minutes to print
LONG = 40
DIGITS = 50


def gathered_product(
    before: Matrix, rows: Iterable[tuple[Expression, Expression, Matrix]], after: Matrix
) -> Matrix:
    """``before · Π [Rz(turn) Tz(shift) bend] · after``.

    Parameters
    ----------
    before, after : sympy.Matrix (4, 4)
    rows : list of (turn, shift, bend)
        Expressions, expressions, and constant matrices (4, 4).

    Returns
    -------
    sympy.Matrix (4, 4)

    Examples
    --------
    >>> import sympy
    >>> x, y = sympy.symbols("x y")
    >>> one = sympy.eye(4)
    >>> gathered_product(one, [(x, 0, one), (y, 0, one)], one)[0, 0]
    cos(x + y)
    """
    sympy = the_sympy()
    factors: list[Matrix] = []
    constant, run = before, None
    for turn, shift, bend in rows:
        if not (sympy.sympify(turn).free_symbols or sympy.sympify(shift).free_symbols):
            constant = _numbers(constant * _Run().moved(turn, shift).matrix() * bend)
            continue
        joined: _Run | None = run and run.through(constant)
        if not joined:
            factors += [run.matrix(), constant] if run else [constant]
        run, constant = (joined or _Run()).moved(turn, shift), bend
    factors += [run.matrix(), constant * after] if run else [constant * after]
    return _readable(_from_the_right(factors))


class _Run:
    """``trans(p) · Rz(angle) · Rx(0 or 180°)``: all that joints with parallel axes can do."""

    def __init__(self, angle=0, up=1, p=(0, 0, 0)):
        self.angle, self.up, self.p = angle, up, p

    def moved(self, turn, shift):
        x, y, z = self.p
        return _Run(self.angle + self.up * turn, self.up, (x, y, z + self.up * shift))

    def through(self, C):
        """This run and the constant pose ``C`` behind it, or None when ``C`` tilts the z axis."""
        sympy = the_sympy()
        if abs(abs(C[2, 2].evalf(DIGITS)) - 1) > PARALLEL:
            return None
        c, s = sympy.cos(self.angle), sympy.sin(self.angle)
        x, y, z = C[0, 3], self.up * C[1, 3], self.up * C[2, 3]
        p = (self.p[0] + c * x - s * y, self.p[1] + s * x + c * y, self.p[2] + z)
        up = self.up * (1 if C[2, 2].evalf() > 0 else -1)
        return _Run(self.angle + self.up * _angle(C[1, 0], C[0, 0]), up, p)

    def matrix(self):
        sympy = the_sympy()
        c, s = sympy.cos(self.angle), sympy.sin(self.angle)
        return sympy.Matrix(
            [
                [c, -s * self.up, 0, self.p[0]],
                [s, c * self.up, 0, self.p[1]],
                [0, 0, self.up, self.p[2]],
                [0, 0, 0, 1],
            ]
        )


def _angle(s, c):
    """The angle of an exact sine and cosine: the number it plainly is, or an arc tangent."""
    sympy = the_sympy()
    angle = sympy.atan2(s, c)
    plain = exact(float(angle.evalf(30)), "angle")
    return plain if abs((plain - angle).evalf(DIGITS)) < PARALLEL else angle


def _from_the_right(factors):
    """The tool's end first, so that brackets nest as in the textbooks: ``c_1 (c_23 (…) - s_23
    (…))``.
    """
    *rest, T = factors
    for factor in reversed(rest):
        T = factor * T
    return T


def _numbers(T):
    """A constant matrix with products of sines and cosines written as sums where that is shorter:
    equal angles then cancel.
    """
    sympy = the_sympy()
    from sympy.simplify.fu import TR8

    def shorter(entry):
        if sympy.count_ops(entry) > LONG:
            return entry.evalf(DIGITS)
        return min(entry, TR8(sympy.expand(entry)), key=sympy.count_ops)

    return T.applyfunc(shorter)


def _readable(T):
    """Decimals with as many digits as a float has; they carried more on the way."""
    sympy = the_sympy()
    return T.xreplace({number: sympy.Float(number, 16) for number in T.atoms(sympy.Float)})
