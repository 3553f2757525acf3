// From a scene to a canvas: floor, shadow, solids, marks, labels, in this order.

import { MILLIMETRES } from "./format.js";
import { Ink, placeLabels } from "./labels.js";

const FONT = '"Segoe UI", system-ui, "DejaVu Sans", sans-serif';
const STEPS = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5];

export class Paper {
  constructor(canvas, renderer) {
    this.canvas = canvas;
    this.context = canvas.getContext("2d");
    this.renderer = renderer;
    this.widths = new Map();
    this.places = new Map();
    this.labels = []; // the boxes of the last picture
  }

  paint(scene, camera) {
    const { context: c, canvas } = this;
    const dots = Math.min(2, devicePixelRatio || 1), width = Math.round(camera.width * dots), height = Math.round(camera.height * dots);
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
    c.setTransform(dots, 0, 0, dots, 0, 0);
    c.clearRect(0, 0, camera.width, camera.height);
    c.lineCap = c.lineJoin = "round";
    this.floor(scene, camera);
    for (const mark of scene.under) this.mark(mark, scene, camera);
    c.setTransform(1, 0, 0, 1, 0, 0);
    for (const { solids, opacity } of scene.faint) this.renderer.paint([solids], camera, c, width, height, opacity);
    this.renderer.paint([scene.body, scene.frames], camera, c, width, height, 1);
    c.setTransform(dots, 0, 0, dots, 0, 0);
    for (const mark of scene.over) this.mark(mark, scene, camera);
    this.write(scene, camera);
  }

  // A grid of round steps under everything, with the step named in a corner.
  floor(scene, camera) {
    if (Math.abs(camera.toward[2]) < 0.03) return this.ground(scene, camera);
    const { low, high } = camera, step = STEPS.find((s) => Math.max(high[0] - low[0], high[1] - low[1]) / s < 11) ?? 10;
    const from = [0, 1].map((k) => Math.floor(low[k] / step - 0.3)), to = [0, 1].map((k) => Math.ceil(high[k] / step + 0.3));
    const z = scene.lowest, lines = [];
    for (let i = from[0]; i <= to[0]; i++) lines.push([[i * step, from[1] * step, z], [i * step, to[1] * step, z]]);
    for (let j = from[1]; j <= to[1]; j++) lines.push([[from[0] * step, j * step, z], [to[0] * step, j * step, z]]);
    for (const points of lines) this.mark({ points, color: "floor", pixels: 1 }, scene, camera);
    this.note(scene, camera, `grid ${step >= 1 ? `${step} m` : (scene.unit ?? MILLIMETRES).text(step)}`);
  }

  ground(scene, camera) {
    const y = camera.flat([camera.centre[0], camera.centre[1], scene.lowest])[1];
    const { context: c } = this;
    c.strokeStyle = scene.colors.floor;
    c.lineWidth = 1.5;
    c.beginPath();
    c.moveTo(12, y);
    c.lineTo(camera.width - 12, y);
    c.stroke();
  }

  note(scene, camera, text) {
    const { context: c } = this;
    c.font = `11px ${FONT}`;
    c.fillStyle = scene.colors.quiet;
    c.textAlign = "left";
    c.textBaseline = "alphabetic";
    c.fillText(text, 10, camera.height - 9);
  }

  mark(mark, scene, camera) {
    const { context: c } = this;
    c.strokeStyle = c.fillStyle = scene.colors[mark.color];
    c.lineWidth = mark.metres ? mark.metres * camera.scale : mark.pixels ?? 1.5;
    c.setLineDash(mark.dash ?? []);
    c.beginPath();
    if (mark.ring) {
      c.arc(...camera.flat(mark.ring), mark.radius, 0, 2 * Math.PI);
      if (mark.fill) c.fill();
      else c.stroke();
    } else {
      const flat = mark.dimension ? this.aside(mark, camera) : mark.points.map((p) => camera.flat(p));
      flat.forEach((p, k) => (k ? c.lineTo(...p) : c.moveTo(...p)));
      mark.flat = flat;
      this.stroke(mark, flat);
    }
    c.setLineDash([]);
    c.globalAlpha = 1;
  }

  stroke(mark, flat) {
    const { context: c } = this;
    c.globalAlpha = mark.alpha ?? 1;
    if (mark.fill) {
      c.globalAlpha = 0.14;
      c.fill();
      return;
    }
    c.stroke();
    if (mark.head || mark.dimension) this.head(flat, c.strokeStyle);
  }

  // Where a length is drawn: beside its line, away from the middle of the picture, with thin lines from its ends.
  aside({ points }, camera) {
    const [from, to] = points.map((p) => camera.flat(p)), far = Math.hypot(to[0] - from[0], to[1] - from[1]) || 1;
    const side = [(to[1] - from[1]) / far, (from[0] - to[0]) / far];
    const outward = side[0] * (from[0] + to[0] - camera.width) + side[1] * (from[1] + to[1] - camera.height) > 0 ? 16 : -16;
    const [a, b] = [from, to].map((p) => [p[0] + side[0] * outward, p[1] + side[1] * outward]);
    const { context: c } = this;
    const width = c.lineWidth;
    c.lineWidth = 0.8;
    for (const [p, end] of [[from, a], [to, b]]) {
      c.moveTo(...p);
      c.lineTo(end[0] + 0.3 * (end[0] - p[0]), end[1] + 0.3 * (end[1] - p[1]));
    }
    c.stroke();
    c.lineWidth = width;
    c.beginPath();
    c.moveTo(...a);
    return [a, b];
  }

  head(flat, color) {
    const { context: c } = this, tip = flat[flat.length - 1];
    const back = flat.findLast((p) => Math.hypot(p[0] - tip[0], p[1] - tip[1]) > 5) ?? flat[0];
    const far = Math.hypot(tip[0] - back[0], tip[1] - back[1]);
    if (far < 2) return;
    const [x, y] = [(tip[0] - back[0]) / far, (tip[1] - back[1]) / far];
    c.fillStyle = color;
    c.beginPath();
    c.moveTo(tip[0] + 2 * x, tip[1] + 2 * y);
    c.lineTo(tip[0] - 9 * x - 4.5 * y, tip[1] - 9 * y + 4.5 * x);
    c.lineTo(tip[0] - 9 * x + 4.5 * y, tip[1] - 9 * y - 4.5 * x);
    c.fill();
  }

  measure(label) {
    const font = this.font(label), key = font + label.text;
    if (!this.widths.has(key)) {
      if (this.widths.size > 500) this.widths.clear();
      this.context.font = font;
      this.widths.set(key, this.context.measureText(label.text).width + 4);
    }
    return [this.widths.get(key), label.size + 3];
  }

  font(label) {
    return `${label.weight} ${label.size}px ${FONT}`;
  }

  write(scene, camera) {
    const { context: c } = this, ink = new Ink(camera.width, camera.height);
    for (const solids of [scene.body, scene.frames]) for (const solid of solids) this.darken(ink, solid, camera);
    for (const { flat = [] } of scene.over) for (let k = 1; k < flat.length; k++) ink.line(flat[k - 1], flat[k], 2);
    const marked = scene.over.filter((mark) => mark.ring).map((mark) => mark.ring);
    this.labels = placeLabels(scene.labels, camera, ink, (label) => this.measure(label), this.places, marked);
    c.textAlign = "center";
    c.textBaseline = "middle";
    for (const box of this.labels) this.letter(box, scene);
  }

  darken(ink, { matrix: m }, camera) {
    const from = camera.flat([m[12], m[13], m[14]]), to = camera.flat([m[12] + m[8], m[13] + m[9], m[14] + m[10]]);
    ink.line(from, to, 2);
  }

  letter({ label, at, led, left, right, top, bottom }, scene) {
    const { context: c } = this, x = (left + right) / 2, y = (top + bottom) / 2;
    const near = [Math.max(left, Math.min(right, at[0])), Math.max(top, Math.min(bottom, at[1]))];
    if (Math.hypot(near[0] - at[0], near[1] - at[1]) > (led ? 3 : label.far ? 13 : 20)) {
      c.strokeStyle = scene.colors.quiet;
      c.lineWidth = 0.8;
      c.beginPath();
      c.moveTo(...at);
      c.lineTo(...near);
      c.stroke();
    }
    c.font = this.font(label);
    c.strokeStyle = scene.colors.ground;
    c.lineWidth = 4;
    c.strokeText(label.text, x, y + 1);
    c.fillStyle = scene.colors[label.color];
    c.fillText(label.text, x, y + 1);
  }
}
