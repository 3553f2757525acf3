"""The library of arms: one YAML file each, the best table first, alternatives by name, every table
with its source and check poses.
"""

from dataclasses import dataclass
from difflib import get_close_matches
from functools import cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from .. import units
from ..arm import Arm
from ..formats import plainyaml
from ..formats.plainyaml import fields, number, text
from ..formats.tablefile import read_arm
from ..formats.tableyaml import ARM_KEYS, arm_from_item, read_limits
from ..formats.urdf import ENDINGS as URDF
from ..formats.urdf import read_description
from .examples import example

__all__ = ["load", "robots", "entry", "example", "Entry", "CheckPose"]

FOLDER = Path(__file__).parent
EXTRA_KEYS = {"note", "checks"}  # what a library table says beyond a table file


@dataclass(frozen=True)
class CheckPose:
    """A pose that a table must give: ``q`` (n,) in rad or m, ``xyz`` (3,) in m, ``R`` (3, 3) or
    None, and where it comes from.
    """

    q: NDArray[np.float64]
    xyz: NDArray[np.float64]
    R: NDArray[np.float64] | None
    source: str


@dataclass(frozen=True)
class Entry:
    """One arm of the library: ``tables`` maps a table's name to its Arm, the best first; ``notes``
    and ``checks`` likewise.
    """

    key: str
    name: str
    topology: str
    ambiguity: str
    tables: dict[str, Arm]
    notes: dict[str, str]
    checks: dict[str, list[CheckPose]]


def robots() -> list[str]:
    """The names of the library's arms.

    Returns
    -------
    list of str

    Examples
    --------
    >>> "ur5e" in robots(), len(robots())
    (True, 19)
    """
    return sorted(path.stem for path in FOLDER.glob("*.yaml"))


def load(name: str | Path) -> Arm:
    """A named arm of the library, or the arm in a table file or a URDF.

    Parameters
    ----------
    name : str or path
        ``"piper"`` (its best table), ``"piper.sdk_old"`` (an alternative), or the path of a
        ``.yaml`` or ``.csv`` table file or of a ``.urdf``, ``.xacro`` or MJCF file (as
        :func:`read_urdf` takes it without further options).

    Returns
    -------
    Arm

    Raises
    ------
    ValueError
        No such arm, table or file; or the file is not a table.

    Examples
    --------
    >>> load("piper").name
    'AgileX PiPER'
    >>> load("pipr")
    Traceback (most recent call last):
    ...
    ValueError: load: expected an arm of the library or a table file, found no 'pipr'; did you mean
    piper?
    """
    ending = Path(str(name)).suffix.lower()
    if ending in URDF:
        return read_description(name)
    if isinstance(name, Path) or ending in (".yaml", ".yml", ".csv"):
        return read_arm(name)
    key, _, table = str(name).partition(".")
    if key not in robots():
        near = get_close_matches(key, robots(), 1)
        todo = (
            f"did you mean {near[0]}?"
            if near
            else f"the arms are {', '.join(robots())}; a file's name ends in .yaml or .csv"
        )
        raise ValueError(
            f"load: expected an arm of the library or a table file, found no {str(name)!r}; {todo}"
        )
    tables = entry(key).tables
    if table and table not in tables:
        raise ValueError(f"load: expected a table of {key} ({', '.join(tables)}), found {table!r}")
    return tables[table or next(iter(tables))]


@cache
def entry(key: str) -> Entry:
    """Everything the library says of one arm.

    Parameters
    ----------
    key : str
        A name from :func:`robots`.

    Returns
    -------
    Entry

    Examples
    --------
    >>> list(entry("piper").tables)
    ['sdk_new', 'sdk_old']
    """
    item = plainyaml.read(FOLDER / f"{key}.yaml", "a library file")
    top = fields(
        item,
        "the file",
        required={"name", "tables"},
        allowed={"name", "topology", "limits", "ambiguity", "tables"},
    )
    words = {
        word: text(top[word], word) if word in top else ""
        for word in ("name", "topology", "ambiguity")
    }
    best = next(iter(top["tables"].value))
    tables, notes, checks = {}, {}, {}
    for name, table in top["tables"].value.items():
        given = fields(table, name, required={"source", "checks"}, allowed=ARM_KEYS | EXTRA_KEYS)
        full_name = words["name"] if name == best else f"{words['name']} ({name})"
        own = plainyaml.Item({k: v for k, v in given.items() if k not in EXTRA_KEYS}, table.where)
        tables[name] = arm_from_item(own, name=full_name, **_shared_limits(top, given))
        notes[name] = text(given["note"], "note") if "note" in given else ""
        checks[name] = [_check_pose(check, tables[name]) for check in given["checks"].value]
    return Entry(key, tables=tables, notes=notes, checks=checks, **words)


def _shared_limits(top, given):
    """The arm's limits, for a table that does not state its own; in degrees and metres."""
    if "limits" not in top or "limits" in given:
        return {}
    letters = "".join(
        "P" if "type" in row.value and row.value["type"].value == "prismatic" else "R"
        for row in given["joints"].value
    )
    return {"limits": read_limits(top["limits"], letters, units.LENGTH["m"], units.ANGLE["deg"])}


def _check_pose(item, arm):
    given = fields(item, "checks", required={"q", "xyz", "from"}, allowed={"q", "xyz", "R", "from"})
    q = np.array([number(entry, "q") for entry in given["q"].value], dtype=float)
    q = np.where(arm.table.prismatic, q, np.deg2rad(q))
    R = np.array(given["R"].plain(), dtype=float) if "R" in given else None
    return CheckPose(q, np.array(given["xyz"].plain(), dtype=float), R, text(given["from"], "from"))
