"""Where an arm ends in a URDF that has a gripper, sensors or several tool frames: the longest chain
of arm joints.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from xml.etree.ElementTree import Element

from .urdfjoint import MOVABLE
from .urdfwords import listed

__all__ = ["chosen_tip"]

Placed = tuple[str, str, str, Element]  # a joint: name, parent, child, element

GRIPS = re.compile(r"finger|gripper|knuckle|jaw|claw|pinch|thumb", re.IGNORECASE)
TURNS = re.compile(r"roll|pitch|yaw|rotat|wrist|turn", re.IGNORECASE)  # a gripper_roll is the arm's
TIPS = ("tool0", "tool_link", "flange", "ee_link", "tcp", "link_ee", "hand")


def chosen_tip(
    leaves: list[str],
    base: str,
    chain_of: Callable[[str], list[Placed]],
    joints: list[Placed],
    path: str | Path,
) -> tuple[str, str]:
    """The link at which the arm ends, and why, in words; empty where nothing had to be chosen.

    Parameters
    ----------
    leaves : list of str
        Links below ``base`` with nothing on them.
    base : str
    chain_of : callable
        From a link to the joints (name, parent, child, element) between base and it.
    joints : list of (name, parent, child, element)
        All of the file.
    path : str or path
        For the error.

    Raises
    ------
    ValueError
        Two chains are equally long and move different joints.
    """
    followed = _followed(joints)
    chains = {leaf: _without_gripper(chain_of(leaf), followed, joints) for leaf in leaves}
    most = max(_moving(chain) for chain in chains.values())
    if not most:  # a gripper alone, or nothing moves
        chains = {leaf: chain_of(leaf) for leaf in leaves}
        most = max(_moving(chain) for chain in chains.values())
    longest = {leaf: chain for leaf, chain in chains.items() if _moving(chain) == most}
    arms = {tuple(j[0] for j in chain if _moves(j)) for chain in longest.values()}
    if len(arms) > 1:
        raise ValueError(
            f"{path}: expected one tip, found {len(leaves)} leaves below {base}, and"
            f" {len(arms)} chains of {most} joints; name the last link as tip (--end):"
            f" {listed(leaves)}"
        )
    ends = [chain[-1][2] if chain else base for chain in longest.values()]
    tip = _best(list(dict.fromkeys(ends)), next(iter(longest.values())))
    taken = {joint[0] for joint in chain_of(tip)}
    left = [j[0] for leaf in leaves for j in chain_of(leaf) if _moves(j) and j[0] not in taken]
    left = list(dict.fromkeys(left))
    if len(leaves) == 1 and not left:
        return tip, ""
    said = f"the arm was taken from {base} to {tip}, the longest chain of arm joints"
    said += f"; left out: {listed(left)}" if left else ""
    return tip, f"{said}; name another end with --end (tip= in Python)."


def _moves(joint):
    return joint[3].get("type") in MOVABLE


def _moving(chain):
    return sum(map(_moves, chain))


def _followed(joints):
    """Joints that mimic others, and those that are mimicked: a gripper's."""
    found = set()
    for name, _, _, element in joints:
        mimic = element.find("mimic")
        if mimic is not None:
            found |= {name, mimic.get("joint")}
    return found


def _without_gripper(chain, followed, joints):
    """A chain up to the link before the first joint of a gripper."""
    for k, joint in enumerate(chain):
        if not _moves(joint):
            continue
        name, parent, child, _ = joint
        # a link called gripper hangs on the last joint of the arm as often as on the gripper's
        words = f"{name} {child}" if _moving(chain[k:]) == 1 else name
        grips = GRIPS.search(words) and not TURNS.search(name)
        if grips or name in followed or _is_finger(parent, chain[k:], joints):
            return chain[:k]
    return chain


def _is_finger(parent, rest, joints):
    """Whether a joint is one of several that move side by side on one link, with no more than two
    joints each: fingers.
    """
    beside = [j for j in joints if j[1] == parent and _moves(j)]
    return len(beside) > 1 and _moving(rest) <= 2


def _best(ends, chain):
    """Of links that stand still to one another the one that is usually meant."""
    for wanted in TIPS:
        for end in ends:
            if end.lower().endswith(wanted):
                return end
    if len(ends) == 1:
        return ends[0]
    # several frames on the last link: the last link itself
    return next((joint[2] for joint in reversed(chain) if _moves(joint)), ends[0])
