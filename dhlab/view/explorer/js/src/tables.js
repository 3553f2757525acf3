// The tables under the view: the DH table as it is now, and the frames for those who read instead of look.

import { Table, write } from "./dom.js";
import { MILLIMETRES, SYMBOLS, TITLES, vector } from "./format.js";
import { COLUMNS, isTurn, rowAt } from "./kinematics.js";
import { axis, origin } from "./matrix.js";

export function headingsOf(convention) {
  return COLUMNS.map((kind) => {
    const behind = convention === "craig" && (kind === "a" || kind === "alpha");
    return `${SYMBOLS[kind]}${behind ? "ᵢ₋₁" : "ᵢ"}`;
  });
}

export class DHTable extends Table {
  constructor(arm, unit = MILLIMETRES, title = `Table now, ${TITLES[arm.convention]}`, light = null) { // light: a row is lit with its link
    super(title, ["i", ...headingsOf(arm.convention)], arm.rows.length);
    [this.arm, this.unit] = [arm, unit];
    [...arm.joints].forEach((letter, i) => this.mark(i, letter === "P" ? 2 : 1, "variable"));
    this.buttons = light && this.lines.map((line, i) => {
      const button = light.button(String(i + 1), i, `row ${i + 1}, lit with its link`);
      this.rows[i][0].replaceChildren(button);
      light.from(line, i);
      return button;
    });
  }

  // The headings of the arm as it is now.
  retitle() {
    write(this.caption, `Table now, ${TITLES[this.arm.convention]}`);
    headingsOf(this.arm.convention).forEach((text, k) => write(this.head[k + 1], text));
  }

  light(on) {
    this.lines.forEach((line, i) => line.classList.toggle("now", i === on));
    this.buttons.forEach((button) => button.darken());
  }

  update(q) {
    this.set(this.arm.rows.map((_, i) => [this.buttons ? null : String(i + 1), ...rowTexts(rowAt(this.arm, q, i), this.unit)]));
  }
}

const rowTexts = (row, unit) => COLUMNS.map((kind, k) => unit.amount(row[k], isTurn(kind)));

export class FramesTable extends Table {
  constructor(titles, unit = MILLIMETRES, caption = "The frames, in the world") {
    super(caption, ["frame", ...["x", "y", "z"].map((letter) => `${letter} (${unit.name})`), "x axis", "y axis", "z axis"], titles.length);
    [this.titles, this.unit] = [titles, unit];
  }

  update(poses) {
    this.set(poses.map((T, k) => [this.titles[k], ...origin(T).map(this.unit.bare), ...[0, 1, 2].map((j) => vector(axis(T, j)))]));
  }
}
