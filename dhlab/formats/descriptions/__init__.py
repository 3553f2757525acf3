"""Robot descriptions of other programs: URDF in and out, xacro and MJCF in."""

__all__ = ["ENDINGS"]

ENDINGS = (".urdf", ".xacro", ".xml")
