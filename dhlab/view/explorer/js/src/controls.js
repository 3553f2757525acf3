// What hands take hold of: sliders with a field beside them, buttons that stay pressed, choices.

import { h } from "./dom.js";
import { DEGREE, MILLIMETRES, below, unitOf } from "./format.js";

const TURN = { name: "°", word: "degrees", factor: DEGREE, step: 0.5, digits: 2 };

// A quantity in radians or metres, shown in degrees or in a unit of length. `changed` gets it back in radians or metres.
export function slider({ symbol, name, turn, low, high, changed, unit = MILLIMETRES, coarse = 1 }) {
  const { factor, word, digits, name: short, step: fine } = turn ? TURN : unit, step = fine * coarse;
  // limits are rounded inward to whole steps, so that a slider can stand at 0; the field goes all the way
  const whole = (steps) => round(steps * step, 6);
  const bounds = { min: whole(Math.ceil((low * factor) / step - 1e-9)), max: whole(Math.floor((high * factor) / step + 1e-9)), step };
  const words = `${name}, ${word}`;
  const range = h("input", { type: "range", "aria-label": words, ...bounds, oninput: () => changed(Number(range.value) / factor) });
  let known = ""; // what stands in the field and is the value already
  const take = () => {
    if (field.value === known || field.value === "" || !Number.isFinite(Number(field.value))) return;
    known = field.value;
    changed(Number(known) / factor);
  };
  const field = h("input", { type: "number", "aria-label": `${words}, exactly`, step: "any", onchange: take, onkeydown: (event) => {
    if (event.key === "Enter") take(); // in JupyterLab's notebook Enter alone makes no change event
  } });
  const mute = (kind, text) => h("span", { class: kind, "aria-hidden": "true" }, text);
  const element = h("div", { class: "slider" }, mute("symbol", symbol), range, field, mute("unit", short));
  const set = (value) => {
    const shown = String(round(value * factor, digits));
    if (Math.abs(Number(range.value) - value * factor) > 1e-9) range.value = value * factor;
    range.setAttribute("aria-valuetext", `${shown} ${word}`);
    if (field.value !== shown) field.value = shown;
    known = shown;
    element.classList.toggle("beyond", value < low - 1e-9 || value > high + 1e-9);
  };
  return { element, set };
}

const round = (value, digits) => Number(value.toFixed(digits)) + 0;

export function toggle(text, pressed, changed) {
  const button = h("button", { type: "button", "aria-pressed": String(pressed), onclick: () => {
    const now = button.getAttribute("aria-pressed") !== "true";
    button.setAttribute("aria-pressed", String(now));
    changed(now);
  } }, text);
  return button;
}

export const button = (text, pressed, properties = {}) => h("button", { type: "button", onclick: pressed, ...properties }, text);

// One of several, as radio buttons in a row: [[value, text], ...].
export function choice(legend, name, options, value, changed) {
  const inputs = options.map(([key]) => h("input", { type: "radio", name, value: key, checked: key === value, onchange: () => changed(key) }));
  const labels = options.map(([, text], k) => h("label", {}, inputs[k], h("span", {}, text)));
  const element = h("fieldset", { class: "choice" }, h("legend", {}, legend), ...labels);
  return { element, set: (key) => inputs.forEach((input, k) => { input.checked = options[k][0] === key; }) };
}

// One of a numbered row of things, from 1, by a slider and arrows; `extra` are more buttons beside them.
export function stepper(name, count, select, extra = []) {
  const to = (number) => select(Math.max(1, Math.min(count, number)));
  const range = h("input", { type: "range", min: 1, max: count, step: 1, "aria-label": name, oninput: () => to(Number(range.value)) });
  const lower = name.toLowerCase();
  const bar = h("div", { class: "transport" }, button("◀", () => to(Number(range.value) - 1), { "aria-label": `The ${lower} before` }),
    button("▶", () => to(Number(range.value) + 1), { "aria-label": `The next ${lower}` }), ...extra);
  const element = h("fieldset", { class: "sliders" }, h("legend", {}, `${name} shown`), range, bar);
  return { element, set: (number) => {
    range.value = number;
    range.setAttribute("aria-valuetext", `${lower} ${number} of ${count}`);
  } };
}

// One slider per joint of an arm; a joint without limits gets a full turn, or the arm's size.
export function jointSliders(arm, size, host) {
  const sliders = [...arm.joints].map((letter, i) => {
    const turn = letter !== "P", free = turn ? Math.PI : size;
    const [low, high] = arm.limits?.[i] ?? [-free, free];
    return slider({ symbol: `q${below(i + 1)}`, name: `Joint ${i + 1}`, turn, low, high, unit: unitOf(host.data), changed: (value) => {
      host.set("q", host.get("q").map((old, k) => (k === i ? value : old)));
    } });
  });
  const zero = button("All joints to 0", () => host.set("q", host.get("q").map(() => 0)));
  const element = h("fieldset", { class: "sliders" }, h("legend", {}, "Joints"), ...sliders.map((one) => one.element), zero);
  return { element, set: (q) => sliders.forEach((one, i) => one.set(q[i])) };
}
