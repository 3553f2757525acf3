"""The text of a learner's program: read, and tried with one thing in it changed, to tell the line
that must change.
"""
