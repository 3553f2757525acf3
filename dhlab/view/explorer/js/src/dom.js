// Elements, made in one line; and a table whose cells are written only when they change.

export function h(name, properties = {}, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(properties)) {
    if (key.startsWith("on")) element.addEventListener(key.slice(2), value);
    else if (value === true) element.setAttribute(key, "");
    else if (value !== false && value != null) element.setAttribute(key, value);
  }
  element.append(...children);
  return element;
}

// Write a text where it differs from what is there, so that nothing is laid out anew for nothing.
export function write(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

export class Table {
  constructor(caption, headings, rows, named = true) { // named: the first cell of a row is its name
    this.caption = h("caption", {}, caption);
    this.head = headings.map((heading) => h("th", { scope: "col" }, heading));
    this.rows = Array.from({ length: rows }, () => headings.map((_, k) => (k || !named ? h("td") : h("th", { scope: "row" }))));
    const body = this.rows.map((cells) => h("tr", {}, ...cells));
    const table = h("table", {}, this.caption, h("thead", {}, h("tr", {}, ...this.head)), h("tbody", {}, ...body));
    this.lines = body;
    this.element = h("div", { class: "scroll", tabindex: 0, role: "group", "aria-label": caption }, table);
  }

  // null leaves what is there.
  set(lines) {
    lines.forEach((texts, i) => texts.forEach((text, k) => text !== null && write(this.rows[i][k], text)));
  }

  mark(row, column, name, on = true) {
    this.rows[row][column].classList.toggle(name, on);
  }
}
