"""Two arms side by side, joint by joint: how each counts, where its zero is, the lengths and angles
of its links.
"""
