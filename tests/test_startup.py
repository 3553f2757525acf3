"""What is loaded when: a room is loaded when one of its names is first asked for, and not before.
Counted in modules; ``benchmarks/startup.py`` measures the time.
"""

import ast
import importlib
import json
import pathlib
import subprocess
import sys

import pytest

PACKAGE = pathlib.Path(__file__).parents[1] / "dhlab"
LAZY = ("dhlab", "dhlab.doctor", "dhlab.doctor.programs", "dhlab.view")
POSES = """
import numpy as np, dhlab as dh
arm = dh.load("ur5e")
rows = arm.table.rows.copy()
rows[2, 3] += 0.3
q = np.random.default_rng(1).uniform(-2, 2, (12, 6))
right = dh.Arm(dh.DHTable.standard(rows, angle="rad"))
assert dh.diagnose(arm, q, right.forward(q)).verdict == "explained"
"""


def loaded(code):
    """The names of all modules that a fresh Python has after ``code``."""
    code += "\nimport json, sys\nprint(json.dumps(sorted(sys.modules)))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout.splitlines()[-1])


def rooms(code):
    """The packages outside dhlab, and the rooms of dhlab, that are loaded after ``code``."""
    names = loaded(code)
    return {name.split(".")[0] for name in names} | {
        ".".join(name.split(".")[:3]) for name in names if name.startswith("dhlab.")
    }


@pytest.mark.parametrize(
    "code, absent",
    [
        ("import dhlab", "numpy scipy matplotlib ruamel sympy dhlab.arm"),
        ("import dhlab; dhlab.DHTable", "scipy matplotlib ruamel sympy dhlab.geometry"),
        (
            "import dhlab; dhlab.load('ur5e').forward([0] * 6)",
            "scipy matplotlib sympy IPython dhlab.geometry dhlab.doctor dhlab.view",
        ),
        (
            POSES,
            "matplotlib sympy IPython ipywidgets dhlab.doctor.programs dhlab.doctor.tables"
            " dhlab.view dhlab.course dhlab.measure",
        ),
        ("from dhlab import view", "numpy matplotlib scipy anywidget"),
        ("from dhlab.doctor import catalogue; catalogue()", "numpy scipy matplotlib"),
        ("from dhlab.course import check; check('05.2', [1, 2])", "scipy matplotlib anywidget"),
    ],
    ids=["import", "table", "forward", "poses", "view", "catalogue", "check"],
)
def test_nothing_is_loaded_before_it_is_needed(code, absent):
    assert rooms(code) & set(absent.split()) == set()


def stub_names(package):
    """The names in the ``.pyi`` beside a package, in its order: (name, module it is taken from)."""
    path = PACKAGE.joinpath(*package.split(".")[1:], "__init__.pyi")
    for node in ast.parse(path.read_text(encoding="utf-8")).body:
        if isinstance(node, ast.ImportFrom):
            for alias in node.names:
                assert alias.asname == alias.name, "a checker takes other names for private"
                yield alias.name, node.module


@pytest.mark.parametrize("package", LAZY)
def test_every_name_is_the_one_that_the_list_says(package):
    module = importlib.import_module(package)
    names = dict(stub_names(package))
    assert module.__all__ == sorted(names) == sorted(dir(module))
    for name, home in names.items():
        there = importlib.import_module(f"{package}.{home or name}")
        assert getattr(module, name) is (getattr(there, name) if home else there)


def test_a_name_that_is_not_there_is_answered_with_those_that_are():
    import dhlab

    with pytest.raises(AttributeError, match=r"dhlab has no 'forwards'; it has Arm, DHTable, "):
        dhlab.forwards


@pytest.mark.slow
def test_a_room_is_there_without_an_import_of_its_own():
    loaded("import dhlab as dh; dh.transform.rot_x(1), dh.view.arm, dh.doctor.diagnose")


@pytest.mark.slow
@pytest.mark.parametrize(
    "package, name", [("dhlab", "robots"), ("dhlab.doctor", "catalogue")], ids=str
)
def test_a_function_with_the_name_of_its_module_stays_the_function(package, name):
    same = f"assert p.{name} is sys.modules['{package}.{name}'].{name}"
    for first in (
        f"import {package}.{name}",
        f"from {package}.{name} import {name}",
        f"p.{name}()",
        f"from {package} import {name}",
    ):
        loaded(f"import sys, {package} as p; {first}; p.{name}(); {same}")
