"""Ten posts of posts.yaml at the bench, as a phone's user: a touch screen 390 pixels wide, fields
filled in, buttons tapped, what is asked back answered once.

    make site LIVE=1
    python benchmarks/bench_posts.py            # a line each
    python benchmarks/bench_posts.py NAME …     # those, with all that came back

What is typed and what must come back is in bench_posts.yaml. It was written before the first was
played; of four posts (Panda, UR5 of the driver's issue 299, AR3, KDL) it was changed after that.
"""

import re
import time
from pathlib import Path

from ruamel.yaml import YAML
from serving import arguments, chromium, served

PLAYS = Path(__file__).with_name("bench_posts.yaml")
ASKED = {
    "order": "Order of the columns",
    "convention": "Convention",
    "angle": "Angles",
    "length": "Lengths",
    "take": "Or take a reading",
}
LABELS = {"poses": "Measured poses", "other": "The other arm", "q": "Joint values ("}


def played(page, play):
    """What the bench says, and how often it asked back."""
    page.locator("textarea").first.fill(play["arm"])
    page.locator(".bench-do", has=page.locator(f'input[value="{play["do"]}"]')).tap()
    for name, label in LABELS.items():
        if name in play:
            page.get_by_label(label).fill(play[name])
    for name, label in {"units": "Their units", "to": "Into"}.items():
        if name in play:
            page.get_by_label(label).select_option(play[name])
    page.get_by_role("button", name="Answer", exact=True).tap()
    asked = 0
    for name in answered(page):
        if name in play.get("said", {}):
            question(page, name).select_option(play["said"][name])
            asked += 1
            answered(page)
    texts = page.locator(".bench-results, .bench-questions").all_inner_texts()
    return " ".join(" ".join(texts).split()), asked


def question(page, name):
    return page.locator(f'.bench-questions label:has(> span:text-is("{ASKED[name]}")) select')


def answered(page):
    """Wait for an answer; what the page asks back."""
    page.locator(".bench-results:not([aria-busy])").wait_for(state="attached")
    return [name for name in ASKED if question(page, name).count()]


def main():
    """The command line."""
    parser = arguments(__doc__)
    parser.add_argument("names", nargs="*")
    given = parser.parse_args()
    plays = YAML(typ="safe").load(PLAYS)
    print("| post | came back | asked | wider than the screen | s |\n|---|---|---|---|---|")
    with served(given.html) as address, chromium() as browser:
        phone = browser.new_context(
            viewport={"width": 390, "height": 844}, has_touch=True, is_mobile=True
        )
        page = phone.new_page()
        page.set_default_timeout(240_000)
        page.goto(f"{address}/bench/index.html", wait_until="networkidle")
        for name in given.names or plays:
            play, began = plays[name], time.perf_counter()
            text, asked = played(page, play)
            missing = [fact for fact in play["says"] if not re.search(fact, text)]
            wide = page.evaluate("document.documentElement.scrollWidth > innerWidth")
            print(
                f"| {name} | {'all' if not missing else 'not: ' + ', '.join(missing)} | {asked}"
                f" | {'yes' if wide else 'no'} | {time.perf_counter() - began:.0f} |",
                flush=True,
            )
            if given.names:
                print(text)


if __name__ == "__main__":
    main()
