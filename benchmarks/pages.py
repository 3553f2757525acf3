"""Every page of the site in Chromium: what axe finds, light and dark, wide and on a phone; what it
asks the outside for; script errors; what it weighs before anything is run.

    make site LIVE=1
    python benchmarks/pages.py                      # all pages; bench and lessons at work
    python benchmarks/pages.py index bench/index    # these
    python benchmarks/pages.py --run 00 04          # only these lessons run

Weight is what a host that compresses sends when a page is opened on a wide screen. axe-core is the
version that the explorer's package.json names; where it is not installed there, npm brings it.
"""

import gzip
import json
import subprocess
import sys
import tarfile
import tempfile
from pathlib import Path
from urllib.parse import unquote, urlsplit

from serving import ROOT, arguments, chromium, served

JS = ROOT / "dhlab" / "view" / "explorer" / "js"
LOOKS = [(mode, width) for width in (1280, 390) for mode in ("light", "dark")]
AXE = """() => axe.run().then((r) => r.violations.flatMap((v) => v.nodes.map((n) =>
    [v.id, [].concat(n.target).flat().join(" "), n.html.slice(0, 120)])))"""
STILL = """() => new Promise((done) => requestAnimationFrame(() => setTimeout(done, 250)))
    .then(() => Promise.all(document.getAnimations().map((one) => one.finished.catch(() => 0))))"""
WIDE = "() => document.documentElement.scrollWidth - document.documentElement.clientWidth"
PACKED = (".webp", ".png", ".woff2", ".zip", ".whl", ".bin")  # gzip makes them no smaller
MOST = 150_000  # bytes, before anything is run


def axe():
    """The text of axe-core."""
    installed = JS / "node_modules" / "axe-core" / "axe.min.js"
    if installed.exists():
        return installed.read_text(encoding="utf-8")
    version = json.loads((JS / "package.json").read_text())["devDependencies"]["axe-core"]
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(
            ["npm", "pack", "--silent", f"axe-core@{version}"],
            cwd=folder,
            check=True,
            stdout=subprocess.DEVNULL,
        )
        with tarfile.open(next(Path(folder).glob("*.tgz"))) as held:
            return held.extractfile("package/axe.min.js").read().decode()


class Look:
    """One page, opened; ``faults`` and ``files`` fill while it is used."""

    def __init__(self, browser, address, name):
        self.name, self.files, self.outside, self.errors = name, set(), [], []
        self.page = browser.new_page(viewport={"width": 1280, "height": 900})
        self.page.set_default_timeout(240_000)
        self.page.on("request", lambda r: self.asked(r.url, address))
        self.page.on("pageerror", lambda error: self.errors.append(str(error)))
        self.page.on("console", lambda m: m.type == "error" and self.errors.append(m.text))
        self.page.goto(f"{address}/{name}.html", wait_until="networkidle")
        self.weight = list(self.files)

    def asked(self, url, address):
        if url.startswith(address):
            self.files.add(unquote(urlsplit(url).path).lstrip("/"))
        elif not url.startswith(("data:", "blob:")):
            self.outside.append(url)

    def looked_at(self, axe):
        """What axe finds in the four looks, and where the page is wider than the screen."""
        self.page.evaluate(axe)
        self.found, self.wide = {}, []
        for mode, width in LOOKS:
            self.page.emulate_media(color_scheme=mode, reduced_motion="reduce")
            self.page.set_viewport_size({"width": width, "height": 900})
            self.page.evaluate(STILL)
            for rule, target, html in self.page.evaluate(AXE):
                self.found.setdefault((rule, target, html), []).append(f"{mode} {width}")
            if self.page.evaluate(WIDE) > 0:
                self.wide.append(f"{mode} {width}")
        self.page.close()
        return self


def weight(html, files):
    """Bytes that are sent for these files."""
    total = 0
    for name in files:
        path = html / (name or "index.html")
        if path.is_file():
            data = path.read_bytes()
            total += len(data if path.suffix in PACKED else gzip.compress(data, 6))
    return total


def bench_answered(look):
    """The bench with an answer of every kind but the doctor's, one after another."""
    page = look.page
    page.locator("textarea").first.fill("ur5e")
    for do in ("read", "fk", "convert", "compare"):
        page.locator(f'input[value="{do}"]').check(force=True)
        if do == "compare":
            page.get_by_label("The other arm").fill("ur10e")
        page.get_by_role("button", name="Answer").click()
        page.locator(".bench-results > *").first.wait_for()
    page.wait_for_timeout(1500)


def lesson_run(look):
    """A lesson with all its cells run, nothing filled in."""
    page = look.page
    page.get_by_role("button", name="Run this lesson").click()
    page.get_by_role("button", name="Run all").click()
    ended = "document.querySelectorAll('[data-live=ran], [data-live=failed]').length"
    page.wait_for_function(f"{ended} === document.querySelectorAll('.live-cell').length")
    page.wait_for_timeout(1500)


def row(look, html, note=""):
    """A line of the table, and after it what was found."""
    heavy = weight(html, look.weight)
    faults = [
        f"{rule} at {target} ({', '.join(looks)}): {text}"
        for (rule, target, text), looks in look.found.items()
    ]
    faults += [f"wider than the screen: {', '.join(look.wide)}"] if look.wide else []
    faults += [f"asked for {url}" for url in look.outside]
    faults += [f"script: {text}" for text in look.errors]
    faults += [f"weighs {heavy / 1000:.0f} kB"] if heavy > MOST else []
    print(
        f"| {look.name}{note} | {len(look.found)} | {len(look.outside)} | {len(look.errors)}"
        f" | {heavy / 1000:.0f} |",
        *[f"    {fault}" for fault in faults],
        sep="\n",
        flush=True,
    )
    return len(faults), heavy


def main():
    """The command line; the exit is 1 where anything was found."""
    parser = arguments(__doc__)
    parser.add_argument("pages", nargs="*", help="such as index or robots/ur5e; all where none")
    parser.add_argument("--run", nargs="*", metavar="NN", help="lessons to run; all where none")
    given = parser.parse_args()
    html, rules = given.html, axe()
    names = given.pages or sorted(
        path.relative_to(html).with_suffix("").as_posix()
        for path in html.rglob("*.html")
        if not {"_static", "lab"} & set(path.relative_to(html).parts)
    )
    lessons = sorted(path.stem for path in (html / "live" / "lessons").glob("*.ipynb"))
    if given.run or (given.pages and given.run is None):
        lessons = [name for name in lessons if name.split("-")[0] in (given.run or ())]
    states = [("bench/index", ", answered", bench_answered)]
    if given.pages and "bench/index" not in given.pages:
        states = []
    states += [(f"lessons/{name}", ", run", lesson_run) for name in lessons]
    print("| page | violations | outside requests | script errors | kB before Run |")
    print("|---|---|---|---|---|")
    rows = []
    with served(html) as address, chromium() as browser:
        for name in names:
            rows.append(row(Look(browser, address, name).looked_at(rules), html))
        for name, note, used in states:
            look = Look(browser, address, name)
            used(look)
            rows.append(row(look.looked_at(rules), html, note))
    faults = sum(count for count, _ in rows)
    heaviest = max(heavy for _, heavy in rows) / 1000
    print(f"{len(rows)} pages and states, {faults} faults, the heaviest {heaviest:.0f} kB")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
