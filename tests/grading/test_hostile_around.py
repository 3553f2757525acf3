"""The attacks of ``around.py``: each raises where it gets at something."""

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
from around import AROUND


@pytest.mark.cage
@pytest.mark.parametrize("attack", [pytest.param(one, id=name) for name, one in AROUND])
def test_what_is_handed_in_or_asked_for_gets_at_nothing(attack, tmp_path):
    attack(tmp_path)
