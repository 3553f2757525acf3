"""From measured poses: which joint axis of a sheet is not where, or not as, it was written."""
