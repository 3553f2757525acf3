// The real robot over the frames: STL files of the links, alone or with the URDF that says where they sit. They stay in the browser.

import { choice } from "../controls.js";
import { h, write } from "../dom.js";
import { frames, jointPlaces } from "../kinematics.js";
import { IDENTITY, cross, dot, inverse, length, product, sub, unit } from "../matrix.js";
import { robot } from "./robot.js";
import { extent, meshOf, stl } from "./stl.js";

const MANY = 25; // times the arm's size: then a file is in millimetres

export class Body {
  constructor({ stage, mode, host }) {
    Object.assign(this, { stage, mode, host, arm: host.data.arm, parts: [], files: [], where: "assembled" });
    this.said = h("p", { role: "status" });
    const given = h("input", { type: "file", multiple: true, accept: ".stl,.urdf,.xml", "aria-label": "STL files of the links, and the URDF", onchange: () => this.take([...given.files]) });
    const where = choice("Without a URDF, a link's file is drawn", "where", [["assembled", "As assembled at q = 0"], ["own", "In its own DH frame"]], "assembled", (to) => {
      this.where = to;
      this.place();
    });
    this.element = h("details", { class: "edit" }, h("summary", {}, "Show the real robot"), h("div", { class: "below" },
      h("p", { class: "hint" }, "Drop the STL files of the links on the picture, with their URDF where there is one. Without it, the last number in a file's name says its link: 0 is the base. Nothing leaves the browser."),
      given, where.element, this.said));
    stage.element.addEventListener("dragover", (event) => event.preventDefault());
    stage.element.addEventListener("drop", (event) => {
      event.preventDefault();
      this.element.open = true;
      this.take([...event.dataTransfer.files]);
    });
  }

  async take(files) {
    this.files = await Promise.all(files.map(async (file) => ({ name: file.name.toLowerCase(), data: await file.arrayBuffer() })));
    this.place();
  }

  place() {
    const { arm } = this, zero = frames(arm, arm.sign.map(() => 0)), size = this.mode.size, said = [];
    const shapes = new Map(this.files.filter(({ name }) => name.endsWith(".stl")).map(({ name, data }) => [name, stl(data)]));
    for (const [name, points] of shapes) if (!points) said.push(`${name} is no STL file.`);
    const description = this.files.find(({ name }) => /\.(urdf|xml)$/.test(name)), found = description && robot(new TextDecoder().decode(description.data), arm.rows.length);
    if (description && !found) said.push(`${description.name}: expected a URDF, found no <robot>; expand a xacro first.`);
    const links = found ? found.links : this.numbered(shapes, zero);
    this.parts = links.filter(({ file }) => shapes.get(file)).map(({ file, scale, pose, joint }) => {
      const points = shapes.get(file), unitOf = !found && extent(points) > MANY * size ? 1e-3 : 1;
      return { frame: joint, pose: found ? product(inverse(zero[joint]), pose) : pose, mesh: meshOf(points, (scale ?? [1, 1, 1]).map((v) => v * unitOf)) };
    });
    if (found && !this.agrees(found.axes)) said.push("At q = 0 this URDF's joint axes lie elsewhere than this table's, so the links may sit wrong.");
    const missing = found ? found.links.filter(({ file }) => !shapes.has(file)).map(({ file }) => file) : [];
    if (missing.length) said.push(`Not among the files: ${[...new Set(missing)].slice(0, 5).join(", ")}.`);
    write(this.said, [this.files.length ? `${this.parts.length} parts are drawn.` : "", ...said].join(" ").trim());
    this.stage.redraw();
  }

  numbered(shapes, zero) {
    return [...shapes.keys()].map((file) => {
      const joint = Number(file.match(/(\d+)\D*$/)?.[1] ?? 0);
      return joint < zero.length ? { file, joint, pose: this.where === "own" ? IDENTITY : inverse(zero[joint]) } : { file: "", joint: 0 };
    });
  }

  // Whether every joint axis of the URDF is the table's, as a line, at q = 0.
  agrees(axes) {
    const places = jointPlaces(this.arm.convention, frames(this.arm, this.arm.sign.map(() => 0)));
    return axes.length === places.length && axes.every(({ at, along }, i) => {
      const z = places[i].along, way = sub(at, places[i].at);
      return Math.abs(dot(unit(along), z)) > 0.9999 && (this.arm.joints[i] === "P" || length(cross(z, way)) < 2e-3 * this.mode.size);
    });
  }

  draw(scene) {
    if (!this.parts.length) return;
    const chain = frames(this.arm, this.host.get("q"));
    scene.seeThrough(0.5, () => this.parts.forEach(({ frame, pose, mesh }) => scene.shape(mesh, product(chain[frame], pose), "link")));
  }
}
