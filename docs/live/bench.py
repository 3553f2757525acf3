"""The bench: an arm as text, and a question about it; the answer as parts for a page."""

import json
import os
import re
import tempfile
import warnings
from html import escape

import numpy as np
from bridge import bundle_of

import dhlab as dh

LENGTHS = {"m": "m", "mm": "mm", "cm": "cm", "in": "in"}


def answer(asked):
    """The answer to a question, both as JSON.

    The question: ``arm`` and ``other`` are texts or names of the library, ``do`` is "read",
    "diagnose", "fk", "compare" or "convert". The answer: ``parts``, each a mime bundle under a
    title; ``yaml``, a table to save; ``open`` what has to be said of the text, with ``readings``;
    ``wrong``, a sentence.
    """
    asked = json.loads(asked)
    with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings(record=True) as noted:
        warnings.simplefilter("always", UserWarning)
        os.chdir(folder)
        try:
            found = Bench(asked).answered()
        except (ValueError, OSError) as error:
            found = {"wrong": plain(str(error))}
        finally:
            os.chdir("/course")
    found["notes"] = [str(one.message) for one in noted if one.category is UserWarning]
    return json.dumps(found)


class Bench:
    def __init__(self, asked):
        self.asked, self.parts, self.yaml = asked, [], ""

    def answered(self):
        text = self.asked["arm"].strip()
        if not text:
            raise ValueError(
                "Expected an arm, found an empty field; paste a table, a URDF or a program, or"
                " write a name of the library, such as ur5e."
            )
        if self.asked["do"] == "diagnose" and is_program(text) and not self.poses():
            return self.program(text)
        arm, asking = self.arm(text, self.asked.get("said", {}))
        if arm is None:
            return {"parts": self.parts, **asking}
        getattr(self, self.asked["do"])(arm)
        return {"parts": self.parts, "yaml": self.yaml, **asking}

    # ---- what was pasted

    def arm(self, text, said, shown=True):
        """The arm of a text, and what is open; None while several readings fit."""
        kind = kind_of(text)
        if kind == "name":
            return dh.load(text), {}
        if kind:
            with open(f"pasted.{kind}", "w", encoding="utf-8") as file:
                file.write(text)
            return (dh.read_urdf if kind == "urdf" else dh.load)(f"pasted.{kind}"), {}
        keys = ("order", "convention", "angle", "length")
        found = dh.recognise_table(text, **{k: said[k] for k in keys if said.get(k)})
        if not found.readings:
            raise ValueError(str(found))
        take = said.get("take")
        asking = {
            "open": [name for name in found.open if name in keys],
            "questions": list(found.questions),
            "readings": [reading.words for reading in found.readings],
        }
        if len(found.readings) > 1 and not take:
            if shown:
                self.say("What was read", str(found))
            return None, asking
        chosen = found.readings[min(int(take or 1), len(found.readings)) - 1]
        if shown:
            notes = [f"Note: {note}." for note in dict.fromkeys([*found.notes, *chosen.notes])]
            self.say("What was read", "\n".join([f"Read as {chosen.words}.", *notes]))
        return chosen.arm, asking

    def poses(self):
        return self.asked.get("poses", "").strip()

    # ---- what is asked

    def read(self, arm):
        self.show("The table", arm)
        self.keep(arm)

    def convert(self, arm):
        to = self.asked.get("to") or ("craig" if arm.table.convention == "standard" else "standard")
        arm = arm.to(to)
        self.show(f"The same arm, {to}", arm)
        self.keep(arm)

    def fk(self, arm):
        q = self.joints(arm)
        pose = arm.forward(q)
        xyz, rpy = dh.transform.to_xyz_rpy(pose)
        say = dh.printing.number
        words = [
            f"position    {'  '.join(say(1000 * v, 3) for v in xyz)} mm",
            f"roll, pitch, yaw  {'  '.join(say(np.rad2deg(v), 4) for v in rpy)}°"
            " (about fixed x, y, z)",
            dh.printing.matrix_text(pose),
        ]
        self.say("Where the end is", "\n".join(words))
        outside = [str(i) for i, inside in enumerate(arm.within_limits(q), 1) if not inside]
        if outside:
            self.say("", f"Outside the stated limits: joint {', '.join(outside)}.")
        self.part("The arm there", bundle_of(dh.explore(arm, q=q, length="mm")))

    def compare(self, arm):
        text = self.asked.get("other", "").strip()
        if not text:
            raise ValueError("Expected a second arm to compare with, found an empty field.")
        try:
            other, asking = self.arm(text, self.asked.get("otherSaid", {}), shown=False)
        except ValueError as error:
            raise ValueError(f"The other arm: {plain(str(error))}") from None
        if other is None:
            raise ValueError(
                "The second arm can be read in several ways: "
                + " ".join(asking["questions"])
                + " Read it alone first, save it as a table file, and paste that file."
            )
        self.part("Side by side", bundle_of(dh.compare(arm, other)))
        if len(arm) == len(other):
            both = dh.explore(arm, "compare", other=other, length="mm")
            self.part("Both in one view", bundle_of(both))

    def diagnose(self, arm):
        if not self.poses():
            raise ValueError(
                "Expected measured poses, found an empty field; paste one a line: the"
                f" {len(arm)} joint values, then x, y, z."
            )
        with open("poses.csv", "w", encoding="utf-8") as file:
            file.write(with_header(self.poses(), len(arm)))
        length, angle = self.asked["units"].split(",")
        q, poses = dh.read_poses("poses.csv", len(arm), length, angle, joints=arm.table.joints)
        free = {
            end: "free" if self.asked.get(f"free_{end}") else "fixed" for end in ("base", "tool")
        }
        found = dh.diagnose(arm, q, poses, **free)
        self.part("The doctor says", bundle_of(found))
        repaired = found.findings[0].repair if found.findings else found.fitted
        if repaired is not None and repaired != arm:
            self.show("Repaired", repaired)
            self.keep(repaired)

    def program(self, text):
        names = {}
        exec(compile(text, "<program>", "exec"), names)
        for name, kind in PROGRAMS.items():
            if callable(names.get(name)):
                self.part(name, bundle_of(dh.diagnose_function(names[name], kind)))
        return {"parts": self.parts, "yaml": ""}

    # ---- parts

    def joints(self, arm):
        text = self.asked.get("q", "").strip()
        cells = [cell for cell in re.split(r"[,;\s]+", text) if cell]
        try:
            q = np.array([float(cell) for cell in cells]) if cells else np.zeros(len(arm))
        except ValueError:
            raise ValueError(
                f"Joint values: expected {len(arm)} numbers, found {text[:60]!r}; write 0.5, not"
                " 1/2."
            ) from None
        if len(q) != len(arm):
            raise ValueError(f"Joint values: expected {len(arm)} numbers, found {len(q)}.")
        return np.where(arm.table.prismatic, q / 1000, np.deg2rad(q))

    def show(self, title, arm):
        self.part(title, {"text/html": arm._repr_html_(), "text/plain": repr(arm)})
        self.part("", bundle_of(dh.explore(arm)))

    def say(self, title, text):
        self.part(title, {"text/html": f'<pre tabindex="0">{escape(text)}</pre>'})

    def part(self, title, data):
        self.parts.append({"title": title, "data": data})

    def keep(self, arm):
        arm.save("kept.yaml", overwrite=True)
        with open("kept.yaml", encoding="utf-8") as file:
            self.yaml = file.read()


def with_header(text, n):
    """Measured poses as CSV: bare numbers get the header that they can only have."""
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    if not any(sign in text for sign in ",;\t"):  # as they were copied from a terminal
        lines = [",".join(line.split()) for line in lines]
    cells = lines[0].strip("[](){} ").split(",")
    if not all(NUMBER.fullmatch(cell.strip()) for cell in cells):
        return "\n".join(lines)
    joints = [f"q{i + 1}" for i in range(n)]
    if len(cells) != n + 3:
        known = ",".join([*joints, "x,y,z"])
        raise ValueError(
            f"Measured poses: expected {n + 3} numbers a line ({n} joint values, then x, y, z),"
            f" found {len(cells)}; where the rotation was measured too, name the columns in a first"
            f" line: {known},qx,qy,qz,qw or {known},roll,pitch,yaw or {known},rx,ry,rz."
        )
    lines = [line.strip("[](){} ") for line in lines]
    return "\n".join([",".join([*joints, *"xyz"]), *lines])


def plain(sentence):
    """A sentence of the library without what concerns a program."""
    sentence = re.sub(r"^(recognise_table|poses\.csv|read_poses|load): ", "", sentence)
    sentence = re.sub(r", or with \w+=\{.*?\}", "", sentence)
    return sentence[:1].upper() + sentence[1:]


NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?")
NAME = re.compile(r"(?=.*[A-Za-z])[\w .+/-]{2,40}")  # one line of a few words
PROGRAMS = {
    "dh_transform": "dh_transform",
    "dh_matrix": "dh_transform",
    "link_transform": "dh_transform",
    "forward_kinematics": "forward_kinematics",
    "fkine": "forward_kinematics",
    "fk": "forward_kinematics",
}


def is_program(text):
    return re.search(rf"^def ({'|'.join(PROGRAMS)})\b", text, re.MULTILINE) is not None


def kind_of(text):
    """What a text is a file of: its ending; "name" of the library; "" for anything else."""
    if "<robot" in text:
        return "urdf"
    if re.search(r"^\s*convention:", text, re.MULTILINE) and re.search(
        r"^\s*joints:", text, re.MULTILINE
    ):
        return "yaml"
    if re.match(r"\s*#\s*convention:", text):
        return "csv"
    return "name" if NAME.fullmatch(text) else ""
