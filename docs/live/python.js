// Python, from files that stand beside this one: the same in a page's worker and in Node.

// What Pyodide would fetch of itself: nothing.
export const NOTHING_ELSE = JSON.stringify({
  info: { abi_version: "2026_0", arch: "wasm32", platform: "emscripten_5_0_3", python: "3.14.0", version: "314.0.3" },
  packages: {},
});

// host: { bytes(name) → Promise of a Uint8Array, now(name) → a Uint8Array at once, send(text) }
export async function start(host, { loadPyodide, createPyodideModule, options = {} }) {
  const python = await loadPyodide({ createPyodideModule, packages: [], ...options });
  const modules = ["bridge.py", "anywidget.py", "bench.py"];
  const [wheels, ...sources] = await Promise.all(["wheels.json", ...modules].map(host.bytes));
  const text = (bytes) => new TextDecoder().decode(bytes);
  python.registerJsModule("page", { wheel: host.now, wheels: text(wheels), send: host.send });
  const site = python.runPython("import site; site.getsitepackages()[0]");
  python.FS.mkdirTree(site);
  modules.forEach((name, k) => python.FS.writeFile(`${site}/${name}`, sources[k]));
  const made = python.pyimport("bridge");
  return {
    python,
    run: (cell, source) => made.run(cell, source),
    hear: (message) => made.hear(JSON.stringify(message)),
    log: (lines) => (lines === undefined ? made.log() : made.log(lines)),
    fresh: () => made.fresh(),
  };
}
