"""Hands on the arm in the explorer: its end, a joint and a link follow the pointer, within the
limits; and every label stands by what it names.
"""

import numpy as np
import pytest
from draws import ALL, few

import dhlab as dh
from dhlab.view.explorer.content import arm_data

Q = np.deg2rad([30, -60, 80, -110, -80, 20])
EXPLORER = "document.querySelector('.dhlab-explorer').explorer"
REACH = """([arm, size, targets, q]) => targets.map((T) => {
    const next = dhlab.reach(arm, q, T, size);
    q = next.q;
    return [next.reached, q]; })"""


def test_the_end_reaches_random_places_within_the_limits(opened):
    rng, page, missed = np.random.default_rng(3), opened(dh.explore(dh.load("ur5e")), webgl=ALL), 0
    for name in few(dh.robots(), 4):
        arm = dh.load(name)
        free = np.where(arm.table.prismatic, 0.3, np.pi)
        pairs = [
            pair or (-f, f) for pair, f in zip(arm.limits or [None] * len(arm), free, strict=True)
        ]
        low, high = np.array(pairs).T
        targets = arm.forward(rng.uniform(low, high, (40, len(arm))))
        size = float(np.ptp(arm.frames(np.zeros(len(arm)))[:, :3, 3], axis=0).max())
        start = ((low + high) / 2).tolist()
        asked = [arm_data(arm), size, targets.reshape(-1, 16).tolist(), start]
        found = page.evaluate(REACH, asked)
        for T, (reached, q) in zip(targets, found, strict=True):
            gap = np.linalg.norm(arm.forward(q)[:3, 3] - T[:3, 3])
            for angle, pair in zip(q, arm.limits or [], strict=False):
                assert pair is None or pair[0] - 1e-12 <= angle <= pair[1] + 1e-12
            assert not reached or gap < 2e-4 * size
            missed += not reached
    assert missed <= 1


@pytest.fixture
def page(opened):
    page = opened(dh.explore(dh.load("ur5e"), q=Q))
    page.wait_for_function(f"{EXPLORER}.stage.drawn > 0")
    return page


def place(page, point):
    """Where a point of the arm is on the page."""
    x, y = page.evaluate(f"p => {EXPLORER}.stage.camera.flat(p)", list(map(float, point)))
    box = page.locator("canvas").bounding_box()
    return box["x"] + x, box["y"] + y


def drag(page, start, by):
    page.mouse.move(*start)
    page.mouse.down()
    page.mouse.move(start[0] + by[0], start[1] + by[1], steps=8)
    page.mouse.up()
    return np.array(page.evaluate(f"{EXPLORER}.host.get('q')"))


def test_the_end_follows_the_mouse_and_keeps_its_turn(page):
    arm = dh.load("ur5e")
    before = place(page, arm.forward(Q)[:3, 3])
    home = page.evaluate(f"{EXPLORER}.stage.camera.azimuth")
    toward = page.evaluate(f"{EXPLORER}.stage.camera.toward")
    q = drag(page, before, (40, -60))
    moved = arm.forward(q)[:3, 3] - arm.forward(Q)[:3, 3]
    assert np.linalg.norm(moved) > 0.05 and abs(moved @ toward) < 1e-3
    np.testing.assert_allclose(arm.forward(q)[:3, :3], arm.forward(Q)[:3, :3], atol=2e-3)
    assert page.evaluate(f"{EXPLORER}.stage.camera.azimuth") == home


def test_a_link_moves_one_joint_alone(page):
    frames = dh.load("ur5e").frames(Q)
    q = drag(page, place(page, (frames[1][:3, 3] + frames[2][:3, 3]) / 2), (30, 20))
    assert np.flatnonzero(np.abs(q - Q) > 1e-6).tolist() == [1]


def test_few_letters_at_first_and_all_on_demand_each_by_its_own_arrow(page):
    labels = (
        f"() => {{ {EXPLORER}.stage.draw(0); return {EXPLORER}.stage.paper.labels.map((one) =>"
        " [one.label.text, one.led]); }"
    )
    first = [text for text, _ in page.evaluate(labels)]
    assert {"x₆", "z₆", "{0}", "{6}"} <= set(first) and "z₀" not in first
    page.get_by_role("button", name="All letters").click()
    every = [text for text, _ in page.evaluate(labels)]
    assert any("z₀" in text for text in every) and len(every) > len(first) + 6
    astray = page.evaluate(
        f"""() => {{ const {{ labels }} = {EXPLORER}.stage.paper;
            const kept = (v, low, high) => Math.max(low, Math.min(high, v));
            const gap = ([x, y], b) =>
                Math.hypot(x - kept(x, b.left, b.right), y - kept(y, b.top, b.bottom));
            const apart = (a, b) => Math.hypot(a.at[0] - b.at[0], a.at[1] - b.at[1]) > 12;
            const strays = (one) => labels.some((other) =>
                apart(other, one) && gap(other.at, one) < gap(one.at, one));
            return labels.filter((one) => !one.led && strays(one)).map((one) => one.label.text);
        }}"""
    )
    assert astray == [], "a label nearer to another's arrow has a line to its own"
