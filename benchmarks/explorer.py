"""What the explorer costs: the size of its module, script per slider move, frames a second, memory
after many moves, six on one page.

Run ``python benchmarks/explorer.py`` from the project's top folder; it needs Chromium, which draws
WebGL in software here. Times are medians of this machine at this moment; a pose computed in Python
stands beside them for scale.
"""

import gzip
import shutil
import sys
import time

import numpy as np
from playwright.sync_api import sync_playwright

import dhlab as dh
from dhlab.view.explorer.widget import MODULE

FLAGS = [
    "--no-sandbox",
    "--disable-gpu",
    "--enable-precise-memory-info",
    "--js-flags=--expose-gc",
    "--disable-background-networking",
]
PAGE = (
    '<!doctype html><html lang="en"><meta charset="utf-8"><title>Explorers</title><body>{}<script'
    ' type="module">{}</script>'
)
MOVES = """many => { const { host, stage } = document.querySelector('.dhlab-explorer').explorer, n = host.get('q').length, times = [];
    const slider = stage.canvas.getRootNode().querySelector('input[type=range]'), low = Number(slider.min), high = Number(slider.max);
    for (let k = 0; k < many; k++) {
        slider.value = low + (high - low) * (0.5 + 0.5 * Math.sin(k / 50));
        const start = performance.now();
        slider.dispatchEvent(new Event('input'));
        times.push(performance.now() - start);
    }
    return times; }"""
DRAWS = """many => { const { stage } = document.querySelector('.dhlab-explorer').explorer, times = [];
    for (let k = 0; k < many; k++) { stage.camera.turnBy(1, 0); const start = performance.now(); stage.draw(start); times.push(performance.now() - start); }
    return times; }"""
FRAMES = """seconds => new Promise((done) => { const stages = [...document.querySelectorAll('.dhlab-explorer')].map((e) => e.explorer.stage).filter((stage) => stage.awake);
    const start = performance.now(), before = stages.map((stage) => stage.drawn);
    const turn = (now) => { for (const stage of stages) { stage.camera.turnBy(1, 0); stage.redraw(); }
        if (now - start < 1000 * seconds) requestAnimationFrame(turn);
        else done([stages.length, ...stages.map((stage, k) => (stage.drawn - before[k]) / (now - start) * 1000)]); };
    requestAnimationFrame(turn); })"""
MEMORY = "() => { gc(); gc(); return performance.memory.usedJSHeapSize / 1e6; }"


def opened(browser, explorers):
    """A page without a kernel that shows them."""
    page = browser.new_page(viewport={"width": 1280, "height": 900})
    stills = {"text/html": "", "text/plain": ""}
    bundles = [explorer._repr_mimebundle_(still=stills) for explorer in explorers]
    html = "".join(
        (bundle[0] if isinstance(bundle, tuple) else bundle)["text/html"] for bundle in bundles
    )
    page.set_content(PAGE.format(html, MODULE.read_text(encoding="utf-8")))
    page.wait_for_function("document.querySelector('.dhlab-explorer').explorer?.stage.drawn")
    return page


def measure(browser):
    """Print the numbers."""
    arm = dh.load("ur5e")
    page = opened(browser, [dh.explore(arm)])
    page.evaluate(MOVES, 500)
    print(
        f"script a slider move: median {np.median(page.evaluate(MOVES, 2000)):.3f} ms (slider,"
        " pose, tables)"
    )
    print(
        f"script a picture:     median {np.median(page.evaluate(DRAWS, 100)):.1f} ms (scene, WebGL"
        " in software, labels)"
    )
    q = np.zeros(6)
    start = time.perf_counter()
    for _ in range(200):
        arm.frames(q)
    print(f"the frames in Python: {5 * (time.perf_counter() - start):.3f} ms")
    print(f"frames a second:      {page.evaluate(FRAMES, 3)[1]:.0f}, turning without a pause")
    before = page.evaluate(MEMORY)
    page.evaluate(MOVES, 10_000)
    page.wait_for_timeout(500)
    middle = page.evaluate(MEMORY)
    page.evaluate(MOVES, 10_000)
    page.wait_for_timeout(500)
    print(
        f"memory:               {before:.2f} MB, {middle:.2f} MB after 10,000 moves,"
        f" {page.evaluate(MEMORY):.2f} MB after 20,000"
    )
    page.close()
    page = opened(
        browser,
        [
            dh.explore(dh.load(name))
            for name in ("ur5e", "panda", "article-6r", "stanford", "iiwa14", "puma560")
        ],
    )
    seen, *rates = page.evaluate(FRAMES, 3)
    print(
        f"six on a page:        {seen} in sight at {', '.join(f'{rate:.0f}' for rate in rates)}"
        " frames a second each; the others sleep"
    )


def main():
    module = MODULE.read_bytes()
    print(
        f"module:               {len(module) / 1000:.1f} kB,"
        f" {len(gzip.compress(module, 9)) / 1000:.1f} kB gz, all modes and styles"
    )
    chromium = (
        shutil.which("chromium")
        or shutil.which("chromium-browser")
        or shutil.which("google-chrome")
    )
    if chromium is None:
        sys.exit("no Chromium here, so nothing else was measured: apt-get install chromium")
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium, args=FLAGS)
        measure(browser)
        browser.close()


if __name__ == "__main__":
    main()
