// Mode "arm": the whole arm with its frames, sliders, the table as it is now, the end pose, the zero pose as a ghost, the trace of the tool.

import { drawBody, drawTriads, named, spread } from "../bodies.js";
import { jointSliders, toggle } from "../controls.js";
import { h, write } from "../dom.js";
import { degrees, direction, place } from "../format.js";
import { endOf, frames, path } from "../kinematics.js";
import { axis, length, origin, rollPitchYaw, sub } from "../matrix.js";
import { DHTable, FramesTable } from "../tables.js";

const LONGEST = 800; // points of the trace that are kept

export function armMode(host, redraw) {
  const { arm } = host.data, zero = frames(arm, arm.sign.map(() => 0)), zeroEnd = endOf(arm, zero);
  const shown = { frames: true, ghost: false, trace: true };
  const trace = [];
  let q, chain, end;
  const mode = { size: sizeOf(arm, zero, host.get("q")), build, changed, said };
  const sliders = jointSliders(arm, mode.size, host), table = new DHTable(arm);
  const { titles } = named(arm, zero, zeroEnd), frameTable = new FramesTable(titles);
  const switchOf = (text, key) => toggle(text, shown[key], (on) => {
    shown[key] = on;
    trace.length = 0;
    redraw();
  });
  mode.tools = [switchOf("Frames", "frames"), switchOf("Zero pose", "ghost"), switchOf("Trace", "trace")];
  mode.controls = [sliders.element];
  mode.below = [table.element];
  mode.frames = frameTable.element;
  mode.readout = endReadout();
  changed();
  return mode;

  function changed() {
    q = host.get("q");
    chain = frames(arm, q);
    end = endOf(arm, chain);
    sliders.set(q);
    table.update(q);
    frameTable.update(named(arm, chain, end).poses);
    mode.readout.update(end);
    const at = origin(end), last = trace[trace.length - 1];
    if (!last || length(sub(at, last)) > 1e-4 * mode.size) trace.push(at);
    if (trace.length > LONGEST) trace.shift();
    redraw();
  }

  function build(scene) {
    if (shown.ghost) scene.seeThrough(0.3, () => drawBody(scene, arm, zero, zeroEnd, { link: "ghost", joint: "ghost", shadow: false }));
    drawBody(scene, arm, chain, end);
    const all = named(arm, chain, end), last = all.poses.length - 1;
    if (shown.frames) drawTriads(scene, all.poses, all.names, all.titles);
    else drawTriads(scene, [all.poses[last]], [all.names[last]], [all.titles[last]]);
    if (shown.trace && trace.length > 1) scene.line([...trace, origin(end)], { color: "trace", pixels: 2, alpha: 0.85 });
  }

  function said() {
    return `End at ${place(origin(end))}, x axis ${direction(axis(end, 0))}, z axis ${direction(axis(end, 2))}.`;
  }
}

export const sizeOf = (arm, zero, q) => spread([...path(arm.convention, zero), origin(endOf(arm, zero)), ...path(arm.convention, frames(arm, q))]);

// The end pose in numbers, over the picture.
export function endReadout() {
  const where = h("span"), how = h("span");
  const element = h("dl", {}, h("dt", {}, "End"), h("dd", {}, where), h("dt", {}, "Roll, pitch, yaw"), h("dd", {}, how));
  return { element, update: (T) => {
    write(where, place(origin(T)));
    write(how, rollPitchYaw(T).map((angle) => degrees(angle, 1)).join(", "));
  } };
}
