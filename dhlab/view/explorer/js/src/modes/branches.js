// Mode "branches": every configuration that brings the end to one pose; the chosen one in full, the others faint.

import { drawBody, drawTriads, named } from "../bodies.js";
import { stepper, toggle } from "../controls.js";
import { Table, h, write } from "../dom.js";
import { unitOf } from "../format.js";
import { endOf, frames } from "../kinematics.js";
import { origin } from "../matrix.js";
import { DHTable, FramesTable } from "../tables.js";
import { endReadout, sizeOf } from "./arm.js";

export function branchesMode(host, redraw) {
  const { arm, qs } = host.data, unit = unitOf(host.data), chains = qs.map((q) => frames(arm, q)), ends = chains.map((chain) => endOf(arm, chain));
  const mode = { size: Math.max(...qs.map((q) => sizeOf(arm, chains[0], q))), unit, build, changed, said };
  const valuesOf = (q) => q.map((value, i) => unit.amount(value, arm.joints[i] !== "P"));
  let k, others = true;
  const steps = stepper("Solution", qs.length, (number) => host.set("step", number)), words = h("p"), dh = new DHTable(arm, unit);
  const table = new Table("Every solution", ["solution", ...qs[0].map((_, i) => `q${i + 1}`)], qs.length);
  table.set(qs.map((q, i) => [String(i + 1), ...valuesOf(q)]));
  const frameTable = new FramesTable(named(arm, chains[0], ends[0]).titles, unit);
  mode.tools = [toggle("The others", others, (on) => {
    others = on;
    redraw();
  })];
  mode.readout = endReadout(unit);
  mode.controls = [steps.element, words, h("p", { class: "hint" }, "The solution shown is solid, the others are faint.")];
  mode.below = [h("div", { class: "pair" }, table.element, dh.element)];
  mode.frames = frameTable.element;
  changed();
  return mode;

  function changed() {
    k = Math.max(0, Math.min(qs.length, host.get("step")) - 1);
    steps.set(k + 1);
    table.lines.forEach((line, i) => line.classList.toggle("now", i === k));
    dh.update(qs[k]);
    frameTable.update(named(arm, chains[k], ends[k]).poses);
    mode.readout.update(ends[k]);
    write(words, said());
    redraw();
  }

  function said() {
    return `Solution ${k + 1} of ${qs.length}: q = ${valuesOf(qs[k]).join(", ")}. The end is at ${unit.place(origin(ends[k]))}.`;
  }

  function build(scene) {
    const ghost = { link: "ghost", joint: "ghost", shadow: false };
    if (others) qs.forEach((_, i) => i !== k && scene.seeThrough(0.3, () => drawBody(scene, arm, chains[i], ends[i], ghost)));
    drawBody(scene, arm, chains[k], ends[k]);
    drawTriads(scene, [ends[k]], [""], null, { letters: false });
  }
}
