"""What axe finds on a page."""

from draws import ALL

__all__ = ["axe"]

RUN = """options => axe.run(options).then(r => [r.passes.length,
    r.violations.map(v => `${v.id}: ${v.nodes.map(n => n.html.slice(0, 120)).join(" | ")}`)])"""


def axe(page, packages):
    """What is wrong in the light, and in the dark, each with how many rules held; of what axe looks
    at, only the colours are others in the dark.
    """
    program = packages / "node_modules" / "axe-core" / "axe.min.js"
    page.evaluate(program.read_text(encoding="utf-8"))
    light = page.evaluate(RUN, {})
    page.emulate_media(color_scheme="dark", reduced_motion="reduce")  # nothing fades to the dark
    page.evaluate("() => new Promise(requestAnimationFrame)")  # the page hears of it in a frame
    return light, page.evaluate(RUN, {} if ALL else {"runOnly": ["color-contrast"]})
