"""The names that learning platforms give to what one person hands in: who it is, as the platform
writes it, stands before what that person called the file.
"""

import re
from typing import NamedTuple

__all__ = ["BLACKBOARD", "CANVAS", "Written", "from_platform", "without_group", "written"]

CANVAS, BLACKBOARD = "Canvas", "Blackboard"
# Canvas first: a file that a student there has named may look like another platform's
PATTERNS = {
    CANVAS: re.compile(r"(?P<name>[^_]+)_(LATE_)?(?P<number>\d+)_\d+_.+", re.IGNORECASE),
    "Moodle": re.compile(r"(?P<name>.+?)_(?P<number>\d+)_assignsubmission_(file|onlinetext)"),
    "Brightspace": re.compile(
        r"(?P<number>\d+)-\d+ ?- ?(?P<name>.+?) ?- ?[A-Z][a-z]{2} \d{1,2}, \d{4} [\d:]+ [AP]M"
    ),
    BLACKBOARD: re.compile(r"(?P<name>.+?)_attempt_\d{4}(-\d\d){5}(?=[_.]|$)"),
}
GRADESCOPE = re.compile(r"submission_\d+$")  # it says who only in a list beside its folders
GROUP = re.compile(r".*?(\d|\b\w)-(?P<name>.+)")  # "Group A-" and "team 3-", but not "Anna-"


class Written(NamedTuple):
    """What a learning platform wrote into a name: the person's name or id, and on Canvas and Moodle
    the platform's number for the person. On Blackboard the assignment stands before the id.
    """

    platform: str
    name: str
    number: str = ""


def written(part: str) -> Written | None:
    """What a platform wrote into the name of a folder or file; None where none did.

    Examples
    --------
    >>> written("lovelaceada_8812_99123_my work.ipynb")
    Written(platform='Canvas', name='lovelaceada', number='8812')
    """
    for platform, pattern in PATTERNS.items():
        if match := pattern.match(part):
            return Written(platform, **match.groupdict())
    return None


def from_platform(part: str) -> bool:
    """Whether a platform gave this name to what one person hands in.

    Examples
    --------
    >>> from_platform("Ada Lovelace_771_assignsubmission_file_"), from_platform("ada")
    (True, False)
    """
    return bool(written(part) or GRADESCOPE.match(part))


def without_group(name: str) -> str:
    """A person's name without the group that Moodle may put before it.

    Examples
    --------
    >>> without_group("Group A-Ada Lovelace"), without_group("Anna-Lena Bo")
    ('Ada Lovelace', 'Anna-Lena Bo')
    """
    group = GROUP.fullmatch(name)
    return group["name"] if group else name
