"""Every arm of the library against its sources, by programs that are not ours.

    python benchmarks/arms.py             # the table: arm, sources, worst deviation over 200 q
    python benchmarks/arms.py --write     # writes it into docs/arms.md

A URDF is moved by pinocchio (where it is not installed, by tests/oracles.py), another publisher's
table by the product of its elementary matrices (tests/oracles.py). The URDF that a table is derived
from must agree as it stands; of the others, base and tool are fitted, and zeros and signs are those
that :func:`dhlab.geometry.shapes.same_shape` finds.
"""

import argparse
import pathlib
import sys
from functools import partial

import numpy as np

import dhlab as dh
from dhlab.formats.files import read_text, write_text
from dhlab.geometry.shapes import same_shape
from dhlab.robots import entry

HERE = pathlib.Path(__file__).parent
sys.path[:0] = [str(HERE), str(HERE.parent / "tests")]
from arm_files import chain, from_chain, sources, urdf_text  # noqa: E402
from oracles import chain_pose, elementary_pose, fit_base_and_tool, pose_errors  # noqa: E402

PAGE = HERE.parent / "docs" / "arms.md"
BEGIN, END = "<!-- made by benchmarks/arms.py --write -->", "<!-- until here -->"
ROUGH = 2e-3, np.deg2rad(0.5)  # m, rad: what two sources of one arm may be apart in this table


def values(arm, m):
    """m joint values within the limits that are stated, else within half a turn."""
    limits = arm.limits or [None] * len(arm)
    low, high = np.array([pair or (-np.pi, np.pi) for pair in limits]).T
    return np.random.default_rng(0).uniform(low, high, (m, len(arm)))


def moved_chain(name):
    """The function from q (m, n) to the end poses of a stored chain."""
    joints = chain(name)["joints"]
    try:
        import pinocchio
    except ImportError:
        return lambda q: np.array([chain_pose(joints, row) for row in q])
    limited = [{"lower": -7.0, "upper": 7.0, **joint} for joint in joints]  # it wants limits
    model = pinocchio.buildModelFromXML(urdf_text(limited))
    data, frame = model.createData(), model.getFrameId(f"link_{len(joints)}")
    free = [joint.nq == 2 for joint in model.joints[1:]]  # a continuous joint has cos and sin

    def pose(row):
        parts = [[np.cos(v), np.sin(v)] if two else [v] for v, two in zip(row, free)]
        pinocchio.framesForwardKinematics(model, data, np.concatenate(parts))
        return data.oMf[frame].homogeneous

    return lambda q: np.array([pose(row) for row in q])


def moved_table(arm, q):
    """The end poses of another publisher's table."""
    return np.array([elementary_pose(arm.table, row) for row in arm.joint_values(q)])


def deviation(arm, other, pose, m=200, exact=False):
    """Largest distance (mm) and angle (deg) over m q, and what had to be fitted; None where the
    two are not one arm. ``other`` is the model of the source, ``pose`` what moves it.
    """
    q = values(arm, m)
    if exact:
        distance, angle = pose_errors(arm.forward(q), pose(q))
        return distance * 1000, np.rad2deg(angle), ""
    same = same_shape(other, arm, length=ROUGH[0], angle=ROUGH[1])
    if same is None:
        return None
    # arm(q) = base · other(sign · q + offset) · tool
    model, judged = arm.forward(q), pose(q * same.zeros.sign + same.zeros.offset)
    B, E = fit_base_and_tool(model, judged)
    distance, angle = pose_errors(B @ model @ E, judged)
    fitted = "base, tool" + (", zeros" if same.zeros.says_something else "")
    return distance * 1000, np.rad2deg(angle), fitted


def compared(key, m=200):
    """(source, licence, deviation) for every source of an arm, its own first."""
    said, best = sources()[key], next(iter(entry(key).tables.values()))
    for i, name in enumerate(
        [*([said["chain"]] if "chain" in said else []), *said.get("second", [])]
    ):
        own = i == 0 and "table" not in said and said.get("made", True)
        found = deviation(best, from_chain(name).arm, moved_chain(name), m, own)
        yield f"URDF, {chain(name)['source']}", chain(name)["licence"], found
    for other in said.get("others", []):
        arm = entry(key).tables[other["name"]]
        plain = dh.Arm(
            arm.table, sign=arm.sign
        )  # joint by joint; couplings have a test of their own
        publisher = (
            other["from"] if "source" in other else f"robotkinematicscatalogue {other['from']}"
        )
        yield publisher, "", deviation(best, plain, partial(moved_table, plain), m)


def rows(keys, m=200):
    """The lines of the table."""
    for key in keys:
        said = sources()[key]
        found = list(compared(key, m))
        first, second = (*found, None, None)[:2]
        if "table" in said or not said.get("made", True):
            first, second = ("a published table", "", None), first
        cells = [key, entry(key).name, first[0] if first else "", _measured(first)]
        cells += [
            second[0] if second else "—",
            _measured(second),
            entry(key).licence or (found[0][1] if found else ""),
        ]
        yield cells


def _measured(source):
    if source is None or source[2] is None:
        return "" if source is None or source[0] == "a published table" else "another arm"
    distance, angle, fitted = source[2]
    return f"{_short(distance)} mm, {_short(angle)}°{f' ({fitted})' if fitted else ''}"


def _short(value):
    """Two digits, or 0 below a ten thousandth."""
    return "0" if value < 1e-4 else f"{value:.2g}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--write", action="store_true", help="write the table into docs/arms.md")
    parser.add_argument("--arms", default="", help="only these, with commas")
    parser.add_argument("-m", type=int, default=200, help="joint values for each source")
    given = parser.parse_args()
    keys = given.arms.split(",") if given.arms else sorted(sources())
    head = ["arm", "", "first source", "deviation", "second source", "deviation", "licence"]
    lines = [head, ["---"] * len(head), *rows(keys, given.m)]
    text = "\n".join("| " + " | ".join(line) + " |" for line in lines)
    print(text)
    if given.write:
        before, _, rest = read_text(PAGE, "the page").partition(BEGIN)
        after = rest.partition(END)[2]
        write_text(PAGE, f"{before}{BEGIN}\n\n{text}\n\n{END}{after}", overwrite=True)


if __name__ == "__main__":
    main()
