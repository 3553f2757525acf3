"""What each mistake of the catalogue does: one function a mistake, beside its words in
``catalogue.yaml``.
"""

from .faults import Fault, faults
from .registry import changes

__all__ = ["Fault", "changes", "faults"]
