// The product itself, as dhlab/kinematics.py has it: one arm, one configuration.
// An arm is {convention, joints, rows, base, tool, sign, coupling, limits, name}; rows hold [theta, d, a, alpha] in radians and metres.

import { IDENTITY, along, axis, cross, dot, middle, origin, product, sub } from "./matrix.js";

export const ORDERS = { standard: ["theta", "d", "a", "alpha"], craig: ["alpha", "a", "theta", "d"] };
export const COLUMNS = ["theta", "d", "a", "alpha"];
export const isTurn = (kind) => kind === "theta" || kind === "alpha";

// One elementary move: theta and d about and along z, a and alpha along and about x.
export function move(kind, value) {
  const T = IDENTITY.slice();
  const c = Math.cos(value), s = Math.sin(value);
  if (kind === "theta") [T[0], T[1], T[4], T[5]] = [c, -s, s, c];
  else if (kind === "alpha") [T[5], T[6], T[9], T[10]] = [c, -s, s, c];
  else T[kind === "a" ? 3 : 11] = value;
  return T;
}

export function linkMatrix(convention, [theta, d, a, alpha]) {
  const ct = Math.cos(theta), st = Math.sin(theta), ca = Math.cos(alpha), sa = Math.sin(alpha);
  return convention === "standard"
    ? [ct, -st * ca, st * sa, a * ct, st, ct * ca, -ct * sa, a * st, 0, sa, ca, d, 0, 0, 0, 1]
    : [ct, -st, 0, a, st * ca, ct * ca, -sa, -d * sa, st * sa, ct * sa, ca, d * ca, 0, 0, 0, 1];
}

// What q makes of joint i (from 0), before the offsets of the table.
function jointValue({ sign, coupling }, q, i) {
  return coupling ? coupling[i].reduce((sum, rate, j) => sum + rate * sign[j] * q[j], 0) : sign[i] * q[i];
}

// Row i (from 0) with the joint variable in its place.
export function rowAt(arm, q, i) {
  const row = arm.rows[i].slice();
  row[arm.joints[i] === "P" ? 1 : 0] += jointValue(arm, q, i);
  return row;
}

// Every frame of the chain, the base first; the tool is not included.
export function frames(arm, q) {
  const chain = [arm.base];
  for (let i = 0; i < arm.rows.length; i++) chain.push(product(chain[i], linkMatrix(arm.convention, rowAt(arm, q, i))));
  return chain;
}

export const endOf = (arm, chain) => product(chain[chain.length - 1], arm.tool);
export const forward = (arm, q) => endOf(arm, frames(arm, q));

// Columns [vx, vy, vz, ωx, ωy, ωz] of the geometric Jacobian at the end, in the frame of the base, for what q counts.
export function jacobian(arm, chain, end) {
  const columns = [...arm.joints].map((letter, i) => {
    const frame = chain[arm.convention === "standard" ? i : i + 1], z = axis(frame, 2);
    return letter === "P" ? [...z, 0, 0, 0] : [...cross(z, sub(origin(end), origin(frame))), ...z];
  });
  const rate = (i, j) => (arm.coupling ? arm.coupling[i][j] : Number(i === j)) * arm.sign[j];
  return columns.map((_, j) => [0, 1, 2, 3, 4, 5].map((k) => columns.reduce((sum, column, i) => sum + column[k] * rate(i, j), 0)));
}

// The way from origin to origin along d and a: origins at the even places, corners between them.
export function path(convention, chain) {
  const points = [origin(chain[0])];
  for (let i = 1; i < chain.length; i++) {
    const from = origin(chain[i - 1]), to = origin(chain[i]);
    const first = axis(chain[i - 1], convention === "standard" ? 2 : 0);
    points.push(along(from, first, dot(sub(to, from), first)), to);
  }
  return points;
}

// Where each joint is drawn, in the middle of its d, and the direction of its axis.
export function jointPlaces(convention, chain) {
  const points = path(convention, chain), standard = convention === "standard";
  return chain.slice(1).map((frame, i) => ({
    at: middle(points[standard ? 2 * i : 2 * i + 1], points[standard ? 2 * i + 1 : 2 * i + 2]),
    along: axis(standard ? chain[i] : frame, 2),
  }));
}
