"""The sheet to take to the arm: which poses to drive to, what to measure there, in which order."""

from dataclasses import dataclass

import numpy as np

from ...arm import Arm
from ...printing import grid_text, listed, number

__all__ = ["Protocol"]


@dataclass(frozen=True, eq=False, repr=False)
class Protocol:
    """Which poses to drive to and what to measure there.

    Parameters
    ----------
    arm : Arm
    q : array (m, n)
        Whole 5° (10 mm for a sliding joint), in radians and metres.
    smallest : float
        Every mistake that moves the point by 20 mm anywhere moves it this far at one of the poses,
        m.
    hidden : tuple of str
        The table's numbers that no position shows.
    still : tuple of int
        The joints (1-based) that do not move the measured point, which lies on their axes.
    above : bool
        The poses keep the arm above its base's plane.

    Examples
    --------
    >>> import dhlab as dh
    >>> plan = dh.doctor.protocol(dh.load("article-6r"), 4)
    >>> plan.q.shape, plan.still, plan.above
    ((4, 6), (6,), True)
    """

    arm: Arm
    q: np.ndarray
    smallest: float
    hidden: tuple
    still: tuple
    above: bool

    @property
    def text(self):
        """The sheet as plain text."""
        who = self.arm.name or "this arm"
        rows = _written(self.arm, self.q)
        units = ["mm" if letter == "P" else "deg" for letter in self.arm.table.joints]
        heads = [
            "pose",
            *(f"q{i + 1} ({unit})" for i, unit in enumerate(units)),
            "x (mm)",
            "y (mm)",
            "z (mm)",
        ]
        grid = grid_text(heads, [[str(k), *row, *["______"] * 3] for k, row in enumerate(rows, 1)])
        return "\n".join(
            [f"With a tape measure: {len(rows)} poses of {who}", "", grid, "", *_steps(self)]
        )

    def to_csv(self):
        """The sheet as a poses file in mm and degrees, x, y, z empty.

        Examples
        --------
        >>> import dhlab as dh
        >>> dh.doctor.protocol(dh.load("article-6r")).to_csv().splitlines()[1]
        'q1,q2,q3,q4,q5,q6,x,y,z'
        """
        header = ",".join([*(f"q{i + 1}" for i in range(len(self.arm))), "x", "y", "z"])
        about = (
            f"# units: mm,deg; {' '.join((self.arm.name or 'an arm').split())}: fill in x, y, z;"
            " joint values are in deg, of sliding joints in mm"
        )
        return (
            "\n".join(
                [about, header, *(",".join(row) + ",,," for row in _written(self.arm, self.q))]
            )
            + "\n"
        )

    def to_dict(self):
        """Plain values for a program."""
        return {
            "arm": self.arm.name,
            "units": {"length": "m", "angle": "rad"},
            "q": self.q.tolist(),
            "smallest_change": self.smallest,
            "hidden": list(self.hidden),
            "joints_that_move_nothing": list(self.still),
            "csv": self.to_csv(),
        }

    def __str__(self):
        return self.text

    __repr__ = __str__


def _written(arm, q):
    human = np.where(arm.table.prismatic, q * 1000, np.rad2deg(q))
    return [[number(value, 3) for value in row] for row in human]


def _steps(plan):
    """What to do, a line each."""
    yield (
        "1. Mark the base's origin and its x axis on the table. Drive slowly: the table is what is"
        " doubted" + ("." if plan.above else ", and some of these poses reach below the base.")
    )
    yield (
        "2. At each pose measure the tool point from that origin, in mm: x and y on the table,"
        " under a plumb line, z above it. 3 to 5 mm is good enough."
    )
    if plan.arm.limits is None:
        yield "   No limits are known here: hold every angle against the arm before driving."
    yield "   A pose that cannot be reached is left out; six will do."
    yield (
        "3. Write the numbers into the CSV sheet (--sheet FILE.csv writes it; delete the lines not"
        " measured), then:"
    )
    yield "   dhlab doctor ARM FILE.csv --units mm,deg --noise 4mm"
    yield (
        "   If the base frame cannot be reached with a tape, measure from any corner, along any"
        " right-angled axes, and add --free-base."
    )
    yield (
        "Every mistake of the catalogue that a tape can show on this arm moves the point by"
        f" {number(1e3 * plan.smallest, 0)} mm or more at one of these poses."
    )
    if plan.hidden:
        joints = [f"joint {i}" for i in plan.still]
        why = f": the tool point lies on the axis of {listed(joints)}" if joints else ""
        yield f"Positions cannot show {listed(plan.hidden)}{why}."
    if plan.still:
        yield (
            "Clamp a pointer that sticks out sideways (100 mm, say) and put its tip into the arm's"
            " tool: then they show."
        )
