"""Source files for a controller: forward kinematics and Jacobian of one arm, in C or Python, with
test values and a check of its own.

It needs no SymPy. Joints on parallel axes are turned together, and every operation is written down
once. On the arms of the library that takes at most two operations more than SymPy's ``cse`` of
:func:`dhlab.symbolic.product`, and up to a quarter fewer (``benchmarks/generated.py``).
"""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np

from ..arm import Arm
from ..table import DHTable
from .c import c_source
from .formulas import forward_formulas, jacobian_formulas
from .lines import Lines
from .python import python_source
from .samples import samples
from .words import header, identifier

__all__ = ["CHECKS", "LANGUAGES", "generate"]

LANGUAGES = {"c": c_source, "python": python_source}
RIGID = 1e-12  # an entry of a rotation; a base typed with seven digits is off by more
CHECKS = {"c": "gcc -std=c99 -DDHLAB_TEST FILE -lm -o check && ./check", "python": "python FILE"}


def generate(arm: Arm | DHTable, language: str = "c", *, name: str | None = None) -> str:
    """Forward kinematics and Jacobian of one arm as one source file that needs nothing else.

    C is C99 with ``math.h``: ``NAME_forward(const double q[n], double T[16])`` and
    ``NAME_jacobian(const double q[n], double J[6*n])``, matrices row by row; with ``DHLAB_TEST``
    defined, a ``main`` checks them. Python is ``NAME_forward(q)`` and ``NAME_jacobian(q)``, which
    give rows; run as a program, it checks them. Base, tool, signs and offsets are in it; limits are
    stated and not enforced.

    Parameters
    ----------
    arm : Arm or DHTable
    language : "c" or "python"
    name : str, optional
        What the functions' names begin with: a letter, then letters, digits and underscores. Made
        from the arm's name when left out.

    Returns
    -------
    str
        The same arm gives the same text.

    Raises
    ------
    ValueError
        Something else than an arm or a table, a language that is not there, a name that is none,
        lengths so large that a pose overflows.

    Notes
    -----
    Angles of joints on parallel axes are added before the cosine is taken; for joint values of many
    turns that rounds a little coarser than ``arm.forward``. Where the rotation of base or tool was
    given with few digits, the nearest rotation stands in for it, and the file's head says so.

    Examples
    --------
    >>> import dhlab as dh
    >>> text = dh.generate(dh.load("ur5e"), "c", name="ur5e")
    >>> print(*[line for line in text.splitlines() if line.startswith("void")][:2], sep="\\n")
    void ur5e_forward(const double q[6], double T[16]);
    void ur5e_jacobian(const double q[6], double J[36]);
    """
    arm = Arm(arm) if isinstance(arm, DHTable) else arm
    if not isinstance(arm, Arm):
        raise ValueError(
            f"generate: expected a DHTable or an Arm, found {type(arm).__name__}; make one with"
            " DHTable.standard or dhlab.load"
        )
    if language not in list(LANGUAGES):
        raise ValueError(f'generate: expected the language "c" or "python", found {language!r}')
    name = _named(arm, name)
    arm, notes = _rigid(arm)
    tests = samples(arm)
    forward, jacobian = forward_formulas(arm), jacobian_formulas(arm)
    head = header(arm, {"forward": forward, "jacobian": jacobian}, notes, CHECKS[language])
    return LANGUAGES[language](arm, name, head, Lines(forward), Lines(jacobian), tests)


def _named(arm: Arm, name: str | None) -> str:
    if name is None:
        return identifier(arm.name)
    if not isinstance(name, str) or not re.fullmatch(r"[A-Za-z][A-Za-z0-9_]{0,39}", name):
        raise ValueError(
            "generate: name: expected a letter, then letters, digits or underscores, 40 at most,"
            f" found {name!r}"
        )
    return name


def _rigid(arm: Arm) -> tuple[Arm, list[str]]:
    """The arm with exact rotations in base and tool, and a sentence for each that was not."""
    exact, notes = {}, []
    for name in ("base", "tool"):
        given = getattr(arm, name)
        pose = _nearest_pose(given)
        off = abs(pose - given).max()
        if off > RIGID:
            exact[name] = pose
            notes.append(f"The rotation of the {name} was made exact; it was given {off:.1g} off.")
    return replace(arm, **exact), notes


def _nearest_pose(given):
    """The rotation nearest to what was given, by its polar decomposition."""
    U, _, Vt = np.linalg.svd(given[:3, :3])
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = U @ Vt, given[:3, 3]
    return pose
