// An arrow of a finished arm turned round: the frame makes half a turn, and the entries that go with it change together.

import { button } from "../controls.js";
import { h, write } from "../dom.js";
import { below } from "../format.js";
import { add, cross, scale } from "../matrix.js";
import { DHTable } from "../tables.js";
import { prefersStillness } from "../theme.js";

const SECONDS = 1;
const START = "Turn an arrow round: which entries change, so that the arm stays the same? What you placed stays as it is.";

// The arm with x_i or z_i turned round; what happens to frame 0 is taken up by the base, what happens to the last by the tool.
export function turnedRound(arm, letter, i) {
  const rows = arm.rows.map((row) => row.slice()), sign = arm.sign.slice(), standard = arm.convention === "standard";
  const half = (k) => [i - 1, i].forEach((j) => rows[j] && (rows[j][k] += rows[j][k] > 1e-9 ? -Math.PI : Math.PI));
  const against = (j, columns) => rows[j] && columns.forEach((k) => { rows[j][k] = k === 0 && rows[j][k] > Math.PI - 1e-9 ? Math.PI : 0 - rows[j][k]; });
  half(letter === "x" ? 0 : 3);
  if (letter === "x") against(standard ? i - 1 : i, [2, 3]); // the row that walks along x_i
  else {
    const joint = standard ? i : i - 1;
    against(joint, [0, 1]);
    if (rows[joint]) sign[joint] *= -1;
  }
  return { ...arm, rows, sign };
}

// The table of a finished arm with a button for each arrow; `settled` and `moving` give the frames, at rest and on their way.
export function roundabout(first, unit, redraw, turned) {
  const n = first.rows.length, table = new DHTable(first, unit, "The finished table"), words = h("p", { class: "hint", role: "status" }, START);
  const away = { x: Array(n + 1).fill(1), z: Array(n + 1).fill(1) }; // -1: turned round
  const row = (letter) => h("div", { class: "transport", role: "group", "aria-label": `Turn ${letter} round` },
    ...away[letter].map((_, i) => button(`${letter}${below(i)} ↻`, () => turn(letter, i), { "aria-label": `Turn ${letter}${i} round` })));
  let arm = first, now = null;
  table.update(first.sign.map(() => 0));
  return { element: h("div", {}, table.element, row("x"), row("z"), words), settled, moving };

  function turn(letter, i) {
    now = prefersStillness() ? null : { letter, i, part: 0 };
    arm = turnedRound(arm, letter, i);
    away[letter][i] *= -1;
    table.arm = arm;
    table.update(arm.sign.map(() => 0));
    arm.rows.forEach((row, j) => row.forEach((value, k) => table.mark(j, k + 1, "differs", differs(value, first.rows[j][k], k))));
    write(words, said(letter, i));
    turned();
  }

  function said(letter, i) {
    const standard = first.convention === "standard", last = (j) => j >= 1 && j <= n, named = (symbol, list) => list.map((j) => symbol + below(j)).join(" and ");
    const ends = i === 0 ? ", and the base" : i === n ? ", and the tool" : "", own = standard ? last(i) : last(i + 1);
    if (letter === "x") return `x${below(i)} round: ${named("θ", [i, i + 1].filter(last))} by 180°${own ? `, ${named("a", [i])} and ${named("α", [i])} with the other sign` : ""}${ends}. The arm is the same.`;
    const joint = standard ? i + 1 : i, turns = (standard ? [i, i + 1] : [i - 1, i]).filter((j) => (standard ? last(j) : j >= 0 && j < n));
    return `z${below(i)} round: ${named("α", turns)} by 180°${last(joint) ? `, θ${below(joint)} and d${below(joint)} with the other sign; joint ${joint} counts the other way` : ""}${ends}. The arm is the same.`;
  }

  // The steps placed, with the arrows that are turned round.
  function settled(placed) {
    const seen = new Map(placed);
    for (const letter of ["x", "z"]) away[letter].forEach((way, i) => seen.set(letter + i, scale(placed.get(letter + i), way)));
    return seen;
  }

  // The same while an arrow is on its way.
  function moving(placed, time) {
    const seen = settled(placed);
    if (!now) return seen;
    now.part = Math.min(1, now.part + Math.min(0.1, (time - (now.last ?? time - 16)) / 1000) / SECONDS);
    now.last = time;
    const { letter, i, part } = now, angle = Math.PI * (1 - part), v = seen.get(letter + i), about = seen.get((letter === "x" ? "z" : "x") + i);
    seen.set(letter + i, add(scale(v, Math.cos(angle)), scale(cross(about, v), Math.sin(angle))));
    if (part === 1) now = null;
    redraw();
    return seen;
  }
}

// Angles that differ by whole turns are one.
function differs(a, b, k) {
  return k === 0 || k === 3 ? Math.abs(Math.sin((a - b) / 2)) > 1e-9 : Math.abs(a - b) > 1e-12;
}
