// From a pose back to joint values, one near to where the arm stands: damped least squares within the limits.

import { endOf, frames, jacobian } from "./kinematics.js";
import { add, axis, cross, length, origin, scale, sub } from "./matrix.js";

const ROUNDS = 60, TRIES = 30;
const REACHED = 1e-4; // of the arm's size; for a turn, in radians, ten times as much

// q (n,) that brings the end to `target`: there with the same turn where that can be, else to its place alone. `reached` says whether it is there.
// Where the arm is stuck, other ways to the place are tried, and the nearest one is taken.
export function reach(arm, q, target, size) {
  const whole = follow(arm, q, target, size, true);
  if (whole.reached) return whole;
  const place = follow(arm, whole.q, target, size, false);
  if (place.reached) return place;
  const others = starts(arm, q, size).map((start) => follow(arm, start, target, size, false)).filter((one) => one.reached);
  const far = (one) => Math.hypot(...one.q.map((v, i) => v - q[i]));
  return others.reduce((best, one) => (!best || far(one) < far(best) ? one : best), null) ?? place;
}

// The same to a pose with its turn, as near as it goes, without another way.
export const turned = (arm, q, target, size) => follow(arm, q, target, size, true);

function follow(arm, start, target, size, turn) {
  let q = kept(arm, start), now = missing(arm, q, target, size, turn), damping = 1e-3;
  for (let round = 0; round < ROUNDS && !now.reached && damping < 1e6; round++) {
    const next = kept(arm, step(arm, q, now, damping, size, turn)), then = missing(arm, next, target, size, turn);
    if (then.cost < now.cost) {
      const gain = (now.cost - then.cost) / now.cost;
      [q, now, damping] = [next, then, Math.max(1e-9, damping / 4)];
      if (gain < 1e-7) break;
    } else damping *= 6;
  }
  return { q, reached: now.reached };
}

function missing(arm, q, target, size, turn) {
  const chain = frames(arm, q), end = endOf(arm, chain), way = scale(sub(origin(target), origin(end)), 1 / size);
  const about = turn ? scale([0, 1, 2].map((k) => cross(axis(end, k), axis(target, k))).reduce(add), 0.5) : [];
  const error = [...way, ...about], far = length(way);
  return { chain, end, error, cost: error.reduce((sum, v) => sum + v * v, 0), reached: far < REACHED && (!turn || length(about) < 10 * REACHED) };
}

// One damped step; a joint that would leave its limits stands still, and the others do its part.
function step(arm, q, { chain, end, error }, damping, size, turn) {
  const columns = jacobian(arm, chain, end).map((c) => [c[0] / size, c[1] / size, c[2] / size, ...(turn ? c.slice(3) : [])]);
  const free = q.map(() => true);
  for (let again = 0; again < q.length; again++) {
    const square = error.map((_, i) => error.map((_, j) => columns.reduce((sum, c, k) => sum + (free[k] ? c[i] * c[j] : 0), i === j ? damping : 0)));
    const pull = solved(square, error), moved = columns.map((c, k) => (free[k] ? c.reduce((sum, v, i) => sum + v * pull[i], 0) : 0));
    const largest = Math.max(...moved.map(Math.abs)), share = largest > 0.6 ? 0.6 / largest : 1;
    const next = q.map((v, k) => v + share * moved[k]), over = next.findIndex((v, k) => free[k] && outside(arm, k, v) && outside(arm, k, q[k] + Math.sign(moved[k]) * 1e-9));
    if (over < 0) return next;
    free[over] = false;
  }
  return q;
}

const outside = ({ limits }, k, v) => Boolean(limits?.[k]) && (v < limits[k][0] || v > limits[k][1]);

// Joint values brought into their limits.
export const kept = ({ limits }, q) => q.map((v, k) => (limits?.[k] ? Math.max(limits[k][0], Math.min(limits[k][1], v)) : v));

// The same places to start from every time, spread over the limits by steps that never meet.
const STEPS = [0.754877666, 0.569840291, 0.414213562, 0.324717957, 0.236067977, 0.618033988, 0.732050808];
function starts(arm, q, size) {
  const spans = q.map((_, k) => span(arm, k, size));
  return Array.from({ length: TRIES }, (_, t) => spans.map(([low, high], k) => low + (high - low) * (((t + 1) * STEPS[k % STEPS.length]) % 1)));
}

// What a joint's limits leave of one turn, or of the arm's size.
function span({ joints, limits }, k, size) {
  const free = joints[k] === "P" ? size : Math.PI, [low, high] = limits?.[k] ?? [-free, free];
  return high - low > 2 * free ? [-free, free] : [low, high];
}

// A small system of equations, symmetric and positive, by Gauss.
function solved(matrix, right) {
  const rows = matrix.map((row, i) => [...row, right[i]]), n = rows.length;
  for (let i = 0; i < n; i++) {
    for (let k = i + 1; k < n; k++) {
      const part = rows[k][i] / rows[i][i];
      for (let j = i; j <= n; j++) rows[k][j] -= part * rows[i][j];
    }
  }
  const x = new Array(n);
  for (let i = n - 1; i >= 0; i--) x[i] = rows[i].slice(i + 1, n).reduce((rest, v, j) => rest - v * x[i + 1 + j], rows[i][n]) / rows[i][i];
  return x;
}
