"""Pages with explorers, opened in one Chromium."""

from functools import lru_cache

import pytest

from dhlab.view.explorer.widget import MODULE

PAGE = """<!doctype html><html lang="en"><meta charset="utf-8"><title>Explorers</title><main><h1>Explorers</h1>{}</main><script type="module">{}
window.dhlab = {{ forward, frames, jacobian, reach, widget }};</script>"""

MODEL = """(state) => {
    const heard = {};
    const take = (all) => Object.entries(all).forEach(([name, value]) => {
        const changed = JSON.stringify(state[name]) !== JSON.stringify(value);
        state[name] = value;
        if (changed) (heard[`change:${name}`] ?? []).forEach((call) => call());
    });
    const model = {
        get: (name) => state[name], set(name, value) { take({ [name]: value }); window.toPython('set', name, value).then(take); }, save_changes() {},
        send: (message) => window.toPython('message', '', message).then(take),
        on: (name, call) => (heard[name] ??= []).push(call), off: (name, call) => { heard[name] = heard[name].filter((one) => one !== call); },
    };
    window.close = dhlab.widget.render({ model, el: document.querySelector('main') });
}"""


BLIND = """const canvas = HTMLCanvasElement.prototype, get = canvas.getContext;
    canvas.getContext = function (kind, ...more) { return kind === 'webgl2' ? null : get.call(this, kind, ...more); };"""
OFFLINE = {"offline": True, "viewport": {"width": 1280, "height": 900}}


@pytest.fixture
def opened(new_page):
    """``opened(explorer, …)`` is a page without a kernel and without a network that shows them;
    whatever goes wrong on it fails the test. With ``webgl=False`` it has none, so that no picture is
    drawn, which is most of what a page of numbers costs.
    """
    pages, faults = [], []

    def get(*explorers, webgl=True, stills=False, **settings):
        page = new_page(**OFFLINE, **settings)
        page.add_init_script("" if webgl else BLIND)
        page.goto("about:blank")  # where the script is run for the first time
        page.on("pageerror", lambda error: faults.append(str(error)))
        page.on(
            "console",
            lambda message: faults.append(message.text) if message.type == "error" else None,
        )
        page.on(
            "request",
            lambda request: (
                None
                if request.url.startswith(("data:", "about:"))
                else faults.append(f"asked for {request.url}")
            ),
        )
        module = MODULE.read_text(encoding="utf-8")
        names = dict(
            pair.split(" as ")[::-1]
            for pair in module[module.rindex("export{") + 7 : module.rindex("}")].split(",")
        )
        module += (
            f"\nconst forward = {names['forward']}, frames = {names['frames']}, jacobian ="
            f" {names['jacobian']}, reach = {names['reach']}, widget = {names['default']};"
        )
        page.set_content(
            PAGE.format("".join(as_html(explorer, stills) for explorer in explorers), module)
        )
        page.wait_for_function(
            "window.dhlab && [...document.querySelectorAll('.dhlab-explorer')].every((e) =>"
            " e.explorer)"
        )
        pages.append(page)
        return page

    yield get
    for page in pages:
        page.close()
    assert faults == []


@pytest.fixture
def live(opened):
    """``live(explorer)`` is a page that shows it as a notebook does: what hands do goes to Python,
    and what Python says comes back.
    """

    def get(explorer, **settings):
        page = opened(**settings)
        page.expose_function(
            "toPython", lambda kind, name, value: heard(explorer, kind, name, value)
        )
        page.evaluate(
            MODEL,
            explorer.get_state(["_data", "q", "row", "poses", "convention", "step", "_answer"]),
        )
        return page

    return get


def heard(explorer, kind, name, value):
    """A message or a changed number from the view; returns the state as Python has it now."""
    if kind == "message":
        explorer._heard(value)
    else:
        explorer.set_state({name: value})
    return explorer.get_state(["q", "row", "poses", "convention", "step", "_answer"])


@lru_cache(None)
def as_html(explorer, stills):
    """What a notebook stores of an explorer; drawing the still picture takes a while, so that only
    those get it who look at it.
    """
    bundle = explorer._repr_mimebundle_(
        **({} if stills else {"still": {"text/html": "", "text/plain": ""}})
    )
    return (bundle[0] if isinstance(bundle, tuple) else bundle)["text/html"]
