"""The derivation in SymPy: the link matrix from its four elementary moves, the product of a whole
arm, its derivatives; all as LaTeX in a notebook.

Needs the extra ``symbolic`` (``pip install dhlab-kinematics[symbolic]``). Angles are radians and
lengths metres, as exact numbers or as symbols.
"""

from .derivation import derivative, product, variables
from .moves import Step, Steps, link, steps
from .numbers import exact
from .shorthand import latex, short

__all__ = [
    "Step",
    "Steps",
    "derivative",
    "exact",
    "latex",
    "link",
    "product",
    "short",
    "steps",
    "variables",
]
