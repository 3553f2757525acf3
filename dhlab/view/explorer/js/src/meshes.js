// Four solids of unit size, as flat lists of [position, normal] per corner and triangles: what every picture is put together from.

const ROUND = 28;

function cylinder() { // radius 1, z from 0 to 1
  const mesh = { corners: [], triangles: [] };
  strip(mesh, (c, s) => [[c, s, 0, c, s, 0], [c, s, 1, c, s, 0]]);
  cap(mesh, 0, -1);
  cap(mesh, 1, 1);
  return mesh;
}

function cone() { // radius 1 at z = 0, tip at z = 1; the slope of its side is set for arrow heads
  const mesh = { corners: [], triangles: [] };
  strip(mesh, (c, s) => [[c, s, 0, c, s, 0.9], [0, 0, 1, c, s, 0.9]]);
  cap(mesh, 0, -1);
  return mesh;
}

function strip(mesh, pair) {
  const first = mesh.corners.length;
  for (let k = 0; k <= ROUND; k++) {
    const angle = (2 * Math.PI * k) / ROUND;
    mesh.corners.push(...pair(Math.cos(angle), Math.sin(angle)));
    if (k < ROUND) {
      const i = first + 2 * k;
      mesh.triangles.push(i, i + 2, i + 1, i + 1, i + 2, i + 3);
    }
  }
}

function cap(mesh, z, sense) {
  const first = mesh.corners.length;
  mesh.corners.push([0, 0, z, 0, 0, sense]);
  for (let k = 0; k <= ROUND; k++) {
    const angle = (2 * Math.PI * k) / ROUND;
    mesh.corners.push([Math.cos(angle), Math.sin(angle), z, 0, 0, sense]);
    if (k) mesh.triangles.push(first, ...(sense > 0 ? [first + k, first + k + 1] : [first + k + 1, first + k]));
  }
}

function ball() {
  const mesh = { corners: [], triangles: [] }, rings = 12;
  for (let i = 0; i <= rings; i++) {
    const polar = (Math.PI * i) / rings;
    for (let k = 0; k <= ROUND; k++) {
      const angle = (2 * Math.PI * k) / ROUND;
      const p = [Math.sin(polar) * Math.cos(angle), Math.sin(polar) * Math.sin(angle), Math.cos(polar)];
      mesh.corners.push([...p, ...p]);
      const here = i * (ROUND + 1) + k, below = here + ROUND + 1;
      if (i < rings && k < ROUND) mesh.triangles.push(here, below, here + 1, here + 1, below, below + 1);
    }
  }
  return mesh;
}

function box() { // from -1 to 1
  const mesh = { corners: [], triangles: [] };
  for (const k of [0, 1, 2]) {
    for (const sense of [1, -1]) {
      const first = mesh.corners.length;
      for (const [s, t] of [[-1, -1], [1, -1], [1, 1], [-1, 1]]) {
        const p = [0, 0, 0], normal = [0, 0, 0];
        [p[k], p[(k + 1) % 3], p[(k + 2) % 3], normal[k]] = [sense, s * sense, t, sense];
        mesh.corners.push([...p, ...normal]);
      }
      mesh.triangles.push(first, first + 1, first + 2, first, first + 2, first + 3);
    }
  }
  return mesh;
}

export const MESHES = { cylinder: cylinder(), cone: cone(), ball: ball(), box: box() };
