// Runs Python beside the page, so that the page never waits. Messages in: start, run, widget. All
// that Python says goes out as it is said.

import { NOTHING_ELSE, start } from "./python.js";

const here = new URL(".", import.meta.url).href;
const at = (name) => new URL(name, here).href;

// files that were made small for hosts that do not compress what they serve
const squeezed = async (name, type) => {
  const answer = await fetched(`${name}.gz.bin`);
  return new Response(answer.body.pipeThrough(new DecompressionStream("gzip")), { headers: { "content-type": type } });
};

const plain = self.fetch.bind(self);
async function fetched(name) {
  const answer = await plain(at(name));
  if (!answer.ok) throw new Error(`expected the file ${name} on this site, found ${answer.status}`);
  return answer;
}
self.fetch = (what, ...rest) =>
  String(what.url ?? what).endsWith("pyodide.asm.wasm") ? squeezed("pyodide.asm.wasm", "application/wasm") : plain(what, ...rest);

const host = {
  bytes: async (name) => new Uint8Array(await (await fetched(name)).arrayBuffer()),
  now(name) {
    const held = ahead.get(name);
    if (held) return held;
    const request = new XMLHttpRequest();
    request.open("GET", at(name), false);
    request.responseType = "arraybuffer";
    request.send();
    if (request.status !== 200 && request.status !== 0) throw new Error(`expected the file ${name} on this site, found ${request.status}`);
    return new Uint8Array(request.response);
  },
  send: (text) => self.postMessage(text),
};
const say = (type, fields = {}) => host.send(JSON.stringify({ type, ...fields }));

async function module() {
  const text = await (await squeezed("pyodide.asm.mjs", "text/javascript")).text();
  const url = URL.createObjectURL(new Blob([text.replaceAll("import.meta.url", JSON.stringify(at("pyodide.asm.mjs")))], { type: "text/javascript" }));
  const loaded = await import(url);
  URL.revokeObjectURL(url);
  return loaded.default;
}

async function begin({ log, buffer }) {
  const wanted = [import(at("pyodide.mjs")), module()];
  const early = prefetch();
  const [{ loadPyodide }, createPyodideModule] = await Promise.all(wanted);
  const made = await start(host, { loadPyodide, createPyodideModule, options: { indexURL: here, lockFileContents: NOTHING_ELSE } });
  await early;
  if (buffer) made.python.setInterruptBuffer(buffer);
  if (log) made.log(log);
  return made;
}

// what the first cell of every lesson imports, fetched while Python starts
const ahead = new Map();
async function prefetch() {
  const wheels = JSON.parse(new TextDecoder().decode(await host.bytes("wheels.json")));
  await Promise.all(["numpy", "dhlab", "lazy_loader", "ruamel"].map(async (name) => ahead.set(wheels[name], await host.bytes(wheels[name]))));
}

let python;
self.onmessage = async ({ data }) => {
  try {
    if (data.type === "start") {
      python = begin(data);
      await python;
      say("ready");
      return;
    }
    const made = await python;
    if (data.type === "run") {
      const ok = made.run(data.cell, data.source);
      say("done", { cell: data.cell, ok, log: made.log() });
    } else if (data.type === "call") {
      say("answer", { id: data.id, text: made.python.pyimport(data.module)[data.name](data.text) });
    } else made.hear(data);
  } catch (error) {
    say("broken", { text: String(error.message ?? error) });
  }
};
