// Numbers as people read them: degrees, metres or millimetres, no trailing zeros, a true minus sign.

export const DEGREE = 180 / Math.PI;

export function number(value, digits = 2) {
  const text = value.toFixed(digits);
  const short = text.includes(".") ? text.replace(/\.?0+$/, "") : text;
  return short === "-0" ? "0" : short.replace("-", "−");
}

export const degrees = (angle, digits = 2) => `${number(angle * DEGREE, digits)}°`;
export const millimetres = (length, digits = 1) => `${number(length * 1000, digits)} mm`;
export const vector = (v, digits = 3) => `(${v.map((x) => number(x, digits)).join(", ")})`;
export const below = (text) => String(text).replace(/[0-9]/g, (digit) => "₀₁₂₃₄₅₆₇₈₉"[digit]);
export const SYMBOLS = { theta: "θ", d: "d", a: "a", alpha: "α" };
export const TITLES = { standard: "standard DH", craig: "Craig's DH" };

// A unit of length, and how places, lengths and the values of a row are written in it.
const unit = (name, word, factor, step, digits) => {
  const bare = (length) => number(length * factor, digits), text = (length) => `${bare(length)} ${name}`;
  return { name, word, factor, step, digits, bare, text, amount: (value, turn) => (turn ? degrees(value) : text(value)),
    place: (p) => `${["x", "y", "z"].map((letter, k) => `${letter} = ${bare(p[k])}`).join(", ")} ${name}` };
};
export const METRES = unit("m", "metres", 1, 0.001, 4), MILLIMETRES = unit("mm", "millimetres", 1000, 1, 1);
export const unitOf = (data) => (data.metres ? METRES : MILLIMETRES);

// An axis (3,) in words: the world axis it lies on, or its components.
export function direction(v) {
  const k = [0, 1, 2].reduce((best, j) => (Math.abs(v[j]) > Math.abs(v[best]) ? j : best), 0);
  return Math.abs(v[k]) > 1 - 1e-6 ? `along ${v[k] > 0 ? "+" : "−"}${"xyz"[k]}` : `along ${vector(v)}`;
}
