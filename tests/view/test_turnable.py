"""Pictures to be turned: the view shows what was given, in its place."""

import numpy as np

import dhlab as dh
from dhlab import view
from dhlab.transform import from_xyz_rpy, trans

X, Y, Z = np.eye(3)
AXES = [([0, 0, 0], Z), ([0.1, -0.2, 0.4], Y), ([0.5, 0, 0.4], -Y), ([0.7, 0, 0.2], X, "P")]
END = from_xyz_rpy([0.9, 0.1, 0.2], [0.3, 0.2, 0.1])


def test_axes_normals_and_frames_stand_where_they_were_given():
    data = view.axes(AXES, END, {0: trans([0, 0, 0.1])}).explorer()._data
    assert [one["name"] for one in data["lines"]] == [f"joint {k}" for k in (1, 2, 3, 4)]
    for one, (point, z, *letter) in zip(data["lines"], AXES):
        start, tip = np.array(one["ends"])
        np.testing.assert_allclose((tip - start) / np.linalg.norm(tip - start), z, atol=1e-12)
        np.testing.assert_allclose(np.cross(start - point, z), 0, atol=1e-12)
        np.testing.assert_allclose(one["at"], point, atol=1e-12)
        assert one["slides"] == (letter == ["P"])
    feet = np.array(data["normals"])
    np.testing.assert_allclose(feet[0], [[0, 0, 0.4], [0.1, 0, 0.4]], atol=1e-12)
    poses = {one["title"]: np.reshape(one["pose"], (4, 4)) for one in data["frames"]}
    np.testing.assert_allclose(poses["{0}"], trans([0, 0, 0.1]), atol=1e-12)
    np.testing.assert_allclose(poses["tool"], END, atol=1e-12)
    assert (
        data["table"]["rows"][3][1] == "slides"
        and not view.axes(AXES, END, normals=False).explorer()._data["normals"]
    )


def test_outside_a_notebook_it_is_a_still_picture():
    bundle = view.frames(np.eye(4))._repr_mimebundle_()
    assert bundle["text/html"].startswith('<figure class="dhlab-picture">')


def test_a_hand_and_keys_turn_it_and_its_table_is_the_pictures(opened):
    picture = view.axes(AXES, END)
    page = opened(picture.explorer(), dh.explore(mode="pose"))
    first = page.locator(".dhlab-explorer").first
    assert first.get_by_text("the rings are their feet").is_visible()
    first.get_by_text("The axes as a table").click()
    cells = first.locator("table tr").evaluate_all(
        "rows => rows.map(row => [...row.cells].map(cell => cell.textContent))"
    )
    assert cells == [picture.cells["headings"], *picture.cells["rows"]]
    seen = "document.querySelector('.dhlab-explorer').explorer.stage.camera.azimuth"
    before = page.evaluate(seen)
    canvas = first.locator("canvas")
    box = canvas.bounding_box()
    page.mouse.move(box["x"] + 30, box["y"] + 200)
    page.mouse.down()
    page.mouse.move(box["x"] + 150, box["y"] + 200, steps=4)
    page.mouse.up()
    turned = page.evaluate(seen)
    canvas.press("ArrowLeft")
    assert before != turned != page.evaluate(seen)
