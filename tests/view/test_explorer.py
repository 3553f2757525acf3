"""The explorer on Python's side: what it takes, what it says, what it stores, and that every
placement can be finished from what it offers.
"""

import json
import re
import subprocess

import nbformat
import numpy as np
import pytest
from nbclient import NotebookClient

import dhlab as dh
from dhlab import transform
from dhlab.view.explorer import stills, without_widgets
from dhlab.view.explorer.placing import Placing, axes_of
from dhlab.view.explorer.widget import MODULE

Q = [0.3, -0.8, 1.1, 0.2, -0.5, 0.9]


@pytest.fixture(scope="module")
def arm():
    return dh.load("article-6r")


def test_module_is_what_its_source_gives(packages):
    subprocess.run(["npm", "run", "--silent", "build"], cwd=packages, check=True)
    for name in ("explorer.js", "instrument.js", "gif.js"):
        assert (packages.parent / name).read_bytes() == MODULE.with_name(name).read_bytes(), (
            "run npm ci and npm run build in dhlab/view/explorer/js"
        )


def test_lock_names_no_registry():
    lock = json.loads((MODULE.parent / "js" / "package-lock.json").read_text())
    assert all("resolved" not in package for package in lock["packages"].values())
    assert {"node_modules/esbuild", "node_modules/axe-core"} <= set(lock["packages"])


def test_python_sets_and_is_told(arm):
    explorer, seen = dh.explore(arm), []
    explorer.observe(lambda change: seen.append(change.new.tolist()), "q")
    explorer.q = Q
    explorer.q = np.array(Q)
    assert seen == [Q]
    assert explorer.get_state("q") == {"q": Q}
    explorer.set_state({"q": [0.5, *Q[1:]]})
    assert explorer.q.tolist() == [0.5, *Q[1:]] and len(seen) == 2
    with pytest.raises(ValueError):
        explorer.q[0] = 1


@pytest.mark.parametrize("convention", ["standard", "craig"])
@pytest.mark.parametrize("name", ["ur5e", "stanford", "cobra600"])
def test_table_is_the_one_shown(name, convention):
    arm = dh.load(name).to(convention)
    q = np.linspace(-0.4, 0.6, len(arm))
    shown = dh.Arm(dh.explore(arm, q=q).table, base=arm.base, tool=arm.tool)
    np.testing.assert_allclose(shown.forward(np.zeros(len(arm))), arm.forward(q), atol=1e-12)


def test_link_mode_starts_at_the_row_and_gives_a_table_back(arm):
    explorer = dh.explore(arm, mode="link", joint=3, q=Q)
    np.testing.assert_allclose(explorer.row, arm.table.rows[2] + [Q[2], 0, 0, 0])
    np.testing.assert_allclose(dh.Arm(explorer.table).forward([0]), arm.links(Q)[2], atol=1e-15)
    explorer.row = [0, 0.1, 0.2, np.pi / 2]
    assert explorer.table == dh.DHTable.standard([[0, 0.1, 0.2, 90]], angle="deg")


def test_compare_mode_follows_the_pose_shown(arm):
    qs = np.random.default_rng(2).uniform(-1, 1, (4, 6))
    poses = arm.forward(qs)
    poses[2, :3, 3] += 0.01
    explorer = dh.explore(arm, mode="compare", q=qs, poses=poses)
    assert explorer.step == 3 and explorer.q.tolist() == qs[2].tolist()
    explorer.step = 1
    assert explorer.q.tolist() == qs[0].tolist()
    with pytest.raises(ValueError, match="from 1 to 4, found 5"):
        explorer.step = 5


def test_branches_mode_follows_the_solution_shown():
    arm = dh.load("puma560")
    answer = arm.solve(arm.forward([0.1, 0.5, -0.2, 0.3, 0.4, 0.5]), method="search")
    explorer = dh.explore(arm, mode="branches", q=answer)
    assert explorer.step == 1
    assert explorer.q.tolist() == answer[0].tolist()
    explorer.step = 8
    assert explorer.q.tolist() == answer[7].tolist()
    assert "8 ways" in repr(explorer)
    assert "8 configurations" in explorer._still().alt
    with pytest.raises(ValueError, match="from 1 to 8, found 9"):
        explorer.step = 9


def test_pose_mode_holds_poses_and_nothing_else():
    explorer, seen = dh.explore([np.eye(4), transform.rot_z(0.3)], mode="pose"), []
    explorer.observe(lambda change: seen.append(change.new), "poses")
    explorer.set_state({"poses": [transform.trans([1, 2, 3]).tolist(), np.eye(4).tolist()]})
    assert explorer.poses[0, :3, 3].tolist() == [1, 2, 3] and len(seen) == 1
    with pytest.raises(ValueError, match="poses.1.: expected a 4×4 pose"):
        explorer.poses = [np.eye(4), 2 * np.eye(4)]
    with pytest.raises(ValueError, match="expected 2 × 4 × 4 finite numbers"):
        explorer.poses = np.eye(4)
    assert explorer.state()["poses"][0][0][3] == 1
    with pytest.raises(ValueError, match="one pose or two, found 3"):
        dh.explore([np.eye(4)] * 3, mode="pose")


ERRORS = [
    ({"mode": "branches"}, "one or more configurations"),
    ({"mode": "branches", "q": [0] * 6}, "one or more configurations"),
    ({"mode": "branches", "q": np.zeros((2, 5))}, "q: expected 6 values"),
    ({"mode": "arms"}, "expected one of the modes arm, link"),
    ({"q": [0]}, "q: expected 6 values"),
    ({"q": np.zeros((2, 6))}, "expected one configuration"),
    ({"mode": "link", "joint": 7}, "joint from 1 to 6, found 7"),
    ({"mode": "link", "poses": 1}, "takes q, joint, found 'poses'"),
    ({"mode": "compare"}, "expected either poses .* or other"),
    ({"mode": "compare", "q": np.zeros((2, 6)), "poses": np.zeros((3, 3))}, "as many finite poses"),
    ({"mode": "compare", "other": dh.load("panda")}, "second arm of 6 joints, found 7"),
    ({"mode": "place", "end": np.eye(4)}, "an arm brings its own"),
    ({"mode": "pose"}, r"expected a pose \(4, 4\), or two"),
]


@pytest.mark.parametrize("needs, sentence", ERRORS, ids=[sentence[:20] for _, sentence in ERRORS])
def test_what_does_not_fit_is_said(arm, needs, sentence):
    with pytest.raises(ValueError, match=sentence):
        dh.explore(arm, **needs)


@pytest.mark.parametrize("value", [[0] * 5, [0, 0, 0, 0, 0, np.nan], ["a"] * 6, None, [[0] * 6]])
def test_q_is_six_finite_numbers(arm, value):
    with pytest.raises(ValueError, match="explorer.q: expected 6 finite numbers"):
        dh.explore(arm).q = value


def test_no_arm_is_said():
    for mode in ("arm", "link", "conventions", "compare"):
        with pytest.raises(ValueError, match="expected an Arm or a DHTable, found list"):
            dh.explore([[0, 0, 0, 0]], mode=mode, **({"other": 1} if mode == "compare" else {}))


CELLS = [
    "import dhlab as dh\narm = dh.load('article-6r')\narm",
    "dh.explore(arm, q=[0.1] * 6)",
    "dh.explore(arm, mode='place')",
    "arm.table",
]


def _stored():
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(text) for text in CELLS])
    NotebookClient(notebook, timeout=120, kernel_name="python3").execute()
    live = json.dumps(notebook)
    return live, [cell.outputs[0].data for cell in without_widgets(notebook).cells], notebook


@pytest.mark.notebook
def test_stored_outputs_are_the_same_every_time_and_show_something_anywhere():
    live, outputs, notebook = _stored()
    _, again, _ = _stored()
    assert "application/vnd.jupyter.widget-view+json" in live and "model_id" not in json.dumps(
        notebook
    )
    assert outputs == again
    shown, explored, placed, _ = (output["text/html"] for output in outputs)
    assert "<table" in shown and 'class="dhlab-explorer"' in shown and "<img" not in shown
    for html in (explored, placed):
        alt = re.search(r'<img alt="([^"]+)"', html)[1]
        assert len(alt.split()) > 20 and "<summary>" in html
    assert outputs[0]["text/plain"] == repr(dh.load("article-6r"))


def test_an_arm_outside_a_notebook_shows_its_table(arm):
    assert arm._repr_mimebundle_() == {"text/html": arm._repr_html_(), "text/plain": repr(arm)}


def test_text_cannot_leave_the_data():
    named = dh.Arm(dh.DHTable.standard([[0, 1, 0, 0]], angle="deg"), name="</script><b>x</b>")
    bundle = dh.explore(named)._repr_mimebundle_()
    html = (bundle[0] if isinstance(bundle, tuple) else bundle)["text/html"]
    assert html.count("</script>") == 1 and "<b>" not in html.split("<script")[0]


@pytest.mark.parametrize("convention", ["standard", "craig"])
@pytest.mark.parametrize("name", ["article-6r", "ur5e", "stanford", "panda", "cobra600"])
def test_every_placement_can_be_finished_from_the_offers(name, convention):
    arm, rng = dh.load(name), np.random.default_rng(5)
    placing, refused = Placing(*axes_of(arm), convention), 0
    answer = placing.answer()
    while answer["next"]:
        offers = list(answer["offers"])
        rng.shuffle(offers)
        for offer in offers:
            judgement = placing.make(answer["next"], offer["value"], offer["point"])
            if judgement:
                break
            refused += 1
        else:
            pytest.fail(f"{answer['next']}: no offer is right: {offers}")
        answer = placing.answer(judgement)
    placed = placing.placement.arm
    q = rng.uniform(-1, 1, (20, len(arm)))
    np.testing.assert_allclose(placed.forward(q), arm.forward(q), atol=1e-8)
    assert refused > len(arm), "some offers are wrong"


def test_a_board_is_shown_with_what_is_placed_on_it(arm):
    board = dh.explore(arm, mode="place").placing.placement
    for i, (x, _, z, o) in enumerate(frame[:3].T for frame in board.model.frames(np.zeros(6))):
        assert board.set_z(i, -z, o) and board.set_origin(i, o)
        if i < 6:
            assert board.set_x(i, -x)
    half = dh.explore(board, mode="place")
    assert half.arm is None and half._answer["next"] == "x6" and half.step == 0
    assert board.set_x(6, x)
    whole = dh.explore(board, mode="place")
    np.testing.assert_allclose(whole.arm.table.rows, board.arm.table.rows, atol=1e-9)
    assert whole.step == len(whole._data["worked"]) == 3 * 7
    np.testing.assert_allclose(whole._data["finished"]["rows"], board.arm.table.rows, atol=1e-9)
    with pytest.raises(ValueError, match="brings its own end"):
        dh.explore(board, mode="place", end=np.eye(4))


def test_a_step_from_python_is_seen_in_the_view(arm):
    explorer = dh.explore(arm, mode="place")
    assert explorer.place("z0", [0, 0, 1]) and explorer._answer["placed"] == [
        {"step": "z0", "value": [0, 0, 1]}
    ]
    wrong = explorer.place("z1", [0, 0, 1])
    assert (
        not wrong
        and explorer._answer["said"]["rule"] == wrong.rule
        and explorer.arm is None
        and explorer.table is None
    )
    with pytest.raises(ValueError, match='such as "z1"'):
        explorer.place("y1", [0, 0, 1])
    with pytest.raises(ValueError, match='expected mode "place"'):
        dh.explore(arm).place("z1", [0, 0, 1])


def test_steps_are_taken_back_one_by_one(arm):
    placing, answers = Placing(*axes_of(arm), "standard"), []
    while placing.placement.missing:
        answers.append(placing.answer())
        offer = next(
            offer
            for offer in answers[-1]["offers"]
            if placing.make(answers[-1]["next"], offer["value"], offer["point"])
        )
        placing.make("z0", [1, 1, 1])  # a wrong one after it is nothing to take back
    for before in reversed(answers):
        placing.back()
        assert placing.answer() | {"turn": 0} == before | {"turn": 0}, offer
    placing.back()
    assert placing.answer() | {"turn": 0} == answers[0] | {"turn": 0}


def test_a_wrong_step_made_twice_is_answered_twice(arm):
    explorer, answers = dh.explore(arm, mode="place"), []
    explorer.observe(lambda change: answers.append(change.new["said"]["rule"]), "_answer")
    for _ in range(2):
        explorer._heard({"step": "z0", "value": [1, 0, 0]})
    assert len(answers) == 2 and answers[0] == answers[1]


def luminance(hexadecimal):
    """Relative luminance as WCAG 2.1 defines it."""
    rgb = np.array([int(hexadecimal[k : k + 2], 16) for k in (1, 3, 5)]) / 255
    return np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4) @ [
        0.2126,
        0.7152,
        0.0722,
    ]


@pytest.mark.parametrize("scheme", ["LIGHT", "DARK"])
def test_what_is_written_in_the_picture_stands_out_from_its_ground(scheme):
    source = (MODULE.parent / "js" / "src" / "theme.js").read_text(encoding="utf-8")
    colors = dict(
        re.findall(
            r'(\w+): "(#\w{6})"', re.search(rf"const {scheme} = \{{(.*?)\}};", source, re.DOTALL)[1]
        )
    )
    for name in ("x", "y", "z", "ink", "quiet", "other", "error", "trace"):
        dark, light = sorted(luminance(color) for color in (colors[name], colors["ground"]))
        assert (light + 0.05) / (dark + 0.05) >= 4.5, name


def test_the_still_picture_of_two_near_arms_letters_each_axis_once(arm):
    rows = arm.table.rows
    rows[5, 1] += 0.002
    near = dh.Arm(dh.DHTable.standard(rows, angle="rad"), name="near")
    texts = [
        text.get_text() for text in stills.two(arm, near, np.zeros(len(arm))).figure.axes[0].texts
    ]
    assert [texts.count(f"${letter}$") for letter in "xyz"] == [1, 1, 1]
