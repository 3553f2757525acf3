// The table as fields: offsets of theta, d, a, alpha in degrees and millimetres.

import { Table, h, write } from "../dom.js";
import { DEGREE } from "../format.js";
import { COLUMNS, isTurn } from "../kinematics.js";
import { headingsOf } from "../tables.js";

const factor = (kind) => (isTurn(kind) ? DEGREE : 1000);
const text = (value, kind) => String(Number((value * factor(kind)).toFixed(7)) + 0);

export class NumbersTable extends Table {
  constructor(arm, published, changed) {
    super("The numbers, in degrees and millimetres", ["i", ...headingsOf(arm.convention)], arm.rows.length);
    this.element.classList.add("numbers");
    this.arm = arm;
    this.fields = arm.rows.map((_, i) => COLUMNS.map((kind, k) => {
      const take = () => field.value !== "" && Number.isFinite(Number(field.value)) && field.value !== text(arm.rows[i][k], kind) && this.take(i, k, Number(field.value) / factor(kind), changed);
      const field = h("input", { type: "number", step: "any", required: true, "aria-label": `${kind} of row ${i + 1}, ${isTurn(kind) ? "degrees" : "millimetres"}`, onchange: take,
        onkeydown: (event) => event.key === "Enter" && take() });
      this.rows[i][k + 1].replaceChildren(field);
      return field;
    }));
    arm.rows.forEach((_, i) => write(this.rows[i][0], String(i + 1)));
    this.show(published);
  }

  take(i, k, value, changed) {
    this.arm.rows[i][k] = value;
    this.tell(i, k);
    changed();
  }

  // The numbers as they are; those that differ from the published ones are marked.
  show(published) {
    this.published = published;
    headingsOf(this.arm.convention).forEach((words, k) => write(this.head[k + 1], words));
    this.fields.forEach((row, i) => row.forEach((field, k) => {
      field.value = text(this.arm.rows[i][k], COLUMNS[k]);
      this.tell(i, k);
    }));
  }

  tell(i, k) {
    this.fields[i][k].classList.toggle("other", Math.abs(this.arm.rows[i][k] - this.published.rows[i][k]) > 1e-12);
  }
}
