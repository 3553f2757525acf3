"""One library that ``kinematics.py`` measures, in a process and an environment of its own.

It is told its name and a file with the arm, answers one question a line on its standard input
(``{"question": "forward", "poses": 1000}``) with a line of JSON, and rests between them, so that
the libraries are measured in turns. Except for dhlab it needs numpy and the library alone.
"""

import json
import os
import sys
import time

import numpy as np

ROUND = 0.02  # seconds that a measurement lasts at least


class UsualNumpy:
    """What is usually written: a stack of 4×4 matrices per joint, multiplied with @."""

    def __init__(self, rows):
        self.rows = rows

    def links(self, q):
        for i, (theta, d, a, alpha) in enumerate(self.rows):
            angle = q[..., i] + theta
            c, s, ca, sa = np.cos(angle), np.sin(angle), np.cos(alpha), np.sin(alpha)
            A = np.zeros((*angle.shape, 4, 4))
            A[..., 0, 0], A[..., 0, 1], A[..., 0, 2], A[..., 0, 3] = c, -s * ca, s * sa, a * c
            A[..., 1, 0], A[..., 1, 1], A[..., 1, 2], A[..., 1, 3] = s, c * ca, -c * sa, a * s
            A[..., 2, 1], A[..., 2, 2], A[..., 2, 3], A[..., 3, 3] = sa, ca, d, 1.0
            yield A

    def forward(self, q):
        T = np.eye(4)
        for A in self.links(q):
            T = T @ A
        return T

    def frames(self, q):
        chain = [np.broadcast_to(np.eye(4), (*q.shape[:-1], 4, 4))]
        for A in self.links(q):
            chain.append(chain[-1] @ A)
        return np.stack(chain, axis=-3)

    def jacobian(self, q):
        chain = self.frames(q)
        z, p = chain[..., :-1, :3, 2], chain[..., :-1, :3, 3]
        v = np.cross(z, chain[..., -1:, :3, 3] - p)
        return np.swapaxes(np.concatenate([v, z], axis=-1), -1, -2)

    def writing(self, q, shape):
        """The limit: to write a result of this size to memory that was never touched."""
        np.empty((*q.shape[:-1], *shape)).fill(1.0)


class Dhlab:
    """Through the public methods, with all checks of what is given."""

    def __init__(self, rows):
        import dhlab as dh

        self.arm = dh.Arm(dh.DHTable.standard(rows, angle="rad"))
        self.forward, self.frames, self.jacobian = (
            self.arm.forward, self.arm.frames, self.arm.jacobian,
        )  # fmt: skip


class RoboticsToolbox:
    """Its chain of elementary transforms in C; for Jacobians it has no batch."""

    def __init__(self, rows):
        import roboticstoolbox as rtb

        links = [rtb.RevoluteDH(d=d, a=a, alpha=alpha, offset=t) for t, d, a, alpha in rows]
        self.ets = rtb.DHRobot(links).ets()

    def forward(self, q):
        return self.ets.eval(q)

    def jacobian(self, q):
        return self.ets.jacob0(q) if q.ndim == 1 else np.array([self.ets.jacob0(row) for row in q])


class OneByOne:
    """A library that takes one configuration a call. Its answers are kept in its own form."""

    def forward(self, q):
        return self.pose(q) if q.ndim == 1 else [self.pose(row) for row in q]

    def frames(self, q):
        return self.chain(q) if q.ndim == 1 else [self.chain(row) for row in q]

    def jacobian(self, q):
        return self.columns(q) if q.ndim == 1 else [self.columns(row) for row in q]


class Pinocchio(OneByOne):
    """A tree of joints about z, fixed placements between."""

    def __init__(self, rows):
        import pinocchio as pin

        self.pin, self.model, parent, placement = pin, pin.Model(), 0, np.eye(4)
        for i, (theta, d, a, alpha) in enumerate(rows):
            placed = pin.SE3(placement @ _turn_z(theta))
            parent = self.model.addJoint(parent, pin.JointModelRZ(), placed, f"joint {i}")
            placement = _link_behind(d, a, alpha)
        self.behind = [_link_behind(d, a, alpha) for _, d, a, alpha in rows]
        place = pin.SE3(placement)
        kind = pin.FrameType.OP_FRAME
        self.end = self.model.addFrame(pin.Frame("end", parent, place, kind))
        self.ids = [
            self.model.addFrame(pin.Frame(f"frame {i}", i + 1, pin.SE3(T), kind))
            for i, T in enumerate(self.behind)
        ]
        self.data = self.model.createData()

    def pose(self, q):
        self.pin.forwardKinematics(self.model, self.data, q)
        return self.pin.updateFramePlacement(self.model, self.data, self.end).homogeneous

    def chain(self, q):
        self.pin.framesForwardKinematics(self.model, self.data, q)
        return [self.data.oMf[k].homogeneous for k in self.ids]

    def columns(self, q):
        world = self.pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
        return self.pin.computeFrameJacobian(self.model, self.data, q, self.end, world)


class Mujoco(OneByOne):
    """Bodies in a chain; its frames are read where it leaves them, as positions and matrices."""

    def __init__(self, rows):
        import mujoco

        self.mujoco = mujoco
        inertia = '<inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>'
        opened, place = "", np.eye(4)
        for i, (theta, d, a, alpha) in enumerate(rows):
            opened += f'<body {_placed(place @ _turn_z(theta))}>{inertia}<joint axis="0 0 1"/>'
            opened += f'<site name="s{i}" {_placed(_link_behind(d, a, alpha))}/>'
            place = _link_behind(d, a, alpha)
        xml = (
            '<mujoco><compiler angle="radian"/><worldbody>'
            + opened + "</body>" * len(rows) + "</worldbody></mujoco>"
        )  # fmt: skip
        self.model = mujoco.MjModel.from_xml_string(xml)
        self.data = mujoco.MjData(self.model)
        self.last = len(rows) - 1
        self.v, self.omega = np.zeros((3, len(rows))), np.zeros((3, len(rows)))

    def pose(self, q):
        self.data.qpos[:] = q
        self.mujoco.mj_kinematics(self.model, self.data)
        return self.data.site_xpos[self.last].copy(), self.data.site_xmat[self.last].copy()

    def chain(self, q):
        self.data.qpos[:] = q
        self.mujoco.mj_kinematics(self.model, self.data)
        return self.data.site_xpos.copy(), self.data.site_xmat.copy()

    def columns(self, q):
        self.data.qpos[:] = q
        self.mujoco.mj_kinematics(self.model, self.data)
        self.mujoco.mj_comPos(self.model, self.data)
        self.mujoco.mj_jacSite(self.model, self.data, self.v, self.omega, self.last)
        return self.v.copy(), self.omega.copy()


class Jax:
    """The usual product, compiled by XLA for one pose and for a batch."""

    def __init__(self, rows):
        import jax

        jax.config.update("jax_enable_x64", True)
        self.jax, jnp = jax, jax.numpy

        def links(q):
            for i, (theta, d, a, alpha) in enumerate(rows):
                c, s = jnp.cos(q[i] + theta), jnp.sin(q[i] + theta)
                ca, sa = np.cos(alpha), np.sin(alpha)
                yield jnp.array(
                    [[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s],
                     [0, sa, ca, d], [0, 0, 0, 1.0]]
                )  # fmt: skip

        def frames(q):
            chain = [jnp.eye(4)]
            for A in links(q):
                chain.append(chain[-1] @ A)
            return jnp.stack(chain)

        def forward(q):
            T = jnp.eye(4)
            for A in links(q):
                T = T @ A
            return T

        def jacobian(q):
            chain = frames(q)
            z, p = chain[:-1, :3, 2], chain[:-1, :3, 3]
            return jnp.concatenate([jnp.cross(z, chain[-1, :3, 3] - p), z], axis=1).T

        for f in (forward, frames, jacobian):
            one, many = jax.jit(f), jax.jit(jax.vmap(f))
            setattr(self, f.__name__, lambda q, one=one, many=many: self._ready(one, many, q))

    def _ready(self, one, many, q):
        return (one if q.ndim == 1 else many)(q).block_until_ready()


def _turn_z(theta):
    T = np.eye(4)
    T[:2, :2] = [[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]]
    return T


def _link_behind(d, a, alpha):
    """Tz(d) Tx(a) Rx(alpha), free of the dust of cos(90°), which MuJoCo's reader would keep."""
    c, s = np.cos(alpha), np.sin(alpha)
    return np.array([[1, 0, 0, a], [0, c, -s, 0], [0, s, c, d], [0, 0, 0, 1.0]])


def _placed(T):
    axes = " ".join(repr(float(x)) for x in [*T[:3, 0], *T[:3, 1]])
    place = " ".join(repr(float(x)) for x in T[:3, 3])
    return f'pos="{place}" xyaxes="{axes}"'


LIBRARIES = {
    "usual numpy": UsualNumpy,
    "dhlab, numpy": Dhlab,
    "dhlab, numba, one core": Dhlab,
    "dhlab, numba": Dhlab,
    "Robotics Toolbox": RoboticsToolbox,
    "pinocchio": Pinocchio,
    "MuJoCo": Mujoco,
    "JAX": Jax,
}


def as_matrices(question, answers):
    """Answers to some q as dhlab gives them: matrices from positions and rotations or from columns,
    the base before the frames.
    """
    if isinstance(answers, list) and isinstance(answers[0], tuple):
        first, second = (np.array(parts) for parts in zip(*answers))
        if question == "jacobian":
            return np.concatenate([first, second], axis=1)
        T = np.zeros((*first.shape[:-1], 4, 4))
        T[..., :3, 3], T[..., :3, :3] = first, second.reshape(*first.shape[:-1], 3, 3)
        T[..., 3, 3] = 1.0
        answers = T
    found = np.asarray(answers)
    if question == "frames":
        base = np.broadcast_to(np.eye(4), (len(found), 1, 4, 4))
        return np.concatenate([base, found], axis=1)
    return found


def measured(f, *given):
    """Seconds of one call, the mean of as many as last a while."""
    began, calls = time.perf_counter(), 0
    while True:
        for _ in range(1 + calls):
            f(*given)
        calls += 1 + calls
        if (took := time.perf_counter() - began) > ROUND:
            return took / calls


def answered(library, arm, question, poses, check=False, rest=()):
    """Seconds a pose; to ``check``, how far the answers are from the right ones; None where the
    library has no answer, or would take minutes.
    """
    f = getattr(library, question, None)
    if f is None or (poses > 1_000_000 and isinstance(library, OneByOne)):
        return None
    if check:
        answers = f(arm["q"])
        whole = not isinstance(library, OneByOne)
        found = np.asarray(answers) if whole else as_matrices(question, answers)
        return float(np.abs(found - arm[question]).max())
    q = np.random.default_rng(1).uniform(-3, 3, (poses, arm["rows"].shape[0]))
    q = q[0] if poses == 1 else q
    f(q, *rest)  # what is compiled on the first call is compiled now
    return measured(f, q, *rest) / poses


def main():
    name, file = sys.argv[1:]
    if name == "dhlab, numba, one core":
        os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
    arm = dict(np.load(file))
    library = LIBRARIES[name](arm["rows"])
    for line in sys.stdin:
        print(json.dumps(answered(library, arm, **json.loads(line))), flush=True)


if __name__ == "__main__":
    main()
