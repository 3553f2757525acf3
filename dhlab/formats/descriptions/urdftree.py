"""The chain of joints between two links of a URDF file."""

from collections.abc import Mapping
from pathlib import Path
from xml.etree.ElementTree import Element

from .urdfends import chosen_tip
from .urdfjoint import Joint, read_joint
from .urdfwords import listed
from .urdfxml import read_parts

__all__ = ["read_chain"]


def read_chain(
    path: str | Path,
    base: str | None,
    tip: str | None,
    arguments: Mapping[str, object] | None = None,
    packages: Mapping[str, str | Path] | None = None,
    *,
    unround: bool = False,
) -> tuple[list[Joint], str, str, str, str]:
    """The joints from ``base`` to ``tip`` in order, the names of the robot and of the two links,
    and in words how the tip was chosen, where it had to be.

    Parameters
    ----------
    path : str or path
    base, tip : str or None
        Names of links; None: the root and the end of the longest chain of arm joints.
    arguments, packages
        Of a xacro file, as :func:`dhlab.formats.descriptions.xacrofile.expanded` takes them.
    unround : bool
        Take the angles of rpy for what they are rounded from.

    Returns
    -------
    joints : list of dhlab.formats.descriptions.urdfjoint.Joint
        Fixed ones included.
    name, base, tip, said : str

    Raises
    ------
    ValueError
        One sentence: what was expected, what was found, what to do.
    """
    name, links, joints = read_parts(path, arguments, packages)
    above = _joint_above(links, joints, path)
    base, tip, said = _ends(links, above, base, tip, path)
    chain = _chain(above, base, tip, path)
    read = [read_joint(joint[3], path, unround=unround) for joint in chain]
    return read, name, base, tip, said


def _joint_above(links, joints, path):
    """From each link to the joint that carries it: (name, parent, child, element)."""
    above: dict[str, tuple[str, str, str, Element]] = {}
    known = set(links)
    for joint in joints:
        name, parent, child, _ = joint
        for link in (parent, child):
            if link not in known:
                raise ValueError(
                    f"{path}: joint {name}: expected a link of the file, found {link}, which is not"
                    " in it; add the link or correct the name"
                )
        if child in above:
            raise ValueError(
                f"{path}: expected a tree of links, found a loop: link {child} hangs on the joints"
                f" {above[child][0]} and {name}; a DH table can only describe a chain without loops"
            )
        above[child] = joint
    return above


def _ends(links, above, base, tip, path):
    for name, link in (("base", base), ("tip", tip)):
        if link is not None and link not in links:
            raise ValueError(
                f"{path}: {name}: expected a link of the file, found {link!r}; the links are"
                f" {listed(links)}"
            )
    if base is None and tip is not None:
        return _path(above, tip, path)[-1], tip, ""
    if base is None:
        roots = [link for link in links if link not in above]
        if not roots:
            raise ValueError(
                f"{path}: expected a tree of links, found a loop without a root; a DH table can"
                " only describe a chain without loops"
            )
        if len(roots) > 1:
            raise ValueError(
                f"{path}: expected one root link, found {listed(roots)}; name one of them as base"
            )
        base = roots[0]
    for link in above:
        _path(above, link, path)  # a loop that hangs on nothing is no part of any chain
    if tip is None:
        return base, *_last_link(links, above, base, path)
    return base, tip, ""


def _last_link(links, above, base, path):
    parents = {joint[1] for joint in above.values()}
    leaves = [link for link in links if link not in parents and base in _path(above, link, path)]
    if leaves == [base] or not leaves:
        raise ValueError(f"{path}: expected joints below {base}, found none; name another base")
    joints = list(above.values())
    return chosen_tip(leaves, base, lambda link: _chain(above, base, link, path), joints, path)


def _path(above, link, path):
    """The links from ``link`` up to its root, both included."""
    found = [link]
    while found[-1] in above:
        found.append(above[found[-1]][1])
        if found[-1] in found[:-1]:
            raise ValueError(
                f"{path}: expected a tree of links, found a loop through {found[-1]}; "
                "a DH table can only describe a chain without loops"
            )
    return found


def _chain(above, base, tip, path):
    """The joints (name, parent, child, element) from base to tip."""
    up = _path(above, tip, path)
    if base not in up:
        raise ValueError(
            f"{path}: expected a chain from {base} to {tip}, found that {tip} is not below {base}"
            f" (it hangs on {listed(up[1:])}); name a base above the tip"
        )
    return [above[link] for link in reversed(up[: up.index(base)])]
