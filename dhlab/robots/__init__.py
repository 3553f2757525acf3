"""The library of arms: one YAML file each, the best table first, alternatives by name, every table
with its source and check poses.
"""

from difflib import get_close_matches
from functools import cache
from pathlib import Path

from ..arm import Arm
from ..formats.descriptions import ENDINGS as DESCRIPTIONS
from ..formats.tablefile import read_arm
from .entries import FOLDER, CheckPose, Entry, entry
from .examples import example

__all__ = ["load", "robots", "search", "known_as", "entry", "example", "Entry", "CheckPose"]


def robots() -> list[str]:
    """The names of the library's arms.

    Returns
    -------
    list of str

    Examples
    --------
    >>> "ur5e" in robots(), "ur10" in robots()  # there are two: ur10_cb and ur10e
    (True, False)
    """
    return list(_names())


@cache
def _names():
    return tuple(sorted(path.stem for path in FOLDER.glob("*.yaml")))


def search(words: str) -> list[str]:
    """The arms whose name, maker or other names hold all of the words.

    Parameters
    ----------
    words : str
        Such as ``"kinova"`` or ``"LR Mate"``; capitals, spaces and signs do not matter.

    Returns
    -------
    list of str
        Names for :func:`load`; empty when there is none.

    Examples
    --------
    >>> search("ur10"), search("Agile-X")
    (['ur10_cb', 'ur10e'], ['piper'])
    """
    wanted = [_plain(word) for word in words.split()]
    return [key for key in robots() if all(word in _said_of(key) for word in wanted)]


def _said_of(key):
    from .index import summary

    said = summary(key)
    return _plain(" ".join((key, said["name"], said["maker"], *said["also"])))


def _plain(words):
    return "".join(letter for letter in words.lower() if letter.isalnum())


def known_as(name: str) -> str:
    """The library's name of an arm that is called so, ``""`` where there is none or several;
    capitals, spaces and signs do not matter, and what else an arm is called counts.

    Examples
    --------
    >>> known_as("myCobot280"), known_as("j2n6s300"), known_as("ur10")
    ('mycobot_280', 'jaco2', '')
    """
    keys = robots()
    if name in keys:
        return name
    from .index import summary

    wanted = _plain(name)
    if not wanted:
        return ""
    same = [key for key in keys if _plain(key) == wanted] or [
        key for key in keys if wanted in map(_plain, summary(key)["also"])
    ]
    return same[0] if len(same) == 1 else ""


def load(name: str | Path) -> Arm:
    """A named arm of the library, or the arm in a table file or a URDF.

    Parameters
    ----------
    name : str or path
        ``"piper"`` (its best table), ``"piper.sdk_old"`` (an alternative), another name of the
        arm (:func:`known_as`), or the path of a
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
    if ending in DESCRIPTIONS:
        from ..formats.descriptions.urdf import read_description  # reads XML

        return read_description(name)
    if isinstance(name, Path) or ending in (".yaml", ".yml", ".csv"):
        return read_arm(name)
    asked, _, table = str(name).partition(".")
    key = known_as(asked)
    if not key:
        near = get_close_matches(asked, robots(), 1)
        if str(name) and not near and Path(str(name)).exists():
            folder = Path(str(name)).is_dir()
            raise ValueError(
                "load: expected an arm of the library or a file that ends in .yaml, .csv or .urdf,"
                f" found {'the folder' if folder else 'the file'} {str(name)!r}; "
                + ("name a file in it" if folder else "dhlab paste reads a table from any text")
            )
        todo = (
            f"did you mean {near[0]}?"
            if near
            else f"dhlab robots lists the {len(robots())} arms; a file's name ends in .yaml or .csv"
        )
        raise ValueError(
            f"load: expected an arm of the library or a table file, found no {str(name)!r}; {todo}"
        )
    tables = entry(key).tables
    if table and table not in tables:
        raise ValueError(f"load: expected a table of {key} ({', '.join(tables)}), found {table!r}")
    return tables[table or next(iter(tables))]
