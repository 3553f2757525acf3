"""Rows between brackets, in any language, and tables that are filled bit by bit."""
