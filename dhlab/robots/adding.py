"""A new arm for the library: read from a URDF or a table file, compared with a second source,
written as the library's files are.
"""

import json
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from ..arm import Arm
from ..formats import plainyaml
from ..formats.descriptions.urdf import read_urdf
from ..formats.descriptions.urdfjoint import unrounded
from ..formats.descriptions.urdftree import read_chain
from ..formats.files import write_text
from ..formats.tablefile import read_arm
from ..formats.tableyaml import yaml_text
from ..geometry.equivalence import equivalent
from ..transform import trans
from .drawing_up import plainest, topology, zero_pose
from .entries import LISTS, WORDS, read_entry
from .likeness import ROUNDED, likeness, words_of

__all__ = ["Given", "add", "agreement", "library_text", "read_given"]

CHECKS, SEED = 1, 15  # how many check poses a table gets, and what draws their joint values
FREE = {"R": (-np.pi, np.pi), "P": (0.0, 0.5)}  # where they are drawn when no limits are stated
KEY = re.compile(r"[a-z0-9][a-z0-9_-]*\Z")


@dataclass(frozen=True, eq=False)
class Given:
    """One table for a library file: the arm, what is said of it, and ``pose``, which takes q (n,)
    and gives the end pose (4, 4) that the table must have; ``judge`` says how.
    """

    arm: Arm
    source: str
    pose: Callable[[NDArray[np.float64]], NDArray[np.float64]]
    judge: str
    note: str = ""


def read_given(
    path: str | Path, source: str, base: str | None = None, tip: str | None = None
) -> Given:
    """The arm in a URDF or table file, as the library has it.

    Of a URDF the rounded angles are made exact, and of the right tables the plainest is taken; its
    poses are computed from the URDF's own joints, without a table.

    Examples
    --------
    >>> from dhlab.robots import example
    >>> given = read_given(example("ur5e.urdf"), "a file of the course", tip="tool0")
    >>> len(given.arm), given.judge
    (6, 'joint by joint from the URDF')
    """
    if Path(path).suffix.lower() != ".urdf":
        arm = read_arm(path)
        return Given(arm, source, arm.forward, "from this table")
    arm = plainest(read_urdf(path, base, tip, unround=True))
    joints, _, first, last, _ = read_chain(path, base, tip, unround=True)
    words = f"{source}; from {first} to {last}, table derived from the joints' axes"
    return Given(arm, words, lambda q: _chain_pose(joints, q), "joint by joint from the URDF")


def _chain_pose(joints, q):
    T, moving = np.eye(4), iter(q)
    for joint in joints:
        T = T @ joint.origin
        if joint.kind != "fixed":
            axis = joint.axis / np.linalg.norm(joint.axis) * next(moving)
            turn = np.eye(4)
            turn[:3, :3] = Rotation.from_rotvec(axis).as_matrix()
            T = T @ (trans(axis) if joint.kind == "prismatic" else turn)
    return T


def agreement(a: Arm, b: Arm) -> str | None:
    """What separates b from a when they are one arm within what publishers round away, base, tool,
    zeros and signs aside; None when they are not.

    Examples
    --------
    >>> import dhlab as dh
    >>> print(agreement(dh.load("ur10_cb"), dh.load("ur10_cb.arte")))
    the same arm, base and tool aside; joint 2's zero moved by -90°, joint 4's zero moved by -90°;
    lengths up to 0.3 mm apart
    >>> agreement(dh.load("ur10_cb"), dh.load("ur10e")) is None
    True
    """
    same = likeness(a, b, *ROUNDED)
    return f"the same arm{words_of(same, a, b)}" if same else None


def add(
    path: str | Path,
    *,
    key: str,
    name: str,
    source: str,
    base: str | None = None,
    tip: str | None = None,
    second: str | Path | None = None,
    second_tip: str | None = None,
    licence: str = "",
    folder: str | Path = ".",
) -> Path:
    """Write a library file for an arm, unless its second source contradicts it.

    Parameters
    ----------
    path : str or path
        A ``.urdf`` file, or a ``.yaml`` or ``.csv`` table file.
    key : str
        The name for :func:`dhlab.load`, which is the new file's.
    name : str
        The arm's full name, with its maker.
    source : str
        Where the file is from: an address that others can open.
    base, tip : str, optional
        Links of the URDF; see :func:`dhlab.read_urdf`.
    second : str or path, optional
        Another publisher's URDF or table file of the same arm, and the last link of it. Bases,
        tools, zeros and signs may differ, and numbers by what is rounded away (0.5 mm and 0.1°).
    second_tip : str, optional
        The link that the second file's chain ends with.
    licence : str
        Of the source.
    folder : str or path
        Where to write.

    Returns
    -------
    Path
        The file. One that exists is never replaced.

    Raises
    ------
    ValueError
        One sentence: a file that is none, a second source of another arm, a key that cannot be a
        file's name.

    Examples
    --------
    >>> import tempfile
    >>> from dhlab.robots import example
    >>> urdf = example("ur5e.urdf")
    >>> new = add(
    ...     urdf, key="ours", name="Our UR5e", source="here", tip="tool0", folder=tempfile.mkdtemp()
    ... )
    >>> print(new.name, new.read_text(encoding="utf-8").splitlines()[0])
    ours.yaml name: "Our UR5e"
    """
    if not KEY.match(key):
        raise ValueError(
            f"robots: expected a key of small letters, digits, _ and -, such as gp7, found {key!r}"
        )
    given = read_given(path, source, base, tip)
    tables, words = {"derived" if Path(path).suffix.lower() == ".urdf" else "table": given}, ""
    if second is not None:
        other = read_given(second, f"the second source, {Path(second).name}", tip=second_tip)
        words = agreement(given.arm, other.arm) or ""
        if not words:
            differs = equivalent(given.arm, other.arm, base="free", tool="free").message
            raise ValueError(
                f"{path}: expected the arm of {second}, found another. {differs} Find out which of"
                " the two is wrong; without a second source nothing is compared"
            )
        words = f"{Path(second).name}: {words}"
        if Path(second).suffix.lower() != ".urdf":
            tables["second"] = replace(other, note=words)
    text = library_text(
        tables, name=name, licence=licence, links=[source], second=words, **_described(given.arm)
    )
    target = Path(folder) / f"{key}.yaml"
    read_entry(key, plainyaml.parse(text, str(target)))
    write_text(target, text)
    return target


def _described(arm):
    return {"topology": topology(arm), "zero": zero_pose(arm)}


def library_text(tables: Mapping[str, Given], **words: str | Sequence[str]) -> str:
    r"""The text of a library file: ``words`` are those of :class:`dhlab.robots.Entry`, the first
    table is the best.

    Examples
    --------
    >>> import dhlab as dh
    >>> arm = dh.load("article-6r")
    >>> text = library_text({"std": Given(arm, "the article", arm.forward, "by hand")}, name="6R")
    >>> print(*text.splitlines()[:4], sep="\n")
    name: "6R"
    tables:
      std:
        convention: standard
    """
    lines = [
        f"{key}: {json.dumps(words[key], ensure_ascii=False)}"
        for key in (*WORDS, *LISTS)
        if words.get(key)
    ]
    lines.append("tables:")
    for name, given in tables.items():
        lines.append(f"  {name}:")
        lines += ["    " + line for line in _table_lines(given)]
    return "\n".join(lines) + "\n"


def _table_lines(given):
    yield from yaml_text(_bare(given.arm), "deg", "mm").splitlines()
    yield f"source: {json.dumps(given.source, ensure_ascii=False)}"
    if given.note:
        yield f"note: {json.dumps(given.note, ensure_ascii=False)}"
    yield "checks:"
    for q in _check_values(given.arm):
        T = given.pose(q)
        human = np.where(given.arm.table.prismatic, q, np.rad2deg(q)).round(4)
        yield f"  - q: {_numbers(human)}"
        yield f"    xyz: {_numbers(T[:3, 3].round(9))}   # metres"
        yield f"    R: [{', '.join(_numbers(row.round(9)) for row in T[:3, :3])}]"
        yield f'    from: "computed {given.judge}, rounded to 1e-9"'


def _bare(arm):
    """The arm without what stands elsewhere in the file, its limits as a sheet would have them."""
    limits = arm.limits and [
        pair and tuple(_tidy(end, letter) for end in pair)
        for pair, letter in zip(arm.limits, arm.table.joints)
    ]
    return Arm(arm.table, arm.base, arm.tool, limits, arm.sign, coupling=arm.coupling)


def _tidy(end, letter):
    """A limit to 0.01° or 0.1 mm; 3.14 in a URDF is 180°."""
    if letter == "P":
        return round(end, 4)
    return float(np.deg2rad(round(float(np.rad2deg(unrounded(end))), 2)))


def _check_values(arm):
    """Joint values of one decimal of a degree, or of a millimetre."""
    limits = arm.limits or [None] * len(arm)
    low, high = np.array([p or FREE[k] for p, k in zip(limits, arm.table.joints)]).T
    for q in np.random.default_rng(SEED).uniform(low, high, (CHECKS, len(arm))):
        yield np.where(arm.table.prismatic, q.round(3), np.deg2rad(np.rad2deg(q).round(1)))


def _numbers(values):
    return "[" + ", ".join(np.format_float_positional(v + 0.0, trim="-") for v in values) + "]"
