"""Axis sheets, and an arm against a URDF, from a terminal."""

import json

import numpy as np
from terminal import dhlab

import dhlab as dh

SHEET = """name: two axes
units: {length: mm, angle: deg}
axes:
  - {point: [0, 0, 0], direction: [0, 0, 1]}
  - {point: [%s, 0, 100], direction: [0, 1, 0]}
  - {type: prismatic, point: [400, 0, 100], direction: [1, 0, 0]}
end: {xyz: [700, 0, 100], rpy: [0, 90, 0]}
limits: [[-180, 180], [-90, 90], [0, 200]]
"""


def written(folder, x=400):
    path = folder / f"sheet{x}.yaml"
    path.write_text(SHEET % x)
    return path


def test_a_sheet_is_an_arm_and_says_how_its_frames_were_placed(tmp_path):
    path = written(tmp_path)
    done = dhlab("from-axes", path, "--steps", "--out", tmp_path / "table.yaml")
    assert done.returncode == 0 and "z1" in done.stdout and "1. " in done.stdout
    arm, again = dh.load(tmp_path / "table.yaml"), dh.load(path)
    np.testing.assert_allclose(arm.forward([0, 0, 0])[:3, 3], [0.7, 0, 0.1], atol=1e-12)
    q = [0.3, -0.4, 0.1]  # by hand: out along the turned and tilted x axis from the second joint
    out = np.array([np.cos(0.4), 0, np.sin(0.4)]) * 0.4 + [0.4, 0, 0]
    turned = [np.cos(0.3) * out[0], np.sin(0.3) * out[0], 0.1 + out[2]]
    np.testing.assert_allclose(arm.forward(q)[:3, 3], turned, atol=1e-12)
    assert dh.equivalent(arm, again) and again.limits == arm.limits


def test_the_doctor_names_the_axis_and_writes_the_sheet_again(tmp_path):
    right = dh.read_axes(written(tmp_path)).arm()
    q = np.random.default_rng(3).uniform([-2, -1.5, 0], [2, 1.5, 0.2], (6, 3))
    lines = ["# units: m,rad", "q1,q2,q3,x,y,z"]
    lines += [",".join(map(repr, map(float, [*v, *T[:3, 3]]))) for v, T in zip(q, right.forward(q))]
    (tmp_path / "poses.csv").write_text("\n".join(lines))
    fixed = tmp_path / "fixed.yaml"
    done = dhlab("doctor", written(tmp_path, 410), tmp_path / "poses.csv", "--repair", fixed)
    assert "axis 2): lies 10 mm away along -x: the point's x is 400 mm, not 410 mm" in " ".join(
        done.stdout.split()
    )
    assert dh.equivalent(dh.load(fixed), right)


def test_a_table_is_held_against_a_urdf(tmp_path):
    arm = dh.load("article-6r")
    dh.to_urdf(arm, tmp_path / "right.urdf")
    rows = arm.table.rows
    rows[3, 3] *= -1
    dh.DHTable.standard(rows, angle="rad").save(tmp_path / "mine.yaml")
    done = dhlab("doctor", tmp_path / "mine.yaml", tmp_path / "right.urdf", "--json")
    answer = json.loads(done.stdout)
    finding = answer["diagnosis"]["findings"][0]
    assert (finding["mistake"], finding["joint"]) == ("alpha-sign", 4)
    assert answer["comparison"]["kind"] != "same"
    assert dhlab("doctor", "article-6r", tmp_path / "right.urdf").stdout.startswith(
        "The table agrees with the poses of"
    )
    done = dhlab("doctor", "article-6r", tmp_path / "right.urdf", "--noise", "1mm,0.1deg")
    assert done.returncode == 2 and "it is an arm, whose poses are computed" in done.stderr
    done = dhlab("doctor", "panda", tmp_path / "right.urdf")
    assert done.returncode == 2 and "expected two arms with the same joints" in done.stderr
