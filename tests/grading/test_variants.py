"""Variants: HMAC-SHA256 by hand, no two alike in a class, a key that is made once and shown to
nobody.
"""

import hashlib
import os
import re
import stat
import sys

import nbformat
import numpy as np
import pytest

from dhlab.course.building.questions import question_of
from dhlab.course.exercises import exercises
from dhlab.course.kinds import Choice, Value
from dhlab.course.workspace import handed_out
from dhlab.grading.handing_out.release import with_variant
from dhlab.grading.handing_out.variants import make_key, read_key, variant, variants

KEY = bytes(range(32))


def hmac_by_hand(key, message):
    """RFC 2104, written out."""
    block = key.ljust(64, b"\0")
    inner = hashlib.sha256(bytes(b ^ 0x36 for b in block) + message).digest()
    return hashlib.sha256(bytes(b ^ 0x5C for b in block) + inner).digest()


@pytest.mark.parametrize("student", ["ada", "李小龙", "a" * 100, "Ångström"])
def test_a_variant_is_the_hmac_of_the_id(student):
    assert (
        variant(KEY, student)
        == int.from_bytes(hmac_by_hand(KEY, student.encode())[:8], "big") % (2**31 - 1) + 1 + 2**32
    )


def test_a_variant_depends_on_key_and_student_alone():
    numbers = [variant(KEY, f"student {k}") for k in range(2000)]
    assert len(set(numbers)) == 2000 and all(2**32 < n < 2**32 + 2**31 for n in numbers)
    other = [variant(KEY[::-1], f"student {k}") for k in range(2000)]
    assert not set(numbers) & set(other) and abs(np.corrcoef(numbers, other)[0, 1]) < 0.1
    assert variant(KEY, "Ångström") == variant(KEY, "Ångström"), (
        "one name, written in two ways of Unicode"
    )


def test_every_exercise_with_numbers_draws_other_ones():
    drawn = [e for e in exercises().values() if isinstance(e, Value) and e.given(0)]
    assert len(drawn) >= 5
    for exercise in drawn:
        texts = {repr(exercise.given(variant(KEY, f"s{k}"))) for k in range(30)}
        assert len(texts) >= 3, f"{exercise.id} hardly varies"


def test_without_a_key_everybody_has_the_same():
    assert (
        variants(None, ["a", "b"]) == {"a": 0, "b": 0}
        and len(set(variants(KEY, ["a", "b"]).values())) == 2
    )


def test_a_key_is_made_once_and_for_its_owner_alone(tmp_path):
    path = tmp_path / "teacher.key"
    key = make_key(path)
    assert len(key) == 32 and read_key(path) == key
    if sys.platform != "win32":
        assert stat.S_IMODE(os.stat(path).st_mode) == 0o600
    with pytest.raises(ValueError, match="found one that exists"):
        make_key(path)
    assert read_key(path) == key and make_key(tmp_path / "other.key") != key


@pytest.mark.parametrize("text", ["", "short", "zz" * 32, "00" * 31, "00" * 33])
def test_what_is_no_key_is_refused(tmp_path, text):
    (tmp_path / "k").write_text(text)
    with pytest.raises(ValueError, match="expected the teacher's key"):
        read_key(tmp_path / "k")


def listed(cell):
    """{text: letter} of the options that a Markdown cell shows, but "?"."""
    found = re.findall(r'^- `"(\w)"` (.*)$', cell.source, re.MULTILINE)
    return {text: letter for letter, text in found}


def test_what_is_right_is_what_the_students_own_list_shows():
    """Every letter, as a student reads it in the lesson as released, against the letters of the
    lesson for all.
    """
    places = {}
    for path in sorted(handed_out().glob("[0-9]*.ipynb")):
        text = path.read_text(encoding="utf-8")
        for student in ("ada", "bo", "cy"):
            number = variant(KEY, student)
            cells = nbformat.reads(with_variant(text, number), as_version=4).cells
            for exercise in (exercises().get(question_of(cell)) for cell in cells):
                if not isinstance(exercise, Choice):
                    continue
                (cell,) = [cell for cell in cells if question_of(cell) == exercise.id]
                letters = listed(cell)
                assert set(letters) == {option.text for option in exercise.options.values()}
                for key, option in exercise.options.items():
                    verdict = exercise.judge(letters[option.text], number)
                    assert (verdict.status == "right") == (key == exercise.correct)
                places.setdefault(exercise.id, []).append(letters)
    moved = [key for key, seen in places.items() if any(one != seen[0] for one in seen)]
    assert len(places) >= 15 and len(moved) >= 0.9 * len(places)


def test_letters_with_a_meaning_and_numbers_given_by_hand_keep_their_order():
    number = variant(KEY, "ada")
    assert exercises()["03.1"].letters(number) == {"standard": "s", "craig": "c"}
    choices = [exercise for exercise in exercises().values() if isinstance(exercise, Choice)]
    assert all(exercise.letters(17) == exercise.letters() for exercise in choices)
