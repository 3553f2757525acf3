// Mode "arm": the whole arm with its frames, sliders, the table as it is now, the end pose, the zero pose as a ghost, the trace of the tool.

import { REACH, drawBody, drawTriads, named, spread } from "../bodies.js";
import { jointSliders, toggle } from "../controls.js";
import { h, write } from "../dom.js";
import { below, degrees, direction, number, unitOf } from "../format.js";
import { found, held } from "../hands.js";
import { AXES, Light, LitColumns } from "../linked.js";
import { endOf, frames, jacobian, jointPlaces, path } from "../kinematics.js";
import { meshOf } from "../instrument/stl.js";
import { along, axis, dot, length, middle, origin, product, rollPitchYaw, scale, sub } from "../matrix.js";
import { DHTable, FramesTable } from "../tables.js";

const LONGEST = 800; // points of the trace that are kept

export function armMode(host, redraw) {
  const { arm } = host.data, unit = unitOf(host.data), nil = arm.sign.map(() => 0);
  const shown = { frames: true, letters: false, ghost: false, trace: true };
  const trace = [];
  let zero = frames(arm, nil), zeroEnd = endOf(arm, zero);
  let q, chain, end, touched = null;
  const mode = { size: sizeOf(arm, zero, host.get("q")), unit, build, changed, said };
  const sliders = jointSliders(arm, mode.size, host), light = new Light(lit), table = new DHTable(arm, unit, undefined, light);
  const columns = host.data.jacobian ? jacobianTable(arm, light) : null;
  const { titles } = named(arm, zero, zeroEnd), frameTable = new FramesTable(titles, unit);
  const switchOf = (text, key) => toggle(text, shown[key], (on) => {
    shown[key] = on;
    trace.length = 0;
    redraw();
  });
  mode.tools = [switchOf("Frames", "frames"), switchOf("All letters", "letters"), switchOf("Zero pose", "ghost"), switchOf("Trace", "trace")];
  mode.controls = [sliders.element, h("p", { class: "hint by-hand" }, "Drag the ring to move the hand, an arrow of it to turn it, a joint or a link to move one joint; beside the arm you turn the view.")];
  mode.hover = hover;
  mode.grab = grab;
  mode.rework = rework;
  mode.below = [table.element, ...(columns ? [columns.element] : [])];
  mode.frames = frameTable.element;
  mode.readout = endReadout(unit);
  mode.parts = []; // the real links, whose files Python reads
  if (host.data.meshes) {
    host.parts = (told, buffers) => {
      mode.parts = told.map((part, k) => ({ ...part, mesh: meshOf(floats(buffers[k]), [1, 1, 1]) }));
      redraw();
    };
    host.send({ meshes: true });
  }
  changed();
  return mode;

  function changed() {
    q = host.get("q");
    chain = frames(arm, q);
    end = endOf(arm, chain);
    sliders.set(q);
    table.update(q);
    if (columns) jacobian(arm, chain, end).forEach((column, k) => column.forEach((value, i) => columns.put(i, k, value)));
    frameTable.update(named(arm, chain, end).poses);
    mode.readout.update(end);
    const at = origin(end), last = trace[trace.length - 1];
    if (!last || length(sub(at, last)) > 1e-4 * mode.size) trace.push(at);
    if (trace.length > LONGEST) trace.shift();
    redraw();
  }

  function lit(on) {
    table.light(on);
    columns?.light(on);
    redraw();
  }

  // The arm's numbers are others now, in the same object.
  function rework() {
    zero = frames(arm, nil);
    zeroEnd = endOf(arm, zero);
    trace.length = 0;
    table.retitle();
    changed();
  }

  function view() {
    return { arm, q, chain, end, size: mode.size, arrow: REACH * mode.size };
  }

  // What is near a point of the canvas: its row is lit.
  function hover(at, camera, near) {
    const one = at && found(view(), at, camera, near), before = touched;
    touched = one && (one.kind === "end" || one.kind === "tip") ? one : null;
    light.point(one?.row ?? null);
    if (before?.kind !== touched?.kind || before?.column !== touched?.column) redraw();
    return one;
  }

  function grab(at, camera, near) {
    const one = found(view(), at, camera, near), follow = one && held(view(), one, at, camera);
    if (!follow) return null;
    return (now, done) => done || host.set("q", follow(now));
  }

  // The frame whose arrows are long and lettered: that of the lit row, else the end's.
  function chosen(all) {
    const row = typeof light.on === "number" ? light.on : null;
    return row === null ? all.poses.length - 1 : row + 1;
  }

  function build(scene) {
    if (shown.ghost) scene.seeThrough(0.3, () => drawBody(scene, arm, zero, zeroEnd, { link: "ghost", joint: "ghost", shadow: false }));
    drawBody(scene, arm, chain, end);
    const all = named(arm, chain, end), last = all.poses.length - 1;
    const one = chosen(all), letters = shown.letters || ((k, j) => k === one && j !== 1);
    if (shown.frames) drawTriads(scene, all.poses, all.names, all.titles, { chosen: shown.letters ? null : one, letters });
    else drawTriads(scene, [all.poses[last]], [all.names[last]], [all.titles[last]], { letters: shown.letters || ((k, j) => j !== 1) });
    scene.ring(origin(end), touched?.kind === "end" ? 13 : 10, { color: touched?.kind === "end" ? "error" : "quiet", pixels: 2 });
    if (touched?.kind === "tip") scene.ring(along(origin(end), axis(end, touched.column), REACH * scene.size), 9, { color: "error", pixels: 2 });
    if (typeof light.on === "number") drawRow(scene, arm, chain, light.on, unit);
    else if (light.on) drawVelocity(scene, arm, chain, end, Number(light.on.slice(1)));
    if (mode.parts.length) scene.seeThrough(0.5, () => mode.parts.forEach(({ frame, pose, mesh }) => scene.shape(mesh, product(chain[frame], pose), "link")));
    mode.extra?.(scene); // what an instrument adds
    if (shown.trace && trace.length > 1) scene.line([...trace, origin(end)], { color: "trace", pixels: 2, alpha: 0.85 });
  }

  function said() {
    return `End at ${unit.place(origin(end))}, x axis ${direction(axis(end, 0))}, z axis ${direction(axis(end, 2))}.`;
  }
}

// What Python sent: a view into a message, at any place in it.
const floats = ({ buffer, byteOffset, byteLength }) => new Float32Array(buffer.slice(byteOffset, byteOffset + byteLength));

export const sizeOf = (arm, zero, q) => spread([...path(arm.convention, zero), origin(endOf(arm, zero)), ...path(arm.convention, frames(arm, q))]);

// The end pose in numbers, over the picture.
export function endReadout(unit) {
  const where = h("span"), how = h("span");
  const element = h("dl", {}, h("dt", {}, "End"), h("dd", {}, where), h("dt", {}, "Roll, pitch, yaw"), h("dd", {}, how));
  return { element, update: (T) => {
    write(where, unit.place(origin(T)));
    write(how, rollPitchYaw(T).map((angle) => degrees(angle, 1)).join(", "));
  } };
}

// A row as its link: d along z and a along x, each with its length.
function drawRow(scene, arm, chain, i, unit) {
  const [from, corner, to] = path(arm.convention, chain).slice(2 * i, 2 * i + 3);
  const parts = arm.convention === "standard" ? [["d", "z", i + 1], ["a", "x", i + 1]] : [["a", "x", i], ["d", "z", i + 1]];
  [[from, corner], [corner, to]].forEach(([a, b], k) => {
    const [symbol, color, number] = parts[k], far = length(sub(b, a));
    if (far < 1e-6) return;
    const about = axis(chain[(arm.convention === "standard") === (k === 0) ? i : i + 1], color === "z" ? 2 : 0);
    scene.onTop(() => scene.stick(a, b, 0.017 * scene.size, color));
    scene.label(`${symbol}${below(number)} = ${unit.text(dot(sub(b, a), about))}`, middle(a, b), { color, far: true, weight: 700, key: `row${symbol}` });
  });
  [from, to].forEach((p) => scene.onTop(() => scene.ball(p, 0.024 * scene.size, "error")));
}

// A column of the Jacobian: the joint's axis, and where the end goes when this joint alone turns by 1 rad/s (or slides by 1 m/s), drawn shorter.
function drawVelocity(scene, arm, chain, end, i) {
  const [vx, vy, vz] = jacobian(arm, chain, end)[i], speed = Math.hypot(vx, vy, vz), { at, along: z } = jointPlaces(arm.convention, chain)[i];
  scene.line([along(at, z, -0.3 * scene.size), along(at, z, 0.45 * scene.size)], { color: "error", pixels: 2, dash: [9, 4] });
  scene.label(`axis of joint ${i + 1}`, along(at, z, 0.45 * scene.size), { toward: z, color: "error", far: true, key: "axis" });
  if (arm.joints[i] !== "P") scene.line([at, along(at, z, dot(sub(origin(end), at), z)), origin(end)], { color: "quiet", pixels: 1.5, dash: [4, 3] });
  if (speed < 1e-6) return;
  const tip = scene.onTop(() => scene.arrow(origin(end), scale([vx, vy, vz], 1 / speed), Math.max(0.06, 0.4 * speed) * Math.min(1, scene.size), 0.011 * scene.size, "error"));
  scene.label(`v = ${number(speed, 3)} m/s`, tip, { toward: [vx, vy, vz], color: "error", far: true, weight: 700, key: "speed" });
}

function jacobianTable(arm, light) {
  const names = [...arm.joints].map((letter, i) => [`q${below(i + 1)}`, `what joint ${i + 1} alone does to the end`, `j${i}`]);
  return new LitColumns("Jacobian: speeds of the end for each joint", names, 6, light, ["v", "ω"].flatMap((kind) => AXES.map((letter) => `${kind} ${letter}`)));
}
