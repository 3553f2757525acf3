"""A robot's own links over the frames: where its URDF says, and read from no notebook."""

import json
from pathlib import Path

import numpy as np
import pytest

import dhlab as dh

SHOWN = """([told, shapes]) => {
    const state = %s, heard = (s) => new DataView(new Float32Array(s).buffer);
    const model = {
        get: (name) => state[name], set() {}, save_changes() {}, off() {},
        on(name, call) { if (name === "msg:custom") model.hear = call; },
        send: ({ meshes }) => meshes && setTimeout(() => model.hear(told, shapes.map(heard))),
    };
    dhlab.widget.render({ model, el: document.querySelector("main") });
}"""
EXPLORER = "document.querySelector('main > div').explorer"
PAINTED = """() => {
    const { stage } = %s, copy = document.createElement("canvas"), pen = copy.getContext("2d");
    stage.draw(performance.now());
    [copy.width, copy.height] = [stage.canvas.width, stage.canvas.height];
    pen.drawImage(stage.canvas, 0, 0);
    const { data } = pen.getImageData(0, 0, copy.width, copy.height);
    return data.filter((v, k) => k %% 4 === 3 && v > 0).length;
}"""


def test_links_stand_where_the_urdf_says_and_no_notebook_keeps_them(judge, opened):
    yourdfpy, trimesh = judge("yourdfpy"), judge("trimesh")
    folder = Path(judge("pybullet_data").getDataPath()) / "kuka_iiwa"
    arm, q = dh.load("iiwa14"), np.deg2rad([40, 20, -20, 30, -50, 60, 10])
    explorer = dh.explore(arm, q=q, meshes=folder / "model.urdf")
    sent = []
    explorer.send = lambda content, buffers: sent.append((content, buffers))
    explorer._heard({"meshes": True})
    [(content, buffers)] = sent

    robot = yourdfpy.URDF.load(folder / "model.urdf", load_meshes=False, build_scene_graph=True)
    robot.update_cfg(q)
    frames = arm.frames(q)
    assert [part["frame"] for part in content["parts"]] == list(range(8))
    for part, data in zip(content["parts"], buffers):
        i = part["frame"]
        pose = frames[i] @ np.reshape(part["pose"], (4, 4))
        np.testing.assert_allclose(pose, robot.get_transform(f"lbr_iiwa_link_{i}"), atol=2e-3)
        wanted = trimesh.load(folder / "meshes" / f"link_{i}.stl", process=False).triangles
        np.testing.assert_allclose(np.frombuffer(data, "<f4").reshape(-1, 3, 3), wanted, atol=1e-6)

    assert ".stl" not in str(explorer.get_state()) + str(explorer._repr_mimebundle_())
    page = opened()
    state = {"_data": explorer.get_state()["_data"], "step": 0, "q": q.tolist()}
    shapes = [np.frombuffer(data, "<f4").tolist() for data in buffers]
    page.evaluate(SHOWN % json.dumps(state), [content, shapes])
    page.wait_for_function(f"{EXPLORER}.mode.parts.length === 8")
    with_links = page.evaluate(PAINTED % EXPLORER)
    page.evaluate(f"{EXPLORER}.mode.parts = []")
    assert with_links > 1.05 * page.evaluate(PAINTED % EXPLORER)


def test_files_without_a_urdf_are_told_apart_by_number_and_unit(tmp_path):
    corners = np.array([[0, 0, 0], [300, 0, 0], [0, 200, 50]], "<f4")
    for name, scale in [("link_2.stl", 1), ("upper.stl", 0.001)]:
        words = "\n".join(f"vertex {x} {y} {z}" for x, y, z in (corners * scale).tolist())
        (tmp_path / name).write_text(f"solid one\n{words}\nendsolid", encoding="utf-8")
    arm = dh.load("article-6r")
    for given, i in [(tmp_path / "link_2.stl", 2), ({3: tmp_path / "upper.stl"}, 3)]:
        [part] = dh.explore(arm, meshes=given).parts
        zero = np.eye(4) if i == 3 else arm.frames(np.zeros(6))[i]
        assert part.frame == i
        np.testing.assert_allclose(zero @ part.pose, np.eye(4), atol=1e-12)
        assert part.scale[0] == (1e-3 if i == 2 else 1)
    with pytest.raises(ValueError, match="expected links from 0 to 6, found 9"):
        dh.explore(arm, meshes={9: tmp_path / "upper.stl"})


MACROS = """<robot name="bent" xmlns:xacro="http://www.ros.org/wiki/xacro">
<xacro:macro name="part" params="i">
  <link name="link${i}"><visual><origin xyz="0 0 ${i / 10}"/>
    <geometry><mesh filename="part${i}.stl"/></geometry></visual></link>
</xacro:macro>
%s
<joint name="turn" type="revolute"><parent link="link0"/><child link="link1"/>
  <origin xyz="0 0 0.3"/><axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/>
</joint></robot>"""
CALLED = '<xacro:part i="0"/><xacro:part i="1"/>'
ONE_LINK = """<link name="link{0}"><visual><origin xyz="0 0 {1}"/>
  <geometry><mesh filename="part{0}.stl"/></geometry></visual></link>"""


@pytest.mark.parametrize(
    "links",
    [CALLED, ONE_LINK.format(0, "0") + ONE_LINK.format(1, "${1 / 10}")],
    ids=["links from a macro", "a macro's number in a shape alone"],
)
@pytest.mark.parametrize("ending", ["xacro", "urdf"])
def test_links_that_a_macro_writes_are_drawn(judge, tmp_path, links, ending):
    judge("xacro")
    for i in range(2):
        words = "vertex 0 0 0\nvertex 0.1 0 0\nvertex 0 0.1 0"
        (tmp_path / f"part{i}.stl").write_text(f"solid one\n{words}\nendsolid", encoding="utf-8")
    file = tmp_path / f"bent.{ending}"
    file.write_text(MACROS % links, encoding="utf-8")
    arm = dh.Arm(dh.DHTable.standard([[0, 0.3, 0, 0]], angle="rad"))
    base, turned = dh.explore(arm, meshes=file).parts
    assert [base.frame, turned.frame] == [0, 1]
    # the plate stands 0.3 m up at the joint, where frame 1 lies, and 0.1 m above it
    np.testing.assert_allclose(base.pose, np.eye(4), atol=1e-12)
    np.testing.assert_allclose(turned.pose[:3, 3], [0, 0, 0.1], atol=1e-12)
