"""The catalogue holds every mistake the project knows of, once, in whole sentences."""

import re

import pytest

from dhlab.doctor import catalogue

# the ids under which the mistakes were collected, with evidence, before the catalogue was written
COLLECTED = """
    standard-rows-in-craig-matrix craig-rows-in-standard-matrix a-alpha-from-previous-row
    joint-index-off-by-one extra-or-missing-row columns-misread product-reversed pose-inverted
    rotation-transposed matrix-transposed row-vector-convention elementwise-product
    last-row-missing translations-not-rotated state-kept-between-calls product-one-link-short
    matrix-entry-mistyped x-shift-before-z-turn x-turn-before-z-shift alpha-sin-cos-exchanged
    degrees-in-sin-cos alpha-in-degrees offset-in-degrees converted-to-radians-twice length-unit
    pi-rounded integer-arrays a-d-exchanged alpha-sign length-sign lengths-made-positive
    theta-alpha-exchanged length-value nominal-table-calibrated-arm offset-missing offset-sign
    offset-on-wrong-joint offset-counted-twice joint-reversed all-joints-left-handed
    joints-coupled absolute-link-angles prismatic-variable-in-theta prismatic-constant-lost
    x-flip-incomplete z-flip-incomplete z-across-joint-axis origin-off-common-normal
    intersecting-axes-given-a-length parallel-offset-in-both-rows
    antiparallel-taken-for-parallel near-parallel-numbers-distrusted tool-missing
    tool-on-wrong-side base-height-missing-or-twice base-turned wrong-frame-compared rpy-order
    roll-yaw-exchanged atan-for-atan2 gimbal-lock-distrusted quaternion-order quaternion-sign
    only-position-checked only-zero-pose-checked arc-taken-for-proof table-taken-as-unique
""".split()


def test_every_collected_mistake_is_in_the_catalogue():
    assert len(COLLECTED) == len(set(COLLECTED)) == 67
    assert [name for name in COLLECTED if name not in catalogue()] == []


def test_an_id_leads_to_one_entry():
    for key, mistake in catalogue().items():
        assert key == mistake.id or key in mistake.also
        assert catalogue()[mistake.id] is mistake


@pytest.mark.parametrize(
    "mistake", {m.id: m for m in catalogue().values()}.values(), ids=lambda m: m.id
)
def test_the_words_are_whole_sentences(mistake):
    assert re.fullmatch("[a-z0-9]+(-[a-z0-9]+)*", mistake.id) and re.fullmatch(
        "0[0-9]", mistake.lesson
    )
    assert 3 <= len(mistake.title) <= 80 and not mistake.title.endswith(".")
    for words in (mistake.see, mistake.why, mistake.next):
        assert 10 <= len(words) <= 260 and words == words.strip(), words
    assert all(
        words.endswith((".", "?", "…")) for words in (mistake.see, mistake.why, mistake.next)
    )
    assert all(isinstance(ref, str) and ref for ref in mistake.refs)
