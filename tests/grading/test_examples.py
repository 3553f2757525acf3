"""What the warm parent of a cage does once for all the submissions after it."""

from importlib import import_module

import pytest

from dhlab.grading.inside.warming.examples import USED, used_once


@pytest.mark.parametrize("name", USED)
def test_a_part_of_the_library_can_be_used_once(name):
    used_once(import_module(name))  # in the cage an error would only cost time, unseen
