// The view itself: a canvas that is turned by mouse, touch and keys, and drawn when something has changed.

import { Camera, VIEWS } from "./camera.js";
import { button } from "./controls.js";
import { h } from "./dom.js";
import { enlist, renderer, schedule } from "./loop.js";
import { Paper } from "./paper.js";
import { Scene } from "./scene.js";
import { COLORS, theme } from "./theme.js";

const MOUSE = 16, FINGER = 28; // pixels around what is meant
const near = (event) => (event.pointerType === "touch" ? FINGER : MOUSE);
const KEYS = { ArrowLeft: [8, 0], ArrowRight: [-8, 0], ArrowUp: [0, 6], ArrowDown: [0, -6] };

export class Stage {
  constructor(label, mode) {
    this.mode = mode;
    this.camera = new Camera();
    this.turnHome();
    this.canvas = h("canvas", { tabindex: 0, role: "application", "aria-roledescription": "3D view",
      "aria-label": `${label}. Arrow keys turn the view, plus and minus zoom, 0 goes home.` });
    this.note = h("p", { class: "instead", hidden: true }, "This browser has no WebGL, so here is a still picture; sliders and tables work.");
    const views = h("div", { class: "views", role: "group", "aria-label": "View" },
      ...Object.keys(VIEWS).map((name) => button(name, () => this.look(name))),
      button("+", () => this.zoom(1.25), { "aria-label": "Zoom in" }), button("−", () => this.zoom(0.8), { "aria-label": "Zoom out" }));
    this.readout = h("div", { class: "readout" });
    this.element = h("div", { class: "stage" }, this.readout, this.canvas, this.note, h("slot"), views);
    this.works = renderer().works;
    this.drawn = 0;
    if (!this.works) return this.stayStill();
    this.paper = new Paper(this.canvas, renderer());
    this.takeHold();
    this.leave = enlist(this);
    this.resized = new ResizeObserver(() => this.redraw());
    this.resized.observe(this.canvas);
  }

  stayStill() {
    this.canvas.hidden = true;
    this.note.hidden = false;
    this.element.classList.add("still");
    this.leave = () => {};
  }

  close() {
    this.leave();
    this.resized?.disconnect();
  }

  redraw() {
    this.stale = true;
    if (this.works) schedule();
  }

  look(name) {
    if (name === "Home") this.turnHome();
    else this.camera.turnTo(VIEWS[name]);
    this.camera.forget();
    this.redraw();
  }

  turnHome() {
    this.camera.turnHome(this.mode.axes?.() ?? []);
  }

  zoom(factor) {
    this.camera.zoomBy(factor);
    this.redraw();
  }

  draw(time) {
    this.stale = false;
    const { clientWidth, clientHeight } = this.canvas;
    if (!clientWidth || !clientHeight || !renderer().works) return;
    const scene = new Scene(COLORS[this.paperTheme ?? theme()], this.mode.size);
    scene.time = time;
    scene.unit = this.mode.unit; // the one that is named
    scene.lowest = this.lowest ?? 0;
    this.mode.build(scene);
    const lowest = Math.min(...scene.kept.map((p) => p[2]));
    if (!this.hand && !(this.lowest <= lowest + 1e-9)) { // the floor goes down with what reaches below it, and then stays
      this.lowest = lowest;
      return this.draw(time);
    }
    if (!this.hand) { // what a hand holds must not run away under it
      this.camera.include(scene.kept, scene.size);
      this.camera.fit(clientWidth, clientHeight);
    }
    this.paper.paint(scene, this.camera);
    this.wanted = scene.labels.length;
    this.drawn++;
  }

  takeHold() {
    const { canvas } = this, held = new Map();
    canvas.addEventListener("pointerdown", (event) => {
      if (!held.size) this.hand = this.mode.grab?.(this.at(event), this.camera, near(event)) ?? null;
      held.set(event.pointerId, [event.clientX, event.clientY]);
      canvas.setPointerCapture(event.pointerId);
    });
    canvas.addEventListener("touchstart", (event) => { // a finger on something that can be moved does not scroll the page
      const [touch] = event.touches;
      if (event.touches.length === 1 && this.mode.grab?.(this.at(touch), this.camera, FINGER)) event.preventDefault();
    }, { passive: false });
    canvas.addEventListener("pointermove", (event) => {
      const last = held.get(event.pointerId);
      if (!last) return this.hover(event);
      if (this.hand && held.size === 1) return this.hand(this.at(event));
      held.set(event.pointerId, [event.clientX, event.clientY]);
      this.dragged(event, last, [...held].filter(([id]) => id !== event.pointerId).map(([, at]) => at));
    });
    for (const name of ["pointerup", "pointercancel"]) canvas.addEventListener(name, (event) => {
      held.delete(event.pointerId);
      if (this.hand && name === "pointerup") this.hand(this.at(event), true);
      if (this.hand) this.redraw();
      this.hand = null;
    });
    canvas.addEventListener("pointerleave", () => this.mode.hover?.(null, this.camera));
    canvas.addEventListener("wheel", (event) => { // only when the view was taken hold of before, so that the page scrolls past it
      if (!event.ctrlKey && canvas.getRootNode().activeElement !== canvas) return;
      event.preventDefault();
      this.zoom(Math.exp(-event.deltaY / 500));
    }, { passive: false });
    canvas.addEventListener("keydown", (event) => this.key(event));
  }

  // Where a pointer is on the canvas, in CSS pixels.
  at({ clientX, clientY }) {
    const box = this.canvas.getBoundingClientRect();
    return [clientX - box.left, clientY - box.top];
  }

  hover(event) {
    const found = this.mode.hover?.(this.at(event), this.camera, near(event));
    this.canvas.style.cursor = found ? "pointer" : "";
  }

  dragged(event, last, others) {
    if (others.length) this.camera.zoomBy(apart([event.clientX, event.clientY], others[0]) / (apart(last, others[0]) || 1));
    else this.camera.turnBy(-0.45 * (event.clientX - last[0]), 0.45 * (event.clientY - last[1]));
    this.redraw();
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (KEYS[event.key]) this.camera.turnBy(...KEYS[event.key]);
    else if (event.key === "+" || event.key === "=") this.camera.zoomBy(1.15);
    else if (event.key === "-") this.camera.zoomBy(1 / 1.15);
    else if (event.key === "0" || event.key === "Home") this.look("Home");
    else return;
    event.preventDefault();
    event.stopPropagation();
    this.redraw();
  }
}

const apart = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]);
