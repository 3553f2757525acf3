"""Files broken in some 200 ways, from the command line and from Python: each must be one plain
sentence that says what was expected and found, with the file and the line; nothing is read silently
and nothing is a traceback. ``python benchmarks/bad_input.py`` prints what is not so.
"""

import argparse
import contextlib
import re
import sys
import tempfile
import warnings
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))
from terminal import dhlab

import dhlab as dh

TABLE = """name: two links
convention: standard
units: {length: mm, angle: deg}
joints:
  - {theta: 0, d: 100, a: 0, alpha: 90}
  - {theta: 0, d: 0, a: 400, alpha: 0}
base: {xyz: [0, 0, 10], rpy: [0, 0, 0]}
limits: [[-180, 180], [-90, 90]]
sign: [1, -1]
"""
CSV = """# convention: standard
theta_deg,d_mm,a_mm,alpha_deg,type,sign
0,100,0,90,revolute,1
0,0,400,0,revolute,-1
"""
POSES = """# units: mm,deg
q1,q2,x,y,z,rx,ry,rz
0,0,400,0,100,90,0,0
10,20,370,65,236,85,5,5
30,-20,325,188,-36,70,20,20
"""
SHEET = """name: two links
units: {length: mm, angle: deg}
axes:
  - {point: [0, 0, 100], direction: [0, 0, 1]}
  - {point: [0, 0, 100], direction: [0, -1, 0]}
end: {xyz: [400, 0, 100], rpy: [90, 0, 0]}
"""
URDF = """<?xml version="1.0"?>
<robot name="two">
  <link name="l0"/>
  <link name="l1"/>
  <link name="l2"/>
  <joint name="j1" type="revolute">
    <parent link="l0"/><child link="l1"/>
    <origin xyz="0 0 0.1" rpy="0 0 0"/><axis xyz="0 0 1"/>
    <limit lower="-3" upper="3" effort="1" velocity="1"/>
  </joint>
  <joint name="j2" type="revolute">
    <parent link="l1"/><child link="l2"/>
    <origin xyz="0.1 0 0.1" rpy="1.5 0 0"/><axis xyz="0 0 1"/>
  </joint>
</robot>
"""
MJCF = """<mujoco model="two">
  <worldbody>
    <body name="a" pos="0 0 0.1"><joint name="j1" axis="0 0 1"/>
      <body name="b" pos="0.4 0 0" euler="0 90 0"><joint name="j2" axis="0 1 0"/></body>
    </body>
  </worldbody>
</mujoco>
"""
GOOD = {
    "table.yaml": TABLE,
    "table.csv": CSV,
    "poses.csv": POSES,
    "sheet.yaml": SHEET,
    "arm.urdf": URDF,
    "model.xml": MJCF,
}
ESCAPE = "\x1b[31mred\x1b[0m"
LONG = "9x" * 500_000
NUMBERS = ("", "abc", "1,5", "1e999", ".nan", "90°", "1/2", "0x10", "1_000", "--3", LONG)
IN_YAML = (
    "",
    "abc",
    "1e999",
    ".nan",
    "90°",
    "1/2",
    "0x10",
    "1_000",
    "--3",
    "true",
    "[1]",
    "{a: 1}",
)
EVERYWHERE = {
    "empty": b"",
    "only spaces": b"  \n \n",
    "zeros": b"\0" * 100,
    "an image": b"\x89PNG\r\n\x1a\n" + bytes(range(256)),
    "UTF-16": "name: x".encode("utf-16"),
    "a zip": b"PK\x03\x04" + bytes(200),
    "words": b"this is a letter to my aunt",
    "a web page": b"<!DOCTYPE html><html><body>404</body></html>",
}


def replaced(old, *new):
    """Pairs of what stands in a good file and what is put in its place, with the line."""
    return [(old, text) for text in new]


CHANGES = {
    "table.yaml": [
        *replaced("d: 100", *(f"d: {text}" for text in IN_YAML), "d: '100'", f'd: "{ESCAPE}"'),
        *replaced("alpha: 90}", "alpha: 90, alpha: 0}", "alpha 90}", "alpha: 90", "beta: 90}", "}"),
        *replaced("theta: 0, d: 0,", "d: 0,", "theta: 0, d: 0, e: 1,", "theta: 0, d: 0,5,"),
        *replaced("convention: standard", "", "convention:", "convention: modified"),
        *replaced("convention: standard", "convention: 3", "convention: [standard]"),
        *replaced("convention: standard", "convention: DH", "konvention: standard"),
        *replaced("units: {length: mm, angle: deg}", "", "units:", "units: mm", "units: [mm, deg]"),
        *replaced("length: mm, ", "", "length: cm, ", "length: , ", "length: 5, ", "länge: mm, "),
        *replaced("angle: deg", "angle: grad", "angle: degrees", "angle: 1"),
        *replaced("xyz: [0, 0, 10]", "xyz: [0, 0]", "xyz: 5", "xyz:", "xyz: [0, 0, x]"),
        *replaced("rpy: [0, 0, 0]", "rpy: [0, 0, 0, 1]", "quat: [1, 0, 0, 0]", "rpy: [.inf, 0, 0]"),
        *replaced("[-180, 180], ", "", "[180, -180], ", "[-180], ", "180, ", "[-180, x], "),
        *replaced("[-180, 180], ", "[-180, .inf], ", "'none', ", "false, "),
        *replaced("sign: [1, -1]", "sign: [1]", "sign: [1, 2]", "sign: [1, x]", "sign: 1", "sign:"),
        *replaced("sign: [1, -1]", "coupling: [[1, 0]]", "coupling: [[1, 0], [0]]", "coupling: 1"),
        *replaced(
            "sign: [1, -1]", "coupling: [[0, 0], [0, 1]]", "colour: red", "sign: [1, -1]\n- 1"
        ),
        *replaced(
            "name: two links", "name: 3", "name:", "name: [a]", f'name: "{LONG}"', "name: &a x"
        ),
        *replaced("name: two links", 'name: "a\\eb"', "name: !!python/object:os.system x"),
        *replaced("joints:\n", "joints: 3\nsource:\n", "joints: []\nsource:\n", "\tjoints:\n"),
        *replaced(
            "  - {theta: 0, d: 100", "  - {type: turning, theta: 0, d: 100", "  - 3\n  - {d: 100"
        ),
    ],
    "table.csv": [
        *replaced("\n0,100,0,90", *(f"\n0,{text},0,90" for text in NUMBERS)),
        *replaced(
            "# convention: standard\n", "", "# convention: modified\n", "convention\n", "#\n"
        ),
        *replaced("theta_deg", "theta", "theta_grad", "alpha_deg", "θ_deg", "q_deg"),
        *replaced("d_mm", "d_cm", "d", "d_mm,d_mm"),
        *replaced(
            "revolute,1", "revolute", "turning,1", "revolute,0", "revolute,1,7", "revolute,x"
        ),
        *replaced("0,0,400,0,revolute,-1", "0,0,400,0", "0;0;400;0;revolute;-1", "0 0 400 0"),
        *replaced(",", ";", "\t"),
    ],
    "poses.csv": [
        *replaced("10,20,370", *(f"10,{text},370" for text in NUMBERS)),
        *replaced("q1,q2,x", "q1,q3,x", "q2,q2,x", "q1,x", "q1,q2,q3,x", "j1,j2,x", "q1_deg,q2,x"),
        *replaced("rx,ry,rz", "rx,ry", "rx,ry,rz,qw", "qw,qx,qy", "a,b,c", "qx,qy,qz"),
        *replaced("85,5,5", "85,5", "85,5,5,5", '"85,5,5', "85;5;5"),
        *replaced("# units: mm,deg\n", "", "# units: cm,deg\n", "# units: mm\n"),
        *replaced("q1,q2,x,y,z,rx,ry,rz\n", ""),
        *replaced("10,20,370,65,236,85,5,5\n", ESCAPE + "\n", LONG + "\n"),
    ],
    "sheet.yaml": [
        *replaced("[0, 0, 100], direction: [0, 0, 1]", "[0, 0], direction: [0, 0, 1]"),
        *replaced("direction: [0, 0, 1]", "direction: [0, 0, 0]", "direction: z", "direction: 1"),
        *replaced("direction: [0, 0, 1]", "along: [0, 0, 1]", "direction: [0, 0, x]", "direction:"),
        *replaced("- {point: [0, 0, 100], direction: [0, 0, 1]}", "- 3", "- [0, 0, 1]"),
        *replaced("axes:\n", "axes: 3\nlimits:\n", "axes: []\nlimits:\n"),
        *replaced("units: {length: mm, angle: deg}", "", "units: mm", "units: {length: mm}"),
        *replaced("end: {xyz: [400, 0, 100], rpy: [90, 0, 0]}", "", "end:", "end: 3"),
        *replaced("rpy: [90, 0, 0]", "rpy: [90]", "rpy: up", "limits: [1]"),
        *replaced(
            "{point: [0, 0, 100], direction: [0, 0",
            "{type: ball, point: [0, 0, 1], direction: [0, 0",
        ),
    ],
    "arm.urdf": [
        *replaced('xyz="0 0 0.1"', *(f'xyz="0 0 {text}"' for text in NUMBERS[1:])),
        *replaced('xyz="0 0 0.1"', 'xyz="0 0"', 'xyz="0,0,0.1"', 'xyz="0 0 ${h}"'),
        *replaced('<axis xyz="0 0 1"/>\n    <limit', '<axis xyz="0 0 0"/>\n    <limit'),
        *replaced('lower="-3"', 'lower="a"', 'lower="1 2"', 'lower="inf"'),
        *replaced('type="revolute">\n    <parent link="l0"', 'type="ball">\n    <parent link="l0"'),
        *replaced(
            'name="j1" type="revolute"', 'name="j1" type="floating"', 'name="j1"', 'type="fixed"'
        ),
        *replaced(
            '<parent link="l0"/>', "", '<parent link="l9"/>', '<parent link="l2"/>', "<parent/>"
        ),
        *replaced('<link name="l2"/>', "", '<link name="l1"/>', "<link/>", '<link name="l2">'),
        *replaced("</robot>", "", "</robt>", "</robot><robot/>", "&nbsp;</robot>"),
        *replaced(
            '<robot name="two">', '<sdf name="two">', "<robot", '<!DOCTYPE x><robot name="two">'
        ),
        *replaced('name="j2"', 'name="j1"', f'name="{LONG}" type2', 'name="a\x9b31mb" x'),
        *replaced('<link name="l0"/>', '<xacro:include filename="no.xacro"/><link name="l0"/>'),
    ],
    "model.xml": [
        *replaced('pos="0 0 0.1"', *(f'pos="0 0 {text}"' for text in NUMBERS[1:8])),
        *replaced('axis="0 0 1"', 'axis="0 0 0"', 'axis="0 1"', 'type="ball"', 'type="free"'),
        *replaced(
            "</worldbody>", "", "<include file='no.xml'/></worldbody>", "<frame/></worldbody>"
        ),
        *replaced("mujoco", "sdf"),
    ],
}
# what was refused and is right: these must be read
READ = {
    "arm.urdf": [
        URDF.replace('version="1.0"', 'version="1.0" encoding="ISO-8859-1"')
        .replace("two", "zwö")
        .encode("latin-1")
    ],
    "table.yaml": [
        ("# -*- coding: latin-1 -*-\n" + TABLE.replace("two", "zwö")).encode("latin-1"),
        b"\xef\xbb\xbf" + TABLE.encode(),
    ],
    "table.csv": [CSV.replace("\n", "\r\n").encode()],
}


def cases():
    """(name of the case, file, bytes, the line that must be named or None)."""
    for file, text in GOOD.items():
        for name, raw in EVERYWHERE.items():
            yield f"{file}: {name}", file, raw, None
        lines = text.splitlines(keepends=True)
        yield f"{file}: cut off", file, "".join(lines[: len(lines) // 2]).encode(), None
    for file, changes in CHANGES.items():
        for old, new in changes:
            text = GOOD[file]
            if old not in text:
                raise ValueError(f"{file}: {old!r} is not in it")
            changed = text.replace(old, new) if len(old) == 1 else text.replace(old, new, 1)
            told = "" if len(new) < 80 else f"… ({len(new)})"
            line = text[: text.index(old)].count("\n") + 1 + old.startswith("\n")
            named = file not in ("model.xml", "arm.urdf") and new and len(old) > 1
            yield (
                f"{file}: {old!r} -> {new[:80]!r}{told}",
                file,
                changed.encode(),
                line if named else None,
            )


def commands(file, folder):
    """How a file is read, from a terminal and from Python."""
    table, path = folder / "table.yaml", folder / file
    if file == "poses.csv":
        yield ("doctor", table, path), lambda: dh.read_poses(path, 2, "mm", "deg")
    elif file == "arm.urdf":
        yield ("from-urdf", path), lambda: dh.read_urdf(path)
    elif file == "model.xml":
        yield ("from-urdf", path), lambda: dh.read_mjcf(path)
    elif file == "sheet.yaml":
        yield ("from-axes", path), lambda: dh.read_axes(path).arm()
    else:
        yield ("fk", path), lambda: dh.load(path)


def faults(name, file, raw, line, folder):
    """What is wrong with the answers to one broken file; nothing where all is well."""
    for good, text in GOOD.items():
        (folder / good).write_text(text, encoding="utf-8")
    (folder / file).write_bytes(raw)
    for typed, read in commands(file, folder):
        try:
            done = dhlab(*typed)
        except Exception as error:
            yield f"a traceback: {type(error).__name__}: {error}"
            continue
        if done.returncode != 2:
            yield f"exit status {done.returncode}: {done.stdout[:300]!r}"
            continue
        sentence = done.stderr.strip()
        yield from _unlike(sentence, file, line, folder)
        # in Python a line # units: is not looked at, since the units are given
        if file == "poses.csv" and "units" in name:
            continue
        try:
            with contextlib.redirect_stderr(None):
                read()
        except ValueError as error:
            yield from (f"Python: {said}" for said in _unlike(str(error), file, line, folder))
        except Exception as error:
            yield f"Python: {type(error).__name__}: {error}"
        else:
            yield "Python: read without a word"


def _unlike(sentence, file, line, folder):
    """In what a sentence is not as it should be."""
    if "\n" in sentence:
        yield f"not one line: {sentence[:300]!r}"
    if len(sentence) > 700:
        yield f"{len(sentence)} characters long: {sentence[:200]!r}…"
    if re.search(r"[\x00-\x08\x0b-\x1f\x7f-\x9f]", sentence):
        yield f"control characters: {sentence[:300]!r}"
    if file not in sentence:
        yield f"the file is not named: {sentence[:300]}"
    # of brackets that are not closed, a line behind is told
    lines = f"{line}|{line + 1}" if line and "this is no YAML" in sentence else line
    if line and not re.search(rf"\bline ({lines})\b", sentence):
        yield f"line {line} is not named: {sentence[:300]}"
    if not re.search(r"expected|unknown key|no [a-z]+;|this is no", sentence):
        yield f"it is not said what was expected: {sentence[:300]}"
    if "put it in quotes" in sentence and "found nothing" in sentence:
        yield f"quotes will not help: {sentence[:300]}"


def refused(folder):
    """Of what is right, though unusual, that which is not read."""
    for file, texts in READ.items():
        for raw in texts:
            (folder / file).write_bytes(raw)
            for typed, _ in commands(file, folder):
                done = dhlab(*typed)
                if done.returncode:
                    yield f"{file}: {raw[:60]!r}: {done.stderr.strip()[:300]}"
    q = np.random.default_rng(0).uniform(-2, 2, (120_000, 2)).round(6)
    rows = "\n".join(
        f"{a},{b},{0.4 * np.cos(a):.9f},{0.4 * np.sin(a):.9f},0.123456789012" for a, b in q
    )
    (folder / "many.csv").write_text("q1,q2,x,y,z\n" + rows)
    try:
        if len(dh.read_poses(folder / "many.csv", 2)[0]) != len(q):
            yield "many.csv: not all poses were read"
    except ValueError as error:
        yield f"many.csv: {error}"


def main():
    """Every case, and a line for each that is not as it should be."""
    warnings.simplefilter("ignore")
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--show", action="store_true", help="print every sentence as well")
    options = parser.parse_args()
    count, wrong = 0, 0
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        for name, file, raw, line in cases():
            count += 1
            found = list(faults(name, file, raw, line, folder))
            wrong += bool(found)
            if found:
                print(f"{name}\n   " + "\n   ".join(found))
            elif options.show:
                typed, _ = next(commands(file, folder))
                print(f"{name}\n   {dhlab(*typed).stderr.strip()}")
        for said in refused(folder):
            wrong += 1
            print(f"must be read: {said}")
    print(f"{count} broken files, each from the command line and from Python: {wrong} not as they")
    print("should be")


if __name__ == "__main__":
    main()
