"""The warm parent: it loads once what submissions need, is copied for each, and
clears up after it.
"""
