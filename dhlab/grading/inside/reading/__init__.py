"""How a notebook becomes programs: its cells, their statements, and what of them is needed. Nothing
here runs any of it.
"""
