"""What a file of the library says: one arm, its tables with their sources and check poses, and
where all of it comes from.
"""

from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from .. import units
from ..arm import Arm
from ..formats import plainyaml
from ..formats.plainyaml import Item, entries, fields, number, text
from ..formats.tableyaml import ARM_KEYS, arm_from_item, read_limits

__all__ = ["FOLDER", "CheckPose", "Entry", "entry", "read_entry"]

FOLDER = Path(__file__).parent
EXTRA_KEYS = {"note", "checks"}  # what a library table says beyond a table file
# what is said of the arm in a text, and in a list of texts
WORDS = ("name", "maker", "topology", "zero", "flange", "ambiguity", "licence", "second")
LISTS = ("also", "links")


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
    and ``checks`` likewise. ``also`` is what else the arm is called, ``zero`` and ``flange`` where
    it stands at q = 0 and which frame its end is, ``second`` what the second source says, and
    ``licence`` and ``links`` are those of the sources; empty where nothing is known.
    """

    key: str
    name: str
    maker: str
    also: tuple[str, ...]
    topology: str
    zero: str
    flange: str
    ambiguity: str
    licence: str
    links: tuple[str, ...]
    second: str
    tables: dict[str, Arm]
    notes: dict[str, str]
    checks: dict[str, list[CheckPose]]


@cache
def entry(key: str) -> Entry:
    """Everything the library says of one arm.

    Parameters
    ----------
    key : str
        A name from :func:`dhlab.robots`.

    Returns
    -------
    Entry

    Examples
    --------
    >>> list(entry("piper").tables)
    ['sdk_new', 'sdk_old']
    """
    return read_entry(key, plainyaml.read(FOLDER / f"{key}.yaml", "a library file"))


def read_entry(key: str, item: Item) -> Entry:
    """The Entry in a library file that :mod:`dhlab.formats.plainyaml` has read; a ValueError names
    the line that is wrong.
    """
    top = fields(
        item, "the file", required={"name", "tables"}, allowed={*WORDS, *LISTS, "limits", "tables"}
    )
    words = {word: text(top[word], word) if word in top else "" for word in WORDS}
    best = next(iter(top["tables"].value))
    tables, notes, checks = {}, {}, {}
    for name, table in top["tables"].value.items():
        given = fields(table, name, required={"source", "checks"}, allowed=ARM_KEYS | EXTRA_KEYS)
        full_name = words["name"] if name == best else f"{words['name']} ({name})"
        own = Item({k: v for k, v in given.items() if k not in EXTRA_KEYS}, table.where)
        tables[name] = arm_from_item(own, name=full_name, **_shared_limits(top, given))
        notes[name] = text(given["note"], "note") if "note" in given else ""
        checks[name] = [_check_pose(check, tables[name]) for check in given["checks"].value]
    also, links = (_texts(top, key) for key in LISTS)
    return Entry(key, tables=tables, notes=notes, checks=checks, also=also, links=links, **words)


def _texts(top, key):
    return tuple(text(one, key) for one in entries(top[key], key)) if key in top else ()


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
    q = np.array([number(one, "q") for one in given["q"].value], dtype=float)
    q = np.where(arm.table.prismatic, q, np.deg2rad(q))
    R = np.array(given["R"].plain(), dtype=float) if "R" in given else None
    return CheckPose(q, np.array(given["xyz"].plain(), dtype=float), R, text(given["from"], "from"))
