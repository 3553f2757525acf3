// An STL file as a mesh for the view: corners with normals, three to a triangle, in metres.

export function stl(buffer) {
  const view = new DataView(buffer), count = buffer.byteLength >= 84 ? view.getUint32(80, true) : -1;
  const points = buffer.byteLength === 84 + 50 * count ? binary(view, count) : text(new TextDecoder().decode(buffer));
  return points.length && points.every(Number.isFinite) ? points : null;
}

function binary(view, count) {
  const points = [];
  for (let i = 0; i < count; i++) for (let k = 0; k < 9; k++) points.push(view.getFloat32(84 + 50 * i + 12 + 4 * k, true));
  return points;
}

function text(words) {
  const points = [...words.matchAll(/vertex\s+(\S+)\s+(\S+)\s+(\S+)/g)].flatMap((found) => [1, 2, 3].map((k) => Number(found[k])));
  return points.slice(0, points.length - (points.length % 9));
}

// The largest distance from the origin: what says whether a file is in metres or millimetres.
export const extent = (points) => points.reduce((far, v) => Math.max(far, Math.abs(v)), 0);

// What the renderer draws: positions and flat normals, and the ball round them.
export function meshOf(points, scale) {
  const corners = new Float32Array(points.length * 2);
  let radius = 0;
  for (let i = 0; i < points.length; i += 9) {
    const p = points.slice(i, i + 9).map((v, k) => v * scale[k % 3]), [a, b] = [0, 1].map((j) => [3, 4, 5].map((k) => p[k + 3 * j] - p[k - 3]));
    const n = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]], far = Math.hypot(...n) || 1;
    for (let j = 0; j < 3; j++) {
      corners.set([...p.slice(3 * j, 3 * j + 3), ...n.map((v) => v / far)], 2 * i + 6 * j);
      radius = Math.max(radius, Math.hypot(...p.slice(3 * j, 3 * j + 3)));
    }
  }
  return { corners, radius };
}
