"""What is wrong: the catalogue of mistakes in words, and the search over them."""

from .catalogue import Mistake, catalogue
from .programs import Finding, explain_function
from .rows import explain_rows

__all__ = ["Mistake", "catalogue", "Finding", "explain_function", "explain_rows"]
