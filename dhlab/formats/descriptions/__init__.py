"""Robot descriptions of other programs: URDF in and out, xacro and MJCF in."""
