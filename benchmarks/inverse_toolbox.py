"""Robotics Toolbox's inverse kinematics on the library's standard tables."""

import time

import numpy as np
import roboticstoolbox as rtb

import dhlab as dh

ARMS = ["puma560", "irb120", "article-6r", "ur5e", "jaco6", "stanford"]


def toolbox_arm(arm):
    """The same arm there; signs are left out, so that its q is ours times the sign."""
    links = [
        rtb.PrismaticDH(theta=theta, a=a, alpha=alpha, offset=d)
        if letter == "P"
        else rtb.RevoluteDH(d=d, a=a, alpha=alpha, offset=theta)
        for (theta, d, a, alpha), letter in zip(arm.table.rows, arm.table.joints, strict=True)
    ]
    robot = rtb.DHRobot(links)
    robot.qlim = np.tile([[-2 * np.pi], [2 * np.pi]], len(arm))
    return robot


def compared(count, random_q, distance, met):
    """Headings and rows: for each arm and way, how often q is among the solutions, and the time."""
    rows = []
    for name in ARMS:
        arm = dh.load(name)
        bare = dh.Arm(arm.table, limits=arm.limits if arm.table.prismatic.any() else None)
        ways = {
            "dhlab": lambda T, bare=bare: bare.solve(T).q,
            "dhlab, by search": lambda T, bare=bare: bare.solve(T, method="search").q,
            **_toolbox_ways(bare),
        }
        counts = {way: [] for way in ways}
        found, seconds, worst = (
            dict.fromkeys(ways, 0),
            {way: [] for way in ways},
            dict.fromkeys(ways, 0.0),
        )
        for q in random_q(bare, np.random.default_rng(7), count):
            T = bare.forward(q)
            for way, solve in ways.items():
                start = time.perf_counter()
                answer = np.reshape(solve(T), (-1, len(bare)))
                seconds[way].append(time.perf_counter() - start)
                counts[way].append(len(answer))
                found[way] += distance(bare, q, answer) < met
                if len(answer):
                    worst[way] = max(worst[way], np.abs(bare.forward(answer) - T).max())
        rows += [
            [
                name,
                way,
                f"{sum(c > 0 for c in counts[way])} of {count}",
                f"{found[way]} of {count}",
                f"{np.mean(counts[way]):.2f}",
                f"{worst[way]:.1e}",
                f"{1e3 * np.median(seconds[way]):.2f}",
            ]
            for way in ways
        ]
    return ["arm", "by", "solved", "q found", "solutions", "worst entry of the pose", "ms"], rows


def _toolbox_ways(arm):
    robot = toolbox_arm(arm)
    ways = {
        "toolbox, ik_LM (C)": lambda T: _one(robot.ets().ik_LM(T)),
        "toolbox, ikine_LM": lambda T: _one(robot.ikine_LM(T)),
    }
    try:
        solver = robot.analytic_ik()
    except (AttributeError, ImportError, NotImplementedError, ValueError) as refusal:
        print(f"Robotics Toolbox has no analytic solution for {arm.table.joints}: {refusal}\n")
        return ways
    solver.solve(arm.forward(np.full(len(arm), 0.3)), joint_limits=False)
    return {"toolbox, analytic": lambda T: solver.solve(T, joint_limits=False).q, **ways}


def _one(answer):
    return answer.q if answer.success else []
