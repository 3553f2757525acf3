// Mode "compare": predicted against measured end poses, one after the other; or two tables as two arms in one picture.

import { drawBody, drawTriads, legend, named } from "../bodies.js";
import { button, jointSliders, stepper } from "../controls.js";
import { Table, h, write } from "../dom.js";
import { degrees, millimetres, unitOf } from "../format.js";
import { endOf, forward, frames } from "../kinematics.js";
import { along, angleBetween, length, middle, origin, sub } from "../matrix.js";
import { DHTable, FramesTable } from "../tables.js";
import { endReadout, sizeOf } from "./arm.js";

const SEEN = 0.08, SMALL = 0.015; // of the arm's size: where even the longest error is shorter than SMALL, all are drawn longer, to SEEN at least

export const compareMode = (host, redraw) => (host.data.other ? twoArms(host, redraw) : measured(host, redraw));

const gapOf = (A, B, positions) => ({ far: length(sub(origin(A), origin(B))), turned: positions ? null : angleBetween(A, B) });
const gapWords = ({ far, turned }) => millimetres(far, 2) + (turned > 1e-4 ? ` and ${degrees(turned)}` : "");

function measured(host, redraw) {
  const { arm, poses, qs, positions } = host.data, unit = unitOf(host.data), predicted = qs.map((q) => forward(arm, q));
  const gaps = poses.map((pose, k) => gapOf(predicted[k], pose, positions)), worst = gaps.reduce((best, gap, k) => (gap.far > gaps[best].far ? k : best), 0);
  const mode = { size: sizeOf(arm, frames(arm, qs[worst]), qs[0]), unit, build, changed, said };
  const factor = longer(gaps[worst].far, mode.size);
  let k, chain;
  const toWorst = button("Worst", () => host.set("step", worst + 1)), steps = stepper("Pose", qs.length, (number) => host.set("step", number), [toWorst]);
  const words = h("p"), dh = new DHTable(arm, unit);
  const frameTable = new FramesTable([...named(arm, frames(arm, qs[0]), predicted[0]).titles, "measured"], unit);
  const table = new Table("Errors, pose by pose", ["pose", "error (mm)", ...(positions ? [] : ["error (°)"]), `measured (${unit.name})`, `predicted (${unit.name})`], qs.length);
  table.set(poses.map((pose, i) => [String(i + 1), millimetres(gaps[i].far, 2).slice(0, -3), ...(positions ? [] : [degrees(gaps[i].turned).slice(0, -1)]),
    ...[pose, predicted[i]].map((T) => origin(T).map(unit.bare).join(", "))]));
  mode.controls = [steps.element, words,
    legend(["error", `error${factor > 1 ? `, drawn ${factor} times as long` : ""}`]),
    h("p", { class: "hint" }, `○ measured, ● predicted. The largest error is ${gapWords(gaps[worst])}, at pose ${worst + 1}.`)];
  mode.below = [h("div", { class: "pair" }, table.element, dh.element)];
  mode.frames = frameTable.element;
  changed();
  return mode;

  function changed() {
    k = Math.max(0, Math.min(qs.length, host.get("step")) - 1);
    chain = frames(arm, qs[k]);
    steps.set(k + 1);
    table.lines.forEach((line, i) => line.classList.toggle("now", i === k));
    dh.update(qs[k]);
    frameTable.update([...named(arm, chain, predicted[k]).poses, poses[k]]);
    write(words, said());
    redraw();
  }

  function said() {
    return `Pose ${k + 1} of ${qs.length}: predicted end ${unit.place(origin(predicted[k]))}; measured ${unit.place(origin(poses[k]))}; ${gapWords(gaps[k])} apart.`;
  }

  function build(scene) {
    drawBody(scene, arm, chain, predicted[k], { link: "link" });
    poses.forEach((pose, i) => {
      const from = origin(pose), way = sub(origin(predicted[i]), from), end = along(from, way, factor);
      scene.line([from, end], { color: "error", pixels: i === k ? 3 : 1.5, alpha: i === k ? 1 : 0.6 });
      scene.ring(from, i === k ? 6 : 4, { color: i === k ? "ink" : "quiet", pixels: i === k ? 2.2 : 1.4 });
      scene.ring(end, i === k ? 4 : 2.6, { color: i === k ? "ink" : "quiet", fill: true });
    });
    scene.label(`${k + 1}: ${gapWords(gaps[k])}`, origin(poses[k]), { color: "error", far: true, size: 14, weight: 600, key: "gap" });
    poses.forEach((pose, i) => i !== k && scene.label(String(i + 1), origin(pose), { color: "quiet", size: 11, key: `pose${i}` }));
    if (!positions) drawTriads(scene, [poses[k]], [""], null, { reach: 0.1 * mode.size, letters: false });
    scene.seeThrough(0.55, () => drawTriads(scene, [predicted[k]], [""], null, { reach: 0.13 * mode.size, letters: false }));
  }
}

function longer(largest, size) {
  if (largest < 1e-9 || largest >= SMALL * size) return 1;
  return [5, 10, 20, 50, 100, 200, 500, 1000].find((factor) => largest * factor >= SEEN * size) ?? 1000;
}

function twoArms(host, redraw) {
  const { arm, other } = host.data, unit = unitOf(host.data), arms = [arm, other], titles = [arm.name || "first", other.name === arm.name ? "second" : other.name || "second"];
  const mode = { size: Math.max(...arms.map((one) => sizeOf(one, frames(one, host.get("q")), host.get("q")))), unit, build, changed, said };
  const sliders = jointSliders(arm, mode.size, host), dh = arms.map((one, k) => new DHTable(one, unit, `${titles[k]}, as it is now`));
  const words = h("p"), named2 = arms.map((one, k) => named(one, frames(one, host.get("q")), one.tool).titles.map((title) => `${title} ${titles[k]}`));
  const frameTable = new FramesTable(named2.flat(), unit);
  let chains, ends;
  mode.readout = endReadout(unit);
  mode.controls = [words, legend(["plain", titles[0]], ["other", titles[1]]), sliders.element];
  mode.below = [h("div", { class: "pair" }, ...dh.map((one) => one.element))];
  mode.frames = frameTable.element;
  if (arm.convention === other.convention && arm.rows.length === other.rows.length) markDifferences();
  changed();
  return mode;

  function markDifferences() {
    arm.rows.forEach((row, i) => row.forEach((value, k) => dh.forEach((table) => table.mark(i, k + 1, "differs", Math.abs(value - other.rows[i][k]) > 1e-12))));
  }

  function changed() {
    const q = host.get("q");
    chains = arms.map((one) => frames(one, q));
    ends = arms.map((one, k) => endOf(one, chains[k]));
    sliders.set(q);
    dh.forEach((table) => table.update(q));
    frameTable.update(arms.flatMap((one, k) => named(one, chains[k], ends[k]).poses));
    mode.readout.update(ends[0]);
    write(words, said());
    redraw();
  }

  function said() {
    return `The ends are ${gapWords(gapOf(...ends))} apart.`;
  }

  function build(scene) {
    scene.seeThrough(0.62, () => drawBody(scene, other, chains[1], ends[1], { link: "other", joint: "other", shadow: false }));
    drawBody(scene, arm, chains[0], ends[0]);
    const far = length(sub(origin(ends[0]), origin(ends[1])));
    if (far > 1e-6) {
      scene.line(ends.map(origin), { color: "error", pixels: 2.5, dash: [5, 4] });
      scene.label(millimetres(far, 2), middle(...ends.map(origin)), { color: "error", far: true, size: 14, weight: 600, key: "gap" });
    }
    ends.forEach((end, k) => drawTriads(scene, [end], [""], far > 1e-6 || !k ? [titles[k]] : null, { reach: 0.13 * mode.size, key: `end${k}` }));
  }
}
