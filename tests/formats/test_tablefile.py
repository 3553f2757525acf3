"""Table files: what is written comes back; what is wrong is named by file, line, row and column."""

import os
import stat

import numpy as np
import pytest
from draws import few, shared_out
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

import dhlab as dh
from dhlab.robots import entry

GOOD = """\
name: my arm
convention: standard          # or craig
units: {length: m, angle: deg}
joints:
  - {theta: 0, d: 0.1, a: 0, alpha: 90}
  - {type: prismatic, theta: 0, d: 1e-3, a: +.425, alpha: 0}
base: {xyz: [0, 0, 1], rpy: [0, 0, 90]}
limits: [[-180, 180], [-0.1, 0.4]]
sign: [1, -1]
"""


def test_the_documented_example(tmp_path):
    (tmp_path / "my.yaml").write_text(GOOD)
    arm = dh.load(tmp_path / "my.yaml")
    assert (arm.name, arm.table.convention, arm.table.joints) == ("my arm", "standard", "RP")
    assert np.allclose(arm.table.rows, [[0, 0.1, 0, np.pi / 2], [0, 0.001, 0.425, 0]])
    assert np.allclose(arm.limits, [(-np.pi, np.pi), (-0.1, 0.4)]) and arm.sign.tolist() == [1, -1]
    assert (
        np.allclose(arm.base[:3, :3], Rotation.from_euler("z", 90, degrees=True).as_matrix())
        and arm.base[2, 3] == 1
    )
    assert dh.load(str(tmp_path / "my.yaml")) == arm


def same(a, b):
    return (
        np.abs(a.table.rows - b.table.rows).max() <= 1e-15 * 8
        and np.abs(a.base - b.base).max() <= 1e-15
        and np.abs(a.tool - b.tool).max() <= 1e-15
        and np.array_equal(a.sign, b.sign)
        and a.table.joints == b.table.joints
        and a.table.convention == b.table.convention
    )


@pytest.mark.parametrize(
    "k, options",
    [(0, {}), (1, {"length": "mm"}), (2, {"angle": "rad"}), (3, {"angle": "deg", "length": "mm"})],
)
def test_every_arm_comes_back(tmp_path, k, options):
    for key in shared_out(few(dh.robots(), 20), k, 4):
        for table, arm in entry(key).tables.items():
            arm.save(tmp_path / f"{key}.{table}.yaml", **options)
            back = dh.load(tmp_path / f"{key}.{table}.yaml")
            assert same(arm, back) and back.name == arm.name and back.source == arm.source
            assert arm.limits is back.limits is None or all(
                x == y or np.allclose(x, y, rtol=0, atol=1e-15)
                for x, y in zip(arm.limits, back.limits)
            )
            arm.table.save(tmp_path / f"{key}.{table}.csv", **options)
            assert same(dh.Arm(dh.DHTable.load(tmp_path / f"{key}.{table}.csv")), dh.Arm(arm.table))


@given(st.integers(0, 2**32 - 1), st.sampled_from([".yaml", ".csv"]))
def test_random_tables_come_back_exactly(tmp_path_factory, seed, ending):
    rng = np.random.default_rng(seed)
    n = int(rng.integers(1, 9))
    make = dh.DHTable.standard if rng.random() < 0.5 else dh.DHTable.craig
    table = make(
        rng.uniform(-7, 7, (n, 4)) * 10.0 ** rng.integers(-6, 3, (n, 4)),
        angle="rad",
        joints="".join(rng.choice(["R", "P"], n)),
    )
    path = tmp_path_factory.mktemp("tables") / f"table{ending}"
    table.save(path)
    assert dh.DHTable.load(path) == table


@given(st.integers(0, 2**32 - 1))
def test_bases_come_back_even_at_the_gimbal(tmp_path_factory, seed):
    rng = np.random.default_rng(seed)
    base = np.eye(4)
    base[:3, :3] = Rotation.from_euler(
        "xyz",
        [rng.uniform(-3, 3), np.pi / 2 + rng.choice([0, 1e-9, 1e-13, 1.0]), rng.uniform(-3, 3)],
    ).as_matrix()
    base[:3, 3] = rng.uniform(-1, 1, 3)
    arm = dh.Arm(dh.DHTable.standard([[0, 0.1, 0, 0]], angle="deg"), base=base)
    path = tmp_path_factory.mktemp("bases") / "arm.yaml"
    arm.save(path)
    assert np.abs(dh.load(path).base - base).max() <= 2e-15


def test_degrees_are_written_the_way_they_were_typed(tmp_path):
    dh.load("xarm6").save(tmp_path / "x.yaml", angle="deg")
    text = (tmp_path / "x.yaml").read_text()
    assert "alpha: -90}" in text and "79.34995" in text
    dh.load("ur5e").save(tmp_path / "u.csv".replace("csv", "yaml"))
    assert "{theta: 0, d: 0.1625, a: 0, alpha: 90}" in (tmp_path / "u.yaml").read_text()


def test_nothing_is_lost(tmp_path):
    path = tmp_path / "arm.yaml"
    path.write_text("precious")
    with pytest.raises(ValueError, match="found one that exists"):
        dh.load("ur5e").save(path)
    assert path.read_text() == "precious" and os.listdir(tmp_path) == ["arm.yaml"]
    os.chmod(path, 0o640)
    dh.load("ur5e").save(path, overwrite=True)
    assert dh.load(path) == dh.load("ur5e") and stat.S_IMODE(path.stat().st_mode) == 0o640
    with pytest.raises(ValueError, match="CSV can hold"):
        dh.load("panda").save(tmp_path / "panda.csv")
    with pytest.raises(ValueError, match="expected to write here"):
        dh.load("ur5e").save(tmp_path / "no" / "such" / "x.yaml")
    with pytest.raises(ValueError, match="ending in .yaml or .csv"):
        dh.load("ur5e").save(tmp_path / "x.json")
    assert os.listdir(tmp_path) == ["arm.yaml"]


def test_a_table_alone_refuses_what_it_cannot_hold(tmp_path):
    (tmp_path / "my.yaml").write_text(GOOD)
    with pytest.raises(ValueError, match="base and sign and limits"):
        dh.DHTable.load(tmp_path / "my.yaml")


def changed(old, new):
    assert old in GOOD
    return GOOD.replace(old, new)


BAD_YAML = {
    "number as text": (changed("d: 0.1", "d: '0.1'"), ["line 5", "row 1", "d:", "text '0.1'"]),
    "sexagesimal": (changed("alpha: 90", "alpha: 89:30"), ["line 5", "row 1", "alpha", "89:30"]),
    "decimal comma": (
        changed("a: 0, alpha: 90", "a: 0,425, alpha: 90"),
        ["row 1", "decimal comma"],
    ),
    "not a number": (changed("d: 0.1", "d: .nan"), ["row 1, d", "finite"]),
    "infinity": (changed("d: 0.1", "d: -.inf"), ["row 1, d", "finite"]),
    "true": (changed("d: 0.1", "d: true"), ["row 1, d", "expected a number"]),
    "missing column": (changed("d: 0.1, ", ""), ["row 1", "no d"]),
    "unknown column": (changed("alpha: 90", "alhpa: 90"), ["row 1", 'did you mean "alpha"']),
    "unknown key": (GOOD + "colour: red\n", ['unknown key "colour"']),
    "key twice": (GOOD + "name: other\n", ["line 10", '"name" twice']),
    "column twice": (changed("d: 0.1", "d: 0.1, d: 0.2"), ['"d" twice']),
    "no convention": (changed("convention: standard", "source: me"), ["no convention"]),
    "modified": (changed("standard", "modified"), ["line 2", '"modified" is called craig']),
    "no units": (changed("units: {length: m, angle: deg}\n", ""), ["no units"]),
    "half of the units": (changed("length: m, ", ""), ["units", "no length"]),
    "strange unit": (changed("length: m", "length: inch"), ["line 3", "found 'inch'"]),
    "no rows": (GOOD.split("joints:")[0] + "joints: []\n", ["empty list"]),
    "row is a list": (
        changed("{theta: 0, d: 0.1, a: 0, alpha: 90}", "[0, 0.1, 0, 90]"),
        ["row 1", "found a list"],
    ),
    "joint type": (changed("type: prismatic", "type: sliding"), ["row 2, type", "'sliding'"]),
    "limits too short": (
        changed("[[-180, 180], [-0.1, 0.4]]", "[[-180, 180]]"),
        ["limits", "expected 2 entries, found 1"],
    ),
    "limits turned round": (changed("[-0.1, 0.4]", "[0.4, -0.1]"), ["limits", "joint 2"]),
    "sign 2": (changed("[1, -1]", "[1, 2]"), ["sign", "1 or -1"]),
    "rpy too short": (
        changed("rpy: [0, 0, 90]", "rpy: [0, 90]"),
        ["base, rpy", "expected 3 entries, found 2"],
    ),
    "anchor": (changed("name: my arm", "name: &x my arm"), ["anchor"]),
    "merge key": (GOOD + "<<: {a: 1}\n", ["merge key"]),
    "tag": (changed("name: my arm", "name: !!python/object:os.system my arm"), ["tag"]),
    "tab": (changed("  - {theta", "\t- {theta"), ["line 5", "no YAML"]),
    "unclosed": (changed("alpha: 90}", "alpha: 90"), ["no YAML"]),
    "two documents": (GOOD + "---\n" + GOOD, ["no YAML"]),
    "a list": ("- 1\n- 2\n", ["found a list"]),
    "empty": ("", ["found nothing"]),
    "a word": ("hello", ["found the text 'hello'"]),
    "deep": ("[\n" * 20000, ["nested"]),  # on one line ruamel looks for a key 1,024 tokens ahead
}


@pytest.mark.parametrize("case", BAD_YAML)
def test_bad_yaml_is_one_plain_sentence(tmp_path, case):
    text, words = BAD_YAML[case]
    (tmp_path / "bad.yaml").write_text(text)
    with pytest.raises(ValueError) as error:
        dh.load(tmp_path / "bad.yaml")
    message = str(error.value)
    assert "bad.yaml" in message and "\n" not in message
    assert all(word in message for word in words), message


CSV = (
    "# convention: craig\n"
    "theta_deg,d_mm,a_mm,alpha_deg,type,sign\n"
    "90,100,0,0,revolute,-1\n"
    "0,5,1e2,-90,prismatic,1\n"
)


def test_csv_with_types_and_signs(tmp_path):
    for text in (
        CSV,
        "\ufeff" + CSV.replace("\n", "\r\n"),
        CSV.replace("craig\n", "craig,,,,,\n") + "\n\n",
        CSV.replace(",", " , "),
    ):
        (tmp_path / "t.csv").write_text(text, encoding="utf-8", newline="")
        arm = dh.load(tmp_path / "t.csv")
        assert (arm.name, arm.table.convention, arm.table.joints, arm.sign.tolist()) == (
            "t",
            "craig",
            "RP",
            [-1, 1],
        )
        assert np.allclose(arm.table.rows, [[np.pi / 2, 0.1, 0, 0], [0, 0.005, 0.1, -np.pi / 2]])


BAD_CSV = {
    "no convention": (CSV.split("\n", 1)[1], ["line 1", "# convention"]),
    "modified": (CSV.replace("craig", "modified"), ["line 1", "called craig"]),
    "no unit": (CSV.replace("theta_deg", "theta"), ["line 2", "theta_deg"]),
    "unknown unit": (CSV.replace("d_mm", "d_in"), ["line 2", "'in'"]),
    "unknown column": (CSV.replace("sign", "colour"), ["line 2", "'colour'"]),
    "twice": (CSV.replace("a_mm", "d_m"), ["d twice"]),
    "missing column": (
        CSV.replace("alpha_deg,", "").replace(",0,revolute", ",revolute"),
        ["no column alpha"],
    ),
    "text": (CSV.replace("100", "ten"), ["line 3", "row 1", "d:", "'ten'"]),
    "nan": (CSV.replace("100", "nan"), ["row 1", "finite"]),
    "empty cell": (CSV.replace("100", ""), ["row 1", "d:", "nothing"]),
    "short row": (CSV.replace(",-90", ""), ["line 4", "row 2", "found 5"]),
    "semicolons": (CSV.replace(",", ";"), ["line 2"]),
    "type": (CSV.replace("prismatic", "P"), ["row 2", "type"]),
    "sign": (CSV.replace("-1\n", "2\n"), ["sign"]),
    "header only": ("\n".join(CSV.split("\n")[:2]), ["at least one row"]),
    "empty": ("", ["line 1"]),
}


@pytest.mark.parametrize("case", BAD_CSV)
def test_bad_csv_is_one_plain_sentence(tmp_path, case):
    text, words = BAD_CSV[case]
    (tmp_path / "bad.csv").write_text(text)
    with pytest.raises(ValueError) as error:
        dh.load(tmp_path / "bad.csv")
    message = str(error.value)
    assert (
        "bad.csv" in message and "\n" not in message and all(word in message for word in words)
    ), message


def test_files_that_are_no_text(tmp_path):
    (tmp_path / "utf16.yaml").write_bytes(GOOD.encode("utf-16"))
    (tmp_path / "folder.yaml").mkdir()
    os.mkfifo(tmp_path / "pipe.yaml")
    (tmp_path / "large.yaml").write_bytes(b"#" * 10_000_001)
    for name, words in (
        ("utf16", "UTF-8"),
        ("folder", "a folder"),
        ("pipe", "no plain file"),
        ("large", "10 MB"),
        ("missing", "no such file"),
    ):
        with pytest.raises(ValueError, match=words):
            dh.load(tmp_path / f"{name}.yaml")
