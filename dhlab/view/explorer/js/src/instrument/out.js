// What is taken away: the picture as PNG, the table as a table file.

import { h } from "../dom.js";
import { DEGREE } from "../format.js";
import { origin, rollPitchYaw } from "../matrix.js";
import { isIdentity } from "../bodies.js";

export function save(name, type, content) {
  const address = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], { type }));
  h("a", { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), 1000);
}

// Takes the view as it stands, on its ground, at most `widest` pixels wide: {canvas, pen, take()}.
export function taker({ canvas, element }, widest = Infinity) {
  const part = Math.min(1, widest / canvas.width), copy = h("canvas", { width: Math.round(part * canvas.width), height: Math.round(part * canvas.height) });
  const pen = copy.getContext("2d", { willReadFrequently: true }), ground = getComputedStyle(element.closest(".explorer")).backgroundColor;
  const take = () => {
    pen.fillStyle = ground;
    pen.fillRect(0, 0, copy.width, copy.height);
    pen.drawImage(canvas, 0, 0, copy.width, copy.height);
    return copy;
  };
  return { canvas: copy, pen, take };
}

export function picture(stage, name) {
  stage.draw(performance.now());
  taker(stage).take().toBlob((blob) => save(`${name}.png`, "image/png", blob));
}

const exact = (value) => String(Number(value.toPrecision(15)) + 0);

// The arm as dhlab's table file, in metres and degrees.
export function yaml(arm, changed) {
  const line = arm.rows.map(([theta, d, a, alpha], i) => {
    const kind = arm.joints[i] === "P" ? "type: prismatic, " : "";
    return `  - {${kind}theta: ${exact(theta * DEGREE)}, d: ${exact(d)}, a: ${exact(a)}, alpha: ${exact(alpha * DEGREE)}}`;
  });
  const list = (values) => `[${values.join(", ")}]`, pose = (name, T) => (isIdentity(T) ? []
    : [`${name}: {xyz: ${list(origin(T).map(exact))}, rpy: ${list(rollPitchYaw(T).map((v) => exact(v * DEGREE)))}}`]);
  const limit = (pair, i) => (pair ? list(pair.map((v) => exact(arm.joints[i] === "P" ? v : v * DEGREE))) : "null");
  return [`name: ${JSON.stringify(arm.name + (changed ? " (changed)" : ""))}`, `convention: ${arm.convention}`, "units: {length: m, angle: deg}", "joints:", ...line,
    ...pose("base", arm.base), ...pose("tool", arm.tool), ...(arm.limits ? [`limits: ${list(arm.limits.map(limit))}`] : []),
    ...(arm.sign.some((v) => v !== 1) ? [`sign: ${list(arm.sign)}`] : []),
    ...(arm.coupling ? [`coupling: ${list(arm.coupling.map((row) => list(row.map(exact))))}`] : []), ""].join("\n");
}
