// Mode "link": the four numbers of one row, each drawn as what it is, and the four moves played one by one in the convention's order.

import { drawTriads } from "../bodies.js";
import { button, choice, slider } from "../controls.js";
import { h, write } from "../dom.js";
import { below, direction, SYMBOLS, unitOf } from "../format.js";
import { COLUMNS, ORDERS, isTurn, move } from "../kinematics.js";
import { AXES, Light, Matrix, drawColumn } from "../linked.js";
import { renderer } from "../loop.js";
import { IDENTITY, add, along, axis, middle, origin, product, scale } from "../matrix.js";
import { FramesTable } from "../tables.js";
import { prefersStillness } from "../theme.js";

const SECONDS = 1.1; // a move
const still = () => prefersStillness() || !renderer().works; // then nothing is drawn on the way

export function linkMode(host, redraw) {
  const { index, reach } = host.data, unit = unitOf(host.data);
  const names = [String(index - 1), String(index)], titles = names.map((name) => `{${name}}`);
  let moves, t = host.get("step"), goal = t, last = null;
  const mode = { size: reach, unit, build, changed, said, axes };
  const sliders = COLUMNS.map((kind, k) => slider({
    symbol: SYMBOLS[kind], name: WORDS[kind], turn: isTurn(kind), unit, low: isTurn(kind) ? -Math.PI : -reach, high: isTurn(kind) ? Math.PI : reach,
    changed: (value) => host.set("row", host.get("row").map((old, j) => (j === k ? value : old))),
  }));
  sliders.forEach((one, k) => one.element.querySelector(".symbol").classList.add(k < 2 ? "z" : "x"));
  const light = new Light(lit); // a number of the row, or a column of its matrix
  sliders.forEach((one, k) => light.from(one.element, COLUMNS[k]));
  const matrix = new Matrix(`${titles[1]} seen from ${titles[0]}, lengths in m`, [...AXES, "p"].map((letter, k) => [`${letter}${below(index)}`,
    k < 3 ? `arrow of frame ${names[1]}, written in frame ${names[0]}` : `origin of frame ${names[1]}, written in frame ${names[0]}`, `column${k}`]), light);
  const order = choice("Order of the moves", "convention", [["standard", "Standard"], ["craig", "Craig"]], host.get("convention"), (value) => {
    host.set("convention", value);
    go(4, 4);
  });
  const list = h("ol", { class: "moves" }, ...COLUMNS.map(() => h("li")));
  const buttons = { start: button("To the start", () => go(0, 0)), back: button("◀ Back", () => go(Math.ceil(goal) - 1), { "aria-label": "One move back" }),
    on: button("Forward ▶", () => go(Math.floor(goal) + 1), { "aria-label": "One move forward" }), play: button("Play all", () => (go(0, 0), go(4))) };
  const frameTable = new FramesTable([...titles, "now"], unit, `Frames, seen from ${titles[0]}`);
  mode.controls = [h("fieldset", { class: "sliders" }, h("legend", {}, `Row ${index}: from ${titles[0]} to ${titles[1]}`), ...sliders.map((one) => one.element)),
    order.element, h("div", { class: "transport", role: "group", "aria-label": "Play the moves" }, ...Object.values(buttons)), list];
  mode.below = [matrix.element];
  mode.frames = frameTable.element;
  changed();
  return mode;

  function lit(on) {
    matrix.light(on);
    sliders.forEach((one, k) => one.element.classList.toggle("lit", COLUMNS[k] === on));
    [...list.children].forEach((item, k) => item.classList.toggle("lit", moves[k].kind === on));
    redraw();
  }

  // Let the moves run to a place between 0 (none done) and 4 (all done), from where they are or from a given place.
  function go(to, from = t) {
    goal = Math.max(0, Math.min(4, to));
    t = still() ? goal : from;
    last = null;
    if (host.get("step") !== goal) host.set("step", goal);
    show();
  }

  function changed(what) {
    if (what === "step" && host.get("step") !== goal) [goal, last] = [host.get("step"), null];
    if (still()) t = goal;
    const row = host.get("row"), convention = host.get("convention");
    moves = movesOf(row, convention, index, unit);
    sliders.forEach((one, k) => one.set(row[k]));
    order.set(convention);
    matrix.update(moves[3].end);
    show();
  }

  function show() {
    [...list.children].forEach((item, k) => {
      const one = moves[k];
      write(item, `${k + 1}. ${one.name} = ${one.text}: ${isTurn(one.kind) ? "turn about" : "shift along"} ${one.letter}`);
    });
    mark();
    buttons.back.disabled = buttons.start.disabled = goal <= 0;
    buttons.on.disabled = goal >= 4;
    frameTable.update([IDENTITY, moves[3].end, poseAt(moves, goal)]);
    redraw();
  }

  // The move that runs is marked; of those at rest the last one made.
  function mark() {
    const now = goal > t ? Math.floor(t) : Math.ceil(t) - 1;
    [...list.children].forEach((item, k) => { item.className = `${k === now ? "now" : k < now ? "done" : ""} ${moves[k].kind === light.on ? "lit" : ""}`.trim(); });
  }

  function advance(time) {
    if (t === goal) return;
    const step = last === null ? 0.016 : Math.min(0.1, (time - last) / 1000);
    last = time;
    t = goal > t ? Math.min(goal, t + step / SECONDS) : Math.max(goal, t - step / SECONDS);
    mark();
    redraw();
  }

  function build(scene) {
    advance(scene.time);
    const size = 0.42 * reach, end = moves[3].end, now = poseAt(moves, t), done = t >= 4;
    scene.size = reach * 1.2;
    zLine(scene, IDENTITY, size);
    zLine(scene, end, size);
    moves.forEach((one, k) => {
      const part = Math.max(0, Math.min(1, t - k));
      if (part > 0 && Math.abs(one.value) > 1e-9) drawMove(scene, one, part, size, k < 2, light.on === one.kind);
      scene.keep(origin(one.end));
    });
    if (!done) scene.seeThrough(0.28, () => drawTriads(scene, [end], [names[1]], null, { reach: size, thick: 0.0095 * reach, letters: false }));
    const shown = done ? [IDENTITY, end] : [IDENTITY, now];
    if (light.on?.startsWith("column")) drawColumn(scene, end, IDENTITY, Number(light.on.slice(6)), size);
    drawTriads(scene, shown, done ? names : [names[0], " "], done ? titles : [titles[0], "moving"], { reach: size, thick: 0.0095 * reach });
  }

  // What the view must keep apart: x and z of both frames.
  function axes() {
    return [IDENTITY, moves[3].end].flatMap((pose) => [axis(pose, 0), axis(pose, 2)]);
  }

  function said() {
    const end = moves[3].end;
    return `Frame ${names[1]} at ${unit.place(origin(end))}, x axis ${direction(axis(end, 0))}, z axis ${direction(axis(end, 2))}.`;
  }
}

const WORDS = { theta: "theta, the turn about z", d: "d, the shift along z", a: "a, the shift along x", alpha: "alpha, the turn about x" };

// The four moves, each with the poses before and after it.
function movesOf(row, convention, index, unit) {
  let pose = IDENTITY;
  return ORDERS[convention].map((kind, k) => {
    const value = row[COLUMNS.indexOf(kind)], start = pose, end = product(pose, move(kind, value));
    const own = convention === "craig" && k < 2 ? index - 1 : index, about = kind === "theta" || kind === "d" ? 2 : 0;
    pose = end;
    const letter = `${"xyz"[about]}${below(k < 2 ? index - 1 : index)}`;
    return { kind, value, start, end, about, letter, name: `${SYMBOLS[kind]}${below(own)}`, text: unit.amount(value, isTurn(kind)) };
  });
}

function poseAt(moves, t) {
  const k = Math.min(3, Math.floor(t)), one = moves[k];
  return product(one.start, move(one.kind, one.value * (t - k)));
}

function zLine(scene, pose, size) {
  const at = origin(pose), z = axis(pose, 2);
  scene.line([along(at, z, -0.55 * size), along(at, z, 1.6 * size)], { color: "quiet", pixels: 1, dash: [9, 3, 2, 3], under: true });
}

// A turn is an arc between two rays, a shift a measured length; both in the colour of the axis about or along which they run.
function drawMove(scene, one, part, size, first, strong) {
  const color = one.about === 2 ? "z" : "x", direction = axis(one.start, one.about), at = origin(one.start);
  const text = `${one.name} = ${one.text}`;
  if (!isTurn(one.kind)) {
    const to = along(at, direction, one.value * part);
    scene.stick(at, to, (strong ? 0.026 : 0.014) * scene.size, strong ? color : "link");
    scene.ball(to, 0.0145 * scene.size, "link");
    scene.dimension(at, to, { color, pixels: strong ? 4 : 2 });
    scene.label(text, middle(at, to), { color, far: true, size: strong ? 17 : 14, weight: 600, key: one.kind });
    return;
  }
  const ray = axis(one.start, one.about === 2 ? 0 : 2), radius = (first ? 0.62 : 0.72) * size;
  const centre = scene.arc(at, ray, direction, one.value * part, radius, { color, pixels: strong ? 6 : 2.5 });
  scene.line([at, along(at, ray, 1.05 * size)], { color: "quiet", pixels: 1, dash: [4, 3] });
  scene.label(text, centre, { toward: add(centre, scale(at, -1)), color, far: true, size: strong ? 17 : 14, weight: 600, key: one.kind });
}

