// Python in a worker, as the page sees it: run a cell, stop it, hear what it says.

const ASIDE = { "explorer.js": new URL("../_static/explorer.js", import.meta.url), "cards.js": new URL("cards.js", import.meta.url) };

export class Kernel {
  // told(message) hears all that is no answer: display, stream, error, replace, loading, ready, lost, broken.
  constructor(told, log = "") {
    this.told = told;
    this.log = log;
    this.models = new Map();
    this.waiting = [];
    this.calls = new Map();
    this.open();
  }

  open() {
    this.ready = false;
    this.worker = new Worker(new URL("worker.js", import.meta.url), { type: "module" });
    this.worker.onmessage = ({ data }) => this.hear(JSON.parse(data));
    this.worker.onerror = (event) => this.told({ type: "broken", text: event.message || "the worker did not start" });
    this.flag = self.crossOriginIsolated ? new Uint8Array(new SharedArrayBuffer(1)) : null;
    this.worker.postMessage({ type: "start", log: this.log, buffer: this.flag });
  }

  get busy() {
    return this.waiting.length > 0;
  }

  // Cells run one after another; true when all went well.
  run(cell, source) {
    if (this.flag) this.flag[0] = 0;
    return new Promise((resolve) => {
      this.waiting.push({ cell, resolve });
      this.worker.postMessage({ type: "run", cell, source });
    });
  }

  // A function of a Python module, from text to text.
  call(module, name, text) {
    const id = crypto.randomUUID?.() ?? String(Math.random());
    return new Promise((resolve) => {
      this.calls.set(id, resolve);
      this.worker.postMessage({ type: "call", id, module, name, text });
    });
  }

  // What runs is interrupted where the site is isolated; elsewhere Python is ended and begun anew.
  stop() {
    if (this.flag && this.ready) {
      this.flag[0] = 2;
      return;
    }
    this.again();
    this.told({ type: "lost" });
  }

  again() {
    this.worker.terminate();
    const [left, calls] = [this.waiting.splice(0), [...this.calls.values()]];
    this.calls.clear();
    this.models.clear();
    for (const { resolve } of left) resolve(false);
    for (const resolve of calls) resolve(null);
    this.open();
  }

  hear(message) {
    if (message.type === "done") {
      this.log = message.log;
      const at = this.waiting.findIndex(({ cell }) => cell === message.cell);
      const [{ resolve }] = this.waiting.splice(at, 1);
      this.told(message);
      resolve(message.ok);
    } else if (message.type === "answer") {
      this.calls.get(message.id)?.(message.text);
      this.calls.delete(message.id);
    } else if (message.type === "widget-state") this.models.get(message.id)?.update(message.state);
    else if (message.type === "widget-message") this.models.get(message.id)?.emit("msg:custom", message.content);
    else {
      if (message.type === "ready") this.ready = true;
      if (message.type === "broken") for (const { resolve } of this.waiting.splice(0)) resolve(false);
      this.told(message);
    }
  }

  // A widget's view into an element.
  async show({ id, module, state }, el) {
    const model = this.models.get(id) ?? new Model(id, state, (message) => this.worker.postMessage({ type: "widget", id, ...message }));
    this.models.set(id, model);
    const { default: view } = await import(ASIDE[module]);
    view.render({ model, el });
  }
}

// What anywidget gives a view: values that both sides know.
class Model {
  constructor(id, state, post) {
    Object.assign(this, { state: { ...state }, post, changed: {}, heard: new Map() });
  }

  get(name) {
    return this.state[name];
  }

  set(name, value) {
    this.state[name] = this.changed[name] = value;
    this.emit(`change:${name}`);
    this.emit("change");
  }

  save_changes() {
    this.post({ state: this.changed });
    this.changed = {};
  }

  send(content) {
    this.post({ content });
  }

  update(state) {
    Object.assign(this.state, state);
    for (const name of Object.keys(state)) this.emit(`change:${name}`);
    this.emit("change");
  }

  on(event, heard) {
    this.heard.set(event, [...(this.heard.get(event) ?? []), heard]);
  }

  off(event, heard) {
    this.heard.set(event, (this.heard.get(event) ?? []).filter((one) => one !== heard));
  }

  emit(event, content) {
    for (const heard of this.heard.get(event) ?? []) heard(content);
  }
}
