"""Handing out, grading and understanding a class."""
