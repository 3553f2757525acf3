// What hands take hold of in an arm: its end, to move it; the tips of the end's arrows, to turn it; a joint; a link.

import { reach, kept, turned } from "./inverse.js";
import { jointPlaces, path } from "./kinematics.js";
import { add, along, axis, cross, dot, length, origin, product, scale, sub, turnTo, unit } from "./matrix.js";

const APART = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]);
const EDGE = 0.35; // an axis this little towards the viewer is seen from its side
const ROUND = 70; // pixels for one radian then

// The thing near a point of the canvas: {kind: "end"}, {kind: "tip", column}, {kind: "joint", i}, {kind: "link", i, row, at}; or null.
export function found({ arm, chain, end, arrow, size }, at, camera, near) {
  const off = (p) => APART(camera.flat(p), at), tips = [0, 1, 2].map((k) => along(origin(end), axis(end, k), arrow));
  const tip = nearest(tips.map(off));
  if (off(origin(end)) <= 0.8 * near && off(origin(end)) <= off(tips[tip])) return { kind: "end" };
  if (off(tips[tip]) <= 0.7 * near) return { kind: "tip", column: tip, at: tips[tip] };
  const places = jointPlaces(arm.convention, chain), joint = nearest(places.map((one) => off(one.at)));
  if (off(places[joint].at) <= 0.6 * near) return { kind: "joint", i: joint, row: joint };
  return link({ arm, chain, end, size }, places, at, camera, near);
}

const nearest = (values) => values.indexOf(Math.min(...values));

function link({ arm, chain, end, size }, places, at, camera, near) {
  const points = [...path(arm.convention, chain), origin(end)];
  const pieces = points.slice(1).map((to, k) => between(at, camera.flat(points[k]), camera.flat(to)));
  const best = nearest(pieces.map((one) => one.far)), { far, part } = pieces[best];
  if (far > 0.5 * near) return null;
  const p = add(points[best], scale(sub(points[best + 1], points[best]), part)), n = chain.length - 1, row = Math.min(best >> 1, n - 1);
  const carries = arm.convention === "standard" ? row : best === 2 * n ? n - 1 : best % 2 ? row : row - 1; // the last joint that can move it
  for (let i = carries; i >= 0; i--) if (arm.joints[i] === "P" || lever(places[i], p) > 0.03 * size) return { kind: "link", i, row, at: p };
  return { kind: "link", i: -1, row, at: p };
}

const lever = ({ at, along: z }, p) => length(cross(z, sub(p, at)));

function between(at, a, b) {
  const [x, y] = [b[0] - a[0], b[1] - a[1]], part = Math.max(0, Math.min(1, ((at[0] - a[0]) * x + (at[1] - a[1]) * y) / (x * x + y * y || 1)));
  return { part, far: Math.hypot(at[0] - a[0] - part * x, at[1] - a[1] - part * y) };
}

// What follows the pointer from here on: a function of where it is that gives the new q.
export function held(view, one, start, camera) {
  if (one.kind === "end") return moving(view, start, camera);
  if (one.kind === "tip") return turning(view, one.column, camera);
  if (one.i < 0) return null;
  const place = jointPlaces(view.arm.convention, view.chain)[one.i];
  if (view.arm.joints[one.i] === "P") return drawn(view, one.i, one.at ?? place.at, () => place.along, start, camera);
  if (one.kind === "link") return drawn(view, one.i, one.at, (p) => cross(place.along, sub(p, place.at)), start, camera, place);
  return dialled(view, one.i, place, start, camera);
}

// The end follows in the plane of the picture, with the turn it had.
function moving({ arm, q, end, size }, start, camera) {
  const [x, y] = camera.flat(origin(end)), aside = [start[0] - x, start[1] - y], first = origin(end);
  let now = q;
  return (at) => {
    const from = camera.flat(first), [right, down] = [0, 1].map((j) => (at[j] - aside[j] - from[j]) / camera.scale);
    const to = add(first, add(scale(camera.right, right), scale(camera.up, -down))), target = end.slice();
    [target[3], target[7], target[11]] = to;
    return (now = reach(arm, now, target, size).q);
  };
}

// An arrow of the end follows on a ball round it.
function turning({ arm, q, end, size, arrow }, column, camera) {
  const side = Math.sign(dot(axis(end, column), camera.toward)) || 1;
  let now = q;
  return (at) => {
    const middle = camera.flat(origin(end)), radius = arrow * camera.scale, [x, y] = [(at[0] - middle[0]) / radius, (middle[1] - at[1]) / radius];
    const deep = side * Math.sqrt(Math.max(0, 1 - x * x - y * y));
    const wanted = unit(add(add(scale(camera.right, x), scale(camera.up, y)), scale(camera.toward, deep))), target = product(turnTo(axis(end, column), wanted), end);
    [target[3], target[7], target[11]] = origin(end);
    return (now = turned(arm, now, target, size).q);
  };
}

// One joint alone, so that a point of its link stays under the pointer.
function drawn({ arm, q }, i, point, rate, start, camera, place = null) {
  const first = camera.flat(point), aside = [start[0] - first[0], start[1] - first[1]], sense = arm.sign[i] || 1;
  let amount = 0;
  return (at) => {
    for (let round = 0; round < 4; round++) {
      const p = place ? add(place.at, about(place.along, amount, sub(point, place.at))) : along(point, rate(point), amount);
      const v = rate(p), flow = [dot(camera.right, v) * camera.scale, -dot(camera.up, v) * camera.scale], here = camera.flat(p);
      const gap = [at[0] - aside[0] - here[0], at[1] - aside[1] - here[1]];
      amount += Math.max(-0.3, Math.min(0.3, (gap[0] * flow[0] + gap[1] * flow[1]) / (flow[0] ** 2 + flow[1] ** 2 + 100)));
    }
    const next = kept(arm, q.map((v, k) => (k === i ? v + sense * amount : v)));
    amount = (next[i] - q[i]) / sense;
    return next;
  };
}

// A joint by its own body: round its middle where its end is seen, across its axis where its side is.
function dialled({ arm, q }, i, { at: centre, along: z }, start, camera) {
  const facing = dot(z, camera.toward), sense = arm.sign[i] || 1;
  let last = start, amount = 0;
  return (at) => {
    const middle = camera.flat(centre);
    if (Math.abs(facing) > EDGE) {
      const turn = ([x, y]) => Math.atan2(middle[1] - y, x - middle[0]), step = turn(at) - turn(last);
      if (APART(at, middle) > 6) amount += Math.sign(facing) * Math.atan2(Math.sin(step), Math.cos(step));
    } else {
      const v = cross(z, camera.toward), flow = unit([dot(camera.right, v), -dot(camera.up, v), 0]);
      amount += ((at[0] - last[0]) * flow[0] + (at[1] - last[1]) * flow[1]) / ROUND;
    }
    last = at;
    const next = kept(arm, q.map((v, k) => (k === i ? v + sense * amount : v)));
    amount = (next[i] - q[i]) / sense;
    return next;
  };
}

// A vector turned about a unit axis.
function about(z, angle, v) {
  const c = Math.cos(angle), s = Math.sin(angle), w = cross(z, v), t = (1 - c) * dot(z, v);
  return [0, 1, 2].map((k) => c * v[k] + s * w[k] + t * z[k]);
}
