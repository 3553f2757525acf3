"""What is wrong: the catalogue of mistakes in words, and the search over them."""

from .catalogue import Mistake, catalogue
from .diagnosis import Diagnosis
from .finding import Finding
from .poses import diagnose
from .programs import explain_function
from .rows import explain_rows

__all__ = ["Mistake", "catalogue", "Diagnosis", "Finding", "diagnose", "explain_function", "explain_rows"]
