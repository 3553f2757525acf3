"""What is wrong: the catalogue of mistakes, and the search over it from measured poses, programs,
tables and motion.
"""

from .arms.motion import diagnose_motion
from .arms.poses import diagnose
from .arms.protocol import Protocol, protocol
from .catalogue import Mistake, catalogue
from .diagnosis import Diagnosis
from .finding import Finding
from .programs.explain import explain_function
from .programs.functions import diagnose_function
from .tables.dialects import Reading, Recognised, recognise_table
from .tables.rows import explain_rows

__all__ = [
    "Diagnosis",
    "Finding",
    "Mistake",
    "Protocol",
    "Reading",
    "Recognised",
    "catalogue",
    "diagnose",
    "diagnose_function",
    "diagnose_motion",
    "explain_function",
    "explain_rows",
    "protocol",
    "recognise_table",
]
