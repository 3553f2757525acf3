// What a cell says, shown under it.

const RICHEST = ["application/vnd.dhlab.widget", "text/html", "image/svg+xml", "text/plain"];

export class Outputs {
  constructor(element, kernel) {
    Object.assign(this, { element, kernel, last: null });
    new ResizeObserver(() => reachable(element)).observe(element);
  }

  clear() {
    this.element.replaceChildren();
    this.last = null;
  }

  stream({ name, text }) {
    if (this.last?.dataset.stream !== name) {
      this.last = pre(`live-${name}`);
      this.last.dataset.stream = name;
      this.element.append(this.last);
    }
    this.last.textContent += text;
    if (this.last.textContent.length > 200000) this.last.textContent = `…\n${this.last.textContent.slice(-100000)}`;
  }

  error(text) {
    const shown = pre("live-error");
    shown.textContent = text;
    this.add(shown);
  }

  display({ data, id }) {
    const shown = document.createElement("div");
    shown.className = "output";
    if (id) shown.dataset.output = id;
    fill(shown, data, this.kernel());
    const before = id && this.element.querySelector(`[data-output="${id}"]`);
    if (before) before.replaceWith(shown);
    else this.add(shown);
  }

  add(element) {
    this.element.append(element);
    this.last = null;
  }
}

// What is wider than its column scrolls; then the keyboard must reach it.
function reachable(element) {
  if (element.scrollWidth > element.clientWidth + 1) element.tabIndex = 0;
  else element.removeAttribute("tabindex");
}

function pre(kind) {
  const element = document.createElement("pre");
  element.className = kind;
  element.tabIndex = 0;
  return element;
}

export function fill(element, data, kernel) {
  const kind = RICHEST.find((one) => one in data);
  if (kind === "application/vnd.dhlab.widget") {
    kernel.show(data[kind], element).catch((error) => { element.textContent = `This view could not be shown: ${error.message}`; });
  } else if (kind === "text/plain") {
    const shown = pre("live-plain");
    shown.textContent = data[kind];
    element.append(shown);
  } else element.innerHTML = data[kind];
}
