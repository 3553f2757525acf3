"""The kinds of exercises: each knows how to draw its numbers from a seed and how to judge an
answer.
"""

from .chosen import Choice, OneOf, Order, Prediction, PreTest
from .exercise import Exercise, Known, Mistakes, Said, untouched
from .explained import Explain
from .functions import CASES, Function
from .lettered import UNDECIDED, Lettered, Option
from .reading import as_numbers, is_array_of, plain
from .tabled.handed_in import as_arm, numbers
from .tabled.tables import Table
from .values import LAST_ROW, Value

__all__ = [
    "CASES",
    "LAST_ROW",
    "UNDECIDED",
    "Choice",
    "Exercise",
    "Explain",
    "Function",
    "Known",
    "Lettered",
    "Mistakes",
    "OneOf",
    "Option",
    "Order",
    "PreTest",
    "Prediction",
    "Said",
    "Table",
    "Value",
    "as_arm",
    "as_numbers",
    "is_array_of",
    "numbers",
    "plain",
    "untouched",
]
