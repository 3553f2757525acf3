// The work on a lesson, kept in this browser; and as a notebook, on the way out and in.

const text = (source) => [].concat(source).join("");
const codeCells = (notebook) => notebook.cells.filter((cell) => cell.cell_type === "code");
const get = (key) => {
  try {
    return localStorage.getItem(key);
  } catch {
    return null;
  }
};
const put = (key, value) => {
  try {
    localStorage.setItem(key, value);
    return true;
  } catch {
    return false;
  }
};

export class Work {
  // notebook: the lesson as it is handed out today
  constructor(name, notebook) {
    Object.assign(this, { key: `dhlab:work:${name}`, name, notebook, earlier: {} });
    this.handedOut = Object.fromEntries(codeCells(notebook).map((cell) => [cell.id, text(cell.source)]));
    this.mine = {};
    this.kept = true;
    const stored = JSON.parse(get(this.key) ?? "null");
    if (stored) this.takeOver(stored.handedOut, stored.mine, stored.earlier);
  }

  // Work on this lesson or an older one: what still has its cell goes there, the rest is shown beside it.
  takeOver(handedOut, mine, earlier = {}) {
    Object.assign(this.earlier, earlier);
    for (const [id, source] of Object.entries(mine)) {
      if (this.handedOut[id] !== undefined && (!handedOut || handedOut[id] === this.handedOut[id])) this.mine[id] = source;
      else if (source !== handedOut?.[id]) this.earlier[id] = source;
    }
    this.save();
  }

  source(id) {
    return this.mine[id] ?? this.handedOut[id];
  }

  write(id, source) {
    if (source === this.handedOut[id]) delete this.mine[id];
    else this.mine[id] = source;
  }

  save() {
    const { handedOut, mine, earlier } = this;
    this.kept = put(this.key, JSON.stringify({ handedOut, mine, earlier }));
    return this.kept;
  }

  clear() {
    [this.mine, this.earlier] = [{}, {}];
    this.save();
  }

  // The .ipynb that dhlab grade takes: the lesson's own, with the text of its cells.
  asNotebook() {
    const notebook = structuredClone(this.notebook);
    for (const cell of codeCells(notebook)) {
      cell.source = this.source(cell.id);
      cell.outputs = [];
      cell.execution_count = null;
    }
    return `${JSON.stringify(notebook, null, 1)}\n`;
  }

  // A notebook from a file; what was wrong with it as a sentence, or "".
  fromNotebook(content) {
    let given;
    try {
      given = codeCells(JSON.parse(content));
    } catch {
      return "Expected a notebook (.ipynb), found a file that is none; choose the notebook of this lesson.";
    }
    const known = given.filter((cell) => this.handedOut[cell.id] !== undefined);
    if (!known.length) return `Expected a notebook of this lesson (${this.name}), found one without its cells; choose another file, or open that lesson.`;
    const before = JSON.stringify(this.mine);
    for (const cell of known) this.write(cell.id, text(cell.source));
    if (before !== JSON.stringify(this.mine)) put(`${this.key}:before`, before);
    this.save();
    return "";
  }
}

// The log of checks, the same for all lessons. What another page has added meanwhile stays.
export class Log {
  constructor() {
    this.text = get("dhlab:log") ?? "";
  }

  add(text) {
    const more = text.slice(this.text.length);
    if (more) put("dhlab:log", (get("dhlab:log") ?? "") + more);
    this.text = text;
  }
}
