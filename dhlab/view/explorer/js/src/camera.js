// Where one looks from. Orthographic: parallel axes stay parallel and equal lengths equal, which kinematics needs.

import { cross, dot, length } from "./matrix.js";

const HOME = { azimuth: -58, elevation: 24 }; // degrees, as matplotlib counts them
export const VIEWS = { Home: HOME, Front: { azimuth: -90, elevation: 0 }, Side: { azimuth: 0, elevation: 0 }, Top: { azimuth: -90, elevation: 90 } };
const ENOUGH = 0.38, ASIDE = [0, 10, -10, 20, 30, 40, -50, -60]; // how far apart axes must look; turns to try, the least first
const MARGIN = 46; // pixels kept free for labels
const CELLS = 24, MOST = 4000; // how fine the points that must be seen are told apart, and how many are kept
const range = (values) => values.reduce(([low, high], v) => [Math.min(low, v), Math.max(high, v)], [Infinity, -Infinity]);

export class Camera {
  constructor() {
    this.zoom = 1;
    this.seen = new Map(); // points that must be in the picture, one for each cell of a grid
    this.turnTo(HOME);
  }

  turnTo({ azimuth, elevation }) {
    this.azimuth = azimuth;
    this.elevation = Math.max(-90, Math.min(90, elevation));
    const a = (this.azimuth * Math.PI) / 180, e = (this.elevation * Math.PI) / 180;
    this.toward = [Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e)];
    this.right = [-Math.sin(a), Math.cos(a), 0];
    this.up = cross(this.toward, this.right);
  }

  // Home; turned aside where one of these axes would look as if it lay along another.
  turnHome(axes) {
    const ways = ASIDE.map((aside) => ({ ...HOME, azimuth: HOME.azimuth + aside }));
    const clear = ways.map((way) => (this.turnTo(way), Math.min(ENOUGH, this.clarity(axes))));
    this.turnTo(ways[clear.indexOf(Math.max(...clear))]);
  }

  // How far the tip of an axis is from the line of another one on the picture, as a part of what it is in space; of all pairs the least.
  clarity(axes) {
    const flat = axes.map((v) => [dot(this.right, v), dot(this.up, v)]);
    let least = 1;
    axes.forEach((v, i) => axes.slice(0, i).forEach((w, j) => {
      const apart = length(cross(v, w)), [a, b] = [flat[i], flat[j]];
      if (apart > 1e-3) least = Math.min(least, Math.abs(a[0] * b[1] - a[1] * b[0]) / Math.max(Math.hypot(...a), Math.hypot(...b)) / apart);
    }));
    return least;
  }

  turnBy(azimuth, elevation) {
    this.turnTo({ azimuth: this.azimuth + azimuth, elevation: this.elevation + elevation });
  }

  zoomBy(factor) {
    this.zoom = Math.max(0.4, Math.min(6, this.zoom * factor));
  }

  // Start to fit anew: what must be seen then only grows, so that the picture keeps still under a moving slider.
  forget() {
    this.seen.clear();
    this.zoom = 1;
  }

  include(points, size) {
    for (const p of points) {
      const cell = Math.round((p[0] * CELLS) / size) * 1e8 + Math.round((p[1] * CELLS) / size) * 1e4 + Math.round((p[2] * CELLS) / size);
      if (!this.seen.has(cell) && this.seen.size < MOST) this.seen.set(cell, p);
    }
  }

  // Decide the scale for a canvas of this many CSS pixels.
  fit(width, height) {
    const points = [...this.seen.values()], margin = Math.min(MARGIN, width / 9);
    const [across, upward, inward] = [this.right, this.up, this.toward].map((d) => range(points.map((p) => dot(p, d))));
    this.width = width;
    this.height = height;
    [this.low, this.high] = [0, 1].map((end) => [0, 1, 2].map((k) => range(points.map((p) => p[k]))[end]));
    this.scale = this.zoom * Math.min((width - 2 * margin) / (across[1] - across[0] || 0.1), (height - 2 * margin) / (upward[1] - upward[0] || 0.1));
    this.offset = [(across[0] + across[1]) / 2, (upward[0] + upward[1]) / 2];
    this.inward = (inward[0] + inward[1]) / 2;
    this.depth = 3 * Math.max(inward[1] - inward[0], across[1] - across[0], upward[1] - upward[0]) + 0.1;
    this.centre = this.low.map((v, k) => (v + this.high[k]) / 2);
  }

  // A point on the canvas, CSS pixels from its upper left corner.
  flat(p) {
    return [this.width / 2 + (dot(this.right, p) - this.offset[0]) * this.scale, this.height / 2 - (dot(this.up, p) - this.offset[1]) * this.scale];
  }

  // World to clip space, column by column as WebGL wants it.
  matrix() {
    const x = (2 * this.scale) / this.width, y = (2 * this.scale) / this.height, z = -1 / this.depth;
    const { right: r, up: u, toward: t } = this;
    return new Float32Array([r[0] * x, u[0] * y, t[0] * z, 0, r[1] * x, u[1] * y, t[1] * z, 0, r[2] * x, u[2] * y, t[2] * z, 0,
      -this.offset[0] * x, -this.offset[1] * y, -this.inward * z, 1]);
  }

  rotation() {
    const { right: r, up: u, toward: t } = this;
    return new Float32Array([r[0], u[0], t[0], r[1], u[1], t[1], r[2], u[2], t[2]]);
  }
}
