"""Measuring an arm: circle-point analysis of single-joint sweeps, and joint zero offsets from
measured poses.
"""

from .calibration import Calibration, calibrate_offsets
from .circles import Circle, CircleReport, fit_circles

__all__ = ["fit_circles", "CircleReport", "Circle", "calibrate_offsets", "Calibration"]
