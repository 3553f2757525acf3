"""The command line as a user types it."""

import json
import os
import subprocess
import sys

import numpy as np
import pytest
from terminal import dhlab

import dhlab as library


def test_fk_gives_the_articles_numbers():
    zero = dhlab("fk", "article-6r")
    assert zero.returncode == 0 and "0.75  -0.2  0.1\n" in zero.stdout and "90  0  0" in zero.stdout
    quarter = json.loads(dhlab("fk", "article-6r", "--q", "90,0,0,0,0,0", "--deg", "--json").stdout)
    assert np.allclose(np.array(quarter["pose"])[:3, 3], [0.2, 0.75, 0.1]) and np.allclose(
        quarter["q"], [np.pi / 2, 0, 0, 0, 0, 0]
    )


def test_fk_with_frames_and_negative_first_values():
    answer = json.loads(
        dhlab("fk", "ur5e", "--q", "-10, 20,-90,90,0,0", "--deg", "--frames", "--json").stdout
    )
    assert np.array(answer["frames"]).shape == (7, 4, 4) and np.allclose(
        answer["frames"][-1], answer["pose"]
    )
    assert dhlab("fk", "ur5e", "--frames").stdout.count("frame ") == 7


def test_metres_of_a_prismatic_joint_are_no_degrees():
    answer = json.loads(dhlab("fk", "stanford", "--q", "0,0,0.5,0,0,0", "--deg", "--json").stdout)
    assert answer["q"][2] == 0.5


def test_limits_are_noted_and_not_enforced():
    answer = dhlab("fk", "panda")
    assert answer.returncode == 0 and "outside the stated limits: joint 4" in answer.stdout


def test_a_table_file(tmp_path):
    (tmp_path / "two.csv").write_text(
        "# convention: standard\ntheta_deg,d_m,a_m,alpha_deg\n0,0,1,0\n0,0,0.5,0\n"
    )
    answer = json.loads(
        dhlab("fk", str(tmp_path / "two.csv"), "--q", "90,-90", "--deg", "--json").stdout
    )
    assert np.allclose(np.array(answer["pose"])[:3, 3], [0.5, 1, 0])


@pytest.mark.slow
def test_robots():
    rows = json.loads(dhlab("robots", "--json").stdout)
    assert len(rows) >= 60 and {"name", "title", "tables"} <= rows[0].keys()
    assert "piper" in dhlab("robots").stdout
    one = json.loads(dhlab("robots", "piper.sdk_old", "--json").stdout)
    assert (
        one["convention"] == "craig"
        and np.isclose(np.rad2deg(one["rows"][1][0]), -174.22)
        and len(one["limits"]) == 6
    )


@pytest.mark.parametrize(
    "arguments, words",
    [
        (["fk", "ur5"], "did you mean"),
        (["fk", "ur5e", "--q", "1,2"], "expected 6 numbers"),
        (["fk", "ur5e", "--q", "a,0,0,0,0,0"], "separated by commas"),
        (["fk", "ur5e", "--q", "nan,0,0,0,0,0"], "joint 1 is NaN"),
        (["fk"], "ARM"),
        (["fk", "ur5e", "--nonsense"], "nonsense"),
        (["nonsense"], "nonsense"),
        (["fk", "no-such.yaml"], "no such file"),
        (["lab", os.devnull], "folder"),
        (["generate", "ur5e", "--to", "rust"], '"c" or "python"'),
        (["generate", "ur5e", "--name", "2 arms"], "expected a letter"),
        (["generate", "ur5e", "--out", os.devnull], "found one that exists"),
    ],
)
def test_errors_are_one_sentence_and_status_2(arguments, words):
    answer = dhlab(*arguments)
    assert (
        answer.returncode == 2
        and words in answer.stderr
        and answer.stderr.count("\n") == 1
        and "Traceback" not in answer.stderr
    )
    assert answer.stdout == ""


def test_help_and_version():
    assert dhlab().returncode == 0 and "robots" in dhlab().stdout
    assert dhlab("--version").stdout.strip() == "0.1.0"


def test_a_terminal_without_greek_letters_gets_an_answer():
    done = subprocess.run(
        [sys.executable, "-m", "dhlab", "robots", "iiwa14"],
        capture_output=True,
        env={**os.environ, "PYTHONIOENCODING": "ascii"},
    )
    assert done.returncode == 0


def test_a_closed_pipe_is_no_traceback():
    process = subprocess.Popen(
        [sys.executable, "-m", "dhlab", "robots"],  # longer than what waits to be written
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    )
    process.stdout.close()
    _, errors = process.communicate()
    assert b"Traceback" not in errors


def test_convert_keeps_the_pose(tmp_path):
    answer = dhlab("convert", "panda", "--to", "standard", "--out", str(tmp_path / "panda.yaml"))
    assert answer.returncode == 0 and "standard DH, 7 joints" in answer.stdout
    q = "0.1,0.2,0.3,-0.4,0.5,0.6,0.7"
    poses = [
        json.loads(dhlab("fk", name, "--q", q, "--json").stdout)["pose"]
        for name in ("panda", str(tmp_path / "panda.yaml"))
    ]
    assert np.allclose(*poses, atol=1e-14)
    again = dhlab("convert", "panda", "--to", "craig", "--out", str(tmp_path / "panda.yaml"))
    assert again.returncode == 2 and "found one that exists" in again.stderr


def test_from_urdf(tmp_path):
    import dhlab as dh

    dh.to_urdf(dh.load("ur5e"), tmp_path / "ur5e.urdf")
    answer = json.loads(dhlab("from-urdf", str(tmp_path / "ur5e.urdf"), "--json").stdout)
    assert answer["convention"] == "standard" and len(answer["rows"]) == 6
    wrong = dhlab("convert", "ur5e", "--to", "modified")
    assert wrong.returncode == 2 and '"craig"' in wrong.stderr and wrong.stderr.count("\n") == 1
    assert dhlab("from-urdf", str(tmp_path / "none.urdf")).returncode == 2


def test_generate_prints_or_writes_a_source_that_checks_itself(tmp_path):
    printed = dhlab("generate", "ur5e", "--name", "left")
    assert printed.returncode == 0
    assert "void left_forward(const double q[6], double T[16])" in printed.stdout
    out = tmp_path / "ur5e.py"
    assert dhlab("generate", "ur5e", "--to", "python", "--out", str(out)).returncode == 0
    done = subprocess.run([sys.executable, str(out)], capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout == "universal_robots_ur5e: 6 poses, 0 of 312 numbers wrong\n"
    before = out.read_bytes()
    again = dhlab("generate", "panda", "--to", "python", "--out", str(out))
    assert again.returncode == 2
    assert "found one that exists" in again.stderr
    assert out.read_bytes() == before
    assert "--to" in dhlab("generate", "--help").stdout


def test_two_arms_are_compared(tmp_path):
    done = dhlab("compare", "piper", "piper.sdk_old", "--picture", tmp_path / "two.png")
    assert done.stdout.startswith("The same lengths and angles; what differs: joint 2's zero")
    assert (tmp_path / "two.png").stat().st_size > 1000
    library.to_urdf(library.load("piper"), tmp_path / "piper.urdf")
    done = dhlab("compare", "piper", tmp_path / "piper.urdf", "--json")
    assert json.loads(done.stdout)["kind"] == "same"


def test_fk_writes_a_rotation_as_others_do():
    """Roll 10°, pitch 20°, yaw 30° about fixed axes, by hand in each of the other ways."""
    answer = json.loads(dhlab("fk", "ur5e", "--deg", "--tool", "0,0,0.1,10,20,30", "--json").stdout)
    bare = np.array(json.loads(dhlab("fk", "ur5e", "--json").stdout)["pose"])
    R = np.linalg.inv(bare)[:3, :3] @ np.array(answer["pose"])[:3, :3]
    half = np.deg2rad([10, 20, 30]) / 2
    (cr, cp, cy), (sr, sp, sy) = np.cos(half), np.sin(half)
    w = cr * cp * cy + sr * sp * sy  # the textbook's quaternion of these three angles
    assert np.isclose(np.trace(R), 4 * w**2 - 1)
    shift = np.array(answer["pose"])[:3, 3] - bare[:3, 3]
    assert np.allclose(shift, 0.1 * bare[:3, 2])
    a, b, c = answer["kuka_abc"]
    assert [c, b, a] == answer["roll_pitch_yaw"]
    w, *xyz = answer["quaternion_wxyz"]
    assert answer["quaternion_xyzw"] == [*xyz, w]
    v = np.array(answer["rotation_vector"])
    angle = np.linalg.norm(v)
    assert np.allclose(xyz, v / angle * np.sin(angle / 2)) and np.isclose(w, np.cos(angle / 2))
    for word in ("KUKA A, B, C", "rotation vector", "quaternion w, x, y, z"):
        assert word in dhlab("fk", "ur5e").stdout
    assert "expected x,y,z in metres" in dhlab("fk", "ur5e", "--tool", "0,0").stderr


def test_an_arm_as_urdf_and_readable(tmp_path):
    done = dhlab("to-urdf", "ur5e", "--out", tmp_path / "ur5e.urdf")
    assert done.returncode == 0 and dhlab("to-urdf", "ur5e").stdout.startswith("<?xml")
    done = dhlab("convert", tmp_path / "ur5e.urdf", "--tidy", "--out", tmp_path / "tidy.yaml")
    assert "do not drive the arm by this table" in done.stderr
    assert library.equivalent(library.load(tmp_path / "tidy.yaml"), library.load("ur5e"))
    done = dhlab("convert", "ur5e", "--hayati", "--out", tmp_path / "h.csv")
    assert "Hayati" in done.stdout and (tmp_path / "h.csv").read_text().startswith("theta_rad,")
    assert "expected what to make of the arm" in dhlab("convert", "ur5e").stderr


def test_like_reads_the_rows_in_the_other_convention_where_none_is_found(tmp_path):
    """The Panda's rows, which its maker gives for Craig's matrix, called standard."""
    t = library.load("panda").table
    mislabelled = library.DHTable("standard", t.theta, t.d, t.a, t.alpha, t.joints)
    mislabelled.save(tmp_path / "rows.yaml")
    told = dhlab("robots", "--like", tmp_path / "rows.yaml").stdout
    assert "Craig's matrix" in told and "panda" in told
