// The options of a question as cards: one is chosen, or they are laid into places, by mouse, finger and keys.

const STYLE = `
:host { display: block; }
.cards { font: 14px/1.45 "Segoe UI", system-ui, "DejaVu Sans", sans-serif; color: var(--ink); max-width: 760px; margin: 6px 0;
  --ink: var(--jp-content-font-color1, #22262b); --quiet: var(--jp-content-font-color2, #50565d); --ground: var(--jp-layout-color1, #fff); --line: #8b949e; --accent: #17479e; --accent-ink: #fff; --mark: #e3edfb; }
.cards.dark { --ground: var(--jp-layout-color1, #181b1f); --ink: #e8ebee; --quiet: #b4bcc6; --accent: #86b2ff; --accent-ink: #10141a; --mark: #24354f; --line: #6b7682; }
fieldset, ol { border: 0; margin: 0; padding: 0; min-width: 0; list-style: none; }
legend { font-weight: 600; padding: 0; margin-bottom: 6px; }
.options { display: grid; grid-template-columns: repeat(auto-fit, minmax(230px, 1fr)); gap: 6px; }
.card, .place { font: inherit; text-align: left; color: var(--ink); background: var(--ground); border: 1.5px solid var(--line); border-radius: 8px; padding: 8px 10px; min-height: 40px; cursor: pointer; display: flex; gap: 9px; align-items: baseline; width: 100%; box-sizing: border-box; position: relative; touch-action: manipulation; }
.card:hover, .place:hover { border-color: var(--accent); }
.card:has(:checked), .place[aria-current="true"] { border-color: var(--accent); background: var(--mark); box-shadow: inset 0 0 0 1px var(--accent); }
.card.used { opacity: .75; border-style: dashed; }
.card input { position: absolute; inset: 0; opacity: 0; margin: 0; cursor: pointer; }
.card:focus-within, :focus-visible { outline: 2px solid var(--accent); outline-offset: 2px; }
.letter { font-weight: 700; color: var(--accent); min-width: 1em; }
.places { display: grid; gap: 5px; margin: 0 0 9px; }
.empty { color: var(--quiet); }
.told { margin: 7px 0 0; color: var(--quiet); min-height: 1.4em; }
code { font-family: ui-monospace, monospace; font-size: .93em; }
.dragged { position: fixed; pointer-events: none; z-index: 9; width: auto; max-width: 320px; opacity: .92; }
`;

function h(name, properties = {}, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(properties)) {
    if (key === "html") element.innerHTML = value;
    else if (key.startsWith("on")) element.addEventListener(key.slice(2), value);
    else if (value !== false && value != null) element.setAttribute(key, value === true ? "" : value);
  }
  element.append(...children);
  return element;
}

const SYSTEM = matchMedia("(prefers-color-scheme: dark)");

// What JupyterLab or the site says, else what the reader's system prefers.
function isDark() {
  const { jpThemeLight, theme } = document.body.dataset;
  if (jpThemeLight) return jpThemeLight === "false";
  return theme === "dark" || theme === "light" ? theme === "dark" : SYSTEM.matches;
}

function render({ model, el }) {
  const host = document.createElement("div"), root = host.attachShadow({ mode: "open" });
  el.append(host);
  host.dataset.lmSuppressShortcuts = "true";
  const { title, options, places, repeats } = model.get("_data");
  const told = h("p", { class: "told", role: "status" });
  const view = (places.length ? laying : choosing)(model, title, options, places, repeats);
  const cards = h("div", { class: "cards" }, view.element, told), dress = () => cards.classList.toggle("dark", isDark());
  root.append(h("style", {}, STYLE), cards);
  const watch = new MutationObserver(dress);
  watch.observe(document.body, { attributes: true, attributeFilter: ["data-theme", "data-jp-theme-light"] });
  SYSTEM.addEventListener("change", dress);
  dress();
  const show = () => {
    view.show(model.get("chosen"));
    told.textContent = model.get("told");
  };
  model.on("change:chosen", show);
  model.on("change:told", show);
  show();
  return () => {
    watch.disconnect();
    SYSTEM.removeEventListener("change", dress);
    model.off("change:chosen", show);
    model.off("change:told", show);
  };
}

function put(model, chosen) {
  model.set("chosen", chosen);
  model.save_changes();
}

const card = (letter, html) => [h("span", { class: "letter", "aria-hidden": "true" }, letter), h("span", { html })];

function choosing(model, title, options) {
  const name = `card${Math.random()}`;
  const inputs = options.map(([letter]) => h("input", { type: "radio", name, value: letter, onchange: () => put(model, [letter]) }));
  const labels = options.map(([letter, html], k) => h("label", { class: "card" }, inputs[k], ...card(letter, html)));
  const element = h("fieldset", {}, h("legend", {}, title), h("div", { class: "options" }, ...labels));
  return { element, show: ([chosen]) => inputs.forEach((input) => { input.checked = input.value === chosen; }) };
}

// A card goes into the place that is current, a place that is pressed gives its card back; a card can be dragged onto a place.
function laying(model, title, options, places, repeats) {
  const texts = new Map(options);
  let current = 0;
  const lay = (letter, place = current) => {
    let chosen = model.get("chosen").slice();
    if (!repeats) chosen = chosen.map((old) => (old === letter ? "" : old));
    if (chosen.includes("?") || letter === "?") chosen = chosen.map(() => "");
    chosen[letter === "?" ? 0 : place] = letter;
    const next = [...chosen.keys()].map((k) => (place + 1 + k) % chosen.length).find((k) => !chosen[k]);
    current = next ?? place;
    put(model, chosen);
    show(chosen);
  };
  const free = (place) => {
    const chosen = model.get("chosen").slice();
    chosen[place] = "";
    current = place;
    put(model, chosen);
    show(chosen);
  };
  const slots = places.map((_, k) => h("button", { type: "button", class: "place", onclick: () => free(k) }));
  const cards = options.map(([letter, html]) => dragging(h("button", { type: "button", class: "card" }, ...card(letter, html)), letter, slots, lay));
  const element = h("fieldset", {}, h("legend", {}, title), h("ol", { class: "places", "aria-label": "Places" }, ...slots.map((slot) => h("li", {}, slot))),
    h("div", { class: "options" }, ...cards));
  return { element, show };

  function show(chosen) {
    slots.forEach((slot, k) => {
      slot.setAttribute("aria-current", String(k === current));
      const place = h("span", { html: `${k + 1}. ${places[k]}` });
      slot.replaceChildren(place, ...(chosen[k] ? card(chosen[k], texts.get(chosen[k]) ?? "") : [h("span", { class: "empty" }, k === current ? "choose a card" : "empty")]));
    });
    cards.forEach((one, k) => one.classList.toggle("used", !repeats && chosen.includes(options[k][0])));
  }
}

function dragging(element, letter, slots, lay) {
  let start = null, ghost = null;
  const end = () => {
    ghost?.remove();
    [start, ghost] = [null, null];
  };
  element.addEventListener("pointerdown", (event) => {
    start = [event.clientX, event.clientY];
    element.setPointerCapture(event.pointerId);
  });
  element.addEventListener("pointermove", (event) => {
    if (!start || !event.buttons || (!ghost && Math.hypot(event.clientX - start[0], event.clientY - start[1]) < 7)) return;
    if (!ghost) {
      ghost = element.cloneNode(true);
      ghost.classList.add("dragged");
      ghost.setAttribute("aria-hidden", "true");
      element.after(ghost);
    }
    ghost.style.left = `${event.clientX + 8}px`;
    ghost.style.top = `${event.clientY + 8}px`;
  });
  element.addEventListener("pointerup", (event) => {
    if (ghost) {
      const over = slots.findIndex((slot) => {
        const box = slot.getBoundingClientRect();
        return event.clientX >= box.left && event.clientX <= box.right && event.clientY >= box.top && event.clientY <= box.bottom;
      });
      if (over >= 0) lay(letter, over);
      element.dataset.dropped = "true"; // the click that follows is the end of the drag
      setTimeout(() => delete element.dataset.dropped, 0);
    }
    end();
  });
  element.addEventListener("pointercancel", end);
  element.addEventListener("click", () => element.dataset.dropped || lay(letter));
  return element;
}

export default { render };
