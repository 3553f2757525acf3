"""What is wrong: the catalogue of mistakes, and the search over it from measured poses, programs, tables and motion."""

from .catalogue import Mistake, catalogue
from .diagnosis import Diagnosis
from .dialects import Reading, Recognised, recognise_table
from .finding import Finding
from .functions import diagnose_function
from .motion import diagnose_motion
from .poses import diagnose
from .programs import explain_function
from .protocol import Protocol, protocol
from .rows import explain_rows

__all__ = ["Diagnosis", "Finding", "Mistake", "Protocol", "Reading", "Recognised", "catalogue", "diagnose", "diagnose_function", "diagnose_motion",
           "explain_function", "explain_rows", "protocol", "recognise_table"]
