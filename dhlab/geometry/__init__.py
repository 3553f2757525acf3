"""From joint axes to frames to a table, and back: what a table leaves free, and when two tables are
one arm.
"""
