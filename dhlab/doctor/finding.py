"""``Finding``: one mistake, recognised, with its place and what repairs it."""

from dataclasses import dataclass

from ..arm import Arm
from .catalogue import catalogue

__all__ = ["Finding", "find"]


@dataclass(frozen=True)
class Finding:
    """A mistake that explains what was seen.

    Parameters
    ----------
    mistake : str
        Its id in the catalogue, such as ``"alpha-sign"``.
    joint : int or None
        1-based row or joint; None when it is everywhere.
    parameter : str or None
        ``"theta"``, ``"d"``, ``"a"``, ``"alpha"``, ``"sign"``, ``"coupling"``, ``"base"``,
        ``"tool"``, ``"q"``, ``"poses"`` or None.
    place : str
        Where, in words; empty when it is everywhere.
    detail : str
        What exactly, such as ``"-90° should be 90°"``.
    repair : Arm or None
        The corrected arm.
    look_alikes : tuple of str
        Ids of other mistakes that give the same on this arm.

    Examples
    --------
    >>> import numpy as np, dhlab as dh
    >>> arm = dh.load("article-6r")
    >>> q = np.random.default_rng(1).uniform(-2, 2, (6, 6))
    >>> finding, = dh.diagnose(arm, q, arm.forward(q) @ dh.transform.trans_z(0.1)).findings
    >>> finding.mistake, finding.joint, finding.parameter
    ('length-value', 6, 'd')
    """

    mistake: str
    joint: int | None = None
    parameter: str | None = None
    place: str = ""
    detail: str = ""
    repair: Arm | None = None
    look_alikes: tuple = ()

    @property
    def message(self):
        """Kind, place, reason and next step in a few sentences."""
        words = catalogue()[self.mistake]
        where = f" ({self.place})" if self.place else ""
        detail = f" {self.detail}." if self.detail else ""
        return f"{words.title}{where}.{detail} {words.see} {words.why} Next: {words.next}"

    def to_dict(self):
        """Plain values for a program; the repair as its rows."""
        return {
            "mistake": self.mistake,
            "title": catalogue()[self.mistake].title,
            "joint": self.joint,
            "parameter": self.parameter,
            "place": self.place,
            "detail": self.detail,
            "message": self.message,
            "lesson": catalogue()[self.mistake].lesson,
            "look_alikes": list(self.look_alikes),
            "repair": None if self.repair is None else _described(self.repair),
        }


def _described(arm):
    table = arm.table
    return {
        "convention": table.convention,
        "joints": table.joints,
        "rows": table.rows.tolist(),
        "sign": arm.sign.tolist(),
        "coupling": None if arm.coupling is None else arm.coupling.tolist(),
        "base": arm.base.tolist(),
        "tool": arm.tool.tolist(),
    }


def find(mistake_id, place="", **parts):
    """The Finding for an id of the catalogue.

    Examples
    --------
    >>> find("alpha-sign", "row 3").message[:32]
    'alpha has the wrong sign (row 3)'
    """
    return Finding(catalogue()[mistake_id].id, place=place, **parts)
