// Vectors as arrays of 3, poses as arrays of 16, row by row, as numpy writes them.

export const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

export const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scale = (a, s) => [a[0] * s, a[1] * s, a[2] * s];
export const along = (p, direction, s) => [p[0] + direction[0] * s, p[1] + direction[1] * s, p[2] + direction[2] * s];
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const length = (a) => Math.hypot(a[0], a[1], a[2]);
export const unit = (a) => scale(a, 1 / (length(a) || 1));
export const middle = (a, b) => scale(add(a, b), 0.5);

export const origin = (T) => [T[3], T[7], T[11]];
export const axis = (T, k) => [T[k], T[4 + k], T[8 + k]];

export function product(A, B) {
  const C = new Array(16);
  for (let i = 0; i < 16; i += 4) {
    for (let j = 0; j < 4; j++) C[i + j] = A[i] * B[j] + A[i + 1] * B[4 + j] + A[i + 2] * B[8 + j] + A[i + 3] * B[12 + j];
  }
  return C;
}

// The angle of the turn that takes the axes of A to those of B, without loss for small angles.
export function angleBetween(A, B) {
  const gap = Math.hypot(...[0, 1, 2].map((k) => length(sub(axis(A, k), axis(B, k)))));
  return 2 * Math.asin(Math.min(1, gap / Math.sqrt(8)));
}

// Fixed-axis roll, pitch, yaw: T = Rz(yaw) Ry(pitch) Rx(roll).
export function rollPitchYaw(T) {
  const cosPitch = Math.hypot(T[0], T[4]);
  if (cosPitch < 1e-9) return [0, Math.atan2(-T[8], cosPitch), Math.atan2(-T[1], T[5])];
  return [Math.atan2(T[9], T[10]), Math.atan2(-T[8], cosPitch), Math.atan2(T[4], T[0])];
}

// The pose with its origin at p and the turns of rollPitchYaw.
export function poseOf(p, [roll, pitch, yaw]) {
  const [cr, sr, cp, sp, cy, sy] = [roll, pitch, yaw].flatMap((angle) => [Math.cos(angle), Math.sin(angle)]);
  return [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr, p[0], sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr, p[1],
    -sp, cp * sr, cp * cr, p[2], 0, 0, 0, 1];
}

// The turn about the origin that takes one unit vector to another by the shortest way.
export function turnTo(from, to) {
  const v = cross(from, to), c = dot(from, to);
  if (c < -1 + 1e-9) return IDENTITY.slice(); // half a turn has no shortest way; a hand comes past it
  const k = 1 / (1 + c), [x, y, z] = v;
  return [1 - k * (y * y + z * z), k * x * y - z, k * x * z + y, 0, k * x * y + z, 1 - k * (x * x + z * z), k * y * z - x, 0,
    k * x * z - y, k * y * z + x, 1 - k * (x * x + y * y), 0, 0, 0, 0, 1];
}

export function inverse(T) {
  const p = origin(T), back = [0, 1, 2].map((k) => -dot(axis(T, k), p));
  return [T[0], T[4], T[8], back[0], T[1], T[5], T[9], back[1], T[2], T[6], T[10], back[2], 0, 0, 0, 1];
}

// Two unit vectors that complete a direction to a right-handed frame.
export function sides(direction) {
  const least = [0, 1, 2].reduce((k, j) => (Math.abs(direction[j]) < Math.abs(direction[k]) ? j : k), 0);
  const helper = [0, 0, 0];
  helper[least] = 1;
  const u = unit(cross(direction, helper));
  return [u, cross(direction, u)];
}
