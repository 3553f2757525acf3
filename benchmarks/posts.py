"""The 35 posts of posts.yaml, and the 32 of posts_more.yaml, each played as its poster would: what
he types, and whether the sentence that was promised comes back.

    python benchmarks/posts.py            # a line each: solved, in part, not, misleading
    python benchmarks/posts.py --more     # the further ones
    python benchmarks/posts.py NAME …     # those, with what was printed

The expectations were written down before the work (posts.yaml); the plays, with the facts that the
answers must hold, are in posts_plays.yaml. Solved: every fact came back. Misleading: a fact did
that must never come. The plays were written by the same hands as the doctor.
"""

import os
import re
import shlex
import sys
import tempfile
from pathlib import Path

import numpy as np
from ruamel.yaml import YAML
from typer.testing import CliRunner

import dhlab as dh
from dhlab.cli.app import app

HERE = Path(__file__).parent
DOCS = HERE.parent / "docs"


def typed(line):
    """What the command prints, errors included, with its white space made single."""
    answer = CliRunner().invoke(app, shlex.split(line)[1:])
    error = "" if answer.exception is None else f" dhlab: {answer.exception}"
    return " ".join((answer.output + error).split())


def missing(text, says):
    return [fact for fact in says if not re.search(fact, text)]


def found(text, never):
    return [fact for fact in never if re.search(fact, text)]


def same_in_pinocchio(table, urdf):
    """Whether another library, given the URDF, moves the end as the table does."""
    import pinocchio

    model = pinocchio.buildModelFromUrdf(urdf)
    arm, data, joints = dh.load(table), model.createData(), list(model.joints)[1:]
    q = np.random.default_rng(1).uniform(-2, 2, (20, len(arm)))
    for one in q:
        turns = [[x] if joint.nq == 1 else [np.cos(x), np.sin(x)] for joint, x in zip(joints, one)]
        pinocchio.framesForwardKinematics(model, data, np.concatenate(turns))
        if not np.allclose(data.oMf[model.nframes - 1].homogeneous, arm.forward(one), atol=1e-9):
            return False
    return True


def measured(file, arm, count, seed, units, calibrated=(0, 0), coupling=()):
    """Write poses of an arm, as the post says that they were: its numbers a little off (m, rad), or
    its joints coupled ({joint: {by: factor}}).
    """
    from dataclasses import replace

    arm, rng = dh.load(arm), np.random.default_rng(seed)
    far, turned = calibrated
    rows = arm.table.rows + rng.normal(0, 1, (len(arm), 4)) * [turned, far, far, turned]
    make = dh.DHTable.standard if arm.table.convention == "standard" else dh.DHTable.craig
    joints = np.eye(len(arm))
    for joint, others in dict(coupling).items():
        for other, factor in others.items():
            joints[joint - 1, other - 1] = factor
    q = rng.uniform(-1.5, 1.5, (count, len(arm)))
    p = replace(arm, table=make(rows, angle="rad")).forward(q @ joints.T)[:, :3, 3]
    shown = np.rad2deg(q) if units.endswith("deg") else q
    head = ",".join([f"q{i + 1}" for i in range(len(arm))] + ["x", "y", "z"])
    lines = [",".join(f"{x:.6f}" for x in row) for row in np.hstack([shown, p])]
    Path(file).write_text("\n".join([head, *lines]), encoding="utf-8")


def play(scene, shown=False):
    """(facts in all, facts missing, facts that must never come) of one post."""
    facts, absent, wrong = 0, [], []
    for name, text in scene.get("files", {}).items():
        Path(name).write_text(text, encoding="utf-8")
    if "poses" in scene:
        measured(**scene["poses"])
    for line in scene.get("prepare", ()):
        typed(line)
    for step in scene.get("run", ()):
        answer = typed(step["types"])
        if shown:
            print(f"$ {step['types']}\n{answer}\n")
        facts += len(step["says"])
        absent += missing(answer, step["says"])
        wrong += found(answer, step.get("never", ()))
    if "page" in scene:
        text = " ".join((DOCS / scene["page"]["name"]).read_text(encoding="utf-8").split())
        facts += len(scene["page"]["says"])
        absent += missing(text, scene["page"]["says"])
    if "pinocchio" in scene:
        facts += 1
        absent += [] if same_in_pinocchio(*scene["pinocchio"]) else ["the same in pinocchio"]
    return facts, absent, wrong


def verdict(facts, absent, wrong):
    if wrong:
        return "misleading"
    if not absent:
        return "solved"
    return "not" if len(absent) == facts else "in part"


def main(names):
    more = "_more" if "--more" in names else ""
    names = [name for name in names if name != "--more"]
    expected = YAML(typ="safe").load(HERE / f"posts{more}.yaml")
    plays = YAML(typ="safe").load(HERE / f"posts{more}_plays.yaml")
    tally = dict.fromkeys(("solved", "in part", "not", "misleading"), 0)
    home = Path.cwd()
    for item in expected:
        name = item["post"]
        if names and name not in names:
            continue
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            facts, absent, wrong = play(plays[name], bool(names))
            os.chdir(home)
        said = verdict(facts, absent, wrong)
        tally[said] += 1
        note = f"; not said: {absent}" if absent else ""
        note += f"; said, and must not be: {wrong}" if wrong else ""
        print(f"{said:10} {name}: {facts - len(absent)} of {facts} facts{note}", flush=True)
    print(", ".join(f"{count} {said}" for said, count in tally.items()))


if __name__ == "__main__":
    main(sys.argv[1:])
