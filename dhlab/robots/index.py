"""What is asked of all arms at once: words, tables and shapes, in one file that is read in a
moment. ``index.json`` is made from the arms' files (``python -m dhlab.robots.index``); an arm that
is not in it is read from its own.
"""

import json
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..arm import Arm
from ..geometry.shapes import shape
from .entries import FOLDER, entry

__all__ = ["summary", "summary_of", "unsigned", "write"]

FILE = FOLDER / "index.json"


def summary(key: str) -> dict[str, Any]:
    """An arm's names, and of each table the convention, the joints and the shape.

    Parameters
    ----------
    key : str
        A name from :func:`dhlab.robots`.

    Returns
    -------
    dict
        ``name``, ``maker``, ``also``, and ``tables``, the best first: by name ``convention``,
        ``joints``, ``shape``, which holds lengths and twists without their signs (m and rad), or is
        None for an arm with sliding joints, and ``rows`` (rad and m), ``sign`` and ``coupling`` as
        they stand in the file.

    Examples
    --------
    >>> summary("panda")["maker"], summary("panda")["tables"]["maker_mod"]["joints"]
    ('Franka Robotics', 'RRRRRRR')
    """
    return _index().get(key) or summary_of(key)


@cache
def _index():
    return json.loads(FILE.read_text(encoding="utf-8")) if FILE.exists() else {}


@cache
def summary_of(key: str) -> dict[str, Any]:
    """The same, from the arm's own file.

    Examples
    --------
    >>> summary_of("ur5e")["tables"]["maker"]["shape"][:5]
    [0.0, 0.425, 0.3922, 0.0, 0.0]
    """
    said = entry(key)
    tables = {
        name: {
            "convention": arm.table.convention,
            "joints": arm.table.joints,
            "shape": None if "P" in arm.table.joints else unsigned(arm).round(9).tolist(),
            "rows": arm.table.rows.tolist(),
            "sign": arm.sign.tolist(),
            "coupling": None if arm.coupling is None else arm.coupling.tolist(),
        }
        for name, arm in said.tables.items()
    }
    return {"name": said.name, "maker": said.maker, "also": list(said.also), "tables": tables}


def unsigned(arm: Arm) -> NDArray[np.float64]:
    """|a| and |d| (m) of an arm's shape, and the angles between neighbouring axes as lines, from 0
    to 90° (rad): what no choice of frames changes; (3n - 2,).

    Examples
    --------
    >>> import dhlab as dh
    >>> unsigned(dh.load("ur5e").flip_x(2).flip_z(4))[:5]
    array([0.    , 0.425 , 0.3922, 0.    , 0.    ])
    """
    of = shape(arm)
    return np.concatenate([abs(of.a), abs(of.d), np.arcsin(np.minimum(1, abs(np.sin(of.alpha))))])


def write() -> None:
    """Make ``index.json`` anew from all the arms' files.

    Examples
    --------
    >>> write()  # doctest: +SKIP
    """
    from . import robots

    lines = [
        f"{json.dumps(key)}: {json.dumps(summary_of(key), ensure_ascii=False)}" for key in robots()
    ]
    FILE.write_text("{\n" + ",\n".join(lines) + "\n}\n", encoding="utf-8")


if __name__ == "__main__":
    write()
