"""Right answers to the functions of lesson 08, each written in another way; none of them uses
dhlab.
"""

import numpy as np
from scipy.spatial.transform import Rotation

# ---- 08.2


def column_by_column(frames, T_end, sliding):
    J = np.zeros((6, len(sliding)))
    for i in range(len(sliding)):
        z, o = frames[i][:3, 2], frames[i][:3, 3]
        J[:, i] = [*z, 0, 0, 0] if sliding[i] else [*np.cross(z, T_end[:3, 3] - o), *z]
    return J


def all_at_once(frames, T_end, sliding):
    z, o = np.asarray(frames)[:-1, :3, 2], np.asarray(frames)[:-1, :3, 3]
    turning = 1.0 - np.asarray(sliding, dtype=float)[:, None]
    return np.concatenate(
        [turning * np.cross(z, T_end[:3, 3] - o) + (1 - turning) * z, turning * z], axis=1
    ).T.tolist()


def by_lines(frames, T_end, sliding):
    """From the axes' Plücker coordinates (direction, moment), carried to the end point."""
    columns = []
    for frame, slides in zip(frames, sliding):
        z, moment = frame[:3, 2], np.cross(frame[:3, 3], frame[:3, 2])
        columns.append(
            np.hstack([z, 0 * z]) if slides else np.hstack([moment + np.cross(z, T_end[:3, 3]), z])
        )
    return np.column_stack(columns)


# ---- 08.4


def by_rotation_vector(T, T_goal):
    return np.hstack(
        [
            T_goal[:3, 3] - T[:3, 3],
            (
                Rotation.from_matrix(T_goal[:3, :3]) * Rotation.from_matrix(T[:3, :3]).inv()
            ).as_rotvec(),
        ]
    )


def by_angle_and_axis(T, T_goal):
    W = T_goal[:3, :3] @ np.linalg.inv(T[:3, :3])
    angle = np.arccos((np.trace(W) - 1) / 2)
    axis = np.array([W[2, 1] - W[1, 2], W[0, 2] - W[2, 0], W[1, 0] - W[0, 1]]) / (2 * np.sin(angle))
    return [*(T_goal - T)[:3, 3], *(angle * axis)]


def by_the_tool(T, T_goal):
    """The turn as the tool sees it, carried back to the base."""
    R = T[:3, :3]
    return np.concatenate(
        [T_goal[:3, 3] - T[:3, 3], R @ Rotation.from_matrix(R.T @ T_goal[:3, :3]).as_rotvec()]
    )


# ---- 08.6


def link(theta, d, a, alpha):
    c, s, u, v = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    return np.array(
        [[c, -s * u, s * v, a * c], [s, c * u, -c * v, a * s], [0, v, u, d], [0, 0, 0, 1]]
    )


def frames_of(rows, q):
    frames = [np.eye(4)]
    for (offset, d, a, alpha), x in zip(rows, q):
        frames.append(frames[-1] @ link(offset + x, d, a, alpha))
    return frames


def _stepping(step):
    def solve(rows, T_goal, q, damping, steps):
        for _ in range(steps):
            frames = frames_of(rows, q)
            q = q + step(
                column_by_column(frames, frames[-1], [False] * len(q)),
                by_rotation_vector(frames[-1], T_goal),
                damping,
            )
        return q

    return solve


def _by_singular_values(J, e, damping):
    U, s, V = np.linalg.svd(J)
    return V.T @ (s / (s**2 + damping**2) * (U.T @ e))


def _by_least_squares(J, e, damping):
    """The bargain itself, |J x − e|² + λ² |x|², as one stacked system."""
    return np.linalg.lstsq(
        np.vstack([J, damping * np.eye(6)]), np.hstack([e, np.zeros(6)]), rcond=None
    )[0]


as_in_the_lesson = _stepping(
    lambda J, e, damping: J.T @ np.linalg.inv(J @ J.T + damping**2 * np.eye(6)) @ e
)
other_side = _stepping(
    lambda J, e, damping: np.linalg.solve(J.T @ J + damping**2 * np.eye(6), J.T @ e)
)
by_singular_values, by_least_squares = _stepping(_by_singular_values), _stepping(_by_least_squares)


def whole_turns_taken_off(*task):
    return ((other_side(*task) + np.pi) % (2 * np.pi) - np.pi).tolist()


# ---- 08.8

ROWS = np.array(
    [
        [0, 0.1, 0, np.pi / 2],
        [0, 0, 0.4, 0],
        [0, 0, 0.35, 0],
        [0, 0.1, 0, np.pi / 2],
        [0, 0, 0, -np.pi / 2],
        [0, 0.1, 0, 0],
    ]
)


def _triples(T):
    """θ1 from the line's equation as complex numbers, θ2 and θ3 from a2 e^{iθ2} + a3 e^{i(θ2 + θ3)}
    = out + i up.
    """
    x, y, z = T[:3, 3] - 0.1 * T[:3, 2]
    far = np.sqrt(x * x + y * y - 0.01)
    for out in (far, -far):
        theta_1 = np.angle((x + 1j * y) / (out - 0.1j))
        goal = out + 1j * (z - 0.1)
        for side in (1, -1):
            inner = side * np.arccos((0.4**2 + abs(goal) ** 2 - 0.35**2) / (0.8 * abs(goal)))
            theta_2 = np.angle(goal) + inner
            theta_3 = np.angle((goal - 0.4 * np.exp(1j * theta_2)) * np.exp(-1j * theta_2))
            yield theta_1, theta_2, theta_3


def _left(T, triple):
    return frames_of(ROWS, [*triple, 0, 0, 0])[3][:3, :3].T @ T[:3, :3]


def by_euler_angles(T):
    answers = []
    for triple in _triples(T):
        theta_4, minus_5, theta_6 = Rotation.from_matrix(_left(T, triple)).as_euler("ZYZ")
        answers += [
            (*triple, theta_4, -minus_5, theta_6),
            (*triple, theta_4 + np.pi, minus_5, theta_6 - np.pi),
        ]
    return answers


def by_both_signs_of_the_sine(T):
    answers = []
    for triple in _triples(T):
        R = _left(T, triple)
        for s in (1, -1):
            theta_5 = np.arctan2(s * np.hypot(R[0, 2], R[1, 2]), R[2, 2])
            answers.append(
                [
                    *triple,
                    np.arctan2(-s * R[1, 2], -s * R[0, 2]),
                    theta_5,
                    np.arctan2(-s * R[2, 1], s * R[2, 0]),
                ]
            )
    return np.array(answers)[::-1]


def with_whole_turns(T):
    return np.array(by_both_signs_of_the_sine(T))[[3, 1, 0, 2, 7, 6, 4, 5]] + 2 * np.pi * np.array(
        [1, 0, -1, 0, 2, 0]
    )


RIGHT_WAYS = {
    "08.2": [column_by_column, all_at_once, by_lines],
    "08.11": [column_by_column, all_at_once, by_lines],
    "08.4": [by_rotation_vector, by_angle_and_axis, by_the_tool],
    "08.6": [
        as_in_the_lesson,
        other_side,
        by_singular_values,
        by_least_squares,
        whole_turns_taken_off,
    ],
    "08.8": [by_euler_angles, by_both_signs_of_the_sine, with_whole_turns],
}
