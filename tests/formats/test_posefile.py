"""Poses files against files written here and rotations computed by other means."""

import numpy as np
import pytest
from scipy.linalg import expm
from scipy.spatial.transform import Rotation

from dhlab.formats.posefile import read_poses

HEADER = "q1,q2,x,y,z"


@pytest.fixture(autouse=True)
def seeded():
    """Every test draws the same numbers, whichever ran before it."""
    global rng
    rng = np.random.default_rng(11)


@pytest.fixture
def file(tmp_path):
    def write(text, name="poses.csv"):
        path = tmp_path / name
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return path

    return write


def poses(m=8):
    q, xyz = rng.uniform(-3, 3, (m, 2)), rng.uniform(-1, 1, (m, 3))
    vectors = rng.uniform(-2, 2, (m, 3))
    T = np.tile(np.eye(4), (m, 1, 1))
    T[:, :3, 3] = xyz
    T[:, :3, :3] = [expm(np.cross(np.eye(3), v)) for v in vectors]  # of the matrix [v×]
    return q, T, vectors


def csv_text(header, columns):
    return (
        header + "\n" + "\n".join(",".join(repr(float(v)) for v in row) for row in columns) + "\n"
    )


def test_positions_alone(file):
    q, T, _vectors = poses()
    got_q, got = read_poses(file(csv_text(HEADER, np.hstack([q, T[:, :3, 3]]))), 2)
    assert np.array_equal(got_q, q) and np.array_equal(got, T[:, :3, 3])


@pytest.mark.parametrize(
    "angle, length", [("rad", "m"), ("deg", "mm"), ("deg", "m"), ("rad", "mm")]
)
@pytest.mark.parametrize("kind", ["quaternion", "rpy", "rotvec"])
def test_every_orientation_in_every_unit(file, kind, angle, length):
    q, T, vectors = poses()
    to, mm = (np.degrees if angle == "deg" else lambda v: v), 1000 if length == "mm" else 1
    R = Rotation.from_matrix(T[:, :3, :3])
    names, values = {
        "quaternion": ("qx,qy,qz,qw", R.as_quat()),
        "rpy": ("roll,pitch,yaw", to(R.as_euler("xyz"))),
        "rotvec": ("rx,ry,rz", to(vectors)),
    }[kind]
    got_q, got = read_poses(
        file(csv_text(f"{HEADER},{names}", np.hstack([to(q), mm * T[:, :3, 3], values]))),
        2,
        length,
        angle,
    )
    assert np.abs(got_q - q).max() < 1e-14 and np.abs(got - T).max() < 1e-14


def test_known_orientations(file):
    quarter = np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1.0]])
    for names, values in (
        ("qw,qx,qy,qz", "0.70711,0,0,0.70711"),
        ("roll,pitch,yaw", "0,0,1.5707963"),
        ("rx,ry,rz", "0,0,1.5707963"),
    ):
        _, (T,) = read_poses(file(f"q1,x,y,z,{names}\n0,1,2,3,{values}\n"), 1)
        assert np.abs(T[:3, :3] - quarter).max() < 1e-7 and T[:3, 3].tolist() == [1, 2, 3]
        assert np.abs(T[:3, :3].T @ T[:3, :3] - np.eye(3)).max() < 1e-14


def test_prismatic_joints_are_lengths(file):
    path = file(f"{HEADER}\n90,250,0,0,1000\n")
    q, points = read_poses(path, 2, "mm", "deg", joints="RP")
    assert q[0].tolist() == [np.pi / 2, 0.25] and points[0].tolist() == [0, 0, 1]


@pytest.mark.parametrize(
    "text",
    [
        "\ufeffq1,q2,x,y,z\r\n1,2,3,4,5\r\n",
        "# made by hand\n\n q1 , q2, x ,y,z \n\n# a remark, with commas\n 1, 2 ,3,4,5\n,,,,\n",
        "z,y,x,q2,q1\n5,4,3,2,1",
        "Q1,Q2,X,Y,Z\r1,2,3,4,5\r",
        '"q1","q2","x","y","z"\n"1","2",+3.0,4e0,5.\n',
        "q1,q2,x,y,z\n1,2,3,4,5,\n",
    ],
)
def test_harmless_differences(file, text):
    q, points = read_poses(file(text), 2)
    assert q.tolist() == [[1, 2]] and points.tolist() == [[3, 4, 5]]


@pytest.mark.parametrize(
    "text, words",
    [
        ("", "an empty file"),
        ("# only a remark\n", "an empty file"),
        (HEADER, "the header alone"),
        ("1,2,3,4,5\n", "line 1: expected a header"),
        ("q1,q2,x,y\n1,2,3,4\n", "line 1: no column z"),
        ("q1,x,y,z\n1,2,3,4\n", "no column q2"),
        ("q1,q2,q3,x,y,z\n1,2,3,4,5,6\n", "'q3'.*number of joints"),
        ("q1,q2,x,y,z,time\n1,2,3,4,5,6\n", "'time'.*take it out"),
        ("q1,q2,x_mm,y,z\n1,2,3,4,5\n", "'x_mm'.*length="),
        ("q1,q1,x,y,z\n1,2,3,4,5\n", "q1 twice"),
        ("q1,q2,x,y,z,qw,qx,qy\n1,2,3,4,5,1,0,0\n", "no column qz"),
        (
            "q1,q2,x,y,z,roll,pitch,yaw,rx\n1,2,3,4,5,0,0,0,0\n",
            "one orientation.*fixed-axis angles and of a rotation vector",
        ),
        (
            f"{HEADER},qw,qx,qy,qz\n1,2,3,4,5,1,0,0,0\n\n1,2,3,4,5,1,0.1,0,0\n",
            "line 4: columns qw.*length 1.005",
        ),
        (f"{HEADER},qw,qx,qy,qz\n1,2,3,4,5,0,0,0,0\n", "length 0"),
        (f"{HEADER}\n1,2,3,4,5\n1,2,nan,4,5\n", "line 3: column x.*finite number, found nan"),
        (f"{HEADER}\n1,2,3,4,1e999\n", "column z.*finite"),
        (f"{HEADER}\n1,2,,4,5\n", "column x.*empty cell"),
        (f"{HEADER}\n1,2,3 mm,4,5\n", "line 2: column x.*'3 mm'.*without units"),
        (f"{HEADER}\n1,2,0x10,4,5\n", "column x"),
        (f"{HEADER}\n1,2,1_000,4,5\n", "column x"),
        (f"{HEADER}\n1,2,3,4\n", "expected 5 cells.*found 4; fill in"),
        (f"{HEADER}\n1,2,0,425,4,5\n", "line 2.*found 6; is that a decimal comma"),
        (f'{HEADER}\n1,2,"0,425",4,5\n', "column x.*write 0.425"),
        (
            "q1;q2;x;y;z\n1,0;2;3;4;5\n",
            "line 1: expected commas between the columns, found semicolons",
        ),
        ("q1\tq2\tx\ty\tz\n1\t2\t3\t4\t5\n", "found tabs"),
        (f'{HEADER}\n1,2,"3,4,5\n', "line 2: expected cells"),
        (b"q1,q2,x,y,z\n1,2,3,4,\xff\n", "UTF-8"),
        (f"{HEADER}\n1,2,3\x00,4,5\n", "line 2"),
    ],
)
def test_what_is_refused_and_how(file, text, words):
    with pytest.raises(ValueError, match=words) as error:
        read_poses(file(text), 2)
    assert "poses.csv" in str(error.value) and "\n" not in str(error.value)


def test_arguments(file):
    path = file(f"{HEADER}\n1,2,3,4,5\n")
    for kwargs, words in [
        ({"length": "cm"}, "length"),
        ({"angle": None}, "angle"),
        ({"joints": "R"}, "joints"),
    ]:
        with pytest.raises(ValueError, match=words):
            read_poses(path, 2, **kwargs)
    for n in (0, -1, 2.5, True, "2"):
        with pytest.raises(ValueError, match="number of joints"):
            read_poses(path, n)
    with pytest.raises(ValueError, match="no such file"):
        read_poses(path.parent / "none.csv", 2)
