"""Tables as people write them: each is read as what it says or asked about, never otherwise; and
whatever is done to a text, the answer is a reading or one plain sentence.
"""

from pathlib import Path

import numpy as np
import pytest
import yaml
from draws import few

import dhlab as dh
from tests.oracles import shift, turn

# by libyaml where it is there: every process of a run reads it
LOADER = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
FORMS = yaml.load(Path(__file__).with_name("forms.yaml").read_text(encoding="utf-8"), LOADER)
MARKS = list("()[]{},;:=|&\\\n\t 0123456789.-+*/°πθα'\"#%<>q")


def pose(form, q):
    """The end pose, multiplied out of elementary moves."""
    T, values = np.eye(4), iter(q)
    for (theta, d, a, alpha), joint, sign in zip(form["rows"], form["joints"], form["sign"]):
        step = 0 if joint == "F" else sign * next(values)
        theta, d = (theta, d + step) if joint == "P" else (theta + step, d)
        along, across = (
            turn([0, 0, theta]) @ shift([0, 0, d]),
            shift([a, 0, 0]) @ turn([alpha, 0, 0]),
        )
        T = T @ (along @ across if form["convention"] == "standard" else across @ along)
    return T


def is_the_form(arm, form):
    n = sum(joint != "F" for joint in form["joints"])
    if len(arm) != n:
        return False
    q = np.random.default_rng(6).uniform(-1.5, 1.5, (3, n))
    right = np.array([pose(form, values) for values in q])
    return np.allclose(arm.forward(q), right, rtol=1e-7, atol=1e-7)


@pytest.mark.slow
@pytest.mark.parametrize("form", FORMS, ids=[form["name"] for form in FORMS])
def test_a_form_is_read_as_what_it_says_or_asked_about(form):
    if form["ask"] is True and not form["rows"]:
        with pytest.raises(ValueError, match="recognise_table"):
            dh.recognise_table(form["text"])
        return
    if form["name"] == "letters missing":
        with pytest.raises(ValueError, match="L3 has no value"):
            dh.recognise_table(form["text"])
        return
    found = dh.recognise_table(form["text"])
    assert len(found.readings) == 1 or form["ask"], str(found)
    assert len(found.readings) > 1 or form["ask"] is not True, str(found)
    assert any(is_the_form(reading.arm, form) for reading in found.readings), str(found)


def mutated(text, rng):
    """A text with a few letters, or stretches of it, left out, doubled or exchanged."""
    letters = list(text)
    for _ in range(rng.integers(1, 6)):
        at, length = int(rng.integers(0, len(letters) + 1)), int(rng.integers(1, 40))
        kind = rng.integers(0, 4)
        if kind == 0:
            letters.insert(at, str(rng.choice(MARKS)))
        elif kind == 1:
            del letters[at : at + length]
        elif kind == 2:
            letters[at:at] = letters[at : at + length]
        else:
            letters[at : at + 1] = [str(rng.choice(MARKS))]
    return "".join(letters)


@pytest.mark.slow
def test_a_mutated_text_gives_a_reading_or_one_plain_sentence():
    rng = np.random.default_rng(12)
    answers = 0
    for _ in few(range(250), 120):
        text = mutated(FORMS[int(rng.integers(len(FORMS)))]["text"], rng)
        try:
            answers += bool(str(dh.recognise_table(text)))
        except ValueError as error:
            said = str(error)
            assert said.startswith("recognise_table") and "\n" not in said and len(said) < 400
    assert answers > 25


@pytest.mark.slow
@pytest.mark.parametrize("piece", ["(", "[[", "- ", "alpha ", "a = ", "Rz(q1) ", "a1: ", "\\frac{"])
def test_a_text_of_one_piece_repeated_is_one_sentence(piece):
    lines = (piece * 1000)[:900]
    with pytest.raises(ValueError, match="recognise_table"):
        dh.recognise_table("\n".join([lines] * 12))
