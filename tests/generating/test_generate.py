"""Generated sources: compiled without a warning, then held against dhlab and against a product of
elementary matrices that does not use it.
"""

import ctypes
import os
import re
import shutil
import subprocess
import sys

import numpy as np
import pytest
from oracles import whole_pose_and_jacobian

import dhlab as dh
from dhlab.generating import formulas, runs
from dhlab.generating.formulas import forward_formulas, jacobian_formulas
from dhlab.generating.lines import Lines
from dhlab.generating.words import identifier, plain
from dhlab.robots import entry
from dhlab.transform import from_xyz_rpy

WARNINGS = [
    *("-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Wstrict-prototypes"),
    *("-Wmissing-prototypes", "-Wmissing-declarations", "-Werror"),
]
TABLES = [f"{arm}.{table}" for arm in dh.robots() for table in entry(arm).tables]
HOSTILE = [
    "*/ int main(void){return 0;} /*",
    "quote \" and ' and \\",
    "two\nlines\r\nand \x0b\x0c\x00\x85\u2028more",
    "??/ ??) **// /*/*/",
    "\\u0041 \\N{DIGIT ONE} %s %d {name} {{}} {0!r}",
    "机械臂 Ärm Ω 🤖",
    "turn\u202eed round\u200b\ufeff",
    "\ud800 half a letter",
    '"""; import os; """',
    "-*- coding: latin-1 -*-",
    "# vim: set fileencoding=utf-7",
    "7 axes",
    "___",
    "int",
    "",
    "a long name " * 40,
    "*" * 300 + "/",
]


@pytest.fixture(scope="session")
def gcc():
    """The path of gcc; what needs it is skipped, saying so, where there is none."""
    found = shutil.which("gcc")
    if found is None:
        if os.environ.get("CI"):
            pytest.fail("CI needs gcc: apt-get install gcc")
        pytest.skip("no gcc here, so no generated C was compiled")
    return found


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


@pytest.mark.parametrize("name", TABLES)
def test_every_table_of_the_library_in_c(name, gcc, tmp_path):
    arm = dh.load(name)
    assert worst(InC(gcc, arm, tmp_path), arm) < 1e-12


@pytest.mark.parametrize("name", TABLES)
def test_every_table_of_the_library_in_python(name):
    arm = dh.load(name)
    assert worst(InPython(arm), arm) < 1e-12


@pytest.mark.parametrize("convention", ["standard", "craig"])
@pytest.mark.parametrize("n", [1, 2, 3, 4, 6, 7, 9])
def test_random_arms_with_every_part(n, convention):
    for seed in range(12):
        arm = random_arm(seed, n, convention)
        assert worst(InPython(arm), arm, trials=5, seed=seed) < 1e-12


@pytest.mark.parametrize("convention", ["standard", "craig"])
def test_random_arms_in_c(convention, gcc, tmp_path):
    for seed, n in enumerate([1, 3, 6, 7]):
        folder = tmp_path / str(n)
        folder.mkdir()
        arm = random_arm(100 + seed, n, convention)
        assert worst(InC(gcc, arm, folder), arm, trials=5) < 1e-12


@pytest.mark.parametrize("length", [1e-9, 1e-4, 1.0, 1e3])
def test_tiny_and_huge_lengths_are_right_in_their_own_size(length, gcc, tmp_path):
    rows = [[0, length, 0, 90], [10, 0, 3 * length, 0], [0, 0, 2 * length, 90], [0, length, 0, 0]]
    arm = dh.Arm(dh.DHTable.standard(rows, angle="deg"))
    assert worst(InC(gcc, arm, tmp_path), arm, reach=7 * length) < 1e-13


def test_lengths_of_all_sizes_in_one_table(gcc, tmp_path):
    rows = [[0, 1e-9, 1e3, 90], [0, 1e3, 1e-9, 0], [0, 1e-6, 1.0, -90], [5, 0, 1e-3, 0]]
    arm = dh.Arm(dh.DHTable.craig(rows, angle="deg"))
    assert worst(InC(gcc, arm, tmp_path), arm, reach=2e3) < 1e-14


@pytest.mark.parametrize("alpha", [1e-15, 1e-9, 1e-8, 4e-8, np.pi - 1e-8, np.pi / 2 + 1e-9, 1.5708])
def test_axes_that_are_nearly_parallel_or_square_are_not_made_exact(alpha):
    arm = dh.Arm(dh.DHTable.standard([[0, 0.3, 0.5, alpha], [0, 0.2, 0.4, alpha]], angle="rad"))
    assert worst(InPython(arm), arm, trials=20) < 1e-14


def test_right_angles_leave_no_numbers_behind():
    arm = dh.Arm(
        dh.DHTable.standard(
            [[90, 0.5, 0.25, 90], [-90, 0, 0.5, -90], [180, 0, 0.25, 180]], angle="deg"
        ),
        base=from_xyz_rpy([0, 0, 1], [np.pi / 2, 0, -np.pi / 2]),
        tool=from_xyz_rpy([0, 0, 0.5], [0, np.pi, np.pi / 2]),
    )
    text = dh.generate(arm, "python", name="arm")
    functions = text[text.index("def arm_forward") : text.index("def _self_check")]
    numbers = set(
        re.findall(r"(?<![\w\[])\d+\.?\d*(?:e-?\d+)?", functions.replace("rows of 3", ""))
    )
    assert {float(number) for number in numbers} <= {0, 1, 0.25, 0.5}, numbers


def test_a_base_typed_with_few_digits_is_made_a_rotation_and_said_so(gcc, tmp_path):
    base = from_xyz_rpy([0.1, 0, 0], [0, 0, np.pi / 4]).round(6)
    tool = from_xyz_rpy([0, 0.1, 0], [0.4, 1.0, -0.2]).round(7)
    arm = dh.Arm(dh.load("ur5e").table, base=base, tool=tool)
    assert worst(InC(gcc, arm, tmp_path), arm, trials=5) < 1e-6
    text = dh.generate(arm, "c")
    assert "The rotation of the base was made exact; it was given 2e-07 off." in text
    assert "The rotation of the tool was made exact" in text
    assert "made exact" not in dh.generate(dh.load("ur5e").to("craig"), "c")


def test_a_pose_that_does_not_depend_on_q_compiles(gcc, tmp_path):
    arm = dh.Arm(dh.DHTable.standard([[0, 0.1, 0, 0], [0, 0, 0.2, 90]], angle="deg", joints="PP"))
    assert worst(InC(gcc, arm, tmp_path), arm, trials=3) < 1e-15


def test_joint_angles_may_be_mixtures_of_several_q(monkeypatch):
    """As in an arm whose motors are coupled: one function says how, and both formulas follow it."""
    arm = random_arm(3, 6, "standard")
    mixture = np.diag(arm.sign) @ (np.eye(6) + np.diag([0, -1, 0, 0.25, 0], 1))
    _, offset = runs.joint_variables(arm)
    for module in (runs, formulas):
        monkeypatch.setattr(module, "joint_variables", lambda arm: (mixture, offset))
    for q in np.random.default_rng(2).uniform(-2, 2, (20, 6)):
        own = arm.sign * (mixture @ q)
        T, J = evaluated(forward_formulas(arm), q), evaluated(jacobian_formulas(arm), q)
        assert abs(T - arm.forward(own)).max() < 1e-13
        assert abs(J - arm.jacobian(own) @ np.diag(arm.sign) @ mixture).max() < 1e-13


def evaluated(some, q):
    """Formulas as numbers."""
    lines = Lines(some)
    names = {"cos": np.cos, "sin": np.sin, "q": q}
    for name, text in lines.assignments:
        names[name] = eval(text, names)
    return np.array([[eval(text, names) for text in row] for row in lines.rows])


def test_a_chain_of_a_hundred_joints(gcc, tmp_path):
    arm = random_arm(5, 100, "craig")
    assert worst(InC(gcc, arm, tmp_path), arm, trials=3, reach=100) < 1e-12
    flat = dh.Arm(dh.DHTable.standard([[1, 0, 0.1, 0]] * 100, angle="deg"))
    (tmp_path / "flat").mkdir()
    assert worst(InC(gcc, flat, tmp_path / "flat"), flat, trials=3) < 1e-12


def test_the_self_checks_find_a_wrong_number(gcc, tmp_path):
    arm = dh.load("ur5e")
    for old, new in (
        ("0.425*c2", "0.426*c2"),
        ("T[6] = -", "T[6] = "),
        ("J[20] = s1", "J[20] = c1"),
    ):
        text = dh.generate(arm, "c")
        assert old in text
        program = compiled(gcc, text.replace(old, new), tmp_path, "-DDHLAB_TEST")
        done = subprocess.run([program], capture_output=True, text=True)
        assert done.returncode == 1
        assert "312 numbers wrong" in done.stdout
    broken = dh.generate(arm, "python").replace("0.425*c2", "float('nan')*c2")
    (tmp_path / "arm.py").write_text(broken)
    done = subprocess.run([sys.executable, tmp_path / "arm.py"], capture_output=True, text=True)
    assert done.returncode == 1
    assert "312 numbers wrong" in done.stdout


def test_it_links_into_a_controller_and_is_c_plus_plus_too(gcc, tmp_path):
    (tmp_path / "main.c").write_text(
        "#include <stdio.h>\nvoid ur5e_forward(const double q[6], double T[16]);\n"
        "extern const double ur5e_limits[6][2];\nint main(void) {\n double q[6] = {0}, T[16];\n"
        ' ur5e_forward(q, T);\n printf("%.4f %.4f\\n", T[3], ur5e_limits[2][1]);\n return 0;\n}\n'
    )
    text = dh.generate(dh.load("ur5e"), "c", name="ur5e")
    program = compiled(gcc, text, tmp_path, tmp_path / "main.c", name="ur5e.c")
    assert subprocess.run([program], capture_output=True, text=True).stdout == "-0.8172 6.2832\n"
    if shutil.which("g++"):
        done = subprocess.run(
            [
                "g++",
                "-Wall",
                "-Wextra",
                "-Wpedantic",
                "-Werror",
                "-fsyntax-only",
                tmp_path / "ur5e.c",
            ],
            capture_output=True,
            text=True,
        )
        assert done.returncode == 0, done.stderr


def test_limits_are_constants_where_they_are_stated(gcc, tmp_path):
    table = dh.DHTable.standard([[0, 0.1, 0, 90], [0, 0, 0, 0]], angle="deg", joints="RP")
    arm = dh.Arm(table, limits=[None, (-0.1, 0.25)], name="two")
    text = dh.generate(arm, "c")
    assert "{-HUGE_VAL, HUGE_VAL}" in text
    assert "{-0.1, 0.25}" in text
    assert "-0.1 to 0.25 m" in text
    checks_itself(gcc, text, tmp_path)
    names = {}
    exec(dh.generate(arm, "python"), names)
    assert names["two_limits"] == [None, (-0.1, 0.25)]
    assert "limits[" not in dh.generate(dh.Arm(table), "c")


@pytest.mark.parametrize("name", HOSTILE, ids=range(len(HOSTILE)))
def test_a_hostile_name_stays_in_its_comment(name, gcc, tmp_path):
    table = dh.DHTable.standard([[0, 0.1, 0.2, 90]], angle="deg")
    calm, hostile = dh.Arm(table, name="x", source="x"), dh.Arm(table, name=name, source=name)
    text = dh.generate(hostile, "c")
    assert checks_itself(gcc, text, tmp_path).startswith(identifier(name))
    assert text.count("*/") == dh.generate(calm, "c").count("*/")
    calm, hostile = (dh.generate(arm, "python", name="same").encode() for arm in (calm, hostile))
    assert compile(hostile, "x.py", "exec").co_code == compile(calm, "x.py", "exec").co_code
    assert re.sub(rb"(?m)^#.*\n", b"", hostile) == re.sub(rb"(?m)^#.*\n", b"", calm)
    assert b"\r" not in hostile


@pytest.mark.parametrize("name", HOSTILE, ids=range(len(HOSTILE)))
def test_an_identifier_is_one(name):
    found = identifier(name)
    assert re.fullmatch(r"[a-z][a-z0-9_]{0,23}", found)
    assert not found.endswith("_")
    assert not re.search(r"\*/|/\*|\?\?", plain(name))
    assert plain(name).isprintable()


@pytest.mark.parametrize("language", ["c", "python"])
def test_the_same_arm_gives_the_same_bytes_in_every_process(language):
    program = (
        "import dhlab, sys; sys.stdout.reconfigure(encoding='utf-8', newline='\\n');"
        f"print(*(dhlab.generate(dhlab.load(a), {language!r}) for a in ('panda', 'stanford')))"
    )
    texts = {
        subprocess.run(
            [sys.executable, "-c", program],
            capture_output=True,
            check=True,
            env={**os.environ, "PYTHONHASHSEED": seed},
        ).stdout
        for seed in ("0", "1", "77")
    }
    assert len(texts) == 1
    assert len(texts.pop()) > 10_000


def test_the_head_says_what_the_table_says():
    text = dh.generate(dh.load("ar4"), "c")
    head = text[: text.index("#include")]
    for words in ("Craig", "q in rad", "0.305", "0.16977", "-170 to 170 deg", "revolute  -1"):
        assert words in head, words
    forward, jacobian = forward_formulas(dh.load("ar4")), jacobian_formulas(dh.load("ar4"))
    for name, part in (("forward", forward), ("jacobian", jacobian)):
        assert f"Cost of {name}: {part.count['multiplications']} multiplications" in head


@pytest.mark.parametrize("name", dh.robots())
def test_the_stated_cost_is_what_the_source_holds(name):
    arm = dh.load(name)
    text = dh.generate(arm, "python", name="arm")
    forward = text[text.index("def arm_forward") : text.index("def arm_jacobian")]
    jacobian = text[text.index("def arm_jacobian") : text.index("def _self_check")]
    for body, part in ((forward, forward_formulas(arm)), (jacobian, jacobian_formulas(arm))):
        code = body.partition('"""\n')[2]
        assert code.count("*") == part.count["multiplications"]
        assert len(re.findall(r"(?:cos|sin)\(", code)) == part.count["sines and cosines"]
        assert len(re.findall(r" [+-] ", code)) == part.count["additions"]


def test_a_table_will_do_and_names_can_be_chosen():
    table = dh.load("ur5e").table
    assert "void arm_forward(const double q[6]" in dh.generate(table)
    assert "def Left_2_forward(q)" in dh.generate(table, "python", name="Left_2")


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ((3, "c"), "expected a DHTable or an Arm, found int"),
        (("ur5e", "c"), "expected a DHTable or an Arm, found str"),
        ((dh.load("ur5e"), "rust"), '"c" or "python", found \'rust\''),
        ((dh.load("ur5e"), ["c"]), '"c" or "python"'),
        ((dh.Arm(dh.DHTable.standard([[0, 1e308, 1e308, 0]] * 3, angle="deg")),), "overflow"),
    ],
)
def test_errors_are_one_sentence(arguments, words):
    with pytest.raises(ValueError, match=re.escape(words)) as raised:
        dh.generate(*arguments)
    assert "\n" not in str(raised.value)


@pytest.mark.parametrize("name", ["", "2d", "a b", "a;b", "_a", "ä", "a\n", 3, "x" * 41])
def test_a_chosen_name_must_be_one(name):
    with pytest.raises(ValueError, match="expected a letter, then letters"):
        dh.generate(dh.load("ur5e"), "c", name=name)
