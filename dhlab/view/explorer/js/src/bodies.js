// The arm as things to draw: links along the DH path, joints on their axes, frames as lettered arrows.

import { h } from "./dom.js";
import { below } from "./format.js";
import { jointPlaces, path } from "./kinematics.js";
import { axis, dot, length, origin, scale, sub } from "./matrix.js";

const NEAR = 1e-6; // metres; closer origins are one point to every eye
const PARALLEL = 1 - 1e-6;
export const REACH = 0.13; // of the arm's size, how long an arrow is
const LEAST = 0.055;

// The longest side of the upright box round points.
export const spread = (points) => Math.max(...[0, 1, 2].map((k) => Math.max(...points.map((p) => p[k])) - Math.min(...points.map((p) => p[k])))) || 0.1;

export function groups(points) {
  const found = [];
  points.forEach((p, k) => {
    const group = found.find(([first]) => length(sub(points[first], p)) < NEAR);
    if (group) group.push(k);
    else found.push([k]);
  });
  return found;
}

export function drawBody(scene, arm, chain, end, { link = "link", joint = "joint", shadow = true } = {}) {
  const { size } = scene, points = path(arm.convention, chain), radius = 0.012 * size;
  points.forEach((p, k) => {
    if (k) scene.stick(points[k - 1], p, radius, link);
    scene.ball(p, radius * 1.02, link);
  });
  if (length(sub(origin(end), points[points.length - 1])) > NEAR) scene.stick(points[points.length - 1], origin(end), 0.6 * radius, link);
  const places = jointPlaces(arm.convention, chain);
  for (const group of groups(places.map((place) => place.at))) {
    group.forEach((k, rank) => scene.joint(places[k].at, places[k].along, 0.026 * size * 0.78 ** rank, 0.04 * size * 1.3 ** rank, joint, arm.joints[k] === "P"));
  }
  if (shadow) scene.shadowOf([...points, origin(end)], 2.6 * radius);
  scene.keep(origin(end));
}

// Frames with names for subscripts ("3", "tool") and titles ("{3}"); those at one place share a title and share letters where axes coincide.
// Where one is `chosen`, the others give way to each other: their arrows end before the next frame. `letters` says which axes have one, (k, j).
export function drawTriads(scene, poses, names, titles, { chosen = null, reach = REACH * scene.size, thick = 0.0052 * scene.size, letters = true, dashed = false, key = "" } = {}) {
  const at = groups(poses.map(origin)), longest = new Map();
  scene.onTop(() => at.forEach((group) => {
    const room = chosen === null || group.includes(chosen) ? 1 : elbowRoom(poses, at, group, reach);
    group.forEach((k, rank) => {
      longest.set(k, reach * room * (1 + 0.28 * rank));
      for (const j of [0, 1, 2]) scene.arrow(origin(poses[k]), axis(poses[k], j), longest.get(k), thick * (room < 1 ? 0.75 : 1) * (j === 2 ? 1.3 : 1), "xyz"[j], dashed);
    });
    scene.ball(origin(poses[group[0]]), 1.75 * thick, "ink");
  }));
  if (titles) {
    for (const group of [...at].reverse()) {
      const away = scale(group.flatMap((k) => [0, 1, 2].map((j) => axis(poses[k], j))).reduce((a, b) => a.map((v, i) => v + b[i])), -1);
      scene.label(group.map((k) => titles[k]).join(", "), origin(poses[group[0]]), { toward: away, far: true, weight: 600, key: `${key}title${group[0]}` });
    }
  }
  if (letters) for (const group of [...at].reverse()) letterAxes(scene, poses, names, group, longest, key, letters);
}

// What part of its length a frame's arrows keep, so that they end before the next frame's origin.
function elbowRoom(poses, at, group, reach) {
  const own = origin(poses[group[0]]), gaps = at.filter((other) => other !== group).map((other) => length(sub(origin(poses[other[0]]), own)));
  return Math.min(0.75, Math.max(LEAST / REACH, (0.8 * Math.min(...gaps)) / reach));
}

function letterAxes(scene, poses, names, group, longest, key, letters) {
  let left = group.flatMap((k) => [0, 1, 2].map((j) => ({ k, j, along: axis(poses[k], j) }))).filter(({ k, j }) => letters === true || letters(k, j));
  while (left.length) {
    const [{ along: first }] = left, same = left.filter((entry) => dot(entry.along, first) > PARALLEL);
    left = left.filter((entry) => !same.includes(entry));
    const far = Math.max(...same.map((entry) => longest.get(entry.k))), start = origin(poses[group[0]]);
    const tip = start.map((v, i) => v + far * first[i]);
    const text = [...new Set(same.map((entry) => "xyz"[entry.j] + below(names[entry.k])))].join(" ");
    const color = same.every((entry) => entry.j === same[0].j) ? "xyz"[same[0].j] : "ink"; // x on another frame's z is neither's colour
    scene.label(text, tip, { toward: first, color, key: `${key}axis${same[0].k}${same[0].j}` });
  }
}

// Frames of an arm with its tool's, as all views name them.
export function named(arm, chain, end) {
  const names = chain.map((_, k) => String(k)), titles = names.map((name) => `{${name}}`);
  if (!isIdentity(arm.base)) titles[0] = "{0} base";
  if (isIdentity(arm.tool)) return { poses: chain, names, titles };
  return { poses: [...chain, end], names: [...names, " tool"], titles: [...titles, "tool"] };
}

export const isIdentity = (T) => T.every((v, k) => v === (k % 5 ? 0 : 1));

export function legend(...entries) {
  return h("p", { class: "legend" }, ...entries.flatMap(([kind, text]) => [h("span", { class: `swatch ${kind}`, "aria-hidden": "true" }), `${text} `]));
}
