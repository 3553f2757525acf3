// Mode "pose": a plate with three arrows that hands turn and move, beside its matrix: a column and its arrow light up together.
// With two plates, the second one is seen from the first, and the two products stand side by side.

import { drawTriads } from "../bodies.js";
import { button, choice, slider } from "../controls.js";
import { h, write } from "../dom.js";
import { METRES, below, vector } from "../format.js";
import { AXES, Light, Matrix, drawColumn } from "../linked.js";
import { IDENTITY, add, along, axis, dot, inverse, length, origin, poseOf, product, rollPitchYaw, scale, sub, turnTo, unit } from "../matrix.js";
import { FramesTable } from "../tables.js";

const GRID = 0.01, STRAIGHT = 0.12; // m, rad: where hands snap to, round numbers and the arrows of the frame around

export function poseMode(host, redraw) {
  const { reach } = host.data, count = host.get("poses").length, two = count === 2, arrow = 0.3 * reach;
  const light = new Light(lit), shown = matrices();
  let hands = [], poses = [], world = [], mine = two ? 1 : 0;
  const mode = { size: reach, unit: METRES, build, changed, said, grab, hover };
  const sliders = [...AXES.map((letter, k) => slider({ symbol: letter, name: `${letter} of the origin`, unit: METRES, coarse: 10, low: -reach, high: reach, changed: (value) => move(k, value) })),
    ...["roll, the turn about x", "pitch, the turn about y", "yaw, the turn about z"].map((name, k) => slider({ symbol: `↻${AXES[k]}`, name, turn: true, low: -Math.PI, high: Math.PI, changed: (value) => move(3 + k, value) }))];
  const legend = h("legend");
  const which = choice("What your hands move", "plate", [["0", "{1} in {0}"], ["1", "{2} in {1}"]], String(mine), (key) => {
    mine = Number(key);
    changed();
  });
  const quarter = h("div", { class: "transport", role: "group", "aria-label": "A quarter turn about an arrow of the plate" },
    ...AXES.map((letter, k) => button(`${letter} +90°`, () => turnOwn(k), { "aria-label": `${letter} +90°: a quarter turn about the plate's own ${letter}` })));
  const hint = h("p", { class: "hint by-hand" }, "Drag the tip of an arrow to turn the plate, its middle to move it. Point at a column: its arrow lights up.");
  const panel = h("fieldset", { class: "sliders" }, legend, ...sliders.map((one) => one.element), quarter);
  mode.controls = [...(two ? [which.element] : [shown[0].table.element]), panel, hint];
  mode.below = two ? [h("div", { class: "matrices" }, ...shown.map((one) => one.table.element))] : [];
  const frameTable = new FramesTable(two ? ["{1}", "{2}, T₀₁·T₁₂", "T₁₂·T₀₁"] : ["{1}"], METRES, "The plates, seen from {0}");
  mode.frames = frameTable.element;
  changed();
  return mode;

  // Each matrix: where its plate is, in whose arrows it is written, and how to get it.
  function matrices() {
    const one = (caption, name, seen, part, at) => ({ at, part, seen, table: new Matrix(caption, [0, 1, 2, 3].map((k) => [
      k < 3 ? `${AXES[k]}${below(name)}` : `p${below(seen + name)}`,
      k < 3 ? `arrow of plate ${name}, written in frame ${seen}` : `origin of plate ${name}, written in frame ${seen}`, `${part}${k}`]), light) });
    if (!two) return [one("T₀₁", "1", "0", "a", () => [poses[0], IDENTITY])];
    const wrong = new Matrix("T₁₂ · T₀₁, the other way round", [...AXES, "p"].map((letter, k) => [letter, `column ${k + 1} of the product the other way round`, `d${k}`]), light);
    return [one("T₀₁", "1", "0", "a", () => [world[0], IDENTITY]), one("T₁₂", "2", "1", "b", () => [world[1], world[0]]),
      one("T₀₂ = T₀₁ · T₁₂", "2", "0", "c", () => [world[1], IDENTITY]), { part: "d", table: wrong, at: () => [world[2], IDENTITY] }];
  }

  function changed() {
    const given = host.get("poses").map((T) => T.flat());
    hands = given.map((T, k) => (hands[k] && same(poseFrom(hands[k]), T) ? hands[k] : handsOf(T)));
    poses = given;
    world = two ? [poses[0], product(poses[0], poses[1]), product(poses[1], poses[0])] : [poses[0]];
    write(legend, two ? `Plate {${mine + 1}}, seen from {${mine}}` : "Plate {1}, seen from {0}");
    sliders.forEach((one, k) => one.set(hands[mine][k]));
    shown.forEach(({ table, at }) => {
      const [T, seen] = at();
      table.update(seen === IDENTITY ? T : product(inverse(seen), T));
    });
    frameTable.update(world);
    redraw();
  }

  function lit(on) {
    shown.forEach(({ table }) => table.light(on));
    redraw();
  }

  function put(k, T) {
    hands[k] = handsOf(T);
    tell(k);
  }

  function tell(k) {
    const T = poseFrom(hands[k]), rows = [0, 4, 8, 12].map((i) => T.slice(i, i + 4));
    host.set("poses", host.get("poses").map((old, j) => (j === k ? rows : old)));
  }

  function move(k, value) {
    hands[mine] = hands[mine].map((old, j) => (j === k ? value : old));
    tell(mine);
  }

  function turnOwn(k) {
    const turn = [0, 0, 0];
    turn[k] = Math.PI / 2;
    put(mine, product(poses[mine], poseOf([0, 0, 0], turn)));
  }

  function build(scene) {
    const key = light.on, [part, column] = key ? [key[0], Number(key[1])] : [null, -1], thick = 0.0085 * reach;
    const drawn = [[IDENTITY, "0", 0.8], [world[0], "1", 1], ...(two ? [[world[1], "2", 1]] : [])];
    drawn.slice(1).forEach(([T, , s]) => scene.solid("box", [0, 1].map((j) => scale(axis(T, j), 0.13 * reach * s)).concat([scale(axis(T, 2), 0.012 * reach), origin(T)]), "ghost", 0.1));
    drawTriads(scene, drawn.map(([T]) => T), drawn.map(([, name]) => name), drawn.map(([, name]) => `{${name}}`), { reach: arrow, thick });
    if (two) scene.seeThrough(0.75, () => drawTriads(scene, [world[2]], ["other"], ["T₁₂·T₀₁"], { reach: 0.8 * arrow, thick: 0.8 * thick, letters: false, dashed: true, key: "other" }));
    for (const [x, y, z] of world.map(origin)) scene.keep([0, 0, 0], [x, 0, 0], [x, y, 0], [x, y, z]); // the steps of a column as well
    if (column >= 0) drawColumn(scene, ...shown.find((one) => one.part === part).at(), column, arrow);
  }

  // What hands can take hold of near a point of the canvas: an arrow's tip, or a plate's middle.
  function found(at, camera, near) {
    const places = world.slice(0, count).flatMap((T, k) => [0, 1, 2, 3].map((column) => ({ k, column, at: column < 3 ? along(origin(T), axis(T, column), arrow) : origin(T) })));
    const far = places.map((one) => ({ ...one, far: Math.hypot(...camera.flat(one.at).map((v, j) => v - at[j])) }));
    return far.reduce((best, one) => (one.far <= near && !(best?.far <= one.far) ? one : best), null);
  }

  function hover(at, camera, near) {
    const one = at && found(at, camera, near);
    light.point(one ? `${two && one.k ? "c" : "a"}${one.column}` : null);
    return one;
  }

  function grab(at, camera, near) {
    const one = found(at, camera, near);
    if (!one) return null;
    if (two && mine !== one.k) {
      mine = one.k;
      which.set(String(mine));
      changed();
    }
    return one.column < 3 ? turning(one, camera) : moving(one, at, camera);
  }

  function moving({ k }, start, camera) {
    const first = origin(world[k]), [x, y] = camera.flat(first), aside = [start[0] - x, start[1] - y];
    return (at, done) => { // where the pointer is on the plane of the picture through the plate; the picture may have been fitted anew
      if (done) return;
      const from = camera.flat(first), [right, down] = [0, 1].map((j) => (at[j] - aside[j] - from[j]) / camera.scale);
      const to = add(first, add(scale(camera.right, right), scale(camera.up, -down))), T = world[k].slice();
      [T[3], T[7], T[11]] = to;
      const own = inOwn(k, T);
      for (const j of [3, 7, 11]) own[j] = Math.round(own[j] / GRID) * GRID;
      put(k, own);
    };
  }

  // The arrow follows the pointer on a ball round the plate; past its rim the arrow goes round to the other side.
  function turning({ k, column }, camera) {
    let side = Math.sign(dot(axis(world[k], column), camera.toward)) || 1, outside = false;
    const start = world[k], radius = arrow * camera.scale, middle = camera.flat(origin(start)), straight = k ? world[0] : IDENTITY;
    return (at, done) => {
      if (done) return;
      const [x, y] = [(at[0] - middle[0]) / radius, (middle[1] - at[1]) / radius], far = Math.hypot(x, y);
      if (far < 0.97 && outside) side = -side;
      outside = far >= 0.97;
      const deep = side * Math.sqrt(Math.max(0, 1 - far * far));
      const wanted = unit(add(add(scale(camera.right, x), scale(camera.up, y)), scale(camera.toward, deep)));
      const near = [0, 1, 2].flatMap((j) => [1, -1].map((sense) => scale(axis(straight, j), sense))).find((v) => length(sub(v, wanted)) < STRAIGHT);
      const T = product(turnTo(axis(start, column), near ?? wanted), start);
      [T[3], T[7], T[11]] = origin(start);
      put(k, inOwn(k, T));
    };
  }

  // A plate's pose in the world as the pose that hands set: in the plate before it.
  function inOwn(k, T) {
    return k ? product(inverse(world[0]), T) : T.slice();
  }

  function said() {
    const name = (T) => `origin at ${vector(origin(T))} m, x arrow ${vector(axis(T, 0))}, z arrow ${vector(axis(T, 2))}`;
    return two ? `Plate 2, seen from 0: ${name(world[1])}. The other way round: ${name(world[2])}.` : `Plate 1: ${name(world[0])}.`;
  }
}

const handsOf = (T) => [...origin(T), ...rollPitchYaw(T)];
const poseFrom = (hands) => poseOf(hands.slice(0, 3), hands.slice(3));
const same = (A, B) => A.every((v, k) => Math.abs(v - B[k]) < 1e-12);
