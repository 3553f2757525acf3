"""Whose links a program makes, which of them its robot has, and in which order."""

import re

__all__ = ["made_here", "of_the_robot"]

LISTED = re.compile(
    r"\b(?:SerialLink|DHRobot|SerialManipulator|robot|chain|arm)\w*\s*\(\s*\[([^\[\]]+)\]",
    re.IGNORECASE,
)
# SerialLink(L(1:6)), DHRobot(links[:6])
PART = re.compile(
    r"\b(?:SerialLink|DHRobot)\s*\(\s*(\w+)\s*(?:\(\s*(\d+)\s*:\s*(\d+)\s*\)|\[\s*(\d*)\s*:\s*(\d+)\s*\])"
)
ADDED = re.compile(r"\b\w+\s*(?:\.|->)\s*(?:add_?link|addLink|AddLink)\s*\(\s*&?\s*(\w+)\s*\)")


def of_the_robot(places, code):
    """(the numbers, from 0, of the links that the robot of the program is made of, in its order;
    what is to be said of that): all of them where nothing says it.

    Parameters
    ----------
    places : list of str
        What each link is assigned to, with its index: ``L1``, ``L(2)``.
    code : str

    Examples
    --------
    >>> of_the_robot(["L1", "L2", "L3"], "r = SerialLink([L1 L2], 'name', 'short')")
    ([0, 1], 'L3 is made and not in the robot')
    """
    at = {re.sub(r"\s", "", place): k for k, place in enumerate(places)}
    lists = [re.split(r"[\s,;]+", one.strip()) for one in LISTED.findall(code)]
    added = ADDED.findall(code)
    lists += [added] if len(set(added)) == len(added) > 1 else []
    lists += [
        [f"{name}({k})" for k in range(int(first), int(last) + 1)]
        if last
        else [f"{name}[{k}]" for k in range(int(begin or 0), int(end))]
        for name, first, last, begin, end in PART.findall(code)
    ]
    lists = [one for one in lists if len(one) > 1 and len(set(one)) == len(one)]
    if len(lists) != 1 or not all(name in at for name in lists[0]):
        return [*range(len(places))], ""
    used = [at[name] for name in lists[0]]
    left = [place for k, place in enumerate(places) if k not in used]
    if left:
        return used, f"{', '.join(left)[:60]} is made and not in the robot"
    return used, "" if used == sorted(used) else "the links stand in the order of the robot"


def made_here(name, code):
    """Whether the text makes a class itself, ``Link = namedtuple("Link", …)`` or ``class Link:``.

    Examples
    --------
    >>> made_here("Link", "class Link:"), made_here("Link", "from toolbox import Link")
    (True, False)
    """
    words = r"(?:\w+[ \t]+)*(?:class|struct|record|type)[ \t]+"
    made = rf"namedtuple\(\s*['\"]{name}\b|^[ \t]*{words}{name}\b"
    return bool(re.search(made, code, re.MULTILINE))
