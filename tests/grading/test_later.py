"""Packages that wait in the cage until they are used give then what they give everywhere."""

import subprocess
import sys

BEGIN = (
    "import sys\nfrom dhlab.grading.inside.warming.later import let_wait\nlet_wait()\n"
    "import numpy as np\n"
)
USES = {
    "rotations": "from scipy.spatial.transform import Rotation, Slerp\n"
    "turns = Rotation.from_rotvec([[0, 0, 0], [0, 0, np.pi / 2]])\n"
    "assert np.allclose(Slerp([0, 1], turns)(0.5).as_rotvec(), [0, 0, np.pi / 4])",
    "groups of rotations": "from scipy.spatial.transform import Rotation\n"
    "assert [len(Rotation.create_group(name)) for name in ('I', 'C3', 'C3')] == [60, 3, 3]",
    "a package's own names": "from scipy.spatial import ConvexHull\n"
    "assert abs(ConvexHull([[0, 0], [0, 2], [3, 0], [1, 0.5]]).volume - 3) < 1e-12",
    "a package by its parts": "import scipy.spatial.transform as t, scipy.spatial as s\n"
    "assert t is s.transform and t.RotationSpline and s.distance.euclidean([0, 3], [4, 0]) == 5\n"
    "assert t.Rotation is s.transform.Rotation",
    "all of its names": "from scipy.spatial import *\n"
    "assert cKDTree([[0], [5]]).query([4])[1] == 1",
    "tests of numpy": "np.testing.assert_allclose(1, 1 + 1e-9)\n"
    "from numpy.testing import assert_array_equal\n"
    "try: assert_array_equal([1], [2])\nexcept AssertionError: pass\nelse: raise SystemExit(3)",
    "masked arrays": "from numpy.ma import masked_array\n"
    "assert masked_array([1, 5], [0, 1]).sum() == np.ma.masked_greater([1, 5], 2).sum() == 1\n"
    "import numpy.ma.extras as extras\nassert np.ma.extras is extras",
    "texts": "assert np.char.upper(['a']) == ['A'] and np.strings.str_len(np.array(['ab'])) == [2]",
    "memory of C": "import ctypes\n"
    "assert np.ctypeslib.as_array((ctypes.c_int * 2)(3, 4)).tolist() == [3, 4]",
    "help": "import pydoc\nassert 'absolute value' in pydoc.render_doc(abs)",
    "polynomials": "assert np.polynomial.Polynomial([1, 2])(3) == 7\n"
    "assert list(np.polynomial.polynomial.polyroots([2, -3, 1]).round(9)) == [1, 2]",
}


def _run(source):
    return subprocess.run([sys.executable, "-c", BEGIN + source], capture_output=True, text=True)


def test_what_waits_is_right_when_it_is_used():
    for what, source in USES.items():
        done = _run(source)
        assert done.returncode == 0, (what, done.stderr)


def test_a_rotation_leaves_waiting_what_it_does_not_use():
    done = _run(f"{USES['rotations']}\nprint(*sys.modules)")
    loaded = set(done.stdout.split())
    assert "scipy.spatial.transform._rotation" in loaded, done.stderr
    assert not loaded & {
        "scipy.spatial._kdtree",
        "scipy.linalg",
        "numpy.testing._private.utils",
        "numpy.ma.core",
        "scipy.constants",
    }


def test_the_warm_parent_loads_what_its_copies_want_of_it():
    done = _run(
        "from dhlab.grading.inside.warming.later import load\nload('scipy.spatial.transform')\n"
        "load('numpy.polynomial')\nprint(*sys.modules)"
    )
    loaded = set(done.stdout.split())
    assert {"scipy.spatial.transform._rotation", "numpy.polynomial.chebyshev"} <= loaded
    assert "scipy.linalg" not in loaded, done.stderr
