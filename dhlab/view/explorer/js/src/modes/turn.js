// Mode "turn": joint axes, common normals and frames of a still picture, to be looked at from all sides; nothing of it moves.

import { drawTriads } from "../bodies.js";
import { Table, h } from "../dom.js";
import { unitOf } from "../format.js";
import { length, sub, unit } from "../matrix.js";

const HOW = "Drag to turn the view, or take the arrow keys.";

export function turnMode(host) {
  const { lines, normals, frames, size, table, alt } = host.data, numbers = new Table(table.caption, table.headings, table.rows.length);
  numbers.set(table.rows);
  const feet = normals.length ? " Between the axes dashed: the common normals; the rings are their feet." : "";
  return { size, unit: unitOf(host.data), build, changed() {}, said: () => alt, controls: [], below: [h("p", { class: "hint" }, HOW + feet)], frames: numbers.element };

  function build(scene) {
    for (const { ends, name, at, slides } of lines) {
      const z = unit(sub(ends[1], ends[0]));
      scene.line(ends, { color: "ink", pixels: 1.4, dash: [10, 3, 2, 3], head: true });
      scene.joint(at, z, 0.022 * size, 0.04 * size, "joint", slides);
      scene.label(name, ends[1], { toward: z, color: "quiet", far: true });
      scene.keep(...ends);
    }
    for (const ends of normals) {
      if (length(sub(...ends)) > 1e-6) scene.line(ends, { color: "quiet", pixels: 2, dash: [5, 4] });
      ends.forEach((foot) => scene.ring(foot, 4, { color: "quiet", pixels: 2 }));
    }
    drawTriads(scene, frames.map((one) => one.pose), frames.map((one) => one.name), frames.map((one) => one.title), { reach: 0.16 * size, thick: 0.0055 * size });
    scene.keep([0, 0, 0]);
  }
}
