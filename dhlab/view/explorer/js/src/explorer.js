// One explorer in one element: the mode's view, controls and tables, in a shadow root that keeps the page's style out.

import { h, write } from "./dom.js";
import { armMode } from "./modes/arm.js";
import { branchesMode } from "./modes/branches.js";
import { compareMode } from "./modes/compare.js";
import { conventionsMode } from "./modes/conventions.js";
import { linkMode } from "./modes/link.js";
import { placeMode } from "./modes/place.js";
import { poseMode } from "./modes/pose.js";
import { turnMode } from "./modes/turn.js";
import { Stage } from "./stage.js";
import style from "./style.css";
import { theme, watchTheme } from "./theme.js";

const MODES = { arm: armMode, link: linkMode, conventions: conventionsMode, compare: compareMode, branches: branchesMode, place: placeMode, pose: poseMode, turn: turnMode };
const SILENCE = 700; // ms after the last change before a screen reader is told

// `host` is what holds the state, a notebook's model or the page: {data, get, set, listen, send}. Returns the way to take everything down.
export function mount(element, host) {
  const root = element.shadowRoot ?? element.attachShadow({ mode: "open" });
  element.dataset.lmSuppressShortcuts = "true"; // JupyterLab keeps its one-letter commands off the fields
  let stage = null;
  const mode = MODES[host.data.mode](host, () => stage?.redraw());
  stage = new Stage(host.data.alt, mode);
  if (!stage.works) host.send({ still: true });
  mode.camera = stage.camera;
  stage.readout.append(...(mode.readout ? [mode.readout.element] : []));
  const words = h("p", { class: "hidden", role: "status", "aria-live": "polite" });
  const layout = h("div", { class: "explorer", role: "group", "aria-label": host.data.title },
    h("header", {}, h("p", { class: "title" }, host.data.title), h("div", { class: "tools", role: "group", "aria-label": "Show" }, ...(mode.tools ?? []))),
    h("div", { class: "main" }, stage.element, h("div", { class: "controls" }, ...mode.controls)),
    h("div", { class: "below" }, ...(mode.below ?? []), h("details", {}, h("summary", {}, host.data.summary ?? "The frames as a table"), mode.frames)), words);
  root.replaceChildren(h("style", {}, style), layout);
  const dress = () => {
    layout.dataset.theme = theme();
    stage.redraw();
  };
  layout.addEventListener("keydown", (event) => { // what is typed into a field is no command of the notebook around it
    if (event.target.matches("input") && !event.ctrlKey && !event.metaKey && !event.altKey) event.stopPropagation();
  });
  const print = () => { // what was not in sight yet is drawn, on paper's ground
    layout.dataset.theme = stage.paperTheme = "light";
    stage.draw(performance.now());
  };
  const printed = () => {
    stage.paperTheme = null;
    dress();
  };
  addEventListener("beforeprint", print);
  addEventListener("afterprint", printed);
  dress();
  const undress = watchTheme(dress);
  let timer = 0;
  const deafen = host.listen((what) => {
    mode.changed(what);
    clearTimeout(timer);
    timer = setTimeout(() => write(words, mode.said()), SILENCE);
  });
  element.explorer = { stage, mode, host };
  return () => {
    clearTimeout(timer);
    deafen();
    removeEventListener("beforeprint", print);
    removeEventListener("afterprint", printed);
    undress();
    mode.close?.();
    stage.close();
  };
}
