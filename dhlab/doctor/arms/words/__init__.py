"""What was found, in words: which numbers differ, what the mistake is called, and in which order
several are told.
"""
