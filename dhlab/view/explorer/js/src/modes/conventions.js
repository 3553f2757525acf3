// Mode "conventions": standard and Craig frames of one arm together; the frame looked at is drawn large, with the joint axes it belongs to.

import { drawBody, drawTriads, legend } from "../bodies.js";
import { choice, jointSliders } from "../controls.js";
import { h, write } from "../dom.js";
import { below, unitOf } from "../format.js";
import { endOf, frames, jointPlaces } from "../kinematics.js";
import { along, axis, dot, length, middle, origin, sub } from "../matrix.js";
import { DHTable, FramesTable } from "../tables.js";
import { sizeOf } from "./arm.js";

const KINDS = ["standard", "craig"];

export function conventionsMode(host, redraw) {
  const { arms } = host.data, unit = unitOf(host.data), n = arms.standard.rows.length;
  const zero = frames(arms.standard, arms.standard.sign.map(() => 0));
  let chains, end, look = null;
  const mode = { size: sizeOf(arms.standard, zero, host.get("q")), unit, build, changed, said };
  const sliders = jointSliders(arms.standard, mode.size, host);
  chains = chainsAt(host.get("q"));
  look = zero.reduce((best, _, k) => (apart(k) > apart(best) + 1e-9 ? k : best), 0);
  const pick = choice("Frame to compare", "frame", [...zero].map((_, k) => [String(k), `{${k}}`]), String(look), (key) => {
    look = Number(key);
    changed();
  });
  const words = h("p");
  const tables = Object.fromEntries(KINDS.map((kind) => [kind, new DHTable(arms[kind], unit)]));
  const frameTable = new FramesTable(KINDS.flatMap((kind) => zero.map((_, k) => `{${k}} ${kind}`)), unit);
  const signs = legend(["plain", "standard (ˢ): solid"], ["dashed", "Craig (ᶜ): dashed"], ["other", "from Craig's origin to the standard one"]);
  mode.controls = [pick.element, words, signs, sliders.element];
  mode.below = [h("div", { class: "pair" }, ...KINDS.map((kind) => tables[kind].element))];
  mode.frames = frameTable.element;
  changed();
  return mode;

  function changed() {
    const q = host.get("q");
    chains = chainsAt(q);
    end = endOf(arms.standard, chains.standard);
    sliders.set(q);
    for (const kind of KINDS) {
      tables[kind].update(q);
      arms[kind].rows.forEach((_, i) => {
        for (const column of [3, 4]) tables[kind].mark(i, column, "differs", arms.standard.rows[i][column - 1] !== arms.craig.rows[i][column - 1]);
        tables[kind].lines[i].classList.toggle("now", i + 1 === look);
      });
    }
    frameTable.update(KINDS.flatMap((kind) => chains[kind]));
    write(words, sentence());
    redraw();
  }

  function chainsAt(q) {
    return Object.fromEntries(KINDS.map((kind) => [kind, frames(arms[kind], q)]));
  }

  // How far the two frames k are from each other.
  function apart(k) {
    return length(sub(origin(chains.standard[k]), origin(chains.craig[k])));
  }

  function sentence() {
    const gap = apart(look);
    const where = gap < 1e-9 ? "their origins coincide" : `their origins are ${unit.text(gap)} apart`;
    const turned = dot(axis(chains.standard[look], 2), axis(chains.craig[look], 2)) > 1 - 1e-9 ? "" : ", and their z axes differ";
    const standard = look < n ? `on the axis of joint ${look + 1}` : "at the end of the last link", craig = look ? `on the axis of joint ${look}` : "in the base";
    return `Frame {${look}}: standard puts z${below(look)} ${standard}, Craig ${craig}; ${where}${turned}.`;
  }

  function build(scene) {
    const { size } = mode, [s, c] = KINDS.map((kind) => chains[kind][look]);
    drawBody(scene, arms.standard, chains.standard, end);
    for (const kind of KINDS) {
      const others = chains[kind].filter((_, k) => k !== look), small = { reach: 0.055 * size, thick: 0.003 * size, letters: false, dashed: kind === "craig" };
      scene.seeThrough(0.45, () => drawTriads(scene, others, [], null, small));
    }
    zero.forEach((_, k) => {
      if (k !== look && apart(k) > 1e-6) scene.line([origin(chains.craig[k]), origin(chains.standard[k])], { color: "other", pixels: 1.5, dash: [2, 4], head: true });
    });
    jointAxes(scene);
    if (apart(look) > 1e-6) {
      scene.line([origin(c), origin(s)], { color: "other", pixels: 3.5, head: true });
      scene.label(unit.text(apart(look)), middle(origin(s), origin(c)), { color: "other", far: true, weight: 600, key: "gap" });
    }
    drawTriads(scene, [s], [`${look}ˢ`], [`{${look}} standard`], { reach: 0.2 * size, thick: 0.0062 * size, key: "s" });
    drawTriads(scene, [c], [`${look}ᶜ`], [`{${look}} Craig`], { reach: 0.16 * size, thick: 0.0062 * size, dashed: true, key: "c" });
  }

  // The axes of the joints before and after frame {look}: Craig's z lies on the first, the standard z on the second.
  function jointAxes(scene) {
    const places = jointPlaces("standard", chains.standard);
    for (const k of [look - 1, look]) {
      const place = places[k];
      if (!place) continue;
      const ends = [-0.34, 0.34].map((s) => along(place.at, place.along, s * mode.size));
      scene.line(ends, { color: "quiet", pixels: 1.2, dash: [9, 3, 2, 3], under: true });
      scene.label(`axis of joint ${k + 1}`, ends[1], { toward: place.along, color: "quiet", size: 12, far: true, key: `joint${k}` });
    }
  }

  function said() {
    return sentence();
  }
}
