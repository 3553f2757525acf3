"""What lesson 05 says of a link matrix: of its entries and columns, and of its moves."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from ...doctor.programs.running.calling import Called
from ...doctor.programs.running.made import matrices_made
from ...doctor.programs.search.slipsearch import wrong_entries
from ..kinds import Function, Known, Said
from ..verdict import RIGHT, Verdict
from .orders03 import ARGUMENTS

__all__ = ["ClosedForm", "OF_THE_MATRIX", "TYPED", "closed", "from_a_blog"]


def closed(theta: float, d: float, a: float, alpha: float) -> NDArray:
    """The link matrix, entry by entry."""
    c, s, u, v = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    return np.array(
        [[c, -s * u, s * v, a * c], [s, c * u, -c * v, a * s], [0, v, u, d], [0, 0, 0, 1]]
    )


def from_a_blog(theta: float, d: float, a: float, alpha: float) -> NDArray:
    """The broken program of 05.7: one sign of the z arrow."""
    T = closed(theta, d, a, alpha)
    T[1, 2] *= -1
    return T


OF_OTHERS = Said(
    "the right matrix, made by calling functions that make matrices; its entries are asked",
    next="Write the sixteen entries in this function, and call nothing but sines and cosines.",
)
OF_OTHERS_MENDED = replace(
    OF_OTHERS, next="Change entries of the program as you got it, and call no other one."
)


@dataclass(frozen=True, kw_only=True)
class ClosedForm(Function):
    """A link matrix typed entry by entry: what is wrong is said of its entries and columns. A
    product of matrices that other functions make is not asked.
    """

    watched: ClassVar[bool] = True

    def compare(self, answer: Any, variant: int) -> Verdict:
        verdict = super().compare(answer, variant)
        if verdict.status != RIGHT or self._made(answer, variant) < 2:
            return verdict
        return self.told(None, OF_OTHERS_MENDED if self.handed_out else OF_OTHERS)

    def _made(self, answer, variant):
        """How many functions made a matrix for the program."""
        if isinstance(answer, Called):
            return answer.made
        return len(matrices_made(answer, self.cases(variant)[0]))

    def refine(
        self, mistake: str | None, answers: Sequence[NDArray], cases: Sequence[tuple]
    ) -> Known | None:
        if mistake not in ("matrix-entry-mistyped", "not-rigid"):
            return None
        matrices = np.array(answers, dtype=float)
        said = (
            _wrong_columns(matrices[:, :3, :3])
            if mistake == "not-rigid"
            else _wrong_entries(wrong_entries(matrices, cases), self._spoilt(cases))
        )
        return said and (mistake, said)

    def _spoilt(self, cases):
        """Which entries (row, column, from 1) were right as they were handed out."""
        if self.handed_out is None:
            return ()
        pairs = [(self.handed_out(*case), self.answer(*case)) for case in cases]
        right = np.all([np.isclose(given, wanted) for given, wanted in pairs], axis=0)
        return [f"row {i}, column {k}" for i, k in np.argwhere(right) + 1]


NEXT = {
    2: "Turn y by θ, then tip it towards z by α.",
    3: "Take z = x × y: z is at right angles to both.",
}  # by column


def _wrong_entries(slips, right_before=()):
    """Which entries, the typed ones of a closed form; None when they are not known one by one."""
    if not slips:
        return None
    columns = {int(slip.place.split("column ")[1][0]) for slip in slips}
    given = any("row 3" in slip.place for slip in slips) or columns & {1, 4}
    column = min(columns)
    turned = (
        len(slips) == 2
        and len(columns) == 1
        and not given
        and all("its sign is turned" in slip.place for slip in slips)
    )
    headline = (
        f"column {column} points the wrong way"
        if turned
        else "one entry is wrong"
        if len(slips) == 1
        else f"{len(slips)} entries are wrong"
    )
    return Said(
        headline,
        next="Compare with the entries that the text gives." if given else NEXT[column],
        place="; ".join(
            place.replace(":", ", right as it was handed out:")
            if place.split(":")[0] in right_before
            else place
            for place in (slip.place for slip in slips)
        ),
    )


def _wrong_columns(R):
    """The first column, or pair of columns, that no frame's arrows can be."""
    for k in range(3):
        if np.abs(np.linalg.norm(R[:, :, k], axis=1) - 1).max() > 1e-6:
            return Said(
                f"column {k + 1} does not have length 1",
                next=NEXT.get(k + 1, "Compare with the entries that the text gives."),
                why="An arrow that is turned keeps its length.",
            )
        for j in range(k):
            if np.abs((R[:, :, j] * R[:, :, k]).sum(axis=1)).max() > 1e-6:
                return Said(
                    f"columns {j + 1} and {k + 1} are not at right angles",
                    next=NEXT[k + 1],
                    why="The arrows of a frame stand at right angles, whatever the angles are.",
                )
    return None


TURNED_BACK = Said(
    "α turns the other way", next="Set θ = 0, α = 90°: column 2 must be z, (0, 0, 1)."
)

X_FIRST = Said(
    "the x moves come before the z moves: this is the order of Craig's convention (lesson 03)",
    next="The move that is made first stands on the left, and each next one joins on the right.",
    place="Tx stands before Rz; Rx stands before Rz and Tz",
)

LEFT_HANDED = Said(
    "one arrow points the wrong way",
    next="Turn y by θ, then tip it by α; take z = x × y.",
    why="x, y and z must form a right hand.",
)

SIN_COS = Said(
    "a sine or a cosine is not where it belongs",
    next="Set this angle to 90°: its turn must be a quarter turn.",
)

OF_THE_MATRIX = {
    "columns-misread": ARGUMENTS,
    "alpha-sign": TURNED_BACK,
    "standard-rows-in-craig-matrix": X_FIRST,
    "mirror": LEFT_HANDED,
    "sin-cos-exchanged": SIN_COS,
}

TYPED = {  # of a matrix that is typed entry by entry, in which no moves stand
    "standard-rows-in-craig-matrix": Said(
        "this is the matrix of Craig's convention, in which the x moves come before the z moves",
        next="Of standard rows the last column is a cos θ, a sin θ, d. What stands there in yours?",
        place="the last column is a, −d sin α, d cos α",
    )
}
