// What a number and a picture share: a place in a table that is pointed at, by mouse, finger or keys, lights what it stands for in the view.

import { Table, h, write } from "./dom.js";
import { number } from "./format.js";

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

// Numbers in columns, each column with a button on top that lights it. `headings` are [[text, name, key], ...].
export class LitColumns extends Table {
  constructor(caption, headings, rows, light) {
    super(caption, headings.map(() => ""), rows, false);
    this.element.classList.add("matrix");
    this.keys = headings.map(([, , key]) => key);
    this.buttons = headings.map(([text, name, key], k) => {
      const button = light.button(text, key, name);
      this.head[k].replaceChildren(button);
      this.rows.forEach((cells) => light.from(cells[k], key));
      return button;
    });
  }

  light(on) {
    this.keys.forEach((key, k) => {
      this.buttons[k].darken();
      for (const cell of [this.head[k], ...this.rows.map((cells) => cells[k])]) cell.classList.toggle("lit", key === on);
    });
  }
}

// A pose as its four columns, in metres, with the digits that numpy shows.
export class Matrix extends LitColumns {
  constructor(caption, headings, light) {
    super(caption, headings, 4, light);
    this.headings = headings;
  }

  update(T) {
    for (let i = 0; i < 4; i++) for (let k = 0; k < 4; k++) write(this.rows[i][k], number(T[4 * i + k], 3));
  }
}
