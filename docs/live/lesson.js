// "Run this lesson": a lesson's page becomes a notebook. Without this file it reads as it is.

import { button, h } from "./elements.js";

const NAME = location.pathname.split("/").pop().replace(/\.html$/, "");

// What stands in the note under the title until somebody begins.
async function offer() {
  const note = document.querySelector(".admonition.tip");
  const places = [...document.querySelectorAll("div.cell")].filter((cell) => cell.querySelector(":scope > .cell_input"));
  if (!note || !places.length || !("Worker" in window) || !("DecompressionStream" in window)) return;
  const begin = button("Run this lesson", () => open(note, places), "live-first");
  const words = h("p", {}, "Python comes from this site (10 MB, more when a cell asks for it) and runs in your browser. What you type stays there.");
  note.querySelector(".admonition-title").textContent = "Do it here, or in Jupyter";
  const lab = h("a", { href: new URL(`../lab/lab/index.html?path=${NAME}.ipynb`, import.meta.url) }, "Open it in JupyterLab in this browser");
  note.append(h("div", { class: "live-offer" }, begin, words), h("p", {}, lab, " (60 MB, once; work done there stays apart from what you do here)."));
}

async function open(note, places) {
  note.querySelector(".live-first").disabled = true;
  const [answer, { Lesson }] = await Promise.all([fetch(new URL(`lessons/${NAME}.ipynb`, import.meta.url)), import("./notebook.js")]);
  const notebook = await answer.json();
  note.querySelector(".live-offer").remove();
  new Lesson(NAME, note, places, notebook);
}

offer();
