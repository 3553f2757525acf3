"""What lesson 07 needs to ask a simulator: the article's arm as a URDF, PyBullet where it is
installed, and its stored answers where it is not.
"""

import os
from contextlib import contextmanager
from pathlib import Path
from tempfile import mkdtemp

import numpy as np

from ..formats.files import write_text

__all__ = ["Q", "STORED", "URDF", "pybullet", "urdf_file"]

# Written from the arm's drawing, joint by joint in the base's directions; no DH table went into it.
# It stands under this project's licence.
JOINTS = (
    ("0 0 0", "0 0 1"),
    ("0 0 0.1", "0 -1 0"),
    ("0.4 0 0", "0 -1 0"),
    ("0.35 0 0", "0 -1 0"),
    ("0 -0.1 0", "0 0 -1"),
    ("0 0 0", "0 -1 0"),
)
TOOL = '<origin xyz="0 -0.1 0" rpy="1.5707963267948966 0 0"/>'
MASS = (
    '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0"'
    ' izz="1"/></inertial>'
)

Q = np.deg2rad(
    [[20, 50, -70, 30, 40, 20], [-40, 80, -60, 25, -35, 50], [65, 35, -95, 45, 70, -15]]
)  # three general configurations (3, 6)
# the tool's position at each, metres, as PyBullet 3.2.7 gave it on Linux
STORED = np.array(
    [
        [0.551585, 0.012822, 0.275549],
        [0.219291, -0.421481, 0.654188],
        [0.295702, 0.316586, 0.050643],
    ]
)


def _urdf():
    links = (
        "".join(f'  <link name="link_{i}">{MASS}</link>\n' for i in range(7))
        + f'  <link name="tool">{MASS}</link>\n'
    )
    joints = "".join(
        f'  <joint name="joint_{i}" type="continuous"><parent link="link_{i - 1}"/><child'
        f' link="link_{i}"/><origin xyz="{xyz}"/><axis xyz="{axis}"/></joint>\n'
        for i, (xyz, axis) in enumerate(JOINTS, 1)
    )
    tool = (
        '  <joint name="tool_joint" type="fixed"><parent link="link_6"/><child'
        f' link="tool"/>{TOOL}</joint>\n'
    )
    return f'<?xml version="1.0"?>\n<robot name="article-6r">\n{links}{joints}{tool}</robot>\n'


URDF = _urdf()


def urdf_file() -> str:
    """The path of a new file that holds the URDF; simulators read files.

    Examples
    --------
    >>> Path(urdf_file()).read_text() == URDF
    True
    """
    path = Path(mkdtemp(), "article-6r.urdf")
    write_text(path, URDF)
    return str(path)


@contextmanager
def _without_chatter():
    """PyBullet prints the date of its build when it is imported, past Python's own stderr."""
    kept, nothing = os.dup(2), os.open(os.devnull, os.O_WRONLY)
    try:
        os.dup2(nothing, 2)
        yield
    finally:
        os.dup2(kept, 2)
        os.close(kept)
        os.close(nothing)


try:
    with _without_chatter():
        import pybullet
except (ImportError, OSError):
    pybullet = None
