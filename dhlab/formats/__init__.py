"""Everything that is read from a file or written to one: table files, poses, URDF; strict text,
atomic writes.
"""
