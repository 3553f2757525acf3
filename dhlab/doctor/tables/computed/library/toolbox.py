"""The links of the Robotics Toolbox, which hold their rows themselves."""

from dataclasses import dataclass

from ..held.budget import Unsupported
from ..held.values import Unknown, is_number, number_of

__all__ = ["BESIDE", "LINKS", "Link", "keep_robot", "links_in"]

TURNING = ("d", "a", "alpha", "offset")
BESIDE = ("qlim", "name", "I", "m", "r", "Jm", "G", "B", "Tc")  # no part of the row
SLIDING = ("theta", "a", "alpha", "offset")


@dataclass(eq=False)
class Link:
    """A link: its convention, the letter of its joint, its numbers, None where one of them was set
    to something that is not known, and whether it is turned round.
    """

    convention: str
    letter: str
    row: tuple | None  # theta, d, a, alpha
    sign: int = 1

    def put(self, name, value):
        """Let one of its numbers be another."""
        if name in BESIDE:
            return
        place = {"theta": 0, "d": 1, "a": 2, "alpha": 3, "offset": int(self.letter == "P")}
        row, self.row = self.row, None
        if row is None or name not in place or not is_number(value) or isinstance(value, Unknown):
            raise Unsupported("a number of a link that is not known")
        at = place[name]
        self.row = (*row[:at], float(number_of(value)), *row[at + 1 :])


def _maker(convention, letter):
    names = TURNING if letter == "R" else SLIDING

    def call(run, args, kwargs):
        said = dict(zip(names, args)) | {key: kwargs[key] for key in names if key in kwargs}
        if any(isinstance(value, Unknown) for value in said.values()):
            raise Unsupported("a number that is not known")
        held = {key: float(number_of(value)) for key, value in said.items()}
        zero = held.get("offset", 0.0)
        theta, d = (zero, held.get("d", 0.0)) if letter == "R" else (held.get("theta", 0.0), zero)
        sign = -1 if kwargs.get("flip") is True else 1
        row = (theta, d, held.get("a", 0.0), held.get("alpha", 0.0))
        return Link(convention, letter, row, sign)

    return call


def robot(run, args, kwargs):
    """A chain of links: what the program was written for."""
    given = args[0] if args else kwargs.get("links", [])
    keep_robot(run, given)
    return run.unknown("robot")


def keep_robot(run, given):
    """Keep a list of links."""
    if isinstance(given, list | tuple) and given and all(isinstance(one, Link) for one in given):
        run.robots.append(tuple(given))


def links_in(value):
    """The links that a name holds: one, or those set by their numbers, ``L(2) = Link(…)``."""
    numbered = isinstance(value, dict) and all(isinstance(key, int) for key in value)
    held = [value[key] for key in sorted(value)] if numbered else [value]
    return held if all(isinstance(one, Link) for one in held) else []


LINKS = {
    "RevoluteDH": _maker("standard", "R"), "PrismaticDH": _maker("standard", "P"),
    "RevoluteMDH": _maker("craig", "R"), "PrismaticMDH": _maker("craig", "P"),
    "DHRobot": robot,
}  # fmt: skip
