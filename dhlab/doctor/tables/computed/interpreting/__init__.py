"""Expressions, statements, functions and classes of a parsed program, carried out."""
