// What one picture shows: solids for WebGL in layers, and marks on the paper (lines, arcs, rings, labels) that lie under or over them.

import { add, along, length, scale, sides, sub, unit } from "./matrix.js";

export class Scene {
  constructor(colors, size) {
    this.colors = colors;
    this.size = size; // metres: how large the arm is; thicknesses follow it
    this.body = [];
    this.frames = [];
    this.faint = []; // see-through layers, painted before the body; the frames are painted after it, so that no link hides them
    this.solids = this.body;
    this.under = [];
    this.over = [];
    this.labels = [];
    this.kept = []; // points that must be in the picture
    this.lowest = 0;
  }

  // What is drawn inside is one see-through layer behind the body.
  seeThrough(opacity, draw) {
    const before = this.solids;
    this.solids = [];
    this.faint.push({ opacity, solids: this.solids });
    draw();
    this.solids = before;
  }

  // What is drawn inside lies over the body, so that no link hides a frame.
  onTop(draw) {
    const before = this.solids;
    if (before === this.body) this.solids = this.frames;
    const made = draw();
    this.solids = before;
    return made;
  }

  solid(mesh, columns, color, gloss) {
    const [u, v, w, p] = columns;
    const rgb = this.colors.rgb[color];
    this.solids.push({ mesh, color: rgb, gloss, matrix: [...u, 0, ...v, 0, ...w, 0, ...p, 1] });
  }

  between(mesh, from, to, radius, color, gloss = 0.12) {
    const way = sub(to, from);
    if (length(way) < 1e-9) return;
    const [u, v] = sides(unit(way));
    this.solid(mesh, [scale(u, radius), scale(v, radius), way, from], color, gloss);
  }

  stick(from, to, radius, color) {
    this.between("cylinder", from, to, radius, color);
    this.keep(from, to);
  }

  ball(at, radius, color) {
    this.solid("ball", [[radius, 0, 0], [0, radius, 0], [0, 0, radius], at], color, 0.12);
    this.keep(at);
  }

  // A cylinder (revolute) or a box (prismatic) round a joint axis.
  joint(at, direction, radius, half, color, slides) {
    const [u, v] = sides(direction);
    if (slides) this.solid("box", [scale(u, radius), scale(v, radius), scale(direction, half), at], color, 0.15);
    else this.between("cylinder", along(at, direction, -half), along(at, direction, half), radius, color, 0.15);
    this.keep(along(at, direction, half), along(at, direction, -half));
  }

  arrow(from, direction, reach, radius, color, dashed = false) {
    const head = Math.min(0.36 * reach, 9 * radius), neck = along(from, direction, reach - head), tip = along(from, direction, reach);
    const pieces = dashed ? [0.02, 0.27, 0.52, 0.77].map((start) => [start, start + 0.14]) : [[0, 1]];
    for (const ends of pieces) this.between("cylinder", ...ends.map((part) => along(from, direction, (reach - head) * part)), radius, color, 0.2);
    this.between("cone", neck, tip, 2.7 * radius, color, 0.2);
    this.keep(tip);
    return tip;
  }

  // A mesh that somebody brought, {corners, radius}, at a pose.
  shape(mesh, T, color) {
    this.solid(mesh, [0, 1, 2, 3].map((k) => [T[k], T[4 + k], T[8 + k]]), color, 0.1);
  }

  keep(...points) {
    this.kept.push(...points);
  }

  line(points, style) {
    (style.under ? this.under : this.over).push({ points, ...style });
  }

  // A measured length beside a line, as on a drawing.
  dimension(from, to, style) {
    this.over.push({ dimension: true, points: [from, to], pixels: 2, ...style });
  }

  ring(at, radius, style) {
    this.over.push({ ring: at, radius, ...style });
    this.keep(at);
  }

  // An arc from one direction by an angle about an axis, with its sector; returns its middle.
  arc(centre, from, about, angle, radius, style) {
    const side = [about[1] * from[2] - about[2] * from[1], about[2] * from[0] - about[0] * from[2], about[0] * from[1] - about[1] * from[0]];
    const at = (t) => add(centre, add(scale(from, radius * Math.cos(t)), scale(side, radius * Math.sin(t))));
    const many = Math.max(12, Math.ceil(Math.abs(angle) * 14));
    const points = Array.from({ length: many + 1 }, (_, k) => at((angle * k) / many));
    this.line([centre, ...points, centre], { ...style, fill: true });
    this.line(points, { ...style, head: true });
    return at(angle / 2);
  }

  // A text near a point; toward (a direction) says on which side it would like to stand. Earlier ones have the better places.
  label(text, at, { toward = null, color = "ink", far = false, size = 13, weight = 400, key = text } = {}) {
    this.labels.push({ text, at, toward, color, far, size, weight, key });
  }

  shadowOf(points, width) {
    const flat = points.map(([x, y]) => [x, y, this.lowest]);
    this.under.push({ points: flat, color: "shadow", pixels: 0, metres: width });
    this.keep(...flat);
  }
}
