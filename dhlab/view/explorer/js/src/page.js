// The module: what a notebook's widget asks for, and what finds the explorers of a page without a kernel.

import { mount } from "./explorer.js";

export { reach } from "./inverse.js";
export { forward, frames, jacobian } from "./kinematics.js";

const STATE = ["q", "row", "poses", "convention", "step", "_answer"];

// In a notebook: anywidget hands in the model and an element.
function render({ model, el }) {
  const element = document.createElement("div");
  el.append(element);
  const host = {
    live: true,
    data: model.get("_data"),
    get: (name) => model.get(name),
    set(name, value) {
      model.set(name, value);
      model.save_changes();
    },
    send: (message) => model.send(message),
    listen(changed) {
      const entries = STATE.map((name) => [`change:${name}`, () => changed(name)]);
      for (const [event, heard] of entries) model.on(event, heard);
      return () => entries.forEach(([event, heard]) => model.off(event, heard));
    },
  };
  model.on("msg:custom", (message, buffers) => {
    if (message.still) element.innerHTML = message.still;
    if (message.parts) host.parts?.(message.parts, buffers);
  });
  return mount(element, host);
}

// On a page: the data stands in the element, beside the still picture that is seen until now.
function adopt(element) {
  const { state, ...data } = JSON.parse(element.querySelector("script").textContent);
  const listeners = new Set();
  const host = {
    live: false,
    data,
    get: (name) => state[name],
    set(name, value) {
      state[name] = value;
      for (const heard of listeners) heard(name);
    },
    send() {},
    listen(changed) {
      listeners.add(changed);
      return () => listeners.delete(changed);
    },
  };
  mount(element, host);
  if (data.instrument) import(new URL(`instrument.js${new URL(import.meta.url).search}`, import.meta.url)).then((made) => made.instrument(element.explorer)); // on the site alone
}

export function adoptAll() {
  for (const element of document.querySelectorAll(".dhlab-explorer:has(> script)")) if (!element.shadowRoot) adopt(element);
}

if (document.readyState === "loading") document.addEventListener("DOMContentLoaded", adoptAll);
else adoptAll();

export default { render };
