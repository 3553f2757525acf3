"""The library files of the arms that are derived, made again from their sources: `arm_sources.yaml`
says what each is made of; the numbers of the URDF files are in `tests/data`.

    python benchmarks/arm_files.py              # all
    python benchmarks/arm_files.py ur20 gp7     # these
"""

import argparse
import json
import pathlib
import tempfile
from dataclasses import replace
from functools import cache
from xml.sax.saxutils import quoteattr

import numpy as np
import yaml

import dhlab as dh
from dhlab.formats.files import write_text
from dhlab.robots.adding import Given, agreement, library_text, read_given
from dhlab.robots.drawing_up import topology, zero_pose
from dhlab.robots.entries import FOLDER
from dhlab.robots.index import write as write_index

HERE = pathlib.Path(__file__).parent
CHAINS = [HERE.parent / "tests" / "data" / folder for folder in ("arms", "chains")]
CATALOGUE = "PyPI robotkinematicscatalogue 1.1.2 (AGPL-3; numbers only)"  # where most others are


@cache
def sources():
    """What `arm_sources.yaml` says, by the arm's name; read by libyaml where it is there, since
    every process of the tests reads it.
    """
    text = (HERE / "arm_sources.yaml").read_text("utf-8")
    return yaml.load(text, getattr(yaml, "CSafeLoader", yaml.SafeLoader))


@cache
def chain(name):
    """The numbers of a stored chain, with where they are from."""
    path = next(folder / f"{name}.json" for folder in CHAINS if (folder / f"{name}.json").exists())
    return json.loads(path.read_text("utf-8"))


def urdf_text(joints):
    """A URDF of a chain's joints, every number as it is stored."""
    lines = ['<robot name="chain">', '  <link name="link_0"/>']
    for i, joint in enumerate(joints):
        xyz, rpy = (" ".join(map(repr, joint[key])) for key in ("xyz", "rpy"))
        lines += [
            f'  <link name="link_{i + 1}"><inertial><mass value="1"/><inertia ixx="1" ixy="0"'
            ' ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>',
            f'  <joint name={quoteattr(joint["name"])} type="{joint["type"]}">',
            f'    <parent link="link_{i}"/><child link="link_{i + 1}"/>',
            f'    <origin xyz="{xyz}" rpy="{rpy}"/>',
        ]
        if joint["type"] != "fixed":
            lines.append(f'    <axis xyz="{" ".join(map(repr, joint["axis"]))}"/>')
            lower, upper = joint.get("lower"), joint.get("upper")
            if lower is not None:
                lines.append(
                    f'    <limit lower="{lower!r}" upper="{upper!r}" effort="1" velocity="1"/>'
                )
        lines.append("  </joint>")
    return "\n".join([*lines, "</robot>"]) + "\n"


def from_chain(name):
    """The arm of a stored chain, as the library draws it up."""
    stored = chain(name)
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "chain.urdf"
        path.write_text(urdf_text(stored["joints"]), encoding="utf-8")
        given = read_given(path, "")
    return replace(given, source=f"{_where(stored)}; table derived from the joints' axes")


def _where(stored):
    version = f", commit {stored['version'][:7]}" if stored.get("version") else ""
    ends = f", {stored['base']} to {stored['tip']}" if "base" in stored else ""
    return f"{stored['source']}{version}: {stored['path']}{ends}"


def from_table(said, limits=None):
    """The arm of a table in `arm_sources.yaml`; rows theta, d, a, alpha in degrees and mm."""
    rows = np.array(said["rows"], float) / [1, 1000, 1000, 1]
    table = getattr(dh.DHTable, said["convention"])(rows, angle="deg")
    coupling = _coupling(said["coupling"], len(rows)) if said.get("coupling") else None
    arm = dh.Arm(table, sign=said.get("sign"), limits=limits, coupling=coupling)
    return Given(arm, said["source"], arm.forward, "from this table", said.get("note", ""))


def _coupling(factor, n):
    """Joint 3 that the controller counts with so much of joint 2."""
    matrix = np.eye(n)
    matrix[2, 1] = factor
    return matrix


def tables(key):
    """The tables of an arm's file, the best first, and what its second source says."""
    said = sources()[key]
    derived = from_chain(said["chain"]) if "chain" in said else None
    found, second = {}, []
    if "table" in said:
        best = from_table(said["table"], derived and derived.arm.limits)
        found[said["table"]["name"]] = best
    else:
        best = found["derived"] = derived
    if "coupling" in said:
        found["controller"] = _as_controller(best, said["coupling"])
    for other in said.get("others", []):
        given = from_table({"source": f"{CATALOGUE}: {other['from']}", **other})
        words = agreement(best.arm, given.arm)
        if words is None:
            raise ValueError(f"{key}: {other['name']} contradicts the best table")
        publisher = "" if "source" in other else "robotkinematicscatalogue "
        second.append(f"{publisher}{other['from']}: {words}")
        found[other["name"]] = replace(given, note=words)
    checked = [said["chain"]] if "table" in said and "chain" in said else []
    for name in [*checked, *said.get("second", [])]:
        words = agreement(best.arm, from_chain(name).arm)
        if words is None:
            raise ValueError(f"{key}: the chain {name} contradicts the best table")
        second.insert(0, f"{_where(chain(name))}: {words}")
    return found, ". ".join(second)


def _as_controller(given, factor):
    """The same arm for the numbers that the controller shows, joint 3 coupled with joint 2."""
    arm = replace(given.arm, coupling=_coupling(factor, len(given.arm)), limits=None)
    sign = "+" if factor > 0 else "-"
    return Given(
        arm,
        f"{given.source}; joint 3 coupled as the controller counts it",
        lambda q: given.pose(arm.joint_values(q)),
        given.judge,
        f"for joint values as the controller shows them: joint 3 is q3 {sign} q2, so that q3 alone"
        " says how the forearm leans, whatever joint 2 does",
    )


def text_of(key):
    """The whole text of an arm's library file."""
    said = sources()[key]
    found, second = tables(key)
    best = next(iter(found.values())).arm
    stored = chain(said["chain"]) if "chain" in said else {}
    licence = said.get("licence") or stored.get("licence", "")
    links = said.get("links") or [f"https://github.com/{stored['source'].removeprefix('github ')}"]
    flange = said.get("flange") or (
        f"the end is the URDF's link {stored['tip']}, in its {stored['base']}" if stored else ""
    )
    return library_text(
        found,
        name=said["name"],
        maker=said["maker"],
        also=said.get("also", []),
        topology=topology(best),
        zero=zero_pose(best),
        flange=flange,
        ambiguity=said.get("ambiguity", ""),
        licence=licence,
        links=links,
        second=second,
    )


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("keys", nargs="*")
    for key in parser.parse_args().keys or [k for k, s in sources().items() if s.get("made", True)]:
        write_text(FOLDER / f"{key}.yaml", text_of(key), overwrite=True)
        print(key)
    write_index()


if __name__ == "__main__":
    main()
