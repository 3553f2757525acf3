"""Cards in Chromium: chosen and laid by mouse and by keys, and nothing for axe to find."""

import base64
import json
from pathlib import Path

import pytest
from axe import axe

from dhlab.view import cards as room
from dhlab.view.cards import Cards, inline

MODULE = Path(room.__file__).with_name("cards.js")
PAGE = """<!doctype html><html lang="en"><meta charset="utf-8"><title>Cards</title><main><h1>Cards</h1></main><script type="module">
const [{{ default: widget }}, state] = [await import("data:text/javascript;base64," + {code!r}), {state}];
const heard = {{}};
window.model = {{ get: (name) => state[name], set(name, value) {{ state[name] = value; (heard["change:" + name] ?? []).forEach((call) => call()); }}, save_changes() {{}},
    on: (name, call) => (heard[name] ??= []).push(call), off() {{}} }};
widget.render({{ model, el: document.querySelector("main") }});
window.ready = true;</script>"""


@pytest.fixture
def shown(new_page):
    """``shown(cards)``: a page with them."""
    pages = []

    def get(cards, **settings):
        page = new_page(viewport={"width": 900, "height": 700}, **settings)
        page.set_default_timeout(20_000)
        state = json.dumps(cards.get_state(["_data", "chosen", "told"]))
        encoded = base64.b64encode(MODULE.read_bytes()).decode()
        page.set_content(PAGE.format(code=encoded, state=state))
        page.wait_for_function("window.ready")
        pages.append(page)
        return page

    yield get
    for page in pages:
        page.close()


CHOICE = Cards("01.6 Which?", {"a": "`x`", "b": "along $z_i$", "?": "I don't know yet"})
ORDER = Cards("05.3 In which order?", {"a": "one", "b": "two", "c": "three"}, ["first", "second"])
CHOSEN = "model.get('chosen')"


def test_one_is_chosen_by_mouse_and_keys(shown):
    page = shown(CHOICE)
    page.get_by_text("along").click(force=True)
    assert page.evaluate(CHOSEN) == ["b"]
    page.keyboard.press("ArrowDown")
    assert page.evaluate(CHOSEN) == ["?"]


def test_cards_are_laid_by_keys_mouse_and_dragging_and_taken_back(shown):
    page = shown(ORDER)
    page.get_by_role("button", name="three").last.focus()
    page.keyboard.press("Enter")
    assert page.evaluate(CHOSEN) == ["c", ""]
    page.get_by_role("button", name="one").last.click()
    assert page.evaluate(CHOSEN) == ["c", "a"]
    page.get_by_role("button", name="2. second").click()
    assert page.evaluate(CHOSEN) == ["c", ""]
    page.get_by_role("button", name="two").last.drag_to(page.get_by_role("button", name="1. first"))
    assert page.evaluate(CHOSEN) == ["b", ""]
    page.get_by_role("button", name="two").last.click()
    assert page.evaluate(CHOSEN) == ["", "b"], "no card has two places"


@pytest.mark.parametrize("cards", [CHOICE, ORDER], ids=["choice", "order"])
def test_axe_finds_nothing(shown, packages, cards):
    page = shown(cards)
    dark = "body { background: #111; color: #eee }"
    page.add_style_tag(content=f"@media (prefers-color-scheme: dark) {{ {dark} }}")
    assert [found for _, found in axe(page, packages)] == [[], []], "in the light, in the dark"


def test_texts_cannot_smuggle_a_program():
    assert inline("<img onerror=x> `a<b`") == "&lt;img onerror=x&gt; <code>a&lt;b</code>"
