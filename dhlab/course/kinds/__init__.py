"""The kinds of exercises: each knows how to draw its numbers from a seed and how to judge an
answer.
"""

from .chosen import UNDECIDED, Choice, Option, Order, Prediction, PreTest
from .computed import CASES, Function, Table, Value, as_arm
from .exercise import Exercise, Said, untouched

__all__ = [
    "CASES",
    "Choice",
    "Exercise",
    "Function",
    "Option",
    "Order",
    "PreTest",
    "Prediction",
    "Said",
    "Table",
    "UNDECIDED",
    "Value",
    "as_arm",
    "untouched",
]
