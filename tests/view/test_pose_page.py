"""Mode "pose" in Chromium: what hands do to the plates, Python reads; a column and its arrow light
up together.
"""

import numpy as np
import pytest
from draws import ALL, few

import dhlab as dh
from dhlab import transform
from dhlab.view.explorer.content import arm_data

T_01 = transform.from_xyz_rpy([0.4, 0.1, 0.2], [0.2, -0.3, 0.9])
T_12 = transform.from_xyz_rpy([0.3, 0.1, 0], [0, 0.4, -0.5])
# where a point of the world stands on the page
SEEN = """p => { const { stage } = document.querySelector('.dhlab-explorer, main > div').explorer, box = stage.canvas.getBoundingClientRect();
    stage.draw(0);
    const [x, y] = stage.camera.flat(p);
    return [box.left + x, box.top + y, stage.camera.scale]; }"""


@pytest.fixture(scope="session")
def chromium(whole_chromium):
    """Here what is pointed at goes dark when the pointer leaves it."""
    return whole_chromium


def shown(page):
    """Every matrix on the page, by its caption."""
    found = page.evaluate(
        """[...document.querySelector('main > div, .dhlab-explorer').shadowRoot.querySelectorAll('.matrix table')].map((t) =>
        [t.caption.textContent, [...t.tBodies[0].rows].map((r) => [...r.cells].map((c) => Number(c.textContent.replace('−', '-'))))])"""
    )
    return {caption: np.array(matrix) for caption, matrix in found}


def drag(page, start, to):
    """Take hold, and do not let go: then the picture is fitted anew."""
    page.mouse.move(*start)
    page.mouse.down()
    for part in (0.3, 0.6, 1):
        page.mouse.move(*(np.array(start) + part * (np.array(to) - start)))


def arrow_of(page, T, column):
    """The tip of an arrow, or the origin, on the page; and how many pixels a metre has."""
    reach = page.evaluate("document.querySelector('main > div').explorer.mode.size")
    tip = T[:3, 3] + 0.3 * reach * T[:3, column] if column < 3 else T[:3, 3]
    x, y, scale = page.evaluate(SEEN, tip.tolist())
    return np.array([x, y]), scale


def test_hands_move_a_plate_along_the_picture_and_python_reads_where(live):
    explorer = dh.explore(T_01, mode="pose")
    page = live(explorer)
    start, _ = arrow_of(page, T_01, 3)
    drag(page, start, start + [60, -40])
    moved = explorer.poses[0]
    there, scale = arrow_of(page, moved, 3)
    away = np.linalg.norm(there - start - [60, -40])
    assert away < 0.01 * scale + 1, "hands snap to centimetres"
    np.testing.assert_allclose(100 * moved[:3, 3], np.round(100 * moved[:3, 3]), atol=1e-9)
    np.testing.assert_allclose(moved[:3, :3], T_01[:3, :3], atol=1e-12)
    np.testing.assert_allclose(shown(page)["T₀₁"], moved, atol=5.1e-4)


def test_an_arrow_follows_the_hand_and_stays_square_to_the_others(live):
    explorer = dh.explore(T_01, mode="pose")
    page = live(explorer)
    for column in range(3):
        before = explorer.poses[0]
        start, _ = arrow_of(page, before, column)
        middle, _ = arrow_of(page, before, 3)
        to = middle + 0.8 * (start - middle) + [4, 3]
        drag(page, start, to)
        T = explorer.poses[0]
        assert np.abs(T - before).max() > 1e-3, column
        np.testing.assert_allclose(T[:3, 3], T_01[:3, 3], atol=1e-12)
        np.testing.assert_allclose(T[:3, :3].T @ T[:3, :3], np.eye(3), atol=1e-9)
        assert np.linalg.det(T[:3, :3]) > 0
        tip, _ = arrow_of(page, T, column)
        snapped = np.abs(T[:3, column]).max() > 1 - 1e-9
        assert snapped or np.linalg.norm(tip - to) < 2, f"tip {column} is where the hand is"
        page.mouse.up()


def test_the_second_plate_is_moved_in_the_first_ones_arrows(live):
    explorer = dh.explore([T_01, T_12], mode="pose")
    page = live(explorer)
    the_matrices_are_the_poses_and_their_products(page)
    page.get_by_role("spinbutton", name="x of the origin, metres, exactly").fill("0.5")
    page.keyboard.press("Enter")
    page.get_by_role("slider", name="yaw, the turn about z, degrees").press("ArrowRight")
    np.testing.assert_allclose(explorer.poses[0], T_01, atol=1e-12)
    wanted = transform.from_xyz_rpy([0.5, 0.1, 0], [0, 0.4, np.deg2rad(-28)])
    np.testing.assert_allclose(explorer.poses[1], wanted, atol=1e-9)
    explorer.poses = [T_12, T_01]
    page.evaluate(
        "rows => document.querySelector('main > div').explorer.host.set('poses', rows)",
        explorer.poses.tolist(),
    )
    np.testing.assert_allclose(shown(page)["T₀₂ = T₀₁ · T₁₂"], T_12 @ T_01, atol=5.1e-4)


def the_matrices_are_the_poses_and_their_products(page):
    wanted = [T_01, T_12, T_01 @ T_12, T_12 @ T_01]
    for matrix, T in zip(shown(page).values(), wanted, strict=True):
        np.testing.assert_allclose(matrix, T, atol=5.1e-4)


def test_a_quarter_turn_is_about_the_plates_own_arrow(live):
    explorer = dh.explore(T_01, mode="pose")
    live(explorer).get_by_role(
        "button", name="y +90°: a quarter turn about the plate's own y"
    ).click()
    wanted = T_01 @ transform.from_xyz_rpy([0, 0, 0], [0, np.pi / 2, 0])
    np.testing.assert_allclose(explorer.poses[0], wanted, atol=1e-9)


LIT = """() => [...document.querySelector('main > div').shadowRoot.querySelectorAll('.matrix td.lit')].map((c) => Number(c.textContent.replace('−', '-')))"""
LABELS = "() => { const { stage } = document.querySelector('main > div').explorer; stage.draw(0); return stage.paper.labels.map((b) => b.label.text); }"


def test_a_column_and_its_arrow_light_up_together(live):
    page = live(dh.explore(T_01, mode="pose"))
    heading = page.get_by_role("button", name="y₁: arrow of plate 1, written in frame 0")
    for light in (heading.hover, lambda: page.keyboard.press("Tab") or heading.focus()):
        page.mouse.move(5, 5)
        assert page.evaluate(LIT) == []
        light()
        np.testing.assert_allclose(page.evaluate(LIT), T_01[:, 1], atol=5.1e-4)
        told = {text.replace("−", "-") for text in page.evaluate(LABELS)}
        assert {f"{v:.3f}".rstrip("0") for v in T_01[:3, 1]} <= told
    page.evaluate("document.querySelector('main > div').shadowRoot.activeElement.blur()")
    tip, _ = arrow_of(page, T_01, 0)
    page.mouse.move(*tip)
    np.testing.assert_allclose(page.evaluate(LIT), T_01[:, 0], atol=5.1e-4)
    page.mouse.move(5, 5)
    assert page.evaluate(LIT) == []
    heading.click()
    page.mouse.move(5, 5)
    assert heading.get_attribute("aria-pressed") == "true" and len(page.evaluate(LIT)) == 4


def test_a_finger_on_a_plate_moves_it_and_elsewhere_scrolls(live):
    explorer = dh.explore(T_01, mode="pose")
    page = live(explorer, has_touch=True)
    (x, y), _ = arrow_of(page, T_01, 3)
    kept = """([x, y]) => { const canvas = document.querySelector('main > div').explorer.stage.canvas;
        const touch = new Touch({ identifier: 1, target: canvas, clientX: x, clientY: y });
        return !canvas.dispatchEvent(new TouchEvent('touchstart', { touches: [touch], cancelable: true, bubbles: true })); }"""
    assert page.evaluate(kept, [x, y]) is True
    assert page.evaluate(kept, [x + 150, y + 150]) is False


@pytest.mark.parametrize("name", few(["stanford", "ur5e", "cobra600"], 2))
def test_columns_of_the_jacobian_are_pythons_and_light_up(opened, name):
    arm = dh.load(name)
    q = np.linspace(-0.7, 0.4, len(arm))
    page = opened(dh.explore(arm, q=q, jacobian=True), webgl=ALL)
    for one in (arm, arm.to("craig")):
        found = page.evaluate(
            "([a, q]) => dhlab.jacobian(a, dhlab.frames(a, q), dhlab.forward(a, q))",
            [arm_data(one), q.tolist()],
        )
        np.testing.assert_allclose(np.transpose(found), arm.jacobian(q), atol=1e-9)
    page.get_by_role("button", name="q₁: what joint 1 alone does to the end").click()
    lit = page.locator(".matrix td.lit").all_text_contents()
    np.testing.assert_allclose(
        [float(text.replace("−", "-")) for text in lit], arm.jacobian(q)[:, 0], atol=5.1e-4
    )


def test_a_row_and_its_link_light_up_together(opened):
    arm = dh.load("article-6r")
    page = opened(dh.explore(arm, q=np.deg2rad([30, 60, -80, -30, 40, 0])))
    now = page.locator("tr.now")
    page.get_by_role("button", name="2: row 2, lit with its link").click()
    page.mouse.move(5, 5)
    assert now.locator("th").inner_text() == "2"
    middle = arm.frames(np.deg2rad([30, 60, -80, -30, 40, 0]))[2:4, :3, 3].mean(axis=0)
    page.mouse.move(
        *page.evaluate(
            SEEN.replace(".dhlab-explorer, main > div", ".dhlab-explorer"), middle.tolist()
        )[:2]
    )
    assert now.locator("th").inner_text() == "3", "the link that the mouse is at"
