// A cell's text to write in: a textarea over its own coloured copy.

const KEYWORDS = new Set(
  "False None True and as assert break class continue def del elif else except finally for from global if import in is lambda nonlocal not or pass raise return try while with yield".split(" "),
);
const TOKEN = /(#.*)|("""[\s\S]*?"""|'''[\s\S]*?'''|"(?:\\.|[^"\\\n])*"?|'(?:\\.|[^'\\\n])*'?)|(\b\d[\d_.]*(?:e[+-]?\d+)?\b)|(\b[A-Za-z_]\w*\b)/g;

function coloured(source) {
  const parts = document.createDocumentFragment();
  let at = 0;
  for (const found of source.matchAll(TOKEN)) {
    const [token, comment, string, number, word] = found;
    const kind = comment ? "c1" : string ? "s2" : number ? "mi" : KEYWORDS.has(word) ? "k" : "";
    if (!kind) continue;
    parts.append(source.slice(at, found.index), Object.assign(document.createElement("span"), { className: kind, textContent: token }));
    at = found.index + token.length;
  }
  parts.append(`${source.slice(at)}\n`);
  return parts;
}

export function editor(source, label, { changed, run }) {
  const element = Object.assign(document.createElement("div"), { className: "live-editor highlight" });
  const copy = Object.assign(document.createElement("pre"), { ariaHidden: "true" });
  const area = Object.assign(document.createElement("textarea"), { value: source, spellcheck: false, autocapitalize: "off", autocomplete: "off", rows: 1 });
  area.setAttribute("aria-label", label);
  area.setAttribute("aria-description", "Shift and Enter run the cell. Escape, then Tab or Shift and Tab, leaves it.");
  const paint = () => copy.replaceChildren(coloured(area.value));
  let leaving = false;
  area.addEventListener("input", () => {
    paint();
    changed(area.value);
  });
  area.addEventListener("keydown", (event) => {
    if (event.key === "Enter" && (event.shiftKey || event.ctrlKey || event.metaKey)) {
      event.preventDefault();
      run(event.shiftKey);
    } else if (event.key === "Tab" && !leaving && !event.ctrlKey && !event.altKey) {
      event.preventDefault();
      indent(area, event.shiftKey);
    } else if (event.key === "Enter") {
      event.preventDefault();
      const line = area.value.slice(0, area.selectionStart).split("\n").pop();
      document.execCommand("insertText", false, `\n${line.match(/^ */)[0]}${/:\s*$/.test(line) ? "    " : ""}`);
    }
    if (event.key !== "Shift") leaving = event.key === "Escape"; // Shift and Tab leave it backwards
  });
  paint();
  element.append(copy, area);
  return {
    element,
    area,
    get text() {
      return area.value;
    },
    set text(value) {
      area.value = value;
      paint();
    },
  };
}

// Four spaces more or less; what is chosen stays chosen, and undo knows of it.
function indent(area, less) {
  const start = area.value.lastIndexOf("\n", area.selectionStart - 1) + 1;
  if (!less && area.selectionStart === area.selectionEnd) {
    document.execCommand("insertText", false, "    ");
    return;
  }
  const end = Math.max(area.selectionEnd, start);
  const old = area.value.slice(start, end);
  const now = less ? old.replace(/^ {1,4}/gm, "") : old.replace(/^(?=.)/gm, "    ");
  area.setSelectionRange(start, end);
  document.execCommand("insertText", false, now);
  area.setSelectionRange(start, start + now.length);
}
