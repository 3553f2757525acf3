// What the site's explorers can do beyond those of a notebook: change the table, keep the state in the address, hand out picture and table.

import { button, choice } from "./controls.js";
import { h, write } from "./dom.js";
import { read, written } from "./instrument/address.js";
import { Body } from "./instrument/body.js";
import { converted } from "./instrument/convert.js";
import { Motion } from "./instrument/motion.js";
import { NumbersTable } from "./instrument/numbers.js";
import { picture, save, yaml } from "./instrument/out.js";

const QUIET = 400; // ms after the last move before the address says it
const STYLE = `
  .numbers input { width: 6.2em; font: inherit; font-size: 13px; padding: 3px 4px; text-align: right; color: var(--ink); background: var(--ground); border: 1px solid var(--line); border-radius: 5px; }
  .numbers input.other { border-color: var(--other); background: var(--mark); }
  .numbers input:invalid { border-color: var(--bad); }
  .numbers td, .numbers th { padding: 2px 4px; }
  .edit button { align-self: flex-start; }
  .numbers input::-webkit-inner-spin-button { display: none; }
  @container (max-width: 480px) { .numbers input { width: 4.7em; padding: 3px 2px; min-width: 0 !important; } .numbers td, .numbers th { padding: 2px 1px; } }
  .give { display: flex; flex-wrap: wrap; gap: 6px; align-items: center; }
  @media print { .give, .edit:not([open]) { display: none; } }
  .give p { color: var(--quiet); font-size: 12.5px; flex-basis: 100%; }
  @media (pointer: coarse) { .numbers input { min-height: 44px; } }`;

export function instrument(explorer) {
  const { stage, mode, host } = explorer, { arm } = host.data, first = structuredClone(arm), start = host.get("q"), root = stage.canvas.getRootNode();
  const said = h("p", { role: "status" }), convention = choice("Convention", "convention", [["standard", "Standard"], ["craig", "Craig's"]], arm.convention, change);
  const body = new Body({ stage, mode, host }), motion = new Motion({ stage, mode, host }, nameOf), numbers = new NumbersTable(arm, first, edited), back = button("Back to the published table", reset);
  explorer.motion = motion;
  explorer.body = body;
  mode.extra = (scene) => {
    body.draw(scene);
    motion.draw(scene);
  };
  let timer = 0;
  root.querySelector(".below").append(
    h("details", { class: "edit" }, h("summary", {}, "Change the table"), h("div", { class: "below" }, convention.element, numbers.element, back)),
    motion.element, body.element,
    h("div", { class: "give" }, button("Copy a link to this", link), button("Save the picture", () => picture(stage, nameOf()), { disabled: !stage.works }),
      button("Save the table", () => save(`${nameOf()}.yaml`, "application/yaml", yaml(arm, changed()))), said));
  root.querySelector(".explorer").append(h("style", {}, STYLE));
  addEventListener("hashchange", fromAddress);
  host.listen((what) => what === "q" && note());
  fromAddress();

  function nameOf() {
    return (arm.name || "arm").toLowerCase().replace(/[^a-z0-9]+/g, "-").replace(/^-|-$/g, "");
  }

  // Whether the numbers are still the published ones, in either convention.
  function changed() {
    const own = converted(first, arm.convention);
    return arm.rows.some((row, i) => row.some((v, k) => Math.abs(v - own.rows[i][k]) > 1e-12));
  }

  function edited() {
    mode.rework();
    motion.plan();
    body.place();
    note();
  }

  function change(to) {
    Object.assign(arm, converted(arm, to));
    refresh();
  }

  function refresh() {
    convention.set(arm.convention);
    numbers.show(converted(first, arm.convention));
    edited();
  }

  function reset() {
    Object.assign(arm, structuredClone(first));
    host.set("q", start);
    refresh();
    write(said, "The table is as it was published.");
  }

  function note() {
    clearTimeout(timer);
    timer = setTimeout(() => history.replaceState(null, "", `#${written(arm, host.get("q"), changed())}`), QUIET);
  }

  async function link() {
    clearTimeout(timer);
    history.replaceState(null, "", `#${written(arm, host.get("q"), changed())}`);
    const copied = await navigator.clipboard?.writeText(location.href).then(() => true, () => false);
    write(said, copied ? "Copied: whoever opens the link sees this arm as it stands here." : "The link is in the address line.");
  }

  function fromAddress() {
    const found = read(location.hash.slice(1), first);
    if (!found) return;
    Object.assign(arm, converted(structuredClone(first), found.convention));
    if (found.rows) arm.rows = found.rows;
    if (found.q) host.set("q", found.q);
    convention.set(arm.convention);
    numbers.show(converted(first, arm.convention));
    mode.rework();
    motion.forget();
  }
}
