"""Standard ↔ Craig, exactly: theta and d stay in their rows, a and alpha move one row, base and
tool take the pair that is left over.
"""

import numpy as np

from ..arm import Arm
from ..table import CONVENTIONS, DHTable
from ..transform import rot_x, trans_x

__all__ = ["to_convention", "as_arm", "require_uncoupled"]


def to_convention(arm: Arm | DHTable, convention: str) -> Arm:
    """The same arm in another convention: the same pose for every q, joint variables, signs,
    limits, name and source unchanged.

    Parameters
    ----------
    arm : Arm or DHTable
    convention : "standard" or "craig"

    Returns
    -------
    Arm
        To Craig: row i holds a_{i-1} and alpha_{i-1}, row 1 zeros, tool' = Tx(a_n) Rx(alpha_n)
        tool. To standard: row i holds a_i and alpha_i, row n zeros, base' = base Rx(alpha_0)
        Tx(a_0). (Both conventions place the same common normals; Craig, Introduction to Robotics,
        section 3.4, has the frame at the near end of a link, the standard one at its far end.)

    Raises
    ------
    ValueError
        Not an arm, or no such convention.

    Examples
    --------
    >>> import dhlab as dh
    >>> print(to_convention(dh.load("panda.deluca_std"), "craig").table)
    Craig DH, 7 joints (lengths in m, angles in deg)
     i   theta  d      a(i-1)   alpha(i-1)
     1   q1     0.333  0        0
     2   q2     0      0        -90
     3   q3     0.316  0        90
     4   q4     0      0.0825   90
     5   q5     0.384  -0.0825  -90
     6   q6     0      0        90
     7   q7     0.107  0.088    90
    """
    if convention not in CONVENTIONS:
        raise ValueError(
            f'to: expected "standard" or "craig", found {convention!r}; "modified" is "craig" here'
        )
    arm = as_arm(arm, "to")
    table = arm.table
    if table.convention == convention:
        return arm
    base, tool = arm.base, arm.tool
    if convention == "craig":
        a, alpha = np.r_[0.0, table.a[:-1]], np.r_[0.0, table.alpha[:-1]]
        tool = trans_x(table.a[-1]) @ rot_x(table.alpha[-1]) @ tool
    else:
        a, alpha = np.r_[table.a[1:], 0.0], np.r_[table.alpha[1:], 0.0]
        base = base @ rot_x(table.alpha[0]) @ trans_x(table.a[0])
    moved = DHTable(convention, table.theta, table.d, a, alpha, table.joints)
    return Arm(
        moved,
        base=base,
        tool=tool,
        limits=arm.limits,
        sign=arm.sign,
        name=arm.name,
        source=arm.source,
        coupling=arm.coupling,
    )


def as_arm(given: object, where: str) -> Arm:
    """``given`` when it is an Arm, the plain arm of a DHTable; a sentence otherwise.

    Examples
    --------
    >>> as_arm([[0, 0, 1, 0]], "to")
    Traceback (most recent call last):
    ...
    ValueError: to: expected an Arm or a DHTable, found list; make one with DHTable.standard or
    DHTable.craig, or dhlab.load a named arm
    """
    if isinstance(given, Arm):
        return given
    if isinstance(given, DHTable):
        return Arm(given)
    raise ValueError(
        f"{where}: expected an Arm or a DHTable, found {type(given).__name__}; "
        "make one with DHTable.standard or DHTable.craig, or dhlab.load a named arm"
    )


def require_uncoupled(arm: Arm, where: str) -> None:
    """A sentence where the joints of an arm are coupled and ``where`` wants each its own.

    Examples
    --------
    >>> import dhlab as dh
    >>> table = dh.load("ur5e").table
    >>> require_uncoupled(Arm(table, coupling=np.eye(6) + np.eye(6, k=1)), "diagnose")
    Traceback (most recent call last):
    ...
    ValueError: diagnose: expected an arm whose joints move one by one, found coupled joints; give
    the arm without its coupling and sign, and arm.joint_values(q) in place of q
    """
    if arm.coupling is not None:
        raise ValueError(
            f"{where}: expected an arm whose joints move one by one, found coupled joints; give"
            " the arm without its coupling and sign, and arm.joint_values(q) in place of q"
        )
