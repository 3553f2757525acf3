// A lesson at work: its cells, the bar over them, what Python says and what is kept. Fetched when somebody runs it.

import { editor } from "./editor.js";
import { button, h } from "./elements.js";
import { Kernel } from "./kernel.js";
import { Outputs } from "./outputs.js";
import { Log, Work } from "./store.js";

const SIZES = { numpy: "2.6 MB", scipy: "12 MB", matplotlib: "6 MB", sympy: "4 MB" };

export class Lesson {
  constructor(name, note, places, notebook) {
    this.name = name;
    this.work = new Work(name, notebook);
    this.log = new Log();
    const cells = notebook.cells.filter((cell) => cell.cell_type === "code");
    this.bar(note);
    for (const pressed of document.querySelectorAll(".predict-options button")) pressed.replaceWith(...pressed.childNodes); // cards come under the cell
    for (const list of document.querySelectorAll(".predict-options")) list.classList.remove("predict-options");
    this.kernel = new Kernel((message) => this.hear(message), this.log.text);
    this.say("Python is being started …");
    this.cells = cells.map((cell, k) => new Cell(this, cell.id, places[k], k));
    this.current = this.cells[0];
    addEventListener("pagehide", () => this.work.save());
    document.documentElement.classList.add("live");
    this.cells[0].area.focus({ preventScroll: true });
    if (!this.work.kept) this.say("This browser keeps nothing for this page: save your work as a notebook before you leave.");
  }

  bar(note) {
    this.status = h("p", { class: "live-status", role: "status" });
    this.stopButton = button("Stop", () => this.kernel.stop());
    this.stopButton.disabled = true;
    const file = h("input", { type: "file", accept: ".ipynb", hidden: "", onchange: () => this.take(file) });
    const more = h(
      "details", { class: "live-more" }, h("summary", {}, "My work"),
      h("div", {},
        button("Save as a notebook", () => this.give()),
        button("Open a notebook …", () => file.click()),
        button("Begin this lesson again …", () => this.clear()),
        file),
    );
    this.element = h("section", { class: "live-bar", "aria-label": "Run this lesson" },
      button("Run to here", () => this.upTo(this.current)), button("Run all", () => this.upTo(this.cells.at(-1))),
      this.stopButton, button("Restart", () => this.restart()), more, this.status);
    note.after(this.element);
  }

  say(words) {
    this.status.textContent = words;
  }

  hear(message) {
    const cell = this.cells?.find(({ id }) => id === message.cell);
    if (message.type === "stream") cell?.outputs.stream(message);
    else if (message.type === "display") cell?.outputs.display(message);
    else if (message.type === "error") (cell ?? this.current).outputs.error(message.text);
    else if (message.type === "replace") cell?.replace(message.source);
    else if (message.type === "loading") this.loading(message.file);
    else if (message.type === "loaded") this.say("Running …");
    else if (message.type === "ready") this.say(this.anew || "Python is ready. Shift and Enter run a cell and go to the next.");
    else if (message.type === "lost") this.lost("Stopped. Python begins anew and knows no names: go to your cell and press Run to here.");
    else if (message.type === "broken") this.say(`Python stopped: ${message.text}. Press Restart; your work is kept.`);
    else if (message.type === "done") this.log.add(message.log);
  }

  loading(file) {
    if (this.anew) return;
    const name = file.split("-")[0];
    this.say(`Fetching ${name}${SIZES[name] ? ` (${SIZES[name]}, once)` : ""} …`);
  }

  lost(words) {
    for (const cell of this.cells) cell.state("");
    this.stopButton.disabled = true;
    this.anew = words; // stands until a cell runs: what Python fetches meanwhile says nothing over it
    this.say(words);
  }

  async run(cell) {
    this.anew = "";
    cell.outputs.clear();
    cell.state("running");
    this.stopButton.disabled = false;
    if (this.kernel.ready) this.say("Running …");
    this.work.save();
    const ok = await this.kernel.run(cell.id, cell.text);
    if (cell.shown === "running") cell.state(ok ? "ran" : "failed");
    if (!this.kernel.busy) {
      this.stopButton.disabled = true;
      if (this.kernel.ready && cell.shown) this.say(ok ? "Ready." : "A cell ended with an error; it says which line.");
    }
    return ok;
  }

  // The cells up to one, those that ran already left out; the first that fails ends it.
  async upTo(last) {
    for (const cell of this.cells.slice(0, last.position + 1)) {
      if (cell.shown === "ran" && cell !== last) continue;
      if (!(await this.run(cell))) return cell.area.focus();
    }
  }

  restart() {
    this.kernel.again();
    this.lost("Python begins anew and knows no names.");
  }

  give() {
    const link = h("a", { href: URL.createObjectURL(new Blob([this.work.asNotebook()], { type: "application/x-ipynb+json" })), download: `${this.name}.ipynb` });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
    this.say(`Saved as ${this.name}.ipynb: the notebook that you hand in, or open in JupyterLab.`);
  }

  async take(file) {
    if (!file.files.length) return;
    const wrong = this.work.fromNotebook(await file.files[0].text());
    file.value = "";
    if (!wrong) for (const cell of this.cells) cell.reset();
    this.say(wrong || "The notebook's cells stand here now. Run them to see what they give.");
  }

  clear() {
    if (!confirm("Take all you wrote in this lesson away? Save it as a notebook first if you may want it.")) return;
    this.work.clear();
    for (const cell of this.cells) cell.reset();
    this.restart();
  }
}

class Cell {
  constructor(lesson, id, place, position) {
    Object.assign(this, { lesson, id, place, position, shown: "" });
    this.editor = editor(lesson.work.source(id), `Cell ${position + 1}`, {
      changed: (text) => this.changed(text),
      run: (onwards) => this.run(onwards),
    });
    this.area = this.editor.area;
    this.area.addEventListener("focus", () => { lesson.current = this; });
    const start = h("button", { type: "button", class: "live-run", "aria-label": `Run cell ${position + 1}`, title: "Run (Shift and Enter)", onclick: () => this.run(false) }, "▶");
    const given = place.querySelector(":scope > .cell_input");
    given.replaceChildren(h("div", { class: "live-cell" }, start, this.editor.element));
    place.querySelector(":scope > .cell_output")?.remove();
    const output = h("div", { class: "cell_output docutils container live-output" });
    place.append(output);
    this.outputs = new Outputs(output, () => lesson.kernel);
    this.beside();
  }

  get text() {
    return this.editor.text;
  }

  // What was written for an earlier version of this cell.
  beside() {
    const text = this.lesson.work.earlier[this.id];
    if (text === undefined) return;
    this.place.append(h("details", { class: "live-earlier" }, h("summary", {}, "This cell has changed since you wrote in it. What you wrote:"), h("pre", { tabindex: "0" }, text)));
  }

  changed(text) {
    this.lesson.work.write(this.id, text);
    clearTimeout(this.later);
    this.later = setTimeout(() => this.lesson.work.save(), 300);
    if (this.shown === "ran") this.state("changed");
  }

  // Python writes what hands chose into the cell.
  replace(source) {
    this.editor.text = source;
    this.lesson.work.write(this.id, source);
  }

  reset() {
    this.editor.text = this.lesson.work.source(this.id);
    this.outputs.clear();
    this.state("");
    this.place.querySelector(".live-earlier")?.remove();
  }

  state(name) {
    this.shown = name;
    this.place.dataset.live = name;
  }

  run(onwards) {
    this.lesson.current = this;
    if (onwards) this.lesson.cells[this.position + 1]?.area.focus();
    return this.lesson.run(this);
  }
}
