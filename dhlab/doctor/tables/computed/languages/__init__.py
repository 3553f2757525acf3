"""Texts in several languages, as programs in Python's grammar."""
