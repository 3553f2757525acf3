"""MATLAB, said in Python's grammar, and what it calls."""
