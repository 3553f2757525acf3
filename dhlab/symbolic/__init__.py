"""The derivation in SymPy: exact numbers, the link matrix from its moves, the product of a whole
arm.
"""

from .derivation import (
    Step,
    Steps,
    derivative,
    exact,
    latex,
    link,
    product,
    short,
    steps,
    variables,
)

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
