"""The class report of 60 simulated students, graded in the cage: what it counts, whom it names, and
what it looks like.
"""

import re
import sys
from collections import Counter
from html import unescape
from itertools import combinations
from pathlib import Path

import numpy as np
import pytest
from test_feedback import HOSTILE, Page

from dhlab.course.exercises import exercises
from dhlab.doctor import catalogue
from dhlab.grading.intake.roster import Student
from dhlab.grading.reports.alike import Pair, alike, answers
from dhlab.grading.reports.classreport import class_report, write_class_report
from dhlab.grading.reports.items import items
from dhlab.grading.reports.sections import (
    question,
    section_of_exercise,
    section_of_mistake,
    sheet_question,
)
from dhlab.grading.results.marks import Graded, Mark

sys.path.insert(0, str(Path(__file__).parents[2] / "benchmarks"))
import classroom


@pytest.fixture(scope="module")
def simulated(tmp_path_factory):
    return classroom.simulate(tmp_path_factory.mktemp("class"), lessons=("05",), seconds=1)


@pytest.fixture(scope="module")
def text(simulated):
    return simulated[2].read_text(encoding="utf-8")


def test_every_student_is_there_with_the_status_that_was_planted(simulated, text):
    status = {graded.student: graded.status for graded in simulated[0]}
    planted = (
        {f"s{k:03d}": "unreadable" for k in classroom.SPOILED}
        | {f"s{k:03d}": "missing" for k in classroom.MISSING}
        | {f"s{k:03d}": "not attempted" for k in classroom.UNTOUCHED}
    )
    assert (
        len(status) == 60
        and {who: what for who, what in status.items() if what != "graded"} == planted
    )
    assert all(f"feedback/{who}.html" in text for who in status)
    late = {graded.student for graded in simulated[0] if graded.penalty}
    assert late == {f"s{k:03d}" for k in classroom.LATE}


def test_it_counts_what_was_planted(simulated):
    results, made, _ = simulated
    wrong, named, known, rightly = classroom.tally(results, made)
    assert wrong > 80 and named / wrong > 0.75 and rightly / known > 0.85
    looked_at = {graded.student: graded for graded in results if graded.status == "graded"}
    for k, plan in enumerate(made):
        if (
            plan.student.student in looked_at
            and k not in classroom.LOOPING
            and k not in classroom.COPIES
        ):
            right = {
                mark.exercise
                for mark in looked_at[plan.student.student].marks
                if mark.status == "right"
            }
            assert right == {key for key, planted in plan.planted.items() if planted == "right"}, (
                plan.student.student
            )


def test_mistakes_lead_back_to_the_lesson_and_to_a_question(simulated, text):
    page = unescape(text)
    for item in items(simulated[0]):
        part = page.partition(f'id="e-{item.exercise}"')[2].partition("</section>")[0]
        assert exercises()[item.exercise].title in part
        for mistake, count in item.mistakes.items():
            row = (
                f"{catalogue()[mistake].title} <code"
                f' class="soft">{mistake}</code></td><td>{count}</td>'
                if mistake
                else f"yourself</td><td>{count}</td>"
            )
            assert row in part
        if any(item.mistakes):
            assert section_of_exercise(item.exercise) in part and "<b>Ask:</b>" in part
    assert sheet_question("05") in page and len(sheet_question("05")) > 40


def _for_all(letter, variant, everybodys):
    """The letter that an option has without a variant, from the letter that a student saw."""
    own = {shown: key for key, shown in exercises()["05.2"].letters(variant).items()}
    return everybodys[own[letter]] if letter in own else letter


def test_every_option_has_its_letter_its_text_and_how_many_chose_it(simulated, text):
    results, made, _ = simulated
    part = unescape(text).partition('id="e-05.2"')[2].partition("</section>")[0]
    written = {plan.student.student: plan.code.get("05.2") for plan in made}
    everybodys = exercises()["05.2"].letters()
    answered = Counter(
        _for_all(written[graded.student].strip("'"), graded.variant, everybodys)
        for graded in results
        for mark in graded.marks
        if mark.exercise == "05.2" and mark.status in ("right", "wrong")
    )
    assert answered["a"] and answered["b"] and sum(answered.values()) > 30
    for letter, said in (
        ("a", "none: every change of order is a mistake"),
        ("b", 'Rz with Tz, Tx with Rx, and Tz with Tx <span class="soft">(right)</span>'),
        ("c", "all turns with all shifts"),
        ("d", "Rz with Rx, since both are turns"),
        ("?", "I don't know yet"),
    ):
        assert f"<b>{letter}</b> {said}</td><td>{answered[letter]}</td>" in part


def test_the_misleading_question_shows_and_no_other(simulated, text):
    assert [item.exercise for item in items(simulated[0]) if item.discrimination < 0] == [
        classroom.BAD_QUESTION
    ]
    assert (
        f'before the class is blamed: <a href="#e-{classroom.BAD_QUESTION}"' in text
        and "misleading" in text
    )


def test_those_who_copied_are_named_and_who_drew_the_same_program_at_most(simulated, text):
    pairs = {(f"s{other:03d}", f"s{k:03d}") for k, other in classroom.COPIES.items()}
    drawn = {plan.student.student: plan.drawn.items() for plan in simulated[1]}
    alike = set(re.findall(r"<td>[^<]*\((s\d+)\) and [^<]*\((s\d+)\)</td>", text))
    guessed = {(graded.guess_of, graded.student) for graded in simulated[0] if graded.guess_of}
    assert guessed <= pairs <= guessed | alike
    assert all(drawn[one] & drawn[other] for one, other in alike - pairs)


def test_names_of_students_are_text(simulated, text):
    page = Page(text)
    assert (
        "script" not in page.tags
        and page.balanced
        and all(name not in text for name in ("<script>", "\u202e"))
    )
    assert "<script>alert('no')</script>" in page.text and "=HYPERLINK" in page.text
    csv = (simulated[2].parent / "grades.csv").read_text(encoding="utf-8")
    assert "\"'=HYPERLINK" in csv


@pytest.mark.parametrize("text", HOSTILE)
def test_nothing_is_raw(text):
    def report(word):
        marks = (
            Mark("05.1", "wrong", 0, 1, word, *[word] * 5),
            Mark("05.2", "not allowed", 0, 1, None, *[word] * 5),
        )
        results = [
            Graded(word, word, "graded", marks, notes=(word,), guess_of=word, cage=word),
            Graded("x", "", "unreadable", (), notes=(word,)),
        ]
        return Page(class_report(results, [Student(word, word)], [Pair((word, "x"), 0.9, (word,))]))

    plain, page = report("mirror"), report(text)
    assert (
        page.balanced
        and page.tags <= plain.tags | {"code"}
        and {name for name, _ in page.attributes}
        <= {name for name, _ in plain.attributes} | {"class"}
    )
    links = {value for name, value in page.attributes if name == "href"}
    assert all(link.startswith(("feedback/", "#e-")) for link in links)


def test_it_is_readable_without_seeing_the_bars(text):
    assert set(re.findall(r"<svg [^>]*>", text)) and all(
        'aria-hidden="true"' in svg for svg in re.findall(r"<svg [^>]*>", text)
    )
    assert (
        text.count("<table") == text.count("<caption>")
        and "<th>" not in text
        and text.count("<h1>") == 1
    )
    assert "bubblewrap" in text or "Landlock" in text or "limits only" in text, (
        "the cage that was used is said"
    )


def test_it_looks_as_it_should(simulated, new_page):
    """In Chromium: nothing asked from elsewhere, nothing wider than the window, bars as long as
    their numbers say.
    """
    for width in (1280, 390):
        page = new_page(viewport={"width": width, "height": 900})
        asked = []
        page.on("request", lambda request: asked.append(request.url))  # noqa: B023  (of this page)
        page.goto(simulated[2].as_uri())
        assert len(asked) == 1 and page.evaluate("document.documentElement.scrollWidth") <= width
        narrowest = page.locator("td").evaluate_all(
            "cells => Math.min(...cells.filter(c => c.offsetParent && c.innerText.length >"
            " 30).map(c => c.getBoundingClientRect().width))"
        )
        assert width > 600 or narrowest > 300, (
            "on a telephone the cells of a row stand below each other"
        )
        rows = page.locator("section.item table tbody tr").evaluate_all(
            "rows => rows.filter(r => !r.closest('details') && r.querySelector('svg')).map(r =>"
            " [Number(r.cells[1].innerText),"
            " r.querySelector('rect').getBoundingClientRect().width])"
        )
        counts, widths = np.array(rows).T
        assert len(rows) > 15 and np.allclose(widths / counts, widths[0] / counts[0], rtol=0.05)


def test_item_analysis_against_numbers_worked_by_hand():
    """Twelve students, two exercises worth 1 and one worth 2: the correlation of each with the
    rest, from the definition.
    """
    rng = np.random.default_rng(3)
    points = rng.integers(0, 2, (12, 3)) * [1, 1, 2]
    results = [
        Graded(
            f"s{i}",
            "",
            "graded",
            tuple(
                Mark(f"05.{j + 1}", "right" if p else "wrong", float(p), of)
                for j, (p, of) in enumerate(zip(row, (1, 1, 2)))
            ),
        )
        for i, row in enumerate(points)
    ]
    for j, item in enumerate(items(results)):
        x, y = points[:, j].astype(float), np.delete(points, j, 1).sum(1).astype(float)
        by_hand = ((x - x.mean()) * (y - y.mean())).sum() / np.sqrt(
            ((x - x.mean()) ** 2).sum() * ((y - y.mean()) ** 2).sum()
        )
        assert np.isclose(item.discrimination, by_hand) and np.isclose(
            item.difficulty, x.mean() / (1, 1, 2)[j]
        )
        assert item.statuses == Counter("right" if p else "wrong" for p in x)
    assert items(results[:9])[0].discrimination is None and items([]) == []


def _program(seed):
    """25 lines that nobody else writes."""
    r = np.random.default_rng(seed)
    words = [f"v{k}" for k in range(30)]
    return "\n".join(
        f"{r.choice(words)} = {r.choice(words)} {r.choice(['+', '*', '-', '@'])}"
        f" {r.choice(['sin', 'cos'])}({r.choice(words)}) / {r.integers(2, 99)}"
        for _ in range(25)
    )


def test_renaming_reordering_and_comments_hide_no_copy_and_a_common_answer_is_none():
    rng = np.random.default_rng(0)
    common = "\n".join(f"x{k} = y{k} + {k}" for k in range(40))
    codes = {f"s{k}": {"05.1": common, "05.2": _program(k)} for k in range(30)}
    copied = re.sub(r"v(\d+)", r"my_\1_name", codes["s3"]["05.2"])
    codes["thief"] = {
        "05.1": common,
        "05.2": "\n".join(f"{line}   # {rng.integers(9)}" for line in copied.splitlines()),
    }
    [pair] = alike(codes, {})
    assert pair.students == ("s3", "thief") and pair.share > 0.95 and pair.exercises == ("05.2",)
    assert alike(codes, {"05.2": codes["s3"]["05.2"]}) == [], "what was handed out is nobody's copy"


def test_four_of_twenty_who_share_one_program_are_found():
    codes = {f"s{k:02d}": {"05.1": _program(k)} for k in range(20)}
    for size in (2, 3, 4):
        circle = {f"s{k:02d}": codes["s00"] for k in range(size)}
        found = {pair.students for pair in alike(codes | circle, {})}
        assert found == set(combinations(circle, 2))
    many = {f"s{k:02d}": codes["s00"] for k in range(12)}
    assert alike(codes | many, {}) == [], "what most of a class writes is how one writes it"


@pytest.mark.parametrize(
    "notebook",
    [
        None,
        3,
        {},
        {"cells": None},
        {
            "cells": [
                3,
                {"cell_type": "code"},
                {"cell_type": "code", "source": None},
                {"cell_type": "code", "source": [1, {}]},
            ]
        },
        {"cells": [{"cell_type": "code", "source": "def f(:\n  '''\ncheck('05.1', f)"}]},
    ],
)
def test_a_broken_notebook_is_compared_as_far_as_it_goes(notebook):
    assert alike({"a": answers(notebook), "b": answers(notebook)}, {}) == []


def test_where_and_what_to_ask():
    assert section_of_mistake("every-order-taken-for-wrong").endswith("“The order of the moves”")
    asked = question(exercises()["05.2"], "every-order-taken-for-wrong")
    assert "every change of order is a mistake" in asked and asked.endswith(
        "What would convince them?"
    )
    assert (
        all(section_of_mistake(mistake) for mistake in catalogue()) and sheet_question("99") == ""
    )


def test_each_section_has_a_report_of_its_own_and_the_missing_stand_in_one_line(tmp_path):
    roster = [Student(name, section=section) for name, section in ("aA", "bB", "cB", "dB")]
    marks = (Mark("05.1", "right", 1, 1),)
    results = [Graded(name, "", "graded" if name in "ab" else "missing", marks) for name in "abcd"]
    write_class_report(results, roster, tmp_path)
    pages = {path.name: path.read_text(encoding="utf-8") for path in tmp_path.iterdir()}
    assert sorted(pages) == [f"class-report{end}.html" for end in ("-A", "-B", "")]
    whole, own = pages["class-report.html"], pages["class-report-B.html"]
    assert 'href="class-report-B.html"' in whole and "<b>Nothing handed in (2)</b>: c, d" in whole
    assert "3 on the roster" in own and "feedback/b.html" in own and "feedback/a.html" not in own


def test_of_mistakes_that_as_many_made_the_one_that_came_first_stands_first():
    made = list(catalogue())[:8]
    for order in (made, made[::-1]):
        marks = tuple(
            Mark(f"05.{k}", "wrong", 0, 1, mistake=mistake) for k, mistake in enumerate(order, 1)
        )
        page = class_report([Graded("ada", "", "graded", marks)])
        told = re.findall(r'<code class="soft">([\w-]+)</code>', page)
        assert [mistake for mistake in order if mistake in told] == told[: len(set(told))]
