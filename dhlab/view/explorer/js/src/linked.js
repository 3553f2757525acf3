// What a number and a picture share: a place in a table that is pointed at, by mouse, finger or keys, lights what it stands for in the view.

import { Table, h, write } from "./dom.js";
import { number } from "./format.js";
import { add, along, axis, dot, origin, scale, sub } from "./matrix.js";

export const AXES = ["x", "y", "z"];

// One thing is lit at a time: `point` while something is pointed at, `hold` until it is held again.
export class Light {
  constructor(changed) {
    this.changed = changed;
    this.pointed = this.held = null;
  }

  get on() {
    return this.pointed ?? this.held;
  }

  point(key) {
    if (key === this.pointed) return;
    this.pointed = key;
    this.changed(this.on);
  }

  hold(key) {
    this.held = key === this.held ? null : key;
    this.changed(this.on);
  }

  // Light `key` while the mouse is over an element or the keys are at it.
  from(element, key) {
    element.addEventListener("pointerenter", (event) => event.pointerType !== "touch" && this.point(key));
    element.addEventListener("pointerleave", () => this.point(null));
    element.addEventListener("focusin", (event) => event.target.matches(":focus-visible") && this.point(key));
    element.addEventListener("focusout", () => this.point(null));
    return element;
  }

  // A button that lights `key` while it is pointed at, and keeps it lit when it is pressed.
  button(text, key, name) {
    const button = this.from(h("button", { type: "button", class: "light", "aria-pressed": "false", "aria-label": `${text}: ${name}`, onclick: () => {
      this.hold(key);
      button.setAttribute("aria-pressed", String(this.held === key));
    } }, text), key);
    button.darken = () => button.setAttribute("aria-pressed", String(this.held === key));
    return button;
  }
}

// Numbers in columns, each column with a button on top that lights it. `headings` are [[text, name, key], ...], `names` those of the rows.
export class LitColumns extends Table {
  constructor(caption, headings, rows, light, names = null) {
    super(caption, [...(names ? [""] : []), ...headings.map(() => "")], rows, Boolean(names));
    this.element.classList.add("matrix");
    this.first = names ? 1 : 0;
    names?.forEach((name, i) => write(this.rows[i][0], name));
    if (names) this.head[0].replaceWith(h("td"));
    this.columns = headings.map(([text, name, key], k) => {
      const cells = [this.head[k + this.first], ...this.rows.map((row) => row[k + this.first])], button = light.button(text, key, name);
      cells[0].replaceChildren(button);
      cells.slice(1).forEach((cell) => light.from(cell, key));
      return { key, cells, button };
    });
  }

  put(i, k, value) {
    write(this.rows[i][k + this.first], number(value, 3));
  }

  light(on) {
    for (const { key, cells, button } of this.columns) {
      button.darken();
      for (const cell of cells) cell.classList.toggle("lit", key === on);
    }
  }
}

// A pose as its four columns, in metres, with the digits that numpy shows.
export class Matrix extends LitColumns {
  constructor(caption, headings, light) {
    super(caption, headings, 4, light);
  }

  update(T) {
    for (let i = 0; i < 4; i++) for (let k = 0; k < 4; k++) this.put(i, k, T[4 * i + k]);
  }
}

// A column of a pose as what it is: the way to its arrow's tip, or to its origin, along the arrows of the frame in which it is written.
export function drawColumn(scene, T, seen, column, arrow) {
  const whole = column === 3, from = origin(whole ? seen : T), size = whole ? 1 : arrow, color = whole ? "error" : AXES[column];
  const way = whole ? sub(origin(T), origin(seen)) : axis(T, column);
  scene.onTop(() => {
    if (whole) scene.ball(origin(T), 0.1 * arrow, color);
    else scene.arrow(from, way, 1.04 * arrow, 0.045 * arrow, color);
  });
  let at = from;
  for (const k of [0, 1, 2]) {
    const part = dot(way, axis(seen, k));
    if (Math.abs(part) < 5e-4) continue;
    const to = along(at, axis(seen, k), part * size);
    scene.line([at, to], { color: AXES[k], pixels: 2.5, dash: [5, 4] });
    scene.label(number(part, 3), scale(add(at, to), 0.5), { color: AXES[k], far: true, weight: 600, key: `part${k}` });
    scene.keep(to);
    at = to;
  }
}
