"""The generated text: what it says, that it checks itself, and that no name of an arm breaks out of
it.
"""

import os
import re
import shutil
import subprocess
import sys

import numpy as np
import pytest
from compiling import checks_itself, compiled
from draws import few

import dhlab as dh
from dhlab.generating.formulas import forward_formulas, jacobian_formulas
from dhlab.generating.words import identifier, plain
from dhlab.transform import from_xyz_rpy

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


@pytest.mark.slow
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


@pytest.mark.parametrize("name", few(dh.robots(), 20))
def test_the_stated_cost_is_what_the_source_holds(name):
    arm = dh.load(name)
    text = dh.generate(arm, "python", name="arm")
    forward = text[text.index("def arm_forward") : text.index("def arm_jacobian")]
    jacobian = text[text.index("def arm_jacobian") : text.index("def _self_check")]
    for body, part in ((forward, forward_formulas(arm)), (jacobian, jacobian_formulas(arm))):
        code = body.partition('"""\n')[2]
        assert code.count("*") == part.count["multiplications"]
        assert len(re.findall(r"(?:cos|sin)\(", code)) == part.count["sines and cosines"]
        assert len(re.findall(r"\s[+-]\s", code)) == part.count["additions"]


def test_a_table_will_do_and_names_can_be_chosen():
    table = dh.load("ur5e").table
    assert "void arm_forward(const double q[6]" in dh.generate(table)
    assert "def Left_2_forward(q)" in dh.generate(table, "python", name="Left_2")


@pytest.mark.parametrize(
    "arguments, words",
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
