"""The numbers of an arm in Hayati's form, which stays small and exact where axes are nearly
parallel and a DH table runs away.
"""

from __future__ import annotations

from dataclasses import dataclass
from html import escape
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...arm import Arm
from ...printing import grid_html, grid_text, number
from ...table import DHTable
from ...transform import inverse, to_xyz_rpy
from ..canonical import joint_axes
from ..conversion import as_arm
from .walk import cases_of, links_of, walk

__all__ = ["Hayati", "hayati"]

HEADINGS = ("i", "theta", "d", "a", "alpha", "beta")


@dataclass(frozen=True, eq=False)
class Hayati:
    """An arm as theta, d, a, alpha, beta per joint: ``A_i = Rz(theta) Tz(d) Tx(a) Rx(alpha)
    Ry(beta)``, q added to theta (to d where the joint slides).

    Attributes
    ----------
    rows : array (n, 5)
        Radians and metres. beta is 0 except where the next axis is nearly parallel; there d is 0
        (of a turning joint).
    joints : str
        Such as "RRP".
    base, tool : array (4, 4)
        The pose is base · A_1 … A_n · tool.
    name : str

    Examples
    --------
    >>> import dhlab as dh
    >>> dh.hayati(dh.load("ur5e")).rows.shape
    (6, 5)
    """

    rows: NDArray[np.float64]
    joints: str
    base: NDArray[np.float64]
    tool: NDArray[np.float64]
    name: str = ""

    def to_dict(self) -> dict[str, Any]:
        """Plain values for a program, in m and rad.

        Examples
        --------
        >>> import dhlab as dh
        >>> dh.hayati(dh.load("ur5e")).to_dict()["columns"]
        ['theta', 'd', 'a', 'alpha', 'beta']
        """
        return {
            "name": self.name,
            "product": "base Rz(theta) Tz(d) Tx(a) Rx(alpha) Ry(beta) ... tool",
            "units": {"length": "m", "angle": "rad"},
            "columns": list(HEADINGS[1:]),
            "joints": self.joints,
            "rows": self.rows.tolist(),
            "base": self.base.tolist(),
            "tool": self.tool.tolist(),
        }

    def to_csv(self) -> str:
        """The rows as CSV, each number the shortest that reads back as it is.

        Examples
        --------
        >>> import dhlab as dh
        >>> print(dh.hayati(dh.load("ur5e")).to_csv().splitlines()[0])
        theta_rad,d_m,a_m,alpha_rad,beta_rad,type
        """
        kinds = {"R": "revolute", "P": "prismatic"}
        lines = ["theta_rad,d_m,a_m,alpha_rad,beta_rad,type"]
        for row, letter in zip(self.rows, self.joints):
            lines.append(",".join([*(repr(float(x)) for x in row), kinds[letter]]))
        return "\n".join(lines) + "\n"

    def __str__(self) -> str:
        title = f"{self.name}\n" if self.name else ""
        title += (
            "Hayati's parameters (lengths in m, angles in deg): Rz(theta) Tz(d) Tx(a) Rx(alpha)"
        )
        return "\n".join([f"{title} Ry(beta)", grid_text(HEADINGS, self._cells()), *self._ends()])

    def _repr_html_(self) -> str:
        ends = "".join(f"<p>{escape(line)}</p>" for line in self._ends())
        return grid_html(HEADINGS, self._cells(), f"{self.name}: Hayati's parameters") + ends

    def _cells(self):
        for i, (row, letter) in enumerate(zip(self.rows, self.joints), 1):
            angles = np.rad2deg(row[[0, 3, 4]])
            cells = [number(angles[0]), *(number(x) for x in row[1:3]), *map(number, angles[1:])]
            k = 1 if letter == "P" else 0
            cells[k] = f"q{i}" if cells[k] == "0" else f"q{i} + {cells[k]}".replace("+ -", "- ")
            yield [str(i), *cells]

    def _ends(self):
        for name in ("base", "tool"):
            pose = getattr(self, name)
            if not np.allclose(pose, np.eye(4), atol=1e-12):
                xyz, rpy = to_xyz_rpy(pose)
                yield (
                    f"{name}: xyz {' '.join(number(v) for v in xyz)} m, roll pitch yaw"
                    f" {' '.join(number(v) for v in np.rad2deg(rpy))} deg"
                )


def hayati(arm: Arm | DHTable) -> Hayati:
    """An arm in Hayati's parameters, for where its DH table is badly conditioned.

    Two axes that are nearly, but not quite, parallel have their common normal far outside the arm,
    and a DH table lengths of kilometres. Hayati's form goes through the plane across the first axis
    instead, and has a fifth number. Elsewhere it is the DH table itself.

    Parameters
    ----------
    arm : Arm or DHTable
        Its joints count as they are; a joint with sign -1 has its z turned round.

    Returns
    -------
    Hayati

    Raises
    ------
    ValueError
        No arm, or coupled joints.

    Notes
    -----
    Hayati and Mirmirani, "Improving the absolute positioning accuracy of robot manipulators",
    Journal of Robotic Systems 2 (1985), 397-413.

    Examples
    --------
    >>> import dhlab as dh
    >>> print(hayati(dh.load("article-6r-wrist")))
    The arm that the article's text describes (roll, pitch, roll wrist), same lengths
    Hayati's parameters (lengths in m, angles in deg): Rz(theta) Tz(d) Tx(a) Rx(alpha) Ry(beta)
     i  theta     d     a    alpha  beta
     1  q1        0.1   0    90     0
     2  q2        0     0.4  0      0
     3  q3 + 90   0.1   0    90     0
     4  q4 + 180  0.35  0    90     0
     5  q5 + 180  0     0    90     0
     6  q6        0.1   0    0      0
    """
    from ..conversion import require_uncoupled

    given = as_arm(arm, "hayati")
    require_uncoupled(given, "hayati")
    A = joint_axes(given)
    cases = cases_of(A)
    way = walk(A, cases)
    n = len(given)
    links = links_of(A, way, cases, np.ones(n), np.ones(n - 1))
    rows = np.array([[k.theta, k.d, k.a, k.alpha, k.beta] for k in links])
    rows[abs(rows) < 1e-15] = 0.0
    base = np.eye(4)
    base[:3, :3] = np.column_stack([way.x[0], np.cross(A.z[0], way.x[0]), A.z[0]])
    base[:3, 3] = way.into[0]
    last = np.eye(4)
    last[:3, :3] = np.column_stack([way.x[-1], np.cross(A.z[-1], way.x[-1]), A.z[-1]])
    last[:3, 3] = way.out[-1]
    return Hayati(rows, A.letters, base, inverse(last) @ A.end, given.name)
