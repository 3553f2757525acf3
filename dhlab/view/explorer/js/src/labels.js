// Labels that keep out of each other's way: each tries places around its point and takes the cheapest; one that finds none free waits for a better view.

const CELL = 5; // pixels of the grid that says where lines run
const RAYS = 16;
const SWAPPED = 9;
const SAME = 12; // pixels; one label for two of one text at points nearer than this
const GAPS = { near: [4, 10, 17], far: [9, 18, 30, 44, 60, 78] };

export class Ink {
  constructor(width, height) {
    this.columns = Math.ceil(width / CELL);
    this.rows = Math.ceil(height / CELL);
    this.cells = new Uint8Array(this.columns * this.rows);
  }

  line([x0, y0], [x1, y1], weight) {
    const steps = Math.min(400, Math.ceil(Math.hypot(x1 - x0, y1 - y0) / CELL) || 1);
    for (let k = 0; k <= steps; k++) {
      const column = Math.floor((x0 + ((x1 - x0) * k) / steps) / CELL), row = Math.floor((y0 + ((y1 - y0) * k) / steps) / CELL);
      if (column >= 0 && row >= 0 && column < this.columns && row < this.rows) this.cells[row * this.columns + column] = weight;
    }
  }

  under(box) {
    let sum = 0;
    const last = [Math.min(this.columns - 1, Math.floor(box.right / CELL)), Math.min(this.rows - 1, Math.floor(box.bottom / CELL))];
    for (let row = Math.max(0, Math.floor(box.top / CELL)); row <= last[1]; row++) {
      for (let column = Math.max(0, Math.floor(box.left / CELL)); column <= last[0]; column++) sum += this.cells[row * this.columns + column];
    }
    return sum;
  }
}

const overlaps = (a, b) => a.left < b.right + 2 && b.left < a.right + 2 && a.top < b.bottom + 1 && b.top < a.bottom + 1;

// The places of labels {text, at, toward, far, key}, as boxes in pixels; `before` remembers each one's ray, so that it does not jump about. `marked` are other points that a label beside them would seem to name.
export function placeLabels(labels, camera, ink, measure, before, marked = []) {
  const placed = [], points = labels.map((label) => camera.flat(label.at)), named = [...points, ...marked.map((at) => camera.flat(at))];
  for (const [k, label] of labels.entries()) {
    const at = points[k], [width, height] = measure(label);
    if (placed.some((one) => one.label.text === label.text && one.label.color === label.color && Math.hypot(one.at[0] - at[0], one.at[1] - at[1]) < SAME)) continue;
    const others = named.filter((p) => apart(p, at) > SAME);
    const best = cheapest(candidates(label, at, camera), (ray) => {
      const box = boxAt(ray, at, width, height);
      return price(ray, box, placed, ink, camera, before.get(label.key)) + (strays(box, at, others) ? SWAPPED : 0);
    });
    if (!best) continue;
    before.set(label.key, best.index);
    const box = boxAt(best, at, width, height);
    placed.push({ label, at, gap: best.gap, led: strays(box, at, others), ...box });
  }
  return placed;
}

const apart = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]);
const gapTo = (box, p) => apart(p, [Math.max(box.left, Math.min(box.right, p[0])), Math.max(box.top, Math.min(box.bottom, p[1]))]);

// Whether a label stands nearer to what another one names, or to a mark, than to its own point: it then costs more, and gets a line.
const strays = (box, at, others) => others.some((p) => gapTo(box, p) < gapTo(box, at) + 2);

function candidates(label, at, camera) {
  let start = -Math.PI / 4;
  if (label.toward) {
    const tip = camera.flat(label.at.map((v, k) => v + label.toward[k] * 0.01));
    const flat = [tip[0] - at[0], tip[1] - at[1]];
    if (Math.hypot(...flat) > 0.1) start = Math.atan2(flat[1], flat[0]);
  }
  const rays = [];
  GAPS[label.far ? "far" : "near"].forEach((gap, g) => {
    for (let k = 0; k < RAYS; k++) {
      const turn = (k % 2 ? 1 : -1) * Math.ceil(k / 2) * ((2 * Math.PI) / RAYS);
      rays.push({ index: g * RAYS + k, gap, turn: Math.abs(turn), x: Math.cos(start + turn), y: Math.sin(start + turn) });
    }
  });
  return rays;
}

function boxAt(ray, at, width, height) {
  const reach = ray.gap + Math.min(width / 2 / (Math.abs(ray.x) || 1e-9), height / 2 / (Math.abs(ray.y) || 1e-9));
  const x = at[0] + ray.x * reach, y = at[1] + ray.y * reach;
  return { left: x - width / 2, right: x + width / 2, top: y - height / 2, bottom: y + height / 2 };
}

function price(ray, box, placed, ink, camera, last) {
  if (box.left < 1 || box.top < 1 || box.right > camera.width - 1 || box.bottom > camera.height - 1) return Infinity;
  if (placed.some((other) => overlaps(box, other))) return Infinity;
  return ink.under(box) + 0.16 * ray.gap + 1.6 * ray.turn - (ray.index === last ? 3 : 0);
}

function cheapest(rays, cost) {
  let best = null, least = Infinity;
  for (const ray of rays) {
    const here = cost(ray);
    if (here < least) [best, least] = [ray, here];
  }
  return best;
}
