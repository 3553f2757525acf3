"""Frames placed by hand on bare joint axes: the board, its rules and the geometry that both look
at.
"""

from .board import Placement

__all__ = ["Placement"]
