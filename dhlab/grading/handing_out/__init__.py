"""Lessons for a class, with numbers of everybody's own."""
