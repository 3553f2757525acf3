"""Real URDF files from PyPI packages through ``read_urdf``, judged by pinocchio and PyBullet.
``python benchmarks/urdf.py`` prints Markdown.

Needs the extra oracles, and the package example-robot-data (6.0.0). Every chain from the
root to every leaf is read.
"""

import argparse
import re
import shutil
import site
import tempfile
import time
import warnings
from collections import Counter
from pathlib import Path
from xml.etree import ElementTree

import numpy as np

from dhlab.formats.descriptions.urdf import read_urdf, to_urdf

PACKAGES = Path(site.getsitepackages()[0])
FOLDERS = {
    "example-robot-data 6.0.0": PACKAGES / "cmeel.prefix/share/example-robot-data/robots",
    "rtb-data 2.0.0": PACKAGES / "rtbdata/xacro",
    "pybullet 3.2.7": PACKAGES / "pybullet_data",
}
# of pybullet_data
NO_ROBOTS = ("random_urdfs", "objects", "lego", "domino", "jenga", "table", "testdata")
# by PyBullet too
ARMS = {
    "franka_panda/panda.urdf": "panda_link8",
    "kuka_iiwa/model.urdf": None,
    "panda_description/urdf/panda.urdf": "panda_link8",
    "kuka_lbr_iiwa/urdf/lbr_iiwa_14_r820.urdf": "tool0",
    "unimation_puma560_description/urdf/puma560_robot.urdf": None,
    "ur_description/urdf/ur5_robot.urdf": "tool0",
    "ur_description/urdf/ur10_robot.urdf": "tool0",
    "kr6r700sixx.xacro": "tool0",
    "kinova_description/robots/kinova.urdf": None,
    "abb_irb140_description/urdf/irb140.urdf": None,
}


def files(work):
    """(package, name, path of a plain URDF), xacro files expanded."""
    for package, folder in FOLDERS.items():
        for path in sorted(folder.rglob("*.urdf")):
            if not set(NO_ROBOTS) & set(path.relative_to(folder).parts):
                yield package, str(path.relative_to(folder)), path
    for path in sorted(FOLDERS["rtb-data 2.0.0"].rglob("*.xacro")):
        out = expanded(path, work)
        if out:
            yield "rtb-data 2.0.0", str(path.relative_to(FOLDERS["rtb-data 2.0.0"])), out


def expanded(path, work):
    """The URDF of a xacro file of rtb-data, or None when it is only a part of a robot; its packages
    lie in folders of other names.
    """
    import xacro

    tree = work / "xacro"
    if not tree.exists():
        shutil.copytree(
            FOLDERS["rtb-data 2.0.0"],
            tree,
            ignore=shutil.ignore_patterns("*.stl", "*.dae", "*.STL", "*.DAE", "*.obj"),
        )
        folders = {folder.name: folder for folder in tree.rglob("*") if folder.is_dir()}
        for part in tree.rglob("*.xacro"):
            text = part.read_text(encoding="utf-8")
            part.write_text(
                re.sub(
                    r"\$\(find ([\w-]+)\)",
                    lambda m: str(
                        folders.get(m[1], folders.get(m[1].replace("_support", ""), m[0]))
                    ),
                    text,
                )
            )
    try:
        text = xacro.process_file(
            str(tree / path.relative_to(FOLDERS["rtb-data 2.0.0"]))
        ).toprettyxml()
    except Exception:  # a macro without its caller, or a package that is not there
        return None
    if "<joint" not in text or "${" in text:
        return None
    out = work / (path.name + ".urdf")
    out.write_text(text, encoding="utf-8")
    return out


def joints_above(path):
    """From each link to the joint that carries it; empty when the file is no XML."""
    try:
        root = ElementTree.fromstring(path.read_bytes())
    except ElementTree.ParseError:
        return {}
    return {joint.find("child").get("link"): joint for joint in root.findall("joint")}


def leaves(path):
    """The links that carry nothing."""
    above = joints_above(path)
    return [
        link
        for link in above
        if link not in {joint.find("parent").get("link") for joint in above.values()}
    ]


def chain(path, tip):
    """The root above a link, and the names of the moving joints between them."""
    above, names = joints_above(path), []
    while tip in above:
        if above[tip].get("type") != "fixed":
            names.append(above[tip].get("name"))
        tip = above[tip].find("parent").get("link")
    return tip, names[::-1]


class Pinocchio:
    def __init__(self, path):
        import pinocchio

        self.pinocchio, self.model = pinocchio, pinocchio.buildModelFromUrdf(str(path))
        self.data = self.model.createData()

    def poses(self, base, tip, names, q):
        ids = [self.model.getJointId(name) for name in names]
        ends = [self.model.getFrameId(name) for name in (base, tip)]
        if max(ids) >= self.model.njoints or max(ends) >= self.model.nframes:
            raise ValueError("pinocchio does not know a joint or link of the chain")
        poses = np.empty((len(q), 4, 4))
        for k, one in enumerate(q):
            values = self.pinocchio.neutral(self.model)
            for i, value in zip(ids, one):
                joint = self.model.joints[i]
                values[joint.idx_q : joint.idx_q + joint.nq] = (
                    (np.cos(value), np.sin(value)) if joint.nq == 2 else value
                )
            self.pinocchio.framesForwardKinematics(self.model, self.data, values)
            poses[k] = (self.data.oMf[ends[0]].inverse() * self.data.oMf[ends[1]]).homogeneous
        return poses


def bare(path, work):
    """The same robot without shapes, which PyBullet would look for on disk, and with a mass for
    every link.
    """
    root = ElementTree.fromstring(path.read_bytes())
    for link in root.findall("link"):
        for part in list(link):
            link.remove(part)
        inertial = ElementTree.SubElement(link, "inertial")
        ElementTree.SubElement(inertial, "mass", value="1")
        ElementTree.SubElement(
            inertial, "inertia", ixx="1", ixy="0", ixz="0", iyy="1", iyz="0", izz="1"
        )
    (work / "bare.urdf").write_bytes(ElementTree.tostring(root))
    return work / "bare.urdf"


def by_pybullet(path, tip, names, q):
    import pybullet

    client = pybullet.connect(pybullet.DIRECT)
    try:
        body = pybullet.loadURDF(str(path), useFixedBase=True, physicsClientId=client)
        info = [
            pybullet.getJointInfo(body, k, physicsClientId=client)
            for k in range(pybullet.getNumJoints(body, physicsClientId=client))
        ]
        joints = {joint[1].decode(): joint[0] for joint in info}
        links = {joint[12].decode(): joint[0] for joint in info}
        poses = np.tile(np.eye(4), (len(q), 1, 1))
        for k, one in enumerate(q):
            for name, value in zip(names, one):
                pybullet.resetJointState(body, joints[name], value, physicsClientId=client)
            state = pybullet.getLinkState(
                body, links[tip], computeForwardKinematics=True, physicsClientId=client
            )
            poses[k, :3, :3], poses[k, :3, 3] = (
                np.reshape(pybullet.getMatrixFromQuaternion(state[5]), (3, 3)),
                state[4],
            )
        return poses
    finally:
        pybullet.disconnect(client)


def error(T, S):
    """Largest distance (m) and angle (rad)."""
    chord = np.linalg.norm(T[:, :3, :3] - S[:, :3, :3], axis=(1, 2)) / np.sqrt(2)
    return np.array(
        [
            np.linalg.norm(T[:, :3, 3] - S[:, :3, 3], axis=1).max(),
            2 * np.arcsin(np.minimum(chord / 2, 1)).max(),
        ]
    )


def judged(path, work, rng, refused):
    """Per file: chains read, joints, and worst errors: standard, Craig, written and read back;
    refusals are counted by their reason.
    """
    try:
        model = Pinocchio(path)
    except Exception as fault:
        refused[f"pinocchio cannot load the file ({type(fault).__name__})"] += 1
        return None
    worst, chains, joints, warned = np.zeros((3, 2)), 0, 0, 0
    for leaf in leaves(path):
        base, names = chain(path, leaf)
        try:
            with warnings.catch_warnings(record=True) as said:
                warnings.simplefilter("always")
                arm = read_urdf(path, tip=leaf, parallel=0)
                craig = arm.to("craig")
                to_urdf(arm, work / "back.urdf", overwrite=True)
                back = read_urdf(work / "back.urdf")
            q = rng.uniform(-np.pi, np.pi, (100, len(arm)))
            T = model.poses(base, leaf, names, q)
        except ValueError as fault:
            refused[reason(str(fault))] += 1
            continue
        worst = np.maximum(worst, [error(T, other.forward(q)) for other in (arm, craig, back)])
        chains, joints, warned = chains + 1, max(joints, len(arm)), warned + bool(said)
    return chains, joints, worst, warned


def reason(words):
    for part in (
        "fixed joints only",
        "mimics",
        "floating",
        "planar",
        "no type",
        "found a loop",
        "pinocchio does not",
        "document type",
        "finite",
    ):
        if part in words:
            return part
    return words[-120:]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="one file in ten")
    quick = parser.parse_args().quick
    rng, refused, rows, bullet, start = np.random.default_rng(0), Counter(), [], [], time.time()
    with tempfile.TemporaryDirectory() as folder:
        work = Path(folder)
        found = list(files(work))
        for package, name, path in found[:: 10 if quick else 1]:
            result = judged(path, work, rng, refused)
            if result and result[0]:
                rows.append((package, name, *result))
            tip = next((tip for end, tip in ARMS.items() if name.endswith(end)), "none")
            if tip != "none":
                tip = tip or leaves(path)[0]
                arm = read_urdf(path, tip=tip, parallel=0)
                q = rng.uniform(-np.pi, np.pi, (100, len(arm)))
                bullet.append(
                    (
                        name,
                        error(
                            by_pybullet(bare(path, work), tip, chain(path, tip)[1], q),
                            arm.forward(q),
                        ),
                    )
                )
    report(rows, bullet, refused, len(found), time.time() - start)


def report(rows, bullet, refused, files_found, seconds):
    print(
        f"# read_urdf on real files: {files_found} files, 100 random q per chain, judge pinocchio"
        f" ({seconds:.0f} s)\n"
    )
    print(
        "| package | files | chains | joints at most | standard m | rad | Craig m | rad | to_urdf"
        " and back m | rad | chains with a warning of nearly parallel axes |"
    )
    print("|---|---|---|---|---|---|---|---|---|---|---|")
    for package in FOLDERS:
        some = [row for row in rows if row[0] == package]
        if some:
            worst = np.max([row[4] for row in some], axis=0)
            print(
                f"| {package} | {len(some)} | {sum(row[2] for row in some)} |"
                f" {max(row[3] for row in some)} | "
                + " | ".join(f"{value:.1e}" for value in worst.ravel())
                + f" | {sum(row[5] for row in some)} |"
            )
    print(
        "\n| worst files | chains | standard m | rad | Craig m | rad |\n|---|---|---|---|---|---|"
    )
    for row in sorted(rows, key=lambda row: -row[4].max())[:12]:
        print(
            f"| {row[1]} | {row[2]} | "
            + " | ".join(f"{value:.1e}" for value in row[4][:2].ravel())
            + " |"
        )
    print("\n| by PyBullet (rounds to some 1e-8) | m | rad |\n|---|---|---|")
    for name, (m, rad) in bullet:
        print(f"| {name} | {m:.1e} | {rad:.1e} |")
    print("\n| not read, or not judged | chains |\n|---|---|")
    for words, count in refused.most_common():
        print(f"| {words} | {count} |")


if __name__ == "__main__":
    main()
