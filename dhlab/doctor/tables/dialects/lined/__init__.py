"""Rows in lines: cells between bars, tabs, commas or spaces, with or without headings."""
