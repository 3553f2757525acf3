// The review: one answer at a time, by keyboard. Every text is set as text, never as HTML.
"use strict";

const $ = (id) => document.getElementById(id);
const STOPS = ["error", "timed out", "not allowed"];
const SHOWN = {
  all: () => true,
  look: (mark) => mark.look || mark.stale,
  wrong: (mark) => mark.status !== "right",
  decided: (mark) => isDecided(mark),
};
// of each student, asked for once; a Map, since an id may be "constructor"
const answers = new Map();
let exercises = [], students = [], list = [], at = 0;

const isDecided = (mark) => mark.given !== null || mark.comment !== "";
const here = () => list[at];
const markOf = (item) => item.student.marks[item.exercise];

async function ask(name, given) {
  const asked = given && { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(given) };
  let reply;
  try {
    reply = await fetch(name, asked || {});
  } catch {
    throw new Error("dhlab review does not answer any more; start it again. What was saved is kept.");
  }
  const told = await reply.json();
  if (!reply.ok) throw new Error(told && told.error ? told.error : "there is no such thing");
  return told;
}

function element(name, text, parent) {
  const made = document.createElement(name);
  made.textContent = text;
  parent.append(made);
  return made;
}

/** The answers that are shown: exercise by exercise, through the class. */
function listed(keep) {
  const wanted = $("exercise").value, shows = SHOWN[$("show").value];
  list = [];
  for (const { id } of exercises) {
    if (wanted && id !== wanted) continue;
    for (const student of students) {
      const mark = student.marks[id];
      if (mark && shows(mark)) list.push({ student, exercise: id });
    }
  }
  const same = keep ? list.findIndex((item) => item.student === keep.student && item.exercise === keep.exercise) : 0;
  at = Math.max(0, same);
  return show();
}

async function show() {
  const item = here();
  for (const id of ["answer", "form", "verdict"]) $(id).hidden = !item;
  const open = list.filter((one) => !isDecided(markOf(one))).length;
  $("count").textContent = item ? `${at + 1} of ${list.length}, ${open} not decided by you` : "";
  if (!item) {
    $("who").textContent = "Nothing here";
    $("what").textContent = "No answer is of this kind. Choose another under Show.";
    return;
  }
  const { student, exercise } = item, mark = markOf(item);
  $("who").textContent = student.name === student.id ? student.id : `${student.name} (${student.id})`;
  const title = exercises.find((one) => one.id === exercise).title;
  $("what").textContent = [`${exercise} ${title}`, mark.file, mark.came].filter(Boolean).join(" · ");
  verdict(student, mark);
  $("of").textContent = `of ${mark.of}; the grader gave ${mark.points}`;
  asked(exercises.find((one) => one.id === exercise), mark);
  $("points").value = mark.given === null ? "" : mark.given;
  $("points").placeholder = mark.points;
  $("comment").value = mark.comment;
  $("hold").value = student.hold;
  if (!answers.has(student.id)) answers.set(student.id, ask("answers/" + encodeURIComponent(student.id)));
  $("answer").textContent = "";
  $("pictures").replaceChildren();
  try {
    const own = await answers.get(student.id);
    if (item !== here()) return;
    const [text, pictures] = own[exercise] || ["", []];
    $("answer").textContent = text || "(nothing was written here)";
    pictures.forEach((_, k) => {
      const picture = element("img", "", $("pictures"));
      picture.alt = `Picture ${k + 1} of the answer`;
      picture.src = ["picture", student.id, exercise, k].map(encodeURIComponent).join("/");
    });
  } catch (error) {
    answers.delete(student.id);
    say(error.message);
  }
}

/** The question that a person marks, and its rubric: keys 1 to 9 tick a line, the points add up. */
function asked({ question, rubric = [] }, mark) {
  const box = $("rubric"), sum = rubric.reduce((all, [, points]) => all + points, 0);
  $("question").textContent = question || "";
  box.hidden = !rubric.length;
  box.replaceChildren(box.firstElementChild);
  const ticks = rubric.map(([text, points], k) => {
    const label = element("label", "", box), tick = element("input", "", label);
    tick.type = "checkbox";
    tick.checked = mark.ticks.includes(k + 1);
    label.append(` ${k + 1}: ${text} (${points})`);
    return tick;
  });
  box.onchange = () => {
    const earned = ticks.reduce((all, tick, k) => all + (tick.checked ? rubric[k][1] : 0), 0);
    $("points").value = Math.round((100 * earned * mark.of) / sum) / 100;
  };
}

/** The lines of the rubric that are ticked, from 1. */
const ticked = () => [...$("rubric").querySelectorAll("input")].flatMap((tick, k) => (tick.checked ? [k + 1] : []));

function verdict(student, mark) {
  const box = $("verdict");
  box.replaceChildren();
  box.className = STOPS.includes(mark.status) ? "stop" : mark.status;
  element("b", mark.status, element("p", "", box));
  if (mark.headline) element("p", mark.headline, box);
  for (const [label, text] of mark.lines) element("p", `${label}: ${text}`, box);
  if (mark.stale) element("p", "You decided when it had earned something else: look at it again.", box);
  for (const note of student.notes) element("p", `Note: ${note}`, box);
}

function say(text, soft = false) {
  $("said").textContent = text;
  $("said").className = soft ? "soft" : "";
}

/** Save what has changed; whether all is well. Nothing is left behind unsaved. */
async function save() {
  const item = here();
  if (!item) return true;
  const { student, exercise } = item, mark = markOf(item);
  const typed = $("points").value.trim().replace(",", ".");
  const points = typed === "" ? null : Number(typed);
  if (points !== null && !(points >= 0 && points <= mark.of)) {
    say(`Expected points from 0 to ${mark.of}, found ${typed}.`);
    $("points").focus();
    return false;
  }
  const comment = $("comment").value.trim(), hold = $("hold").value.trim();
  const given = [], ticks = ticked();
  const other = points !== mark.given || comment !== mark.comment || String(ticks) !== String(mark.ticks);
  if (other || (mark.stale && points !== null)) given.push({ student: student.id, exercise, points, comment, ticks });
  if (hold !== student.hold) given.push({ student: student.id, hold });
  try {
    for (const one of given) Object.assign(student, await ask("save", one));
  } catch (error) {
    say(error.message);
    return false;
  }
  say(given.length ? "Saved." : "", true);
  return true;
}

let busy = false;
async function go(find) {
  if (busy) return;
  busy = true;
  try {
    if (!(await save())) return;
    const next = find();
    if (next < 0 || next >= list.length) say("There is no other one in this list.", true);
    else at = next;
    await show();
    $("who").focus({ preventScroll: true });
    window.scrollTo(0, 0);
  } finally {
    busy = false;
  }
}

const next = () => at + 1;
const undecided = () => {
  const after = (from, to) => list.findIndex((item, k) => k >= from && k < to && !isDecided(markOf(item)));
  const later = after(at + 1, list.length);
  return later < 0 ? after(0, at) : later;
};
const KEYS = {
  n: () => go(next),
  p: () => go(() => at - 1),
  u: () => go(undecided),
  "]": () => turn(1),
  "[": () => turn(-1),
  m: () => $("points").focus(),
  c: () => $("comment").focus(),
  h: () => $("hold").focus(),
};

async function turn(step) {
  const box = $("exercise"), to = box.selectedIndex + step;
  if (to < 0 || to >= box.length || !(await save())) return;
  box.selectedIndex = to;
  await listed();
}

document.addEventListener("keydown", (event) => {
  const field = event.target.closest("input[type=text], textarea, select");
  if (event.key === "Enter" && (event.ctrlKey || event.metaKey)) {
    event.preventDefault();
    go(next);
  } else if (event.key === "Escape" && field) {
    $("who").focus();
  } else if (!field && !event.ctrlKey && !event.metaKey && !event.altKey && $("keys").checked && KEYS[event.key]) {
    event.preventDefault();
    KEYS[event.key]();
  } else if (!field && $("keys").checked && /^[1-9]$/.test(event.key)) {
    $("rubric").querySelectorAll("input")[event.key - 1]?.click();
  }
});
$("form").addEventListener("submit", (event) => {
  event.preventDefault();
  go(next);
});
$("back").addEventListener("click", async () => {
  for (const id of ["points", "comment"]) $(id).value = "";
  for (const tick of $("rubric").querySelectorAll("input")) tick.checked = false;
  await save();
  await show();
});
for (const id of ["exercise", "show"]) {
  let before = null;
  $(id).addEventListener("focus", () => (before = $(id).value));
  $(id).addEventListener("change", async () => {
    if (await save()) await listed(here());
    else $(id).value = before;
    before = $(id).value;
  });
}
window.addEventListener("beforeunload", (event) => {
  const item = here(), mark = item && markOf(item);
  if (mark && ($("comment").value.trim() !== mark.comment || $("hold").value.trim() !== item.student.hold)) event.preventDefault();
});

ask("class").then((told) => {
  ({ exercises, students } = told);
  $("exercise").append(new Option("all", ""), ...exercises.map(({ id, title }) => new Option(`${id} ${title}`, id)));
  return listed();
}).catch((error) => say(error.message));
