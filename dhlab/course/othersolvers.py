"""The same inverse kinematics by other people's libraries, each run in a process of its own; their
stored answers where they are not installed.

Robotics Toolbox (Levenberg-Marquardt), PyBullet (damped least squares, on the arm's URDF) and
TRAC-IK, which runs KDL's Newton beside a sequential quadratic program (on the URDF too). ``pip
install dhlab-kinematics[oracles]`` brings them on Linux.
"""

import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike
from scipy.spatial.transform import Rotation

from ..arm import Arm
from ..formats.descriptions.urdf import to_urdf
from ..printing import grid_text, number
from ..table import DHTable

__all__ = ["other_solvers", "solve_all"]

LIBRARIES = ("Robotics Toolbox", "PyBullet", "TRAC-IK")
SECONDS = 60
HEADINGS = ("library", "q (deg)", "off by (mm)", "turned by (deg)", "")
# what each library answered for article-6r, from q = (0, 40, -60, 20, 30, 0)° to the pose at (30,
# 60, -80, -30, 40, 0)°; degrees. roboticstoolbox 1.5.0, pybullet 3.2.7, pytracik 0.0.3
STORED = {
    "Robotics Toolbox": (30.0, 60.011, -80.019, -29.992, 40.0, 0.0),
    "PyBullet": (30.0, 60.0, -80.0, -30.0, 40.0, 0.0),
    "TRAC-IK": (30.0, 60.0, -80.0, -30.0, 40.0, 0.0),
}
STORED_FROM, STORED_TO = (0, 40, -60, 20, 30, 0), (30, 60, -80, -30, 40, 0)


def other_solvers(arm: Arm, T_goal: ArrayLike, q: ArrayLike) -> str:
    """What three libraries answer when they are asked for the joint values that reach a pose.

    Parameters
    ----------
    arm : Arm
        Turning joints.
    T_goal : array (4, 4)
        Metres.
    q : array (n,)
        Where they begin, radians.

    Returns
    -------
    str
        A line per library: joint values in whole degrees, how far their pose is from the goal (by
        this arm's forward kinematics), and whether the library was run here or its stored answer is
        shown. There are stored answers for the task of lesson 08 only.

    Raises
    ------
    ValueError
        An arm with a sliding joint.

    Examples
    --------
    >>> import dhlab as dh
    >>> arm = dh.load("article-6r")
    >>> T_goal = arm.forward(np.deg2rad(STORED_TO))
    >>> shown = other_solvers(arm, T_goal, np.deg2rad(STORED_FROM))  # doctest: +SKIP
    >>> shown.splitlines()[1][:37]  # doctest: +SKIP
    ' Robotics Toolbox  30 60 -80 -30 40 0'
    """
    if arm.table.prismatic.any():
        raise ValueError(
            "other_solvers: expected turning joints only, found a sliding one; choose another arm"
        )
    answers = _in_a_process(arm, T_goal, q)
    known = (
        arm == _the_arm()
        and np.allclose(T_goal, arm.forward(np.deg2rad(STORED_TO)))
        and np.allclose(q, np.deg2rad(STORED_FROM))
    )
    return grid_text(
        HEADINGS,
        [
            _line(name, arm, T_goal, answers.get(name), np.deg2rad(STORED[name]) if known else None)
            for name in LIBRARIES
        ],
    )


def _the_arm():
    from ..robots import load

    return load("article-6r")


def _line(name, arm, T_goal, answer, stored):
    if answer is None and stored is None:
        return [name, "", "", "", "not installed here"]
    q = np.asarray(stored if answer is None else answer)
    T = arm.forward(q)
    way, turn = (
        1e3 * np.linalg.norm(T[:3, 3] - T_goal[:3, 3]),
        np.rad2deg(Rotation.from_matrix(T[:3, :3].T @ T_goal[:3, :3]).magnitude()),
    )
    where = "stored: not installed here" if answer is None else "computed here"
    return [name, " ".join(number(x, 0) for x in np.rad2deg(q)), _size(way), _size(turn), where]


def _size(value):
    return "under 0.1" if value < 0.1 else number(value, 1)


def _in_a_process(arm, T_goal, q):
    """The answers by library; empty where no process can be had. Two of the libraries print when
    they are loaded, and none may end the notebook.
    """
    task = {
        "arm": _described(arm),
        "T_goal": np.asarray(T_goal).tolist(),
        "q": np.asarray(q).tolist(),
    }
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(path for path in sys.path if path)}
    try:
        run = subprocess.run(
            [sys.executable, "-m", "dhlab.course.othersolvers"],
            input=json.dumps(task),
            capture_output=True,
            text=True,
            timeout=SECONDS,
            env=environment,
        )
        return json.loads(run.stdout.splitlines()[-1])
    except (OSError, subprocess.SubprocessError, ValueError, IndexError):
        return {}


def _described(arm):
    arrays = {name: getattr(arm, name).tolist() for name in ("base", "tool", "sign")}
    return {"convention": arm.table.convention, "rows": arm.table.rows.tolist(), **arrays}


def solve_all(task: Mapping[str, Any]) -> dict[str, Any]:
    """The answers of the libraries that can be loaded here, by name; radians. ``task`` is what
    :func:`other_solvers` hands over.
    """
    parts = task["arm"]
    make = DHTable.standard if parts["convention"] == "standard" else DHTable.craig
    arm = Arm(
        make(parts["rows"], angle="rad"),
        base=parts["base"],
        tool=parts["tool"],
        sign=parts["sign"],
        name="arm",
    ).to("standard")
    T_goal, q, found = np.array(task["T_goal"]), np.array(task["q"]), {}
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "arm.urdf")
        to_urdf(arm, path)
        for name, solve in zip(LIBRARIES, (_robotics_toolbox, _pybullet, _trac_ik)):
            try:
                found[name] = [float(x) for x in solve(arm, str(path), T_goal, q)]
            except ImportError:
                continue
    return found


def _robotics_toolbox(arm, path, T_goal, q):
    from roboticstoolbox import DHRobot, RevoluteDH

    links = [
        RevoluteDH(d=d, a=a, alpha=alpha, offset=theta, flip=sign < 0)
        for (theta, d, a, alpha), sign in zip(arm.table.rows, arm.sign)
    ]
    return DHRobot(links, base=arm.base, tool=arm.tool).ikine_LM(T_goal, q0=q).q


def _pybullet(arm, path, T_goal, q):
    import pybullet

    pybullet.connect(pybullet.DIRECT)
    body = pybullet.loadURDF(path, useFixedBase=True)
    for joint, value in enumerate(q):
        pybullet.resetJointState(body, joint, value)
    turn = Rotation.from_matrix(T_goal[:3, :3]).as_quat().tolist()
    return pybullet.calculateInverseKinematics(
        body, len(q), T_goal[:3, 3].tolist(), turn, maxNumIterations=200, residualThreshold=1e-9
    )


def _trac_ik(arm, path, T_goal, q):
    from trac_ik import TracIK

    solver = TracIK("link_0", "tool", path, timeout=0.1, solver_type="Distance")
    return solver.ik(T_goal[:3, 3].copy(), T_goal[:3, :3].copy(), seed_jnt_values=q)


if __name__ == "__main__":
    answers = solve_all(json.load(sys.stdin))
    print("\n" + json.dumps(answers))
