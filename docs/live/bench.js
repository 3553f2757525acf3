// The bench: an arm and a question, answered by Python beside the page.

import { h } from "./elements.js";
import { Kernel } from "./kernel.js";
import { fill } from "./outputs.js";

const host = document.querySelector(".dhlab-bench");
const DO = { read: "Read it", diagnose: "What is wrong?", fk: "Where is its end?", compare: "Compare with another", convert: "Convert" };
const CHOICES = {
  order: ["theta d a alpha", "alpha a d theta", "theta a d alpha", "a alpha d theta", "alpha d a theta", "d theta a alpha"],
  convention: ["standard", "craig"],
  angle: ["deg", "rad"],
  length: ["m", "mm", "cm", "in"],
};
const ASK = { order: "Order of the columns", convention: "Convention", angle: "Angles", length: "Lengths" };
const EXAMPLE = { arm: "theta d a alpha\n0 0.1625 0 90\n0 0 -0.425 0\n0 0 -0.3922 0\n0 0.1333 0 -90\n0 0.0997 0 -90\n0 0.0996 0 0", do: "compare", other: "ur5e", said: { convention: "standard", angle: "deg", length: "m" } };

let kernel = null;
let said = {};
let yaml = "";
const fields = {};

const area = (name, label, rows, hint) => field(name, label, h("textarea", { rows, spellcheck: "false", autocapitalize: "off", placeholder: hint }));
const line = (name, label, hint) => field(name, label, h("input", { type: "text", spellcheck: "false", autocapitalize: "off", placeholder: hint }));
const pick = (name, label, options) => field(name, label, h("select", {}, ...options.map(([value, words]) => h("option", { value }, words))));
const box = (name, label) => {
  fields[name] = h("input", { type: "checkbox" });
  return h("label", { class: "bench-box" }, fields[name], label);
};
function field(name, label, element) {
  fields[name] = element;
  return h("label", { class: "bench-field" }, h("span", {}, label), element);
}

const parts = {
  diagnose: h("div", {}, area("poses", "Measured poses, one a line: joint values, then x, y, z", 6, "0, 30, -45, 412.1, 3.2, 200.7\n… or under a header q1,q2,q3,x,y,z,roll,pitch,yaw"),
    pick("units", "Their units", [["mm,deg", "mm and degrees"], ["m,rad", "m and radians"], ["m,deg", "m and degrees"], ["mm,rad", "mm and radians"]]),
    box("free_base", "measured in another base frame"), box("free_tool", "measured at another tool")),
  fk: h("div", {}, line("q", "Joint values (degrees; mm for a sliding joint)", "0, 30, -45, 0, 0, 0")),
  compare: h("div", {}, area("other", "The other arm", 5, "a table, a URDF, or a name such as ur5e")),
  convert: h("div", {}, pick("to", "Into", [["", "the other convention"], ["standard", "standard"], ["craig", "Craig's (modified)"]])),
};
const chosen = () => host.querySelector("input[name=do]:checked").value;
const status = h("p", { class: "live-status", role: "status" });
const questions = h("div", { class: "bench-questions" });
const results = h("div", { class: "bench-results", "aria-live": "polite" });
const stop = h("button", { type: "button", class: "live-button", onclick: () => kernel?.stop() }, "Stop");
const save = h("button", { type: "button", class: "live-button", hidden: "", onclick: give }, "Save the table (.yaml)");

function form() {
  stop.disabled = true;
  const radios = Object.entries(DO).map(([value, words]) => h("label", { class: "bench-do" }, h("input", { type: "radio", name: "do", value, onchange: shown }), words));
  host.replaceChildren(h("form", { onsubmit: (event) => { event.preventDefault(); ask(); } },
    area("arm", "The arm: a table from anywhere, a URDF, a program with dh_transform, or a name such as ur5e", 9, "theta d a alpha\n0 0.1625 0 90\n…"),
    h("fieldset", {}, h("legend", {}, "The question"), ...radios),
    ...Object.values(parts), questions,
    h("div", { class: "bench-buttons" },
      h("button", { type: "submit", class: "live-button live-first" }, "Answer"), stop,
      h("button", { type: "button", class: "live-button", onclick: link }, "Copy a link to this case"),
      h("button", { type: "button", class: "live-button", onclick: () => put(EXAMPLE) }, "An example"), save)),
    status, results);
  fields.arm.addEventListener("input", () => {
    said = {};
    questions.replaceChildren();
  });
  host.querySelector("input[value=read]").checked = true;
  shown();
}

function shown() {
  for (const [name, part] of Object.entries(parts)) part.hidden = name !== chosen();
}

function state() {
  const texts = Object.entries(fields).map(([name, element]) => [name, element.type === "checkbox" ? element.checked : element.value]);
  return { ...Object.fromEntries(texts.filter(([, value]) => value)), do: chosen(), said };
}

function put(given) {
  for (const [name, element] of Object.entries(fields)) {
    if (element.type === "checkbox") element.checked = given[name] === true;
    else if (typeof given[name] === "string") element.value = given[name];
    else if (element.tagName !== "SELECT") element.value = "";
  }
  const radio = host.querySelector(`input[name=do][value="${CSS.escape(given.do ?? "read")}"]`);
  if (radio) radio.checked = true;
  said = typeof given.said === "object" && given.said ? { ...given.said } : {};
  questions.replaceChildren();
  results.replaceChildren();
  shown();
}

async function ask() {
  kernel ??= new Kernel(hear);
  results.replaceChildren();
  results.setAttribute("aria-busy", "true");
  save.hidden = true;
  stop.disabled = false;
  status.textContent = kernel.ready ? "Thinking …" : "Python is being started (10 MB, once) …";
  const text = await kernel.call("bench", "answer", JSON.stringify(state()));
  stop.disabled = true;
  results.removeAttribute("aria-busy");
  if (text === null) return;
  status.textContent = "";
  show(JSON.parse(text));
  (questions.querySelector("[data-open]") ? questions : results).scrollIntoView({ block: "start" });
}

function hear(message) {
  if (message.type === "loading") status.textContent = `Fetching ${message.file.split("-")[0]} …`;
  else if (message.type === "loaded" || message.type === "ready") status.textContent = "Thinking …";
  else if (message.type === "lost") status.textContent = "Stopped.";
  else if (message.type === "broken") {
    status.textContent = `Python stopped: ${message.text}`;
    stop.disabled = true;
    kernel.again();
  } else if (message.type === "error") status.textContent = message.text;
}

function show(answer) {
  if (answer.wrong) results.append(h("p", { class: "bench-wrong", role: "alert" }, answer.wrong));
  openQuestions(answer);
  for (const { title, data } of answer.parts ?? []) {
    if (title) results.append(h("h2", {}, title));
    const element = h("div", { class: "cell_output live-output" });
    fill(element, data, kernel);
    results.append(element);
  }
  for (const note of answer.notes ?? []) results.append(h("p", {}, `Note: ${note}`));
  yaml = answer.yaml ?? "";
  save.hidden = !yaml;
}

// What the text does not say: asked once, and kept with the case.
function openQuestions({ open = [], questions: words = [], readings = [] }) {
  questions.replaceChildren();
  const names = [...new Set([...open, ...Object.keys(said).filter((name) => name in CHOICES)])];
  if (!names.length && readings.length < 2) return;
  questions.append(h("p", { "data-open": open.length || (readings.length > 1 && !said.take) ? "" : null }, open.length ? `The text leaves open: ${words.join(" ")}` : "As you said:"));
  for (const name of names) {
    const select = h("select", { onchange: () => { said[name] = select.value; ask(); } },
      ...["", ...CHOICES[name]].map((value) => h("option", { value }, value || "not said")));
    select.value = said[name] ?? "";
    questions.append(h("label", { class: "bench-field" }, h("span", {}, ASK[name]), select));
  }
  if (readings.length > 1) {
    const take = h("select", { onchange: () => { said.take = take.value; ask(); } },
      h("option", { value: "" }, "choose"), ...readings.map((reading, k) => h("option", { value: String(k + 1) }, `${k + 1}. ${reading}`)));
    take.value = said.take ?? "";
    questions.append(h("label", { class: "bench-field" }, h("span", {}, "Or take a reading"), take));
  }
}

function give() {
  const anchor = h("a", { href: URL.createObjectURL(new Blob([yaml], { type: "application/yaml" })), download: "arm.yaml" });
  anchor.click();
  setTimeout(() => URL.revokeObjectURL(anchor.href), 1000);
}

// ---- the case in the link: JSON, deflated, in letters that a link may hold

async function through(stream, bytes) {
  return new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());
}

async function link() {
  const bytes = await through(new CompressionStream("deflate-raw"), new TextEncoder().encode(JSON.stringify(state())));
  const letters = btoa(String.fromCharCode(...bytes)).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
  history.replaceState(null, "", `#${letters}`);
  const copied = await navigator.clipboard?.writeText(location.href).then(() => true, () => false);
  status.textContent = copied ? "Copied. The link holds all that stands in the fields." : "The link is in the address line; it holds all that stands in the fields.";
}

async function fromLink() {
  const letters = location.hash.slice(1);
  if (!letters) return;
  try {
    const bytes = Uint8Array.from(atob(letters.replaceAll("-", "+").replaceAll("_", "/")), (letter) => letter.charCodeAt(0));
    put(JSON.parse(new TextDecoder().decode(await through(new DecompressionStream("deflate-raw"), bytes))));
    status.textContent = "This case came with the link. A program in it runs only when you press Answer: look at it first.";
  } catch {
    status.textContent = "Expected a case behind the # of this link, found something else; ask for the link again, or paste the arm.";
  }
}

if (host && "Worker" in window && "DecompressionStream" in window) {
  form();
  fromLink();
  addEventListener("hashchange", fromLink);
}
