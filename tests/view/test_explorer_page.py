"""The explorer in Chromium, on a page without kernel and network: poses, hands on it, labels,
tables, light and dark, what is heard and what is not seen.
"""

import json
import re

import numpy as np
import pytest
from axe import axe
from draws import ALL, few, shared_out

import dhlab as dh
from dhlab import transform
from dhlab.view.explorer.content import arm_data

Q = np.deg2rad([30, -60, 80, -110, -80, 20])
VIEWS = ["Home", "Front", "Side", "Top"]
# for a page on which only numbers and controls are looked at
NUMBERS = {"webgl": ALL}


def wrong(arm):
    """The same arm with a sign lost in one row."""
    rows = arm.table.rows
    rows[3, 3] *= -1
    return dh.Arm(dh.DHTable(arm.table.convention, *rows.T, arm.table.joints), name="mine")


def every_mode():
    arm = dh.load("ur5e")
    qs = np.random.default_rng(1).uniform(-1.5, 1.5, (5, 6))
    return {
        "arm": dh.explore(arm, q=Q),
        "link": dh.explore(arm, mode="link", joint=4, q=Q),
        "conventions": dh.explore(arm, mode="conventions", q=Q),
        "compare": dh.explore(wrong(arm), mode="compare", q=qs, poses=arm.forward(qs)),
        "two": dh.explore(arm, mode="compare", other=wrong(arm), q=Q),
        "branches": dh.explore(arm, mode="branches", q=qs),
        "pose": dh.explore(mode="pose"),
        "plates": dh.explore([transform.trans([0.4, 0, 0]), transform.rot_z(1.0)], mode="pose"),
        "place": dh.explore(dh.load("stanford"), mode="place"),
    }


@pytest.fixture(scope="module")
def modes():
    return every_mode()


def explorer(page, k=0):
    return page.locator(".dhlab-explorer").nth(k)


def text_table(page, caption):
    """The cells of a table as they are read aloud."""
    rows = page.locator(".explorer table", has=page.locator("caption", has_text=caption)).locator(
        "tbody tr"
    )
    return rows.evaluate_all(
        "rows => rows.map(row => [...row.querySelectorAll('th, td')].map(cell => cell.textContent))"
    )


def unfold(page):
    """Open the tables of the frames; pictures under them have tables of their own, unseen."""
    for summary in page.locator(".explorer summary").all():
        summary.click()


def numbers(text):
    return [float(found) for found in re.findall(r"-?\d+\.?\d*", text.replace("−", "-"))]


def test_pose_equals_pythons_for_every_arm_and_both_conventions(opened):
    rng, page = np.random.default_rng(7), opened(dh.explore(dh.load("article-6r")), **NUMBERS)
    largest = 0.0
    for name in few(dh.robots(), 10):
        for arm in (dh.load(name).to("standard"), dh.load(name).to("craig")):
            q = rng.uniform(-3, 3, (50, len(arm)))
            found = page.evaluate(  # as text: numbers one by one take longer than the arm
                "([arm, qs]) => JSON.stringify("
                "qs.map((q) => [dhlab.forward(arm, q), ...dhlab.frames(arm, q)]))",
                [arm_data(arm), q.tolist()],
            )
            wanted = np.concatenate([arm.forward(q)[:, None], arm.frames(q)], axis=1)
            largest = max(
                largest, np.abs(np.reshape(json.loads(found), wanted.shape) - wanted).max()
            )
    print(f"largest difference {largest:.1e}")
    assert largest < 1e-9


def test_sign_offset_slide_base_and_tool_count(opened):
    table = dh.DHTable.standard(
        [[30, 0.1, 0.2, 90], [-20, 0.3, 0, -90], [0, 0, 0.4, 10]], angle="deg", joints="RPR"
    )
    T = dh.load("ur5e").forward(Q)
    arm = dh.Arm(table, base=T, tool=np.linalg.inv(T), sign=[-1, -1, 1])
    page, q = opened(dh.explore(arm), **NUMBERS), [0.4, -0.15, 1.1]
    for one in (arm, arm.to("craig")):
        np.testing.assert_allclose(
            np.reshape(
                page.evaluate("([arm, q]) => dhlab.forward(arm, q)", [arm_data(one), q]), (4, 4)
            ),
            arm.forward(q),
            atol=1e-12,
        )


NOTEBOOK = """() => { // Enter alone makes no change event there, and letters are commands
    window.commands = [];
    document.addEventListener("keypress", (event) => event.key === "Enter" && event.preventDefault(), true);
    document.addEventListener("keydown", (event) => window.commands.push(event.key)); }"""


@pytest.mark.parametrize("mode", ["arm", "link", "conventions", "two"])
def test_enter_is_enough_in_every_number_box_and_a_notebook_hears_no_key(opened, modes, mode):
    page, typed = opened(modes[mode], **NUMBERS), 0
    page.evaluate(NOTEBOOK)
    boxes, sliders = page.get_by_role("spinbutton"), page.locator(".slider input[type=range]")
    assert boxes.count() == (4 if mode == "link" else 6)
    for k in range(boxes.count()):
        length = "metres" in boxes.nth(k).get_attribute("aria-label")
        for value in shared_out(["-0.2", "0.137"] if length else ["-20", "70"], k, 2):
            typed += 1
            boxes.nth(k).click()
            page.keyboard.press("Control+a")
            page.keyboard.type(value)
            page.keyboard.press("Enter")
            assert sliders.nth(k).input_value() == value and boxes.nth(k).input_value() == value
    for key in [
        "a",
        "b",
        "d",
        "d",
        "m",
        "0",
        "0",
        "7",
        "Backspace",
        "ArrowUp",
        "ArrowDown",
        "Escape",
    ]:
        page.keyboard.press(key)
    sliders.nth(0).focus()
    page.keyboard.press("ArrowRight")
    assert (
        set(page.evaluate("window.commands")) <= {"Control", "a"}
        and page.evaluate("window.commands.length") == 2 * typed
    ), "Control and a alone"


def test_enter_in_the_box_of_mode_place_moves_the_point(live):
    explorer = dh.explore(dh.load("cobra600"), mode="place")
    for i, frame in enumerate(explorer.placing.placement.model.frames(np.zeros(4))):
        assert explorer.place(f"z{i}", frame[:3, 2], frame[:3, 3])
    page = live(explorer)
    page.evaluate(NOTEBOOK)
    page.get_by_role("spinbutton").fill("0.035")
    page.keyboard.press("Enter")
    assert (
        page.get_by_role("slider", name="Along the line of z").input_value() == "0.035"
        and page.get_by_role("button", name="Place it").is_enabled()
    )


def test_a_chosen_origin_is_dragged_along_its_line_and_snaps_to_what_is_offered(live):
    explorer = dh.explore(dh.load("cobra600"), mode="place")
    for i, frame in enumerate(explorer.placing.placement.model.frames(np.zeros(4))):
        assert explorer.place(f"z{i}", frame[:3, 2], frame[:3, 3])
    page, answer = live(explorer), explorer._answer
    z, p = explorer.placing.placement.z[0], explorer.placing.placement.axes[0].p
    values = [np.array(offer["value"]) for offer in answer["offers"]]
    on = [value for value in values if np.linalg.norm(np.cross(value - p, z)) < 1e-9]
    start, goal = on[0], max(on, key=lambda value: np.linalg.norm(value - on[0]))

    def at(point):
        return page.evaluate(
            "p => { const { stage } = document.querySelector('main > div').explorer;"
            " const { x, y } = stage.canvas.getBoundingClientRect();"
            " const [u, v] = stage.camera.flat(p); return [x + u, y + v]; }",
            list(point),
        )

    def drag(a, b):
        page.mouse.move(*a)
        page.mouse.down()
        page.mouse.move(*b, steps=5)
        page.mouse.up()

    page.wait_for_function("document.querySelector('main > div').explorer.stage.drawn > 0")
    page.mouse.click(*at(start))
    slider = page.get_by_role("slider", name="Along the line of z")
    middle = (start + goal) / 2
    drag(at(start), at(middle))
    assert float(slider.input_value()) == pytest.approx((middle - p) @ z, abs=0.01)
    drag(at(middle), np.array(at(goal)) + 3)
    sent = "document.querySelector('main > div').explorer.host"
    page.evaluate(f"{sent}.send = (message) => {{ window.sent = message; }}")
    page.mouse.click(*at(goal))
    np.testing.assert_allclose(page.evaluate("window.sent.value"), goal, atol=1e-9)


def test_a_number_with_more_digits_than_shown_stays_as_typed(opened, modes):
    page = opened(modes["arm"], **NUMBERS)
    box = page.get_by_role("spinbutton").first
    box.fill("33.33333")
    for key in ("Enter", "Tab"):
        page.keyboard.press(key)
        assert page.evaluate(
            "document.querySelector('.dhlab-explorer').explorer.host.get('q')[0]"
        ) == pytest.approx(np.deg2rad(33.33333), abs=1e-12)


def test_sliders_by_mouse_and_keyboard_move_arm_and_tables(opened):
    arm = dh.load("ur5e")
    page = opened(dh.explore(arm))
    first, second = (page.get_by_role("slider", name=f"Joint {k}, degrees") for k in (1, 2))
    box = first.bounding_box()
    page.mouse.click(box["x"] + 0.8 * box["width"], box["y"] + box["height"] / 2)
    second.focus()
    for _ in range(6):
        page.keyboard.press("ArrowLeft")
    page.get_by_role("spinbutton", name="Joint 3, degrees, exactly").fill("33.25")
    page.keyboard.press("Enter")
    q = page.evaluate("document.querySelector('.dhlab-explorer').explorer.host.get('q')")
    assert (
        q[0] > 1
        and q[1] == pytest.approx(np.deg2rad(-3))
        and q[2] == pytest.approx(np.deg2rad(33.25))
    )
    end = arm.forward(q)
    np.testing.assert_allclose(
        numbers(page.locator("dd").first.inner_text()), end[:3, 3], atol=5.1e-5
    )
    shown = text_table(page, "Table now")
    np.testing.assert_allclose(
        [numbers(row[1])[0] for row in shown], np.rad2deg(arm.table.theta + q), atol=0.0051
    )
    expect_status(page, f"x = {end[0, 3]:.4f}".rstrip("0").replace("-", "−"))


def until(page, what, true):
    """Wait until ``true()``, which the page brings about through Python."""
    for _ in range(3000):
        if true():
            return
        page.wait_for_timeout(10)
    pytest.fail(f"waited 30 s for {what}; the page says {page.locator('main').inner_text()}")


def expect_status(page, text):
    from playwright.sync_api import expect

    expect(page.get_by_role("status").first).to_contain_text(text)


@pytest.mark.parametrize("name", few(["ur5e", "stanford", "panda"], 2))
def test_text_table_is_the_frames(opened, name):
    arm = dh.load(name)
    q = np.linspace(-0.5, 0.8, len(arm))
    page = opened(dh.explore(arm), **NUMBERS)
    page.evaluate(
        "q => document.querySelector('.dhlab-explorer').explorer.host.set('q', q)", q.tolist()
    )
    unfold(page)
    rows, frames = text_table(page, "The frames"), arm.frames(q)
    assert len(rows) == len(frames) + (not np.array_equal(arm.tool, np.eye(4)))
    for row, T in zip(rows, [*frames, arm.forward(q)]):
        np.testing.assert_allclose([numbers(cell)[0] for cell in row[1:4]], T[:3, 3], atol=5.1e-5)
        np.testing.assert_allclose([numbers(cell) for cell in row[4:]], T[:3, :3].T, atol=0.00051)


def test_labels_are_apart_and_nearly_all_there_at_the_usual_views(opened):
    arms = [dh.load(name) for name in few(dh.robots(), 10)]
    page, missing = (
        opened(*(dh.explore(arm, q=np.linspace(0.5, -0.7, len(arm))) for arm in arms)),
        {},
    )
    for view in VIEWS:
        found = page.evaluate(
            """view => [...document.querySelectorAll('.dhlab-explorer')].map(({ explorer: { stage } }) => {
            stage.look(view);
            stage.draw(0);
            return [stage.wanted, stage.paper.labels.map((b) => [b.left, b.top, b.right, b.bottom])]; })""",
            view,
        )
        for arm, (wanted, boxes) in zip(arms, found):
            for i, a in enumerate(boxes):
                assert all(
                    a[0] >= b[2] or b[0] >= a[2] or a[1] >= b[3] or b[1] >= a[3] for b in boxes[:i]
                ), f"{arm.name}, {view}"
            missing[arm.name, view] = 1 - len(boxes) / wanted
    assert max(missing.values()) < 0.2 and np.mean(list(missing.values())) < 0.04, sorted(
        missing.items(), key=lambda item: -item[1]
    )[:5]


def drawn(page, k=0):
    """Wait for the picture."""
    page.wait_for_function(
        "k => { const { stage } = document.querySelectorAll('.dhlab-explorer')[k].explorer; return"
        " stage.drawn > 0 && !stage.stale; }",
        arg=k,
    )


def test_axe_finds_nothing_in_any_mode(opened, modes, packages):
    page = opened(*modes.values(), stills=True)
    unfold(page)
    (passed, light), (coloured, dark) = axe(page, packages)
    assert passed > 15 and coloured > 0 and light == dark == []


def test_one_loop_sleeps_out_of_sight_and_when_nothing_changes(opened, modes):
    page = opened(*modes.values())
    count = "[...document.querySelectorAll('.dhlab-explorer')].map((e) => e.explorer.stage.drawn)"
    drawn(page)
    before = page.evaluate(count)
    assert before[-1] == 0, "the last one is far below and has not been drawn"
    page.evaluate(
        "document.querySelectorAll('.dhlab-explorer').forEach((e) => e.explorer.stage.redraw())"
    )
    drawn(page)
    after = page.evaluate(count)
    assert after[0] == before[0] + 1 and after[-1] == 0
    page.wait_for_timeout(200)
    assert page.evaluate(count) == after, "nothing moves, nothing is drawn"
    explorer(page, len(modes) - 1).scroll_into_view_if_needed()
    drawn(page, len(modes) - 1)
    assert (
        page.evaluate(
            "[...Object.getOwnPropertySymbols(globalThis)].filter((s) => s.description ==="
            " 'dhlab.explorer').length"
        )
        == 1
    )


def test_without_webgl_the_still_picture_is_seen_and_the_sliders_work(opened):
    page = opened(dh.explore(dh.load("ur5e")), stills=True, webgl=False)
    assert (
        page.locator("figure.dhlab-picture img").is_visible() and page.locator("canvas").is_hidden()
    )
    before = page.locator("dd").first.inner_text()
    page.get_by_role("slider", name="Joint 1, degrees").press("PageUp")
    assert page.locator("dd").first.inner_text() != before


def test_with_webgl_the_still_picture_makes_room(opened, modes):
    page = opened(modes["arm"], stills=True)
    assert (
        page.locator("figure.dhlab-picture img").is_hidden() and page.locator("canvas").is_visible()
    )
    drawn(page)
    colours = page.evaluate(
        """() => { const c = document.querySelector('.dhlab-explorer').explorer.stage.canvas, d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data;
        const seen = { x: 0, y: 0, z: 0 };
        for (let i = 0; i < d.length; i += 4) { const [r, g, b] = d.slice(i, i + 3); if (d[i + 3] < 200) continue;
            if (r > 150 && g < 110 && b < 80) seen.x++; if (g > 80 && r < 70 && b < 120 && g > b) seen.y++; if (b > 110 && r < 80 && b > g + 30) seen.z++; }
        return seen; }"""
    )
    assert min(colours.values()) > 100, colours


def test_the_view_turns_by_keys_mouse_and_buttons(opened, modes):
    page = opened(modes["arm"])
    angles = (
        "(({ azimuth, elevation, zoom }) => [azimuth, elevation,"
        " zoom])(document.querySelector('.dhlab-explorer').explorer.stage.camera)"
    )
    drawn(page)
    home, canvas = page.evaluate(angles), page.locator("canvas")
    canvas.focus()
    page.keyboard.press("ArrowLeft")
    page.keyboard.press("ArrowUp")
    page.keyboard.press("+")
    turned = page.evaluate(angles)
    assert all(abs(a - b) > 0.05 for a, b in zip(home, turned))
    box = canvas.bounding_box()
    page.mouse.move(box["x"] + 300, box["y"] + 200)
    page.mouse.down()
    page.mouse.move(box["x"] + 380, box["y"] + 160, steps=4)
    page.mouse.up()
    assert page.evaluate(angles)[0] != turned[0]
    page.get_by_role("button", name="Top", exact=True).click()
    assert page.evaluate(angles)[1] == 90
    page.get_by_role("button", name="Home", exact=True).click()
    assert page.evaluate(angles) == home


def test_one_finger_turns_two_fingers_zoom(opened, modes):
    page = opened(modes["arm"], has_touch=True)
    camera = (
        "(({ azimuth, zoom }) => [azimuth,"
        " zoom])(document.querySelector('.dhlab-explorer').explorer.stage.camera)"
    )
    box, hand = page.locator("canvas").bounding_box(), page.context.new_cdp_session(page)
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2

    def drag(*ways):
        for k in range(6):
            points = [
                {"x": x + dx * k / 5 + start, "y": y, "id": i} for i, (start, dx) in enumerate(ways)
            ]
            hand.send(
                "Input.dispatchTouchEvent",
                {"type": "touchMove" if k else "touchStart", "touchPoints": points},
            )
        hand.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
        return page.evaluate(camera)

    before = page.evaluate(camera)
    turned = drag((0, 120))
    assert turned[0] < before[0] - 20 and turned[1] == before[1]
    assert drag((-40, -80), (40, 80))[1] > 1.2


def test_a_lost_picture_comes_back(opened, modes):
    page = opened(modes["arm"])
    drawn(page)
    page.evaluate(
        """() => { const { stage } = document.querySelector('.dhlab-explorer').explorer;
        const { gl } = stage.paper.renderer;
        gl.canvas.addEventListener('webglcontextlost', () => { window.gone = true; });
        window.lost = gl.getExtension('WEBGL_lose_context');
        window.lost.loseContext(); stage.redraw(); window.before = stage.drawn; }"""
    )
    page.wait_for_function("window.gone")
    page.evaluate("window.lost.restoreContext()")
    page.wait_for_function(
        "document.querySelector('.dhlab-explorer').explorer.stage.drawn > window.before"
    )


def test_link_moves_one_by_one_in_the_order_of_the_convention(opened, modes):
    page = opened(modes["link"], reduced_motion="reduce")
    unfold(page)
    for convention, order in (("Standard", "θ₄ d₄ a₄ α₄"), ("Craig", "α₃ a₃ θ₄ d₄")):
        page.get_by_role("radio", name=convention).check(force=True)
        page.get_by_role("button", name="To the start").click()
        items = page.locator(".moves li")
        assert [item.split(" ")[1] for item in items.all_text_contents()] == order.split()
        table = dh.DHTable(convention.lower(), *modes["link"].row[:, None], "R")
        for k in range(4):
            np.testing.assert_allclose(_shown(page), _after(table, k), atol=5.1e-5)
            page.get_by_role("button", name="One move forward").click()
            assert items.nth(k).get_attribute("class") == "now"
        end = dh.Arm(table).forward([0])[:3, 3]
        np.testing.assert_allclose(_shown(page), end, atol=5.1e-5)
        page.get_by_role("button", name="One move back").click()
        np.testing.assert_allclose(_shown(page), _after(table, 3), atol=5.1e-5)


def _shown(page):
    """Where the moving frame is (m), as the page says."""
    return numbers(" ".join(text_table(page, "Frames, seen")[2][1:4]))[:3]


@pytest.mark.parametrize("convention", ["Standard", "Craig"])
def test_the_move_that_runs_is_the_one_marked(opened, convention):
    page = opened(dh.explore(dh.DHTable.standard([[40, 0.3, 0.4, 50]], angle="deg"), mode="link"))
    page.set_viewport_size({"width": 390, "height": 800})
    page.get_by_role("radio", name=convention).check(force=True)
    play = """way => { const { explorer: { stage, host }, shadowRoot } = document.querySelector('.dhlab-explorer');
        const items = [...shadowRoot.querySelectorAll('.moves li')], seen = [];
        if (way === 'back') host.set('step', 0);
        else [...shadowRoot.querySelectorAll('button')].find((one) => one.textContent === 'Play all').click();
        for (let time = 0; time < 4600; time += 100) {
            stage.draw(time);
            seen.push(items.map((item) => item.className)); }
        return seen; }"""
    for way, order in (("on", [0, 1, 2, 3]), ("back", [3, 2, 1, 0])):
        seen = page.evaluate(play, way)
        for step, classes in enumerate(seen[:-3]):
            part = (0.016 + 0.1 * step) / 1.1
            if abs(part - round(part)) > 0.01:
                now = order[int(part)]
                assert classes == ["done"] * now + ["now"] + [""] * (3 - now), (way, step)
        assert seen[-1] == (["done"] * 3 + ["now"] if way == "on" else [""] * 4)


ROWS = [
    (110, 0.3, -0.1, -20),
    (-60, 0.1, -0.3, 90),
    (30, 0.2, 0.3, 90),
    (40, 0.3, 0.4, 50),
    (90, 0.3, 0.2, 90),
]


def test_no_x_and_z_fall_together_in_the_first_view_of_a_row(opened):
    tables = [dh.DHTable.standard([row], angle="deg") for row in ROWS]
    page = opened(*(dh.explore(table, mode="link") for table in tables))
    cameras = (
        "[...document.querySelectorAll('.dhlab-explorer')].map((e) => e.explorer.stage.camera)"
        ".map(({ azimuth, right, up }) => [azimuth, right, up])"
    )
    first = page.evaluate(cameras)
    for row, table, (azimuth, *flat) in zip(ROWS, tables, first, strict=True):
        R = dh.Arm(table).forward([0])[:3, :3]
        axes = [np.eye(3)[0], np.eye(3)[2], R[:, 0], R[:, 2]]
        for k, v in enumerate(axes):
            for w in axes[:k]:
                space = np.linalg.norm(np.cross(v, w))
                if space > 1e-6:
                    a, b = np.array(flat) @ v, np.array(flat) @ w
                    assert (
                        abs(a[0] * b[1] - a[1] * b[0]) / max(np.linalg.norm(a), np.linalg.norm(b))
                        > 0.25 * space
                    ), row
        assert azimuth == -58 or row[0] != 90, "a view that is good stays"
    for name in ("Top", "Home"):
        for k in range(len(ROWS)):
            explorer(page, k).get_by_role("button", name=name, exact=True).click()
    assert page.evaluate(cameras) == first, "and is what Home means"


def _after(table, k):
    """Where the moving frame is (m) after k moves: the other parameters are not there yet."""
    order = {"standard": [0, 1, 2, 3], "craig": [3, 2, 0, 1]}[table.convention]
    row = np.array([value if j in order[:k] else 0.0 for j, value in enumerate(table.rows[0])])
    return dh.Arm(dh.DHTable(table.convention, *row[:, None], "R")).forward([0])[:3, 3]


def test_conventions_say_how_far_the_frames_are_apart(opened, modes):
    page, arm = opened(modes["conventions"], **NUMBERS), dh.load("ur5e")
    far = np.linalg.norm(
        (arm.to("standard").frames(Q) - arm.to("craig").frames(Q))[:, :3, 3], axis=1
    )
    for k in range(7):
        page.get_by_role("radio", name=f"{{{k}}}").check(force=True)
        text = page.get_by_text(f"Frame {{{k}}}: standard puts").inner_text()
        assert (
            "coincide" in text
            if far[k] < 1e-9
            else numbers(text.split("origins are")[1])[0] == pytest.approx(far[k], abs=5.1e-5)
        )


def test_compare_tells_every_error_and_goes_to_the_worst(opened, modes):
    page, data = opened(modes["compare"], **NUMBERS), modes["compare"]._data
    found = (
        np.reshape(data["poses"], (-1, 4, 4))[:, :3, 3]
        - modes["compare"].arm.forward(data["qs"])[:, :3, 3]
    )
    errors = 1000 * np.linalg.norm(found, axis=1)
    np.testing.assert_allclose(
        [numbers(row[1])[0] for row in text_table(page, "Errors")], errors, atol=0.0051
    )
    page.get_by_role("button", name="The pose before").click()
    page.get_by_role("button", name="Worst").click()
    assert page.get_by_role("slider", name="Pose").input_value() == str(1 + errors.argmax())


def test_lengths_are_in_the_unit_that_was_asked_for(opened):
    arm, names = dh.load("cobra600"), ["arm", "link", "conventions", "branches", "place"]
    needs = {"branches": {"q": np.zeros((1, 4))}}
    for length, other in (("m", "mm"), ("mm", "m")):
        page = opened(
            *(dh.explore(arm, mode=mode, length=length, **needs.get(mode, {})) for mode in names),
            **NUMBERS,
        )
        unfold(page)
        for mode, text in zip(names, page.locator(".explorer").all_inner_texts(), strict=True):
            assert re.search(rf"[\d(]{length}\b|\d {length}\b", text), mode
            seen = re.findall(rf".*(?:\d |\(){other}\b.*", text)
            assert not seen, (mode, seen)
    with pytest.raises(ValueError, match='expected length "m" or "mm", found \'cm\''):
        dh.explore(arm, length="cm")


def test_branches_are_gone_through_one_by_one(opened, modes):
    page = opened(modes["branches"], **NUMBERS)
    qs = modes["branches"]._data["qs"]
    page.get_by_role("button", name="The next solution").click()
    assert page.get_by_text("Solution 2 of 5").first.is_visible()
    rows = text_table(page, "Every solution")
    shown = [[numbers(cell)[0] for cell in row[1:]] for row in rows]
    assert np.allclose(shown, np.rad2deg(qs), atol=0.006)
    page.get_by_role("button", name="The solution before").click()
    assert page.get_by_text("Solution 1 of 5").first.is_visible()


def test_two_arms_mark_the_entry_that_differs(opened, modes):
    page = opened(modes["two"], **NUMBERS)
    assert page.locator("td.differs").all_text_contents() == ["90°", "−90°"]


def test_ends_that_nearly_coincide_share_their_letters(opened):
    arm = dh.load("ur5e")
    rows = arm.table.rows
    rows[5, 1] += 0.001
    page = opened(
        dh.explore(
            arm,
            mode="compare",
            other=dh.Arm(dh.DHTable.standard(rows, angle="rad"), name="near"),
            q=Q,
        )
    )
    drawn(page)
    letters = page.evaluate(
        "document.querySelector('.dhlab-explorer').explorer.stage.paper.labels.map((box) =>"
        " box.label.text)"
    )
    assert [letters.count(letter) for letter in "xyz"] == [1, 1, 1]


def test_bare_axes_end_on_the_floor_with_a_dot(opened):
    page = opened(dh.explore(dh.load("article-6r"), mode="place"))
    drawn(page)
    lowest, lines, dots = page.evaluate(
        """() => { const { stage } = document.querySelector('.dhlab-explorer').explorer, lines = [], dots = [];
        const known = { lowest: stage.lowest, line: (points) => lines.push(points), ring: (at) => dots.push(at) };
        stage.mode.build(new Proxy(known, { get: (scene, name) => scene[name] ?? (() => [0, 0, 0]) }));
        return [stage.lowest, lines, dots]; }"""
    )
    assert np.min(np.array(lines)[..., 2]) == pytest.approx(lowest) and len(lines) == 6
    assert (
        np.array(dots)[:, 2] == pytest.approx([lowest] * len(dots))
        and np.allclose(dots[0][:2], 0)
        and len(dots) == 2
    )


def test_placement_is_played_to_its_table(opened, modes):
    page, data = opened(modes["place"], **NUMBERS), modes["place"]._data
    for _ in range(3):
        page.get_by_role("button", name="Forward").click()
    assert page.locator(".steps li:visible").count() == 3
    page.get_by_role("button", name="To the end").click()
    rows = text_table(page, "The finished table")
    np.testing.assert_allclose(
        [numbers(row[4])[0] for row in rows],
        np.rad2deg([row[3] for row in data["finished"]["rows"]]),
        atol=0.0051,
    )
    assert page.locator(".steps li:visible").count() == len(data["worked"]) == 3 * 7


def test_an_arrow_turned_round_changes_the_numbers_that_python_changes(opened):
    explorer = dh.explore(dh.load("stanford").to("craig"), mode="place")
    page, arm = opened(explorer, **NUMBERS), explorer.placing.placement.model
    page.get_by_role("button", name="To the end").click()
    for letter, i in (("x", 1), ("z", 2), ("x", 3), ("z", 3), ("z", 6)):
        page.get_by_role("button", name=f"Turn {letter}{i} round").click()
        arm = arm.flip_x(i) if letter == "x" else arm.flip_z(i)
        rows = text_table(page, "The finished table")
        found = np.array([[numbers(cell)[-1] for cell in row[1:]] for row in rows])
        wanted = arm.table.rows * [180 / np.pi, 1, 1, 180 / np.pi]
        gap = found - wanted
        gap[:, [0, 3]] = (gap[:, [0, 3]] + 180) % 360 - 180
        np.testing.assert_allclose(gap[:, [0, 3]], 0, atol=0.051)
        np.testing.assert_allclose(gap[:, [1, 2]], 0, atol=5.1e-5)
    page.get_by_text("joint 6 counts the other way").wait_for()


def test_the_theme_of_the_page_is_taken_up(opened, modes):
    page = opened(modes["arm"], **NUMBERS)
    shade = page.locator(".explorer")
    for attribute, value, wanted in (
        ("data-theme", "dark", "dark"),
        ("data-theme", "light", "light"),
        ("data-theme", None, "light"),
        ("data-jp-theme-light", "false", "dark"),
        ("data-jp-theme-light", "true", "light"),
    ):
        page.evaluate(
            "([name, value]) => value ? document.body.setAttribute(name, value)"
            " : document.body.removeAttribute(name)",
            [attribute, value],
        )
        page.wait_for_function(
            "wanted =>"
            " document.querySelector('.dhlab-explorer').shadowRoot.querySelector('.explorer').dataset.theme"
            " === wanted",
            arg=wanted,
        )
    assert shade.get_attribute("data-theme") == "light"


def test_phones_need_no_sideways_scrolling(opened, modes):
    page = opened(*modes.values())
    page.set_viewport_size({"width": 390, "height": 800})
    assert page.evaluate("document.documentElement.scrollWidth") <= 390


def test_frames_are_placed_by_hand_and_judged_by_python(live):
    arm = dh.load("cobra600")
    explorer, rng, verdicts = dh.explore(arm, mode="place"), np.random.default_rng(3), []
    page = live(explorer, **NUMBERS)
    while explorer.arm is None:
        offers = page.locator(".offers input")
        for k in rng.permutation(offers.count()):
            before = explorer._answer
            offers.nth(int(k)).check(force=True)
            page.get_by_role("button", name="Place it").click()
            until(page, "Python's answer", lambda seen=before: explorer._answer is not seen)
            page.wait_for_function(
                "text => document.querySelector('main >"
                " div').shadowRoot.querySelector('.verdict').textContent.includes(text)",
                arg=explorer._answer["said"]["message"],
            )
            verdicts.append(page.locator(".verdict").get_attribute("class"))
            if explorer._answer["said"]["right"]:
                break
    assert verdicts.count("verdict right") == 3 * 5 and verdicts.count("verdict wrong") > 5
    q = rng.uniform(-1, 1, (5, 4))
    np.testing.assert_allclose(explorer.arm.forward(q), arm.forward(q), atol=1e-9)
    rows = text_table(page, "The finished table")
    np.testing.assert_allclose(
        [numbers(row[3])[0] for row in rows], explorer.arm.table.a, atol=5.1e-5
    )
    page.get_by_role("button", name="Undo").click()
    page.get_by_text("1 step left").wait_for()
    assert explorer.arm is None and explorer.placing.placement.missing == ("x4",)
    page.get_by_role("button", name="Start over").click()
    page.get_by_text("15 steps left").wait_for()
    assert page.get_by_role("button", name="Undo").is_disabled()


def test_python_and_hands_move_the_same_numbers(live):
    explorer = dh.explore(dh.load("panda"), mode="link", joint=5)
    page = live(explorer)
    page.get_by_role("slider", name="alpha, the turn about x").press("ArrowRight")
    page.get_by_role("radio", name="Standard").check(force=True)
    until(page, "the convention in Python", lambda: explorer.convention == "standard")
    assert (
        explorer.row[3] == pytest.approx(np.deg2rad(-89.5))
        and explorer.convention == "standard"
        and explorer.table.convention == "standard"
    )
    page.evaluate("close()")
    assert page.evaluate("document.querySelector('main > div').explorer.stage.canvas.isConnected")
