"""``dhlab doctor`` as a user types it."""

import json
from pathlib import Path

import numpy as np
import pytest
from terminal import dhlab

import dhlab as dh
from dhlab.cli.measured import noise_of
from dhlab.transform import from_xyz_rpy, rot_z, trans


def doctor(*arguments):
    return dhlab("doctor", *arguments)


def general(n, m=8, seed=3):
    return np.random.default_rng(seed).uniform(-2.4, 2.4, (m, n))


def write_positions(path, q, p, length=1.0, angle=1.0):
    rows = np.column_stack([q / angle, p / length])
    units = f"# units: {'m' if length == 1 else 'mm'},{'rad' if angle == 1 else 'deg'}"
    header = ",".join([f"q{i + 1}" for i in range(q.shape[1])] + ["x", "y", "z"])
    path.write_text(
        "\n".join([units, header, *(",".join(repr(float(v)) for v in row) for row in rows)]) + "\n"
    )
    return str(path)


@pytest.fixture
def wrong(tmp_path):
    """The article's arm with the sign of alpha 4 turned, as a table file."""
    rows = dh.load("article-6r").table.rows
    rows[3, 3] *= -1
    dh.Arm(dh.DHTable.standard(rows, angle="rad"), name="wrong").save(tmp_path / "wrong.yaml")
    return str(tmp_path / "wrong.yaml")


@pytest.fixture
def positions(tmp_path):
    q = general(6)
    return write_positions(tmp_path / "poses.csv", q, dh.load("article-6r").forward(q)[:, :3, 3])


@pytest.mark.slow
def test_a_wrong_sign_is_found_and_the_joint_named(wrong, positions, tmp_path):
    answer = doctor(wrong, positions, "--repair", str(tmp_path / "right.yaml"))
    assert answer.returncode == 0 and answer.stdout.startswith(
        "One mistake explains the measurements."
    )
    assert "alpha has the wrong sign (row 4, alpha)" in answer.stdout and "Off by" in answer.stdout
    q = general(6, seed=8)
    assert np.allclose(
        dh.load(str(tmp_path / "right.yaml")).forward(q)[:, :3, 3],
        dh.load("article-6r").forward(q)[:, :3, 3],
        atol=1e-6,
    )
    again = doctor(wrong, positions, "--repair", str(tmp_path / "right.yaml"))
    assert again.returncode == 2 and "found one that exists" in again.stderr and again.stdout == ""


@pytest.mark.slow
def test_json_for_a_program(wrong, positions):
    answer = json.loads(doctor(wrong, positions, "--json").stdout)
    assert {
        "verdict",
        "headline",
        "findings",
        "before",
        "after",
        "notes",
        "next_pose",
    } <= answer.keys()
    first = answer["findings"][0]
    assert (
        answer["verdict"] == "explained"
        and first["mistake"] == "alpha-sign"
        and first["joint"] == 4
        and len(first["repair"]["rows"]) == 6
    )
    assert (
        answer["before"]["mm"] > 1
        and answer["after"]["mm"] < 1e-3
        and answer["before"]["deg"] is None
    )


@pytest.mark.slow
def test_millimetres_degrees_and_stated_noise(wrong, tmp_path):
    q = general(6, 12)
    p = dh.load("article-6r").forward(q)[:, :3, 3] + np.random.default_rng(1).normal(
        0, 1e-3, (12, 3)
    )
    path = write_positions(tmp_path / "mm.csv", q, p, 1e-3, np.pi / 180)
    for noise in ("1mm,0.2deg", "0.001m,0.003rad", "1 mm"):
        answer = json.loads(
            doctor(wrong, path, "--units", "mm,deg", "--noise", noise, "--json").stdout
        )
        assert answer["verdict"] == "explained" and answer["findings"][0]["mistake"] == "alpha-sign"
    right = doctor("article-6r", path, "--units", "deg,mm", "--noise", "1mm")
    assert right.returncode == 0 and "agrees" in right.stdout


@pytest.mark.slow
def test_another_base_frame(wrong, tmp_path):
    q = general(6, 12)
    moved = trans([0.3, -0.2, 0.5]) @ rot_z(0.7)
    path = write_positions(
        tmp_path / "moved.csv", q, (moved @ dh.load("article-6r").forward(q))[:, :3, 3]
    )
    answer = json.loads(doctor(wrong, path, "--free-base", "--json").stdout)
    assert answer["verdict"] == "explained" and answer["findings"][0]["mistake"] == "alpha-sign"


def test_nothing_to_repair_is_said(positions, tmp_path):
    answer = doctor("article-6r", positions, "--repair", str(tmp_path / "none.yaml"))
    assert (
        answer.returncode == 0
        and "was not written" in answer.stderr
        and not (tmp_path / "none.yaml").exists()
    )


@pytest.mark.parametrize(
    "arguments, words",
    [
        (["article-6r"], "--protocol"),
        (["article-6r", "no-such.csv"], "no such file"),
        (["no-such-arm", "x.csv", "--units", "mm,deg"], "no-such-arm"),
        (["article-6r", "x.csv", "--units", "cm,deg"], "--units"),
        (["article-6r", "x.csv", "--units", "mm"], "--units"),
        (["article-6r", "x.csv", "--noise", "1cm"], "--noise"),
        (["article-6r", "x.csv", "--protocol"], "--protocol"),
        (["article-6r", "x.csv", "--sheet", "s.csv"], "--sheet"),
        (["article-6r", "x.csv", "--repair", "arm.csv"], ".yaml"),
        (["article-6r", "x.csv", "--motion", "--free-base"], "--motion"),
    ],
)
def test_errors_are_one_sentence_and_status_2(arguments, words):
    answer = doctor(*arguments)
    assert (
        answer.returncode == 2
        and words in answer.stderr
        and answer.stderr.count("\n") == 1
        and "Traceback" not in answer.stderr
    )
    assert answer.stdout == ""


@pytest.mark.parametrize(
    "text, value",
    [
        ("1mm,0.2deg", (1e-3, np.deg2rad(0.2))),
        ("0.001m,0.003rad", (1e-3, 3e-3)),
        ("4 mm", (4e-3,)),
        ("1e-3m , .1°", (1e-3, np.deg2rad(0.1))),
    ],
)
def test_noise_as_people_write_it(text, value):
    assert np.allclose(noise_of(text), value) and noise_of(" ") is None


@pytest.mark.parametrize(
    "text",
    [
        "-1mm",
        "0",
        "4",
        "0.001,0.003",
        "1mm,0.2",
        "1mm,2,3",
        "1mm,0.2mm",
        "0.2deg",
        "a lot",
        "nan",
        "1e999",
        "1,",
        ",",
    ],
)
def test_noise_that_says_nothing_is_refused(text):
    with pytest.raises(ValueError, match="--noise"):
        noise_of(text)


def test_wrong_columns(tmp_path):
    path = write_positions(tmp_path / "seven.csv", general(7), np.ones((8, 3)))
    answer = doctor("article-6r", path)
    assert answer.returncode == 2 and "q7" in answer.stderr and answer.stderr.count("\n") == 1
    (tmp_path / "empty.csv").write_text(
        "# units: mm, deg\nq1,q2,q3,q4,q5,q6,x,y,z\n1,2,3,4,5,6,,,\n"
    )
    answer = doctor("article-6r", str(tmp_path / "empty.csv"))
    assert answer.returncode == 2 and "empty cell" in answer.stderr


def test_units_are_never_guessed(positions, tmp_path):
    """Without units nothing is read: millimetres taken for metres would be a wrong diagnosis."""
    bare = tmp_path / "bare.csv"
    bare.write_text(
        "".join(
            line
            for line in Path(positions).read_text().splitlines(keepends=True)
            if not line.startswith("#")
        )
    )
    answer = doctor("article-6r", str(bare))
    assert (
        answer.returncode == 2
        and "--units mm,deg" in answer.stderr
        and answer.stderr.count("\n") == 1
    )
    assert (
        "agrees"
        in doctor("article-6r", str(bare), "--units", "m,rad").stdout
        == doctor("article-6r", positions).stdout
    )


def test_the_protocols_own_sheet_says_its_units(tmp_path):
    doctor("article-6r", "--protocol", "--sheet", str(tmp_path / "sheet.csv"))
    comment, header, *lines = (tmp_path / "sheet.csv").read_text().splitlines()
    arm = dh.load("article-6r")
    filled = [
        line[:-3]
        + ","
        + ",".join(
            f"{1000 * x:.2f}"
            for x in arm.forward(np.deg2rad([float(v) for v in line.split(",")[:6]]))[:3, 3]
        )
        for line in lines
    ]
    (tmp_path / "filled.csv").write_text("\n".join([comment, header, *filled]) + "\n")
    assert "agrees" in doctor("article-6r", str(tmp_path / "filled.csv"), "--noise", "4mm").stdout


def test_a_found_base_is_told_and_written(tmp_path):
    q, moved = general(6, 12), from_xyz_rpy([0.35, -0.12, 0.74], np.deg2rad([0, 0, 30]))
    path = write_positions(
        tmp_path / "moved.csv", q, (moved @ dh.load("article-6r").forward(q))[:, :3, 3]
    )
    answer = doctor("article-6r", path, "--free-base", "--repair", str(tmp_path / "placed.yaml"))
    assert "The base was found at xyz (350, -120, 740) mm, rpy (0, 0, 30)°." in " ".join(
        answer.stdout.split()
    )
    assert np.allclose(dh.load(str(tmp_path / "placed.yaml")).base, moved, atol=1e-6)


def test_of_a_long_log_some_poses_are_used(tmp_path):
    arm, q = dh.load("article-6r"), general(6, 4500).round(4)
    log = write_positions(tmp_path / "log.csv", q, arm.forward(q)[:, :3, 3])
    done = doctor("article-6r", log)
    assert "agrees" in done.stdout and "Of 4500 poses one in 9 was used" in done.stdout
