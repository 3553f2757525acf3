"""Answers chosen by hand: written into their own cell when it is run again, and into no other."""

import numpy as np
import pytest
from jupyter_client.manager import start_new_kernel

import dhlab as dh
from dhlab.course import check, given
from dhlab.course.celltext import written
from dhlab.placing import Placement


@pytest.fixture(scope="module")
def kernel():
    """``run(cell, text)``: what a cell shows, and what the notebook is told to write into it; as
    JupyterLab runs it, with the cell's id.
    """
    manager, client = start_new_kernel(kernel_name="python3")

    def run(cell, text):
        content = {"code": text, "silent": False, "store_history": True, "allow_stdin": False}
        message = client.session.msg("execute_request", content, metadata={"cellId": cell})
        client.shell_channel.send(message)
        shown = []
        while True:
            heard = client.get_iopub_msg(timeout=60)
            if heard["parent_header"].get("msg_id") != message["header"]["msg_id"]:
                continue
            if heard["content"].get("execution_state") == "idle":
                break
            assert heard["msg_type"] != "error", heard["content"]
            shown.append(heard["content"].get("data", {}).get("text/plain", ""))
        reply = client.get_shell_msg(timeout=60)
        while reply["parent_header"].get("msg_id") != message["header"]["msg_id"]:
            reply = client.get_shell_msg(timeout=60)
        payload = reply["content"]["payload"]
        return "\n".join(shown), [(one["text"], one["replace"]) for one in payload]

    run(
        "01-000", "from dhlab.course import check, given, predict\nfrom dhlab.course import handing"
    )
    yield run
    manager.shutdown_kernel(now=True)


def hands(run, exercise, chosen):
    """What a click does: the widget's letters change, in no cell."""
    _, told = run("elsewhere", f"handing._offers[{exercise!r}].shown.chosen = {chosen}")
    assert told == []


@pytest.mark.notebook
def test_a_choice_is_written_into_its_own_cell_and_no_other(kernel):
    answer, question = "# replace the dots\nwhy = ...", 'check("01.6", why)'
    assert kernel("01-050", answer)[1] == []
    shown, told = kernel("01-051", question)
    assert "Cards" in shown and told == []
    hands(kernel, "01.6", ["c"])
    for cell, text in [("01-070", "why = ..."), ("02-003", answer), ("x", "why = ..."), ("y", "")]:
        assert kernel(cell, text)[1] == [], "another cell, even of the same text"
    shown, told = kernel("01-051", question)
    assert "What you chose, c, is not in the notebook yet" in shown and told == []
    assert kernel("01-050", answer)[1] == [('# replace the dots\nwhy = "c"', True)]
    assert "Right" in kernel("01-051", question)[0]
    assert kernel("01-050", '# replace the dots\nwhy = "c"')[1] == []


@pytest.mark.notebook
def test_a_guess_counts_in_the_run_that_writes_it(kernel):
    cell = 'guess = ...\npredict("01.P1", guess)'
    assert "Cards" in kernel("01-018", cell)[0]
    hands(kernel, "01.P1", ["b"])
    shown, told = kernel("01-018", cell)
    assert told == [('guess = "b"\npredict("01.P1", guess)', True)] and "Noted" in shown


@pytest.mark.notebook
def test_what_was_typed_stays_and_a_checks_own_expression_is_left_alone(kernel):
    kernel("01-050", "why = ...")
    kernel("01-051", 'check("01.6", why)')
    hands(kernel, "01.6", ["c"])
    assert kernel("01-050", 'why = "a"')[1] == []
    assert kernel("01-050", "why = ...")[1] == [], "the choice was dropped for what was typed"
    shown, told = kernel("01-052", 'check("01.6", ...)')
    assert "Cards" not in shown and told == []
    shown, _ = kernel("01-053", 'own = ...\ncheck("01.6", own)')
    assert "Cards" not in shown, "the answer's cell checks it: nothing would be written there"


@pytest.mark.notebook
def test_an_order_waits_for_every_place(kernel):
    kernel("01-040", "chain = [..., ..., ..., ...]")
    kernel("01-041", 'check("01.5", chain)')
    hands(kernel, "01.5", ["e", "c", "", ""])
    assert "is not in the notebook" not in kernel("01-041", 'check("01.5", chain)')[0]
    hands(kernel, "01.5", ["e", "c", "a", "d"])
    told = kernel("01-040", "chain = [..., ..., ..., ...]")[1]
    assert told == [('chain = ["e", "c", "a", "d"]', True)]


@pytest.mark.notebook
def test_frames_placed_by_hand_become_numbers_that_the_check_takes(kernel):
    cell = "frames = [[..., ..., ...], [..., ..., ...], [..., ..., ...]]"
    kernel("04-010", cell)
    assert "Place the frames above" in kernel("04-011", 'check("04.2", frames)')[0]
    steps = """offer = handing._offers["04.2"].shown
for T, i in zip(offer.placing.placement.model.frames([0.0, 0.0]), range(3)):
    offer.place(f"z{i}", T[:3, 2], T[:3, 3])
for T, i in zip(offer.placing.placement.model.frames([0.0, 0.0]), range(3)):
    offer.place(f"o{i}", T[:3, 3]), offer.place(f"x{i}", T[:3, 0])"""
    assert kernel("elsewhere", steps)[1] == []
    ((text, replaces),) = kernel("04-010", cell)[1]
    assert (
        replaces and "..." not in text and "Right" in kernel("04-011", 'check("04.2", frames)')[0]
    )
    space: dict = {}
    exec(text, space)
    assert check("04.2", space["frames"]).status == "right", "the notebook alone holds the answer"


def test_a_board_and_an_explorer_are_answers():
    task = given("04.2")
    board = Placement(task["axes"], task["end"])
    explorer = dh.explore(task["axes"], mode="place", end=task["end"])
    assert check("04.2", board).status == "not attempted"
    frames = board.model.frames(np.zeros(len(board)))
    for i, T in enumerate(frames):
        assert board.set_z(i, T[:3, 2]) and explorer.place(f"z{i}", T[:3, 2], T[:3, 3])
    for i, T in enumerate(frames):
        assert board.set_origin(i, T[:3, 3]) and board.set_x(i, T[:3, 0])
        assert explorer.place(f"o{i}", T[:3, 3]) and explorer.place(f"x{i}", T[:3, 0])
    assert check("04.2", board).status == check("04.2", explorer).status == "right"


@pytest.mark.parametrize(
    "text, name, chosen, wanted",
    [
        ("é = 1; a = ...  # ü", "a", "b", 'é = 1; a = "b"  # ü'),
        ("a = ...\na = ...", "a", "b", None),
        ("if True:\n    a = ...", "a", "b", None),
        ("a = [..., ...,\n     [1, 2]]", "a", [3, 4, 5], "a = [3, 4,\n     [1, 2]]"),
        ("a = [..., ...]", "a", "?", 'a = "?"'),
        ("a = (", "a", "b", None),
    ],
)
def test_dots_alone_are_replaced(text, name, chosen, wanted):
    assert written(text, name, chosen) == wanted
