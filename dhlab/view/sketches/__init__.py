"""The course's sketches: one idea each, drawn from numbers that stand in its module."""
