"""Generated sources made to run, judged against dhlab and against a product of elementary matrices
that does not use it; and arms to try them on.
"""

import ctypes
import re
import subprocess

import numpy as np
from oracles import whole_pose_and_jacobian

import dhlab as dh
from dhlab.transform import from_xyz_rpy

WARNINGS = [
    *("-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Wstrict-prototypes"),
    *("-Wmissing-prototypes", "-Wmissing-declarations", "-Werror"),
]


def compiled(gcc, text, folder, *options, name="arm.c"):
    """The file that gcc makes of a source, which must not draw a warning."""
    source, out = folder / name, folder / f"made{len(list(folder.iterdir()))}"
    source.write_bytes(text.encode())
    done = subprocess.run(
        [gcc, "-std=c99", *WARNINGS, *options, source, "-lm", "-o", out],
        capture_output=True,
        text=True,
    )
    assert (done.returncode, done.stderr) == (0, "")
    return out


def checks_itself(gcc, text, folder):
    """What the source's own main prints; its exit status is 0."""
    program = compiled(gcc, text, folder, "-DDHLAB_TEST")
    done = subprocess.run([program], capture_output=True, text=True)
    assert done.returncode == 0
    assert re.search(r"poses, 0 of \d+ numbers wrong\n$", done.stdout)
    return done.stdout


class InC:
    """The two functions of a C source, as functions of numpy arrays."""

    def __init__(self, gcc, arm, folder):
        text = dh.generate(arm, "c", name="arm")
        checks_itself(gcc, text, folder)
        self.n = len(arm)
        self.library = ctypes.CDLL(str(compiled(gcc, text, folder, "-shared", "-fPIC", "-O1")))

    def _called(self, function, q, shape):
        q, out = np.array(q, dtype=float), np.full(shape, np.nan)
        pointer = ctypes.POINTER(ctypes.c_double)
        function.argtypes, function.restype = [pointer, pointer], None
        function(q.ctypes.data_as(pointer), out.ctypes.data_as(pointer))
        return out

    def forward(self, q):
        return self._called(self.library.arm_forward, q, (4, 4))

    def jacobian(self, q):
        return self._called(self.library.arm_jacobian, q, (6, self.n))


class InPython:
    """The same of a Python source."""

    def __init__(self, arm):
        self.names = {"__name__": "generated"}
        exec(compile(dh.generate(arm, "python", name="arm"), "generated.py", "exec"), self.names)
        assert self.names["_self_check"]() == 0

    def forward(self, q):
        return np.array(self.names["arm_forward"](list(q)))

    def jacobian(self, q):
        return np.array(self.names["arm_jacobian"](list(q)))


def worst(made, arm, trials=100, seed=0, reach=1.0):
    """The largest difference from dhlab and from the oracle; lengths as shares of ``reach``."""
    q = np.random.default_rng(seed).uniform(-np.pi, np.pi, (trials, len(arm)))
    found = 0.0
    for row in q:
        T, J = made.forward(row), made.jacobian(row)
        for right_T, right_J in (
            (arm.forward(row), arm.jacobian(row)),
            whole_pose_and_jacobian(arm, row),
        ):
            dT, dJ = abs(T - right_T), abs(J - right_J)
            dT[:3, 3] /= reach
            dJ[:3] /= reach
            assert np.isfinite([*dT.flat, *dJ.flat]).all()
            found = max(found, dT.max(), dJ.max())
    return found


def random_arm(seed, n, convention, lengths=(0.0, 0.1, -0.25, 0.4)):
    """An arm with signs, offsets, sliding joints, parallel and skew axes, base and tool."""
    rng = np.random.default_rng(seed)
    rows = np.column_stack(
        [
            rng.choice([0, 90, -90, 180, 35.5, -12.25], n),
            rng.choice(lengths, n),
            rng.choice(lengths, n),
            rng.choice([0, 0, 90, -90, 180, 60, 23.25], n),
        ]
    )
    joints = "".join(rng.choice(["R", "R", "P"], n))
    rpy = rng.choice([0, np.pi / 2, np.pi, -np.pi / 4, 0.3], (2, 3))
    base, tool = (from_xyz_rpy(rng.choice(lengths, 3), angles) for angles in rpy)
    table = getattr(dh.DHTable, convention)(rows, angle="deg", joints=joints)
    return dh.Arm(table, base=base, tool=tool, sign=rng.choice([1, -1], n))
