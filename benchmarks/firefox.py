"""The site in Firefox: whether its explorer is drawn and turns, lessons run, answers are checked
and the bench answers; seconds, script errors and requests to elsewhere.

    make site LIVE=1
    xvfb-run -a -s "-screen 0 1280x1000x24" python benchmarks/firefox.py [--shots FOLDER]

Firefox (Debian: firefox-esr) is spoken to in WebDriver BiDi, through the socket that it opens
itself. It needs a screen, or that of Xvfb: without one it runs, but gives pages no WebGL. Its
profile is new for each line, so that nothing comes from a cache. Exit 1 where something did not
come, a script failed or something was asked of elsewhere.
"""

import base64
import contextlib
import itertools
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from first_answers import POSES, right, table
from serving import Quiet, arguments, served
from websocket import create_connection

EVENTS = ["log.entryAdded", "network.beforeRequestSent"]
PREFERENCES = """user_pref("app.update.enabled", false);
user_pref("browser.shell.checkDefaultBrowser", false);
user_pref("datareporting.policy.dataSubmissionEnabled", false);
user_pref("toolkit.telemetry.enabled", false);
user_pref("network.captive-portal-service.enabled", false);
user_pref("network.connectivity-service.enabled", false);
user_pref("webgl.force-enabled", true);
"""
PATIENCE = 240  # seconds for one thing to happen
TOOLS = """
const until = async (what) => {
    for (const end = performance.now() + 1000 * PATIENCE; performance.now() < end; await new Promise((next) => setTimeout(next, 20))) { const found = what(); if (found) return found; }
    throw new Error(`did not come: ${what}`); };
const seen = (where) => until(() => document.querySelector(where));
const press = async (words) => (await until(() => [...document.querySelectorAll("button")].find((one) => one.textContent === words))).click();
const fill = (area, text) => { area.value = text; area.dispatchEvent(new Event("input", { bubbles: true })); };
"""
ALIVE = """const { stage, host } = (await until(() => document.querySelector(".dhlab-explorer")?.explorer));
await until(() => stage.drawn > 0);
const box = stage.canvas.getBoundingClientRect(), centre = stage.camera.azimuth;
return { drawn: stage.drawn, azimuth: centre, at: [box.x + 12, box.y + box.height / 2], q: host.get("q"),
    inks: new Set(stage.canvas.getContext("2d").getImageData(0, 0, stage.canvas.width, stage.canvas.height).data).size };"""
HOME = 'const { camera } = document.querySelector(".dhlab-explorer").explorer.stage; return camera.azimuth;'
EVERY_CELL = """await press("Run this lesson");
await press("Run all");
const cells = await until(() => { const all = document.querySelectorAll(".live-cell"); return all.length && all; });
await until(() => document.querySelectorAll("[data-live=ran], [data-live=failed]").length === cells.length);
return { cells: cells.length, failed: document.querySelectorAll("[data-live=failed]").length };"""
CHECK = """await press("Run this lesson");
const cells = await until(() => { const all = [...document.querySelectorAll(".live-cell textarea")]; return all.length && all; });
const check = cells.findIndex((one) => one.value.includes('check("05.1"'));
fill(cells[check - 1], ANSWER);
const places = cells.slice(0, check + 1).map((one) => one.closest("div.cell"));
for (const place of places) {
    place.querySelector(".live-run").click();
    await until(() => ["ran", "failed"].includes(place.dataset.live));
}
return { said: places[check].querySelector(".live-output").innerText.replace(/\\s+/g, " ").slice(0, 90) };"""
BENCH = """fill(await seen("textarea"), TABLE);
document.querySelector('input[value="diagnose"]').click();
fill(await until(() => [...document.querySelectorAll("textarea")].find((one) => [...one.labels].some((label) => label.textContent.includes("Measured poses")))), POSES);
await press("Answer");
const head = await until(() => [...document.querySelectorAll("h2, h3")].find((one) => one.textContent.includes("The doctor says")));
return { said: head.parentElement.innerText.replace(/\\s+/g, " ").slice(0, 140) };"""
GIF = """const { motion, host } = await until(() => document.querySelector(".dhlab-explorer")?.explorer?.motion && document.querySelector(".dhlab-explorer").explorer);
host.set("q", [0, -1, 1, 0, 0, 0]);
motion.keep();
const taken = new Promise((done) => { const own = URL.createObjectURL; URL.createObjectURL = (blob) => { done(blob); return own.call(URL, blob); }; });
motion.animate("motion");
const gif = await taken;
return { bytes: gif.size, head: new TextDecoder().decode((await gif.arrayBuffer()).slice(0, 6)), video: motion.type ?? "none" };"""


class Firefox:
    """A new Firefox and the one page in it."""

    def __init__(self, profile, address):
        self.address, self.wrong, self.numbers = address, [], itertools.count(1)
        (profile / "user.js").write_text(PREFERENCES, encoding="utf-8")
        program = shutil.which("firefox-esr") or shutil.which("firefox")
        if program is None:
            sys.exit("expected Firefox, found none; on Debian: apt-get install firefox-esr")
        screen = [] if os.environ.get("DISPLAY") else ["--headless"]
        command = [program, *screen, "--no-remote", "--profile", str(profile)]
        self.process = subprocess.Popen(
            [*command, "--remote-debugging-port", "0"],
            stderr=subprocess.PIPE,
            stdout=subprocess.DEVNULL,
            text=True,
        )
        told = next(line for line in self.process.stderr if "BiDi listening on" in line)
        where = told.split()[-1]
        self.socket = create_connection(
            f"{where}/session", timeout=2 * PATIENCE, suppress_origin=True, max_size=None
        )
        self.ask("session.new", capabilities={})
        self.page = self.ask("browsingContext.getTree")["contexts"][0]["context"]
        self.ask("session.subscribe", events=EVENTS)

    def ask(self, method, **params):
        """The answer to one command; what the page reports meanwhile is kept."""
        number = next(self.numbers)
        self.socket.send(json.dumps({"id": number, "method": method, "params": params}))
        while True:
            message = json.loads(self.socket.recv())
            if message.get("id") == number:
                if message["type"] == "error":
                    raise SystemExit(f"{method}: {message['message']}")
                return message["result"]
            self.hear(message)

    def hear(self, message):
        """Keep a script error, or a request to elsewhere."""
        what, params = message.get("method"), message.get("params", {})
        if what == "log.entryAdded" and params["level"] == "error":
            self.wrong.append(f"script: {params['text']}")
        if what == "network.beforeRequestSent":
            url = params["request"]["url"]
            if not url.startswith((self.address, "data:", "blob:")):
                self.wrong.append(f"asked for {url}")

    def go(self, name):
        self.ask(
            "browsingContext.navigate",
            context=self.page,
            url=f"{self.address}/{name}",
            wait="complete",
        )

    def run(self, script, **values):
        """What a script on the page returns, as JSON."""
        values["PATIENCE"] = PATIENCE
        given = "".join(f"const {name} = {json.dumps(value)};" for name, value in values.items())
        found = self.ask(
            "script.callFunction",
            target={"context": self.page},
            awaitPromise=True,
            functionDeclaration="async () => { const own = async () => {"
            + given
            + TOOLS
            + script
            + "}; return JSON.stringify(await own()); }",
        )
        if found["type"] == "exception":
            self.wrong.append(found["exceptionDetails"]["text"])
            return {}
        return json.loads(found["result"]["value"])

    def drag(self, start, by):
        """One drag of the mouse."""
        x, y = map(round, start)
        moves = [
            {"type": "pointerMove", "x": x, "y": y},
            {"type": "pointerDown", "button": 0},
            {"type": "pointerMove", "x": x + by[0], "y": y + by[1], "duration": 200},
            {"type": "pointerUp", "button": 0},
        ]
        hand = {"type": "pointer", "id": "hand", "actions": moves}
        self.ask("input.performActions", context=self.page, actions=[hand])

    def picture(self, path):
        shot = self.ask("browsingContext.captureScreenshot", context=self.page)
        path.write_bytes(base64.b64decode(shot["data"]))

    def close(self):
        with contextlib.suppress(Exception):
            self.ask("browser.close")
        self.process.wait(timeout=30)


def turned(firefox):
    """The explorer of the page is drawn, and a drag beside the arm turns it."""
    before = firefox.run(ALIVE)
    if not before:
        return "not drawn"
    firefox.drag(before["at"], (90, 0))
    after = firefox.run(HOME)
    if before["inks"] < 20 or after == before["azimuth"]:
        firefox.wrong.append(f"the explorer is not alive: {before}, then at {after}")
    return f"drawn, {before['azimuth']:.0f}° turned to {after:.0f}°"


LINES = {
    "landing page, explorer turned": ("index.html", turned),
    "lesson 00, all cells": ("lessons/00-start-here.html", lambda f: f.run(EVERY_CELL)),
    "lesson 05, all cells": ("lessons/05-link-matrix.html", lambda f: f.run(EVERY_CELL)),
    "lesson 05, an answer checked": (
        "lessons/05-link-matrix.html",
        lambda f: f.run(CHECK, ANSWER=right("05.1")),
    ),
    "bench, the doctor's answer": (
        "bench/index.html",
        lambda f: f.run(BENCH, TABLE=table(), POSES=POSES),
    ),
    "an arm's motion as a GIF": ("robots/ur5e.html", lambda f: f.run(GIF)),
}


def main():
    """The command line."""
    parser = arguments(__doc__)
    parser.add_argument("--shots", type=Path, help="a folder for pictures of what is seen")
    given = parser.parse_args()
    faults = 0
    print("| in Firefox | s | MB | script errors, outside requests | |\n|---|---|---|---|---|")
    with served(given.html) as address:
        for number, (words, (name, done)) in enumerate(LINES.items()):
            with (
                tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile,
                contextlib.closing(Firefox(Path(profile), address)) as firefox,
            ):
                before = Quiet.sent
                firefox.go(name)
                began = time.perf_counter()
                found = done(firefox)
                took, size = time.perf_counter() - began, (Quiet.sent - before) / 1e6
                if given.shots:
                    firefox.picture(given.shots / f"firefox-{number}.png")
            print(f"| {words} | {took:.1f} | {size:.1f} | {len(firefox.wrong)} | {found} |")
            print(*[f"    {fault}\n" for fault in firefox.wrong], sep="", end="", flush=True)
            faults += len(firefox.wrong)
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
