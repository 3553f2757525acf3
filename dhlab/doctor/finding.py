"""``Finding``: one mistake, recognised, with its place."""

from dataclasses import dataclass

from .catalogue import Mistake, catalogue

__all__ = ["Finding", "find"]


@dataclass(frozen=True)
class Finding:
    """A mistake that explains an answer; ``place`` says where (row 3, column 2, joint 4), empty when it is everywhere."""

    mistake: Mistake
    place: str = ""

    @property
    def message(self):
        """Kind, place, reason and next step in a few sentences."""
        where = f" ({self.place})" if self.place else ""
        return f"{self.mistake.title}{where}. {self.mistake.see} {self.mistake.why} Next: {self.mistake.next}"


def find(mistake_id, place=""):
    """The Finding for an id of the catalogue.

    Examples
    --------
    >>> find("alpha-sign", "row 3").message[:32]
    'alpha has the wrong sign (row 3)'
    """
    return Finding(catalogue()[mistake_id], place)
