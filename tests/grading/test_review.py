"""The teacher's page: what is decided there is in decisions.yaml and nothing else of it changes;
nobody else gets in; by keyboard through a class of 120, and nothing for axe to find.
"""

import base64
import http.client
import json
import os
import shutil
import threading
from urllib.parse import urlsplit

import pytest
from axe import axe

from dhlab.course.exercises import exercises
from dhlab.course.kinds import Explain
from dhlab.grading.exports.gradebooks import read_marks, settled
from dhlab.grading.grade import grade
from dhlab.grading.intake.roster import Student
from dhlab.grading.reports.answered import keep_answers, own_answers, read_answers
from dhlab.grading.reports.feedback import feedback_page
from dhlab.grading.reports.publish import publish
from dhlab.grading.results.decisions import read_decisions
from dhlab.grading.results.gradebook import Gradebook
from dhlab.grading.results.marks import Graded, Mark
from dhlab.grading.reviewing.desk import Desk
from dhlab.grading.reviewing.edit import decide, hold
from dhlab.grading.reviewing.server import serve
from dhlab.grading.settings import Lesson, Settings

HOSTILE = "<img src=x onerror=document.title='gone'></pre><script>1</script>\n"
FILE = """# my decisions
dropped: {"05.7": "the task was unclear"}     # counts for nobody
students:
    ada:   # a friend
        due: {"05": 2030-11-25}                   # for her alone
        exercises:
            "05.4": {points: 1.5, comment: 'Right idea.', was: 0}
        bonus: 1.50
    bo:
        due: {"05": 2030-11-25 12:00}   # at noon
"""


@pytest.fixture(scope="module")
def graded_folder(tmp_path_factory):
    """A class of 120; 05.4 is wrong and has no name for every tenth."""
    top = tmp_path_factory.mktemp("class")
    book = Gradebook(top)
    with book.alone():
        for k in range(120):
            marks = (
                Mark("05.2", "right", 1, 1, file="a.ipynb"),
                Mark("05.4", "wrong" if k % 10 == 0 else "right", 0 if k % 10 == 0 else 2, 2),
            )
            marks = (marks[0], Mark.from_dict(marks[1].to_dict() | {"file": "a.ipynb"}))
            graded = Graded(f"s{k:03d}", "a.ipynb", "graded", marks)
            book.write(graded)
            cells = [{"source": f"{HOSTILE}x = {k}"}, {"source": 'check("05.4", x)'}]
            notebook = {"cells": [{"cell_type": "code", **cell} for cell in cells]}
            keep_answers(graded, {("a.ipynb", ""): own_answers(notebook)}, top)
    return top


@pytest.fixture
def folder(graded_folder, tmp_path):
    """A copy of the class, to be decided upon."""
    return shutil.copytree(graded_folder, tmp_path, dirs_exist_ok=True)


@pytest.fixture
def address(folder):
    server, address = serve(Desk(folder, [Student("s000", "<b>Ada</b>")]))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    yield address
    server.shutdown()
    server.server_close()


def asked(address, path="", method="GET", body=None, **headers):
    parts = urlsplit(address)
    connection = http.client.HTTPConnection(parts.hostname, parts.port, timeout=10)
    connection.request(method, path or parts.path, body, headers)
    reply = connection.getresponse()
    return reply.status, reply.read().decode(), dict(reply.getheaders())


def test_a_decision_changes_nothing_else_in_the_file(tmp_path):
    path = tmp_path / "decisions.yaml"
    path.write_text(FILE, encoding="utf-8")
    decide(path, "cy", "05.2", {"points": 0.5, "comment": 'so "it" is: #1\ntrue', "was": 1.0})
    assert path.read_text(encoding="utf-8").startswith(FILE)
    found = read_decisions(path).students["cy"].exercises["05.2"]
    assert (found.points, found.comment, found.was) == (0.5, 'so "it" is: #1\ntrue', 1)
    decide(path, "cy", "05.2", {"points": None, "comment": "", "was": None})
    assert path.read_text(encoding="utf-8") == FILE, "a decision that is taken back leaves nothing"
    hold(path, "ada", "we have to talk")
    assert read_decisions(path).students["ada"].hold == "we have to talk"
    assert "# a friend" in path.read_text(encoding="utf-8")


def test_ids_and_exercises_may_stand_without_quotes(tmp_path):
    path = tmp_path / "decisions.yaml"
    written = "students:\n  0123:\n    bonus: 1\n    exercises:\n      05.4: {points: 2.0}\n"
    path.write_text(written, encoding="utf-8")
    decide(path, "0123", "05.2", {"points": 0.5, "ticks": [1, 2]})
    assert path.read_text(encoding="utf-8").startswith(written)
    decide(path, "0123", "05.4", {"points": 1.0})
    (mine,) = read_decisions(path).students.values()
    points = {key: decided.points for key, decided in mine.exercises.items()}
    assert (mine.bonus, points) == (1, {"05.4": 1, "05.2": 0.5})
    assert mine.exercises["05.2"].ticks == (1, 2)


@pytest.mark.parametrize("student", ["null", "Null", "1000"])
def test_an_id_that_yaml_reads_as_another_thing_is_itself(tmp_path, student):
    """Also beside one that YAML would take for the same."""
    path = tmp_path / "decisions.yaml"
    written = (
        f"students:\n    {student}: {{bonus: 1}}\n    NULL: {{bonus: 2}}\n    1e3: {{bonus: 3}}\n"
    )
    path.write_text(written, encoding="utf-8")
    hold(path, student, "we have to talk")
    found = read_decisions(path).students
    assert found[student].hold and found[student].bonus == 1 and len(found) == 3
    path.write_text("students: null\n", encoding="utf-8")
    hold(path, student, "we have to talk")
    assert read_decisions(path).students.keys() == {student}


def test_next_weeks_file_of_the_same_name_leaves_this_weeks_answers(tmp_path):
    weeks = "2026-11-01 10:00, zip", "2026-11-08 10:00, zip"
    marks = [
        Mark(key, "right", 1, 1, file="a.ipynb", handed_in=when)
        for key, when in zip(("05.2", "06.2"), weeks)
    ]
    for k, mark in enumerate(marks):
        cells = {"source": "x = 1"}, {"source": f'check("{mark.exercise}", x)'}
        own = own_answers({"cells": [{"cell_type": "code", **cell} for cell in cells]})
        graded = Graded("ada", "a.ipynb", "graded", tuple(marks[: k + 1]))
        keep_answers(graded, {("a.ipynb", mark.handed_in): own}, tmp_path)
    assert set(read_answers("ada", tmp_path)) == {"05.2", "06.2"}


def test_a_file_that_grading_refuses_is_left_as_it_is(tmp_path):
    path = tmp_path / "decisions.yaml"
    path.write_text("students: {ada: {points: 3}}  # mine\n", encoding="utf-8")
    with pytest.raises(ValueError, match='line 1: .*unknown key "points"'):
        hold(path, "bo", "why")
    assert path.read_text(encoding="utf-8") == "students: {ada: {points: 3}}  # mine\n"
    assert [each.name for each in tmp_path.iterdir()] == ["decisions.yaml"]


def test_an_answer_is_what_its_student_wrote_and_stands_when_the_file_is_gone(folder):
    code = read_answers("s010", folder)["05.4"].code
    assert code == f"{HOSTILE}x = 10"
    keep_answers(Gradebook(folder).read("s010"), {}, folder)
    assert read_answers("s010", folder)["05.4"].code == code
    odd = [{}, {"cells": 3}, {"cells": [None, {"cell_type": "code", "source": 5}]}, []]
    assert [own_answers(notebook) for notebook in odd] == [{}] * 4


def test_what_a_browser_is_started_with_leads_in_once(folder):
    server, address = serve(Desk(folder))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    try:
        assert urlsplit(server.once).path != urlsplit(address).path
        assert asked(server.once, Host="evil.example")[0] == 404
        status, _, headers = asked(server.once)
        assert (status, headers["Location"]) == (303, urlsplit(address).path)
        assert asked(server.once)[0] == 404
        assert asked(address)[0] == asked(address)[0] == 200
    finally:
        server.shutdown()
        server.server_close()


def test_nobody_gets_in_without_the_token_or_from_another_site(address):
    parts = urlsplit(address)
    save = json.dumps({"student": "s000", "hold": "x"})
    kind = {"Content-Type": "application/json"}
    assert parts.hostname == "127.0.0.1" and len(parts.path) > 30
    status, page, headers = asked(address)
    assert status == 200 and "default-src 'none'" in headers["Content-Security-Policy"]
    assert "http" not in page.replace("http-equiv", "")
    assert asked(address, "/")[0] == asked(address, "/" + "a" * 32 + "/class")[0] == 404
    assert asked(address, Host="evil.example")[0] == 404
    to = parts.path + "save"
    assert asked(address, to, "POST", save, Origin="http://evil.example", **kind)[0] == 400
    assert asked(address, to, "POST", save, **{"Content-Type": "text/plain"})[0] == 400
    assert asked(address, parts.path + "../../etc/passwd")[0] == 404
    assert asked(address, parts.path + "answers/%2e%2e%2fx")[0] == 404


@pytest.mark.parametrize(
    "given, words",
    [
        ({"student": "nobody", "hold": ""}, "expected a student"),
        ({"student": "s000", "exercise": "05.9"}, "expected an exercise"),
        ({"student": "s000", "exercise": "05.4", "points": "2"}, "expected points from 0 to 2"),
        ({"student": "s000", "exercise": "05.4", "points": -1}, "expected points from 0 to 2"),
        ({"student": "s000", "hold": 3}, "expected a text"),
        ([], "expected a student"),
    ],
)
def test_what_is_no_decision_is_refused_and_nothing_written(folder, given, words):
    with pytest.raises(ValueError, match=words):
        Desk(folder).save(given)
    assert not (folder / "decisions.yaml").exists()


def test_by_keyboard_through_a_class_of_120(folder, address, browser):
    page, outside = shown(browser, address)
    assert page.locator("#count").inner_text().startswith("1 of 12, 12 not")
    page.keyboard.press("m")
    page.keyboard.type("1,5")
    page.keyboard.press("Enter")
    for k in range(1, 12):
        page.get_by_text(f"x = {10 * k}", exact=False).wait_for()
        page.keyboard.press("h" if k == 11 else "c")
        page.keyboard.type("Look again.")
        page.keyboard.press("Control+Enter")
    page.get_by_text("There is no other one").wait_for()
    page.close()
    assert outside == []
    known = read_decisions(folder / "decisions.yaml").students
    one = known["s000"].exercises["05.4"]
    assert (one.points, one.was) == (1.5, 0)
    assert [known[f"s{k:03d}"].exercises["05.4"].comment for k in range(10, 110, 10)] == [
        "Look again."
    ] * 10
    assert known["s110"].hold == "Look again." and len(known) == 12


def test_answers_of_students_who_are_called_like_a_part_of_an_object(tmp_path, browser):
    names, book = ["__proto__", "constructor", "s0", "toString"], Gradebook(tmp_path)
    with book.alone():
        for k, name in enumerate(names):
            graded = Graded(name, "a", "graded", (Mark("05.4", "error", 0, 2, file="a"),))
            book.write(graded)
            cells = [{"source": f"x = {k}"}, {"source": 'check("05.4", x)'}]
            notebook = {"cells": [{"cell_type": "code", **cell} for cell in cells]}
            keep_answers(graded, {("a", ""): own_answers(notebook)}, tmp_path)
    server, address = serve(Desk(tmp_path, [Student(name) for name in names]))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    page, outside = shown(browser, address)
    for k, name in enumerate(names):
        page.get_by_text(name, exact=True).wait_for()
        page.get_by_text(f"x = {k}", exact=True).wait_for()
        page.keyboard.press("n")
    page.close()
    server.shutdown()
    server.server_close()
    assert outside == []


def test_axe_finds_nothing(address, browser, packages):
    page, outside = shown(browser, address)
    page.locator("summary").click()
    assert [found for _, found in axe(page, packages)] == [[], []], "in the light, in the dark"
    assert (outside, page.title()) == ([], "Review")
    page.close()


def shown(browser, address):
    """(the page with its first answer, what it asked of others or could not do)."""
    page, outside = browser.new_page(), []
    own = (address, f"http://{urlsplit(address).netloc}/favicon.ico")
    page.on("request", lambda r: None if r.url.startswith(own) else outside.append(r.url))
    page.on("pageerror", lambda e: outside.append(str(e)))
    page.goto(address)
    page.get_by_text("x = 0").wait_for()
    return page, outside


EXPLAIN = Explain(
    id="05.99",
    title="Why",
    points=3,
    question="Why?",
    rubric=(("names the seal", 1), ("names the pressure", 2)),
)
PIXEL = (
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAA"
    "DUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg=="
)


def handed_in(answer, picture=False):
    """A notebook with an explanation."""
    photo = {"cell_type": "markdown", "metadata": {}, "source": "![](p.png)"}
    photo["attachments"] = {"p.png": {"image/png": PIXEL, "image/svg+xml": "<svg/>"}}
    cells = [
        {"cell_type": "code", "metadata": {}, "source": source, "outputs": [], "id": f"c{k}"}
        for k, source in enumerate(
            ("from dhlab.course import check", f"why = {answer}", 'check("05.99", why)')
        )
    ]
    cells[2:2] = [photo] if picture else []
    told = {"cells": cells, "metadata": {}, "nbformat": 4, "nbformat_minor": 5}
    return json.dumps(told).encode()


@pytest.mark.cage
def test_an_explanation_counts_when_it_is_marked_and_never_for_another_answer(
    tmp_path, monkeypatch, kept_cages
):
    monkeypatch.setitem(exercises(), "05.99", EXPLAIN)
    answers = {"ada": ('"Air presses."', False), "bo": ("...", True), "cy": ("...", False)}
    settings = Settings({"05": Lesson(points={})}, cage="")

    def run():
        for student, given in answers.items():
            (tmp_path / "in" / student).mkdir(parents=True, exist_ok=True)
            path = tmp_path / "in" / student / "05.ipynb"
            path.write_bytes(handed_in(*given))
            os.utime(path, (10**9, 10**9))  # the minute is part of a mark
        results, planned = grade(tmp_path / "in", tmp_path / "out", settings=settings)
        publish(planned, results, (), tmp_path / "out")
        found = read_marks(tmp_path / "out")
        return found, {k: {m.exercise: m for m in g.marks}["05.99"] for k, g in found.items()}

    found, marks = run()
    assert [marks[k].status for k in answers] == ["to be marked", "to be marked", "not attempted"]
    assert found["ada"].of == found["cy"].of - 3 and settled(found)[1] == {"05.99": 2}
    assert len({graded.of for graded in settled(found)[0].values()}) == 1
    desk = Desk(tmp_path / "out")
    text, pictures = desk.answers("ada")["05.99"]
    assert text.endswith('why = "Air presses."') and pictures == []
    assert desk.answers("bo")["05.99"][1] == ["image/png"]
    assert desk.picture("bo", "05.99", 0) == ("image/png", base64.b64decode(PIXEL))
    assert desk.picture("bo", "05.99", 1) is None
    for student, points, ticks in (("ada", 2, [2]), ("bo", 3, [2, 1])):
        given = {"student": student, "exercise": "05.99", "points": points, "comment": ""}
        desk.save(given | {"ticks": ticks})
        with pytest.raises(ValueError, match="rubric"):
            desk.save(given | {"ticks": [3]})
    shown = {
        each["id"]: each["marks"]["05.99"]["ticks"] for each in Desk(desk.folder).show()["students"]
    }
    assert shown["ada"] == [2] and shown["bo"] == [1, 2]
    assert "ticks: [1, 2]" in desk.decisions.read_text(encoding="utf-8")
    found, marks = run()
    changed = (tmp_path / "out" / "changes.csv").read_text(encoding="utf-8-sig").splitlines()
    assert 'ada,05.99,to be marked,"2 of 3, marked",your decision' in changed and len(changed) == 5
    assert [marks[k].points for k in answers] == [2, 3, 0] and settled(found)[1] == {}
    assert "Marked by your teacher" in feedback_page(found["ada"])
    answers["ada"] = ('"Another text."', False)
    found, marks = run()
    assert marks["ada"].status == "to be marked" and found["bo"].points == 3
    assert Desk(tmp_path / "out").show()["students"][0]["marks"]["05.99"]["given"] is None
