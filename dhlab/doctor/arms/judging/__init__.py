"""What may be claimed of a table: how well it agrees, whether it is a calibration, and when too few
poses tell.
"""
