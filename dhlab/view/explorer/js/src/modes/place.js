// Mode "place": bare joint axes. With a kernel the learner chooses among lines, points and directions, and Python judges each step;
// on a page without one a worked placement is played step by step.

import { button, slider } from "../controls.js";
import { h, write } from "../dom.js";
import { below, unitOf, vector } from "../format.js";
import { IDENTITY, along, axis, cross, origin, unit } from "../matrix.js";
import { FramesTable } from "../tables.js";
import { roundabout } from "./round.js";

const ASKS = { z: (i) => `Along which line, and which way, does z${below(i)} run?`, o: (i) => `Where does the origin of {${i}} stand?`,
  x: (i) => `Which way does x${below(i)} point?` };
const START = "Place every z, then origin and x, frame by frame. Turn the view to see which line is which.";
const NOBODY = "Python has not answered. Run the cell above again, or wait until it is done with other cells.";
const PATIENCE = 4000; // milliseconds
const STILL = 4; // points that a hand may move in a click
const LETTERS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";

export function placeMode(host, redraw) {
  const { axes, end, reach } = host.data, lengths = unitOf(host.data), n = axes.length - 1;
  const mode = { size: reach, unit: lengths, build, said };
  const frameTable = new FramesTable(Array.from({ length: n + 1 }, (_, i) => `{${i}}`), lengths), tableHere = h("div");
  let placed = new Map(), words = "", shownArm = null, round = null;
  const ways = (host.live ? judged : worked)(host, mode, redraw);
  mode.controls = ways.controls;
  mode.close = ways.close;
  [mode.grab, mode.hover] = [ways.grab, ways.hover];
  mode.below = [tableHere];
  mode.frames = frameTable.element;
  mode.changed = () => {
    ({ placed, words } = ways.changed());
    showTable(ways.arm());
    showFrames();
    redraw();
  };
  mode.changed();
  return mode;

  function said() {
    return words;
  }

  function showTable(arm) {
    if (arm === shownArm) return;
    shownArm = arm;
    round = arm && roundabout(arm, lengths, redraw, () => (showFrames(), redraw()));
    tableHere.replaceChildren(...(round ? [round.element] : []));
  }

  function showFrames() {
    const seen = round ? round.settled(placed) : placed;
    frameTable.set(Array.from({ length: n + 1 }, (_, i) => frameRow(seen, i, lengths)));
  }

  function build(scene) {
    const base = { reach: 0.13 * reach, thick: 0.004 * reach };
    scene.seeThrough(0.45, () => [IDENTITY, end].forEach((T) => [0, 1, 2].forEach((j) => scene.arrow(origin(T), axis(T, j), base.reach, base.thick, "xyz"[j]))));
    scene.label("base", [0, 0, 0], { color: "quiet", far: true });
    scene.label("end", origin(end), { color: "quiet", far: true });
    axes.slice(0, n).forEach((one, k) => drawAxis(scene, one, k + 1, reach));
    scene.onTop(() => {
      const seen = round ? round.moving(placed, scene.time) : placed;
      for (let i = 0; i <= n; i++) drawFrame(scene, seen, i, reach);
      ways.draw?.(scene);
    });
    scene.keep(origin(end), [0, 0, 0]);
  }
}

function drawAxis(scene, { p, z, letter }, k, reach) {
  const ends = [-0.26, 0.26].map((s) => along(p, z, s * reach));
  const [low, high] = z[2] < 0 ? [0.38, -0.38] : [-0.38, 0.38], floor = z[2] && (scene.lowest - p[2]) / z[2]; // from p, along z, to the floor
  const through = p[2] + low * reach * z[2] < scene.lowest;
  if (through) scene.ring(along(p, z, floor), 2.6, { color: "quiet", fill: true });
  scene.line([along(p, z, through ? floor : low * reach), along(p, z, high * reach)], { color: "quiet", pixels: 1.1, dash: [10, 3, 2, 3], under: true });
  scene.joint(p, z, 0.024 * reach, 0.05 * reach, "joint", letter === "P");
  scene.label(`joint ${k}`, ends[1], { toward: z, color: "quiet", size: 12, far: true, key: `joint${k}` });
  scene.keep(...ends);
}

// What is placed of frame i: z as an arrow, the origin as a ball, x, and then y of itself.
function drawFrame(scene, placed, i, reach) {
  const [z, o, x] = ["z", "o", "x"].map((letter) => placed.get(letter + i));
  const at = o ?? placed.get(`on${i}`);
  if (!z || !at) return;
  const far = 0.15 * reach, thick = 0.0055 * reach;
  if (o) scene.ball(o, 2 * thick, "ink");
  if (o) scene.label(`{${i}}`, o, { far: true, weight: 600, key: `title${i}` });
  scene.label(`z${below(i)}`, scene.arrow(at, z, far, 1.3 * thick, "z"), { toward: z, color: "z" });
  if (!x) return;
  scene.label(`x${below(i)}`, scene.arrow(o, x, far, thick, "x"), { toward: x, color: "x" });
  scene.label(`y${below(i)}`, scene.arrow(o, cross(z, x), far, thick, "y"), { toward: cross(z, x), color: "y" });
}

function frameRow(placed, i, lengths) {
  const [z, o, x] = ["z", "o", "x"].map((letter) => placed.get(letter + i));
  return [`{${i}}`, ...[0, 1, 2].map((k) => (o ? lengths.bare(o[k]) : "–")), x ? vector(x) : "–", x && z ? vector(cross(z, x)) : "–", z ? vector(z) : "–"];
}

// Steps as a map from "z1" to its value; "on1" is a point of z1's line, for as long as its origin is not placed.
function mapOf(steps, data) {
  const placed = new Map(steps.map(({ step, value }) => [step, value]));
  for (let i = 0; i < data.axes.length; i++) {
    const z = placed.get(`z${i}`), k = data.convention === "standard" ? i : i - 1, own = data.axes[k];
    if (z && own) placed.set(`on${i}`, own.p);
  }
  return placed;
}

function worked(host, mode, redraw) {
  const { data } = host, steps = data.worked, word = h("p", { class: "verdict" });
  const list = h("ol", { class: "steps", tabindex: 0, "aria-label": "Steps" }, ...steps.map(({ step, message }) => h("li", {}, `${pretty(step)}: ${message}`)));
  const to = (k) => host.set("step", Math.max(0, Math.min(steps.length, k)));
  const bar = { start: button("To the start", () => to(0)), back: button("◀ Back", () => to(host.get("step") - 1)),
    on: button("Forward ▶", () => to(host.get("step") + 1)), all: button("To the end", () => to(steps.length)) };
  return {
    controls: [h("p", {}, "A worked placement, step by step. With a kernel you place the frames yourself."),
      h("div", { class: "transport", role: "group", "aria-label": "Play the steps" }, ...Object.values(bar)), word, list],
    arm: () => (host.get("step") === steps.length ? data.finished : null),
    changed() {
      const k = host.get("step");
      bar.back.disabled = bar.start.disabled = k === 0;
      bar.on.disabled = bar.all.disabled = k === steps.length;
      [...list.children].forEach((item, i) => { item.className = i === k - 1 ? "now" : ""; item.hidden = i >= k; });
      list.scrollTop = list.scrollHeight;
      const words = k ? `${pretty(steps[k - 1].step)}: ${steps[k - 1].message}` : `${steps.length} steps: every z, then origin and x, frame by frame.`;
      write(word, words);
      return { placed: mapOf(steps.slice(0, k), data), words };
    },
  };
}

function judged(host, mode, redraw) {
  const { data } = host;
  let answer, chosen = null;
  const ask = h("legend"), offers = h("fieldset", { class: "choice offers" }, ask), what = h("p", { class: "hint" });
  const verdict = h("p", { class: "verdict" }), progress = h("p", { class: "hint" });
  const slide = slider({ symbol: "↔", name: "Along the line of z", turn: false, unit: unitOf(data), low: -1.2 * data.reach, high: 1.2 * data.reach,
    changed: (value) => choose(free(value)) });
  const submit = button("Place it", () => chosen && tell({ step: answer.next, value: chosen.value, point: chosen.point }), { class: "submit" });
  const back = button("Undo", () => tell({ back: true })), again = button("Start over", () => tell({ again: true }));
  let waiting = 0;
  return {
    controls: [verdict, offers, what, slide.element, h("div", { class: "transport" }, submit, back, again), progress],
    arm: () => answer.arm,
    close: () => clearTimeout(waiting),
    changed() {
      clearTimeout(waiting);
      const placing = submit.matches(":focus");
      answer = host.get("_answer");
      chosen = null;
      show();
      if (placing) onwards();
      return { placed: mapOf(answer.placed, data), words: spoken() };
    },
    // A click near an offer chooses it, a second one places it; a chosen origin that may stand anywhere on its line can be dragged along
    // it, and snaps to the offers there.
    grab(at, camera, near) {
      const one = nearest(at, camera, near), own = answer.next?.[0] === "o" ? line() : null;
      const held = own && chosen && Math.hypot(...camera.flat(chosen.value).map((v, k) => v - at[k])) <= near && (!one || one === chosen);
      if (!held) return one && ((_, done) => done && (one === chosen ? submit.click() : take(one)));
      let moved = false;
      return (to, done) => {
        moved ||= Math.hypot(to[0] - at[0], to[1] - at[1]) > STILL;
        if (!moved) return done && one && submit.click();
        const [p, z] = own, [a, b] = [camera.flat(p), camera.flat(along(p, z, 1))], way = [b[0] - a[0], b[1] - a[1]];
        const far = ((to[0] - a[0]) * way[0] + (to[1] - a[1]) * way[1]) / (way[0] ** 2 + way[1] ** 2 || 1);
        take(nearest(to, camera, near) ?? free(far));
      };
    },
    hover: (at, camera, near) => at && nearest(at, camera, near),
    draw(scene) {
      answer.offers.forEach((offer, k) => drawOffer(scene, offer, k));
      if (chosen && !answer.offers.includes(chosen)) scene.ball(chosen.value, 0.02 * data.reach, "error");
    },
  };

  // A notebook that was opened again shows this view before its cell has run: then nobody is there to judge.
  function tell(message) {
    clearTimeout(waiting);
    waiting = setTimeout(() => {
      verdict.className = "verdict wrong";
      verdict.textContent = NOBODY;
    }, PATIENCE);
    host.send(message);
  }

  function spoken() {
    const { said, next } = answer, verdict = said ? `${said.right ? "Right" : "Not yet"}. ${pretty(said.step)}: ${said.message} ` : "";
    return verdict + (next ? `Next: ${question()}` : "All frames are placed; the table is below.");
  }

  function question() {
    return ASKS[answer.next[0]](answer.next.slice(1));
  }

  function show() {
    const { said, next, left } = answer;
    verdict.className = `verdict ${said ? (said.right ? "right" : "wrong") : ""}`;
    verdict.replaceChildren(...(said ? [h("b", {}, said.right ? "✓ Right. " : "✗ Not yet. "), `${pretty(said.step)}: ${said.message}`] : [START]));
    verdict.hidden = !said && !next;
    offers.hidden = what.hidden = submit.hidden = !next;
    back.disabled = again.disabled = !answer.placed.length;
    slide.element.hidden = !next || next[0] !== "o" || !line();
    progress.textContent = next ? `${left} ${left === 1 ? "step" : "steps"} left` : "All frames are placed. Every valid choice gives a right table; yours is below.";
    if (!next) return;
    slide.set(0);
    ask.textContent = question();
    offers.replaceChildren(ask, ...answer.offers.map((offer, k) => {
      const input = h("input", { type: "radio", name: "offer", checked: offer === chosen, "aria-label": `${LETTERS[k]}: ${describe(offer)}`, onchange: () => choose(offer) });
      return h("label", {}, input, h("span", {}, LETTERS[k]));
    }));
    choose(chosen);
  }

  // Keys that placed go on with what is offered next: the button they were on has nothing to place now.
  function onwards() {
    (answer.next ? offers.querySelector("input") : back).focus({ preventScroll: true });
  }

  function choose(offer) {
    chosen = offer;
    submit.disabled = !offer;
    write(what, offer ? describe(offer) : "Each letter stands in the view. Click one there or here, then place it, or click it again.");
    redraw();
  }

  function take(offer) {
    for (const [k, input] of [...offers.querySelectorAll("input")].entries()) input.checked = answer.offers[k] === offer;
    choose(offer);
  }

  // The offer that is drawn nearest to a point of the canvas.
  function nearest(at, camera, near) {
    const far = answer.offers.map((offer) => {
      const [from, to] = drawnAt(offer).map((p) => camera.flat(p)), [x, y] = [to[0] - from[0], to[1] - from[1]];
      const t = Math.max(0.35, Math.min(1, ((at[0] - from[0]) * x + (at[1] - from[1]) * y) / (x * x + y * y || 1))); // where arrows start they are together
      return Math.hypot(at[0] - from[0] - t * x, at[1] - from[1] - t * y);
    });
    const least = Math.min(...far);
    return least <= near ? answer.offers[far.indexOf(least)] : null;
  }

  // From where to where an offer is drawn: a point, or an arrow.
  function drawnAt(offer) {
    const [letter, i] = [answer.next[0], answer.next.slice(1)];
    if (letter === "o") return [offer.value, offer.value];
    const from = offer.point ?? answer.placed.find((one) => one.step === `o${i}`)?.value ?? [0, 0, 0];
    const start = letter === "z" ? along(from, offer.value, 0.06 * data.reach) : from;
    return [start, along(start, unit(offer.value), 0.22 * data.reach)];
  }

  // The line of the z whose origin is asked for, where an origin may be anywhere on it.
  function line() {
    const i = Number(answer.next.slice(1)), z = answer.placed.find((one) => one.step === `z${i}`)?.value, own = data.axes[data.convention === "standard" ? i : i - 1];
    return z && own && own.letter === "R" ? [own.p, z] : null;
  }

  function free(value) {
    slide.set(value);
    for (const input of offers.querySelectorAll("input")) input.checked = false;
    const [p, z] = line();
    return { words: "", value: along(p, z, value), point: null };
  }

  function describe({ words, value }) {
    return words || (answer.next[0] === "o" ? unitOf(data).place(value) : `along ${vector(value)}`);
  }

  function drawOffer(scene, offer, k) {
    const here = offer === chosen, color = here ? "error" : "trace", size = 13, weight = here ? 800 : 500, key = `offer${k}`;
    if (answer.next[0] === "o") {
      scene.ball(offer.value, (here ? 0.02 : 0.013) * data.reach, color);
      scene.label(LETTERS[k], offer.value, { color, far: true, size, weight, key });
      return;
    }
    const [start] = drawnAt(offer);
    const tip = scene.arrow(start, unit(offer.value), 0.22 * data.reach, (here ? 0.008 : 0.0045) * data.reach, color);
    scene.label(LETTERS[k], tip, { toward: offer.value, color, size, weight, key });
  }
}

const pretty = (step) => (step[0] === "o" ? `origin of {${step.slice(1)}}` : step[0] + below(step.slice(1)));
