// From one configuration to the next in two ways: each joint straight, or the hand straight with the joints found on the way.

import { turned } from "../inverse.js";
import { forward } from "../kinematics.js";
import { axis, cross, dot, length, origin, product, inverse, unit } from "../matrix.js";

export const STEPS = 90; // of each stretch
const JUMP = 0.35; // radians or arm's sizes in one step; more is another branch

// One stretch after the other through the configurations: {qs, faults}, a fault being {kind: "out" or "jump", step, joint}.
export function path(arm, poses, way, size) {
  const qs = [poses[0]], faults = [];
  for (let k = 1; k < poses.length; k++) {
    if (way === "joints") for (let s = 1; s <= STEPS; s++) qs.push(between(poses[k - 1], poses[k], s / STEPS));
    else handStraight(arm, poses[k - 1], poses[k], size, qs, faults);
  }
  return { qs, faults };
}

const between = (from, to, t) => from.map((v, i) => v + t * (to[i] - v));

function handStraight(arm, from, to, size, qs, faults) {
  const start = forward(arm, from), end = forward(arm, to), first = qs.length;
  let q = from, out = false;
  for (let s = 1; s <= STEPS; s++) {
    const next = turned(arm, q, blended(start, end, s / STEPS), size), step = next.q.map((v, i) => Math.abs(v - q[i])), far = Math.max(...step);
    if (far > JUMP) faults.push({ kind: "jump", step: qs.length, joint: step.indexOf(far) + 1 });
    if (!next.reached && !out) faults.push({ kind: "out", step: qs.length, part: s / STEPS });
    out ||= !next.reached;
    qs.push((q = next.q));
  }
  const apart = to.map((v, i) => Math.abs(v - q[i])), worst = Math.max(...apart);
  if (!out && worst > JUMP) faults.push({ kind: "other", step: first, joint: apart.indexOf(worst) + 1 });
}

// The pose a part of the way from one to the other: its origin on a line, its turn about one axis.
export function blended(A, B, t) {
  const turn = product(inverse(A), B), p = origin(A), goal = origin(B), [about, angle] = axisAngle(turn), T = product(A, spin(about, t * angle));
  [T[3], T[7], T[11]] = p.map((v, k) => v + t * (goal[k] - v));
  return T;
}

function axisAngle(T) {
  const skew = [T[9] - T[6], T[2] - T[8], T[4] - T[1]], sine = length(skew) / 2, cosine = (T[0] + T[5] + T[10] - 1) / 2;
  if (sine > 1e-6) return [unit(skew), Math.atan2(sine, cosine)];
  if (cosine > 0) return [[0, 0, 1], 0];
  const k = [0, 1, 2].reduce((best, j) => (T[5 * j] > T[5 * best] ? j : best), 0); // half a turn: the axis is a column of T + 1
  return [unit(axis(T, k).map((v, j) => v + Number(j === k))), Math.PI];
}

function spin(z, angle) {
  const c = Math.cos(angle), s = Math.sin(angle), columns = [0, 1, 2].map((k) => {
    const e = [0, 1, 2].map((j) => Number(j === k)), w = cross(z, e), d = (1 - c) * dot(z, e);
    return e.map((v, j) => c * v + s * w[j] + d * z[j]);
  });
  const [x, y, w] = columns;
  return [x[0], y[0], w[0], 0, x[1], y[1], w[1], 0, x[2], y[2], w[2], 0, 0, 0, 0, 1];
}
