// Runs notebooks in the Python of the pages, without a page:
//   node benchmarks/live.mjs LIVE CORE NOTEBOOK…     LIVE: the site's folder; CORE: where pyodide lies unpacked
// Prints a line of JSON for each: the log of its checks, and the cells that ended with an error.

import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

const [live, core, ...notebooks] = process.argv.slice(2);
const { loadPyodide } = await import(pathToFileURL(`${core}/pyodide.mjs`));
const text = readFileSync(`${live}/python.js`, "utf8"); // a module, whatever its folder says
const { start, NOTHING_ELSE } = await import(`data:text/javascript,${encodeURIComponent(text)}`);

const read = (name) => new Uint8Array(readFileSync(`${live}/${name}`));
let errors = [];
let files = [];
const send = (line) => {
  const message = JSON.parse(line);
  if (message.type === "error") errors.push([message.cell, message.text]);
  if (message.type === "loading") files.push(message.file);
};
const host = { bytes: async (name) => read(name), now: read, send };
const made = await start(host, { loadPyodide, options: { indexURL: `${core}/`, lockFileContents: NOTHING_ELSE } });

for (const notebook of notebooks) {
  [errors, files] = [[], []];
  made.fresh();
  made.log("");
  const began = performance.now();
  for (const cell of JSON.parse(readFileSync(notebook)).cells) {
    if (cell.cell_type === "code") made.run(cell.id, [].concat(cell.source).join(""));
  }
  const log = made.log().trim().split("\n").filter(Boolean).map(JSON.parse);
  console.log(JSON.stringify({ notebook, errors, files, log, seconds: (performance.now() - began) / 1000 }));
}
